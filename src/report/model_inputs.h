// The inputs of a model in tables: each row has a key of the page's texts, a value and its unit.
#pragma once

#include "report/bundle.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::report {

// {wall: [[key, value, unit], ...], openings, materials: {names, rows}, masonry: [[key, value, unit], ...],
//  origins: [[table, key, value, kind, by, inputs, formula, source], ...], stages, settings, notes}
[[nodiscard]] Json model_inputs(const ModelSpec& spec, const Model& model);

}  // namespace wythe::report
