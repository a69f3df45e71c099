// Laws of nature: after mirroring, turning, renumbering or rescaling wall and load, the result follows.
//
// A wall of half units with a hole is loaded by gravity and pushed until it cracks. Only
// round-off may differ. Without damping it grows to 2e-13 of the peak over these 3000
// steps; the tolerance is 1e-10. Local damping is not continuous: where a velocity is zero
// up to round-off, its sign is random, and with it 0.8 of the force for a step. So damped
// results are compared only until cracks magnify this, with the spread measured there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenes/rig.h"
#include "scenes/scenes.h"

namespace wythe::symmetry_test {
namespace {

using scenes::Rig;

constexpr double kGravity = 9.81;
constexpr double kRoundOff = 1e-10;
constexpr double kDampedSpread =
    1e-4;  // of the peak, in the first steps of the push; measured 2e-5
constexpr std::size_t kDampedSteps = 500;
constexpr int kLoadSteps = 1000, kPushSteps = 2000;

ModelSpec wall() {
  ModelSpec spec = scenes::half_units({}, scenes::paper_joint());
  spec.stage = {scenes::push_stage("r6c0", Direction::kPlusX, 0.02, 1)};
  return spec;
}

struct Setting {
  double angle = 0;  // by which blocks, gravity and push are turned
  double scale = 1;
  double damping = 0.8;
};

const Setting kUndamped{.damping = 0};

// The results of a push, by block name.
struct Answer {
  Model model;
  State state;
  std::vector<double> reaction;
  [[nodiscard]] std::size_t at(const std::string& id) const {
    return static_cast<std::size_t>(scenes::block_named(model, id));
  }
  [[nodiscard]] double largest() const {
    double u = 0;
    for (std::size_t i = 0; i < state.ux.size(); ++i)
      u = std::max(u, std::hypot(state.ux[i], state.uy[i]));
    return u;
  }
};

Answer push(const ModelSpec& spec, const Setting& setting = {}) {
  Model built = compile(spec);
  const double c = std::cos(setting.angle), s = std::sin(setting.angle);
  Stage& stage = built.stages[0];
  const double sense = stage.drive_x;
  stage.drive_x = c * sense;
  stage.drive_y = s * sense;
  Rig rig(std::move(built));
  rig.controls.dt = 1.5e-5 * setting.scale;  // below the bound of every one of these walls
  EXPECT_LT(rig.controls.dt, 2 / rig.model.omega_max / std::sqrt(1.8));
  rig.controls.damping = setting.damping;
  for (int k = 1; k <= kLoadSteps; ++k) {
    const double g = kGravity / setting.scale * k / kLoadSteps;
    rig.state.gravity_x = g * s;
    rig.state.gravity_y = -g * c;
    rig.step();
  }
  Answer answer;
  for (int k = 1; k <= kPushSteps; ++k) {
    rig.drive(0, 0.05 * std::min(1.0, k / 500.0));
    answer.reaction.push_back(rig.step());
  }
  answer.model = rig.model;
  answer.state = rig.state;
  return answer;
}

double tension_damage(const Answer& a) {
  const std::vector<PointReading> points = read_points(a.model, a.state);
  double most = 0;
  for (const PointReading& p : points) most = std::max(most, p.damage_tension);
  return most;
}

void expect_same_reaction(const Answer& a, const Answer& b, double factor, double tolerance,
                          std::size_t steps = kPushSteps) {
  const double peak = *std::max_element(a.reaction.begin(), a.reaction.end());
  for (std::size_t k = 0; k < steps; ++k)
    ASSERT_NEAR(b.reaction[k] / factor, a.reaction[k], tolerance * peak) << "step " << k;
}

// Block by block: b's displacement is a's seen through (x, y, theta) -> expected.
template <class Expected>
void expect_same_motion(const Answer& a, const Answer& b, double tolerance, Expected expected) {
  const double u = tolerance * b.largest();
  for (std::size_t i = 0; i < a.state.ux.size(); ++i) {
    const std::size_t j = b.at(a.model.anatomy.block_id[i]);
    const auto [x, y, theta] = expected(a.state.ux[i], a.state.uy[i], a.state.theta[i]);
    ASSERT_NEAR(b.state.ux[j], x, u);
    ASSERT_NEAR(b.state.uy[j], y, u);
    ASSERT_NEAR(b.state.theta[j], theta, u / 0.1);  // a half unit is 0.1 m large
  }
}

struct Motion {
  double x, y, theta;
};

TEST(Symmetry, the_push_cracks_the_wall) {
  EXPECT_GT(tension_damage(push(wall())), 0.99);
  EXPECT_GT(tension_damage(push(wall(), kUndamped)), 0.99);
}

TEST(Symmetry, mirrored_wall_and_load_give_the_mirrored_answer) {
  const Answer a = push(wall(), kUndamped), b = push(scenes::mirrored(wall()), kUndamped);
  expect_same_reaction(a, b, 1, kRoundOff);
  expect_same_motion(a, b, kRoundOff, [](double x, double y, double t) {
    return Motion{-x, y, -t};
  });
}

TEST(Symmetry, any_turn_gives_the_turned_answer) {
  const Answer a = push(wall(), kUndamped);
  for (const double angle : {0.3, 2.0, -1.1}) {
    const Answer b = push(scenes::turned(wall(), angle), {.angle = angle, .damping = 0});
    const double c = std::cos(angle), s = std::sin(angle);
    expect_same_reaction(a, b, 1, kRoundOff);
    expect_same_motion(a, b, kRoundOff, [&](double x, double y, double t) {
      return Motion{c * x - s * y, s * x + c * y, t};
    });
  }
}

TEST(Symmetry, the_order_of_blocks_does_not_matter) {
  const Answer a = push(wall(), kUndamped), b = push(scenes::reversed(wall()), kUndamped);
  EXPECT_NE(a.at("r6c0"), b.at("r6c0"));
  expect_same_reaction(a, b, 1, kRoundOff);
  expect_same_motion(a, b, kRoundOff, [](double x, double y, double t) { return Motion{x, y, t}; });
}

TEST(Symmetry, damped_push_mirrors_turns_by_quarters_and_takes_any_order) {
  // local damping acts on the axes x and y, so only quarter turns leave it as it is
  const Answer a = push(wall());
  expect_same_reaction(a, push(scenes::mirrored(wall())), 1, kDampedSpread, kDampedSteps);
  expect_same_reaction(a, push(scenes::reversed(wall())), 1, kDampedSpread, kDampedSteps);
  for (const double angle : {0.5 * scenes::kPi, scenes::kPi})
    expect_same_reaction(a, push(scenes::turned(wall(), angle), {.angle = angle}), 1, kDampedSpread,
                         kDampedSteps);
}

TEST(Symmetry, twice_the_size_gives_the_same_bits) {
  // powers of two scale without rounding, and nothing in the engine has a length of its own
  const Answer a = push(wall()), b = push(scenes::scaled(wall(), 2), {.scale = 2});
  for (std::size_t i = 0; i < a.state.ux.size(); ++i) {
    EXPECT_EQ(b.state.ux[i], 2 * a.state.ux[i]);
    EXPECT_EQ(b.state.uy[i], 2 * a.state.uy[i]);
    EXPECT_EQ(b.state.theta[i], a.state.theta[i]);
  }
  for (std::size_t k = 0; k < a.reaction.size(); ++k) EXPECT_EQ(b.reaction[k], 4 * a.reaction[k]);
}

TEST(Symmetry, three_times_the_size_gives_the_scaled_answer) {
  const Answer a = push(wall(), kUndamped);
  const Answer b = push(scenes::scaled(wall(), 3), {.scale = 3, .damping = 0});
  expect_same_reaction(a, b, 9, kRoundOff);
  expect_same_motion(a, b, kRoundOff, [](double x, double y, double t) {
    return Motion{3 * x, 3 * y, t};
  });
}

}  // namespace
}  // namespace wythe::symmetry_test
