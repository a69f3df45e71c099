// The assessment of a campaign: at which peak ground acceleration its samples reach each limit state
// (docs/theory/assessment.md, "Fragility against PGA").
#include <algorithm>
#include <cmath>

#include "study/assessment/assessment_parts.h"
#include "study/statistics/bootstrap.h"
#include "study/statistics/intervals.h"
#include "study/statistics/survival.h"
#include "wythe/statistics.h"

namespace wythe {
namespace {

using study::Counts;
using study::Lognormal;

constexpr int kGrid = 60;  // points of a curve

CodeAssessment assess_sample(const SampleRecord& record, const ModelSpec& base, const Model& model,
                             const MassAndShape& mass) {
  JudgedPush push = study::judged_push(model);
  const JudgedPush of{
      .status = value_of(kSolveStatusWords, record.status).value_or(SolveStatus::kInterrupted),
      .curve_of = push.curve_of,
      .is_horizontal = push.is_horizontal,
      .is_patterned = push.is_patterned,
      .curve = record.curve,
      .responses = record.responses,
      .judgement = record.quasi_static.judgement,
      .pier_slenderness = push.pier_slenderness,
      .mechanism = study::mechanism_of(record.failure_mode),
      .barred = push.barred};
  return assess(base.assessment, of, [&](double) { return mass; });
}

// The band of the curve: 2.5 and 97.5 % of what the replicates give.
Estimate probability(double x, const Lognormal& fit, const std::vector<Lognormal>& replicates,
                     double record_scatter) {
  const auto p = [&](const Lognormal& of) {
    return 1 - Lognormal{of.median, std::hypot(of.beta, record_scatter)}.exceedance(x);
  };
  Estimate out{p(fit), {}};
  std::vector<double> values;
  for (const Lognormal& of : replicates) values.push_back(p(of));
  std::sort(values.begin(), values.end());
  if (!values.empty())
    out.interval = {study::quantile_of(values, 0.025), study::quantile_of(values, 0.975)};
  return out;
}

void fit_to(std::vector<Reading> readings, double stated_scatter, PgaFragility& out) {
  readings = study::in_order(std::move(readings));
  const auto n = static_cast<int>(readings.size());
  out.n = n;
  for (const Reading& r : readings) out.censored += r.censored ? 1 : 0;
  out.point = study::kaplan_meier(readings);
  const Lognormal fit = study::fit_lognormal(readings, Counts(readings.size(), 1));
  if (!std::isfinite(fit.median)) return;
  std::vector<Lognormal> replicates;
  std::vector<double> betas;
  if (n >= study::kFewestForBootstrap) {
    const std::vector<double> medians = study::replicates(n, [&](const Counts& count) {
      const Lognormal again = study::fit_lognormal(readings, count);
      if (std::isfinite(again.beta)) replicates.push_back(again), betas.push_back(again.beta);
      return again.median;
    });
    std::sort(betas.begin(), betas.end());
    out.median.interval = {study::quantile_of(medians, 0.025), study::quantile_of(medians, 0.975)};
    out.beta_capacity.interval = {study::quantile_of(betas, 0.025),
                                  study::quantile_of(betas, 0.975)};
  }
  out.median.value = fit.median, out.beta_capacity.value = fit.beta;
  const double scatter = std::isnan(stated_scatter) ? 0 : stated_scatter;
  out.beta = std::hypot(fit.beta, scatter);
  const double last = std::fmax(fit.median * std::exp(3 * out.beta), 1.1 * out.demand);
  for (int i = 0; i <= kGrid; ++i)
    out.curve.push_back(
        {last * i / kGrid, probability(last * i / kGrid, fit, replicates, scatter)});
  if (out.demand > 0) out.at_demand = probability(out.demand, fit, replicates, scatter);
}

// Whether a sample with this key set has the mass, the shape and the spectrum of the base model.
bool keeps_mass_and_spectrum(const std::string& path) {
  if (path.empty()) return true;  // a number of formulas alone
  const bool is_law = path.starts_with("material.") || path.starts_with("masonry.");
  return is_law && path.find("density") == std::string::npos;
}

// What samples have of their own that their assessment would have to follow; "": nothing.
std::string own_key(const StudySpec& study) {
  for (const VariableSpec& of : study.variable)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  for (const DependentSpec& of : study.dependent)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  for (const StudyField& of : study.field)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  return "";
}

Message barred(const Campaign& campaign, const Model& model) {
  if (const std::string path = own_key(campaign.study); !path.empty())
    return {"assessment.samples_differ", {{"path", path}}};
  return study::judged_push(model).barred;
}

}  // namespace

CampaignAssessment assess_campaign(const Campaign& campaign, const ModelSpec& base,
                                   const Model& model) {
  CampaignAssessment out;
  out.spec = base.assessment;
  const ElasticSpectrum spectrum = spectrum_of(base.assessment.spectrum);
  out.mass = mass_and_linear_shape(base.assessment, model);
  out.reason = barred(campaign, model);
  if (!out.reason.empty()) {
    for (const SampleRecord& record : campaign.records)
      out.without_answer += record.status.empty() ? 0 : 1;
    return out;
  }
  constexpr std::size_t kStates = std::size(kLimitStateWords);
  std::vector<std::vector<Reading>> readings(kStates);
  for (const SampleRecord& record : campaign.records) {
    if (record.status.empty()) continue;
    const CodeAssessment a = assess_sample(record, base, model, out.mass);
    if (out.notes.empty()) out.notes = a.notes;
    if (a.limit_states.empty() || !is_answered(record)) {
      ++out.without_answer;
      continue;
    }
    ++out.answered;
    const LimitStateCheck* asked = a.asked();
    out.doubtful += a.may_be_signed || (a.cautions.size() == 1 && asked->at_least) ? 0 : 1;
    for (const LimitStateCheck& check : a.limit_states)
      readings[static_cast<std::size_t>(check.state)].push_back(
          {check.acceleration, check.at_least});
  }
  for (Message& note : study::notes_of_masses(base, model)) out.notes.push_back(std::move(note));
  out.notes.push_back({"assessment.note.base_mass"});
  if (std::isnan(base.assessment.record_scatter))
    out.notes.push_back({"assessment.note.no_record_scatter"});
  if (!spectrum.is_given()) return out;
  for (std::size_t k = 0; k < kStates; ++k) {
    PgaFragility& of = out.fragility.emplace_back();
    of.limit_state = word_of(kLimitStateWords, static_cast<LimitState>(k));
    of.is_checked = of.limit_state == base.assessment.limit_state;
    of.demand = of.is_checked ? spectrum.peak_ground_acceleration() : kUnset;
    fit_to(std::move(readings[k]), base.assessment.record_scatter, of);
  }
  return out;
}

}  // namespace wythe
