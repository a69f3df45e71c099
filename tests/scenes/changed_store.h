// A store changed by somebody who also updates its checksums, so readers have to find faults without them.
#pragma once

#include <string>
#include <vector>

#include "campaign/store/digest.h"
#include "campaign/store/store.h"

namespace wythe::scenes {

inline void renew_checksums(const std::string& folder) {
  study::Database database(study::store_path(folder), study::Database::Access::kWrite);
  database.execute("PRAGMA synchronous = OFF; DELETE FROM digest");
  std::vector<int> samples;
  for (study::Statement all(database, "SELECT sample FROM sample"); all.step();)
    samples.push_back(static_cast<int>(all.integer()));
  study::SampleDigests digests(database);
  for (const int sample : samples) digests.write(sample);
  study::write_study_digests(database);
}

}  // namespace wythe::scenes
