// Shakes of the model file: records, driven blocks and watched points -> motions, numbers and dashpots.
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

// Places of a model file in this wall, in the plane or in space.
struct WallPlaces {
  std::function<Vec3(Direction)> axis;
  std::function<std::vector<BlockId>(const PlaceSpec&)>
      blocks;                                            // in space supports too: n_block + k
  std::function<Vec3(const PlaceSpec&, BlockId)> point;  // in the axes of the wall
  double lowest = 0;                                     // [m]
};

[[nodiscard]] Vec3 vector_of(Direction direction);

// Motions of the stage at `path`, and the blocks or supports that they drive.
void compile_shake(const std::string& path, const WallPlaces& places, Model& model, Stage& stage,
                   FaultList& faults);
// The points of [[history]]; without any the highest block, if a stage shakes the wall.
void compile_watched(const std::vector<HistorySpec>& history, const WallPlaces& places,
                     Model& model, FaultList& faults);
// Adds the inertia that floors gave to blocks of the mass `bare` to the shaken masses.
void carry_floors(const std::vector<double>& bare, Model& model);
// Sets the dashpots of each shake; needs final masses.
void set_dashpots(Model& model);

// Bound on the largest eigenvalue of M^-1 C with dashpots at all joints closed [1/s].
[[nodiscard]] double dashpot_rate(const Model& model, const Dashpots& dashpots);
[[nodiscard]] double dashpot_rate_in_space(const Model& model, const Dashpots& dashpots);

// A spring of `share` times the contact's stiffness in series with a dashpot, with relaxation time `relaxation`
// [s]. Parallel to the contact they give `fraction` of critical damping at `frequency` [Hz], their maximum
// (docs/theory/dynamics.md, 14.8).
struct MaxwellElement {
  double share, relaxation;
};
[[nodiscard]] MaxwellElement maxwell_element(double fraction, double frequency);
// Fraction of critical damping that a shake's viscous damping gives an elastic vibration of this frequency [Hz], from all
// kinds together (14.9a).
[[nodiscard]] double viscous_fraction(const ShakeStage& shake, double frequency);
// Longest stable step with these dashpots over that without, from the bound `omega_max` on the highest frequency [1/s]
// (14.5, 14.10).
[[nodiscard]] double share_of_step(double omega_max, const Dashpots& dashpots);

// The fraction that means no restitution: 0.2 % of the energy returns.
inline constexpr double kNoRebound = 2;
// Fraction of critical damping of a mass on a compression-only spring that rebounds with the share
// `restitution` of its velocity (docs/theory/dynamics.md, 14.6).
[[nodiscard]] double fraction_of_restitution(double restitution);

// Longest interval between rows of a shake [s]. Peaks are read from rows, and a wall that rocks or vibrates moves between
// rows that are farther apart.
inline constexpr double kMostShakeRows = 4000;  // default number of rows
[[nodiscard]] inline double longest_interval(double duration) {
  return std::max(0.01, duration / kMostShakeRows);
}

// Damping of a shake in words. `drawn`: keys of the stage that samples of a study draw, with the names of their inputs.
[[nodiscard]] std::vector<Message> damping_of(const StageSpec& stage,
                                              const std::map<std::string, std::string>& drawn);

// Blocks at the top of each storey.
[[nodiscard]] std::vector<std::vector<BlockId>> blocks_at_tops(const Model& model);
// Notes storeys whose drift a shake cannot give.
void note_storeys_without_top(Model& model);

// Drift of storey k in a row, along x and z: displacement of its top against its foot, over its height.
[[nodiscard]] inline std::pair<double, double> storey_drift(const ShakeHistory& h, std::size_t row,
                                                            std::size_t k) {
  const PointMotion* tops = &h.storey_top[row * h.storey.size()];
  const PointMotion foot = k > 0 ? tops[k - 1] : PointMotion{};
  return {(tops[k][0] - foot[0]) / h.storey_height[k], (tops[k][2] - foot[2]) / h.storey_height[k]};
}

// Missing samples of a record: the sample before, and the interval of the others [s].
struct Gap {
  std::size_t after;
  double usual;
};
[[nodiscard]] std::vector<Gap> gaps_of(const std::vector<double>& times);

// Hash of a record's numbers, 16 hex digits.
[[nodiscard]] std::string record_hash(const std::vector<double>& times,
                                      const std::vector<double>& accelerations);

}  // namespace wythe
