// The numbers by which solver, tests and report judge a state. Those of a running
// wall (unbalance, kinetic energy, base shear, runaway block) are in passes/sums.h.
#pragma once

#include "wythe/parts/result.h"

namespace wythe::dynamics {

// Recoverable energy in the joints [J].
[[nodiscard]] double elastic_energy(const Model& model, const State& state);
// Work since the start by kind; gap is the part that the ledger misses.
[[nodiscard]] EnergyLedger energy_ledger(const Model& model, const State& state,
                                         double mass_scaling);
// Largest |ux| of the blocks whose centroids lie within 1 % of the height below the highest [m].
[[nodiscard]] double top_displacement(const Model& model, const State& state);

}  // namespace wythe::dynamics
