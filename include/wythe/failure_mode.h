// Naming the failure: from the state of the joints, by rules anyone can read.
#pragma once

#include "wythe/model.h"
#include "wythe/result.h"

namespace wythe {

// Reads what happened to each pier, spandrel and connection from the snapshots of a push and names
// the mode: FM-1 ... FM-5 for a wall of two piers and one opening, a plain name otherwise, "unclear"
// where margins are small. Read at 40 mm, or at the last snapshot of a shorter push.
[[nodiscard]] FailureMode name_failure_mode(const Model& model, const Result& result);

}  // namespace wythe
