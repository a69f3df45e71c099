// force_displacement.csv: the push-over curve with the unit in each column's
// name. Further columns have motion and forces of a lintel made of zones.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/result.h"

namespace wythe::io {

[[nodiscard]] std::string curve_csv(const std::vector<CurveRow>& curve, ShownColumns of = {});

// Rows of the shakes; the third direction only for walls in space.
[[nodiscard]] std::string history_csv(const ShakeHistory& history, int axes);
// Only with frames: N, V, M and use of every section at every row of the curve, one line each.
[[nodiscard]] std::string frames_csv(const Model& model, const Result& result);
// Only with layers: largest use and its place, detached and broken parts of every layer at every row of the curve, one line each.
[[nodiscard]] std::string layers_csv(const Model& model, const Result& result);
// Force and elongation of each link at the end of each row of the curve.
[[nodiscard]] std::string links_csv(const std::vector<std::string>& names, const Result& result);

}  // namespace wythe::io
