#include "io/summary_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "wythe/provenance.h"

namespace wythe::io {
namespace {

using Json = nlohmann::ordered_json;

Json energy_json(const EnergyLedger& energy) {
  return {{"loads", energy.loads},       {"drive", energy.drive},
          {"kinetic", energy.kinetic},   {"elastic", energy.elastic},
          {"friction", energy.friction}, {"fracture", energy.fracture},
          {"crushing", energy.crushing}, {"damping", energy.damping},
          {"gap", energy.gap},           {"gap_ratio", energy.gap_ratio}};
}

Json quasi_static_json(const QuasiStatic& meter) {
  return {{"verdict", meter.verdict},
          {"unbalance_ratio_mean", meter.unbalance_ratio_mean},
          {"unbalance_ratio_max", meter.unbalance_ratio_max},
          {"kinetic_ratio_mean", meter.kinetic_ratio_mean},
          {"kinetic_ratio_max", meter.kinetic_ratio_max},
          {"shear_gap", meter.shear_gap},
          {"damping_share", meter.damping_share}};
}

Json failure_mode_json(const FailureMode& mode) {
  Json evidence = Json::array();
  for (const Evidence& e : mode.evidence) {
    evidence.push_back({{"element", e.element},
                        {"measure", e.measure},
                        {"value", e.value},
                        {"threshold", e.threshold},
                        {"unit", e.unit}});
  }
  Json scores = Json::object();
  for (const auto& [name, score] : mode.scores) scores[name] = score;
  return {{"name", mode.name},
          {"sentence", mode.sentence},
          {"read_at_mm", mode.read_at * 1e3},
          {"scores", scores},
          {"evidence", evidence}};
}

Json events_json(const std::vector<Event>& events) {
  Json list = Json::array();
  for (const Event& event : events) {
    list.push_back({{"name", event.name},
                    {"displacement_mm", event.displacement * 1e3},
                    {"reaction_kN", event.reaction * 1e-3},
                    {"where", event.where}});
  }
  return list;
}

Json stages_json(const std::vector<StageReport>& stages) {
  Json list = Json::array();
  for (const StageReport& stage : stages) {
    list.push_back({{"name", stage.name},
                    {"time_s", stage.time},
                    {"steps", stage.steps},
                    {"unbalance_ratio", stage.unbalance_ratio},
                    {"settled", stage.settled}});
  }
  return list;
}

Json provenance_json(std::uint64_t spec_hash) {
  const Provenance made = provenance();
  return {{"version", made.version},       {"commit", made.commit},
          {"compiler", made.compiler},     {"flags", made.flags},
          {"build_type", made.build_type}, {"spec_hash", fmt::format("{:016x}", spec_hash)}};
}

void add_responses(Json& json, const Responses& r) {
  json["peak_reaction_kN"] = r.peak_reaction * 1e-3;
  json["displacement_at_peak_mm"] = r.displacement_at_peak * 1e3;
  json["displacement_at_80_percent_mm"] = r.displacement_at_80 * 1e3;
  json["censored"] = r.censored_80;
  json["censored_80"] = r.censored_80;
  json["displacement_max_mm"] = r.displacement_max * 1e3;
  json["censored_max"] = r.censored_max;
  json["initial_stiffness_kN_per_mm"] = r.initial_stiffness * 1e-6;
}

}  // namespace

std::string summary_json(const Model& model, const Result& result) {
  Json json;
  json["status"] = to_string(result.status);
  json["reason"] = result.reason;
  add_responses(json, result.responses);
  json["load_factor"] = result.load_factor;
  json["top_displacement_mm"] = result.top_displacement * 1e3;
  json["failure_mode"] = failure_mode_json(result.failure_mode);
  json["energy_J"] = energy_json(result.energy);
  json["quasi_static"] = quasi_static_json(result.quasi_static);
  json["events"] = events_json(result.events);
  json["stages"] = stages_json(result.stages);
  json["blocks"] = model.n_block;
  json["joints"] = model.n_joint;
  json["points"] = model.n_point();
  json["steps"] = result.steps;
  json["time_step_s"] = result.time_step;
  json["wall_seconds"] = result.wall_seconds;
  json["state_hash"] = result.state_hash;
  json["provenance"] = provenance_json(model.spec_hash);
  // replace: a name that is not UTF-8 must not lose the run
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wythe::io
