// Study files that are refused: for each bad input the place, the value and the cure that its message
// names.
#include <gtest/gtest.h>

#include "unit/study_text.h"

namespace wythe::study_faults_test {
namespace {

using namespace io_tests;

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
                .find("did you mean material.joint.cohesion?"),
            std::string::npos);
  const std::string stage =
      study_fault("material.joint.tensile_strength", "stage.gravity.velocity");
  EXPECT_NE(stage.find("no such number in the model"), std::string::npos) << stage;
}

TEST(StudyRefused, cycle_with_its_way) {
  EXPECT_EQ(
      study_fault("\"0.029 mm + 0 mm * R\"", "\"GI / ft_j\""),
      "study.toml:21: dependent.GI.formula = w * ft_j: depends on itself: GI -> w -> GI; let one "
      "of them follow from variables only");
  EXPECT_NE(study_fault("\"0.029 mm + 0 mm * R\"", "\"w\"").find("w -> w"), std::string::npos);
}

TEST(StudyRefused, formula_of_another_unit_than_its_key) {
  EXPECT_EQ(study_fault("1.5 * ft_j", "3 mm * ft_j"),
            "study.toml:18: dependent.c.formula = 3 mm * ft_j: gives a force per length or an "
            "energy per area [N/m], but "
            "material.joint.cohesion is a stress [Pa]; make it a formula in MPa");
  EXPECT_EQ(study_fault("atan(0.9 * tan(phi))", "ft_j"),
            "study.toml:26: dependent.phi_res.formula = ft_j: gives a stress [Pa], but "
            "material.joint.residual_friction_angle is a number; make it a formula in deg");
  EXPECT_NE(study_fault("\"0.029 mm + 0 mm * R\"", "\"sqrt(2 mm)\"").find("a fractional power"),
            std::string::npos);
}

TEST(StudyRefused, bare_number_for_a_quantity) {
  EXPECT_EQ(
      study_fault("\"0.15 MPa\"", "0.15"),
      "study.toml:4: variable.ft_j.mean = 0.15: has no unit; write it with its unit, e.g. mean = "
      "\"1 MPa\"");
  EXPECT_EQ(study_fault("mean = 0.5", "mean = \"0.5 MPa\""),
            "study.toml:12: variable.R.path: is missing, and mean = 0.5 MPa has a unit; write the "
            "key that this varies, e.g. path = \"material.joint.tensile_strength\"; or unit = "
            "\"MPa\" of a value for formulas alone");
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
  EXPECT_TRUE(
      study_fault("[dependent.c]", "[dependent.R]")
          .starts_with(
              "study.toml:16: dependent.R: there is a variable of this name; give it a name "
              "of its own"));
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

// Ranks of few values correlate less than the normal variables behind them say.
TEST(StudyRefused, the_nearest_matrix_of_few_values_is_one_too) {
  const Folder folder;
  folder.write("model.toml", kModel);
  folder.write("t.csv", "ft_MPa\n0.1\n0.2\n0.3\n");
  const auto faults = [&](const std::string& a, const std::string& b, const std::string& c) {
    std::string text = "[study]\nmodel = \"model.toml\"\nsamples = 8\nseed = 1\n";
    for (const char* name : {"tensile_strength", "cohesion", "compressive_strength"})
      text += std::string("[variable.") + name + "]\npath = \"material.joint." + name +
              "\"\ndistribution = \"empirical\"\nfile = \"t.csv\"\n";
    const auto pair = [&](const char* first, const char* second, const std::string& rank) {
      text += std::string("[[correlation]]\nbetween = [\"") + first + "\", \"" + second +
              "\"]\nrank = " + rank + "\n";
    };
    pair("tensile_strength", "cohesion", a);
    pair("cohesion", "compressive_strength", b);
    pair("tensile_strength", "compressive_strength", c);
    try {
      (void)read_study(folder.write("study.toml", text));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string fault = faults("0.8", "0.75", "0.05");
  ASSERT_NE(fault.find("the nearest that is one: "), std::string::npos) << fault;
  const auto rank_of = [&](const std::string& pair) {
    const std::size_t at = fault.find(pair + " rank = ") + pair.size() + 8;
    return fault.substr(at, fault.find(',', at) - at);
  };
  EXPECT_EQ(
      faults(rank_of("tensile_strength and cohesion"), rank_of("cohesion and compressive_strength"),
             rank_of("tensile_strength and compressive_strength")),
      "");
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
  for (const char* csv : {"n;ft (MPa)\n1;0,1\n2;0,2\n", ",ft_MPa\n0,0.1\n1,0.2\n",
                          "wall\tft [N/mm^2]\nA\t0.1\nB\t0.2\n", "n ft_MPa\n1 0.1\n2 0.2\n"})
    EXPECT_EQ(fault(csv, "ft"), "") << csv;
  EXPECT_EQ(fault(",ft_MPa\n0,0.1\n1,0.2\n", ""), "");
  EXPECT_NE(fault("ft_MPa,ft_kPa\n0.1,100\n", "ft").find("several columns of this name"),
            std::string::npos);
  EXPECT_NE(fault("n;ft_MPa\n1;0,1\n2;0.2\n", "ft").find("another decimal mark"),
            std::string::npos);
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

TEST(StudyRefused, a_setting_of_what_an_input_sets) {
  EXPECT_EQ(
      joined(study_faults(kStudy, {"material.joint.tensile_strength=0.14 MPa"}), "\n"),
      "--set: material.joint.tensile_strength: has no effect, it is set by variable.ft_j; leave "
      "it out, or change variable.ft_j instead, e.g. --set variable.ft_j.mean=...");
  EXPECT_TRUE(
      study_fault("set = [\"wall.unit.split=none\"]", "set = [\"material.joint.cohesion=0.2 MPa\"]")
          .starts_with("study.toml:37: study.set: material.joint.cohesion: has no effect, it "
                       "is set by dependent.c"));
}

TEST(StudyRefused, a_stop_rule_that_is_none) {
  EXPECT_TRUE(study_fault("seed = 7\n", "seed = 7\nuntil = \"x\"\n")
                  .starts_with("study.toml:34: study.until = x: "));
}

TEST(StudyRefused, a_variable_nothing_uses) {
  EXPECT_EQ(
      study_fault("[variable.R]",
                  "[variable.idle]\ndistribution = \"normal\"\nmean = 1\ncov = 0.1\n[variable.R]"),
      "study.toml:12: variable.idle: nothing uses it: it has no path, and no formula names it; "
      "write path = \"...\", use it in a formula, or leave it out");
}

TEST(StudyRefused, a_fraction_that_stands_there_twice) {
  EXPECT_EQ(study_fault("fractions = [0.8, 0.5]", "fractions = [0.5, 0.5]"),
            "study.toml:36: study.fractions = 0.5: stands there twice; leave one of them out");
}

TEST(StudyRefused, files_that_are_not_there) {
  const Folder folder;
  folder.write("model.toml", kModel);
  const auto fault = [&](const std::string& head, const std::string& variable) {
    const std::string path =
        folder.write("study.toml", "[study]\n" + head +
                                       "samples = 8\nseed = 1\n[variable.ft]\npath = "
                                       "\"material.joint.tensile_strength\"\n" +
                                       variable);
    try {
      (void)read_study(path);
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.find("study.toml"));
    }
    return std::string();
  };
  const std::string normal = "distribution = \"normal\"\nmean = \"0.1 MPa\"\ncov = 0.1\n";
  const std::string model = fault("model = \"nope.toml\"\n", normal);
  EXPECT_TRUE(model.starts_with("study.toml:2: study.model = nope.toml: can't read ")) << model;
  EXPECT_NE(model.find("name the base model, relative to the study file"), std::string::npos);
  const std::string values =
      fault("model = \"model.toml\"\n", "distribution = \"empirical\"\nfile = \"nope.csv\"\n");
  EXPECT_TRUE(values.starts_with("study.toml:8: variable.ft.file = nope.csv: can't read "))
      << values;
}

TEST(StudyNotes, what_the_push_does_not_reach) {
  StudySpec study = parsed(kStudy);
  const double end = model_builder(study)({}).stage.back().get<PushStage>().until;
  study.states = {end, 1.5 * end};
  study.read_modes_at = 2 * end;
  const ModelSpec base = model_builder(parsed(kStudy))({});
  const std::vector<Message> notes = notes_of(study, base);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_TRUE(text_of(notes[0]).starts_with("study.states asks for a state at "));
  EXPECT_TRUE(text_of(notes[1]).starts_with("failure modes are named at "));
  study.states.clear(), study.read_modes_at = end;
  EXPECT_TRUE(notes_of(study, base).empty());
}

TEST(StudyRefused, keys_that_are_missing_or_unknown) {
  EXPECT_EQ(
      study_fault("seed = 7\n", ""),
      "study.toml:30: study.seed: is missing; without it the samples could not be drawn again; "
      "write e.g. seed = 2026");
  EXPECT_EQ(study_fault("samples = 20", "sampels = 20"),
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

}  // namespace
}  // namespace wythe::study_faults_test
