// A wall and its states as arrays of a page (wall.* and frame.*; web/src/wall.ts reads them).
// Deformable blocks follow the rigid ones and their contacts the joints, in every array of either. A wall in
// space has space.* in place of most of wall.* (space_arrays.cpp).
#pragma once

#include <string>
#include <vector>

#include "report/bundle.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"

namespace wythe::report {

// Shapes at the start: blocks, joints, supports, what is pushed. Header: "wall".
void add_wall(Bundle& bundle, const Model& model);
// What varies within the wall: of each joint or block, in the unit it is shown in. Header: "wall.fields".
// In a campaign each `sample` has its own.
void add_fields(Bundle& bundle, const ModelSpec& spec, const Model& model, int sample = 0);

// How many of a sample's states go along, the last ones: all of them where the last of every sample
// that follows still has room, else the last alone.
[[nodiscard]] int states_kept(int states, int room, int samples_after);

// Which states of a run go along where no more than `most` fit: all that are labelled, and of the others as
// many as there is room for, evenly spread.
[[nodiscard]] std::vector<bool> states_shown(const std::vector<bool>& labelled, int most);
// Numbers of a page that one state takes, without forces of joints, which a run alone has.
[[nodiscard]] double state_numbers(const Model& model);

// Bodies and joint faces of a wall in space. Header: "wall.space", to go into `wall`.
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

// States in the order they are to be shown; every one has the same blocks and joints.
class FrameArrays {
 public:
  // With forces: compression, shear and eccentricity of every joint as well, and what sections of frames carry.
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
