// The one description of the input: every key of a model file
// with its member, unit, range, words, meaning and example.
//
//   describe(visitor, spec)      visitor reads, writes, compares or documents; it offers
//     quantity, quantities       double, vector<double> with a unit
//     points                     pairs of them
//     number, integer, flag      double without unit, int, bool
//     text, texts, choice        string, vector<string>, an enum by its words
//     table, list, map           a struct, a vector of structs [[..]], structs by name [..<name>]
//
// Visitors: toml_reader.h, toml_writer.h, reference.cpp, same_spec.h, key_list.cpp, model_key.cpp, materials.cpp. A new
// key is one line here and nothing elsewhere. Order here is order in written files and in the reference page.
#pragma once

#include "io/keys/describe_assessment.h"
#include "io/keys/describe_building.h"
#include "io/keys/describe_floors.h"
#include "io/keys/describe_frames.h"
#include "io/keys/describe_layers.h"
#include "io/keys/describe_plan.h"
#include "io/keys/describe_shaking.h"
#include "io/keys/describe_space.h"
#include "io/keys/key.h"
#include "io/keys/stage_records.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

inline constexpr Kinds kLoadStage = kind_bit(StageKind::kLoad);
inline constexpr Kinds kPushStage = kind_bit(StageKind::kPush);
inline constexpr Kinds kBodyForceStage = kind_bit(StageKind::kBodyForce);
inline constexpr Kinds kTiltStage = kind_bit(StageKind::kTilt);
inline constexpr Kinds kHoldStage = kind_bit(StageKind::kHold);
inline constexpr Kinds kShakeStage = kind_bit(StageKind::kShake);
inline constexpr Kinds kDirectedStage = kPushStage | kBodyForceStage | kTiltStage;
inline constexpr Kinds kRampedStage =
    kind_bit(StageKind::kGravity) | kind_bit(StageKind::kCut) | kLoadStage | kDirectedStage;

// The descriptions are tables in manual layout, two to four lines for each key.
// clang-format off

// A key that is removed before the table is read (src/io/model/materials.cpp). Visitors of values ignore it.
template <class Visitor>
void describe_recipe(Visitor& v, const char* name, const Key& key) {
  if constexpr (requires { v.recipe(name, key); }) v.recipe(name, key);
}

// --- wall ----------------------------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, BeamSpec& s) {
  v.quantity("height", s.height, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "no beam", .example = "250 mm",
             .doc = "Height of a rigid beam over the wall top; its presence makes the beam."});
  v.quantity("density", s.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kNotNegative,
             .example = "2400 kg/m^3", .doc = "Density of the beam; 0 kg/m^3 for a light one."});
  v.choice("rotation", s.rotation, kFreedomWords, {.example = "blocked",
           .doc = "Whether the beam may turn: free for a cantilever, blocked for double fixity."});
  v.text("joint", s.joint, {.example = "joint",
         .doc = "Name of the joint material between beam and masonry."});
}

template <class Visitor>
void describe(Visitor& v, WallSpec& s) {
  v.quantity("length", s.length, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = kRequired, .example = "5.10 m", .doc = "Length of the wall."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "required, or the sum of the storeys", .example = "3.62 m",
             .doc = "Height of the masonry; with storeys it may be left out, or agrees with their sum."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = kRequired, .example = "0.31 m",
             .doc = "Thickness out of the plane; may stand in the blocks file or in every storey instead."});
  v.choice("bond", s.bond, kBondWords, {.example = "running", .doc = "How the units are laid."});
  v.choice("fit", s.fit, kFitWords, {.example = "cut",
           .doc = "Where units or courses do not divide the wall evenly: `whole` fits their size "
                  "by up to 2 % and reports it, `cut` keeps it and cuts units at the edges, as in a "
                  "surveyed wall."});
  v.text("blocks", s.blocks, {.fallback = "the bond pattern", .example = "stones.json",
         .doc = "Blocks file (JSON), or a drawing of every stone (DXF), relative to the model file. It replaces "
                "length, height, bond, the unit's sizes and the openings."});
  describe_recipe(v, "blocks_unit", {.fallback = "what the drawing states", .example = "mm",
                  .doc = "Unit of a mesh or COMPAS file, or of a drawing that states none (m, mm, cm, dm, in, ft)."});
  describe_space(v, s);
  v.table("unit", s.unit, {.optional = true, .doc = "The masonry unit."});
  describe_joints(v, s.joints, "joint", "joint, or what that is", "unit");
  v.list("opening", s.opening, {.doc = "One table for each door or window."});
  v.table("beam", s.beam, {.optional = true, .doc = "A loading beam over the whole wall top."});
  v.list("foundation", s.foundation, {.optional = true,
         .doc = "Ground in steps, from left to right: the wall begins on each. The lowest is at y = 0 m. Without "
                "it the ground is level. The soil beside a step does not touch the wall."});
}

// --- materials -----------------------------------------------------------------------------------

template <class Visitor>
void describe_use(Visitor& v) {
  describe_recipe(v, "use", {.fallback = "none", .example = "circolare_brick_lime",
                  .doc = "Typical values, with their source and scatter, for what is not given here; "
                         "`wythe materials` lists the names."});
}

template <class Visitor>
void describe_origin(Visitor& v, std::vector<std::string>& origin) {
  v.texts("origin", origin, {.fallback = "none", .example = "[\"cohesion 0.21 MPa: typical of circolare_brick_lime\"]",
          .doc = "Written by the program: where the values come from that were not given. A line holds "
                 "only while the value is the one it names."});
}

template <class Visitor>
void describe_strengths(Visitor& v, MasonrySpec& m) {
  v.choice("unit_type", m.unit_type, kUnitTypeWords, {.fallback = "none", .example = "clay",
           .doc = "Kind of unit, for rules whose ratios depend on it."});
  v.quantity("unit_strength", m.unit_strength, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .fallback = "none", .example = "15 MPa",
             .doc = "fb, mean normalised compressive strength of the units (EN 772-1), gross section."});
  v.quantity("mortar_strength", m.mortar_strength, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .fallback = "none", .example = "4 MPa", .doc = "fmo, mean compressive strength of the mortar."});
  v.quantity("masonry_strength", m.masonry_strength, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .fallback = "none", .example = "6 MPa",
             .doc = "fm, mean compressive strength of the masonry across the bed joints."});
  v.quantity("vertical_stress", m.vertical_stress, {.unit = "Pa", .shown = "MPa", .range = kNotNegative,
             .fallback = "none", .example = "0.6 MPa",
             .doc = "Mean vertical stress of the wall under its loads; lowers tension of units along their length."});
  v.quantity("initial_shear_strength", m.initial_shear_strength, {.unit = "Pa", .shown = "MPa",
             .range = kNotNegative, .fallback = "none", .example = "0.2 MPa", .doc = "fv0 of triplets (EN 1052-3)."});
  v.quantity("diagonal_shear_strength", m.diagonal_shear_strength, {.unit = "Pa", .shown = "MPa",
             .range = kNotNegative, .fallback = "none", .example = "0.06 MPa",
             .doc = "tau0 of panels that crack along a diagonal, without normal stress."});
  v.number("friction_tan", m.friction_tan, {.range = kNotNegative, .fallback = "none", .example = "0.6",
           .doc = "mu of triplets, a tangent."});
}

template <class Visitor>
void describe_stiffnesses(Visitor& v, MasonrySpec& m) {
  v.quantity("youngs_modulus", m.youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "none", .example = "3 GPa", .doc = "E of the masonry across the bed joints."});
  v.quantity("shear_modulus", m.shear_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "none", .example = "1.2 GPa", .doc = "G of the masonry."});
  v.quantity("weight", m.weight, {.unit = "N/m^3", .shown = "kN/m^3", .range = kPositive, .fallback = "none",
             .example = "18 kN/m^3", .doc = "Weight of a volume of masonry."});
  v.quantity("density", m.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kPositive, .fallback = "none",
             .example = "1800 kg/m^3",
             .doc = "Density of the masonry. `wall.unit.density = \"rule\"` takes it; without it that of weight."});
  v.quantity("unit_youngs_modulus", m.unit_youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "none", .example = "10 GPa", .doc = "Eu of the units."});
  v.quantity("mortar_youngs_modulus", m.mortar_youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "none", .example = "2 GPa", .doc = "Em of the mortar in the joint."});
  v.quantity("interface_normal_stiffness", m.interface_normal_stiffness, {.unit = "Pa/m", .shown = "GPa/m",
             .range = kPositive, .fallback = "none", .example = "82 GPa/m",
             .doc = "kn of an interface between elastic units, as micro-models state it (1 N/mm3 is 1 GPa/m)."});
  v.quantity("interface_shear_stiffness", m.interface_shear_stiffness, {.unit = "Pa/m", .shown = "GPa/m",
             .range = kPositive, .fallback = "none", .example = "36 GPa/m", .doc = "ks of such an interface."});
  v.quantity("joint_thickness", m.joint_thickness, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "wall.unit.mortar", .example = "10 mm", .doc = "Thickness of a bed joint."});
  v.quantity("course_height", m.course_height, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "wall.unit.height", .example = "65 mm", .doc = "Height of a course, bed joint included."});
  v.quantity("unit_length", m.unit_length, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "wall.unit.length", .example = "260 mm", .doc = "Length of a unit, head joint included."});
}

// Existing masonry by Circolare 7/2019; a coefficient is true, or a number up to what the table allows.
template <class Visitor>
void describe_office(Visitor& v) {
  describe_recipe(v, "knowledge_level", {.fallback = "mean values, not divided", .example = "LC2",
                  .doc = "`LC1`, `LC2` or `LC3` of C8.5.4: which values of Table C8.5.I are taken, and by which confidence "
                         "factor strengths are divided. With `use = \"circolare_...\"`."});
  const auto factor = [&](const char* name, const char* doc) {
    describe_recipe(v, name, {.fallback = "false", .example = "true", .doc = doc});
  };
  factor("good_mortar", "Good mortar: `true` takes the coefficient of Table C8.5.II, a number a smaller one. Of bricks it follows "
                        "from mortar_strength, above 2 MPa.");
  factor("courses", "Levelling courses, likewise: f and tau0 alone.");
  factor("transverse_connection", "Through stones between the leaves, likewise: strengths alone.");
  factor("injections", "Injected with binder, likewise.");
  factor("reinforced_plaster", "Reinforced plaster, likewise; in its place acts no transverse connection and no repointing.");
  factor("reinforced_repointing", "Reinforced repointing with connected leaves, likewise; moduli gain half.");
  factor("artificial_headers", "Artificial through stones: the coefficient of the transverse connection.");
  factor("leaf_ties", "Thin ties through the wall: that coefficient on the compressive strength alone.");
  factor("poor_mortar", "`true`: mortar below 0.7 MPa, strengths times 0.7, moduli times 0.8.");
  factor("thick_joints", "`true`: bricks with joints above 13 mm, likewise.");
  factor("deep_wedges", "`true`: rough blocks with deep stone wedges, strengths times 1.2.");
  describe_recipe(v, "test", {.fallback = "none",
                  .example = "{ of = \"masonry_strength\", mean = \"3.4 MPa\", number = 3, method = \"double_flat_jack\" }",
                  .doc = "LC3: one table `[[masonry.test]]` for each value that was tested: `of` (its key), `mean` (a quantity), `number` "
                         "of tests, `method` (`compression`, `double_flat_jack`, `shear_compression`, `diagonal_compression`, "
                         "`joint_shear`, `constituents`), and `kappa` where it is not that of Table C8.5.III."});
}

template <class Visitor>
void describe(Visitor& v, MasonrySpec& m) {
  describe_use(v);
  describe_office(v);
  describe_strengths(v, m);
  describe_stiffnesses(v, m);
  describe_origin(v, m.origin);
}

template <class Visitor>
void describe_elasticity(Visitor& v, JointMaterial& m) {
  v.quantity("normal_stiffness", m.normal_stiffness, {.unit = "Pa/m", .shown = "GPa/m",
             .range = kPositive, .fallback = kRequired, .example = "20 GPa/m",
             .doc = "kn, normal stress per opening or closing."});
  v.quantity("shear_stiffness", m.shear_stiffness, {.unit = "Pa/m", .shown = "GPa/m",
             .range = kPositive, .fallback = kRequired, .example = "8 GPa/m",
             .doc = "ks, shear stress per slip."});
}

template <class Visitor>
void describe_strength(Visitor& v, JointMaterial& m) {
  v.quantity("tensile_strength", m.tensile_strength, {.unit = "Pa", .shown = "MPa",
             .range = kNotNegative, .fallback = kRequired, .example = "0.15 MPa",
             .doc = "ft, normal to the joint; 0 MPa for a dry joint."});
  v.quantity("cohesion", m.cohesion, {.unit = "Pa", .shown = "MPa", .range = kNotNegative,
             .fallback = kRequired, .example = "0.15 MPa",
             .doc = "c, shear strength at zero normal stress; 0 MPa for a dry joint."});
  v.quantity("friction_angle", m.friction_angle, {.unit = "rad", .shown = "deg",
             .range = kFrictionAngle, .fallback = kRequired, .example = "16.2 deg",
             .doc = "Friction angle of the intact joint."});
  describe_recipe(v, "friction_tan", {.range = kNotNegative, .fallback = "friction_angle", .example = "0.6",
                  .doc = "The same as a tangent: one of the two."});
  v.quantity("residual_friction_angle", m.residual_friction_angle, {.unit = "rad", .shown = "deg",
             .range = kFrictionAngle, .fallback = kRequired, .example = "14.6 deg",
             .doc = "Friction angle once the joint has broken."});
  describe_recipe(v, "residual_friction_tan", {.range = kNotNegative, .fallback = "residual_friction_angle",
                  .example = "0.55", .doc = "The same as a tangent: one of the two."});
  v.quantity("residual_cohesion", m.residual_cohesion, {.unit = "Pa", .shown = "MPa",
             .range = kNotNegative, .fallback = kRequired, .example = "0 MPa",
             .doc = "Cohesion left once the joint has broken."});
  v.quantity("compressive_strength", m.compressive_strength, {.unit = "Pa", .shown = "MPa",
             .range = kPositive, .may_be_unlimited = true, .fallback = kRequired,
             .example = "3.96 MPa",
             .doc = "fc of the masonry, modelled in the joint; \"unlimited\": no crushing."});
}

template <class Visitor>
void describe_fracture(Visitor& v, JointMaterial& m) {
  v.quantity("mode_1_energy", m.mode_1_energy, {.unit = "N/m", .shown = "N/m",
             .range = kNotNegative, .fallback = "needed where the joint has tensile strength",
             .example = "4.3 N/m",
             .doc = "GI, energy that breaks a unit area in tension: the area under the curve."});
  v.quantity("mode_2_energy", m.mode_2_energy, {.unit = "N/m", .shown = "N/m",
             .range = kNotNegative, .fallback = "needed where shear strength drops",
             .example = "125 N/m",
             .doc = "GII, energy to shear a unit area through, above the residual friction."});
  v.quantity("mode_2_energy_per_pressure", m.mode_2_energy_per_pressure, {.unit = "m", .shown = "mm",
             .range = kNotNegative, .fallback = "none", .example = "0.13 mm",
             .doc = "b: GII grows with the pressure on the joint, mode_2_energy + b sn (1 mm is 1 N/mm "
                    "per MPa). Without it GII is the same under every pressure."});
  v.quantity("compressive_energy", m.compressive_energy, {.unit = "N/m", .shown = "N/m",
             .range = kNotNegative, .fallback = "needed where fc is limited",
             .example = "12800 N/m",
             .doc = "Gc, energy to crush a unit area: the whole area under the curve."});
  v.number("compression_cap", m.compression_cap, {.range = kPositive, .fallback = "none",
           .example = "9",
           .doc = "Css of a cap in normal and shear stress, sigma^2 + Css tau^2 <= F^2: shear helps "
                  "to crush. Without it fc limits the normal stress alone."});
  v.quantity("hardening_displacement", m.hardening_displacement, {.unit = "m", .shown = "mm",
             .range = kPositive, .fallback = "none", .example = "0.09 mm",
             .doc = "kappa_p: plastic shortening over which the strength in crushing rises from "
                    "fc/3 to fc."});
  v.quantity("dilatancy_angle", m.dilatancy_angle, {.unit = "rad", .shown = "deg",
             .range = kFrictionAngle, .fallback = "none", .example = "5 deg",
             .doc = "psi: how much a closed joint opens while it slides, under no pressure; at "
                    "most the residual friction angle."});
  v.quantity("dilatancy_slip", m.dilatancy_slip, {.unit = "m", .shown = "mm", .range = kPositive,
             .fallback = "does not fade with slip", .example = "1 mm",
             .doc = "Slip over which dilatancy fades, along a straight line."});
  v.quantity("dilatancy_pressure", m.dilatancy_pressure, {.unit = "Pa", .shown = "MPa",
             .range = kPositive, .fallback = "does not fade with pressure", .example = "1 MPa",
             .doc = "Compression under which dilatancy is gone, along a straight line."});
  v.number("head_joint_bond", m.head_joint_bond, {.range = kZeroToOne, .fallback = "1: as the beds",
           .example = "0.25",
           .doc = "Share of tensile strength, cohesion and their energies that head joints have beside beds of this "
                  "material, where no `head_joint` names another; 0 is dry. Friction and stiffness are the beds'."});
  v.choice("softening", m.softening, kSofteningWords, {.example = "bilinear",
           .doc = "Shape of the falling branch in tension and shear; the energy stays the same."});
  v.choice("coupling", m.coupling, kCouplingWords, {.example = "union",
           .doc = "How damage in tension and in shear combine: d_t + d_s - d_t d_s, the larger, or "
                  "the loss of stiffness acting on shear."});
  v.choice("unloading", m.unloading, kUnloadingWords, {.example = "secant",
           .doc = "How an open joint closes: straight to the origin, or elastically to a set."});
}

template <class Visitor>
void describe(Visitor& v, JointMaterial& m) {
  describe_use(v);
  describe_recipe(v, "missing", {.fallback = "each is asked for", .example = "rule",
                  .doc = "`missing = \"rule\"`: every key of the joint law that is not here by its rule "
                         "(docs/theory/material_rules.md). A single key: `cohesion = \"rule\"`, or `\"rule: NAME\"`."});
  describe_elasticity(v, m);
  describe_strength(v, m);
  describe_fracture(v, m);
  v.quantity("density", m.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kNotNegative,
             .fallback = "needed for a lintel or a block", .example = "600 kg/m^3",
             .doc = "Density, for a material that is a body: a lintel, a plate, a block."});
  v.quantity("youngs_modulus", m.youngs_modulus, {.unit = "Pa", .shown = "GPa",
             .range = kPositive, .fallback = "needed for a lintel", .example = "10 GPa",
             .doc = "E along a lintel."});
  v.quantity("shear_modulus", m.shear_modulus, {.unit = "Pa", .shown = "GPa",
             .range = kPositive, .fallback = "needed for a lintel", .example = "0.6 GPa",
             .doc = "G of a lintel."});
  v.quantity("youngs_modulus_across", m.youngs_modulus_across, {.unit = "Pa", .shown = "GPa",
             .range = kPositive, .fallback = "isotropic", .example = "0.4 GPa",
             .doc = "E across the grain, of a lintel of zones."});
  v.number("poisson_ratio", m.poisson_ratio, {.range = kPoisson, .fallback = "E/2G - 1",
           .example = "0.4", .doc = "Strain across over strain along, of a lintel of zones; needed "
                                    "with youngs_modulus_across."});
  v.quantity("tension_limit", m.tension_limit, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .fallback = "none", .example = "20 MPa",
             .doc = "Principal tension of a zone beyond which the run reports it; no effect."});
  v.quantity("compression_limit", m.compression_limit, {.unit = "Pa", .shown = "MPa",
             .range = kPositive, .fallback = "none", .example = "20 MPa",
             .doc = "Principal compression of a zone beyond which the run reports it; no effect."});
  describe_origin(v, m.origin);
}

template <class Visitor>
void describe(Visitor& v, ContactRule& s) {
  v.texts("between", s.between, {.count = 2, .fallback = kRequired,
          .example = "[\"stone\", \"ground\"]",
          .doc = "Two block materials of a blocks file; `ground` is the support."});
  v.text("material", s.material, {.fallback = kRequired, .example = "joint",
         .doc = "Name of the joint material between them."});
}

// --- fields --------------------------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, FieldTie& s) {
  v.number("gaussian", s.gaussian, {.fallback = kRequired, .example = "0.5",
           .doc = "Correlation of the two at one place, of the Gaussian copula."});
}

template <class Visitor>
void describe(Visitor& v, FieldSpec& s) {
  v.text("path", s.path, {.fallback = kRequired, .example = "material.joint.cohesion",
         .doc = "What varies: a strength, energy, angle or stiffness of a joint material, or a density. "
                "Its value in the model is the mean."});
  v.text("formula", s.formula, {.fallback = "a scatter of its own", .example = "0.03 mm * ft",
         .doc = "Follows other fields of the same joints, place by place, in the place of a scatter."});
  v.choice("distribution", s.distribution, kDistributionWords, {.example = "lognormal",
           .doc = "Distribution at each place, with the mean of the key (not `empirical`)."});
  v.number("cov", s.cov, {.range = kNotNegative, .fallback = "required, or formula",
           .example = "0.3", .doc = "Coefficient of variation within the wall, before it is cut off."});
  v.number("low", s.low, {.fallback = "needed by beta", .example = "0.4",
           .doc = "Lower end of a beta distribution, as a multiple of the mean."});
  v.number("high", s.high, {.fallback = "needed by beta", .example = "2",
           .doc = "Upper end of a beta distribution, as a multiple of the mean."});
  v.number("lower", s.lower, {.fallback = "none", .example = "0.2",
           .doc = "Cuts off what is below this multiple of the mean; the mean is kept."});
  v.number("upper", s.upper, {.fallback = "none", .example = "3",
           .doc = "Cuts off what is above this multiple of the mean; the mean is kept."});
  v.choice("by", s.by, kFieldByWords, {.example = "unit",
           .doc = "What has one value of its own: each place, correlated with others over `along` and "
                  "`across`; each course; each unit, with the joints below and left of it; each joint."});
  v.choice("kernel", s.kernel, kFieldKernelWords, {.example = "exponential",
           .doc = "How correlation fades with distance, along and across multiplied: exp(-d/length), or "
                  "exp(-(d/length)^2)."});
  v.quantity("along", s.along, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "required with by = place", .example = "1 m",
             .doc = "Correlation length along the courses: there 1/e is left."});
  v.quantity("across", s.across, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "required with by = place", .example = "0.3 m",
             .doc = "Correlation length across the courses."});
  v.map("correlation", s.correlation, {.doc = "Correlation with other fields, by their name, "
        "e.g. `correlation.ft.gaussian = 0.5`; at one of the two."});
  v.integer("seed", s.seed, {.range = kFromZero, .example = "1",
            .doc = "Which of all walls with this field; a study gives each sample its own."});
  v.flag("in_place", s.in_place, {.example = "true",
         .doc = "Draws by where each unit, joint or course stands and not by its number in the wall, so that a wall "
                "with another opening has the same ones elsewhere. Not with by = place."});
}

template <class Visitor>
void describe(Visitor& v, ScatterSpec& s) {
  v.text("use", s.use, {.fallback = "the numbers below", .example = "clay_brick",
         .doc = "Kind of masonry whose tests say how much it scatters: clay_brick, calcium_silicate, stone, tuff."});
  v.number("joint_tension", s.joint_tension, {.range = kNotNegative, .fallback = "of `use`", .example = "0.3",
           .doc = "Coefficient of variation of the joints' tensile strength, from unit to unit (Weibull); GI follows."});
  v.number("joint_cohesion", s.joint_cohesion, {.range = kNotNegative, .fallback = "of `use`", .example = "0.25",
           .doc = "The same of their cohesion (lognormal), tied to the tensile strength; GII and residual cohesion follow."});
  v.number("unit_tension", s.unit_tension, {.range = kNotNegative, .fallback = "of `use`", .example = "0.2",
           .doc = "The same of the units' tensile strength (lognormal); their cohesion and energies follow."});
  v.text("joint", s.joint, {.example = "joint", .doc = "Name of the joints' material."});
  v.text("unit", s.unit, {.example = "unit", .doc = "Name of the material of crack planes in units."});
  v.choice("by", s.by, kFieldByWords, {.example = "unit",
           .doc = "What has one value of its own: the bed of each `unit`, each `joint`, each `course` (not `place`)."});
  v.integer("seed", s.seed, {.range = kFromZero, .example = "1",
            .doc = "Which of all walls; `wythe run --walls` and studies give each its own."});
}

// --- stages --------------------------------------------------------------------------------------

template <class Visitor>
void describe_load(Visitor& v, StageRecords& r) {
  v.quantity("pier_load", r.load.pier_load, {.unit = "N", .shown = "kN", .range = kNotNegative,
             .kinds = kLoadStage, .fallback = "one of the loads, or floors", .example = "200 kN",
             .doc = "Vertical load on the top of each pier, downwards."});
  v.quantity("pressure", r.load.pressure, {.unit = "Pa", .shown = "MPa", .range = kNotNegative,
             .kinds = kLoadStage, .fallback = "one of the loads, or floors", .example = "0.3 MPa",
             .doc = "Vertical pressure on the whole wall top, downwards. In space on all faces that look towards `face` and have "
                    "nothing before them: a window sill has its head before it. With `on` all free faces of the blocks there."});
  v.quantity("beam_load", r.load.beam_load, {.unit = "N", .shown = "kN", .range = kNotNegative,
             .kinds = kLoadStage, .fallback = "one of the loads, or floors", .example = "100 kN",
             .doc = "Vertical load on the centre of the loading beam, downwards."});
  v.flag("floors", r.load.floors, {.kinds = kLoadStage, .example = "true",
         .doc = "Sets every `[[floor]]` on the wall, in the place of a load. Without such a stage the "
                "first gravity stage does."});
  v.choice("as", r.push.as, kMannerWords, {.kinds = kLoadStage | kPushStage,
           .fallback = "pressure (load), spreader (push)", .example = "plate",
           .doc = "A load acts as a uniform pressure or through a free stiff plate; a push moves "
                  "its blocks through a spreader (equal forces, mean path) or each the same way."});
  v.text("plate_joint", r.load.plate_joint, {.kinds = kLoadStage, .example = "foundation",
         .doc = "Name of the joint material under a plate."});
}

template <class Visitor>
void describe_push(Visitor& v, PushStage& s) {
  v.table("at", s.at, {.kinds = kPushStage | kLoadStage, .in_braces = true, .optional = true,
          .fallback = "required, or pattern; of a load needed by force",
          .example = "{ x = \"0 m\", y = \"3.12 m\", courses = 3 }",
          .doc = "The blocks that are pushed: a point, a box, one block or the beam. In space: where a force acts."});
  v.choice("pattern", s.pattern, kPatternWords, {.kinds = kPushStage, .fallback = "none: pushes `at`",
           .example = "mass_height",
           .doc = "Forces at several places in fixed shares, in the place of `at`. At `levels`: "
                  "`given` by `shares`; `uniform`, by the mass nearest to each level; "
                  "`mass_height`, by that mass times its height. `mass`: on every block by its own "
                  "mass, as a body force, but by displacement, so that the falling branch is "
                  "followed. Masses include those of loads before the push, not of the ground's "
                  "half storey."});
  v.quantities("levels", s.levels, {.unit = "m", .shown = "m", .range = kLength,
               .kinds = kPushStage, .fallback = "needed by every pattern but mass",
               .example = "[\"3.0 m\", \"6.2 m\"]",
               .doc = "Heights of the levels above the wall's lowest point: the course that "
                      "holds the height is pushed along its whole length, each block by its "
                      "mass."});
  v.numbers("shares", s.shares, {.kinds = kPushStage, .fallback = "needed by pattern given",
            .example = "[0.35, 0.65]", .doc = "Share of the force at each level, in their order."});
  v.table("control", s.control, {.kinds = kPushStage, .in_braces = true, .optional = true,
          .fallback = "the mean of what is pushed, weighted by the shares",
          .example = "{ x = \"0 m\", y = \"6.2 m\" }",
          .doc = "A point (the block there) whose displacement the rows tell and `until` is of. "
                 "`velocity` stays that of the weighted mean, which the forces work on."});
  v.number("contraflexure", s.contraflexure, {.range = kContraflexure, .kinds = kPushStage,
           .fallback = "none: pushed through its centroid", .example = "0.75",
           .doc = "H0 over the wall's height: where above its foot the moment is nil. 0.5: both ends "
                  "held against turning, in effect; 1: a cantilever. The push acts on an arm of the "
                  "one block that `at` names, e.g. { beam = true }; the rows tell that block's "
                  "displacement."});
  v.choice("direction", s.drive.direction, kDirectionWords, {.kinds = kDirectedStage, .example = "+x",
           .doc = "Which way the wall is pushed or tilted; +x is to the right, +y upwards."});
  v.quantity("velocity", s.velocity, {.unit = "m/s", .shown = "mm/s", .range = kSpeed,
             .kinds = kPushStage, .fallback = "adapts: 0.1 mm/s, and 5 mm/s near balance", .example = "10 mm/s",
             .doc = "Velocity of the push, throughout where `fast_velocity` is not given. Left out, the push waits at "
                    "each crack (docs/theory/integration.md, \"Faster while in balance\")."});
  v.quantity("fast_velocity", s.fast_velocity, {.unit = "m/s", .shown = "mm/s",
             .range = kSpeed, .kinds = kPushStage, .fallback = "velocity throughout, or 5 mm/s without it",
             .example = "40 mm/s",
             .doc = "Velocity while the wall is near balance; `velocity` while it cracks."});
  v.number("fast_below", s.fast_below, {.range = kPositive, .kinds = kPushStage,
           .fallback = "1e-4", .example = "2e-4",
           .doc = "Unbalance ratio below which the push goes at `fast_velocity`; above twice this "
                  "it goes at `velocity`."});
  v.quantity("until", s.until, {.unit = "m", .shown = "mm", .range = kLength,
             .kinds = kPushStage, .fallback = "required, or targets, amplitudes or drifts", .example = "50 mm",
             .doc = "Displacement at which the push ends."});
  v.quantities("targets", s.targets, {.unit = "m", .shown = "mm", .range = kCoordinate,
               .kinds = kPushStage,
               .fallback = "none", .example = "[\"2 mm\", \"-2 mm\", \"4 mm\"]",
               .doc = "Cyclic push: displacements along `direction`, one after the other."});
  v.quantities("amplitudes", s.amplitudes, {.unit = "m", .shown = "mm", .range = kLength, .kinds = kPushStage,
               .fallback = "none", .example = "[\"2 mm\", \"4 mm\", \"8 mm\"]",
               .doc = "Cyclic push by a protocol: how far each level goes, to both sides, first along `direction`. The levels "
                      "grow, and the push ends at zero."});
  v.quantities("drifts", s.drifts, {.unit = "1", .shown = "%", .range = kPositive, .kinds = kPushStage,
               .fallback = "none", .example = "[\"0.05 %\", \"0.1 %\", \"0.2 %\"]",
               .doc = "The same as drifts: of the height of the rows' `drift_percent`, from the wall's foot to the middle of "
                      "what is pushed."});
  v.numbers("cycles", s.cycles, {.range = kFromOne, .may_be_alone = true, .kinds = kPushStage, .fallback = "1", .example = "2",
            .doc = "How many cycles each level of `amplitudes` or `drifts` has: one number, or a list with one a level."});
  v.number("stop_below", s.stop_below, {.range = kBelowOne, .kinds = kPushStage,
           .example = "0.2",
           .doc = "End when the reaction has stayed below this share of its peak over a tenth of the displacement; 0: never."});
  v.choice("rotation", s.fixity.rotation, kFreedomWords, {.kinds = kPushStage | kShakeStage, .example = "blocked",
           .doc = "Whether the pushed blocks, or those with a record of their own, may turn."});
  v.choice("across", s.fixity.across, kFreedomWords, {.kinds = kPushStage | kShakeStage, .example = "blocked",
           .doc = "Whether they may move across the push, or across their record."});
}

template <class Visitor>
void describe_other_drives(Visitor& v, StageRecords& r) {
  v.quantity("rate", r.body_force.rate, {.unit = "1/s", .shown = "1/s", .range = kPositive,
             .kinds = kBodyForceStage, .fallback = kRequired, .example = "0.05 1/s",
             .doc = "Growth of the factor lambda; every block carries lambda times its weight."});
  v.number("factor", r.body_force.factor, {.range = kPositive, .kinds = kBodyForceStage,
           .fallback = kRequired, .example = "0.5", .doc = "Largest lambda."});
  v.quantity("tilt_rate", r.tilt.tilt_rate, {.unit = "rad/s", .shown = "deg/s", .range = kPositive,
             .kinds = kTiltStage, .fallback = kRequired, .example = "1 deg/s",
             .doc = "Speed at which the ground tilts."});
  v.quantity("tilt_until", r.tilt.tilt_until, {.unit = "rad", .shown = "deg", .range = kTiltAngle,
             .kinds = kTiltStage, .fallback = kRequired, .example = "30 deg",
             .doc = "Tilt at which the stage ends."});
  v.quantity("duration", r.hold.duration, {.unit = "s", .shown = "s", .range = kPositive,
             .kinds = kHoldStage, .fallback = kRequired, .example = "1 s",
             .doc = "How long loads and pushed blocks are held."});
  v.flag("release", r.hold.release, {.kinds = kHoldStage, .example = "true",
         .doc = "Lets go of the blocks that a push before it moved; loads stay."});
}

template <class Visitor>
void describe(Visitor& v, StageSpec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "push",
         .doc = "Its name, different from the other stages'; `--set stage.push.velocity=...` "
                "finds it by this."});
  StageKind kind = s.kind();
  v.choice("kind", kind, kStageKindWords, {.fallback = "follows from the other keys",
           .example = "push", .doc = "What the stage does; a stage named gravity is one. `cut`: takes the masonry out of the openings that name it (`wall.opening.cut`) and puts up the frames that do (`frame.stage`), which fades in over the ramp."});
  v.quantity("ramp", s.ramp, {.unit = "s", .shown = "s", .range = kNotNegative,
             .kinds = kRampedStage, .fallback = "push: 8 first periods of the wall; 0.1 s otherwise",
             .example = "0.1 s", .doc = "Duration of the smooth start."});
  v.number("damping", s.damping, {.range = kBelowOne, .fallback = "solve.damping; 0 in a shake",
           .example = "0.8", .doc = "Local damping in this stage."});
  StageRecords records(s.action);
  describe_load(v, records);
  describe_push(v, records.push);
  describe_other_drives(v, records);
  describe_space(v, records, kDirectedStage, kLoadStage);
  describe_shaking(v, records.shake, kShakeStage);
  if constexpr (requires { v.kind_by_keys(kind); }) kind = v.kind_by_keys(kind);
  s.action = records.of(kind);
}

// --- settings ------------------------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, SolveSpec& s) {
  v.choice("point_rule", s.point_rule, kPointRuleWords,
           {.fallback = "lobatto; with points_per_face alone, 2 are corners and more a trapezoid",
            .example = "corners",
            .doc = "Where the contact points of a joint stand and what area each takes. `corners`: "
                   "its two ends, half the area each, as in block codes; a joint is then three "
                   "times stiffer in rotation than a continuous one. `trapezoid`: at equal "
                   "distances. `lobatto` and `gauss` integrate the stresses over the joint "
                   "exactly while it is elastic; `lobatto` has points at both ends, `gauss` has "
                   "none there."});
  v.integer("points_per_face", s.points_per_face, {.range = {.low = 2, .high = 16},
            .fallback = "3 (corners: 2)", .example = "3",
            .doc = "Contact points along a joint. Without `point_rule`, 2 stand at the corners "
                   "and more follow the trapezoidal rule, as in older files."});
  v.number("step_fraction", s.step_fraction, {.range = kPositiveToOne, .example = "0.95",
           .doc = "Time step as a share of the longest stable one, 2 / (omega_max sqrt(1 + "
                  "damping)) with each stage's own damping and a bound on omega_max that is on "
                  "the safe side."});
  v.number("damping", s.damping, {.range = kBelowOne, .example = "0.8",
           .doc = "Local damping: this share of the unbalanced force opposes the motion."});
  describe_space(v, s);
  v.quantity("gravity", s.gravity, {.unit = "m/s^2", .shown = "m/s^2", .range = kNotNegative,
             .example = "9.81 m/s^2", .doc = "Acceleration of gravity, downwards."});
  v.number("settle_ratio", s.settle_ratio, {.range = kPositive, .example = "1e-5",
           .doc = "A stage has settled when unbalanced over contact forces fall below this."});
  v.quantity("settle_limit", s.settle_limit, {.unit = "s", .shown = "s", .range = kPositive,
             .example = "20 s", .doc = "Time after which a stage ends as not_settled."});
  v.number("mass_scaling", s.mass_scaling, {.range = kFromOne, .example = "1",
           .doc = "Scaling of the inertia in the gravity and load stages before the first push."});
  v.flag("raise_light_inertia", s.raise_light_inertia, {.example = "true",
         .doc = "Lintels, plates and beams whose own stable step is shorter than the masonry's get "
                "more inertia, but not weight, until it is as long; a note says how much. In "
                "space nodes of zones gain at most 3 % of the wall's mass; beyond that the step is shorter."});
  v.quantity("collapse_displacement", s.collapse_displacement, {.unit = "m", .shown = "mm",
             .range = kPositive, .may_be_unlimited = true,
             .fallback = "the smallest block height; with free contacts the run goes on",
             .example = "110 mm",
             .doc = "Collapse: a block has moved this far beyond the push; \"unlimited\": however far."});
  v.choice("contacts", s.contacts, kContactsWords, {.example = "free",
           .doc = "`joints`: blocks touch where their faces touched at the start, and nowhere else; enough "
                  "up to the peak and some way beyond. `free`: new contacts are found as blocks move, and "
                  "joints that are broken and displaced give way to them; for collapse and debris "
                  "(docs/theory/contacts.md). Costs more time a step."});
  v.quantity("ground", s.ground, {.unit = "m", .shown = "m", .range = kCoordinate,
             .fallback = "the foot of a built wall; none below bodies of a file",
             .example = "0 m", .doc = "Height of level ground on which blocks land; for free contacts."});
}

template <class Visitor>
void describe(Visitor& v, OutputSpec& s) {
  v.integer("rows", s.rows, {.range = {.low = 10, .high = 1e6}, .example = "500",
            .doc = "Rows of force_displacement.csv."});
  v.quantity("window", s.window, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "one row", .example = "0.1 mm",
             .doc = "Displacement over which forces are averaged."});
  v.quantities("states", s.states, {.unit = "m", .shown = "mm", .range = kCoordinate,
               .fallback = "none",
               .example = "[\"10 mm\", \"20 mm\"]",
               .doc = "Displacements at which a state is written for ParaView, besides start, "
                      "peak and end."});
}

// Tables that become bodies when the file is read (model_file.cpp). Visitors of values ignore them.
template <class Visitor>
void describe_built(Visitor& v) {
  BuilderSpec built;
  if constexpr (requires { v.recipe("", Key{}); }) describe(v, built);
}

template <class Visitor>
void describe(Visitor& v, ModelSpec& s) {
  v.text("name", s.name, {.fallback = "none", .example = "tuff wall",
         .doc = "Title of the report."});
  v.text("note", s.note, {.fallback = "none", .example = "Table 1 of the paper",
         .doc = "Remarks."});
  v.table("project", s.project, {.optional = true, .doc = "Heads of the sheet that is handed over."});
  v.table("wall", s.wall, {.doc = "The wall: sizes along x (to the right) and y (upwards)."});
  v.list("storey", s.storey, {.doc = "The storeys of a building from the ground up, one on the other. What one leaves "
         "out is the wall's. In space name and height alone: levels whose drifts are read."});
  v.list("region", s.region, {.doc = "Parts of the masonry with other materials. A block belongs to the last region that "
         "holds its centre. A joint belongs to a region where both its blocks do, else to what is listed "
         "before it and around it."});
  describe_built(v);
  v.list("ring_beam", s.ring_beam, {.optional = true,
         .doc = "Beams within the masonry, elastic chains along a level (docs/theory/ring_beams.md)."});
  v.list("frame", s.frame, {.optional = true,
         .doc = "Frames of columns and beams, elastic and yielding, round an opening or free (docs/theory/frames.md)."});
  v.list("layer", s.layer, {.optional = true,
         .doc = "Fibres in mortar on the faces of the masonry: reinforced plaster, textile mortars, nets "
                "(docs/theory/layers.md)."});
  v.list("floor", s.floor, {.optional = true,
         .doc = "Floors and roofs that lie on the wall, one table each: weight at their level."});
  v.list("tie", s.tie, {.optional = true, .doc = "Bars that only pull (docs/theory/links.md)."});
  v.list("diaphragm", s.diaphragm, {.optional = true,
         .doc = "What a floor does for points of the wall in its plane: it keeps their distances."});
  v.list("spring", s.spring, {.optional = true,
         .doc = "Walls across and neighbours: a point held by the ground, along one direction."});
  v.table("masonry", s.masonry, {.optional = true,
          .doc = "What tests say, mean values: the inputs of rules (docs/theory/material_rules.md), which a "
                 "material asks for by `\"rule\"` in the place of a value. No effect but through them. Any of "
                 "these may itself be `\"rule\"`."});
  v.map("material", s.material, {.doc = "One table for each material. Joints use `joint` (bed and "
        "head joints), `unit` (the crack plane inside a unit), `foundation`, and the names "
        "given elsewhere; bodies (lintels, blocks) need density and moduli only."});
  v.table("scatter", s.scatter, {.optional = true,
          .doc = "How much joints and units differ within the wall: fields made by the kind of masonry "
                 "(docs/theory/fields.md)."});
  v.map("field", s.field, {.doc = "One table for each property that differs from place to place "
        "(docs/theory/fields.md)."});
  v.list("contact", s.contact, {.doc = "For blocks files: the joint between two kinds of block."});
  v.list("stage", s.stage, {.doc = "What is done to the wall, stage after stage. At least one."});
  v.list("history", s.history, {.optional = true,
         .doc = "Points whose motion a shake tells, in `history.csv` and the summary; the first is its control "
                "point. Without any, the highest block."});
  v.table("solve", s.solve, {.doc = "Numerical settings; the defaults suit a push-over."});
  v.table("assessment", s.assessment, {.optional = true,
          .doc = "What a code asks of the wall, and what it has (docs/theory/assessment.md)."});
  v.table("output", s.output, {.doc = "What is written."});
}

// clang-format on

}  // namespace wythe::io
