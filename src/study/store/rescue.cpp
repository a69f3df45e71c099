// check_campaign reads every byte of a store; rescue_campaign copies what still reads into a new one, sample by
// sample, each looked at again in the copy.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/hash.h"
#include "study/campaign/proof.h"
#include "study/store/folder_lock.h"
#include "study/store/packing.h"
#include "study/store/store.h"
#include "study/store/store_schema.h"
#include "study/store/study_rows.h"
#include "wythe/error.h"
#include "wythe/new_folder.h"
#include "wythe/rescue.h"

namespace wythe {
namespace study {
namespace {

// Of a store without checksums of its rows; their frames have one.
void check_older_states(Database& database) {
  Statement select(database, "SELECT sample, label, data FROM state");
  while (select.step()) {
    const auto sample = select.integer();
    const std::string label = select.text();
    check_packed(select.bytes(),
                 fmt::format("{}: state {} of sample {}", database.name(), label, sample));
  }
}

// Samples one by one, from a store that is damaged somewhere into one that is not. What the source refuses is lost with
// its sample; what the target's disk refuses ends the rescue.
class Copier {
 public:
  Copier(Store& from, Store& out, const SampleTable& table)
      : out_(out), table_(table), digests_(out.database()) {
    for (const std::string& rows : result_tables()) {
      tables_.push_back({rows, Statement(from.database(),
                                         fmt::format("SELECT * FROM {} WHERE sample = ?", rows))});
      inserts_.emplace_back(out.database(), insert_sql(rows, tables_.back().second.columns()));
    }
  }

  // Whether the source has the sample; all its rows are then in `out`, and read as they should.
  bool copy(int sample) {
    Transaction transaction(out_.database());
    for (std::size_t t = 0; t < inserts_.size(); ++t) {
      Statement& rows = tables_[t].second;
      rows.reset(), inserts_[t].reset();  // of a sample that was lost before
      rows.bind(sample);
      while (rows.step()) {
        inserts_[t].bind_row(rows);
        inserts_[t].run();
      }
      rows.reset();
    }
    const bool is_there = !out_.records(table_, sample, sample).empty();
    out_.database().give_back();
    if (!is_there) return false;
    digests_.check_states(sample);
    transaction.commit();
    return true;
  }

 private:
  Store& out_;
  const SampleTable& table_;
  SampleDigests digests_;
  std::vector<std::pair<std::string, Statement>> tables_;
  std::vector<Statement> inserts_;
};

// What each sample drew: as it is stored where its checksum holds, else as the study draws it.
SampleTable trusted_inputs(Store& source) {
  SampleTable table;
  try {
    table = source.samples(Store::Inputs::kAnyhow);
    if (source.inputs_are_whole()) return table;
  } catch (const DiskError&) {
    throw;
  } catch (const IoError&) {  // a value is no number, a row is missing
    return draw_samples(source.study());
  }
  const SampleTable drawn = draw_samples(source.study());
  const std::set<int> stored = source.done();
  for (int sample = 1; sample <= std::min(table.n_sample(), drawn.n_sample()); ++sample) {
    const auto i = static_cast<std::size_t>(sample - 1);
    if (!stored.contains(sample) || !source.is_whole(sample)) table.value[i] = drawn.value[i];
  }
  return table;
}

// What a new store begins with, and why samples of the old one do not fit it.
struct Beginning {
  StudySpec spec;
  SampleTable samples;
  StoreHead head;
  std::map<int, std::string> unfit;
  bool knows_shard = true;
  std::vector<int> to_prove{};  // samples
};

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Whether a rescue goes on in `out` with what an earlier one saved there; else it begins.
bool goes_on(const std::string& out, const Beginning& begin) {
  if (!holds_store(out)) return false;
  const auto refuse = [&](const char* problem, const char* cure) {
    throw InputError({{.file = out, .path = "", .value = "", .problem = problem, .cure = cure}});
  };
  Store store(out, Store::Access::kRead);
  if (store.value(kRescuedFrom) != begin.head.rescued_from)
    refuse("holds a campaign already", "name another folder for what is rescued");
  if (std::vector<Fault> faults = changes(store.study(), begin.spec, store.database().name());
      !faults.empty() || store.study().batch != begin.spec.batch) {
    if (faults.empty()) refuse("holds a rescue of another design", "name another folder");
    faults.back().cure = "name another folder for what is rescued now (nothing was written)";
    throw InputError(std::move(faults));
  }
  const std::vector<std::vector<double>> there = store.samples().value;
  if (!std::equal(there.begin(), there.end(), begin.samples.value.begin(),
                  begin.samples.value.end(), same_inputs))
    refuse("holds a rescue with other inputs of the samples",
           "give the study that it was begun with, or name another folder");
  if (store.value("shard") != begin.head.shard)
    refuse("holds a rescue as another shard",
           "give the --shard that it was begun with, or name another folder");
  return true;
}

Store source_of(const std::string& folder) {
  if (!holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
  if (!Store(folder, Store::Access::kRead).is_current())
    throw IoError(store_path(folder).string() +
                  ": was written by an older wythe; rescue it with that one");
  return {folder, Store::Access::kRead};
}

// Where the table does not read as a whole: all that may be in it.
std::vector<int> numbers_of_samples(Database& database, int drawn) {
  std::vector<int> numbers;
  try {
    Statement select(database, "SELECT sample FROM sample ORDER BY sample");
    while (select.step())  // a damaged number is that of no sample
      if (const std::int64_t sample = select.integer();
          sample >= 1 && sample <= std::numeric_limits<int>::max())
        numbers.push_back(static_cast<int>(sample));
  } catch (const DiskError&) {
    throw;
  } catch (const IoError&) {
    numbers.resize(static_cast<std::size_t>(drawn));
    std::iota(numbers.begin(), numbers.end(), 1);
  }
  return numbers;
}

// Why a sample's stored inputs are not what was drawn, bit for bit; "" where they are.
std::string other_inputs(Statement& select, int sample, const SampleTable& drawn) {
  const std::vector<double>& due = drawn.value[static_cast<std::size_t>(sample - 1)];
  std::size_t at = 0;
  select.reset();
  select.bind(sample);
  while (select.step()) {
    static_cast<void>(select.integer());
    const bool is_next = select.integer() == static_cast<std::int64_t>(at);
    const double value = select.number();
    if (at >= due.size())
      return fmt::format("the store has more than the {} inputs of the study", due.size());
    if (!is_next || !is_same(value, due[at]))
      return fmt::format("its input {} is {} in the store, the study draws {}",
                         drawn.column[at].name, value, due[at]);
    ++at;
  }
  return at < due.size() ? "its input " + drawn.column[at].name + " is missing in the store" : "";
}

std::map<int, std::string> not_drawn(Database& database, const SampleTable& drawn) {
  std::map<int, std::string> unfit;
  Statement select(
      database,
      "SELECT sample, position, value FROM sample_input WHERE sample = ? ORDER BY position");
  for (const int sample : numbers_of_samples(database, drawn.n_sample())) {
    if (sample > drawn.n_sample()) {
      unfit[sample] = fmt::format("the study draws {} samples", drawn.n_sample());
      continue;
    }
    try {
      if (const std::string why = other_inputs(select, sample, drawn); !why.empty())
        unfit[sample] = why;
    } catch (const DiskError&) {
      throw;
    } catch (const IoError& error) {
      unfit[sample] = error.what();
    }
  }
  return unfit;
}

// Where the stored study is whole, it says what the study is.
void refuse_another_study(Store& source, const StudySpec& spec) {
  std::optional<StudySpec> stored;
  try {
    stored = source.study();
  } catch (const StudyDamage&) {
    return;
  }
  std::vector<Fault> faults = changes(*stored, spec, source.database().name());
  if (!faults.empty()) throw InputError(std::move(faults));
}

// The sizes of the designs that the store may have: as it says, and as the study is with more added later.
std::vector<std::vector<int>> possible_batches(Store& source, const StudySpec& spec,
                                               std::int64_t drawn) {
  std::vector<std::vector<int>> batches;
  try {
    Rows rows = rows_of(spec);
    for (auto& [key, value] : rows)
      if (key == "samples") value = source.value(key);
    batches.push_back(study_of(rows).batch);
  } catch (const IoError&) {  // that row is damaged too
  } catch (const InputError&) {
  }
  std::vector<int> grown = spec.batch;
  const std::int64_t each =
      count_samples(spec) /
      std::max<std::int64_t>(
          1, std::accumulate(grown.begin(), grown.end(), std::int64_t{0}));  // samples of a wall
  const std::int64_t more = each > 0 ? (drawn - count_samples(spec)) / each : 0;
  if (more > 0 && more <= std::numeric_limits<int>::max()) {
    grown.push_back(static_cast<int>(more));
    batches.push_back(grown);
  }
  return batches;
}

// The design that leaves out the fewest samples.
Beginning by_study(Store& source, const StudySpec& spec) {
  Beginning best{spec, draw_samples(spec), {}, {}};
  best.unfit = not_drawn(source.database(), best.samples);
  std::int64_t drawn = 0;
  try {
    drawn = source.database().integer("SELECT coalesce(max(sample), 0) FROM sample_input");
  } catch (const DiskError&) {
    throw;
  } catch (const IoError&) {  // that table does not read: none but the study's own size
    return best;
  }
  for (std::vector<int>& batch : possible_batches(source, spec, drawn)) {
    StudySpec grown = spec;
    grown.batch = std::move(batch);
    try {
      if (grown.batch == spec.batch || !check_study(grown).empty() || count_samples(grown) != drawn)
        continue;
      Beginning other{grown, draw_samples(grown), {}, {}};
      other.unfit = not_drawn(source.database(), other.samples);
      if (other.unfit.size() < best.unfit.size()) best = std::move(other);
    } catch (const InputError&) {
    }
  }
  return best;
}

// The samples that will be saved: how each of them ended, and no more, for there may be very many.
std::vector<SampleRecord> whole_samples(Store& source, const Beginning& begin,
                                        const std::vector<int>& stored) {
  std::vector<SampleRecord> whole;
  SampleDigests digests(source.database());
  for (const int sample : stored) {
    if (begin.unfit.contains(sample)) continue;
    try {
      digests.check_states(sample);
      for (SampleRecord& record : source.records(begin.samples, sample, sample)) {
        SampleRecord& end = whole.emplace_back();
        end.sample = record.sample, end.steps = record.steps, end.retried = record.retried;
        end.status = std::move(record.status), end.shakes = std::move(record.shakes);
        if (record.has_curve()) end.curve.resize(2);
      }
    } catch (const DiskError&) {
      throw;
    } catch (const IoError&) {  // it will be lost
    }
    source.database().give_back();
  }
  return whole;
}

// The shard that the store names, where all whole samples are in it; else the one that is asked for. Else any may be in it.
void settle_shard(const std::vector<SampleRecord>& whole, const std::string& asked,
                  const std::string& named, Beginning& begin) {
  const auto refuse = [&](const std::string& problem, const char* cure) {
    throw InputError(
        {{.file = "--shard", .path = "", .value = asked, .problem = problem, .cure = cure}});
  };
  const auto outside = [&](const Shard& shard) {
    const auto found = std::find_if(whole.begin(), whole.end(), [&](const SampleRecord& record) {
      return (record.sample - shard.number) % shard.of != 0;
    });
    return found == whole.end() ? 0 : found->sample;
  };
  const std::optional<Shard> stored = shard_of(named), wanted = shard_of(asked);
  const bool fits = stored && outside(*stored) == 0;
  if (!asked.empty()) {
    if (!wanted || wanted->of > begin.samples.n_sample())
      refuse("is no shard of the campaign",
             "write its number and how many there are, e.g. --shard 2/4");
    if (const int sample = outside(*wanted); sample != 0)
      refuse(fmt::format("does not hold sample {}, which is stored", sample),
             "give the shard as the campaign did (nothing was written)");
    if (fits && named != asked)
      refuse(fmt::format("is not what the store says, {}, and its samples are of that", named),
             "leave --shard out (nothing was written)");
  }
  begin.knows_shard = fits || wanted;
  begin.head.shard = !asked.empty() ? asked : fits ? named : "1/1";
}

Beginning begun_by(Store& source, const StudyOfRescue& by) {
  Beginning begin = by_study(source, by.study);
  const std::vector<int> stored = numbers_of_samples(source.database(), begin.samples.n_sample());
  if (!stored.empty() && begin.unfit.size() == stored.size())
    throw InputError(
        {{.file = by.study.file,
          .path = "study",
          .value = "",
          .problem = fmt::format("draws none of the {} samples of {}: of sample {}, {}",
                                 stored.size(), source.database().name(),
                                 begin.unfit.begin()->first, begin.unfit.begin()->second),
          .cure = "name the study file of that campaign, with its --set, --seed and "
                  "--samples (nothing was written)"}});
  begin.head.load_height = load_height_of(compile(by.build({})));
  begin.head.provenance = source.text_or("provenance", "");
  const std::vector<SampleRecord> whole = whole_samples(source, begin, stored);
  settle_shard(whole, by.shard, source.text_or("shard", ""), begin);
  begin.to_prove = samples_to_prove(begin.spec, whole);
  return begin;
}

// Goes on with what an earlier one has saved: it was ended by force or by the disk, or its files were not written.
// `by`: the study is to be proved; NULL: it is the stored one.
Rescue rescued(Store& source, const std::string& folder, const std::string& out, Beginning begin,
               const StudyOfRescue* by) {
  Hash place;
  place.add((std::filesystem::absolute(folder) / "").lexically_normal().string());
  begin.head.rescued_from = place.text();
  static_cast<void>(goes_on(out, begin));  // refuses before the folder is made
  const NewFolder made(out);
  const FolderLock lock(out);
  const bool there = goes_on(out, begin);  // now nobody else begins
  if (by != nullptr) prove_study(folder, out, begin.spec, *by, begin.to_prove);
  Rescue rescue;
  rescue.knows_shard = begin.knows_shard;
  try {
    if (!there) create_store(out, begin.spec, begin.samples, begin.head);
    Store store(out, Store::Access::kWrite);
    const std::set<int> saved = store.done();
    Copier copier(source, store, begin.samples);
    for (int sample = 1; sample <= begin.samples.n_sample(); ++sample) {
      if (by != nullptr && by->stop != nullptr && by->stop->load())
        throw IoError(fmt::format(
            "{}: interrupted; {} samples are saved, the others were not looked at: start the same "
            "rescue again, it goes on",
            out, rescue.kept));
      const auto unfit = begin.unfit.find(sample);
      try {
        if (unfit != begin.unfit.end())
          rescue.lost.push_back({sample, unfit->second});
        else
          rescue.kept += saved.contains(sample) || copier.copy(sample) ? 1 : 0;
      } catch (const DiskError& error) {
        if (error.file() == store.database().name()) throw;
        rescue.lost.push_back({sample, error.reason()});
      } catch (const FileDamage& damage) {
        // seen in the copy, which is the store that is damaged
        rescue.lost.push_back({sample, source.database().name() + ": " + damage.reason()});
      } catch (const IoError& error) {
        rescue.lost.push_back({sample, error.what()});
      }
    }
    for (const auto& [sample, why] : begin.unfit)
      if (sample > begin.samples.n_sample()) rescue.lost.push_back({sample, why});
  } catch (const DiskError& error) {
    if (error.file() != store_path(out).string()) throw;
    throw IoError(
        fmt::format("{}: the disk refused ({}); {} samples are saved, the others were not looked "
                    "at: start the same rescue again "
                    "when there is room, it goes on",
                    error.file(), error.reason(), rescue.kept));
  }
  return rescue;
}

}  // namespace
}  // namespace study

void check_campaign(const std::string& folder) {
  if (!study::holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
  study::Store store(folder, study::Store::Access::kRead);
  study::Statement check(store.database(), "PRAGMA integrity_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok") store.database().damaged(verdict);
  static_cast<void>(store.study());
  static_cast<void>(store.head());
  store.check_whole();
  if (store.has_checksums())
    store.check_states();
  else
    study::check_older_states(store.database());
}

Rescue rescue_campaign(const std::string& folder, const std::string& out) {
  study::Store source = study::source_of(folder);
  try {
    const StudySpec spec = source.study();  // first: what is read of the samples goes by it
    const SampleTable table = study::trusted_inputs(source);
    return study::rescued(source, folder, out, {spec, table, source.head(), {}}, nullptr);
  } catch (const study::StudyDamage& damage) {
    throw IoError(
        fmt::format("{}\nWithout the study no sample of it can be told to be right, so nothing was "
                    "saved. If you have the study file: "
                    "wythe store rescue DIR --out NEW --study FILE takes the study from there, and "
                    "saves what fits it",
                    damage.what()));
  }
}

Rescue rescue_campaign(const std::string& folder, const std::string& out, const StudyOfRescue& by) {
  study::Store source = study::source_of(folder);
  study::refuse_another_study(source, by.study);
  return study::rescued(source, folder, out, study::begun_by(source, by), &by);
}

}  // namespace wythe
