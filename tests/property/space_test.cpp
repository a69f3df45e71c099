// Laws of nature in space: after turning, mirroring or renumbering the wall, or cutting a face in two, the result follows.
//
// Two leaves on a floor get their weight and are pushed obliquely until they crack and slide. Only rounding may
// differ. The vector form of local damping does not depend on axes, so it may stay on. It is not continuous near
// zero velocity, which magnifies rounding. Tolerances are relative to the largest displacement or reaction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenes/space_rig.h"

namespace wythe::space_test {
namespace {

using scenes::box;
using scenes::Frame;
using scenes::SpaceRig;

constexpr int kLoadSteps = 1500, kPushSteps = 2500;
constexpr double kUndamped = 1e-9;
constexpr double kDamped = 1e-3;  // within it a turned world scatters by some 1e-5 to 1e-4

ModelSpec leaves() {
  std::vector<BodySpec> bodies{box("floor", {-1, -0.2, -1}, {3, 0.2, 2}, true)};
  for (int leaf = 0; leaf < 2; ++leaf)
    for (int course = 0; course < 4; ++course)
      for (int k = 0; k < 3; ++k)
        bodies.push_back(
            box("l" + std::to_string(leaf) + "c" + std::to_string(course) + "u" + std::to_string(k),
                {0.2 * k + (course % 2 == 0 ? 0.0 : 0.08), 0.1 * course, 0.12 * leaf},
                {0.2, 0.1, 0.12}));
  ModelSpec spec = scenes::in_space(bodies, scenes::paper_joint());
  StageSpec push = scenes::push_stage("l0c3*", Direction::kPlusX, 0.05, 1);
  push.get<PushStage>().drive.along = {0.3, 0, 1};
  spec.stage = {push};
  return spec;
}

struct Answer {
  Model model;
  State state;
  std::vector<double> reaction;

  [[nodiscard]] Vec3 moved(const std::string& id) const {
    const auto i = static_cast<std::size_t>(scenes::block_named(model, id));
    return {state.ux[i], state.uy[i], state.uz[i]};
  }
  [[nodiscard]] Vec3 turned(const std::string& id) const {
    const auto i = static_cast<std::size_t>(scenes::block_named(model, id));
    return {state.qx[i], state.qy[i], state.qz[i]};
  }
};

Answer push(const ModelSpec& spec, double damping, Vec3 down = {0, -1, 0}) {
  SpaceRig rig(compile(spec));
  rig.controls.dt = 8e-6;  // below the bound of every one of these walls
  EXPECT_LT(rig.controls.dt, 2 / rig.model.omega_max / std::sqrt(1.8));
  rig.controls.damping = damping;
  for (int k = 1; k <= kLoadSteps; ++k) {
    rig.set_gravity(9.81 * k / kLoadSteps * down);
    rig.advance();
  }
  Answer answer;
  for (int k = 1; k <= kPushSteps; ++k) {
    rig.drive(0, 0.05 * std::min(1.0, k / 500.0));
    answer.reaction.push_back(rig.advance());
  }
  rig.store_state();
  answer.model = rig.model;
  answer.state = rig.state;
  return answer;
}

// b's answer is a's once `to` has moved its vectors; turns are axial: a mirror turns them round as well.
template <class To>
void expect_same(const Answer& a, const Answer& b, double tolerance, const To& to,
                 double axial = 1) {
  const double most = *std::max_element(a.reaction.begin(), a.reaction.end());
  double apart = 0;
  for (std::size_t k = 0; k < a.reaction.size(); ++k)
    apart = std::max(apart, std::fabs(a.reaction[k] - b.reaction[k]));
  EXPECT_LT(apart, tolerance * most);
  double furthest = 0, widest = 0;
  for (const std::string& id : a.model.anatomy.block_id) {
    furthest = std::max(furthest, length(a.moved(id)));
    widest = std::max(widest, length(a.turned(id)));
  }
  for (const std::string& id : a.model.anatomy.block_id) {
    EXPECT_LT(length(to(a.moved(id)) - b.moved(id)), tolerance * furthest) << id;
    EXPECT_LT(length(axial * to(a.turned(id)) - b.turned(id)), tolerance * widest) << id;
  }
}

TEST(SpaceWorld, the_push_cracks_the_wall_and_slides_it) {
  for (const double damping : {0.0, 0.8}) {
    const Answer a = push(leaves(), damping);
    double most = 0, slid = 0;
    for (const PointReading& p : read_points(a.model, a.state))
      most = std::max(most, p.damage_tension), slid = std::max(slid, p.slid);
    EXPECT_GT(most, 0.99);
    EXPECT_GT(slid, 1e-6);
  }
}

TEST(SpaceWorld, any_turn_gives_the_turned_answer_step_by_step) {
  for (const double damping : {0.0, 0.8}) {
    const Answer a = push(leaves(), damping);
    for (const Frame& frame : {Frame::turned(0.3, 0.5, -0.7, 0.2, {1, -2, 0.5}),
                               Frame::turned(1, 0, 1, 0), Frame::turned(-0.6, 0.1, 0.2, 0.9)}) {
      const Answer b =
          push(scenes::in_frame(leaves(), frame), damping, frame.direction({0, -1, 0}));
      expect_same(a, b, damping > 0 ? kDamped : kUndamped,
                  [&](Vec3 v) { return frame.direction(v); });
    }
  }
}

TEST(SpaceWorld, damping_by_components_knows_the_axes) {
  // what the vector form is for: with the form of the paper the turned world answers otherwise
  ModelSpec spec = leaves();
  spec.solve.damping_form = DampingForm::kComponents;
  const Frame frame = Frame::turned(0.3, 0.5, -0.7, 0.2);
  const Answer a = push(spec, 0.8),
               b = push(scenes::in_frame(spec, frame), 0.8, frame.direction({0, -1, 0}));
  EXPECT_GT(std::fabs(a.reaction.back() - b.reaction.back()), 1e-3 * std::fabs(a.reaction.back()));
}

ModelSpec mirrored(ModelSpec spec) {
  for (BodySpec& body : spec.body)
    for (Polyhedron& part : body.part) {
      for (Vec3& v : part.vertex) v.x = -v.x;
      for (auto& face : part.face) std::reverse(face.begin(), face.end());
    }
  for (StageSpec& stage : spec.stage)
    stage.get<PushStage>().drive.along[0] = -stage.get<PushStage>().drive.along[0];
  return spec;
}

TEST(SpaceWorld, the_mirrored_wall_gives_the_mirrored_answer) {
  for (const double damping : {0.0, 0.8})
    expect_same(
        push(leaves(), damping), push(mirrored(leaves()), damping),
        damping > 0 ? kDamped : kUndamped,
        [](Vec3 v) {
          return Vec3{-v.x, v.y, v.z};
        },
        -1);
}

TEST(SpaceWorld, the_order_of_blocks_does_not_matter) {
  for (const double damping : {0.0, 0.8}) {
    ModelSpec other = leaves();
    std::reverse(other.body.begin(), other.body.end());
    const Answer a = push(leaves(), damping), b = push(other, damping);
    EXPECT_NE(scenes::block_named(a.model, "l0c0u0"), scenes::block_named(b.model, "l0c0u0"));
    expect_same(a, b, damping > 0 ? kDamped : kUndamped, [](Vec3 v) { return v; });
  }
}

TEST(SpaceWorld, a_face_cut_in_two_carries_the_same_while_it_is_elastic) {
  // the floor in two pieces that meet under the middle of the first block: Lobatto points integrate a
  // linear stress exactly on the whole and on both halves
  ModelSpec whole = scenes::in_space(
      {box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true), box("a", {-0.15, 0, -0.1}, {0.3, 0.1, 0.2}),
       box("b", {-0.15, 0.1, -0.1}, {0.3, 0.1, 0.2})},
      scenes::elastic_joint(2e9, 8e8));
  StageSpec shove = scenes::push_stage("b", Direction::kPlusX, 0.05, 1);
  shove.get<PushStage>().drive.along = {0.3, 0.2, 1};
  whole.stage = {shove};
  ModelSpec halves = whole;
  halves.body[0] = box("left", {-1, -0.2, -1}, {1.05, 0.2, 2}, true);
  halves.body.push_back(box("right", {0.05, -0.2, -1}, {0.95, 0.2, 2}, true));
  const Answer a = push(whole, 0), b = push(halves, 0);
  EXPECT_EQ(a.model.n_joint, 2);
  EXPECT_EQ(b.model.n_joint, 3);
  expect_same(a, b, kUndamped, [](Vec3 v) { return v; });
  // force and moment of the halves about one place are those of the whole
  const auto sums = [](const Answer& x) {
    Vec3 force, moment;
    const WallReading wall = read_wall(x.model, x.state);
    for (JointId j = x.model.n_pair; j < x.model.n_joint; ++j)
      for (const PointReading& p : wall.points_of(wall.joints[j])) {
        const Vec3 f =
            x.model.area[j] * p.share * (p.shear_vector + p.normal_stress * Vec3{0, 1, 0});
        force = force + f, moment = moment + cross(p.where, f);
      }
    return std::pair(force, moment);
  };
  const auto one = sums(a), two = sums(b);
  EXPECT_LT(length(one.first - two.first), 1e-6 * length(one.first));
  EXPECT_LT(length(one.second - two.second), 1e-6 * length(one.second));
}

}  // namespace
}  // namespace wythe::space_test
