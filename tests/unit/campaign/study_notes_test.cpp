// Values that no masonry has are noted for a study as for a model, by the same function.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "model/densities.h"
#include "unit/study_text.h"
#include "wythe/parts/study_notes.h"

namespace wythe::study_notes_test {
namespace {

using io_tests::kStudy;
using io_tests::parsed;

std::string notes_with(const std::vector<std::string>& settings) {
  const StudySpec study = parsed(kStudy, settings);
  std::string all;
  for (const std::string& note :
       texts_of(notes_of_values(study, draw_samples(study), model_builder(study))))
    all += note + '\n';
  return all;
}

void expect_noted(const std::vector<std::string>& settings, const std::string& words) {
  const std::string notes = notes_with(settings);
  EXPECT_NE(notes.find(words), std::string::npos) << notes;
}

TEST(StudyNotes, none_of_values_that_masonry_has) { EXPECT_EQ(notes_with({}), ""); }

TEST(StudyNotes, a_value_of_the_base_model) {
  expect_noted({"wall.unit.density=1.8 kg/m^3"}, "wall.unit.density is 1.8 kg/m3");
}

TEST(StudyNotes, megapascals_of_concrete_for_gigapascals) {
  ModelSpec spec;
  spec.material["concrete"].youngs_modulus = 15e6;
  const std::vector<std::string> notes = texts_of(notes_of_values(spec));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("material.concrete.youngs_modulus is 0.015 GPa"), std::string::npos);
  spec.material["concrete"].youngs_modulus = 60e6;  // adobe
  EXPECT_TRUE(notes_of_values(spec).empty());
}

TEST(StudyNotes, the_mean_of_a_variable) {
  expect_noted({"variable.ft_j.mean=0.15 kPa"},
               "material.joint.tensile_strength by variable.ft_j is 0.000");
  expect_noted({"variable.phi.mean=0.6 deg", "variable.phi.lower=0.1 deg"},
               "material.joint.friction_angle by variable.phi is 0.");
}

TEST(StudyNotes, what_follows_by_a_formula) {
  expect_noted({"dependent.c.formula=1e-6 * ft_j"},
               "material.joint.cohesion by dependent.c is 1.4");
}

TEST(StudyNotes, a_variable_sets_an_odd_value_of_the_base_model_right) {
  const std::string line = "mode_1_energy = \"4.3 N/m\"";
  std::string text = kStudy;
  text.replace(text.find(line), line.size(), "mode_1_energy = \"430 kN/m\"");
  const StudySpec study = parsed(text);
  EXPECT_TRUE(notes_of_values(study, draw_samples(study), model_builder(study)).empty());
}

TEST(StudyNotes, percent_for_a_share) {
  expect_noted(
      {"variable.ft_j.cov=20"},
      "variable.ft_j.cov is 20, a scatter of 2000 %: for 20 % write variable.ft_j.cov = 0.2");
  expect_noted({"variable.R.cov=5"}, "for 5 % write variable.R.cov = 0.05");
}

TEST(StudyNotes, a_deviation_in_another_unit_than_the_mean) {
  for (const auto& [deviation, share] :
       {std::pair("45 MPa", "30000 %"), std::pair("45 N/m^2", "0.03 %")}) {
    std::string text = kStudy;
    const std::string cov = "cov = 0.3";
    text.replace(text.find(cov), cov.size(),
                 std::string("standard_deviation = \"") + deviation + "\"");
    const StudySpec study = parsed(text);
    std::string all;
    for (const std::string& note :
         texts_of(notes_of_values(study, draw_samples(study), model_builder(study))))
      all += note + '\n';
    EXPECT_NE(all.find(std::string("variable.ft_j.standard_deviation is ") + share +
                       " of the mean: check the units of both"),
              std::string::npos)
        << all;
  }
}

}  // namespace
}  // namespace wythe::study_notes_test
