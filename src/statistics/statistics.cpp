// statistics_of(): calls the parts (statistics_parts.h) in order; each answers one question.
#include "wythe/parts/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "statistics/bootstrap.h"
#include "statistics/statistics_parts.h"
#include "wythe/parts/failure_mode.h"

namespace wythe {
namespace {

using study::Answered;
using study::Group;

constexpr int kFewestForTable = 10;  // samples of a mode, for a table of its correlations

// "kN/mm" -> "kN_per_mm"
std::string unit_in_key(const std::string& unit) {
  std::string out;
  for (const char c : unit) out += c == '/' ? "_per_" : std::string(1, c);
  return out;
}

constexpr Word<Design> kDesignTitles[] = {{"Latin hypercube", Design::kLatinHypercube},
                                          {"Monte Carlo", Design::kMonteCarlo},
                                          {"scrambled Sobol", Design::kSobol}};
static_assert(names_all(kDesignTitles));

bool has_shake_that_counts(const SampleRecord& record) {
  return std::any_of(record.shakes.begin(), record.shakes.end(),
                     [](const ShakeResult& shake) { return shake.counts(); });
}

void count_outcomes(const Campaign& campaign, Statistics& out) {
  for (const SampleRecord& record : campaign.records) {
    if (record.status.empty()) continue;  // it has not run
    ++out.run;
    ++out.status[record.status];
    if (record.has_curve() && !record.quasi_static.judgement.empty())
      ++out.judgement[record.quasi_static.judgement];
    if (!record.has_curve() && has_shake_that_counts(record)) {
      ++out.answered;
      continue;
    }
    if (!is_answered(record)) {
      const Message& why = record.responses.peak_reason;
      out.unanswered.push_back({record.sample, record.status, why.empty() ? record.reason : why});
      const bool fell = record.status == to_string(SolveStatus::kCollapsed);
      out.collapsed_before_push += fell && !record.has_curve() ? 1 : 0;
      continue;
    }
    out.still_rising += is_still_rising(record) ? 1 : 0;
    out.named_earlier += is_read_early(record.failure_mode.read_at, out.read_modes_at) ? 1 : 0;
  }
}

void describe_study(const Campaign& campaign, Statistics& out) {
  out.study = campaign.study.name;
  out.design = word_of(kDesignTitles, campaign.study.design);
  out.seed = campaign.study.seed;
  out.asked = std::max(campaign.samples.n_sample(), static_cast<int>(campaign.records.size()));
  out.load_height = campaign.load_height;
  const double read_at = campaign.study.read_modes_at;
  out.read_modes_at = std::isnan(read_at) ? kReadModesAt : read_at;
  out.replicates = study::kReplicates;
}

// If a study has other fractions, the displacement reached at 0.8 is a lower bound.
Reading at_half(const Responses& r) {
  for (const FallTo& fall : r.falls)
    if (std::fabs(fall.fraction - 0.5) < 1e-9) return {fall.displacement, fall.censored};
  return {r.displacement_at_80, true};
}

void correlate_groups(const Answered& samples, Statistics& out) {
  std::vector<Group> groups = {study::all_of(samples)};
  for (Group& mode : study::modes_of(samples))
    if (static_cast<int>(mode.record.size()) >= kFewestForTable) groups.push_back(std::move(mode));
  for (const Group& group : groups)
    for (const Quantity& quantity : quantities())
      if (!study::all_censored(group, quantity))
        out.correlation.push_back(study::correlation_table(samples, group, quantity));
}

void summarise_groups(const Answered& samples, Statistics& out) {
  out.group.push_back(study::summarise(study::all_of(samples)));
  out.mean_curve.push_back(
      study::mean_curve_of(study::all_of(samples), samples.campaign.load_height));
  for (const Group& group : study::modes_of(samples)) {
    out.group.push_back(study::summarise(group));
    out.mean_curve.push_back(study::mean_curve_of(group, samples.campaign.load_height));
  }
  for (const Group& group : study::unions_of(samples)) out.group.push_back(study::summarise(group));
}

}  // namespace

const std::vector<Quantity>& quantities() {
  using R = const Responses&;
  static const std::vector<Quantity> kQuantities = {
      {"peak_reaction", "quantity.peak_reaction", "kN", 1e-3, false,
       [](R r) {
         return Reading{r.peak_reaction, false};
       }},
      {"displacement_at_peak", "quantity.displacement_at_peak", "mm", 1e3, false,
       [](R r) {
         return Reading{r.displacement_at_peak, false};
       }},
      {"displacement_at_80_percent", "quantity.displacement_at_80", "mm", 1e3, true,
       [](R r) {
         return Reading{r.displacement_at_80, r.censored_80};
       }},
      {"displacement_max", "quantity.displacement_max", "mm", 1e3, true,
       [](R r) {
         return Reading{r.displacement_max, r.censored_max};
       }},
      {"initial_stiffness", "quantity.initial_stiffness", "kN/mm", 1e-6, false,
       [](R r) {
         return Reading{r.initial_stiffness, false};
       }},
      {"displacement_at_50_percent", "quantity.displacement_at_50", "mm", 1e3, true, at_half},
      {"collapse_displacement", "quantity.collapse_displacement", "mm", 1e3, true,
       [](R r) {
         return Reading{r.collapse.displacement, r.collapse.censored};
       }},
      {"first_fall_80_percent", "quantity.first_fall_80", "mm", 1e3, true, [](R r) {
         return Reading{r.first_fall_80, r.censored_first_80};
       }}};
  return kQuantities;
}

const Quantity& quantity_named(const std::string& name) {
  for (const Quantity& q : quantities())
    if (name == q.name) return q;
  throw std::logic_error("no quantity is called " + name);
}

std::string key_of(const Quantity& q) { return std::string(q.name) + "_" + unit_in_key(q.unit); }

bool is_still_rising(const SampleRecord& record) { return record.responses.censored_peak; }

bool is_answered(const SampleRecord& record) {
  return record.answered() && !(record.responses.peak_reaction <= 0);
}

Statistics statistics_of(const Campaign& campaign) {
  const Answered samples = study::answered_of(campaign);
  Statistics out;
  describe_study(campaign, out);
  count_outcomes(campaign, out);
  out.answered += samples.n();
  out.modes = samples.modes;
  out.input = study::input_summaries(campaign);
  out.input_correlation = input_correlations(campaign.samples);
  summarise_groups(samples, out);
  out.share = study::shares_of(samples);
  out.walls = ensemble_of(campaign);
  out.name_sensitivity = study::name_sensitivities(samples);
  out.flag = study::flag_counts(samples);
  out.running = study::running_means(samples);
  out.precision = study::precisions(samples, out.running);
  correlate_groups(samples, out);
  out.first_order = study::first_order_indices(samples);
  out.mode_against_input = study::modes_against_inputs(samples);
  out.drift_limit = study::drift_limits(samples);
  out.exceedance = study::exceedances(samples);
  out.fragility = study::fragilities(samples);
  out.measuring = study::measurings(samples);
  out.surrogate_indices = study::surrogate_indices(samples);
  out.shaking = shaking_statistics(campaign);
  return out;
}

}  // namespace wythe
