#include "limit/limit_loads.h"

#include <algorithm>

#include "wythe/error.h"

namespace wythe::limit {
namespace {

bool is_factor(const Stage& s) {
  return s.spec.kind == StageKind::kBodyForce || s.spec.kind == StageKind::kTilt;
}

// Tests built in code may leave gravity out; then blocks weigh nothing.
bool has_gravity(const Model& model) {
  return std::any_of(model.stages.begin(), model.stages.end(), [](const Stage& s) {
    return s.spec.kind == StageKind::kGravity || is_factor(s);
  });
}

void add_dead_loads(const Model& model, LimitLoads& loads) {
  const double g = has_gravity(model) ? model.solve.gravity : 0.0;
  for (std::size_t i = 0; i < loads.dead.size(); ++i) loads.dead[i].fy -= g * model.heavy_mass[i];
  for (const Stage& stage : model.stages) {
    for (const PointLoad& p : stage.loads) {
      BlockForce& f = loads.dead[static_cast<std::size_t>(p.block)];
      f.fx += p.fx;
      f.fy += p.fy;
      f.moment += p.arm_x * p.fy - p.arm_y * p.fx;
    }
  }
}

void add_push(const Stage& push, LimitLoads& loads) {
  loads.together = push.spec.as == Manner::kEach;
  const auto n = static_cast<double>(push.driven.size());
  for (const BlockId b : push.driven) {
    const auto i = static_cast<std::size_t>(b);
    if (!loads.together) loads.growing[i] = {push.drive_x / n, push.drive_y / n, 0};
    loads.held_across[i] = push.spec.across == Freedom::kBlocked;
    loads.held_turn[i] = push.spec.rotation == Freedom::kBlocked;
  }
}

}  // namespace

const Stage* growing_stage(const Model& model) {
  const Stage* found = nullptr;
  for (const Stage& s : model.stages)
    if (s.spec.kind == StageKind::kPush || is_factor(s)) found = &s;
  return found;
}

LimitLoads limit_loads(const Model& model) {
  LimitLoads loads;
  loads.stage = growing_stage(model);
  if (loads.stage == nullptr)
    throw InputError({{.file = "",
                       .path = "stage",
                       .value = "",
                       .problem = "no stage has a load that grows",
                       .cure = "add a push, e.g. at = { x = \"0 m\", y = \"3.12 m\" }, or a "
                               "body_force stage"}});
  const auto n = static_cast<std::size_t>(model.n_block);
  loads.dead.resize(n);
  loads.growing.resize(n);
  loads.held_across.assign(n, 0);
  loads.held_turn.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) loads.held_turn[i] = model.turn_freedom[i] == 0;
  add_dead_loads(model, loads);
  loads.is_force = !is_factor(*loads.stage);
  if (loads.is_force) {
    add_push(*loads.stage, loads);
    return loads;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double w = model.solve.gravity * model.heavy_mass[i];
    loads.growing[i] = {w * loads.stage->drive_x, w * loads.stage->drive_y, 0};
  }
  return loads;
}

}  // namespace wythe::limit
