// Campaigns of very many samples: a selection of them gives the intervals of all, and the page stays readable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "report/bundle.h"
#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/survival.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"
#include "wythe/parts/statistics.h"

namespace wythe::many_samples_test {
namespace {

using namespace study;

// Peaks of 150 kN with a CoV of 10 %; displacements that go beyond the end of the push in a third of the samples.
Campaign many(int n) {
  Campaign campaign;
  campaign.load_height = 3;
  campaign.samples.column = {{"ft", "material.joint.tensile_strength", "Pa", "MPa", 1e-6, 0, true}};
  RandomBits bits(5);
  for (int i = 0; i < n; ++i) {
    const double z = normal_quantile(bits.uniform()), other = normal_quantile(bits.uniform());
    SampleRecord& r = campaign.records.emplace_back();
    r.sample = i + 1, r.status = "completed";
    r.inputs = {1e5 * (1 + 0.1 * (0.8 * z + 0.6 * other))};
    campaign.samples.value.push_back(r.inputs);
    r.responses.peak_reaction = 150e3 * (1 + 0.1 * z);
    const double failed = 20e-3 * std::exp(0.3 * other), end = 23e-3;
    r.responses.displacement_at_peak = 1e-3;
    r.responses.displacement_at_80 = std::min(failed, end);
    r.responses.censored_80 = failed > end;
    r.curve = {{}, {.displacement = end, .reaction = r.responses.peak_reaction}};
    r.failure_mode.name = i == 3776 ? "FM-5" : "FM-1";
    r.failure_mode.read_at = 40e-3;
  }
  return campaign;
}

const Summary& summary_of(const Statistics& s, const char* quantity) {
  for (std::size_t q = 0; q < quantities().size(); ++q)
    if (std::string(quantities()[q].name) == quantity) return s.group.front().quantity[q];
  throw std::runtime_error(quantity);
}

TEST(ManySamples, so_many_stand_for_all_wherever_they_lie) {
  EXPECT_TRUE(Resampled(kMostResampled).is_all());
  std::vector<int> all(100'000);
  for (int i = 0; i < 100'000; ++i) all[i] = i;
  const Resampled part(all.size());
  const std::vector<int> taken = part.of(all);
  ASSERT_EQ(static_cast<int>(taken.size()), kMostResampled);
  int odd = 0;
  for (int i = 0; i < kMostResampled; ++i) {
    EXPECT_EQ(taken[i] / 50, i);  // one of each part
    odd += taken[i] % 2;
  }
  // every second point of a Sobol sequence lies in one half
  EXPECT_NEAR(odd, kMostResampled / 2, 4 * std::sqrt(0.25 * kMostResampled));
}

TEST(ManySamples, no_statistic_sees_more_than_stand_for_all) {
  const Statistics s = statistics_of(many(30'000));
  EXPECT_EQ(s.answered, 30'000);
  EXPECT_EQ(summary_of(s, "peak_reaction").n, 30'000);
  for (const Fragility& f : s.fragility) EXPECT_LE(f.n, 10'000);
  for (const Measuring& m : s.measuring) EXPECT_LE(m.n, 10'000);
}

// The widths that theory gives for 20 000 samples. 2000 replicates of 2000 samples know a width to 3 %; of a median,
// whose density they have to find as well, to 10 %.
TEST(ManySamples, intervals_are_as_wide_as_those_of_all) {
  constexpr int kN = 20'000;
  const Campaign campaign = many(kN);
  const Statistics s = statistics_of(campaign);
  const Summary& peak = summary_of(s, "peak_reaction");
  const double sigma = 15e3, root = std::sqrt(kN);
  const auto near = [](const Interval& interval, double width, double share, const char* what) {
    EXPECT_NEAR(interval.width(), width, share * width) << what;
  };
  near(peak.mean.interval, 2 * kNormal95 * sigma / root, 0.06, "mean");
  near(peak.cov.interval, 2 * kNormal95 * 0.1 * std::sqrt(0.5 + 0.01) / root, 0.08, "CoV");
  near(peak.median.interval, 2 * kNormal95 * std::sqrt(M_PI / 2) * sigma / root, 0.2, "median");
  EXPECT_LT(peak.mean.interval.low, peak.mean.value);
  EXPECT_GT(peak.mean.interval.high, peak.mean.value);
  for (const Exceedance& e : s.exceedance) {
    if (e.quantity == "peak_reaction") {
      near(e.beta.interval, 2 * kNormal95 * e.beta.value / std::sqrt(2.0 * kN), 0.1, "beta");
    }
    if (e.quantity != "displacement_at_80_percent") continue;
    EXPECT_GT(e.censored, kN / 4);
    EXPECT_NEAR(e.median.value, 20e-3, 3 * 0.3 * 20e-3 / root);
    EXPECT_NEAR(e.beta.value, 0.3, 4 * 0.3 / std::sqrt(2.0 * kN) * 1.3);
    // bounds know less than values: wider than of as many values, by not more than of those observed
    EXPECT_GT(e.beta.interval.width(), 0.95 * 2 * kNormal95 * 0.3 / std::sqrt(2.0 * kN));
    EXPECT_LT(e.beta.interval.width(), 1.6 * 2 * kNormal95 * 0.3 / std::sqrt(2.0 * kN));
  }
}

// A stiffness that no input changes: it ended the statistics with words of a library.
TEST(ManySamples, a_response_of_one_value_has_no_indices) {
  const Statistics s = statistics_of(many(60));
  ASSERT_FALSE(s.surrogate_indices.empty());
  EXPECT_EQ(s.surrogate_indices.back().quantity, "initial_stiffness_kN_per_mm");
  EXPECT_EQ(s.surrogate_indices.back().verdict, IndexVerdict::kUnexplained);
}

// Replicates from sums about the mean equal replicates from the values.
TEST(ManySamples, mean_and_cov_are_those_of_the_general_bootstrap) {
  const Campaign campaign = many(120);
  const Summary peak = summary_of(statistics_of(campaign), "peak_reaction");
  std::vector<double> values;
  for (const SampleRecord& r : campaign.records) values.push_back(r.responses.peak_reaction);
  std::sort(values.begin(), values.end());
  const auto moments = [&](const Counts& count) {
    Moments m;
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int k = 0; k < count[i]; ++k) m.add(values[i]);
    return m;
  };
  const auto same = [](const Estimate& a, const Estimate& b) {
    EXPECT_NEAR(a.value, b.value, 1e-12 * b.value);
    EXPECT_NEAR(a.interval.low, b.interval.low, 1e-9 * b.value);
    EXPECT_NEAR(a.interval.high, b.interval.high, 1e-9 * b.value);
  };
  same(peak.mean, bca_bootstrap(120, [&](const Counts& c) { return moments(c).mean(); }));
  same(peak.cov, bca_bootstrap(120, [&](const Counts& c) {
         const Moments m = moments(c);
         return m.standard_deviation() / m.mean();
       }));
}

TEST(ManySamples, long_lists_of_statistics_keep_their_ends) {
  const nlohmann::json json = nlohmann::json::parse(statistics_json(statistics_of(many(5000))));
  const nlohmann::json& running = json["running"]["peak_reaction_kN"];
  EXPECT_EQ(running["n"].size(), 2000U);
  EXPECT_EQ(running["mean"].size(), 2000U);
  EXPECT_EQ(running["n"].front(), 1);
  EXPECT_EQ(running["n"].back(), 5000);
  const nlohmann::json& beyond = json["exceedance"]["peak_reaction_kN"];
  EXPECT_EQ(beyond["probability"].size(), 2000U);
  EXPECT_EQ(beyond["probability"].back(), 0);
  EXPECT_EQ(beyond["n"], 5000);
}

TEST(ManySamples, the_page_shows_some_and_says_so) {
  const Campaign campaign = many(5000);
  const report::Json header = report::header_of(campaign_data(campaign, statistics_of(campaign)));
  const std::size_t shown = header["samples"].size();
  EXPECT_EQ(shown, 2001U);  // every mode has one
  EXPECT_EQ(header["thinned"]["n"], shown);
  EXPECT_EQ(header["thinned"]["of"], 5000);
  std::set<int> numbers;
  bool has_rare = false;
  for (const report::Json& sample : header["samples"]) {
    numbers.insert(sample["sample"].get<int>());
    has_rare = has_rare || sample["mode"] == "FM-5";
  }
  EXPECT_EQ(numbers.size(), shown);
  EXPECT_TRUE(has_rare);
  EXPECT_FALSE(
      report::header_of(campaign_data(many(100), statistics_of(many(100)))).contains("thinned"));
}

}  // namespace
}  // namespace wythe::many_samples_test
