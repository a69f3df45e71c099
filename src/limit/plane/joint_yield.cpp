// Sets a joint's strength by the assumed bond, friction and crushing, and approximates stress blocks (6.4) by tangents.
// A joint without tensile strength counts as broken: even "bonded" gives it residual cohesion and friction. Infinite
// strengths stay infinite. Each tangent touches the curve at the N of a solution outside of it.
#include "limit/plane/joint_yield.h"

#include <cmath>

#include "core/elementary.h"

namespace wythe::limit {
namespace {

double times_area(double strength, double area) {
  return std::isinf(strength) ? strength : strength * area;
}

}  // namespace

JointYield yield_of_joint(const JointMaterial& m, double area, const LimitOptions& o) {
  const bool bonded = o.strength == JointStrength::kBonded && m.tensile_strength > 0;
  const bool unlimited = std::isinf(m.tensile_strength);
  const bool damaged = o.strength == JointStrength::kBonded && !bonded;
  const bool residual = o.friction == FrictionChoice::kResidual || damaged;
  JointYield y;
  y.tension = bonded || unlimited ? times_area(m.tensile_strength, area) : 0.0;
  const bool sticks = bonded || std::isinf(m.cohesion);
  const double c_res = std::isfinite(m.residual_cohesion) ? m.residual_cohesion : 0.0;
  y.cohesion = times_area(sticks ? m.cohesion : c_res, area);
  y.friction = elementary::tan(residual ? m.residual_friction_angle : m.friction_angle);
  y.compression =
      o.crushing == CrushingChoice::kNone ? kUnlimited : times_area(m.compressive_strength, area);
  return y;
}

YieldModel yield_of(const Model& model, const LimitOptions& options, double times) {
  YieldModel yield;
  yield.stress_block = options.crushing == CrushingChoice::kStressBlock;
  const bool own_points = options.crushing == CrushingChoice::kPoints;
  yield.xi = own_points ? model.point_xi : std::vector<double>{-1, 1};
  yield.weight = own_points ? model.point_weight : std::vector<double>{0.5, 0.5};
  for (int j = 0; j < model.n_joint; ++j) {
    const JointMaterial& m = model.materials[model.joint_material[j]];
    JointYield y = yield_of_joint(m, times * model.area[j], options);
    y.half_length = elementary::hypot(model.half_x[j], model.half_y[j]);
    yield.joint.push_back(y);
  }
  for (std::size_t k = 0; k < model.links.a.size(); ++k)
    yield.link.push_back({times * model.links.tension[k], times * model.links.compression[k]});
  return yield;
}

int cut_stress_blocks(YieldModel& yield, const std::vector<double>& point_force) {
  constexpr double kTolerance = 1e-9;  // of C l: far below the accuracy of the load
  if (!yield.stress_block) return 0;
  int added = 0;
  for (std::size_t j = 0; j < yield.joint.size(); ++j) {
    const JointYield& y = yield.joint[j];
    if (std::isinf(y.compression) || std::isinf(y.tension)) continue;
    const double p0 = point_force[2 * j], p1 = point_force[2 * j + 1];
    const double n = p0 + p1, m = (p1 - p0) * y.half_length;
    const double span = y.compression + y.tension;
    const double bound = y.half_length * (n + y.tension) * (y.compression - n) / span;
    if (std::fabs(m) <= bound + kTolerance * y.compression * y.half_length) continue;
    const double slope = y.half_length * (y.compression - y.tension - 2 * n) / span;
    yield.tangent.push_back({static_cast<int>(j), m > 0 ? 1.0 : -1.0, slope, bound - slope * n});
    ++added;
  }
  return added;
}

void drop_idle_tangents(YieldModel& yield, const std::vector<double>& point_force) {
  constexpr double kTouches = 1e-7;  // of C l
  std::erase_if(yield.tangent, [&](const Tangent& t) {
    const std::size_t j = t.joint;
    const JointYield& y = yield.joint[j];
    const double p0 = point_force[2 * j], p1 = point_force[2 * j + 1];
    const double m = (p1 - p0) * y.half_length;
    return t.sign * m - t.slope * (p0 + p1) < t.capacity - kTouches * y.compression * y.half_length;
  });
}

}  // namespace wythe::limit
