// Rescue of a store whose own study is damaged: the study comes from the file of its user.
#pragma once

#include <functional>
#include <string>

#include "wythe/campaign.h"

namespace wythe {

// What is said instead of the damaged study.
struct StudyOfRescue {
  StudySpec study;
  ModelBuilder build;
  std::string shard{};  // "2/4": which part of its campaign the store is; "": what the store says
  // Called before anything is written, with the whole sample of the fewest steps, NULL where none ran: drawn values do not
  // tell one wall from another, so it is for the caller to run that sample again. It throws where the study is another.
  std::function<void(const SampleTable&, const SampleRecord*)> prove{};
};

// As rescue_campaign(folder, out), with this study in the place of the stored one. A sample is saved where it is whole and
// its inputs are, to the bit, what this study draws. InputError where that holds for none, or where a sample is not in the
// shard: then nothing is written.
[[nodiscard]] Rescue rescue_campaign(const std::string& folder, const std::string& out,
                                     const StudyOfRescue& by);

}  // namespace wythe
