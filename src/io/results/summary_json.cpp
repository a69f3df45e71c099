// summary.json of a run: the main numbers, with their evidence and provenance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "dynamics/meters/still_moving.h"
#include "io/results/assessment_json.h"
#include "io/results/message_json.h"
#include "judge/modes/wall_parts.h"
#include "wythe/parts/io.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/provenance.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/slow_push.h"
#include "wythe/parts/tested_range.h"

namespace wythe {
namespace {

using Json = nlohmann::ordered_json;

Json energy_json(const EnergyLedger& energy) {
  Json json = Json::object();
  for (const EnergyTerm& term : kEnergyTerms) json[term.name] = energy.*term.value;
  return json;
}

// Puts each result under its key, in the units of the key's name.
struct Answers {
  Json& json;
  void operator()(const OutputKey& key, const auto& value) const {
    const std::string path = key.summary;  // "bilinear.force_kN" is a member of an object
    const std::size_t dot = path.find('.');
    if (dot == std::string::npos)
      put(json, path, key, value);
    else
      put(json[path.substr(0, dot)], path.substr(dot + 1), key, value);
  }

 private:
  static void put(Json& in, const std::string& name, const OutputKey& key, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double>)
      in[name] = value * key.to_unit;
    else if constexpr (std::is_same_v<Value, Message>)
      io::put(in, name, value);
    else
      in[name] = value;
  }
};

Json evidence_json(const std::vector<Evidence>& evidence) {
  return io::list_of(evidence, [&](const Evidence& e) -> Json {
    return {{"element", e.element},     {"measure", e.measure}, {"value", e.value},
            {"threshold", e.threshold}, {"unit", e.unit},       {"margin", e.margin()}};
  });
}

Json flags_json(const std::vector<Evidence>& flags) {
  Json list = evidence_json(flags);
  for (std::size_t i = 0; i < flags.size(); ++i) list[i]["raised"] = flags[i].holds();
  return list;
}

Json elements_json(const Model& model, const std::vector<ElementState>& elements) {
  const study::WallParts parts = study::find_parts(model);
  std::map<std::string, const study::Part*> by_name;
  for (const auto& [part, kind] : study::all_parts(parts)) by_name[part->name] = part;
  Json list = Json::array();
  for (const ElementState& e : elements) {
    const auto part = by_name.find(e.element);
    Json signs = Json::array();
    for (const ElementSign& s : e.signs) {
      signs.push_back({{"state", s.state},
                       {"holds", s.holds()},
                       {"measure", s.measure},
                       {"value", s.value},
                       {"threshold", s.threshold},
                       {"unit", s.unit},
                       {"displacement_first_mm", s.displacement_first * 1e3}});
    }
    list.push_back({{"element", e.element},
                    {"kind", e.kind},
                    {"mark", part != by_name.end() ? part->second->mark : ""},
                    {"storey", part != by_name.end() ? part->second->storey : 0},
                    {"state", e.state},
                    {"displacement_first_mm", e.displacement_first * 1e3},
                    {"signs", signs}});
  }
  return list;
}

Json mechanism_json(const WallMechanism& mechanism) {
  Json scores = Json::object();
  for (const auto& [name, score] : mechanism.scores) scores[name] = score;
  Json json = {{"name", mechanism.name}};
  io::put(json, "sentence", mechanism.sentence);
  json.update(
      {{"storeys", mechanism.storeys}, {"candidates", mechanism.candidates}, {"scores", scores}});
  return json;
}

Json failure_mode_json(const Model& model, const Result& result) {
  const FailureMode& mode = result.failure_mode;
  Json scores = Json::object();
  for (const auto& [name, score] : mode.scores) scores[name] = score;
  Json sensitivity = Json::array();
  for (const NameReading& other : mode.sensitivity) {
    io::put(sensitivity.emplace_back(), "what", other.what());
    sensitivity.back()["name"] = other.name;
  }
  Json json = {{"name", mode.name}};
  io::put(json, "sentence", mode.sentence);
  json["read_at_mm"] = mode.read_at * 1e3;
  io::put(json, "reading", mode.reading);
  json.update({{"mechanism", mechanism_json(read_mechanism(model, result))},
               {"scores", scores},
               {"evidence", evidence_json(mode.evidence)},
               {"elements", elements_json(model, mode.elements)},
               {"flags", flags_json(mode.flags)},
               {"sensitivity", sensitivity}});
  return json;
}

Json slow_push_json(const SlowPushVerdict& promise) {
  Json json = {{"verdict", promise.verdict}};
  io::put(json, "reason", promise.reason);
  return json;
}

Json features_json(const std::vector<Feature>& features) {
  return io::list_of(features, [&](const Feature& f) -> Json {
    return {
        {"name", f.name}, {"displacement_mm", f.displacement * 1e3}, {"value_mm", f.value * 1e3}};
  });
}

Json events_json(const std::vector<Event>& events) {
  Json list = Json::array();
  for (const Event& event : events) {
    Json& json = list.emplace_back();
    io::put(json, "name", event.name);
    json["displacement_mm"] = event.displacement * 1e3;
    json["reaction_kN"] = event.reaction * 1e-3;
    io::put(json, "where", event.where);
  }
  return list;
}

// For each link: the largest force over the curve with its place, and the plastic elongation.
Json links_json(const Model& model, const Result& result) {
  Json list = Json::array();
  const std::size_t n = model.links.name.size();
  for (std::size_t k = 0; k < n; ++k) {
    LinkRow largest, last;
    double at = 0;
    for (std::size_t row = 0; row * n + k < result.strengthening.links.size(); ++row) {
      last = result.strengthening.links[row * n + k];
      if (std::fabs(last.force) <= std::fabs(largest.force)) continue;
      largest = last;
      at = result.curve[row].displacement;
    }
    list.push_back({{"name", model.links.name[k]},
                    {"kind", word_of(kLinkKindWords, model.links.kind[k])},
                    {"stiffness_kN_per_mm", 1e-6 * model.links.stiffness[k]},
                    {"largest_force_kN", 1e-3 * largest.force},
                    {"displacement_mm", 1e3 * at},
                    {"yields", last.plastic != 0},
                    {"plastic_mm", 1e3 * last.plastic}});
  }
  return list;
}

// For each frame: the largest use with time and place, and the first yielding.
Json frames_json(const Model& model, const Result& result) {
  Json list = Json::array();
  for (std::size_t k = 0; k < result.strengthening.frame_uses.size(); ++k) {
    const FrameUse& use = result.strengthening.frame_uses[k];
    Json& json = list.emplace_back();
    json["name"] = model.frames.name[k];
    json["use"] = use.use;
    json["displacement_mm"] = 1e3 * use.displacement;
    io::put(json, "where", use.where);
    json["yields"] = !std::isnan(use.yields_at);
    if (std::isnan(use.yields_at)) continue;
    json["yields_at_mm"] = 1e3 * use.yields_at;
    io::put(json, "yields_where", use.yields_where);
  }
  return list;
}

// For each layer: the largest use with its place, when fibres broke, and the detached and broken parts at the end.
Json layers_json(const Model& model, const Result& result) {
  Json list = Json::array();
  for (std::size_t k = 0; k < result.strengthening.layer_uses.size(); ++k) {
    const LayerUse& use = result.strengthening.layer_uses[k];
    Json& json = list.emplace_back();
    json["name"] = model.layers.name[k];
    json["use"] = use.use;
    json["displacement_mm"] = 1e3 * use.displacement;
    io::put(json, "where", use.where);
    json["detached_percent"] = 100 * use.detached;
    json["broken_percent"] = 100 * use.broken;
    json["breaks"] = !std::isnan(use.breaks_at);
    if (!std::isnan(use.breaks_at)) json["breaks_at_mm"] = 1e3 * use.breaks_at;
  }
  return list;
}

Json stages_json(const std::vector<StageReport>& stages) {
  return io::list_of(stages, [&](const StageReport& stage) -> Json {
    return {{"name", stage.name},
            {"time_s", stage.time},
            {"steps", stage.steps},
            {"unbalance_ratio", stage.unbalance_ratio},
            {"settled", stage.settled}};
  });
}

Json provenance_json(std::uint64_t spec_hash) {
  const Provenance made = provenance();
  return {{"version", made.version},       {"commit", made.commit},
          {"compiler", made.compiler},     {"flags", made.flags},
          {"build_type", made.build_type}, {"spec_hash", fmt::format("{:016x}", spec_hash)}};
}

Json falls_json(const std::vector<FallTo>& falls) {
  return io::list_of(falls, [&](const FallTo& fall) -> Json {
    return {{"fraction", fall.fraction},         {"displacement_mm", fall.displacement * 1e3},
            {"drift_percent", fall.drift * 1e2}, {"censored", fall.censored},
            {"first_mm", fall.first * 1e3},      {"last_mm", fall.last * 1e3}};
  });
}

// d(r): arrays of equal length, by the remaining share of the peak; for a push, or for one of its directions.
template <class Readings>
Json drift_capacity_json(const Readings& r) {
  const auto column = [&](double FallTo::*value, double to_unit) {
    return io::column_of(r.drift_capacity, value, to_unit);
  };
  Json json = {{"left", column(&FallTo::fraction, 1)},
               {"first_mm", column(&FallTo::first, 1e3)},
               {"lasting_mm", column(&FallTo::displacement, 1e3)},
               {"last_mm", column(&FallTo::last, 1e3)},
               {"lasting_drift_percent", column(&FallTo::drift, 1e2)},
               {"censored_first", io::list_of(r.drift_capacity, &FallTo::censored_first)},
               {"censored_last", io::list_of(r.drift_capacity, &FallTo::censored_last)},
               {"censored", io::list_of(r.drift_capacity, &FallTo::censored)}};
  json["lasts_percent"] = kLastingShare * 1e2;
  const std::optional<bool> decides = threshold_decides(r.drift_capacity);
  json["threshold_decides"] = decides ? Json(*decides) : Json(nullptr);
  json["dips"] = io::list_of(r.dips, [](const Dip& dip) -> Json {
    return {{"left", dip.fraction},
            {"from_mm", dip.from * 1e3},
            {"back_mm", dip.back * 1e3},
            {"lowest_left", dip.lowest},
            {"before_peak", dip.before_peak}};
  });
  return json;
}

void add_responses(Json& json, const Responses& r) {
  each_response(Answers{json}, r);
  json["censored"] = r.censored_80;
  json["falls"] = falls_json(r.falls);
  json["drift_capacity"] = drift_capacity_json(r);
}

Json direction_json(const DirectionReadings& d) {
  Json json;
  each_direction_reading([&](auto, const std::string& name, const char* unit,
                             auto value) { json[name + unit] = value; },
                         d);
  json["drift_capacity"] = drift_capacity_json(d);
  json["bilinear"] = io::bilinear_json(d.bilinear);
  json["envelope"] = {
      {"displacement_mm", io::column_of(d.backbone, &BackbonePoint::displacement, 1e3)},
      {"reaction_kN", io::column_of(d.backbone, &BackbonePoint::reaction, 1e-3)}};
  return json;
}

Json cycles_json(const std::vector<Cycle>& cycles) {
  return io::list_of(cycles, [&](const Cycle& c) -> Json {
    return {{"kind", c.kind},
            {"displacement_max_mm", c.displacement_max * 1e3},
            {"displacement_min_mm", c.displacement_min * 1e3},
            {"reaction_max_kN", c.reaction_max * 1e-3},
            {"reaction_min_kN", c.reaction_min * 1e-3},
            {"in_balance", c.in_balance},
            {"residual_max_mm", c.residual_max * 1e3},
            {"residual_min_mm", c.residual_min * 1e3},
            {"stiffness_kN_per_mm", c.stiffness * 1e-6},
            {"dissipated_J", c.dissipated},
            {"drag_J", c.drag},
            {"damping_ratio", c.damping_ratio},
            {"repeat", c.repeat},
            {"strength_kept", c.kept}};
  });
}

Json cyclic_json(const CyclicReadings& c) {
  return {{"read_in", c.sense > 0 ? "positive" : "negative"},
          {"positive", direction_json(c.positive)},
          {"negative", direction_json(c.negative)},
          {"cycles", cycles_json(c.cycles)},
          {"work_J", c.work}};
}

Json tested_range_json(const TestedRange& range) {
  Json json = {{"kind", range.kind},
               {"walls", range.walls},
               {"bias", range.bias},
               {"bias_interval", {range.bias_low, range.bias_high}},
               {"scatter", range.scatter}};
  io::put(json, "note", note_of(range));
  const TestedDrift& d = range.drift;
  json["drift"] = {{"masonry", d.stone ? "stone" : "brick"},
                   {"walls", d.walls},
                   {"median_percent", 1e2 * d.median},
                   {"nine_of_ten_percent", {1e2 * d.low, 1e2 * d.high}},
                   {"own_walls", d.own_walls},
                   {"own_ratio", d.own_ratio},
                   {"own_factor", d.own_factor}};
  io::put(json["drift"], "note", drift_note_of(range));
  return json;
}

Json vector_json(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Json shaking_json(const Model& model, const Result& result) {
  const ShakeReadings& r = result.shaking;
  Json records = Json::array(), points = Json::array();
  for (const AppliedRecord& a : r.record)
    records.push_back({{"record", a.source},
                       {"hash", a.hash},
                       {"along", vector_json(a.along)},
                       {"of", a.of_base ? "base" : "driven, against the base"},
                       {"factor", a.factor},
                       {"pga_g", a.peak_acceleration / 9.80665},
                       {"pgv_mm_per_s", 1e3 * a.peak_velocity},
                       {"arias_m_per_s", a.arias},
                       {"duration_s", a.duration},
                       {"final_velocity_mm_per_s", 1e3 * a.final_velocity},
                       {"final_displacement_mm", 1e3 * a.final_displacement}});
  for (std::size_t k = 0; k < r.motion.size(); ++k)
    points.push_back({{"name", r.motion[k].point},
                      {"height_m", model.watched[k].height},
                      {"peak_displacement_mm", 1e3 * r.motion[k].peak},
                      {"peak_at_s", r.motion[k].at},
                      {"residual_displacement_mm", 1e3 * r.motion[k].residual}});
  Json storeys = Json::array();
  for (std::size_t k = 0; k < r.storey.size(); ++k)
    storeys.push_back({{"name", r.storey[k].storey},
                       {"height_m", result.history.storey_height[k]},
                       {"peak_drift_percent", 1e2 * r.storey[k].peak},
                       {"peak_at_s", r.storey[k].at},
                       {"residual_drift_percent", 1e2 * r.storey[k].residual}});
  Json damping = Json::array();
  for (const Stage& stage : model.stages) {
    const auto* shake = std::get_if<ShakeStage>(&stage.spec.action);
    if (shake == nullptr) continue;
    damping.push_back({{"stage", stage.spec.name}, {"local", stage.spec.damping}});
    Json& json = damping.back();
    for (const auto& [name, viscous] : {std::pair("mass", shake->mass_damping),
                                        {"joints", shake->joint_damping},
                                        {"maxwell", shake->maxwell_damping}})
      if (std::isfinite(viscous.fraction))
        json[name] = {{"fraction", viscous.fraction}, {"frequency_Hz", viscous.frequency}};
    if (std::isfinite(shake->restitution)) json["restitution"] = shake->restitution;
  }
  return {{"collapsed", r.collapsed},
          {"collapse_time_s", r.collapsed ? Json(r.collapse_time) : Json()},
          {"peak_drift_percent", 1e2 * r.peak_drift},
          {"residual_drift_percent", 1e2 * r.residual_drift},
          {"peak_base_shear_kN", 1e-3 * r.peak_base_shear},
          {"largest_opening_mm", 1e3 * r.largest_opening},
          {"largest_slip_mm", 1e3 * r.largest_slip},
          {"points", points},
          {"storeys", storeys},
          {"records", records},
          {"damping", damping}};
}

// The largest rotation of any block at the end of the run [rad].
double lean_of(const Model& model, const Result& result) {
  if (result.states.snapshots.empty()) return 0;
  double most = 0;
  for (BlockId b = 0; b < model.n_block; ++b)
    most = std::max(most,
                    length(read_block(model, result.states.snapshots.back().state, b).turned.by));
  return most;
}
}  // namespace

// Uses the largest record of the base; a second motion is described with the records.
Message shaken_sentence(const Model& model, const Result& result) {
  const ShakeReadings& r = result.shaking;
  if (!r.was_shaken || r.motion.empty()) return {};
  double peak = 0;
  for (const AppliedRecord& a : r.record) peak = std::max(peak, a.peak_acceleration);
  if (r.collapsed)
    return {"shaken.collapsed", {{"pga_g", peak / 9.80665}, {"time_s", r.collapse_time}}};
  const bool whole = result.status == SolveStatus::kCompleted;
  if (whole && result.debris.blocks > 0)
    return {"shaken.shed",
            {{"pga_g", peak / 9.80665}, {"blocks", static_cast<double>(result.debris.blocks)}}};
  Message said{whole ? "shaken.stands" : "shaken.cut",
               {{"pga_g", peak / 9.80665},
                {"point", r.motion.front().point},
                {"peak_mm", 1e3 * r.motion.front().peak},
                {"drift_percent", 1e2 * r.peak_drift},
                {"residual_mm", 1e3 * r.motion.front().residual},
                {"shear_kN", 1e-3 * r.peak_base_shear}}};
  constexpr double kSeen =
      M_PI /
      180;  // a visible tilt: such a wall has not fallen, but it does not stand as it did before
  if (const double lean = lean_of(model, result); whole && lean > kSeen) {
    said.code = "shaken.leans";
    said.arguments.emplace_back("degrees", lean * 180 / M_PI);
  }
  if (whole && dynamics::is_still_moving(model, result))
    return {"shaken.still_moving", {{"what", std::move(said)}}};
  if (result.validity.holds()) return said;
  return {"shaken.slid_off", {{"what", std::move(said)}, {"joints", result.validity.joints}}};
}

std::string summary_json(const Model& model, const Result& result) {
  return summary_json({}, model, result);
}

std::string summary_json(const ModelSpec& spec, const Model& model, const Result& result) {
  Json json;
  json["status"] = to_string(result.status);
  io::put(json, "reason", result.reason);
  io::put(json, "warning", warning_of(model, result));
  io::add_project(json, spec.project);
  add_responses(json, result.responses);
  io::put(json, "initial_stiffness_reason", why_no_stiffness(result.responses));
  const FlatPeak flat = flat_peak(result);
  json["flat_peak"] = {{"share", kFlatPeak},
                       {"from_mm", 1e3 * flat.from},
                       {"to_mm", 1e3 * flat.to},
                       {"is_bound", flat.is_bound},
                       {"says_little", flat.says_little(result.responses.displacement_at_peak)}};
  if (is_asked(spec.assessment))
    json["assessment"] = io::assessment_json(assess_run(spec, model, result));
  if (result.responses.cyclic.sense != 0) json["cyclic"] = cyclic_json(result.responses.cyclic);
  if (result.shaking.was_shaken) {
    json["shaking"] = shaking_json(model, result);
    io::put(json["shaking"], "sentence", shaken_sentence(model, result));
  }
  json["curve_of"] = word_of(kStageKindWords, result.curve_of);
  json["load_factor"] = result.load_factor;
  if (result.curve_of == StageKind::kTilt)
    json["tilt_degrees"] = std::atan(result.load_factor) * 180 / M_PI;
  json["top_displacement_mm"] = result.top_displacement * 1e3;
  json["failure_mode"] = failure_mode_json(model, result);
  json["tested_range"] = tested_range_json(compare_with_tests(model, result));
  json["features"] = features_json(result.features);
  json["energy_J"] = energy_json(result.energy);
  if (model.free.any()) {
    json["energy_J"]["hand_over"] = result.energy.hand_over;
    json["debris"] = {{"blocks", result.debris.blocks},
                      {"volume_m3", result.debris.volume},
                      {"mass_kg", result.debris.mass},
                      {"reach_m", result.debris.reach},
                      {"load_off_kN", result.debris.load * 1e-3}};
  }
  each_quasi_static(Answers{json}, result.quasi_static);
  json["quasi_static"]["displacement"] = slow_push_json(displacement_of_slow_push(model, result));
  json["quasi_static"]["mode"] = slow_push_json(mode_of_slow_push(model, result));
  json["validity"] = {{"overlap_lost_at_mm", result.validity.overlap_lost * 1e3},
                      {"joints", result.validity.joints}};
  io::put(json["validity"], "where", result.validity.where);
  json["events"] = events_json(result.events);
  json["stages"] = stages_json(result.stages);
  if (model.links.n > 0) json["links"] = links_json(model, result);
  if (model.frames.n > 0) json["frames"] = frames_json(model, result);
  if (model.layers.n > 0) json["layers"] = layers_json(model, result);
  json["blocks"] = model.n_block;
  json["joints"] = model.n_joint;
  json["points"] = model.n_point();
  const SpaceSolids& in_space = model.space.solids;
  if (model.solids.n_zone + in_space.n_zone > 0) {
    json["zones"] = model.solids.n_zone + in_space.n_zone;
    json["zone_nodes"] = model.solids.n_node + in_space.n_node;
    json["zone_contacts"] = model.solids.n_contact + in_space.n_contact;
  }
  json["steps"] = result.steps;
  json["time_step_s"] = result.time_step;
  json["wall_seconds"] = result.wall_seconds;
  json["state_hash"] = result.state_hash;
  json["provenance"] = provenance_json(model.spec_hash);
  // "replace", so that a name that is not UTF-8 does not lose the run
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wythe
