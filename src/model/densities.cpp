// Notes values that are probably errors of unit: sizes, laws, moduli, densities, scatters, long pushes.
// A note refuses nothing and changes no model. The ranges [SI] are those of masonry, and of steel, timber and fibres that
// hold it. More notes name blocks with the unit's density and shakes with local damping. Others name values that a rule or a
// knowledge level leaves unchanged because another value is stated.
#include "model/densities.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "core/text.h"
#include "materials/origin.h"
#include "materials/rules.h"
#include "wythe/parts/text.h"

namespace wythe {
namespace {

// Materials of blocks without a density in any table and without a contact rule, such as the name of a layer.
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

// Notes millimetres read as metres, or the reverse, in blocks files and wrong lengths: the tallest masonry has
// 170 m, the longest walls of a building a few hundred.
void note_scale(const ModelSpec& spec, Model& model) {
  constexpr double kTallest = 200, kLongestWall = 1000, kLowest = 0.03;  // [m]
  const Anatomy& a = model.anatomy;
  const double longest = std::max(a.length, a.height);
  const bool is_high = a.height > kTallest, is_long = a.length > kLongestWall;
  const char* code = is_high && is_long                 ? "scale.large"
                     : is_high                          ? "scale.high"
                     : is_long                          ? "scale.long"
                     : longest > 0 && longest < kLowest ? "scale.small"
                                                        : nullptr;
  if (code == nullptr) return;
  const std::string ending =
      small_letters(std::filesystem::path(spec.wall.blocks).extension().string());
  Message cure{"scale.as_mm", {{"number", is_high ? a.height : a.length}}};
  if (ending == ".dxf") cure = {"scale.as_mm_in_drawing", {{"file", spec.wall.blocks}}};
  if (ending == ".obj" || ending == ".stl" || ending == ".ply")
    cure = {"scale.as_mm_of_mesh", {{"file", spec.wall.blocks}}};
  model.anatomy.notes.push_back({code,
                                 {{"length_m", a.length},
                                  {"height_m", a.height},
                                  {"height_mm", 1e3 * a.height},
                                  {"cure", std::move(cure)}}});
}

// Notes a value that its key admits but that differs from masonry by a factor of a thousand: probably a wrong unit.
class OddValues {
 public:
  explicit OddValues(std::vector<Message>& notes) : notes_(notes) {}

  // Tests one value. `shown`: unit of the note; `factor`: its SI value.
  void look(const std::string& path, double value, double least, double most, const char* shown,
            double factor) {
    if (!std::isfinite(value) || value == 0 || (value >= least && value <= most)) return;
    notes_.push_back({"value.odd",
                      {{"key", path},
                       {"value", value / factor},
                       {"unit", shown},
                       {"least", least / factor},
                       {"most", most / factor}}});
  }
  void of_law(const std::string& path, const JointMaterial& m) {
    constexpr double kDegree = 3.14159265358979323846 / 180;
    look(path + "normal_stiffness", m.normal_stiffness, 1e7, 1e14, "GPa/m", 1e9);
    look(path + "shear_stiffness", m.shear_stiffness, 1e6, 1e14, "GPa/m", 1e9);
    // of mortar joints; 5 MPa is the strength of a mortar, not of its bond
    const bool is_bed = path == "material.joint." || path == "material.foundation.";
    stress(path + "tensile_strength", m.tensile_strength, 1e3, is_bed ? 3e6 : 50e6);
    stress(path + "cohesion", m.cohesion, 1e3, is_bed ? 4e6 : 100e6);
    stress(path + "residual_cohesion", m.residual_cohesion, 100, 100e6);
    stress(path + "compressive_strength", m.compressive_strength, 1e4, 1e9);
    stress(path + "dilatancy_pressure", m.dilatancy_pressure, 1e3, 1e9);
    look(path + "friction_angle", m.friction_angle, 3 * kDegree, 80 * kDegree, "deg", kDegree);
    look(path + "mode_1_energy", m.mode_1_energy, 0.01, 3000, "N/m", 1);
    look(path + "mode_2_energy", m.mode_2_energy, 0.01, 30000, "N/m", 1);
    look(path + "compressive_energy", m.compressive_energy, 30, 3e6, "N/m", 1);
    modulus(path + "youngs_modulus", m.youngs_modulus, kSoftest);
    modulus(path + "shear_modulus", m.shear_modulus, kSoftest / 3);
  }
  void of_masonry(const MasonrySpec& m) {
    stress("masonry.unit_strength", m.unit_strength, 1e5, 1e9);
    stress("masonry.mortar_strength", m.mortar_strength, 1e4, 1e9);
    stress("masonry.masonry_strength", m.masonry_strength, 1e4, 1e9);
    stress("masonry.vertical_stress", m.vertical_stress, 1e3, 1e8);
    stress("masonry.initial_shear_strength", m.initial_shear_strength, 1e3, 1e8);
    stress("masonry.diagonal_shear_strength", m.diagonal_shear_strength, 1e3, 1e8);
    modulus("masonry.youngs_modulus", m.youngs_modulus, kSoftest);
    modulus("masonry.shear_modulus", m.shear_modulus, kSoftest / 3);
    modulus("masonry.unit_youngs_modulus", m.unit_youngs_modulus, kSoftest);
    modulus("masonry.mortar_youngs_modulus", m.mortar_youngs_modulus, kSoftest);
    look("masonry.weight", m.weight, 3e3, 5e4, "kN/m^3", 1e3);
  }
  // Checks steel, timber and fibres that hold a wall.
  void of_ties(const ModelSpec& spec) {
    for (const TieSpec& tie : spec.tie) {
      modulus("tie." + tie.name + ".youngs_modulus", tie.youngs_modulus, 1e8);
      stress("tie." + tie.name + ".yield_strength", tie.yield_strength, 1e6, 1e10);
      stress("tie." + tie.name + ".prestress", tie.prestress, 1e4, 1e10);
    }
    for (const FrameSpec& frame : spec.frame) {
      modulus("frame." + frame.name + ".youngs_modulus", frame.youngs_modulus, 1e8);
      modulus("frame." + frame.name + ".shear_modulus", frame.shear_modulus, 1e8);
      stress("frame." + frame.name + ".yield_strength", frame.yield_strength, 1e6, 1e10);
    }
  }

 private:
  // Young's modulus of the softest adobe; concrete of 30 GPa stated in MPa is no stiffer [Pa].
  static constexpr double kSoftest = 30e6;

  void stress(const std::string& path, double value, double least, double most) {
    look(path, value, least, most, "MPa", 1e6);
  }
  void modulus(const std::string& path, double value, double least) {
    look(path, value, least, 2e12, "GPa", 1e9);
  }
  std::vector<Message>& notes_;
};

void note_odd_values(const ModelSpec& spec, std::vector<Message>& notes) {
  OddValues odd(notes);
  odd.look("wall.thickness", spec.wall.thickness, 0.01, 10, "m", 1);
  odd.look("solve.gravity", spec.solve.gravity, 1, 30, "m/s^2", 1);
  for (const auto& [name, law] : spec.material) odd.of_law("material." + name + ".", law);
  odd.of_masonry(spec.masonry);
  odd.of_ties(spec);
  for (const FloorSpec& floor : spec.floor)
    odd.look("floor." + floor.name + ".load", floor.load, 30, 3e6, "kN/m", 1e3);
  for (const StageSpec& stage : spec.stage) {
    if (const auto* push = std::get_if<PushStage>(&stage.action))
      odd.look("stage." + stage.name + ".velocity", push->velocity, 1e-9, 1, "m/s", 1);
    if (const auto* load = std::get_if<LoadStage>(&stage.action))
      odd.look("stage." + stage.name + ".pressure", load->pressure, 100, 1e8, "MPa", 1e6);
  }
}

void note_odd_densities(const ModelSpec& spec, std::vector<Message>& notes) {
  // Aerated concrete has 400 kg/m3, granite 3000; wood at least 350, steel 7850.
  constexpr double kLeast = 300, kMost = 5000, kMostOfMetals = 8000;
  const auto look = [&](const std::string& path, double density, double most) {
    if (std::isfinite(density) && density > 0 && (density < kLeast || density > most))
      notes.push_back({"density.odd", {{"key", path}, {"density_kg_per_m3", density}}});
  };
  look("wall.unit.density", spec.wall.unit.density, kMost);
  for (const StoreySpec& storey : spec.storey)
    look("storey." + storey.name + ".unit.density", storey.unit.density, kMost);
  for (const auto& [name, material] : spec.material)
    look("material." + name + ".density", material.density, kMostOfMetals);
}

// Notes 20 in place of 20 %: no value of a wall scatters as much as its own mean.
void note_odd_scatter(const ModelSpec& spec, std::vector<Message>& notes) {
  const auto look = [&](const std::string& path, double cov) {
    if (is_scatter_odd(cov)) notes.push_back(note_of_scatter(path, cov));
  };
  for (const auto& [name, field] : spec.field) look("field." + name + ".cov", field.cov);
  look("scatter.joint_tension", spec.scatter.joint_tension);
  look("scatter.joint_cohesion", spec.scatter.joint_cohesion);
  look("scatter.unit_tension", spec.scatter.unit_tension);
}

// Notes a slope b of GII that `missing` requests but that a stated GII excludes; its origin says so.
void note_slopes_left_out(const ModelSpec& spec, std::vector<Message>& notes) {
  constexpr const char* kSlope = "mode_2_energy_per_pressure";
  const materials::Rule* rule = materials::rule_for(materials::Role::kJoint, kSlope);
  const auto whence = [](const std::string& words) -> Message {
    if (words.starts_with(materials::kTypicalOf))
      return {"rule.typical", {{"entry", words.substr(materials::kTypicalOf.size())}}};
    if (words.starts_with(materials::kBy))
      return {"rule.other", {{"rule", words.substr(materials::kBy.size())}}};
    return {"rule.stated"};
  };
  for (const auto& [name, material] : spec.material)
    for (const std::string& line : material.origin) {
      const auto origin = materials::origin_of(line);
      if (!origin || origin->key != kSlope || !origin->by.starts_with(materials::kAsEnergyIs))
        continue;
      notes.push_back({"rule.slope_left_out",
                       {{"key", "material." + name + ".mode_2_energy"},
                        {"how", whence(origin->by.substr(materials::kAsEnergyIs.size()))},
                        {"b_mm", 1e3 * rule->value({})}}});
    }
}

// Notes values stated beside a knowledge level, which only corrects values from the table.
void note_undivided(const ModelSpec& spec, std::vector<Message>& notes) {
  for (const std::string& line : spec.masonry.origin) {
    const auto origin = materials::origin_of(line);
    if (!origin || !origin->by.starts_with(materials::kBesideLevel)) continue;
    const std::string words = origin->by.substr(materials::kBesideLevel.size());
    const std::size_t end = std::min(words.find(materials::kNot), words.size());
    notes.push_back(
        {"office.undivided",
         {{"key", "masonry." + origin->key},
          {"level", words.substr(0, end)},
          {"way", words.substr(std::min(end + materials::kNot.size(), words.size()))}}});
  }
}

// Notes local damping in a shake: it resists every motion, even a fall.
void note_shake_damping(const ModelSpec& spec, Model& model) {
  for (const StageSpec& stage : spec.stage)
    if (stage.kind() == StageKind::kShake && stage.damping > 0)
      model.anatomy.notes.push_back(
          {"shake.local_damping", {{"stage", stage.name}, {"damping", stage.damping}}});
}

// Notes metres in place of millimetres: no wall is pushed farther than its own size.
void note_far_pushes(Model& model) {
  const double size = std::max(model.anatomy.length, model.anatomy.height);
  for (const Stage& stage : model.stages) {
    const PushStage* push = stage.push();
    if (push == nullptr) continue;
    double farthest = 0;
    for (const double target : stage.targets()) farthest = std::max(farthest, std::fabs(target));
    if (std::isfinite(push->until)) farthest = std::max(farthest, std::fabs(push->until));
    if (size > 0 && farthest > size)
      model.anatomy.notes.push_back(
          {"scale.push", {{"stage", stage.spec.name}, {"push_m", farthest}}});
  }
}

}  // namespace

bool is_scatter_odd(double cov) { return cov >= 1; }

Message note_of_scatter(const std::string& key, double cov) {
  return {"scatter.odd",
          {{"key", key}, {"cov", cov}, {"cov_percent", 100 * cov}, {"share", cov / 100}}};
}

std::vector<Message> notes_of_values(const ModelSpec& spec) {
  std::vector<Message> notes;
  note_odd_densities(spec, notes);
  note_odd_values(spec, notes);
  note_odd_scatter(spec, notes);
  note_slopes_left_out(spec, notes);
  note_undivided(spec, notes);
  return notes;
}

void note_densities(const ModelSpec& spec, Model& model) {
  for (Message& note : notes_of_values(spec)) model.anatomy.notes.push_back(std::move(note));
  note_scale(spec, model);
  note_far_pushes(model);
  note_shake_damping(spec, model);
  if (const std::vector<std::string> names = unmatched(spec); !names.empty())
    model.anatomy.notes.push_back(
        {"density.of_unit",
         {{"materials", joined(names, ", ")}, {"density_kg_per_m3", spec.wall.unit.density}}});
}

}  // namespace wythe
