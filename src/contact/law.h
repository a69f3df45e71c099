// The joint law at one contact point: stresses and history from opening w and relative slip s.
//
// Called by dynamics/passes/joints.h for every point of every step and by drive_contact() for one point.
// One source for every scalar type (double, Dual, SIMD pack), branch-free through select().
// Equations: docs/theory/joint_law.md; parameters after Pulatsu et al. (the D-RBA paper), Lourenco &
// Rots 1997. Signs: opening and tension +, compression sn = -sigma +.
//
//   crushing   w_e = w + p,  p >= 0 grows where kn w_e < -fc(p)          area Gc
//   tension    y = 1 - d_t = g(ft/GI (kappa - y w0)),  w0 = ft/kn         area GI, elastic part included
//   shear      T = R + B (1 - d_s),  d_s = 1 - g(s (t0 - tr)/GII)          work above the residual GII
//   coupling   1 - d = (1 - d_t)(1 - d_s)  or  min(1 - d_t, 1 - d_s); with stiffness damage shear sees
//              1 - secant/kn in place of d_t
//   normal     w_e > 0: secant through (kappa, (1 - d) ft) or elastic to w_t;  w_e <= 0: kn w_e
//
// The return in shear is implicit in d_s and the crushing return in p: on a straight piece of path at
// constant normal stress the work done does not depend on how it is cut into steps. Zero dilation.
#pragma once

#include <array>
#include <type_traits>

#include "contact/softening.h"
#include "core/real.h"
#include "wythe/contact_law.h"

namespace wythe::contact {

// Which law a material follows.
struct LawChoice {
  Softening softening = Softening::kBilinear;
  Coupling coupling = Coupling::kUnion;
  Unloading unloading = Unloading::kSecant;
  bool operator==(const LawChoice&) const = default;
};

// How a function of the law learns of the choice: a Variant states it when the program is compiled, so
// that nothing is asked at run time; AnyVariant reads it from the constants, the same in all lanes. Two
// are compiled, the paper's and any (with_variant, parameters.h): each costs seconds of compile time.
template <Softening softening_, Coupling coupling_, Unloading unloading_>
struct Variant {
  static constexpr LawChoice known{softening_, coupling_, unloading_};
};
using PaperVariant = Variant<Softening::kBilinear, Coupling::kUnion, Unloading::kSecant>;
struct AnyVariant {};

template <class V, class Constants>
[[nodiscard]] WYTHE_INLINE constexpr LawChoice choice_of(const Constants& m) {
  if constexpr (std::is_same_v<V, AnyVariant>)
    return m.choice;
  else
    return V::known;
}

// Parameters of one material with every division done beforehand (constants_of, parameters.cpp).
template <class Real>
struct LawConstants {
  Real kn, ks, inv_ks, inv_kn;       // [Pa/m], [m/Pa]
  Real ft, w0, ft_over_GI;           // [Pa], [m], [1/m]
  Real tension_onset, tension_rate;  // bilinear d_t = clip((kappa - onset) rate, 0, 1)
  Real c_res, c_drop;                // c_res, c - c_res [Pa]
  Real tan_res, tan_drop;            // tan phi_res, tan phi0 - tan phi_res
  Real half_inv_GII;                 // 1/(2 GII) [m/N]
  Real fc, p_full, inv_p_full;       // [Pa], 2 Gc/fc [m], [1/m]
  Real crush_gain;                   // 1/(kn - fc/p_full) [m/Pa]
  LawChoice choice;
};
// Its numbers, in order: how they are copied, and laid out for walls side by side.
template <class Real, class C = LawConstants<Real>>
inline constexpr std::array kConstants{
    &C::kn,     &C::ks,         &C::inv_ks,        &C::inv_kn,       &C::ft,
    &C::w0,     &C::ft_over_GI, &C::tension_onset, &C::tension_rate, &C::c_res,
    &C::c_drop, &C::tan_res,    &C::tan_drop,      &C::half_inv_GII, &C::fc,
    &C::p_full, &C::inv_p_full, &C::crush_gain};

// Committed history of a point; the only memory of the law.
template <class Real>
struct History {
  Real kappa;         // largest opening w_e reached [m]
  Real crush;         // crushing shortening p = -w_p [m]
  Real plastic_slip;  // signed [m]
  Real slip;          // accumulated |plastic slip| [m]
  Real shear_damage;  // d_s [-]
  Real tension_set;   // w_t [m] (elastic unloading)
};
// Its numbers, in the order of the table of fields (model/fields.h).
template <class Real, class H = History<Real>>
inline constexpr std::array kHistory{&H::kappa, &H::crush,        &H::plastic_slip,
                                     &H::slip,  &H::shear_damage, &H::tension_set};
// How many of them, from the first, a law of this choice asks for: no others are kept in memory.
[[nodiscard]] WYTHE_INLINE constexpr int remembered(const LawChoice& choice) {
  constexpr int all = static_cast<int>(kHistory<double>.size());
  static_assert(kHistory<double>.back() == &History<double>::tension_set);
  return choice.unloading == Unloading::kElastic ? all : all - 1;
}

template <class Real>
struct Answer {
  Real sigma, tau;                    // [Pa]
  Real tension_damage, damage;        // d_t, d [-]
  Real friction, fracture, crushing;  // dissipated in this step [N/m]
};

// Crushing return: updates p and gives the work done in crushing [N/m].
template <class C, class Real>
[[nodiscard]] WYTHE_INLINE Real crush_return(const LawConstants<C>& m, Real w, Real& p) {
  const Real zero(0.0);
  const Real before = m.fc * maximum(zero, Real(1.0) - p * m.inv_p_full);
  const Real excess = zero - m.kn * (w + p) - before;
  if (!any(excess > zero)) return zero;
  const Real softened = p + maximum(zero, excess) * m.crush_gain;
  const Real spent = maximum(p, zero - w);  // fully crushed: carries nothing
  const Real p1 = select(softened > m.p_full, spent, softened);
  const Real after = m.fc * maximum(zero, Real(1.0) - p1 * m.inv_p_full);
  const Real length = minimum(p1, m.p_full) - minimum(p, m.p_full);
  p = p1;
  return Real(0.5) * (before + after) * length;
}

// Share of tensile strength left, y = 1 - d_t, at the largest opening kappa.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real tension_left(const LawConstants<C>& m, Real kappa) {
  if (choice_of<V>(m).softening == Softening::kBilinear) {
    return Real(1.0) - clip((kappa - m.tension_onset) * m.tension_rate, Real(0.0), Real(1.0));
  } else {
    // y - g(a (kappa - y w0)) is concave and rising in y: Newton from y = 1 turns monotone at once.
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
  Real slip_rate;  // (t0 - tr)/(2 GII) = 1/su [1/m]
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
  const Real peak_drop = m.c_drop + maximum(sn, zero) * m.tan_drop;  // t0 - tr
  yield.slip_rate = maximum(peak_drop, zero) * m.half_inv_GII;
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

// ds reached after the accumulated slip s.
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

// Plastic slip of this step: |tau_trial| - ks D = T(s + D), T falling with D; D >= 0.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real plastic_increment(const LawConstants<C>& m,
                                                  const Yield<Real>& yield, Real trial, Real s,
                                                  Real ds) {
  const Real zero(0.0), one(1.0);
  const Real held = maximum(ds, yield.floor);  // T is flat until ds passes this
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

// Energy set free by the normal stress when kappa or d grew: the area between the old and the new
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

// Shear of one step: elastic trial, implicit return, damage. `felt` is the normal stress with the
// damage so far. Gives tau and adds the work of the plastic slip to the answer.
template <class V, class C, class Real>
WYTHE_INLINE void shear_step(const LawConstants<C>& m, const Yield<Real>& yield, Real s,
                             History<Real>& h, Answer<Real>& answer) {
  const Real zero(0.0);
  h.shear_damage = maximum(h.shear_damage, damage_of_slip<V>(m, yield, h.slip));
  answer.tau = m.ks * (s - h.plastic_slip);
  const Real trial = magnitude(answer.tau);
  const Real start = stress_at<V>(m, yield, h.shear_damage);
  answer.friction = answer.fracture = zero;
  const auto slides = trial > start;
  if (!any(slides)) return;
  const Real increment =
      select(slides, plastic_increment<V>(m, yield, trial, h.slip, h.shear_damage), zero);
  h.slip = h.slip + increment;
  h.plastic_slip = h.plastic_slip + sign(answer.tau) * increment;
  h.shear_damage = maximum(h.shear_damage, damage_of_slip<V>(m, yield, h.slip));
  answer.tau = m.ks * (s - h.plastic_slip);
  // Work of the plastic slip: friction is the residual's part, fracture the rest.
  const Real worked = Real(0.5) * (start + magnitude(answer.tau)) * increment;
  answer.friction = minimum(worked, maximum(zero, yield.residual) * increment);
  answer.fracture = worked - answer.friction;
}

// Tensile stress of an open point, before (`strength`) any damage of this step in shear.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Real pull(const LawConstants<C>& m, Real open, Real strength,
                                     Real inv_kappa, Real tension_set) {
  if (choice_of<V>(m).unloading == Unloading::kElastic)
    return clip(m.kn * (open - tension_set), Real(0.0), strength);
  return open * minimum(m.kn, strength * inv_kappa);
}

// A point that keeps its history: it crushes no further, opens no wider than before, does not slide, and
// its shear damage does not grow under the present pressure. Where it `rests`, update() gives the same
// stresses and history, bit for bit; elsewhere, and where something is not a number, it has to be asked.
template <class Real>
struct Rest {
  Real sigma, tau;  // [Pa]
  bool_of_t<Real> rests, open;
};

// `closed`: the caller expects no point to be open, which spares most of the work; one that is does not
// rest.
template <class V, bool closed, class C, class Real>
[[nodiscard]] WYTHE_INLINE Rest<Real> at_rest(const LawConstants<C>& m, Real w, Real s,
                                              const History<Real>& h) {
  const Real zero(0.0), one(1.0);
  const Real we = w + h.crush, pressed = m.kn * we;
  const Real crush_strength = m.fc * maximum(zero, one - h.crush * m.inv_p_full);
  const bool_of_t<Real> is_open = we > zero;
  bool_of_t<Real> rests = pressed + crush_strength >= zero;
  const Real left = tension_left<V>(m, h.kappa);
  Real sigma = minimum(pressed, zero);
  if constexpr (closed) {
    rests = rests & (we <= zero);
  } else {
    const Real open = maximum(we, zero);
    rests = rests & (open <= h.kappa);
    const Real strength = m.ft * strength_left<V>(m, left, one - h.shear_damage);
    const Real inv_kappa = one / maximum(h.kappa, Real(1e-30));
    sigma = sigma + pull<V>(m, open, strength, inv_kappa, h.tension_set);
    if (choice_of<V>(m).unloading == Unloading::kElastic)
      rests = rests & (open - strength * m.inv_kn <= h.tension_set);
  }
  Yield<Real> yield = yield_of<V>(m, sigma, left, h.kappa);
  if constexpr (!closed) yield.residual = select(is_open & (left <= zero), zero, yield.residual);
  const Real tau = m.ks * (s - h.plastic_slip);
  rests = rests & (damage_of_slip<V>(m, yield, h.slip) <= h.shear_damage);
  rests = rests & (magnitude(tau) <= stress_at<V>(m, yield, h.shear_damage));
  return {sigma, tau, rests, is_open};
}

// Whether update() took a point from `before` to `now` by changing its history: it may go on doing so.
template <class Real>
[[nodiscard]] WYTHE_INLINE bool_of_t<Real> moves(const History<Real>& before,
                                                 const History<Real>& now) {
  bool_of_t<Real> moved = now.kappa > before.kappa;
  moved = moved | (now.crush > before.crush);
  moved = moved | (now.plastic_slip > before.plastic_slip);
  moved = moved | (now.plastic_slip < before.plastic_slip);
  return moved | (now.shear_damage > before.shear_damage);
}

// One step of the law: from the total opening w and relative slip s [m], with history `h` advanced.
// What happens only to open, sliding or crushing points is skipped where no lane needs it.
template <class V, class C, class Real>
[[nodiscard]] WYTHE_INLINE Answer<Real> update(const LawConstants<C>& m, Real w, Real s,
                                               History<Real>& h) {
  const Real zero(0.0), one(1.0);
  Answer<Real> answer;

  // Crushing, then the effective opening and what is left of the tensile strength.
  answer.crushing = crush_return(m, w, h.crush);
  const Real we = w + h.crush;
  const Real open = maximum(we, zero);
  const Real kappa0 = h.kappa;
  h.kappa = maximum(kappa0, open);
  const Real left = tension_left<V>(m, h.kappa);
  const Real compression = m.kn * minimum(we, zero);
  const auto is_open = we > zero;
  const bool opens = any(is_open);

  // Normal stress with the shear damage so far: what the shear strength feels.
  const Real shear_left0 = one - h.shear_damage;
  Real felt = compression, inv_kappa = zero;
  if (opens) {
    inv_kappa = one / maximum(h.kappa, Real(1e-30));
    const Real strength = m.ft * strength_left<V>(m, left, shear_left0);
    felt = felt + pull<V>(m, open, strength, inv_kappa, h.tension_set);
  }

  Yield<Real> yield = yield_of<V>(m, felt, left, h.kappa);
  if (opens) yield.residual = select(is_open & (left <= zero), zero, yield.residual);
  shear_step<V>(m, yield, s, h, answer);

  // Normal stress with the damage of this step, and the energy it set free.
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
    answer.sigma = answer.sigma + pull<V>(m, open, strength1, inv_kappa, h.tension_set);
  }
  answer.tension_damage = one - left;
  answer.damage = one - all_left;
  return answer;
}

}  // namespace wythe::contact
