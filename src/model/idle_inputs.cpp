// Inputs without effect; each function detects one kind of them.
#include "model/idle_inputs.h"
#include "model/protocol.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "core/text.h"

namespace wythe {
namespace {

// Notes laws that no joint has, such as that of a misspelt "foundation".
void note_idle_laws(const ModelSpec& spec, Model& model) {
  std::vector<std::string> idle;
  for (const auto& [name, law] : spec.material) {
    const bool is_law = std::isfinite(law.normal_stiffness);
    const auto& used = model.material_names;
    if (is_law && std::find(used.begin(), used.end(), name) == used.end())
      idle.push_back("[material." + name + "]");
  }
  if (!idle.empty())
    model.anatomy.notes.push_back({"material.idle", {{"materials", joined(idle, ", ")}}});
}

// Materials of blocks, lintels, arches, sills, ring beams and mortars of layers.
std::set<std::string> materials_of_blocks(const ModelSpec& spec) {
  std::set<std::string> names = {"masonry"};
  for (const auto& block : spec.block) names.insert(block.material);
  for (const auto& body : spec.body) names.insert(body.material);
  for (const ContactRule& rule : spec.contact)
    names.insert(rule.between.begin(), rule.between.end());
  for (const OpeningSpec& opening : spec.wall.opening)
    names.insert({opening.lintel.material, opening.arch.material, opening.sill.material});
  for (const RingBeamSpec& beam : spec.ring_beam) names.insert(beam.material);
  for (const LayerSpec& layer : spec.layer) names.insert(layer.mortar.joint);
  return names;
}

// Notes density and moduli of a material that no block has.
void note_idle_bodies(const ModelSpec& spec, Model& model) {
  const std::set<std::string> used = materials_of_blocks(spec);
  std::vector<std::string> idle;
  for (const auto& [name, material] : spec.material)
    if (!std::isfinite(material.normal_stiffness) && !used.contains(name))
      idle.push_back("[material." + name + "]");
  if (!idle.empty())
    model.anatomy.notes.push_back({"material.of_nothing", {{"materials", joined(idle, ", ")}}});
}

// Notes a typology, or values of masonry, where no material requests a rule.
void note_idle_masonry(const ModelSpec& spec, Model& model) {
  const MasonrySpec& m = spec.masonry;
  const bool is_stated = !m.origin.empty() || m.unit_type != UnitType::kUnstated ||
                         std::isfinite(m.unit_strength) || std::isfinite(m.mortar_strength) ||
                         std::isfinite(m.masonry_strength) || std::isfinite(m.youngs_modulus) ||
                         std::isfinite(m.initial_shear_strength);
  const auto has_rule = [](const auto& material) { return !material.second.origin.empty(); };
  if (is_stated && std::none_of(spec.material.begin(), spec.material.end(), has_rule))
    model.anatomy.notes.push_back({"masonry.idle"});
}

// Notes the width of a unit, the length of a header, in a bond of stretchers only.
void note_idle_width(const ModelSpec& spec, Model& model) {
  if (!spec.block.empty() || !spec.body.empty()) return;  // blocks files: noted elsewhere
  const auto has_headers = [&](const std::string& bond) {
    const Bond of_wall = spec.wall.bond;
    return bond.empty() ? of_wall != Bond::kRunning && of_wall != Bond::kStack
                        : bond != "running" && bond != "stack";
  };
  bool is_any_header = spec.storey.empty() && has_headers("");
  const auto note = [&](const std::string& key) {
    model.anatomy.notes.push_back({"unit.width_idle", {{"key", key}}});
  };
  for (const StoreySpec& storey : spec.storey) {
    const bool headers = has_headers(storey.bond);
    is_any_header = is_any_header || headers;
    if (std::isfinite(storey.unit.width) && !headers) note("storey." + storey.name + ".unit.width");
  }
  if (std::isfinite(spec.wall.unit.width) && !is_any_header) note("wall.unit.width");
}

// Notes the form of damping in the plane, where a force is damped by its components.
void note_idle_damping_form(const ModelSpec& spec, Model& model) {
  if (spec.body.empty() && spec.solve.damping_form != SolveSpec{}.damping_form)
    model.anatomy.notes.push_back({"solve.damping_form_idle"});
}

// Notes an end beside targets, which define the end of a push: --set may add targets to a model with an end.
void note_idle_ends(const ModelSpec& spec, Model& model) {
  for (const StageSpec& stage : spec.stage)
    if (const auto* push = std::get_if<PushStage>(&stage.action);
        push && std::isfinite(push->until) && goes_to_and_fro(*push))
      model.anatomy.notes.push_back(
          {"push.until_idle", {{"stage", stage.name}, {"until_mm", 1e3 * push->until}}});
}

// Notes states that no push reaches.
void note_states_beyond(const ModelSpec& spec, Model& model) {
  double least = 0, most = 0;
  for (const StageSpec& stage : spec.stage) {
    const auto* push = std::get_if<PushStage>(&stage.action);
    if (push == nullptr) continue;
    for (const double end : push->targets) least = std::min(least, end), most = std::max(most, end);
    const bool one_way = push->targets.empty() && push->amplitudes.empty();
    if (one_way && std::isfinite(push->until)) most = std::max(most, push->until);
    for (const double a : push->amplitudes) least = std::min(least, -a), most = std::max(most, a);
    if (!push->drifts.empty()) return;  // its height is found later
  }
  if (!(most > 0)) return;
  for (const double at : spec.output.states)
    if (at > most * (1 + 1e-9) || at < least * (1 + 1e-9))
      model.anatomy.notes.push_back(
          {"output.state_beyond",
           {{"at_mm", 1e3 * at}, {"least_mm", 1e3 * least}, {"most_mm", 1e3 * most}}});
}

}  // namespace

void note_idle_inputs(const ModelSpec& spec, Model& model) {
  note_idle_laws(spec, model);
  note_idle_bodies(spec, model);
  note_idle_masonry(spec, model);
  note_idle_width(spec, model);
  note_idle_damping_form(spec, model);
  note_states_beyond(spec, model);
  note_idle_ends(spec, model);
}

}  // namespace wythe
