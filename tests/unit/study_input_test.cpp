// Study files: what is understood, round trips, and for each bad input the place, the value and the
// cure that its message names.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "core/text.h"
#include "io/describe_study.h"
#include "io/same_spec.h"
#include "unit/io_helpers.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe {
namespace {

using namespace io_tests;

// Line numbers below count from the first line of this text; the model stands at its end.
const std::string kStudy = R"toml([variable.ft_j]
path = "material.joint.tensile_strength"
distribution = "lognormal"
mean = "0.15 MPa"
cov = 0.3
[variable.phi]
path = "material.joint.friction_angle"
distribution = "normal"
mean = "16 deg"
cov = 0.2
lower = "2 deg"
[variable.R]
distribution = "normal"
mean = 0.5
cov = 0.2
[dependent.c]
path = "material.joint.cohesion"
formula = "1.5 * ft_j"
[dependent.GI]
path = "material.joint.mode_1_energy"
formula = "w * ft_j"
[dependent.w]
formula = "0.029 mm"
[dependent.phi_res]
path = "material.joint.residual_friction_angle"
formula = "atan(0.9 * tan(phi))"
[[correlation]]
between = ["ft_j", "phi"]
rank = 0.3
[study]
model = "model.toml"
samples = 20
seed = 7
states = ["10 mm", "20 mm"]
read_modes_at = "20 mm"
fractions = [0.8, 0.5]
set = ["wall.unit.split=none"]
)toml" + std::string("model_text = '''\n") +
                           kModel + "'''\n";

StudySpec parsed(const std::string& text, const Texts& overrides = {}) {
  return parse_study(text, "study.toml", overrides);
}

Texts study_faults(const std::string& text, const Texts& overrides = {}) {
  Texts out;
  try {
    (void)parsed(text, overrides);
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) out.push_back(to_string(fault));
  }
  return out;
}

std::string study_fault(const std::string& from, const std::string& to) {
  return joined(study_faults(with(kStudy, from, to)), "\n");
}

std::string added(const std::string& tables) {
  return with(kStudy, "[study]\n", tables + "[study]\n");
}

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
      draw_samples(read_study(WYTHE_SOURCE_DIR "/examples/tuff_wall/study.toml"));
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
            "low = \"1 m\"\nmode = \"120 cm\"\nhigh = \"2 m\"\nunit = \"cm\"\n"),
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

TEST(Study, overrides_change_the_study_or_its_model) {
  const StudySpec study = parsed(kStudy, {"variable.ft_j.cov=0.1", "study.design=sobol",
                                          "study.seed=9", "stage.push.velocity=1 mm/s",
                                          "correlation.0.rank=0.5", "dependent.w.formula=0.03 mm"});
  EXPECT_EQ(study.variable[0].cov, 0.1);
  EXPECT_EQ(study.design, Design::kSobol);
  EXPECT_EQ(study.seed, 9U);
  EXPECT_EQ(study.settings, (Texts{"wall.unit.split=none", "stage.push.velocity=1 mm/s"}));
  EXPECT_EQ(study.correlation[0].value, 0.5);
  EXPECT_EQ(study.dependent[2].formula, "0.03 mm");
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

StudySpec tuff_study() { return read_study(WYTHE_SOURCE_DIR "/examples/tuff_wall/study.toml"); }

std::string refusal(const Texts& settings) {
  return refusal_of(settings, model_builder(tuff_study()));
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
  EXPECT_TRUE(snap_back.starts_with("material.joint.mode_1_energy is 0.1 N/m: snap-back"))
      << snap_back;
  EXPECT_EQ(snap_back.find('\n'), std::string::npos);
}

TEST(Refusal, of_a_value_that_is_not_finite) {
  SampleTable table = draw_samples(parsed(kStudy));
  table.value[0][0] = kUnlimited;
  const std::string why = refusal_of(settings_of(table, 0), model_builder(parsed(kStudy)));
  EXPECT_EQ(why, "material.joint.tensile_strength = nan Pa: is not a finite number");
}

// --- dependents --------------------------------------------------------------------------------------

TEST(Dependents, follow_each_other_in_any_order) {
  const SampleTable table = draw_samples(parsed(kStudy));
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_DOUBLE_EQ(of(table, i, "GI"), 2.9e-5 * of(table, i, "ft_j"));
}

// --- files refused -------------------------------------------------------------------------------

TEST(StudyRefused, cov_of_zero_and_less) {
  EXPECT_EQ(study_fault("cov = 0.3", "cov = 0"),
            "study.toml:5: variable.ft_j.cov = 0: must be more than 0; write e.g. cov = 0.3");
  EXPECT_EQ(
      study_fault("cov = 0.3", "standard_deviation = \"-1 MPa\""),
      "study.toml:5: variable.ft_j.standard_deviation = -1 MPa: must be more than 0 MPa; write "
      "e.g. standard_deviation = \"1 MPa\"");
}

TEST(StudyRefused, no_sample_or_one) {
  for (const char* n : {"0", "1"})
    EXPECT_EQ(study_fault("samples = 20", std::string("samples = ") + n),
              std::string("study.toml:32: study.samples = ") + n +
                  ": must be at least 2: one sample has no scatter; write e.g. samples = 250");
  EXPECT_EQ(
      study_fault("samples = 20", "samples = 2.5"),
      "study.toml:32: study.samples = 2.5: must be a whole number without quotes, or a list of "
      "them; write e.g. samples = 250");
}

TEST(StudyRefused, low_above_high) {
  EXPECT_EQ(
      joined(study_faults(added("[variable.u]\ndistribution = \"uniform\"\nlow = 3\nhigh = 2\n")),
             "\n"),
      "study.toml:32: variable.u.low = 3: must be less than high = 2; exchange them");
  EXPECT_EQ(
      study_fault("lower = \"2 deg\"", "lower = \"20 deg\"\nupper = \"9 deg\""),
      "study.toml:11: variable.phi.lower = 20 deg: must be less than upper = 9 deg; exchange them");
}

TEST(StudyRefused, unknown_path_with_the_nearest) {
  EXPECT_EQ(
      study_fault("joint.tensile_strength", "joint.tensil_strength"),
      "study.toml:2: variable.ft_j.path = material.joint.tensil_strength: no such number in the "
      "model; did you mean material.joint.tensile_strength?");
  const std::string far = study_fault("material.joint.tensile_strength", "material.joint.colour");
  EXPECT_NE(far.find("known in material.joint: normal_stiffness, "), std::string::npos) << far;
  EXPECT_NE(study_fault("material.joint.tensile_strength", "material.jont.cohesion")
                .find("did you mean material.joint?"),
            std::string::npos);
  const std::string stage =
      study_fault("material.joint.tensile_strength", "stage.gravity.velocity");
  EXPECT_NE(stage.find("no such number in the model"), std::string::npos) << stage;
}

TEST(StudyRefused, cycle_with_its_way) {
  EXPECT_EQ(
      study_fault("\"0.029 mm\"", "\"GI / ft_j\""),
      "study.toml:21: dependent.GI.formula = w * ft_j: depends on itself: GI -> w -> GI; let one "
      "of them follow from variables only");
  EXPECT_NE(study_fault("\"0.029 mm\"", "\"w\"").find("w -> w"), std::string::npos);
}

TEST(StudyRefused, formula_of_another_unit_than_its_key) {
  EXPECT_EQ(study_fault("1.5 * ft_j", "3 mm * ft_j"),
            "study.toml:18: dependent.c.formula = 3 mm * ft_j: gives an energy per area [N/m], but "
            "material.joint.cohesion is a stress [Pa]; make it a formula in MPa");
  EXPECT_EQ(study_fault("atan(0.9 * tan(phi))", "ft_j"),
            "study.toml:26: dependent.phi_res.formula = ft_j: gives a stress [Pa], but "
            "material.joint.residual_friction_angle is a number; make it a formula in deg");
  EXPECT_NE(study_fault("\"0.029 mm\"", "\"sqrt(2 mm)\"").find("a fractional power"),
            std::string::npos);
}

TEST(StudyRefused, bare_number_for_a_quantity) {
  EXPECT_EQ(
      study_fault("\"0.15 MPa\"", "0.15"),
      "study.toml:4: variable.ft_j.mean = 0.15: has no unit; write it with its unit, e.g. mean = "
      "\"1 MPa\"");
  EXPECT_EQ(study_fault("mean = 0.5", "mean = \"0.5 MPa\""),
            "study.toml:14: variable.R.mean = 0.5 MPa: must be a number without quotes; write e.g. "
            "mean = 0.5");
  EXPECT_EQ(
      study_fault("\"16 deg\"", "\"16 mm\""),
      "study.toml:9: variable.phi.mean = 16 mm: mm is not the unit of an angle [rad]; write e.g. "
      "mean = \"1 deg\"");
}

TEST(StudyRefused, mean_that_the_model_does_not_admit) {
  EXPECT_EQ(
      study_fault("\"16 deg\"", "\"95 deg\""),
      "study.toml:9: variable.phi.mean = 95 deg: must be from 0 deg to less than 90 deg; write "
      "e.g. mean = \"1 deg\"");
}

TEST(StudyRefused, one_path_set_twice) {
  EXPECT_EQ(study_fault("material.joint.cohesion", "material.joint.tensile_strength"),
            "study.toml:17: dependent.c.path = material.joint.tensile_strength: is set by "
            "variable.ft_j too; leave one of the two");
}

TEST(StudyRefused, one_name_twice_or_no_name) {
  EXPECT_EQ(
      study_fault("[dependent.c]", "[dependent.R]"),
      "study.toml:16: dependent.R: there is a variable of this name; give it a name of its own");
  EXPECT_EQ(study_fault("[dependent.c]", "[dependent.tan]"),
            "study.toml:16: dependent.tan: tan is a function of formulas; rename it");
  EXPECT_EQ(
      study_fault("[dependent.c]", "[dependent.2-c]"),
      "study.toml:16: dependent.2-c: a name is made of letters, digits and _, and begins with a "
      "letter; rename it, e.g. ft_j");
}

TEST(StudyRefused, truncation_that_leaves_nothing) {
  EXPECT_EQ(study_fault("lower = \"2 deg\"", "lower = \"60 deg\""),
            "study.toml:11: variable.phi.lower = 60 deg: the truncation leaves nothing of the "
            "distribution; widen lower and upper");
}

TEST(StudyRefused, parameters_of_another_distribution) {
  EXPECT_EQ(
      study_fault("lower = \"2 deg\"", "shape = 2"),
      "study.toml:11: variable.phi.shape = 2: a normal distribution has no shape; it takes mean "
      "and cov (or standard_deviation)");
  EXPECT_EQ(
      study_fault("cov = 0.3\n", ""),
      "study.toml:1: variable.ft_j: a lognormal distribution needs mean and cov (or "
      "standard_deviation), or median and log_standard_deviation; given: mean; write one set of "
      "them, no more");
  EXPECT_EQ(study_fault("cov = 0.3", "cov = 0.3\nstandard_deviation = \"1 MPa\""),
            "study.toml:5: variable.ft_j.cov = 0.3: stands beside standard_deviation; leave one of "
            "the two");
}

TEST(StudyRefused, beta_wider_than_its_bounds) {
  const std::string table =
      "[variable.b]\ndistribution = \"beta\"\nlow = 0\nhigh = 1\nmean = 0.5\nstandard_deviation = "
      "0.6\n";
  EXPECT_EQ(
      joined(study_faults(added(table)), "\n"),
      "study.toml:35: variable.b.standard_deviation = 0.6: a standard deviation of 0.6 does not "
      "fit between low and high; stay below 0.5");
}

TEST(StudyRefused, correlation_that_is_none) {
  EXPECT_EQ(
      study_fault("rank = 0.3", "rank = 1.0"),
      "study.toml:29: correlation.0.rank = 1: must be more than -1 and less than 1; write e.g. "
      "rank = 0.3");
  EXPECT_EQ(study_fault("[\"ft_j\", \"phi\"]", "[\"ft_j\", \"c\"]"),
            "study.toml:28: correlation.0.between = c: is a dependent, it follows its formula; "
            "correlate the variables it follows from");
  EXPECT_EQ(
      study_fault("[\"ft_j\", \"phi\"]", "[\"ft_j\", \"ft_j\"]"),
      "study.toml:28: correlation.0.between = ft_j: names one variable twice; name two variables");
  EXPECT_EQ(study_fault("rank = 0.3\n", ""),
            "study.toml:27: correlation.0: needs rank or gaussian; write rank = 0.3 (Spearman) or "
            "gaussian = 0.3");
}

// The cure must be one: typed in, it is accepted.
TEST(StudyRefused, matrix_that_is_not_positive_definite_with_the_nearest) {
  const auto study = [](const std::string& a, const std::string& b, const std::string& c) {
    return with(added("[[correlation]]\nbetween = [\"phi\", \"R\"]\nrank = " + b +
                      "\n[[correlation]]\nbetween = [\"ft_j\", \"R\"]\ngaussian = " + c + "\n"),
                "rank = 0.3", "rank = " + a);
  };
  const std::string fault = joined(study_faults(study("0.95", "0.9", "0.1")), "\n");
  EXPECT_TRUE(fault.starts_with(
      "study.toml:27: correlation: the pairs together are not a correlation matrix (not positive "
      "definite); the nearest that is one: ft_j and phi rank = "))
      << fault;
  const auto number_after = [&](const std::string& words) {
    const std::size_t at = fault.find(words) + words.size();
    return fault.substr(at, fault.find(',', at) - at);
  };
  EXPECT_EQ(
      study_faults(study(number_after("ft_j and phi rank = "), number_after("phi and R rank = "),
                         number_after("ft_j and R gaussian = "))),
      Texts{});
}

TEST(StudyRefused, measured_values_that_are_none) {
  const Folder folder;
  folder.write("model.toml", kModel);
  const auto fault = [&](const std::string& csv, const std::string& column) {
    folder.write("t.csv", csv);
    const std::string path =
        folder.write("study.toml",
                     "[study]\nmodel = \"model.toml\"\nsamples = 8\nseed = 1\n[variable.ft]\n"
                     "path = \"material.joint.tensile_strength\"\ndistribution = \"empirical\"\n"
                     "file = \"t.csv\"\n" +
                         (column.empty() ? "" : "column = \"" + column + "\"\n"));
    try {
      (void)read_study(path);
    } catch (const InputError& error) {
      const std::string text = to_string(error.faults().at(0));
      return text.substr(text.find("t.csv"));
    }
    return std::string();
  };
  EXPECT_EQ(fault("", ""), "t.csv: is empty; write a head such as ft_MPa and one value a line");
  EXPECT_EQ(fault("ft_MPa\n", ""),
            "t.csv: has no values; write a head such as ft_MPa and one value a line");
  EXPECT_EQ(fault("ft\n0.1\n", "").find("t.csv:1: = ft"), std::string::npos);
  EXPECT_NE(fault("ft\n0.1\n", "").find("the unit of this column is not known"), std::string::npos);
  EXPECT_NE(fault("ft_MPa,n\n0.1,3\n", "").find("has several columns; name one"),
            std::string::npos);
  EXPECT_NE(fault("ft_MPa\n0,1\n", "ft").find("t.csv:2: ft = 0,1: has 2 cells, the head has 1"),
            std::string::npos);
  EXPECT_NE(fault("ft_MPa\nabc\n", "ft").find("t.csv:2: ft = abc: must be a finite number"),
            std::string::npos);
  EXPECT_NE(fault("ft_MPa\n1\n", "fz").find("no such column in the head"), std::string::npos);
  EXPECT_EQ(fault("ft [kPa]\n100\n", "ft"), "");
}

TEST(StudyRefused, faults_of_the_base_model_and_of_settings) {
  EXPECT_EQ(joined(study_faults(kStudy, {"stage.push.velocty=1 mm/s"}), "\n"),
            "--set: stage.push.velocty = 1 mm/s: no such key velocty; did you mean velocity?");
  EXPECT_EQ(
      study_fault("set = [\"wall.unit.split=none\"]", "set = [\"wall.length=0 m\"]"),
      "study.toml:37: study.set: wall.length = 0 m: must be more than 0 m; write e.g. length = "
      "\"5.10 m\"");
  EXPECT_EQ(study_fault("length = \"5.10 m\"", "length = 5.1"),
            "model.toml:2: wall.length = 5.1: has no unit; write it with its unit, e.g. length = "
            "\"5.10 m\"");
}

TEST(StudyRefused, keys_that_are_missing_or_unknown) {
  EXPECT_EQ(
      study_fault("seed = 7\n", ""),
      "study.toml:30: study.seed: is missing; without it the samples could not be drawn again; "
      "write e.g. seed = 2026");
  EXPECT_EQ(study_fault("samples = 20", "sampels = 20"),
            "study.toml:30: study.samples: is missing; write e.g. samples = 250\n"
            "study.toml:32: study.sampels = 20: no such key sampels; did you mean samples?");
  EXPECT_EQ(
      study_fault("[variable.R]", "[varable.R]")
          .find("study.toml:12: varable = a table: no such key varable; did you mean variable?"),
      0U);
  EXPECT_EQ(
      study_fault("fractions = [0.8, 0.5]", "fractions = [0.8, 1]"),
      "study.toml:36: study.fractions = 1: must be more than 0 and less than 1, a share of the "
      "peak; write e.g. fractions = [0.8, 0.5]");
  EXPECT_EQ(study_fault("distribution = \"lognormal\"\n", "")
                .find("study.toml:1: variable.ft_j.distribution: is missing"),
            0U);
  EXPECT_EQ(
      joined(study_faults("[study]\nmodel = \"m\"\nsamples = 3\nseed = 1\nmodel_text = '''\n" +
                          kModel + "'''\n"),
             "\n")
          .find("study.toml: variable: is missing"),
      0U);
}

TEST(StudyRefused, everything_at_once_in_order_of_lines) {
  const std::string text =
      with(with(with(kStudy, "cov = 0.3", "cov = -1"), "1.5 * ft_j", "1.5 ft_j"), "samples = 20",
           "samples = 1");
  const Texts faults = study_faults(text);
  ASSERT_EQ(faults.size(), 3U) << joined(faults, "\n");
  EXPECT_TRUE(faults[0].starts_with("study.toml:5: variable.ft_j.cov"));
  EXPECT_TRUE(faults[1].starts_with("study.toml:18: dependent.c.formula"));
  EXPECT_TRUE(faults[2].starts_with("study.toml:32: study.samples"));
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
  void choice(const char* name, const E&, const io::Word<E> (&words)[N], const io::Key&) {
    names.emplace_back(name);
    for (const auto& word : words) names.emplace_back(word.word);
  }
};

TEST(StudyReference, has_every_key) {
  std::ifstream file(WYTHE_SOURCE_DIR "/docs/reference/study.md");
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
}  // namespace wythe
