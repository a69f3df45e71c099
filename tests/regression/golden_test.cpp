// Complete pushes against stored results, to find any change; only tools/bless changes these.
//
// The hash must agree to the bit: the step and the law use no libm transcendental
// and no fused multiply-add. If it differs, the other figures show what changed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/solve.h"

namespace wythe::golden_test {
namespace {

std::string describe_run(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  const Result r = solve(model, state);
  std::string text =
      fmt::format("status {}\nsteps {}\npeak_N {:.9g}\nat_m {:.9g}\n", to_string(r.status), r.steps,
                  r.responses.peak_reaction, r.responses.displacement_at_peak);
  for (const CurveRow& row : r.curve)
    if (static_cast<long>(&row - r.curve.data()) % 50 == 0)
      text += fmt::format("{:.6g} m {:.9g} N\n", row.displacement, row.reaction);
  return text + "hash " + r.state_hash + "\n";
}

std::string read(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void expect_golden(const std::string& name, const ModelSpec& spec) {
  const std::string fresh = describe_run(spec);
  std::ofstream(fresh_dir() + "/" + name + ".golden") << fresh;
  EXPECT_EQ(fresh, read(source_dir() + "/tests/regression/golden/" + name + ".golden"))
      << "changed on purpose? tools/bless --why \"...\"";
}

TEST(Golden, small_wall_with_a_window) { expect_golden("small_wall", scenes::small_wall()); }

TEST(Golden, small_wall_with_every_other_choice_of_the_law) {
  ModelSpec spec = scenes::small_wall();
  for (auto& [name, material] : spec.material) {
    material.softening = Softening::kExponential;
    material.coupling = Coupling::kMaximum;
    material.unloading = Unloading::kElastic;
  }
  spec.solve.points_per_face = 3;
  expect_golden("small_wall_variants", spec);
}

TEST(Golden, first_millimetre_of_the_tuff_wall) {
  expect_golden("tuff_wall_1mm", scenes::tuff_wall(source_dir(), 1e-3));
}

}  // namespace
}  // namespace wythe::golden_test
