// Motion in space against closed forms: spinning tops, tumbling bodies, frequencies and friction, in any frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "record.h"
#include "scenes/space_rig.h"

namespace wythe::space_motion_test {
namespace {

using scenes::box;
using scenes::Frame;
using scenes::SpaceRig;
using verification::verify;

constexpr double kG = 9.81, kDensity = 2000;

const std::vector<Frame>& frames() {
  static const std::vector<Frame> all{Frame{}, Frame::turned(0.3, 0.5, -0.7, 0.2, {3, -1, 2}),
                                      Frame::turned(-0.6, 0.1, 0.2, 0.9, {-2, 5, 1})};
  return all;
}

// A block that touches nothing: it stands on a dry joint and is taken half a metre off.
Model flying(Vec3 size, const Frame& frame = {}) {
  ModelSpec spec = scenes::in_space({box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                     box("b", {-size.x / 2, 0, -size.z / 2}, size)},
                                    scenes::dry_joint(1e9, 4e8, 0.5), kDensity);
  return compile(scenes::in_frame(std::move(spec), frame));
}
void take_off(SpaceRig& rig, const Frame& frame) {
  const Vec3 up = 0.5 * frame.direction({0, 1, 0});
  for (std::size_t i = 0; i < rig.state.ux.size(); ++i)
    rig.state.ux[i] = up.x, rig.state.uy[i] = up.y, rig.state.uz[i] = up.z;
}

// --- a heavy top: weight at the centroid, its counterforce at the tip of an arm that turns along

struct Top {
  static constexpr double kArm = 0.15, kTilt = 0.5;
  SpaceRig rig;
  double force, around, across;  // N, moments of inertia

  static Model model() {
    Model m = flying({0.1, 0.3, 0.1});
    const double weight = m.mass[0] * kG;
    scenes::add_load(m, 0, {0, -kArm, 0}, {0, weight, 0});
    m.stages.back().loads.push_back({0, 0, 0, 0, -weight, 0, 0});
    return m;
  }
  explicit Top(double dt) : rig(model()), force(rig.model.mass[0] * kG) {
    const double m = rig.model.mass[0];
    around = m * (0.1 * 0.1 + 0.1 * 0.1) / 12, across = m * (0.1 * 0.1 + 0.3 * 0.3) / 12;
    rig.controls.damping = 0;
    rig.controls.dt = dt;
    take_off(rig, {});
    rig.state.load_scale.back() = 1;
    rig.state.qw[0] = std::cos(kTilt / 2);
    rig.state.qz[0] = std::sin(kTilt / 2);
  }
  [[nodiscard]] Vec3 axis() const { return rig.out_of_block(0, {0, 1, 0}); }
  [[nodiscard]] Vec3 torque() const { return cross(-kArm * axis(), Vec3{0, force, 0}); }
  // Turning at `spin` about its axis and at `precession` about the vertical; momentum half a step back.
  void start(double spin, double precession) {
    const Vec3 a = axis(), w = Vec3{0, precession, 0};
    const Vec3 l = around * spin * a + across * (w - dot(w, a) * a);
    rig.set_momentum(0, l - 0.5 * rig.controls.dt * torque());
    rig.load_state();
  }
  [[nodiscard]] double energy() const {
    const Vec3 l = rig.momentum(0) + 0.5 * rig.controls.dt * torque(), a = axis();
    const double along = dot(l, a);
    return 0.5 * along * along / around + 0.5 * (dot(l, l) - along * along) / across +
           force * kArm * a.y;
  }
};

TEST(SpaceMotion, a_fast_top_precesses_steadily) {
  Top top(5e-5);
  const double spin = 300, c = std::cos(Top::kTilt);
  // I1 W^2 cos - I3 w3 W + m g l = 0, the slow root
  const double b = top.around * spin, mgl = top.force * Top::kArm;
  const double rate = 2 * mgl / (b + std::sqrt(b * b - 4 * top.across * c * mgl));
  top.start(spin, rate);
  const double period = 2 * M_PI / rate;
  top.rig.run(10 * period);
  const Vec3 a = top.axis();
  // ten turns and what is left: the axis leaned towards -x at the start
  const double late = std::atan2(a.z, -a.x) - rate * (top.rig.state.time - 10 * period);
  verify({"SP10", "heavy top: steady precession", "rad/s", rate, 2e-6,
          "h^2 over ten turns of the precession"},
         rate * (1 + std::remainder(late, 2 * M_PI) / (20 * M_PI)));
  verify({"SP11", "heavy top: tilt after ten turns", "rad", Top::kTilt, 1e-5, "h^2"},
         std::acos(a.y));
}

TEST(SpaceMotion, a_nutating_top_keeps_its_energy) {
  Top top(1e-4);
  top.start(200, 0);  // let go: it nutates
  const auto mean_energy = [&] {
    double sum = 0;
    constexpr int kSteps = 20000;
    for (int k = 0; k < kSteps; ++k) {
      top.rig.step();
      sum += top.energy() / kSteps;
    }
    return sum;
  };
  const double first = mean_energy();
  top.rig.run(40);  // 1 300 turns
  const double last = mean_energy();
  verify({"SP12", "heavy top: energy after 1 300 turns, drift", "-", 0, 1e-7,
          "symplectic: it swings, and does not drift", true},
         last / first - 1);
}

// --- no torque at all

TEST(SpaceMotion, a_tumbling_body_keeps_its_momentum_and_its_period) {
  for (const Frame& frame : frames()) {
    SpaceRig rig(flying({0.2, 0.3, 0.1}, frame));
    rig.controls.damping = 0;
    rig.controls.dt = 1e-4;
    take_off(rig, frame);
    const double m = rig.model.mass[0];
    const double i1 = m * (0.04 + 0.01) / 12, i2 = m * (0.09 + 0.01) / 12,
                 i3 = m * (0.04 + 0.09) / 12;  // about y, x, z of the frame
    const double w1 = 4, w2 = 3, w3 = 9;
    const Vec3 start = frame.direction({i2 * w2, i1 * w1, i3 * w3});
    rig.set_momentum(0, start);
    rig.load_state();
    const double twice = i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3, l2 = dot(start, start);
    ASSERT_GT(l2, twice * i2);  // it turns about the third axis
    const double p = (i3 - i2) * (l2 - twice * i1);
    const double k = std::sqrt((i2 - i1) * (twice * i3 - l2) / p);
    const double period = 4 * std::comp_ellint_1(k) * std::sqrt(i1 * i2 * i3 / p);
    // upward passages of the middle component through zero
    const Vec3 middle = frame.direction({1, 0, 0});
    double before = 1, first = 0, last = 0;
    int passages = 0;
    while (passages < 21) {
      rig.step();
      const double now = dot(rig.in_block(0, rig.momentum(0)), middle);
      if (before < 0 && now >= 0) {
        last = rig.state.time - rig.controls.dt * now / (now - before);
        if (passages++ == 0) first = last;
      }
      before = now;
    }
    verify({"SP13", "tumbling body: period of twenty turns", "s", period, 1e-6, "h^2"},
           (last - first) / 20);
    EXPECT_LT(length(rig.momentum(0) - start), 1e-13 * length(start));
  }
}

// --- friction of a bed in torsion: what the points of a rule give, and what many points come to

TEST(SpaceMotion, a_spinning_block_is_braked_by_the_torsional_friction_of_its_points) {
  struct Rule {
    PointRule rule;
    int points;
    double share;  // T / (mu N a)
    const char* what;
  };
  const double corner = std::sqrt(0.5), half = 0.5, fifth = 1 / std::sqrt(5.0);
  const double lobatto_3 = 4 * corner / 36 + 4 * half / 9;
  const double lobatto_4 = 4 * corner / 144 + 8 * 5.0 / 144 * half * std::hypot(1, fifth) +
                           4 * 25.0 / 144 * half * fifth * std::sqrt(2.0);
  const double exact = (std::sqrt(2.0) + std::log(1 + std::sqrt(2.0))) / 6;  // 0.3826
  for (const Rule& r : {Rule{PointRule::kCorners, 2, corner, "corners"},
                        Rule{PointRule::kLobatto, 3, lobatto_3, "3 x 3 Lobatto, the default"},
                        Rule{PointRule::kLobatto, 4, lobatto_4, "4 x 4 Lobatto"},
                        Rule{PointRule::kGauss, 16, exact, "16 x 16 Gauss"}}) {
    const double a = 0.2, mu = 0.5;
    for (const Frame& frame : frames()) {
      ModelSpec spec = scenes::in_space({box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                         box("b", {-a / 2, 0, -a / 2}, {a, 0.1, a})},
                                        scenes::dry_joint(1e9, 4e8, std::atan(mu)), kDensity);
      spec.solve.point_rule = r.rule;
      spec.solve.points_per_face = r.points;
      SpaceRig rig(compile(scenes::in_frame(std::move(spec), frame)));
      const double m = rig.model.mass[0], weight = m * kG, inertia = m * a * a / 6;
      const Vec3 up = frame.direction({0, 1, 0});
      const Vec3 sunk = -weight / (1e9 * a * a) * up;
      rig.state.ux[0] = sunk.x, rig.state.uy[0] = sunk.y, rig.state.uz[0] = sunk.z;
      rig.set_gravity(-kG * up);
      rig.set_momentum(0, 10 * inertia * up);
      rig.controls.damping = 0;
      rig.load_state();
      rig.run(0.02);  // later friction makes it flutter: nothing damps it
      const double l0 = dot(rig.momentum(0), up), t0 = rig.state.time;
      rig.run(0.03);
      const double torque = (l0 - dot(rig.momentum(0), up)) / (rig.state.time - t0);
      verify({"SP04", std::string("torsional friction of a square, ") + r.what, "-", r.share,
              r.points == 16 ? 1e-3 : 1e-5,
              r.points == 16 ? "16 x 16 points" : "the elastic slip lags behind the turn"},
             torque / (mu * weight * a));
    }
  }
}

// --- frequencies of small motions

// Period of free motion from rest: a velocity is given, passages through zero of what is seen are counted.
double period_of(SpaceRig& rig, double guess, const std::function<double()>& seen) {
  rig.controls.damping = 0;
  rig.controls.dt = guess / 400;
  rig.load_state();
  double before = 0, first = 0, last = 0;
  int passages = 0;
  rig.step();
  before = seen();
  for (int k = 0; k < 400 * 13 && passages < 11; ++k) {
    rig.step();
    const double now = seen();
    if (before < 0 && now >= 0) {
      last = rig.state.time - rig.controls.dt * now / (now - before);
      if (passages++ == 0) first = last;
    }
    before = now;
  }
  EXPECT_EQ(passages, 11);
  return (last - first) / 10;
}

// Two equal boxes and the face between them, alone in space: its six ways to move.
TEST(SpaceMotion, two_blocks_swing_against_each_other_in_six_ways) {
  const double kn = 2e9, ks = 8e8;
  const Vec3 size{0.2, 0.15, 0.1};  // the face is x by z
  const double area = size.x * size.z, m = kDensity * size.x * size.y * size.z, h = size.y;
  const double about_x = area * size.z * size.z / 12, about_z = area * size.x * size.x / 12;
  const double ix = m * (size.y * size.y + size.z * size.z) / 12,
               iy = m * (size.x * size.x + size.z * size.z) / 12,
               iz = m * (size.x * size.x + size.y * size.y) / 12;
  struct Way {
    const char* what;
    Vec3 v, w;     // of the upper block
    double sense;  // of the lower block's turn against the upper's
    double squared;
  };
  // across: u against u with turns h/2 that go along, so that no angular momentum is in it
  const auto across = [&](double i) { return ks * area * (2 / m + h * h / (2 * i)); };
  const std::vector<Way> ways{
      {"apart", {0, 1, 0}, {}, 0, 2 * kn * area / m},
      {"across, along x", {1, 0, 0}, {0, 0, m * h / (2 * iz)}, 1, across(iz)},
      {"across, along z", {0, 0, 1}, {-m * h / (2 * ix), 0, 0}, 1, across(ix)},
      {"bending about x", {}, {1, 0, 0}, -1, 2 * kn * about_x / ix},
      {"bending about z", {}, {0, 0, 1}, -1, 2 * kn * about_z / iz},
      {"twist", {}, {0, 1, 0}, -1, 2 * ks * (about_x + about_z) / iy}};
  for (const Frame& frame : frames())
    for (const Way& way : ways) {
      ModelSpec spec = scenes::in_space({box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                         box("a", {-size.x / 2, 0, -size.z / 2}, size),
                                         box("b", {-size.x / 2, size.y, -size.z / 2}, size)},
                                        scenes::elastic_joint(kn, ks), kDensity);
      spec.material["foundation"] = scenes::dry_joint(kn, ks, 0.5);
      SpaceRig rig(compile(scenes::in_frame(std::move(spec), frame)));
      take_off(rig, frame);
      const double small = 1e-6 * std::sqrt(way.squared);
      const Vec3 v = small * frame.direction(way.v);
      rig.set_velocity(0, -1.0 * v);
      rig.set_velocity(1, v);
      const Vec3 l = small * frame.direction({ix * way.w.x, iy * way.w.y, iz * way.w.z});
      rig.set_momentum(0, way.sense * l);
      rig.set_momentum(1, l);
      const Vec3 seen = frame.direction(length(way.v) > 0 ? way.v : way.w);
      const double expected = 2 * M_PI / std::sqrt(way.squared);
      const double period = period_of(rig, expected, [&] {
        if (length(way.v) > 0) return dot(rig.moved(1) - rig.moved(0), seen);
        return 2 * dot(Vec3{rig.state.qx[1], rig.state.qy[1], rig.state.qz[1]}, seen);
      });
      verify({"SP14", std::string("two blocks, ") + way.what + ": period", "s", expected, 2e-5,
              "central differences at 400 steps a period"},
             period);
    }
}

}  // namespace
}  // namespace wythe::space_motion_test
