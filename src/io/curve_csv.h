// force_displacement.csv: the push-over curve with the unit in each column's name.
#pragma once

#include <string>
#include <vector>

#include "wythe/result.h"

namespace wythe::io {

[[nodiscard]] std::string curve_csv(const std::vector<CurveRow>& curve);

}  // namespace wythe::io
