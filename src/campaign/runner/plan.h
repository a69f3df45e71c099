// The plan of a campaign, compared with its store: the study of a store never changes, and its design only
// grows. Used by a running campaign (campaign.cpp) and by shards that are created together (shards.cpp).
#pragma once

#include <string>
#include <vector>

#include "campaign/store/store.h"
#include "wythe/parts/campaign.h"

namespace wythe::study {

[[nodiscard]] int total(const std::vector<int>& batch);

// Compiles the base model, which must be valid by itself; its load height is used for the drifts of all samples.
[[nodiscard]] StoreHead head_of(const StudySpec& asked, const ModelBuilder& build,
                                const CampaignOptions& options);

// The design of a store only grows: samples beyond it become a new batch.
[[nodiscard]] std::vector<int> grown(const std::vector<int>& was, const std::vector<int>& asked,
                                     const std::string& store);

// A campaign that is ready to run: its study with the present batches, and all samples.
struct CampaignPlan {
  StudySpec spec;
  SampleTable samples;
  std::vector<Message> notes;
};

// Continues the study of an existing store, and adds samples to it where more are asked for. Stored samples
// stay, even if this version would draw other values. Throws InputError where the study has changed.
[[nodiscard]] CampaignPlan continue_store(Store& store, const StudySpec& asked,
                                          const StoreHead& head);

}  // namespace wythe::study
