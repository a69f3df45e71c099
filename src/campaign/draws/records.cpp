// case_of, count_samples, intensity_setting: the wall and the record of a sample.
#include "campaign/draws/records.h"

#include <fmt/format.h>

#include <numeric>

namespace wythe {

double first_intensity(const ShakingSpec& shaking, const StudyRecord& record) {
  if (!record.levels.empty()) return record.levels.front();
  return shaking.climbs() ? shaking.first : shaking.levels.front();
}

int count_samples(const StudySpec& study) {
  const int walls = std::accumulate(study.batch.begin(), study.batch.end(), 0);
  const bool each = study.shaking.is_asked() && study.shaking.pairing == Pairing::kEach;
  return each ? walls * static_cast<int>(study.shaking.record.size()) : walls;
}

SampleCase case_of(const StudySpec& study, int sample) {
  const ShakingSpec& shaking = study.shaking;
  if (!shaking.is_asked()) return {.wall = sample, .record = -1};
  const int records = static_cast<int>(shaking.record.size());
  if (shaking.pairing == Pairing::kInTurn) return {.wall = sample, .record = sample % records};
  return {.wall = sample / records, .record = sample % records};
}

const char* unit_of(IntensityMeasure measure) {
  return measure == IntensityMeasure::kPgv ? "m/s" : "m/s^2";
}

std::string intensity_setting(const ShakingSpec& shaking, double intensity) {
  const char* const word = word_of(kIntensityMeasureWords, shaking.measure);
  std::string value = fmt::format("{} = \"{:.17g} {}\"", word, intensity, unit_of(shaking.measure));
  if (shaking.measure == IntensityMeasure::kSa)
    value +=
        fmt::format(", period = \"{:.17g} s\", damping = {:.17g}", shaking.period, shaking.damping);
  return fmt::format("stage.{}.scale={{ {} }}", shaking.stage, value);
}

}  // namespace wythe
