// What the joint law needs of a material, and what it remembers of a point: its choice, constants and history.
//
// Apart from law.h, because many sources know these numbers and few compute with them: a changed line of the law compiles those few.
#pragma once

#include <array>
#include <type_traits>

#include "core/real.h"
#include "wythe/parts/contact_law.h"

namespace wythe::contact {

// Which law a material follows.
struct LawChoice {
  Softening softening = Softening::kBilinear;
  Coupling coupling = Coupling::kUnion;
  Unloading unloading = Unloading::kSecant;
  bool cap = false;     // crushing by an ellipse in normal and shear stress, hardening, dilatancy
  bool rising = false;  // GII grows with pressure
  bool operator==(const LawChoice&) const = default;
};

// How functions of the law get the choice: a Variant states it at compile time, so
// that no test runs; AnyVariant reads it from the constants, equal in all lanes. Few variants
// are compiled (with_variant, parameters.h), since each costs seconds of compile time. `rising` is not among them: every
// variant tests the constants, one branch that is equal for all points of a material.
template <Softening softening_, Coupling coupling_, Unloading unloading_, bool cap_ = false>
struct Variant {
  static constexpr LawChoice known{softening_, coupling_, unloading_, cap_, false};
};
using PaperVariant = Variant<Softening::kBilinear, Coupling::kUnion, Unloading::kSecant>;
using CappedVariant = Variant<Softening::kBilinear, Coupling::kUnion, Unloading::kSecant, true>;
struct AnyVariant {};

template <class V, class Constants>
[[nodiscard]] WYTHE_INLINE constexpr LawChoice choice_of(const Constants& m) {
  if constexpr (std::is_same_v<V, AnyVariant>)
    return m.choice;
  else
    return V::known;
}

// Parameters of one material with all divisions done in advance (constants_of, parameters.cpp).
template <class Real>
struct LawConstants {
  Real kn, ks, inv_ks, inv_kn;       // [Pa/m], [m/Pa]
  Real ft, w0, ft_over_GI;           // [Pa], [m], [1/m]
  Real tension_onset, tension_rate;  // bilinear d_t = clip((kappa - onset) rate, 0, 1)
  Real c_res, c_drop;                // c_res, c - c_res [Pa]
  Real tan_res, tan_drop;            // tan phi_res, tan phi0 - tan phi_res
  Real half_inv_GII;                 // 1/(2 GII); of a rising GII 1/(2 a) [m/N]
  Real fc, p_full, inv_p_full;       // [Pa], 2 Gc/fc [m], [1/m]
  Real crush_gain;                   // 1/(kn - fc/p_full) [m/Pa]
  Real twice_b;                      // 2 b, for a rising GII only [m]
  // for a law with a cap only
  Real root_css, css_ks;                          // sqrt Css [-], Css ks [Pa/m]
  Real harden, inv_harden, harden_drop;           // kappa_p [m]; share of fc missing at q = 0 [-]
  Real crush_rate;                                // 1/(q_full - kappa_p) [1/m]
  Real tan_lift, inv_lift_slip, inv_lift_stress;  // dilatancy: tan psi, where it fades
  LawChoice choice;
};
// The constants in order, for copies and for walls side by side. First those from strengths, cohesions and their
// energies, which a field varies most. Within both parts, constants for an elastic
// step of a closed point come first, so that such a step reads little memory.
template <class Real, class C = LawConstants<Real>>
inline constexpr std::array kConstants{&C::tension_onset,
                                       &C::tension_rate,
                                       &C::c_res,
                                       &C::c_drop,
                                       &C::half_inv_GII,
                                       &C::ft,
                                       &C::w0,
                                       &C::ft_over_GI,
                                       &C::kn,
                                       &C::ks,
                                       &C::fc,
                                       &C::inv_p_full,
                                       &C::tan_res,
                                       &C::tan_drop,
                                       &C::inv_kn,
                                       &C::inv_ks,
                                       &C::p_full,
                                       &C::crush_gain,
                                       &C::twice_b,
                                       &C::root_css,
                                       &C::css_ks,
                                       &C::harden,
                                       &C::inv_harden,
                                       &C::harden_drop,
                                       &C::crush_rate,
                                       &C::tan_lift,
                                       &C::inv_lift_slip,
                                       &C::inv_lift_stress};
inline constexpr int kStrengths = 8;
static_assert(kConstants<double>[kStrengths] == &LawConstants<double>::kn);

// Committed history of a point; the law has no other memory.
template <class Real>
struct History {
  Real kappa;         // largest opening w_e reached [m]
  Real crush;         // crushing shortening p = -w_p, less the lift of dilatancy [m]
  Real plastic_slip;  // signed [m]
  Real slip;          // accumulated |plastic slip| [m]
  Real shear_damage;  // d_s [-]
  Real tension_set;   // w_t [m] (elastic unloading)
  Real crush_path;    // q, path of crushing in normal and shear displacement [m] (cap)
};
// The numbers of the history, in the order of the table of fields (model/fields.h).
template <class Real, class H = History<Real>>
inline constexpr std::array kHistory{&H::kappa,        &H::crush,       &H::plastic_slip, &H::slip,
                                     &H::shear_damage, &H::tension_set, &H::crush_path};
// How many of them, from the first on, a law of this choice needs. Only these are stored.
[[nodiscard]] WYTHE_INLINE constexpr int history_size(const LawChoice& choice) {
  constexpr int all = static_cast<int>(kHistory<double>.size());
  static_assert(kHistory<double>[all - 2] == &History<double>::tension_set &&
                kHistory<double>[all - 1] == &History<double>::crush_path);
  if (choice.cap) return all;
  return choice.unloading == Unloading::kElastic ? all - 1 : all - 2;
}

}  // namespace wythe::contact
