// Shakes: records, driven blocks and watched points in the user's words -> motions, numbers and dashpots.
#pragma once

#include <functional>
#include <string>

#include "wythe/error.h"
#include "wythe/model.h"

namespace wythe {

// What the words of a model file mean in this wall, in its plane or in space.
struct WallPlaces {
  std::function<Vec3(Direction)> axis;
  std::function<std::vector<BlockId>(const PlaceSpec&)>
      blocks;                                            // in space supports too: n_block + k
  std::function<Vec3(const PlaceSpec&, BlockId)> point;  // in the wall's axes
  double lowest = 0;                                     // [m]
};

[[nodiscard]] Vec3 vector_of(Direction direction);

// Motions of the stage at `path`, and what it drives.
void compile_shake(const std::string& path, const WallPlaces& places, Model& model, Stage& stage,
                   FaultList& faults);
// The points of [[history]]; without any the highest block, where a stage shakes the wall.
void compile_watched(const std::vector<HistorySpec>& history, const WallPlaces& places,
                     Model& model, FaultList& faults);
// The base shakes the inertia that floors gave to blocks of the mass `bare` too.
void carry_floors(const std::vector<double>& bare, Model& model);
// Dashpots of each shake; needs final masses.
void set_dashpots(Model& model);

// A bound on the highest eigenvalue of M^-1 C, of dashpots at all joints closed [1/s].
[[nodiscard]] double dashpot_rate(const Model& model, const Dashpots& dashpots);
[[nodiscard]] double dashpot_rate_in_space(const Model& model, const Dashpots& dashpots);

// Fraction of critical damping with which a mass on a spring that only presses comes back with a share
// `restitution` of its speed (docs/theory/dynamics.md, 14.6).
[[nodiscard]] double fraction_of_restitution(double restitution);

// The fingerprint of a record's numbers, 16 hex digits.
[[nodiscard]] std::string record_hash(const std::vector<double>& times,
                                      const std::vector<double>& accelerations);

}  // namespace wythe
