// The record of a sample as a text, with which one process hands it to another that judges all of them.
#pragma once

#include <string>
#include <string_view>

#include "wythe/parts/campaign.h"

namespace wythe::study {

[[nodiscard]] std::string handed_text(const StudySpec& study, const SampleTable& samples,
                                      const SampleRecord& record);
// The record as a store would give it. Throws InputError where the text is damaged, of another sample, study or program.
[[nodiscard]] SampleRecord handed_record(const StudySpec& study, const SampleTable& samples,
                                         int sample, std::string_view text);

}  // namespace wythe::study
