// Columns of samples.csv for samples with shakes.
#pragma once

#include <string>

#include "wythe/parts/campaign.h"

namespace wythe::io {

// ",intensity_pga_m_per_s2,pga_m_per_s2,..." after the status of a sample.
[[nodiscard]] std::string shake_titles(const StudySpec& study);
[[nodiscard]] std::string shake_cells(const StudySpec& study, const ShakeResult& shake);
// The whole file of a study with [shaking]: a row for each shake.
[[nodiscard]] std::string shakes_csv(const Campaign& campaign);

}  // namespace wythe::io
