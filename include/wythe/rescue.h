// Rescue of a store whose own study is damaged: the study comes from the file of its user.
#pragma once

#include <string>

#include "wythe/campaign.h"

namespace wythe {

// As rescue_campaign(folder, out), with this study in the place of the stored one. A sample is saved where it is whole and
// its inputs are, to the bit, what this study draws. InputError where that holds for none: then nothing is written.
[[nodiscard]] Rescue rescue_campaign(const std::string& folder, const std::string& out,
                                     const StudySpec& study, const ModelBuilder& build);

}  // namespace wythe
