// Short ways through the law (law.h) where it would keep a point's history or only widen its opening: a point
// to which nothing has happened, a point at rest. Each gives the bits of update() or says that it does not
// hold (docs/theory/joint_law.md, 3.12a, 3.12b; tests/unit/contact/fast_paths_test.cpp).
#pragma once

#include "contact/law.h"

namespace wythe::contact {

// A point to which nothing has happened: not crushed, not slid, and opened no wider than its tensile strength
// bears. It is elastic, pressed or drawn, as long as it stays so (joint_law.md, 3.12b). With stiffness damage
// or a cap no point is taken for one.
template <class V, class C>
[[nodiscard]] WYTHE_INLINE constexpr bool has_undamaged_path(const LawConstants<C>& m) {
  return choice_of<V>(m).coupling != Coupling::kStiffness && !choice_of<V>(m).cap;
}
// How far it may open; below ft/kn by more than rounding can hide. A dry joint is never whole (onset < 0).
template <class C>
[[nodiscard]] WYTHE_INLINE C undamaged_opening(const LawConstants<C>& m) {
  return minimum(m.w0, m.tension_onset) * C(1 - 1e-9);
}
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE bool_of_t<Real> is_undamaged(const LawConstants<C>& m,
                                                        const History<Real>& h) {
  const Real zero(0.0);
  bool_of_t<Real> undamaged = h.kappa <= Real(undamaged_opening(m));
  undamaged = undamaged & (h.crush <= zero) & (h.slip <= zero) & (h.shear_damage <= zero);
  undamaged = undamaged & (magnitude(h.plastic_slip) <= zero);
  if (choice_of<V>(m).unloading == Unloading::kElastic)
    undamaged = undamaged & (h.tension_set <= zero);
  return undamaged;
}

// Stresses of a whole point. Where it `stays` whole update() gives the same, bit for bit, and of the history
// only kappa grows, to w.
template <class Real>
struct UndamagedStress {
  Real sigma, tau;  // [Pa]
  bool_of_t<Real> stays;
};
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE UndamagedStress<Real> undamaged_point(const LawConstants<C>& m, Real w,
                                                                 Real s) {
  const Real sigma = m.kn * w, tau = m.ks * s, sn = Real(0.0) - sigma;
  const Real strength = (m.c_res + sn * m.tan_res) + (m.c_drop + sn * m.tan_drop);
  bool_of_t<Real> stays = w <= Real(undamaged_opening(m));
  stays = stays & (magnitude(tau) <= strength);
  stays = stays & (sigma + m.fc >= Real(0.0));
  return {sigma, tau, stays};
}

// A point that keeps its history: it crushes no further, opens no wider than before, does not slide, and
// its shear damage does not grow under the present pressure. Where it `rests`, update() gives the same
// stresses and history, bit for bit; elsewhere, and where something is not a number, it has to be asked.
template <class Real>
struct ElasticStep {
  Real sigma, tau;  // [Pa]
  bool_of_t<Real> is_elastic, open;
};

// `closed`: the caller expects no point to be open, which spares most of the work; one that is does not
// rest.
template <class V, bool closed, class C, class Real>
[[nodiscard]] WYTHE_INLINE ElasticStep<Real> elastic_step(const LawConstants<C>& m, Real w, Real s,
                                                          const History<Real>& h) {
  const Real zero(0.0), one(1.0);
  const Real we = w + h.crush, pressed = m.kn * we;
  const bool_of_t<Real> is_open = we > zero;
  const Real tau = m.ks * (s - h.plastic_slip);
  bool_of_t<Real> is_elastic = zero <= zero;
  if (choice_of<V>(m).cap) {
    const Real strength = crush_strength(m, h.crush_path).left;
    is_elastic = beyond_cap(m, minimum(pressed, zero), tau, strength) <= zero;
  } else {
    is_elastic = pressed + m.fc * maximum(zero, one - h.crush * m.inv_p_full) >= zero;
  }
  const Real left = tension_left<V>(m, h.kappa);
  Real sigma = minimum(pressed, zero);
  if constexpr (closed) {
    is_elastic = is_elastic & (we <= zero);
  } else {
    const Real open = maximum(we, zero);
    is_elastic = is_elastic & (open <= h.kappa);
    const Real strength = m.ft * strength_left<V>(m, left, one - h.shear_damage);
    const Real inv_kappa = one / maximum(h.kappa, Real(1e-30));
    sigma = sigma + tensile_stress<V>(m, open, strength, inv_kappa, h.tension_set);
    if (choice_of<V>(m).unloading == Unloading::kElastic)
      is_elastic = is_elastic & (open - strength * m.inv_kn <= h.tension_set);
  }
  Yield<Real> yield = yield_of<V>(m, sigma, left, h.kappa);
  if constexpr (!closed) yield.residual = select(is_open & (left <= zero), zero, yield.residual);
  is_elastic = is_elastic & (damage_of_slip<V>(m, yield, h.slip) <= h.shear_damage);
  is_elastic = is_elastic & (magnitude(tau) <= stress_at<V>(m, yield, h.shear_damage));
  return {sigma, tau, is_elastic, is_open};
}

// Whether update() took a point from `before` to `now` by changing its history: it may go on doing so.
template <class Real>
[[nodiscard]] WYTHE_INLINE bool_of_t<Real> history_changed(const History<Real>& before,
                                                           const History<Real>& now) {
  bool_of_t<Real> moved = now.kappa > before.kappa;
  moved = moved | (now.crush > before.crush);
  moved = moved | (now.plastic_slip > before.plastic_slip);
  moved = moved | (now.plastic_slip < before.plastic_slip);
  return moved | (now.shear_damage > before.shear_damage);
}

}  // namespace wythe::contact
