// Shakes: records, driven blocks and watched points in the user's words -> motions, numbers and dashpots.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "wythe/parts/error.h"
#include "wythe/parts/model.h"
#include "wythe/parts/shaking.h"

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

// A spring of `share` times the stiffness of its contact and a dashpot in series with it, which relaxes in `relaxation`
// [s]: together with the contact they give `fraction` of critical damping at `frequency` [Hz], their largest
// (docs/theory/dynamics.md, 14.8).
struct MaxwellElement {
  double share, relaxation;
};
[[nodiscard]] MaxwellElement maxwell_element(double fraction, double frequency);
// The fraction of critical damping that the viscous damping of a shake gives an elastic vibration of this frequency [Hz], all
// kinds together (14.9a).
[[nodiscard]] double viscous_fraction(const StageSpec& shake, double frequency);
// The longest stable step of a wall with these dashpots over that without, by the bound on its highest frequency [1/s]
// (14.5, 14.10).
[[nodiscard]] double share_of_step(double omega_max, const Dashpots& dashpots);

// The fraction that stands for no restitution at all: 0.2 % of the energy comes back, as good as none.
inline constexpr double kNoRebound = 2;
// Fraction of critical damping with which a mass on a spring that only presses comes back with a share
// `restitution` of its speed (docs/theory/dynamics.md, 14.6).
[[nodiscard]] double fraction_of_restitution(double restitution);

// The longest time between rows of a shake [s]: peaks are read from rows, and a wall that rocks or vibrates moves to and fro
// between rows that lie further apart.
inline constexpr double kMostShakeRows = 4000;  // where the model does not say
[[nodiscard]] inline double longest_interval(double duration) {
  return std::max(0.01, duration / kMostShakeRows);
}

// What damps a shake, in words. `drawn`: keys of the stage that samples of a study draw, each with its input's name.
[[nodiscard]] std::vector<Message> damping_of(const StageSpec& shake,
                                              const std::map<std::string, std::string>& drawn);

// The blocks that hold the top of each storey.
[[nodiscard]] std::vector<std::vector<BlockId>> blocks_at_tops(const Model& model);
// Where a shake cannot tell the drifts of storeys.
void note_storeys_without_top(Model& model);

// Drift of storey k at a row along x and z: its top against its foot, over its height.
[[nodiscard]] inline std::pair<double, double> storey_drift(const ShakeHistory& h, std::size_t row,
                                                            std::size_t k) {
  const PointMotion* tops = &h.storey_top[row * h.storey.size()];
  const PointMotion foot = k > 0 ? tops[k - 1] : PointMotion{};
  return {(tops[k][0] - foot[0]) / h.storey_height[k], (tops[k][2] - foot[2]) / h.storey_height[k]};
}

// Samples that are missing from a record: behind which one, and how far apart others lie [s].
struct Gap {
  std::size_t after;
  double usual;
};
[[nodiscard]] std::vector<Gap> gaps_of(const std::vector<double>& times);

// The fingerprint of a record's numbers, 16 hex digits.
[[nodiscard]] std::string record_hash(const std::vector<double>& times,
                                      const std::vector<double>& accelerations);

}  // namespace wythe
