// Each joint face in space evaluates its stresses, advances its history and writes its force. Geometry
// and forces: contact/face_in_space.h. The law and its paths are as in the plane (passes/joints.h).
#pragma once

#include "contact/face_in_space.h"
#include "contact/law.h"
#include "dynamics/passes/joints.h"
#include "dynamics/space/tables.h"
#include "dynamics/space/turning.h"

namespace wythe::dynamics::space {

template <class Real, class Access>
[[nodiscard]] WYTHE_INLINE Vector<Real> shared_vector(const Access& access, const double* table,
                                                      std::ptrdiff_t row) {
  return {access.shared(table, row), access.shared(table, row + 1), access.shared(table, row + 2)};
}

template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE contact::Pose<Real> pose_of(const Tables& t, const Access& access,
                                                       const std::int32_t* id, std::ptrdiff_t j) {
  const Rows<Real> shift = access.rows(t.shift, id, j), turn = access.rows(t.turn, id, j);
  return {{shift.c0, shift.c1, shift.c2}, {shift.c3, {turn.c0, turn.c1, turn.c2}}};
}
// Face j in the present poses: between two blocks, or on a support.
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE contact::PairFace<Real> pair_face(const Tables& t, const Access& access,
                                                             std::ptrdiff_t j) {
  const auto vector = [&](int row) __attribute__((always_inline)) {
    return shared_vector<Real>(access, t.face, j * kFaceRows + row);
  };
  return contact::PairFace<Real>(pose_of(t, access, t.joint_a, j), pose_of(t, access, t.joint_b, j),
                                 vector(kArmA), vector(kArmB), vector(kTangent), vector(kNormal));
}
template <class Access, class Real = typename Access::Real>
[[nodiscard]] WYTHE_INLINE contact::SupportFace<Real> support_face(const Tables& t,
                                                                   const Access& access,
                                                                   std::ptrdiff_t j) {
  const auto vector = [&](int row) __attribute__((always_inline)) {
    return shared_vector<Real>(access, t.face, j * kFaceRows + row);
  };
  const Rows<Real> moved = access.rows(t.support, t.joint_a, j);
  return contact::SupportFace<Real>({moved.c0, moved.c1, moved.c2},
                                    pose_of(t, access, t.joint_b, j), vector(kArmB),
                                    vector(kTangent), vector(kNormal));
}

// Whether an undamaged point (contact/fast_paths.h) stays undamaged. Squares of
// its shear (s1, s2) and of the strength are compared, so that no root is needed.
// The comparison is slightly strict, so update() never slides where it holds.
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE bool_of_t<Real> stays_undamaged(const contact::LawConstants<C>& m,
                                                           Real w, Real s1, Real s2) {
  const Real sigma = m.kn * w, sn = Real(0.0) - sigma;
  const Real strength = (m.c_res + sn * m.tan_res) + (m.c_drop + sn * m.tan_drop);
  const Real t1 = m.ks * s1, t2 = m.ks * s2;
  bool_of_t<Real> stays = w <= Real(contact::undamaged_opening(m));
  stays = stays & (strength > Real(0.0));
  stays = stays & (t1 * t1 + t2 * t2 < strength * strength * Real(1 - 1e-12));
  return stays & (sigma + m.fc >= Real(0.0));
}

// Joints of one law, one kind of support and one number of points.
template <class V, bool on_support, class A>
struct Joints {
  using Access = A;
  using Real = typename Access::Real;
  using Work = JointWork<Real>;
  using History = contact::History<Real>;

  const Tables& t;
  Access access;
  const Chunk& chunk;
  double* history;      // from the run's first item on
  const double* point;  // data of its points, from the run's first item on

  WYTHE_INLINE Joints(const Tables& tables, Access lanes, const Chunk& run)
      : t(tables),
        access(lanes),
        chunk(run),
        history(tables.history + static_cast<std::ptrdiff_t>(run.history) * lanes.history_lanes()),
        point(tables.point +
              static_cast<std::ptrdiff_t>(run.rule) * (Access::one_wall ? kGroup : 1)) {}

  WYTHE_INLINE void select_part(int part) { access.select_part(part); }
  WYTHE_INLINE void at(std::ptrdiff_t j, Work& work) const {
    if constexpr (Access::one_wall)
      if (access.load_flag(t.law_path, j) == kReleased) return;
    if constexpr (on_support) {
      const contact::SupportFace<Real> face = support_face(t, access, j);
      store_loads(j, face.loads(ask(j, face.gap(), work)));
    } else {
      const contact::PairFace<Real> face = pair_face(t, access, j);
      store_loads(j, face.loads(ask(j, face.gap(), work)));
    }
  }

 private:
  // The gap of the step before, for faces that slide.
  [[nodiscard]] WYTHE_OUTLINE contact::FaceGap<Real> gap_before(std::ptrdiff_t j) const {
    const auto vector = [&](int row) {
      return shared_vector<Real>(access, t.face, j * kFaceRows + row);
    };
    const contact::Pose<Real> b = pose_before(t, access, t.joint_b, j);
    if constexpr (on_support) {
      const Rows<Real> moved = access.rows(t.support, t.joint_a, j);
      const auto step = [&](int c) {
        return moved.c3 * access.wall_value(t.wall, kSupportStep + c);
      };
      return contact::SupportFace<Real>(
                 {moved.c0 - step(0), moved.c1 - step(1), moved.c2 - step(2)}, b, vector(kArmB),
                 vector(kTangent), vector(kNormal))
          .gap();
    } else {
      return contact::PairFace<Real>(pose_before(t, access, t.joint_a, j), b, vector(kArmA),
                                     vector(kArmB), vector(kTangent), vector(kNormal))
          .gap();
    }
  }
  WYTHE_INLINE void store_loads(std::ptrdiff_t j, const contact::BlockLoads<Real>& l) const {
    const Real zero(0.0);
    access.store_rows({l.f.x, l.f.y, l.f.z, zero}, t.force, j);
    if constexpr (!on_support)
      access.store_rows({l.on_a.x, l.on_a.y, l.on_a.z, zero}, t.moment_a, j);
    access.store_rows({l.on_b.x, l.on_b.y, l.on_b.z, zero}, t.moment_b, j);
  }

  // A point: its place, its share of the area, opening and shear.
  struct Asked {
    Real r1, r2, share, w;
    contact::Shear<Real> shear;
  };
  [[nodiscard]] WYTHE_INLINE int history_size() const {
    return contact::history_size(contact::choice_of<V>(chunk));
  }
  [[nodiscard]] WYTHE_INLINE std::ptrdiff_t first(std::ptrdiff_t j, int k, int rows) const {
    return ((j - chunk.begin) * chunk.points + k) * rows;
  }
  WYTHE_INLINE History load(std::ptrdiff_t row, Real& plastic_1, Real& plastic_2) const {
    History h;
    for_each_part<kHistoryRows>([&](auto r) __attribute__((always_inline)) {
      if (r < history_size())
        h.*contact::kHistory<Real>[decltype(r)::value] = access.load(history, row + r);
    });
    plastic_1 = h.plastic_slip;
    plastic_2 = access.load(history, row + history_size());
    h.plastic_slip = Real(0.0);
    return h;
  }
  WYTHE_INLINE void store(std::ptrdiff_t row, History h, Real plastic_1, Real plastic_2) const {
    h.plastic_slip = plastic_1;
    for_each_part<kHistoryRows>([&](auto r) __attribute__((always_inline)) {
      if (r < history_size())
        access.store(h.*contact::kHistory<Real>[decltype(r)::value], history, row + r);
    });
    access.store(plastic_2, history, row + history_size());
  }
  [[nodiscard]] WYTHE_INLINE Asked asked(std::ptrdiff_t row, Real area,
                                         const contact::FaceGap<Real>& gap, Real plastic_1,
                                         Real plastic_2) const {
    Asked p;
    p.r1 = access.shared(point, row + kR1);
    p.r2 = access.shared(point, row + kR2);
    p.share = area * access.shared(point, row + kShare);
    p.w = gap.j.z + p.r1 * gap.a.z + p.r2 * gap.b.z;
    p.shear = contact::shear_of(gap.j.x + p.r1 * gap.a.x + p.r2 * gap.b.x,
                                gap.j.y + p.r1 * gap.a.y + p.r2 * gap.b.y, plastic_1, plastic_2);
    return p;
  }
  WYTHE_INLINE void add(const Asked& p, Real sigma, Real tau_1, Real tau_2,
                        contact::FaceLoad<Real>& sum) const {
    const Vector<Real> f{p.share * tau_1, p.share * tau_2, p.share * sigma};
    sum.f = sum.f + f;
    sum.r1 = sum.r1 + p.r1 * f;
    sum.r2 = sum.r2 + p.r2 * f;
  }

  // Forces of a face. An elastic step stores no history. After a step that changed history, the full law is taken at once.
  [[nodiscard]] WYTHE_INLINE contact::FaceLoad<Real> ask(std::ptrdiff_t j,
                                                         const contact::FaceGap<Real>& gap,
                                                         Work& work) const {
    const std::ptrdiff_t step = chunk.graded ? (j - chunk.begin) * kLawRows : 0;
    const contact::LawConstants<Real> law =
        law_of(access, t.law, chunk.strengths + step, chunk.others + step, chunk.choice);
    const Real area = access.shared(t.face, j * kFaceRows + kFaceArea);
    const std::uint8_t law_path = access.load_flag(t.law_path, j);
    contact::FaceLoad<Real> sum;
    if (law_path == kUndamaged && undamaged(j, law, area, gap, sum)) return sum;
    if (law_path == kClosed && elastic<true>(j, law, area, gap, sum)) return sum;
    if (law_path == kOpen && elastic<false>(j, law, area, gap, sum)) return sum;
    return advance(j, law, area, gap, work);
  }
  // Undamaged points (contact/fast_paths.h): no history is loaded, and only the
  // opening is stored. Returns false where a point does not stay undamaged.
  [[nodiscard]] WYTHE_INLINE bool undamaged(std::ptrdiff_t j,
                                            const contact::LawConstants<Real>& law, Real area,
                                            const contact::FaceGap<Real>& gap,
                                            contact::FaceLoad<Real>& sum) const {
    const Real zero(0.0);
    const Vector<Real> none{zero, zero, zero};
    sum = {none, none, none};
    bool_of_t<Real> stays = zero <= zero, opened = zero > zero;
    for (int k = 0; k < chunk.points; ++k) {
      const Asked p = asked(first(j, k, kPointRows), area, gap, zero, zero);
      stays = stays & stays_undamaged(law, p.w, p.shear.e1, p.shear.e2);
      opened = opened | (p.w > zero);
      add(p, law.kn * p.w, law.ks * p.shear.e1, law.ks * p.shear.e2, sum);
    }
    if (!all(stays)) return false;
    if (any(opened)) store_opening(j, gap);
    return true;
  }
  WYTHE_INLINE void store_opening(std::ptrdiff_t j, const contact::FaceGap<Real>& gap) const {
    for (int k = 0; k < chunk.points; ++k) {
      const std::ptrdiff_t at = first(j, k, kPointRows), row = first(j, k, history_size() + 1);
      const Real w = gap.j.z + access.shared(point, at + kR1) * gap.a.z +
                     access.shared(point, at + kR2) * gap.b.z;
      const Real kappa = access.load(history, row);
      access.store(select(w > kappa, w, kappa), history, row);
    }
  }
  template <bool closed>
  [[nodiscard]] WYTHE_INLINE bool elastic(std::ptrdiff_t j, const contact::LawConstants<Real>& law,
                                          Real area, const contact::FaceGap<Real>& gap,
                                          contact::FaceLoad<Real>& sum) const {
    const Real zero(0.0);
    const Vector<Real> none{zero, zero, zero};
    sum = {none, none, none};
    bool_of_t<Real> is_elastic = zero <= zero, open = zero > zero;
    for (int k = 0; k < chunk.points; ++k) {
      Real plastic_1, plastic_2;
      const History h = load(first(j, k, history_size() + 1), plastic_1, plastic_2);
      const Asked p = asked(first(j, k, kPointRows), area, gap, plastic_1, plastic_2);
      const contact::ElasticStep<Real> now =
          contact::elastic_step<V, closed>(law, p.w, p.shear.e, h);
      add(p, now.sigma, law.ks * p.shear.e1, law.ks * p.shear.e2, sum);
      is_elastic = is_elastic & now.is_elastic;
      open = open | now.open;
    }
    if (!all(is_elastic)) return false;
    if constexpr (!closed) access.store_flag(t.law_path, j, any(open) ? kOpen : kClosed);
    return true;
  }
  // The full law: history of joints advances here alone (of zones in zones.cpp).
  WYTHE_OUTLINE contact::FaceLoad<Real> advance(std::ptrdiff_t j,
                                                const contact::LawConstants<Real>& law, Real area,
                                                const contact::FaceGap<Real>& gap,
                                                Work& work) const {
    const Real zero(0.0), one(1.0);
    const Vector<Real> none{zero, zero, zero};
    contact::FaceLoad<Real> sum{none, none, none};
    bool_of_t<Real> moved = zero > zero, open = zero > zero;
    bool is_undamaged = contact::has_undamaged_path<V>(law), knows_then = false;
    contact::FaceGap<Real> then{none, none, none};
    for (int k = 0; k < chunk.points; ++k) {
      const std::ptrdiff_t row = first(j, k, history_size() + 1);
      Real plastic_1, plastic_2;
      const History before = load(row, plastic_1, plastic_2);
      History now = before;
      const Asked p = asked(first(j, k, kPointRows), area, gap, plastic_1, plastic_2);
      const contact::LawUpdate<Real> a = contact::update<V>(law, p.w, p.shear.e, now);
      const Real slid = now.plastic_slip *
                        (one / maximum(p.shear.e, Real(1e-300)));  // share of e that is plastic now
      const Real slid_1 = slid * p.shear.e1, slid_2 = slid * p.shear.e2;
      store(row, now, plastic_1 + slid_1, plastic_2 + slid_2);
      add(p, a.sigma, law.ks * (p.shear.e1 - slid_1), law.ks * (p.shear.e2 - slid_2), sum);
      Real friction = a.friction;
      if (any(magnitude(a.slipped) > zero)) {
        if (!knows_then) then = gap_before(j);
        knows_then = true;
        const Asked q = asked(first(j, k, kPointRows), area, then, plastic_1, plastic_2);
        friction =
            contact::friction_taken<V>(law, a, before, q.w, contact::along(p.shear, q.shear));
      }
      work = {work.friction + friction * p.share, work.fracture + a.fracture * p.share,
              work.crushing + a.crushing * p.share};
      moved = moved | contact::history_changed(before, now);
      open = open | (p.w + now.crush > zero);
      const bool_of_t<Real> is_past_1 = magnitude(plastic_1) > zero,
                            is_past_2 = magnitude(plastic_2) > zero,
                            had_slid = is_past_1 | is_past_2;
      is_undamaged = is_undamaged && !any(had_slid) && all(contact::is_undamaged<V>(law, now));
    }
    access.store_flag(t.law_path, j,
                      is_undamaged ? kUndamaged
                      : any(moved) ? kFullLaw
                      : any(open)  ? kOpen
                                   : kClosed);
    return sum;
  }
};

}  // namespace wythe::dynamics::space
