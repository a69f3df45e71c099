// What went in: wall, openings, materials, stages, settings, each with its unit.
#include <fmt/format.h>

#include <cmath>

#include "report/html.h"
#include "report/sections.h"

namespace wythe::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string metres(double value) { return quantity(value, "m", 4); }
std::string millimetres(double value) { return quantity(value * 1e3, "mm", 4); }

// A row of the material table: SI value times factor is the value shown.
struct MaterialRow {
  const char* name;
  const char* unit;
  double factor;
  double JointMaterial::*value;
};

constexpr double kDegree = 57.29577951308232;  // per radian

constexpr MaterialRow kMaterialRows[] = {
    {"normal stiffness", "GPa/m", 1e-9, &JointMaterial::normal_stiffness},
    {"shear stiffness", "GPa/m", 1e-9, &JointMaterial::shear_stiffness},
    {"tensile strength", "MPa", 1e-6, &JointMaterial::tensile_strength},
    {"cohesion", "MPa", 1e-6, &JointMaterial::cohesion},
    {"friction angle", "°", kDegree, &JointMaterial::friction_angle},
    {"residual friction angle", "°", kDegree, &JointMaterial::residual_friction_angle},
    {"residual cohesion", "MPa", 1e-6, &JointMaterial::residual_cohesion},
    {"mode I energy", "N/m", 1, &JointMaterial::mode_1_energy},
    {"mode II energy", "N/m", 1, &JointMaterial::mode_2_energy},
    {"compressive strength", "MPa", 1e-6, &JointMaterial::compressive_strength},
    {"compressive energy", "N/m", 1, &JointMaterial::compressive_energy},
    {"density", "kg/m³", 1, &JointMaterial::density},
    {"Young's modulus", "GPa", 1e-9, &JointMaterial::youngs_modulus},
    {"shear modulus", "GPa", 1e-9, &JointMaterial::shear_modulus}};

// One column a material; rows that no material states are left out.
std::string material_table(const std::map<std::string, JointMaterial>& materials) {
  Rows rows = {{"", "in"}};
  for (const auto& [name, material] : materials) rows[0].push_back(escaped(name));
  for (const MaterialRow& row : kMaterialRows) {
    std::vector<std::string> cells = {row.name, row.unit};
    bool stated = false;
    for (const auto& [name, material] : materials) {
      cells.push_back(rounded(material.*row.value * row.factor, 4));
      stated = stated || !std::isnan(material.*row.value);
    }
    if (stated) rows.push_back(cells);
  }
  return table(rows);
}

std::string wall_table(const ModelSpec& spec, const Model& model) {
  const Anatomy& a = model.anatomy;
  Rows rows = {{"", ""}};
  rows.push_back({"wall", fmt::format("{} × {} × {} (length, height, thickness)", metres(a.length),
                                      metres(a.height), metres(a.thickness))});
  if (!spec.wall.blocks.empty()) rows.push_back({"blocks from", escaped(spec.wall.blocks)});
  if (a.courses > 0) {
    rows.push_back({"courses", fmt::format("{} of {}", a.courses, millimetres(a.course_height))});
    rows.push_back({"half unit", millimetres(a.half_unit)});
  }
  if (!std::isnan(spec.wall.unit.density))
    rows.push_back({"density of the units", quantity(spec.wall.unit.density, "kg/m³", 4)});
  rows.push_back({"weight of all blocks", quantity(model.weight * 1e-3, "kN", 4)});
  for (std::size_t i = 0; i < spec.wall.opening.size(); ++i) {
    const OpeningSpec& o = spec.wall.opening[i];
    std::string words = fmt::format("{} × {} at x = {}, y = {}", metres(o.width), metres(o.height),
                                    metres(o.x), metres(o.y));
    if (!o.lintel.kind.empty()) {
      words += fmt::format("; {} lintel {} deep, bearing {}", escaped(o.lintel.kind),
                           millimetres(o.lintel.depth), millimetres(o.lintel.bearing));
    }
    rows.push_back({o.name.empty() ? fmt::format("opening {}", i + 1) : escaped(o.name), words});
  }
  for (const std::string& note : a.notes) rows.push_back({"note", escaped(note)});
  return table(rows, "words bare");
}

const char* direction_word(Direction direction) {
  switch (direction) {
    case Direction::kPlusX: return "+x";
    case Direction::kMinusX: return "−x";
    case Direction::kPlusY: return "+y";
    case Direction::kMinusY: return "−y";
  }
  return "";
}

// What a stage does, in a clause.
std::string stage_words(const StageSpec& s) {
  std::string words;
  const auto add = [&](const char* name, double value, const char* unit, double factor) {
    if (std::isnan(value)) return;
    words +=
        fmt::format("{}{} {}", words.empty() ? "" : ", ", name, quantity(value * factor, unit, 4));
  };
  if (s.kind == StageKind::kGravity) words = "own weight";
  add("load on each pier", s.pier_load, "kN", 1e-3);
  add("pressure on the top", s.pressure, "MPa", 1e-6);
  add("load on the beam", s.beam_load, "kN", 1e-3);
  if (s.kind == StageKind::kPush) words = fmt::format("push in {}", direction_word(s.direction));
  add("velocity", s.velocity, "mm/s", 1e3);
  add("until", s.until, "mm", 1e3);
  for (double target : s.targets) add("to", target, "mm", 1e3);
  add("body force growing at", s.rate, "/s", 1);
  add("up to", s.factor, "of the weight", 1);
  add("tilt at", s.tilt_rate, "°/s", kDegree);
  add("up to", s.tilt_until, "°", kDegree);
  add("hold for", s.duration, "s", 1);
  return words;
}

std::string stage_table(const std::vector<Stage>& stages) {
  Rows rows = {{"", ""}};
  for (const Stage& stage : stages) {
    std::string words = stage_words(stage.spec);
    if (!stage.driven.empty()) {
      words +=
          fmt::format("; {} driven {} at a height of {}", stage.driven.size(),
                      stage.driven.size() == 1 ? "block" : "blocks", metres(stage.load_height));
    }
    rows.push_back({escaped(stage.spec.name), words});
  }
  return table(rows, "words bare");
}

}  // namespace

std::string inputs_section(const ModelSpec& spec, const Model& model) {
  std::string out = "<h2>What went in</h2>\n";
  if (!spec.note.empty()) out += "<p>" + escaped(spec.note) + "</p>\n";
  out += "<div class=\"two\"><div><h3>Wall</h3>\n" + wall_table(spec, model);
  out += "</div><div><h3>Stages</h3>\n" + stage_table(model.stages) + "</div></div>\n";
  if (!spec.material.empty())
    out += "<h3>Materials of the joints</h3>\n" + material_table(spec.material);
  const SolveSpec& s = spec.solve;
  out += fmt::format(
      "<p class=\"soft\">Settings: {} points on a joint face, local damping {}, time step {} of "
      "the "
      "stable bound, gravity {}, mass scaling {}.</p>\n",
      s.points_per_face, rounded(s.damping), rounded(s.step_fraction),
      quantity(s.gravity, "m/s²", 4), rounded(s.mass_scaling));
  return out;
}

}  // namespace wythe::report
