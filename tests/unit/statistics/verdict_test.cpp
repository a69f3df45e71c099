// The verdict from many walls: the deciding direction and pattern, the effect of lost walls and bounds
// on the share, and cases that must not be signed. Walls are artificial; only their capacities count.
#include "wythe/parts/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <utility>

#include "statistics/intervals.h"

namespace wythe::verdict_test {
namespace {

constexpr double kDemand = 0.2 * kStandardGravity;

AssessmentSpec asked() {
  AssessmentSpec spec;
  spec.code = "circolare_2019";
  spec.spectrum.kind = SpectrumKind::kNtc2018;
  spec.spectrum.ground_acceleration = kDemand;
  spec.spectrum.amplification = 2.5;
  spec.spectrum.corner_period = 0.3;
  return spec;
}

JudgedWall wall_of(double g, bool at_least = false, const char* mode = "rocking") {
  JudgedWall wall;
  wall.mode = mode;
  LimitStateCheck check{.state = LimitState::kLifeSafety, .is_asked = true, .is_checked = true};
  check.acceleration = g * kStandardGravity;
  check.at_least = at_least;
  if (check.acceleration >= kDemand)
    check.verdict = AssessmentVerdict::kHolds;
  else
    check.verdict = at_least ? AssessmentVerdict::kNotShown : AssessmentVerdict::kFails;
  wall.assessment.limit_states.push_back(check);
  wall.assessment.verdict = check.verdict;
  wall.assessment.may_be_signed = true;
  return wall;
}
JudgedWall lost_wall() {
  JudgedWall wall;
  wall.lost = as_text("collapsed under its weight");
  return wall;
}

WayOfPushing way(const char* direction, const char* pattern, std::vector<JudgedWall> walls) {
  int number = 0;
  for (JudgedWall& wall : walls) {
    wall.wall = ++number;
    if (std::isnan(wall.peak))
      wall.peak = 1e5 * (1 + 0.1 * (number % 5));  // as walls of tests differ
  }
  return {.direction = direction, .pattern = pattern, .folder = "x", .walls = std::move(walls)};
}
std::vector<JudgedWall> walls_of(const std::vector<double>& capacities) {
  std::vector<JudgedWall> walls;
  for (const double g : capacities) walls.push_back(wall_of(g));
  return walls;
}
std::vector<JudgedWall> same(int n, double g) {
  return walls_of(std::vector<double>(static_cast<std::size_t>(n), g));
}

bool has(const std::vector<Message>& messages, const char* code) {
  return std::any_of(messages.begin(), messages.end(),
                     [&](const Message& m) { return m.code == code; });
}

TEST(Verdict, of_strong_walls_in_both_directions_may_be_signed) {
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", same(8, 0.30)), way("-x", "at", same(8, 0.28))}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_TRUE(v.may_be_signed) << text_of(v.sentence);
  EXPECT_EQ(v.decides().text(), "-x");
  EXPECT_EQ(v.worst.counts.met, 8);
  EXPECT_EQ(v.worst.counts.probability().value, 0);
  EXPECT_NEAR(v.worst.capacity.median.value / kStandardGravity, 0.28, 1e-12);
}

// Each direction fails other walls: half of them in each, none of them stands in both.
TEST(Verdict, takes_each_wall_by_its_worse_direction) {
  const WallsVerdict v =
      verdict_of(asked(),
                 {way("+x", "at", walls_of({0.1, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1, 0.3})),
                  way("-x", "at", walls_of({0.3, 0.1, 0.3, 0.1, 0.3, 0.1, 0.3, 0.1, 0.3, 0.05}))},
                 10);
  EXPECT_EQ(v.ways[0].counts.not_met, 5);
  EXPECT_EQ(v.worst.counts.not_met, 10);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_EQ(v.worst.direction, "+x");  // five walls each: the model's own
}

TEST(Verdict, is_that_of_the_worse_pattern) {
  const std::vector<WayOfPushing> ways = {
      way("+x", "mass_height", same(8, 0.25)), way("-x", "mass_height", same(8, 0.24)),
      way("+x", "uniform", same(8, 0.15)), way("-x", "uniform", same(8, 0.16))};
  const WallsVerdict v = verdict_of(asked(), ways, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_EQ(v.decides().text(), "+x, uniform");
  EXPECT_NEAR(v.worst.capacity.median.value / kStandardGravity, 0.15, 1e-12);
  // whatever the order in which they ran
  std::vector<WayOfPushing> turned(ways.rbegin(), ways.rend());
  const WallsVerdict w = verdict_of(asked(), turned, 8);
  EXPECT_EQ(w.decides().text(), v.decides().text());
  EXPECT_EQ(w.worst.capacity.median.value, v.worst.capacity.median.value);
}

// A pattern that shows nothing must not lose to one that is met.
TEST(Verdict, of_a_pattern_not_known_is_not_met_by_another) {
  const std::vector<JudgedWall> bounds(8, wall_of(0.1, true));
  const WallsVerdict v =
      verdict_of(asked(),
                 {way("+x", "mass_height", same(8, 0.3)), way("-x", "mass_height", same(8, 0.3)),
                  way("+x", "uniform", bounds), way("-x", "uniform", bounds)},
                 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.not_shown"));
}

TEST(Verdict, is_undecided_where_half_of_all_walls_may_lie_on_either_side) {
  std::vector<double> mixed = {0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.1, 0.1};
  WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", walls_of(mixed)), way("-x", "at", walls_of(mixed))}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.undecided"));
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_NE(text_of(v.sentence).find("--resume --walls 20"), std::string::npos);
  EXPECT_NE(text_of(v.sentence, "it").find("--resume --walls 20"), std::string::npos);
  // five walls, all met, are too few: 1 in 32 that all lie on one side of a median
  v = verdict_of(asked(), {way("+x", "at", same(5, 0.3)), way("-x", "at", same(5, 0.3))}, 5);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
}

TEST(Verdict, counts_a_lost_wall_on_both_sides) {
  std::vector<JudgedWall> with_lost = same(8, 0.3);
  with_lost[3] = lost_wall();
  WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", with_lost), way("-x", "at", same(8, 0.3))}, 8);
  EXPECT_EQ(v.worst.counts.lost, 1);
  EXPECT_EQ(v.worst.counts.met, 7);
  EXPECT_EQ(v.worst.counts.probability().value, 0);
  EXPECT_NEAR(v.worst.counts.probability().interval.high, study::exact_share(1, 8).interval.high,
              1e-12);
  EXPECT_EQ(v.worst.capacity.median.interval.low, 0);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.lost"));
  EXPECT_FALSE(v.may_be_signed);
  // a wall that does not meet it in one direction does not, whatever the other would say
  std::vector<JudgedWall> weak = same(8, 0.3);
  weak[3] = wall_of(0.1);
  v = verdict_of(asked(), {way("+x", "at", with_lost), way("-x", "at", weak)}, 8);
  EXPECT_EQ(v.worst.counts.lost, 0);
  EXPECT_EQ(v.worst.counts.not_met, 1);
}

TEST(Verdict, signs_nothing_where_all_walls_are_lost_in_a_direction) {
  const std::vector<JudgedWall> lost(8, lost_wall());
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", same(8, 0.5)), way("-x", "at", lost)}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotKnown);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_EQ(v.reason.code, "verdict.all_lost");
  EXPECT_NE(text_of(v.sentence).find("-x"), std::string::npos);
}

TEST(Verdict, waits_for_walls_that_have_not_run) {
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", same(8, 0.5)), way("-x", "at", same(3, 0.5))}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotKnown);
  EXPECT_EQ(v.reason.code, "verdict.walls_missing");
}

TEST(Verdict, says_what_stands_against_single_pushes) {
  std::vector<JudgedWall> fast = same(8, 0.3);
  fast[1].assessment.cautions = {{"assessment.too_fast"}};
  fast[2].assessment.cautions = {{"assessment.too_fast"},
                                 {"assessment.caution.bound", {{"displacement_mm", 6.0}}}};
  fast[5].is_in_plane = false;
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", same(8, 0.3)), way("-x", "at", fast)}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_FALSE(v.may_be_signed);
  ASSERT_EQ(v.cautions.size(), 2U);  // the bound lies beyond the demand
  EXPECT_EQ(v.cautions[0].number("pushes"), 2);
  EXPECT_EQ(v.cautions[0].number("all"), 16);
  EXPECT_EQ(v.cautions[1].number("pushes"), 1);
  // what the model does not allow bars it too
  EXPECT_FALSE(verdict_of(asked(), {way("+x", "at", same(8, 0.3)), way("-x", "at", same(8, 0.3))},
                          8, {{"verdict.caution.one_pattern"}})
                   .may_be_signed);
}

// Ends of pushes: a lower bound below another wall's value leaves the lesser of both a bound.
TEST(Verdict, keeps_bounds_as_bounds) {
  std::vector<JudgedWall> forth(8, wall_of(0.25, true));
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", forth), way("-x", "at", same(8, 0.30))}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_TRUE(v.worst.capacity.at_least);
  EXPECT_NEAR(v.worst.capacity.median.value / kStandardGravity, 0.25, 1e-12);
  EXPECT_NEAR(v.worst.capacity.median.interval.high / kStandardGravity, 0.30, 1e-12);
}

// The knife: one run turns from met to not met where the strength changes by 0.6 %. Many walls that scatter
// let the share of those not met rise slowly, and never fall, as all of them get weaker.
TEST(Verdict, moves_smoothly_with_strength) {
  std::mt19937 random(1);
  std::normal_distribution<double> scatter(0, 0.2);
  std::vector<double> logs;
  for (int i = 0; i < 400; ++i) logs.push_back(scatter(random));
  double before = 0;
  for (double strength = 0.35; strength > 0.15; strength *= 0.994) {
    std::vector<JudgedWall> walls;
    walls.reserve(logs.size());
    for (const double log : logs) walls.push_back(wall_of(strength * std::exp(log)));
    const double p = verdict_of(asked(), {way("+x", "at", walls), way("-x", "at", walls)}, 400)
                         .worst.counts.probability()
                         .value;
    EXPECT_GE(p, before);
    EXPECT_LT(p - before, 0.05);  // density of the normal 0.4 over 0.2, times 0.006, is 0.012
    before = p;
  }
  EXPECT_GT(before, 0.85);
}

// --- what tested walls say of drift

// Walls that carry 0.3 g by their own drift, and `low` to `high` by those of tests.
std::vector<JudgedWall> with_tests(double g, double low, double high) {
  std::vector<JudgedWall> walls = same(8, g);
  for (JudgedWall& wall : walls) {
    LimitStateCheck& check = wall.assessment.limit_states.front();
    check.tested_low = low * kStandardGravity, check.tested_high = high * kStandardGravity;
    wall.assessment.tests = {{"shear", false, 79, 0.0018, 0.0061}};
  }
  return walls;
}
WallsVerdict both_ways(const std::vector<JudgedWall>& walls) {
  return verdict_of(asked(), {way("+x", "at", walls), way("-x", "at", walls)},
                    static_cast<int>(walls.size()));
}

TEST(Verdict, holds_the_drifts_of_tested_walls_in_its_interval) {
  const WallsVerdict v = both_ways(with_tests(0.30, 0.25, 0.40));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_TRUE(v.may_be_signed) << text_of(v.sentence);
  EXPECT_NEAR(v.worst.capacity.with_tests.low / kStandardGravity, 0.25, 1e-12);
  EXPECT_NEAR(v.worst.capacity.with_tests.high / kStandardGravity, 0.40, 1e-12);
  EXPECT_TRUE(has(v.notes, "verdict.note.tests"));
  EXPECT_NE(text_of(v.sentence).find("0.250 to 0.400 with the drifts of tested walls"),
            std::string::npos);
}

TEST(Verdict, is_undecided_where_the_drift_of_tests_turns_it) {
  WallsVerdict v = both_ways(with_tests(0.30, 0.15, 0.40));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.drift"));
  EXPECT_FALSE(has(v.cautions, "verdict.caution.undecided"));  // more walls do not help
  EXPECT_EQ(v.worst.counts.with_tests().high, 1);
  // a computed drift far below those of tests does not condemn a wall
  v = both_ways(with_tests(0.10, 0.15, 0.25));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  v = both_ways(with_tests(0.10, 0.05, 0.15));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_TRUE(v.may_be_signed) << text_of(v.sentence);
  v = both_ways(with_tests(0.10, 0.05, std::numeric_limits<double>::infinity()));
  EXPECT_TRUE(has(v.cautions, "verdict.caution.drift_open"));
}

TEST(Verdict, says_where_no_test_speaks_of_drift) {
  EXPECT_TRUE(has(both_ways(same(8, 0.3)).notes, "verdict.note.no_tests"));
}

// --- walls that do not differ

TEST(Verdict, of_walls_that_are_all_but_equal_is_not_signed) {
  std::vector<JudgedWall> equal = same(8, 0.30);
  for (JudgedWall& wall : equal) wall.peak = 1e5;
  WallsVerdict v = both_ways(equal);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.alike"));
  equal[0].peak *= 1 + 1e-4;
  EXPECT_TRUE(has(both_ways(equal).cautions, "verdict.caution.alike"));
  equal[0].peak *= 1.05;
  EXPECT_FALSE(has(both_ways(equal).cautions, "verdict.caution.alike"));
}

// --- limit states

// --- parts out of plane

LocalCheck part_of(const char* name, double reserve, bool may_be_signed = true) {
  LocalCheck part;
  part.name = name;
  part.capacity.alpha0 = 0.1;
  part.verdict = reserve >= 1 ? AssessmentVerdict::kHolds : AssessmentVerdict::kFails;
  part.states = {{.state = LimitState::kLifeSafety,
                  .verdict = part.verdict,
                  .ground_demand = kDemand,
                  .q_ratio = reserve,
                  .acceleration = reserve * kDemand}};
  part.may_be_signed = may_be_signed;
  if (!may_be_signed) part.cautions = {{"local.caution.factor"}};
  return part;
}
WallsVerdict with_parts(double g, PartsOutOfPlane parts) {
  std::vector<JudgedWall> walls = same(8, g);
  for (JudgedWall& wall : walls) wall.assessment.notes.push_back({"assessment.note.out_of_plane"});
  return verdict_of(asked(), {way("+x", "at", walls), way("-x", "at", walls)}, 8, {}, {},
                    std::move(parts));
}
PartsOutOfPlane named(std::vector<LocalCheck> checked, std::vector<Refusal> refused = {}) {
  return {.checked = std::move(checked), .refused = std::move(refused)};
}
PartsOutOfPlane found(std::vector<LocalCheck> checked, std::vector<Refusal> refused = {}) {
  for (LocalCheck& part : checked) part.by = "found";
  for (Refusal& part : refused) part.what.code = "local.part_found";
  return {.checked = std::move(checked), .refused = std::move(refused)};
}
PartsOutOfPlane both(PartsOutOfPlane parts, const PartsOutOfPlane& others) {
  parts.checked.insert(parts.checked.end(), others.checked.begin(), others.checked.end());
  parts.refused.insert(parts.refused.end(), others.refused.begin(), others.refused.end());
  return parts;
}
const Refusal kRefused{{"local.part", {{"name", "attic"}}}, "its floor has no bearing"};

TEST(Parts, that_stand_leave_the_verdict_as_it_is_and_are_in_the_sentence) {
  for (const bool are_named : {true, false}) {
    const std::vector<LocalCheck> parts = {part_of("storey", 1.8), part_of("gable", 1.4)};
    const WallsVerdict v = with_parts(0.3, are_named ? named(parts) : found(parts));
    EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
    EXPECT_TRUE(v.may_be_signed) << text_of(v.sentence);
    EXPECT_FALSE(v.part_decides());
    EXPECT_NE(text_of(v.sentence).find("out of plane gable has the least reserve, 1.40 times"),
              std::string::npos)
        << text_of(v.sentence);
    EXPECT_FALSE(has(v.notes, "assessment.note.out_of_plane"));
    EXPECT_TRUE(has(v.notes, are_named ? "verdict.note.parts_named" : "verdict.note.parts_found"));
  }
}

TEST(Parts, that_are_named_and_fall_are_not_met_whatever_the_pushes_carry) {
  const WallsVerdict v = with_parts(0.3, named({part_of("storey", 2), part_of("gable", 0.62)}));
  EXPECT_EQ(v.of_pushes, AssessmentVerdict::kHolds);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_TRUE(v.part_decides());
  EXPECT_EQ(text_of(v.sentence).find("life safety not met: gable overturns out of plane at 0.62"),
            0U)
      << text_of(v.sentence);
  // and with walls that are not met either, both are said
  const WallsVerdict both = with_parts(0.1, named({part_of("gable", 0.62)}));
  EXPECT_EQ(both.verdict, AssessmentVerdict::kFails);
  EXPECT_NE(text_of(both.sentence).find("gable overturns"), std::string::npos);
  EXPECT_NE(text_of(both.sentence).find("not met in 8 of 8 walls"), std::string::npos);
  // one that falls by itself has no limit state
  LocalCheck fallen = part_of("parapet", 0);
  fallen.states.clear(), fallen.capacity.alpha0 = -0.1;
  EXPECT_EQ(with_parts(0.3, named({part_of("gable", 2), fallen})).verdict,
            AssessmentVerdict::kFails);
}

TEST(Parts, that_are_named_and_have_no_answer_are_not_met) {
  std::vector<PartsOutOfPlane> without;
  without.push_back(named({part_of("gable", 2)}, {kRefused}));
  without.push_back(named({}, {kRefused}));
  for (const AssessmentVerdict none :
       {AssessmentVerdict::kNotKnown, AssessmentVerdict::kNoDemand}) {
    LocalCheck part = part_of("attic", kUnset);
    part.verdict = none, part.states.clear();
    without.push_back(named({part_of("gable", 2), part}));
  }
  for (const PartsOutOfPlane& parts : without) {
    const WallsVerdict v = with_parts(0.3, parts);
    EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
    EXPECT_FALSE(v.may_be_signed);
    EXPECT_TRUE(has(v.cautions, "verdict.caution.part_unchecked"));
    EXPECT_NE(text_of(v.sentence).find("attic could not be checked out of plane"),
              std::string::npos)
        << text_of(v.sentence);
    // pushes that are not met stay so
    EXPECT_EQ(with_parts(0.1, parts).verdict, AssessmentVerdict::kFails);
  }
}

TEST(Parts, that_are_named_and_not_to_be_signed_bar_the_signature) {
  const WallsVerdict v = with_parts(0.3, named({part_of("gable", 2, false)}));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.parts"));
}

TEST(Parts, that_rules_found_take_away_what_the_pushes_show_and_show_nothing_else) {
  const WallsVerdict v = with_parts(0.3, found({part_of("storey", 0.7), part_of("parapet", 3)}));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.part_found"));
  EXPECT_EQ(text_of(v.sentence).find("not to be signed"), 0U);
  EXPECT_NE(text_of(v.sentence).find("storey overturns out of plane if nothing holds it, at 0.70"),
            std::string::npos);
  EXPECT_EQ(with_parts(0.1, found({part_of("storey", 0.7)})).verdict, AssessmentVerdict::kFails);
}

// One part that is named must not hide the others.
TEST(Parts, that_rules_found_count_beside_named_ones) {
  const PartsOutOfPlane harmless = named({part_of("plinth", 9)});
  WallsVerdict v = with_parts(0.3, both(harmless, found({part_of("wall", 0.7)})));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotShown);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.part_found"));
  EXPECT_NE(text_of(v.sentence).find("the wall overturns out of plane if nothing holds it"),
            std::string::npos)
      << text_of(v.sentence);
  EXPECT_TRUE(has(v.notes, "verdict.note.parts_named_and_found"));
  v = with_parts(0.3, both(harmless, found({part_of("wall", 1.2)})));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_TRUE(v.may_be_signed) << text_of(v.sentence);
  // a named part that falls decides, however little another holds
  v = with_parts(0.3, both(named({part_of("gable", 0.9)}), found({part_of("wall", 0.2)})));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_NE(text_of(v.sentence).find("gable overturns out of plane at 0.90"), std::string::npos)
      << text_of(v.sentence);
  // and one that rules found and could not check leaves the named ones as they are
  v = with_parts(0.3, both(harmless, found({}, {kRefused})));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
  EXPECT_FALSE(v.may_be_signed);
  EXPECT_TRUE(has(v.cautions, "verdict.caution.part_unchecked"));
}

TEST(Parts, that_rules_found_and_cannot_check_are_said_to_be_unchecked_and_not_counted) {
  for (const PartsOutOfPlane& parts :
       {found({}, {kRefused}), found({part_of("attic", 0.5 + 1, false)})}) {
    const WallsVerdict v = with_parts(0.3, parts);
    EXPECT_EQ(v.verdict, AssessmentVerdict::kHolds);
    EXPECT_EQ(v.least_part(), nullptr);
    EXPECT_TRUE(has(v.notes, "verdict.note.parts_unchecked"));
    EXPECT_FALSE(has(v.notes, "verdict.note.parts_found"));
    // who states less does not get the better verdict: without the data of a part nothing is signed
    EXPECT_FALSE(v.may_be_signed);
    EXPECT_TRUE(has(v.cautions, "verdict.caution.part_unchecked"));
    EXPECT_NE(text_of(v.sentence).find("attic"), std::string::npos);
  }
  LocalCheck uncertain = part_of("attic", 1.5, false);
  uncertain.cautions = {{"local.caution.free"}};  // of another kind: said, and no data are missing
  EXPECT_TRUE(with_parts(0.3, found({uncertain})).may_be_signed);
}

TEST(Parts, whose_heads_are_taken_as_held_are_said_so) {
  LocalCheck part = part_of("upper storey", 2);
  part.notes = {{"local.note.head_held"}};
  EXPECT_TRUE(has(with_parts(0.3, named({part})).notes, "verdict.note.parts_held"));
  EXPECT_FALSE(has(with_parts(0.3, named({part_of("gable", 2)})).notes, "verdict.note.parts_held"));
}

TEST(Parts, that_nobody_looked_at_are_not_modelled) {
  EXPECT_TRUE(has(with_parts(0.3, {}).notes, "assessment.note.out_of_plane"));
  PartsOutOfPlane none;
  none.not_looked_at = {"verdict.note.no_parts"};
  const WallsVerdict v = with_parts(0.3, none);
  EXPECT_TRUE(has(v.notes, "verdict.note.no_parts"));
  EXPECT_FALSE(has(v.notes, "assessment.note.out_of_plane"));
}

TEST(Parts, do_not_make_a_verdict_of_walls_without_an_answer) {
  const std::vector<JudgedWall> lost(8, lost_wall());
  const WallsVerdict v = verdict_of(asked(), {way("+x", "at", lost), way("-x", "at", lost)}, 8, {},
                                    {}, named({part_of("gable", 2)}));
  EXPECT_EQ(v.verdict, AssessmentVerdict::kNotKnown);
  EXPECT_FALSE(v.may_be_signed);
}

TEST(Parts, are_spoken_of_in_every_language) {
  for (const PartsOutOfPlane& parts :
       {named({part_of("timpano", 0.5)}), named({}, {kRefused}), found({part_of("timpano", 0.5)}),
        named({part_of("timpano", 2, false)})}) {
    const WallsVerdict v = with_parts(0.3, parts);
    const std::string said = text_of(v.sentence, "it");
    EXPECT_EQ(said.find('{'), std::string::npos) << said;
    for (const char* english : {"plane", "wall", "falls", "bearing"})
      EXPECT_EQ(said.find(english), std::string::npos) << said;
  }
}

TEST(Verdict, is_that_of_the_limit_state_with_the_least_reserve) {
  AssessmentSpec spec = asked();
  spec.spectra.damage_limitation = spec.spectrum;
  std::vector<JudgedWall> walls = same(8, 0.30);
  for (JudgedWall& wall : walls) {
    LimitStateCheck damage{.state = LimitState::kDamageLimitation, .is_checked = true};
    damage.acceleration = 0.1 * kStandardGravity;
    damage.verdict = AssessmentVerdict::kFails;
    damage.governing = "yield";
    for (const auto& [name, code, at] :
         {std::tuple("yield", "assessment.yield", 0.002),
          {"shear strength", "assessment.strength_of_piers", 0.003}}) {
      Criterion criterion;
      criterion.name = name, criterion.words.code = code, criterion.displacement = at;
      damage.criteria.push_back(criterion);
    }
    wall.assessment.limit_states.push_back(damage);
  }
  const WallsVerdict v = verdict_of(spec, {way("+x", "at", walls), way("-x", "at", walls)}, 8);
  EXPECT_EQ(v.verdict, AssessmentVerdict::kFails);
  EXPECT_EQ(v.worst.state, LimitState::kDamageLimitation);
  EXPECT_NE(text_of(v.sentence).find("damage limitation not met in 8 of 8"), std::string::npos);
  ASSERT_EQ(v.limit_states.size(), 2U);
  EXPECT_EQ(v.limit_states[1].state, LimitState::kLifeSafety);
  EXPECT_EQ(v.limit_states[1].verdict, AssessmentVerdict::kHolds);
  ASSERT_EQ(v.worst.rules.size(), 2U);
  EXPECT_EQ(v.worst.rules[0].words.code, "assessment.yield");
  EXPECT_EQ(v.worst.rules[0].decides, 8);
  EXPECT_EQ(v.worst.rules[1].decides, 0);
  EXPECT_EQ(v.worst.rules[1].displacement, 0.003);
}

TEST(Verdict, has_a_sentence_in_every_language) {
  const WallsVerdict v =
      verdict_of(asked(), {way("+x", "at", same(8, 0.19)), way("-x", "at", same(8, 0.15))}, 8);
  EXPECT_EQ(text_of(v.sentence),
            "carries 0.150 g (0.150 to 0.150); asked 0.200 g: life safety not met in 8 of 8 walls; "
            "-x decides; most often rocking (8 walls)");
  EXPECT_EQ(text_of(v.sentence, "it"),
            "sostiene 0,150 g (da 0,150 a 0,150); richiesti 0,200 g: salvaguardia della vita non "
            "soddisfatta in 8 di 8 pareti; decide -x; più spesso oscillazione (8 pareti)");
}

// --- the interval of a share

TEST(ClopperPearson, is_that_of_tables) {
  // Clopper and Pearson 1934 by the quantiles of beta: 0 of 10 and 3 of 10
  const Estimate none = study::exact_share(0, 10), three = study::exact_share(3, 10);
  EXPECT_EQ(none.interval.low, 0);
  EXPECT_NEAR(none.interval.high, 1 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_NEAR(three.interval.low, 0.06673951, 1e-7);
  EXPECT_NEAR(three.interval.high, 0.65245285, 1e-7);
  EXPECT_EQ(study::exact_share(10, 10).interval.high, 1);
  EXPECT_TRUE(std::isnan(study::exact_share(0, 0).value));
}

// At every n from 5 to 30, and any share, it holds the share at least as often as it says.
TEST(ClopperPearson, covers_what_it_says_at_small_n) {
  for (int n = 5; n <= 30; ++n)
    for (double p = 0.01; p < 1; p += 0.01) {
      double held = 0, chance = std::pow(1 - p, n);  // of k = 0
      for (int k = 0; k <= n; ++k) {
        const Interval interval = study::exact_share(k, n).interval;
        if (interval.low <= p && p <= interval.high) held += chance;
        chance *= p / (1 - p) * (n - k) / (k + 1);
      }
      EXPECT_GE(held, 0.95 - 1e-9) << n << " " << p;
    }
}

// --- how many walls

WallCounts counts_of(int not_met, int walls) {
  return {.walls = walls, .met = walls - not_met, .not_met = not_met};
}

TEST(Walls, grow_until_the_share_is_known_well_enough) {
  EXPECT_EQ(most_walls(0.5), 17);
  EXPECT_EQ(most_walls(0.3), 47);
  EXPECT_EQ(next_walls(counts_of(0, 8), 0.3), 11);  // all alike: 1 - 0.025^(1/11) = 0.285
  EXPECT_EQ(next_walls(counts_of(0, 11), 0.3), 0);
  EXPECT_EQ(next_walls(counts_of(4, 8), 0.3), 47);
  EXPECT_EQ(next_walls(counts_of(24, 47), 0.3), 0);
  // lost walls say nothing, however many: it ends all the same
  const WallCounts lost{.walls = 47, .met = 1, .not_met = 1, .lost = 45};
  EXPECT_EQ(next_walls(lost, 0.3), 0);
  EXPECT_EQ(next_walls({.walls = 8, .lost = 8}, 0.3), 0);
}

TEST(Walls, that_would_decide_are_stated) {
  EXPECT_EQ(walls_to_decide(counts_of(2, 8)), 20);  // 5 of 20: up to 49.1 %
  EXPECT_EQ(walls_to_decide(counts_of(6, 8)), 20);  // 15 of 20, its mirror image
  EXPECT_EQ(walls_to_decide(counts_of(0, 5)), 6);   // 2 * 0.5^6 < 0.05
  EXPECT_EQ(walls_to_decide(counts_of(4, 8)), 0);   // half and half
  for (int k = 0; k <= 12; ++k) {
    const int n = walls_to_decide(counts_of(k, 12));
    if (n == 0) continue;
    const Interval at =
        study::exact_share(k * n / 12.0 < n / 2.0 ? (k * n + 11) / 12 : k * n / 12, n).interval;
    EXPECT_TRUE(at.low > 0.5 || at.high < 0.5) << k;
  }
  // a quarter is lost: with all of them on the other side, 6 of 8 meet it
  EXPECT_EQ(walls_to_decide({.walls = 8, .met = 6, .lost = 2}), 20);
  EXPECT_EQ(walls_to_decide({.walls = 8, .met = 4, .lost = 4}), 0);
  EXPECT_EQ(walls_to_decide(counts_of(0, 8)), 8);
  EXPECT_EQ(walls_to_decide({}), 0);
}

// Repeated checks reduce certainty. This is the probability that the last interval
// contains the share, over every possible sequence of walls, from 8 walls on.
TEST(Walls, that_grow_hold_the_share_almost_as_often_as_said) {
  std::map<std::pair<int, int>, std::pair<int, Interval>> known;
  const auto look = [&](int k, int n, double width) -> const std::pair<int, Interval>& {
    auto& found = known[{k, n}];
    if (std::isnan(found.second.low))
      found = {next_walls(counts_of(k, n), width), study::exact_share(k, n).interval};
    return found;
  };
  const auto chance = [](int k, int n, double p) {
    return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                    k * std::log(p) + (n - k) * std::log1p(-p));
  };
  double least = 1;
  for (const double width : {0.3, 0.5}) {
    known.clear();
    for (double p = 0.02; p < 0.51; p += 0.02) {
      std::map<std::pair<int, int>, double> open;
      for (int k = 0; k <= 8; ++k) open[{k, 8}] = chance(k, 8, p);
      double held = 0;
      while (!open.empty()) {
        std::map<std::pair<int, int>, double> then;
        for (const auto& [at, probability] : open) {
          const auto& [k, n] = at;
          const auto& [next, interval] = look(k, n, width);
          if (next == 0) held += interval.low <= p && p <= interval.high ? probability : 0;
          for (int more = 0; next > n && more <= next - n; ++more)
            then[{k + more, next}] += probability * chance(more, next - n, p);
        }
        open.swap(then);
      }
      least = std::fmin(least, held);
    }
  }
  EXPECT_GT(least, 0.944);
  EXPECT_LT(least, 0.96);
}

}  // namespace
}  // namespace wythe::verdict_test
