// Functions that read each kind of wall: one table for walls in the plane, one for walls in space.
// Only readers_of() tests which kind a wall is; the functions of wythe/parts/reading.h call its table.
#pragma once

#include "reading/zones.h"
#include "wythe/parts/reading.h"

namespace wythe::reading {

struct Readers {
  int dimension;  // of places
  // constant data
  PointRange (*range)(const Model&, JointId);
  JointShape (*shape)(const Model&, JointId);
  std::vector<Vec3> (*corners)(const Model&, BlockId);
  double (*volume)(const Model&, BlockId);  // of a rigid block [m^3]
  // positions
  BlockReading (*block)(const Model&, const State&, BlockId);
  std::vector<Vec3> (*corners_now)(const Model&, const State&, BlockId);
  std::vector<Vec3> (*face)(const Model&, const State&, JointId, double scale);
  std::array<Vec3, 2> (*ends)(const Model&, const State&, JointId, double scale);
  Vec3 (*displacement)(const Model&, const State&, BlockId, Vec3 arm);
  double (*tilt)(const State&, BlockId);
  // deformations and forces
  std::vector<PointReading> (*points)(const Model&, const State&);
  JointReading (*joint)(const Model&, JointId, const std::vector<PointReading>&);
  bool (*slid_off)(const Model&, const std::vector<PointReading>&, JointId);
  Vec3 (*force)(const Model&, const JointReading&, const WallReading&);
  LinkReading (*link)(const Model&, const State&, std::size_t);
  std::vector<FrameReading> (*frames)(const Model&, const State&);
  std::vector<BeyondLimit> (*beyond_limits)(const Model&, const State&);
  LintelMeasures (*lintel)(const Model&, const State&);
};
[[nodiscard]] const Readers& readers_of(const Model& model);

// places.cpp
[[nodiscard]] PointRange range_in_plane(const Model& model, JointId joint);
[[nodiscard]] PointRange range_in_space(const Model& model, JointId joint);
[[nodiscard]] JointShape shape_in_plane(const Model& model, JointId joint);
[[nodiscard]] JointShape shape_in_space(const Model& model, JointId joint);
[[nodiscard]] std::vector<Vec3> corners_in_space(const Model& model, BlockId block);
[[nodiscard]] double volume_in_plane(const Model& model, BlockId block);
[[nodiscard]] double volume_in_space(const Model& model, BlockId block);
[[nodiscard]] BlockReading block_in_plane(const Model& model, const State& state, BlockId block);
[[nodiscard]] BlockReading block_in_space(const Model& model, const State& state, BlockId block);
[[nodiscard]] std::vector<Vec3> corners_now_in_plane(const Model&, const State&, BlockId);
[[nodiscard]] std::vector<Vec3> corners_now_in_space(const Model&, const State&, BlockId);
[[nodiscard]] std::vector<Vec3> face_in_plane(const Model&, const State&, JointId, double scale);
[[nodiscard]] std::vector<Vec3> face_in_space(const Model&, const State&, JointId, double scale);
[[nodiscard]] std::array<Vec3, 2> ends_in_plane(const Model&, const State&, JointId, double scale);
[[nodiscard]] std::array<Vec3, 2> ends_in_space(const Model&, const State&, JointId, double scale);
[[nodiscard]] Vec3 displacement_in_plane(const Model& model, const State& state, BlockId block,
                                         Vec3 arm);
[[nodiscard]] Vec3 displacement_in_space(const Model& model, const State& state, BlockId block,
                                         Vec3 arm);
[[nodiscard]] double tilt_in_plane(const State& state, BlockId block);
[[nodiscard]] double tilt_in_space(const State& state, BlockId block);
// joints.cpp
[[nodiscard]] std::vector<PointReading> points_in_plane(const Model& model, const State& state);
[[nodiscard]] JointReading joint_in_plane(const Model& model, JointId joint,
                                          const std::vector<PointReading>& points);
[[nodiscard]] bool slid_off_in_plane(const Model& model, const std::vector<PointReading>& points,
                                     JointId joint);
[[nodiscard]] Vec3 force_in_plane(const Model&, const JointReading&, const WallReading&);
// space.cpp
// Distances of a joint's points along t1, t2 and n, as the law receives them [m].
[[nodiscard]] std::vector<Vec3> gaps_in_space(const Model& model, const State& state,
                                              JointId joint);
// Displacement of a place of a body at `arm` from its centroid; of a support as it was driven.
[[nodiscard]] Vec3 moved_in_space(const Model& model, const State& state, BlockId body, Vec3 arm);
[[nodiscard]] std::vector<PointReading> points_in_space(const Model& model, const State& state);
[[nodiscard]] JointReading joint_in_space(const Model& model, JointId joint,
                                          const std::vector<PointReading>& points);
// Whether a joint is compressed and has slid by more than half its size; on a support, out of the box around it.
[[nodiscard]] bool slid_off_in_space(const Model& model, const std::vector<PointReading>& points,
                                     JointId joint);
[[nodiscard]] Vec3 force_in_space(const Model&, const JointReading&, const WallReading&);
// links.cpp
[[nodiscard]] LinkReading link_in_plane(const Model& model, const State& state, std::size_t link);
[[nodiscard]] LinkReading link_in_space(const Model& model, const State& state, std::size_t link);
// frames.cpp
[[nodiscard]] std::vector<FrameReading> frames_in_plane(const Model& model, const State& state);
[[nodiscard]] std::vector<FrameReading> frames_in_space(const Model& model, const State& state);
// zones.cpp
[[nodiscard]] std::vector<BeyondLimit> beyond_limits_in_plane(const Model&, const State&);
[[nodiscard]] LintelMeasures lintel_measures_in_plane(const Model& model, const State& state);

}  // namespace wythe::reading
