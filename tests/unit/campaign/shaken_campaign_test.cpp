// Campaigns over records: the runs, the stored data, and bits that do not depend on jobs, shards, resume or order.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "campaign/runner/shakes.h"
#include "core/files.h"
#include "scenes/shaken_study.h"
#include "scenes/small_study.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/text.h"

namespace wythe::shaken_campaign_test {
namespace {

namespace fs = std::filesystem;
using scenes::shaken_study;
using scenes::shaken_text;
using scenes::TemporaryFolder;

const char* const kLevels = "measure = \"pga\"\nlevels = [\"2 m/s^2\", \"4 m/s^2\", \"8 m/s^2\"]";
const char* const kClimb =
    "measure = \"pga\"\nfrom = \"2 m/s^2\"\nstep = \"3 m/s^2\"\nmost = \"14 m/s^2\"\nhalvings = 2";
const char* const kStates =
    "[[limit_state]]\nname = \"rocking\"\npeak_drift = \"2 %\"\n[[limit_state]]\nname = "
    "\"overturning\"\n"
    "collapse = true\n";

CampaignOutcome run(const StudySpec& study, const std::string& folder,
                    CampaignOptions options = {}) {
  options.provenance = "this program";
  return run_campaign(study, model_builder(study), folder, options);
}
std::string csv(const std::string& folder) { return samples_csv(read_campaign(folder)); }
std::string json(const std::string& folder) {
  return statistics_json(statistics_of(read_campaign(folder)));
}
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
std::string reading(const std::string& text) {
  return refusal([&] { (void)parse_study(text, "shaken.toml"); });
}
bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// --- which shakes ------------------------------------------------------------------------------------

ShakeResult stood(double intensity) {
  ShakeResult a;
  a.intensity = intensity, a.status = "completed", a.gap_ratio = 0;
  return a;
}
ShakeResult fell(double intensity) {
  ShakeResult a = stood(intensity);
  a.status = "collapsed", a.collapsed = true;
  return a;
}
ShakeResult lost(double intensity) {
  ShakeResult a = stood(intensity);
  a.status = "unstable";
  return a;
}

TEST(Shakes, climb_until_it_falls_then_halve) {
  ShakingSpec s;
  s.stage = "quake", s.first = 1, s.step = 2, s.most = 6, s.halvings = 2;
  const StudyRecord record;
  const auto next = [&](const std::vector<ShakeResult>& done) {
    return study::next_intensity(s, record, done).value_or(0);
  };
  EXPECT_EQ(next({}), 1);
  EXPECT_EQ(next({stood(1)}), 3);
  EXPECT_EQ(next({stood(1), stood(3), stood(5)}), 0);  // 7 is beyond
  EXPECT_EQ(next({stood(1), fell(3)}), 2);
  EXPECT_EQ(next({stood(1), fell(3), stood(2)}), 2.5);
  EXPECT_EQ(next({stood(1), fell(3), fell(2)}), 1.5);
  EXPECT_EQ(next({stood(1), fell(3), fell(2), stood(1.5)}), 0);
  EXPECT_EQ(next({fell(1)}), 0.5);
  // a shake that does not count is passed over, and not asked for again
  EXPECT_EQ(next({stood(1), lost(3)}), 5);
  EXPECT_EQ(next({stood(1), lost(3), fell(5)}), 3);
  EXPECT_EQ(next({stood(1), fell(3), lost(2)}), 0);
}

TEST(Shakes, count_where_they_ended_shaken_and_their_energy_closes) {
  EXPECT_TRUE(stood(1).counts());
  EXPECT_TRUE(fell(1).counts());
  EXPECT_FALSE(lost(1).counts());
  ShakeResult a = stood(1);
  a.gap_ratio = 0.02;
  EXPECT_FALSE(a.counts());
  a.gap_ratio = kUnset;
  EXPECT_FALSE(a.counts());
  a = fell(1);
  a.collapsed = false;  // before it was shaken
  EXPECT_FALSE(a.counts());
  for (const char* status : {"not_settled", "budget_spent", "interrupted", "refused", ""}) {
    a = stood(1);
    a.status = status;
    EXPECT_FALSE(a.counts()) << status;
  }
}

// The block's own text, with another line in the place of one.
StudySpec with_line(const std::string& line, const std::string& instead) {
  std::string text = shaken_text("measure = \"pga\"\nlevels = [\"12 m/s^2\"]", {0.3}, 1, kStates);
  const auto at = text.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return parse_study(text.replace(at, line.size(), instead), "shaken.toml");
}

// --- campaigns ----------------------------------------------------------------------------------------

TEST(ShakenCampaign, every_wall_meets_every_record_at_every_level) {
  const TemporaryFolder folder;
  const StudySpec study = shaken_study(kLevels, {0.15, 0.8, 1.6}, 2, kStates);
  EXPECT_EQ(count_samples(study), 6);
  EXPECT_EQ(count_shakes(study).most, 18);
  run(study, folder / "a");
  const Campaign campaign = read_campaign(folder / "a");
  ASSERT_EQ(campaign.records.size(), 6U);
  for (const SampleRecord& record : campaign.records) {
    ASSERT_EQ(record.shakes.size(), 3U);
    const SampleCase of = case_of(study, record.sample - 1);
    EXPECT_EQ(of.wall, (record.sample - 1) / 3);
    EXPECT_EQ(of.record, (record.sample - 1) % 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const ShakeResult& shake = record.shakes[k];
      EXPECT_EQ(shake.intensity, 2.0 * std::pow(2, k));
      EXPECT_NEAR(shake.pga, shake.intensity, 1e-3 * shake.intensity);
      EXPECT_TRUE(shake.counts()) << shake.status;
      EXPECT_EQ(shake.state_hash.size(), 16U);
    }
    // no base motion below the acceleration of uplift, b/h g = 2.45 m/s^2, rocks the block
    EXPECT_LT(record.shakes[0].peak_drift, 2e-3);
  }
  // pulses of one peak overturn a block the sooner the longer they are
  const auto& of_first = campaign.records;
  EXPECT_FALSE(of_first[0].shakes[2].collapsed);
  EXPECT_TRUE(of_first[2].shakes[2].collapsed);
  // two walls differ
  EXPECT_NE(of_first[0].shakes[2].state_hash, of_first[3].shakes[2].state_hash);
}

// This block falls long after its pulse of 0.3 s. Whoever looks away at the end of the pulse has not seen it stand.
TEST(ShakenCampaign, a_wall_that_still_falls_has_not_stood) {
  const TemporaryFolder folder;
  run(with_line("free_vibration = \"2 s\"", "free_vibration = \"3 s\""), folder / "long");
  const ShakeResult whole = read_campaign(folder / "long").records.at(0).shakes.at(0);
  ASSERT_TRUE(whole.collapsed);
  ASSERT_GT(whole.collapse_time, 0.5);
  run(with_line("free_vibration = \"2 s\"", "free_vibration = \"0.05 s\""), folder / "cut");
  const ShakeResult shake = read_campaign(folder / "cut").records.at(0).shakes.at(0);
  EXPECT_FALSE(shake.counts());
  EXPECT_TRUE(has(text_of(shake.reason), "come to rest")) << text_of(shake.reason);
}

TEST(ShakenCampaign, a_control_point_without_height_has_no_drift) {
  const TemporaryFolder folder;
  const StudySpec study = with_line("y = \"0.75 m\"", "y = \"0 m\"");
  const std::string said = refusal([&] { run(study, folder / "a"); });
  EXPECT_TRUE(has(said, "height of the control point")) << said;
}

TEST(ShakenCampaign, jobs_shards_and_resume_change_no_byte) {
  const TemporaryFolder folder;
  const StudySpec study = shaken_study(kClimb, {0.4, 0.8, 1.2}, 2, kStates);
  run(study, folder / "one", {.jobs = 1});
  run(study, folder / "two", {.jobs = 2});
  EXPECT_EQ(csv(folder / "two"), csv(folder / "one"));
  EXPECT_EQ(json(folder / "two"), json(folder / "one"));
  run(study, folder / "s1", {.shard = 1, .shards = 2});
  run(study, folder / "s2", {.shard = 2, .shards = 2});
  merge_campaigns({folder / "s2", folder / "s1"}, folder / "both");
  EXPECT_EQ(csv(folder / "both"), csv(folder / "one"));
  run(study, folder / "part", {.jobs = 1, .last = 2});
  EXPECT_EQ(read_campaign(folder / "part").records.size(), 2U);
  run(study, folder / "part", {.resume = true});
  EXPECT_EQ(csv(folder / "part"), csv(folder / "one"));
  EXPECT_EQ(json(folder / "part"), json(folder / "one"));
}

TEST(ShakenCampaign, the_order_of_records_changes_no_bit_of_an_answer) {
  const TemporaryFolder folder;
  run(shaken_study(kClimb, {0.4, 0.8, 1.2}, 2, kStates), folder / "a");
  run(shaken_study(kClimb, {1.2, 0.4, 0.8}, 2, kStates), folder / "b");
  const auto hashes = [](const Campaign& campaign) {
    std::multiset<std::string> all;
    for (const SampleRecord& record : campaign.records)
      for (const ShakeResult& shake : record.shakes) all.insert(shake.state_hash);
    return all;
  };
  EXPECT_EQ(hashes(read_campaign(folder / "a")), hashes(read_campaign(folder / "b")));
}

TEST(ShakenCampaign, one_shake_alone_has_the_bits_of_the_campaign) {
  const TemporaryFolder folder;
  const StudySpec study = shaken_study(kClimb, {0.4, 0.8}, 2, kStates);
  run(study, folder / "a");
  const Campaign campaign = read_campaign(folder / "a");
  const SampleRecord& record = campaign.records[3];
  ASSERT_GT(record.shakes.size(), 2U);
  const ShakeResult& shake = record.shakes[1];
  const SampleRun alone = run_shake(campaign.study, campaign.samples, 4, shake.intensity,
                                    model_builder(campaign.study), {});
  ASSERT_EQ(alone.shakes.size(), 1U);
  EXPECT_EQ(alone.result.state_hash, shake.state_hash);
  EXPECT_EQ(alone.shakes[0].peak_drift, shake.peak_drift);
  const SampleRun whole =
      run_sample(campaign.study, campaign.samples, 4, model_builder(campaign.study), {});
  ASSERT_EQ(whole.shakes.size(), record.shakes.size());
  EXPECT_EQ(whole.shakes.back().state_hash, record.shakes.back().state_hash);
}

TEST(ShakenCampaign, in_turn_gives_each_wall_one_record) {
  const StudySpec study =
      shaken_study(std::string(kLevels) + "\npairing = \"in_turn\"", {0.3, 0.8, 1.6}, 5);
  EXPECT_EQ(count_samples(study), 5);
  const SampleTable samples = draw_samples(study);
  ASSERT_EQ(samples.n_sample(), 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(case_of(study, i).record, i % 3);
}

TEST(ShakenCampaign, walls_do_not_depend_on_the_records) {
  const SampleTable few = draw_samples(shaken_study(kLevels, {0.3}, 4));
  const SampleTable more = draw_samples(shaken_study(kLevels, {0.3, 0.8, 1.6}, 4));
  for (int w = 0; w < 4; ++w)
    for (int r = 0; r < 3; ++r) EXPECT_EQ(more.value[3 * w + r], few.value[w]);
}

TEST(ShakenCampaign, records_alone_need_no_variable) {
  const TemporaryFolder folder;
  const StudySpec study = shaken_study(kLevels, {0.3, 0.8}, 1, kStates);
  run(study, folder / "a", {.jobs = 1});
  EXPECT_EQ(read_campaign(folder / "a").records.size(), 2U);
  run(study, folder / "a", {.resume = true});
  EXPECT_EQ(statistics_of(read_campaign(folder / "a")).shaking.shakes, 6);
}

TEST(ShakenCampaign, limit_states_may_change_on_resume_and_intensities_may_not) {
  const TemporaryFolder folder;
  run(shaken_study(kLevels, {0.3, 0.8}, 2, kStates), folder / "a");
  const std::string other = "[[limit_state]]\nname = \"uplift\"\nuplift = \"5 mm\"\n";
  run(shaken_study(kLevels, {0.3, 0.8}, 2, other), folder / "a", {.resume = true});
  const Statistics s = statistics_of(read_campaign(folder / "a"));
  ASSERT_EQ(s.shaking.fragility.size(), 1U);
  EXPECT_EQ(s.shaking.fragility[0].limit_state.name, "uplift");
  EXPECT_DOUBLE_EQ(s.shaking.fragility[0].limit_state.uplift, 5e-3);
  const std::string levels = "measure = \"pga\"\nlevels = [\"2 m/s^2\", \"5 m/s^2\"]";
  const std::string said = refusal([&] {
    run(shaken_study(levels, {0.3, 0.8}, 2, kStates), folder / "a", {.resume = true});
  });
  EXPECT_TRUE(has(said, "shaking.levels")) << said;
  EXPECT_TRUE(
      has(refusal([&] {
            run(shaken_study(kLevels, {0.3, 0.9}, 2, kStates), folder / "a", {.resume = true});
          }),
          "record.1.motion"));
}

TEST(ShakenCampaign, more_samples_keep_those_that_ran) {
  const TemporaryFolder folder;
  run(shaken_study(kLevels, {0.3, 0.8}, 2), folder / "a");
  const Campaign before = read_campaign(folder / "a");
  run(shaken_study(kLevels, {0.3, 0.8}, 5), folder / "a", {.resume = true});
  const Campaign after = read_campaign(folder / "a");
  ASSERT_EQ(after.records.size(), 10U);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(after.records[i].state_hash, before.records[i].state_hash);
}

// Files of records go into the store: the campaign is whole where they are gone.
TEST(ShakenCampaign, a_store_holds_its_records) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "records");
  std::string values = "time_s,a\n";
  for (int k = 0; k <= 80; ++k)
    values += std::to_string(0.01 * k) + "," + std::to_string(std::sin(M_PI * k / 80.0)) + "\n";
  write_file(folder / "records/half.csv", values);
  std::string text = shaken_text(kLevels, {}, 2, kStates);
  text += "[[record]]\nname = \"half\"\nfile = \"records/half.csv\"\nunit = \"m/s2\"\n";
  write_file(folder / "study.toml", text);
  const StudySpec study = read_study(folder / "study.toml");
  EXPECT_EQ(study.record_text.at("records/half.csv"), values);
  fs::remove_all(folder / "records");
  run(study, folder / "out");
  const Campaign campaign = read_campaign(folder / "out");
  EXPECT_EQ(campaign.study.record_text, study.record_text);
  const SampleRun again =
      run_sample(campaign.study, campaign.samples, 2, model_builder(campaign.study), {});
  EXPECT_EQ(again.shakes.back().state_hash, campaign.records[1].shakes.back().state_hash);
  // and the study written whole is the same study
  const StudySpec whole = parse_study(write_study(study), study.file);
  EXPECT_EQ(write_study(whole), write_study(study));
  EXPECT_EQ(draw_samples(whole).more_setting, draw_samples(study).more_setting);
}

TEST(ShakenCampaign, pgv_and_sa_scale_to_what_is_asked) {
  const TemporaryFolder folder;
  const StudySpec by_velocity =
      shaken_study("measure = \"pgv\"\nlevels = [\"0.2 m/s\", \"0.4 m/s\"]", {0.4, 0.9}, 1);
  run(by_velocity, folder / "v");
  for (const SampleRecord& r : read_campaign(folder / "v").records)
    for (const ShakeResult& s : r.shakes) EXPECT_NEAR(s.pgv / s.intensity, 1, 1e-12);
  const StudySpec by_spectrum =
      shaken_study("measure = \"sa\"\nperiod = \"0.3 s\"\ndamping = 0.05\nlevels = [\"2 m/s^2\"]",
                   {0.4, 0.9}, 1);
  run(by_spectrum, folder / "s");
  for (const SampleRecord& r : read_campaign(folder / "s").records)
    for (const ShakeResult& s : r.shakes) EXPECT_NEAR(s.sa / s.intensity, 1, 1e-12);
}

// A study without [shaking] of a model that shakes: answers are kept, in columns after the others.
TEST(ShakenCampaign, a_shaken_model_without_the_table_keeps_its_answers) {
  const TemporaryFolder folder;
  std::string text = shaken_text("", {}, 3);
  text.erase(text.find("[shaking]"), 10);
  run(parse_study(text, "s.toml"), folder / "a");
  const Campaign campaign = read_campaign(folder / "a");
  for (const SampleRecord& r : campaign.records) {
    ASSERT_EQ(r.shakes.size(), 1U);
    EXPECT_TRUE(r.shakes[0].counts());
    EXPECT_TRUE(std::isnan(r.shakes[0].intensity));
    EXPECT_EQ(r.state_hash, r.shakes[0].state_hash);
  }
  EXPECT_TRUE(has(samples_csv(campaign), "peak_drift_percent"));
  EXPECT_EQ(statistics_of(campaign).answered, 3);
}

// --- faults ------------------------------------------------------------------------------------------

TEST(ShakenStudy, says_every_fault_with_its_cure) {
  const std::vector<double> pulses = {0.4, 0.8};
  const auto with = [&](const std::string& shaking, const std::string& more = "") {
    return reading(shaken_text(shaking, pulses, 2, more));
  };
  const struct {
    std::string text, wants;
  } cases[] = {
      {with("levels = [\"1 m/s^2\"]"), "shaking.measure"},
      {with("measure = \"pgx\"\nlevels = [\"1 m/s^2\"]"), "pga"},
      {with("measure = \"pga\""), "has no intensities"},
      {with("measure = \"pga\"\nlevels = []"), "is empty"},
      {with("measure = \"pga\"\nlevels = [\"2 m/s^2\", \"1 m/s^2\"]"), "do not rise"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s^2\", \"1 m/s^2\"]"), "do not rise"},
      {with("measure = \"pga\"\nlevels = [\"-1 m/s^2\"]"), "more than 0"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s\"]"), "m/s^2"},
      {with("measure = \"pgv\"\nlevels = [\"1 m/s^2\"]"), "m/s"},
      {with("measure = \"pga\"\nlevels = [1]"), "has no unit"},
      {with("measure = \"sa\"\nlevels = [\"1 m/s^2\"]"), "needs it"},
      {with("measure = \"pga\"\nperiod = \"0.3 s\"\nlevels = [\"1 m/s^2\"]"), "belongs to measure"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s^2\"]\nfrom = \"1 m/s^2\""), "stands beside"},
      {with("measure = \"pga\"\nfrom = \"1 m/s^2\"\nmost = \"4 m/s^2\""), "shaking.step"},
      {with("measure = \"pga\"\nfrom = \"5 m/s^2\"\nstep = \"1 m/s^2\"\nmost = \"4 m/s^2\""),
       "less than from"},
      {with("measure = \"pga\"\nfrom = \"1 m/s^2\"\nstep = \"0.001 m/s^2\"\nmost = \"4 m/s^2\""),
       "more than 200"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s^2\"]\nhalvings = 2"), "belongs to from"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s^2\"]\nstage = \"push\""), "write quake"},
      {with("measure = \"pga\"\nlevels = [\"1 m/s^2\"]\nfoo = 1"), "foo"},
      {with("measure = \"pga\"\nlevels = [\"500 m/s^2\"]"), "record \"pulse of 0.4 s\""},
      {with(kLevels, "[[limit_state]]\nname = \"x\"\n"), "has no limit"},
      {with(kLevels, "[[limit_state]]\npeak_drift = \"1 %\"\n"), "limit_state.0.name"},
      {with(kLevels, "[[limit_state]]\nname = \"x\"\npeak_drift = 0.01\n"), "has no unit"},
      {with(kLevels, "[[limit_state]]\nname = \"x\"\npeak_drift = \"1 %\"\ncollapse = true\n"),
       "reaches too"},
      {with(kLevels, std::string(kStates) + kStates), "stands there twice"},
      {with(kLevels, "[[record]]\nname = \"pulse of 0.4 s\"\nfile = \"a.csv\"\nunit = \"g\"\n"),
       "stands there twice"},
      {with(kLevels, "[[record]]\nname = \"none\"\nfile = \"no_such.csv\"\nunit = \"g\"\n"),
       "no_such.csv"},
      {with(kLevels, "[[record]]\nname = \"x\"\npulse = \"half_cycle\"\nperiod = \"1 s\"\n"),
       "amplitude"},
      {with(kLevels,
            "[[record]]\nname = \"x\"\npulse = \"half_cycle\"\nperiod = \"1 s\"\namplitude = \"1 "
            "m/s^2\"\ncolour = 1\n"),
       "colour"},
      {with(kLevels,
            "[[record]]\nname = \"x\"\nlevels = [\"3 m/s^2\", \"2 m/s^2\"]\npulse = "
            "\"half_cycle\"\nperiod = \"1 s\"\namplitude = \"1 m/s^2\"\n"),
       "do not rise"},
      {reading(shaken_text(kLevels, {}, 2)), "record"},
      {reading(shaken_text(kLevels, pulses, 3) + "[study2]\n"), "study2"},
  };
  for (const auto& c : cases) EXPECT_TRUE(has(c.text, c.wants)) << c.wants << " in:\n" << c.text;
}

TEST(ShakenStudy, refuses_what_belongs_to_pushes) {
  for (const char* key :
       {"until = \"interval(share) < 0.1\"", "fragility = [\"peak_reaction > 1 kN\"]",
        "states = [\"1 mm\"]", "fractions = [0.5]", "read_modes_at = \"10 mm\""}) {
    std::string text = shaken_text(kLevels, {0.4}, 2);
    text.insert(text.find("samples"), std::string(key) + "\n");
    EXPECT_TRUE(has(reading(text), "leave it out")) << key << reading(text);
  }
  std::string pushed = shaken_text(kLevels, {0.4}, 2);
  pushed.insert(
      pushed.find("[[history]]"),
      "[[stage]]\nname = \"push\"\nat = { x = \"0.1 m\", y = \"0.7 m\" }\nvelocity = \"5 mm/s\"\n"
      "until = \"1 mm\"\n");
  EXPECT_TRUE(has(reading(pushed), "leave that stage out")) << reading(pushed);
  std::string still = shaken_text(kLevels, {0.4}, 2);
  still.erase(still.find("record = { pulse"),
              still.find("free_vibration") - still.find("record = { pulse"));
  EXPECT_FALSE(reading(still).empty());
  EXPECT_TRUE(has(reading(shaken_text(kLevels, {0.4}, 1) +
                          "[variable.f]\npath = \"wall.thickness\"\n"
                          "distribution = \"normal\"\nmean = \"1 m\"\ncov = 0.1\n"),
                  "at least 2"));
  EXPECT_TRUE(has(
      reading(shaken_text(std::string(kLevels) + "\npairing = \"in_turn\"", {0.4, 0.5, 0.6}, 2)),
      "leaves records out"));
  EXPECT_TRUE(
      has(reading(shaken_text(kLevels, {0.4}, 2,
                              "[[variant]]\nname = \"tie\"\nset = [\"wall.thickness=0.5 m\"]\n")),
          "beside [shaking]"));
  std::string alone = shaken_text(kLevels, {0.4}, 2);
  alone.erase(alone.find("[shaking]"), alone.find("[[record]]") - alone.find("[shaking]"));
  EXPECT_TRUE(has(reading(alone), "without [shaking]"));
}

}  // namespace
}  // namespace wythe::shaken_campaign_test
