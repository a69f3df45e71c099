// statistics.json: the statistics of a campaign for other programs; keys in docs/reference/statistics.md.
//
// Numbers have nine significant digits, far more than any interval needs, without noise of binary fractions. NaN
// and infinite values are null.

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/export/shaking_json.h"
#include "io/export/statistics_numbers.h"
#include "io/results/assessment_json.h"
#include "io/results/message_json.h"
#include "wythe/parts/io.h"

namespace wythe {
namespace {

using namespace io;

// "_kN"
std::string unit_in_key(const Quantity& q) { return key_of(q).substr(std::string(q.name).size()); }

Json summary_of(const Summary& s, const Quantity& q) {
  const double scale = q.to_unit;
  Json json = {{"n", s.n}, {"without_value", s.without_value}};
  if (q.can_be_censored) json["censored"] = s.censored;
  add(json, "mean", s.mean, scale);
  add(json, "cov", s.cov);
  add(json, "median", s.median, scale);
  json["standard_deviation"] = number(s.standard_deviation * scale);
  json["min"] = number(s.min * scale);
  json["max"] = number(s.max * scale);
  json["percentile_5"] = number(s.percentile_5 * scale);
  json["percentile_95"] = number(s.percentile_95 * scale);
  if (!q.can_be_censored) return json;
  add(json, "survival_mean", s.survival_mean, scale);
  add(json, "survival_median", s.survival_median, scale);
  return json;
}

Json table_json(const Statistics& s) {
  Json json = Json::object();
  for (const GroupSummary& group : s.group) {
    Json& of_group = json[group.name] = {{"modes", group.modes}};
    for (std::size_t q = 0; q < group.quantity.size(); ++q)
      of_group[key_of(quantities()[q])] = summary_of(group.quantity[q], quantities()[q]);
  }
  return json;
}

Json samples_json(const Statistics& s) {
  Json status = Json::object();
  for (const auto& [name, count] : s.status) status[name] = count;
  Json judgements = Json::object();
  for (const auto& [name, count] : s.judgement) judgements[name] = count;
  Json unanswered = Json::array();
  for (const Unanswered& u : s.unanswered) {
    Json& json = unanswered.emplace_back(Json{{"sample", u.sample}, {"status", u.status}});
    put(json, "reason", u.reason);
  }
  return {{"asked", s.asked},
          {"run", s.run},
          {"answered", s.answered},
          {"judgements", judgements},
          {"still_rising", s.still_rising},
          {"named_earlier", s.named_earlier},
          {"collapsed_before_push", s.collapsed_before_push},
          {"status", status},
          {"unanswered", unanswered}};
}

Json inputs_json(const Statistics& s) {
  return io::list_of(s.input, [&](const InputSummary& in) -> Json {
    return {{"name", in.name},         {"unit", in.unit},       {"random", in.is_random},
            {"mean", number(in.mean)}, {"cov", number(in.cov)}, {"min", number(in.min)},
            {"max", number(in.max)}};
  });
}

Json input_correlation_json(const Statistics& s) {
  return io::list_of(s.input_correlation, [&](const InputCorrelation& c) -> Json {
    return {{"a", c.a}, {"b", c.b}, {"spearman", number(c.rank)}};
  });
}

Json shares_json(const Statistics& s) {
  Json json = Json::object();
  for (const Share& share : s.share) {
    Json& of_mode = json[share.name] = {{"modes", share.modes}, {"count", share.count}};
    add(of_mode, "share", share.share);
  }
  return json;
}

Json sensitivity_json(const Statistics& s) {
  Json list = Json::array();
  for (const NameSensitivity& n : s.name_sensitivity) {
    const NameReading& r = n.reading;
    Json row;
    put(row, "reading", r.what());
    row["state"] = r.state.empty() ? Json(nullptr) : Json(r.state);
    row["threshold"] = r.threshold.empty() ? Json(nullptr) : Json(r.threshold);
    row["factor"] = number(r.factor);
    row["n"] = n.n, row["differs"] = n.differs;
    add(row, "share", n.share);
    list.push_back(std::move(row));
  }
  return list;
}

Json flags_json(const Statistics& s) {
  Json list = Json::array();
  for (const FlagCount& f : s.flag) {
    Json row = {{"element", f.flag.element},
                {"measure", f.flag.measure},
                {"threshold", number(f.flag.threshold)},
                {"unit", f.flag.unit},
                {"n", f.n},
                {"raised", f.raised}};
    add(row, "share", f.share);
    list.push_back(std::move(row));
  }
  return list;
}

// Indices of the written entries of a long list: all, or kMostPoints evenly spaced from the first to the last.
std::vector<std::size_t> written(std::size_t n) {
  constexpr std::size_t kMostPoints = 2000;  // more than a picture has columns of pixels
  std::vector<std::size_t> places(std::min(n, kMostPoints));
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = n <= kMostPoints ? i : i * (n - 1) / (kMostPoints - 1);
  return places;
}

Json running_json(const Statistics& s) {
  Json json = Json::object();
  for (std::size_t q = 0; q < s.running.size(); ++q) {
    const double scale = quantities()[q].to_unit;
    const RunningMean& running = s.running[q];
    Json n = Json::array(), mean = Json::array(), low = Json::array(), high = Json::array();
    for (const std::size_t i : written(running.mean.size())) {
      const Estimate& e = running.mean[i];
      n.push_back(running.n[i]);
      mean.push_back(number(e.value * scale));
      low.push_back(number(e.interval.low * scale));
      high.push_back(number(e.interval.high * scale));
    }
    json[key_of(quantities()[q])] = {{"n", n}, {"mean", mean}, {"low", low}, {"high", high}};
  }
  return json;
}

Json of_walls_json(const OfWalls& of, double scale) {
  Json json = {{"n", of.n}, {"bounds", of.bounds}};
  add(json, "median", of.median, scale);
  json["at_least"] = number(of.at_least * scale);
  json["smallest"] = number(of.smallest * scale);
  json["largest"] = number(of.largest * scale);
  json["log_scatter"] = number(of.log_scatter);
  return json;
}

// d(r): arrays of equal length, by the remaining share of the peak.
Json walls_json(const WallEnsemble& walls) {
  Json json = {{"peak_reaction_kN", of_walls_json(walls.peak_reaction, 1e-3)},
               {"displacement_at_peak_mm", of_walls_json(walls.displacement_at_peak, 1e3)},
               {"displacement_at_80_percent_mm", of_walls_json(walls.displacement_at_80, 1e3)}};
  Json& capacity = json["drift_capacity"] = {{"left", walls.left}};
  for (const char* key : {"n", "median_mm", "at_least_mm", "low_mm", "high_mm", "bounds"})
    capacity[key] = Json::array();
  for (const OfWalls& of : walls.capacity) {
    capacity["n"].push_back(of.n);
    capacity["median_mm"].push_back(number(of.median.value * 1e3));
    capacity["at_least_mm"].push_back(number(of.at_least * 1e3));
    capacity["low_mm"].push_back(number(of.median.interval.low * 1e3));
    capacity["high_mm"].push_back(number(of.median.interval.high * 1e3));
    capacity["bounds"].push_back(of.bounds);
  }
  Json& modes = json["failure_modes"] = Json::object();
  for (const Share& mode : walls.mode) {
    modes[mode.name] = {{"count", mode.count}};
    add(modes[mode.name], "share", mode.share);
  }
  return json;
}

Json precision_json(const Statistics& s) {
  const auto size = [](int n) { return n > 0 ? Json(n) : Json(nullptr); };
  return io::list_of(s.precision, [&](const Precision& p) -> Json {
    return {{"what", p.what},
            {"half_width_asked", p.target},
            {"half_width_now", number(p.now)},
            {"first_met_at", size(p.first_met)},
            {"held_from", size(p.held_from)},
            {"expected_at", size(p.expected)}};
  });
}

Json correlation_json(const Statistics& s) {
  Json list = Json::array();
  for (const CorrelationTable& table : s.correlation) {
    for (const Correlation& c : table.input) {
      Json row = {{"group", table.group},
                  {"response", table.quantity},
                  {"input", c.input},
                  {"n", c.n},
                  {"censored", table.censored}};
      add(row, "pearson", c.pearson);
      add(row, "spearman", c.spearman);
      add(row, "partial_rank", c.partial_rank);
      list.push_back(std::move(row));
    }
  }
  return list;
}

Json first_order_json(const Statistics& s) {
  Json list = Json::array();
  for (const FirstOrderIndex& f : s.first_order) {
    Json row = {{"response", f.quantity}, {"input", f.input}, {"bins", f.bins}};
    add(row, "index", f.index);
    row["entangled_with"] = f.entangled;
    list.push_back(std::move(row));
  }
  return list;
}

Json bin_json(const ModeBin& bin, const std::vector<std::string>& modes,
              const InputColumn& column) {
  const auto shown = [&](double si) { return number(si * column.to_unit + column.offset); };
  Json json = {
      {"n", bin.n}, {"low", shown(bin.low)}, {"high", shown(bin.high)}, {"mean", shown(bin.mean)}};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    Json& of_mode = json["share"][modes[m]] = Json::object();
    add(of_mode, "share", bin.share[m]);
  }
  return json;
}

Json modes_json(const Statistics& s) {
  Json list = Json::array();
  for (const ModeAgainstInput& input : s.mode_against_input) {
    Json bins = Json::array();
    for (const ModeBin& bin : input.bin) bins.push_back(bin_json(bin, input.modes, input.column));
    list.push_back({{"input", input.column.name}, {"unit", input.column.unit}, {"bins", bins}});
  }
  return list;
}

Json mean_curve_json(const MeanCurve& curve) {
  const auto column = [&](double CurvePoint::*value, double to_unit) {
    return list_of(curve.point, [&](const CurvePoint& p) { return number(p.*value * to_unit); });
  };
  return {{"curves", curve.n},
          {"displacement_mm", column(&CurvePoint::displacement, 1e3)},
          {"drift_percent", column(&CurvePoint::drift, 1e2)},
          {"n", list_of(curve.point, &CurvePoint::n)},
          {"reaction_mean_kN", column(&CurvePoint::mean, 1e-3)},
          {"reaction_standard_deviation_kN", column(&CurvePoint::standard_deviation, 1e-3)},
          {"reaction_5_percent_kN", column(&CurvePoint::low, 1e-3)},
          {"reaction_95_percent_kN", column(&CurvePoint::high, 1e-3)}};
}

Json drift_limits_json(const Statistics& s) {
  Json list = Json::array();
  for (const DriftLimit& d : s.drift_limit) {
    Json row = {{"element", d.element}, {"mechanism", d.mechanism},
                {"label", d.label},     {"state", d.state},
                {"clause", d.clause},   {"limit_drift_percent", number(d.limit * 1e2)},
                {"below", d.below},     {"unknown", d.unknown}};
    add(row, "share_below", d.share);
    row["share_below_is_lower_bound"] = d.is_lower_bound;
    list.push_back(std::move(row));
  }
  return list;
}

Json exceedance_json(const Exceedance& e, const Quantity& q) {
  const std::string unit = unit_in_key(q);
  Json value = Json::array(), probability = Json::array(), low = Json::array(),
       high = Json::array();
  for (const std::size_t i : written(e.point.size())) {
    const ExceedancePoint& p = e.point[i];
    value.push_back(number(p.value * q.to_unit));
    probability.push_back(number(p.probability.value));
    low.push_back(number(p.probability.interval.low));
    high.push_back(number(p.probability.interval.high));
  }
  Json fit = Json::object();
  add(fit, "median" + unit, e.median, q.to_unit);
  add(fit, "beta", e.beta);
  fit["misfit"] = number(e.misfit);
  return {
      {"n", e.n},   {"censored", e.censored}, {"value" + unit, value}, {"probability", probability},
      {"low", low}, {"high", high},           {"lognormal", fit}};
}

// "slope_per_MPa"
Json fit_json(const FragilityFit& fit) {
  Json json = {{"law", word_of(kFragilityLawWords, fit.law)}};
  add(json, "slope", fit.slope);
  add(json, "half_at", fit.half);
  if (fit.law == FragilityLaw::kLognormal) {
    const Interval& s = fit.slope.interval;
    const bool has_sign = s.low > 0 || s.high < 0;
    const double ends[] = {std::fabs(1 / s.low), std::fabs(1 / s.high)};
    add(json, "beta",
        {std::fabs(1 / fit.slope.value),
         has_sign ? Interval{std::fmin(ends[0], ends[1]), std::fmax(ends[0], ends[1])}
                  : Interval{std::fmin(ends[0], ends[1]), kUnset}});
  }
  json["log_likelihood"] = number(fit.log_likelihood);
  json["influence_p"] = number(fit.influence_p);
  json["fit_p"] = number(fit.fit_p);
  return json;
}

Json fragility_input_json(const FragilityOfInput& of) {
  Json json = {{"input", of.input},
               {"unit", of.unit},
               {"verdict", word_of(kFragilityVerdictWords, of.verdict)},
               {"entangled_with", of.entangled}};
  if (of.verdict == FragilityVerdict::kSeparated)
    json["parted_between"] = pair({of.parted_low, of.parted_high});
  json["fits"] = list_of(of.fit, fit_json);
  if (of.point.empty()) return json;
  Json& curve = json["curve"] = {{"law", word_of(kFragilityLawWords, of.fit.front().law)}};
  curve["input"] = list_of(of.point, [](const FragilityPoint& p) { return number(p.x); });
  add_probabilities(curve, of.point);
  return json;
}

Json fragility_pair_json(const FragilityOfPair& pair) {
  Json json = {{"inputs", {pair.a, pair.b}},
               {"verdict", word_of(kFragilityVerdictWords, pair.verdict)}};
  if (pair.verdict != FragilityVerdict::kTold) return json;
  json["intercept"] = number(pair.intercept);
  add(json, "slope_1", pair.slope_a);
  add(json, "slope_2", pair.slope_b);
  json["added_p"] = number(pair.added_p);
  json["fit_p"] = number(pair.fit_p);
  return json;
}

Json fragility_json(const Statistics& s) {
  Json list = Json::array();
  for (const Fragility& f : s.fragility) {
    const FragilityEvent& event = f.event;
    Json row = {{"response", event.response}};
    if (event.of_mode()) row["mode"] = event.mode;
    if (!event.of_mode())
      row["greater_than"] = number(event.threshold * event.to_unit), row["unit"] = event.unit;
    row["n"] = f.n, row["seen"] = f.seen, row["unknown"] = f.unknown;
    row["repeated"] = f.repeated, row["not_slow_enough"] = f.doubtful;
    row["lost"] = s.run - f.n - f.repeated;  // samples without an answer, or without this response
    add(row, "share", f.share);
    row["sample"] = f.sample, row["outcome"] = f.outcome;
    row["inputs"] = Json::array(), row["pairs"] = Json::array();
    for (const FragilityOfInput& of : f.input) row["inputs"].push_back(fragility_input_json(of));
    for (const FragilityOfPair& of : f.pair) row["pairs"].push_back(fragility_pair_json(of));
    list.push_back(std::move(row));
  }
  return list;
}

Json measuring_json(const Statistics& s) {
  Json list = Json::array();
  for (const Measuring& m : s.measuring) {
    Json row = {{"response", m.quantity}, {"input", m.input}, {"n", m.n}, {"censored", m.censored}};
    add(row, "variance_share", m.variance);
    add(row, "width_share", m.width);
    row["is_best"] = number(m.is_best);
    list.push_back(std::move(row));
  }
  return list;
}

Json surrogate_json(const Statistics& s) {
  Json list = Json::array();
  for (const SurrogateIndices& of : s.surrogate_indices) {
    Json row = {{"response", of.quantity},
                {"verdict", word_of(kIndexVerdictWords, of.verdict)},
                {"n", of.n},
                {"q2", number(of.q2)},
                {"q2_asked", kLeastQ2},
                {"terms", of.terms}};
    row["inputs"] = Json::array();
    for (const SurrogateIndices::Of& input : of.input) {
      Json& json = row["inputs"].emplace_back(Json{{"input", input.input}});
      add(json, "first_order", input.first_order);
      add(json, "total", input.total);
    }
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace

std::string statistics_json(const Statistics& s) {
  Json json = {{"study", s.study}, {"design", s.design}, {"seed", s.seed}};
  json["samples"] = samples_json(s);
  json["load_height_m"] = number(s.load_height);
  json["read_modes_at_mm"] = number(s.read_modes_at * 1e3);
  json["interval"] = {{"confidence", 0.95}, {"bootstrap_replicates", s.replicates}};
  json["inputs"] = inputs_json(s);
  json["input_correlation"] = input_correlation_json(s);
  json["modes"] = s.modes;
  json["table"] = table_json(s);
  json["shares"] = shares_json(s);
  json["walls"] = walls_json(s.walls);
  json["name_sensitivity"] = sensitivity_json(s);
  json["flags"] = flags_json(s);
  json["precision"] = precision_json(s);
  json["drift_limits"] = drift_limits_json(s);
  json["correlation"] = correlation_json(s);
  json["first_order"] = first_order_json(s);
  json["mode_against_input"] = modes_json(s);
  json["fragility"] =
      s.shaking.shaking.is_asked() ? limit_states_json(s.shaking) : fragility_json(s);
  if (s.shaking.is_told()) json["shaking"] = shaking_json(s.shaking);
  if (is_asked(s.assessment.spec)) json["assessment"] = assessment_json(s.assessment);
  add_project(json, s.project);
  json["measuring"] = measuring_json(s);
  json["surrogate_indices"] = surrogate_json(s);
  json["running"] = running_json(s);
  json["mean_curves"] = Json::object();
  for (const MeanCurve& curve : s.mean_curve)
    json["mean_curves"][curve.group] = mean_curve_json(curve);
  json["exceedance"] = Json::object();
  for (const Exceedance& e : s.exceedance) {
    const Quantity& q = quantity_named(e.quantity);
    json["exceedance"][key_of(q)] = exceedance_json(e, q);
  }
  // "replace", so that a name that is not UTF-8 does not lose the campaign
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wythe
