// Energy of free contacts in a state, and fallen blocks (docs/theory/contacts.md).
#pragma once

#include "wythe/parts/model.h"

namespace wythe::reading {

// Recoverable energy of the free contacts at the current poses [J].
[[nodiscard]] double free_energy(const Model& model, const State& state);

// Fallen material of a state; empty without free contacts.
[[nodiscard]] Debris evaluate_debris(const Model& model, const State& state);

// Largest penetration of a free contact, that of its most compressed block [m]; 0 without contacts.
[[nodiscard]] double deepest_overlap(const Model& model, const State& state);

}  // namespace wythe::reading
