// Inputs of a study are columns of its results: none may have the name of another column, in any case.
#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include "campaign/draws/result_columns.h"
#include "io/export/export_samples.h"
#include "io/results/shakes_csv.h"
#include "unit/study_text.h"
#include "wythe/parts/campaign.h"

namespace wythe::input_names_test {
namespace {

using namespace io_tests;

std::string named(const std::string& name, const std::string& unit = "") {
  const std::string mean = unit.empty() ? "0.5" : "\"0.5 " + unit + "\"\nunit = \"" + unit + '"';
  return joined(
      study_faults(added("[variable." + name +
                         "]\ndistribution = \"normal\"\ncov = 0.2\nmean = " + mean + "\n")),
      "\n");
}

TEST(InputName, of_a_result_column_is_refused_with_its_place_and_a_cure) {
  const std::string said = named("status");
  EXPECT_TRUE(said.starts_with("study.toml:")) << said;
  EXPECT_NE(said.find("variable.status: results have a column status of their own; rename it, e.g. "
                      "status_input"),
            std::string::npos)
      << said;
  for (const char* name :
       {"sample", "Status", "REASON", "failure_mode", "peak_reaction_kN", "PEAK_REACTION_KN",
        "state_hash", "censored_50", "record", "wall", "displacement_at_35_percent_mm",
        "rate_judgement", "read_in", "bilinear_ductility", "peak_drift_percent", "limit_states"})
    EXPECT_NE(named(name).find("of their own"), std::string::npos) << name;
}

// The column is named after the unit too.
TEST(InputName, with_its_unit_is_what_counts) {
  EXPECT_NE(named("displacement_max", "mm").find("displacement_max_mm of their own"),
            std::string::npos)
      << named("displacement_max", "mm");
  for (const auto& [name, unit] :
       {std::pair{"displacement_max", "MPa"}, {"peak_reaction", ""}, {"censored_wall", ""}})
    EXPECT_EQ(named(name, unit).find("of their own"), std::string::npos) << name;
}

TEST(InputName, that_gives_the_column_of_another_in_other_letters_is_refused) {
  EXPECT_NE(named("r").find("variable.r: its column of the results, r, has the name of that of "
                            "variable.R, but for the case of letters"),
            std::string::npos)
      << named("r");
  EXPECT_NE(named("FT_J_MPa").find("that of variable.ft_j"), std::string::npos)
      << named("FT_J_MPa");
  EXPECT_NE(named("W", "m").find("that of"), std::string::npos) << named("W", "m");  // of a formula
  EXPECT_EQ(named("r", "MPa").find("that of"), std::string::npos);
}

// The list in result_columns.cpp against what is written.
TEST(InputName, every_column_that_is_written_is_barred) {
  Campaign campaign;
  campaign.study = parsed(kStudy);
  SampleRecord record;
  record.curve.resize(3);
  std::string heads = "sample,wall,record";
  for (const IntensityMeasure measure :
       {IntensityMeasure::kPga, IntensityMeasure::kPgv, IntensityMeasure::kSa}) {
    StudySpec shaken = campaign.study;
    shaken.shaking.stage = "shake";
    shaken.shaking.measure = measure;
    shaken.shaking.record.resize(1);
    shaken.shaking.limit_state.resize(1);
    heads += io::shake_titles(shaken);
  }
  heads += "," + samples_csv(campaign).substr(0, samples_csv(campaign).find('\n'));
  for (const io::ExportCell& cell : io::sample_cells(campaign, record))
    heads += "," + cell.column.name;
  std::istringstream titles(heads);
  int count = 0;
  for (std::string title; std::getline(titles, title, ','); ++count)
    EXPECT_TRUE(study::is_result_column(title)) << title;
  EXPECT_GT(count, 80);
  for (const char* title : {"read_in", "peak_reaction_positive_kN", "censored_80_negative"})
    EXPECT_TRUE(study::is_result_column(title)) << title;
}

}  // namespace
}  // namespace wythe::input_names_test
