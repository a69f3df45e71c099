// What the benchmarks step: the tuff wall cracked by a push of 6 mm, and its bare kernels checked
// against the engine.
#pragma once

#include <string>
#include <vector>

#include "bare_wall.h"
#include "contact/law.h"
#include "dynamics/executors/processor.h"

namespace wythe::bench {

struct Cracked {
  explicit Cracked(const std::vector<std::string>& more = {});
  [[nodiscard]] BareStart bare() const;
  [[nodiscard]] const Stage& push() const { return model.stages.back(); }

  Model model;
  State state;
  State held;  // the same, its driven blocks at rest
  std::vector<contact::LawConstants<double>> law;
  std::string hash;
  double dt = 0;
};
// Made at the first call.
[[nodiscard]] const Cracked& cracked();
// The same wall with a field that does not scatter: every joint has a law of its own, and the bits are those of
// cracked().
[[nodiscard]] const Cracked& graded();

// Largest difference between a bare kernel's state after 200 steps and the engine's, each array (and
// the ledger but friction) relative to its largest value. Rounding alone makes 1e-11.
[[nodiscard]] double difference(const State& bare, const State& engine);
[[nodiscard]] State engine_after(int steps);
// Throws std::runtime_error where a kernel computes something else.
void check_bare_kernels();

// Operations and bytes of one point update.
struct Cost {
  double arithmetic, other, bytes;
};
[[nodiscard]] Cost engine_cost(int lanes);
[[nodiscard]] Cost bare_cost();

}  // namespace wythe::bench
