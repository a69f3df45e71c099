#include "dynamics/wall_pass.h"

namespace wythe::dynamics {

Drive drive_of(const Stage& push) {
  return {push.driven.data(),
          static_cast<int>(push.driven.size()),
          push.drive_x,
          push.drive_y,
          push.spec.as != Manner::kEach,
          push.spec.across == Freedom::kFree,
          push.spec.rotation == Freedom::kFree};
}

double drive_pass(const Model& model, State& s, const WallView& wall, const Controls& controls) {
  if (controls.push == nullptr) return 0;
  WallWork work{s.work_drive, s.work_damping, s.work_loads};
  const double reaction =
      drive_blocks(drive_of(*controls.push), wall, {model.mass.data()}, {model.inertia.data()},
                   controls.dt, controls.damping, controls.drive_velocity, work);
  s.work_drive = work.drive;
  s.work_damping = work.damping;
  s.work_loads = work.loads;
  s.drive_displacement += controls.dt * controls.drive_velocity;
  return reaction;
}

void load_pass(const Model& model, const State& state, const WallView& wall) {
  // Only loaded blocks are touched: cleared first, then summed in the stages' order.
  for (const Stage& stage : model.stages)
    for (const PointLoad& load : stage.loads)
      wall.load_x[load.block] = wall.load_y[load.block] = wall.load_m[load.block] = 0;
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const double scale = state.load_scale[k];
    if (scale == 0) continue;
    for (const PointLoad& load : model.stages[k].loads) add_load(load, scale, wall);
  }
}

void choose_driven(const Model& model, const WallView& wall, const std::vector<BlockId>& blocks) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) wall.is_free[i] = 1.0;
  for (const BlockId block : blocks) wall.is_free[static_cast<std::size_t>(block)] = 0.0;
}

}  // namespace wythe::dynamics
