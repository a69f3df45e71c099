// Prints statistics that the library computed: groups by mode, the assessment, inputs that cannot be told apart,
// and a warning where pushes were too fast.
#include "campaign_table.h"

#include <fmt/core.h>

#include <cmath>

#include "shaking_table.h"

namespace wythe::app {
namespace {

std::string cell(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

// "231.4 +- 3.2": the mean and half its interval.
std::string mean_cell(const Summary& summary, double to_unit) {
  const Estimate& mean = summary.mean;
  if (std::isnan(mean.value)) return "-";
  const double half = 0.5 * mean.interval.width();
  if (std::isnan(half)) return fmt::format("{:.2f}", mean.value * to_unit);
  return fmt::format("{:.2f} +- {:.2f}", mean.value * to_unit, half * to_unit);
}

std::string share_cell(const Statistics& statistics, const GroupSummary& group) {
  for (const Share& share : statistics.share)
    if (share.name == group.name)
      return fmt::format("{:.0f} ({:.0f}-{:.0f})", 100 * share.share.value,
                         100 * share.share.interval.low, 100 * share.share.interval.high);
  return "";
}

void print_entangled(const std::vector<InputCorrelation>& pairs) {
  if (!pairs.empty() && std::fabs(pairs.front().rank) > kEntangled)
    fmt::print(
        "note: {} and {} were drawn with a rank correlation of {:.3f}, so their influences "
        "cannot be told apart\n",
        pairs.front().a, pairs.front().b, pairs.front().rank);
}

// Printed before the table, so that its numbers are not read without it.
void print_assessment(const CampaignAssessment& a) {
  if (a.spec.code.empty()) return;
  const Message said = sentence_of(a);
  const bool is_signed = a.reason.empty() && said.code != "assessment.unsigned";
  fmt::print("{}assessment, {}: {}\n", is_signed ? "" : "WARNING ", a.spec.code, text_of(said));
}

}  // namespace

// A warning before all numbers: how many pushes were too fast. A usable push is right within a few percent.
void print_rate_warning(const Statistics& statistics) {
  std::string counts;
  int doubtful = 0, usable = 0, judged = 0;
  for (const auto& [judgement, count] : statistics.judgement) {
    judged += judgement == "no push" ? 0 : count;
    usable += judgement == "usable" ? count : 0;
    if (judgement == "slow enough" || judgement == "no push" || judgement == "usable") continue;
    doubtful += count;
    counts += fmt::format("{}{} \"{}\"", counts.empty() ? "" : ", ", count,
                          judgement.empty() ? "not judged" : judgement);
  }
  if (doubtful > 0)
    fmt::print(
        "WARNING {} of {} pushes were not slow enough ({}): their forces may be wrong by more "
        "than 4 %; halve the velocity or lower stage.damping\n",
        doubtful, judged, counts);
  if (usable > 0)
    fmt::print(
        "note: {} of {} pushes are \"usable\": a slower push may change their peak by more than "
        "4 %; halve the velocity or lower stage.damping to be sure\n",
        usable, judged);
}

void print_table(const Campaign& campaign, const Statistics& statistics) {
  print_rate_warning(statistics);
  print_assessment(statistics.assessment);
  fmt::print("samples {} of {}:", campaign.records.size(), campaign.samples.n_sample());
  const char* between = " ";
  for (const auto& [status, count] : statistics.status) {
    fmt::print("{}{} {}", between, count, status);
    between = ", ";
  }
  fmt::print("\n");
  if (statistics.shaking.is_told()) print_shaking(statistics.shaking);
  if (statistics.shaking.shaking.is_asked()) return print_entangled(statistics.input_correlation);
  if (statistics.collapsed_before_push > 0)
    fmt::print("{} collapsed before the push: they have no strength and are not counted below\n",
               statistics.collapsed_before_push);
  constexpr std::size_t kShown = 3;  // peak, displacement at the peak, at 80 % of it
  const auto& quantity = quantities();
  fmt::print("{:<24} {:>4} {:>14}", "failure mode", "n", "share %");
  for (std::size_t q = 0; q < kShown && q < quantity.size(); ++q)
    fmt::print(" {:>26}", fmt::format("{} {}", quantity[q].name, quantity[q].unit));
  fmt::print(" {:>6}\n", "CoV %");
  for (const GroupSummary& group : statistics.group) {
    if (group.quantity.empty()) continue;
    fmt::print("{:<24} {:>4} {:>14}", group.name,
               group.quantity[0].n + group.quantity[0].without_value,
               share_cell(statistics, group));
    for (std::size_t q = 0; q < kShown && q < group.quantity.size(); ++q)
      fmt::print(" {:>26}", mean_cell(group.quantity[q], quantity[q].to_unit));
    fmt::print(" {:>6}\n", cell(100 * group.quantity[0].cov.value, "{:.1f}"));
  }
  fmt::print(
      "means with their 95 % interval; CoV of the peak; a displacement that the push did not "
      "reach counts as recorded\n");
  if (!statistics.group.empty() && statistics.group[0].quantity[0].without_value > 0)
    fmt::print("{} of {} samples have no peak force and are left out of its mean\n",
               statistics.group[0].quantity[0].without_value, statistics.answered);
  if (statistics.still_rising > 0)
    fmt::print("{} of {} peaks are lower bounds: the force was still rising where the push ended\n",
               statistics.still_rising, statistics.answered);
  if (statistics.named_earlier > 0)
    fmt::print("{} of {} pushes ended before {:g} mm; their failure modes were read at the end\n",
               statistics.named_earlier, statistics.answered, 1e3 * statistics.read_modes_at);
  print_entangled(statistics.input_correlation);
}

void print_inputs(const SampleTable& samples) {
  fmt::print("{:<40} {:>14} {:>8} {:>10}\n", "input", "mean", "CoV %", "cut off %");
  std::size_t variable = 0;
  for (std::size_t i = 0; i < samples.column.size(); ++i) {
    const InputColumn& column = samples.column[i];
    double sum = 0, squares = 0;
    for (const auto& row : samples.value) sum += row[i] * column.to_unit + column.offset;
    const double n = samples.n_sample(), mean = sum / n;
    for (const auto& row : samples.value) {
      const double off = row[i] * column.to_unit + column.offset - mean;
      squares += off * off;
    }
    const double cov = n > 1 ? std::sqrt(squares / (n - 1)) / std::fabs(mean) : std::nan("");
    const double cut =
        column.is_random && variable < samples.cut_off.size() ? samples.cut_off[variable++] : 0.0;
    fmt::print("{:<40} {:>14.6g} {:>8} {:>10}\n", column_title(column), mean,
               cell(100 * cov, "{:.2f}"), cut > 0 ? fmt::format("{:.3g}", 100 * cut) : "");
  }
  const std::vector<InputCorrelation> pairs = input_correlations(samples);
  if (!pairs.empty())
    fmt::print("largest rank correlation of two inputs: {} and {} {:.3f}\n", pairs.front().a,
               pairs.front().b, pairs.front().rank);
}

}  // namespace wythe::app
