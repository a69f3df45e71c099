#include "dynamics/lane_step.h"

#include <algorithm>
#include <array>

#include "contact/parameters.h"
#include "dynamics/shifted.h"
#include "dynamics/step_arrays.h"

namespace wythe::dynamics {
namespace {

// The widest set that fills no more than the lanes.
const Kernels& kernels_for(int lanes) {
  const Kernels* widest = &scalar_kernels();
  for (const Kernels* set : kernels_here())
    if (set->width <= lanes) widest = set;
  return *widest;
}

}  // namespace

bool fit_together(const Model& a, const Model& b) {
  return a.topology == b.topology && a.n_face_point == 2;
}

LaneStepper::LaneStepper(const Model& model, int lanes)
    : model_(model),
      lanes_(lanes),
      kernels_(kernels_for(lanes)),
      wall_(at(lanes)),
      work_(model, lanes),
      all_(initial_state(model)) {
  for (const StateField& field : kStateFields)
    (all_.*field.array).assign((all_.*field.array).size() * at(lanes), 0.0);
  const auto in_all_lanes = [&](const std::vector<double>& of_block) {
    std::vector<double> all;
    for (const double value : of_block) all.insert(all.end(), at(lanes), value);
    return all;
  };
  mass_ = in_all_lanes(model.mass);
  heavy_mass_ = in_all_lanes(model.heavy_mass);
  inertia_ = in_all_lanes(model.inertia);
  node_mass_ = in_all_lanes(model.solids.node_mass);
  node_heavy_mass_ = in_all_lanes(model.solids.node_heavy_mass);
  for (auto* array : {&dt_, &damping_, &mass_scaling_, &gravity_x_, &gravity_y_})
    array->assign(at(lanes), 0.0);
  for (int lane = 0; lane < lanes; ++lane) set(lane, {});
  turn_pass();
}

void LaneStepper::put(int lane, const Model& model, State& state) {
  wall_[at(lane)] = {&model, &state, {}, 0};
  copy_in(lane, state);
  const auto into_lane = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i * at(lanes_) + at(lane)] = from[i];
  };
  into_lane(model.mass, mass_);
  into_lane(model.heavy_mass, heavy_mass_);
  into_lane(model.inertia, inertia_);
  into_lane(model.solids.node_mass, node_mass_);
  into_lane(model.solids.node_heavy_mass, node_heavy_mass_);
  const std::vector<double> none(at(model.n_block), 0.0);
  for (auto* array : {&work_.load_x, &work_.load_y, &work_.load_m}) into_lane(none, *array);
  for (std::size_t m = 0; m < model.materials.size(); ++m)
    work_.law[m * at(lanes_) + at(lane)] = contact::constants_of(model.materials[m]);
  turn_pass();
}

void LaneStepper::drop(int lane) {
  Wall& wall = wall_[at(lane)];
  copy_out(lane, *wall.state);
  wall = {};
  set(lane, {});
}

std::unique_ptr<Place> LaneStepper::place(int lane) {
  return std::make_unique<ViewPlace>(*wall_[at(lane)].model, wall_view(work_, all_, lanes_, lane),
                                     [this, lane](State& state) { copy_out(lane, state); });
}

void LaneStepper::set(int lane, const Controls& controls) {
  wall_[at(lane)].controls = controls;
  dt_[at(lane)] = controls.dt;
  damping_[at(lane)] = controls.damping;
  mass_scaling_[at(lane)] = controls.mass_scaling;
}

void LaneStepper::copy_in(int lane, const State& state) {
  for (const StateField& field : kStateFields) {
    const Strided to{(all_.*field.array).data() + lane, lanes_};
    for (std::size_t i = 0; i < (state.*field.array).size(); ++i) to[i] = (state.*field.array)[i];
  }
}

void LaneStepper::copy_out(int lane, State& state) const {
  for (const StateField& field : kStateFields) {
    const double* from = (all_.*field.array).data() + lane;
    for (double& value : state.*field.array) {
      value = *from;
      from += lanes_;
    }
  }
}

void LaneStepper::step() {
  joint_pass();
  zone_pass();
  zone_contact_pass();
  gather_pass();
  gather_zone_contacts(model_, work_, lanes_);
  for (int lane = 0; lane < lanes_; ++lane)
    if (const Wall& wall = wall_[at(lane)]; wall.model != nullptr)
      load_pass(*wall.model, *wall.state, wall_view(work_, all_, lanes_, lane));
  for (int lane = 0; lane < lanes_; ++lane) {
    const State* state = wall_[at(lane)].state;
    gravity_x_[at(lane)] = state == nullptr ? 0.0 : state->gravity_x;
    gravity_y_[at(lane)] = state == nullptr ? 0.0 : state->gravity_y;
  }
  move_pass();
  node_pass();
  for (int lane = 0; lane < lanes_; ++lane)
    if (Wall& wall = wall_[at(lane)]; wall.model != nullptr)
      wall.reaction =
          drive_pass(*wall.model, *wall.state, wall_view(work_, all_, lanes_, lane), wall.controls);
  turn_pass();
  for (int lane = 0; lane < lanes_; ++lane)
    if (const Wall& wall = wall_[at(lane)]; wall.model != nullptr) {
      add_energies(work_, lanes_, lane, *wall.state);
      advance_clock(*wall.state, wall.controls);
    }
}

void LaneStepper::joint_pass() {
  const JointArrays arrays = joint_arrays(model_, work_, all_);
  for (std::size_t c = 0; c < work_.joint_chunks.size(); ++c) {
    const JointChunk& chunk = work_.joint_chunks[c];
    const auto begin = static_cast<std::size_t>(chunk.begin);
    const auto material = static_cast<std::size_t>(model_.joint_material[begin]);
    sum_joints(c, work_.joint_energy, [&](int lane, const JointEnergy& energy) {
      kernels_.wall_joints(shifted(arrays, lane), lanes_,
                           &work_.law[material * at(lanes_) + at(lane)], chunk.on_ground, begin,
                           static_cast<std::size_t>(chunk.end), energy);
    });
  }
}

void LaneStepper::gather_pass() {
  const GatherArrays arrays = gather_arrays(model_, work_);
  for (int lane = 0; lane < lanes_; lane += kernels_.width)
    kernels_.wall_gather(shifted(arrays, lane), lanes_, 0,
                         static_cast<std::size_t>(model_.n_block));
}

MoveControls LaneStepper::move_controls(int lane) const {
  return {&dt_[at(lane)], &damping_[at(lane)], &mass_scaling_[at(lane)], &gravity_x_[at(lane)],
          &gravity_y_[at(lane)]};
}

void LaneStepper::move_pass() {
  BlockArrays arrays = block_arrays(model_, work_, all_);
  arrays.mass = mass_.data();
  arrays.heavy_mass = heavy_mass_.data();
  arrays.inertia = inertia_.data();
  for (int c = 0; c < work_.block_chunks; ++c) {
    const Range range = block_range(model_, c);
    sum_blocks(at(c), work_.block_energy, [&](int lane, const BlockEnergy& energy) {
      kernels_.wall_move(shifted(arrays, lane), lanes_, move_controls(lane), range.begin, range.end,
                         energy);
    });
  }
}

void LaneStepper::turn_pass() {
  const BlockArrays arrays = block_arrays(model_, work_, all_);
  for (int lane = 0; lane < lanes_; lane += kernels_.width)
    kernels_.wall_turn(shifted(arrays, lane), lanes_, 0, static_cast<std::size_t>(model_.n_block));
}

}  // namespace wythe::dynamics
