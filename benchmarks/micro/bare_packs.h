// The steps of bare walls (bare_wall.h) for one kind of lanes; included by one source file per
// instruction set. Every function is a template over it, so that none is shared.
#pragma once

#include "bare_wall.h"
#include "core/pack.h"
#include "dynamics/passes/access.h"

namespace wythe::bench {

template <class Real>
inline constexpr int kWidth = dynamics::Lanes<Real>::width;
template <class Real>
WYTHE_INLINE Real get(const double* row, int k) {
  return dynamics::Lanes<Real>::load(row + k * kWidth<Real>);
}
template <class Real>
WYTHE_INLINE void put(Real value, double* row, int k) {
  dynamics::Lanes<Real>::store(value, row + k * kWidth<Real>);
}

template <class Real>
struct BareWork {
  Real friction, fracture, crushing;
};
template <class Real>
struct BarePoint {
  Real sigma, tau;
};

// The rows of a material where the joints are of one wall (the same in all lanes) or of one each.
template <class Real>
struct LawOfWalls {
  const double* row;
  WYTHE_INLINE Real operator()(int k) const { return get<Real>(row, k); }
};
template <class Real>
struct LawOfWall {
  const double* row;
  WYTHE_INLINE Real operator()(int k) const { return Real(row[k]); }
};

template <class Real>
WYTHE_INLINE Real left_at(const auto& m, Real kappa) {
  return clip(m(kLeftAtNone) - kappa * m(kLeftRate), Real(0.0), Real(1.0));
}

// What the shear strength is made of at the normal stress sigma.
template <class Real>
struct BareYield {
  Real residual, drop, rate;  // T = residual + drop (1 - ds); ds = slip rate
};

// The whole law at a point.
template <class Real>
WYTHE_INLINE BarePoint<Real> bare_law(const auto& m, Real w, Real s, double* hot, double* cold,
                                      Real share, BareWork<Real>& work, auto& rests) {
  const Real zero(0.0), one(1.0), half(0.5);
  Real p = get<Real>(hot, kCrush), we = w + p;
  const auto crushes = w < get<Real>(hot, kCrushesBelow);
  if (any(crushes)) {
    const Real fc = m(kFc) * maximum(zero, one - p * m(kInvPFull));
    const Real excess = zero - m(kKn) * we - fc;
    const Real softened = p + maximum(zero, excess) * m(kCrushGain);
    const Real p1 = select(softened > m(kPFull), maximum(p, zero - w), softened);
    const Real after = m(kFc) * maximum(zero, one - p1 * m(kInvPFull));
    const Real length = minimum(p1, m(kPFull)) - minimum(p, m(kPFull));
    work.crushing = work.crushing + share * half * (fc + after) * length;
    p = p1;
    we = w + p;
    put(p, hot, kCrush);
    put(zero - after * m(kInvKn) - p, hot, kCrushesBelow);
  }
  const Real kappa0 = get<Real>(cold, kKappa), ds0 = get<Real>(cold, kShear);
  const Real open = maximum(we, zero), kappa = maximum(kappa0, open);
  const Real left = left_at(m, kappa), y0 = m(kFt) * get<Real>(hot, kLeft);
  const Real inv_kappa = one / maximum(kappa, Real(1e-30));
  const Real closed = m(kKn) * minimum(we, zero);
  const Real sn = zero - (closed + open * minimum(m(kKn), m(kFt) * left * (one - ds0) * inv_kappa));

  const Real residual = select((we > zero) & (left <= zero), zero, m(kCRes) + sn * m(kTanRes));
  const Real drop = (m(kCDrop) + sn * m(kTanDrop)) * left;
  const Real rate = maximum(zero, m(kCDrop) + maximum(sn, zero) * m(kTanDrop)) * m(kHalfInvGII);
  Real slip = get<Real>(cold, kSlip), plastic = get<Real>(hot, kPlastic);
  Real ds = maximum(ds0, minimum(one, slip * rate));
  Real tau = m(kKs) * (s - plastic);
  const Real trial = magnitude(tau);
  const Real start = maximum(zero, residual + drop * (one - ds));
  const auto slides = trial > start;
  if (any(slides)) {
    const Real over = trial - residual;
    const Real flat = (over - drop * (one - ds)) * m(kInvKs);
    const Real falling = (over - drop * (one - slip * rate)) / (m(kKs) - drop * rate);
    const Real beyond = select((slip + falling) * rate < one, falling, over * m(kInvKs));
    const Real raw = select((slip + flat) * rate <= ds, flat, beyond);
    const Real slid = select(slides, maximum(zero, minimum(raw, trial * m(kInvKs))), zero);
    slip = slip + slid;
    plastic = plastic + select(tau > zero, slid, zero - slid);
    ds = maximum(ds, minimum(one, slip * rate));
    tau = m(kKs) * (s - plastic);
    const Real worked = half * (start + magnitude(tau)) * slid;
    const Real rubbed = minimum(worked, maximum(zero, residual) * slid);
    work.friction = work.friction + share * rubbed;
    work.fracture = work.fracture + share * (worked - rubbed);
    put(slip, cold, kSlip);
    put(plastic, hot, kPlastic);
  }
  const Real y = left * (one - ds), strength = m(kFt) * y;
  const Real from = maximum(kappa0, minimum(kappa, y0 * m(kInvKn)));
  const Real s0 = minimum(y0, m(kKn) * from), s1 = minimum(strength, m(kKn) * kappa);
  const Real freed =
      select(open > kappa0, s0 * kappa - s1 * from, (s0 - s1) * open * open * inv_kappa);
  work.fracture = work.fracture + share * half * maximum(zero, freed);
  put(kappa, cold, kKappa);
  put(ds, cold, kShear);
  put(y, hot, kLeft);
  put(select(ds < one, ds * m(kTwoGII) / maximum(slip, Real(1e-30)), Real(1e300)), hot,
      kDamagedFrom);
  rests = (we <= zero) & (trial <= start);
  return {closed + open * minimum(m(kKn), strength * inv_kappa), tau};
}

// The stresses of a point at rest, with the same bits; else `busy`.
template <class Real>
WYTHE_INLINE BarePoint<Real> at_rest(const auto& m, Real w, Real s, const double* hot, auto& busy) {
  const Real we = w + get<Real>(hot, kCrush);
  const Real sigma = m(kKn) * we, tau = m(kKs) * (s - get<Real>(hot, kPlastic));
  const Real drop = m(kCDrop) - sigma * m(kTanDrop);
  const Real strength = m(kCRes) - sigma * m(kTanRes) + drop * get<Real>(hot, kLeft);
  busy = (we > Real(0.0)) | (magnitude(tau) > strength) | (w < get<Real>(hot, kCrushesBelow)) |
         (drop > get<Real>(hot, kDamagedFrom));
  return {sigma, tau};
}

// One side of a joint: where its arm is turned to and how its face's centre moved.
template <class Real>
struct BareSide {
  Real arm_x, arm_y, move_x, move_y;
};
template <class Real>
WYTHE_INLINE BareSide<Real> side_of(Real ux, Real uy, Real drop, Real sine, Real ax, Real ay) {
  const Real dx = drop * ax - sine * ay, dy = sine * ax + drop * ay;
  return {ax + dx, ay + dy, ux + dx, uy + dy};
}

// The frame of a joint between two blocks.
template <class Real>
struct BareFrame {
  BareSide<Real> a, b;
  Real tx, ty;       // tangent, turned by the mean of both rotations
  Real grown, half;  // 2 |e| sin(delta/2), |e| cos(delta/2)
};
template <class Real>
struct BareForce {
  Real fx, fy, ma, mb;
};

template <class Real>
WYTHE_INLINE BareFrame<Real> frame_of(const BareSide<Real>& a, const BareSide<Real>& b, Real ca,
                                      Real sa, Real cb, Real sb, Real tx, Real ty, Real half) {
  const Real cc = ca * cb, ss = sa * sb, sc = sa * cb, cs = ca * sb;
  const Real cos = cc - ss, sin = sc + cs;
  return {
      a, b, cos * tx - sin * ty, sin * tx + cos * ty, (half + half) * (cs - sc), half * (cc + ss)};
}

// Opening of the two points and their slip.
template <class Real>
struct BareJump {
  Real jx, jy, w0, w1, s;
};
template <class Real>
WYTHE_INLINE BareJump<Real> jump_of(const BareFrame<Real>& q) {
  const Real jx = q.b.move_x - q.a.move_x, jy = q.b.move_y - q.a.move_y;
  const Real jn = jy * q.tx - jx * q.ty;
  return {jx, jy, jn - q.grown, jn + q.grown, jx * q.tx + jy * q.ty};
}
template <class Real>
WYTHE_INLINE BareForce<Real> force_of(const BareFrame<Real>& q, const BareJump<Real>& j,
                                      const BarePoint<Real>& p0, const BarePoint<Real>& p1,
                                      Real share) {
  const Real fn = share * (p0.sigma + p1.sigma), ft = share * (p0.tau + p1.tau);
  const Real couple = q.half * share * (p1.sigma - p0.sigma);
  const Real fx = ft * q.tx - fn * q.ty, fy = ft * q.ty + fn * q.tx;
  const Real cx = Real(0.5) * j.jx, cy = Real(0.5) * j.jy;
  return {fx, fy, (q.a.arm_x + cx) * fy - (q.a.arm_y + cy) * fx + couple,
          (q.b.arm_y - cy) * fx - (q.b.arm_x - cx) * fy - couple};
}

// The same on the ground: its tangent stands still and it has no lever.
template <class Real>
WYTHE_INLINE BareForce<Real> bare_ground_force(const auto& law, const BareSide<Real>& b, Real tx,
                                               Real ty, Real half, Real drop, Real sine,
                                               double* hot, double* cold, Real share,
                                               BareWork<Real>& work) {
  const Real ex = half * tx, ey = half * ty;
  const Real dx = drop * ex - sine * ey, dy = sine * ex + drop * ey;
  const Real jn = b.move_y * tx - b.move_x * ty, jt = b.move_x * tx + b.move_y * ty;
  const Real dn = dy * tx - dx * ty, dt = dx * tx + dy * ty;
  constexpr int w = kWidth<Real>;
  bool_of_t<Real> rests;
  const BarePoint<Real> p0 = bare_law(law, jn - dn, jt - dt, hot, cold, share, work, rests);
  const BarePoint<Real> p1 =
      bare_law(law, jn + dn, jt + dt, hot + kHotRows * w, cold + kColdRows * w, share, work, rests);
  const Real fn = share * (p0.sigma + p1.sigma), ft = share * (p0.tau + p1.tau);
  const Real gn = share * (p1.sigma - p0.sigma), gt = share * (p1.tau - p0.tau);
  const Real fx = ft * tx - fn * ty, fy = ft * ty + fn * tx;
  const Real gx = gt * tx - gn * ty, gy = gt * ty + gn * tx;
  const Real hx = ex + dx, hy = ey + dy;
  return {fx, fy, Real(0.0), (b.arm_y * fx - b.arm_x * fy) + (hy * gx - hx * gy)};
}

// cos theta - 1, sin theta, and cosine and sine of theta/2, by Taylor series of degree 9.
template <class Real>
[[gnu::noinline]] dynamics::Rows<Real> far_turn(Real theta) {
  const SinCos<Real> h = sin_cos(Real(0.5) * theta);
  return {Real(-2.0) * h.sin * h.sin, Real(2.0) * h.sin * h.cos, h.cos, h.sin};
}
template <class Real>
WYTHE_INLINE dynamics::Rows<Real> turn_of(Real theta) {
  const Real one(1.0), x = Real(0.5) * theta, z = x * x;
  if (any(magnitude(x) > Real(0.125))) return far_turn(theta);
  const Real s = x + x * z *
                         (Real(-1.0 / 6) +
                          z * (Real(1.0 / 120) + z * (Real(-1.0 / 5040) + z * Real(1.0 / 362880))));
  const Real c =
      one - z * (Real(0.5) - z * (Real(1.0 / 24) - z * (Real(1.0 / 720) - z * Real(1.0 / 40320))));
  return {Real(-2.0) * s * s, Real(2.0) * s * c, c, s};
}

// --- walls side by side ------------------------------------------------------------------------

template <class Real>
struct WallStep {
  static constexpr int kW = kWidth<Real>;
  const BareWalls v;

  WYTHE_INLINE double* block(std::int32_t i) const {
    return v.block + static_cast<std::ptrdiff_t>(i) * kBlockRows * kW;
  }
  WYTHE_INLINE double* hot(int j) const {
    return v.hot + static_cast<std::ptrdiff_t>(j) * 2 * kHotRows * kW;
  }
  WYTHE_INLINE double* cold(int j) const {
    return v.cold + static_cast<std::ptrdiff_t>(j) * 2 * kColdRows * kW;
  }
  WYTHE_INLINE LawOfWalls<Real> law(const BareJoint& g) const {
    return {v.law + g.material * kLawRows * kW};
  }
  WYTHE_INLINE BareSide<Real> side(const double* q, double ax, double ay) const {
    return side_of(get<Real>(q, kUx), get<Real>(q, kUy), get<Real>(q, kDrop), get<Real>(q, kSine),
                   Real(ax), Real(ay));
  }
  WYTHE_INLINE BareFrame<Real> frame(const BareJoint& g, const double* a, const double* b) const {
    return frame_of(side(a, g.ax, g.ay), side(b, g.bx, g.by), get<Real>(a, kCos),
                    get<Real>(a, kSin), get<Real>(b, kCos), get<Real>(b, kSin), Real(g.tx),
                    Real(g.ty), Real(g.half));
  }
  WYTHE_INLINE void add(const BareForce<Real>& f, double* a, double* b) const {
    put(get<Real>(a, kFx) + f.fx, a, kFx);
    put(get<Real>(a, kFy) + f.fy, a, kFy);
    put(get<Real>(a, kMoment) + f.ma, a, kMoment);
    take(f, b);
  }
  WYTHE_INLINE void take(const BareForce<Real>& f, double* b) const {
    put(get<Real>(b, kFx) - f.fx, b, kFx);
    put(get<Real>(b, kFy) - f.fy, b, kFy);
    put(get<Real>(b, kMoment) + f.mb, b, kMoment);
  }

  // False, and nothing done, where a point is not at rest.
  WYTHE_INLINE bool joint_at_rest(int j) const {
    const BareJoint& g = v.joint[j];
    double *a = block(g.a), *b = block(g.b);
    const BareFrame<Real> q = frame(g, a, b);
    const BareJump<Real> jump = jump_of(q);
    bool_of_t<Real> busy0, busy1;
    const BarePoint<Real> p0 = at_rest(law(g), jump.w0, jump.s, hot(j), busy0);
    const BarePoint<Real> p1 = at_rest(law(g), jump.w1, jump.s, hot(j) + kHotRows * kW, busy1);
    if (any(busy0 | busy1)) return false;
    add(force_of(q, jump, p0, p1, Real(g.share)), a, b);
    return true;
  }
  [[gnu::noinline]] void busy_joint(int j) const {
    const BareJoint& g = v.joint[j];
    double *b = block(g.b), *h = hot(j), *c = cold(j);
    const Real share(g.share);
    BareWork<Real> work{get<Real>(v.wall, kFriction), get<Real>(v.wall, kFracture),
                        get<Real>(v.wall, kCrushing)};
    if (g.a < 0) {
      take(bare_ground_force(law(g), side(b, g.bx, g.by), Real(g.tx), Real(g.ty), Real(g.half),
                             get<Real>(b, kDrop), get<Real>(b, kSine), h, c, share, work),
           b);
    } else {
      double* a = block(g.a);
      const BareFrame<Real> q = frame(g, a, b);
      const BareJump<Real> jump = jump_of(q);
      bool_of_t<Real> rests0, rests1;
      const BarePoint<Real> p0 = bare_law(law(g), jump.w0, jump.s, h, c, share, work, rests0);
      const BarePoint<Real> p1 = bare_law(law(g), jump.w1, jump.s, h + kHotRows * kW,
                                          c + kColdRows * kW, share, work, rests1);
      add(force_of(q, jump, p0, p1, share), a, b);
      v.busy[j] = all(rests0 & rests1) ? 0 : 1;
    }
    put(work.friction, v.wall, kFriction);
    put(work.fracture, v.wall, kFracture);
    put(work.crushing, v.wall, kCrushing);
  }

  [[gnu::noinline]] void move(std::int32_t i) const {
    double* q = block(i);
    const Real dt = get<Real>(v.wall, kDt), damping = get<Real>(v.wall, kDamping);
    Real damped = get<Real>(v.wall, kDamped);
    const auto advance = [&](BlockRow force, BlockRow velocity, BlockRow rate, Real & twice)
        __attribute__((always_inline)) {
      const Real f = get<Real>(q, force), v0 = get<Real>(q, velocity);
      const Real drag = damping * magnitude(f) * sign(v0);
      const Real v1 = v0 + get<Real>(q, rate) * (f - drag);
      put(v1, q, velocity);
      twice = v0 + v1;
      damped = damped - drag * twice;
      return v1;
    };
    Real x2, y2, r2;
    const Real vx = advance(kFx, kVx, kRate, x2), vy = advance(kFy, kVy, kRate, y2);
    const Real omega = advance(kMoment, kOmega, kTurnRate, r2);
    const Real load_x = get<Real>(q, kLoadX), load_y = get<Real>(q, kLoadY);
    const Real loads = load_x * x2 + load_y * y2 + get<Real>(q, kLoadMoment) * r2;
    put(load_x, q, kFx);
    put(load_y, q, kFy);
    put(Real(0.0), q, kMoment);
    put(get<Real>(q, kUx) + dt * vx, q, kUx);
    put(get<Real>(q, kUy) + dt * vy, q, kUy);
    const Real theta = get<Real>(q, kTheta) + dt * omega;
    put(theta, q, kTheta);
    const dynamics::Rows<Real> turned = turn_of(theta);
    put(turned.c0, q, kDrop);
    put(turned.c1, q, kSine);
    put(turned.c2, q, kCos);
    put(turned.c3, q, kSin);
    put(damped, v.wall, kDamped);
    put(get<Real>(v.wall, kLoads) + loads, v.wall, kLoads);
  }

  void load() const {
    for (int k = 0; k < v.n_load; ++k) put(Real(0.0), block(v.load[k].block), kLoadMoment);
    for (int k = 0; k < v.n_load; ++k) {
      const BareLoad& load = v.load[k];
      double* q = block(load.block);
      const Real drop = get<Real>(q, kDrop), sine = get<Real>(q, kSine);
      const Real ax(load.arm_x), ay(load.arm_y);
      const Real moment = (ax + drop * ax - sine * ay) * Real(load.fy) -
                          (ay + sine * ax + drop * ay) * Real(load.fx);
      put(get<Real>(q, kLoadMoment) + moment, q, kLoadMoment);
      put(get<Real>(q, kMoment) + moment, q, kMoment);
    }
  }

  void run() const {
    load();
    int moved = 0;
    for (int j = 0; j < v.n_joint; ++j) {
      if (v.busy[j] != 0 || !joint_at_rest(j)) busy_joint(j);
      for (const int last = v.joint[j].moved; moved < last; ++moved) move(v.order[moved]);
    }
  }
};

template <class Real>
void bare_walls_step(const BareWalls& v) {
  WallStep<Real>{v}.run();
}

// --- one wall, packs of joints -----------------------------------------------------------------

typedef double BareRow __attribute__((vector_size(32), aligned(8), may_alias));

template <class Real>
struct JointStep {
  static constexpr int kW = kWidth<Real>;
  using L = dynamics::Lanes<Real>;
  const BareJoints v;

  WYTHE_INLINE static BareRow& row(double* rows, std::ptrdiff_t i) {
    return *reinterpret_cast<BareRow*>(rows + 4 * i);
  }
  WYTHE_INLINE static const BareRow& row(const double* rows, std::ptrdiff_t i) {
    return *reinterpret_cast<const BareRow*>(rows + 4 * i);
  }
  WYTHE_INLINE Real geometry(std::ptrdiff_t k, int r) const {
    return get<Real>(v.geometry + k * kGeometryRows * kW, r);
  }
  // A side at its pose (ux, uy, cos, sin).
  WYTHE_INLINE BareSide<Real> side(const dynamics::Rows<Real>& q, Real ax, Real ay) const {
    return side_of(q.c0, q.c1, Real(-2.0) * q.c3 * q.c3, Real(2.0) * q.c3 * q.c2, ax, ay);
  }
  WYTHE_INLINE BareFrame<Real> frame(std::ptrdiff_t k) const {
    const dynamics::Rows<Real> a = L::load_rows(v.pose, v.a + k * kW);
    const dynamics::Rows<Real> b = L::load_rows(v.pose, v.b + k * kW);
    return frame_of(side(a, geometry(k, 0), geometry(k, 1)),
                    side(b, geometry(k, 2), geometry(k, 3)), a.c2, a.c3, b.c2, b.c3, geometry(k, 4),
                    geometry(k, 5), geometry(k, 6));
  }
  WYTHE_INLINE void keep(const BareForce<Real>& f, std::ptrdiff_t k) const {
    L::store_rows({f.fx, f.fy, f.ma, f.mb}, v.force + 4 * k * kW);
  }

  WYTHE_INLINE bool pack_at_rest(std::ptrdiff_t k, const LawOfWall<Real>& law) const {
    const BareFrame<Real> q = frame(k);
    const BareJump<Real> jump = jump_of(q);
    const double* hot = v.hot + k * 2 * kHotRows * kW;
    bool_of_t<Real> busy0, busy1;
    const BarePoint<Real> p0 = at_rest(law, jump.w0, jump.s, hot, busy0);
    const BarePoint<Real> p1 = at_rest(law, jump.w1, jump.s, hot + kHotRows * kW, busy1);
    if (any(busy0 | busy1)) return false;
    keep(force_of(q, jump, p0, p1, geometry(k, 7)), k);
    return true;
  }
  [[gnu::noinline]] void busy_pack(std::ptrdiff_t k, const LawOfWall<Real>& law, bool on_ground,
                                   BareWork<Real>& work) const {
    double *hot = v.hot + k * 2 * kHotRows * kW, *cold = v.cold + k * 2 * kColdRows * kW;
    const Real share = geometry(k, 7);
    if (on_ground) {
      const dynamics::Rows<Real> b = L::load_rows(v.pose, v.b + k * kW);
      keep(bare_ground_force(law, side(b, geometry(k, 2), geometry(k, 3)), geometry(k, 4),
                             geometry(k, 5), geometry(k, 6), Real(-2.0) * b.c3 * b.c3,
                             Real(2.0) * b.c3 * b.c2, hot, cold, share, work),
           k);
      return;
    }
    const BareFrame<Real> q = frame(k);
    const BareJump<Real> jump = jump_of(q);
    bool_of_t<Real> rests0, rests1;
    const BarePoint<Real> p0 = bare_law(law, jump.w0, jump.s, hot, cold, share, work, rests0);
    const BarePoint<Real> p1 = bare_law(law, jump.w1, jump.s, hot + kHotRows * kW,
                                        cold + kColdRows * kW, share, work, rests1);
    keep(force_of(q, jump, p0, p1, share), k);
    v.busy[k] = all(rests0 & rests1) ? 0 : 1;
  }
  void joints() const {
    BareWork<Real> work{Real(0.0), Real(0.0), Real(0.0)};
    for (int g = 0; g < v.n_group; ++g) {
      const BareGroup& group = v.group[g];
      const LawOfWall<Real> law{v.law + group.material * kLawRows};
      for (std::ptrdiff_t k = group.first; k < group.last; ++k)
        if (v.busy[k] != 0 || !pack_at_rest(k, law)) busy_pack(k, law, group.on_ground, work);
    }
    v.wall[kFriction] += sum(work.friction);
    v.wall[kFracture] += sum(work.fracture);
    v.wall[kCrushing] += sum(work.crushing);
  }
  static double sum(Real lanes) {
    double all[kW], total = 0;
    L::store(lanes, all);
    for (const double one : all) total += one;
    return total;
  }

  // Moment of the loads on their turned blocks.
  void load() const {
    for (int k = 0; k < v.n_load; ++k) v.weight[4 * v.load[k].block + 2] = 0;
    for (int k = 0; k < v.n_load; ++k) {
      const BareLoad& load = v.load[k];
      const double *q = v.pose + 4 * load.block, drop = -2 * q[3] * q[3], sine = 2 * q[2] * q[3];
      const double ax = load.arm_x + drop * load.arm_x - sine * load.arm_y;
      const double ay = load.arm_y + sine * load.arm_x + drop * load.arm_y;
      v.weight[4 * load.block + 2] += ax * load.fy - ay * load.fx;
    }
  }
  // A row holds the three motions of a block: forces gathered, moved, and the works of the step.
  WYTHE_INLINE void move(std::ptrdiff_t i, BareRow& loads, BareRow& damped) const {
    const BareRow zero{}, one = zero + 1.0, weight = row(v.weight, i);
    BareRow a = weight, b = zero;
    const auto middle = v.middle[i], last = v.begin[i + 1];
    for (auto e = v.begin[i]; e < middle; ++e) a += row(v.force, v.entry[e]);
    for (auto e = middle; e < last; ++e) b += row(v.force, v.entry[e]);
    const BareRow f = a + BareRow{-1, -1, 1, 0} * __builtin_shufflevector(b, b, 0, 1, 3, 2);
    const BareRow v0 = row(v.velocity, i), size = f < zero ? -f : f;
    const BareRow drag =
        v.wall[kDamping] * size * ((v0 > zero ? one : zero) - (v0 < zero ? one : zero));
    const BareRow v1 = v0 + row(v.rate, i) * (f - drag), twice = v0 + v1;
    damped -= drag * twice;
    loads += weight * twice;
    row(v.velocity, i) = v1;
    row(v.place, i) += v.wall[kDt] * v1;
  }
  void blocks() const {
    BareRow loads{}, damped{};
    int i = 0;
    for (; i + kW <= v.n_block; i += kW) {
      std::int32_t id[kW];
      for (int k = 0; k < kW; ++k) move(id[k] = i + k, loads, damped);
      const dynamics::Rows<Real> q = L::load_rows(v.place, id);
      const dynamics::Rows<Real> turned = turn_of(q.c2);
      L::store_rows({q.c0, q.c1, turned.c2, turned.c3}, v.pose + 4 * i);
    }
    for (; i < v.n_block; ++i) {
      move(i, loads, damped);
      const double* q = v.place + 4 * i;
      double* pose = v.pose + 4 * i;
      double theta[kW] = {q[2]}, cos[kW], sin[kW];
      const dynamics::Rows<Real> turned = turn_of(L::load(theta));
      L::store(turned.c2, cos);
      L::store(turned.c3, sin);
      pose[0] = q[0], pose[1] = q[1], pose[2] = cos[0], pose[3] = sin[0];
    }
    v.wall[kLoads] += loads[0] + loads[1] + loads[2];
    v.wall[kDamped] += damped[0] + damped[1] + damped[2];
  }
};

template <class Real>
void bare_joints_step(const BareJoints& v) {
  const JointStep<Real> step{v};
  step.load();
  step.joints();
  step.blocks();
}

// --- what the units can do ---------------------------------------------------------------------

// Twelve chains of one multiplication and one addition each: enough to fill two pipes of each kind.
template <class Real>
double multiply_add(std::int64_t rounds) {
  Real x[kChains];
  for (int k = 0; k < kChains; ++k) x[k] = Real(1.0 + k);
  const Real factor(0.999999), term(1e-6);
  for (std::int64_t r = 0; r < rounds; ++r)
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) x[k] = x[k] * factor + term;
  Real sum = x[0];
  for (int k = 1; k < kChains; ++k) sum = sum + x[k];
  return JointStep<Real>::sum(sum);
}

template <class Real>
[[nodiscard]] constexpr BareKernels bare_kernels(const char* name,
                                                 double (*fused)(std::int64_t) = nullptr) {
  return {name, kWidth<Real>, bare_walls_step<Real>, bare_joints_step<Real>, multiply_add<Real>,
          fused};
}

}  // namespace wythe::bench
