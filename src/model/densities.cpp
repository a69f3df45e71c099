#include "model/densities.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/text.h"

namespace wythe {
namespace {

// Names that blocks bear, that no table gives a density and no contact rule speaks of: a layer's name, say.
std::vector<std::string> unmatched(const ModelSpec& spec) {
  std::set<std::string> known = {"masonry"};
  for (const auto& [name, material] : spec.material)
    if (std::isfinite(material.density)) known.insert(name);
  for (const ContactRule& rule : spec.contact)
    known.insert(rule.between.begin(), rule.between.end());
  std::set<std::string> names;
  const auto look = [&](const auto& blocks) {
    for (const auto& block : blocks)
      if (!block.fixed && !block.material.empty() && !known.contains(block.material))
        names.insert(block.material);
  };
  look(spec.block);
  look(spec.body);
  return {names.begin(), names.end()};
}

// Millimetres read as metres, or the other way, where blocks come from a file or a length is a slip: the tallest masonry has
// 170 m, the longest walls of a building a few hundred.
void note_scale(Model& model) {
  constexpr double kTallest = 200, kLongest = 1000, kLowest = 0.03;  // [m]
  const Anatomy& a = model.anatomy;
  const double longest = std::max(a.length, a.height);
  const bool is_high = a.height > kTallest, is_long = a.length > kLongest;
  const char* code = is_high && is_long                 ? "scale.large"
                     : is_high                          ? "scale.high"
                     : is_long                          ? "scale.long"
                     : longest > 0 && longest < kLowest ? "scale.small"
                                                        : nullptr;
  if (code != nullptr)
    model.anatomy.notes.push_back(
        {code, {{"length_m", a.length}, {"height_m", a.height}, {"height_mm", 1e3 * a.height}}});
}

// A value in the range that its key admits, and a thousand times off what masonry has: a slip of the unit, most likely.
void note_odd_values(const ModelSpec& spec, Model& model) {
  const auto look = [&](const std::string& path, double value, double least, double most,
                        const char* unit, double factor) {
    if (!std::isfinite(value) || value == 0 || (value >= least && value <= most)) return;
    model.anatomy.notes.push_back({"value.odd",
                                   {{"key", path},
                                    {"value", value / factor},
                                    {"unit", unit},
                                    {"least", least / factor},
                                    {"most", most / factor}}});
  };
  look("wall.thickness", spec.wall.thickness, 0.01, 10, "m", 1);
  look("solve.gravity", spec.solve.gravity, 1, 30, "m/s^2", 1);
  constexpr double kDegree = 3.14159265358979323846 / 180;
  for (const auto& [name, m] : spec.material) {
    const std::string path = "material." + name + ".";
    look(path + "normal_stiffness", m.normal_stiffness, 1e7, 1e14, "GPa/m", 1e9);
    look(path + "shear_stiffness", m.shear_stiffness, 1e6, 1e14, "GPa/m", 1e9);
    look(path + "tensile_strength", m.tensile_strength, 100, 50e6, "MPa", 1e6);
    look(path + "cohesion", m.cohesion, 100, 100e6, "MPa", 1e6);
    look(path + "compressive_strength", m.compressive_strength, 1e4, 1e9, "MPa", 1e6);
    look(path + "friction_angle", m.friction_angle, 3 * kDegree, 80 * kDegree, "deg", kDegree);
    look(path + "mode_1_energy", m.mode_1_energy, 0.01, 3000, "N/m", 1);
    look(path + "mode_2_energy", m.mode_2_energy, 0.01, 30000, "N/m", 1);
  }
  for (const StageSpec& stage : spec.stage)
    look("stage." + stage.name + ".velocity", stage.velocity, 1e-9, 1, "m/s", 1);
}

// In a shake local damping brakes every motion, a fall too.
void note_shake_damping(const ModelSpec& spec, Model& model) {
  for (const StageSpec& stage : spec.stage)
    if (stage.kind == StageKind::kShake && stage.damping > 0)
      model.anatomy.notes.push_back(
          {"shake.local_damping", {{"stage", stage.name}, {"damping", stage.damping}}});
}

// Metres where millimetres were meant: no wall is pushed farther than its own size.
void note_far_pushes(Model& model) {
  const double size = std::max(model.anatomy.length, model.anatomy.height);
  for (const Stage& stage : model.stages) {
    if (stage.spec.kind != StageKind::kPush) continue;
    double farthest = 0;
    for (const double target : stage.spec.targets) farthest = std::max(farthest, std::fabs(target));
    if (std::isfinite(stage.spec.until)) farthest = std::max(farthest, std::fabs(stage.spec.until));
    if (size > 0 && farthest > size)
      model.anatomy.notes.push_back(
          {"scale.push", {{"stage", stage.spec.name}, {"push_m", farthest}}});
  }
}

}  // namespace

void note_densities(const ModelSpec& spec, Model& model) {
  // Aerated concrete has 400 kg/m3, granite 3000; wood 350 and more, steel 7850.
  constexpr double kLeast = 300, kMost = 5000, kMostOfMetals = 8000;
  const auto look = [&](const std::string& path, double density, double most) {
    if (std::isfinite(density) && density > 0 && (density < kLeast || density > most))
      model.anatomy.notes.push_back(
          {"density.odd", {{"key", path}, {"density_kg_per_m3", density}}});
  };
  look("wall.unit.density", spec.wall.unit.density, kMost);
  for (const StoreySpec& storey : spec.storey)
    look("storey." + storey.name + ".unit.density", storey.unit.density, kMost);
  for (const auto& [name, material] : spec.material)
    look("material." + name + ".density", material.density, kMostOfMetals);
  note_scale(model);
  note_far_pushes(model);
  note_odd_values(spec, model);
  note_shake_damping(spec, model);
  if (const std::vector<std::string> names = unmatched(spec); !names.empty())
    model.anatomy.notes.push_back(
        {"density.of_unit",
         {{"materials", joined(names, ", ")}, {"density_kg_per_m3", spec.wall.unit.density}}});
}

}  // namespace wythe
