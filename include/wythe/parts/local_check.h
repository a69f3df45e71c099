// Parts of a wall that fall on their face: what sets them off, how far they go, and what a code asks.
//
//   [[assessment.part]] ──► strip of masonry, floors, ties ──┐
//   limit_load() of a body force ──► its mechanism ──────────┴─► LocalCapacity ──► spectrum at that height ──► LocalCheck
//
// Equations and clauses: docs/theory/local_mechanisms.md. SI units; NaN: not known.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

enum class LimitState;         // wythe/parts/assessment.h
enum class AssessmentVerdict;  // the same
struct SecondOpinion;          // wythe/parts/limit.h

// --- one rigid body that turns about a line ------------------------------------------------------------

// A weight of the body. Per unit turn it goes `travel` along the earthquake and rises by `rise`; while it turns on, its
// rise falls by `drop`. About a level line across the earthquake: rise is the distance behind the line, travel and drop
// the height above it.
struct LocalWeight {
  double weight = 0;                                            // that presses [N]
  double pushed = 0;                                            // of it, by an earthquake [N]
  double travel = 0, rise = 0, drop = 0;                        // [m]
  double slides_off = std::numeric_limits<double>::infinity();  // a floor, beyond this travel [m]
};
// What holds the body back, level and against the earthquake.
struct LocalHold {
  double force = 0;             // [N]
  double travel = 0, rise = 0;  // of its place, as of a weight [m]
  double lets_go = kUnset;      // beyond this travel; NaN: not known [m]
};
struct LocalCapacity {
  double weight = 0, pushed = 0;  // sums [N]
  double alpha0 = kUnset;         // multiplier of the pushed weights at which it sets off [-]
  double mass = kUnset;           // M* [kg]
  double mass_share = kUnset;     // e* [-]
  bool is_one_body = true;        // else M* and e* hang on which blocks are taken as one
  double alpha0_to_end =
      kUnset;                 // the same by what holds to the end alone: the curve's beginning [-]
  double rotation0 = kUnset;  // where nothing more is needed to fall [rad]
  double displacement0 = kUnset;  // d0*, of the equivalent system [m]
  double top0 = kUnset;           // that of the highest point of the body, along the earthquake [m]
  double slides_off =
      std::numeric_limits<double>::infinity();  // d* at which a floor is off its bearing [m]
  double lets_go = std::numeric_limits<double>::infinity();  // d* at which what breaks takes more
                                                             // than half of the onset along [m]
  Message no_displacement = {};                              // why there is no d0*; empty: there is
};
// `resisted`: work of what resists without moving along, friction of teeth, per unit turn [N m]. `top`: height above the
// line of the highest point.
[[nodiscard]] LocalCapacity overturning(const std::vector<LocalWeight>& weights,
                                        const std::vector<LocalHold>& holds, double resisted,
                                        double top, double gravity);

// --- two bodies between a foot and a head that is held --------------------------------------------------

// A strip that bends outwards. The lower body turns about its face at the foot, the upper one about the inner face at
// `hinge`, of what stands there on each other; its head moves up and down in the middle of its thickness.
struct BentStrip {
  double height = 0;                 // [m]
  double at_hinge = 0, at_head = 0;  // thicknesses; outer faces are flush [m]
  double inset = 0;                  // of all lines from the faces [m]
  // Weights by height above the foot and distance behind the outer face. Those at the head press and are not pushed.
  struct Weight {
    double height = 0, behind = 0, weight = 0, pushed = 0;
    double slides_off = std::numeric_limits<double>::infinity();  // a floor, beyond this travel [m]
  };
  std::vector<Weight> lower = {}, upper = {};
};
[[nodiscard]] LocalCapacity bending(const BentStrip& strip, double hinge, double gravity);

// --- the spectrum at a height --------------------------------------------------------------------------

struct BuildingAt {
  double height = kUnset;  // Z, of what the part turns about [m]
  double top = kUnset;     // H [m]
  double period = kUnset;  // T1 [s]
  int storeys = 1;
  [[nodiscard]] double share() const;  // gamma psi(Z) [-]
};

// --- the check ----------------------------------------------------------------------------------------

// Of one limit state.
struct LocalStateCheck {
  LimitState state{};
  AssessmentVerdict verdict{};
  double ground_demand = kUnset;  // peak of the ground [m/s^2]
  double demand = kUnset;         // largest of the ground and of the height, before q [m/s^2]
  double q = kUnset;             // by which it is divided; NaN: the check by q is not of this state
  double q_ratio = kUnset;       // capacity over demand of the onset [-]
  double displacement = kUnset;  // that it may reach, d* [m]
  double period = kUnset;        // T of the limit state there [s]
  double displacement_demand = kUnset;
  double displacement_ratio = kUnset;
  double acceleration =
      kUnset;  // peak of the ground at which the deciding check is met at its limit [m/s^2]
  bool by_onset = false;  // that is the one which sets it off, for the way would carry less
};
struct LocalCheck {
  std::string name;
  std::string by;                  // "part" of [assessment], "found", or the name of a limit load
  double foot = 0, head = kUnset;  // above the wall's base [m]
  double hinge = kUnset;           // of a part that bends [m]
  double inset = 0;                // [m]
  double masonry = 0, floors = 0;  // weights [N]
  LocalCapacity capacity;
  double confidence_factor = 1;
  double acceleration0 = kUnset;         // a0* at the onset [m/s^2]
  double acceleration0_to_end = kUnset;  // that the curve a = a0 (1 - d / d0) begins with [m/s^2]
  BuildingAt building;
  AssessmentVerdict verdict{};
  std::vector<LocalStateCheck> states;
  bool may_be_signed = false;
  std::vector<Message> cautions, notes;
  Message sentence;
  [[nodiscard]] const LocalStateCheck* deciding() const;
  // Capacity over demand of that limit state; 0 of a part that falls by itself, NaN without an answer.
  [[nodiscard]] double reserve() const;
};

// Checks of every part that the model file names or, where it names none, that simple rules find, and of the mechanism
// of a body force. `parts`: whether parts are asked for. What can't be checked goes to `opinion.refused` with its place
// and cure.
void add_local_checks(const ModelSpec& spec, const Model& model, bool parts,
                      SecondOpinion& opinion);
// Whether there is any part to look at, without a limit load.
[[nodiscard]] bool has_parts(const ModelSpec& spec, const Model& model);

}  // namespace wythe
