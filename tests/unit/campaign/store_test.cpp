// The store: exact rows, packed arrays, and every way a file can be wrong.
#include "campaign/store/store.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include "campaign/runner/handed_sample.h"
#include "campaign/store/folder_lock.h"
#include "campaign/store/packing.h"
#include "campaign/store/record_rows.h"
#include "campaign/store/store_schema.h"
#include "core/hash.h"
#include "core/messages.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/stored_states.h"

namespace wythe::study::store_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The message of an IoError; "" if nothing was thrown.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

SampleTable two_samples() {
  SampleTable table;
  table.column = {{.name = "ft",
                   .path = "material.joint.tensile_strength",
                   .si_unit = "Pa",
                   .unit = "MPa",
                   .to_unit = 1e-6},
                  {.name = "c",
                   .path = "material.joint.cohesion",
                   .si_unit = "Pa",
                   .unit = "MPa",
                   .to_unit = 1e-6,
                   .is_random = false}};
  table.value = {{0.1 + 0.2, 2e10}, {1.0 / 3.0, 1e10}};
  table.cut_off = {0.0125};
  return table;
}

std::vector<CurveRow> curve(std::size_t rows) {
  std::vector<CurveRow> all(rows);
  double x = 0;
  for (CurveRow& r : all)
    for (const CurveColumn& column : kCurveColumns) r.*column.value = std::sin(x += 1);
  return all;
}

Evidence evidence(const std::string& element) { return {element, "slip", 0.1, 1.0 / 3, "mm"}; }

// Every member differs from its default, so that one that is lost shows.
SampleRecord full_record(int sample) {
  SampleRecord r;
  r.sample = sample;
  r.inputs = two_samples().value[sample - 1];
  r.status = "completed";
  r.reason = as_text("because, \"quoted\"");
  r.retried = true;
  r.responses.peak_reaction = 0.1 + 0.2;
  r.responses.censored_80 = false;
  r.responses.falls = {{0.5, 1.0 / 3, 0.01, false, 0.3, false, 0.4, false},
                       {0.8, 0.2, 0.02, true, 0.1, false, 0.25, true}};
  r.responses.bilinear.ductility = 3.7;
  r.responses.collapse = {0.04, 0.013, false, as_text("a block fell")};
  r.failure_mode.name = "FM-3";
  r.failure_mode.scores = {{"FM-1", 0.25}, {"FM-3", 0.75}};
  r.failure_mode.evidence = {evidence("left pier"), evidence("spandrel")};
  r.failure_mode.flags = {evidence("right pier")};
  r.failure_mode.sentence = as_text("words");
  r.failure_mode.read_at = 0.04;
  ElementState element{"left pier", "pier", "rocking", {}, 0.01};
  element.signs = {{"rocking", "rise of the heel", 2, 1, "mm", 0.01},
                   {"sliding", "slip", 0.1, 1, "mm", kNan}};
  r.failure_mode.elements = {element, {"spandrel", "spandrel", "intact", {}, kNan}};
  r.failure_mode.sensitivity = {{"unclear", "20 mm", 0.02, "crack width", 0.75}};
  r.features = {{"left_pier_slip", 0.01, 0.123}};
  r.events = {{{"event.first_crack"}, 0.001, 2e4, as_text("bed joint at (0, 0) m")}};
  r.energy.fracture = 12.5;
  r.quasi_static.verdict = {"rate.slow_enough", {{"lift_percent", 1.5}}};
  r.curve = curve(7);
  r.steps = 123456789012;
  r.time_step = 1e-5;
  r.wall_seconds = 2.5;
  r.state_hash = "0123456789abcdef";
  r.provenance = "this program";
  return r;
}

// Names and values of all members, for comparison and for readable differences.
struct Told {
  std::vector<std::string> all;
  void operator()(const char* name, double v) { all.push_back(std::string(name) + hex(v)); }
  void operator()(const char* name, std::int64_t v) {
    all.push_back(name + (" " + std::to_string(v)));
  }
  void operator()(const char* name, bool v) { all.push_back(name + std::string(v ? " 1" : " 0")); }
  void operator()(const char* name, const std::string& v) { all.push_back(name + (" " + v)); }
  void operator()(const char* name, const Message& v) {
    all.push_back(name + (" " + text_of(v) + message_json(v)));
  }
  static std::string hex(double v) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), " %a", v);
    return text.data();
  }
};
struct ToldLists {
  Told& told;
  const RecordLists& lists;
  template <class Member, class Columns>
  void list(const char* table, std::vector<Member> RecordLists::*which, const Columns& columns) {
    for (const Member& member : lists.*which) {
      told.all.emplace_back(table);
      columns(told, member);
    }
  }
};
std::vector<std::string> told(const SampleRecord& record) {
  Told t;
  t("sample", static_cast<std::int64_t>(record.sample));
  for (const double x : record.inputs) t("input", x);
  each_column(t, record);
  each_output(t, record);
  const RecordLists lists = lists_of(record);
  ToldLists all{t, lists};
  each_list(all);
  for (const double x : curve_columns(record.curve)) t("curve", x);
  return t.all;
}

State random_state(std::size_t blocks, std::size_t points) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  State s;
  for (auto* a : {&s.ux, &s.uy, &s.theta, &s.vx, &s.vy, &s.omega}) a->assign(blocks, 0.0);
  for (auto* a : {&s.kappa, &s.crush, &s.plastic_slip, &s.slip, &s.shear_damage, &s.tension_set})
    a->assign(points, 0.0);
  for (auto* a : {&s.ux, &s.uy, &s.theta, &s.kappa, &s.crush, &s.plastic_slip, &s.slip,
                  &s.shear_damage, &s.tension_set})
    for (double& x : *a) x = any(random);
  return s;
}

class StoreFile : public testing::Test {
 protected:
  void SetUp() override {
    create_store(out_, scenes::small_study(2), two_samples(), {"1/1", "this program", 0.75});
  }
  [[nodiscard]] std::string read_refusal() const {
    return refusal([&] { static_cast<void>(read_campaign(out_)); });
  }
  [[nodiscard]] std::string name() const { return store_path(out_).string(); }

  TemporaryFolder folder_;
  std::string out_ = folder_ / "out";
};

TEST(Packing, doubles_come_back_to_the_bit) {
  const std::vector<double> numbers = {
      0.1, -0.0, 1e-310, std::numeric_limits<double>::infinity(), kNan, -1.0 / 3};
  const std::vector<double> back = unpack_doubles(pack_doubles(numbers), numbers.size(), "x");
  ASSERT_EQ(back.size(), numbers.size());
  EXPECT_EQ(std::memcmp(back.data(), numbers.data(), sizeof(double) * numbers.size()), 0);
}

TEST(Packing, floats_keep_seven_digits) {
  const std::vector<double> numbers = {0.04, -1.0 / 3, 0};
  const std::vector<double> back = unpack_floats(pack_floats(numbers), numbers.size(), "x");
  // float32 rounds by at most 2^-24 of the value
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_LE(std::fabs(back[i] - numbers[i]), std::ldexp(std::fabs(numbers[i]), -24));
}

TEST(Packing, damaged_bytes_are_refused_by_name) {
  std::string bytes = pack_doubles(std::vector<double>(100, 0.7));
  bytes[bytes.size() - 2] ^= 1;  // in the checksum
  EXPECT_TRUE(has(refusal([&] { (void)unpack_doubles(bytes, 100, "the curve of sample 4"); }),
                  "the curve of sample 4 is damaged"));
  const std::string short_one = pack_doubles(std::vector<double>(99, 0.7));
  EXPECT_TRUE(has(refusal([&] { (void)unpack_doubles(short_one, 100, "x"); }), "damaged"));
}

TEST(StudyRows, a_study_comes_back) {
  StudySpec s = scenes::small_study(12);
  s.seed = 0xfedcba9876543210ULL;
  s.batch = {12, 30};
  s.settings = {"stage.push.velocity=1 mm/s", "output.rows=50"};
  s.until = "share < 0.1";
  s.fractions = {0.8, 0.5, 1.0 / 3};
  s.variable[0].lower = 1.0 / 3;
  VariableSpec measured;
  measured.name = "m";
  measured.si_unit = "1";
  measured.distribution = DistributionKind::kEmpirical;
  measured.values = {0.1, 0.2 + 0.1, 5};
  s.variable.push_back(measured);
  s.correlation = {{"ft", "m", -0.3, true}};
  s.design = Design::kSobol;
  const StudySpec back = study_of(rows_of(s));
  EXPECT_EQ(rows_of(back), rows_of(s));
  EXPECT_EQ(back.seed, s.seed);
  EXPECT_EQ(back.batch, s.batch);
  EXPECT_EQ(back.settings, s.settings);
  EXPECT_EQ(back.fractions, s.fractions);
  EXPECT_EQ(back.states, s.states);
  EXPECT_EQ(back.read_modes_at, s.read_modes_at);
  EXPECT_EQ(back.model_text, s.model_text);
  EXPECT_EQ(back.design, Design::kSobol);
  ASSERT_EQ(back.variable.size(), 2U);
  EXPECT_EQ(back.variable[0].cov, s.variable[0].cov);
  EXPECT_EQ(back.variable[0].mean, s.variable[0].mean);
  EXPECT_EQ(back.variable[0].lower, s.variable[0].lower);
  EXPECT_TRUE(std::isnan(back.variable[0].upper));
  EXPECT_EQ(back.variable[1].values, measured.values);
  ASSERT_EQ(back.correlation.size(), 1U);
  EXPECT_TRUE(back.correlation[0].rank);
  EXPECT_EQ(back.correlation[0].value, -0.3);
  EXPECT_EQ(back.dependent[0].formula, s.dependent[0].formula);
}

TEST(StudyRows, words_are_tied_to_values_not_to_their_order) {
  const std::pair<Design, const char*> designs[] = {{Design::kLatinHypercube, "latin_hypercube"},
                                                    {Design::kMonteCarlo, "monte_carlo"},
                                                    {Design::kSobol, "sobol"}};
  for (const auto& [design, word] : designs) {
    StudySpec s = scenes::small_study(12);
    s.design = design;
    EXPECT_EQ(value_of(rows_of(s), "design"), word);
    EXPECT_EQ(study_of(rows_of(s)).design, design);
  }
  for (const Word<DistributionKind>& kind : kDistributionWords) {
    StudySpec s = scenes::small_study(12);
    s.variable[0].distribution = kind.value;
    EXPECT_EQ(value_of(rows_of(s), "variable.ft.distribution"), kind.word);
    EXPECT_EQ(study_of(rows_of(s)).variable[0].distribution, kind.value);
  }
  constexpr Word<Design> twice[] = {
      {"a", Design::kSobol}, {"b", Design::kSobol}, {"c", Design::kMonteCarlo}};
  static_assert(!names_all(twice));
  constexpr Word<Design> turned[] = {
      {"c", Design::kSobol}, {"a", Design::kLatinHypercube}, {"b", Design::kMonteCarlo}};
  static_assert(names_all(turned));
  constexpr Word<Design> one_short[] = {{"c", Design::kSobol}, {"a", Design::kLatinHypercube}};
  static_assert(!names_all(one_short));
  constexpr Word<Design> alike[] = {
      {"a", Design::kSobol}, {"a", Design::kLatinHypercube}, {"b", Design::kMonteCarlo}};
  static_assert(!names_all(alike));
}

TEST(StudyRows, changes_name_the_key_and_both_values) {
  const StudySpec was = scenes::small_study(12);
  StudySpec is = was;
  is.name = "another name";
  is.batch = {30};
  is.until = "share < 0.1";
  is.model_text = "# a comment\n\n  " + was.model_text;
  EXPECT_TRUE(changes(was, is, "db").empty());
  EXPECT_EQ(identity_of(was), identity_of(is));
  is.variable[0].cov = 0.25;
  EXPECT_NE(identity_of(was), identity_of(is));
  is.settings = {"output.rows=50"};
  is.model_text.replace(is.model_text.find("\"0.5 mm\""), 8, "\"0.6 mm\"");
  const std::vector<Fault> faults = changes(was, is, "db");
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(faults[0].path, "variable.ft.cov");
  EXPECT_TRUE(has(faults[0].problem, "was 0.2 when the campaign began, is 0.25 now"));
  EXPECT_EQ(faults[1].path, "settings");
  EXPECT_TRUE(has(faults[1].problem, "was not given"));
  EXPECT_EQ(faults[2].value, "until = \"0.5 mm\"");
  EXPECT_EQ(faults[3].value, "until = \"0.6 mm\"");
  EXPECT_FALSE(faults[3].cure.empty());
}

TEST(StudyRows, settings_in_another_order_are_the_same) {
  StudySpec was = scenes::small_study(12), is = was;
  was.settings = {"output.rows=50", "solve.damping = 0.7"};
  is.settings = {"solve.damping=0.7", "output.rows=40", "output.rows=50"};  // the last one counts
  EXPECT_TRUE(changes(was, is, "db").empty());
  EXPECT_EQ(identity_of(was), identity_of(is));
  is.settings = {"solve.damping=0.7", "output.rows=50", "output.rows=40"};
  EXPECT_EQ(changes(was, is, "db").size(), 1U);
  EXPECT_NE(identity_of(was), identity_of(is));
}

TEST(StudyRows, other_blocks_are_a_change_told_in_words) {
  StudySpec was = scenes::small_study(12), is = was;
  was.blocks_text = R"({"blocks": [1]})", is.blocks_text = R"({"blocks": [2]})";
  const std::vector<Fault> faults = changes(was, is, "db");
  EXPECT_NE(identity_of(was), identity_of(is));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "wall.blocks");
}

TEST_F(StoreFile, says_nothing_of_the_folders_it_was_made_in) {
  StudySpec spec = scenes::small_study(2);
  spec.file = "/somewhere/private/study.toml", spec.model_file = "/somewhere/private/model.toml";
  create_store(folder_ / "other", spec, two_samples(), {"1/1", "this program", 0.75});
  const StudySpec back = read_campaign(folder_ / "other").study;
  EXPECT_EQ(back.file, "study.toml");
  EXPECT_EQ(back.model_file, "model.toml");
}

TEST_F(StoreFile, a_sample_comes_back_whole) {
  {
    Store store(out_, Store::Access::kWrite);
    store.write(packed(full_record(2), {}));
    store.write(packed(full_record(1), {}));
  }
  const Campaign campaign = read_campaign(out_);
  ASSERT_EQ(campaign.records.size(), 2U);
  EXPECT_EQ(told(campaign.records[0]), told(full_record(1)));
  EXPECT_EQ(told(campaign.records[1]), told(full_record(2)));
  EXPECT_EQ(campaign.samples.value, two_samples().value);
  EXPECT_EQ(campaign.samples.cut_off, two_samples().cut_off);
  EXPECT_EQ(campaign.samples.column[1].unit, "MPa");
  EXPECT_FALSE(campaign.samples.column[1].is_random);
  EXPECT_EQ(campaign.load_height, 0.75);
  EXPECT_EQ(campaign.provenance, "this program");
  EXPECT_EQ(rows_of(campaign.study), rows_of(scenes::small_study(2)));
}

TEST(HandedSample, comes_back_as_a_store_gives_it_and_nothing_else_is_read) {
  const StudySpec study = scenes::small_study(2);
  const SampleTable samples = two_samples();
  const std::string text = handed_text(study, samples, full_record(1));
  EXPECT_EQ(told(handed_record(study, samples, 1, text)), told(full_record(1)));
  const auto refused = [&](const StudySpec& of, int sample, const std::string& given) {
    EXPECT_THROW(static_cast<void>(handed_record(of, samples, sample, given)), InputError);
  };
  for (std::size_t at = 0; at < text.size(); at += 97) {
    std::string damaged = text;
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    refused(study, 1, damaged);
    refused(study, 1, text.substr(0, at));
  }
  refused(study, 2, text);
  StudySpec other = study;
  other.settings.emplace_back("wall.thickness=0.3 m");
  refused(other, 1, text);
}

TEST(HandedSample, has_no_numbers_without_an_answer) {
  SampleRecord failed = full_record(1);
  failed.status = "not_settled";
  const StudySpec study = scenes::small_study(2);
  const std::string text = handed_text(study, two_samples(), failed);
  const SampleRecord back = handed_record(study, two_samples(), 1, text);
  EXPECT_EQ(back.responses.peak_reaction, 0);
  EXPECT_EQ(back.reason, failed.reason);
  EXPECT_TRUE(back.failure_mode.scores.empty());
}

TEST_F(StoreFile, a_sample_without_answer_has_no_numbers) {
  SampleRecord failed = full_record(1);
  failed.status = "not_settled";
  Store store(out_, Store::Access::kWrite);
  store.write(packed(failed, {}));
  EXPECT_EQ(store.database().integer(
                "SELECT count(*) FROM samples WHERE peak_reaction_kN IS NULL AND failure_mode IS "
                "NULL AND status = 'not_settled'"),
            1);
  const SampleRecord back = store.records(2).at(0);
  EXPECT_EQ(back.responses.peak_reaction, 0);
  EXPECT_EQ(back.reason, failed.reason);
  EXPECT_TRUE(back.failure_mode.scores.empty());
}

TEST_F(StoreFile, states_come_back_at_rest_and_rounded) {
  const ModelBuilder build = model_builder(scenes::small_study(2));
  const Model model = compile(build({}));
  const std::size_t blocks = initial_state(model).ux.size(),
                    points = initial_state(model).kappa.size();
  const State state = random_state(blocks, points);
  {
    Store store(out_, Store::Access::kWrite);
    store.write(packed(full_record(1), {{"10 mm", 0.01, 1e5, state}, {"end", 0.02, 2e5, state}}));
  }
  const std::vector<Snapshot> states = read_states(out_, 1, model);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].label, "10 mm");
  EXPECT_EQ(states[1].reaction, 2e5);
  EXPECT_EQ(states[0].state.vx, std::vector<double>(blocks, 0.0));
  for (std::size_t i = 0; i < points; ++i) {
    EXPECT_FLOAT_EQ(static_cast<float>(states[0].state.crush[i]),
                    static_cast<float>(state.crush[i]));
    EXPECT_FLOAT_EQ(static_cast<float>(states[0].state.tension_set[i]),
                    static_cast<float>(state.tension_set[i]));
  }
  EXPECT_TRUE(read_states(out_, 2, model).empty());
}

TEST_F(StoreFile, a_store_that_stays_open_gives_the_same_states) {
  const Model model = compile(model_builder(scenes::small_study(2))({}));
  const State state =
      random_state(initial_state(model).ux.size(), initial_state(model).kappa.size());
  {
    Store store(out_, Store::Access::kWrite);
    store.write(packed(full_record(1), {{"10 mm", 0.01, 1e5, state}}));
  }
  StoredStates stored(out_);
  const std::vector<Snapshot> alone = read_states(out_, 1, model);
  for (int again = 0; again < 2; ++again) {
    const std::vector<Snapshot> states = stored.of(1, model);
    ASSERT_EQ(states.size(), 1U);
    EXPECT_EQ(states[0].state.ux, alone[0].state.ux);
    EXPECT_EQ(states[0].state.tension_set, alone[0].state.tension_set);
    EXPECT_TRUE(stored.of(2, model).empty());
  }
  {  // what is stored meanwhile is seen, as by an opening of its own
    Store store(out_, Store::Access::kWrite);
    store.write(packed(full_record(2), {{"10 mm", 0.01, 1e5, state}}));
  }
  EXPECT_EQ(stored.of(2, model).size(), 1U);
  EXPECT_THROW(StoredStates(out_ + "/none"), InputError);
}

// Numbers nobody can compress: the tuff wall's 852 blocks and 2600 joints, three states, 500 rows.
TEST_F(StoreFile, a_campaign_of_250_stays_within_150_MB) {
  const State state = random_state(852, 5200);
  SampleRecord record = full_record(1);
  record.curve = curve(500);
  const PackedSample sample = packed(
      record, {{"10 mm", 0.01, 0, state}, {"20 mm", 0.02, 0, state}, {"40 mm", 0.04, 0, state}});
  {
    Store store(out_, Store::Access::kWrite);
    store.write(sample);
  }
  EXPECT_LT(250.0 * static_cast<double>(fs::file_size(name())), 150e6);
}

TEST_F(StoreFile, a_transaction_that_fails_leaves_nothing) {
  Store store(out_, Store::Access::kWrite);
  store.write(packed(full_record(1), {}));
  // the same sample again breaks a rule of the schema in the middle of the transaction
  EXPECT_NE(refusal([&] { store.write(packed(full_record(1), {})); }), "");
  EXPECT_EQ(told(store.records(2).at(0)), told(full_record(1)));
  store.write(packed(full_record(2), {}));
  EXPECT_EQ(store.done(), (std::set<int>{1, 2}));
}

TEST_F(StoreFile, a_full_disk_says_so_and_loses_nothing) {
  Store store(out_, Store::Access::kWrite);
  store.write(packed(full_record(1), {}));
  const std::int64_t pages = store.database().integer("PRAGMA page_count");
  static_cast<void>(
      store.database().integer("PRAGMA max_page_count = " + std::to_string(pages + 3)));
  const State state = random_state(852, 5200);
  const std::string said = refusal([&] {
    store.write(packed(full_record(2), {{"10 mm", 0.01, 0, state}}));
  });
  EXPECT_TRUE(has(said, "the disk is full")) << said;
  EXPECT_TRUE(has(said, "--resume")) << said;
  EXPECT_EQ(told(store.records(2).at(0)), told(full_record(1)));
  EXPECT_EQ(store.done(), std::set<int>{1});
}

TEST_F(StoreFile, a_locked_store_says_who_to_look_for) {
  Database other(name(), Database::Access::kWrite);
  other.execute("BEGIN IMMEDIATE");
  Store store(out_, Store::Access::kWrite);
  const std::string said = refusal([&] { store.write(packed(full_record(1), {})); });
  EXPECT_TRUE(has(said, name())) << said;
  EXPECT_TRUE(has(said, "locked by another program")) << said;
  other.execute("ROLLBACK");
  EXPECT_EQ(refusal([&] { store.write(packed(full_record(1), {})); }), "");
}

TEST_F(StoreFile, another_campaign_in_the_folder_is_named) {
  const FolderLock first(out_);
  const std::string said = refusal([&] { const FolderLock second(out_); });
  EXPECT_TRUE(has(said, "another campaign is writing there (process ")) << said;
}

TEST_F(StoreFile, a_lock_ends_with_its_holder) {
  { const FolderLock first(out_); }
  EXPECT_FALSE(fs::exists(out_ + "/campaign.lock"));
  EXPECT_EQ(refusal([&] { const FolderLock second(out_); }), "");
}

TEST_F(StoreFile, a_store_of_another_version_is_refused) {
  for (const char* other : {"0", "2", "7", "99"}) {
    Database(name(), Database::Access::kWrite)
        .execute(std::string("PRAGMA user_version = ") + other);
    const std::string said = read_refusal();
    EXPECT_TRUE(has(said, std::string("has store version ") + other + ", and this wythe reads"))
        << said;
    EXPECT_TRUE(has(said, "writes version 1; use the wythe that wrote it, or run")) << said;
  }
}

TEST_F(StoreFile, another_sqlite_file_is_refused) {
  Database(name(), Database::Access::kWrite).execute("PRAGMA application_id = 5");
  EXPECT_TRUE(has(read_refusal(), "not a campaign of wythe")) << read_refusal();
}

TEST_F(StoreFile, a_file_that_is_no_database_is_refused) {
  fs::resize_file(name(), 0);
  std::ofstream(name()) << "time_s,displacement_mm\n" << std::string(5000, 'x');
  EXPECT_TRUE(has(read_refusal(), "is not a campaign store, or its first bytes are damaged"))
      << read_refusal();
}

TEST_F(StoreFile, a_truncated_file_is_refused_as_damaged) {
  {
    Store store(out_, Store::Access::kWrite);
    store.write(packed(full_record(1), {{"10 mm", 0.01, 0, random_state(852, 5200)}}));
  }
  fs::resize_file(name(), fs::file_size(name()) / 2);
  const std::string said = refusal([&] {
    Store store(out_, Store::Access::kWrite);
    store.check_whole();
  });
  EXPECT_TRUE(has(said, "is damaged")) << said;
  EXPECT_TRUE(has(said, "restore it from a copy")) << said;
}

TEST(Store, an_empty_folder_holds_none) {
  const TemporaryFolder folder;
  EXPECT_FALSE(holds_campaign(folder / "out"));
  try {
    (void)read_campaign(folder / "out");
    FAIL() << "read what is not there";
  } catch (const InputError& error) {
    EXPECT_TRUE(has(error.what(), "holds no campaign")) << error.what();
  }
}

TEST(Store, a_folder_that_cannot_be_made_is_an_io_error) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  const std::string said = refusal(
      [&] { create_store(folder / "file/out", scenes::small_study(2), two_samples(), {}); });
  EXPECT_TRUE(has(said, "cannot be made")) << said;
}

// Who changes a table has to raise the version, since another program would call the new store damaged. A response is
// an exception: its column has the name of its line in responses.h, and a store that lacks it is refused as one of
// another program (check_tables). So the tables are compared without the columns of responses.
TEST(StoreSchema, a_version_belongs_to_its_tables) {
  std::string tables = schema_sql(), view = samples_view_sql(two_samples());
  const auto remove = [](std::string& text, const std::string& begin, const std::string& ends) {
    const std::size_t from = text.find(begin);
    ASSERT_NE(from, std::string::npos) << begin;
    text.erase(from, text.find_first_of(ends, from + begin.size()) - from);
  };
  const auto leave_out = [&](const OutputKey& key, const auto&) {
    remove(tables, std::string(", ") + key.stored + " ", ",)");
    if (key.listed != OutputKey::kNowhere)
      remove(view, std::string(", ") + key.stored + " ", ",\n");
  };
  const SampleRecord any;
  each_response(leave_out, any.responses);
  each_quasi_static(leave_out, any.quasi_static);
  Hash hash;
  hash.add(tables);
  hash.add(view);
  EXPECT_EQ(kSchemaVersion, 1);
  EXPECT_EQ(hash.text(), "5fca656866ef6c8b")
      << "the tables of a store have changed: raise kSchemaVersion";
}

}  // namespace
}  // namespace wythe::study::store_test
