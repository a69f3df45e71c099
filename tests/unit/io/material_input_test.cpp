// Materials by rule and by typology: the requests of a file, the resulting values, and the messages.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "io/keys/same_spec.h"
#include "unit/io_helpers.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"
#include "wythe/parts/study.h"
#include "wythe/parts/study_notes.h"

namespace wythe::io_tests::material_input_test {
namespace {

// A wall whose joints come by rule from tests, with a crack plane in its units. Line numbers count from here.
const std::string kRules = R"([wall]
length = "1.5 m"
height = "1.29 m"
thickness = "0.38 m"
[wall.unit]
length = "250 mm"
height = "64.5 mm"
density = "1800 kg/m^3"
[masonry]
unit_type = "clay"
unit_strength = "14.92 MPa"
masonry_strength = "7.92 MPa"
youngs_modulus = "2991 MPa"
shear_modulus = "rule"
unit_youngs_modulus = "rule"
initial_shear_strength = "0.21 MPa"
friction_tan = 0.7
vertical_stress = "1.2 MPa"
[material.joint]
missing = "rule"
[material.unit]
missing = "rule"
tensile_strength = "rule: unit_ft_from_fb"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = { x = "0 m", y = "1.2 m" }
velocity = "10 mm/s"
until = "1 mm"
)";

ModelSpec read(const std::string& text, const Texts& overrides = {}) {
  return parse_model(text, "model.toml", overrides);
}

std::string faults(const std::string& text, const Texts& overrides = {}) {
  return joined(faults_of(text, overrides), "\n");
}

std::string line_of(const std::vector<std::string>& origin, const std::string& key) {
  for (const std::string& line : origin)
    if (line.starts_with(key + ' ')) return line;
  return "";
}

// Derived values are written with six digits.
void expect_near(double found, double by_hand) {
  EXPECT_NEAR(found, by_hand, 2e-5 * std::fabs(by_hand));
}

std::string study_of(const std::string& path, const std::string& mean) {
  return "[study]\nmodel = \"rules.toml\"\nsamples = 4\nseed = 1\n[variable.x]\npath = \"" + path +
         "\"\ndistribution = \"lognormal\"\nmean = \"" + mean + "\"\ncov = 0.2\n";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MaterialInput, a_law_by_rule_has_the_numbers_worked_out_by_hand) {
  const ModelSpec spec = read(kRules);
  const JointMaterial& joint = spec.material.at("joint");
  expect_near(joint.normal_stiffness, 2991e6 / 0.0645);
  expect_near(joint.shear_stiffness, 0.4 * 2991e6 / 0.0645);
  expect_near(joint.cohesion, 0.21e6);
  expect_near(joint.tensile_strength, 0.21e6 / 2.76);
  expect_near(std::tan(joint.friction_angle), 0.7);
  expect_near(std::tan(joint.residual_friction_angle), 0.7);
  EXPECT_EQ(joint.residual_cohesion, 0);
  expect_near(joint.mode_1_energy, 0.029e-3 * 0.21e6 / 2.76);
  expect_near(joint.mode_2_energy, 0.093e-3 * 0.21e6);
  expect_near(joint.compressive_strength, 7.92e6);
  expect_near(joint.compressive_energy, 1.6e-3 * 7.92e6);
  const JointMaterial& unit = spec.material.at("unit");
  const double ft = 0.040 * 14.92e6 * std::pow(1 - 1.2 / 14.92, 1 / 0.58);
  expect_near(unit.tensile_strength, ft);
  expect_near(unit.cohesion, std::sqrt(ft * (ft + 1.2e6)));
  expect_near(unit.normal_stiffness, 300 * 14.92e6 / 0.125);
  expect_near(unit.mode_2_energy, 10 * unit.mode_1_energy);
  expect_near(spec.masonry.shear_modulus, 0.4 * 2991e6);
}

TEST(MaterialInput, every_value_that_was_not_given_says_whence_it_comes) {
  const ModelSpec spec = read(kRules);
  const std::vector<std::string>& origin = spec.material.at("unit").origin;
  EXPECT_EQ(origin.size(), 11U);
  const std::string ft = line_of(origin, "tensile_strength");
  EXPECT_TRUE(
      says(ft,
           ": derived by unit_ft_from_fb from unit_strength 14.92 MPa, vertical_stress 1.2 MPa, "
           "unit_type clay"))
      << ft;
  const std::string kn = line_of(spec.material.at("joint").origin, "normal_stiffness");
  EXPECT_TRUE(says(kn,
                   "derived by kn_from_e from youngs_modulus 2.991 GPa, course_height 64.5 mm "
                   "(wall.unit.height)"))
      << kn;
  EXPECT_EQ(spec.masonry.origin.size(), 2U);
}

TEST(MaterialInput, nothing_is_derived_that_is_not_asked_for) {
  const std::string said = faults(with(kRules, "[material.joint]\nmissing = \"rule\"\n",
                                       "[material.joint]\ncohesion = \"rule\"\n"));
  EXPECT_TRUE(says(said, "material.joint: lacks normal_stiffness, ")) << said;
  EXPECT_TRUE(says(said, "ask for rules, missing = \"rule\"")) << said;
  EXPECT_TRUE(says(said, "use = \"NAME\"")) << said;
  EXPECT_FALSE(says(said, "material.joint.cohesion")) << said;
}

TEST(MaterialInput, a_rule_names_the_inputs_it_lacks) {
  const std::string said = faults(with(kRules, "vertical_stress = \"1.2 MPa\"\n", ""));
  EXPECT_TRUE(says(said,
                   "model.toml:22: material.unit.tensile_strength = rule: unit_ft_from_fb: the "
                   "rule unit_ft_from_fb needs vertical_stress; give vertical_stress under "
                   "[masonry], give tensile_strength itself, or a typology"))
      << said;
  EXPECT_FALSE(says(said, "mode_1_energy")) << said;  // follows from that
  const std::string kind = faults(with(kRules, "unit_type = \"clay\"\n", ""));
  EXPECT_TRUE(says(kind, "needs unit_type")) << kind;
}

TEST(MaterialInput, a_rule_outside_its_range_is_refused_where_it_stands) {
  const std::string said =
      faults(with(kRules, "unit_strength = \"14.92 MPa\"", "unit_strength = \"150 MPa\""));
  EXPECT_TRUE(says(said,
                   "the rule unit_ft_from_fb holds for unit_strength from 2 MPa to 100 MPa, "
                   "unit_e_from_fb (for unit_youngs_modulus) from 5 MPa to 100 MPa, here it is 150 "
                   "MPa; check unit_strength, or give tensile_strength, unit_youngs_modulus "
                   "themselves"))
      << said;
  const std::string ratio =
      faults(with(kRules, "vertical_stress = \"1.2 MPa\"", "vertical_stress = \"9 MPa\""));
  EXPECT_TRUE(says(ratio, "vertical_stress / unit_strength from 0 to 0.5, here it is 0.6032"))
      << ratio;
  const std::string kind = faults(with(kRules, "\"clay\"", "\"tuff\""));
  EXPECT_TRUE(says(kind, "was not tested for units of tuff")) << kind;
}

TEST(MaterialInput, what_never_crushes_needs_no_energy) {
  const ModelSpec spec = parse_model(
      with(kRules, "[material.joint]\nmissing = \"rule\"\n",
           "[material.joint]\nmissing = \"rule\"\ncompressive_strength = \"unlimited\"\n"),
      "model.toml");
  EXPECT_TRUE(std::isinf(spec.material.at("joint").compressive_strength));
  EXPECT_TRUE(std::isnan(spec.material.at("joint").compressive_energy));
}

TEST(MaterialInput, an_unknown_rule_is_answered_with_those_there_are) {
  const std::string said = faults(with(kRules, "rule: unit_ft_from_fb", "rule: from_fb"));
  EXPECT_TRUE(says(said, "no such rule for it; write \"rule\", or one of: rule: unit_ft_from_fb"))
      << said;
  EXPECT_TRUE(says(faults(kRules + "[material.lintel]\ndensity = \"rule\"\n"),
                   "material.lintel.density = rule: there is no rule for it"));
}

// ft 2 MPa and 5 GPa/m: 0.058 kN/m by index against ft^2/(2 kn) = 0.4 kN/m.
TEST(MaterialInput, a_derived_energy_that_snaps_back_is_refused_with_its_numbers_and_its_rule) {
  const std::string said = faults(
      with(kRules, "tensile_strength = \"rule: unit_ft_from_fb\"",
           "tensile_strength = \"2 MPa\"\nnormal_stiffness = \"5 GPa/m\"\nmode_1_energy = \"rule: "
           "unit_gi_by_index\""));
  EXPECT_TRUE(says(said,
                   "model.toml:25: material.unit.mode_1_energy = 58 N/m (derived by "
                   "unit_gi_by_index from tensile_strength 2 MPa): gives snap-back"))
      << said;
  EXPECT_TRUE(says(said, "above 400 N/m")) << said;
}

TEST(MaterialInput, friction_is_an_angle_or_a_tangent) {
  const std::string tangent =
      with(kRules, "[material.joint]\n", "[material.joint]\nfriction_tan = 0.6\n");
  const JointMaterial joint = read(tangent).material.at("joint");
  EXPECT_NEAR(std::tan(joint.friction_angle), 0.6, 1e-12);
  EXPECT_TRUE(says(line_of(joint.origin, "friction_angle"), ": given as friction_tan 0.6"));
  const std::string both = faults(
      with(tangent, "friction_tan = 0.6", "friction_tan = 0.6\nfriction_angle = \"30 deg\""));
  EXPECT_TRUE(says(both,
                   "model.toml:20: material.joint.friction_tan = 0.6: stands beside "
                   "friction_angle; leave one of the two"))
      << both;
  EXPECT_TRUE(says(faults(with(tangent, "0.6", "\"31 deg\"")), "must be a number"));
  EXPECT_TRUE(says(faults(tangent, {"material.joint.friction_tan=-1"}), "at least 0"));
  EXPECT_NEAR(
      std::tan(
          read(tangent, {"material.joint.friction_tan=0.5"}).material.at("joint").friction_angle),
      0.5, 1e-12);
}

const std::string kTypical =
    with(with(kRules,
              kRules.substr(kRules.find("[masonry]"),
                            kRules.find("[material.joint]") - kRules.find("[masonry]")),
              ""),
         kRules.substr(kRules.find("[material.joint]"),
                       kRules.find("[[stage]]") - kRules.find("[material.joint]")),
         R"([material.joint]
use = "tuff_pozzolanic"
[material.unit]
use = "tuff_pozzolanic"
cohesion = "0.345 MPa"
)");

TEST(MaterialInput, use_takes_typical_values_for_what_is_not_given) {
  const ModelSpec spec = read(kTypical);
  const JointMaterial &joint = spec.material.at("joint"), &unit = spec.material.at("unit");
  expect_near(joint.cohesion, 0.15e6);
  expect_near(joint.friction_angle * 180 / M_PI, 16.2);
  expect_near(unit.tensile_strength, 0.23e6);
  expect_near(unit.cohesion, 0.345e6);
  EXPECT_EQ(line_of(unit.origin, "cohesion"), "");
  EXPECT_EQ(
      line_of(joint.origin, "tensile_strength"),
      "tensile_strength 0.15 MPa: typical of tuff_pozzolanic (Pulatsu et al. 2022, Tables 1 and 2, "
      "tests of Augenti and Parisi, CoV 0.30)");
}

TEST(MaterialInput, what_tests_give_comes_before_what_is_typical) {
  const std::string text =
      with(with(kTypical, "use = \"tuff_pozzolanic\"\n[material.unit]",
                "use = \"circolare_brick_lime\"\nmissing = \"rule\"\n[material.unit]"),
           "[material.joint]", "[masonry]\nmasonry_strength = \"5 MPa\"\n[material.joint]");
  const JointMaterial joint = read(text).material.at("joint");
  expect_near(joint.compressive_strength, 5e6);
  expect_near(joint.cohesion, 0.20e6);
  const std::string cohesion = line_of(joint.origin, "cohesion");
  EXPECT_TRUE(says(cohesion,
                   "derived by c_from_fv0 from initial_shear_strength 0.2 MPa (typical of "
                   "circolare_brick_lime)"))
      << cohesion;
}

TEST(MaterialInput, a_typology_that_leaves_something_out_is_not_filled_up) {
  const std::string said = faults(with(kTypical, "use = \"tuff_pozzolanic\"\n[material.unit]",
                                       "use = \"circolare_brick_lime\"\n[material.unit]"));
  EXPECT_TRUE(says(said,
                   "material.joint: lacks normal_stiffness, shear_stiffness, "
                   "tensile_strength, "))
      << said;
  EXPECT_FALSE(says(said, " cohesion, ")) << said;
  EXPECT_TRUE(says(
      faults(with(kTypical, "use = \"tuff_pozzolanic\"\ncohesion", "use = \"en1996_clay_m5\"\n#")),
      "en1996_clay_m5 says nothing of this"));
}

TEST(MaterialInput, an_unknown_or_ambiguous_typology_is_answered_with_names) {
  const auto said = [&](const std::string& name) {
    return faults(with(kTypical, "use = \"tuff_pozzolanic\"\n[material.unit]",
                       "use = \"" + name + "\"\n[material.unit]"));
  };
  EXPECT_TRUE(says(said("tuff_pozolanic"), "no such material; did you mean tuff_pozzolanic?"));
  EXPECT_TRUE(says(said("granite"),
                   "is the name of several materials; write one of: granite_dry, granite_lime"));
  EXPECT_TRUE(says(said("limestone"), "did you mean limestone_dry?"));
  EXPECT_TRUE(says(said(""), "no such material; known here:"));
}

TEST(MaterialInput, masonry_may_take_a_typology_and_its_kind_of_unit) {
  const std::string text = with(kTypical, "[material.joint]\nuse = \"tuff_pozzolanic\"",
                                "[masonry]\nuse = \"clay_brick_old\"\nvertical_stress = \"0 MPa\"\n"
                                "shear_modulus = \"rule\"\n[material.joint]\nmissing = \"rule\"");
  const ModelSpec spec = read(text);
  expect_near(spec.material.at("joint").cohesion, 0.21e6);
  expect_near(spec.masonry.unit_strength, 14.92e6);
  EXPECT_EQ(spec.masonry.unit_type, UnitType::kClay);
  EXPECT_TRUE(says(line_of(spec.masonry.origin, "masonry_strength"), "typical of clay_brick_old"));
}

// --- settings and written models ------------------------------------------------------------------

TEST(MaterialInput, a_setting_of_an_input_moves_what_is_derived_from_it) {
  const ModelSpec spec = read(kRules, {"masonry.masonry_strength=5 MPa"});
  expect_near(spec.material.at("joint").compressive_energy, 1.6e-3 * 5e6);
  const ModelSpec direct = read(kRules, {"material.unit.tensile_strength=0.4 MPa"});
  expect_near(direct.material.at("unit").mode_1_energy, 25 * std::pow(0.8, 0.7));
}

TEST(MaterialInput, a_setting_that_no_rule_takes_is_refused) {
  const std::string said = faults(kRules, {"masonry.mortar_strength=5 MPa"});
  EXPECT_TRUE(says(said, "--set: masonry.mortar_strength")) << said;
  EXPECT_TRUE(says(said, "has no effect: no rule of this model asks for it")) << said;
}

TEST(MaterialInput, a_written_model_reads_back_to_the_same_bits_and_origins) {
  const std::string code =
      with(kTypical, "use = \"tuff_pozzolanic\"\n[material.unit]",
           "use = \"circolare_brick_lime\"\nmissing = \"rule\"\nnormal_stiffness = \"20 "
           "GPa/m\"\n[material.unit]");
  for (const std::string& text : {kRules, kTypical, code}) {
    const ModelSpec spec = read(text);
    const std::string written = write_model(spec);
    ModelSpec again = read(written);
    EXPECT_EQ(io::first_difference(spec, again), "") << written;
    EXPECT_EQ(write_model(again), written);
    EXPECT_FALSE(again.material.at("unit").origin.empty());
  }
}

TEST(MaterialInput, an_origin_holds_only_for_the_value_it_names) {
  const std::string written = write_model(read(kRules));
  const JointMaterial changed =
      read(written, {"material.unit.mode_1_energy=30 N/m", "material.unit.mode_2_energy=300 N/m"})
          .material.at("unit");
  EXPECT_EQ(line_of(changed.origin, "mode_1_energy"), "");
  EXPECT_NE(line_of(changed.origin, "tensile_strength"), "");
  const std::string stale = faults(written, {"masonry.masonry_strength=5 MPa"});
  EXPECT_TRUE(says(stale, "its origin says derived by fc_is_fm")) << stale;
  EXPECT_TRUE(says(stale, "to follow, or remove its line from origin to keep it")) << stale;
  const std::string false_claim =
      with(write_model(read(kTypical)), "cohesion 0.15 MPa: typical of tuff_pozzolanic",
           "cohesion 0.15 MPa: typical of granite_dry");
  EXPECT_EQ(line_of(read(false_claim).material.at("joint").origin, "cohesion"), "");
}

// --- what a stated value silences -----------------------------------------------------------------

// The notes that a slope of GII is left out.
Texts slopes_left_out(const std::vector<Message>& notes) {
  Texts out;
  for (const Message& note : notes)
    if (note.code == "rule.slope_left_out") out.push_back(text_of(note));
  return out;
}

Texts slopes_left_out(const std::string& text, const Texts& set = {}) {
  return slopes_left_out(compile(read(text, set)).anatomy.notes);
}

std::string with_joint(const std::string& lines) {
  return with(kRules, "[material.joint]\n", "[material.joint]\n" + lines + "\n");
}

const std::string kLeftOut =
    "so mode_2_energy_per_pressure is 0 and not the 0.13 mm of its rule. State it too: \"0 mm\" if "
    "this energy holds at every pressure, \"rule\" if it is that without pressure";
const std::string kStatedEnergy = "material.joint.mode_2_energy is stated, " + kLeftOut;

TEST(MaterialInput, a_stated_energy_of_slip_without_its_slope_is_noted) {
  EXPECT_EQ(slopes_left_out(with_joint("mode_2_energy = \"100 N/m\"")), Texts{kStatedEnergy});
  EXPECT_EQ(slopes_left_out(kRules, {"material.joint.mode_2_energy=100 N/m"}),
            Texts{kStatedEnergy});
  EXPECT_EQ(slopes_left_out(with_joint("mode_2_energy = \"rule: gii_published\"")),
            Texts{"material.joint.mode_2_energy is by the rule gii_published, " + kLeftOut});
  EXPECT_EQ(slopes_left_out(with_joint("use = \"clay_brick_eindhoven\"")),
            Texts{"material.joint.mode_2_energy is typical of clay_brick_eindhoven, " + kLeftOut});
}

TEST(MaterialInput, a_slope_that_is_stated_or_that_no_rule_would_give_is_no_note) {
  const Texts none;
  const std::string energy = "mode_2_energy = \"100 N/m\"\n";
  EXPECT_EQ(slopes_left_out(kRules), none);
  EXPECT_EQ(slopes_left_out(with_joint("mode_2_energy = \"rule\"")), none);
  for (const char* slope : {"\"0 mm\"", "\"0.05 mm\"", "\"rule\""})
    EXPECT_EQ(slopes_left_out(with_joint(energy + "mode_2_energy_per_pressure = " + slope)), none)
        << slope;
  EXPECT_EQ(slopes_left_out(with_joint(energy), {"material.joint.mode_2_energy_per_pressure=0 mm"}),
            none);
  EXPECT_EQ(slopes_left_out(with_joint(energy + "cohesion = \"0 MPa\"")), none);
  EXPECT_EQ(slopes_left_out(with(with_joint(energy), "\"clay\"", "\"calcium_silicate\"")), none);
  // where each value is asked for by itself, b is not
  EXPECT_EQ(slopes_left_out(with(kRules, "[material.joint]\nmissing = \"rule\"\n",
                                 "[material.joint]\nuse = \"clay_brick_eindhoven\"\n"
                                 "mode_1_energy = \"rule\"\ncohesion = \"rule\"\n"
                                 "friction_angle = \"rule\"\nresidual_friction_angle = \"rule\"\n"
                                 "normal_stiffness = \"rule\"\nshear_stiffness = \"rule\"\n"
                                 "compressive_strength = \"unlimited\"\n")),
            none);
}

// A used model tells it again, until b is stated or GII comes by its rule.
TEST(MaterialInput, a_used_model_still_says_that_a_slope_is_left_out) {
  const std::string used = write_model(read(with_joint("mode_2_energy = \"100 N/m\"")));
  EXPECT_EQ(line_of(read(used).material.at("joint").origin, "mode_2_energy_per_pressure"),
            "mode_2_energy_per_pressure 0 mm: given as mode_2_energy is stated");
  EXPECT_EQ(write_model(read(used)), used);
  EXPECT_EQ(slopes_left_out(used), Texts{kStatedEnergy});
  const Texts none;
  EXPECT_EQ(slopes_left_out(used, {"material.joint.mode_2_energy_per_pressure=0 mm"}), none);
  EXPECT_EQ(slopes_left_out(used, {"material.joint.mode_2_energy=rule"}), none);
}

// Whatever a study states is told once, however many samples it has.
TEST(MaterialInput, a_study_that_states_an_energy_of_slip_is_noted_once) {
  const Folder folder;
  const auto notes = [&](const std::string& model, const std::string& study) {
    folder.write("rules.toml", model);
    const StudySpec spec = read_study(folder.write("study.toml", study));
    return slopes_left_out(notes_of_values(spec, draw_samples(spec), model_builder(spec)));
  };
  const std::string energy = study_of("material.joint.mode_2_energy", "100 N/m");
  EXPECT_EQ(notes(kRules, energy),
            Texts{"material.joint.mode_2_energy by variable.x is stated, " + kLeftOut});
  EXPECT_EQ(notes(with_joint("mode_2_energy_per_pressure = \"0.05 mm\""), energy), Texts{});
  const std::string other = study_of("masonry.unit_strength", "14.92 MPa");
  EXPECT_EQ(notes(kRules, other), Texts{});
  EXPECT_EQ(notes(with_joint("mode_2_energy = \"100 N/m\""), other), Texts{kStatedEnergy});
  // medians that do not go together hide no note of the model itself
  const std::string apart = study_of("material.joint.residual_friction_angle", "42 deg");
  EXPECT_EQ(notes(with_joint("mode_2_energy = \"100 N/m\""), apart), Texts{kStatedEnergy});
}

// --- studies and laws -----------------------------------------------------------------------------

TEST(MaterialInput, a_study_varies_the_input_of_a_rule_and_the_law_follows) {
  const Folder folder;
  folder.write("rules.toml", kRules);
  const StudySpec study =
      read_study(folder.write("study.toml", study_of("masonry.unit_strength", "14.92 MPa")));
  const ModelBuilder build = model_builder(study);
  const double weak =
      build({"masonry.unit_strength=\"10 MPa\""}).material.at("unit").tensile_strength;
  expect_near(weak, 0.040 * 10e6 * std::pow(1 - 0.12, 1 / 0.58));
  EXPECT_EQ(weak,
            read(kRules, {"masonry.unit_strength=10 MPa"}).material.at("unit").tensile_strength);
}

TEST(MaterialInput, a_study_may_not_vary_what_no_rule_takes) {
  const Folder folder;
  folder.write("rules.toml", kRules);
  const std::string path = folder.write("study.toml", study_of("masonry.mortar_strength", "4 MPa"));
  try {
    (void)read_study(path);
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), "no rule of the base model asks for it")) << error.what();
  }
}

TEST(MaterialInput, a_study_varies_a_tangent_only_where_the_model_gives_one) {
  const Folder folder;
  folder.write("rules.toml",
               with(kRules, "[material.joint]\n", "[material.joint]\nfriction_tan = 0.6\n"));
  const std::string study = study_of("material.joint.friction_tan", "0.6");
  const std::string number = with(study, "\"0.6\"", "0.6");
  EXPECT_EQ(read_study(folder.write("study.toml", number)).variable.size(), 1U);
  folder.write("rules.toml", with(kRules, "[material.joint]\n",
                                  "[material.joint]\nfriction_angle = \"30 deg\"\n"));
  try {
    (void)read_study(folder.write("study.toml", number));
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), "the base model gives no friction_tan")) << error.what();
  }
}

TEST(MaterialInput, a_typology_of_masonry_that_no_rule_takes_is_refused_as_a_setting) {
  const std::string said = faults(kTypical, {"masonry.use=clay_brick_old"});
  EXPECT_TRUE(says(said, "--set: masonry.use: has no effect")) << said;
}

TEST(MaterialInput, a_cap_is_on_only_where_it_is_asked_for) {
  EXPECT_TRUE(std::isnan(read(kRules).material.at("joint").compression_cap));
  const std::string asked =
      with(kRules, "[material.joint]\n", "[material.joint]\ncompression_cap = \"rule\"\n");
  EXPECT_EQ(read(asked).material.at("joint").compression_cap, 9);
}

// docs/howto/materials.md, "Head joints".
TEST(MaterialInput, a_dry_head_joint_asks_for_its_cohesion_alone) {
  const ModelSpec spec = read(with(
      with(kRules, "[wall.unit]\n", "head_joint = \"dry\"\n[wall.unit]\n"), "[material.unit]\n",
      "[material.dry]\nmissing = \"rule\"\ncohesion = \"0 MPa\"\n[material.unit]\n"));
  const JointMaterial &dry = spec.material.at("dry"), &bed = spec.material.at("joint");
  EXPECT_EQ(dry.cohesion, 0);
  EXPECT_EQ(dry.tensile_strength, 0);
  EXPECT_EQ(dry.friction_angle, bed.friction_angle);
  EXPECT_EQ(dry.normal_stiffness, bed.normal_stiffness);
  EXPECT_EQ(dry.compressive_strength, bed.compressive_strength);
  EXPECT_GT(bed.tensile_strength, 0);
}

TEST(MaterialInput, a_filled_head_joint_has_a_quarter_by_rule_where_the_file_names_none) {
  const auto bond = [](const std::string& text) {
    return read(text).material.at("joint").head_joint_bond;
  };
  const ModelSpec spec = read(kRules);
  EXPECT_EQ(bond(kRules), 0.25);
  EXPECT_EQ(line_of(spec.material.at("joint").origin, "head_joint_bond"),
            "head_joint_bond 0.25: derived by head_joint_quarter");
  EXPECT_TRUE(std::isnan(spec.material.at("unit").head_joint_bond));
  const auto with_line = [](const std::string& line) {
    return with(kRules, "[material.joint]\n", "[material.joint]\n" + line + "\n");
  };
  EXPECT_EQ(bond(with_line("head_joint_bond = 1")), 1);
  EXPECT_EQ(bond(with_line("head_joint_bond = 0")), 0);
  EXPECT_EQ(bond(with_line("head_joint_bond = \"rule\"")), 0.25);
  EXPECT_EQ(bond(with_line("head_joint_bond = \"rule: head_joint_quarter\"")), 0.25);
  // a head joint that is named has nothing of the beds'
  EXPECT_TRUE(
      std::isnan(bond(with(kRules, "[wall.unit]\n", "head_joint = \"joint\"\n[wall.unit]\n"))));
  // values that are given ask for no rule, and a foundation has no head joints
  EXPECT_TRUE(std::isnan(read(kTypical).material.at("joint").head_joint_bond));
  const ModelSpec founded = read(with(
      kRules, "[material.unit]\n", "[material.foundation]\nmissing = \"rule\"\n[material.unit]\n"));
  EXPECT_TRUE(std::isnan(founded.material.at("foundation").head_joint_bond));
}

// b comes with a GII by rule, of mortar between clay units; a stated GII holds for the pressures of its tests.
TEST(MaterialInput, energy_of_slip_grows_with_pressure_by_rule_between_clay_units_alone) {
  const auto law = [](const std::string& text) { return read(text).material.at("joint"); };
  const auto with_line = [](const std::string& line) {
    return with(kRules, "[material.joint]\n", "[material.joint]\n" + line + "\n");
  };
  const auto with_units = [](const std::string& type) {
    return with(kRules, "unit_type = \"clay\"", "unit_type = \"" + type + "\"");
  };
  const JointMaterial clay = law(kRules);
  EXPECT_DOUBLE_EQ(clay.mode_2_energy_per_pressure, 0.13e-3);
  EXPECT_EQ(line_of(clay.origin, "mode_2_energy_per_pressure"),
            "mode_2_energy_per_pressure 0.13 mm: derived by gii_per_pressure from unit_type clay");
  EXPECT_TRUE(check_joint_material(clay).empty());
  EXPECT_TRUE(std::isnan(read(kRules).material.at("unit").mode_2_energy_per_pressure));
  for (const char* type : {"calcium_silicate", "aerated_concrete"}) {
    const JointMaterial other = law(with_units(type));
    EXPECT_TRUE(std::isnan(other.mode_2_energy_per_pressure)) << type;
    EXPECT_GE(other.mode_2_energy, clay.mode_2_energy) << type;
  }
  const auto b = [&](const std::string& line) {
    return law(with_line(line)).mode_2_energy_per_pressure;
  };
  EXPECT_DOUBLE_EQ(b("mode_2_energy = \"rule\""), 0.13e-3);
  EXPECT_DOUBLE_EQ(b("mode_2_energy = \"rule: gii_from_cohesion\""), 0.13e-3);
  EXPECT_TRUE(std::isnan(b("mode_2_energy = \"rule: gii_published\"")));
  EXPECT_TRUE(std::isnan(b("mode_2_energy = \"100 N/m\"")));
  EXPECT_EQ(b("mode_2_energy_per_pressure = \"0.05 mm\""), 0.05e-3);
  EXPECT_EQ(b("mode_2_energy_per_pressure = \"0 mm\""), 0);
  EXPECT_DOUBLE_EQ(b("mode_2_energy = \"100 N/m\"\nmode_2_energy_per_pressure = \"rule\""),
                   0.13e-3);
  EXPECT_TRUE(std::isnan(b("cohesion = \"0 MPa\"")));
}

TEST(MaterialInput,
     a_share_of_head_joints_that_is_none_or_acts_nowhere_is_refused_where_it_stands) {
  const auto said = [](const std::string& table, const std::string& line) {
    return faults(with(kRules, table + "\n", table + "\n" + line + "\n"));
  };
  for (const char* value : {"-0.1", "1.2", "nan", "inf"}) {
    const std::string text = said("[material.joint]", std::string("head_joint_bond = ") + value);
    EXPECT_TRUE(says(text, "model.toml:20: material.joint.head_joint_bond")) << value << text;
    EXPECT_TRUE(says(text, "from 0 to 1") || says(text, "finite")) << value << ": " << text;
  }
  EXPECT_TRUE(says(said("[material.joint]", "head_joint_bond = \"0.25 MPa\""), "number"));
  EXPECT_TRUE(says(said("[material.joint]", "head_joint_bond = \"rule: half\""), "no such rule"));
  const std::string idle = said("[material.unit]", "head_joint_bond = 0.25");
  EXPECT_TRUE(says(idle,
                   "material.unit.head_joint_bond = 0.25: has no effect: no bed joints are "
                   "of this material; name the material as joint"))
      << idle;
}

TEST(MaterialInput, beds_of_a_region_or_storey_have_a_share_for_their_own_head_joints) {
  const std::string weak =
      "[material.weak]\nmissing = \"rule\"\ncohesion = \"0.1 MPa\"\n[material.unit]\n";
  const auto bond = [&](const std::string& region) {
    return read(with(with(kRules, "[material.unit]\n", weak), "[[stage]]\nname = \"gravity\"\n",
                     "[[region]]\nx = \"0 m\"\ny = \"0 m\"\nwidth = \"0.5 m\"\nheight = \"0.5 "
                     "m\"\n" +
                         region + "[[stage]]\nname = \"gravity\"\n"))
        .material.at("weak")
        .head_joint_bond;
  };
  EXPECT_EQ(bond("joint = \"weak\"\n"), 0.25);
  EXPECT_TRUE(std::isnan(bond("joint = \"weak\"\nhead_joint = \"joint\"\n")));
  EXPECT_TRUE(std::isnan(bond("head_joint = \"weak\"\n")));
}

TEST(MaterialInput, a_law_file_may_ask_for_rules) {
  const Folder folder;
  const std::string path = folder.write(
      "law.toml", "[material.joint]\nuse = \"tuff_pozzolanic\"\nmode_1_energy = \"rule\"\n");
  const JointMaterial law = read_law(path);
  expect_near(law.mode_1_energy, 4.35);
  expect_near(law.cohesion, 0.15e6);
}

TEST(MaterialInput, the_list_explains_each_material_and_each_rule) {
  const std::string list = materials_text("");
  for (const char* name : {"circolare_brick_lime", "granite_dry", "unit_ft_from_fb", "gc_from_fc"})
    EXPECT_TRUE(says(list, name)) << name;
  const std::string brick = materials_text("circolare_brick_lime");
  EXPECT_TRUE(says(brick, "2.6 to 4.3 MPa")) << brick;
  EXPECT_TRUE(says(brick, "0.26")) << brick;  // sqrt(exp((ln(4.3/2.6)/2)^2) - 1) = 0.2557
  EXPECT_TRUE(says(brick, "path = \"masonry.masonry_strength\"")) << brick;
  const std::string rule = materials_text("unit_ft_from_fb");
  EXPECT_TRUE(says(rule, "ft = c2 fb (1 - sv/fb)^1.72")) << rule;
  EXPECT_TRUE(says(rule, "range: unit_strength from 2 to 100 MPa")) << rule;
  EXPECT_TRUE(says(rule, "clay_perforated")) << rule;
  EXPECT_THROW((void)materials_text("no_such"), InputError);
}

// --- rules and storeys ---------------------------------------------------------------------------

const std::string kStoreys = R"(
[[storey]]
name = "ground"
height = "0.645 m"
[[storey]]
name = "first"
height = "0.6 m"
unit = { height = "100 mm" }
)";

std::string with_storeys(const std::string& more) {
  std::string text = kRules;
  text.replace(text.find("height = \"1.29 m\"\n"), 18, "");
  return text + kStoreys + more;
}

TEST(MaterialInput, a_rule_takes_the_course_height_of_the_storey_that_has_its_joints) {
  const ModelSpec spec = read(with_storeys(
      "joint = \"upper\"\nunit_joint = \"upper_unit\"\n[material.upper]\nmissing = \"rule\"\n"
      "[material.upper_unit]\nmissing = \"rule\"\n"));
  expect_near(spec.material.at("joint").normal_stiffness, 2991e6 / 0.0645);
  expect_near(spec.material.at("upper").normal_stiffness, 2991e6 / 0.1);
  const std::string kn = line_of(spec.material.at("upper").origin, "normal_stiffness");
  EXPECT_TRUE(says(kn, "course_height 100 mm (storey.first.unit.height)")) << kn;
}

TEST(MaterialInput, a_rule_of_a_joint_in_storeys_of_two_course_heights_is_refused) {
  const std::string said = faults(with_storeys(""));
  EXPECT_TRUE(says(said, "material.joint")) << said;
  EXPECT_TRUE(says(said, "64.5 mm in wall.unit.height, 100 mm in storey.first.unit.height"))
      << said;
  EXPECT_TRUE(says(said, "course_height under [masonry]")) << said;
  const ModelSpec given = read(with_storeys(""), {"masonry.course_height=80 mm"});
  expect_near(given.material.at("joint").normal_stiffness, 2991e6 / 0.08);
}

TEST(MaterialInput, a_region_has_the_course_height_of_its_storey) {
  const std::string region =
      "joint = \"upper\"\nunit_joint = \"upper_unit\"\n[[region]]\n%s\nx = \"0 m\"\ny = \"0 m\"\n"
      "width = \"0.5 m\"\nheight = \"0.3 m\"\njoint = \"patch\"\n[material.patch]\n"
      "missing = \"rule\"\n[material.upper]\nmissing = \"rule\"\n[material.upper_unit]\n"
      "missing = \"rule\"\n";
  const auto of = [&](const std::string& storey) {
    std::string text = region;
    return with_storeys(text.replace(text.find("%s"), 2, storey));
  };
  expect_near(read(of("storey = \"first\"")).material.at("patch").normal_stiffness, 2991e6 / 0.1);
  EXPECT_TRUE(says(faults(of("")), "material.patch: its rules ask for course_height"))
      << faults(of(""));
}

}  // namespace
}  // namespace wythe::io_tests::material_input_test
