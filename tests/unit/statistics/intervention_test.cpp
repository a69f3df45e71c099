// Before and after against closed forms: ratios of pairs, limits, bounds, no answer, swapped sides, the same wall twice, doubts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scenes/sample_campaign.h"
#include "statistics/intervals.h"
#include "statistics/pairs.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/io.h"

namespace wythe::intervention_test {
namespace {

using Sides = std::vector<std::pair<Reading, Reading>>;  // before, after

PairedResponse response_of(const Sides& sides) {
  std::vector<PairValue> pairs;
  for (const auto& [before, after] : sides)
    pairs.push_back({static_cast<int>(pairs.size()) + 1, before, after});
  return study::paired_response(std::move(pairs), true, 0);
}
Change changed(const Sides& sides, double least = 1, double most = kUnset, int lost = 0) {
  return change_of(response_of(sides), lost, least, most);
}
// Five walls whose ratios are exp(-2d), exp(-d), 1, exp(d), exp(2d), times `middle`.
Sides scattered(double middle, double d) {
  Sides out;
  for (int k = -2; k <= 2; ++k)
    out.push_back({{10.0 + k, false}, {(10.0 + k) * middle * std::exp(k * d), false}});
  return out;
}

// What a slip beside the intervention would change: a thickness, a load, a value that one file alone states.
TEST(Intervention, every_key_in_which_the_models_differ_is_named) {
  const char* base =
      "name = \"before\"\n"
      "[wall]\nlength = \"2 m\"\nheight = \"2 m\"\nthickness = \"380 mm\"\n"
      "[wall.unit]\nlength = \"250 mm\"\nheight = \"100 mm\"\ndensity = \"1800 kg/m^3\"\n"
      "[[wall.opening]]\nname = \"door\"\nx = \"0.5 m\"\ny = \"1 m\"\nwidth = \"0.5 m\"\nheight = "
      "\"0.5 m\"\n"
      "lintel = { kind = \"none\" }\n"
      "[material.joint]\nuse = \"granite_dry\"\nnormal_stiffness = \"20 GPa/m\"\nshear_stiffness = "
      "\"8 GPa/m\"\nresidual_friction_angle = \"30 deg\"\ncompressive_strength = "
      "\"unlimited\"\n[[stage]]\nname = \"gravity\"\n";
  const auto model = [&](std::vector<std::string> settings) {
    return parse_model(base, "model.toml", settings);
  };
  const ModelSpec before = model({});
  EXPECT_TRUE(model_differences(before, model({"name=\"after\""})).empty());
  using Keys = std::vector<std::string>;
  EXPECT_EQ(
      model_differences(before, model({"wall.thickness=\"400 mm\"", "wall.bond=\"english\""})),
      (Keys{"wall.thickness: 0.38 m → 0.4 m", "wall.bond: running → english"}));
  const Keys more = model_differences(before, model({"wall.beam.height=\"0.2 m\""}));
  ASSERT_EQ(more.size(), 1);
  EXPECT_EQ(more[0], "+ wall.beam.height = 200 mm");
  EXPECT_EQ(model_differences(model({"wall.beam.height=\"0.2 m\""}), before)[0],
            "− wall.beam.height = 200 mm");
  ModelSpec without = before;
  without.wall.opening.clear();
  EXPECT_EQ(model_differences(before, without), Keys{"− wall.opening"});
  EXPECT_EQ(model_differences(without, before), Keys{"+ wall.opening"});
  ModelSpec one_more = before;  // before the door in the list
  one_more.wall.opening.insert(one_more.wall.opening.begin(), before.wall.opening[0]);
  one_more.wall.opening[0].name = "window";
  EXPECT_EQ(model_differences(before, one_more), Keys{"+ wall.opening.window"});
  // two of one name are told apart by their places
  ModelSpec two = before;
  two.spring = {{.name = "s", .stiffness = 1e6}, {.name = "s", .stiffness = 1e6}};
  ModelSpec stiffer = two;
  stiffer.spring[1].stiffness = 2e6;
  EXPECT_EQ(model_differences(two, stiffer), Keys{"spring.1.stiffness: 1 kN/mm → 2 kN/mm"});
  // contents of files, whose names may be the same
  ModelSpec drawn = before, other = before;
  drawn.wall.blocks = other.wall.blocks = "blocks.json";
  drawn.block = {{.id = "a", .polygon = {{0, 0}, {1, 0}, {1, 1}}}};
  other.block = {{.id = "a", .polygon = {{0, 0}, {1, 0}, {1, 2}}}};
  EXPECT_TRUE(model_differences(drawn, drawn).empty());
  EXPECT_EQ(model_differences(drawn, other), Keys{"wall.blocks: other blocks"});
  ModelSpec field = before;
  field.field["ft"].path = "material.joint.tensile_strength";
  ModelSpec cut_off = field;
  field.field["ft"].upper = 3, cut_off.field["ft"].upper = 2;
  EXPECT_EQ(model_differences(field, cut_off), Keys{"field.ft.upper: 3 → 2"});
  ModelSpec shaken = before;
  shaken.stage.push_back({.name = "shake", .action = ShakeStage{}});
  RecordSpec record;
  record.read_times = {0, 0.1}, record.read_accelerations = {0, 1};
  shaken.stage.back().get<ShakeStage>().record = {record};
  ModelSpec stronger = shaken;
  EXPECT_TRUE(model_differences(shaken, stronger).empty());
  stronger.stage.back().get<ShakeStage>().record[0].read_accelerations = {0, 1.1};
  EXPECT_EQ(model_differences(shaken, stronger), Keys{"stage.shake.record: other accelerations"});
}

TEST(Intervention, a_change_is_the_geometric_mean_of_the_pairs_with_students_interval) {
  const double d = 0.02;
  const Change change = changed(scattered(0.9, d));
  // logarithms of -2d ... 2d: standard deviation d sqrt(2.5)
  const double half = study::student_95(4) * d * std::sqrt(2.5 / 5);
  EXPECT_NEAR(change.ratio.value, 0.9, 1e-12);
  EXPECT_NEAR(change.ratio.interval.low, 0.9 * std::exp(-half), 1e-12);
  EXPECT_NEAR(change.ratio.interval.high, 0.9 * std::exp(half), 1e-12);
}

TEST(Intervention, the_whole_interval_decides) {
  const double half = study::student_95(4) * 0.02 * std::sqrt(2.5 / 5);
  const double low = 0.9 * std::exp(-half), high = 0.9 * std::exp(half);
  EXPECT_EQ(changed(scattered(0.9, 0.02), low).answer, ChangeAnswer::kYes);
  EXPECT_EQ(changed(scattered(0.9, 0.02), low * 1.0001).answer, ChangeAnswer::kNotShown);
  EXPECT_EQ(changed(scattered(0.9, 0.02), high * 0.9999).answer, ChangeAnswer::kNotShown);
  EXPECT_EQ(changed(scattered(0.9, 0.02), high * 1.0001).answer, ChangeAnswer::kNo);
  EXPECT_EQ(changed(scattered(1.16, 0.02), 0.85, 1.15).answer, ChangeAnswer::kNotShown);
  EXPECT_EQ(changed(scattered(1.3, 0.02), 0.85, 1.15).answer, ChangeAnswer::kNo);
  EXPECT_EQ(changed(scattered(1, 0.02), 0.85, 1.15).answer, ChangeAnswer::kYes);
}

TEST(Intervention, swapped_sides_have_the_inverse_ratio) {
  Sides swapped = scattered(0.8, 0.05);
  for (auto& [before, after] : swapped) std::swap(before, after);
  const Change there = changed(scattered(0.8, 0.05)), back = changed(swapped);
  EXPECT_NEAR(there.ratio.value * back.ratio.value, 1, 1e-12);
  EXPECT_NEAR(there.ratio.interval.low * back.ratio.interval.high, 1, 1e-12);
}

TEST(Intervention, equal_walls_do_not_change_and_their_interval_has_no_width) {
  for (const std::size_t walls : {1U, 2U, 8U}) {
    const Change change = changed(Sides(walls, {{3.7, false}, {3.7, false}}));
    EXPECT_TRUE(change.is_same);
    EXPECT_EQ(change.ratio.value, 1);
    EXPECT_EQ(change.ratio.interval.width(), 0);
    EXPECT_EQ(change.answer, ChangeAnswer::kYes);
  }
}

TEST(Intervention, one_wall_has_no_interval_and_few_have_no_answer) {
  const Change one = changed({{{10, false}, {9, false}}}, 0.85, 1.15);
  EXPECT_NEAR(one.ratio.value, 0.9, 1e-12);
  EXPECT_TRUE(std::isnan(one.ratio.interval.low));
  EXPECT_EQ(one.answer, ChangeAnswer::kYes);
  const Change few = changed({{{10, false}, {9, false}}, {{10, false}, {8, false}}}, 0.5);
  EXPECT_EQ(few.answer, ChangeAnswer::kNotKnown);
  EXPECT_EQ(few.why.code, "compare.why_few");
}

TEST(Intervention, a_bound_after_can_show_that_nothing_fell_and_never_that_it_did) {
  Sides bounds(6, {{10, false}, {12, true}});
  const Change more = changed(bounds);
  EXPECT_TRUE(more.at_least);
  EXPECT_EQ(more.answer, ChangeAnswer::kYes);
  for (auto& [before, after] : bounds) after.value = 8;
  EXPECT_EQ(changed(bounds).answer, ChangeAnswer::kNotShown);
  for (auto& [before, after] : bounds) std::swap(before, after);  // 8 or more before, 10 after
  EXPECT_TRUE(changed(bounds).at_most);
  EXPECT_EQ(changed(bounds).answer, ChangeAnswer::kNotShown);
  for (auto& [before, after] : bounds) after.value = 6;
  EXPECT_EQ(changed(bounds).answer, ChangeAnswer::kNo);
}

TEST(Intervention, pushes_that_ended_too_early_on_both_sides_tell_nothing) {
  const Change equal = changed(Sides(8, {{12, true}, {12, true}}));
  EXPECT_EQ(equal.answer, ChangeAnswer::kNotKnown);
  EXPECT_FALSE(equal.is_same);
  EXPECT_EQ(equal.why.code, "compare.why_bounds");
  Sides mixed(8, {{12, false}, {12, false}});
  mixed[0].first.censored = true, mixed[5].second.censored = true;
  EXPECT_EQ(changed(mixed).answer, ChangeAnswer::kNotKnown);
}

TEST(Intervention, a_lost_pair_or_one_without_a_value_leaves_no_answer) {
  EXPECT_EQ(changed(scattered(1.5, 0.01), 1, kUnset, 1).answer, ChangeAnswer::kNotKnown);
  Sides silent = scattered(1.5, 0.01);
  silent[2].second.value = kUnset;
  EXPECT_EQ(changed(silent).answer, ChangeAnswer::kNotKnown);
  silent[2].second.value = 0;  // no ratio
  EXPECT_EQ(changed(silent).answer, ChangeAnswer::kNotKnown);
  EXPECT_EQ(changed({}).answer, ChangeAnswer::kNotKnown);
}

// --- models ----------------------------------------------------------------------------------------

// Six walls, their strength times `factor`; what is not asked about here stays.
ComparedCampaign campaign_of(const std::string& name, double factor, const std::string& mode) {
  ComparedCampaign out{.name = name, .folder = "", .campaign = {}};
  for (int i = 1; i <= 6; ++i) {
    out.campaign.samples.value.emplace_back();
    SampleRecord& record = out.campaign.records.emplace_back(
        scenes::sample_record(i, factor * (100e3 + 1e3 * i), mode));
    record.state_hash = fmt::format("{} {} {}", i, factor, mode);
    record.quasi_static.judgement = "slow enough";
  }
  return out;
}
ComparedModels models_of(double plus, double minus, const std::string& mode = "FM-1") {
  ComparedModels models;
  models.name = {"before.toml", "after.toml"};
  models.way = {{{"+x", "uniform"}, {campaign_of("b", 1, "FM-1"), campaign_of("a", plus, mode)}},
                {{"-x", "uniform"}, {campaign_of("b", 1, "FM-1"), campaign_of("a", minus, mode)}}};
  return models;
}
const CheckedChange& strength_of(const PairedComparison& found) {
  return found.intervention.at(0).change.at(1);
}

TEST(Intervention, the_worse_direction_decides) {
  const PairedComparison found = compare_models(models_of(1.1, 0.9));
  EXPECT_EQ(found.option.size(), 2U);
  EXPECT_EQ(strength_of(found).quantity, "peak_reaction");
  EXPECT_EQ(strength_of(found).way[0].answer, ChangeAnswer::kYes);
  EXPECT_EQ(strength_of(found).way[1].answer, ChangeAnswer::kNo);
  EXPECT_EQ(strength_of(found).answer, ChangeAnswer::kNo);
  EXPECT_EQ(strength_of(found).way[strength_of(found).worst].push.text(), "-x");
  EXPECT_EQ(found.intervention[0].answer, ChangeAnswer::kNo);
}

TEST(Intervention, of_ways_with_one_direction_and_two_patterns_the_worse_is_named_and_shown) {
  ComparedModels models = models_of(0.9, 0.95);
  models.way[1].push = {"+x", "mass_height"};
  for (ComparedWay& way : models.way) way.push.is_several = true;
  const PairedComparison found = compare_models(models);
  const auto json = nlohmann::json::parse(comparison_json(found));
  const auto& strength = json["intervention"][0]["change"][1];
  EXPECT_EQ(strength["decides"], "+x, uniform");
  EXPECT_EQ(strength["way"][0]["decides"], true);
  EXPECT_EQ(strength["way"][1]["decides"], false);
  EXPECT_EQ(json["option"][1]["pattern"], "mass_height");
  EXPECT_NE(text_of(found.intervention[0].sentence).find("+x with forces by mass"),
            std::string::npos)
      << found.intervention[0].sentence;
}

TEST(Intervention, limits_are_inputs_and_say_whether_they_are_the_defaults) {
  ComparedModels models = models_of(0.97, 0.96);
  EXPECT_EQ(strength_of(compare_models(models)).answer, ChangeAnswer::kNo);
  EXPECT_TRUE(strength_of(compare_models(models)).is_default);
  models.limits.strength = 0.05;
  const PairedComparison found = compare_models(models);
  EXPECT_EQ(strength_of(found).answer, ChangeAnswer::kYes);
  EXPECT_FALSE(strength_of(found).is_default);
}

TEST(Intervention, a_model_against_itself_is_no_change) {
  const Intervention found = compare_models(models_of(1, 1)).intervention.at(0);
  EXPECT_NE(text_of(found.sentence).find("no change"), std::string::npos);
  EXPECT_EQ(text_of(found.sentence).find('+'), std::string::npos) << found.sentence;
}

// An opening is cut and the wall falls, before any push: its strength is nothing, and not unknown.
TEST(Intervention, a_changed_wall_that_falls_does_not_keep_within_the_limits) {
  for (const char* status : {"collapsed", "not_settled"}) {
    ComparedModels models = models_of(1.1, 1.1);
    SampleRecord& after = models.way[1].stores[1].campaign.records[3];
    after.status = status, after.curve.clear(), after.responses.peak_reaction = kUnset;
    const bool falls = after.status == "collapsed";
    const Intervention found = compare_models(models).intervention.at(0);
    EXPECT_EQ(found.answer, falls ? ChangeAnswer::kNo : ChangeAnswer::kNotKnown) << status;
    EXPECT_EQ(
        text_of(found.sentence).find("in 1 of 6 pairs the changed wall falls") != std::string::npos,
        falls)
        << text_of(found.sentence);
    // a wall that falls before and after the change shows nothing of the change
    models.way[1].stores[0].campaign.records[3] = after;
    EXPECT_EQ(compare_models(models).intervention.at(0).answer, ChangeAnswer::kNotKnown) << status;
  }
}

// `wythe run` of such a wall says that its displacement is not known.
TEST(Intervention, a_displacement_that_a_slower_push_may_change_is_not_known) {
  const PushDoubt doubt{.displacement = {"promise.force"}, .mode = true};
  for (const std::size_t side : {0U, 1U}) {
    ComparedModels models = models_of(1.1, 1.1);
    models.way[1].stores[side].doubt[3] = doubt;
    const Intervention found = compare_models(models).intervention.at(0);
    EXPECT_EQ(found.change.at(1).answer, ChangeAnswer::kYes);  // the strength
    const CheckedChange& displacement = found.change.at(2);
    EXPECT_EQ(displacement.way[0].answer, ChangeAnswer::kYes);
    EXPECT_EQ(displacement.way[1].answer, ChangeAnswer::kNotKnown);
    EXPECT_EQ(displacement.way[1].why.code, "compare.why_doubt");
    EXPECT_EQ(displacement.answer, ChangeAnswer::kNotKnown);
    EXPECT_EQ(found.answer, ChangeAnswer::kNotKnown);
    const std::string said = text_of(found.sentence);
    for (const char* words :
         {"in 1 of 6 pairs of walls a slower push may give another one",
          "the push is not slow enough for its force", "must not fall: not known",
          "in 1 of these pairs a slower push may show another failure mode"})
      EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  // walls that are equal to the last bit stay equal in a slower push
  ComparedModels models = models_of(1, 1);
  for (ComparedCampaign& store : models.way[1].stores) store.doubt[3] = doubt;
  EXPECT_EQ(compare_models(models).intervention.at(0).answer, ChangeAnswer::kYes);
}

TEST(Intervention, another_failure_is_told_with_its_counts) {
  const std::string said =
      text_of(compare_models(models_of(1.2, 1.2, "FM-4")).intervention.at(0).sentence);
  EXPECT_NE(said.find("before FM-1 in 12; after FM-4 in 12"), std::string::npos) << said;
}

}  // namespace
}  // namespace wythe::intervention_test
