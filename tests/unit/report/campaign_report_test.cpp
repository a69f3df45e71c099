// The page and the file of a campaign: any content, names as text. The
// drawings by the page's scripts are tested in a browser (tests/web).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "report/bundle.h"
#include "report/wall_arrays.h"
#include "scenes/sample_campaign.h"
#include "scenes/scenes.h"
#include "wythe/parts/io.h"
#include "wythe/parts/report.h"
#include "wythe/parts/study.h"

namespace wythe::campaign_report_test {
namespace {

using report::header_of;
using report::Json;
using scenes::sample_campaign;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}
std::string data_of(const Campaign& campaign) {
  return campaign_data(campaign, statistics_of(campaign));
}
// The part of the page without scripts.
std::string head_of(const Campaign& campaign, const std::string& language = "en") {
  const std::string page = report_page(data_of(campaign), language);
  const std::size_t from = page.find("<main");
  return page.substr(from, page.find("</main>") - from);
}

TEST(CampaignReport, headline_says_how_strong_how_far_and_how_it_fails) {
  const std::string head = head_of(sample_campaign(60));
  EXPECT_EQ(count(head, "In 60 samples the wall resists <b>"), 1);
  EXPECT_EQ(count(head, "It fails most often by <b>FM-"), 1);
  EXPECT_EQ(count(head, "class=\"card\""), 4);
  EXPECT_EQ(count(head, "nan"), 0);
  EXPECT_EQ(count(head_of(sample_campaign(60), "it"), "In 60 campioni la parete resiste"), 1);
}

// `n` of the samples end at their peaks, named at the end of a push of 20 mm.
Campaign ended_early(int n) {
  Campaign campaign = sample_campaign(60);
  for (SampleRecord& r : campaign.records) r.responses.censored_80 = false;  // of peaks only
  for (int i = 0; i < n; ++i) {
    campaign.records[i].responses.displacement_at_peak =
        campaign.records[i].curve.back().displacement;
    campaign.records[i].responses.censored_peak = true;
    campaign.records[i].failure_mode.read_at = 20e-3;
  }
  return campaign;
}

TEST(CampaignReport, peaks_at_the_end_of_the_push_are_lower_bounds) {
  const int early = statistics_of(ended_early(0)).still_rising;
  EXPECT_EQ(early, 0);
  EXPECT_EQ(count(head_of(ended_early(0)), "still rising"), 0);

  const std::string few = head_of(ended_early(30));  // half is not most
  EXPECT_EQ(count(few, "In 30 of 60 samples the force was still rising"), 1);
  EXPECT_EQ(count(few, "nine times in ten between"), 1);
  EXPECT_EQ(count(few, "≥ "), 0);

  const std::string most = head_of(ended_early(31));
  EXPECT_EQ(count(most, "In 31 of 60 samples the force was still rising"), 1);
  EXPECT_EQ(count(most, "In 60 samples the wall resists at least <b>"), 1);
  EXPECT_EQ(count(most, "<div class=\"value\">≥ "), 2);  // mean and weakest twentieth
  EXPECT_EQ(count(head_of(ended_early(31), "it"), "resiste in media ad almeno <b>"), 1);
}

// `n` of the samples never fell to 80 % of their peak.
Campaign held(int n) {
  Campaign campaign = sample_campaign(60);
  for (SampleRecord& r : campaign.records) {
    Responses& responses = r.responses;
    responses.censored_80 = r.sample <= n;
    responses.displacement_at_80 = r.sample <= n ? 50e-3 : 10e-3 + 0.2e-3 * r.sample;
  }
  return campaign;
}

TEST(CampaignReport, mean_displacement_is_a_bound_where_many_never_fell) {
  const std::string none = head_of(held(0)), few = head_of(held(3)), many = head_of(held(20));
  EXPECT_EQ(count(none, "known only from below"), 0);
  EXPECT_EQ(count(few, "3 of 60 known only from below"), 1);  // 5 % hardly move a mean
  EXPECT_EQ(count(few, "up to at least"), 0);
  EXPECT_EQ(count(many, "20 of 60 known only from below"), 1);
  EXPECT_EQ(count(many, "It keeps 80\u202f% of the peak up to at least <b>"), 1);
  EXPECT_EQ(count(many, "<div class=\"value\">≥ "), 1);
  EXPECT_EQ(count(many, "It fails most often by"), 1);
  const std::string most = head_of(held(40));
  EXPECT_EQ(count(most, "Most samples still hold 80\u202f% of their peak"), 1);
  EXPECT_EQ(count(most, "So far it shows most often <b>FM-"), 1);
}

TEST(CampaignData, says_where_modes_were_read_and_what_was_still_rising) {
  const Json header = header_of(data_of(ended_early(7)));
  EXPECT_EQ(header["samples"][0]["read_at_mm"], 20.0);
  EXPECT_EQ(header["samples"][0]["read_early"], true);
  EXPECT_EQ(header["samples"][7]["read_early"], false);
  EXPECT_EQ(header["samples"][0]["still_rising"], true);
  EXPECT_EQ(header["samples"][7]["read_at_mm"], 40.0);
  EXPECT_EQ(header["samples"][7]["still_rising"], false);
}

TEST(CampaignReport, names_read_before_the_asked_displacement_are_told) {
  EXPECT_EQ(count(head_of(ended_early(7)), "7 of 60 pushes ended before 40\u202fmm"), 1);
}

TEST(CampaignReport, names_from_files_are_text) {
  Campaign campaign = sample_campaign(40);
  const std::string bad = "<script>alert(2)</script>";
  campaign.study.name = bad;
  campaign.provenance = bad;
  campaign.samples.column[0].name = campaign.samples.column[0].unit = bad;
  for (SampleRecord& r : campaign.records) r.failure_mode.name = bad;
  const std::string page = report_page(data_of(campaign));
  EXPECT_EQ(count(page, bad), 0);
  EXPECT_EQ(count(page, "&lt;script&gt;alert(2)"), 3);  // title, heading, most frequent mode
}

TEST(CampaignReport, of_250_samples_stays_below_three_megabytes) {
  EXPECT_LT(report_page(data_of(sample_campaign(250))).size(), 3'000'000u);
}

TEST(CampaignReport, an_empty_campaign_says_so) {
  EXPECT_EQ(count(head_of(Campaign{}), "No sample has run yet"), 1);
}

TEST(CampaignReport, one_sample_says_so) {
  EXPECT_EQ(count(head_of(sample_campaign(1)), "One sample answered"), 1);
}

TEST(CampaignReport, all_failed_says_so_and_carries_the_causes) {
  Campaign campaign = sample_campaign(3);
  for (SampleRecord& r : campaign.records)
    r.status = "unstable", r.reason = as_text("block 7 flew off");
  EXPECT_EQ(count(head_of(campaign), "None of the 3 samples"), 1);
  const Json header = header_of(data_of(campaign));
  EXPECT_EQ(header["statistics"]["samples"]["unanswered"].size(), 3u);
  EXPECT_EQ(header["samples"][0]["reason"], "block 7 flew off");
}

TEST(CampaignData, carries_every_sample_curve_and_input) {
  const Campaign campaign = sample_campaign(30);
  const Json header = header_of(data_of(campaign));
  ASSERT_EQ(header["samples"].size(), 30u);
  std::size_t rows = 0;
  for (const SampleRecord& r : campaign.records) rows += r.curve.size();
  EXPECT_EQ(header["arrays"]["curve.reaction_kN"]["count"], rows);
  EXPECT_EQ(header["arrays"]["input"]["count"], 30 * campaign.samples.column.size());
  const double peak = header["samples"][4]["response"][0];
  EXPECT_NEAR(peak, campaign.records[4].responses.peak_reaction * 1e-3, 1e-9);
}

// The density is a density: over all of the samples' range it sums to nearly one.
TEST(CampaignData, densities_integrate_to_the_share_in_range) {
  const Json header = header_of(data_of(sample_campaign(400)));
  int drawn = 0;
  for (const Json& input : header["inputs"]) {
    if (input["density"].is_null()) continue;
    const auto x = input["density"]["x"].get<std::vector<double>>();
    const auto y = input["density"]["y"].get<std::vector<double>>();
    double sum = 0;
    for (std::size_t i = 1; i < x.size(); ++i) sum += 0.5 * (y[i] + y[i - 1]) * (x[i] - x[i - 1]);
    EXPECT_GT(sum, 0.97) << input["name"];  // 400 samples span all but about 2/400 of it
    EXPECT_LT(sum, 1.001) << input["name"];
    ++drawn;
  }
  EXPECT_EQ(drawn, 5);
}

TEST(CampaignData, before_a_sample_shows_all_its_states_every_sample_shows_its_last) {
  EXPECT_EQ(report::states_kept(4, 100, 10), 4);
  EXPECT_EQ(report::states_kept(4, 14, 10), 4);
  EXPECT_EQ(report::states_kept(4, 13, 10), 1);
  EXPECT_EQ(report::states_kept(1, 1, 10), 1);
  EXPECT_EQ(report::states_kept(4, 0, 0), 0);
  EXPECT_EQ(report::states_kept(0, 5, 0), 0);
}

// Walls of a real model: a frame a stored state of samples that answered, none where states are missing.
TEST(CampaignData, draws_every_stored_state_of_each_sample) {
  Campaign campaign = sample_campaign(4);
  campaign.records[1].status = "unstable";
  const ModelSpec spec = scenes::small_wall();
  const Model model = compile(spec);
  SampleWalls walls;
  walls.build = [&](const std::vector<std::string>&) { return spec; };
  walls.states = [&](int sample, const Model&) {
    std::vector<Snapshot> states;
    if (sample == 4) return states;  // none stored
    for (const double at : {1e-3, 2e-3}) states.push_back({"", at, 10e3, initial_state(model)});
    return states;
  };
  const Json header = header_of(campaign_data(campaign, statistics_of(campaign), walls));
  ASSERT_EQ(header["frames"].size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(header["frames"][i]["sample"], i < 2 ? 1 : 3);
    EXPECT_EQ(header["frames"][i]["displacement_mm"], i % 2 == 0 ? 1.0 : 2.0);
    EXPECT_EQ(header["frames"][i]["stored"], 2);
  }
  EXPECT_EQ(header["arrays"]["frame.ux"]["count"], 4 * model.n_block);
  EXPECT_EQ(header["wall"]["blocks"], model.n_block);
}

TEST(CampaignData, shows_each_sample_with_its_own_fields) {
  const auto wall = [](int seed) {
    ModelSpec spec = scenes::small_wall();
    FieldSpec& ft = spec.field["ft"];
    ft.path = "material.joint.tensile_strength";
    ft.distribution = DistributionKind::kNormal;
    ft.cov = 0.25, ft.lower = 0.75, ft.upper = 1.25;
    ft.by = FieldBy::kJoint;
    ft.seed = seed;
    draw_fields(spec);
    return spec;
  };
  Campaign campaign = sample_campaign(3);
  int built = 0;
  SampleWalls walls;
  walls.build = [&](const std::vector<std::string>&) { return wall(++built); };
  walls.states = [&](int, const Model& model) {
    return std::vector<Snapshot>{{"", 1e-3, 10e3, initial_state(model)}};
  };
  const Json header = header_of(campaign_data(campaign, statistics_of(campaign), walls));
  const Json& fields = header["wall"]["fields"];
  ASSERT_EQ(fields.size(), header["frames"].size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    EXPECT_EQ(fields[i]["sample"], header["frames"][i]["sample"]);
    EXPECT_EQ(fields[i]["name"], "ft");
    EXPECT_NE(fields[i]["note"].dump().find("13.5 %"), std::string::npos) << fields[i]["note"];
    EXPECT_TRUE(header["arrays"].contains("wall.field_" + std::to_string(i)));
  }
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
}  // namespace wythe::campaign_report_test
