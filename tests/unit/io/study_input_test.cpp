// Study files: valid input, round trips, samples as settings, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "core/text.h"
#include "io/keys/describe_study.h"
#include "io/keys/same_spec.h"
#include "scenes/places.h"
#include "unit/study_text.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/io.h"
#include "wythe/parts/study.h"

namespace wythe::study_input_test {
namespace {

using namespace io_tests;

double of(const SampleTable& table, std::size_t sample, const std::string& name) {
  for (std::size_t j = 0; j < table.column.size(); ++j)
    if (table.column[j].name == name) return table.value[sample][j];
  throw std::logic_error("no column " + name);
}

// --- what is understood --------------------------------------------------------------------------

TEST(Study, example_is_understood) {
  const StudySpec study = parsed(kStudy);
  ASSERT_EQ(study.variable.size(), 3U);
  EXPECT_EQ(study.variable[0].name, "ft_j");  // in the order of the file
  EXPECT_EQ(study.variable[0].si_unit, "Pa");
  EXPECT_EQ(study.variable[0].unit, "MPa");
  EXPECT_EQ(study.variable[0].mean, 0.15e6);
  EXPECT_EQ(study.variable[1].unit, "deg");
  EXPECT_EQ(study.variable[2].name, "R");
  EXPECT_EQ(study.variable[2].unit, "1");
  EXPECT_EQ(study.dependent[2].si_unit, "");  // derived when samples are drawn
  EXPECT_EQ(study.batch, std::vector<int>{20});
  EXPECT_EQ(study.states, (std::vector<double>{0.01, 0.02}));
  EXPECT_EQ(study.fractions, (std::vector<double>{0.8, 0.5}));
  EXPECT_TRUE(study.correlation[0].rank);
}

TEST(Study, of_the_paper_is_table_2) {
  const SampleTable table =
      draw_samples(read_study(source_dir() + "/examples/tuff_wall/study.toml"));
  EXPECT_EQ(table.n_sample(), 250);
  const double tan_ratio =
      std::tan(14.6 * std::numbers::pi / 180) / std::tan(16.2 * std::numbers::pi / 180);
  for (std::size_t i = 0; i < 250; ++i) {
    const auto value = [&](const char* name) { return of(table, i, name); };
    // rules of Table 2; four roundings at most
    EXPECT_DOUBLE_EQ(value("joint_cohesion"), 1.5 * value("ft_j"));
    EXPECT_DOUBLE_EQ(value("joint_GI"), 2.9e-5 * value("ft_j"));
    EXPECT_DOUBLE_EQ(value("joint_GII"), 125 * (value("ft_j") / 0.15e6));
    EXPECT_DOUBLE_EQ(value("joint_Gc"), 3.2e-3 * value("fc"));
    EXPECT_DOUBLE_EQ(value("unit_cohesion"), 1.5 * value("ft_u"));
    EXPECT_DOUBLE_EQ(value("unit_GI"), 8 * (value("ft_u") / 0.23e6));
    EXPECT_DOUBLE_EQ(value("unit_normal_stiffness"), 20e9 * value("R"));
    EXPECT_DOUBLE_EQ(value("unit_shear_stiffness"), 8e9 * value("R"));
    EXPECT_EQ(value("foundation_ft"), value("ft_j"));
    EXPECT_NEAR(std::tan(value("joint_residual_friction")) / std::tan(value("phi")), tan_ratio,
                1e-14);
  }
}

TEST(Study, written_and_read_is_the_same) {
  StudySpec study = parsed(
      added("[variable.m]\ndistribution = \"empirical\"\nvalues = [0.1, 3, 0.30000000000000004]\n"
            "[variable.s]\nunit = \"MPa\"\ndistribution = \"empirical\"\nvalues = [\"1 Pa\", \"0.7 "
            "MPa\"]\n"
            "[variable.u]\npath = \"wall.opening.0.width\"\ndistribution = \"triangular\"\n"
            "low = \"1 m\"\nmode = \"120 cm\"\nhigh = \"2 m\"\nunit = \"cm\"\n"
            "[dependent.used]\nformula = \"m * s\"\n"),
      {"stage.push.velocity=1 mm/s", "study.samples=[20, 30]", "study.note='a \"b\"\\n'"});
  study.seed = 0xfedcba9876543210ULL;
  study.until = "interval(share) < 0.1";
  const std::string text = write_study(study);
  const StudySpec back = parsed(text);
  EXPECT_EQ(write_study(back), text);
  EXPECT_EQ(back.seed, study.seed);
  EXPECT_EQ(back.batch, (std::vector<int>{20, 30}));
  EXPECT_EQ(back.settings, study.settings);
  EXPECT_EQ(back.model_text, study.model_text);
  EXPECT_EQ(back.model_file, study.model_file);
  EXPECT_EQ(back.note, study.note);
  EXPECT_EQ(back.variable[3].values, study.variable[3].values);
  EXPECT_EQ(back.variable[4].values, (std::vector<double>{1, 0.7e6}));
  EXPECT_EQ(back.variable[5].path, "wall.opening.door.width");  // by its name
  EXPECT_EQ(draw_samples(back).value, draw_samples(study).value);
}

TEST(Study, options_are_written_and_read_too) {
  const StudySpec study = parsed(
      added("[[variant]]\nname = \"Slow push, 1 mm/s\"\nset = [\"stage.push.velocity=1 mm/s\", "
            "\"dependent.w.formula=0.03 mm * R\"]\n[[variant]]\nname = \"quick\"\n"
            "set = [\"stage.push.velocity=9 mm/s\"]\n"),
      {"stage.push.velocity=5 mm/s"});
  ASSERT_EQ(study.option.size(), 2U);
  const VariantSpec& slow = study.option[0];
  EXPECT_EQ(slow.folder, "slow_push_1_mm_s");
  EXPECT_EQ(slow.study.variant_place, 1);
  EXPECT_EQ(study.variant, "base");
  // an option's settings come after those of the command line, and its samples are the base's
  EXPECT_EQ(model_builder(slow.study)({}).stage.back().get<PushStage>().velocity, 1e-3);
  EXPECT_EQ(model_builder(study)({}).stage.back().get<PushStage>().velocity, 5e-3);
  const SampleTable base = draw_samples(study), option = draw_samples(slow.study);
  EXPECT_EQ(other_inputs(base, option), "");
  EXPECT_NE(base.value, option.value);  // but for the dependent that it changes
  const std::string text = write_study(study);
  const StudySpec back = parsed(text);
  EXPECT_EQ(write_study(back), text);
  EXPECT_EQ(write_study(back.option[0].study), write_study(slow.study));
}

TEST(Study, overrides_change_the_study_or_its_model) {
  const StudySpec study =
      parsed(kStudy, {"variable.ft_j.cov=0.1", "study.design=sobol", "study.seed=9",
                      "stage.push.velocity=1 mm/s", "correlation.0.rank=0.5",
                      "dependent.w.formula=0.03 mm * R"});
  EXPECT_EQ(study.variable[0].cov, 0.1);
  EXPECT_EQ(study.design, Design::kSobol);
  EXPECT_EQ(study.seed, 9U);
  EXPECT_EQ(study.settings, (Texts{"wall.unit.split=none", "stage.push.velocity=1 mm/s"}));
  EXPECT_EQ(study.correlation[0].value, 0.5);
  EXPECT_EQ(study.dependent[2].formula, "0.03 mm * R");
}

TEST(Study, is_told_from_a_model) {
  const Folder folder;
  EXPECT_TRUE(is_study(folder.write("study.toml", kStudy)));
  EXPECT_FALSE(is_study(folder.write("model.toml", kModel)));
}

TEST(Study, base_model_and_values_are_read_beside_the_study) {
  const Folder folder;
  folder.write("model.toml", kModel);
  folder.write("tests.csv", "# six couplets\nname,ft_MPa\na,0.1\nb,0.2\nc, 0.15 \n");
  const std::string path = folder.write(
      "study.toml",
      "[study]\nmodel = \"model.toml\"\nsamples = 8\nseed = 1\nset = [\"solve.damping=0.7\"]\n"
      "[variable.ft]\npath = \"material.joint.tensile_strength\"\n"
      "distribution = \"empirical\"\nfile = \"tests.csv\"\ncolumn = \"ft\"\n");
  const StudySpec study = read_study(path);
  EXPECT_EQ(study.variable[0].values, (std::vector<double>{0.1e6, 0.2e6, 0.15e6}));
  EXPECT_EQ(model_builder(study)({}).solve.damping, 0.7);
}

// --- samples as settings -------------------------------------------------------------------------

TEST(Settings, give_the_model_the_samples_bits) {
  const StudySpec study = parsed(kStudy);
  const SampleTable table = draw_samples(study);
  const ModelBuilder build = model_builder(study);
  for (int i = 0; i < table.n_sample(); ++i) {
    const auto s = static_cast<std::size_t>(i);
    const ModelSpec model = build(settings_of(table, i));
    const JointMaterial& joint = model.material.at("joint");
    EXPECT_EQ(joint.tensile_strength, of(table, s, "ft_j"));
    EXPECT_EQ(joint.cohesion, of(table, s, "c"));
    EXPECT_EQ(joint.friction_angle, of(table, s, "phi"));
    EXPECT_EQ(joint.mode_1_energy, of(table, s, "GI"));
    EXPECT_EQ(model.output.states, (std::vector<double>{0.01, 0.02}));
  }
}

TEST(Settings, leave_out_what_sets_nothing) {
  const SampleTable table = draw_samples(parsed(kStudy));
  const Texts settings = settings_of(table, 0);
  ASSERT_EQ(settings.size(), 5U);
  EXPECT_TRUE(settings[0].starts_with("material.joint.tensile_strength=")) << settings[0];
  EXPECT_TRUE(settings[0].ends_with(" Pa")) << settings[0];
}

TEST(Columns, derive_their_units) {
  const SampleTable table = draw_samples(parsed(kStudy));
  ASSERT_EQ(table.column.size(), 7U);
  EXPECT_EQ(table.column[5].name, "w");
  EXPECT_EQ(table.column[5].si_unit, "m");
  EXPECT_FALSE(table.column[5].is_random);
  EXPECT_DOUBLE_EQ(table.column[0].to_unit * 0.15e6, 0.15);
  EXPECT_NEAR(table.cut_off[1], 0.5 * std::erfc(14 / 3.2 / std::numbers::sqrt2), 1e-15);
  EXPECT_EQ(table.cut_off[0], 0);
}

// --- refusals of single samples ------------------------------------------------------------------

StudySpec tuff_study() { return read_study(source_dir() + "/examples/tuff_wall/study.toml"); }

std::string refusal(const Texts& settings) {
  return in_one_line(refusal_of(settings, model_builder(tuff_study())));
}

TEST(Refusal, is_empty_for_an_admissible_sample) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal(settings_of(draw_samples(tuff_study()), 0)), "");
}

TEST(Refusal, names_key_value_and_reason_in_one_line) {
  EXPECT_EQ(refusal({"material.joint.tensile_strength=-1234567.8912345 Pa"}),
            "material.joint.tensile_strength = -1.23457e+06 Pa: must be at least 0 MPa");
  EXPECT_EQ(refusal({"material.joint.friction_angle=1.6 rad"}),
            "material.joint.friction_angle = 1.6 rad: must be from 0 deg to less than 90 deg");
  const std::string snap_back = refusal({"material.joint.mode_1_energy=0.1 N/m"});
  EXPECT_TRUE(snap_back.starts_with("material.joint.mode_1_energy = 0.1 N/m: gives snap-back"))
      << snap_back;
  EXPECT_EQ(snap_back.find('\n'), std::string::npos);
}

TEST(Refusal, of_a_value_that_is_not_finite) {
  SampleTable table = draw_samples(parsed(kStudy));
  table.value[0][0] = kUnlimited;
  const std::string why =
      in_one_line(refusal_of(settings_of(table, 0), model_builder(parsed(kStudy))));
  EXPECT_EQ(why, "material.joint.tensile_strength = nan Pa: is not a finite number");
}

TEST(Refusal, names_the_input_whose_formula_has_no_value) {
  SampleTable table = draw_samples(tuff_study());
  table.value[2][5] = kUnlimited;
  const ModelBuilder build = model_builder(tuff_study());
  EXPECT_EQ(in_one_line(refusal_of(table, 2, build)),
            "joint_cohesion = inf: is not a finite number");
  EXPECT_TRUE(refusal_of(table, 1, build).empty());
}

TEST(Refusal, of_all_samples_is_that_of_each) {
  SampleTable table = draw_samples(tuff_study());
  table.value.resize(6);
  table.value[0][0] = -1.0;  // the first gives no wall that the others could share
  table.value[3][5] = kUnlimited;
  const ModelBuilder build = model_builder(tuff_study());
  const std::vector<std::vector<Fault>> all = refusals_of(table, build);
  ASSERT_EQ(all.size(), 6U);
  for (int s = 0; s < 6; ++s)
    EXPECT_EQ(in_one_line(all[s]), in_one_line(refusal_of(table, s, build))) << s;
  EXPECT_FALSE(all[0].empty());
  EXPECT_TRUE(all[1].empty());
}

// --- dependents --------------------------------------------------------------------------------------

TEST(Dependents, follow_each_other_in_any_order) {
  const SampleTable table = draw_samples(parsed(kStudy));
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_DOUBLE_EQ(of(table, i, "GI"), 2.9e-5 * of(table, i, "ft_j"));
}

// --- reference page ------------------------------------------------------------------------------

// Collects the names of keys from their description.
struct KeyNames {
  Texts names;
  void quantity(const char* name, const double&, const io::Key&) { names.emplace_back(name); }
  void number(const char* name, const double&, const io::Key&) { names.emplace_back(name); }
  void text(const char* name, const std::string&, const io::Key&) { names.emplace_back(name); }
  void texts(const char* name, const Texts&, const io::Key&) { names.emplace_back(name); }
  void quantities(const char* name, const std::vector<double>&, const io::Key&) {
    names.emplace_back(name);
  }
  template <class E, std::size_t N>
  void choice(const char* name, const E&, const Word<E> (&words)[N], const io::Key&) {
    names.emplace_back(name);
    for (const auto& word : words) names.emplace_back(word.word);
  }
};

TEST(StudyReference, has_every_key) {
  std::ifstream file(source_dir() + "/docs/reference/study.md");
  std::stringstream page;
  page << file.rdbuf();
  StudySpec spec;
  VariableSpec variable;
  variable.si_unit = variable.unit = "1";
  DependentSpec dependent;
  const io::VariableKeys keys;
  io::StudyHead head{spec, ""};
  io::VariableTable variable_table{variable, keys};
  io::DependentTable dependent_table{dependent};
  io::PairTable pair;
  KeyNames names;
  io::describe(names, head);
  io::describe(names, variable_table);
  io::describe(names, dependent_table);
  io::describe(names, pair);
  EXPECT_GT(names.names.size(), 40U);
  for (const char* by_hand : {"samples", "seed", "fractions", "values"})
    names.names.emplace_back(by_hand);
  for (const std::string& name : names.names)
    EXPECT_NE(page.str().find('`' + name + '`'), std::string::npos) << name;
}

}  // namespace
}  // namespace wythe::study_input_test
