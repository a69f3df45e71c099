// Random fields: a property of the wall's material that differs from place to place.
//
//   [field.NAME] of the model ──draw_fields()──► a factor at each place ──compile()──► each joint's own law
//
// The value in the model file stays the mean of the wall; a field multiplies it, place by place. Theory:
// docs/theory/fields.md.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/contact_law.h"
#include "wythe/parts/words.h"

namespace wythe {

// Of a study's variables and of fields. What a kind takes and how it is made: kKinds in
// src/campaign/draws/sampling.cpp.
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

// What has one value of its own: a place, all of a course, all of a unit, or each joint.
enum class FieldBy { kPlace, kCourse, kUnit, kJoint };
inline constexpr Word<FieldBy> kFieldByWords[] = {{"place", FieldBy::kPlace},
                                                  {"course", FieldBy::kCourse},
                                                  {"unit", FieldBy::kUnit},
                                                  {"joint", FieldBy::kJoint}};

// How correlation fades with the distances dx, dy: to 1/e at `along` or `across`.
//   exponential           exp(-|dx|/along - |dy|/across)
//   squared_exponential   exp(-(dx/along)^2 - (dy/across)^2)
// In space y is up and dx the distance in plan, sqrt(dx^2 + dz^2), whatever way walls run.
enum class FieldKernel { kExponential, kSquaredExponential };
inline constexpr Word<FieldKernel> kFieldKernelWords[] = {
    {"exponential", FieldKernel::kExponential},
    {"squared_exponential", FieldKernel::kSquaredExponential}};

// Correlation with another field, of the Gaussian copula.
struct FieldTie {
  double gaussian = kUnset;
};

struct FieldSpec {
  // "material.joint.cohesion", "wall.unit.density"
  std::string path;
  // Follows other fields place by place, "0.03 mm * ft"; then nothing below is given.
  std::string formula;
  DistributionKind distribution = DistributionKind::kLognormal;
  double cov = kUnset;                 // of the field within the wall [-]
  double low = kUnset, high = kUnset;  // ends of a beta distribution, as multiples of the mean [-]
  double lower = kUnset, upper = kUnset;  // truncation, as multiples of the mean [-]
  FieldBy by = FieldBy::kPlace;
  FieldKernel kernel = FieldKernel::kExponential;
  double along = kUnset, across = kUnset;  // correlation lengths along and across the courses [m]
  std::map<std::string, FieldTie> correlation;  // by the other field's name
  int seed = 0;                                 // which wall of all these
  // Numbers are drawn by where a unit, joint or course stands, not by its number in the wall: a wall with another
  // opening draws the same where nothing changed.
  bool in_place = false;

  // Put there by draw_fields(), no keys: of each place, in the assembly's order, a factor, or of a formula
  // the value [SI]; and the shape_key of the wall.
  std::vector<double> drawn;
  std::uint64_t drawn_for = 0;
};

// [scatter]: how much the strengths of joints and units differ within a wall, as tests say of a kind of masonry
// (docs/theory/fields.md, "Scatter of a masonry"). draw_fields() makes fields of it.
struct ScatterSpec {
  std::string use;  // "clay_brick", "calcium_silicate", "stone", "tuff"; "": the numbers alone
  // Coefficients of variation [-]; unset: of `use`, else none.
  double joint_tension = kUnset, joint_cohesion = kUnset, unit_tension = kUnset;
  std::string joint = "joint", unit = "unit";  // the materials
  FieldBy by = FieldBy::kUnit;
  int seed = 0;  // which of all walls
  [[nodiscard]] bool is_asked() const {
    return !use.empty() || joint_tension > 0 || joint_cohesion > 0 || unit_tension > 0;
  }
};

// A field as it stands in a compiled wall, for pictures and tables.
struct DrawnField {
  std::string name, path;
  std::vector<double> of_joint, of_block;  // [SI] (n_joint, n_block); NaN where it does not act
};

}  // namespace wythe
