// Converts the user's joint material into the constants of the law, and chooses the variant.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/law_constants.h"

namespace wythe::contact {

// Cache of tangents of recent angles. Each costs 0.5 us; joints of a field have their own materials, but rarely their
// own angles.
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

// Computes the constants of the law; `material` must have passed check_joint_material().
[[nodiscard]] LawConstants<double> constants_of(const JointMaterial& material);
[[nodiscard]] LawConstants<double> constants_of(const JointMaterial& material, Tangents& tangents);

// Cache of the last constants, since consecutive joints often have one material. A list of all would be long where each joint
// of a field has its own material.
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

// Largest drop from peak to residual shear stress at any pressure up to crushing [Pa].
[[nodiscard]] double greatest_drop(const JointMaterial& material);
// Growth of a GII that rises with pressure, up to crushing, or to 10 MPa where that is unlimited [N/m].
[[nodiscard]] double greatest_rise(const JointMaterial& material);

// The law of a head joint with `bed.head_joint_bond` of this bed's bond (material_rules.md, 9.6): that share of tensile
// strength, cohesion and energies, everything else as in the bed. Admissible where the bed is.
[[nodiscard]] JointMaterial head_joint_law(const JointMaterial& bed);

// Replaces several faults "is missing" of check_joint_material() by one without a key.
[[nodiscard]] std::vector<MaterialFault> missing_as_one(std::vector<MaterialFault> faults);

[[nodiscard]] constexpr LawChoice choice_of(const JointMaterial& m) {
  const bool cap = m.compression_cap > 0 || m.hardening_displacement > 0 || m.dilatancy_angle > 0;
  return {m.softening, m.coupling, m.unloading, cap, m.mode_2_energy_per_pressure >= 0};
}

// Calls visitor(V{}) with the compiled variant for a law: that of the paper, the same with a cap,
// or AnyVariant.
template <class Visitor>
decltype(auto) with_variant(LawChoice choice, Visitor&& visitor) {
  choice.rising = false;  // tested at run time
  if (choice == PaperVariant::known) return visitor(PaperVariant{});
  if (choice == CappedVariant::known) return visitor(CappedVariant{});
  return visitor(AnyVariant{});
}

}  // namespace wythe::contact
