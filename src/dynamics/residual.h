// The numbers by which solver, tests and report judge a state: unbalance, energies, base shear.
#pragma once

#include "dynamics/wall_sums.h"
#include "wythe/result.h"

namespace wythe::dynamics {

[[nodiscard]] WallSizes sizes_of(const Model& model);

// sum |unbalanced force| / sum |contact force| over the free blocks, 1-norm; 0 where nothing acts.
[[nodiscard]] double unbalance_ratio(const Model& model, const WallView& wall);
// 1/2 m v^2 + 1/2 I omega^2 at the half step [J].
[[nodiscard]] double kinetic_energy(const Model& model, const WallView& wall, double mass_scaling);
// Recoverable energy in the joints [J].
[[nodiscard]] double elastic_energy(const Model& model, const State& state);
// Sum of the ground's forces against the direction (px, py), + resists [N].
[[nodiscard]] double base_shear(const Model& model, const WallView& wall, double px, double py);
// Where work went since the start; gap is what the ledger misses.
[[nodiscard]] EnergyLedger energy_ledger(const Model& model, const State& state,
                                         double mass_scaling);
// First block whose motion is not finite or faster than 100 m/s, or -1; n_block + i for node i.
[[nodiscard]] BlockId runaway_block(const Model& model, const WallView& wall);
// Largest |ux| of the blocks whose centroids lie within 1 % of the height below the highest [m].
[[nodiscard]] double top_displacement(const Model& model, const State& state);
// The block (n_block + i: node i) that has moved furthest.
[[nodiscard]] Furthest furthest_block(const Model& model, const WallView& wall);

}  // namespace wythe::dynamics
