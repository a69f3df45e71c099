// Samples under records: the wall and the record of a sample, and its intensities.
#pragma once

#include "wythe/parts/study.h"

namespace wythe {

// For a study with shakes.
[[nodiscard]] double first_intensity(const ShakingSpec& shaking, const StudyRecord& record);

}  // namespace wythe
