// The loads of a model for limit analysis: constant loads and growing loads.
//
// Reads the stages: gravity and load stages give the dead loads; the last push, body force or tilt
// gives the growing ones. Called by limit_load.cpp and by the macro-block mechanisms.
#pragma once

#include <vector>

#include "wythe/parts/model.h"

namespace wythe::limit {

struct BlockForce {
  double fx = 0, fy = 0, moment = 0;  // on a centroid [N], [N m]
};

struct LimitLoads {
  std::vector<BlockForce> dead;     // (n_block)
  std::vector<BlockForce> growing;  // per unit of the load (n_block); unused with `together`
  const Stage* stage = nullptr;     // the growing stage
  double push_x = 0, push_y = 0;    // unit vector of a push
  bool is_force = true;
  bool together = false;  // driven blocks share one velocity; their forces sum to the load
  std::vector<char> held_across, held_turn;  // motions the test rig prevents (n_block)
};

// Whether the growing load is a factor on the masses.
[[nodiscard]] inline bool is_factor(const Stage& s) {
  return s.spec.kind() == StageKind::kBodyForce || s.spec.kind() == StageKind::kTilt;
}

// Loads in force when the last growing stage begins. `secant` multiplies dead loads of constant
// direction on tilting ground (limit_load.cpp). `loads_are_masses`: see LimitOptions. Throws InputError
// when no stage grows.
[[nodiscard]] LimitLoads limit_loads(const Model& model, double secant = 1,
                                     bool loads_are_masses = false);
// Gravity after the stages before the growing one; a body force or a tilt stays in force. Tests
// built in code may omit gravity; then blocks have no weight.
[[nodiscard]] Vec3 gravity_before(const Model& model, const Stage* grows);
// Whether a push goes against its direction, since all its targets lie behind it.
[[nodiscard]] bool goes_back(const Stage& push);
// Whether a stage applies a non-zero weight of blocks before `grows` ends.
[[nodiscard]] bool has_weight(const Model& model, const Stage* grows);
// The growing stage: the last push, body force or tilt; nullptr: none.
[[nodiscard]] const Stage* growing_stage(const Model& model);

}  // namespace wythe::limit
