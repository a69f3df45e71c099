// From what the user states about a joint to the constants of the law, and the choice of variant.
#pragma once

#include <utility>

#include "contact/law.h"

namespace wythe::contact {

// Precomputes every quotient of the law; `material` must have passed check_joint_material().
[[nodiscard]] LawConstants<double> constants_of(const JointMaterial& material);

// Calls visitor(Variant<...>{}) for the material's softening, coupling and unloading.
template <class Visitor>
decltype(auto) with_variant(const JointMaterial& m, Visitor&& visitor) {
  const auto unloading = [&]<Softening s, Coupling c>() -> decltype(auto) {
    if (m.unloading == Unloading::kElastic) return visitor(Variant<s, c, Unloading::kElastic>{});
    return visitor(Variant<s, c, Unloading::kSecant>{});
  };
  const auto coupling = [&]<Softening s>() -> decltype(auto) {
    switch (m.coupling) {
      case Coupling::kMaximum: return unloading.template operator()<s, Coupling::kMaximum>();
      case Coupling::kStiffness: return unloading.template operator()<s, Coupling::kStiffness>();
      case Coupling::kUnion: break;
    }
    return unloading.template operator()<s, Coupling::kUnion>();
  };
  switch (m.softening) {
    case Softening::kExponential: return coupling.template operator()<Softening::kExponential>();
    case Softening::kPolynomial: return coupling.template operator()<Softening::kPolynomial>();
    case Softening::kPetersson: return coupling.template operator()<Softening::kPetersson>();
    case Softening::kBilinear: break;
  }
  return coupling.template operator()<Softening::kBilinear>();
}

// True when two materials run through the same compiled variant of the law.
[[nodiscard]] inline bool same_variant(const JointMaterial& a, const JointMaterial& b) {
  return a.softening == b.softening && a.coupling == b.coupling && a.unloading == b.unloading;
}

}  // namespace wythe::contact
