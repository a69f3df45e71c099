// A second opinion on a model without time stepping: limit analysis of its blocks, and the collapse
// of three macro-blocks cut from it.
//
//   Model --limit_load()--> LimitAnswer     largest load rigid-plastic joints carry, by linear
//                                           programming; static and kinematic theorem, both solved
//   Model --find_portal()--> Portal         two piers, one opening, a spandrel (src/study)
//   Portal --mechanism()--> Mechanism       FM-1 or FM-4: hinges, ratios, force against displacement
//   Mechanism + curves --compare()--> Verdict
//
// Theory: docs/theory/limit_analysis.md.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/model.h"

namespace wythe {

// --- limit analysis of the block model ------------------------------------------------------------

// What a joint resists beside compression and friction.
enum class JointStrength { kDry, kBonded };  // bonded: tension cut-off ft and cohesion c
enum class FrictionChoice { kPeak, kResidual };
// How crushing bounds a joint: not at all; each contact point by its share of fc A, as the D-RBA has
// it; or a stress block at fc, M <= N l/2 (1 - N/(fc A)).
enum class CrushingChoice { kNone, kPoints, kStressBlock };

struct LimitOptions {
  JointStrength strength = JointStrength::kDry;
  FrictionChoice friction = FrictionChoice::kPeak;
  CrushingChoice crushing = CrushingChoice::kNone;
};

// What grows: the force of the push stage along its direction [N], or lambda W on every block
// (body force and tilt, lambda = tan of the angle) [-].
struct LimitAnswer {
  LimitOptions options;
  bool is_force = true;
  double load = 0;       // static theorem: largest load in balance within the joints' strength
  double kinematic = 0;  // kinematic theorem: least load that drives a mechanism; equal to `load`
  // joint forces at that load (n_point): compression on each point [N]
  std::vector<double> point_force;
  std::vector<double> shear_force;  // along t on the block b [N] (n_joint)
  // collapse mechanism, per unit velocity of the load (n_block) [-], [-], [1/m]
  std::vector<double> vx, vy, omega;
  double dissipation = 0;  // of the joints in that mechanism, per unit velocity of the load
  int rows = 0, columns = 0, cuts = 0;  // size of the static programme; tangents added
  double seconds = 0;
};
// Associated flow, small displacements. Throws InputError when nothing grows, when the dead loads
// alone cannot be carried (says which block cannot stand), and when the load is without limit.
[[nodiscard]] LimitAnswer limit_load(const Model& model, const LimitOptions& options);

}  // namespace wythe
