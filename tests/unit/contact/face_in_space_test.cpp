// The face between two bodies in space, and the spin of a free body: identities that hold for any law.
#include "contact/face_in_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dynamics/space/blocks.h"

namespace wythe::face_in_space_test {
namespace {

using Vec = Vector<double>;
using Turn = Quaternion<double>;

double length(const Vec& v) { return std::sqrt(dot(v, v)); }

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double number(double size = 1) {
    return size * std::uniform_real_distribution(-1.0, 1.0)(random_);
  }
  Vec vector(double size = 1) { return {number(size), number(size), number(size)}; }
  // A turn by up to `angle`.
  Turn turn(double angle) {
    const Vec axis = vector();
    const double half = 0.5 * number(angle), l = length(axis);
    return {std::cos(half), std::sin(half) / l * axis};
  }

 private:
  std::mt19937 random_;
};

// The pose after moving at velocity v and turning at rate `omega` for h.
contact::Pose<double> moved(const contact::Pose<double>& pose, const Vec& v, const Vec& omega,
                            double h) {
  const double rate = length(omega), half = 0.5 * rate * h;
  const Turn step{std::cos(half), std::sin(half) / rate * omega};
  return {pose.u + h * v, step * pose.q};
}

double power(const contact::FaceLoad<double>& l, const contact::FaceGap<double>& a,
             const contact::FaceGap<double>& b, double h) {
  return (dot(l.f, b.j - a.j) + dot(l.r1, b.a - a.a) + dot(l.r2, b.b - a.b)) / h;
}

// A face with arms and frame of its own, and loads that any law might give.
struct Scene {
  Vec arm_a, arm_b, t, n;
  contact::Pose<double> a, b;
  contact::FaceLoad<double> load;
  Vec va, vb, wa, wb;

  explicit Scene(unsigned seed) {
    Dice dice(seed);
    arm_a = dice.vector(), arm_b = dice.vector();
    const Turn frame = dice.turn(3);
    t = turned(frame, Vec{1, 0, 0}), n = turned(frame, Vec{0, 0, 1});
    a = {dice.vector(0.3), dice.turn(1.2)}, b = {dice.vector(0.3), dice.turn(1.2)};
    load = {dice.vector(), dice.vector(), dice.vector()};
    va = dice.vector(), vb = dice.vector(), wa = dice.vector(), wb = dice.vector();
  }
};

TEST(FaceInSpace, forces_of_a_pair_work_exactly_as_the_law_does) {
  constexpr double h = 1e-5;  // central differences: error h^2
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Scene s(seed);
    const auto face = [&](double step) {
      return contact::PairFace<double>(moved(s.a, s.va, s.wa, step), moved(s.b, s.vb, s.wb, step),
                                       s.arm_a, s.arm_b, s.t, s.n);
    };
    const contact::BlockLoads<double> on = face(0).loads(s.load);
    const double of_law = power(s.load, face(-h).gap(), face(h).gap(), 2 * h);
    const double of_blocks =
        dot(on.f, s.va) - dot(on.f, s.vb) + dot(on.on_a, s.wa) + dot(on.on_b, s.wb);
    EXPECT_NEAR(of_law, -of_blocks, 1e-7) << seed;
  }
}

TEST(FaceInSpace, forces_of_a_pair_keep_the_angular_momentum_exactly) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Scene s(seed);
    const contact::PairFace<double> face(s.a, s.b, s.arm_a, s.arm_b, s.t, s.n);
    const contact::BlockLoads<double> on = face.loads(s.load);
    // at the start both centres of the face are one point: a's centroid at 0, b's at arm_a - arm_b
    const Vec xa = s.a.u, xb = s.b.u + s.arm_a - s.arm_b;
    const Vec sum = cross(xa, on.f) - cross(xb, on.f) + on.on_a + on.on_b;
    EXPECT_LT(length(sum), 1e-13) << seed;
  }
}

TEST(FaceInSpace, forces_on_a_support_work_exactly_as_the_law_does) {
  constexpr double h = 1e-5;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Scene s(seed);
    const auto face = [&](double step) {
      return contact::SupportFace<double>(s.a.u + step * s.va, moved(s.b, s.vb, s.wb, step),
                                          s.arm_b, s.t, s.n);
    };
    const contact::BlockLoads<double> on = face(0).loads(s.load);
    const double of_law = power(s.load, face(-h).gap(), face(h).gap(), 2 * h);
    const double of_blocks = dot(on.f, s.va) - dot(on.f, s.vb) + dot(on.on_b, s.wb);
    EXPECT_NEAR(of_law, -of_blocks, 1e-7) << seed;
  }
}

TEST(FaceInSpace, gap_and_loads_turn_with_the_world) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Scene s(seed);
    Dice dice(seed + 1000);
    const Turn world = dice.turn(3);
    // in the turned world every reference vector is turned; a block's turn q becomes world q world*
    const auto pose = [&](const contact::Pose<double>& p) {
      const Turn back{world.w, -1.0 * world.v};
      return contact::Pose<double>{turned(world, p.u), world * p.q * back};
    };
    const auto turned_scene = [&](const Vec& v) { return turned(world, v); };
    const contact::PairFace<double> here(s.a, s.b, s.arm_a, s.arm_b, s.t, s.n);
    const contact::PairFace<double> there(pose(s.a), pose(s.b), turned_scene(s.arm_a),
                                          turned_scene(s.arm_b), turned_scene(s.t),
                                          turned_scene(s.n));
    EXPECT_LT(length(here.gap().j - there.gap().j), 1e-13);
    EXPECT_LT(length(here.gap().a - there.gap().a), 1e-13);
    EXPECT_LT(length(here.gap().b - there.gap().b), 1e-13);
    const auto a = here.loads(s.load), b = there.loads(s.load);
    EXPECT_LT(length(turned(world, a.f) - b.f), 1e-13);
    EXPECT_LT(length(turned(world, a.on_a) - b.on_a), 1e-13);
    EXPECT_LT(length(turned(world, a.on_b) - b.on_b), 1e-13);
  }
}

TEST(FaceInSpace, swapping_the_sign_of_a_quaternion_changes_nothing) {
  const Scene s(7);
  contact::Pose<double> other = s.b;
  other.q = {-other.q.w, -1.0 * other.q.v};
  const contact::PairFace<double> one(s.a, s.b, s.arm_a, s.arm_b, s.t, s.n);
  const contact::PairFace<double> two(s.a, other, s.arm_a, s.arm_b, s.t, s.n);
  EXPECT_LT(length(one.gap().a - two.gap().a), 1e-15);
  EXPECT_LT(length(one.loads(s.load).on_a - two.loads(s.load).on_a), 1e-14);
}

TEST(FaceInSpace, turns_about_one_axis_are_those_of_the_plane) {
  // jump and growth of decision 0004: w = j.n + xi 2 h sin(delta/2), s = j.t
  const double ta = 0.3, tb = -0.4, xi = 0.7;
  const auto about_z = [](double angle) {
    return Turn{std::cos(angle / 2), {0, 0, std::sin(angle / 2)}};
  };
  const contact::Pose<double> a{{0.01, 0.02, 0}, about_z(ta)}, b{{-0.03, 0.05, 0}, about_z(tb)};
  const Vec arm_a{0.2, 0.5, 0}, arm_b{-0.1, -0.4, 0};
  const contact::PairFace<double> face(a, b, arm_a, arm_b, {1, 0, 0}, {0, 1, 0});
  const auto turned_arm = [](double t, const Vec& v) {
    return Vec{std::cos(t) * v.x - std::sin(t) * v.y, std::sin(t) * v.x + std::cos(t) * v.y, 0};
  };
  const Vec jump = (b.u + turned_arm(tb, arm_b) - arm_b) - (a.u + turned_arm(ta, arm_a) - arm_a);
  const double phi = 0.5 * (ta + tb), nx = -std::sin(phi), ny = std::cos(phi);
  const auto gap = face.gap();
  EXPECT_NEAR(gap.j.z + xi * gap.a.z,
              jump.x * nx + jump.y * ny + xi * 2 * std::sin(0.5 * (tb - ta)), 1e-15);
  EXPECT_NEAR(gap.j.x + xi * gap.a.x, jump.x * ny - jump.y * nx, 1e-15);
}

// --- the spin of a free body

dynamics::space::Inertia<double> body(double i1, double i2, double i3) {
  return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1 / i1, 1 / i2, 1 / i3}};
}

TEST(Spin, a_free_body_keeps_its_energy) {
  // I = (1, 2, 3.5), started near its middle axis; h = 0.05 as in the comparison of schemes
  const auto inertia = body(1, 2, 3.5);
  const Vec l{0.1, 2, 0.1};
  Turn q{1, {0, 0, 0}};
  const auto energy = [&] {
    const Vec m = turned_back(q, l);
    return 0.5 * dot(m, inertia.rate(m));
  };
  const double start = energy();
  double worst = 0, late = 0;
  for (int k = 0; k < 200000; ++k) {
    q = dynamics::space::spin(q, turned_back(q, l), inertia, 0.05);
    const double off = std::fabs(energy() / start - 1);
    worst = std::fmax(worst, off);
    if (k >= 199000) late = std::fmax(late, off);
  }
  EXPECT_LT(worst, 1e-2);         // it swings with h^2 ...
  EXPECT_LT(late, 1.05 * worst);  // ... and does not drift
  EXPECT_NEAR(q.w * q.w + dot(q.v, q.v), 1, 1e-14);
}

TEST(Spin, a_turn_about_one_axis_is_that_of_the_plane) {
  const auto inertia = body(0.3, 0.4, 0.5);
  const double rate = 3, h = 1e-4;
  Turn q{1, {0, 0, 0}};
  for (int k = 0; k < 10000; ++k) q = dynamics::space::spin(q, {0, 0, 0.5 * rate}, inertia, h);
  // Cayley's half angle: phi - 2 atan(phi/2) = phi^3/12 a step
  EXPECT_NEAR(2 * std::atan2(q.v.z, q.w), std::remainder(rate * 1.0, 2 * M_PI),
              1e-4 * 1e-4 * 27 / 12 * 1.5);
  EXPECT_EQ(q.v.x, 0);
  EXPECT_EQ(q.v.y, 0);
}

TEST(Spin, is_of_second_order_and_reversible) {
  const auto inertia = body(1, 2, 3.5);
  const Vec l{0.7, 1.3, -0.4};
  const auto after = [&](int steps, double h) {
    Turn q{1, {0, 0, 0}};
    for (int k = 0; k < steps; ++k) q = dynamics::space::spin(q, turned_back(q, l), inertia, h);
    return q;
  };
  const Turn exact = after(64000, 1.0 / 64000);
  const auto error = [&](int steps) {
    const Turn q = after(steps, 1.0 / steps);
    return length(q.v - exact.v);
  };
  EXPECT_NEAR(error(100) / error(200), 4, 0.1);
  // back again: the same turn with the momentum reversed
  Turn q = after(100, 0.01);
  for (int k = 0; k < 100; ++k)
    q = dynamics::space::spin(q, turned_back(q, -1.0 * l), inertia, 0.01);
  EXPECT_LT(length(q.v), 1e-12);
}

}  // namespace
}  // namespace wythe::face_in_space_test
