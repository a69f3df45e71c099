// One list of columns serves both samples.csv and the file of a study with [shaking]. A sample without any shake has
// one row with its own status. Limit states are named only for shakes that count.
#include "io/results/shakes_csv.h"

#include <fmt/format.h>

#include <vector>

#include "core/text.h"
#include "io/text/csv.h"
#include "wythe/parts/statistics.h"

namespace wythe::io {
namespace {

struct ShakeColumn {
  const char* title;
  double ShakeResult::*value;
  double to_unit;
};
constexpr ShakeColumn kColumns[] = {
    {"pga_m_per_s2", &ShakeResult::pga, 1},
    {"pgv_m_per_s", &ShakeResult::pgv, 1},
    {"sa_m_per_s2", &ShakeResult::sa, 1},
    {"peak_drift_percent", &ShakeResult::peak_drift, 1e2},
    {"residual_drift_percent", &ShakeResult::residual_drift, 1e2},
    {"peak_displacement_mm", &ShakeResult::peak_displacement, 1e3},
    {"residual_displacement_mm", &ShakeResult::residual_displacement, 1e3},
    {"uplift_mm", &ShakeResult::uplift, 1e3},
    {"slip_mm", &ShakeResult::slip, 1e3},
    {"peak_base_shear_kN", &ShakeResult::peak_base_shear, 1e-3},
    {"collapse_time_s", &ShakeResult::collapse_time, 1},
    {"energy_gap_percent", &ShakeResult::gap_ratio, 1e2}};

// "m/s^2" -> "m_per_s2"
const char* unit_in_title(IntensityMeasure measure) {
  return measure == IntensityMeasure::kPgv ? "m_per_s" : "m_per_s2";
}

std::string states_reached(const StudySpec& study, const ShakeResult& shake) {
  std::vector<std::string> names;
  for (const LimitStateSpec& limit : study.shaking.limit_state)
    if (shake.counts() && reaches(limit, shake)) names.push_back(limit.name);
  return csv_cell(joined(names, "; "));
}

std::string inputs_of(const Campaign& campaign, const SampleRecord& record) {
  std::string text;
  for (std::size_t i = 0; i < record.inputs.size(); ++i) {
    const InputColumn& column = campaign.samples.column[i];
    text += "," + short_cell(record.inputs[i] * column.to_unit + column.offset);
  }
  return text;
}

}  // namespace

std::string shake_titles(const StudySpec& study) {
  std::string text;
  if (study.shaking.is_asked())
    text += fmt::format(",intensity_{}_{}", word_of(kIntensityMeasureWords, study.shaking.measure),
                        unit_in_title(study.shaking.measure));
  for (const ShakeColumn& column : kColumns) text += fmt::format(",{}", column.title);
  return text + ",shaken_to_collapse,counts,limit_states";
}

std::string shake_cells(const StudySpec& study, const ShakeResult& shake) {
  std::string text;
  if (study.shaking.is_asked()) text += "," + short_cell(shake.intensity);
  for (const ShakeColumn& column : kColumns)
    text += "," + short_cell(shake.*column.value * column.to_unit);
  return text + fmt::format(",{},{},{}", shake.collapsed ? 1 : 0, shake.counts() ? 1 : 0,
                            states_reached(study, shake));
}

std::string shakes_csv(const Campaign& campaign) {
  const StudySpec& study = campaign.study;
  std::string text = "sample,wall,record";
  for (const InputColumn& column : campaign.samples.column)
    text += "," + csv_cell(column_title(column));
  text += ",status" + shake_titles(study) + ",retried,state_hash\n";
  for (const SampleRecord& record : campaign.records) {
    const SampleCase of = case_of(study, record.sample - 1);
    const std::string head = fmt::format("{},{},{}", record.sample, of.wall + 1,
                                         csv_cell(study.shaking.record[of.record].name)) +
                             inputs_of(campaign, record);
    if (record.shakes.empty())
      text += head + "," + csv_cell(record.status) + shake_cells(study, {}) + ",0,\n";
    for (const ShakeResult& shake : record.shakes)
      text += head + "," + csv_cell(shake.status) + shake_cells(study, shake) +
              fmt::format(",{},{}\n", shake.retried ? 1 : 0, shake.state_hash);
  }
  return text;
}

}  // namespace wythe::io
