// Samples under records: the wall and the record of a sample, and its intensities.
#pragma once

#include "wythe/parts/study.h"

namespace wythe {

// Of a study that asks for shakes.
[[nodiscard]] double first_intensity(const ShakingSpec& shaking, const StudyRecord& record);

}  // namespace wythe
