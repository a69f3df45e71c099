// check_campaign reads every byte of a store; rescue_campaign copies what still reads into a new one, sample by
// sample, each looked at again in the copy.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "study/store/folder_lock.h"
#include "study/store/packing.h"
#include "study/store/store.h"
#include "study/store/store_schema.h"
#include "wythe/error.h"

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

// Whether the source has the sample; all its rows are then in `out`, and read as they should.
bool copy_sample(Store& out, const SampleTable& table, int sample) {
  Database& database = out.database();
  Transaction transaction(database);
  for (const std::string& rows : result_tables())
    Statement(database,
              fmt::format("INSERT INTO main.{0} SELECT * FROM damaged.{0} WHERE sample = ?", rows))
        .run(sample);
  const bool is_there = !out.records(table, sample, sample).empty();
  if (!is_there) return false;
  SampleDigests(database).check_states(sample);
  transaction.commit();
  return true;
}

// What each sample drew: as it is stored where its checksum holds, else as the study draws it.
SampleTable trusted_inputs(Store& source) {
  SampleTable table = source.samples(Store::Inputs::kAnyhow);
  if (source.inputs_are_whole()) return table;
  const SampleTable drawn = draw_samples(source.study());
  const std::set<int> stored = source.done();
  for (int sample = 1; sample <= std::min(table.n_sample(), drawn.n_sample()); ++sample) {
    const auto i = static_cast<std::size_t>(sample - 1);
    if (!stored.contains(sample) || !source.is_whole(sample)) table.value[i] = drawn.value[i];
  }
  return table;
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
  if (store.is_current())
    store.check_states();
  else
    study::check_older_states(store.database());
}

Rescue rescue_campaign(const std::string& folder, const std::string& out) {
  study::Store source(folder, study::Store::Access::kRead);
  if (!source.is_current())
    throw IoError(source.database().name() +
                  ": was written by an older wythe; rescue it with that one");
  const SampleTable table = study::trusted_inputs(source);
  if (study::holds_store(out))
    throw InputError({{.file = out,
                       .path = "",
                       .value = "",
                       .problem = "holds a campaign already",
                       .cure = "name another folder for what is rescued"}});
  const study::FolderLock lock(out);
  study::create_store(out, source.study(), table, source.head());
  study::Store store(out, study::Store::Access::kWrite);
  store.database().attach(study::store_path(folder), "damaged");
  Rescue rescue;
  for (int sample = 1; sample <= table.n_sample(); ++sample) {
    try {
      rescue.kept += study::copy_sample(store, table, sample) ? 1 : 0;
    } catch (const IoError& error) {
      rescue.lost.push_back({sample, error.what()});
    }
  }
  store.database().execute("DETACH DATABASE damaged");
  return rescue;
}

}  // namespace wythe
