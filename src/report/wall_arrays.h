// A wall and its states as arrays of a page (wall.* and frame.*; web/src/wall/wall.ts reads
// them). Deformable blocks follow the rigid ones, and their contacts follow the joints, in
// all arrays. A wall in space has space.* instead of most of wall.* (space_arrays.cpp).
#pragma once

#include <vector>

#include "report/bundle.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe::report {

// Shapes at the start: blocks, joints, supports, pushed blocks. Header: "wall".
void add_wall(Bundle& bundle, const Model& model);
// Fields within the wall: values of each joint or block, in the displayed
// unit. Header: "wall.fields". In a campaign each `sample` has its own.
void add_fields(Bundle& bundle, const ModelSpec& spec, const Model& model, int sample = 0);

// How many of a sample's states are kept, counted from the last: all if
// the last state of every later sample still fits, else only the last.
[[nodiscard]] int states_kept(int states, int room, int samples_after);

// The states of a run that are kept, where only `most` fit: all
// labelled ones, and others evenly spaced as far as there is space.
[[nodiscard]] std::vector<bool> states_shown(const std::vector<bool>& labelled, int most);
// Numbers in a page for one state, without forces of joints, which only a run has.
[[nodiscard]] double state_numbers(const Model& model);

// Bodies and joint faces of a wall in space. Header: "wall.space", to be put into `wall`.
void add_space(Bundle& bundle, const Model& model, Json& wall);

// States of a wall in space.
class SpaceFrames {
 public:
  void add(const Model& model, const State& state);
  void write(Bundle& bundle, int count) const;

 private:
  std::vector<double> moved_, turned_;           // (n_frame, n_body, 3) [m], [rad]
  std::vector<double> opening_, slip_, stress_;  // (n_frame, n_joint) [m], [m], [Pa]
  std::vector<std::uint8_t> damage_, crushing_;
  std::vector<double> link_force_;        // (n_frame, n_link) tension + [N]
  std::vector<std::uint8_t> link_state_;  // the same: 0 holds, 1 slack or a gap, 2 yielded
};

// States in the order of display; all have the same blocks and joints.
class FrameArrays {
 public:
  // With forces: also compression, shear and eccentricity of every joint, and the forces of frame sections.
  explicit FrameArrays(bool with_forces) : with_forces_(with_forces) {}
  void add(const Model& model, const State& state);
  [[nodiscard]] int count() const { return count_; }
  void write(Bundle& bundle) const;

 private:
  bool with_forces_;
  int count_ = 0;
  std::vector<double> ux_, uy_, turned_;     // (n_frame, n_block) [m], [m], [rad]
  std::vector<double> node_ux_, node_uy_;    // (n_frame, n_node) of zones [m]
  std::vector<double> greater_, smaller_;    // (n_frame, n_zone) principal stresses, tension + [Pa]
  std::vector<double> opening_, slip_;       // (n_frame, n_joint) largest of a joint's points [m]
  std::vector<double> compression_, shear_;  // [N]
  std::vector<double> eccentricity_;         // of the compression, over half the face, -1 to 1
  std::vector<std::uint8_t> damage_, crushing_;
  std::vector<double> link_force_;                      // (n_frame, n_link) tension + [N]
  std::vector<double> section_normal_, section_shear_;  // (n_frame, n_section) of frames [N]
  std::vector<double> section_moment_, section_use_;    // [N m], share; signs as in FrameReading
  bool in_space_ = false;
  SpaceFrames space_;  // in space these and the sections' alone
};

}  // namespace wythe::report
