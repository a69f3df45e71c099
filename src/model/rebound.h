// What restitution gives to a wall of many blocks. It is stated for one block that falls flat; a pile that falls as one is a
// chain, in which the shock runs up and comes back after the lowest joint's own impact is over.
#pragma once

#include <optional>

#include "wythe/parts/model.h"

namespace wythe {

// The share of its speed with which the wall comes back when all of it falls flat on its ground at once, by the vertical
// motion of its blocks on the springs and dashpots of their beds, without weight. Nothing where beds do not carry nearly all
// of the wall, where it has zones, or where one block alone stands on another.
[[nodiscard]] std::optional<double> rebound_of_wall(const Model& model, const Dashpots& dashpots);

}  // namespace wythe
