// The loads of a model for limit analysis: those that stay constant and those that grow.
//
// Reads the stages: gravity and load stages give the dead loads, the last push, body force or tilt
// gives what grows. Called by limit_load.cpp and by the macro-block mechanisms.
#pragma once

#include <vector>

#include "wythe/parts/model.h"

namespace wythe::limit {

struct BlockForce {
  double fx = 0, fy = 0, moment = 0;  // on a centroid [N], [N m]
};

struct LimitLoads {
  std::vector<BlockForce> dead;     // (n_block)
  std::vector<BlockForce> growing;  // per unit of the load (n_block); none under `together`
  const Stage* stage = nullptr;     // what grows
  double push_x = 0, push_y = 0;    // unit vector of a push
  bool is_force = true;
  bool together = false;  // driven blocks share one velocity, their forces sum up to the load
  std::vector<char> held_across, held_turn;  // motions the test rig prevents (n_block)
};

// Whether a stage grows by a factor on the masses.
[[nodiscard]] inline bool is_factor(const Stage& s) {
  return s.spec.kind == StageKind::kBodyForce || s.spec.kind == StageKind::kTilt;
}

// Reads what is in force when the last growing stage begins. `secant` multiplies the dead loads
// that keep their direction while the ground tilts (limit_load.cpp). `loads_are_masses`: LimitOptions. Throws InputError
// when no stage grows.
[[nodiscard]] LimitLoads limit_loads(const Model& model, double secant = 1,
                                     bool loads_are_masses = false);
// A push whose targets all lie behind it pushes against its direction.
[[nodiscard]] bool goes_back(const Stage& push);
// Whether a stage turns the blocks' weight on before `grows` ends, and there is any.
[[nodiscard]] bool has_weight(const Model& model, const Stage* grows);
// The stage that grows: the last push, body force or tilt; nullptr: none.
[[nodiscard]] const Stage* growing_stage(const Model& model);

}  // namespace wythe::limit
