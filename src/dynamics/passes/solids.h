// Deformable blocks: zones, their contacts with rigid blocks, nodes (docs/theory/zones.md).
//
// A contact's two points stand on a face of a rigid block a and on an edge p-q of a zone. The frame
// turns with a, and both forces act where the edge's point is now:
//
//   j = x_edge - x_face,  w = j . n(theta_a),  s = j . t(theta_a)
//   f = area/2 (sigma n + tau t) on a at x_edge, -f on the edge, (1 - share) to p and share to q
//
// This is exactly work-conjugate to w and s and keeps linear and angular momentum.
#pragma once

#include "dynamics/passes/blocks.h"
#include "dynamics/passes/joints.h"
#include "solids/zone.h"

namespace wythe::dynamics {

// Zones of one shape: forces on their corners.
template <class A>
struct Zones {
  using Access = A;
  using Real = typename Access::Real;
  using Work = NoWork;

  const Tables& t;
  Access access;
  const ZoneShape& shape;

  WYTHE_INLINE Zones(const Tables& tables, Access lanes, const Chunk& chunk)
      : t(tables), access(lanes), shape(tables.shapes[chunk.material]) {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t z, Work&) const {
    solids::ZoneVectors<Real> u;
    for (int k = 0; k < 4; ++k) {
      u.x[k] = access.of(t.node, kNodeRows, kNodeUx, t.corner[k], z);
      u.y[k] = access.of(t.node, kNodeRows, kNodeUy, t.corner[k], z);
    }
    const solids::ZoneVectors<Real> f = solids::zone_force(shape, u);
    access.store_rows({f.x[0], f.y[0], f.x[1], f.y[1]}, t.zone_force, z);
    access.store_rows({f.x[2], f.y[2], f.x[3], f.y[3]}, t.high_force, z);
  }
};

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

// Contacts of zones of one law.
template <class V, class A>
struct Edges {
  using Access = A;
  using Real = typename Access::Real;
  using Work = JointWork<Real>;

  const Tables& t;
  FaceRun<Access> run;

  WYTHE_INLINE Edges(const Tables& tables, Access access, const Chunk& chunk)
      : t(tables), run(face_run(tables, access, chunk, tables.edge_law_path)) {}

  WYTHE_INLINE void select_part(int part) { run.access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t c, Work& work) const {
    const Real half(0.5);
    const Place e = place_of(c, run.access.rows(t.pose, t.edge_block, c), ends_of(c));
    const FaceForce<Real> f =
        face_force<V, 2, false>(run, c, geometry(c, kEdgeArea), e.jump, JumpBefore{this, c}, work);
    // from sums back to the points, in the wall's axes
    const Real fn0 = half * (f.fn - f.gn), fn1 = half * (f.fn + f.gn);
    const Real ft0 = half * (f.ft - f.gt), ft1 = half * (f.ft + f.gt);
    const Real x0 = ft0 * e.tx - fn0 * e.ty, y0 = ft0 * e.ty + fn0 * e.tx;
    const Real x1 = ft1 * e.tx - fn1 * e.ty, y1 = ft1 * e.ty + fn1 * e.tx;
    const Real moment = (e.e0.arm_x * y0 - e.e0.arm_y * x0) + (e.e1.arm_x * y1 - e.e1.arm_y * x1);
    run.access.store_rows({x0 + x1, y0 + y1, moment, Real(0.0)}, t.edge_block_force, c);
    const Real share_0 = geometry(c, kShare0), share_1 = geometry(c, kShare1);
    const Real to_q_x = share_0 * x0 + share_1 * x1, to_q_y = share_0 * y0 + share_1 * y1;
    run.access.store_rows(
        {to_q_x - (x0 + x1), to_q_y - (y0 + y1), Real(0.0) - to_q_x, Real(0.0) - to_q_y},
        t.edge_force, c);
  }

 private:
  // The ends of the edge [m].
  struct Ends {
    Real px, py, qx, qy;
  };
  // Both points of a contact, the present tangent, and the jump for the law.
  struct Place {
    EdgePoint<Real> e0, e1;
    Real tx, ty;
    FaceJump<Real> jump;
  };
  [[nodiscard]] WYTHE_INLINE Ends ends_of(std::ptrdiff_t c) const {
    return {node(kNodeUx, t.edge_p, c), node(kNodeUy, t.edge_p, c), node(kNodeUx, t.edge_q, c),
            node(kNodeUy, t.edge_q, c)};
  }
  [[nodiscard]] WYTHE_INLINE Place place_of(std::ptrdiff_t c, const Rows<Real>& pose,
                                            const Ends& end) const {
    const Real one(1.0), half(0.5);
    const Real share_0 = geometry(c, kShare0), share_1 = geometry(c, kShare1);
    const auto on_edge = [&](Real from, Real to, Real share) __attribute__((always_inline)) {
      return (one - share) * from + share * to;
    };
    Place p;
    p.e0 = edge_point(pose, geometry(c, kArm0X), geometry(c, kArm0Y),
                      on_edge(end.px, end.qx, share_0), on_edge(end.py, end.qy, share_0));
    p.e1 = edge_point(pose, geometry(c, kArm1X), geometry(c, kArm1Y),
                      on_edge(end.px, end.qx, share_1), on_edge(end.py, end.qy, share_1));
    // t turned by theta_a; n on its left
    const Real cosine = one - Real(2.0) * pose.c3 * pose.c3, sine = Real(2.0) * pose.c3 * pose.c2;
    const Real tx0 = geometry(c, kEdgeTangentX), ty0 = geometry(c, kEdgeTangentY);
    const Real tx = cosine * tx0 - sine * ty0, ty = sine * tx0 + cosine * ty0;
    p.tx = tx, p.ty = ty;
    const Real n0 = p.e0.jump_y * tx - p.e0.jump_x * ty, t0 = p.e0.jump_x * tx + p.e0.jump_y * ty;
    const Real n1 = p.e1.jump_y * tx - p.e1.jump_x * ty, t1 = p.e1.jump_x * tx + p.e1.jump_y * ty;
    p.jump = {half * (n0 + n1), half * (t0 + t1), half * (n1 - n0), half * (t1 - t0)};
    return p;
  }
  // The jump of the step before, for contacts that slide.
  struct JumpBefore {
    const Edges* edges;
    std::ptrdiff_t c;
    WYTHE_OUTLINE FaceJump<Real> operator()() const {
      const Edges& of = *edges;
      const Real dt = of.run.access.wall_value(of.t.wall, kTimeBefore);
      Ends end = of.ends_of(c);
      end.px = end.px - dt * of.node(kNodeVx, of.t.edge_p, c);
      end.py = end.py - dt * of.node(kNodeVy, of.t.edge_p, c);
      end.qx = end.qx - dt * of.node(kNodeVx, of.t.edge_q, c);
      end.qy = end.qy - dt * of.node(kNodeVy, of.t.edge_q, c);
      return of.place_of(c, pose_before(of.t, of.run.access, of.t.edge_block, c), end).jump;
    }
  };
  [[nodiscard]] WYTHE_INLINE Real geometry(std::ptrdiff_t c, EdgeRow row) const {
    return run.access.shared(t.edge, c * kEdgeRows + row);
  }
  [[nodiscard]] WYTHE_INLINE Real node(NodeRow row, const std::int32_t* id,
                                       std::ptrdiff_t c) const {
    return run.access.of(t.node, kNodeRows, row, id, c);
  }
};

// Nodes: adds forces of zones, then of contacts, in the order of their lists; then moves as blocks.
template <class A>
struct Nodes {
  using Access = A;
  using Real = typename Access::Real;
  using Work = BlockWork<Real>;

  const Tables& t;
  Access access;
  Real dt, damping, gravity_x, gravity_y;

  WYTHE_INLINE Nodes(const Tables& tables, Access lanes, const Chunk&)
      : t(tables),
        access(lanes),
        dt(access.wall_value(t.wall, kDt)),
        damping(access.wall_value(t.wall, kDamping)),
        gravity_x(access.wall_value(t.wall, kGravityX)),
        gravity_y(access.wall_value(t.wall, kGravityY)) {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t i, Work& work) const {
    const Real heavy = load_row(i, kNodeGravityMass), rate = load_row(i, kNodeRate);
    const Real load_x = heavy * gravity_x, load_y = heavy * gravity_y;
    Real sum_x, sum_y;
    gather(i, sum_x, sum_y);
    const Real fx = access.shared(t.node_free_x, i) * (sum_x + load_x);
    const Real fy = access.shared(t.node_free_y, i) * (sum_y + load_y);
    store_row(fx, i, kNodeTotalX);
    store_row(fy, i, kNodeTotalY);
    const auto advance = [&](NodeRow velocity, NodeRow place, Real force)
        __attribute__((always_inline)) {
      const Moved<Real> moved = accelerate(load_row(i, velocity), force, rate, dt, damping);
      store_row(moved.velocity, i, velocity);
      store_row(load_row(i, place) + dt * moved.velocity, i, place);
      return moved;
    };
    const Moved<Real> x = advance(kNodeVx, kNodeUx, fx);
    const Moved<Real> y = advance(kNodeVy, kNodeUy, fy);
    work = {work.loads + dt * (load_x * x.mean_velocity + load_y * y.mean_velocity),
            work.damping + (x.damping_work + y.damping_work)};
  }

 private:
  [[nodiscard]] WYTHE_INLINE Real load_row(std::ptrdiff_t i, NodeRow row) const {
    return access.load(t.node, i * kNodeRows + row);
  }
  WYTHE_INLINE void store_row(Real value, std::ptrdiff_t i, NodeRow row) const {
    access.store(value, t.node, i * kNodeRows + row);
  }

  // Entries are places of the x component in rows of four, y follows.
  template <class Add>
  WYTHE_INLINE void each_entry(std::ptrdiff_t i, const Add& add) const {
    for (auto e = t.node_zone_begin[i]; e < t.node_zone_begin[i + 1]; ++e)
      add(t.zone_force, t.node_zone_entry[e]);
    for (auto e = t.node_edge_begin[i]; e < t.node_edge_begin[i + 1]; ++e)
      add(t.edge_force, t.node_edge_entry[e]);
  }
  WYTHE_INLINE void gather(std::ptrdiff_t i, Real& sum_x, Real& sum_y) const {
    if constexpr (Access::one_wall) {
      using L = typename Access::L;
      double x[L::width] = {}, y[L::width] = {};
      for (int k = 0; k < L::width; ++k)
        each_entry(
            i * kGroup + access.lane + k, [&](const double* force, std::ptrdiff_t at)
                                              __attribute__((always_inline)) {
                                                x[k] += force[at];
                                                y[k] += force[at + 1];
                                              });
      sum_x = L::load(x);
      sum_y = L::load(y);
    } else {
      sum_x = sum_y = Real(0.0);
      each_entry(
          i, [&](const double* force, std::ptrdiff_t at) __attribute__((always_inline)) {
            sum_x = sum_x + access.load(force, at);
            sum_y = sum_y + access.load(force, at + 1);
          });
    }
  }
};

}  // namespace wythe::dynamics
