// A wall in space stepped by a test, without stages, in any frame: in_frame() turns
// bodies and pushes; gravity is that of the state. After run() and step() the state's
// arrays are up to date. After a change of them, put() passes them to the executor.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "dynamics/space/executor.h"
#include "scenes/scenes.h"
#include "scenes/solids.h"
#include "wythe/parts/model.h"
#include "wythe/parts/reading.h"

namespace wythe::scenes {

class SpaceRig {
 public:
  explicit SpaceRig(Model built)
      : model(std::move(built)), state(initial_state(model)), processor(model, 1) {
    controls.damping = model.solve.damping;
    controls.dt = 0.8 * 2 / (model.omega_max * std::sqrt(1 + controls.damping));
    load_state();
  }
  SpaceRig(const SpaceRig&) = delete;
  SpaceRig& operator=(const SpaceRig&) = delete;

  void load_state() {
    processor.load_wall(0, model, state);
    processor.set(0, controls);
    processor.access(0)->choose_driven(driven_);
  }
  double step() {
    const double reaction = advance();
    processor.access(0)->store_state(state);
    return reaction;
  }
  // The same without copying motion and history to the state: many times faster.
  double advance() {
    processor.set(0, controls);
    processor.step();
    return processor.reaction(0);
  }
  void store_state() { processor.access(0)->store_state(state); }
  void run(double seconds) {
    const auto steps = static_cast<std::int64_t>(std::ceil(seconds / controls.dt - 1e-9));
    for (std::int64_t k = 0; k < steps; ++k) advance();
    store_state();
  }
  // Drives the first push stage's blocks along its direction.
  void drive(std::size_t stage, double velocity) {
    controls.push = &model.stages[stage];
    controls.drive_velocity = velocity;
    if (driven_ == model.stages[stage].driven) return;
    driven_ = model.stages[stage].driven;
    processor.access(0)->choose_driven(driven_);
  }
  [[nodiscard]] Vec3 moved(std::size_t i) const { return {state.ux[i], state.uy[i], state.uz[i]}; }
  [[nodiscard]] Vec3 momentum(std::size_t i) const {  // angular
    return {state.lx[i], state.ly[i], state.lz[i]};
  }
  void set_momentum(std::size_t i, Vec3 l) {
    state.lx[i] = l.x, state.ly[i] = l.y, state.lz[i] = l.z;
  }
  void set_velocity(std::size_t i, Vec3 v) {
    state.vx[i] = v.x, state.vy[i] = v.y, state.vz[i] = v.z;
  }
  void set_gravity(Vec3 g) { state.gravity_x = g.x, state.gravity_y = g.y, state.gravity_z = g.z; }
  [[nodiscard]] Quaternion<double> turn(std::size_t i) const {
    return {state.qw[i], {state.qx[i], state.qy[i], state.qz[i]}};
  }
  // A vector of a block in the block's own axes; the moment I w.
  [[nodiscard]] Vec3 in_block(std::size_t i, Vec3 v) const {
    const Vector<double> b = turned_back(turn(i), Vector<double>{v.x, v.y, v.z});
    return {b.x, b.y, b.z};
  }
  [[nodiscard]] Vec3 out_of_block(std::size_t i, Vec3 v) const {
    const Vector<double> b = wythe::turned(turn(i), Vector<double>{v.x, v.y, v.z});
    return {b.x, b.y, b.z};
  }

  Model model;
  State state;
  dynamics::space::SpaceProcessor processor;
  dynamics::Controls controls;

 private:
  std::vector<BlockId> driven_;
};

// Bodies and pushes seen in another frame.
[[nodiscard]] inline ModelSpec in_frame(ModelSpec spec, const Frame& frame) {
  for (BodySpec& body : spec.body) body = frame.body(body);
  for (StageSpec& stage : spec.stage)
    if (auto* along = along_of(stage); along && along->size() == 3) {
      const Vec3 d = frame.direction({(*along)[0], (*along)[1], (*along)[2]});
      *along = {d.x, d.y, d.z};
    }
  return spec;
}
inline std::size_t add_load(Model& model, BlockId block, Vec3 arm, Vec3 force) {
  return add_load(model, {block, arm.x, arm.y, force.x, force.y, arm.z, force.z});
}

}  // namespace wythe::scenes
