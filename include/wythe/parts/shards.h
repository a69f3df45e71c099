// The shards of a campaign, their stores made together before any of them runs: all have one study and one design
// from then on, whatever becomes of the study file, and can be joined at any time.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/campaign.h"

namespace wythe {

struct ShardStores {
  std::vector<std::string> folders;  // of shard 1, 2, ... of so many
  std::string joined;                // where they will be joined: it may hold a campaign already
  bool may_shrink =
      false;  // fewer samples than are there are not asked for, but the study's own number
};

// The sizes of the designs that all of them will have: those that the largest holds, and what `study` asks beyond.
// Nothing is written. Throws InputError with all that differs from the study, with both values; where fewer samples
// are asked than there are; and where a process writes in one that would have to grow.
[[nodiscard]] std::vector<int> check_shards(const StudySpec& study, const ShardStores& stores);

// Makes the stores that are not there, and grows the others to the design of `study`, which check_shards gave.
void make_shards(const StudySpec& study, const ModelBuilder& build, const ShardStores& stores,
                 const std::string& provenance);

// How many workers run samples in this folder now; 0: none, or it is not known.
[[nodiscard]] int campaign_workers(const std::string& folder);

}  // namespace wythe
