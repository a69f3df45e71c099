// The passes of the step over deformable blocks: zones, their contacts with rigid blocks, nodes.
//
// A contact's two points stand on a face of a rigid block a and on an edge p-q of a zone. The frame
// turns with a, and both forces act where the edge's point is now:
//
//   j = x_edge - x_face,  w = j . n(theta_a),  s = j . t(theta_a)
//   f = area/2 (sigma n + tau t) on a at x_edge, -f on the edge, (1 - share) to p and share to q
//
// This is exactly work-conjugate to w and s and keeps linear and angular momentum.
#pragma once

#include "dynamics/blocks.h"
#include "dynamics/forces.h"
#include "solids/zone.h"

namespace wythe::dynamics {

// Zones begin..end-1, all of one shape.
template <class Access>
WYTHE_BOTH void zone_run(const ZoneArrays& v, Access access, const ZoneShape& shape,
                         std::size_t begin, std::size_t end) {
  using Real = typename Access::Real;
  for (std::size_t z = begin; z < end; z += Access::advance) {
    solids::ZoneVectors<Real> u;
    for (int k = 0; k < 4; ++k) {
      u.x[k] = access.of(v.ux, v.corner[k], z);
      u.y[k] = access.of(v.uy, v.corner[k], z);
    }
    const solids::ZoneVectors<Real> f = solids::zone_force(shape, u);
    access.keep_rows({f.x[0], f.y[0], f.x[1], f.y[1]}, v.low_force, z);
    access.keep_rows({f.x[2], f.y[2], f.x[3], f.y[3]}, v.high_force, z);
  }
}

// Displacement and place of one point on both sides.
template <class Real>
struct EdgePoint {
  Real jump_x, jump_y;  // edge against face
  Real arm_x, arm_y;    // of the edge's point, from a's centroid
};

template <class Real>
[[nodiscard]] WYTHE_INLINE EdgePoint<Real> edge_point(const Rows<Real>& pose, Real arm_x,
                                                      Real arm_y, Real edge_x, Real edge_y) {
  const Real c = pose.c2, s = pose.c3;
  const Real drop = Real(-2.0) * s * s, sine = Real(2.0) * s * c;
  const Real dx = drop * arm_x - sine * arm_y, dy = sine * arm_x + drop * arm_y;
  const Real jx = edge_x - (pose.c0 + dx), jy = edge_y - (pose.c1 + dy);
  return {jx, jy, arm_x + dx + jx, arm_y + dy + jy};
}

template <class V, class Access, class Real>
WYTHE_INLINE void edge_force(const EdgeArrays& v, Access access,
                             const contact::LawConstants<Real>& law, std::size_t c,
                             JointWork<Real>& work) {
  const Real one(1.0), half(0.5);
  const Rows<Real> pose = access.rows(v.joint.pose, v.block, c);
  const Real share_0 = access.shared(v.share_0, c), share_1 = access.shared(v.share_1, c);
  const Real px = access.of(v.ux, v.p, c), py = access.of(v.uy, v.p, c);
  const Real qx = access.of(v.ux, v.q, c), qy = access.of(v.uy, v.q, c);
  const auto on_edge = [&](Real from, Real to, Real share) __attribute__((always_inline)) {
    return (one - share) * from + share * to;
  };
  const EdgePoint<Real> e0 =
      edge_point(pose, access.shared(v.arm_0_x, c), access.shared(v.arm_0_y, c),
                 on_edge(px, qx, share_0), on_edge(py, qy, share_0));
  const EdgePoint<Real> e1 =
      edge_point(pose, access.shared(v.arm_1_x, c), access.shared(v.arm_1_y, c),
                 on_edge(px, qx, share_1), on_edge(py, qy, share_1));
  // t turned by theta_a; n on its left
  const Real cosine = one - Real(2.0) * pose.c3 * pose.c3, sine = Real(2.0) * pose.c3 * pose.c2;
  const Real tx0 = access.shared(v.tangent_x, c), ty0 = access.shared(v.tangent_y, c);
  const Real tx = cosine * tx0 - sine * ty0, ty = sine * tx0 + cosine * ty0;
  const Real n0 = e0.jump_y * tx - e0.jump_x * ty, t0 = e0.jump_x * tx + e0.jump_y * ty;
  const Real n1 = e1.jump_y * tx - e1.jump_x * ty, t1 = e1.jump_x * tx + e1.jump_y * ty;
  const FaceForce<Real> f = face_force<V, 2, false>(
      v.joint, access, law, c,
      FaceJump<Real>{half * (n0 + n1), half * (t0 + t1), half * (n1 - n0), half * (t1 - t0)}, work);
  // sums back to the points, in the wall's axes
  const Real fn0 = half * (f.fn - f.gn), fn1 = half * (f.fn + f.gn);
  const Real ft0 = half * (f.ft - f.gt), ft1 = half * (f.ft + f.gt);
  const Real x0 = ft0 * tx - fn0 * ty, y0 = ft0 * ty + fn0 * tx;
  const Real x1 = ft1 * tx - fn1 * ty, y1 = ft1 * ty + fn1 * tx;
  const Real moment = (e0.arm_x * y0 - e0.arm_y * x0) + (e1.arm_x * y1 - e1.arm_y * x1);
  access.keep_rows({x0 + x1, y0 + y1, moment, Real(0.0)}, v.block_force, c);
  const Real to_q_x = share_0 * x0 + share_1 * x1, to_q_y = share_0 * y0 + share_1 * y1;
  access.keep_rows({to_q_x - (x0 + x1), to_q_y - (y0 + y1), Real(0.0) - to_q_x, Real(0.0) - to_q_y},
                   v.edge_force, c);
}

// Forces of zones and contacts on node i of wall `wall` of `walls`, in the order of its lists.
struct NodeSums {
  const std::int32_t *zone_begin, *zone_entry, *contact_begin, *contact_entry;
  const double *zone_force, *edge_force;
  double *total_x, *total_y;
};
WYTHE_INLINE void sum_on_node(const NodeSums& v, std::size_t i, std::ptrdiff_t walls,
                              std::ptrdiff_t wall) {
  double x = 0, y = 0;
  const auto add = [&](const std::int32_t* begin, const std::int32_t* list, const double* force) {
    for (auto e = begin[i]; e < begin[i + 1]; ++e) {
      const double* at = force + list[e] * walls + wall;
      x += at[0];
      y += at[walls];
    }
  };
  add(v.zone_begin, v.zone_entry, v.zone_force);
  add(v.contact_begin, v.contact_entry, v.edge_force);
  v.total_x[static_cast<std::ptrdiff_t>(i) * walls + wall] = x;
  v.total_y[static_cast<std::ptrdiff_t>(i) * walls + wall] = y;
}

// Adds zone contact c's force to its rigid block, in the contacts' order, after the joints.
WYTHE_INLINE void gather_contact(const BlockId* contact_block, BlockId n_block, const double* force,
                                 double* contact_x, double* contact_y, double* contact_m, int c,
                                 std::ptrdiff_t walls, std::ptrdiff_t wall) {
  if (contact_block[c] == n_block) return;
  const std::ptrdiff_t i = contact_block[c] * walls + wall;
  const double* row = force + 4 * c * walls + wall;
  contact_x[i] += row[0];
  contact_y[i] += row[walls];
  contact_m[i] += row[2 * walls];
}

// The nodes a Real takes from i on.
template <class Access, class Real>
WYTHE_INLINE void move_node(const NodeArrays& v, Access access, const MoveControls& controls,
                            std::size_t i, BlockWork<Real>& work) {
  const Real dt = access.of_wall(controls.dt), damping = access.of_wall(controls.damping);
  const Real heavy = access.own(v.heavy_mass, i);
  const Real rate = dt / (access.own(v.mass, i) * access.of_wall(controls.mass_scaling));
  const Real load_x = heavy * access.of_wall(controls.gravity_x);
  const Real load_y = heavy * access.of_wall(controls.gravity_y);
  const Real fx = access.shared(v.free_x, i) * (access.own(v.total_x, i) + load_x);
  const Real fy = access.shared(v.free_y, i) * (access.own(v.total_y, i) + load_y);
  access.keep(fx, v.total_x, i);
  access.keep(fy, v.total_y, i);
  const auto advance = [&](double* velocity, double* place, Real force)
      __attribute__((always_inline)) {
    const Moved<Real> moved = accelerate(access.own(velocity, i), force, rate, dt, damping);
    access.keep(moved.velocity, velocity, i);
    access.keep(access.own(place, i) + dt * moved.velocity, place, i);
    return moved;
  };
  const Moved<Real> x = advance(v.vx, v.ux, fx);
  const Moved<Real> y = advance(v.vy, v.uy, fy);
  work = {work.loads + dt * (load_x * x.mean_velocity + load_y * y.mean_velocity),
          work.damping + (x.damping_work + y.damping_work)};
}

template <class Access>
void node_run(const NodeArrays& v, Access access, const MoveControls& controls, std::size_t begin,
              std::size_t end, const BlockEnergy& energy) {
  BlockWork<typename Access::Real> work[Access::packs];
  load_work(access, energy, work);
  int k = 0;
  for (std::size_t i = begin; i < end; i += Access::advance) {
    move_node(v, access, controls, i, work[k]);
    k = (k + 1) % Access::packs;
  }
  store_work(access, work, energy);
}

// Contacts begin..end-1, all of one law.
template <class V, class Access>
void edge_run(const EdgeArrays& v, Access access, const contact::LawConstants<double>* constants,
              std::size_t begin, std::size_t end, const JointEnergy& energy) {
  using Real = typename Access::Real;
  const contact::LawConstants<Real> law = law_of<Real>(constants, access);
  JointWork<Real> work[Access::packs];
  load_work(access, energy, work);
  int k = 0;
  for (std::size_t c = begin; c < end; c += Access::advance) {
    edge_force<V>(v, access, law, c, work[k]);
    k = (k + 1) % Access::packs;
  }
  store_work(access, work, energy);
}

}  // namespace wythe::dynamics
