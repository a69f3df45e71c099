// Statics in space against closed forms, in any frame: a chain of blocks as a cantilever, shear in twelve
// directions against the law, rocking about each edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contact/law.h"
#include "contact/parameters.h"
#include "record.h"
#include "scenes/space_rig.h"
#include "wythe/parts/io.h"

namespace wythe::space_statics_test {
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

// --- a chain of n blocks: each joint bends, shears, twists; no weight

struct Tip {
  Vec3 moved, turned;
};

constexpr int kBlocks = 8;
constexpr double kWide = 0.2, kDeep = 0.1, kHigh = 0.1, kKn = 20e9, kKs = 8e9;

ModelSpec chain_of_blocks() {
  std::vector<BodySpec> bodies{box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true)};
  for (int k = 0; k < kBlocks; ++k)
    bodies.push_back(
        box("b" + std::to_string(k), {-kWide / 2, kHigh * k, -kDeep / 2}, {kWide, kHigh, kDeep}));
  return scenes::in_space(bodies, scenes::elastic_joint(kKn, kKs), kDensity);
}

// The same as segments of a lintel, the first of them held.
constexpr double kE = 10e9, kShear = 0.6e9;
ModelSpec chain_of_segments() {
  std::vector<BodySpec> bodies;
  for (int k = 0; k <= kBlocks; ++k) {
    bodies.push_back(box("w.lintel0.s" + std::to_string(k),
                         {-kWide / 2, kHigh * (k - 1), -kDeep / 2}, {kWide, kHigh, kDeep}, k == 0));
    bodies.back().material = "oak";
  }
  ModelSpec spec = scenes::in_space(bodies, scenes::elastic_joint(kKn, kKs), kDensity);
  JointMaterial oak;
  oak.density = 600, oak.youngs_modulus = kE, oak.shear_modulus = kShear;
  spec.material["oak"] = oak;
  return spec;
}

// Force and moment at the tip's centroid, in the frame of the chain; so are the answers.
Tip load_chain(const Frame& frame, Vec3 force, Vec3 moment,
               const ModelSpec& chain = chain_of_blocks()) {
  Model model = compile(scenes::in_frame(chain, frame));
  const auto add = [&](Vec3 arm, Vec3 f) {
    const Vec3 a = frame.direction(arm), g = frame.direction(f);
    if (model.stages.empty())
      scenes::add_load(model, kBlocks - 1, a, g);
    else
      model.stages[0].loads.push_back({kBlocks - 1, a.x, a.y, g.x, g.y, a.z, g.z});
  };
  add({}, force);
  // couples: two forces each, at arms across them
  const double arm = 0.05;
  const auto couple = [&](Vec3 along, Vec3 across, double size) {
    add(arm * along, size / (2 * arm) * across);
    add(-arm * along, -size / (2 * arm) * across);
  };
  couple({0, 1, 0}, {0, 0, 1}, moment.x);
  couple({0, 0, 1}, {1, 0, 0}, moment.y);
  couple({1, 0, 0}, {0, 1, 0}, moment.z);
  SpaceRig rig(std::move(model));
  rig.state.load_scale[0] = 1;
  rig.controls.damping = 0.4;
  rig.load_state();
  rig.run(0.5);
  const Quaternion<double> q = rig.turn(kBlocks - 1);
  const Frame& f = frame;
  const auto seen = [&](Vec3 v) {
    return Vec3{dot(v, f.direction({1, 0, 0})), dot(v, f.direction({0, 1, 0})),
                dot(v, f.direction({0, 0, 1}))};
  };
  return {seen(rig.moved(kBlocks - 1)), seen(2.0 * Vec3{q.v.x, q.v.y, q.v.z})};
}

TEST(SpaceStatics, a_chain_of_blocks_bends_shears_and_twists_as_its_joints_say) {
  const double area = kWide * kDeep;
  const double about_x = kKn * kWide * std::pow(kDeep, 3) / 12,
               about_z = kKn * kDeep * std::pow(kWide, 3) / 12,
               twist = kKs * (kWide * std::pow(kDeep, 3) + kDeep * std::pow(kWide, 3)) / 12;
  double lever = 0, square = 0;  // of the joints, from the tip's centroid
  for (int k = 0; k < kBlocks; ++k) {
    const double l = (kBlocks - 0.5 - k) * kHigh;
    lever += l, square += l * l;
  }
  const double n = kBlocks, force = 100, moment = 10;
  const char* why = "settled with damping; second order of the turns 1e-5";
  for (const Frame& frame : frames()) {
    const Tip x = load_chain(frame, {force, 0, 0}, {});
    verify({"SP15", "chain of blocks: force along x, deflection", "m",
            force * (n / (kKs * area) + square / about_z), 1e-4, why},
           x.moved.x);
    verify({"SP15", "chain of blocks: force along x, turn about -z", "rad", force * lever / about_z,
            1e-4, why},
           -x.turned.z);
    const Tip z = load_chain(frame, {0, 0, force}, {});
    verify({"SP15", "chain of blocks: force along z, deflection", "m",
            force * (n / (kKs * area) + square / about_x), 1e-4, why},
           z.moved.z);
    verify({"SP15", "chain of blocks: force along z, turn about x", "rad", force * lever / about_x,
            1e-4, why},
           z.turned.x);
    const Tip y = load_chain(frame, {0, force, 0}, {0, moment, 0});
    verify({"SP15", "chain of blocks: stretch", "m", force * n / (kKn * area), 1e-4, why},
           y.moved.y);
    verify({"SP15", "chain of blocks: twist", "rad", moment * n / twist, 1e-4, why}, y.turned.y);
    const Tip m = load_chain(frame, {}, {moment, 0, moment});
    verify(
        {"SP15", "chain of blocks: moment about x, turn", "rad", moment * n / about_x, 1e-4, why},
        m.turned.x);
    verify({"SP15", "chain of blocks: moment about z, deflection along -x", "m",
            moment * lever / about_z, 1e-4, why},
           -m.moved.x);
  }
}

// The closed form is that of the chain: bending in each joint alone. Against a beam that bends all along this is
// 1/(4 n^2) = 0.4 % of the deflection.
TEST(SpaceStatics, a_lintel_bends_about_both_axes_stretches_and_twists_as_a_beam) {
  const double area = kWide * kDeep, l = kHigh, n = kBlocks, force = 100, moment = 10;
  const double about_x = kE * kWide * std::pow(kDeep, 3) / 12,
               about_z = kE * kDeep * std::pow(kWide, 3) / 12;
  const double torsion = 0.22868 * kWide * std::pow(kDeep, 3);  // Saint-Venant, sides 2 : 1
  double square = 0;
  for (int k = 0; k < kBlocks; ++k) {
    const double at = (kBlocks - 0.5 - k) * kHigh;
    square += at * at;
  }
  const char* why = "settled with damping; second order of the turns 1e-5";
  for (const Frame& frame : frames()) {
    const auto load = [&](Vec3 f, Vec3 m) { return load_chain(frame, f, m, chain_of_segments()); };
    const double shear = n * l / (5.0 / 6 * kShear * area);
    verify({"SP27", "lintel in space: force along x, deflection", "m",
            force * (shear + square * l / about_z), 1e-4, why},
           load({force, 0, 0}, {}).moved.x);
    verify({"SP27", "lintel in space: force along z, deflection", "m",
            force * (shear + square * l / about_x), 1e-4, why},
           load({0, 0, force}, {}).moved.z);
    const Tip y = load({0, force, 0}, {0, moment, 0});
    verify({"SP27", "lintel in space: stretch", "m", force * n * l / (kE * area), 1e-4, why},
           y.moved.y);
    verify({"SP27", "lintel in space: twist", "rad", moment * n * l / (kShear * torsion), 3e-3,
            "torsion constant by a polynomial, within 0.2 %"},
           y.turned.y);
    const Tip m = load({}, {moment, 0, moment});
    verify({"SP27", "lintel in space: moment about x, turn", "rad", moment * n * l / about_x, 1e-4,
            why},
           m.turned.x);
    verify({"SP27", "lintel in space: moment about z, turn", "rad", moment * n * l / about_z, 1e-4,
            why},
           m.turned.z);
  }
}

// --- shear and tension of one face: the reaction is the law's own answer, whatever the direction

TEST(SpaceStatics, a_face_answers_in_every_direction_as_the_law_does) {
  const JointMaterial joint = scenes::paper_joint();
  const contact::LawConstants<double> law = contact::constants_of(joint);
  const double area = 0.4 * 0.2;
  for (const Frame& frame : frames())
    for (int k = 0; k < 13; ++k) {  // twelve along the face, one off it
      const double angle = k * M_PI / 6;
      const Vec3 along = k == 12 ? Vec3{0, 1, 0} : Vec3{std::cos(angle), 0, std::sin(angle)};
      ModelSpec spec = scenes::in_space({box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                         box("b", {-0.2, 0, -0.1}, {0.4, 0.1, 0.2})},
                                        joint, kDensity);
      StageSpec push = scenes::push_stage("b", Direction::kPlusX, 0.01, 1);
      push.get<PushStage>().drive.along = {along.x, along.y, along.z};
      push.get<PushStage>().fixity = {Freedom::kBlocked, Freedom::kBlocked};
      push.get<PushStage>().as = Manner::kEach;
      spec.stage = {push};
      SpaceRig rig(compile(scenes::in_frame(std::move(spec), frame)));
      rig.controls.dt = 2e-5;
      rig.drive(0, 0.01);
      contact::History<double> history{};
      double most = 0, worst = 0, at = 0;
      for (int step = 0; step < 5000; ++step) {
        const double reaction = rig.advance();  // of the place at the start of the step
        const contact::LawUpdate<double> answer =
            contact::with_variant(law.choice, [&](auto variant) {
              return contact::update<decltype(variant)>(law, k == 12 ? at : 0.0, k == 12 ? 0.0 : at,
                                                        history);
            });
        const double expected = area * (k == 12 ? answer.sigma : answer.tau);
        most = std::max(most, expected);
        worst = std::max(worst, std::fabs(reaction - expected));
        at += 0.01 * rig.controls.dt;
      }
      verify({"SP03", k == 12 ? "tension of a face" : "shear of a face in twelve directions", "N",
              area * 0.15e6, 2e-2, "steps of the path"},
             most);
      EXPECT_LT(worst / most, 1e-9) << "direction " << k;
      EXPECT_GT(history.kappa + history.slip, 5e-5) << "it went through softening";
    }
}

// --- rocking: a rigid block let go at a share of its slenderness, time until it stands upright

double time_to_upright(double p2, double slenderness, double start) {
  // phi'' = p^2 sin phi with phi = slenderness - angle; phi = phi0 + s^2 takes the root out
  const double phi0 = slenderness - start;
  const int n = 2000;
  const double end = std::sqrt(start);
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double s = end * k / n;
    const double f = k == 0 ? std::sqrt(2 / std::sin(phi0))
                            : 2 * s / std::sqrt(2 * (std::cos(phi0) - std::cos(phi0 + s * s)));
    sum += (k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2) * f;
  }
  return sum * end / n / 3 / std::sqrt(p2);
}

TEST(SpaceStatics, a_block_rocks_about_each_edge_in_the_time_of_its_closed_form) {
  const Vec3 size{0.3, 1.2, 0.2};
  for (const Frame& frame : frames())
    for (const bool about_x : {false, true})
      for (const double sense : {1.0, -1.0}) {
        ModelSpec spec = scenes::in_space({box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                           box("b", {-size.x / 2, 0, -size.z / 2}, size)},
                                          scenes::dry_joint(2e12, 8e11, std::atan(2.0)), kDensity);
        SpaceRig rig(compile(scenes::in_frame(std::move(spec), frame)));
        const double half = 0.5 * (about_x ? size.z : size.x), high = 0.5 * size.y;
        const double slenderness = std::atan(half / high), start = 0.3 * slenderness;
        const double r2 = half * half + high * high, m = rig.model.mass[0];
        const double inertia = m * r2 * 4 / 3;
        // about the edge it leans over
        const Vec3 axis = about_x ? Vec3{sense, 0, 0} : Vec3{0, 0, sense};
        const Vec3 to_edge = about_x ? Vec3{0, -high, sense * half} : Vec3{-sense * half, -high, 0};
        const Vec3 arm = -1.0 * to_edge;
        const Vec3 moved = turned(arm, Rotation{start * axis}) - arm;
        const Vec3 u = frame.direction(moved), k = frame.direction(axis);
        rig.state.ux[0] = u.x, rig.state.uy[0] = u.y, rig.state.uz[0] = u.z;
        rig.state.qw[0] = std::cos(start / 2);
        rig.state.qx[0] = std::sin(start / 2) * k.x;
        rig.state.qy[0] = std::sin(start / 2) * k.y;
        rig.state.qz[0] = std::sin(start / 2) * k.z;
        rig.set_gravity(-kG * frame.direction({0, 1, 0}));
        rig.controls.damping = 0;
        rig.load_state();
        const auto lean = [&] {
          return dot(Vec3{rig.state.qx[0], rig.state.qy[0], rig.state.qz[0]}, k);
        };
        double before = lean(), now = before;
        while (now > 0 && rig.state.time < 2) {
          for (int s = 0; s < 20; ++s) rig.advance();
          rig.store_state();
          before = now, now = lean();
        }
        const double time = rig.state.time - 20 * rig.controls.dt * (1 - before / (before - now));
        verify({"SP21", "rocking about an edge: time to upright", "s",
                time_to_upright(m * kG * std::sqrt(r2) / inertia, slenderness, start), 2e-3,
                "the edge gives by a few micrometres"},
               time);
      }
}

}  // namespace
}  // namespace wythe::space_statics_test
