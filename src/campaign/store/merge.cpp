// merge_campaigns: everything is compared before the first byte is written, then rows are copied. Where two stores
// hold the same sample, every number of it is compared except the time it took (duplicate_samples.h).
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "campaign/store/duplicate_samples.h"
#include "campaign/store/folder_lock.h"
#include "campaign/store/store.h"
#include "campaign/store/store_schema.h"
#include "core/parallel.h"
#include "wythe/parts/error.h"

namespace wythe {
namespace study {
namespace {

// A store that has been read completely before any of it is copied, or the reason why it is refused.
struct Checked {
  std::string folder;
  StudySpec spec;
  StoreHead head;
  std::string inputs_digest;
  SampleTable samples;  // empty where they are those of the first store
  std::set<int> done;
  std::exception_ptr refused;
};

// `first`: a store that was checked before, whose samples this one may share; null if none.
Checked checked(const std::string& folder, const Checked* first) {
  Checked out;
  out.folder = folder;
  try {
    if (!holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
    Store store(folder, Store::Access::kRead);
    out.spec = store.study();
    out.inputs_digest = store.inputs_digest();
    const bool draws_the_same = first != nullptr && out.inputs_digest == first->inputs_digest &&
                                out.spec.batch == first->spec.batch;
    store.check_whole(draws_the_same ? &first->samples : nullptr);
    store.check_states();
    out.head = store.head();
    out.done = store.done();
    if (!draws_the_same) out.samples = store.samples();
  } catch (...) {
    out.refused = std::current_exception();
  }
  return out;
}

class Comparison {
 public:
  // Reads the stores, several at a time. The first one is read alone, because the others are compared with it.
  void add(const std::vector<std::string>& folders) {
    const Checked first = checked(folders.front(), nullptr);
    add(first);
    std::vector<Checked> others(folders.size() - 1);
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const auto n = static_cast<int>(others.size());
    Workers(std::min(cores, n)).for_each_chunk(n, [&](int i) {
      others[i] = checked(folders[i + 1], &first);
    });
    for (const Checked& other : others) add(other);
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
  void add(const Checked& store) {
    if (store.refused) std::rethrow_exception(store.refused);
    if (first_.empty()) {
      first_ = store.folder;
      spec_ = store.spec, samples_ = store.samples, head_ = store.head;
    } else {
      compare(store);
    }
    add_answers(store);
  }

  void compare(const Checked& store) {
    const std::string name = store_path(store.folder).string();
    for (Fault fault : changes(spec_, store.spec, name, "in " + first_)) {
      fault.cure.clear();
      faults_.push_back(std::move(fault));
    }
    const std::size_t both = std::min(store.spec.batch.size(), spec_.batch.size());
    if (!std::equal(store.spec.batch.begin(),
                    store.spec.batch.begin() + static_cast<std::ptrdiff_t>(both),
                    spec_.batch.begin())) {
      faults_.push_back(
          {.file = name,
           .path = "samples",
           .problem = "is not that of " + first_ + ", nor does one go on from the other"});
      return;
    }
    if (!faults_.empty() || store.samples.value.empty()) return;
    const std::size_t shared = std::min(store.samples.value.size(), samples_.value.size());
    if (!std::equal(store.samples.value.begin(),
                    store.samples.value.begin() + static_cast<std::ptrdiff_t>(shared),
                    samples_.value.begin(), same_inputs))
      faults_.push_back({.file = store.folder,
                         .path = "samples",
                         .problem = "other values were drawn than in " + first_});
    else if (store.samples.value.size() > samples_.value.size())
      spec_.batch = store.spec.batch, samples_ = store.samples;
  }

  // Samples that two stores contain must have equal results.
  void add_answers(const Checked& store) {
    std::map<std::string, std::vector<int>> twice;  // by the folder that contained them first
    for (const int sample : store.done) {
      const auto [there, is_new] = folder_of_.emplace(sample, store.folder);
      if (!is_new) twice[there->second].push_back(sample);
    }
    for (const auto& [folder, samples] : twice) {
      SampleRows before(folder), now(store.folder);
      for (const int sample : samples)
        if (const auto difference = SampleRows::difference(now, before, sample))
          refuse_answer(sample, *difference, {folder, before.run(sample)},
                        {store.folder, now.run(sample)});
    }
  }

  using Run = std::pair<std::string, SampleRows::Run>;  // with its folder
  void refuse_answer(int sample, const std::string& difference, const Run& there, const Run& here) {
    const SampleRows::Run &before = there.second, &now = here.second;
    const bool is_run_otherwise =
        before.status != now.status || before.state_hash != now.state_hash;
    const std::string problem =
        is_run_otherwise
            ? fmt::format("{} with state {} here, run by {}; {} with state {} in {}, run by {}",
                          now.status, now.state_hash, now.provenance, before.status,
                          before.state_hash, there.first, before.provenance)
            : fmt::format(
                  "the same state {} as in {}, but other results: one store was changed "
                  "after its run (by {} here, by {} there)",
                  now.state_hash, there.first, now.provenance, before.provenance);
    faults_.push_back({.file = here.first,
                       .path = fmt::format("sample {}", sample),
                       .problem = problem + ": " + difference});
  }

  std::string first_;
  StudySpec spec_;
  SampleTable samples_;
  StoreHead head_;
  std::map<int, std::string> folder_of_;  // for each sample the first folder with it
  std::vector<Fault> faults_;
};

// Reads the rows of a shard, sample by sample.
class Source {
 public:
  explicit Source(const std::string& folder) : store_(folder, Store::Access::kRead) {
    store_.database().execute("PRAGMA cache_size = -256");  // kB: many are open
    store_.database().execute("BEGIN");                     // one lock for all rows
    for (const std::string& table : result_tables())
      rows_.emplace_back(store_.database(),
                         fmt::format("SELECT * FROM {} WHERE sample = ?", table));
  }
  [[nodiscard]] std::set<int> done() { return store_.done(); }
  std::vector<Statement>& rows() { return rows_; }

 private:
  Store store_;
  std::vector<Statement> rows_;  // of each of result_tables()
};

// Copies samples that are not in `out`, in the order of their numbers, so that each page is written once. Returns whether any was copied.
bool copy_samples(Store& out, const std::vector<std::string>& folders) {
  constexpr std::size_t kTogether = 256;  // samples of a transaction
  const std::set<int> there = out.done();
  std::deque<Source> sources;  // a deque, because statements must keep their address
  std::map<int, std::size_t> source_of;
  for (const std::string& folder : folders) {
    Source& source = sources.emplace_back(folder);
    for (const int sample : source.done())
      if (!there.contains(sample)) source_of.emplace(sample, sources.size() - 1);
  }
  if (source_of.empty()) return false;
  Database& database = out.database();
  std::vector<Statement> inserts;
  const std::vector<std::string> tables = result_tables();
  for (std::size_t t = 0; t < tables.size(); ++t)
    inserts.emplace_back(database, insert_sql(tables[t], sources.front().rows()[t].columns()));
  std::optional<Transaction> transaction;
  std::size_t copied = 0;
  for (const auto& [sample, from] : source_of) {
    if (!transaction) transaction.emplace(database);
    for (std::size_t t = 0; t < tables.size(); ++t) {
      Statement& rows = sources[from].rows()[t];
      rows.bind(sample);
      while (rows.step()) {
        inserts[t].bind_row(rows);
        inserts[t].run();
      }
      rows.reset();
    }
    if (++copied % kTogether != 0 && copied < source_of.size()) continue;
    transaction->commit();
    transaction.reset();
  }
  return true;
}

}  // namespace
}  // namespace study

void merge_campaigns(const std::vector<std::string>& folders, const std::string& out) {
  constexpr std::size_t kMostOpen = 200;  // files at once; a process may open 1024
  std::unique_ptr<study::FolderLock> lock;
  study::Comparison comparison;
  const bool there = study::holds_store(out);
  std::vector<std::string> all = folders;
  if (there) {
    lock = std::make_unique<study::FolderLock>(out);
    all.insert(all.begin(), out);
  }
  comparison.add(all);
  comparison.throw_if_any();
  if (!there) {
    lock = std::make_unique<study::FolderLock>(out);
    study::create_store(out, comparison.spec(), comparison.samples(), comparison.head());
  }
  study::Store store(out, study::Store::Access::kWrite);
  store.database().execute("PRAGMA wal_autocheckpoint = 16384");  // pages
  if (const int has = store.samples().n_sample(); comparison.samples().n_sample() > has)
    store.add_samples(comparison.samples(), has + 1, comparison.spec());
  bool is_more = false;
  for (std::size_t i = 0; i < folders.size(); i += kMostOpen)
    is_more |= study::copy_samples(
        store,
        {folders.begin() + static_cast<std::ptrdiff_t>(i),
         folders.begin() + static_cast<std::ptrdiff_t>(std::min(i + kMostOpen, folders.size()))});
  // samples beyond the end of a rule were requested, so all count until --resume gives a rule again
  if (is_more)
    for (const char* key : {"until_met_at", "until_from"})
      if (!store.value(key).empty()) store.set_value(key, "");
}

}  // namespace wythe
