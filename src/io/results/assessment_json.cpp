// Writes an assessment with the unit in each key: accelerations in g, lengths in mm,
// forces in kN. The points of a spectrum are closer together at short periods, and include
// its corners. Without limit states the object ends after verdict, spectrum and notes.
#include "io/results/assessment_json.h"

#include <algorithm>
#include <cmath>

#include "io/export/statistics_numbers.h"
#include "io/results/message_json.h"

namespace wythe::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSpectrumPoints = 80;  // closer together at short periods

Json criteria_json(const LimitStateCheck& check) {
  Json list = Json::array();
  for (const Criterion& c : check.criteria) {
    Json& json = list.emplace_back(Json{{"name", c.name}});
    put(json, "words", c.words);
    json.update({{"clause", c.clause},
                 {"verified", c.verified},
                 {"value", c.value},
                 {"unit", c.unit},
                 {"displacement_mm", c.displacement * 1e3},
                 {"reached", c.reached},
                 {"governs", c.name == check.governing}});
  }
  return list;
}

Json limit_states_json(const CodeAssessment& a) {
  return io::list_of(a.limit_states, [&](const LimitStateCheck& check) -> Json {
    return {{"state", word_of(kLimitStateWords, check.state)},
            {"is_checked", check.is_asked},
            {"verdict", word_of(kAssessmentVerdictWords, check.verdict)},
            {"displacement_mm", check.displacement * 1e3},
            {"drift_percent", check.drift * 1e2},
            {"at_least", check.at_least},
            {"governing", check.governing},
            {"capacity_over_demand", check.ratio},
            {"spectrum_factor", check.scale},
            {"pga_g", check.acceleration / kStandardGravity},
            {"ground_acceleration_g", check.rock_acceleration / kStandardGravity},
            {"demand_pga_g", check.demand_acceleration / kStandardGravity},
            {"demand_displacement_mm", check.demand_displacement * 1e3},
            {"q", check.q},
            {"criteria", criteria_json(check)}};
  });
}

Json mass_json(const MassAndShape& m) {
  return {{"blocks_kg", m.blocks},
          {"loads_kg", m.loads},
          {"added_kg", m.added},
          {"total_kg", m.total()},
          {"participating_kg", m.participating},
          {"participation_factor", m.participation},
          {"shape", m.is_linear ? "linear" : "displacements"},
          {"shape_read_at_mm", m.read_at * 1e3}};
}

}  // namespace

Json bilinear_json(const Bilinear& b) {
  return {{"stiffness_kN_per_mm", b.stiffness * 1e-6},
          {"force_kN", b.force * 1e-3},
          {"yield_displacement_mm", b.yield_displacement * 1e3},
          {"ultimate_displacement_mm", b.ultimate_displacement * 1e3},
          {"ductility", b.ductility},
          {"censored", b.censored}};
}

Json spectrum_json(const ElasticSpectrum& s) {
  Json json = {{"kind", word_of(kSpectrumKindWords, s.kind)},
               {"ground_acceleration_g", s.ground_acceleration / kStandardGravity},
               {"pga_g", s.peak_ground_acceleration() / kStandardGravity},
               {"soil_factor", s.soil},
               {"topography", s.topography},
               {"eta", s.eta},
               {"amplification", s.amplification},
               {"TB_s", s.TB},
               {"TC_s", s.TC},
               {"TD_s", s.TD}};
  const double last = s.periods.empty() ? std::fmax(2.5, 1.2 * s.TD) : s.periods.back();
  std::vector<double> periods = s.periods;
  for (int i = 0; i <= kSpectrumPoints; ++i)
    periods.push_back(last * i * i / kSpectrumPoints / kSpectrumPoints);
  for (const double corner : {s.TB, s.TC, s.TD})
    if (corner < last) periods.push_back(corner);
  std::sort(periods.begin(), periods.end());
  periods.erase(std::unique(periods.begin(), periods.end()), periods.end());
  json["period_s"] = periods;
  json["acceleration_g"] =
      list_of(periods, [&](double T) { return s.acceleration(T) / kStandardGravity; });
  json["displacement_mm"] = list_of(periods, [&](double T) { return s.displacement(T) * 1e3; });
  return json;
}

Json assessment_json(const CodeAssessment& a) {
  Json json = {{"verdict", word_of(kAssessmentVerdictWords, a.verdict)},
               {"may_be_signed", a.may_be_signed}};
  put(json, "sentence", a.sentence);
  put(json, "cautions", a.cautions);
  put(json, "reason", a.reason);
  json["code"] = a.spec.code;
  json["limit_state"] = a.spec.limit_state;
  json["confidence_factor"] = a.spec.confidence_factor;
  json["masonry_share"] = a.spec.masonry_share;
  if (a.spectrum.is_given()) json["spectrum"] = spectrum_json(a.spectrum);
  put(json, "notes", a.notes);
  if (a.limit_states.empty()) return json;
  if (const LimitStateCheck* check = a.deciding())
    json["decides"] = word_of(kLimitStateWords, check->state);
  json["mass"] = mass_json(a.mass);
  const Bilinear& b = a.bilinear;
  json["bilinear"] = bilinear_json(b);
  json["equivalent"] = {
      {"mass_kg", a.system.mass},
      {"participation_factor", a.system.participation},
      {"force_kN", a.system.force * 1e-3},
      {"yield_displacement_mm", a.system.yield() * 1e3},
      {"ultimate_displacement_mm", b.ultimate_displacement / a.system.participation * 1e3},
      {"acceleration_g", a.system.force / a.system.mass / kStandardGravity},
      {"period_s", a.system.period()}};
  if (a.spectrum.is_given())
    json["demand"] = {{"q", a.demand.q},
                      {"elastic_displacement_mm", a.demand.elastic * 1e3},
                      {"equivalent_displacement_mm", a.demand.displacement * 1e3},
                      {"displacement_mm", a.demand_displacement * 1e3}};
  json["limit_states"] = limit_states_json(a);
  return json;
}

namespace {

Json fragility_json(const PgaFragility& f) {
  constexpr double kToG = 1 / kStandardGravity;
  Json json = {{"limit_state", f.limit_state},
               {"is_checked", f.is_checked},
               {"n", f.n},
               {"censored", f.censored}};
  add(json, "median_pga_g", f.median, kToG);
  add(json, "beta_capacity", f.beta_capacity);
  json["beta"] = number(f.beta);
  json["demand_pga_g"] = number(f.demand * kToG);
  add(json, "probability_at_demand", f.at_demand);
  json["curve"]["pga_g"] =
      list_of(f.curve, [&](const FragilityPoint& p) { return number(p.x * kToG); });
  add_probabilities(json["curve"], f.curve);
  json["samples"] = {
      {"pga_g", list_of(f.point, [&](const auto& p) { return number(p.value * kToG); })},
      {"share_reached",
       list_of(f.point, [](const auto& p) { return number(1 - p.probability.value); })}};
  return json;
}

}  // namespace

Json assessment_json(const CampaignAssessment& a) {
  Json json = {{"code", a.spec.code},
               {"limit_state", a.spec.limit_state},
               {"record_scatter", number(a.spec.record_scatter)},
               {"answered", a.answered},
               {"without_answer", a.without_answer},
               {"not_to_be_signed", a.doubtful},
               {"mass", mass_json(a.mass)}};
  put(json, "sentence", sentence_of(a));
  put(json, "cautions", cautions_of(a));
  put(json, "reason", a.reason);
  put(json, "notes", a.notes);
  json["limit_states"] = list_of(a.fragility, fragility_json);
  return json;
}

void add_project(Json& json, const ProjectSpec& project) {
  Json heads = Json::object();
  for (const auto& [name, text] : {std::pair{"title", &project.title},
                                   {"client", &project.client},
                                   {"author", &project.author},
                                   {"date", &project.date},
                                   {"place", &project.place}})
    if (!text->empty()) heads[name] = *text;
  if (!heads.empty()) json["project"] = std::move(heads);
}

}  // namespace wythe::io
