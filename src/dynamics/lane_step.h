// One step of several walls side by side: wall k is lane k of every array and of every pack.
//
// The walls share blocks, joints and geometry; strengths, stiffnesses, masses, loads, state, time
// step and stage are each wall's own. The passes are those of step.h, through the same kernels, so
// that a wall's bits do not depend on its lane, its neighbours or the number of lanes.
//
//   joint, zone, gather, move, node, turn pass   all walls at once (zones: zone_pass.cpp)
//   load_pass, drive_pass, energies, clock       wall by wall: a few blocks each
#pragma once

#include <array>
#include <vector>

#include "dynamics/side_by_side.h"
#include "dynamics/step_arrays.h"
#include "dynamics/workspace.h"

namespace wythe::dynamics {

inline constexpr int kMostLanes = 8;

// True when two walls can be stepped side by side: one topology, one geometry, two points a face.
[[nodiscard]] bool fit_together(const Model& a, const Model& b);

class LaneStepper final : public SideBySide {
 public:
  // `lanes` 2, 4 or 8; `model` (copied) stands for all walls that fit it.
  LaneStepper(const Model& model, int lanes);

  [[nodiscard]] int lanes() const override { return lanes_; }
  [[nodiscard]] const Model& model() const override { return model_; }
  void put(int lane, const Model& model, State& state) override;
  void drop(int lane) override;
  [[nodiscard]] std::unique_ptr<Place> place(int lane) override;
  void set(int lane, const Controls& controls) override;
  void step() override;
  [[nodiscard]] double reaction(int lane) const override { return wall_[at(lane)].reaction; }

 private:
  struct Wall {
    const Model* model = nullptr;  // null: the lane is idle
    State* state = nullptr;
    Controls controls;
    double reaction = 0;
  };

  void joint_pass();
  void zone_pass();
  void zone_contact_pass();
  void gather_pass();
  void move_pass();
  void node_pass();
  void turn_pass();
  // Runs all lanes, a pack at a time, and sums what each has done into chunk c of `to`.
  template <class Run>
  void sum_joints(std::size_t c, std::vector<ChunkEnergy>& to, const Run& run);
  template <class Run>
  void sum_blocks(std::size_t c, std::vector<ChunkEnergy>& to, const Run& run);
  [[nodiscard]] MoveControls move_controls(int lane) const;
  void copy_in(int lane, const State& state);
  void copy_out(int lane, State& state) const;
  [[nodiscard]] static std::size_t at(int lane) { return static_cast<std::size_t>(lane); }

  const Model model_;
  const int lanes_;
  const Kernels& kernels_;
  std::vector<Wall> wall_;
  Workspace work_;
  State all_;  // its arrays hold all walls side by side; its numbers are unused

  // of each wall: (n_block, lanes), (n_node, lanes) and (lanes)
  std::vector<double> mass_, heavy_mass_, inertia_, node_mass_, node_heavy_mass_;
  std::vector<double> dt_, damping_, mass_scaling_, gravity_x_, gravity_y_;
};

template <class Run>
void LaneStepper::sum_joints(std::size_t c, std::vector<ChunkEnergy>& to, const Run& run) {
  std::array<double, 3 * kGroup * kMostLanes> sums{};
  double* friction = sums.data();
  double* fracture = friction + kGroup * lanes_;
  double* crushing = fracture + kGroup * lanes_;
  for (int lane = 0; lane < lanes_; lane += kernels_.width)
    run(lane, JointEnergy{friction + lane, fracture + lane, crushing + lane});
  for (int lane = 0; lane < lanes_; ++lane) {
    ChunkEnergy& energy = to[c * at(lanes_) + at(lane)];
    energy.friction = sum_of_groups(friction + lane, lanes_);
    energy.fracture = sum_of_groups(fracture + lane, lanes_);
    energy.crushing = sum_of_groups(crushing + lane, lanes_);
  }
}

template <class Run>
void LaneStepper::sum_blocks(std::size_t c, std::vector<ChunkEnergy>& to, const Run& run) {
  std::array<double, 2 * kGroup * kMostLanes> sums{};
  double* loads = sums.data();
  double* damping = loads + kGroup * lanes_;
  for (int lane = 0; lane < lanes_; lane += kernels_.width)
    run(lane, BlockEnergy{loads + lane, damping + lane});
  for (int lane = 0; lane < lanes_; ++lane) {
    ChunkEnergy& energy = to[c * at(lanes_) + at(lane)];
    energy.loads = sum_of_groups(loads + lane, lanes_);
    energy.damping = sum_of_groups(damping + lane, lanes_);
  }
}

}  // namespace wythe::dynamics
