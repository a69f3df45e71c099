// Fragilities of a campaign: the outcome of each sample, and cases without a result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "scenes/sample_campaign.h"
#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::fragility_test {
namespace {

using namespace study;
using nlohmann::json;

// A campaign of two inputs in MPa: the peak is `peak(a, b)` [kN], the drift at 80 % what that says.
struct Made {
  double peak = 150, drift = 0.01;
  bool censored = false;
  std::string mode = "FM-1";
};
template <class Of>
Campaign made(int n, const Of& of) {
  Campaign campaign;
  campaign.load_height = 2;
  for (const char* name : {"a", "b"})
    campaign.samples.column.push_back({name, "", "Pa", "MPa", 1e-6, 0, true});
  RandomBits bits(4);
  for (int i = 0; i < n; ++i) {
    const double a = (i + 0.5) / n, b = bits.uniform();
    const Made m = of(a, b, i);
    SampleRecord record = scenes::sample_record(i + 1, 1e3 * m.peak, m.mode);
    record.responses.peak_reaction = 1e3 * m.peak;
    record.responses.load_height = 2;
    record.responses.displacement_at_80 = 2 * m.drift;
    record.responses.censored_80 = m.censored;
    record.quasi_static.judgement = "slow enough";
    record.inputs = {1e6 * a, 1e6 * b};
    campaign.samples.value.push_back(record.inputs);
    campaign.records.push_back(std::move(record));
  }
  return campaign;
}
std::vector<Fragility> of(const Campaign& campaign) { return fragilities(answered_of(campaign)); }

const Fragility& about(const std::vector<Fragility>& all, const std::string& what, int which = 0) {
  for (const Fragility& f : all)
    if ((f.event.response == what || f.event.mode == what) && which-- == 0) return f;
  throw std::runtime_error("no event " + what);
}
// A chance from the sample's number, the same each time.
double chance(int i) { return std::fmod(0.5 + 0.6180339887 * i, 1.0); }

TEST(Fragility, tells_of_a_force_a_drift_and_every_mode) {
  const auto all = of(made(100, [](double a, double, int i) {
    const bool strong = chance(i) < 1 / (1 + std::exp(-8 * (a - 0.5)));
    return Made{.peak = strong ? 170.0 + i / 100.0 : 130.0 + i / 100.0,
                .drift = strong ? 0.012 : 0.004,
                .mode = strong ? "FM-2" : "FM-1"};
  }));
  EXPECT_EQ(about(all, "peak_reaction").n, 100);
  EXPECT_EQ(about(all, "drift_at_80_percent").event.threshold, 0.005);
  EXPECT_EQ(about(all, "drift_at_80_percent", 1).event.threshold, 0.010);
  EXPECT_THROW(about(all, "drift_at_80_percent", 2),
               std::runtime_error);  // 1.5 %: nobody gets there
  const Fragility& mode = about(all, "FM-2");
  ASSERT_EQ(mode.input[0].verdict, FragilityVerdict::kTold);
  EXPECT_NEAR(mode.input[0].fit[0].half.value, 0.5, 0.1);
  EXPECT_LT(mode.input[0].fit[0].influence_p, 1e-6);
  EXPECT_GT(mode.input[0].fit[0].slope.interval.low, 0);
  EXPECT_LT(about(all, "FM-1").input[0].fit[0].slope.interval.high, 0);  // the other one falls
  EXPECT_EQ(mode.pair.size(), 1U);
  // within the samples, no farther
  EXPECT_NEAR(mode.input[0].point.front().x, 0.005, 1e-12);
  EXPECT_NEAR(mode.input[0].point.back().x, 0.995, 1e-12);
}

TEST(Fragility, is_not_told_of_what_always_or_never_happens) {
  Campaign campaign =
      made(60, [](double a, double, int i) { return Made{.peak = 100 + 50 * a + chance(i)}; });
  campaign.study.fragility = {"peak_reaction > 10 kN", "peak_reaction > 900 kN",
                              "peak_reaction > 148 kN"};
  const auto all = of(campaign);
  EXPECT_EQ(about(all, "peak_reaction", 0).input[0].verdict, FragilityVerdict::kAlways);
  EXPECT_EQ(about(all, "peak_reaction", 1).input[0].verdict, FragilityVerdict::kNever);
  EXPECT_EQ(about(all, "peak_reaction", 2).input[0].verdict, FragilityVerdict::kRare);
  EXPECT_EQ(about(all, "FM-1").input[0].verdict, FragilityVerdict::kAlways);
  EXPECT_GT(about(all, "peak_reaction", 1).share.interval.high,
            0.04);  // none of 60 is not none at all
  for (const Fragility& f : all) {
    for (const FragilityOfInput& input : f.input)
      EXPECT_EQ(input.point.empty(), input.verdict != FragilityVerdict::kTold);
    EXPECT_TRUE(f.input[0].verdict == FragilityVerdict::kTold || f.pair.empty());
  }
}

TEST(Fragility, says_where_an_input_parts_the_samples) {
  const auto all =
      of(made(60, [](double a, double, int) { return Made{.mode = a > 0.4 ? "FM-2" : "FM-1"}; }));
  const FragilityOfInput& a = about(all, "FM-2").input[0];
  EXPECT_EQ(a.verdict, FragilityVerdict::kSeparated);
  EXPECT_NEAR(a.parted_low, 23.5 / 60, 1e-9);
  EXPECT_NEAR(a.parted_high, 24.5 / 60, 1e-9);
  EXPECT_TRUE(a.fit.empty() && a.point.empty());
  EXPECT_EQ(about(all, "FM-2").input[1].verdict, FragilityVerdict::kTold);  // b has no part in it
  EXPECT_GT(about(all, "FM-2").input[1].fit[0].influence_p, 0.01);
}

TEST(Fragility, steeper_than_can_be_told_names_where_the_change_is) {
  // two samples change places: a slope is finite, but of a step it says nothing
  const auto all = of(made(400, [](double a, double, int i) {
    const bool far = i == 199 ? true : i == 201 ? false : a > 0.5;
    return Made{.mode = far ? "FM-2" : "FM-1"};
  }));
  const FragilityOfInput& a = about(all, "FM-2").input[0];
  EXPECT_EQ(a.verdict, FragilityVerdict::kSeparated);
  EXPECT_NEAR(a.parted_low, 199.5 / 400, 1e-9);
  EXPECT_NEAR(a.parted_high, 201.5 / 400, 1e-9);
}

TEST(Fragility, is_not_told_of_few_samples_or_of_a_mode_seen_once) {
  const auto eight = of(made(8, [](double a, double, int i) {
    return Made{.peak = 100 + 50 * a, .mode = i % 2 == 0 ? "FM-1" : "FM-2"};
  }));
  ASSERT_FALSE(eight.empty());
  for (const Fragility& f : eight)
    for (const FragilityOfInput& input : f.input)
      EXPECT_EQ(input.verdict, FragilityVerdict::kFewSamples);
  const auto once =
      of(made(100, [](double, double, int i) { return Made{.mode = i == 50 ? "FM-3" : "FM-1"}; }));
  EXPECT_EQ(about(once, "FM-3").input[0].verdict, FragilityVerdict::kRare);
  EXPECT_EQ(about(once, "FM-3").seen, 1);
  EXPECT_TRUE(of(Campaign{}).empty());
}

TEST(Fragility, is_not_told_of_an_input_that_does_not_vary_or_has_two_values) {
  Campaign campaign = made(
      80, [](double, double, int i) { return Made{.mode = chance(i) < 0.5 ? "FM-1" : "FM-2"}; });
  for (SampleRecord& r : campaign.records) r.inputs = {1e6, 1e6 * (1 + r.sample % 2)};
  // two values alone would repeat: a third input makes every sample another wall
  campaign.samples.column.push_back({"c", "", "Pa", "MPa", 1e-6, 0, true});
  for (std::size_t i = 0; i < campaign.records.size(); ++i) {
    campaign.records[i].inputs.push_back(1e4 * static_cast<double>(i % 7 + 10 * i));
    campaign.samples.value[i] = campaign.records[i].inputs;
  }
  const Fragility mode = about(of(campaign), "FM-1");
  EXPECT_EQ(mode.input[0].verdict, FragilityVerdict::kConstant);
  EXPECT_EQ(mode.input[1].verdict, FragilityVerdict::kTwoValues);
  EXPECT_EQ(mode.input[2].verdict, FragilityVerdict::kTold);
  EXPECT_EQ(mode.input[2].fit.size(), 1U);  // 0 is among the values: no lognormal law
}

TEST(Fragility, leaves_out_samples_that_repeat_others) {
  const auto twice = [](const Campaign& once) {
    Campaign campaign = once;
    for (SampleRecord record : once.records) {
      record.sample += 1000;
      campaign.samples.value.push_back(record.inputs);
      campaign.records.push_back(std::move(record));
    }
    return campaign;
  };
  const Campaign once = made(
      60, [](double a, double, int i) { return Made{.mode = chance(i) < a ? "FM-2" : "FM-1"}; });
  const Fragility one = about(of(once), "FM-2"), two = about(of(twice(once)), "FM-2");
  EXPECT_EQ(two.repeated, 60);
  EXPECT_EQ(two.n, one.n);
  EXPECT_EQ(two.input[0].fit[0].slope.interval.low, one.input[0].fit[0].slope.interval.low);
  Campaign fields = twice(once);  // of equal means, but other walls
  fields.study.field.emplace_back();
  EXPECT_EQ(about(of(fields), "FM-2").repeated, 0);
}

TEST(Fragility, knows_a_censored_drift_below_its_bound_alone) {
  // all pushes end at 0.8 %: whether 0.5 % is exceeded is known of all, 1 % of those that fell before
  const auto all = of(made(100, [](double a, double, int i) {
    const double drift = 0.003 + 0.008 * a + 0.002 * chance(i);
    return Made{.drift = std::min(drift, 0.008), .censored = drift > 0.008};
  }));
  const Fragility& below = about(all, "drift_at_80_percent");
  EXPECT_EQ(below.event.threshold, 0.005);
  EXPECT_EQ(below.unknown, 0);
  for (const Fragility& f : all)
    EXPECT_NE(f.event.threshold, 0.010);  // the program does not ask it
  Campaign asked = made(100, [](double a, double, int i) {
    const double drift = 0.003 + 0.008 * a + 0.002 * chance(i);
    return Made{.drift = std::min(drift, 0.008), .censored = drift > 0.008};
  });
  asked.study.fragility = {"drift_at_80_percent > 1 %"};
  const Fragility beyond = about(of(asked), "drift_at_80_percent");
  EXPECT_EQ(beyond.seen, 0);
  EXPECT_GT(beyond.unknown, 30);
  EXPECT_TRUE(std::isnan(beyond.share.value));
  EXPECT_LT(beyond.share.interval.low, 0.05);  // none may exceed it,
  EXPECT_GT(beyond.share.interval.high, 0.3);  // or all that went on
  EXPECT_EQ(beyond.input[0].verdict, FragilityVerdict::kRare);
}

TEST(Fragility, a_few_unknown_samples_widen_the_band_to_hold_both_cases) {
  const auto with = [](bool unknown) {
    Campaign campaign = made(200, [&](double a, double, int i) {
      const bool far = chance(i) < a;
      const bool ends = unknown && i % 20 == 7;
      return Made{.drift = ends ? 0.004 : far ? 0.02 : 0.003, .censored = ends};
    });
    campaign.study.fragility = {"drift_at_80_percent > 0.5 %"};
    return about(of(campaign), "drift_at_80_percent");
  };
  const Fragility known = with(false), open = with(true);
  EXPECT_EQ(open.unknown, 10);
  EXPECT_LE(open.seen, known.seen);
  const auto width = [](const Fragility& f) {
    const Interval& i = f.input[0].point[10].probability.interval;
    return i.high - i.low;
  };
  EXPECT_GT(width(open), 1.1 * width(known));
}

TEST(Fragility, a_peak_at_the_end_of_a_push_is_a_lower_bound) {
  Campaign campaign =
      made(60, [](double a, double, int i) { return Made{.peak = 100 + 50 * a + 20 * chance(i)}; });
  for (SampleRecord& r : campaign.records) r.responses.censored_peak = r.sample % 6 == 0;
  campaign.study.fragility = {"peak_reaction > 130 kN"};
  const Fragility f = about(of(campaign), "peak_reaction");
  EXPECT_GT(f.unknown, 0);
  for (std::size_t i = 0; i < f.sample.size(); ++i) {
    const Responses& r = campaign.records[f.sample[i] - 1].responses;
    EXPECT_EQ(f.outcome[i], r.peak_reaction > 130e3 ? 1 : r.censored_peak ? 0.5 : 0);
  }
}

TEST(Fragility, the_displacement_at_a_peak_at_the_end_of_a_push_is_a_lower_bound) {
  Campaign campaign =
      made(60, [](double a, double, int i) { return Made{.peak = 100 + 50 * a + 20 * chance(i)}; });
  for (SampleRecord& r : campaign.records) {
    r.responses.censored_peak = r.sample % 3 == 0;
    r.responses.displacement_at_peak = r.responses.censored_peak ? 2e-3 : 8e-3 * chance(r.sample);
  }
  campaign.study.fragility = {"displacement_at_peak > 4 mm"};
  const Fragility f = about(of(campaign), "displacement_at_peak");
  EXPECT_EQ(f.unknown, 20);
  for (std::size_t i = 0; i < f.sample.size(); ++i)
    EXPECT_EQ(f.outcome[i] == 0.5, f.sample[i] % 3 == 0);
}

TEST(Fragility, an_unclear_mode_may_be_the_one_asked_for) {
  const Fragility f =
      about(of(made(60,
                    [](double, double, int i) {
                      return Made{.mode = i % 3 == 0 ? "unclear" : i % 3 == 1 ? "FM-1" : "FM-2"};
                    })),
            "FM-2");
  EXPECT_EQ(f.seen, 20);
  EXPECT_EQ(f.unknown, 20);
  EXPECT_LT(f.share.interval.low, 0.34);
  EXPECT_GT(f.share.interval.high, 0.66);
}

// Pushes of a high `a` ended early: on one side they make the event rare there, on the other frequent.
TEST(Fragility, no_influence_is_claimed_that_hangs_on_what_is_not_known) {
  const auto with = [](double beyond) {
    Campaign campaign = made(200, [&](double a, double b, int i) {
      const bool ends = a > beyond;
      const bool far = chance(i) < 0.5 + 0.2 * (b - 0.5);
      return Made{.drift = ends ? 0.004 : far ? 0.02 : 0.003, .censored = ends};
    });
    campaign.study.fragility = {"drift_at_80_percent > 0.5 %"};
    return about(of(campaign), "drift_at_80_percent");
  };
  const Fragility known = with(2), open = with(0.8);
  EXPECT_EQ(open.unknown, 40);
  ASSERT_EQ(open.input[0].verdict, FragilityVerdict::kTold);
  EXPECT_GT(known.input[0].fit[0].influence_p, 0.05);
  EXPECT_TRUE(std::isnan(open.input[0].fit[0].influence_p));
  EXPECT_LT(open.input[0].fit[0].slope.interval.low, 0);
  EXPECT_GT(open.input[0].fit[0].slope.interval.high, 0);
  ASSERT_EQ(open.pair.size(), 1U);
  EXPECT_EQ(open.pair[0].verdict, FragilityVerdict::kTold);
  EXPECT_TRUE(std::isnan(open.pair[0].added_p));
}

TEST(Fragility, an_event_asked_for_that_is_the_programs_own_stands_once) {
  Campaign campaign = made(
      100, [](double, double, int i) { return Made{.drift = chance(i) < 0.5 ? 0.012 : 0.004}; });
  campaign.study.fragility = {"drift_at_80_percent > 1 %", "drift_at_80_percent > 1.0 %"};
  const auto all = of(campaign);
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const Fragility& f) {
                            return f.event.response == "drift_at_80_percent" &&
                                   std::fabs(f.event.threshold - 0.01) < 1e-9;
                          }),
            1);
}

TEST(Fragility, counts_pushes_that_were_not_slow_enough) {
  Campaign campaign =
      made(40, [](double a, double, int i) { return Made{.peak = 100 + 50 * a + 20 * chance(i)}; });
  for (SampleRecord& r : campaign.records)
    if (r.sample <= 7) r.quasi_static.judgement = "too fast";
  const Fragility f = about(of(campaign), "peak_reaction");
  EXPECT_EQ(f.doubtful, 7);
  EXPECT_EQ(f.n, 40);  // they count, as everywhere
}

TEST(Fragility, two_inputs_that_go_together_are_not_told_apart) {
  Campaign campaign = made(
      100, [](double a, double, int i) { return Made{.mode = chance(i) < a ? "FM-2" : "FM-1"}; });
  for (std::size_t i = 0; i < campaign.records.size(); ++i) {
    campaign.records[i].inputs[1] = campaign.records[i].inputs[0] * 2 + static_cast<double>(i % 2);
    campaign.samples.value[i] = campaign.records[i].inputs;
  }
  const Fragility f = about(of(campaign), "FM-2");
  ASSERT_EQ(f.pair.size(), 1U);
  EXPECT_EQ(f.pair[0].verdict, FragilityVerdict::kCollinear);
  EXPECT_EQ(f.input[0].entangled, std::vector<std::string>{"b"});
}

TEST(Fragility, events_of_a_study_are_checked) {
  const FragilityEvent force = fragility_event(" peak_reaction>0.15 MN ");
  EXPECT_EQ(force.response, "peak_reaction");
  EXPECT_NEAR(force.threshold, 150e3, 1e-6);
  EXPECT_NEAR(fragility_event("drift_at_80_percent > 0.5 %").threshold, 0.005, 1e-12);
  for (const auto& [text, word] : {std::pair{"peak_reaction", "response > threshold"},
                                   {"peek_reaction > 1 kN", "peak_reaction"},
                                   {"peak_reaction > 150", "threshold"},
                                   {"peak_reaction > 150 mm", "threshold"},
                                   {"peak_reaction > -1 kN", "positive"},
                                   {"peak_reaction > nan kN", "threshold"}}) {
    try {
      static_cast<void>(fragility_event(text));
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << text << ": " << error.what();
    }
  }
}

TEST(SurrogateIndices, of_correlated_inputs_are_not_defined) {
  Campaign campaign =
      made(100, [](double a, double b, int) { return Made{.peak = 100 + 50 * a + 20 * b}; });
  EXPECT_EQ(surrogate_indices(answered_of(campaign)).front().verdict, IndexVerdict::kTold);
  campaign.study.correlation = {{"a", "b", 0.3, false}};
  for (const SurrogateIndices& s : surrogate_indices(answered_of(campaign)))
    EXPECT_TRUE(s.verdict != IndexVerdict::kTold);
  EXPECT_EQ(surrogate_indices(answered_of(campaign)).front().verdict, IndexVerdict::kCorrelated);
}

TEST(SurrogateIndices, of_lower_bounds_are_not_told) {
  Campaign campaign =
      made(100, [](double a, double b, int) { return Made{.peak = 100 + 50 * a + 20 * b}; });
  for (SampleRecord& r : campaign.records) r.responses.censored_peak = r.sample % 10 == 0;
  EXPECT_EQ(surrogate_indices(answered_of(campaign)).front().verdict, IndexVerdict::kCensored);
  EXPECT_EQ(measurings(answered_of(campaign)).front().censored, 10);
}

TEST(Measuring, of_lower_bounds_is_not_told) {
  Campaign campaign =
      made(100, [](double a, double b, int) { return Made{.peak = 100 + 50 * a + 20 * b}; });
  const auto peak = [&] { return measurings(answered_of(campaign)).front(); };
  for (int i = 0; i < 5; ++i) campaign.records[i].responses.censored_peak = true;
  EXPECT_GT(peak().variance.value, 0.5);  // one in twenty
  campaign.records[5].responses.censored_peak = true;
  EXPECT_EQ(peak().censored, 6);
  EXPECT_TRUE(std::isnan(peak().variance.value));
  EXPECT_TRUE(std::isnan(peak().width.value));
  EXPECT_TRUE(std::isnan(peak().is_best));
  const json s = json::parse(statistics_json(statistics_of(campaign)));
  EXPECT_TRUE(s["measuring"][0]["variance_share"].is_null());
}

TEST(Fragility, counts_samples_without_an_answer) {
  Campaign campaign =
      made(100, [](double a, double b, int) { return Made{.peak = 100 + 50 * a + 20 * b}; });
  const auto lost = [&](const char* what) {
    return json::parse(statistics_json(statistics_of(campaign)))["fragility"][0][what].get<int>();
  };
  EXPECT_EQ(lost("lost"), 0);
  for (int i = 0; i < 40; ++i) campaign.records[i].status = "unstable";
  campaign.records[50].responses.peak_reaction = kUnset;
  EXPECT_EQ(lost("n"), 59);
  EXPECT_EQ(lost("lost"), 41);
}

TEST(Measuring, names_the_input_that_decides) {
  const Campaign campaign = made(100, [](double a, double b, int i) {
    return Made{.peak = 100 + 10 * a + 60 * b + chance(i)};
  });
  const std::vector<Measuring> all = measurings(answered_of(campaign));
  ASSERT_GE(all.size(), 2U);
  EXPECT_EQ(all[0].input, "b");
  EXPECT_GT(all[0].is_best, 0.99);
  EXPECT_GT(all[0].variance.interval.low, 0.8);
  EXPECT_NEAR(all[0].width.value, 1 - std::sqrt(1 - all[0].variance.value), 1e-12);
}

TEST(Fragility, stands_in_the_file_as_numbers_or_null) {
  const json s = json::parse(statistics_json(statistics_of(scenes::sample_campaign(60))));
  ASSERT_GT(s["fragility"].size(), 2U);
  const json& force = s["fragility"][0];
  EXPECT_EQ(force["response"], "peak_reaction");
  EXPECT_EQ(force["outcome"].size(), force["n"].get<std::size_t>());
  const json& curve = force["inputs"][1]["curve"];
  EXPECT_EQ(curve["input"].size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_LE(curve["low"][i].get<double>(), curve["probability"][i].get<double>());
    EXPECT_LE(curve["probability"][i].get<double>(), curve["high"][i].get<double>());
  }
  EXPECT_EQ(s["measuring"][0]["input"],
            "ft_j");  // 0.05 of the peak a standard deviation, others less
}

}  // namespace
}  // namespace wythe::fragility_test
