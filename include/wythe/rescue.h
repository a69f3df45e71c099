// Rescue of a store whose own study is damaged: the study comes from the file of its user.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "wythe/campaign.h"

namespace wythe {

// What is said instead of the damaged study.
struct StudyOfRescue {
  StudySpec study;
  ModelBuilder build;
  std::string shard{};  // "2/4": which part of its campaign the store is; "": what the store says
  const std::atomic<bool>* stop = nullptr;  // true: end the proof, save nothing
  // Called with the samples that are run again for the proof; none where no sample is whole.
  std::function<void(const std::vector<int>&)> proves{};
};

// As rescue_campaign(folder, out), with this study in the place of the stored one. A sample is saved where it is whole and
// its inputs are, to the bit, what this study draws. Drawn values do not tell one wall from another, so first samples
// are run again, for each record and each way to end the one with the fewest steps, and every stored number of them has to
// come out once more. InputError where it does not, where no sample fits the study, or where one is not in the shard: then
// nothing is written.
[[nodiscard]] Rescue rescue_campaign(const std::string& folder, const std::string& out,
                                     const StudyOfRescue& by);

}  // namespace wythe
