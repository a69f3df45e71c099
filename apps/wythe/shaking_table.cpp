// Intensities, limit states and fragilities of a study with records. A number has its interval, or the reason why
// there is none.
#include "shaking_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "notes.h"
#include "progress.h"
#include "wythe/io.h"
#include "wythe/solve.h"

namespace wythe::app {
namespace {

constexpr std::size_t kLostShown = 8;

std::string measure_text(const ShakingSpec& shaking) {
  if (shaking.measure != IntensityMeasure::kSa)
    return word_of(kIntensityMeasureWords, shaking.measure);
  return fmt::format("sa({:g} s, {:g} %)", shaking.period, 100 * shaking.damping);
}

std::string interval_text(const Interval& interval, const char* format) {
  const auto end = [&](double value) {
    return std::isnan(value) ? std::string("?") : fmt::format(fmt::runtime(format), value);
  };
  return end(interval.low) + " to " + end(interval.high);
}

// Why there is no result, in words.
std::string reason_of(const LimitStateFragility& f) {
  switch (f.verdict) {
    case LimitStateVerdict::kTold: return "";
    case LimitStateVerdict::kFewRecords:
      return fmt::format("not determined: fewer than {} records", kFewestRecords);
    case LimitStateVerdict::kNever: return "not determined: no sample reached it; shake harder";
    case LimitStateVerdict::kAlways:
      return "not determined: every sample reached it at its lowest intensity; begin lower";
    case LimitStateVerdict::kSeparated:
      return "not determined: one intensity separates those that reached it from the others, so "
             "that the dispersion is not known; take closer intensities or more records";
    case LimitStateVerdict::kNoTrend:
      return "not determined: it is reached no more often at higher intensities";
  }
  return "";
}

}  // namespace

void add_record_notes(const Model& model, std::vector<Message>& notes) {
  for (const Message& note : model.anatomy.notes) {
    const auto is_same = [&](const Message& other) { return text_of(other) == text_of(note); };
    if (note.code.starts_with("shake.") && std::none_of(notes.begin(), notes.end(), is_same))
      notes.push_back(note);
  }
}

std::string intensity_text(const ShakingSpec& shaking, double intensity) {
  return fmt::format("{:.6g} {}", intensity, unit_of(shaking.measure));
}

double print_shakes_asked(const StudySpec& study, const SampleTable& samples,
                          const ModelBuilder& build) {
  const ShakingSpec& shaking = study.shaking;
  std::vector<double> seconds(shaking.record.size(), -1);
  double least = 0, most = 0;
  std::vector<Message> notes;
  const ShakeCount count = count_shakes(study);
  for (int s = 0; s < samples.n_sample(); ++s) {
    double& one = seconds[case_of(study, s).record];
    if (one < 0) one = 0;
    if (one > 0) continue;
    try {
      const Model model = compile(build(settings_of(samples, s)));
      one = estimate(model).seconds;
      add_record_notes(model, notes);
    } catch (const InputError&) {  // this sample is refused, so another one is used
    }
  }
  print_notes(notes, true);
  for (int s = 0; s < samples.n_sample(); ++s) least += seconds[case_of(study, s).record];
  const double each = least / std::max(1, samples.n_sample());
  least = each * count.least, most = each * count.most;
  fmt::print("{} records, {} of intensity, {} limit states\n", shaking.record.size(),
             measure_text(shaking), shaking.limit_state.size());
  if (count.least == count.most)
    fmt::print("{} shakes of {} samples\n", count.most, samples.n_sample());
  else
    fmt::print("{} to {} shakes of {} samples, as they collapse\n", count.least, count.most,
               samples.n_sample());
  return most;
}

void print_shaking(const ShakingStatistics& s) {
  const char* const measure = word_of(kIntensityMeasureWords, s.shaking.measure);
  fmt::print("{} shakes: {} stood, {} collapsed, {} not counted\n", s.shakes, s.stood, s.collapsed,
             s.lost.size());
  for (std::size_t i = 0; i < std::min(kLostShown, s.lost.size()); ++i)
    fmt::print("  not counted: sample {} at {}: {}{}\n", s.lost[i].sample,
               intensity_text(s.shaking, s.lost[i].intensity), s.lost[i].status,
               s.lost[i].reason.empty() ? "" : ", " + readable(text_of(s.lost[i].reason)));
  if (s.lost.size() > kLostShown) fmt::print("  and {} more\n", s.lost.size() - kLostShown);
  if (!s.damping.empty()) fmt::print("damping: {}\n", fmt::join(texts_of(s.damping), "; "));
  if (!s.shaking.is_asked()) return;
  fmt::print("{:<24} {:>4} {:>8} {:>12} {:>22} {:>7} {:>16}\n", "limit state", "n", "reached",
             fmt::format("median {}", measure), "95 % interval", "beta", "95 % interval");
  for (const LimitStateFragility& f : s.fragility) {
    fmt::print("{:<24} {:>4} {:>8} ", readable(f.limit_state.name), f.n, f.reached);
    if (f.verdict != LimitStateVerdict::kTold) {
      fmt::print("{}\n", reason_of(f));
      continue;
    }
    fmt::print("{:>12} {:>22} {:>7.3f} {:>16}\n", intensity_text(s.shaking, f.median.value),
               interval_text(f.median.interval, "{:.4g}"), f.beta.value,
               interval_text(f.beta.interval, "{:.3f}"));
    if (f.lost > 0)
      fmt::print(
          "  {} samples are left out, since shakes that decide do not count: the median "
          "would be {} to {} with them\n",
          f.lost, intensity_text(s.shaking, f.median_if_reached),
          intensity_text(s.shaking, f.median_if_not));
    if (f.scatter.verdict == ScatterVerdict::kTold)
      fmt::print(
          "  scatter of ln {}: {:.3f} from record to record, {:.3f} from wall to wall, "
          "{:.3f} of both together\n",
          measure, f.scatter.record.value, f.scatter.wall.value, f.scatter.rest.value);
  }
}

}  // namespace wythe::app
