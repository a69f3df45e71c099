// The joint material: the parameters of the joint law that a user states for one kind of joint (docs/theory/joint_law.md).
//
// src/contact, the law as a template over the scalar type, and all writers read it.
// All physical parameters start as NaN; check_joint_material() refuses missing ones.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "wythe/parts/words.h"

namespace wythe {

inline constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
[[nodiscard]] inline bool is_set(double value) { return !std::isnan(value); }
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Shape of the softening branch in tension and shear; each holds the same area GI or GII.
enum class Softening { kBilinear, kExponential, kPolynomial, kPetersson };
inline constexpr Word<Softening> kSofteningWords[] = {{"bilinear", Softening::kBilinear},
                                                      {"exponential", Softening::kExponential},
                                                      {"polynomial", Softening::kPolynomial},
                                                      {"petersson", Softening::kPetersson}};
// How tension damage d_t and shear damage d_s combine: d = d_t + d_s - d_t d_s, max(d_t, d_s), or
// max(1 - secant/kn, d_s) acting on shear alone (stiffness damage, which weakens shear earlier).
enum class Coupling { kUnion, kMaximum, kStiffness };
inline constexpr Word<Coupling> kCouplingWords[] = {{"union", Coupling::kUnion},
                                                    {"maximum", Coupling::kMaximum},
                                                    {"stiffness", Coupling::kStiffness}};
// Path of unloading from an open joint: towards the origin, or with elastic stiffness to a tension set w_t.
enum class Unloading { kSecant, kElastic };
inline constexpr Word<Unloading> kUnloadingWords[] = {{"secant", Unloading::kSecant},
                                                      {"elastic", Unloading::kElastic}};

struct JointMaterial {
  double normal_stiffness = kUnset;         // kn [Pa/m], normal stress per opening
  double shear_stiffness = kUnset;          // ks [Pa/m], shear stress per slip
  double tensile_strength = kUnset;         // ft [Pa], 0 for a dry joint
  double cohesion = kUnset;                 // c [Pa]
  double friction_angle = kUnset;           // phi0 [rad]
  double residual_friction_angle = kUnset;  // phi_res [rad]
  double residual_cohesion = kUnset;        // c_res [Pa]
  double mode_1_energy = kUnset;            // GI [N/m], whole area of the curve; needed when ft > 0
  double mode_2_energy = kUnset;  // GII [N/m], work above the residual; needed when t0 > tr
  // b [m]: GII grows by b with each Pa of pressure, GII = mode_2_energy + b sn; unset: it does not.
  double mode_2_energy_per_pressure = kUnset;
  double compressive_strength = kUnset;  // fc [Pa], kUnlimited allowed
  double compressive_energy = kUnset;    // Gc [N/m], area as of GI; needed when fc is finite
  // If any of the next three is given, crushing follows q, the combined path of normal and shear displacement.
  double compression_cap = kUnset;         // Css [-]: sigma^2 + Css tau^2 <= F(q)^2; unset: no cap
  double hardening_displacement = kUnset;  // kappa_p [m], F rises from fc/3 to fc; unset: none
  double dilatancy_angle = kUnset;         // psi [rad], lift per slip without pressure; unset: none
  double dilatancy_slip = kUnset;          // slip at which dilatancy has faded [m]; unset: it stays
  double dilatancy_pressure = kUnset;      // pressure at which dilatancy is zero [Pa]; unset: none
  // Of a bed material: share of its bond for head joints that name no material of their own [-]; unset: 1.
  double head_joint_bond = kUnset;
  Softening softening = Softening::kBilinear;
  Coupling coupling = Coupling::kUnion;
  Unloading unloading = Unloading::kSecant;
  // For a material that is also a body (timber lintel, plate): density [kg/m^3] and elastic moduli [Pa].
  double density = kUnset;
  double youngs_modulus = kUnset;  // along the body (the grain)
  double shear_modulus = kUnset;
  double youngs_modulus_across = kUnset;  // unset: isotropic
  double poisson_ratio = kUnset;          // unset: E/2G - 1
  // Principal stresses of a zone above which the run reports an event; the zone itself stays elastic [Pa].
  double tension_limit = kUnset, compression_limit = kUnset;
  // Sources of values that the file does not give: "cohesion 0.21 MPa: typical of ..." (read by materials/origin.h).
  std::vector<std::string> origin = {};
};

// A missing or inadmissible parameter, or snap-back: a softening branch steeper than the elastic
// one, which no displacement path can follow. Each fault gives its numbers.
struct MaterialFault {
  std::string key;      // e.g. "mode_1_energy"
  std::string value;    // "0.1 N/m", empty when missing
  std::string problem;  // in one clause, with the other numbers involved
  std::string cure;
};
[[nodiscard]] std::vector<MaterialFault> check_joint_material(const JointMaterial& material);

// One row of a prescribed path, and the response of a single joint to it (`wythe contact`).
struct ContactPathRow {
  double opening = 0;  // w [m], + opens
  double slip = 0;     // [m]
};
struct ContactAnswer {
  double normal_stress = 0;   // sigma [Pa], tension +
  double shear_stress = 0;    // tau [Pa]
  double damage_tension = 0;  // d_t [-]
  double damage_shear = 0;    // d_s [-]
  double damage = 0;          // d [-], coupled
  double crushing = 0;        // h [-]
  double dissipated = 0;      // [N/m], since the start of the path
};
// Response of one joint along `path`, straight between rows and divided into substeps that resolve the law.
[[nodiscard]] std::vector<ContactAnswer> drive_contact(const JointMaterial& material,
                                                       const std::vector<ContactPathRow>& path);

}  // namespace wythe
