// Each joint evaluates its stresses, advances its history and writes its force.
//
// A joint's points lie on the line between the two faces; both faces follow their blocks. With
// j the jump of the face centre, h the half length of the face, delta = tb - ta, phi = (ta + tb)/2
// and the face along the tangent, its growth (Rb - Ra) e is normal to the mean face and its mean
// (Ra + Rb) e / 2 along it:
//
//   w(xi) = j . n(phi) + xi 2 h sin(delta/2)      s(xi) = j . t(phi)      the same at all points
//   f = area weight (sigma n + tau t) on a, -f on b, both acting at the midpoint of the pair
//   lever of the points about the midpoint of the centres: xi h cos(delta/2) t(phi)
//
// The midpoint with the mean rotation is exactly work-conjugate to w and s and gives equal and
// opposite forces on one line of action: linear and angular momentum are kept and no energy is made
// by large rotation (docs/theory/kinematics.md). On the ground the normal stands still and the force
// acts at the block's own point, so that a block may slide any distance.
//
// The half-angle cosines of two blocks multiply to those of the mean angle: no root, no division.
#pragma once

#include "contact/fast_paths.h"
#include "core/several.h"
#include "dynamics/passes/access.h"
#include "dynamics/passes/law_path.h"

namespace wythe::dynamics {

template <class Real>
struct JointWork {
  Real friction, fracture, crushing;  // [J]
};

// Motion of one side: displacement of the face centre and the turned arm to it.
template <class Real>
struct FaceMotion {
  Real move_x, move_y;
  Real arm_x, arm_y;
};

// cos theta - 1, free of cancellation, and sin theta.
template <class Real>
struct Turn {
  Real drop, sine;
};
template <class Real>
[[nodiscard]] WYTHE_INLINE Turn<Real> turn_of(const Rows<Real>& pose) {
  return {Real(-2.0) * pose.c3 * pose.c3, Real(2.0) * pose.c3 * pose.c2};
}

template <class Real>
[[nodiscard]] WYTHE_INLINE FaceMotion<Real> face_motion(const Rows<Real>& pose,
                                                        const Turn<Real>& turn, Real arm_x,
                                                        Real arm_y) {
  const Real dx = turn.drop * arm_x - turn.sine * arm_y;
  const Real dy = turn.sine * arm_x + turn.drop * arm_y;
  return {pose.c0 + dx, pose.c1 + dy, arm_x + dx, arm_y + dy};
}

// Pose of a block in the step before, up to rounding: its velocity acted for the time `dt` (kTimeBefore).
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE Rows<Real> pose_before(const Tables& t, const Access& access,
                                                  const std::int32_t* id, std::ptrdiff_t item) {
  const Rows<Real> pose = access.rows(t.pose, id, item);
  const Real dt = access.wall_value(t.wall, kTimeBefore), one(1.0);
  const auto moved = [&](BlockRow velocity) __attribute__((always_inline)) {
    return dt * access.of(t.block, kBlockRows, velocity, id, item);
  };
  const Real turn = Real(0.5) * moved(kOmega), square = turn * turn;  // small: its sine and cosine
  const Real sine = turn * (one - square * Real(1.0 / 6.0));
  const Real cosine = one - Real(0.5) * square * (one - square * Real(1.0 / 12.0));
  return {pose.c0 - moved(kVx), pose.c1 - moved(kVy), pose.c2 * cosine + pose.c3 * sine,
          pose.c3 * cosine - pose.c2 * sine};
}

// Sums over the points of a joint, in its (n, t) axes: F = sum f, G = sum xi f.
template <class Real>
struct FaceForce {
  Real fn, ft, gn, gt;
};

// Jump of the face centre and its growth along the face, in the joint's (n, t)
// axes. Between two blocks there is no growth along t, so `dt` is not read.
template <class Real>
struct FaceJump {
  Real jn, jt, dn, dt;
};

// A run of joints (or edges) that share law and points: their tables, their points.
template <class Access>
struct FaceRun {
  using Real = typename Access::Real;
  Access access;
  const double* law;                           // table of laws (tables.h)
  std::ptrdiff_t strengths, others;            // first rows of the run, in it
  std::ptrdiff_t strengths_each, others_each;  // rows of an item's own, 0 where all have the same
  contact::LawChoice choice;
  const double *xi, *weight;  // of the points of a face
  double* history;            // from the run's first item on
  std::uint8_t* law_path;
  std::ptrdiff_t begin;  // its first item
  int points;

  [[nodiscard]] WYTHE_INLINE contact::LawConstants<Real> law_at(std::ptrdiff_t item) const {
    const std::ptrdiff_t k = item - begin;
    return law_of(access, law, strengths + strengths_each * k, others + others_each * k, choice);
  }
};
template <class Access>
[[nodiscard]] WYTHE_INLINE FaceRun<Access> face_run(const Tables& t, Access access,
                                                    const Chunk& chunk, std::uint8_t* law_path) {
  return {access,
          t.law,
          chunk.strengths,
          chunk.others,
          chunk.graded ? kStrengths : 0,
          chunk.graded_others ? kOthers : 0,
          chunk.choice,
          t.point_xi + chunk.rule,
          t.point_weight + chunk.rule,
          t.history + static_cast<std::ptrdiff_t>(chunk.history) * access.history_lanes(),
          law_path,
          chunk.begin,
          chunk.points};
}

// `n` points of a face from point `from` on, taken together.
template <class V, int n, bool one_slip, class Access>
struct FacePoints {
  using Real = typename Access::Real;
  using Points = Several<Real, n>;
  using History = contact::History<Points>;

  const FaceRun<Access>& run;
  const contact::LawConstants<Real>& law;
  std::ptrdiff_t first;  // number of its history
  int from;

  [[nodiscard]] WYTHE_INLINE int rows() const {
    return contact::history_size(contact::choice_of<V>(run));
  }
  WYTHE_INLINE History load() const {
    History h;
    for_each_part<kHistoryRows>([&](auto r) __attribute__((always_inline)) {
      constexpr auto member = contact::kHistory<Points>[decltype(r)::value];
      if (r >= rows()) return;
      for_each_part<n>([&](auto k) __attribute__((always_inline)) {
        (h.*member).template part<k>() = run.access.load(run.history, first + k * rows() + r);
      });
    });
    return h;
  }
  WYTHE_INLINE void store(const History& h) const {
    for_each_part<kHistoryRows>([&](auto r) __attribute__((always_inline)) {
      constexpr auto member = contact::kHistory<Points>[decltype(r)::value];
      if (r >= rows()) return;
      for_each_part<n>([&](auto k) __attribute__((always_inline)) {
        run.access.store((h.*member).template part<k>(), run.history, first + k * rows() + r);
      });
    });
  }
  // Two points are those at the ends of the face (Chunk::at_ends).
  [[nodiscard]] WYTHE_INLINE Points places() const {
    if constexpr (n == 2) return {Real(-1.0), Several<Real, 1>(Real(1.0))};
    return of_points(run.xi);
  }
  [[nodiscard]] WYTHE_INLINE Points shares(Real area) const {
    if constexpr (n == 2) return Points(area * Real(0.5));
    return Points(area) * of_points(run.weight);
  }
  [[nodiscard]] WYTHE_INLINE Points of_points(const double* number) const {
    Points all;
    for_each_part<n>([&](auto k) __attribute__((always_inline)) {
      all.template part<k>() = Real(number[from + k]);
    });
    return all;
  }
  [[nodiscard]] WYTHE_INLINE Points opening(const FaceJump<Real>& jump) const {
    return Points(jump.jn) + places() * Points(jump.dn);
  }
  [[nodiscard]] WYTHE_INLINE Points slip(const FaceJump<Real>& jump) const {
    if constexpr (one_slip) return Points(jump.jt);
    return Points(jump.jt) + places() * Points(jump.dt);
  }
  WYTHE_INLINE void add(Real area, const Points& sigma, const Points& tau,
                        FaceForce<Real>& sum) const {
    const Points xi = places(), share = shares(area);
    const Points fn = sigma * share, ft = tau * share, gn = fn * xi, gt = ft * xi;
    for_each_part<n>([&](auto k) __attribute__((always_inline)) {
      sum = {sum.fn + fn.template part<k>(), sum.ft + ft.template part<k>(),
             sum.gn + gn.template part<k>(), sum.gt + gt.template part<k>()};
    });
  }

  // Forces in an elastic step. Also tells whether the step is elastic and whether a point is open.
  template <bool closed>
  WYTHE_INLINE void elastic(Real area, const FaceJump<Real>& jump, FaceForce<Real>& sum,
                            bool_of_t<Real>& is_elastic, bool_of_t<Real>& open) const {
    const contact::ElasticStep<Points> now =
        contact::elastic_step<V, closed>(law, opening(jump), slip(jump), load());
    add(area, now.sigma, now.tau, sum);
    is_elastic = is_elastic & now.is_elastic.all_parts();
    open = open | now.open.any_part();
  }
  // Forces of undamaged points. Also tells whether they stay undamaged.
  WYTHE_INLINE void undamaged(Real area, const FaceJump<Real>& jump, FaceForce<Real>& sum,
                              bool_of_t<Real>& stays) const {
    const contact::UndamagedStress<Points> now =
        contact::undamaged_point(law, opening(jump), slip(jump));
    add(area, now.sigma, now.tau, sum);
    stays = stays & now.stays.all_parts();
  }
  // Stores the largest opening of undamaged points; it is their only history.
  WYTHE_INLINE void store_opening(const FaceJump<Real>& jump) const {
    const Points w = opening(jump);
    for_each_part<n>([&](auto k) __attribute__((always_inline)) {
      const Real now = w.template part<k>();
      const Real kappa = run.access.load(run.history, first + k * rows());
      const bool_of_t<Real> wider = now > kappa;
      if (any(wider)) run.access.store(select(wider, now, kappa), run.history, first + k * rows());
    });
  }
  // The full law, the only place where all of the history advances. It tells whether history changed, whether a point is
  // open and whether all points are undamaged. jump_before() is called where a point slides, for the work of the slip.
  template <class Before>
  WYTHE_INLINE void advance(Real area, const FaceJump<Real>& jump, const Before& jump_before,
                            FaceForce<Real>& sum, JointWork<Real>& work, bool_of_t<Real>& moved,
                            bool_of_t<Real>& open, bool& undamaged) const {
    const History before = load();
    History now = before;
    const Points w = opening(jump);
    const contact::LawUpdate<Points> a = contact::update<V>(law, w, slip(jump), now);
    store(now);
    add(area, a.sigma, a.tau, sum);
    const Points share = shares(area);
    Points taken = a.friction;
    if (any((magnitude(a.slipped) > Points(Real(0.0))).any_part())) {
      const FaceJump<Real> then = jump_before();
      taken = contact::friction_taken<V>(law, a, before, opening(then), slip(then));
    }
    const Points friction = taken * share, fracture = a.fracture * share,
                 crushing = a.crushing * share;
    for_each_part<n>([&](auto k) __attribute__((always_inline)) {
      work = {work.friction + friction.template part<k>(),
              work.fracture + fracture.template part<k>(),
              work.crushing + crushing.template part<k>()};
    });
    moved = moved | contact::history_changed(before, now).any_part();
    open = open | (w + now.crush > Points(Real(0.0))).any_part();
    // slip first, because most points have slid
    undamaged =
        undamaged && !any(now.slip > Points(Real(0.0))) && all(contact::is_undamaged<V>(law, now));
  }
};

// Calls act(FacePoints) for all points of the face at `item`: once for all if
// their number n is known at compile time, one by one if it is not (n = 0).
template <class V, int n, bool one_slip, class Access, class Act>
WYTHE_INLINE void each_points(const FaceRun<Access>& run, std::ptrdiff_t item, const Act& act) {
  const int points = n > 0 ? n : run.points;
  const int rows = contact::history_size(contact::choice_of<V>(run));
  const contact::LawConstants<typename Access::Real> law = run.law_at(item);
  const std::ptrdiff_t first = (item - run.begin) * points * rows;
  if constexpr (n > 0) {
    act(FacePoints<V, n, one_slip, Access>{run, law, first, 0});
  } else {
    for (int k = 0; k < points; ++k)
      act(FacePoints<V, 1, one_slip, Access>{run, law, first + k * rows, k});
  }
}

template <class V, int n, bool one_slip, class Access, class Before, class Real>
WYTHE_OUTLINE FaceForce<Real> full_law_face(const FaceRun<Access>& run, std::ptrdiff_t item,
                                            Real area, const FaceJump<Real>& jump, Before before,
                                            JointWork<Real>& work) {
  const Real zero(0.0);
  FaceForce<Real> sum{zero, zero, zero, zero};
  bool_of_t<Real> moved = zero > zero, open = zero > zero;
  bool undamaged = contact::has_undamaged_path<V>(run.law_at(item));
  each_points<V, n, one_slip>(
      run, item, [&](const auto& points) __attribute__((always_inline)) {
        points.advance(area, jump, before, sum, work, moved, open, undamaged);
      });
  run.access.store_flag(run.law_path, item,
                        undamaged    ? kUndamaged
                        : any(moved) ? kFullLaw
                        : any(open)  ? kOpen
                                     : kClosed);
  return sum;
}

// Forces of a face with undamaged points; false where a point does not stay undamaged.
template <class V, int n, bool one_slip, class Access, class Real>
[[nodiscard]] WYTHE_INLINE bool undamaged_face(const FaceRun<Access>& run, std::ptrdiff_t item,
                                               Real area, const FaceJump<Real>& jump,
                                               FaceForce<Real>& sum) {
  const Real zero(0.0);
  sum = {zero, zero, zero, zero};
  bool_of_t<Real> stays = zero <= zero;
  each_points<V, n, one_slip>(
      run, item, [&](const auto& points) __attribute__((always_inline)) {
        points.undamaged(area, jump, sum, stays);
      });
  if (!all(stays)) return false;
  each_points<V, n, one_slip>(
      run,
      item, [&](const auto& points) __attribute__((always_inline)) { points.store_opening(jump); });
  return true;
}

// Forces of a face in an elastic step; false where the history of a point changes.
template <class V, int n, bool one_slip, bool closed, class Access, class Real>
[[nodiscard]] WYTHE_INLINE bool elastic_face(const FaceRun<Access>& run, std::ptrdiff_t item,
                                             Real area, const FaceJump<Real>& jump,
                                             FaceForce<Real>& sum) {
  const Real zero(0.0);
  sum = {zero, zero, zero, zero};
  bool_of_t<Real> is_elastic = zero <= zero, open = zero > zero;
  each_points<V, n, one_slip>(
      run, item, [&](const auto& points) __attribute__((always_inline)) {
        points.template elastic<closed>(area, jump, sum, is_elastic, open);
      });
  if (!all(is_elastic)) return false;
  if constexpr (!closed) run.access.store_flag(run.law_path, item, any(open) ? kOpen : kClosed);
  return true;
}

// Forces of a face. Fast paths store no history except the opening of undamaged points. A face whose
// history changed in the last step takes the full law at once. `before` gives the jump of the step before.
template <class V, int n, bool one_slip, class Access, class Before, class Real>
[[nodiscard]] WYTHE_INLINE FaceForce<Real> face_force(const FaceRun<Access>& run,
                                                      std::ptrdiff_t item, Real area,
                                                      const FaceJump<Real>& jump, Before before,
                                                      JointWork<Real>& work) {
  const std::uint8_t law_path = run.access.load_flag(run.law_path, item);
  FaceForce<Real> sum;
  if (law_path == kUndamaged && undamaged_face<V, n, one_slip>(run, item, area, jump, sum))
    return sum;
  if (law_path == kClosed && elastic_face<V, n, one_slip, true>(run, item, area, jump, sum))
    return sum;
  if (law_path == kOpen && elastic_face<V, n, one_slip, false>(run, item, area, jump, sum))
    return sum;
  return full_law_face<V, n, one_slip>(run, item, area, jump, before, work);
}

// Row of the geometry of joint j.
template <class Access>
[[nodiscard]] WYTHE_INLINE typename Access::Real joint_row(const Tables& t, const Access& access,
                                                           std::ptrdiff_t j, JointRow row) {
  return access.shared(t.joint, j * kJointRows + row);
}

// A face between two blocks in their present poses: arms, tangent, jump of its centre, lever of its points.
template <class Real>
struct PairPlace {
  FaceMotion<Real> a, b;
  Real tx, ty, jx, jy, lever;
  FaceJump<Real> jump;
};
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE PairPlace<Real> pair_in(const Tables& t, const Access& access,
                                                   std::ptrdiff_t j, const Rows<Real>& pose_a,
                                                   const Rows<Real>& pose_b) {
  const auto of = [&](JointRow row) __attribute__((always_inline)) {
    return joint_row(t, access, j, row);
  };
  PairPlace<Real> p;
  p.a = face_motion(pose_a, turn_of(pose_a), of(kArmAX), of(kArmAY));
  p.b = face_motion(pose_b, turn_of(pose_b), of(kArmBX), of(kArmBY));
  // cosine and sine of phi and of delta/2
  const Real cc = pose_a.c2 * pose_b.c2, ss = pose_a.c3 * pose_b.c3;
  const Real sc = pose_a.c3 * pose_b.c2, cs = pose_a.c2 * pose_b.c3;
  const Real cos = cc - ss, sin = sc + cs;
  const Real tx0 = of(kTangentX), ty0 = of(kTangentY);
  p.tx = cos * tx0 - sin * ty0, p.ty = sin * tx0 + cos * ty0;
  const Real reach = of(kHalfLength);
  p.lever = reach * (cc + ss);
  p.jx = p.b.move_x - p.a.move_x, p.jy = p.b.move_y - p.a.move_y;
  p.jump = {p.jy * p.tx - p.jx * p.ty, p.jx * p.tx + p.jy * p.ty, Real(2.0) * reach * (cs - sc),
            Real(0.0)};
  return p;
}

// A face on the ground.
template <class Real>
struct GroundPlace {
  FaceMotion<Real> b;
  Turn<Real> turn;
  FaceJump<Real> jump;
};
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE GroundPlace<Real> ground_in(const Tables& t, const Access& access,
                                                       std::ptrdiff_t j, const Rows<Real>& pose) {
  const auto of = [&](JointRow row) __attribute__((always_inline)) {
    return joint_row(t, access, j, row);
  };
  GroundPlace<Real> g;
  g.turn = turn_of(pose);
  g.b = face_motion(pose, g.turn, of(kArmBX), of(kArmBY));
  const Real tx = of(kTangentX), ty = of(kTangentY), reach = of(kHalfLength);
  g.jump = {g.b.move_y * tx - g.b.move_x * ty, g.b.move_x * tx + g.b.move_y * ty,
            reach * g.turn.sine, reach * g.turn.drop};
  return g;
}

// The jump of the step before, for faces that slide. They are few, so this stays out of the loops.
template <class Access, bool on_ground>
WYTHE_OUTLINE FaceJump<typename Access::Real> jump_before(const Tables& t, const Access& access,
                                                          std::ptrdiff_t j) {
  const auto b = pose_before(t, access, t.joint_b, j);
  if constexpr (on_ground)
    return ground_in(t, access, j, b).jump;
  else
    return pair_in(t, access, j, pose_before(t, access, t.joint_a, j), b).jump;
}
template <class Access, bool on_ground>
struct JumpBefore {
  const Tables* tables;
  Access access;
  std::ptrdiff_t j;
  WYTHE_INLINE FaceJump<typename Access::Real> operator()() const {
    return jump_before<Access, on_ground>(*tables, access, j);
  }
};

// Joints of one law, one support and one number of points.
template <class V, bool on_ground, int n, class A>
struct Joints {
  using Access = A;
  using Real = typename Access::Real;
  using Work = JointWork<Real>;

  const Tables& t;
  FaceRun<Access> run;

  WYTHE_INLINE Joints(const Tables& tables, Access access, const Chunk& chunk)
      : t(tables), run(face_run(tables, access, chunk, tables.joint_law_path)) {}

  WYTHE_INLINE void select_part(int part) { run.access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t item, Work& work) const {
    if constexpr (Access::one_wall)
      if (run.access.load_flag(run.law_path, item) == kReleased) return;
    if constexpr (on_ground)
      ground(item, work);
    else
      pair(item, work);
  }

 private:
  [[nodiscard]] WYTHE_INLINE Real geometry(std::ptrdiff_t item, JointRow row) const {
    return joint_row(t, run.access, item, row);
  }

  WYTHE_INLINE void pair(std::ptrdiff_t j, Work& work) const {
    const Real half(0.5);
    const PairPlace<Real> p = pair_in(t, run.access, j, run.access.rows(t.pose, t.joint_a, j),
                                      run.access.rows(t.pose, t.joint_b, j));
    const FaceForce<Real> f = face_force<V, n, true>(
        run, j, geometry(j, kArea), p.jump, JumpBefore<Access, on_ground>{&t, run.access, j}, work);
    // back to the wall's axes: n = (-ty, tx)
    const Real fx = f.ft * p.tx - f.fn * p.ty, fy = f.ft * p.ty + f.fn * p.tx;
    const Real couple = p.lever * f.gn;
    const Real cx = half * p.jx, cy = half * p.jy;
    run.access.store_rows({fx, fy, ((p.a.arm_x + cx) * fy - (p.a.arm_y + cy) * fx) + couple,
                           ((p.b.arm_y - cy) * fx - (p.b.arm_x - cx) * fy) - couple},
                          t.force, j);
  }

  // On the ground the tangent is fixed and there is no lever.
  WYTHE_INLINE void ground(std::ptrdiff_t j, Work& work) const {
    const GroundPlace<Real> g = ground_in(t, run.access, j, run.access.rows(t.pose, t.joint_b, j));
    const Real tx = geometry(j, kTangentX), ty = geometry(j, kTangentY);
    const FaceForce<Real> f = face_force<V, n, false>(
        run, j, geometry(j, kArea), g.jump, JumpBefore<Access, on_ground>{&t, run.access, j}, work);
    const Real fx = f.ft * tx - f.fn * ty, fy = f.ft * ty + f.fn * tx;
    // the turned face is h ((1 + drop) t + sine n)
    const Real couple =
        geometry(j, kHalfLength) * ((Real(1.0) + g.turn.drop) * f.gn - g.turn.sine * f.gt);
    run.access.store_rows({fx, fy, Real(0.0), (g.b.arm_y * fx - g.b.arm_x * fy) - couple}, t.force,
                          j);
  }
};

}  // namespace wythe::dynamics
