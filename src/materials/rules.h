// Rules for materials: formulas that derive parameters of a joint law from tests of units, mortar and
// couplets (docs/theory/material_rules.md).
//
// Used by src/io where a file says "rule"; nothing else is derived. Each rule
// names its inputs by their keys, in SI, and states formula, source, range of validity and scatter.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "wythe/parts/masonry.h"

namespace wythe::materials {

// What a value belongs to: a joint between units, the crack plane inside a unit, or masonry.
enum class Role { kJoint, kUnit, kMasonry };

// Admissible values of one input [SI], or of its ratio to another input.
struct Bound {
  const char* input;
  double low;
  double high;
  const char* per = "";  // the other input; "": the value itself
};

// The inputs of a rule, in the order of its list.
struct Inputs {
  std::vector<double> value;                 // [SI]
  UnitType unit_type = UnitType::kUnstated;  // for rules that depend on it
  double operator[](std::size_t i) const { return value[i]; }
};

struct Rule {
  const char* name;
  Role role;
  const char* gives;                // the key it derives
  std::vector<const char*> inputs;  // keys
  const char* formula;
  const char* source;
  double cov;                // of the value about the formula [-]; 0: a definition
  std::vector<Bound> range;  // the rule is refused outside it
  double (*value)(const Inputs&);
  bool by_unit_type = false;
  bool on_request = false;  // for an optional key of the law: `missing` omits it
  bool clay_alone = false;  // tested on clay units only; needs by_unit_type
};

// All rules. Among those with equal role and key, the first is the one that "rule" selects.
[[nodiscard]] std::span<const Rule> rules();
// The rule that "rule" selects for a key, or "rule: name"; nullptr where there is none.
[[nodiscard]] const Rule* rule_for(Role role, std::string_view key, std::string_view name = "");
// Whether tests give coefficients of the rule for this kind of unit.
[[nodiscard]] bool holds_for(const Rule& rule, UnitType type);
// Coefficient of variation of a rule [-]; for some rules it depends on the kind of unit.
[[nodiscard]] double cov_of(const Rule& rule, UnitType type);

// Ratios from tests of units and small specimens, by kind of unit; nullopt where none are known.
struct UnitRatios {
  UnitType type;
  double tension;      // longitudinal direct tensile strength over normalised compressive strength
  double tension_cov;  // of the tensile strength
  double stiffness;    // E of masonry over its mean compressive strength
  double k, alpha, beta;  // mean compressive strength of masonry = k fb^alpha fmo^beta [MPa]
};
[[nodiscard]] std::optional<UnitRatios> ratios_of(UnitType type);

}  // namespace wythe::materials
