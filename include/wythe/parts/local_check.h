// Local mechanisms: parts of a wall that overturn out of plane, their onset, their displacement capacity and the check of a code.
//
//   [[assessment.part]] ──► strip of masonry, floors, ties ──┐
//   limit_load() of a body force ──► its mechanism ──────────┴─► LocalCapacity ──► spectrum at that height ──► LocalCheck
//
// Equations and clauses: docs/theory/local_mechanisms.md. All numbers are SI; NaN means not known.
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

// --- one rigid body that rotates about a line ----------------------------------------------------------

// A weight of the body. Per unit rotation it moves by `travel` along the earthquake and by `rise` upwards; with growing rotation
// its rise decreases by `drop`. For a rotation about a level line across the earthquake, rise is the distance behind the line,
// travel and drop are the height above it.
struct LocalWeight {
  double weight = 0;                                            // vertical force [N]
  double pushed = 0;                                            // part of it with inertia [N]
  double travel = 0, rise = 0, drop = 0;                        // [m]
  double slides_off = std::numeric_limits<double>::infinity();  // travel that unseats a floor [m]
};
// A horizontal force that holds the body back against the earthquake.
struct LocalHold {
  double force = 0;             // [N]
  double travel = 0, rise = 0;  // of its point, as for a weight [m]
  double lets_go = kUnset;      // travel at which it fails; NaN: not known [m]
};
struct LocalCapacity {
  double weight = 0, pushed = 0;  // sums [N]
  double alpha0 = kUnset;         // multiplier of the pushed weights at the onset [-]
  double mass = kUnset;           // M* [kg]
  double mass_share = kUnset;     // e* [-]
  bool is_one_body = true;        // else M* and e* depend on which blocks count as one body
  double alpha0_to_end =
      kUnset;                 // alpha0 with the holds that last to the end: start of the curve [-]
  double rotation0 = kUnset;  // rotation at which the resistance is zero [rad]
  double displacement0 = kUnset;  // d0*, of the equivalent system [m]
  double top0 = kUnset;           // displacement0 of the highest point, along the earthquake [m]
  double slides_off =
      std::numeric_limits<double>::infinity();  // d* at which a floor leaves its bearing [m]
  double lets_go = std::numeric_limits<double>::infinity();  // d* where failing holds have taken
                                                             // more than half of the resistance
  double without_holds_from = kUnset;  // d* at which the first hold fails that the curve leaves out
  bool ends_with_hold = false;         // at d0* a hold fails that the curve counts
  Message no_displacement = {};        // why there is no d0*; empty: there is
};
// Capacities of one rotating body: with all holds whose way is known up to the rotation at which the first lets go, then without
// that one, and so on; at last without any. Each is on the safe side. `resisted`: work per unit rotation of forces that do not displace, such as friction of teeth
// [N m]. `top`: height of the highest point above the line [m]. `gravity`: g [m/s^2].
[[nodiscard]] std::vector<LocalCapacity> overturning(const std::vector<LocalWeight>& weights,
                                                     const std::vector<LocalHold>& holds,
                                                     double resisted, double top, double gravity);

// --- two bodies between a foot and a held head ----------------------------------------------------------

// A strip that bends outwards into two bodies. The lower rotates about its outer face at the foot, the upper about the inner face
// at `hinge`, where both touch. The head moves only vertically, at mid-thickness.
struct BentStrip {
  double height = 0;                 // [m]
  double at_hinge = 0, at_head = 0;  // thicknesses; outer faces flush [m]
  double inset = 0;                  // distance of all rotation lines from the faces [m]
  // Height above the foot, distance behind the outer face. Weights at the head press but have no inertia (pushed = 0).
  struct Weight {
    double height = 0, behind = 0, weight = 0, pushed = 0;
    double slides_off = std::numeric_limits<double>::infinity();  // travel that unseats a floor [m]
  };
  std::vector<Weight> lower = {}, upper = {};
};
[[nodiscard]] LocalCapacity bending(const BentStrip& strip, double hinge, double gravity);

// --- the spectrum at a height --------------------------------------------------------------------------

struct BuildingAt {
  double height = kUnset;  // Z, height of the rotation line [m]
  double top = kUnset;     // H, height of the building [m]
  double period = kUnset;  // T1 [s]
  int storeys = 1;
  [[nodiscard]] double share() const;  // gamma psi(Z): first mode at that height [-]
};

// --- the check ----------------------------------------------------------------------------------------

// The check for one limit state.
struct LocalStateCheck {
  LimitState state{};
  AssessmentVerdict verdict{};
  double ground_demand = kUnset;  // peak ground acceleration [m/s^2]
  double demand = kUnset;         // largest acceleration, at the ground or at Z, before q [m/s^2]
  double q = kUnset;              // divides the demand; NaN: this limit state has no check by q
  double q_ratio = kUnset;        // capacity over demand at the onset [-]
  double displacement = kUnset;   // displacement capacity d* [m]
  double period = kUnset;         // period T of the limit state at it [s]
  double displacement_demand = kUnset;
  double displacement_ratio = kUnset;
  double acceleration =
      kUnset;  // peak ground acceleration at which the deciding check is just met [m/s^2]
  bool by_onset = false;  // the onset decides, since displacements would give less
};
struct LocalCheck {
  std::string name;
  std::string by;                  // "part" of [assessment], "found", or name of a limit load
  double foot = 0, head = kUnset;  // above the wall's base [m]
  double hinge = kUnset;           // of a bending part [m]
  double inset = 0;                // [m]
  double masonry = 0, floors = 0;  // weights [N]
  LocalCapacity capacity;
  double confidence_factor = 1;
  double acceleration0 = kUnset;         // a0* at the onset [m/s^2]
  double acceleration0_to_end = kUnset;  // initial value of the curve a = a0 (1 - d / d0) [m/s^2]
  BuildingAt building;
  AssessmentVerdict verdict{};
  std::vector<LocalStateCheck> states;
  bool may_be_signed = false;
  double reserve_beside = kUnset;  // of the weakest part between its holds, if that is less
  Message beside;                  // tells of it, if it holds
  std::vector<Message> cautions, notes;
  Message sentence;
  [[nodiscard]] bool is_found() const { return by == "found"; }
  [[nodiscard]] const LocalStateCheck* deciding() const;  // null: no limit state is checked
  // Capacity over demand of the deciding limit state, or of what is weaker between its holds; 0 for a part that falls by itself,
  // NaN without an answer.
  [[nodiscard]] double reserve() const;
};

// Checks every part that the model file names, the parts that simple rules find where no named part covers them, and the
// mechanism of a body force. `parts`: whether parts are requested. A check that is not possible goes to
// `opinion.refused` with its place and cure.
void add_local_checks(const ModelSpec& spec, const Model& model, bool parts,
                      SecondOpinion& opinion);
// Whether the model has any part to check, without a limit load.
[[nodiscard]] bool has_parts(const ModelSpec& spec, const Model& model);

}  // namespace wythe
