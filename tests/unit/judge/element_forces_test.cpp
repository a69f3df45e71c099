// Forces of piers and spandrels against statics: the joints of a
// storey's piers together carry exactly the load above, in any state.
#include "wythe/parts/element_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/solve.h"

namespace wythe::element_forces_test {
namespace {

using scenes::Rig;

constexpr double kColumn = 0.155, kCourse = 0.11;  // [m]
constexpr double kUnbalance = 1e-9;

struct Hole {
  int column, course, wide = 3, high = 3;
};

ModelSpec facade(const std::vector<Hole>& holes, int columns, int courses) {
  ModelSpec spec = scenes::plain_wall(columns, courses, 2e-3, 0.02);
  for (const Hole& hole : holes) {
    OpeningSpec o;
    o.x = hole.column * kColumn, o.y = hole.course * kCourse;
    o.width = hole.wide * kColumn, o.height = hole.high * kCourse;
    spec.wall.opening.push_back(o);
  }
  for (auto& [name, material] : spec.material)  // nothing cracks
    material = scenes::elastic_joint(20e9, 8e9);
  return spec;
}
// A door between windows, and a storey that does not stand in line with them.
ModelSpec two_storeys() {
  return facade({{3, 3}, {12, 0, 3, 6}, {21, 3}, {8, 10}, {16, 10}}, 27, 16);
}

std::vector<ElementForces> forces_in(const Model& model, const State& state) {
  Result result;
  result.states.readings.push_back({"end", 0, 0, state});
  return read_element_forces(model, result);
}

struct Sum {
  double axial = 0, shear = 0;
};
Sum of_storey(const std::vector<ElementForces>& elements, int storey, std::size_t end) {
  Sum sum;
  for (const ElementForces& e : elements) {
    if (e.kind != "pier" || e.storey != storey) continue;
    sum.axial += e.rows.back().end[end].axial;
    sum.shear += e.rows.back().end[end].shear;
  }
  return sum;
}

double weight_above(const Model& model, double y) {
  double weight = 0;
  for (BlockId b = 0; b < model.n_block; ++b)
    if (model.centroid_y[b] > y) weight += model.mass[b] * 9.81;
  return weight;
}

TEST(ElementForces, axial_forces_of_a_storey_are_the_weight_above_it) {
  Rig rig(compile(two_storeys()));
  rig.state.gravity_y = -9.81;
  rig.settle(kUnbalance);
  const auto elements = forces_in(rig.model, rig.state);
  // heads at one height in each storey, but the door's pier stands as low as the windows'
  for (const auto& [storey, head] : {std::pair(1, 6), std::pair(2, 13)}) {
    const double weight = weight_above(rig.model, head * kCourse);
    const Sum sum = of_storey(elements, storey, 1);
    EXPECT_NEAR(sum.axial, weight, 1e-6 * weight) << storey;
    EXPECT_NEAR(sum.shear, 0, 1e-6 * weight) << storey;
  }
}

TEST(ElementForces, shears_of_a_storey_are_the_force_above_it_and_moments_balance_each_pier) {
  constexpr double kPush = -700;  // against x
  Model model = compile(two_storeys());
  BlockId top = 0;
  for (BlockId b = 0; b < model.n_block; ++b)  // the highest, of these the last
    if (model.centroid_y[b] >= model.centroid_y[top]) top = b;
  const std::size_t load = scenes::add_load(model, {top, 0, 0, kPush, 0});
  Rig rig(std::move(model));
  rig.state.load_scale[load] = 1;
  rig.settle(kUnbalance);
  const auto elements = forces_in(rig.model, rig.state);
  for (const int storey : {1, 2})
    for (const std::size_t end : {0U, 1U}) {
      const Sum sum = of_storey(elements, storey, end);
      EXPECT_NEAR(sum.shear, kPush, 1e-6 * -kPush) << storey << end;
      EXPECT_NEAR(sum.axial, 0, 1e-5 * -kPush) << storey << end;
    }
  double turning = 0;  // about (0, 6 courses): what the heads of storey 1 carry holds the load
  int piers = 0;
  for (const ElementForces& e : elements) {
    if (e.kind != "pier") continue;
    const auto& [foot, head] = e.rows.back().end;
    EXPECT_NEAR(foot.moment, head.moment - head.shear * e.length, 1e-5 * -kPush) << e.element;
    EXPECT_LT(e.rows.back().drift, 0) << e.element;
    if (e.storey != 1) continue;
    constexpr double kMiddles[] = {1.5, 9, 18, 25.5};
    turning += head.moment - head.axial * kMiddles[piers++] * kColumn;
  }
  EXPECT_EQ(piers, 4);
  const double arm = rig.model.centroid_y[top] - 6 * kCourse;
  EXPECT_NEAR(turning, -kPush * arm, 1e-5 * -kPush * arm);
}

// A beam of blocks on two feet: its middle carries half the weight to either side.
TEST(ElementForces, spandrel_between_two_piers_alike_carries_half_its_weight_to_each) {
  Rig rig(compile(facade({{4, 0, 4, 4}}, 12, 8)));
  rig.state.gravity_y = -9.81;
  rig.settle(kUnbalance);
  const auto elements = forces_in(rig.model, rig.state);
  const auto spandrel = std::find_if(elements.begin(), elements.end(),
                                     [](const auto& e) { return e.kind == "spandrel"; });
  ASSERT_NE(spandrel, elements.end());
  const auto& [left, right] = spandrel->rows.back().end;
  const double sum = weight_above(rig.model, 4 * kCourse);
  EXPECT_NEAR(right.shear - left.shear, 4.0 / 12 * sum, 1e-6 * sum);
  EXPECT_NEAR(right.shear + left.shear, 0, 1e-6 * sum);
  EXPECT_NEAR(right.moment, left.moment, 1e-6 * sum);
}

TEST(ElementForces, mirrored_wall_has_mirrored_forces) {
  const std::vector<Hole> holes = {{3, 3}, {12, 0, 3, 6}, {8, 10}},
                          mirrors = {{21, 3}, {12, 0, 3, 6}, {16, 10}};
  std::vector<std::vector<ElementForces>> of;
  for (const auto* list : {&holes, &mirrors}) {
    Rig rig(compile(facade(*list, 27, 16)));
    rig.state.gravity_y = -9.81;
    rig.settle(kUnbalance);
    of.push_back(forces_in(rig.model, rig.state));
  }
  const auto named = [](const auto& list, const std::string& name) {
    for (const ElementForces& e : list)
      if (e.element == name) return e.rows.back();
    throw std::runtime_error("no " + name);
  };
  const auto a = named(of[0], "pier 1 of storey 1"), b = named(of[1], "pier 3 of storey 1");
  for (const std::size_t end : {0U, 1U}) {
    EXPECT_NEAR(a.end[end].axial, b.end[end].axial, 1e-6 * a.end[end].axial);
    EXPECT_NEAR(a.end[end].shear, -b.end[end].shear, 1e-6 * a.end[end].axial);
    EXPECT_NEAR(a.end[end].moment, -b.end[end].moment, 1e-6 * a.end[end].axial);
  }
}

TEST(ElementForces, rigid_turn_of_the_wall_is_drift_but_no_distortion) {
  const Model model = compile(two_storeys());
  constexpr double kTurn = 1e-3;
  State state = initial_state(model);
  for (std::size_t b = 0; b < static_cast<std::size_t>(model.n_block); ++b) {
    state.ux[b] = -kTurn * model.centroid_y[b], state.uy[b] = kTurn * model.centroid_x[b];
    state.theta[b] = kTurn;
  }
  for (const ElementForces& e : forces_in(model, state)) {
    if (e.storey != 2) continue;  // the ground stands still
    const ElementForces::Row& row = e.rows.back();
    EXPECT_NEAR(row.drift, e.kind == "pier" ? -kTurn : kTurn, 1e-9) << e.element;
    EXPECT_NEAR(row.distortion, 0, 1e-9) << e.element;
  }
}

TEST(ElementForces, wall_without_openings_is_one_pier_from_the_ground_to_its_top) {
  Rig rig(compile(facade({}, 8, 8)));
  rig.state.gravity_y = -9.81;
  rig.settle(kUnbalance);
  const auto elements = forces_in(rig.model, rig.state);
  ASSERT_EQ(elements.size(), 1U);
  const auto& [foot, head] = elements[0].rows.back().end;
  EXPECT_NEAR(foot.axial, weight_above(rig.model, 0), 1e-6 * foot.axial);
  EXPECT_EQ(head.axial, 0);
}

// A run: the sum of the shears is the base shear, within what is out of balance.
TEST(ElementForces, of_a_push_are_read_each_millimetre_and_sum_to_the_base_shear) {
  const Model model = compile(scenes::small_wall(3e-3, 5e-3));
  State state = initial_state(model);
  const Result result = solve(model, state);
  const auto elements = read_element_forces(model, result);
  ASSERT_FALSE(elements.empty());
  for (std::size_t r = 1; r < elements[0].rows.size(); ++r)  // each state once
    EXPECT_GT(elements[0].rows[r].displacement, elements[0].rows[r - 1].displacement);
  EXPECT_EQ(elements[0].rows.size(), 4U);  // the start, 1, 2 and 3 mm
  EXPECT_NEAR(elements[0].rows.front().displacement, 0, 1e-9);
  const double shear = of_storey(elements, 1, 1).shear;
  const CurveRow& last = result.curve.back();
  EXPECT_NEAR(shear, last.base_shear,
              0.03 * last.base_shear);  // the row is a mean, the state is not
  const std::string csv = element_forces_csv(elements);
  EXPECT_EQ(csv.substr(0, csv.find('\n')).find("displacement_mm,mark,element,"), 0U);
  const auto lines = std::count(csv.begin(), csv.end(), '\n');
  EXPECT_EQ(static_cast<std::size_t>(lines), 1 + elements.size() * elements[0].rows.size());
}

}  // namespace
}  // namespace wythe::element_forces_test
