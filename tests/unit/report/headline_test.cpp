// The headline of runs and campaigns from artificial data: reasons for doubt come before all
// numbers, an unknown value is never a number, and a wall of many parts gets one sentence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "report/bundle.h"
#include "report/headline.h"
#include "report/texts.h"
#include "scenes/sample_run.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/report.h"

namespace wythe::headline_test {
namespace {

using namespace report;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// The headline of data written by hand: keys as summary.json and statistics.json have them.
std::string run_head(const std::string& summary, const std::string& language = "en",
                     const Json& mode = {{"brief", "one pier cracks"}}) {
  const Json header = {{"kind", "run"},
                       {"title", "w"},
                       {"weight_kN", 4.5},
                       {"summary", Json::parse(summary)},
                       {"mode", mode}};
  return headline_of(header, Texts(language));
}
// The answer alone, as a reader sees it.
std::string answer_of(const std::string& head) {
  const std::string open = "<p class=\"answer\">";
  const std::size_t from = head.find(open) + open.size();
  return std::regex_replace(head.substr(from, head.find("</p>", from) - from),
                            std::regex("<[^>]*>"), "");
}
std::string pushed(const std::string& more) {
  return R"({"status": "completed", "reason": "", "peak_reaction_kN": 10, "displacement_at_peak_mm": 2,
    "displacement_at_80_percent_mm": 6, "displacement_max_mm": 9, "censored_80": false,
    "drift_percent_at_peak": 0.2, "initial_stiffness_kN_per_mm": 5,
    "failure_mode": {"name": "FM-1", "sentence": "one pier cracks", "read_at_mm": 40})" +
         more + "}";
}

TEST(Headline, a_push_that_was_too_fast_is_said_before_any_number) {
  const std::string head = answer_of(run_head(
      pushed(R"(, "quasi_static": {"judgement": "too fast", "verdict": "too fast: halve it"})")));
  EXPECT_EQ(head.rfind("This run was pushed too fast: its force is not the strength of the wall. "
                       "The wall",
                       0),
            0u)
      << head;
  const auto begins = [](const std::string& judgement, const std::string& words) {
    const std::string said = answer_of(run_head(
        pushed(R"(, "quasi_static": {"verdict": "?", "judgement": ")" + judgement + "\"}")));
    return said.rfind(words, 0) == 0;
  };
  EXPECT_TRUE(begins("usable", "This run was pushed a little too fast:"));
  EXPECT_TRUE(begins("unknown", "It is not known whether this run was pushed slowly enough:"));
  EXPECT_TRUE(begins("slow enough", "The wall resists"));
  EXPECT_TRUE(begins("no push", "The wall resists"));
}

TEST(Headline, a_drift_that_one_run_cannot_tell_is_said_first) {
  const std::string head = run_head(pushed(R"(, "quasi_static": {"judgement": "slow enough",
    "verdict": "slow enough", "displacement": {"verdict": "not known", "reason": "it jumped"}})"));
  EXPECT_EQ(answer_of(head).rfind("One run cannot tell the drift:", 0), 0u) << head;
  EXPECT_NE(head.find("caution mild"), std::string::npos);  // the force is what it says
}

TEST(Headline, the_ends_of_a_short_dip_differ) {
  const auto said = [](const std::string& from, const std::string& back) {
    return answer_of(run_head(pushed(R"(, "drift_capacity": {"dips": [{"from_mm": )" + from +
                                     R"(, "back_mm": )" + back +
                                     R"(, "lowest_left": 0.7, "before_peak": false}]})")));
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string short_one = said("46.281", "46.312"), long_one = said("4.281", "5.312");
  EXPECT_TRUE(has(short_one,
                  "From 46.28\u202fmm the force dips to 70\u202f% of the peak. It "
                  "recovers by 46.31\u202fmm"))
      << short_one;
  EXPECT_TRUE(has(long_one, "From 4.28\u202fmm")) << long_one;
}

TEST(Headline, no_capacity_is_said_with_its_reason_and_the_raw_maximum) {
  const std::string none = R"({"status": "completed", "reason": "", "peak_reaction_kN": null,
    "displacement_at_peak_mm": null, "displacement_at_80_percent_mm": null, "drift_percent_at_peak": null,
    "initial_stiffness_kN_per_mm": null, "peak_raw_kN": 247.2,
    "peak_reason": "reaction and base shear never agree within 2 %",
    "failure_mode": {"name": "FM-1", "sentence": "one pier cracks", "read_at_mm": 40}})";
  const std::string head = run_head(none);
  EXPECT_EQ(answer_of(head).rfind(
                "No capacity was found: reaction and base shear never agree within 2 %. "
                "The largest force read, 247\u202fkN, is not a strength.",
                0),
            0u)
      << answer_of(head);
  EXPECT_EQ(count(head, "The wall resists"), 0);
  EXPECT_EQ(count(head, "0\u202fkN"), 0);
  EXPECT_EQ(count(head, "<div class=\"value\">not known</div>"), 1);
  EXPECT_EQ(count(head, "largest force read</div>"), 1);
  EXPECT_EQ(count(head, "NaN") + count(head, "null"), 0);
  EXPECT_EQ(answer_of(run_head(none, "it")).rfind("Non è stata trovata alcuna capacità", 0), 0u);
}

TEST(Headline, an_energy_ledger_that_does_not_close_is_said_first) {
  const auto said = [](const std::string& gap) {
    return answer_of(run_head(pushed(R"(, "energy_J": {"gap": 1, "gap_ratio": )" + gap + "}")));
  };
  EXPECT_EQ(said("4.1").rfind("The energy of this run does not balance (410\u202f% is missing)", 0),
            0u)
      << said("4.1");
  EXPECT_EQ(said("-0.02").rfind("The energy of this run does not balance (2\u202f%", 0), 0u);
  EXPECT_EQ(said("0.009").rfind("The wall resists", 0), 0u);
  EXPECT_EQ(said("null").rfind("It is not known whether this run", 0), 0u) << said("null");
}

TEST(Headline, blocks_that_slid_off_before_the_peak_are_said_first) {
  const auto said = [](const std::string& at) {
    return answer_of(
        run_head(pushed(R"(, "validity": {"joints": 3, "overlap_lost_at_mm": )" + at + "}")));
  };
  EXPECT_EQ(said("1.5").rfind("Blocks slid off each other at 1.5\u202fmm", 0), 0u) << said("1.5");
  EXPECT_EQ(said("7").rfind("The wall resists", 0), 0u);
  EXPECT_NE(said("7").find("From 7\u202fmm on blocks have slid off each other"), std::string::npos);
  EXPECT_EQ(said("null").rfind("The wall resists", 0), 0u);
  EXPECT_EQ(said("null").find("slid off"), std::string::npos);
}

TEST(Headline, what_fell_is_counted) {
  const std::string fell = answer_of(run_head(
      pushed(R"(, "debris": {"blocks": 12, "volume_m3": 0.31, "mass_kg": 560, "reach_m": 0.42})")));
  EXPECT_NE(fell.find("12 blocks fell"), std::string::npos) << fell;
  EXPECT_EQ(answer_of(run_head(pushed(R"(, "debris": {"blocks": 0})"))).find("fell,"),
            std::string::npos);
}

TEST(Headline, a_load_that_grew_says_its_factor_and_tilt_whatever_else_was_read) {
  const std::string head =
      run_head(pushed(R"(, "load_factor": 0.25, "tilt_degrees": 14.04, "top_displacement_mm": 3)"));
  EXPECT_EQ(answer_of(head).rfind("The wall carries 0.25 of its weight sideways (load factor λ), a "
                                  "tilt of 14°.",
                                  0),
            0u)
      << answer_of(head);
  EXPECT_EQ(count(head, "class=\"card\""), 4);
  EXPECT_EQ(count(head, "Past the peak"), 0);
}

TEST(Headline, a_run_that_broke_off_says_so_before_its_force) {
  for (const char* status : {"unstable", "not_settled", "interrupted", "budget_spent"}) {
    std::string summary = pushed("");
    summary.replace(summary.find("completed"), 9, status);
    EXPECT_EQ(answer_of(run_head(summary)).rfind("The wall resists", 0), std::string::npos)
        << status;
  }
}

TEST(Headline, a_wall_that_came_down_is_not_to_be_pushed_farther) {
  std::string summary = pushed(R"(, "censored_max": true)");
  summary.replace(summary.find("completed"), 9, "collapsed");
  summary.replace(summary.find("\"displacement_max_mm\": 9"), 24, "\"displacement_max_mm\": 2");
  const std::string head = run_head(summary);
  EXPECT_EQ(count(head, "push farther") + count(head, "at least"), 0) << answer_of(head);
}

// A peak in the last hundredth of the path is a lower bound, as the summary and the console say.
TEST(Headline, a_peak_close_to_the_end_is_a_bound) {
  std::string summary =
      pushed(R"(, "censored_max": true, "censored_80": true, "censored_peak": true)");
  summary.replace(summary.find("\"displacement_max_mm\": 9"), 24, "\"displacement_max_mm\": 2.01");
  EXPECT_NE(answer_of(run_head(summary)).find("at least"), std::string::npos)
      << answer_of(run_head(summary));
  summary.replace(summary.find("\"censored_peak\": true"), 21, "\"censored_peak\": false");
  EXPECT_EQ(answer_of(run_head(summary)).find("at least 10"), std::string::npos)
      << answer_of(run_head(summary));
}

// A facade of eight piers: one short sentence, the rest is in the table below.
TEST(Headline, many_damaged_parts_are_counted_not_listed) {
  Json elements = Json::array();
  for (int i = 1; i <= 8; ++i) {
    const std::string name = "pier " + std::to_string(i);
    elements.push_back(
        {{"element", name}, {"kind", "pier"}, {"state", i < 7 ? "rocking" : "intact"}});
  }
  for (int i = 1; i <= 7; ++i)
    elements.push_back(
        {{"element", "spandrel " + std::to_string(i)}, {"kind", "spandrel"}, {"state", "intact"}});
  const Json mode = {
      {"name", "pier rocking"}, {"sentence", "?"}, {"read_at_mm", 40}, {"elements", elements}};
  const std::string said =
      answer_of(run_head(pushed(", \"failure_mode\": " + mode.dump()), "en",
                         {{"words", "pier rocking"}, {"brief", "?"}, {"lists_parts", true}}));
  EXPECT_NE(said.find("It fails by pier rocking: damage shows in 6 of 8 piers."), std::string::npos)
      << said;
  EXPECT_LT(said.size(), 220u) << said;
}

TEST(Headline, candidates_of_an_unclear_mode_are_named_without_their_definitions) {
  Result result = scenes::sample_result();
  result.failure_mode.name = "unclear";
  result.failure_mode.sentence = {"mode.between_modes",
                                  {{"first", as_text("FM-4")},
                                   {"first_means", Message{"mode.fm_4"}},
                                   {"second", as_text("FM-5")},
                                   {"second_means", Message{"mode.fm_5"}}}};
  const Json header = header_of(run_data(scenes::sample_spec(), scenes::sample_model(), result));
  for (const auto& [language, words] :
       {std::pair{"en", "Between FM-4 and FM-5."}, std::pair{"it", "Tra FM-4 e FM-5."}}) {
    const std::string said = answer_of(headline_of(header, Texts(language)));
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
}

std::string campaign_head(const std::string& samples, const std::string& statistics,
                          const std::string& language = "en") {
  Json header = {{"kind", "campaign"}, {"title", "c"}};
  header["statistics"] = Json::parse(R"({"seed": 1, "design": "Monte Carlo", "load_height_m": 2,
    "samples": {"asked": 4, "run": 4, "answered": 4}, "shares": {}, "table": {"all": {
    "peak_reaction_kN": {"n": 4, "mean": 100, "percentile_5": 90, "percentile_95": 110},
    "displacement_at_80_percent_mm": {"n": 4, "censored": 0, "survival_mean": 20, "max": 30}}}})");
  header["statistics"].merge_patch(Json::parse(statistics));
  header["samples"] = Json::parse(samples);
  return headline_of(header, Texts(language));
}
std::string sample_json(const std::string& peak) {
  return R"({"answered": true, "response": [)" + peak + "]}";
}

TEST(Headline, a_campaign_counts_the_samples_that_were_too_fast_first) {
  const auto judged = [](const std::string& counts) {
    return campaign_head("[]", R"({"samples": {"judgements": {)" + counts + "}}}");
  };
  const std::string counted = answer_of(judged(R"("too fast": 3, "unknown": 1, "slow enough": 0)"));
  EXPECT_EQ(
      counted.rfind("3 of 4 samples were pushed too fast: their forces are not strengths.", 0), 0u)
      << counted;
  EXPECT_NE(counted.find("For 1 of 4 samples it is not known"), std::string::npos) << counted;
  const std::string fine = answer_of(judged(R"("slow enough": 4)"));
  EXPECT_EQ(fine.rfind("In 4 samples the wall resists", 0), 0u) << fine;
  EXPECT_NE(judged(R"("usable": 2)").find("2 of 4 samples were pushed a"), std::string::npos);
}

TEST(Headline, a_campaign_counts_the_samples_without_a_force_in_balance) {
  const std::string one = sample_json("null");
  const std::string some = answer_of(campaign_head("[" + one + "," + sample_json("9") + "]", "{}"));
  EXPECT_EQ(some.rfind("1 of 4 samples never had a force in balance", 0), 0u) << some;
  const std::string none = campaign_head(
      "[" + one + "," + one + "," + one + "," + one + "]",
      R"({"table": {"all": {"peak_reaction_kN": {"n": 0, "mean": null, "percentile_5": null,
        "percentile_95": null}, "displacement_at_80_percent_mm": {"n": 0, "survival_mean": null,
        "max": null}}}})");
  EXPECT_NE(answer_of(none).find("No strength was found."), std::string::npos) << answer_of(none);
  EXPECT_EQ(count(none, "wall resists") + count(none, ">0\u202fkN") + count(none, "null"), 0)
      << none;
}

TEST(Headline, runs_above_their_limit_load_are_told_the_allowance_the_program_uses) {
  const Json header = Json::parse(R"({"kind": "limit", "title": "w", "opinion": {
    "mechanisms": [], "limit_loads": [], "comparison": {"bounds": [{"holds": false}]}}})");
  const std::string allowance = fmt::format("{:g}\u202f%", 1e2 * kBoundTolerance);
  for (const char* language : {"en", "it"})
    EXPECT_EQ(count(headline_of(header, Texts(language)), allowance), 1) << language;
}

}  // namespace
}  // namespace wythe::headline_test
