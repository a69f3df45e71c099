// Effect of restitution in a wall of many blocks. It is stated for one block that falls flat. A pile that falls as one is a
// chain: the shock travels up and returns after the impact at the lowest joint is over.
#pragma once

#include <optional>

#include "wythe/parts/model.h"

namespace wythe {

// Rebound velocity over impact velocity when the whole wall falls flat on its ground [-]. It follows from the vertical motion of
// blocks on springs and dashpots of their beds, without weight. Nothing where beds do not carry nearly all
// of the wall, where it has zones, or where it is a single block on another.
[[nodiscard]] std::optional<double> rebound_of_wall(const Model& model, const Dashpots& dashpots);

}  // namespace wythe
