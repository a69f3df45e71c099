// The rules that name failures, on walls moved as rigid bodies: each mode and its mirror image.
//
// A mechanism is a set of rigid bodies (scenes/mechanism.h). `turn` is the rotation of a pier that
// rocks; 0.0128 moves mid-spandrel by 40 mm.
//
//   push ->   +----+-----------+----+     piers turn clockwise about their right corners, the
//             |    | spandrel  |    |     spandrel follows their inner edges, which turns it the
//             | /  +-----------+ /  |     other way
//             |/   |           |/   |
#include "wythe/parts/failure_mode.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "judge/modes/element_states.h"
#include "scenes/mechanism.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "wythe/parts/mechanism.h"

namespace wythe::failure_mode_test {
namespace {

using scenes::Mechanism;
using scenes::mirror_name;
using scenes::mirrored;
using scenes::Motion;
using scenes::moved;

constexpr double kTurn = 0.0128;  // [rad]
constexpr double kLength = 5.10;  // of the tuff wall [m]
constexpr double kRoundOff = 1e-9;

// --- the tuff wall ---------------------------------------------------------------------------

const Model& tuff_wall() {
  static const Model model = compile(scenes::tuff_wall(source_dir(), 50e-3));
  return model;
}

struct Parts {
  bool left_split = false, right_split = false;
  enum { kWhole, kLayers, kStepped, kCut } spandrel = kWhole;
};

// A pier from x0 to x1 turns about its right corner; a split one only above its diagonal.
Motion pier_motion(double x0, double x1, bool split, double turn, double x, double y) {
  constexpr double kHead = 2.64;
  const bool stands = split && y < kHead * (x1 - x) / (x1 - x0);
  return {.pivot_x = x1, .pivot_y = 0, .turn = stands ? 0 : -turn};
}

// Spandrel blocks about (2.55, height): their ends stay with the inner edges of the piers.
Motion spandrel_motion(double height, double turn) {
  return {.pivot_x = 2.55,
          .pivot_y = height,
          .turn = turn,
          .move_x = turn * height,
          .move_y = 0.85 * turn};
}

Mechanism mechanism(const Parts& parts, double turn = kTurn) {
  return [=](double x, double y) {
    if (x < 1.70) return pier_motion(0, 1.70, parts.left_split, turn, x, y);
    if (x > 3.40) return pier_motion(3.40, kLength, parts.right_split, turn, x, y);
    const Motion left = {.pivot_x = 1.70, .pivot_y = 0, .turn = -turn};
    const Motion right = {.pivot_x = kLength, .pivot_y = 0, .turn = -turn};
    const bool above_step = y > 3.62 - 0.87 * (x - 1.70) / 1.70;
    switch (parts.spandrel) {
      case Parts::kLayers: return spandrel_motion(y, turn);
      case Parts::kStepped: return above_step ? right : left;
      case Parts::kCut: return x < 2.55 ? left : right;
      case Parts::kWhole: break;
    }
    return spandrel_motion(3.13, turn);
  };
}

const Parts kFm1{.right_split = true};
const Parts kFm2{.left_split = true, .right_split = true};
const Parts kFm3{.right_split = true, .spandrel = Parts::kLayers};
const Parts kFm4{.spandrel = Parts::kLayers};
const Parts kFm5{};

FailureMode named(const Parts& parts, double turn = kTurn) {
  return name_from_state(tuff_wall(), moved(tuff_wall(), mechanism(parts, turn)));
}
FailureMode named_mirrored(const Parts& parts) {
  return name_from_state(tuff_wall(), moved(tuff_wall(), mirrored(mechanism(parts), kLength)));
}

const ElementSign& sign_of(const ElementStates& elements, const std::string& element,
                           const std::string& state) {
  for (const ElementState& e : elements)
    for (const ElementSign& s : e.signs)
      if (e.element == element && s.state == state) return s;
  throw std::runtime_error("no sign " + state + " of " + element);
}

bool shows(const FailureMode& mode, const std::string& element, const std::string& state) {
  return sign_of(mode.elements, element, state).holds();
}

const Evidence& flag_of(const FailureMode& mode, const std::string& element) {
  for (const Evidence& f : mode.flags)
    if (f.element == element) return f;
  throw std::runtime_error("no flag of " + element);
}

// --- modes -----------------------------------------------------------------------------------

struct Case {
  const char* name;
  Parts parts;
};
const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"FM-1", kFm1},
      {"FM-1", {.left_split = true}},
      {"FM-2", kFm2},
      {"FM-3", kFm3},
      {"FM-3", {.left_split = true, .spandrel = Parts::kLayers}},
      {"FM-3", {.left_split = true, .right_split = true, .spandrel = Parts::kStepped}},
      {"FM-4", kFm4},
      {"FM-4", {.spandrel = Parts::kStepped}},
      {"FM-4", {.spandrel = Parts::kCut}},
      {"FM-5", kFm5}};
  return all;
}

TEST(FailureMode, every_mechanism_gets_its_name) {
  for (const Case& c : cases()) EXPECT_EQ(named(c.parts).name, c.name);
}

TEST(FailureMode, mirror_image_gets_the_same_name) {
  for (const Case& c : cases()) EXPECT_EQ(named_mirrored(c.parts).name, c.name);
}

TEST(FailureMode, mirror_image_gives_the_same_measures_with_sides_swapped) {
  for (const Case& c : cases()) {
    const FailureMode mode = named(c.parts), mirror = named_mirrored(c.parts);
    for (const ElementState& e : mode.elements) {
      for (const ElementSign& s : e.signs) {
        const ElementSign& other = sign_of(mirror.elements, mirror_name(e.element), s.state);
        EXPECT_NEAR(other.value, s.value, kRoundOff * (1 + s.value)) << e.element << s.state;
      }
    }
  }
}

TEST(FailureMode, intact_wall_is_unclear) {
  const FailureMode mode = name_from_state(tuff_wall(), initial_state(tuff_wall()));
  EXPECT_EQ(mode.name, "unclear");
  for (const ElementState& e : mode.elements) EXPECT_EQ(e.state, "intact") << e.element;
  for (const Evidence& f : mode.flags) EXPECT_FALSE(f.holds()) << f.element;
}

TEST(FailureMode, rigid_motion_of_the_wall_is_no_damage_above_the_base) {
  const auto whole = [](double, double) {
    return Motion{.pivot_x = kLength, .turn = -0.05, .move_x = 0.2};
  };
  const ElementStates elements = read_elements(tuff_wall(), moved(tuff_wall(), whole));
  for (const ElementState& e : elements)
    if (e.kind == "spandrel" || e.kind == "connection") {
      EXPECT_EQ(e.state, "intact") << e.element;
    }
  EXPECT_FALSE(sign_of(elements, "left pier", study::kDiagonal).holds());
  EXPECT_TRUE(sign_of(elements, "left pier", study::kBaseSliding).holds());
}

TEST(FailureMode, scores_lie_between_0_and_1_and_add_up_to_1_at_most) {
  for (const Case& c : cases()) {
    double sum = 0;
    for (const auto& [name, score] : named(c.parts).scores) {
      EXPECT_GE(score, 0) << name;
      sum += score;
    }
    EXPECT_LE(sum, 1 + 1e-12);  // round-off
  }
}

// --- elements --------------------------------------------------------------------------------

TEST(ElementStates, rocking_wall_shows_rocking_piers_and_cracked_connections) {
  const FailureMode mode = named(kFm5);
  for (const char* pier : {"left pier", "right pier"}) {
    EXPECT_TRUE(shows(mode, pier, study::kRocking));
    EXPECT_TRUE(shows(mode, pier, study::kFlexural));
    EXPECT_FALSE(shows(mode, pier, study::kDiagonal));
    EXPECT_FALSE(shows(mode, pier, study::kSliding));
  }
  EXPECT_TRUE(shows(mode, "left connection", study::kFlexural));
  EXPECT_TRUE(shows(mode, "right connection", study::kFlexural));
  EXPECT_FALSE(shows(mode, "spandrel", study::kDiagonal));
}

TEST(ElementStates, opening_at_the_heel_is_that_of_the_rotation) {
  // the widest point of the foundation is at the heel: turn x width, less a cosine of 8e-5
  const FailureMode mode = named(kFm5);
  EXPECT_NEAR(sign_of(mode.elements, "left pier", study::kFlexural).value, 1e3 * 1.70 * kTurn,
              1e-3 * 1e3 * 1.70 * kTurn);
}

TEST(ElementStates, split_pier_is_the_one_that_is_named) {
  const FailureMode mode = named(kFm1);
  EXPECT_TRUE(shows(mode, "right pier", study::kDiagonal));
  EXPECT_FALSE(shows(mode, "left pier", study::kDiagonal));
  EXPECT_TRUE(flag_of(mode, "right pier").holds());  // grown by turn x height: up to 28 mm
  EXPECT_FALSE(flag_of(mode, "left pier").holds());
}

// A plumb strip at the right end of the right pier, `width` wide up to `height`, goes down by `way`.
Mechanism with_strip(const Mechanism& rest, double width, double height, double way = 4e-3) {
  return [=](double x, double y) {
    Motion m = rest(x, y);
    if (x > kLength - width && y < height) m.move_y -= way;
    return m;
  };
}

TEST(ElementStates, plumb_split_is_a_crack_through_the_pier_from_three_quarters_of_its_shaft_on) {
  const auto none = [](double, double) { return Motion{}; };
  const auto is_cracked = [&](double width, double height) {
    const State state = moved(tuff_wall(), with_strip(none, width, height));
    return shows(name_from_state(tuff_wall(), state), "right pier", study::kDiagonal);
  };
  EXPECT_FALSE(is_cracked(0.45, 1.00));
  EXPECT_FALSE(is_cracked(0.45, 1.45));  // as high as a stepped crack that crosses the pier
  EXPECT_TRUE(is_cracked(0.45, 2.64));
  EXPECT_TRUE(is_cracked(0.29, 2.64));
}

TEST(ElementStates, strip_of_half_a_unit_that_comes_off_an_edge_is_no_crack_through_the_pier) {
  const FailureMode mode =
      name_from_state(tuff_wall(), moved(tuff_wall(), with_strip(mechanism(kFm5), 0.155, 2.64)));
  EXPECT_FALSE(shows(mode, "right pier", study::kDiagonal));
  EXPECT_EQ(mode.name, "FM-5");
}

TEST(ElementStates, short_split_beside_a_sheared_spandrel_does_not_blur_the_name) {
  const FailureMode mode =
      name_from_state(tuff_wall(), moved(tuff_wall(), with_strip(mechanism(kFm4), 0.45, 1.35)));
  EXPECT_EQ(mode.name, "FM-4") << mode.sentence;
}

TEST(ElementStates, stepped_crack_that_crosses_a_pier_counts_at_the_slope_of_the_bond) {
  // what is above the steps, from (3.6, 1.9) down to the toe side, goes right
  const auto above = [](double x, double y) {
    const bool is_above = x > 3.40 && y > 1.75 - (x - 3.55) * 0.11 / 0.155 && y < 2.64;
    return Motion{.move_x = is_above ? 4e-3 : 0, .move_y = is_above ? -1e-3 : 0};
  };
  const FailureMode mode = name_from_state(tuff_wall(), moved(tuff_wall(), above));
  EXPECT_TRUE(shows(mode, "right pier", study::kDiagonal))
      << sign_of(mode.elements, "right pier", study::kDiagonal).value << " of "
      << sign_of(mode.elements, "right pier", study::kDiagonal).threshold;
}

TEST(ElementStates, crack_that_has_closed_still_counts) {
  State state = moved(tuff_wall(), mechanism(kFm1));
  std::fill(state.ux.begin(), state.ux.end(), 0.0);
  std::fill(state.uy.begin(), state.uy.end(), 0.0);
  std::fill(state.theta.begin(), state.theta.end(), 0.0);
  const FailureMode mode = name_from_state(tuff_wall(), state);
  EXPECT_EQ(mode.name, "FM-1");
  EXPECT_FALSE(flag_of(mode, "right pier").holds());  // the growth is of now
}

// The wall cut at a height: what is above moves by `slip`.
Mechanism cut(double height, double slip) {
  return [=](double, double y) { return Motion{.move_x = y > height ? slip : 0}; };
}

TEST(ElementStates, pier_slides_from_the_threshold_on) {
  const ModeRules rules = rules_for(tuff_wall());
  for (const double share : {0.99, 1.01}) {
    const FailureMode mode =
        name_from_state(tuff_wall(), moved(tuff_wall(), cut(1.0, share * rules.sliding)));
    EXPECT_EQ(shows(mode, "left pier", study::kSliding), share > 1);
    EXPECT_NEAR(sign_of(mode.elements, "right pier", study::kSliding).value,
                1e3 * share * rules.sliding, 1e-6);
  }
}

TEST(ElementStates, band_through_the_spandrel_is_parted_from_a_crack_width_on) {
  const ModeRules rules = rules_for(tuff_wall());
  for (const double share : {0.99, 1.01}) {
    const FailureMode mode =
        name_from_state(tuff_wall(), moved(tuff_wall(), cut(3.2, share * rules.crack)));
    const ElementSign& sheared = sign_of(mode.elements, "spandrel", study::kDiagonal);
    EXPECT_NEAR(sheared.value, share > 1 ? 1.70 : 0, kRoundOff);
    EXPECT_EQ(flag_of(mode, "spandrel").holds(), share > 1);  // and slides in one bed
  }
}

TEST(ElementStates, toe_is_crushed_by_the_strength_it_lost) {
  const Model& m = tuff_wall();
  State state = initial_state(m);
  const JointMaterial& foundation = m.materials[m.joint_material[m.n_joint - 1]];
  const double full = 2 * foundation.compressive_energy / foundation.compressive_strength;
  JointId corner = 0;  // the foundation joint farthest right
  double farthest = 0;
  for (JointId j = m.n_pair; j < m.n_joint; ++j) {
    const double x = m.centroid_x[m.joint_b[j]];
    if (x > farthest) corner = j;
    farthest = std::max(farthest, x);
  }
  state.crush[corner * m.n_face_point] = 0.25 * full;
  const ElementStates elements = read_elements(m, state);
  EXPECT_NEAR(sign_of(elements, "right toe of the right pier", study::kCrushing).value, 0.25, 1e-6);
  EXPECT_EQ(sign_of(elements, "left toe of the right pier", study::kCrushing).value, 0);
}

TEST(Flags, loaded_node_slides_against_its_neighbours) {
  const Model& m = tuff_wall();
  State state = initial_state(m);
  for (const BlockId b : m.stages.back().driven) state.ux[b] = 5e-3;
  const FailureMode mode = name_from_state(m, state);
  EXPECT_NEAR(flag_of(mode, "loaded node").value, 5, 1e-6);
  EXPECT_TRUE(flag_of(mode, "loaded node").holds());
}

// --- margins ---------------------------------------------------------------------------------

TEST(FailureMode, growing_motion_names_the_mode_once_and_keeps_it) {
  for (const Case& c : cases()) {
    bool was_named = false;
    for (const double share : {0.01, 0.03, 0.1, 0.3, 1.0, 2.0}) {
      const FailureMode mode = named(c.parts, share * kTurn);
      // at 80 mm a plumb cut has slid by more than half a face: the name stands in the sentence
      const bool is_doubted = text_of(mode.sentence).find("slid off") != std::string::npos &&
                              text_of(mode.sentence).find(c.name) != std::string::npos;
      const bool is_named = mode.name == c.name || (share > 1 && is_doubted);
      EXPECT_FALSE(was_named && !is_named) << c.name << " at " << share;
      EXPECT_FALSE(share <= 0.01 && is_named) << c.name;  // 0.4 mm: nothing the eye sees
      EXPECT_FALSE(share >= 0.3 && !is_named) << c.name;
      was_named = is_named;
    }
  }
}

TEST(FailureMode, measure_at_its_threshold_leaves_two_candidates) {
  // rocking, and one bed of the spandrel slides by just a crack's width: FM-4 or FM-5
  const ModeRules rules = rules_for(tuff_wall());
  const Mechanism rocking = mechanism(kFm5);
  const auto nearly = [=](double x, double y) {
    Motion m = rocking(x, y);
    if (x > 1.70 && x < 3.40 && y > 3.2) m.move_x += 1.01 * rules.crack;
    return m;
  };
  const FailureMode mode = name_from_state(tuff_wall(), moved(tuff_wall(), nearly));
  EXPECT_EQ(mode.name, "unclear");
  EXPECT_NE(text_of(mode.sentence).find("FM-4"), std::string::npos) << mode.sentence;
  EXPECT_NE(text_of(mode.sentence).find("FM-5"), std::string::npos) << mode.sentence;
}

TEST(FailureMode, clear_mechanism_outlives_a_quarter_of_each_threshold) {
  const ModeRules rules = rules_for(tuff_wall());
  constexpr double ModeRules::*kThresholds[] = {
      &ModeRules::crack,   &ModeRules::sliding,  &ModeRules::pier_crossed,
      &ModeRules::rocking, &ModeRules::crushing, &ModeRules::spandrel_crossed};
  for (const Case& c : cases()) {
    const State state = moved(tuff_wall(), mechanism(c.parts));
    for (const auto threshold : kThresholds) {
      for (const double factor : {0.75, 1.25}) {
        ModeRules changed = rules;
        changed.*threshold *= factor;
        EXPECT_EQ(name_from_state(tuff_wall(), state, changed).name, c.name);
      }
    }
  }
}

// --- sliding all along the wall --------------------------------------------------------------

TEST(FailureMode, of_one_pier_alone_is_no_mechanism_of_the_wall_but_is_said) {
  const auto one_rocks = [](double x, double y) {
    return x > 3.40 && y < 2.64 ? pier_motion(3.40, kLength, false, kTurn, x, y) : Motion{};
  };
  const FailureMode mode = name_from_state(tuff_wall(), moved(tuff_wall(), one_rocks));
  EXPECT_EQ(mode.name, "unclear");
  EXPECT_NE(text_of(mode.sentence).find("only pier rocking: right pier: rocking"),
            std::string::npos)
      << mode.sentence;
}

TEST(Sliding, along_one_joint_through_the_whole_wall_with_an_opening_is_named) {
  const auto name = [](double height) {
    return name_from_state(tuff_wall(), moved(tuff_wall(), cut(height, 36e-3))).name;
  };
  EXPECT_EQ(name(-1), "base sliding");
  EXPECT_EQ(name(1.0), "pier sliding");
  EXPECT_EQ(name(3.2), "bed sliding");
}

TEST(Sliding, beside_rocking_leaves_the_two_as_candidates) {
  // the wall slides on its foundation by about as much as it rocks
  const Mechanism rocking = mechanism(kFm5);
  const auto both = [=](double x, double y) {
    Motion m = rocking(x, y);
    m.move_x += 45e-3;
    return m;
  };
  const FailureMode mode = name_from_state(tuff_wall(), moved(tuff_wall(), both));
  EXPECT_EQ(mode.name, "unclear");
  EXPECT_NE(text_of(mode.sentence).find("FM-5"), std::string::npos) << mode.sentence;
  EXPECT_NE(text_of(mode.sentence).find("base sliding"), std::string::npos) << mode.sentence;
}

// --- a run -----------------------------------------------------------------------------------

// Readings and snapshots at the displacements.
Result run_of(const Parts& parts, const std::vector<double>& displacements) {
  Result result;
  result.states.snapshots.push_back({"start", 0, 0, initial_state(tuff_wall())});
  for (const double d : displacements) {
    const State state = moved(tuff_wall(), mechanism(parts, d / 3.12));
    result.states.snapshots.push_back({fmt::format("{:g} mm", 1e3 * d), d, 0, state});
    result.states.snapshots.back().state.step = static_cast<std::int64_t>(1e6 * d);
    CurveRow row;
    row.displacement = d;
    row.reaction = 100;
    result.curve.push_back(row);
  }
  result.states.readings.assign(result.states.snapshots.begin() + 1, result.states.snapshots.end());
  return result;
}

TEST(NameFailureMode, reads_the_first_state_that_has_gone_as_far_as_stated) {
  const Result result = run_of(kFm4, {1e-3, 10e-3, 20e-3, 40e-3, 50e-3});
  const FailureMode mode = name_failure_mode(tuff_wall(), result);
  EXPECT_DOUBLE_EQ(mode.read_at, 40e-3);
  EXPECT_EQ(text_of(mode.reading), "read at 40.0 mm");
  EXPECT_DOUBLE_EQ(name_failure_mode(tuff_wall(), result, 20e-3).read_at, 20e-3);
}

TEST(NameFailureMode, what_is_stored_for_the_user_changes_neither_name_nor_place) {
  const Result whole = run_of(kFm4, {0.1e-3, 10e-3, 40e-3, 40.3e-3, 50e-3});
  for (const std::size_t kept : {0U, 1U, 2U, 4U}) {
    Result result = whole;
    result.states.snapshots.erase(result.states.snapshots.begin(),
                                  result.states.snapshots.end() - static_cast<long>(kept));
    const FailureMode mode = name_failure_mode(tuff_wall(), result);
    EXPECT_EQ(mode.name, "FM-4") << kept;
    EXPECT_DOUBLE_EQ(mode.read_at, 40e-3) << kept;
  }
}

TEST(NameFailureMode, spandrel_that_shears_well_after_a_pier_does_not_take_the_name) {
  const auto named_when = [](double spandrel_at, double pier_at) {
    Result result;
    for (int mm = 1; mm <= 40; ++mm) {
      const double d = 1e-3 * mm;
      const Parts parts{.right_split = d >= pier_at,
                        .spandrel = d >= spandrel_at ? Parts::kLayers : Parts::kWhole};
      result.states.readings.push_back({"", d, 0, moved(tuff_wall(), mechanism(parts, d / 3.12))});
    }
    const FailureMode mode = name_failure_mode(tuff_wall(), result);
    const WallMechanism whole = read_mechanism(tuff_wall(), result);
    EXPECT_EQ(whole.name == "one pier in shear", mode.name == "FM-1") << whole.name;
    if (mode.name == "unclear") return text_of(mode.sentence);
    return mode.name + (text_of(mode.sentence).find("later") == std::string::npos ? "" : ", later");
  };
  EXPECT_EQ(named_when(30e-3, 18e-3), "FM-1, later");
  EXPECT_EQ(named_when(18e-3, 18e-3), "FM-3");
  EXPECT_EQ(named_when(18e-3, 30e-3), "FM-3");
  EXPECT_EQ(named_when(1, 18e-3), "FM-1");
}

// The left pier rocks, the right one slides on the bed at `bed`; the spandrel goes along.
Mechanism one_pier_slides(double bed) {
  return [=](double x, double y) {
    if (x < 1.70) return Motion{.pivot_x = 1.70, .pivot_y = 0, .turn = -kTurn};
    if (x > 3.40) return Motion{.move_x = y > bed ? 40e-3 : 0};
    return spandrel_motion(3.13, kTurn);
  };
}

TEST(NameFailureMode, pier_that_slides_on_a_bed_is_told_as_sliding) {
  const FailureMode mode = name_from_state(tuff_wall(), moved(tuff_wall(), one_pier_slides(1.32)));
  EXPECT_EQ(mode.name, "FM-1");
  EXPECT_EQ(mode.sentence.code, "mode.fm_1_slides");
}

TEST(NameFailureMode, pier_that_slides_at_its_base_beside_one_that_rocks_is_a_mechanism) {
  const State state = moved(tuff_wall(), one_pier_slides(0));
  const WallMechanism mechanism = mechanism_from_state(tuff_wall(), state);
  EXPECT_EQ(mechanism.name, "partial") << text_of(mechanism.sentence);
  for (const char* pier : {"left pier", "right pier"})
    EXPECT_NE(text_of(mechanism.sentence).find(pier), std::string::npos)
        << text_of(mechanism.sentence);
}

TEST(NameFailureMode, push_that_ended_before_is_read_at_its_end_and_says_so) {
  Result result = run_of(kFm4, {5e-3, 15e-3});
  FailureMode mode = name_failure_mode(tuff_wall(), result);
  EXPECT_DOUBLE_EQ(mode.read_at, 15e-3);
  EXPECT_EQ(text_of(mode.reading), "read at 15.0 mm, where the loading ended short of 40.0 mm");
  result.status = SolveStatus::kCollapsed;
  mode = name_failure_mode(tuff_wall(), result);
  EXPECT_EQ(text_of(mode.reading), "read at 15.0 mm, where the wall collapsed short of 40.0 mm");
}

TEST(NameFailureMode, cyclic_push_is_read_where_it_last_turned_before_going_farther) {
  Model cyclic = tuff_wall();
  cyclic.stages.back().spec.get<PushStage>().targets = {40e-3, -40e-3, 60e-3};
  Result result = run_of(kFm4, {10e-3, 40e-3, 40e-3, 40e-3, 41e-3, 60e-3, 10e-3});
  for (std::size_t i : {2U, 3U}) result.states.readings[i].label = "turn";
  result.states.readings[3].displacement = -40e-3;
  for (Snapshot& s : result.states.readings)
    s.state.stage = static_cast<int>(cyclic.stages.size()) - 1;
  FailureMode mode = name_failure_mode(cyclic, result);
  EXPECT_DOUBLE_EQ(mode.read_at, -40e-3);
  EXPECT_EQ(text_of(mode.reading), "read at -40.0 mm, where the push last turned");
  EXPECT_FALSE(is_read_early(mode.read_at, 40e-3));
  // never so far: the last of the farthest, not the end at rest
  EXPECT_DOUBLE_EQ(name_failure_mode(cyclic, result, 80e-3).read_at, 60e-3);
}

TEST(NameFailureMode, falling_wall_under_a_load_factor_is_read_out_of_balance) {
  Model tilted = tuff_wall();
  tilted.stages.back().spec.action = TiltStage{};
  Result result = run_of(kFm4, {0.1e-3, 40e-3});
  for (Snapshot& s : result.states.readings)
    s.state.stage = static_cast<int>(tilted.stages.size()) - 1;
  result.states.readings.back().state.progress.balance = 1;
  EXPECT_EQ(text_of(name_failure_mode(tilted, result).reading), "read at 40.0 mm, out of balance");
  result.states.readings.back().state.progress.balance = 0;
  EXPECT_EQ(text_of(name_failure_mode(tilted, result).reading), "read at 40.0 mm");
}

TEST(NameFailureMode, without_a_state_there_is_no_name) {
  EXPECT_EQ(name_failure_mode(tuff_wall(), run_of(kFm4, {})).name, "unclear");
  EXPECT_EQ(name_failure_mode(tuff_wall(), {}).name, "unclear");
}

TEST(NameFailureMode, signs_know_when_they_first_showed) {
  // the heel opens by 1.70 / 3.12 of the displacement: a crack from 2.0 mm on
  const FailureMode mode =
      name_failure_mode(tuff_wall(), run_of(kFm4, {1e-3, 1.9e-3, 2.1e-3, 20e-3, 40e-3}));
  const ElementSign& crack = sign_of(mode.elements, "left pier", study::kFlexural);
  EXPECT_DOUBLE_EQ(crack.displacement_first, 2.1e-3);
  EXPECT_TRUE(std::isnan(sign_of(mode.elements, "left pier", study::kDiagonal).displacement_first));
}

TEST(NameFailureMode, readings_between_the_states_tell_when_and_later_ones_nothing) {
  // states at 10 mm steps, readings closer; the crack of the heel is one from 2.0 mm on
  Result result = run_of(kFm4, {10e-3, 20e-3, 40e-3});
  result.states.readings = run_of(kFm4, {1e-3, 2e-3, 3e-3, 40e-3}).states.readings;
  const FailureMode mode = name_failure_mode(tuff_wall(), result);
  EXPECT_DOUBLE_EQ(sign_of(mode.elements, "left pier", study::kFlexural).displacement_first, 3e-3);
  // read at 1 mm nothing has happened yet: what comes after is not its past
  for (const ElementState& e : name_failure_mode(tuff_wall(), result, 1e-3).elements) {
    EXPECT_EQ(e.state, "intact") << e.element;
    EXPECT_TRUE(std::isnan(e.displacement_first)) << e.element;
  }
}

TEST(NameFailureMode, says_what_other_readings_would_name) {
  const FailureMode mode = name_failure_mode(tuff_wall(), run_of(kFm4, {0.1e-3, 20e-3, 40e-3}));
  const auto name_of = [&](const std::string& what) {
    for (const NameReading& r : mode.sensitivity)
      if (text_of(r.what()) == what) return r.name;
    return std::string("absent");
  };
  EXPECT_EQ(name_of("at 0.1 mm"), "unclear");
  EXPECT_EQ(name_of("at 20 mm"), "FM-4");
  EXPECT_EQ(name_of("crack width x 0.75"), "FM-4");
  EXPECT_EQ(name_of("crossing of a spandrel x 1.25"), "FM-4");
  EXPECT_EQ(mode.sensitivity.size(), 2U + 6U * 2U);
}

TEST(NameFailureMode, sudden_fall_raises_a_flag_and_a_slow_one_does_not) {
  Result result = run_of(kFm4, {10e-3, 40e-3});
  const auto falling_over = [&](double path) {
    result.curve.clear();
    for (int i = 0; i <= 1000; ++i) {
      CurveRow row;
      row.displacement = 0.05e-3 * i;
      row.reaction = 100 - 30 * std::clamp((row.displacement - 10e-3) / path, 0.0, 1.0);
      result.curve.push_back(row);
    }
    return flag_of(name_failure_mode(tuff_wall(), result), "reaction");
  };
  EXPECT_TRUE(falling_over(0.5e-3).holds());
  EXPECT_NEAR(falling_over(0.5e-3).value, 0.3, 1e-9);
  EXPECT_FALSE(falling_over(10e-3).holds());
  // 30 over 10 mm: rows within 1.097 mm are at most 21 steps of 0.05 mm apart
  EXPECT_NEAR(falling_over(10e-3).value, 0.3 * 21 * 0.05 / 10, 1e-9);
}

TEST(Features, sum_the_joints_of_each_region) {
  // one bed between 3.2 m and the next course slides by 2 mm: the spandrel's 11 half units
  Result result;
  result.states.snapshots.push_back({"20 mm", 20e-3, 0, moved(tuff_wall(), cut(3.2, 2e-3))});
  const std::vector<Feature> features = read_features(tuff_wall(), result);
  const auto value = [&](const std::string& name) {
    for (const Feature& f : features)
      if (f.name == name) return f.value;
    return kUnset;
  };
  EXPECT_NEAR(value("spandrel_slip"), 11 * 2e-3, kRoundOff);
  EXPECT_NEAR(value("left_pier_slip"), 0, kRoundOff);
  EXPECT_NEAR(value("base_opening"), 0, kRoundOff);
  EXPECT_NEAR(value("spandrel_opening"), 0, kRoundOff);
  for (const Feature& f : features) EXPECT_DOUBLE_EQ(f.displacement, 20e-3);
}

// --- a name that a slow push may lose -----------------------------------------------------------

FailureMode of_scores(const std::string& name, std::map<std::string, double> scores) {
  FailureMode mode;
  mode.name = name;
  mode.scores = std::move(scores);
  return mode;
}

TEST(FirmName, leads_by_far_and_no_kind_beside_it_is_in_doubt) {
  EXPECT_TRUE(is_firm(of_scores("shear", {{"shear", 1}, {"rocking", 0.19}})));
  EXPECT_FALSE(is_firm(of_scores("shear", {{"shear", 1}, {"rocking", 0.21}})));
  EXPECT_FALSE(is_firm(of_scores("shear", {{"shear", 0.79}, {"rocking", 0}})));
  EXPECT_TRUE(is_firm(of_scores("FM-4", {{"FM-1", 0.1}, {"FM-4", 0.75}})));
  EXPECT_FALSE(is_firm(of_scores("FM-4", {{"FM-1", 0.3}, {"FM-4", 0.75}})));
  // nothing to promise between two names; something where no sign shows
  EXPECT_FALSE(is_firm(of_scores("unclear", {{"shear", 1}, {"rocking", 0.4}})));
  EXPECT_FALSE(is_firm(of_scores("unclear", {{"FM-1", 0.5}, {"FM-4", 0.5}})));
  EXPECT_TRUE(is_firm(of_scores("unclear", {{"shear", 0.1}, {"rocking", 0}})));
  EXPECT_TRUE(is_firm(of_scores("unclear", {{"FM-1", 0}, {"FM-4", 0}})));
  EXPECT_TRUE(is_firm(of_scores("part breaking away", {{"FM-1", 0.1}, {"FM-4", 0.4}})));
}

TEST(FirmName, hangs_on_no_kind_that_it_would_not_name) {
  // lesser damage beside graver, and a third kind
  EXPECT_TRUE(is_firm(of_scores("shear", {{"shear", 1}, {"toe crushing", 0.5}})));
  EXPECT_TRUE(is_firm(of_scores("pier shear + pier sliding",
                                {{"pier shear", 1}, {"pier sliding", 1}, {"pier rocking", 0.5}})));
  EXPECT_FALSE(is_firm(of_scores("pier shear + pier rocking",
                                 {{"pier shear", 1}, {"pier sliding", 0.4}, {"pier rocking", 1}})));
}

}  // namespace
}  // namespace wythe::failure_mode_test
