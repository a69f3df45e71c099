// What a state says of free contacts (docs/theory/contacts.md): their energy, and what has fallen.
#pragma once

#include "wythe/parts/model.h"

namespace wythe::reading {

// Recoverable energy of the free contacts at the present poses [J].
[[nodiscard]] double free_energy(const Model& model, const State& state);

// Empty where contacts are not free.
[[nodiscard]] Debris evaluate_debris(const Model& model, const State& state);

// How deep the block of a free contact that is pressed most lies in the other [m]; 0 without one.
[[nodiscard]] double deepest_overlap(const Model& model, const State& state);

}  // namespace wythe::reading
