// merge_campaigns: everything is compared before the first byte is written, then rows are copied. Where two
// stores hold the same sample, every number of it is compared but the time it took.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "core/hash.h"
#include "study/store/folder_lock.h"
#include "study/store/record_rows.h"
#include "study/store/store.h"
#include "study/store/store_schema.h"
#include "wythe/error.h"

namespace wythe {
namespace study {
namespace {

// What a sample answered, enough to see whether two shards contradict each other.
struct Answer {
  std::string status, state_hash, provenance, folder;
  std::uint64_t numbers = 0;  // hash of its row and its curve
};

// Every column of such a table that is a result, in SQL, as one exact text.
std::string results_as_text(Database& database, const char* table) {
  Statement columns(database, fmt::format("SELECT name FROM pragma_table_info('{}')", table));
  std::string text;
  while (columns.step()) {
    const std::string name = columns.text();
    if (name == "wall_seconds" || name == "provenance") continue;
    text += fmt::format("{}quote({})", text.empty() ? "" : " || ' ' || ", name);
  }
  return text;
}

class Comparison {
 public:
  void add(const std::string& folder) {
    if (!holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
    Store store(folder, Store::Access::kRead);
    if (!store.is_current())
      throw IoError(store.database().name() +
                    ": was written by an older wythe; merge with that one, or run it again");
    store.check_whole();  // before a byte of it is copied
    store.check_states();
    const StudySpec spec = store.study();
    if (first_.empty()) {
      first_ = folder;
      spec_ = spec;
      samples_ = store.samples();
      head_ = store.head();
    } else {
      compare(store, spec, folder);
    }
    add_answers(store, folder);
  }
  void throw_if_any() {
    if (faults_.empty()) return;
    faults_.back().cure = "merge only shards of one campaign: same study, samples and seed";
    throw InputError(faults_);
  }
  [[nodiscard]] const StudySpec& spec() const { return spec_; }
  [[nodiscard]] const SampleTable& samples() const { return samples_; }
  [[nodiscard]] StoreHead head() const {
    StoreHead whole = head_;
    whole.shard = "1/1";
    return whole;
  }

 private:
  void compare(Store& store, const StudySpec& spec, const std::string& folder) {
    const std::string& name = store.database().name();
    for (Fault fault : changes(spec_, spec, name, "in " + first_)) {
      fault.cure.clear();
      faults_.push_back(std::move(fault));
    }
    const std::size_t both = std::min(spec.batch.size(), spec_.batch.size());
    if (!std::equal(spec.batch.begin(), spec.batch.begin() + static_cast<std::ptrdiff_t>(both),
                    spec_.batch.begin())) {
      faults_.push_back(
          {.file = name,
           .path = "samples",
           .value = "",
           .problem = "is not that of " + first_ + ", nor does one go on from the other",
           .cure = ""});
      return;
    }
    if (!faults_.empty()) return;
    SampleTable samples = store.samples();
    const std::size_t shared = std::min(samples.value.size(), samples_.value.size());
    if (!std::equal(samples.value.begin(),
                    samples.value.begin() + static_cast<std::ptrdiff_t>(shared),
                    samples_.value.begin()))
      faults_.push_back({.file = folder,
                         .path = "samples",
                         .value = "",
                         .problem = "other values were drawn than in " + first_,
                         .cure = ""});
    else if (samples.value.size() > samples_.value.size())
      spec_.batch = spec.batch, samples_ = std::move(samples);
  }

  void add_answers(Store& store, const std::string& folder) {
    Statement select(
        store.database(),
        fmt::format(
            "SELECT sample, status, state_hash, provenance, {}, (SELECT data FROM curve "
            "WHERE curve.sample = sample.sample), (SELECT group_concat({}, '|') FROM (SELECT * "
            "FROM shake WHERE shake.sample = sample.sample ORDER BY position)) FROM sample",
            results_as_text(store.database(), "sample"),
            results_as_text(store.database(), "shake")));
    while (select.step()) {
      const int sample = static_cast<int>(select.integer());
      Answer answer;
      answer.status = select.text();
      answer.state_hash = select.text();
      answer.provenance = select.text();
      answer.folder = folder;
      Hash numbers;
      numbers.add(select.text());
      numbers.add(select.bytes());
      numbers.add(select.text());
      answer.numbers = numbers.value();
      const auto [there, is_new] = answers_.emplace(sample, answer);
      const Answer& before = there->second;
      if (!is_new && before.numbers != answer.numbers) refuse_answer(sample, before, answer);
    }
  }

  void refuse_answer(int sample, const Answer& before, const Answer& answer) {
    const bool is_run_otherwise =
        before.status != answer.status || before.state_hash != answer.state_hash;
    faults_.push_back(
        {.file = answer.folder,
         .path = fmt::format("sample {}", sample),
         .value = "",
         .problem =
             is_run_otherwise
                 ? fmt::format(
                       "{} with state {} here, run by {}; {} with state {} in {}, run by {}",
                       answer.status, answer.state_hash, answer.provenance, before.status,
                       before.state_hash, before.folder, before.provenance)
                 : fmt::format(
                       "the same state {} as in {}, but other results: one store was changed "
                       "after its run (by {} here, by {} there)",
                       answer.state_hash, before.folder, answer.provenance, before.provenance),
         .cure = ""});
  }

  std::string first_;
  StudySpec spec_;
  SampleTable samples_;
  StoreHead head_;
  std::map<int, Answer> answers_;
  std::vector<Fault> faults_;
};

void copy_rows(Store& out, const std::string& folder) {
  Database& database = out.database();
  database.attach(store_path(folder), "shard");
  {
    Transaction transaction(database);
    std::vector<std::string> tables = result_tables();
    std::reverse(tables.begin(),
                 tables.end());  // `sample` last: whole samples, those not there yet
    for (const std::string& table : tables)
      database.execute(fmt::format(
          "INSERT INTO main.{0} SELECT * FROM shard.{0} WHERE sample NOT IN (SELECT sample FROM "
          "main.sample)",
          table));
    transaction.commit();
  }
  database.execute("DETACH DATABASE shard");
}

}  // namespace
}  // namespace study

void merge_campaigns(const std::vector<std::string>& folders, const std::string& out) {
  std::unique_ptr<study::FolderLock> lock;
  study::Comparison comparison;
  const bool there = study::holds_store(out);
  if (there) {
    lock = std::make_unique<study::FolderLock>(out);
    comparison.add(out);
  }
  for (const std::string& folder : folders) comparison.add(folder);
  comparison.throw_if_any();
  if (!there) {
    lock = std::make_unique<study::FolderLock>(out);
    study::create_store(out, comparison.spec(), comparison.samples(), comparison.head());
  }
  study::Store store(out, study::Store::Access::kWrite);
  if (const int has = store.samples().n_sample(); comparison.samples().n_sample() > has)
    store.add_samples(comparison.samples(), has + 1, comparison.spec());
  for (const std::string& folder : folders) study::copy_rows(store, folder);
}

}  // namespace wythe
