// merge_campaigns: everything is compared before the first byte is written, then rows are copied.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

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
  std::string status, state_hash, folder;
};

class Comparison {
 public:
  void add(const std::string& folder) {
    if (!holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
    Store store(folder, Store::Access::kRead);
    if (!store.is_current())
      throw IoError(store.database().name() +
                    ": was written by an older wythe; merge with that one, or run it again");
    store.check_whole();  // before a byte of it is copied
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
    if (spec.batch != spec_.batch)
      faults_.push_back({.file = name,
                         .path = "samples",
                         .value = "",
                         .problem = "is not that of " + first_,
                         .cure = ""});
    else if (faults_.empty() && store.samples().value != samples_.value)
      faults_.push_back({.file = folder,
                         .path = "samples",
                         .value = "",
                         .problem = "other values were drawn than in " + first_,
                         .cure = ""});
  }

  void add_answers(Store& store, const std::string& folder) {
    Statement select(store.database(), "SELECT sample, status, state_hash FROM sample");
    while (select.step()) {
      const int sample = static_cast<int>(select.integer());
      Answer answer;
      answer.status = select.text();
      answer.state_hash = select.text();
      answer.folder = folder;
      const auto [there, is_new] = answers_.emplace(sample, answer);
      const Answer& before = there->second;
      if (is_new || (before.status == answer.status && before.state_hash == answer.state_hash))
        continue;
      faults_.push_back({.file = folder,
                         .path = fmt::format("sample {}", sample),
                         .value = "",
                         .problem = fmt::format("{} with state {} here, {} with state {} in {}",
                                                answer.status, answer.state_hash, before.status,
                                                before.state_hash, before.folder),
                         .cure = ""});
    }
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
  Statement(database, "ATTACH DATABASE ? AS shard").run(store_path(folder).string());
  {
    Transaction transaction(database);
    for (const std::string& table : result_tables())
      database.execute(
          fmt::format("INSERT OR IGNORE INTO main.{0} SELECT * FROM shard.{0}", table));
    transaction.commit();
  }
  database.execute("DETACH DATABASE shard");
}

}  // namespace
}  // namespace study

void merge_campaigns(const std::vector<std::string>& folders, const std::string& out) {
  study::Comparison comparison;
  for (const std::string& folder : folders) comparison.add(folder);
  comparison.throw_if_any();
  if (study::holds_store(out))
    throw InputError({{.file = out,
                       .path = "",
                       .value = "",
                       .problem = "holds a campaign already",
                       .cure = "name another folder for the merged one"}});
  const study::FolderLock lock(out);
  study::create_store(out, comparison.spec(), comparison.samples(), comparison.head());
  study::Store store(out, study::Store::Access::kWrite);
  for (const std::string& folder : folders) study::copy_rows(store, folder);
}

}  // namespace wythe
