// From what the user states about a joint to the constants of the law, and the choice of variant.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/law.h"

namespace wythe::contact {

// Tangents of the last angles that were asked for. Each takes 0.5 us, and joints of a field have materials of their own, but
// hardly ever angles of their own.
class Tangents {
 public:
  [[nodiscard]] double of(double angle);

 private:
  struct Known {
    double angle = kUnset, tangent = kUnset;
  };
  std::array<Known, 8> known_{};
  std::size_t oldest_ = 0;
};

// Precomputes every quotient of the law; `material` must have passed check_joint_material().
[[nodiscard]] LawConstants<double> constants_of(const JointMaterial& material);
[[nodiscard]] LawConstants<double> constants_of(const JointMaterial& material, Tangents& tangents);

// The constants of joint after joint. Those of the last material are kept, since joints come in runs of one material; a list of
// all would be long where each joint of a field has its own.
class Laws {
 public:
  explicit Laws(const std::vector<JointMaterial>& materials) : materials_(materials) {}
  [[nodiscard]] const LawConstants<double>& of(std::int32_t material);

 private:
  const std::vector<JointMaterial>& materials_;
  std::int32_t last_ = -1;
  LawConstants<double> law_{};
  Tangents tangents_;
};

// The largest fall from peak to residual shear stress at any pressure up to crushing [Pa].
[[nodiscard]] double greatest_drop(const JointMaterial& material);
// What a GII that rises with pressure gains up to crushing, or to 10 MPa where that is unlimited [N/m].
[[nodiscard]] double greatest_rise(const JointMaterial& material);

// The law of a head joint that has `bed.head_joint_bond` of the bond of this bed (material_rules.md, 9.6): tension,
// cohesion and energies by that share, the rest as the bed. Admissible wherever the bed is.
[[nodiscard]] JointMaterial head_joint_law(const JointMaterial& bed);

// Faults of check_joint_material() with one, of no key, in the place of several that say "is missing".
[[nodiscard]] std::vector<MaterialFault> missing_as_one(std::vector<MaterialFault> faults);

[[nodiscard]] constexpr LawChoice choice_of(const JointMaterial& m) {
  const bool cap = m.compression_cap > 0 || m.hardening_displacement > 0 || m.dilatancy_angle > 0;
  return {m.softening, m.coupling, m.unloading, cap, m.mode_2_energy_per_pressure >= 0};
}

// Calls visitor(V{}) with the compiled variant that a law runs through: the paper's, the same with a cap,
// or any.
template <class Visitor>
decltype(auto) with_variant(LawChoice choice, Visitor&& visitor) {
  choice.rising = false;  // asked at run time
  if (choice == PaperVariant::known) return visitor(PaperVariant{});
  if (choice == CappedVariant::known) return visitor(CappedVariant{});
  return visitor(AnyVariant{});
}

}  // namespace wythe::contact
