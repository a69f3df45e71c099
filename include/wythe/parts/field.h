// Random fields: a property of the wall's materials that varies from place to place.
//
//   [field.NAME] of the model ──draw_fields()──► a factor at each place ──compile()──► each joint's own law
//
// The value in the model file is the mean of the wall; a field gives a factor for each place. Theory:
// docs/theory/fields.md.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/contact_law.h"
#include "wythe/parts/words.h"

namespace wythe {

// Distributions of a study's variables and of fields. Parameters and sampling of each kind: kKinds in
// src/campaign/draws/margin.cpp.
enum class DistributionKind {
  kNormal,
  kLognormal,
  kUniform,
  kTriangular,
  kBeta,
  kWeibull,
  kEmpirical
};
inline constexpr Word<DistributionKind> kDistributionWords[] = {
    {"normal", DistributionKind::kNormal},      {"lognormal", DistributionKind::kLognormal},
    {"uniform", DistributionKind::kUniform},    {"triangular", DistributionKind::kTriangular},
    {"beta", DistributionKind::kBeta},          {"weibull", DistributionKind::kWeibull},
    {"empirical", DistributionKind::kEmpirical}};

// What has a value of its own: each place, each course, each unit, or each joint.
enum class FieldBy { kPlace, kCourse, kUnit, kJoint };
inline constexpr Word<FieldBy> kFieldByWords[] = {{"place", FieldBy::kPlace},
                                                  {"course", FieldBy::kCourse},
                                                  {"unit", FieldBy::kUnit},
                                                  {"joint", FieldBy::kJoint}};

// Correlation over the distances dx, dy; it falls to 1/e at the lengths `along` and `across`.
//   exponential           exp(-|dx|/along - |dy|/across)
//   squared_exponential   exp(-(dx/along)^2 - (dy/across)^2)
// In space y is up and dx is the distance in plan, sqrt(dx^2 + dz^2), whatever the direction of walls.
enum class FieldKernel { kExponential, kSquaredExponential };
inline constexpr Word<FieldKernel> kFieldKernelWords[] = {
    {"exponential", FieldKernel::kExponential},
    {"squared_exponential", FieldKernel::kSquaredExponential}};

// Correlation with another field, in the Gaussian copula.
struct FieldTie {
  double gaussian = kUnset;
};

struct FieldSpec {
  // "material.joint.cohesion", "wall.unit.density"
  std::string path;
  // Formula over other fields at the same place, "0.03 mm * ft"; then no member below is given.
  std::string formula;
  DistributionKind distribution = DistributionKind::kLognormal;
  double cov = kUnset;                 // of the field within the wall [-]
  double low = kUnset, high = kUnset;  // ends of a beta distribution, as multiples of the mean [-]
  double lower = kUnset, upper = kUnset;  // truncation, as multiples of the mean [-]
  FieldBy by = FieldBy::kPlace;
  FieldKernel kernel = FieldKernel::kExponential;
  double along = kUnset, across = kUnset;  // correlation lengths along and across the courses [m]
  std::map<std::string, FieldTie> correlation;  // by the other field's name
  int seed = 0;                                 // number of the realisation
  // Numbers are drawn by the position of a unit, joint or course, not by its index in the wall. A wall with another
  // opening then has the same values where nothing changed.
  bool in_place = false;

  // Set by draw_fields(), not keys: for each place in the assembly's order a factor, or the value of a
  // formula [SI]; and the shape_key of the wall that was drawn.
  std::vector<double> drawn;
  std::uint64_t drawn_for = 0;
};

// [scatter]: variation of the strengths of joints and units within a wall, from tests of a kind of masonry
// (docs/theory/fields.md, "Scatter of a masonry"). draw_fields() turns it into fields.
struct ScatterSpec {
  std::string use;  // "clay_brick", "calcium_silicate", "stone", "tuff"; "": only numbers
  // Coefficients of variation [-]; unset: those of `use`, else none.
  double joint_tension = kUnset, joint_cohesion = kUnset, unit_tension = kUnset;
  std::string joint = "joint", unit = "unit";  // the materials that vary
  FieldBy by = FieldBy::kUnit;
  int seed = 0;  // number of the realisation
  [[nodiscard]] bool is_asked() const {
    return !use.empty() || joint_tension > 0 || joint_cohesion > 0 || unit_tension > 0;
  }
};

// The values of a field in a compiled wall, for pictures and tables.
struct DrawnField {
  std::string name, path;
  std::vector<double> of_joint, of_block;  // [SI] (n_joint, n_block); NaN where it does not act
};

}  // namespace wythe
