// What is saved of a store whose own study is damaged, by a disk that fills, and by a rescue that was killed.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "scenes/changed_store.h"
#include "scenes/places.h"
#include "scenes/shaken_study.h"
#include "scenes/small_study.h"
#include "study/campaign/proof.h"
#include "study/draws/records.h"
#include "study/store/database.h"
#include "study/store/store.h"
#include "study/store/store_schema.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/rescue.h"

namespace wythe::study {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

template <class Error, class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

class RescueStore : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TemporaryFolder;
    run_campaign(study(), model_builder(study()), *made_ / "out", {.jobs = 1});
  }
  static void TearDownTestSuite() { delete made_; }
  void SetUp() override { put_back(); }

  static StudySpec study() { return scenes::small_study(3); }
  void put_back() {
    fs::remove_all(out_);
    fs::remove_all(saved_);
    fs::create_directories(out_);
    fs::copy_file(store_path(*made_ / "out"), store_path(out_));
  }
  void change(const std::string& sql) {
    Database(store_path(out_), Database::Access::kWrite).execute(sql);
  }
  Rescue by(const StudySpec& spec, const std::string& shard = "") {
    return rescue_campaign(out_, saved_,
                           {.study = spec, .build = model_builder(spec), .shard = shard});
  }

  static TemporaryFolder* made_;
  TemporaryFolder folder_;
  std::string out_ = folder_ / "out", saved_ = folder_ / "saved";
};
TemporaryFolder* RescueStore::made_ = nullptr;

TEST_F(RescueStore, a_damaged_study_does_not_lose_the_samples) {
  for (const char* sql :
       {"UPDATE study SET value = 'x' WHERE key = 'digest'",
        "UPDATE study SET value = 'x' WHERE key = 'digest_inputs'",
        "UPDATE study SET value = 'x' WHERE key = 'digest_schema'",
        "UPDATE study SET value = 'x' WHERE key = 'schema_version'",
        "UPDATE study SET value = '7.5' WHERE key = 'load_height_m'",
        "UPDATE study SET value = 'x' WHERE key = 'shard'",
        "UPDATE study SET value = x'00ff' WHERE key = 'provenance'",
        "UPDATE study SET value = substr(value, 9) WHERE key = 'model'",
        "UPDATE study SET value = '3000000' WHERE key = 'samples'",
        "DELETE FROM study WHERE key = 'seed'", "DELETE FROM study", "DELETE FROM input",
        "UPDATE input SET name = 'fx'", "UPDATE input SET position = position + 1000"}) {
    put_back();
    change(sql);
    const std::string said = refusal<IoError>([&] { (void)rescue_campaign(out_, saved_); });
    if (!has(sql, "digest_inputs")) {
      EXPECT_TRUE(has(said, "wythe store rescue DIR --out NEW --study FILE")) << sql << said;
      EXPECT_FALSE(fs::exists(saved_)) << sql;
    }
    fs::remove_all(saved_);
    const Rescue rescue = by(study());
    EXPECT_EQ(rescue.kept, 3) << sql;
    EXPECT_TRUE(rescue.lost.empty()) << sql << rescue.lost[0].why;
    check_campaign(saved_);
    EXPECT_EQ(samples_csv(read_campaign(saved_)), samples_csv(read_campaign(*made_ / "out")));
    EXPECT_EQ(campaign_progress(saved_).total, 3);
  }
}

TEST_F(RescueStore, what_is_damaged_beside_the_study_is_lost_by_name) {
  change(
      "UPDATE study SET value = 'x' WHERE key = 'digest';"
      "UPDATE sample SET steps = steps + 1 WHERE sample = 2;"
      "UPDATE sample_input SET value = value * 2 WHERE sample = 3");
  const Rescue rescue = by(study());
  EXPECT_EQ(rescue.kept, 1);
  ASSERT_EQ(rescue.lost.size(), 2U);
  EXPECT_TRUE(has(rescue.lost[0].why, "sample 2: its numbers are not what was stored"));
  EXPECT_TRUE(has(rescue.lost[1].why, "its input ft is ")) << rescue.lost[1].why;
}

TEST_F(RescueStore, another_study_is_refused_before_anything_is_written) {
  StudySpec other = study();
  other.seed = 8;
  EXPECT_TRUE(has(refusal<InputError>([&] { (void)by(other); }), "seed: was 7"));
  change("UPDATE study SET value = 'x' WHERE key = 'digest'");  // what is stored proves nothing now
  const std::string said = refusal<InputError>([&] { (void)by(other); });
  EXPECT_TRUE(has(said, "draws none of the 3 samples") && has(said, "of sample 1, its input ft is"))
      << said;
  EXPECT_FALSE(fs::exists(saved_));
}

// Drawn values do not tell one wall from another: some samples are run again, and every number of them has to come out.
TEST_F(RescueStore, another_push_or_wall_is_refused_by_running_it) {
  change("UPDATE study SET value = 'x' WHERE key = 'digest'");
  const std::vector<std::string> others = {
      "stage.push.until = \"0.6 mm\"", "stage.push.velocity = \"3 mm/s\"",
      "stage.push.direction = \"-x\"", "wall.unit.density = \"2300 kg/m^3\""};
  for (const std::string& setting : others) {
    StudySpec other = study();
    other.settings.push_back(setting);
    const std::string said = refusal<InputError>([&] { (void)by(other); });
    EXPECT_TRUE(has(said, "comes out otherwise than it is stored")) << setting << said;
    EXPECT_FALSE(fs::exists(saved_)) << setting;
  }
  StudySpec other = study();  // the same wall and push, but other states are kept
  other.states = {0.3e-3};
  const std::string said = refusal<InputError>([&] { (void)by(other); });
  EXPECT_TRUE(has(said, "comes out otherwise") && has(said, "table ")) << said;
  EXPECT_FALSE(fs::exists(saved_));
  EXPECT_EQ(by(study()).kept, 3);
}

// One of each way to end, the cheapest; a damaged one says nothing, be it in its states alone.
TEST_F(RescueStore, a_sample_of_each_way_to_end_is_run_again) {
  std::vector<SampleRecord> records = read_campaign(out_).records;
  ASSERT_EQ(records.size(), 3U);
  records[0].steps = 30, records[1].steps = 20, records[2].steps = 10;
  const auto of = [&] { return samples_to_prove(study(), records); };
  EXPECT_EQ(of(), std::vector<int>{3});
  records[2].status = "collapsed";
  EXPECT_EQ(of(), (std::vector<int>{2, 3}));
  for (SampleRecord& record : records) record.status = "collapsed";
  EXPECT_EQ(of(), std::vector<int>{3});
  records[2].curve.clear();  // before it was pushed
  EXPECT_EQ(of(), (std::vector<int>{2, 3}));
  for (SampleRecord& record : records) record.steps = 0;
  EXPECT_TRUE(of().empty());

  const int shortest = samples_to_prove(study(), read_campaign(out_).records).front();
  for (const std::string& damage :
       {std::string("UPDATE state SET data = zeroblob(9)"), std::string("DELETE FROM state")}) {
    put_back();
    change("UPDATE study SET value = 'x' WHERE key = 'digest';" + damage +
           " WHERE sample = " + std::to_string(shortest));
    const Rescue rescue = by(study());
    EXPECT_EQ(rescue.kept, 2) << damage;
    ASSERT_EQ(rescue.lost.size(), 1U) << damage;
    EXPECT_EQ(rescue.lost[0].sample, shortest) << damage;
  }

  put_back();
  std::vector<int> proves = {0};
  StudyOfRescue right{.study = study(), .build = model_builder(study())};
  right.proves = [&](const std::vector<int>& samples) { proves = samples; };
  change(
      "UPDATE study SET value = 'x' WHERE key = 'digest';"
      "UPDATE sample SET steps = 1");
  EXPECT_EQ(rescue_campaign(out_, saved_, right).kept, 0);
  EXPECT_TRUE(proves.empty());
}

StudySpec two_records(double second_period) {
  return scenes::shaken_study("measure = \"pga\"\nlevels = [\"2 m/s^2\"]", {0.15, second_period}, 2,
                              "[[limit_state]]\nname = \"rocking\"\npeak_drift = \"2 %\"\n");
}

TEST(ProofOfStudy, has_a_sample_of_each_record) {
  const StudySpec shaken = two_records(0.8);
  const int records = 2, samples = count_samples(shaken);
  ASSERT_EQ(samples, 4);
  std::vector<SampleRecord> all(static_cast<std::size_t>(samples));
  for (int s = 1; s <= samples; ++s) {
    SampleRecord& record = all[static_cast<std::size_t>(s - 1)];
    record.sample = s, record.steps = 1000 - s, record.status = "completed";
  }
  std::set<int> seen;
  for (const int sample : samples_to_prove(shaken, all))
    EXPECT_TRUE(seen.insert(case_of(shaken, sample).record).second);
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(records));

  // so another record is found, whichever it is
  const TemporaryFolder folder;
  run_campaign(shaken, model_builder(shaken), folder / "out", {.jobs = 1});
  Database(store_path(folder / "out"), Database::Access::kWrite)
      .execute("UPDATE study SET value = 'x' WHERE key = 'digest'");
  const auto by = [&](const StudySpec& study) {
    return rescue_campaign(folder / "out", folder / "saved",
                           {.study = study, .build = model_builder(study)});
  };
  const StudySpec other = two_records(0.9);
  EXPECT_TRUE(has(refusal<InputError>([&] { (void)by(other); }), "comes out otherwise"));
  EXPECT_FALSE(fs::exists(folder / "saved"));
  EXPECT_EQ(by(shaken).kept, samples);
}

// What was saved before belongs to the study that it was saved with.
TEST_F(RescueStore, goes_on_with_the_same_study_alone) {
  EXPECT_EQ(rescue_campaign(out_, saved_).kept, 3);
  fs::remove_all(out_);  // another campaign in the same place, which draws the same
  StudySpec other = study();
  other.settings.push_back("wall.unit.density = \"2300 kg/m^3\"");
  run_campaign(other, model_builder(other), out_, {.jobs = 1});
  const std::string said = refusal<InputError>([&] { (void)rescue_campaign(out_, saved_); });
  EXPECT_TRUE(has(said, "2300 kg/m^3") && has(said, "name another folder")) << said;
  EXPECT_EQ(rescue_campaign(out_ + "/", saved_ + "_2").kept, 3);
  EXPECT_EQ(rescue_campaign(out_, saved_ + "_2").kept, 3);  // the same place, written otherwise
}

// Nothing of somebody else's is removed, be it called as the folder of the proof; what a killed proof left is.
TEST_F(RescueStore, the_proof_removes_its_own_folder_alone) {
  change("UPDATE study SET value = 'x' WHERE key = 'digest'");
  fs::create_directories(saved_ + "/.wythe_proof/deep");
  fs::copy(store_path(out_), store_path(saved_ + "/.wythe_proof"));
  const StudyOfRescue from{.study = study(), .build = model_builder(study())};
  for (const std::string& source : {out_, saved_ + "/.wythe_proof"}) {
    EXPECT_TRUE(has(refusal<InputError>([&] { (void)rescue_campaign(source, saved_, from); }),
                    "is in the place where the study is to be proved"));
    EXPECT_TRUE(fs::exists(store_path(saved_ + "/.wythe_proof")));
  }
  fs::create_directories(saved_ + "/.wythe_proof/made_by_rescue");
  EXPECT_EQ(by(study()).kept, 3);
  EXPECT_FALSE(fs::exists(saved_ + "/.wythe_proof"));
}

TEST_F(RescueStore, interrupted_it_saves_nothing_unproved) {
  change("UPDATE study SET value = 'x' WHERE key = 'digest'");
  std::atomic<bool> stop{true};
  const StudyOfRescue by{.study = study(), .build = model_builder(study()), .stop = &stop};
  EXPECT_TRUE(has(refusal<IoError>([&] { (void)rescue_campaign(out_, saved_, by); }),
                  "before the study was proved"));
  EXPECT_FALSE(fs::exists(saved_));
}

// A shard that is put back into its array has to say which it is, also where the store does not any more.
TEST_F(RescueStore, a_shard_stays_one) {
  fs::remove_all(out_);
  run_campaign(study(), model_builder(study()), out_, {.jobs = 1, .shard = 1, .shards = 2});
  const auto damage = [&](const std::string& row) {
    change("UPDATE study SET value = '" + row + "' WHERE key = 'shard'");
    fs::remove_all(saved_);
  };
  for (const char* damaged : {"x", "2/2"}) {  // it holds samples 1 and 3, so it is not the second
    damage(damaged);
    const Rescue unknown = by(study());
    EXPECT_EQ(unknown.kept, 2) << damaged;
    EXPECT_FALSE(unknown.knows_shard) << damaged;
    EXPECT_EQ(campaign_progress(saved_).shards, 1) << damaged;
    EXPECT_TRUE(has(refusal<InputError>([&] { (void)by(study(), "1/2"); }), "as another shard"));
    fs::remove_all(saved_);
    const Rescue known = by(study(), "1/2");
    EXPECT_EQ(known.kept, 2) << damaged;
    EXPECT_TRUE(known.knows_shard) << damaged;
    EXPECT_EQ(campaign_progress(saved_).shards, 2) << damaged;
    EXPECT_EQ(campaign_progress(saved_).total, 2) << damaged;
  }
  damage("x");
  EXPECT_TRUE(
      has(refusal<InputError>([&] { (void)by(study(), "2/2"); }), "does not hold sample 1"));
  for (const char* none : {"2", "1/4", "1/99999999", "0/2"})
    EXPECT_TRUE(has(refusal<InputError>([&] { (void)by(study(), none); }), "is no shard")) << none;
  EXPECT_FALSE(fs::exists(saved_));
  // where the row reads, and the samples are of it, it holds
  change("UPDATE study SET value = '1/2' WHERE key = 'shard'");
  EXPECT_TRUE(
      has(refusal<InputError>([&] { (void)by(study(), "1/1"); }), "what the store says, 1/2"));
  damage("x");
  // a sample that is damaged says nothing of the shard
  change("UPDATE sample SET sample = 2 WHERE sample = 3");
  const Rescue rest = by(study(), "1/2");
  EXPECT_EQ(rest.kept, 1);
  ASSERT_EQ(rest.lost.size(), 1U);
  EXPECT_EQ(rest.lost[0].sample, 2);
}

TEST_F(RescueStore, of_a_design_that_grew_all_batches_are_saved) {
  StudySpec more = study();
  more.batch = {5};
  run_campaign(more, model_builder(more), out_, {.jobs = 1, .resume = true});
  change("UPDATE study SET value = 'x' WHERE key = 'digest'");
  EXPECT_EQ(by(study()).kept, 5);
  EXPECT_EQ(read_campaign(saved_).study.batch, (std::vector<int>{3, 2}));
  fs::remove_all(saved_);
  change("UPDATE study SET value = 'x' WHERE key = 'samples'");  // nor does that say it any more
  EXPECT_EQ(by(study()).kept, 5);
  EXPECT_EQ(read_campaign(saved_).study.batch, (std::vector<int>{3, 2}));
}

// A rescue that was killed has saved some samples; one started again goes on with them. Not one of another store, nor
// with another study.
TEST_F(RescueStore, a_killed_rescue_goes_on) {
  EXPECT_EQ(rescue_campaign(out_, saved_).kept, 3);
  EXPECT_EQ(rescue_campaign(out_, saved_).kept, 3);
  fs::copy(out_, out_ + "_other", fs::copy_options::recursive);
  EXPECT_TRUE(has(refusal<InputError>([&] { (void)rescue_campaign(out_ + "_other", saved_); }),
                  "holds a campaign already"));
  fs::remove_all(out_ + "_other");
  {
    Store store(saved_, Store::Access::kWrite);
    for (const std::string& table : result_tables())
      store.database().execute("DELETE FROM " + table + " WHERE sample > 1");
  }
  EXPECT_EQ(rescue_campaign(out_, saved_).kept, 3);
  check_campaign(saved_);
  EXPECT_EQ(samples_csv(read_campaign(saved_)), samples_csv(read_campaign(out_)));
}

// No file may grow beyond this, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

// No sample is damaged because the disk is full; with more room the same rescue goes on to its end.
TEST_F(RescueStore, a_full_disk_is_not_a_damaged_sample) {
  int refused = 0;
  for (rlim_t room = 64'000; room < 64'000'000; room += room / 4) {
    const SmallDisk disk(room);
    try {
      const Rescue rescue = rescue_campaign(out_, saved_);
      EXPECT_TRUE(rescue.lost.empty()) << rescue.lost[0].why;
      EXPECT_EQ(rescue.kept, 3);
      break;
    } catch (const IoError& error) {
      ++refused;
      EXPECT_TRUE(has(error.what(), saved_)) << error.what();
      EXPECT_TRUE(has(error.what(), "start the same rescue again")) << error.what();
      EXPECT_FALSE(has(error.what(), "damaged")) << error.what();
    }
  }
  EXPECT_GT(refused, 0);
  check_campaign(saved_);
  EXPECT_EQ(samples_csv(read_campaign(saved_)), samples_csv(read_campaign(out_)));
}

}  // namespace
}  // namespace wythe::study
