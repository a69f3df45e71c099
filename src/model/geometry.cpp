// The two tables, for walls in the plane and in space. Only geometry_of() tests which kind a model is.
#include "model/geometry.h"

#include <algorithm>

#include "geometry/bodies/joint_faces.h"
#include "model/parts.h"
#include "model/shaking.h"
#include "model/space/space.h"

namespace wythe {
namespace {

std::pair<double, double> heights_in_plane(const Model& m, BlockId b) {
  const Anatomy& a = m.anatomy;
  const auto [low, high] = std::minmax_element(a.outline_y.begin() + a.outline_begin[b],
                                               a.outline_y.begin() + a.outline_begin[b + 1]);
  return {*low, *high};
}

std::pair<double, double> heights_in_space(const Model& m, BlockId b) {
  const geometry::Box3 box = geometry::box_of(m.space.body[b]);
  return {box.low.y, box.high.y};
}

constexpr Geometry kPlane{
    .dimension = 2,
    .centroid =
        [](const Model& m, BlockId i) {
          return Vec3{m.centroid_x[i], m.centroid_y[i]};
        },
    .normal =
        [](const Model& m, JointId j) {
          return Vec3{-m.tangent_y[j], m.tangent_x[j]};
        },
    .heights = heights_in_plane,
    .first_period = [](const Model& m, Vec3 along) { return first_period(m, along.x, along.y); },
    .dashpot_rate = dashpot_rate};

constexpr Geometry kSpace{.dimension = 3,
                          .centroid = [](const Model& m, BlockId i) { return m.space.centroid[i]; },
                          .normal = [](const Model& m, JointId j) { return m.space.normal[j]; },
                          .heights = heights_in_space,
                          .first_period = first_period_in_space,
                          .dashpot_rate = dashpot_rate_in_space};

}  // namespace

const Geometry& geometry_of(const Model& model) { return model.in_space() ? kSpace : kPlane; }

}  // namespace wythe
