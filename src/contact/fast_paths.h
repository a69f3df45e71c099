// Fast paths through the law (law.h) for two kinds of points: an undamaged point, where only the largest opening may
// grow, and an elastic step, in which no history changes. Each gives the bits of update(), or reports that it does not
// apply (docs/theory/joint_law.md, 3.12a, 3.12b; tests/unit/contact/fast_paths_test.cpp).
#pragma once

#include "contact/law.h"

namespace wythe::contact {

// An undamaged point has not crushed or slid, and has not opened beyond its tensile
// strength. Until then it is elastic in compression and tension (joint_law.md, 3.12b). With stiffness damage
// or a cap no point counts as undamaged.
template <class V, class C>
[[nodiscard]] WYTHE_INLINE constexpr bool has_undamaged_path(const LawConstants<C>& m) {
  return choice_of<V>(m).coupling != Coupling::kStiffness && !choice_of<V>(m).cap;
}
// Largest opening of an undamaged point; below ft/kn by more than round-off. A dry joint is never undamaged (onset < 0).
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

// Stresses of an undamaged point. If it `stays` undamaged, update() gives the same bits and changes only kappa, to w.
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

// A step in which no history changes. The point does not crush further, open wider than before or slide,
// and its shear damage does not grow under the present pressure. If the step `is_elastic`, update() gives the same bits.
// Otherwise, and for NaN, update() must be called.
template <class Real>
struct ElasticStep {
  Real sigma, tau;  // [Pa]
  bool_of_t<Real> is_elastic, open;
};

// `closed`: the caller expects no open point, which saves most of the work; an open point then counts as not elastic.
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

// Whether update() changed the history of a point. If so, the next step may change it again.
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
