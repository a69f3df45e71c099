#include "model/deformed.h"

#include <cmath>

namespace wythe {
namespace {

// Place of the point that started at `arm` from the centroid of `block`.
PlacedPoint place(const Model& model, const State& state, BlockId block, PlacedPoint arm,
                  double scale) {
  // magnified rotations stay rotations up to a quarter turn; beyond, blocks would spin
  const double limit = 1.5707963267948966;
  const double turn = state.theta[block] * scale;
  const double theta = std::abs(state.theta[block]) > limit
                           ? state.theta[block]
                           : std::fmin(std::fmax(turn, -limit), limit);
  const double c = std::cos(theta);
  const double s = std::sin(theta);
  return {model.centroid_x[block] + scale * state.ux[block] + c * arm.x - s * arm.y,
          model.centroid_y[block] + scale * state.uy[block] + s * arm.x + c * arm.y};
}

}  // namespace

std::vector<PlacedPoint> placed_outline(const Model& model, const State& state, BlockId block,
                                        double scale) {
  const Anatomy& anatomy = model.anatomy;
  std::vector<PlacedPoint> outline;
  for (int i = anatomy.outline_begin[block]; i < anatomy.outline_begin[block + 1]; ++i) {
    const PlacedPoint arm = {anatomy.outline_x[i] - model.centroid_x[block],
                             anatomy.outline_y[i] - model.centroid_y[block]};
    outline.push_back(place(model, state, block, arm, scale));
  }
  return outline;
}

PlacedPoint placed_node(const Model& model, const State& state, int node, double scale) {
  const auto i = static_cast<std::size_t>(node);
  return {model.solids.node_x[i] + scale * state.node_ux[i],
          model.solids.node_y[i] + scale * state.node_uy[i]};
}

std::array<PlacedPoint, 2> placed_contact(const Model& model, const State& state, int contact,
                                          double scale) {
  const Solids& s = model.solids;
  const auto c = static_cast<std::size_t>(contact);
  const PlacedPoint p = placed_node(model, state, s.contact_p[c], scale);
  const PlacedPoint q = placed_node(model, state, s.contact_q[c], scale);
  const auto between = [&](double share) {
    return PlacedPoint{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
  };
  return {between(s.share_0[c]), between(s.share_1[c])};
}

std::array<PlacedPoint, 2> placed_joint(const Model& model, const State& state, JointId joint,
                                        double scale) {
  const BlockId a = model.joint_a[joint];
  const BlockId b = model.joint_b[joint];
  std::array<PlacedPoint, 2> ends;
  for (int side : {0, 1}) {
    const double sign = side == 0 ? -1 : 1;
    const PlacedPoint arm_b = {model.arm_b_x[joint] + sign * model.half_x[joint],
                               model.arm_b_y[joint] + sign * model.half_y[joint]};
    const PlacedPoint on_b = place(model, state, b, arm_b, scale);
    PlacedPoint on_a = {model.centroid_x[b] + arm_b.x, model.centroid_y[b] + arm_b.y};
    if (a != kGroundBlock) {
      const PlacedPoint arm_a = {model.arm_a_x[joint] + sign * model.half_x[joint],
                                 model.arm_a_y[joint] + sign * model.half_y[joint]};
      on_a = place(model, state, a, arm_a, scale);
    }
    ends[side] = {(on_a.x + on_b.x) / 2, (on_a.y + on_b.y) / 2};
  }
  return ends;
}

}  // namespace wythe
