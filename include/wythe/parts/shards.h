// The shards of a campaign. Their stores are created together before any shard runs, so that all have one study and one
// design. They can be merged at any time, even if the study file changes later.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/campaign.h"

namespace wythe {

struct ShardStores {
  std::vector<std::string> folders;  // of the shards 1, 2, ...
  std::string joined;                // folder of the merged campaign; may hold one already
  bool may_shrink =
      false;  // accept fewer samples than the stores hold: the number is the study's own
};

// The designs that all stores will have: those of the largest store, and the samples that `study` adds. Nothing is
// written. Throws InputError with every difference from the study, with both values; where fewer samples are
// requested than exist; and where a process writes in a store that would have to grow.
[[nodiscard]] std::vector<int> check_shards(const StudySpec& study, const ShardStores& stores);

// Creates missing stores and extends the others to the design of `study`, which check_shards() returned.
void make_shards(const StudySpec& study, const ModelBuilder& build, const ShardStores& stores,
                 const std::string& provenance);

// Number of workers that run samples in this folder now; 0: none, or not known.
[[nodiscard]] int campaign_workers(const std::string& folder);

}  // namespace wythe
