// Fragility of the resistance: the probability that a force, a drift or a mode occurs, given an input.
//
//   events (a force, drifts of the code, every mode) x inputs ──► outcomes 0, 1, not known
//     ──► enough outcomes? ──► logistic and lognormal fit (binary_fit.h), the better one as a curve
//
// If a push ended before a threshold or the mode is unclear, the outcome is not known. Such a sample counts as
// half an event. Every interval is widened to include the fits with all of them on one side and on the other.
// Equations (7.14) to (7.18) of docs/theory/statistics.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "core/text.h"
#include "statistics/binary_fit.h"
#include "statistics/intervals.h"
#include "statistics/statistics_parts.h"
#include "statistics/survival.h"
#include "wythe/parts/error.h"
#include "wythe/parts/units.h"

namespace wythe::study {
namespace {

constexpr int kFewestOfEither = 5;          // events, and samples without: for one slope
constexpr int kFewestOfEitherForPair = 10;  // the same for two slopes
constexpr int kCurvePoints = 21;
constexpr double kSameInput = 0.95;  // rank correlation above which two inputs cannot be separated

// --- events ----------------------------------------------------------------------------------------

// The quantity for the threshold. A peak at the end of a push counts as a lower bound here.
Reading reading_for(const FragilityEvent& event, const SampleRecord& record, double base_height) {
  const Responses& r = record.responses;
  if (event.response != "drift_at_80_percent") {
    Reading reading = quantity_named(event.response).read(record.responses);
    if (event.response == "peak_reaction" || event.response == "displacement_at_peak")
      reading.censored = is_still_rising(record);
    return reading;
  }
  const double height = height_of(record, base_height);
  return height > 0 ? Reading{r.displacement_at_80 / height, r.censored_80} : Reading{};
}

// 0 or 1, 0.5 where the outcome is not known; NaN where the sample has no such response.
double outcome_of(const FragilityEvent& event, const SampleRecord& record, double base_height) {
  if (event.of_mode()) {
    const std::string& name = record.failure_mode.name;
    return name == event.mode ? 1 : name == "unclear" ? 0.5 : 0;
  }
  const Reading reading = reading_for(event, record, base_height);
  if (!reading.is_known()) return kUnset;
  if (reading.value > event.threshold) return 1;
  return reading.censored ? 0.5 : 0;
}

// Rounds a threshold of the program's own choice to three digits.
double rounded(double value) {
  if (!(value > 0)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::round(value / unit) * unit;
}

double median_of(const FragilityEvent& event, const Answered& samples) {
  std::vector<Reading> readings;
  for (const SampleRecord* record : samples.record)
    if (const Reading r = reading_for(event, *record, samples.campaign.load_height); r.is_known())
      readings.push_back(r);
  readings = in_order(std::move(readings));
  return survival_quantile(readings, Counts(readings.size(), 1), 0.5);
}

bool is_worth(const FragilityEvent& event, const Answered& samples) {
  int seen = 0, missing = 0;
  for (const SampleRecord* record : samples.record) {
    const double y = outcome_of(event, *record, samples.campaign.load_height);
    seen += y == 1 ? 1 : 0, missing += y == 0 ? 1 : 0;
  }
  return std::min(seen, missing) >= kFewestOfEither;
}

std::vector<FragilityEvent> events_of(const Answered& samples) {
  std::vector<FragilityEvent> events;
  for (const std::string& text : samples.campaign.study.fragility)
    events.push_back(fragility_event(text));
  FragilityEvent force{.response = "peak_reaction", .mode = "", .unit = "kN", .to_unit = 1e-3};
  force.threshold = 1e3 * rounded(1e-3 * median_of(force, samples));
  if (std::isfinite(force.threshold)) events.push_back(force);
  FragilityEvent drift{.response = "drift_at_80_percent", .mode = "", .unit = "%", .to_unit = 1e2};
  const double half = median_of(drift, samples);
  const std::size_t before = events.size();
  for (const double limit : {0.005, 0.010, 0.015, 0.020}) {  // Circolare 7/2019, near collapse
    drift.threshold = limit;
    if (is_worth(drift, samples)) events.push_back(drift);
  }
  drift.threshold = 1e-2 * rounded(1e2 * half);
  if (events.size() == before && std::isfinite(half)) events.push_back(drift);
  for (const std::string& mode : samples.modes) {
    const FragilityEvent event{.response = "failure_mode", .mode = mode};
    const bool occurs = std::any_of(samples.record.begin(), samples.record.end(),
                                    [&](auto* r) { return r->failure_mode.name == mode; });
    if (mode != "unclear" && occurs) events.push_back(event);
  }
  const auto is_same = [](const FragilityEvent& a, const FragilityEvent& b) {
    return a.response == b.response && a.mode == b.mode &&
           (a.of_mode() || std::fabs(a.threshold - b.threshold) <= 1e-9 * a.threshold);
  };
  std::vector<FragilityEvent> once;  // a requested event may equal one of the program's own
  for (FragilityEvent& event : events)
    if (std::none_of(once.begin(), once.end(), [&](const auto& e) { return is_same(e, event); }))
      once.push_back(std::move(event));
  return once;
}

// --- verdict ---------------------------------------------------------------------------------------

// The samples of one event.
struct Outcomes {
  std::vector<const SampleRecord*> record;
  Column y;
  int seen = 0, unknown = 0;
  [[nodiscard]] int n() const { return static_cast<int>(y.size()); }
  [[nodiscard]] int missing() const { return n() - seen - unknown; }
};

FragilityVerdict verdict_of(const Outcomes& o, int fewest) {
  if (o.n() < kFewestSamples) return FragilityVerdict::kFewSamples;
  if (o.unknown == 0 && o.seen == 0) return FragilityVerdict::kNever;
  if (o.unknown == 0 && o.missing() == 0) return FragilityVerdict::kAlways;
  return std::min(o.seen, o.missing()) < fewest ? FragilityVerdict::kRare : FragilityVerdict::kTold;
}

// The outcomes with all unknown ones as 0, and as 1; none where all are known.
std::vector<Column> sides_of(const Column& y) {
  std::vector<Column> sides;
  if (std::find(y.begin(), y.end(), 0.5) == y.end()) return sides;
  for (const double side : {0.0, 1.0}) {
    Column& one = sides.emplace_back(y);
    std::replace(one.begin(), one.end(), 0.5, side);
  }
  return sides;
}

std::vector<BinaryFit> extremes_of(const BinaryData& data) {
  std::vector<BinaryFit> fits;
  for (Column& y : sides_of(data.y)) fits.emplace_back(BinaryData{data.law, data.x, std::move(y)});
  return fits;
}

constexpr double kDoubt = 0.05;

// The p of a test, if both extremes agree with it; NaN where it depends on
// unknown outcomes. `p_of` gives the p of a fit, `slope_of` the tested slope.
template <class P, class Slope>
double agreed(const BinaryFit& fit, const std::vector<BinaryFit>& others, const P& p_of,
              const Slope& slope_of) {
  const double p = p_of(fit);
  for (const BinaryFit& other : others) {
    if (!other.is_finite() || (p_of(other) < kDoubt) != (p < kDoubt)) return kUnset;
    if (p < kDoubt && (slope_of(other) > 0) != (slope_of(fit) > 0)) return kUnset;
  }
  return p;
}

void widen(Interval& interval, const Interval& other) {
  interval.low = std::min(interval.low, other.low);
  interval.high = std::max(interval.high, other.high);
}

// Sets values beyond the samples to NaN.
Estimate within(Estimate e, double low, double high) {
  const auto inside = [&](double x) { return x >= low && x <= high ? x : kUnset; };
  return {inside(e.value), {inside(e.interval.low), inside(e.interval.high)}};
}

FragilityFit told(const BinaryData& data, const BinaryFit& fit,
                  const std::vector<BinaryFit>& others, double low, double high) {
  const bool is_log = data.law == FragilityLaw::kLognormal;
  FragilityFit out;
  out.law = data.law;
  out.slope = {fit.slope(0), fit.profile_slope()};
  out.half = fit.half();
  for (const BinaryFit& other : others) {
    widen(out.slope.interval,
          other.is_finite() ? other.profile_slope() : Interval{-HUGE_VAL, HUGE_VAL});
    widen(out.half.interval,
          other.is_finite() ? other.half().interval : Interval{-HUGE_VAL, HUGE_VAL});
  }
  if (is_log)
    out.half = {std::exp(out.half.value),
                {std::exp(out.half.interval.low), std::exp(out.half.interval.high)}};
  out.half = within(out.half, low, high);
  out.log_likelihood = fit.log_likelihood();
  out.influence_p = agreed(
      fit, others, [](const BinaryFit& f) { return f.influence_p(); },
      [](const BinaryFit& f) { return f.slope(0); });
  out.fit_p = fit.fit_p();
  return out;
}

std::vector<FragilityPoint> curve_of(const BinaryFit& fit, const std::vector<BinaryFit>& others,
                                     FragilityLaw law, double low, double high) {
  std::vector<FragilityPoint> points;
  for (int i = 0; i < kCurvePoints; ++i) {
    const double x = i + 1 == kCurvePoints ? high : low + (high - low) * i / (kCurvePoints - 1);
    const std::vector<double> at = {law == FragilityLaw::kLognormal ? std::log(x) : x};
    FragilityPoint point{x, fit.at(at)};
    for (const BinaryFit& other : others)
      widen(point.probability.interval, other.is_finite() ? other.at(at).interval : Interval{0, 1});
    points.push_back(point);
  }
  return points;
}

// The values between which the outcomes change from one kind to the other.
void find_gap(const Column& x, const Column& y, FragilityOfInput& out) {
  double least[2] = {HUGE_VAL, HUGE_VAL}, most[2] = {-HUGE_VAL, -HUGE_VAL};
  Moments moments[2];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const int kind = y[i] == 1 ? 1 : 0;
    if (y[i] == 0.5) continue;
    least[kind] = std::min(least[kind], x[i]), most[kind] = std::max(most[kind], x[i]);
    moments[kind].add(x[i]);
  }
  const int below = moments[0].mean() <= moments[1].mean() ? 0 : 1;
  out.parted_low = std::min(most[below], least[1 - below]);
  out.parted_high = std::max(most[below], least[1 - below]);
}

FragilityOfInput of_input(const Outcomes& outcomes, const InputColumn& column, const Column& x) {
  FragilityOfInput out;
  out.input = column.name, out.unit = column.unit;
  const std::set<double> values(x.begin(), x.end());
  out.verdict = verdict_of(outcomes, kFewestOfEither);
  if (out.verdict != FragilityVerdict::kTold) return out;
  if (values.size() < 2) out.verdict = FragilityVerdict::kConstant;
  if (values.size() == 2) out.verdict = FragilityVerdict::kTwoValues;
  if (values.size() > 2 && parts(x, outcomes.y)) {
    out.verdict = FragilityVerdict::kSeparated;
    find_gap(x, outcomes.y, out);
  }
  if (out.verdict != FragilityVerdict::kTold) return out;
  const double low = *values.begin(), high = *values.rbegin();
  for (const FragilityLaw law : {FragilityLaw::kLogistic, FragilityLaw::kLognormal}) {
    if (law == FragilityLaw::kLognormal && !(low > 0)) continue;
    BinaryData data{law, {x}, outcomes.y};
    if (law == FragilityLaw::kLognormal)
      for (double& v : data.x[0]) v = std::log(v);
    const BinaryFit fit(data);
    if (!fit.is_finite()) continue;
    const std::vector<BinaryFit> others = extremes_of(data);
    const bool is_better = out.fit.empty() || fit.log_likelihood() > out.fit.front().log_likelihood;
    out.fit.insert(is_better ? out.fit.begin() : out.fit.end(), told(data, fit, others, low, high));
    if (is_better) out.point = curve_of(fit, others, law, low, high);
  }
  if (out.fit.empty()) {  // not separated, but too steep
    out.verdict = FragilityVerdict::kSeparated;
    find_gap(x, outcomes.y, out);
  }
  return out;
}

// Likelihood ratio of both inputs against the better one of the two alone.
double added_p(const BinaryFit& both, const Column& x_a, const Column& x_b, const Column& y) {
  double alone = kUnset;
  for (const Column* x : {&x_a, &x_b}) {
    const BinaryFit one(BinaryData{FragilityLaw::kLogistic, {*x}, y});
    if (one.is_finite()) alone = std::fmax(alone, one.log_likelihood());
  }
  return chi_square_beyond(2 * (both.log_likelihood() - alone), 1);
}

FragilityOfPair of_pair(const Outcomes& outcomes, const FragilityOfInput& a, const Column& x_a,
                        const FragilityOfInput& b, const Column& x_b) {
  FragilityOfPair out;
  out.a = a.input, out.b = b.input;
  out.verdict = verdict_of(outcomes, kFewestOfEitherForPair);
  if (out.verdict != FragilityVerdict::kTold) return out;
  if (!(std::fabs(pearson(ranks(x_a), ranks(x_b))) < kSameInput)) {
    out.verdict = FragilityVerdict::kCollinear;
    return out;
  }
  const BinaryData data{FragilityLaw::kLogistic, {x_a, x_b}, outcomes.y};
  const BinaryFit fit(data);
  std::vector<BinaryFit> all = extremes_of(data);
  all.push_back(fit);
  for (const BinaryFit& each : all)
    if (!each.is_finite()) out.verdict = FragilityVerdict::kSeparated;
  if (out.verdict != FragilityVerdict::kTold) return out;
  out.intercept = fit.intercept();
  out.slope_a = {fit.slope(0), fit.wald_slope(0)};
  out.slope_b = {fit.slope(1), fit.wald_slope(1)};
  for (const BinaryFit& each : all) {
    widen(out.slope_a.interval, each.wald_slope(0));
    widen(out.slope_b.interval, each.wald_slope(1));
  }
  out.added_p = added_p(fit, x_a, x_b, outcomes.y);
  const bool adds = out.added_p < kDoubt;
  std::size_t k = 0;  // index into `all`, which begins with the sides
  for (const Column& y : sides_of(outcomes.y))
    if ((added_p(all[k++], x_a, x_b, y) < kDoubt) != adds) out.added_p = kUnset;
  out.fit_p = fit.fit_p();
  return out;
}

// Samples with the inputs of an earlier one add nothing, because a
// run repeats exactly. With fields they are still different walls.
Outcomes outcomes_of(const Answered& samples, const FragilityEvent& event, Fragility& out) {
  Outcomes o;
  std::set<std::vector<double>> known;
  const bool has_fields = !samples.campaign.study.field.empty();
  for (const SampleRecord* record : samples.record) {
    const double y = outcome_of(event, *record, samples.campaign.load_height);
    if (std::isnan(y)) continue;
    if (!has_fields && !known.insert(record->inputs).second) {
      ++out.repeated;
      continue;
    }
    const std::string& judgement = record->quasi_static.judgement;
    out.doubtful += judgement == "slow enough" || judgement == "no push" ? 0 : 1;
    o.record.push_back(record), o.y.push_back(y);
    out.sample.push_back(record->sample), out.outcome.push_back(y);
    o.seen += y == 1 ? 1 : 0, o.unknown += y == 0.5 ? 1 : 0;
  }
  return o;
}

Fragility fragility_of(const Answered& samples, const FragilityEvent& event) {
  Fragility out;
  out.event = event;
  const Outcomes outcomes = outcomes_of(samples, event, out);
  out.n = outcomes.n(), out.seen = outcomes.seen, out.unknown = outcomes.unknown;
  out.share = share_estimate(out.seen, out.n - out.unknown);
  if (out.unknown > 0)
    out.share = {kUnset,
                 {share_estimate(out.seen, out.n).interval.low,
                  share_estimate(out.seen + out.unknown, out.n).interval.high}};
  const SampleTable& table = samples.campaign.samples;
  const std::vector<InputCorrelation> pairs = input_correlations(table);
  std::vector<Column> shown;
  for (const int k : random_columns(table)) {
    const InputColumn& column = table.column[k];
    Column& x = shown.emplace_back();
    for (const double v : input_of(outcomes.record, k))
      x.push_back(v * column.to_unit + column.offset);
    out.input.push_back(of_input(outcomes, column, x));
    out.input.back().entangled = entangled_with(column.name, pairs);
  }
  for (std::size_t a = 0; a < shown.size(); ++a)
    for (std::size_t b = a + 1; b < shown.size(); ++b)
      if (out.input[a].verdict == FragilityVerdict::kTold &&
          out.input[b].verdict == FragilityVerdict::kTold)
        out.pair.push_back(of_pair(outcomes, out.input[a], shown[a], out.input[b], shown[b]));
  return out;
}

}  // namespace

std::vector<Fragility> fragilities(const Answered& whole) {
  const Answered samples = for_fits(whole);
  std::vector<Fragility> all;
  if (samples.n() == 0) return all;
  for (const FragilityEvent& event : events_of(samples))
    all.push_back(fragility_of(samples, event));
  return all;
}

}  // namespace wythe::study

namespace wythe {

FragilityEvent fragility_event(const std::string& text) {
  const auto refuse = [&](const std::string& problem, const std::string& cure) {
    throw InputError(
        {{.path = "fragility", .value = "\"" + text + "\"", .problem = problem, .cure = cure}});
  };
  constexpr const char* kExample = "write e.g. \"peak_reaction > 150 kN\"";
  FragilityEvent event;
  const std::size_t at = text.find('>');
  if (at == std::string::npos) refuse("is not response > threshold", kExample);
  event.response = trimmed(std::string_view(text).substr(0, at));
  const std::string threshold(trimmed(std::string_view(text).substr(at + 1)));
  std::vector<std::string> names = {"drift_at_80_percent"};
  for (const Quantity& q : quantities()) {
    names.emplace_back(q.name);
    if (event.response == q.name) event.unit = q.unit, event.to_unit = q.to_unit;
  }
  if (event.response == names.front()) event.unit = "%", event.to_unit = 1e2;
  if (event.unit.empty())
    refuse("names no response that is known here", name_advice(event.response, names));
  const std::map<std::string, const char*> si = {
      {"kN", "N"}, {"mm", "m"}, {"kN/mm", "N/m"}, {"%", "1"}};
  try {
    event.threshold = parse_quantity(threshold, si.at(event.unit));
  } catch (const std::invalid_argument& error) {
    refuse(fmt::format("has the threshold {}: {}", threshold, error.what()), kExample);
  }
  if (!(event.threshold > 0) || !std::isfinite(event.threshold))
    refuse("has a threshold that every sample passes or none: it must be positive", kExample);
  return event;
}

}  // namespace wythe
