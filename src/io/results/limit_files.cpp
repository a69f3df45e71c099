// mechanisms.json and mechanism_<name>.csv of `wythe limit`; keys: docs/reference/limit.md.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/results/assessment_json.h"
#include "io/results/message_json.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/io.h"
#include "wythe/parts/provenance.h"

namespace wythe {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMilli = 1e3, kPerKilo = 1e-3;

Json point_json(Vec2 p) { return {p.x, p.y}; }

Json points_json(const std::vector<Vec2>& points) { return io::list_of(points, point_json); }

Json forces_json(const std::vector<Vec2>& forces) {
  return io::list_of(forces, [](Vec2 f) -> Json { return {f.x * kPerKilo, f.y * kPerKilo}; });
}

// An infinite strength has no number in JSON.
Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json("unlimited"); }

Json bodies_json(const Chain& chain) {
  return io::list_of(chain.bodies, [](const MacroBlock& body) -> Json {
    const Json loads = io::list_of(body.loads, [](const BodyLoad& load) -> Json {
      return {{"kind", load.is_weight ? "self-weight" : "dead load"},
              {"at_m", point_json(load.at)},
              {"fx_kN", load.fx * kPerKilo},
              {"fy_kN", load.fy * kPerKilo}};
    });
    return {{"name", body.name}, {"outline_m", points_json(body.outline)}, {"loads", loads}};
  });
}

// One array for each quantity with one entry for each state, for pages that draw the moving bodies.
Json curve_json(const CapacityCurve& curve) {
  const auto hinges = [](const ChainState& s) { return points_json(s.hinges); };
  return {{"ends_where", word_of(kChainEndWords, curve.end)},
          {"displacement_mm", io::column_of(curve.states, &ChainState::displacement, kMilli)},
          {"force_kN", io::column_of(curve.states, &ChainState::force, kPerKilo)},
          {"rotation_rad", io::list_of(curve.states, &ChainState::rotation)},
          {"rotation_ratio", io::list_of(curve.states, &ChainState::rate)},
          {"hinges_m", io::list_of(curve.states, hinges)}};
}

Json assessment_json(const Assessment& a, const LimitStateShares& shares) {
  return {{"clause", "Circolare 7/2019, C8.7.1.2.1"},
          {"note",
           "force and displacements at the load point, confidence factor 1; acceleration0 goes "
           "with the "
           "displacements that are called spectral; shares of d0: C8.7.1.2.1.6, of parts out of "
           "plane"},
          {"alpha0", a.alpha0},
          {"alpha0_by_weights", a.alpha0_by_weights},
          {"participating_mass_kg", a.participating_mass},
          {"participating_mass_share", a.mass_share},
          {"acceleration0_m_per_s2", a.acceleration0},
          {"displacement0_mm", a.displacement0 * kMilli},
          {"spectral_share", a.spectral_share},
          {"spectral_displacement0_mm", a.spectral(a.displacement0) * kMilli},
          {"life_safety_share_of_d0", shares.life_safety},
          {"life_safety_displacement_mm", a.life_safety * kMilli},
          {"near_collapse_share_of_d0", shares.near_collapse},
          {"near_collapse_displacement_mm", a.near_collapse * kMilli},
          {"life_safety_spectral_displacement_mm", a.spectral(a.life_safety) * kMilli},
          {"near_collapse_spectral_displacement_mm", a.spectral(a.near_collapse) * kMilli}};
}

Json known(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json local_state_json(const LocalStateCheck& s) {
  return {{"limit_state", word_of(kLimitStateWords, s.state)},
          {"verdict", word_of(kAssessmentVerdictWords, s.verdict)},
          {"pga_demand_g", known(s.ground_demand / kStandardGravity)},
          {"pga_capacity_g", known(s.acceleration / kStandardGravity)},
          {"acceleration_demand_m_per_s2", known(s.demand)},
          {"q", known(s.q)},
          {"capacity_over_demand_by_q", known(s.q_ratio)},
          {"displacement_mm", known(s.displacement * kMilli)},
          {"secant_period_s", known(s.period)},
          {"displacement_demand_mm", known(s.displacement_demand * kMilli)},
          {"capacity_over_demand_by_displacement", known(s.displacement_ratio)},
          {"by_onset", s.by_onset}};
}

Json mechanism_json(const Mechanism& m) {
  Json inputs = Json::object();
  for (const NamedNumber& n : m.inputs)
    inputs[n.name] = {{"value", number_json(n.value)}, {"unit", n.unit}};
  const auto& start = m.curve.states.front();
  return {{"name", m.file_name()},
          {"mode", m.mode},
          {"hypothesis", word_of(kHypothesisWords, m.hypothesis)},
          {"force_at_rest_kN", start.force * kPerKilo},
          {"displacement_without_force_mm", m.curve.states.back().displacement * kMilli},
          {"rotation_ratios", start.rate},
          {"inputs", inputs},
          {"hinge_names", m.chain.hinges.size() == 4 ? Json{"C1", "C12", "C23", "C3"} : Json{"C1"}},
          {"hinges_m", points_json(m.chain.hinges)},
          {"hinge_forces_at_rest_kN", forces_json(hinge_forces(m.chain, start.force))},
          {"bodies", bodies_json(m.chain)},
          {"load_point_m", point_json(m.chain.load_point)},
          {"loaded_body", m.chain.loaded_body},
          {"direction", m.chain.direction},
          {"curve", curve_json(m.curve)}};
}

Json limit_json(const NamedLimit& limit) {
  const LimitResult& a = limit.answer;
  const double unit = a.is_force ? kPerKilo : 1.0;
  const std::string tail = a.is_force ? "_kN" : "";
  Json json{{"name", limit.name},
            {"joints", word_of(kJointStrengthWords, a.options.strength)},
            {"friction", word_of(kFrictionChoiceWords, a.options.friction)},
            {"crushing", word_of(kCrushingChoiceWords, a.options.crushing)}};
  json["static" + tail] = a.load * unit;
  json["kinematic" + tail] = a.kinematic * unit;
  json["gap"] = a.load != 0 ? std::fabs(a.kinematic / a.load - 1) : 0.0;
  json["accuracy"] = a.accuracy;
  json["rows"] = a.rows;
  json["columns"] = a.columns;
  json["tangents"] = a.cuts;
  json["seconds"] = a.seconds;
  json["velocity_x"] = a.vx;
  json["velocity_y"] = a.vy;
  json["spin_per_m"] = a.omega;
  if (!a.vz.empty()) {
    json["velocity_z"] = a.vz;
    json["spin_x_per_m"] = a.omega_x;
    json["spin_y_per_m"] = a.omega_y;
    json["shear_force_2_N"] = a.shear_force_2;
    json["friction_excess"] = a.friction_excess;
  }
  json["point_force_N"] = a.point_force;
  json["shear_force_N"] = a.shear_force;
  if (!a.link_force.empty()) json["link_force_N"] = a.link_force;
  return json;
}

Json rows_json(const std::vector<CurveRow>& rows) {
  return {{"displacement_mm", io::column_of(rows, &CurveRow::displacement, kMilli)},
          {"force_kN", io::column_of(rows, &CurveRow::reaction, kPerKilo)}};
}

Json envelope_json(const std::vector<EnvelopePoint>& points) {
  using Point = EnvelopePoint;
  return {{"displacement_mm", io::column_of(points, &Point::displacement, kMilli)},
          {"low_kN", io::column_of(points, &Point::low, kPerKilo)},
          {"percentile_5_kN", io::column_of(points, &Point::percentile_5, kPerKilo)},
          {"mean_kN", io::column_of(points, &Point::mean, kPerKilo)},
          {"percentile_95_kN", io::column_of(points, &Point::percentile_95, kPerKilo)},
          {"high_kN", io::column_of(points, &Point::high, kPerKilo)},
          {"runs", io::list_of(points, &Point::runs)}};
}

Json verdicts_json(const Comparison& c) {
  return io::list_of(c.curves, [&](const CurveVerdict& v) -> Json {
    return {{"run", v.run},
            {"mode", v.mode},
            {"mechanism", v.mechanism},
            {"peak_ratio", v.peak_ratio},
            {"post_peak_gap_kN", v.gap * kPerKilo},
            {"post_peak_gap_share_of_peak", v.gap_share}};
  });
}

Json groups_json(const Comparison& c) {
  return io::list_of(c.groups, [&](const GroupVerdict& g) -> Json {
    return {{"mode", g.mode},
            {"mechanism", g.mechanism},
            {"runs", g.runs},
            {"mean_peak_kN", g.mean_peak * kPerKilo},
            {"mean_peak_ratio", g.peak_ratio},
            {"mean_post_peak_gap_kN", g.gap * kPerKilo},
            {"mean_post_peak_gap_share_of_peak", g.gap_share}};
  });
}

Json bounds_json(const Comparison& c) {
  Json list = Json::array();
  for (const BoundVerdict& b : c.bounds) {
    const double unit = b.is_force ? kPerKilo : 1.0;
    const std::string tail = b.is_force ? "_kN" : "";
    Json& json = list.emplace_back(Json{{"run", b.run},
                                        {"peak" + tail, b.peak * unit},
                                        {"bound" + tail, b.bound * unit},
                                        {"allowance", b.allowance},
                                        {"holds", b.holds()}});
    io::put(json, "no_evidence", b.no_evidence);
  }
  return list;
}

Json without_bound_json(const Comparison& c) {
  Json list = Json::array();
  for (const ComparedRun& run : c.runs)
    if (!run.no_bound.empty()) list.push_back({{"run", run.name}, {"why", run.no_bound}});
  return list;
}

Json bracket_json(const BracketVerdict& b) {
  if (b.runs == 0) return nullptr;
  const double unit = b.is_force ? kPerKilo : 1.0;
  const std::string tail = b.is_force ? "_kN" : "";
  return {{"low" + tail, b.low * unit},
          {"high" + tail, b.high * unit},
          {"least_peak" + tail, b.least_peak * unit},
          {"most_peak" + tail, b.most_peak * unit},
          {"runs", b.runs},
          {"below", b.below},
          {"above", b.above},
          {"nominal", b.runs > 1}};
}

Json comparison_json(const SecondOpinion& opinion) {
  const Comparison& c = opinion.comparison;
  if (c.with.empty()) return nullptr;
  Json json{{"with", c.with}, {"runs", c.runs.size()}};
  json["groups"] = groups_json(c);
  json["bounds"] = bounds_json(c);
  json["without_bound"] = without_bound_json(c);
  json["bracket"] = bracket_json(c.bracket);
  json["curves"] = verdicts_json(c);
  if (c.runs.size() == 1) json["curve"] = rows_json(c.runs.front().curve);
  json["envelopes"] = Json::object();
  for (const char* mode : {"FM-1", "FM-4"}) {
    const std::vector<EnvelopePoint> points = envelope(c.runs, mode);
    if (!points.empty()) json["envelopes"][mode] = envelope_json(points);
  }
  return json;
}

}  // namespace

nlohmann::ordered_json io::local_json(const LocalCheck& c) {
  const LocalCapacity& k = c.capacity;
  Json json{{"name", c.name},
            {"by", c.by},
            {"clause", "Circolare 7/2019, C8.7.1.2.1; spectrum at a height C7.2.3"},
            {"verified", true},
            {"verdict", word_of(kAssessmentVerdictWords, c.verdict)},
            {"may_be_signed", c.may_be_signed}};
  put(json, "sentence", c.sentence);
  put(json, "cautions", c.cautions);
  put(json, "notes", c.notes);
  json["foot_m"] = c.foot;
  json["head_m"] = known(c.head);
  json["hinge_m"] = known(c.hinge);
  json["inset_mm"] = c.inset * kMilli;
  json["masonry_kN"] = c.masonry * kPerKilo;
  json["floors_kN"] = c.floors * kPerKilo;
  json["weight_kN"] = k.weight * kPerKilo;
  json["alpha0"] = known(k.alpha0);
  json["participating_mass_kg"] = known(k.mass);
  json["participating_mass_share"] = known(k.mass_share);
  json["confidence_factor"] = c.confidence_factor;
  json["acceleration0_m_per_s2"] = known(c.acceleration0);
  json["alpha0_to_the_end"] = known(k.alpha0_to_end);
  json["acceleration0_to_the_end_m_per_s2"] = known(c.acceleration0_to_end);
  json["rotation0_rad"] = known(k.rotation0);
  json["displacement0_mm"] = known(k.displacement0 * kMilli);
  json["displacement0_of_top_mm"] = known(k.top0 * kMilli);
  json["slides_off_mm"] = known(k.slides_off * kMilli);
  json["lets_go_mm"] = known(k.lets_go * kMilli);
  json["building"] = {{"height_m", known(c.building.top)},
                      {"period_s", known(c.building.period)},
                      {"storeys", c.building.storeys},
                      {"part_at_m", known(c.building.height)},
                      {"share_of_first_mode", c.building.share()}};
  json["limit_states"] = list_of(c.states, local_state_json);
  return json;
}

std::string mechanisms_json(const Model& model, const SecondOpinion& opinion) {
  Json json{{"wythe", provenance().version}, {"blocks", model.n_block}, {"joints", model.n_joint}};
  json["mechanisms"] = Json::array();
  for (std::size_t i = 0; i < opinion.mechanisms.size(); ++i) {
    json["mechanisms"].push_back(mechanism_json(opinion.mechanisms[i]));
    if (i < opinion.assessments.size())
      json["mechanisms"].back()["assessment"] =
          assessment_json(opinion.assessments[i], opinion.shares);
  }
  json["local"] = io::list_of(opinion.local, io::local_json);
  json["limit_loads"] = io::list_of(opinion.limits, limit_json);
  json["refused"] = Json::array();
  for (const Refusal& r : opinion.refused) {
    io::put(json["refused"].emplace_back(), "what", r.what);
    json["refused"].back()["why"] = r.why;
  }
  io::put(json, "notes", opinion.notes);
  json["block_id"] = model.anatomy.block_id;
  json["comparison"] = comparison_json(opinion);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string mechanism_csv(const CapacityCurve& curve) {
  std::string text = "displacement_mm,force_kN\n";
  for (const ChainState& s : curve.states)
    text += fmt::format("{:.10g},{:.10g}\n", s.displacement * kMilli, s.force * kPerKilo);
  return text;
}

}  // namespace wythe
