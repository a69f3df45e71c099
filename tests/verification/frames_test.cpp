// Frames against closed forms: stiffness of portals, plastic collapse, bending with axial force, a beam on blocks.
//
//      3 =====beam===== 2       the portal stands over a block that it does not touch: the block only gives the
//        ||          ||         model its masonry
//        ||   [b0]   ||
//      __||___|__|___||__
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/wall/profiles.h"
#include "scenes/scenes.h"
#include "verification/record.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/solve.h"

namespace wythe::verification::frames_test {
namespace {

constexpr double kSpan = 4, kHeight = 3;  // of the axis [m]
constexpr double kE = 210e9, kG = 81e9, kYield = 235e6;

// A block in the middle, and no weight: frames are pushed alone.
ModelSpec yard() {
  ModelSpec spec = scenes::block_on_ground(1, 0.5, scenes::dry_joint(60e9, 30e9, 0.5), 0.3, 2000);
  spec.material["contact"] = scenes::dry_joint(60e9, 30e9, 0.5);
  spec.solve.gravity = 0;
  spec.solve.raise_light_inertia = false;  // the block would lend its own slowness
  spec.solve.collapse_displacement = 10;
  return spec;
}

FrameSpec portal(FrameFeet feet) {
  FrameSpec frame;
  frame.name = "F1";
  const double left = 0.5 - kSpan / 2, right = 0.5 + kSpan / 2;
  frame.line = {{left, 0}, {left, kHeight}, {right, kHeight}, {right, 0}};
  frame.feet = feet;
  frame.profile = "HEB 200";
  frame.grade = "S235";
  frame.joint = "contact";
  return frame;
}

// The corner at the left is segment 0, that at the right 1; parts follow in their order, 8 segments each.
StageSpec push(const std::string& block, Direction direction, double until,
               double velocity = 0.02) {
  StageSpec stage = scenes::push_stage(block, direction, velocity, until);
  return stage;
}

struct Ran {
  Model model;
  State state;
  Result result;
};
Ran solved(const ModelSpec& spec) {
  Ran r{compile(spec), {}, {}};
  r.state = initial_state(r.model);
  r.result = solve(r.model, r.state);
  return r;
}

// Force per displacement of the last row.
double stiffness_of(const Ran& r) {
  const CurveRow& last = r.result.curve.back();
  return last.base_shear / last.displacement;
}

double lateral_stiffness(const ModelSpec& spec) {
  ModelSpec pushed = spec;
  pushed.stage = {scenes::gravity_stage(), push("frame0_0", Direction::kPlusX, 1e-3, 5e-4)};
  return stiffness_of(solved(pushed));
}

// As slender as the textbook's: neither shear nor axial force lengthens anything.
SectionSpec slender() {
  const geometry::Section heb = *geometry::profile_named("HEB 200");
  SectionSpec s;
  s.height = heb.height, s.width = heb.width;
  s.area = 40 * heb.area, s.shear_area = 40 * heb.shear_area;
  s.second_moment = heb.second_moment, s.plastic_modulus = heb.plastic_modulus;
  s.mass = heb.mass;
  return s;
}

TEST(Frames, portal_with_fixed_feet_has_the_stiffness_of_the_textbook) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  spec.frame[0].profile = "";
  spec.frame[0].section = slender();
  const double bending = kE * slender().second_moment, beta = kHeight / kSpan;
  verify({"frame", "portal, fixed feet: lateral stiffness", "N/m",
          24 * bending / std::pow(kHeight, 3) * (6 * beta + 1) / (6 * beta + 4), 1e-2,
          "quadrature of the curvature is exact; axial and shear flexibility of the section left, "
          "0.5 %"},
         lateral_stiffness(spec));
}

TEST(Frames, portal_with_hinged_feet_has_the_stiffness_of_the_textbook) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kHinged)};
  spec.frame[0].profile = "";
  spec.frame[0].section = slender();
  const double bending = kE * slender().second_moment, beta = kHeight / kSpan;
  verify({"frame", "portal, hinged feet: lateral stiffness", "N/m",
          12 * bending / std::pow(kHeight, 3) / (2 + 1 / beta), 1e-2, "as with fixed feet"},
         lateral_stiffness(spec));
}

// Timoshenko members between nodes, by direct stiffness: what the chain has to give for a real profile.
class Members {
 public:
  explicit Members(int nodes) : k_(Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes)) {}
  // From node a to b; -1: held.
  void add(int a, int b, Vec2 from, Vec2 to, const geometry::Section& s, bool hinged_at_a) {
    const double l = std::hypot(to.x - from.x, to.y - from.y);
    const double c = (to.x - from.x) / l, n = (to.y - from.y) / l, ei = kE * s.second_moment;
    const double phi = 12 * ei / (kG * s.shear_area * l * l), q = ei / (l * (1 + phi));
    Eigen::Matrix<double, 6, 6> k = Eigen::Matrix<double, 6, 6>::Zero();
    const double axial = kE * s.area / l;
    k(0, 0) = k(3, 3) = axial, k(0, 3) = k(3, 0) = -axial;
    const double v = 12 * q / (l * l), m = 6 * q / l, near = (4 + phi) * q, far = (2 - phi) * q;
    k(1, 1) = k(4, 4) = v, k(1, 4) = k(4, 1) = -v;
    k(1, 2) = k(2, 1) = k(1, 5) = k(5, 1) = m;
    k(4, 2) = k(2, 4) = k(4, 5) = k(5, 4) = -m;
    k(2, 2) = k(5, 5) = near, k(2, 5) = k(5, 2) = far;
    if (hinged_at_a) k -= Eigen::Matrix<double, 6, 6>(k.col(2) * k.row(2) / k(2, 2));
    Eigen::Matrix<double, 6, 6> turn = Eigen::Matrix<double, 6, 6>::Zero();
    for (const int i : {0, 3}) {
      turn(i, i) = turn(i + 1, i + 1) = c, turn(i, i + 1) = n, turn(i + 1, i) = -n;
      turn(i + 2, i + 2) = 1;
    }
    const Eigen::Matrix<double, 6, 6> global = turn.transpose() * k * turn;
    const int at[6] = {3 * a, 3 * a + 1, 3 * a + 2, 3 * b, 3 * b + 1, 3 * b + 2};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        if (at[i] >= 0 && at[j] >= 0) k_(at[i], at[j]) += global(i, j);
  }
  // Force over displacement at a freedom.
  [[nodiscard]] double stiffness_at(int freedom) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(k_.rows());
    force[freedom] = 1;
    return 1 / k_.ldlt().solve(force)[freedom];
  }

 private:
  Eigen::MatrixXd k_;
};

void expect_portal_of_members(FrameFeet feet) {
  ModelSpec spec = yard();
  spec.frame = {portal(feet)};
  spec.frame[0].beam_profile = "IPE 240";
  const geometry::Section column = *geometry::profile_named("HEB 200"),
                          beam = *geometry::profile_named("IPE 240");
  const bool hinged = feet == FrameFeet::kHinged;
  Members exact(2);
  exact.add(-1, 0, {0, 0}, {0, kHeight}, column, hinged);
  exact.add(0, 1, {0, kHeight}, {kSpan, kHeight}, beam, false);
  exact.add(-1, 1, {kSpan, 0}, {kSpan, kHeight}, column, hinged);
  verify({"frame",
          std::string("portal of HEB 200 and IPE 240, ") + (hinged ? "hinged" : "fixed") +
              " feet, by members with shear",
          "N/m", exact.stiffness_at(0), 2e-3,
          "quadrature is exact; the push at 0.5 mm/s swings by less"},
         lateral_stiffness(spec));
}
TEST(Frames, portal_of_rolled_profiles_is_as_stiff_as_its_members) {
  expect_portal_of_members(FrameFeet::kFixed);
  expect_portal_of_members(FrameFeet::kHinged);
}

// --- plastic ---------------------------------------------------------------------------------------------

double plastic_moment() { return kYield * geometry::profile_named("HEB 200")->plastic_modulus; }

double sway_load(FrameFeet feet) {
  ModelSpec spec = yard();
  spec.frame = {portal(feet)};
  spec.stage = {scenes::gravity_stage(), push("frame0_0", Direction::kPlusX, 0.15, 0.05)};
  const Ran r = solved(spec);
  EXPECT_EQ(r.result.status, SolveStatus::kCompleted);
  return r.result.curve.back().base_shear;
}
TEST(Frames, sway_of_a_portal_takes_its_plastic_moments_over_its_height) {
  verify(
      {"frame", "sway of a portal, fixed feet: collapse load", "N", 4 * plastic_moment() / kHeight,
       1e-2, "hinges at the ends of the columns; geometry of 150 mm, 0.3 %"},
      sway_load(FrameFeet::kFixed));
  verify({"frame", "sway of a portal, hinged feet: collapse load", "N",
          2 * plastic_moment() / kHeight, 1e-2, "hinges at the tops alone"},
         sway_load(FrameFeet::kHinged));
}

//   the two segments beside the middle of the beam go down, half a segment from it: P = 4 Mpl / a
TEST(Frames, a_beam_fails_with_hinges_at_its_ends_and_in_the_middle) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  spec.frame[0].beam_profile = "IPE 200";
  StageSpec down = push("", Direction::kMinusY, 0.05, 0.02);
  down.get<PushStage>().at = {.x = 0.5 - 0.3, .y = kHeight - 0.05, .width = 0.6, .height = 0.1};
  spec.stage = {scenes::gravity_stage(), down};
  const Ran r = solved(spec);
  ASSERT_EQ(r.model.stages[1].driven.size(), 2U);
  const double mpl = kYield * geometry::profile_named("IPE 200")->plastic_modulus;
  const double arm = kSpan / 2 - kSpan / 16, sagged = r.result.curve.back().displacement;
  // the columns press the beam, which has sagged: second order
  double thrust = 0;
  const std::vector<FrameReading> sections = read_frames(r.model, r.state);
  for (std::size_t k = 0; k < sections.size(); ++k)
    if (r.model.frames.member[k] == 1) thrust = std::max(thrust, -sections[k].normal);
  verify({"frame", "beam of a portal under two loads near its middle: collapse load", "N",
          (4 * mpl - 2 * thrust * sagged) / arm, 1e-2,
          "hinges stand at the ends and in the middle of the beam; the push's drag"},
         r.result.curve.back().base_shear);
}

// N is a dead load at the tip: the foot yields at H h + N u = M(N).
TEST(Frames, a_post_under_axial_force_bears_the_moment_of_its_three_fibres) {
  const geometry::Section heb = *geometry::profile_named("HEB 200");
  const double squash = kYield * heb.area, fibre = heb.second_moment / heb.plastic_modulus;
  const double outer = heb.second_moment / (heb.area * fibre * fibre);
  for (const double n : {0.0, 0.3, 0.6}) {
    ModelSpec spec = yard();
    FrameSpec post = portal(FrameFeet::kFixed);
    post.line = {{-0.1, 0}, {-0.1, kHeight}};  // beside the block, which it touches
    spec.frame = {post};
    spec.material["contact"] = scenes::dry_joint(1e6, 1e6, 1e-6);
    spec.stage = {scenes::gravity_stage(), push("frame0_7", Direction::kMinusX, 0.08, 0.02)};
    Ran r{compile(spec), {}, {}};
    BlockId tip = 0;
    for (BlockId b = 0; b < r.model.n_block; ++b)
      if (r.model.anatomy.block_id[b] == "frame0_7") tip = b;
    r.model.stages[0].loads.push_back({tip, 0, 0, 0, -n * squash});
    r.state = initial_state(r.model);
    r.result = solve(r.model, r.state);
    ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
    const FrameReading foot = read_frames(r.model, r.state)[0];
    const double moment = plastic_moment() * std::min(1.0, (1 + foot.normal / squash) / outer);
    verify({"frame", "post under N = " + fmt::format("{:.1f}", n) + " Npl: moment of its foot",
            "N m", moment, 2e-3, "on the line of three fibres; N as it is under the push"},
           foot.moment);
    // by equilibrium of the whole post; the push drags a little at the base, and is dragged at the tip
    const CurveRow& last = r.result.curve.back();
    const double height = kHeight - kHeight / 16;
    verify({"frame", "post under N = " + fmt::format("{:.1f}", n) + " Npl: force at its tip", "N",
            (moment - n * squash * last.displacement) / height, 1e-2 * moment / height,
            "1 % of what the moment gives: the push's drag", true},
           (last.base_shear + last.reaction) / 2);
  }
}

// --- with masonry ----------------------------------------------------------------------------------------

//      =============     rests on two narrow blocks by contact alone and bends under its own weight
//      [ ]       [ ]
TEST(Frames, a_beam_rests_on_blocks_and_bends_by_its_own_weight) {
  constexpr double kLong = 4, kNarrow = 0.05, kTop = 0.5;
  const double step = kLong / 8, span = kLong - step;
  ModelSpec spec = scenes::assembly(
      {scenes::rectangle("left", step / 2 - kNarrow / 2, 0, kNarrow, kTop),
       scenes::rectangle("right", kLong - step / 2 - kNarrow / 2, 0, kNarrow, kTop)},
      scenes::dry_joint(1e12, 1e12, 0.5), 0.3, 2000);
  spec.material["contact"] = scenes::dry_joint(1e9, 1e7, 1e-6);  // a seat that turns freely
  FrameSpec beam;
  beam.line = {{0, kTop + 0.1}, {kLong, kTop + 0.1}};
  beam.feet = FrameFeet::kResting;
  beam.profile = "HEB 200";
  beam.grade = "S235";
  beam.joint = "contact";
  spec.frame = {beam};
  spec.solve.settle_ratio = 1e-9;
  spec.stage = {scenes::gravity_stage()};
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted) << text_of(r.result.reason);
  const geometry::Section heb = *geometry::profile_named("HEB 200");
  const double w = heb.mass * 9.81, ei = kE * heb.second_moment;
  const auto down = [&](const std::string& id) {
    for (std::size_t b = 0; b < r.model.anatomy.block_id.size(); ++b)
      if (r.model.anatomy.block_id[b] == id) return -r.state.uy[b];
    return 0.0;
  };
  // of the middle, where two segments meet: the mean of both, and half a segment of their slopes
  const auto turned = [&](const std::string& id) {
    for (std::size_t b = 0; b < r.model.anatomy.block_id.size(); ++b)
      if (r.model.anatomy.block_id[b] == id) return r.state.theta[b];
    return 0.0;
  };
  const double middle = 0.5 * (down("frame0_3") + down("frame0_4")) -
                        0.25 * step * (turned("frame0_3") - turned("frame0_4")) -
                        0.5 * (down("frame0_0") + down("frame0_7"));
  const double hang = w * step * step / 8;  // of half a segment beyond each support
  verify({"frame", "beam on two blocks under its own weight: deflection", "m",
          5 * w * std::pow(span, 4) / (384 * ei) - hang * span * span / (8 * ei) +
              w * span * span / (8 * kG * heb.shear_area),
          2e-2, "quadrature, 1.3 % at 8 segments; the blocks' width turns the supports a little"},
         middle);
}

// --- energy ----------------------------------------------------------------------------------------------

TEST(Frames, energy_balances_over_a_plastic_cycle) {
  ModelSpec spec = yard();
  spec.frame = {portal(FrameFeet::kFixed)};
  StageSpec cycle = push("frame0_0", Direction::kPlusX, 0, 0.05);
  cycle.get<PushStage>().until = kUnset;
  cycle.get<PushStage>().targets = {0.08, -0.08, 0.0};
  spec.stage = {scenes::gravity_stage(), cycle};
  const Ran r = solved(spec);
  ASSERT_EQ(r.result.status, SolveStatus::kCompleted);
  EXPECT_LT(r.result.energy.gap_ratio, 1e-3);
  double area = 0;  // under the curve
  for (std::size_t k = 1; k < r.result.curve.size(); ++k)
    area += 0.5 * (r.result.curve[k].base_shear + r.result.curve[k - 1].base_shear) *
            (r.result.curve[k].displacement - r.result.curve[k - 1].displacement);
  verify({"frame", "plastic cycle of a portal: taken by yielding", "J",
          area - r.result.energy.elastic, 2e-2, "the curve's rows are means"},
         r.result.energy.friction);
  EXPECT_GT(r.result.energy.friction, 1e3);
}

}  // namespace
}  // namespace wythe::verification::frames_test
