// Blocks in space: the forces on them, leapfrog of momentum and angular momentum with local damping, and the
// turn by five rotations about the principal axes (docs/theory/space.md, "Motion").
#pragma once

#include "contact/face_in_space.h"
#include "dynamics/passes/blocks.h"
#include "dynamics/space/joints.h"
#include "dynamics/space/turning.h"

namespace wythe::dynamics::space {

template <class Real>
struct Load {
  Vector<Real> f, m;
};

// Local damping of force f against the rate v. Either as vectors, -lambda |f| v/|v|, which
// is independent of axes, or component by component as in the paper. Zero where v is 0.
template <class Real>
[[nodiscard]] WYTHE_INLINE Vector<Real> damping_of(const Vector<Real>& f, const Vector<Real>& v,
                                                   Real lambda, bool components) {
  const Real minus(-1.0);
  if (components)
    return {minus * lambda * magnitude(f.x) * sign(v.x),
            minus * lambda * magnitude(f.y) * sign(v.y),
            minus * lambda * magnitude(f.z) * sign(v.z)};
  const Real pace = square_root(maximum(dot(v, v), Real(1e-300)));
  return (minus * lambda * square_root(dot(f, f)) / pace) * v;
}

// Contact force on block i of wall `lane`: joints of which it is side a, then joints of which it is side b.
WYTHE_INLINE Load<double> contact_load(const Tables& t, std::ptrdiff_t i, std::ptrdiff_t lane) {
  const auto of = [&](const double* rows, std::int32_t joint) {
    const double* row = rows + 4 * static_cast<std::ptrdiff_t>(joint) * t.lanes + lane;
    return Vector<double>{row[0], row[t.lanes], row[2 * t.lanes]};
  };
  Load<double> sum{{0, 0, 0}, {0, 0, 0}};
  for (auto e = t.block_begin[i]; e < t.block_middle[i]; ++e)
    sum = {sum.f + of(t.force, t.block_entry[e]), sum.m + of(t.moment_a, t.block_entry[e])};
  for (auto e = t.block_middle[i]; e < t.block_begin[i + 1]; ++e)
    sum = {sum.f - of(t.force, t.block_entry[e]), sum.m + of(t.moment_b, t.block_entry[e])};
  return sum;
}

template <class A>
struct Blocks {
  using Access = A;
  using Real = typename Access::Real;
  using Work = BlockWork<Real>;

  const Tables& t;
  Access access;
  Real dt, lambda;
  Vector<Real> gravity;

  WYTHE_INLINE Blocks(const Tables& tables, Access lanes, const Chunk&)
      : t(tables),
        access(lanes),
        dt(access.wall_value(t.wall, kStep)),
        lambda(access.wall_value(t.wall, kLambda)),
        gravity{access.wall_value(t.wall, kGravity), access.wall_value(t.wall, kGravity + 1),
                access.wall_value(t.wall, kGravity + 2)} {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t i, Work& work) const {
    const Real zero(0.0), half(0.5);
    const bool special = t.special[i] != 0;
    const Load<Real> contact = gather(i);
    Load<Real> load{load_row(i, kGravityMass) * gravity, {zero, zero, zero}};
    if (special) load = {vector(i, kLoad) + load.f, vector(i, kLoadMoment)};
    const Vector<Real> f = contact.f + load.f, m = contact.m + load.m;

    const Rows<Real> shift = access.load_rows(t.shift, i), turn = access.load_rows(t.turn, i);
    const Quaternion<Real> q{shift.c3, {turn.c0, turn.c1, turn.c2}};
    const Inertia<Real> body = inertia(i);

    const Vector<Real> v0 = vector(i, kV), damped = damping_of(f, v0, lambda, t.damps_components);
    const Vector<Real> v = v0 + load_row(i, kMassRate) * (f + damped);
    const Vector<Real> mean_v = half * (v0 + v);

    const Vector<Real> l0 = vector(i, kL);
    const Vector<Real> rate0 = turned(q, body.rate(turned_back(q, l0)));
    const Vector<Real> damped_moment = damping_of(m, rate0, lambda, t.damps_components);
    const Vector<Real> l = l0 + dt * (m + damped_moment);
    const Vector<Real> in_block = turned_back(q, l);
    const Vector<Real> mean_rate = half * (rate0 + turned(q, body.rate(in_block)));

    Vector<Real> v1 = v, l1 = l, u{shift.c0 + dt * v.x, shift.c1 + dt * v.y, shift.c2 + dt * v.z};
    Quaternion<Real> q1 = spin(q, in_block, body, dt);
    Real loads = dt * (dot(load.f, mean_v) + dot(load.m, mean_rate));
    Real damping = dt * (dot(damped, mean_v) + dot(damped_moment, mean_rate));
    if (special) {
      const auto is_free = load_row(i, kFree) > zero;
      const auto chosen = [&](const Vector<Real>& a, const Vector<Real>& b) {
        return Vector<Real>{select(is_free, a.x, b.x), select(is_free, a.y, b.y),
                            select(is_free, a.z, b.z)};
      };
      v1 = chosen(v, v0);
      l1 = chosen(l, l0);
      u = chosen(u, {shift.c0, shift.c1, shift.c2});
      q1 = {select(is_free, q1.w, q.w), chosen(q1.v, q.v)};
      loads = select(is_free, loads, zero);
      damping = select(is_free, damping, zero);
    }
    work = {work.loads + loads, work.damping + damping};
    store_vector(v1, i, kV);
    store_vector(l1, i, kL);
    access.store_rows({u.x, u.y, u.z, q1.w}, t.shift, i);
    access.store_rows({q1.v.x, q1.v.y, q1.v.z, zero}, t.turn, i);
  }

 private:
  [[nodiscard]] WYTHE_INLINE Real load_row(std::ptrdiff_t i, int row) const {
    return access.load(t.body, i * kBodyRows + row);
  }
  [[nodiscard]] WYTHE_INLINE Vector<Real> vector(std::ptrdiff_t i, int row) const {
    return {load_row(i, row), load_row(i, row + 1), load_row(i, row + 2)};
  }
  WYTHE_INLINE void store_vector(const Vector<Real>& v, std::ptrdiff_t i, int row) const {
    access.store(v.x, t.body, i * kBodyRows + row);
    access.store(v.y, t.body, i * kBodyRows + row + 1);
    access.store(v.z, t.body, i * kBodyRows + row + 2);
  }
  [[nodiscard]] WYTHE_INLINE Inertia<Real> inertia(std::ptrdiff_t i) const {
    Inertia<Real> body;
    for (int k = 0; k < 3; ++k) {
      body.axis[k] = shared_vector<Real>(access, t.axes, i * kAxisRows + 3 * k);
      body.inverse[k] = load_row(i, kInverse + k);
    }
    return body;
  }
  [[nodiscard]] WYTHE_INLINE Load<Real> gather(std::ptrdiff_t i) const {
    const Real zero(0.0);
    if constexpr (Access::one_wall) {
      using L = typename Access::L;
      double sum[6][L::width];
      for (int k = 0; k < L::width; ++k) {
        const Load<double> load = contact_load(t, i * kGroup + access.lane + k, 0);
        const double all[6] = {load.f.x, load.f.y, load.f.z, load.m.x, load.m.y, load.m.z};
        for (int r = 0; r < 6; ++r) sum[r][k] = all[r];
      }
      return {{L::load(sum[0]), L::load(sum[1]), L::load(sum[2])},
              {L::load(sum[3]), L::load(sum[4]), L::load(sum[5])}};
    } else {
      const auto of = [&](const double* rows, std::int32_t joint) {
        const Rows<Real> row = access.row_of(rows, joint);
        return Vector<Real>{row.c0, row.c1, row.c2};
      };
      Load<Real> sum{{zero, zero, zero}, {zero, zero, zero}};
      for (auto e = t.block_begin[i]; e < t.block_middle[i]; ++e)
        sum = {sum.f + of(t.force, t.block_entry[e]), sum.m + of(t.moment_a, t.block_entry[e])};
      for (auto e = t.block_middle[i]; e < t.block_begin[i + 1]; ++e)
        sum = {sum.f - of(t.force, t.block_entry[e]), sum.m + of(t.moment_b, t.block_entry[e])};
      return sum;
    }
  }
};

}  // namespace wythe::dynamics::space
