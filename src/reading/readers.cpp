// The two tables of readers.h, for walls in the plane and in space.
#include "reading/readers.h"

#include "model/geometry.h"
#include "reading/zones_in_space.h"

namespace wythe {
namespace reading {
namespace {

constexpr Readers kPlane{.dimension = 2,
                         .range = range_in_plane,
                         .shape = shape_in_plane,
                         .corners = outline_of,
                         .volume = volume_in_plane,
                         .block = block_in_plane,
                         .corners_now = corners_now_in_plane,
                         .face = face_in_plane,
                         .ends = ends_in_plane,
                         .displacement = displacement_in_plane,
                         .tilt = tilt_in_plane,
                         .points = points_in_plane,
                         .joint = joint_in_plane,
                         .slid_off = slid_off_in_plane,
                         .force = force_in_plane,
                         .link = link_in_plane,
                         .frames = frames_in_plane,
                         .beyond_limits = beyond_limits_in_plane,
                         .lintel = lintel_measures_in_plane};

constexpr Readers kSpace{.dimension = 3,
                         .range = range_in_space,
                         .shape = shape_in_space,
                         .corners = corners_in_space,
                         .volume = volume_in_space,
                         .block = block_in_space,
                         .corners_now = corners_now_in_space,
                         .face = face_in_space,
                         .ends = ends_in_space,
                         .displacement = displacement_in_space,
                         .tilt = tilt_in_space,
                         .points = points_in_space,
                         .joint = joint_in_space,
                         .slid_off = slid_off_in_space,
                         .force = force_in_space,
                         .link = link_in_space,
                         .frames = frames_in_space,
                         .beyond_limits = beyond_limits_in_space,
                         .lintel = lintel_measures_in_space};

}  // namespace

const Readers& readers_of(const Model& model) { return model.in_space() ? kSpace : kPlane; }

}  // namespace reading

using reading::readers_of;

int dimension_of(const Model& model) { return readers_of(model).dimension; }
PointRange points_of(const Model& model, JointId joint) {
  return readers_of(model).range(model, joint);
}
JointShape joint_shape(const Model& model, JointId joint) {
  return readers_of(model).shape(model, joint);
}
Vec3 centroid_of(const Model& model, BlockId block) {
  return geometry_of(model).centroid(model, block);
}
std::vector<Vec3> corners_of(const Model& model, BlockId block) {
  return readers_of(model).corners(model, block);
}
BlockReading read_block(const Model& model, const State& state, BlockId block) {
  return readers_of(model).block(model, state, block);
}
std::vector<Vec3> corners_now(const Model& model, const State& state, BlockId block) {
  return readers_of(model).corners_now(model, state, block);
}
std::vector<Vec3> face_now(const Model& model, const State& state, JointId joint, double scale) {
  return readers_of(model).face(model, state, joint, scale);
}
std::array<Vec3, 2> ends_now(const Model& model, const State& state, JointId joint, double scale) {
  return readers_of(model).ends(model, state, joint, scale);
}
Vec3 displacement_of(const Model& model, const State& state, BlockId block, Vec3 arm) {
  return readers_of(model).displacement(model, state, block, arm);
}
double tilt_of(const Model& model, const State& state, BlockId block) {
  return readers_of(model).tilt(state, block);
}
std::vector<PointReading> read_points(const Model& model, const State& state) {
  return readers_of(model).points(model, state);
}
bool has_slid_off(const Model& model, const std::vector<PointReading>& points, JointId joint) {
  return readers_of(model).slid_off(model, points, joint);
}
std::vector<FrameReading> read_frames(const Model& model, const State& state) {
  return readers_of(model).frames(model, state);
}
Vec3 force_of(const Model& model, const JointReading& joint, const WallReading& wall) {
  return readers_of(model).force(model, joint, wall);
}

}  // namespace wythe
