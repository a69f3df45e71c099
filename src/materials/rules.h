// Rules for materials: formulas that derive what a joint law needs from what tests on units, mortar and
// couplets give (docs/theory/material_rules.md).
//
// Asked by src/io where a file says "rule"; nothing is derived that the file does not ask for. Each rule
// names its inputs by their keys, in SI, and states formula, source, range of validity and scatter.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wythe/parts/masonry.h"

namespace wythe::materials {

// What a value belongs to: a joint between units, the crack plane inside a unit, or the masonry.
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
  UnitType unit_type = UnitType::kUnstated;  // for rules that ask for it
  double operator[](std::size_t i) const { return value[i]; }
};

struct Rule {
  const char* name;
  Role role;
  const char* gives;                // the key it derives
  std::vector<const char*> inputs;  // keys
  const char* formula;
  const char* source;
  double cov;                // of the value around the formula [-]; 0: a definition
  std::vector<Bound> range;  // outside it the rule is refused
  double (*value)(const Inputs&);
  bool by_unit_type = false;
  bool on_request = false;  // for a key the law does without: `missing` leaves it out
  bool clay_alone = false;  // tested on clay units alone; goes with by_unit_type
};

// Every rule. Of those with the same role and key the first is the one meant by "rule".
[[nodiscard]] std::span<const Rule> rules();
// The rule meant by "rule" for a key, or by "rule: name"; nullptr where there is none.
[[nodiscard]] const Rule* rule_for(Role role, std::string_view key, std::string_view name = "");
// Whether tests give the rule's coefficients for this kind of unit.
[[nodiscard]] bool holds_for(const Rule& rule, UnitType type);
// Its scatter, which depends on the kind of unit for some.
[[nodiscard]] double cov_of(const Rule& rule, UnitType type);

// Ratios from tests on units and small specimens, for a kind of unit; nullopt where none are known.
struct UnitRatios {
  UnitType type;
  double tension;      // longitudinal direct tensile strength over normalised compressive strength
  double tension_cov;  // of the tensile strength
  double stiffness;    // E of masonry over its mean compressive strength
  double k, alpha, beta;  // mean compressive strength of masonry = k fb^alpha fmo^beta [MPa]
};
[[nodiscard]] std::optional<UnitRatios> ratios_of(UnitType type);

}  // namespace wythe::materials
