// force_displacement.csv: the push-over curve with the unit in each column's name; where a lintel is made of zones,
// its motion and forces follow in columns of their own.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/result.h"

namespace wythe::io {

[[nodiscard]] std::string curve_csv(const std::vector<CurveRow>& curve, ShownColumns of = {});

// Rows of the shakes; the third direction of walls in space alone.
[[nodiscard]] std::string history_csv(const ShakeHistory& history, int axes);
// Frames only: N, V, M and use of every section at every row of the curve, a line each.
[[nodiscard]] std::string frames_csv(const Model& model, const Result& result);
// Layers only: largest use and where, what is detached and broken, of every layer at every row of the curve, a line each.
[[nodiscard]] std::string layers_csv(const Model& model, const Result& result);
// Force and elongation of each link at the end of each row of the curve.
[[nodiscard]] std::string links_csv(const std::vector<std::string>& names, const Result& result);

}  // namespace wythe::io
