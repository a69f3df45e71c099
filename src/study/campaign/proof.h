// Whether a study is that of stored samples: some of them are run again, and compared in every number.
#pragma once

#include <string>
#include <vector>

#include "wythe/rescue.h"

namespace wythe::study {

// The samples of `whole` to run again: for each record, and each way that samples ended under it, the one with the fewest
// steps. What none of them goes through they do not prove.
[[nodiscard]] std::vector<int> samples_to_prove(const StudySpec& study,
                                                const std::vector<SampleRecord>& whole);

// Runs them as campaigns of one sample each, in a hidden folder below `out` which is gone afterwards, and compares them with the
// store in `folder`. `study`: with the design of the store. InputError where a number differs, IoError where it was stopped.
void prove_study(const std::string& folder, const std::string& out, const StudySpec& study,
                 const StudyOfRescue& by, const std::vector<int>& samples);

}  // namespace wythe::study
