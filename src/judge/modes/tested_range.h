// compare_with_tests() with a table given by the caller; see wythe/parts/tested_range.h.
#pragma once

#include <span>

#include "judge/modes/tested_walls.h"
#include "wythe/parts/tested_range.h"

namespace wythe::study {

// No joint has any bond, as in the tested stone walls with units that cannot crack.
[[nodiscard]] bool is_dry(const Model& model);
[[nodiscard]] TestedRange compare_with(std::span<const TestedKind> tests, const Model& model,
                                       const Result& result);

}  // namespace wythe::study
