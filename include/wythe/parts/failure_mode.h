// The failure mode: the damage of each part of the wall, and a name that follows from it by stated rules.
//
//   Model + State --read_elements()--> ElementState of every pier, spandrel, connection, toe
//                 --name_from_state()--> FM-1 ... FM-5 (two piers, one opening) or a plain name
//   Result        --name_failure_mode()--> the same at a stated displacement, with first
//                   displacements, flags and how the name changes with displacement and thresholds
//
// Rules and their reasons: docs/theory/failure_modes.md.
#pragma once

#include <cmath>
#include <vector>

#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe {

// Thresholds of the rules. rules_for() sets the lengths from the courses of the wall.
struct ModeRules {
  double crack = 0;             // opening, or slip along a crack, that counts as a crack [m]
  double sliding = 0;           // slip across a whole section that counts as sliding [m]
  double pier_crossed = 0.75;   // share of a pier's width that a diagonal crack crosses [-]
  double spandrel_crossed = 1;  // share of a spandrel's depth that a diagonal crack crosses [-]
  double rocking = 0.5;         // open share of a rocking pier's foot [-]
  double crushing = 0.05;       // lost share of the compressive strength of a crushed toe [-]
  double broken_off = 0.02;     // share of the masonry that separated in one piece [-]
  double growth = 8e-3;         // flag: growth of a pier's width [m]
  double drop = 0.2;            // flag: sudden drop of the reaction, over the peak [-]
  double doubt = 0.15;          // a measure this near its threshold, as a share of it, is in doubt
};
// crack = 1 % of the course height (a tenth of a usual mortar bed), sliding = 3 crack.
[[nodiscard]] ModeRules rules_for(const Model& model);

inline constexpr double kReadModesAt = 40e-3;  // default displacement at which the mode is read [m]

// Whether the push ended before the displacement at which the mode was to be read, in either direction.
[[nodiscard]] inline bool is_read_early(double read_at, double asked) {
  return std::fabs(read_at) < 0.99 * asked;
}

using ElementStates = std::vector<ElementState>;

// State of each part of the wall in one state; first displacements are NaN.
[[nodiscard]] ElementStates read_elements(const Model& model, const State& state);
[[nodiscard]] ElementStates read_elements(const Model& model, const State& state,
                                          const ModeRules& rules);
// Name, scores, evidence, elements and flags of one state of the wall.
[[nodiscard]] FailureMode name_from_state(const Model& model, const State& state);
[[nodiscard]] FailureMode name_from_state(const Model& model, const State& state,
                                          const ModeRules& rules);

// Names the mode from the state of KeptStates::readings at `read_at` [m]; the run must have used the same
// SolveOptions::read_modes_at. Earlier readings give first displacements, snapshots give the
// sensitivity. The name is "unclear" where margins are small, where half the section of a pier has slid
// off its neighbours, or where no state was read.
[[nodiscard]] FailureMode name_failure_mode(const Model& model, const Result& result,
                                            double read_at = kReadModesAt);

// Whether a slower push, whose measures differ a little, gets the same name: its score leads by 0.6 (below 0.3 it is
// "unclear"), and no decisive kind of damage scores between 0.2 and 0.8 (0.35 and 0.65). True in space.
[[nodiscard]] bool is_firm(const FailureMode& mode);

// Opening, slip and crushing summed over piers, spandrels, connections and base, for every snapshot [m].
[[nodiscard]] std::vector<Feature> read_features(const Model& model, const Result& result);

}  // namespace wythe
