// What a campaign is about to do, compared with what its store holds: a store's study never changes, its design
// only grows. Used by a campaign that runs (campaign.cpp) and by the shards of one, made together (shards.cpp).
#pragma once

#include <string>
#include <vector>

#include "campaign/store/store.h"
#include "wythe/parts/campaign.h"

namespace wythe::study {

[[nodiscard]] int total(const std::vector<int>& batch);

// The base model has to stand by itself; its drifts are those of every sample.
[[nodiscard]] StoreHead head_of(const StudySpec& asked, const ModelBuilder& build,
                                const CampaignOptions& options);

// The design of a store only grows: what is asked beyond it becomes a batch of its own.
[[nodiscard]] std::vector<int> grown(const std::vector<int>& was, const std::vector<int>& asked,
                                     const std::string& store);

// A campaign as it is run: its study with the batches it has now, and all samples.
struct CampaignPlan {
  StudySpec spec;
  SampleTable samples;
  std::vector<Message> notes;
};

// Takes the study on from a store that is there, and adds samples to it where more are asked. Samples that are
// stored stay as they are, also where this version would draw others. Throws InputError where the study has changed.
[[nodiscard]] CampaignPlan continue_store(Store& store, const StudySpec& asked,
                                          const StoreHead& head);

}  // namespace wythe::study
