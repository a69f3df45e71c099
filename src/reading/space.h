// Points and joints of walls in space, read as those of plane walls (joints.cpp).
#pragma once

#include "wythe/parts/reading.h"

namespace wythe::reading {

// How far the points of a joint are apart along t1, t2 and n, as the law sees them [m].
[[nodiscard]] std::vector<Vec3> gaps_in_space(const Model& model, const State& state,
                                              JointId joint);
// How far a place of a body has moved, `arm` from its centroid; a support as it was driven.
[[nodiscard]] Vec3 moved_in_space(const Model& model, const State& state, BlockId body, Vec3 arm);
[[nodiscard]] std::vector<PointReading> points_in_space(const Model& model, const State& state);
[[nodiscard]] JointReading joint_in_space(const Model& model, JointId joint,
                                          const std::vector<PointReading>& points);
// Whether a joint is pressed and has slid by more than half of its own size; on a support, off the box round it.
[[nodiscard]] bool slid_off_in_space(const Model& model, const std::vector<PointReading>& points,
                                     JointId joint);

}  // namespace wythe::reading
