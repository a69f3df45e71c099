// Anchors and wedges of frames against equilibrium (docs/theory/frames.md, "Anchors and wedges").
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::anchors_test {
namespace {

constexpr double kTension = 5e3, kShear = 3e3, kSlip = 1e-3;  // of one anchor [N], [m]
constexpr double kWedged = 8e3;                               // force of all wedges [N]

// A block of 1 m by 0.5 m without weight beside a stiff column; two anchors lie at its height.
//
//     +--------+||
//     |   b    |||   HEB 200, fixed at its foot
//   __|________|||__
ModelSpec anchored_block() {
  ModelSpec spec = scenes::block_on_ground(1, 0.5, scenes::dry_joint(60e9, 30e9, 0.5), 0.3, 2000);
  spec.material["contact"] = scenes::dry_joint(60e9, 30e9, 1e-6);
  spec.solve.gravity = 0;
  spec.solve.raise_light_inertia = false;
  FrameSpec column;
  column.name = "F1";
  column.line = {{1.1, 0}, {1.1, 1}};
  column.feet = FrameFeet::kFixed;
  column.profile = "HEB 200";
  column.grade = "S275";
  column.joint = "contact";
  column.anchors = {
      .spacing = 0.25, .depth = 0.1, .tension = kTension, .shear = kShear, .slip = kSlip};
  spec.frame = {column};
  return spec;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec, std::int64_t steps = 0) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  SolveOptions options;
  options.step_budget = steps;
  r.result = solve(r.model, r.state, options);
  return r;
}
Ran pulled(Direction direction, double until) {
  ModelSpec spec = anchored_block();
  StageSpec push = scenes::push_stage("b0", direction, 0.01, until);
  push.get<PushStage>().fixity.rotation = Freedom::kBlocked;
  spec.stage = {scenes::gravity_stage(), push};
  return solved(spec);
}

// Sum of the forces of all links of a kind [N].
double force_of(const Ran& r, LinkKind kind) {
  const std::vector<LinkReading> links = read_links(r.model, r.state);
  double sum = 0;
  for (std::size_t k = 0; k < links.size(); ++k)
    if (r.model.links.kind[k] == kind) sum += links[k].force;
  return sum;
}

// Pulled off by more than its slip an anchor bears its strength, and goes on doing so.
TEST(Anchors, are_pulled_out_at_their_strength) {
  const Ran r = pulled(Direction::kMinusX, 3e-3);
  ASSERT_EQ(r.model.links.n, 4);
  verify({"AN01", "two anchors of a column, block pulled off by three times their slip: force", "N",
          2 * kTension, 2e-3, "the damped motion of the block"},
         std::fabs(r.result.curve.back().base_shear));
  EXPECT_NEAR(force_of(r, LinkKind::kAnchor), 2 * kTension, 1e-6 * kTension);
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  bool told = false;
  for (const Event& event : r.result.events) told = told || event.name.code == "event.link_yields";
  EXPECT_TRUE(told);
}

// Before that they are springs of strength over slip; the column bends by a thirtieth of it.
TEST(Anchors, are_as_stiff_as_their_slip_says) {
  const Ran r = pulled(Direction::kMinusX, 0.5e-3);
  const CurveRow& last = r.result.curve.back();
  verify({"AN02", "stiffness of two anchors before they yield", "N/m", 2 * kTension / kSlip, 0.02,
          "the column bends too"},
         std::fabs(last.base_shear / last.displacement));
}

// Pressed on, the block leans on the column, and its anchors bear nothing.
TEST(Anchors, bear_no_pressure) {
  const Ran r = pulled(Direction::kPlusX, 0.1e-3);
  EXPECT_LT(force_of(r, LinkKind::kAnchor), 2e-3 * kTension);  // the column turns a little
  EXPECT_GT(std::fabs(r.result.curve.back().base_shear), 10 * kTension);
}

// Lifted, they are sheared off.
TEST(Anchors, are_sheared_off_at_their_strength) {
  const Ran r = pulled(Direction::kPlusY, 4e-3);
  verify({"AN03", "two anchors of a column, block lifted: force across them", "N", 2 * kShear, 1e-6,
          "their law"},
         std::fabs(force_of(r, LinkKind::kDowel)));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
}

// A window cut under load, with a frame in it.
ModelSpec cut_wall() {
  ModelSpec spec = scenes::cut_under_load(scenes::framed(scenes::small_wall(1e-3, 0.02, 20e3)));
  FrameSpec& frame = spec.frame[0];
  frame.yield_strength = 500e6;
  frame.section.area *= 4;
  frame.section.mass *= 4;
  return spec;
}
ModelSpec anchored_wall() {
  ModelSpec spec = cut_wall();
  spec.frame[0].anchors = {
      .spacing = 0.08, .depth = 0.05, .tension = 500, .shear = 500, .slip = 1e-3};
  return spec;
}
ModelSpec wedged_wall() {
  ModelSpec spec = cut_wall();
  spec.frame[0].wedges = {.force = kWedged, .spacing = 0.1};
  return spec;
}
ModelSpec without_push(ModelSpec spec) {
  spec.stage.pop_back();
  spec.solve.settle_ratio = 1e-6;
  return spec;
}
// With one step of the last stage.
Ran begun(const ModelSpec& spec) {
  const Result whole = solved(spec).result;
  return solved(spec, whole.steps - whole.stages.back().steps + 1);
}

// A frame that is put up under load has anchors without force.
TEST(Anchors, begin_without_force_where_a_stage_puts_them_up) {
  const ModelSpec spec = without_push(anchored_wall());
  const Ran start = begun(spec), cut = solved(spec);
  ASSERT_EQ(cut.result.status, SolveStatus::kCompleted);
  const auto most = [](const Ran& r) {
    double force = 0;
    for (const LinkReading& link : read_links(r.model, r.state))
      force = std::max(force, std::fabs(link.force));
    return force;
  };
  EXPECT_GT(most(cut), 1);
  EXPECT_LT(most(start), 1e-3 * most(cut));
  for (const Event& event : cut.result.events) EXPECT_NE(event.name.code, "event.link_yields");
  EXPECT_LT(cut.result.energy.gap_ratio, 1e-3);
}

// Before their stage they are not there.
TEST(Anchors, are_not_there_before_their_frame) {
  const Result whole = solved(without_push(anchored_wall())).result;
  const Ran r = solved(without_push(anchored_wall()), whole.steps - whole.stages.back().steps - 1);
  ASSERT_EQ(r.state.stage, 1);
  for (const LinkReading& link : read_links(r.model, r.state)) EXPECT_EQ(link.force, 0);
}

double ground_force(const Ran& r) {
  double sum = 0;
  for (const JointReading& joint : read_wall(r.model, r.state).joints)
    if (joint.shape.a == kGroundBlock) sum += joint.compression;
  return sum;
}

// However far beam and masonry give way, the wedges have their force at the end of the stage. It is between parts of
// the wall, so the ground bears no more.
TEST(Wedges, have_their_force_when_they_are_in) {
  const Ran r = solved(without_push(wedged_wall())), plain = solved(without_push(cut_wall()));
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  verify({"AN04", "wedges between a frame and the masonry above: their force when they are in", "N",
          kWedged, 1e-3, "settled to 1e-6"},
         -force_of(r, LinkKind::kWedge));
  EXPECT_NEAR(ground_force(r), ground_force(plain), 1e-4 * ground_force(plain));
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  for (const Event& event : r.result.events) EXPECT_NE(event.name.code, "event.link_yields");
}

// Later they stay as they are: more load presses them more, and a wall that rises lets go of them.
TEST(Wedges, stay_when_the_jack_is_gone) {
  ModelSpec spec = without_push(wedged_wall());
  StageSpec more = spec.stage[1];
  ASSERT_EQ(more.kind(), StageKind::kLoad);
  more.name = "more";
  spec.stage.push_back(more);
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_GT(-force_of(r, LinkKind::kWedge), 1.02 * kWedged);
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  const std::vector<LinkReading> links = read_links(r.model, r.state);
  for (std::size_t k = 0; k < links.size(); ++k)
    if (r.model.links.kind[k] == LinkKind::kWedge) {
      EXPECT_LE(links[k].force, 0);  // none pulls
    }
}

TEST(Wedges, come_in_without_a_jolt) {
  const Ran start = begun(without_push(wedged_wall()));
  double speed = 0;
  for (std::size_t i = 0; i < start.state.vx.size(); ++i)
    speed = std::max(speed, std::hypot(start.state.vx[i], start.state.vy[i]));
  EXPECT_LT(speed, 0.01 * start.model.solve.gravity * start.result.time_step);
}

// A run that stops within the stage goes on to the same bits.
TEST(Wedges, a_run_goes_on_where_it_stopped) {
  ModelSpec spec = wedged_wall();
  spec.frame[0].anchors = anchored_wall().frame[0].anchors;
  spec.solve.settle_ratio = 1e-3;
  const Ran whole = solved(spec);
  ASSERT_EQ(whole.result.status, SolveStatus::kCompleted);
  for (const std::int64_t back : {100, 5}) {
    const std::int64_t cut = whole.result.steps - whole.result.stages.back().steps - back;
    Ran part = solved(spec, cut);
    part.result = solve(part.model, part.state);
    EXPECT_EQ(part.result.state_hash, whole.result.state_hash) << back;
  }
}

// The path and the problem of the first fault.
std::string fault_of(const ModelSpec& spec) {
  try {
    (void)compile(spec);
  } catch (const InputError& error) {
    return error.faults().front().path + ": " + error.faults().front().problem;
  }
  return "none";
}

TEST(Anchors, what_cannot_be_is_refused_with_its_place) {
  ModelSpec spec = anchored_wall();
  spec.frame[0].gap = 1e-3;
  EXPECT_EQ(fault_of(spec), "frame.0.anchors: bridge a gap, in which they would bend");
  spec = anchored_wall();
  spec.frame[0].anchors.depth = 5;
  EXPECT_EQ(fault_of(spec),
            "frame.0.anchors.depth: meets no masonry so far behind the frame's face");
  spec = anchored_wall();
  spec.frame[0].anchors.shear = kUnset;
  EXPECT_EQ(fault_of(spec), "frame.0.anchors.shear: is missing");
  spec = wedged_wall();
  spec.wall.opening[0].cut = "";
  EXPECT_EQ(fault_of(spec),
            "frame.0.wedges: are driven in while a stage puts the frame up, and this one stands "
            "from the start");
}

}  // namespace
}  // namespace wythe::verification::anchors_test
