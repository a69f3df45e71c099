// A wall in design practice against a calculation by hand: solid bricks in lime mortar, injected, with
// through bricks, at LC1, under a floor (docs/theory/material_rules.md, "Values of Circolare 7/2019").
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/record.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::office_test {
namespace {

using verification::verify;

// One column of 20 courses; the joints carry its weight and the floor.
constexpr const char* kWall = R"([wall]
length = "0.25 m"
height = "1.3 m"
thickness = "0.4 m"
[wall.unit]
length = "250 mm"
height = "65 mm"
split = "none"
density = "rule"
[masonry]
use = "circolare_brick_lime"
knowledge_level = "LC1"
transverse_connection = true
injections = true
[material.joint]
missing = "rule"
[[floor]]
name = "first floor"
y = "1.3 m"
g1 = "2.6 kN/m^2"
g2 = "1.4 kN/m^2"
q = "2 kN/m^2"
psi2 = 0.3
span = "4.8 m"
[[stage]]
name = "gravity"
[solve]
settle_ratio = 1e-8
)";

// f = 2.6 x 1.3 x 1.2/1.35, fv0 = 0.13 x 1.56/1.35, kn = 1500 x 1.2/0.065, ks = kn/3; the ground carries
// 18 kN/m3 x 0.25 x 0.4 x 1.3 m3 + (2.6 + 1.4 + 0.3 x 2) x 4.8/2 x 0.25 kN.
TEST(Office, a_wall_at_lc1_with_coefficients_and_a_floor) {
  const ModelSpec spec = parse_model(kWall, "model.toml");
  const JointMaterial& joint = spec.material.at("joint");
  const char* const six = "derived values have six digits";
  verify({"OF01a", "bricks in lime, LC1, through bricks, injected: fc", "MPa",
          2.6 * 1.3 * 1.2 / 1.35, 1e-5, six},
         1e-6 * joint.compressive_strength);
  verify({"OF01b", "the same: cohesion", "MPa", 0.13 * 1.3 * 1.2 / 1.35, 1e-5, six},
         1e-6 * joint.cohesion);
  verify({"OF01c", "the same: normal stiffness by E without a factor", "GPa/m", 1.5 * 1.2 / 0.065,
          1e-5, six},
         1e-9 * joint.normal_stiffness);
  verify({"OF01d", "the same: tau0", "MPa", 0.05 * 1.3 * 1.2 / 1.35, 1e-5, six},
         1e-6 * spec.masonry.diagonal_shear_strength);
  const double wall = 18e3 * 0.25 * 0.4 * 1.3, floor = (2.6e3 + 1.4e3 + 0.3 * 2e3) * 4.8 / 2 * 0.25;
  const Model model = compile(spec);
  State state = initial_state(model);
  ASSERT_EQ(solve(model, state).status, SolveStatus::kCompleted);
  double down = 0;  // the lowest joint carries most
  for (const JointReading& read : read_wall(model, state).joints)
    down = std::max(down, read.compression);
  verify(
      {"OF01e", "the same: what the ground carries, wall and floor", "N", wall + floor, 1e-5, six},
      down);
}

}  // namespace
}  // namespace wythe::office_test
