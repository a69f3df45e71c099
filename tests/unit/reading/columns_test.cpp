// One line in kCurveColumns is a column everywhere: in the CSV, the store, the
// page and the reference. Every enumerator that a file stores keeps its value.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "campaign/draws/distribution.h"
#include "campaign/store/record_rows.h"
#include "campaign/store/store_schema.h"
#include "io/results/curve_csv.h"
#include "report/bundle.h"
#include "scenes/places.h"
#include "scenes/sample_run.h"
#include "wythe/parts/curve.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/report.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/statistics.h"

namespace wythe::columns_test {
namespace {

// Rows in which every value of every column differs.
std::vector<CurveRow> unlike_rows() {
  std::vector<CurveRow> rows(3);
  double value = 0;
  for (CurveRow& row : rows)
    for (const CurveColumn& column : kCurveColumns) row.*column.value = (value += 0.125);
  return rows;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

std::string text_of(const char* page) {
  std::ifstream file((source_dir() + "/docs/reference/") + page);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> stored_names() { return cells_of(study::curve_column_names()); }

TEST(Columns, csv_has_each_in_its_unit) {
  const std::vector<CurveRow> rows = unlike_rows();
  std::istringstream csv(io::curve_csv(rows, {true, true}));
  std::string line;
  std::getline(csv, line);
  const std::vector<std::string> names = cells_of(line);
  ASSERT_EQ(names.size(), std::size(kCurveColumns));
  for (const CurveRow& row : rows) {
    ASSERT_TRUE(std::getline(csv, line));
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), names.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const CurveColumn& column = kCurveColumns[i];
      EXPECT_EQ(names[i], column.name);
      EXPECT_NEAR(std::stod(cells[i]) / (row.*column.value * column.to_unit), 1, 1e-9) << names[i];
    }
  }
}

TEST(Columns, csv_begins_with_those_that_are_promised) {
  const std::string promised =
      "time_s,displacement_mm,drift_percent,reaction_kN,base_shear_kN,unbalance_ratio,"
      "kinetic_ratio,";
  EXPECT_EQ(io::curve_csv({}).substr(0, promised.size()), promised);
  EXPECT_EQ(io::curve_csv({}).find("lintel"), std::string::npos);
}

TEST(Columns, store_keeps_each_exactly_under_its_own_name) {
  const std::vector<CurveRow> rows = unlike_rows();
  const std::vector<std::string> names = stored_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), std::size(kCurveColumns));
  const std::vector<CurveRow> back = study::curve_rows(study::curve_columns(rows), names);
  ASSERT_EQ(back.size(), rows.size());
  for (const CurveColumn& column : kCurveColumns)
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_EQ(back[i].*column.value, rows[i].*column.value) << column.stored;
}

// A column may come without a new version of the store: one may hold fewer, others, or the same in another order.
TEST(Columns, store_is_read_by_names_not_by_places) {
  const std::vector<CurveRow> rows = unlike_rows();
  const std::vector<double> few = {rows[0].reaction, rows[1].reaction, 7, 8,
                                   rows[0].time,     rows[1].time};
  const std::vector<CurveRow> back =
      study::curve_rows(few, {"reaction_N", "of_tomorrow", "time_s"});
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[1].reaction, rows[1].reaction);
  EXPECT_EQ(back[1].time, rows[1].time);
  EXPECT_TRUE(std::isnan(back[1].displacement));
}

TEST(Columns, page_has_each_that_its_wall_shows) {
  Result result = scenes::sample_result();
  result.curve = unlike_rows();
  const report::Json arrays =
      report::header_of(run_data(scenes::sample_spec(), scenes::sample_model(), result))["arrays"];
  for (const CurveColumn& column : columns_shown({}))
    EXPECT_EQ(arrays[std::string("curve.") + column.name].value("count", 0), 3) << column.name;
  EXPECT_EQ(columns_of(scenes::sample_model()), ShownColumns{});
  EXPECT_FALSE(arrays.contains("curve.lintel_axial_kN"));
  EXPECT_EQ(columns_shown({true, true}).size(), std::size(kCurveColumns));
}

TEST(Columns, reference_has_each_with_its_unit) {
  EXPECT_NE(text_of("results.md").find(curve_table()), std::string::npos)
      << "the table is not that of kCurveColumns: make docs";
  for (const CurveColumn& column : kCurveColumns)
    EXPECT_NE(curve_table().find(std::string("| `") + column.name + "` | " + column.unit + " |"),
              std::string::npos);
}

// --- answers -------------------------------------------------------------------------------------

std::vector<OutputKey> output_keys() {
  std::vector<OutputKey> keys;
  const auto add = [&](const OutputKey& key, const auto&) { keys.push_back(key); };
  const SampleRecord any;
  each_response(add, any.responses);
  each_quasi_static(add, any.quasi_static);
  return keys;
}

TEST(Answers, each_is_in_the_summary_and_its_reference) {
  const auto summary =
      report::Json::parse(summary_json(scenes::sample_model(), scenes::sample_result()));
  const std::string page = text_of("results.md");
  EXPECT_NE(page.find(responses_table()), std::string::npos)
      << "the table is not that of each_response(): make docs";
  for (const OutputKey& key : output_keys()) {
    std::string path = "/" + std::string(key.summary);
    if (const auto dot = path.find('.'); dot != std::string::npos) path[dot] = '/';
    EXPECT_TRUE(summary.contains(report::Json::json_pointer(path))) << path;
    EXPECT_NE(page.find(fmt::format("| `{}` | {} |", key.summary, key.unit)), std::string::npos)
        << path;
    EXPECT_NE(std::string(key.meaning), "") << path;
  }
}

TEST(Answers, each_has_columns_of_its_own_in_the_store_its_view_and_the_csv) {
  const Campaign none;
  const std::string schema = study::schema_sql(), view = study::samples_view_sql(none.samples),
                    csv = samples_csv(none), page = text_of("results.md");
  std::set<std::string> stored, columns;
  for (const OutputKey& key : output_keys()) {
    EXPECT_TRUE(stored.insert(key.stored).second) << key.stored;
    EXPECT_NE(schema.find(std::string(", ") + key.stored + " "), std::string::npos) << key.stored;
    if (key.listed == OutputKey::kNowhere) continue;
    EXPECT_TRUE(columns.insert(key.column).second) << key.column;
    EXPECT_NE(view.find(std::string(" AS ") + key.column), std::string::npos) << key.column;
    EXPECT_NE(page.find(std::string("`") + key.column + "`"), std::string::npos) << key.column;
    EXPECT_EQ(csv.find(std::string(",") + key.column + ",") != std::string::npos,
              key.listed == OutputKey::kCsv)
        << key.column;
  }
}

// What statistics are made of goes by the same names and units as the samples it is made from.
TEST(Answers, of_the_statistics_are_those_of_the_samples) {
  for (const Quantity& q : quantities()) {
    if (std::string(q.name) == "displacement_at_50_percent") continue;  // a fraction, asked for
    std::size_t found = 0;
    for (const OutputKey& key : output_keys())
      found += key_of(q) == key.column && q.to_unit == key.to_unit;
    EXPECT_EQ(found, 1U) << key_of(q);
  }
}

// --- words ---------------------------------------------------------------------------------------

TEST(Words, go_to_the_page_by_the_number_that_stands_for_them) {
  const report::Json wall = report::header_of(
      run_data(scenes::sample_spec(), scenes::sample_model(), scenes::sample_result()))["wall"];
  ASSERT_EQ(wall["kinds"].size(), std::size(kJointKindWords));
  for (const auto& [word, kind] : kJointKindWords)
    EXPECT_EQ(wall["kinds"][static_cast<std::size_t>(kind)], word);
  for (const auto& [word, role] : kBlockRoleWords)
    EXPECT_EQ(wall["roles"][static_cast<std::size_t>(role)], word);
}

// What a VTU file and the seeds of samples are made of: a value that moved would relabel the one and draw
// other samples from the other.
TEST(Words, numbers_that_stand_in_files_never_change) {
  EXPECT_EQ(static_cast<int>(BlockRole::kBeam), 3);
  EXPECT_EQ(static_cast<int>(BlockRole::kRingBeam), 4);
  EXPECT_EQ(static_cast<int>(BlockRole::kSill), 5);
  EXPECT_EQ(static_cast<int>(JointKind::kFoundation), 3);
  EXPECT_EQ(static_cast<int>(JointKind::kOther), 8);
  EXPECT_EQ(static_cast<int>(Design::kMonteCarlo), 1);
  EXPECT_EQ(static_cast<int>(Design::kSobol), 2);
}

TEST(Words, each_distribution_says_what_it_takes) {
  std::set<std::string> parameters = {"spread"};
  for (const study::VariableParameter& p : study::kVariableParameters) parameters.insert(p.name);
  for (const auto& [word, kind] : kDistributionWords) {
    const study::DistributionForms& takes = study::forms_of(kind);
    EXPECT_NE(std::string(takes.words).size(), 0U) << word;
    EXPECT_FALSE(takes.forms.empty()) << word;
    for (const std::vector<std::string>& form : takes.forms)
      for (const std::string& name : form) EXPECT_TRUE(parameters.contains(name)) << word << name;
  }
}

// A page in another language finds a text for every word that it may show.
TEST(Words, of_a_page_have_their_texts) {
  std::ifstream file(source_dir() + "/src/report/assets/texts.json");
  const report::Json texts = report::Json::parse(file);
  const auto expect_each = [&](const std::string& before, const auto& words) {
    for (const auto& [word, value] : words)
      EXPECT_TRUE(texts[before.empty() ? "phrases" : "texts"].contains(before + word))
          << before << word;
  };
  expect_each("", kBondWords);
  expect_each("", kSofteningWords);
  expect_each("", kCouplingWords);
  expect_each("", kUnloadingWords);
  expect_each("", kDistributionWords);
  expect_each("stage.", kStageKindWords);
  expect_each("joint.", kJointKindWords);
  expect_each("hypothesis.", kHypothesisWords);
}

// The words outlive the order of the enumerators: what is kept under one is read as the same value.
TEST(Words, are_read_back_as_the_value_that_they_name) {
  for (const auto& [word, kind] : kStageKindWords) EXPECT_EQ(value_of(kStageKindWords, word), kind);
  for (const auto& [word, bond] : kBondWords) EXPECT_STREQ(word_of(kBondWords, bond), word);
  EXPECT_FALSE(value_of(kBondWords, "Running").has_value());
  EXPECT_STREQ(word_of(kMannerWords, Manner::kDefault), "");
}

}  // namespace
}  // namespace wythe::columns_test
