// summary.json of a run: the numbers an engineer quotes, with their evidence and their provenance.
#pragma once

#include <string>

#include "wythe/model.h"
#include "wythe/result.h"

namespace wythe::io {

// Keys are the contract of docs/reference/results.md; what is not a number is null.
[[nodiscard]] std::string summary_json(const Model& model, const Result& result);

}  // namespace wythe::io
