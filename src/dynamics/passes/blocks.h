// Blocks: the forces on them, central differences with local damping, and their poses for the next step.
#pragma once

#include "dynamics/passes/access.h"
#include "dynamics/passes/motion.h"

namespace wythe::dynamics {

template <class Real>
struct BlockWork {
  Real loads, damping;  // [J]
};

template <class Real>
struct BlockForce {
  Real x, y, m;  // [N], [N m]
};

// Contact force on block i of wall `lane` (0 for one wall). It adds up joints of which i is side
// a, joints of which it is side b with opposite sign, then zone contacts, each in their order.
WYTHE_INLINE BlockForce<double> contact_force(const Tables& t, std::ptrdiff_t i,
                                              std::ptrdiff_t lane) {
  const std::ptrdiff_t walls = t.lanes;
  BlockForce<double> a{0, 0, 0}, b{0, 0, 0};
  const auto middle = t.block_middle[i], last = t.block_begin[i + 1];
  for (auto e = t.block_begin[i]; e < middle; ++e) {
    const double* row = t.force + 4 * t.block_entry[e] * walls + lane;
    a = {a.x + row[0], a.y + row[walls], a.m + row[2 * walls]};
  }
  for (auto e = middle; e < last; ++e) {
    const double* row = t.force + 4 * t.block_entry[e] * walls + lane;
    b = {b.x + row[0], b.y + row[walls], b.m + row[3 * walls]};
  }
  BlockForce<double> sum{a.x - b.x, a.y - b.y, a.m + b.m};
  for (auto e = t.block_edge_begin[i]; e < t.block_edge_begin[i + 1]; ++e) {
    const double* row = t.edge_block_force + 4 * t.block_edge_entry[e] * walls + lane;
    sum = {sum.x + row[0], sum.y + row[walls], sum.m + row[2 * walls]};
  }
  return sum;
}

template <class A>
struct Blocks {
  using Access = A;
  using Real = typename Access::Real;
  using Work = BlockWork<Real>;

  const Tables& t;
  Access access;
  Real dt, damping, gravity_x, gravity_y;

  WYTHE_INLINE Blocks(const Tables& tables, Access lanes, const Chunk&)
      : t(tables),
        access(lanes),
        dt(access.wall_value(t.wall, kDt)),
        damping(access.wall_value(t.wall, kDamping)),
        gravity_x(access.wall_value(t.wall, kGravityX)),
        gravity_y(access.wall_value(t.wall, kGravityY)) {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t i, Work& work) const {
    if (t.special[i] != 0)
      move<true>(i, work);
    else
      move<false>(i, work);
  }

 private:
  // `special`: dead loads may act on the block, or the drive may move it.
  template <bool special>
  WYTHE_INLINE void move(std::ptrdiff_t i, Work& work) const {
    const Real zero(0.0);
    const BlockForce<Real> contact = gather(i);
    const Real heavy = load_row(i, kGravityMass);
    BlockForce<Real> load{heavy * gravity_x, heavy * gravity_y, zero};
    if constexpr (special)
      load = {load_row(i, kLoadX) + load.x, load_row(i, kLoadY) + load.y, load_row(i, kLoadM)};
    const Real fx = contact.x + load.x, fy = contact.y + load.y;
    Real moment = contact.m;
    if constexpr (special) moment = moment + load.m;
    const Real fm = access.shared(t.turn_freedom, i) * moment;
    const Real rate = load_row(i, kRate), turn_rate = load_row(i, kTurnRate);
    const Rows<Real> pose = access.load_rows(t.pose, i);
    Moved<Real> x = accelerate(load_row(i, kVx), fx, rate, dt, damping);
    Moved<Real> y = accelerate(load_row(i, kVy), fy, rate, dt, damping);
    Moved<Real> r = accelerate(load_row(i, kOmega), fm, turn_rate, dt, damping);
    const Real theta0 = load_row(i, kTheta);
    Rows<Real> next{pose.c0 + dt * x.velocity, pose.c1 + dt * y.velocity, zero, zero};
    Real theta = theta0 + dt * r.velocity;
    Real power = load.x * x.mean_velocity + load.y * y.mean_velocity;
    if constexpr (special) power = power + load.m * r.mean_velocity;
    const Real loads = dt * power;
    const Real damped = x.damping_work + y.damping_work + r.damping_work;
    if constexpr (special) {
      const auto is_free = load_row(i, kIsFree) > zero;
      x.velocity = select(is_free, x.velocity, load_row(i, kVx));
      y.velocity = select(is_free, y.velocity, load_row(i, kVy));
      r.velocity = select(is_free, r.velocity, load_row(i, kOmega));
      next.c0 = select(is_free, next.c0, pose.c0);
      next.c1 = select(is_free, next.c1, pose.c1);
      theta = select(is_free, theta, theta0);
      work = {work.loads + select(is_free, loads, zero),
              work.damping + select(is_free, damped, zero)};
    } else {
      work = {work.loads + loads, work.damping + damped};
    }
    store_row(x.velocity, i, kVx);
    store_row(y.velocity, i, kVy);
    store_row(r.velocity, i, kOmega);
    store_row(theta, i, kTheta);
    const SinCos<Real> turned = sin_cos(Real(0.5) * theta);
    next.c2 = turned.cos;
    next.c3 = turned.sin;
    access.store_rows(next, t.pose, i);
  }

  [[nodiscard]] WYTHE_INLINE Real load_row(std::ptrdiff_t i, BlockRow row) const {
    return access.load(t.block, i * kBlockRows + row);
  }
  WYTHE_INLINE void store_row(Real value, std::ptrdiff_t i, BlockRow row) const {
    access.store(value, t.block, i * kBlockRows + row);
  }

  [[nodiscard]] WYTHE_INLINE BlockForce<Real> gather(std::ptrdiff_t i) const {
    if constexpr (Access::one_wall) {
      using L = typename Access::L;
      double x[L::width], y[L::width], m[L::width];
      for (int k = 0; k < L::width; ++k) {
        const BlockForce<double> f = contact_force(t, i * kGroup + access.lane + k, 0);
        x[k] = f.x, y[k] = f.y, m[k] = f.m;
      }
      return {L::load(x), L::load(y), L::load(m)};
    } else {
      Real ax(0.0), ay(0.0), am(0.0), bx(0.0), by(0.0), bm(0.0);
      const auto middle = t.block_middle[i], last = t.block_begin[i + 1];
      for (auto e = t.block_begin[i]; e < middle; ++e) {
        const Rows<Real> f = access.row_of(t.force, t.block_entry[e]);
        ax = ax + f.c0;
        ay = ay + f.c1;
        am = am + f.c2;
      }
      for (auto e = middle; e < last; ++e) {
        const Rows<Real> f = access.row_of(t.force, t.block_entry[e]);
        bx = bx + f.c0;
        by = by + f.c1;
        bm = bm + f.c3;
      }
      BlockForce<Real> sum{ax - bx, ay - by, am + bm};
      for (auto e = t.block_edge_begin[i]; e < t.block_edge_begin[i + 1]; ++e) {
        const Rows<Real> f = access.row_of(t.edge_block_force, t.block_edge_entry[e]);
        sum = {sum.x + f.c0, sum.y + f.c1, sum.m + f.c2};
      }
      return sum;
    }
  }
};

}  // namespace wythe::dynamics
