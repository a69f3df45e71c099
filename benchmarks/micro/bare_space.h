// Bare walls in space: one step of boxes in the paper's law with nine points a face, by hand, with no engine
// around it (as bare_wall.h in the plane). Geometry of a face and turn of a block are the equations themselves
// (contact/face_in_space.h, dynamics/space/blocks.h); tables, loops and the law are its own:
//
//   what is used together lies together, in the order of use
//   a face at rest (closed, sticking, damaged and crushed no further) costs six rows a point, takes no root and
//   writes no history
//
// Two shapes: walls side by side, one a lane (`many`), and one wall in packs of faces.
#pragma once

#include "bare_packs.h"
#include "dynamics/space/blocks.h"

namespace wythe::bench {

inline constexpr int kFacePoints = 9;
// Rows of a face: arms, t1, n. Of a point: place, area. Of its history: hot is what is asked of it at rest.
enum BareFaceRow { kBareArmA, kBareArmB = 3, kBareT = 6, kBareN = 9, kBareFaceRows = 12 };
enum BarePointRow { kBareR1, kBareR2, kBareArea, kBarePointRows };
enum SpaceHotRow {
  kHotCrush,
  kHotCrushesBelow,
  kHotLeft,
  kHotPlastic1,
  kHotPlastic2,
  kHotDamagedFrom,
  kSpaceHotRows
};
// Rows of a block: motion, mobility, weight; in a wall of many also forces that faces add to.
enum SpaceBlockRow {
  kBareV,
  kBareL = 3,
  kBareMobility = 6,  // dt/m and dt; 0 where the block is held
  kBareTurn,
  kBareInverse,  // 1/I, 0 where it is held
  kBareWeight = 11,
  kBareF = 14,
  kBareM = 17,
  kSpaceBlockRows = 20
};

struct BareSpace {
  int n_pack, first_ground, n_block;  // packs of faces, or faces of walls side by side
  const std::int32_t *a, *b;
  const double *face, *point, *axes, *law;
  double *hot, *cold, *block, *wall;
  double *shift, *turn;  // rows of four: u and w; x, y, z. The last is nobody's.
  double *force, *moment_a, *moment_b;
  const std::int32_t *begin, *middle, *entry;
  unsigned char* busy;
};

template <class Real>
struct SpacePoint {
  Real sigma, t1, t2;
};

// The whole law at a point (bare_law with the slip as a vector).
template <class Real>
WYTHE_INLINE SpacePoint<Real> bare_space_law(const auto& m, Real w, Real s1, Real s2, double* hot,
                                             double* cold, Real area, BareWork<Real>& work,
                                             auto& rests) {
  const Real zero(0.0), one(1.0), half(0.5);
  Real p = get<Real>(hot, kHotCrush), we = w + p;
  const auto crushes = w < get<Real>(hot, kHotCrushesBelow);
  if (any(crushes)) {
    const Real fc = m(kFc) * maximum(zero, one - p * m(kInvPFull));
    const Real excess = zero - m(kKn) * we - fc;
    const Real softened = p + maximum(zero, excess) * m(kCrushGain);
    const Real p1 = select(softened > m(kPFull), maximum(p, zero - w), softened);
    const Real after = m(kFc) * maximum(zero, one - p1 * m(kInvPFull));
    const Real length = minimum(p1, m(kPFull)) - minimum(p, m(kPFull));
    work.crushing = work.crushing + area * half * (fc + after) * length;
    p = p1;
    we = w + p;
    put(p, hot, kHotCrush);
    put(zero - after * m(kInvKn) - p, hot, kHotCrushesBelow);
  }
  const Real kappa0 = get<Real>(cold, kKappa), ds0 = get<Real>(cold, kShear);
  const Real open = maximum(we, zero), kappa = maximum(kappa0, open);
  const Real left = left_at(m, kappa), y0 = m(kFt) * get<Real>(hot, kHotLeft);
  const Real inv_kappa = one / maximum(kappa, Real(1e-30));
  const Real closed = m(kKn) * minimum(we, zero);
  const Real sn = zero - (closed + open * minimum(m(kKn), m(kFt) * left * (one - ds0) * inv_kappa));
  const Real residual = select((we > zero) & (left <= zero), zero, m(kCRes) + sn * m(kTanRes));
  const Real drop = (m(kCDrop) + sn * m(kTanDrop)) * left;
  const Real rate = maximum(zero, m(kCDrop) + maximum(sn, zero) * m(kTanDrop)) * m(kHalfInvGII);
  Real slip = get<Real>(cold, kSlip);
  Real ds = maximum(ds0, minimum(one, slip * rate));
  const Real plastic1 = get<Real>(hot, kHotPlastic1), plastic2 = get<Real>(hot, kHotPlastic2);
  Real e1 = s1 - plastic1, e2 = s2 - plastic2;
  const Real e = square_root(e1 * e1 + e2 * e2), trial = m(kKs) * e;
  const Real start = maximum(zero, residual + drop * (one - ds));
  const auto slides = trial > start;
  if (any(slides)) {
    const Real over = trial - residual;
    const Real flat = (over - drop * (one - ds)) * m(kInvKs);
    const Real falling = (over - drop * (one - slip * rate)) / (m(kKs) - drop * rate);
    const Real beyond = select((slip + falling) * rate < one, falling, over * m(kInvKs));
    const Real raw = select((slip + flat) * rate <= ds, flat, beyond);
    const Real slid = select(slides, maximum(zero, minimum(raw, e)), zero);
    const Real share = slid / maximum(e, Real(1e-300));
    slip = slip + slid;
    put(plastic1 + share * e1, hot, kHotPlastic1);
    put(plastic2 + share * e2, hot, kHotPlastic2);
    e1 = e1 - share * e1, e2 = e2 - share * e2;
    ds = maximum(ds, minimum(one, slip * rate));
    const Real worked = half * (start + m(kKs) * (e - slid)) * slid;
    const Real rubbed = minimum(worked, maximum(zero, residual) * slid);
    work.friction = work.friction + area * rubbed;
    work.fracture = work.fracture + area * (worked - rubbed);
    put(slip, cold, kSlip);
  }
  const Real y = left * (one - ds), strength = m(kFt) * y;
  const Real from = maximum(kappa0, minimum(kappa, y0 * m(kInvKn)));
  const Real f0 = minimum(y0, m(kKn) * from), f1 = minimum(strength, m(kKn) * kappa);
  const Real freed =
      select(open > kappa0, f0 * kappa - f1 * from, (f0 - f1) * open * open * inv_kappa);
  work.fracture = work.fracture + area * half * maximum(zero, freed);
  put(kappa, cold, kKappa);
  put(ds, cold, kShear);
  put(y, hot, kHotLeft);
  put(select(ds < one, ds * m(kTwoGII) / maximum(slip, Real(1e-30)), Real(1e300)), hot,
      kHotDamagedFrom);
  rests = (we <= zero) & (trial <= start);
  return {closed + open * minimum(m(kKn), strength * inv_kappa), m(kKs) * e1, m(kKs) * e2};
}

// The stresses of a point at rest; else `busy`. Strength and shear are compared by their squares.
template <class Real>
WYTHE_INLINE SpacePoint<Real> space_at_rest(const auto& m, Real w, Real s1, Real s2,
                                            const double* hot, auto& busy) {
  const Real we = w + get<Real>(hot, kHotCrush), sigma = m(kKn) * we;
  const Real t1 = m(kKs) * (s1 - get<Real>(hot, kHotPlastic1)),
             t2 = m(kKs) * (s2 - get<Real>(hot, kHotPlastic2));
  const Real drop = m(kCDrop) - sigma * m(kTanDrop);
  const Real strength = m(kCRes) - sigma * m(kTanRes) + drop * get<Real>(hot, kHotLeft);
  busy = busy | (we > Real(0.0)) | (t1 * t1 + t2 * t2 > strength * strength) |
         (w < get<Real>(hot, kHotCrushesBelow)) | (drop > get<Real>(hot, kHotDamagedFrom));
  return {sigma, t1, t2};
}

template <class Real, bool many>
struct SpaceStep {
  static constexpr int kW = kWidth<Real>;
  using L = dynamics::Lanes<Real>;
  using Vec = Vector<Real>;
  using Law = std::conditional_t<many, LawOfWalls<Real>, LawOfWall<Real>>;
  const BareSpace v;

  // What all walls share: a number, or one a face of the pack.
  WYTHE_INLINE static Real shared(const double* table, std::ptrdiff_t row) {
    if constexpr (many) return Real(table[row]);
    return L::load(table + row * kW);
  }
  WYTHE_INLINE Vec face(std::ptrdiff_t k, int row) const {
    const std::ptrdiff_t at = k * kBareFaceRows + row;
    return {shared(v.face, at), shared(v.face, at + 1), shared(v.face, at + 2)};
  }
  WYTHE_INLINE contact::Pose<Real> pose(const std::int32_t* id, std::ptrdiff_t k) const {
    if constexpr (many) {
      const double *u = v.shift + 4 * id[k] * std::ptrdiff_t{kW},
                   *q = v.turn + 4 * id[k] * std::ptrdiff_t{kW};
      return {{get<Real>(u, 0), get<Real>(u, 1), get<Real>(u, 2)},
              {get<Real>(u, 3), {get<Real>(q, 0), get<Real>(q, 1), get<Real>(q, 2)}}};
    } else {
      const dynamics::Rows<Real> u = L::load_rows(v.shift, id + k * kW),
                                 q = L::load_rows(v.turn, id + k * kW);
      return {{u.c0, u.c1, u.c2}, {u.c3, {q.c0, q.c1, q.c2}}};
    }
  }
  WYTHE_INLINE double* block(std::ptrdiff_t i) const { return v.block + i * kSpaceBlockRows * kW; }
  WYTHE_INLINE static void add(Vec f, double* rows, int row) {
    put(get<Real>(rows, row) + f.x, rows, row);
    put(get<Real>(rows, row + 1) + f.y, rows, row + 1);
    put(get<Real>(rows, row + 2) + f.z, rows, row + 2);
  }
  template <bool on_ground>
  WYTHE_INLINE void keep(const contact::BlockLoads<Real>& l, std::ptrdiff_t k) const {
    const Real zero(0.0);
    if constexpr (many) {
      if constexpr (!on_ground) {
        add(l.f, block(v.a[k]), kBareF);
        add(l.on_a, block(v.a[k]), kBareM);
      }
      add(Real(-1.0) * l.f, block(v.b[k]), kBareF);
      add(l.on_b, block(v.b[k]), kBareM);
    } else {
      L::store_rows({l.f.x, l.f.y, l.f.z, zero}, v.force + 4 * k * kW);
      if constexpr (!on_ground)
        L::store_rows({l.on_a.x, l.on_a.y, l.on_a.z, zero}, v.moment_a + 4 * k * kW);
      L::store_rows({l.on_b.x, l.on_b.y, l.on_b.z, zero}, v.moment_b + 4 * k * kW);
    }
  }

  struct At {
    Real r1, r2, area, w, s1, s2;
  };
  WYTHE_INLINE At at(std::ptrdiff_t k, int p, const contact::FaceGap<Real>& g) const {
    const std::ptrdiff_t row = (k * kFacePoints + p) * kBarePointRows;
    const Real r1 = shared(v.point, row), r2 = shared(v.point, row + 1);
    return {r1,
            r2,
            shared(v.point, row + 2),
            g.j.z + r1 * g.a.z + r2 * g.b.z,
            g.j.x + r1 * g.a.x + r2 * g.b.x,
            g.j.y + r1 * g.a.y + r2 * g.b.y};
  }
  WYTHE_INLINE static void sum(contact::FaceLoad<Real>& l, const At& p, const SpacePoint<Real>& t) {
    const Vec f{p.area * t.t1, p.area * t.t2, p.area * t.sigma};
    l.f = l.f + f;
    l.r1 = l.r1 + p.r1 * f;
    l.r2 = l.r2 + p.r2 * f;
  }
  template <bool on_ground>
  WYTHE_INLINE void face(std::ptrdiff_t k, const Law& law, BareWork<Real>& work) const {
    const auto with = [&](const auto& geometry) __attribute__((always_inline)) {
      const contact::FaceGap<Real> gap = geometry.gap();
      if (v.busy[k] != 0 || !rest<on_ground>(k, law, geometry, gap))
        move<on_ground>(k, law, geometry, gap, work);
    };
    if constexpr (on_ground)
      with(contact::SupportFace<Real>({Real(0.0), Real(0.0), Real(0.0)}, pose(v.b, k),
                                      face(k, kBareArmB), face(k, kBareT), face(k, kBareN)));
    else
      with(contact::PairFace<Real>(pose(v.a, k), pose(v.b, k), face(k, kBareArmA),
                                   face(k, kBareArmB), face(k, kBareT), face(k, kBareN)));
  }
  template <bool on_ground>
  WYTHE_INLINE bool rest(std::ptrdiff_t k, const Law& law, const auto& geometry,
                         const contact::FaceGap<Real>& gap) const {
    const Real zero(0.0);
    const Vec none{zero, zero, zero};
    contact::FaceLoad<Real> load{none, none, none};
    const double* hot = v.hot + k * kFacePoints * kSpaceHotRows * kW;
    bool_of_t<Real> busy = zero > zero;
    for (int p = 0; p < kFacePoints; ++p) {
      const At point = at(k, p, gap);
      sum(load, point,
          space_at_rest(law, point.w, point.s1, point.s2, hot + p * kSpaceHotRows * kW, busy));
    }
    if (any(busy)) return false;
    keep<on_ground>(geometry.loads(load), k);
    return true;
  }
  template <bool on_ground>
  [[gnu::noinline]] void move(std::ptrdiff_t k, const Law& law, const auto& geometry,
                              const contact::FaceGap<Real>& gap, BareWork<Real>& work) const {
    const Real zero(0.0);
    const Vec none{zero, zero, zero};
    contact::FaceLoad<Real> load{none, none, none};
    double *hot = v.hot + k * kFacePoints * kSpaceHotRows * kW,
           *cold = v.cold + k * kFacePoints * kColdRows * kW;
    bool_of_t<Real> rest = zero <= zero;
    for (int p = 0; p < kFacePoints; ++p) {
      const At point = at(k, p, gap);
      bool_of_t<Real> rests;
      sum(load, point,
          bare_space_law(law, point.w, point.s1, point.s2, hot + p * kSpaceHotRows * kW,
                         cold + p * kColdRows * kW, point.area, work, rests));
      rest = rest & rests;
    }
    v.busy[k] = all(rest) ? 0 : 1;
    keep<on_ground>(geometry.loads(load), k);
  }

  WYTHE_INLINE static Vec rows(const double* q, int row) {
    return {get<Real>(q, row), get<Real>(q, row + 1), get<Real>(q, row + 2)};
  }
  WYTHE_INLINE static void store_rows(const Vec& a, double* q, int row) {
    put(a.x, q, row), put(a.y, q, row + 1), put(a.z, q, row + 2);
  }
  // Block i of walls side by side, or kW blocks from i kW on.
  WYTHE_INLINE void block(std::ptrdiff_t i, Real dt, Real lambda, Real& loads, Real& damped) const {
    const Real zero(0.0), half(0.5);
    double* q = block(i);
    const Vec weight = rows(q, kBareWeight);
    Vec f = weight, m{zero, zero, zero};
    if constexpr (many) {
      f = f + rows(q, kBareF), m = rows(q, kBareM);
      store_rows({zero, zero, zero}, q, kBareF);
      store_rows({zero, zero, zero}, q, kBareM);
    } else {
      double all[6][kW];
      for (int k = 0; k < kW; ++k) {
        double sum[6] = {};
        const std::ptrdiff_t e0 = v.begin[i * kW + k], e1 = v.middle[i * kW + k],
                             e2 = v.begin[i * kW + k + 1];
        for (std::ptrdiff_t e = e0; e < e1; ++e)
          for (int c = 0; c < 3; ++c)
            sum[c] += v.force[4 * v.entry[e] + c], sum[3 + c] += v.moment_a[4 * v.entry[e] + c];
        for (std::ptrdiff_t e = e1; e < e2; ++e)
          for (int c = 0; c < 3; ++c)
            sum[c] -= v.force[4 * v.entry[e] + c], sum[3 + c] += v.moment_b[4 * v.entry[e] + c];
        for (int r = 0; r < 6; ++r) all[r][k] = sum[r];
      }
      f = f + Vec{L::load(all[0]), L::load(all[1]), L::load(all[2])};
      m = {L::load(all[3]), L::load(all[4]), L::load(all[5])};
    }
    dynamics::space::Inertia<Real> body;
    for (int k = 0; k < 3; ++k) {
      const std::ptrdiff_t at = i * 9 + 3 * k;
      body.axis[k] = {shared(v.axes, at), shared(v.axes, at + 1), shared(v.axes, at + 2)};
      body.inverse[k] = get<Real>(q, kBareInverse + k);
    }
    double *u = v.shift + 4 * i * kW, *t = v.turn + 4 * i * kW;
    std::int32_t id[kW];
    for (int k = 0; k < kW; ++k) id[k] = k;
    dynamics::Rows<Real> shift, turn;
    if constexpr (many) {
      shift = {get<Real>(u, 0), get<Real>(u, 1), get<Real>(u, 2), get<Real>(u, 3)};
      turn = {get<Real>(t, 0), get<Real>(t, 1), get<Real>(t, 2), zero};
    } else {
      shift = L::load_rows(u, id), turn = L::load_rows(t, id);
    }
    const Quaternion<Real> now{shift.c3, {turn.c0, turn.c1, turn.c2}};
    const Vec v0 = rows(q, kBareV), l0 = rows(q, kBareL);
    const Vec drag = dynamics::space::damping_of(f, v0, lambda, false);
    const Vec v1 = v0 + get<Real>(q, kBareMobility) * (f + drag);
    const Vec rate0 = turned(now, body.rate(turned_back(now, l0)));
    const Vec brake = dynamics::space::damping_of(m, rate0, lambda, false);
    const Vec l1 = l0 + get<Real>(q, kBareTurn) * (m + brake), inside = turned_back(now, l1);
    const Vec rate1 = turned(now, body.rate(inside));
    loads = loads + half * dt * dot(weight, v0 + v1);
    damped = damped + half * dt * (dot(drag, v0 + v1) + dot(brake, rate0 + rate1));
    const Quaternion<Real> next = dynamics::space::spin(now, inside, body, dt);
    store_rows(v1, q, kBareV);
    store_rows(l1, q, kBareL);
    shift = {shift.c0 + dt * v1.x, shift.c1 + dt * v1.y, shift.c2 + dt * v1.z, next.w};
    if constexpr (many) {
      put(shift.c0, u, 0), put(shift.c1, u, 1), put(shift.c2, u, 2), put(shift.c3, u, 3);
      put(next.v.x, t, 0), put(next.v.y, t, 1), put(next.v.z, t, 2);
    } else {
      L::store_rows(shift, u);
      L::store_rows({next.v.x, next.v.y, next.v.z, zero}, t);
    }
  }

  WYTHE_INLINE Real wall_value(int row) const {
    if constexpr (many) return get<Real>(v.wall, row);
    return Real(v.wall[row]);
  }
  WYTHE_INLINE void book(int row, Real work) const {
    if constexpr (many)
      put(get<Real>(v.wall, row) + work, v.wall, row);
    else
      v.wall[row] += JointStep<Real>::sum(work);
  }
  void run() const {
    const Real zero(0.0);
    BareWork<Real> work{zero, zero, zero};
    const Law law{v.law};
    for (std::ptrdiff_t k = 0; k < v.first_ground; ++k) face<false>(k, law, work);
    for (std::ptrdiff_t k = v.first_ground; k < v.n_pack; ++k) face<true>(k, law, work);
    Real loads = zero, damped = zero;
    const Real dt = wall_value(kDt), lambda = wall_value(kDamping);
    const std::ptrdiff_t blocks = many ? v.n_block : (v.n_block + kW - 1) / kW;
    for (std::ptrdiff_t i = 0; i < blocks; ++i) block(i, dt, lambda, loads, damped);
    book(kFriction, work.friction), book(kFracture, work.fracture);
    book(kCrushing, work.crushing), book(kLoads, loads), book(kDamped, damped);
  }
};

template <class Real, bool many>
void bare_space_step(const BareSpace& v) {
  SpaceStep<Real, many>{v}.run();
}

struct SpaceKernels {
  const char* name;
  int lanes;
  void (*step[2])(const BareSpace&);  // one wall in packs of faces, walls side by side
};
template <class Real>
[[nodiscard]] constexpr SpaceKernels space_kernels(const char* name) {
  return {name, kWidth<Real>, {bare_space_step<Real, false>, bare_space_step<Real, true>}};
}
[[nodiscard]] const SpaceKernels& bare_space_scalar();
#if defined(__x86_64__)
[[nodiscard]] const SpaceKernels& bare_space_avx2();
[[nodiscard]] const SpaceKernels& bare_space_avx512();
#endif

}  // namespace wythe::bench
