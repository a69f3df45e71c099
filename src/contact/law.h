// The joint law at one contact point: stresses and history from opening w and relative slip s.
//
// Called by dynamics/passes/joints.h for every point of every step and by drive_contact() for one point.
// One source for every scalar type (double, Dual, SIMD pack), branch-free through select().
// Equations: docs/theory/joint_law.md; parameters after Pulatsu et al. (the D-RBA paper), Lourenco &
// Rots 1997. Signs: opening and tension +, compression sn = -sigma +.
//
//   crushing   w_e = w + p,  p >= 0 grows where kn w_e < -fc(p)          area Gc
//   tension    y = 1 - d_t = g(ft/GI (kappa - y w0)),  w0 = ft/kn         area GI, elastic part included
//   shear      T = R + B (1 - d_s),  d_s = 1 - g(s (t0 - tr)/GII)          work above the residual GII,
//              which is a + b sn where it grows with pressure (LawChoice::rising)
//   coupling   1 - d = (1 - d_t)(1 - d_s)  or  min(1 - d_t, 1 - d_s); with stiffness damage shear sees
//              1 - secant/kn in place of d_t
//   normal     w_e > 0: secant through (kappa, (1 - d) ft) or elastic to w_t;  w_e <= 0: kn w_e
//
// With a cap (LawChoice::cap), crushing is driven by normal and shear stress together:
//
//   cap        sigma^2 + Css tau^2 <= F(q)^2 in compression; both stresses make q grow, F falls with q
//   dilatancy  slip under pressure lifts the joint: p falls by tan psi ds
//
// The return in shear is implicit in d_s, the crushing return in p. So on a straight piece of path at
// constant normal stress, the work does not depend on the number of steps.
#pragma once

#include "contact/law_constants.h"
#include "contact/softening.h"

namespace wythe::contact {

// Stresses, damage and works of one step.
template <class Real>
struct LawUpdate {
  Real sigma, tau;                    // [Pa]
  Real tension_damage, damage;        // d_t, d [-]
  Real friction, fracture, crushing;  // dissipated in this step [N/m]
  // Part of `friction` from sliding, at the pressure at the end of this step: signed plastic slip [m] and its work
  // [N/m]; includes dilatancy, which returns work.
  Real slipped, slip_work;
  Real lifted, lift_work;
};

// Crushing return: updates p and returns the work of crushing [N/m].
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real crush_return(const LawConstants<C>& m, Real w, Real& p) {
  const Real zero(0.0);
  const Real before = m.fc * maximum(zero, Real(1.0) - p * m.inv_p_full);
  const Real excess = zero - m.kn * (w + p) - before;
  if (!any(excess > zero)) return zero;
  const Real softened = p + maximum(zero, excess) * m.crush_gain;
  const Real spent = maximum(p, zero - w);  // fully crushed: no stress left
  const Real p1 = select(softened > m.p_full, spent, softened);
  const Real after = m.fc * maximum(zero, Real(1.0) - p1 * m.inv_p_full);
  const Real length = minimum(p1, m.p_full) - minimum(p, m.p_full);
  p = p1;
  return Real(0.5) * (before + after) * length;
}

// Remaining share of tensile strength, y = 1 - d_t, at the largest opening kappa.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real tension_left(const LawConstants<C>& m, Real kappa) {
  if (choice_of<V>(m).softening == Softening::kBilinear) {
    return Real(1.0) - clip((kappa - m.tension_onset) * m.tension_rate, Real(0.0), Real(1.0));
  } else {
    // y - g(a (kappa - y w0)) is concave and rising in y, so Newton from y = 1 converges monotonically after one step.
    const Real zero(0.0), one(1.0);
    Real y = one;
    for (int k = 0; k < 6; ++k) {
      const Shape<Real> g =
          soften(choice_of<V>(m).softening, maximum(zero, m.ft_over_GI * (kappa - y * m.w0)));
      const Real rise = one + g.slope * m.ft_over_GI * m.w0;
      y = clip(y - (y - g.left) / rise, zero, one);
    }
    // A dry joint (onset < 0) has no strength from the start.
    return select(m.tension_onset < zero, zero, select(kappa <= m.w0, one, y));
  }
}

// 1 - d from 1 - d_t and 1 - d_s.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real strength_left(const LawConstants<C>& m, Real tension, Real shear) {
  if (choice_of<V>(m).coupling == Coupling::kUnion) return tension * shear;
  return minimum(tension, shear);
}

// Yield stress in shear as a function of ds: T = max(0, R + B (1 - max(ds, floor))).
template <class Real>
struct Yield {
  Real residual;   // R [Pa]
  Real drop;       // B [Pa]
  Real floor;      // damage below which ds does not act (coupling by maximum)
  Real slip_rate;  // (t0 - tr)/(2 GII) = 1/su at the present pressure [1/m]
};

template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Yield<Real> yield_of(const LawConstants<C>& m, Real sigma, Real left,
                                                Real kappa) {
  const Real zero(0.0), one(1.0);
  const Real sn = zero - sigma;
  Yield<Real> yield;
  yield.residual = m.c_res + sn * m.tan_res;
  yield.drop = m.c_drop + sn * m.tan_drop;
  yield.floor = zero;
  const Real pressure = maximum(sn, zero);
  const Real peak_drop = m.c_drop + pressure * m.tan_drop;  // t0 - tr
  yield.slip_rate = maximum(peak_drop, zero) * m.half_inv_GII;
  if (m.choice.rising)  // GII = a (1 + sn b/a)
    yield.slip_rate = yield.slip_rate / (one + pressure * (m.twice_b * m.half_inv_GII));
  const Coupling coupling = choice_of<V>(m).coupling;
  if (coupling == Coupling::kUnion) {
    yield.drop = yield.drop * left;
  } else if (coupling == Coupling::kMaximum) {
    yield.floor = one - left;
  } else {
    const Real secant = minimum(m.kn, m.ft * left / maximum(kappa, Real(1e-30)));
    yield.floor = one - secant * m.inv_kn;
  }
  return yield;
}

// d_s after the accumulated slip s.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real damage_of_slip(const LawConstants<C>& m, const Yield<Real>& yield,
                                               Real s) {
  const Real x = Real(2.0) * s * yield.slip_rate;
  return Real(1.0) - soften(choice_of<V>(m).softening, x).left;
}

template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real stress_at(const LawConstants<C>& m, const Yield<Real>& yield,
                                          Real ds) {
  Real held = ds;
  if (choice_of<V>(m).coupling != Coupling::kUnion) held = maximum(ds, yield.floor);
  return maximum(Real(0.0), yield.residual + yield.drop * (Real(1.0) - held));
}

// Plastic slip of this step: |tau_trial| - ks D = T(s + D), where T falls with D; D >= 0.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real plastic_increment(const LawConstants<C>& m,
                                                  const Yield<Real>& yield, Real trial, Real s,
                                                  Real ds) {
  const Real zero(0.0), one(1.0);
  const Real held = maximum(ds, yield.floor);  // T is constant until ds exceeds this
  const Real flat = (trial - yield.residual - yield.drop * (one - held)) * m.inv_ks;
  Real increment = flat;
  const Softening softening = choice_of<V>(m).softening;
  if (softening == Softening::kBilinear) {
    const Real rate = yield.slip_rate;
    const Real falling =
        (trial - yield.residual - yield.drop * (one - s * rate)) / (m.ks - yield.drop * rate);
    const Real spent = (trial - yield.residual) * m.inv_ks;
    const Real beyond = select((s + falling) * rate < one, falling, spent);
    increment = select((s + flat) * rate <= held, flat, beyond);
  } else {
    for (int k = 0; k < 6; ++k) {
      const Real x = Real(2.0) * (s + increment) * yield.slip_rate;
      const Shape<Real> g = soften(softening, x);
      const auto acts = one - g.left > held;
      const Real left = select(acts, g.left, one - held);
      const Real fall = select(acts, yield.drop * g.slope * Real(2.0) * yield.slip_rate, zero);
      const Real miss = trial - m.ks * increment - yield.residual - yield.drop * left;
      increment = maximum(zero, increment + miss / (m.ks + fall));
    }
  }
  return maximum(zero, minimum(increment, trial * m.inv_ks));
}

// --- the cap -----------------------------------------------------------------------------------------

// Strength F in crushing after the path q, and dF/dq: a parabola up to kappa_p, then a line down to 0.
template <class Real>
struct CrushStrength {
  Real left;   // F [Pa]
  Real slope;  // [Pa/m]
};
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE CrushStrength<Real> crush_strength(const LawConstants<C>& m, Real q) {
  const Real zero(0.0), one(1.0);
  const Real rest = maximum(zero, one - q * m.inv_harden), beyond = maximum(zero, q - m.harden);
  const Real share = one - m.harden_drop * rest * rest - beyond * m.crush_rate;
  const Real falls = select(beyond > zero, Real(m.crush_rate), zero);
  return {m.fc * select(q < Real(m.p_full), share, zero),
          m.fc * (Real(2.0) * m.harden_drop * rest * m.inv_harden - falls)};
}

// Work of crushing on the path from 0 to q [N/m].
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real crush_work(const LawConstants<C>& m, Real q) {
  const Real zero(0.0), one(1.0);
  const Real rest = maximum(zero, one - q * m.inv_harden), beyond = maximum(zero, q - m.harden);
  const Real missing = m.harden_drop * m.harden * Real(1.0 / 3.0) * (one - rest * rest * rest);
  return m.fc * (q - missing - Real(0.5) * beyond * beyond * m.crush_rate);
}

// Permanently lost share of the crushing strength [-].
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real crushed_share(const LawConstants<C>& m, const History<Real>& h) {
  if (!m.choice.cap) return minimum(Real(1.0), h.crush * m.inv_p_full);
  return clip((h.crush_path - m.harden) * m.crush_rate, Real(0.0), Real(1.0));
}

// Positive outside the cap: sigma^2 + Css tau^2 - F^2, for a compressed point.
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real beyond_cap(const LawConstants<C>& m, Real pressed, Real tau,
                                           Real strength) {
  const Real sheared = m.root_css * tau;
  return pressed * pressed + sheared * sheared - strength * strength;
}

// Increment d of the path that returns the trial stresses (a, b), b = sqrt(Css) tau, to the cap:
//
//   (a/x)^2 + (b/y)^2 = 1,   x = F(q + d) + kn d,   y = F(q + d) + Css ks d        (joint_law.md, 3.22)
//
// 1/sqrt of the left side rises with d and is concave; it is a straight line where a or b is 0. So Newton from
// d = 0 is exact there after one step, and approaches from below elsewhere.
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real cap_path(const LawConstants<C>& m, Real a, Real b, Real q) {
  const Real zero(0.0), one(1.0);
  Real d = zero;
  for (int k = 0; k < 4; ++k) {
    const CrushStrength<Real> strength = crush_strength(m, q + d);
    const Real x = strength.left + d * m.kn, y = strength.left + d * m.css_ks;
    const Real inv_x = one / maximum(x, Real(1e-30)), inv_y = one / maximum(y, Real(1e-30));
    const Real u = a * inv_x, v = b * inv_y, square = u * u + v * v;
    const Real fall =
        u * u * (strength.slope + m.kn) * inv_x + v * v * (strength.slope + m.css_ks) * inv_y;
    // without stress this is NaN: maximum() returns its second argument then
    d = maximum(d + square * (square_root(square) - one) / fall, zero);
  }
  return d;
}

// Effect of the cap in a step.
template <class Real>
struct Capped {
  bool_of_t<Real> outside;  // where it acted; elsewhere nothing has changed
  Real limit;               // largest shear stress at the present pressure [Pa]
  Real work;                // [N/m]
};

// Return to the cap from the trial stresses. Friction limits the shear stress first, so that sliding does
// not cause crushing.
template <class V, class C, class Real>
WYTHE_OUTLINE void return_to_cap(const LawConstants<C>& m, Real w, Real pressed, Real tau,
                                 Real before, History<Real>& h, Capped<Real>& capped) {
  const Real zero(0.0);
  const Yield<Real> yield = yield_of<V>(m, pressed, tension_left<V>(m, h.kappa), h.kappa);
  const Real shear = minimum(magnitude(tau), stress_at<V>(m, yield, h.shear_damage));
  capped.outside = capped.outside & (beyond_cap(m, pressed, shear, before) > zero);
  const Real left = maximum(zero, m.p_full - h.crush_path);
  const Real path = cap_path(m, zero - pressed, m.root_css * shear, h.crush_path);
  const Real d = minimum(left, select(capped.outside, path, zero));
  const Real q = select(capped.outside & (d >= left), Real(m.p_full), h.crush_path + d);
  const Real after = crush_strength(m, q).left;
  const auto spent = after <= zero;
  const Real sigma = select(spent, zero, pressed * (after / (after + d * m.kn)));
  const Real lost = select(m.css_ks > zero, shear, zero);
  const Real held = select(spent, shear - lost, shear * (after / (after + d * m.css_ks)));
  const Real p = maximum(h.crush, sigma * m.inv_kn - w);
  h.crush = select(capped.outside & (pressed < zero), p, h.crush);
  h.plastic_slip = select(capped.outside, h.plastic_slip + sign(tau) * (shear - held) * m.inv_ks,
                          h.plastic_slip);
  capped.work = crush_work(m, q) - crush_work(m, h.crush_path);
  h.crush_path = q;
  const Real room = square_root(maximum(zero, after * after - sigma * sigma));
  capped.limit =
      select(m.css_ks > zero, room / maximum(Real(m.root_css), Real(1e-30)), Real(1e300));
}

template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Capped<Real> cap_return(const LawConstants<C>& m, Real w, Real s,
                                                   History<Real>& h) {
  const Real zero(0.0);
  const Real pressed = minimum(m.kn * (w + h.crush), zero), tau = m.ks * (s - h.plastic_slip);
  const Real before = crush_strength(m, h.crush_path).left;
  Capped<Real> capped{beyond_cap(m, pressed, tau, before) > zero, zero, zero};
  if (any(capped.outside)) return_to_cap<V>(m, w, pressed, tau, before, h, capped);
  return capped;
}

// Work of the remaining shear stress above the cap: the point slides.
template <class C, class Real>
WYTHE_INLINE void slide_under_cap(const LawConstants<C>& m, const Capped<Real>& capped,
                                  History<Real>& h, LawUpdate<Real>& answer) {
  const Real zero(0.0), tau = answer.tau;
  const Real excess = magnitude(tau) - capped.limit;
  const auto slides = capped.outside & (excess > zero);
  if (!any(slides)) return;
  const Real slip = select(slides, excess * m.inv_ks, zero);
  const Real work = Real(0.5) * (magnitude(tau) + capped.limit) * slip;
  answer.friction = answer.friction + work;
  answer.slip_work = answer.slip_work + work;
  answer.slipped = answer.slipped + sign(tau) * slip;
  h.slip = h.slip + slip;
  h.plastic_slip = h.plastic_slip + sign(tau) * slip;
  answer.tau = select(slides, sign(tau) * capped.limit, tau);
}

// Dilatancy: slip from `before` to h.slip lifts a closed joint against the pressure.
template <class C, class Real>
WYTHE_INLINE void lift(const LawConstants<C>& m, Real sigma, Real before, History<Real>& h,
                       LawUpdate<Real>& answer) {
  const Real zero(0.0), one(1.0), half(0.5);
  const Real sn = zero - sigma;
  const Real fade = half * (maximum(zero, one - before * m.inv_lift_slip) +
                            maximum(zero, one - h.slip * m.inv_lift_slip));
  const Real rise =
      m.tan_lift * fade * maximum(zero, one - sn * m.inv_lift_stress) * (h.slip - before);
  const Real lifted = select(sn > zero, rise, zero);
  h.crush = h.crush - lifted;
  answer.lifted = lifted;
  answer.lift_work = sn * lifted;
  answer.friction = answer.friction - answer.lift_work;
}

// --- one step ----------------------------------------------------------------------------------------

// Energy released by the normal stress when kappa or d grew: the area between the old and the new
// secant, exact for straight branches [N/m].
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real secant_release(const LawConstants<C>& m, Real open, Real kappa0,
                                               Real kappa1, Real strength0, Real strength1,
                                               Real inv_kappa1) {
  const Real start = maximum(kappa0, minimum(kappa1, strength0 * m.inv_kn));
  const Real s0 = minimum(strength0, m.kn * start);
  const Real s1 = minimum(strength1, m.kn * kappa1);
  const Real grown = s0 * kappa1 - s1 * start;
  const Real faded = (s0 - s1) * open * open * inv_kappa1;
  return Real(0.5) * maximum(Real(0.0), select(open > kappa0, grown, faded));
}

// Shear in one step: elastic trial, implicit return, damage. `felt` is the normal stress with previous
// damage. Sets tau and adds the work of the plastic slip to the result.
template <class V, class C, class Real>
WYTHE_INLINE void shear_step(const LawConstants<C>& m, const Yield<Real>& yield, Real s,
                             History<Real>& h, LawUpdate<Real>& answer) {
  const Real zero(0.0);
  h.shear_damage = maximum(h.shear_damage, damage_of_slip<V>(m, yield, h.slip));
  const Real trial_tau = m.ks * (s - h.plastic_slip);
  answer.tau = trial_tau;
  const Real trial = magnitude(trial_tau);
  const Real start = stress_at<V>(m, yield, h.shear_damage);
  answer.friction = answer.fracture = zero;
  answer.slipped = answer.slip_work = answer.lifted = answer.lift_work = zero;
  const auto slides = trial > start;
  if (!any(slides)) return;
  const Real increment =
      select(slides, plastic_increment<V>(m, yield, trial, h.slip, h.shear_damage), zero);
  h.slip = h.slip + increment;
  h.plastic_slip = h.plastic_slip + sign(answer.tau) * increment;
  h.shear_damage = maximum(h.shear_damage, damage_of_slip<V>(m, yield, h.slip));
  answer.tau = m.ks * (s - h.plastic_slip);
  // work of the plastic slip: friction is the part of the residual stress, fracture the rest
  const Real worked = Real(0.5) * (start + magnitude(answer.tau)) * increment;
  answer.friction = minimum(worked, maximum(zero, yield.residual) * increment);
  answer.fracture = worked - answer.friction;
  answer.slipped = sign(trial_tau) * increment;
  answer.slip_work = worked;
}

// Tensile stress of an open point, with the tensile `strength` before any shear damage of this step.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real tensile_stress(const LawConstants<C>& m, Real open, Real strength,
                                               Real inv_kappa, Real tension_set) {
  if (choice_of<V>(m).unloading == Unloading::kElastic)
    return clip(m.kn * (open - tension_set), Real(0.0), strength);
  return open * minimum(m.kn, strength * inv_kappa);
}

// One step of the law, from total opening w and relative slip s [m]; advances the history `h`.
// Work for open, sliding or crushing points is skipped where no lane needs it.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE LawUpdate<Real> update(const LawConstants<C>& m, Real w, Real s,
                                                  History<Real>& h) {
  const Real zero(0.0), one(1.0);
  LawUpdate<Real> answer;

  // Crushing, then effective opening and remaining tensile strength.
  const bool cap = choice_of<V>(m).cap;
  Capped<Real> capped{zero > zero, zero, zero};
  if (cap) {
    capped = cap_return<V>(m, w, s, h);
    answer.crushing = capped.work;
  } else {
    answer.crushing = crush_return(m, w, h.crush);
  }
  const Real we = w + h.crush;
  const Real open = maximum(we, zero);
  const Real kappa0 = h.kappa;
  h.kappa = maximum(kappa0, open);
  const Real left = tension_left<V>(m, h.kappa);
  Real compression = m.kn * minimum(we, zero);
  const auto is_open = we > zero;
  const bool opens = any(is_open);

  // Normal stress with previous shear damage, which determines the shear strength.
  const Real shear_left0 = one - h.shear_damage;
  Real felt = compression, inv_kappa = zero;
  if (opens) {
    inv_kappa = one / maximum(h.kappa, Real(1e-30));
    const Real strength = m.ft * strength_left<V>(m, left, shear_left0);
    felt = felt + tensile_stress<V>(m, open, strength, inv_kappa, h.tension_set);
  }

  Yield<Real> yield = yield_of<V>(m, felt, left, h.kappa);
  if (opens) yield.residual = select(is_open & (left <= zero), zero, yield.residual);
  const Real slip_before = h.slip;
  shear_step<V>(m, yield, s, h, answer);
  if (cap) {
    slide_under_cap(m, capped, h, answer);
    lift(m, compression, slip_before, h, answer);
    compression = m.kn * minimum(w + h.crush, zero);
  }

  // Normal stress with the damage of this step, and the energy it released.
  const Real all_left = strength_left<V>(m, left, one - h.shear_damage);
  answer.sigma = compression;
  if (opens) {
    const Real strength0 = m.ft * strength_left<V>(m, tension_left<V>(m, kappa0), shear_left0);
    const Real strength1 = m.ft * all_left;
    if (choice_of<V>(m).unloading == Unloading::kElastic) {
      const Real set = maximum(h.tension_set, open - strength1 * m.inv_kn);
      answer.fracture =
          answer.fracture + Real(0.5) * (strength0 + strength1) * (set - h.tension_set);
      h.tension_set = set;
    } else {
      answer.fracture = answer.fracture +
                        secant_release(m, open, kappa0, h.kappa, strength0, strength1, inv_kappa);
    }
    answer.sigma = answer.sigma + tensile_stress<V>(m, open, strength1, inv_kappa, h.tension_set);
  }
  answer.tension_damage = one - left;
  answer.damage = one - all_left;
  return answer;
}

// Friction work of a step in an undamped motion, from the results of update() [N/m]. update() knows the end of the step
// and takes its pressure for the whole step. Forces act at whole steps and velocities at half steps, so the work of
// a joint in a step is exactly (f + f_before)/2 . Delta u (docs/theory/integration.md, 4.15). `w_before` and
// `s_before` are opening and slip of the previous step, `before` its history. Without them the work is of first order in
// the time step where pressure and slip change together. The previous stress is limited to the first yield under its own
// pressure: a state that was set by hand has no previous step, and this bounds it.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real friction_taken(const LawConstants<C>& m,
                                               const LawUpdate<Real>& answer,
                                               const History<Real>& before, Real w_before,
                                               Real s_before) {
  const Real zero(0.0), half(0.5);
  const Real pressed_before = maximum(zero, zero - m.kn * (w_before + before.crush));
  const Real most = m.c_res + m.c_drop + (m.tan_res + m.tan_drop) * pressed_before;
  const Real reached = m.ks * (s_before - before.plastic_slip);
  const Real tau_before = sign(reached) * minimum(magnitude(reached), most);
  Real friction =
      answer.friction + (half * (answer.tau + tau_before) * answer.slipped - answer.slip_work);
  if (choice_of<V>(m).cap) {
    const Real pressed = maximum(zero, zero - answer.sigma) + pressed_before;
    friction = friction - (half * pressed * answer.lifted - answer.lift_work);
  }
  return friction;
}

}  // namespace wythe::contact
