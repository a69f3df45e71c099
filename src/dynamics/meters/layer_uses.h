// Each layer over the curve: its largest use and where, when fibres broke, and how much is detached.
#pragma once

#include <vector>

#include "wythe/parts/result.h"

namespace wythe::dynamics {

// Results for a state, one row for each layer.
[[nodiscard]] std::vector<LayerRow> evaluate_layer_rows(const Model& model, const State& state);
[[nodiscard]] std::vector<LayerUse> evaluate_layer_uses(const Model& model, const Result& result);

// "(1.20, 0.55) m".
[[nodiscard]] Message place_in_layer(const LayerRow& row);

}  // namespace wythe::dynamics
