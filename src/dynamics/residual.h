// The numbers by which solver, tests and report judge a state: unbalance, energies, base shear.
#pragma once

#include "dynamics/wall_view.h"
#include "wythe/result.h"

namespace wythe::dynamics {

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
// Distance of the block that has moved furthest [m], and which it is; n_block + i for node i.
struct Furthest {
  double distance = 0;
  BlockId block = 0;
};
[[nodiscard]] Furthest furthest_block(const Model& model, const WallView& wall);

}  // namespace wythe::dynamics
