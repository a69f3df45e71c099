// The page and the file of a campaign: whatever it holds, names as text, nothing from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "report/campaign_charts.h"
#include "report/plot.h"
#include "scenes/sample_campaign.h"
#include "wythe/io.h"
#include "wythe/report.h"

namespace wythe {
namespace {

using scenes::sample_campaign;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}
std::string page_of(const Campaign& campaign) {
  return campaign_report(campaign, statistics_of(campaign));
}
// As many tags closed as opened, for every element the page uses.
void expect_closed(const std::string& page) {
  for (const char* tag : {"div", "figure", "svg", "table", "details", "p", "section", "g", "ul"}) {
    const std::string open = std::string("<") + tag;
    EXPECT_EQ(count(page, open + " ") + count(page, open + ">"),
              count(page, std::string("</") + tag + ">"))
        << tag;
  }
}

TEST(CampaignReport, is_closed_and_needs_nothing_from_outside) {
  const std::string page = page_of(sample_campaign(60));
  expect_closed(page);
  EXPECT_EQ(count(page, "src="), 0);
  EXPECT_EQ(count(page, "href="), 0);
  EXPECT_EQ(count(page, "url("), 0);
  EXPECT_EQ(count(page, "\"nan"), 0);
  EXPECT_EQ(count(page, "inf\""), 0);
}

TEST(CampaignReport, names_from_files_are_text) {
  Campaign campaign = sample_campaign(40);
  const std::string bad = "<script>alert(2)</script>";
  campaign.study.until = "interval(share) < 0.1";
  campaign.provenance = bad;
  campaign.samples.column[0].name = campaign.samples.column[0].unit = bad;
  campaign.records[0].failure_mode.name = bad;
  campaign.records[1].status = campaign.records[1].reason = bad;
  const std::string page = page_of(campaign);
  EXPECT_EQ(count(page, "<script"), 0);
  EXPECT_GT(count(page, "&lt;script&gt;alert(2)"), 5);
}

TEST(CampaignReport, draws_every_answered_curve) {
  EXPECT_EQ(count(page_of(sample_campaign(60)), "<title>sample "), 60);
}

TEST(CampaignReport, of_250_samples_stays_below_three_megabytes) {
  EXPECT_LT(page_of(sample_campaign(250)).size(), 3'000'000u);
}

TEST(CampaignReport, an_empty_campaign_says_so) {
  const std::string page = page_of(Campaign{});
  EXPECT_EQ(count(page, "No sample has run yet"), 1);
  expect_closed(page);
}

TEST(CampaignReport, one_sample_says_so) {
  const std::string page = page_of(sample_campaign(1));
  EXPECT_EQ(count(page, "One sample answered"), 1);
  expect_closed(page);
}

TEST(CampaignReport, all_failed_says_so_and_lists_causes) {
  Campaign campaign = sample_campaign(3);
  for (SampleRecord& r : campaign.records) r.status = "unstable", r.reason = "block 7 flew off";
  const std::string page = page_of(campaign);
  EXPECT_EQ(count(page, "None of the 3 samples"), 1);
  EXPECT_EQ(count(page, "Block 7 flew off."), 3);
  expect_closed(page);
}

TEST(CampaignReport, colours_of_the_paper_stay_with_their_modes) {
  const std::vector<std::string> modes = {"FM-1", "FM-3", "rocking", "sliding", "unclear"};
  EXPECT_EQ(report::mode_class(modes, "FM-3"), "m3");
  EXPECT_EQ(report::mode_class(modes, "unclear"), "m0");
  EXPECT_NE(report::mode_class(modes, "rocking"), report::mode_class(modes, "sliding"));
  EXPECT_EQ(report::mode_class({"rocking", "sliding"}, "rocking"), "m1");
}

TEST(Plot, long_names_are_cut_between_characters) {
  EXPECT_EQ(report::cut_to_fit("sliding of pier 2"), "sliding of pier 2");
  const std::string cut = report::cut_to_fit(std::string(47, 'x') + "äöüäöü");
  EXPECT_EQ(cut, std::string(47, 'x') + "…");
  EXPECT_GT(report::room_for({cut}, 76), 300);
  EXPECT_EQ(report::room_for({}, 76), 76);
}

TEST(Plot, thinning_keeps_corners_and_drops_the_straight) {
  std::vector<report::Pixel> points;
  for (int i = 0; i <= 100; ++i) points.push_back({1.0 * i, i < 50 ? 0.0 : i - 50.0});
  const auto kept = report::thinned(points, 0.4);
  ASSERT_LE(kept.size(), 4u);
  EXPECT_EQ(kept.front().x, 0);
  EXPECT_EQ(kept.back().y, 50);
}

TEST(StatisticsJson, has_stable_keys_with_units) {
  const auto json = nlohmann::json::parse(statistics_json(statistics_of(sample_campaign(40))));
  EXPECT_EQ(json["samples"]["answered"], 40);
  const auto& all = json["table"]["all"];
  EXPECT_NEAR(all["peak_reaction_kN"]["mean"].get<double>(), 163, 10);
  for (const char* key : {"displacement_at_peak_mm", "displacement_at_80_percent_mm",
                          "displacement_max_mm", "initial_stiffness_kN_per_mm"})
    EXPECT_TRUE(all.contains(key)) << key;
  EXPECT_TRUE(all["displacement_at_80_percent_mm"].contains("survival_mean_interval"));
  EXPECT_TRUE(json["shares"]["FM-1"].contains("share_interval"));
  EXPECT_EQ(json["running"]["peak_reaction_kN"]["mean"].size(), 40u);
  EXPECT_EQ(json["exceedance"]["displacement_at_80_percent_mm"]["value_mm"].size(),
            json["exceedance"]["displacement_at_80_percent_mm"]["probability"].size());
}

TEST(StatisticsJson, what_is_not_a_number_is_null) {
  const auto json = nlohmann::json::parse(statistics_json(statistics_of(Campaign{})));
  EXPECT_TRUE(json["table"]["all"]["peak_reaction_kN"]["mean"].is_null());
  EXPECT_EQ(json["samples"]["run"], 0);
}

}  // namespace
}  // namespace wythe
