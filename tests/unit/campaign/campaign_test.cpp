// Campaigns: results depend only on the inputs, never on jobs, order, shard, stop or resume.
#include "wythe/parts/campaign.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <filesystem>

#include "campaign/runner/sample_run.h"
#include "campaign/store/digest.h"
#include "campaign/store/folder_lock.h"
#include "campaign/store/store.h"
#include "scenes/changed_store.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/io.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/stored_states.h"

namespace wythe::campaign_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

CampaignOutcome run(const StudySpec& asked, const std::string& folder, CampaignOptions options = {},
                    const std::function<void(const CampaignProgress&)>& progress = {}) {
  options.provenance = "this program";
  return run_campaign(asked, model_builder(asked), folder, options, progress);
}

Model wall() { return compile(model_builder(scenes::small_study(2))({})); }

std::string csv(const std::string& folder) { return samples_csv(read_campaign(folder)); }

// The message of a refusal; "" if nothing was refused.
template <class Error, class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Campaign, jobs_do_not_change_a_byte) {
  const TemporaryFolder folder;
  const StudySpec asked = scenes::small_study(6);
  const CampaignOutcome one = run(asked, folder / "one", {.jobs = 1});
  EXPECT_EQ(one.done, 6);
  EXPECT_FALSE(one.interrupted);
  run(asked, folder / "two", {.jobs = 2});
  run(asked, folder / "nine", {.jobs = 9});
  EXPECT_EQ(csv(folder / "two"), csv(folder / "one"));
  EXPECT_EQ(csv(folder / "nine"), csv(folder / "one"));
}

TEST(Campaign, samples_csv_has_the_contract_columns) {
  const TemporaryFolder folder;
  run(scenes::small_study(2), folder / "out");
  const std::string text = csv(folder / "out");
  EXPECT_EQ(text.substr(0, text.find(",censored_max")),
            "sample,ft_MPa,c_MPa,status,peak_reaction_kN,displacement_at_peak_mm,"
            "displacement_at_80_percent_mm,censored_80,displacement_max_mm,failure_mode");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_TRUE(has(text, "\n1,0.1")) << text;
}

TEST(Campaign, asked_states_and_the_whole_curve_are_stored) {
  const TemporaryFolder folder;
  run(scenes::small_study(2), folder / "out");
  const std::vector<Snapshot> states = read_states(folder / "out", 2, wall());
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].label, "0.2 mm");
  EXPECT_EQ(states[1].label, "0.4 mm");
  EXPECT_GT(states[1].state.ux.front(), states[0].state.ux.front());
  const Campaign campaign = read_campaign(folder / "out");
  EXPECT_GE(campaign.records[1].curve.size(), 500U);
  EXPECT_EQ(read_responses(campaign.records[1].curve).peak_reaction,
            campaign.records[1].responses.peak_reaction);
  EXPECT_DOUBLE_EQ(campaign.load_height, 0.75);
}

TEST(Campaign, a_sample_alone_gives_the_same_bits) {
  const TemporaryFolder folder;
  run(scenes::small_study(3), folder / "out");
  const Campaign campaign = read_campaign(folder / "out");  // nothing but the store
  const SampleRun alone = run_sample(campaign.study, campaign.samples, 3,
                                     model_builder(campaign.study), SolveOptions{});
  EXPECT_EQ(alone.result.state_hash, campaign.records[2].state_hash);
  EXPECT_EQ(alone.result.responses.peak_reaction, campaign.records[2].responses.peak_reaction);
  EXPECT_EQ(alone.result.failure_mode.name, campaign.records[2].failure_mode.name);
}

TEST(Campaign, shards_merge_into_the_whole) {
  const TemporaryFolder folder;
  const StudySpec asked = scenes::small_study(5);
  run(asked, folder / "whole");
  const CampaignOutcome first = run(asked, folder / "s1", {.shard = 1, .shards = 2});
  EXPECT_EQ(first.total, 3);  // 1, 3, 5
  run(asked, folder / "s2", {.shard = 2, .shards = 2});
  merge_campaigns({folder / "s2", folder / "s1"}, folder / "merged");
  EXPECT_EQ(csv(folder / "merged"), csv(folder / "whole"));
  EXPECT_EQ(read_states(folder / "merged", 4, wall()).size(), 2U);
  const Campaign merged = read_campaign(folder / "merged"), whole = read_campaign(folder / "whole");
  for (std::size_t i = 0; i < whole.records.size(); ++i) {  // sentences as data, not as texts
    EXPECT_EQ(merged.records[i].quasi_static.verdict, whole.records[i].quasi_static.verdict);
    EXPECT_TRUE(merged.records[i].quasi_static.verdict.code.starts_with("rate.")) << i;
  }
  // what is merged can go on as a whole
  const CampaignOutcome more = run(asked, folder / "merged", {.resume = true});
  EXPECT_EQ(more.done, 5);
}

TEST(Campaign, shards_of_other_studies_do_not_merge) {
  const TemporaryFolder folder;
  StudySpec other = scenes::small_study(4);
  run(other, folder / "s1", {.shard = 1, .shards = 2});
  other.seed = 8;
  run(other, folder / "s2", {.shard = 2, .shards = 2});
  const std::string said = refusal<InputError>([&] {
    merge_campaigns({folder / "s1", folder / "s2"}, folder / "merged");
  });
  EXPECT_TRUE(has(said, "seed: was 7 in " + (folder / "s1") + ", is 8 now")) << said;
  EXPECT_FALSE(fs::exists(folder / "merged"));
}

TEST(Campaign, contradicting_shards_do_not_merge) {
  const TemporaryFolder folder;
  run(scenes::small_study(2), folder / "a");
  run(scenes::small_study(2), folder / "b");
  study::Store(folder / "b", study::Store::Access::kWrite)
      .database()
      .execute("UPDATE sample SET state_hash = 'other' WHERE sample = 2");
  scenes::renew_checksums(folder / "b");
  const std::string said = refusal<InputError>([&] {
    merge_campaigns({folder / "a", folder / "b"}, folder / "m");
  });
  EXPECT_TRUE(has(said, "sample 2: completed with state other here")) << said;
}

// Shards say by a checksum that they drew the same, so that not every one is read to its end; what they ran with is read.
TEST(Campaign, a_shard_whose_inputs_are_forged_does_not_merge) {
  const TemporaryFolder folder;
  run(scenes::small_study(4), folder / "a", {.shard = 1, .shards = 2});
  run(scenes::small_study(4), folder / "b", {.shard = 2, .shards = 2});
  {
    study::Store store(folder / "b", study::Store::Access::kWrite);
    const std::string digest = store.inputs_digest();
    store.database().execute("UPDATE sample_input SET value = value * 1.5 WHERE sample = 2");
    scenes::renew_checksums(folder / "b");
    study::Statement(store.database(), "UPDATE study SET value = ? WHERE key = ?")
        .run(digest, study::kInputsDigest);
    ASSERT_EQ(store.inputs_digest(), digest);
  }
  const std::string said = refusal<IoError>([&] {
    merge_campaigns({folder / "a", folder / "b"}, folder / "m");
  });
  EXPECT_TRUE(has(said, "/b/campaign.db") && has(said, "sample 2")) << said;
  EXPECT_FALSE(fs::exists(folder / "m"));
}

TEST(Campaign, what_statistics_need_is_read_as_the_whole) {
  const TemporaryFolder folder;
  run(scenes::small_study(3), folder / "out");
  const Campaign whole = read_campaign(folder / "out"), answers = read_answers(folder / "out");
  ASSERT_EQ(answers.records.size(), 3U);
  EXPECT_EQ(samples_csv(answers), samples_csv(whole));
  EXPECT_EQ(statistics_json(full_statistics(answers)), statistics_json(full_statistics(whole)));
  EXPECT_TRUE(answers.records[0].features.empty() && !whole.records[0].features.empty());
}

TEST(Campaign, a_stop_keeps_what_is_done_and_resume_finishes) {
  const TemporaryFolder folder;
  const StudySpec asked = scenes::small_study(24);  // more than two jobs solve side by side
  run(asked, folder / "undisturbed");
  std::atomic<bool> stop{false};
  const CampaignOutcome stopped = run(asked, folder / "out", {.jobs = 2, .stop = &stop},
                                      [&](const CampaignProgress& p) { stop = p.done >= 2; });
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_GE(stopped.done, 2);
  EXPECT_LT(stopped.done, 24);
  EXPECT_EQ(read_campaign(folder / "out").records.size(), static_cast<std::size_t>(stopped.done));
  const CampaignOutcome rest = run(asked, folder / "out", {.resume = true});
  EXPECT_FALSE(rest.interrupted);
  EXPECT_EQ(csv(folder / "out"), csv(folder / "undisturbed"));
}

TEST(Campaign, progress_counts_up_and_shows_the_last_sample) {
  const TemporaryFolder folder;
  std::vector<int> done;
  run(scenes::small_study(3), folder / "out", {.jobs = 2}, [&](const CampaignProgress& p) {
    done.push_back(p.done);
    EXPECT_EQ(p.total, 3);
    EXPECT_EQ(p.last == nullptr, p.done == 0);
    if (p.last == nullptr) return;
    EXPECT_GT(p.last->responses.peak_reaction, 0);
    EXPECT_GE(p.seconds_left, 0);
  });
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Campaign, an_existing_one_needs_resume) {
  const TemporaryFolder folder;
  run(scenes::small_study(2), folder / "out");
  const std::string said =
      refusal<InputError>([&] { run(scenes::small_study(2), folder / "out"); });
  EXPECT_TRUE(has(said, "holds a campaign already; --resume goes on with it")) << said;
}

TEST(Campaign, resume_refuses_a_changed_study_and_touches_nothing) {
  const TemporaryFolder folder;
  StudySpec changed = scenes::small_study(2);
  run(changed, folder / "out");
  const std::string before = csv(folder / "out");
  changed.variable[0].cov = 0.3;
  const std::string said =
      refusal<InputError>([&] { run(changed, folder / "out", {.resume = true}); });
  EXPECT_TRUE(has(said, "variable.ft.cov: was 0.2 when the campaign began, is 0.3 now")) << said;
  EXPECT_EQ(csv(folder / "out"), before);
  const std::string shard = refusal<InputError>([&] {
    run(scenes::small_study(2), folder / "out", {.resume = true, .shard = 1, .shards = 2});
  });
  EXPECT_TRUE(has(shard, "shard: was 1/1 when the campaign began, is 1/2 now")) << shard;
}

TEST(Campaign, more_samples_become_a_batch_and_leave_the_first_alone) {
  const TemporaryFolder folder;
  run(scenes::small_study(3), folder / "out");
  const std::string first = csv(folder / "out");
  const CampaignOutcome more = run(scenes::small_study(8), folder / "out", {.resume = true});
  EXPECT_EQ(more.done, 8);
  const Campaign campaign = read_campaign(folder / "out");
  EXPECT_EQ(campaign.study.batch, (std::vector<int>{3, 5}));
  EXPECT_EQ(stored_batches(folder / "out"), (std::vector<int>{3, 5}));
  EXPECT_EQ(csv(folder / "out").substr(0, first.size()), first);
  const std::string fewer =
      refusal<InputError>([&] { run(scenes::small_study(4), folder / "out", {.resume = true}); });
  EXPECT_TRUE(has(fewer, "which can only grow; write --samples 8 or more")) << fewer;
}

TEST(Campaign, samples_that_are_not_admissible_are_counted_not_redrawn) {
  const TemporaryFolder folder;
  const StudySpec asked =
      scenes::small_study(8, "distribution = \"normal\"\nmean = \"0.15 MPa\"\ncov = 1.2\n");
  run(asked, folder / "out");
  const Campaign campaign = read_campaign(folder / "out");
  ASSERT_EQ(campaign.records.size(), 8U);
  int refused = 0;
  for (const SampleRecord& record : campaign.records) {
    if (record.inputs[0] >= 0) continue;
    ++refused;
    EXPECT_EQ(record.status, "refused");
    EXPECT_TRUE(has(text_of(record.reason), "tensile_strength")) << record.reason;
  }
  EXPECT_GE(refused, 1);  // a Latin hypercube of 8 has one below the 12.5 % fractile, which is < 0
  EXPECT_TRUE(has(csv(folder / "out"), ",refused,,,,,,,")) << csv(folder / "out");
}

// The wall of two blocks that a blocks file holds: run, then replayed with the file gone.
TEST(Campaign, the_blocks_file_is_in_the_store) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& height) {
    write_text(folder / "blocks.json",
               R"({"units": "m", "thickness": 0.2, "blocks": [)"
               R"({"id": "base", "polygon": [[0, 0], [0.4, 0], [0.4, 0.2], [0, 0.2]]},)"
               R"({"id": "top", "polygon": [[0, 0.2], [0.4, 0.2], [0.4, )" +
                   height + R"(], [0, )" + height + "]]}]}");
  };
  write("0.5");
  StudySpec small = scenes::small_study(2);
  const std::string wall = "[wall]\nblocks = \"blocks.json\"\n[wall.unit]\n";
  std::string model = small.model_text;
  model.replace(0, model.find("density"), wall);
  model.replace(model.find("y = \"0.75 m\""), 12, "y = \"0.4 m\"");
  write_text(folder / "model.toml", model);
  write_text(folder / "study.toml",
             "[study]\nmodel = \"model.toml\"\nsamples = 2\nseed = 1\nread_modes_at = \"0.4 mm\"\n"
             "[variable.ft]\npath = \"material.joint.tensile_strength\"\n"
             "distribution = \"normal\"\nmean = \"0.15 MPa\"\ncov = 0.1\n");
  const StudySpec asked = read_study(folder / "study.toml");
  run(asked, folder / "out");
  const Campaign before = read_campaign(folder / "out");
  ASSERT_EQ(before.records.size(), 2U);
  EXPECT_EQ(before.records[0].status, "completed") << before.records[0].reason;
  write("0.6");  // other blocks are another campaign
  const StudySpec changed = read_study(folder / "study.toml");
  const std::string said =
      refusal<InputError>([&] { run(changed, folder / "out", {.resume = true}); });
  EXPECT_TRUE(has(said, "wall.blocks: holds other blocks")) << said;
  fs::remove(folder / "blocks.json");
  fs::remove(folder / "model.toml");
  const SampleRun again =
      run_sample(before.study, before.samples, 1, model_builder(before.study), {});
  EXPECT_EQ(again.refused, "");
  EXPECT_EQ(again.result.state_hash, before.records[0].state_hash);
}

TEST(Campaign, a_broken_base_model_writes_nothing) {
  const TemporaryFolder folder;
  StudySpec broken = scenes::small_study(2);
  broken.settings = {"wall.thickness=-1 m"};
  EXPECT_TRUE(has(refusal<InputError>([&] { run(broken, folder / "out"); }), "thickness"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(Campaign, two_in_one_folder_are_refused) {
  const TemporaryFolder folder;
  run(scenes::small_study(2), folder / "out");
  const study::FolderLock other(folder / "out");
  const std::string said =
      refusal<IoError>([&] { run(scenes::small_study(2), folder / "out", {.resume = true}); });
  EXPECT_TRUE(has(said, "another campaign is writing there")) << said;
}

TEST(Campaign, the_stop_rule_stops_at_the_same_sample_for_any_jobs) {
  const TemporaryFolder folder;
  StudySpec asked = scenes::small_study(26);
  asked.until = "relative_interval(peak_reaction) < 50 %";
  const CampaignOutcome one = run(asked, folder / "one", {.jobs = 1});
  const CampaignOutcome three = run(asked, folder / "three", {.jobs = 3});
  EXPECT_EQ(one.precise_at, three.precise_at);
  EXPECT_LE(one.precise_at, one.done);
  EXPECT_GE(three.precise_at, kFewestSamples);
  EXPECT_FALSE(one.interrupted);
  EXPECT_FALSE(one.until_state.empty());
  EXPECT_EQ(read_campaign(folder / "one").records.size(), 20U);  // the fewest a rule may stop at
  EXPECT_EQ(csv(folder / "three"), csv(folder / "one"));
  // the same again has nothing to do; without the rule all samples run and all count
  EXPECT_TRUE(run(asked, folder / "one", {.resume = true}).precise_at > 0);
  asked.until.clear();
  const CampaignOutcome all = run(asked, folder / "one", {.resume = true});
  EXPECT_EQ(all.done, 26);
  EXPECT_EQ(read_campaign(folder / "one").records.size(), 26U);
  // a rule asked later never takes away what is there
  asked.until = "relative_interval(peak_reaction) < 50 %";
  EXPECT_TRUE(run(asked, folder / "one", {.resume = true}).precise_at > 0);
  EXPECT_EQ(read_campaign(folder / "one").records.size(), 26U);
}

TEST(Campaign, options_that_make_no_sense_are_refused_before_anything_is_written) {
  const TemporaryFolder folder;
  StudySpec asked = scenes::small_study(2);
  const auto said = [&](CampaignOptions options) {
    return refusal<InputError>([&] { run(asked, folder / "out", options); });
  };
  EXPECT_TRUE(has(said({.shard = 3, .shards = 2}), "--shard: 3/2: is not a shard") ||
              has(said({.shard = 3, .shards = 2}), "3/2: is not a shard"));
  EXPECT_TRUE(has(said({.jobs = -1}), "must not be negative"));
  asked.until = "relative_interval(nothing) < 1 %";
  EXPECT_NE(said({}), "");
  asked.until = "interval(share) < 0.1";
  EXPECT_TRUE(has(said({.shard = 1, .shards = 2}), "can't be judged by a shard"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A limit on the size of files stands for the full disk: SQLite sees a write that fails.
TEST(Campaign, a_full_disk_stops_it_and_loses_nothing) {
  const TemporaryFolder folder;
  const StudySpec asked = scenes::small_study(6);
  run(asked, folder / "undisturbed");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{300'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = refusal<IoError>([&] { run(asked, folder / "out"); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(has(said, "disk")) << said;
  EXPECT_TRUE(has(said, "go on with --resume")) << said;
  const std::size_t kept = read_campaign(folder / "out").records.size();
  EXPECT_GE(kept, 1U);
  EXPECT_LT(kept, 6U);
  run(asked, folder / "out", {.resume = true});
  EXPECT_EQ(csv(folder / "out"), csv(folder / "undisturbed"));
}

// The time of one core: not that of a clock, which runs for the other samples of a lane and of a core too.
TEST(Campaign, times_of_samples_add_up_to_what_the_cores_worked) {
  const TemporaryFolder folder;
  const std::clock_t before = std::clock();
  run(scenes::small_study(16), folder / "out", {.jobs = 16});  // more than there are cores
  const double worked = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  double sum = 0;
  for (const SampleRecord& record : read_campaign(folder / "out").records) {
    EXPECT_GT(record.wall_seconds, 0);
    sum += record.wall_seconds;
  }
  EXPECT_LT(sum, 1.01 * worked);
  EXPECT_GT(sum, 0.3 * worked);  // the rest: reading, drawing, naming of modes, the store
}

// --- one sample: retry --------------------------------------------------------------------------

struct Played {
  StudySpec spec = scenes::small_study(2);
  SampleTable samples = draw_samples(spec);
  ModelBuilder build = model_builder(spec);
  std::vector<double> fractions;  // step fractions that were tried

  // Plays a solver that is unstable above `stable` of the step bound.
  SampleRun run(double stable) {
    const auto solver = [&](const Model& model, State& state, const SolveOptions&) {
      fractions.push_back(model.solve.step_fraction);
      Result result;
      result.status =
          model.solve.step_fraction > stable ? SolveStatus::kUnstable : SolveStatus::kCompleted;
      result.reason = {"stop.budget_spent", {{"steps", 7}}};
      result.state_hash = state_hash(state);
      return result;
    };
    return study::run_task({spec, samples, build}, 1, solver, {});
  }
};

TEST(SampleRun, a_stable_sample_runs_once) {
  Played played;
  const SampleRun run = played.run(1);
  EXPECT_FALSE(run.retried);
  EXPECT_EQ(played.fractions.size(), 1U);
}

TEST(SampleRun, an_unstable_sample_is_tried_again_with_half_the_step) {
  Played played;
  const double usual = played.build({}).solve.step_fraction;
  const SampleRun run = played.run(0.6 * usual);
  EXPECT_TRUE(run.retried);
  EXPECT_EQ(played.fractions, (std::vector<double>{usual, 0.5 * usual}));
  EXPECT_EQ(run.spec.solve.step_fraction, 0.5 * usual);
  const SampleRecord record = study::record_of(run, played.samples, 1);
  EXPECT_EQ(record.status, "completed");
  EXPECT_EQ(record.reason, (Message{"stop.budget_spent", {{"steps", 7}}}));
  EXPECT_TRUE(record.retried);
}

TEST(SampleRun, a_sample_unstable_twice_is_an_outcome) {
  Played played;
  const SampleRun run = played.run(0);
  EXPECT_EQ(played.fractions.size(), 2U);
  const SampleRecord record = study::record_of(run, played.samples, 1);
  EXPECT_EQ(record.status, "unstable");
  EXPECT_EQ(record.reason, (Message{"stop.budget_spent", {{"steps", 7}}}));
  EXPECT_FALSE(record.answered());
}

TEST(ColumnTitle, carries_the_unit_without_signs) {
  const auto title = [](const char* unit) {
    return column_title({.name = "x", .path = "", .si_unit = "", .unit = unit});
  };
  EXPECT_EQ(title("MPa"), "x_MPa");
  EXPECT_EQ(title("GPa/m"), "x_GPa_per_m");
  EXPECT_EQ(title("kg/m^3"), "x_kg_per_m3");
  EXPECT_EQ(title("1"), "x");
}

}  // namespace
}  // namespace wythe::campaign_test
