// The assessment of a campaign: the peak ground acceleration at which its samples
// reach each limit state (docs/theory/assessment.md, "Fragility against PGA").
#include <algorithm>
#include <cmath>

#include "judge/assessment/assessment_parts.h"
#include "judge/modes/wall_parts.h"
#include "model/coarse_units.h"
#include "statistics/bootstrap.h"
#include "statistics/intervals.h"
#include "statistics/one_push.h"
#include "statistics/survival.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/slow_push.h"
#include "wythe/parts/statistics.h"

namespace wythe {
namespace {

using study::Counts;
using study::Lognormal;

constexpr int kGridOfPga = 60;  // points of a curve

// The band of the curve: 2.5 and 97.5 % quantiles of the replicates,
// or a closed form for few samples. No band for 0 `observed`.
Estimate probability(double x, const Lognormal& fit, const std::vector<Lognormal>& replicates,
                     double record_scatter, int observed) {
  const auto p = [&](const Lognormal& of) {
    return 1 - Lognormal{of.median, std::hypot(of.beta, record_scatter)}.exceedance(x);
  };
  Estimate out{p(fit), {}};
  if (replicates.empty())
    out.interval = study::lognormal_band(x, fit.median, fit.beta, record_scatter, observed);
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
  study::LognormalReplicates by;
  if (n >= study::kFewestForBootstrap) {
    by = study::lognormal_replicates(readings, fit);
    out.median.interval = by.median, out.beta_capacity.interval = by.beta;
  }
  // for few values with more than half bounds the interval has not been tested, so there is none
  const int observed = by.fit.empty() && 2 * out.censored <= n ? n - out.censored : 0;
  if (observed > 0) {
    const auto of_few = study::lognormal_intervals(fit.median, fit.beta, observed);
    out.median.interval = of_few.median, out.beta_capacity.interval = of_few.beta;
  }
  out.median.value = fit.median, out.beta_capacity.value = fit.beta;
  const double scatter = std::isnan(stated_scatter) ? 0 : stated_scatter;
  out.beta = std::hypot(fit.beta, scatter);
  const double last = std::fmax(fit.median * std::exp(3 * out.beta), 1.1 * out.demand);
  for (int i = 0; i <= kGridOfPga; ++i)
    out.curve.push_back({last * i / kGridOfPga,
                         probability(last * i / kGridOfPga, fit, by.fit, scatter, observed)});
  if (out.demand > 0) out.at_demand = probability(out.demand, fit, by.fit, scatter, observed);
}

// Whether a sample with this key keeps the mass, the shape and the spectrum of the base model.
bool keeps_mass_and_spectrum(const std::string& path) {
  if (path.empty()) return true;  // used in formulas only
  const bool is_law = path.starts_with("material.") || path.starts_with("masonry.");
  if (is_law) return path.find("density") == std::string::npos;
  // the motion of a stage, not its loads
  if (!path.starts_with("stage.")) return false;
  constexpr const char* kDriving[] = {".velocity", ".damping", ".ramp", ".until"};
  return std::any_of(std::begin(kDriving), std::end(kDriving),
                     [&](const char* key) { return path.ends_with(key); });
}

// A key of the samples that their assessment would have to follow; empty if none.
std::string own_key(const StudySpec& study) {
  for (const VariableSpec& of : study.variable)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  for (const DependentSpec& of : study.dependent)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  for (const StudyField& of : study.field)
    if (!keeps_mass_and_spectrum(of.path)) return of.path;
  return "";
}

// Whether every sample has a stored wall, with each of its piers.
bool knows_walls(const Campaign& campaign, const Model& model) {
  const std::size_t piers = study::find_parts(model).piers.size();
  return std::all_of(campaign.records.begin(), campaign.records.end(), [&](const auto& record) {
    return !is_answered(record) || (record.pushed.is_read() && record.pushed.piers.size() == piers);
  });
}

Message barred(const Campaign& campaign, const Model& model) {
  if (const std::string path = own_key(campaign.study); !path.empty())
    return {"assessment.samples_differ", {{"path", path}}};
  return study::judged_push(model).barred;
}

// Cautions for all numbers of the campaign. A sample with several piers
// and no stored drift of each pier does not show the drift that counts.
std::vector<Message> cautions_of_samples(const Campaign& campaign, const ModelSpec& base,
                                         const Model& model) {
  std::vector<Message> say = study::cautions_of_inputs(base, model);
  for (Message& caution : study::cautions_of_demand(base.assessment))
    say.push_back(std::move(caution));
  if (Message units = caution_of_units(base); !units.empty()) say.push_back(std::move(units));
  if (knows_walls(campaign, model)) return say;
  if (study::find_parts(model).piers.size() > 1 || base.storey.size() > 1)
    say.push_back({"assessment.caution.whole_drift"});
  return say;
}

// Samples without an answer may all lie on one side. From this share on they can
// change probabilities, which are given in whole per cents, so a caution comes first.
constexpr double kMostLost = 0.01;

Message lost_samples(const CampaignAssessment& a, const Message& why) {
  const int all = a.answered + a.without_answer;
  if (a.answered == 0 || a.without_answer <= kMostLost * all) return {};
  return {"assessment.caution.lost", {{"without", a.without_answer}, {"all", all}, {"why", why}}};
}

// A median that no sample showed, because more than half of them still stand at the last step.
Message extrapolated(const CampaignAssessment& a) {
  for (const PgaFragility& f : a.fragility)
    if (f.is_checked && std::isfinite(f.median.value) && !f.point.empty() &&
        f.point.back().probability.value > 0.5)
      return {"assessment.caution.extrapolated", {{"censored", f.censored}, {"answered", f.n}}};
  return {};
}

}  // namespace

std::vector<Message> cautions_of(const CampaignAssessment& a) {
  std::vector<Message> cautions;
  for (const Message& note : a.notes)
    if (note.code.starts_with("assessment.caution.")) cautions.push_back(note);
  return cautions;
}

Message sentence_of(const CampaignAssessment& a) {
  if (!a.reason.empty()) return {"assessment.not_known", {{"why", a.reason}}};
  Message said{"assessment.campaign_without_demand",
               {{"answered", a.answered}, {"without", a.without_answer}}};
  for (const PgaFragility& f : a.fragility) {
    if (!f.is_checked) continue;
    const Message state = study::words_of_state(value_of(kLimitStateWords, f.limit_state).value());
    said =
        std::isfinite(f.median.value)
            ? Message{"assessment.campaign",
                      {{"state", state},
                       {"median_g", f.median.value / kStandardGravity},
                       {"beta", f.beta},
                       {"demand_g", f.demand / kStandardGravity},
                       {"percent", 100 * f.at_demand.value},
                       {"answered", a.answered},
                       {"without", a.without_answer}}}
            : Message{"assessment.campaign_without_median",
                      {{"state", state}, {"answered", a.answered}, {"without", a.without_answer}}};
  }
  std::vector<Message> cautions = cautions_of(a);
  if (cautions.empty() && a.doubtful > 0)
    cautions.push_back(
        {"assessment.caution.samples", {{"doubtful", a.doubtful}, {"answered", a.answered}}});
  if (cautions.empty()) return said;
  return {"assessment.unsigned", {{"cautions", std::move(cautions)}, {"verdict", said}}};
}

CodeAssessment assess_sample(const SampleRecord& record, const ModelSpec& base,
                             const Model& model) {
  const JudgedPush push = study::judged_push(model);
  const JudgedCurve curve{record.curve, record.responses, record.quasi_static};
  JudgedPush of{
      .status = value_of(kSolveStatusWords, record.status).value_or(SolveStatus::kInterrupted),
      .curve_of = push.curve_of,
      .is_horizontal = push.is_horizontal,
      .is_patterned = push.is_patterned,
      .curve = record.curve,
      .responses = record.responses,
      .judgement = record.quasi_static.judgement,
      .displacement = displacement_of_slow_push(model, curve),
      .mode = mode_of_slow_push(model, curve, record.failure_mode.read_at,
                                is_firm(record.failure_mode)),
      .overlap_lost = record.overlap_lost,
      .rise = record.rise,
      .pier_slenderness = push.pier_slenderness,
      .barred = push.barred};
  return study::judged(base, model, std::move(of), record.failure_mode, record.pushed);
}

namespace {

// Adds the fragility of each limit state, where there is a spectrum.
void add_fragility(std::vector<std::vector<Reading>> readings, CampaignAssessment& out) {
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const auto state = static_cast<LimitState>(k);
    const ElasticSpectrum spectrum = spectrum_of(spectrum_for(out.spec, state));
    if (!spectrum.is_given() || (readings[k].empty() && state == LimitState::kOperational))
      continue;
    PgaFragility& of = out.fragility.emplace_back();
    of.limit_state = word_of(kLimitStateWords, state);
    of.is_checked = of.limit_state == out.spec.limit_state;
    of.demand = is_checked(out.spec, state) ? spectrum.peak_ground_acceleration() : kUnset;
    fit_to(std::move(readings[k]), out.spec.record_scatter, of);
  }
}

// The mass and shape of the sample with the median participating mass.
MassAndShape middle_of(std::vector<MassAndShape> masses) {
  std::stable_sort(masses.begin(), masses.end(), [](const MassAndShape& a, const MassAndShape& b) {
    return a.participating < b.participating;
  });
  return masses[(masses.size() - 1) / 2];
}

// A bound is valid in a fragility, and the scatter of many runs replaces some cautions of one run.
bool is_doubtful(const CodeAssessment& a, bool waits) {
  return std::any_of(a.cautions.begin(), a.cautions.end(), [&](const Message& caution) {
    return caution.code != "assessment.caution.bound" &&
           !study::is_left_to_the_scatter(caution, waits);
  });
}

}  // namespace

CampaignAssessment assess_campaign(const Campaign& campaign, const ModelSpec& base,
                                   const Model& model) {
  CampaignAssessment out;
  out.spec = base.assessment;
  out.mass = mass_and_linear_shape(base.assessment, model);
  out.reason = barred(campaign, model);
  if (!out.reason.empty()) {
    for (const SampleRecord& record : campaign.records)
      out.without_answer += record.status.empty() ? 0 : 1;
    out.doubtful = out.without_answer;
    return out;
  }
  out.notes = cautions_of_samples(campaign, base, model);
  std::vector<Message> notes;
  const bool waits = study::waits_at_cracks(model);
  Message why;  // the first sample without an answer sets it
  std::vector<MassAndShape> masses;
  std::vector<std::vector<Reading>> readings(std::size(kLimitStateWords));
  for (const SampleRecord& record : campaign.records) {
    if (record.status.empty()) continue;
    const CodeAssessment a = assess_sample(record, base, model);
    if (notes.empty()) notes = a.notes;
    if (a.limit_states.empty() || !is_answered(record)) {
      ++out.without_answer;
      if (why.empty()) why = a.reason;
      continue;
    }
    ++out.answered;
    masses.push_back(a.mass);
    out.doubtful += is_doubtful(a, waits) ? 1 : 0;
    for (const LimitStateCheck& check : a.limit_states)
      readings[static_cast<std::size_t>(check.state)].push_back(
          {check.acceleration, check.at_least});
  }
  if (out.answered == 0 && out.without_answer > 0) {
    out.reason = {"assessment.no_sample_answers", {{"why", why}}};
    out.doubtful = out.without_answer;
  }
  if (!masses.empty()) out.mass = middle_of(std::move(masses));
  add_fragility(std::move(readings), out);
  for (Message& say : std::vector{lost_samples(out, why), extrapolated(out)})
    if (!say.empty()) out.notes.push_back(std::move(say));
  if (!out.notes.empty()) out.doubtful = out.answered > 0 ? out.answered : out.without_answer;
  out.notes.insert(out.notes.end(), notes.begin(), notes.end());
  for (Message& note : study::notes_of_masses(base, model)) out.notes.push_back(std::move(note));
  out.notes.push_back(
      {knows_walls(campaign, model) ? "assessment.note.own_shapes" : "assessment.note.base_mass"});
  if (std::isnan(base.assessment.record_scatter))
    out.notes.push_back({"assessment.note.no_record_scatter"});
  return out;
}

}  // namespace wythe
