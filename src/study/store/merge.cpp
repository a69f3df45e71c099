// merge_campaigns: everything is compared before the first byte is written, then rows are copied. Where two
// stores hold the same sample, every number of it is compared but the time it took.
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

#include "core/hash.h"
#include "core/parallel.h"
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
  std::string status, state_hash, provenance;
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

class Answers {
 public:
  explicit Answers(const std::string& folder)
      : store_(folder, Store::Access::kRead),
        select_(store_.database(),
                fmt::format(
                    "SELECT status, state_hash, provenance, {}, (SELECT data FROM curve WHERE "
                    "curve.sample = sample.sample), (SELECT group_concat({}, '|') FROM (SELECT * "
                    "FROM shake WHERE shake.sample = sample.sample ORDER BY position)) FROM sample "
                    "WHERE sample = ?",
                    results_as_text(store_.database(), "sample"),
                    results_as_text(store_.database(), "shake"))) {}

  Answer of(int sample) {
    select_.bind(sample);
    if (!select_.step()) store_.database().damaged(fmt::format("sample {} is missing", sample));
    Answer answer;
    answer.status = select_.text();
    answer.state_hash = select_.text();
    answer.provenance = select_.text();
    Hash numbers;
    numbers.add(select_.text());
    numbers.add(select_.bytes());
    numbers.add(select_.text());
    answer.numbers = numbers.value();
    select_.reset();
    return answer;
  }

 private:
  Store store_;
  Statement select_;
};

// A store that was read through before a byte of it is copied; or why it is not taken.
struct Checked {
  std::string folder;
  StudySpec spec;
  StoreHead head;
  std::string inputs_digest;
  SampleTable samples;  // empty where they are those of the first store
  std::set<int> done;
  std::exception_ptr refused;
};

// `first`: a store that was checked before, whose draws this one may share; NULL: none.
Checked checked(const std::string& folder, const Checked* first) {
  Checked out;
  out.folder = folder;
  try {
    if (!holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
    Store store(folder, Store::Access::kRead);
    if (!store.is_current())
      throw IoError(store.database().name() +
                    ": was written by an older wythe; merge with that one, or run it again");
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
  // Reads them through, several at a time; the first alone, since the others are compared with it.
  void add(const std::vector<std::string>& folders) {
    const Checked first = checked(folders.front(), nullptr);
    add(first);
    std::vector<Checked> others(folders.size() - 1);
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const auto n = static_cast<int>(others.size());
    Workers(std::min(cores, n)).for_each_chunk(n, [&](int i) {
      others[static_cast<std::size_t>(i)] =
          checked(folders[static_cast<std::size_t>(i) + 1], &first);
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
           .value = "",
           .problem = "is not that of " + first_ + ", nor does one go on from the other",
           .cure = ""});
      return;
    }
    if (!faults_.empty() || store.samples.value.empty()) return;
    const std::size_t shared = std::min(store.samples.value.size(), samples_.value.size());
    if (!std::equal(store.samples.value.begin(),
                    store.samples.value.begin() + static_cast<std::ptrdiff_t>(shared),
                    samples_.value.begin()))
      faults_.push_back({.file = store.folder,
                         .path = "samples",
                         .value = "",
                         .problem = "other values were drawn than in " + first_,
                         .cure = ""});
    else if (store.samples.value.size() > samples_.value.size())
      spec_.batch = store.spec.batch, samples_ = store.samples;
  }

  // Samples that two stores hold must answer the same.
  void add_answers(const Checked& store) {
    std::map<std::string, std::vector<int>> twice;  // by the folder that had them before
    for (const int sample : store.done) {
      const auto [there, is_new] = folder_of_.emplace(sample, store.folder);
      if (!is_new) twice[there->second].push_back(sample);
    }
    for (const auto& [folder, samples] : twice) {
      Answers before(folder), now(store.folder);
      for (const int sample : samples) {
        const Answer a = before.of(sample), b = now.of(sample);
        if (a.numbers != b.numbers) refuse_answer(sample, folder, a, store.folder, b);
      }
    }
  }

  void refuse_answer(int sample, const std::string& before_folder, const Answer& before,
                     const std::string& folder, const Answer& answer) {
    const bool is_run_otherwise =
        before.status != answer.status || before.state_hash != answer.state_hash;
    faults_.push_back(
        {.file = folder,
         .path = fmt::format("sample {}", sample),
         .value = "",
         .problem =
             is_run_otherwise
                 ? fmt::format(
                       "{} with state {} here, run by {}; {} with state {} in {}, run by {}",
                       answer.status, answer.state_hash, answer.provenance, before.status,
                       before.state_hash, before_folder, before.provenance)
                 : fmt::format(
                       "the same state {} as in {}, but other results: one store was changed "
                       "after its run (by {} here, by {} there)",
                       answer.state_hash, before_folder, answer.provenance, before.provenance),
         .cure = ""});
  }

  std::string first_;
  StudySpec spec_;
  SampleTable samples_;
  StoreHead head_;
  std::map<int, std::string> folder_of_;  // of each sample the first that holds it
  std::vector<Fault> faults_;
};

// A shard's rows, sample by sample.
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

// Samples that are not in `out` yet, in the order of their numbers, so that each page of it is written once.
void copy_samples(Store& out, const std::vector<std::string>& folders) {
  constexpr std::size_t kTogether = 256;  // samples of a transaction
  const std::set<int> there = out.done();
  std::deque<Source> sources;  // their statements keep where they are
  std::map<int, std::size_t> source_of;
  for (const std::string& folder : folders) {
    Source& source = sources.emplace_back(folder);
    for (const int sample : source.done())
      if (!there.contains(sample)) source_of.emplace(sample, sources.size() - 1);
  }
  if (source_of.empty()) return;
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
  for (std::size_t i = 0; i < folders.size(); i += kMostOpen)
    study::copy_samples(
        store,
        {folders.begin() + static_cast<std::ptrdiff_t>(i),
         folders.begin() + static_cast<std::ptrdiff_t>(std::min(i + kMostOpen, folders.size()))});
}

}  // namespace wythe
