// verify(): compares a number of the engine with its closed form. It appends a row to
// fresh_dir()/verification.csv, from which tools/verification_table makes docs/evidence/verification.md.
#pragma once

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include "scenes/places.h"
#include "wythe/parts/provenance.h"

namespace wythe::verification {

// The claim of a case. `id` ("CF07a") numbers the cases: docs/evidence/verification.md lists them.
struct Claim {
  std::string id, what, unit;
  double expected = 0;
  double tolerance = 0;  // relative to |expected|, absolute where `expected` is 0 or `absolute`
  std::string because;   // where the tolerance comes from
  bool absolute = false;
};

inline void append_row(const Claim& claim, double computed, double deviation, bool passed) {
  const std::filesystem::path folder = fresh_dir();
  std::filesystem::create_directories(folder);
  // one write in append mode: shards of the test program may run side by side
  std::ofstream file(folder / "verification.csv", std::ios::app);
  file << fmt::format("{},\"{}\",{},{:.17g},{:.17g},{:.3e},{:.3e},{},\"{}\",{},{}\n", claim.id,
                      claim.what, claim.unit, claim.expected, computed, deviation, claim.tolerance,
                      claim.absolute ? "absolute" : "relative", claim.because, passed ? 1 : 0,
                      provenance().commit);
}

inline void verify(const Claim& claim, double computed) {
  const double scale = claim.absolute ? 1.0 : std::fabs(claim.expected);
  const double deviation = (computed - claim.expected) / scale;
  const bool passed = std::fabs(deviation) <= claim.tolerance;
  append_row(claim, computed, deviation, passed);
  EXPECT_TRUE(passed) << claim.id << " " << claim.what << ": closed form " << claim.expected << " "
                      << claim.unit << ", computed " << computed << ", deviation " << deviation
                      << ", tolerance " << claim.tolerance << " (" << claim.because << ")";
}

}  // namespace wythe::verification
