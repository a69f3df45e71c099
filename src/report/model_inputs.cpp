// Lists the user's inputs and the values that the model derived, as rows of key, value and unit. Each row has
// its factor from SI to the displayed unit. NaN means not given and leaves no row; infinite is "unlimited".
// Origins are cut from lines that materials::to_text() composes, so this file depends on their wording.
#include "report/model_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/library.h"
#include "materials/origin.h"
#include "model/protocol.h"
#include "report/translation.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/notes.h"

namespace wythe::report {
namespace {

constexpr double kDegree = 57.29577951308232;  // per radian

// A row of the material table: SI value times factor is the displayed value. Every number of a material
// has its row (tests/unit/report/report_test.cpp compares them with the keys of the model file). Forces
// are in kN and stresses in MPa, moduli of bars and layers in GPa; 1 kN/m is 1 N/mm, 1 MPa/mm is 1 GPa/m.
struct MaterialRow {
  const char* key;
  const char* unit;
  double factor;
  double JointMaterial::*value;
};

constexpr MaterialRow kMaterialRows[] = {
    {"normal_stiffness", "MPa/mm", 1e-9, &JointMaterial::normal_stiffness},
    {"shear_stiffness", "MPa/mm", 1e-9, &JointMaterial::shear_stiffness},
    {"tensile_strength", "MPa", 1e-6, &JointMaterial::tensile_strength},
    {"cohesion", "MPa", 1e-6, &JointMaterial::cohesion},
    {"residual_cohesion", "MPa", 1e-6, &JointMaterial::residual_cohesion},
    {"friction_angle", "°", kDegree, &JointMaterial::friction_angle},
    {"residual_friction_angle", "°", kDegree, &JointMaterial::residual_friction_angle},
    {"compressive_strength", "MPa", 1e-6, &JointMaterial::compressive_strength},
    {"mode_1_energy", "kN/m", 1e-3, &JointMaterial::mode_1_energy},
    {"mode_2_energy", "kN/m", 1e-3, &JointMaterial::mode_2_energy},
    {"mode_2_energy_per_pressure", "mm", 1e3, &JointMaterial::mode_2_energy_per_pressure},
    {"head_joint_bond", "", 1, &JointMaterial::head_joint_bond},
    {"compressive_energy", "kN/m", 1e-3, &JointMaterial::compressive_energy},
    {"compression_cap", "", 1, &JointMaterial::compression_cap},
    {"hardening_displacement", "mm", 1e3, &JointMaterial::hardening_displacement},
    {"dilatancy_angle", "°", kDegree, &JointMaterial::dilatancy_angle},
    {"dilatancy_slip", "mm", 1e3, &JointMaterial::dilatancy_slip},
    {"dilatancy_pressure", "MPa", 1e-6, &JointMaterial::dilatancy_pressure},
    {"density", "kg/m³", 1, &JointMaterial::density},
    {"youngs_modulus", "MPa", 1e-6, &JointMaterial::youngs_modulus},
    {"youngs_modulus_across", "MPa", 1e-6, &JointMaterial::youngs_modulus_across},
    {"shear_modulus", "MPa", 1e-6, &JointMaterial::shear_modulus},
    {"poisson_ratio", "", 1, &JointMaterial::poisson_ratio},
    {"tension_limit", "MPa", 1e-6, &JointMaterial::tension_limit},
    {"compression_limit", "MPa", 1e-6, &JointMaterial::compression_limit}};

// JSON has no infinity, so "unlimited" replaces it; null means not given.
Json number(double value) {
  if (std::isinf(value)) return "unlimited";
  return value;
}

Json row(const char* key, double value, const char* unit) { return {key, number(value), unit}; }

// One column for each material; rows that no material has are left out.
Json materials_of(const std::map<std::string, JointMaterial>& materials) {
  Json names = Json::array(), rows = Json::array();
  for (const auto& [name, material] : materials) names.push_back(name);
  for (const MaterialRow& r : kMaterialRows) {
    Json cells = Json::array();
    bool stated = false;
    for (const auto& [name, material] : materials) {
      cells.push_back(number(material.*r.value * r.factor));
      stated = stated || !std::isnan(material.*r.value);
    }
    if (stated) rows.push_back({r.key, r.unit, cells});
  }
  // the joint law in words; a material of a body has none
  const auto add_words = [&](const char* key, const auto& word) {
    Json cells = Json::array();
    bool stated = false;
    for (const auto& [name, material] : materials) {
      const bool is_joint = !std::isnan(material.normal_stiffness);
      cells.push_back(is_joint ? Json(word(material)) : Json());
      stated = stated || is_joint;
    }
    if (stated) rows.push_back({key, "", cells});
  };
  add_words("softening",
            [](const JointMaterial& m) { return word_of(kSofteningWords, m.softening); });
  add_words("coupling", [](const JointMaterial& m) { return word_of(kCouplingWords, m.coupling); });
  add_words("unloading",
            [](const JointMaterial& m) { return word_of(kUnloadingWords, m.unloading); });
  return {{"names", names}, {"rows", rows}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// The parts of a line of origin: [table, key, value, kind, rule or typology, inputs, formula
// or title, source]. Its connecting words are left out, because the page has its own.
Json origin_row(const std::string& table, materials::Role role, const materials::Origin& origin) {
  using materials::Origin;
  const std::string by =
      origin.by.substr(std::min<std::size_t>(3, origin.by.size()));  // after "by "
  const std::size_t end = std::min(by.find(' '), by.size());
  const std::string name = by.substr(0, end);
  std::string inputs, formula, source;
  const materials::Rule* rule = materials::rule_for(role, origin.key, name);
  if (rule && origin.kind == Origin::kDerived) {
    inputs = by.substr(std::min(end + 6, by.size()));  // after " from "
    inputs = replaced(replaced(inputs, "(typical of ", "(t: "), "(by ", "(r: ");
    formula = rule->formula;
    source = rule->source;
  }
  const materials::Entry* entry = materials::entry_of(name);
  if (entry && origin.kind == Origin::kTypical) {
    formula = entry->title;
    source = by.substr(std::min(by.find(" (", end) + 2, by.size()));
    const std::size_t way = source.find("): ");  // of a knowledge level
    if (way != std::string::npos) {
      inputs = source.substr(way + 3);
      source.resize(way);
    }
    if (source.ends_with(')')) source.pop_back();
  }
  const bool given = origin.kind == Origin::kGiven;
  return {table,  origin.key, origin.value, materials::kind_word(origin.kind), given ? by : name,
          inputs, formula,    source};
}

void add_origins(const std::string& table, materials::Role role,
                 const std::vector<std::string>& lines, Json& rows) {
  for (const std::string& line : lines)
    if (const auto origin = materials::origin_of(line))
      rows.push_back(origin_row(table, role, *origin));
}

// Whether the law is that of a crack within units, not of a joint.
bool is_unit_joint(const ModelSpec& spec, const std::string& name) {
  const auto names_it = [&](const auto& part) { return part.joints.unit_joint == name; };
  return name == "unit" || names_it(spec.wall) ||
         std::any_of(spec.storey.begin(), spec.storey.end(), names_it) ||
         std::any_of(spec.region.begin(), spec.region.end(), names_it);
}

// Each note is a text, or one line and the notes that it stands for.
Json notes_of(const std::vector<Message>& notes) {
  Json rows = Json::array();
  for (const NoteGroup& group : grouped(notes))
    rows.push_back(group.members.empty() ? translated(group.line)
                                         : Json{{"line", translated(group.line)},
                                                {"members", translated(group.members)}});
  return rows;
}

Json floor_row(const std::string& name, const materials::Origin& origin) {
  const bool is_load = origin.key == "load";
  const std::size_t from = origin.by.find(" from ");
  return {name,
          is_load ? "line_load" : "floor_mass",
          origin.value,
          "derived",
          is_load ? "floor_load" : "floor_mass",
          from == std::string::npos ? "" : origin.by.substr(from + 6),
          is_load ? "(g1 + g2 + psi2 q) span / 2" : "load / 9.81 m/s^2",
          is_load ? "NTC 2018, 2.5.3, [2.5.5]" : "NTC 2018, 2.5.3, [2.5.7]"};
}

Json origins_of(const ModelSpec& spec) {
  Json rows = Json::array();
  add_origins("masonry", materials::Role::kMasonry, spec.masonry.origin, rows);
  for (const auto& [name, material] : spec.material)
    add_origins(name, is_unit_joint(spec, name) ? materials::Role::kUnit : materials::Role::kJoint,
                material.origin, rows);
  for (const FloorSpec& floor : spec.floor)
    for (const std::string& line : floor.origin)
      if (const auto origin = materials::origin_of(line))
        rows.push_back(floor_row(floor.name, *origin));
  return rows;
}

// Results of tests, which are inputs of rules.
Json masonry_rows(const MasonrySpec& m) {
  Json rows = Json::array();
  if (m.unit_type != UnitType::kUnstated)
    rows.push_back({"unit_type", word_of(kUnitTypeWords, m.unit_type), ""});
  const auto add = [&](const char* key, double value, const char* unit, double factor) {
    if (!std::isnan(value)) rows.push_back(row(key, value * factor, unit));
  };
  add("unit_strength", m.unit_strength, "MPa", 1e-6);
  add("mortar_strength", m.mortar_strength, "MPa", 1e-6);
  add("masonry_strength", m.masonry_strength, "MPa", 1e-6);
  add("vertical_stress", m.vertical_stress, "MPa", 1e-6);
  add("diagonal_shear_strength", m.diagonal_shear_strength, "MPa", 1e-6);
  add("initial_shear_strength", m.initial_shear_strength, "MPa", 1e-6);
  add("friction_tan", m.friction_tan, "", 1);
  add("youngs_modulus", m.youngs_modulus, "MPa", 1e-6);
  add("shear_modulus", m.shear_modulus, "MPa", 1e-6);
  add("weight", m.weight, "kN/m³", 1e-3);
  add("density", m.density, "kg/m³", 1);
  add("unit_youngs_modulus", m.unit_youngs_modulus, "MPa", 1e-6);
  add("mortar_youngs_modulus", m.mortar_youngs_modulus, "MPa", 1e-6);
  add("interface_normal_stiffness", m.interface_normal_stiffness, "MPa/mm", 1e-9);
  add("interface_shear_stiffness", m.interface_shear_stiffness, "MPa/mm", 1e-9);
  add("joint_thickness", m.joint_thickness, "mm", 1e3);
  add("course_height", m.course_height, "mm", 1e3);
  add("unit_length", m.unit_length, "mm", 1e3);
  return rows;
}

// One number, or the range from the thinnest to the thickest masonry.
Json thickness_row(const Model& model) {
  double least = model.anatomy.thickness, most = least;
  for (std::size_t b = 0; b < model.anatomy.block_role.size(); ++b) {
    if (model.anatomy.block_role[b] != BlockRole::kMasonry) continue;
    least = std::min(least, model.anatomy.block_thickness[b]);
    most = std::max(most, model.anatomy.block_thickness[b]);
  }
  if (!(least < most)) return row("thickness", most, "m");
  return {"thickness", fmt::format("{:g} – {:g}", least, most), "m"};
}

Json wall_rows(const ModelSpec& spec, const Model& model) {
  const Anatomy& a = model.anatomy;
  Json rows = {row("length", a.length, "m"), row("height", a.height, "m"), thickness_row(model)};
  if (!spec.wall.blocks.empty()) rows.push_back({"blocks_file", spec.wall.blocks, ""});
  if (a.courses > 0) {
    rows.push_back({"bond", word_of(kBondWords, spec.wall.bond), ""});
    rows.push_back(row("courses", a.courses, ""));
    rows.push_back(row("course_height", a.course_height * 1e3, "mm"));
    rows.push_back(row("half_unit", a.half_unit * 1e3, "mm"));
  }
  if (!std::isnan(spec.wall.unit.density))
    rows.push_back(row("unit_density", spec.wall.unit.density, "kg/m³"));
  if (!std::isnan(spec.wall.beam.height)) {
    rows.push_back(row("beam_height", spec.wall.beam.height * 1e3, "mm"));
    rows.push_back(row("beam_density", spec.wall.beam.density, "kg/m³"));
  }
  rows.push_back(row("all_weight", model.weight * 1e-3, "kN"));
  return rows;
}

// Foot of the storey from which an opening is measured.
double foot_of(const ModelSpec& spec, const std::string& storey) {
  double foot = 0;
  for (const StoreySpec& s : spec.storey) {
    if (s.name == storey) return foot;
    foot += s.height;
  }
  return 0;
}

// From the ground up.
Json storeys_of(const ModelSpec& spec) {
  Json list = Json::array();
  double foot = 0;
  for (const StoreySpec& s : spec.storey) {
    list.push_back({{"name", s.name},
                    {"foot", foot},
                    {"height", s.height},
                    {"thickness", std::isnan(s.thickness) ? spec.wall.thickness : s.thickness}});
    foot += s.height;
  }
  return list;
}

Json openings_of(const ModelSpec& spec) {
  Json list = Json::array();
  for (const OpeningSpec& o : spec.wall.opening)
    list.push_back(
        {{"name", o.name},
         {"x", o.x},
         {"y", o.y + foot_of(spec, o.storey)},
         {"width", o.width},
         {"height", o.height},
         {"lintel", o.lintel.kind},
         {"lintel_depth_mm", o.lintel.depth * 1e3},
         {"lintel_bearing_mm", o.lintel.bearing * 1e3},
         {"arch", o.arch.kind == ArchKind::kNone ? "" : word_of(kArchKindWords, o.arch.kind)},
         {"arch_depth_mm", o.arch.depth * 1e3},
         {"sill", o.sill.kind},
         {"sill_depth_mm", o.sill.depth * 1e3}});
  return list;
}

// The point, with z in space; or the block or the beam.
std::string place_words(const PlaceSpec& at) {
  if (at.beam) return "beam";
  if (!at.block.empty()) return at.block;
  return std::isnan(at.z) ? fmt::format("({:.4g} m, {:.4g} m)", at.x, at.y)
                          : fmt::format("({:.4g} m, {:.4g} m, {:.4g} m)", at.x, at.y, at.z);
}

// Loads on the wall, ties and restraints: [kind, name, where, rows].
class Carried {
 public:
  Json list = Json::array();

  void add(const char* kind, const std::string& name, std::string where) {
    list.push_back({{"kind", kind}, {"name", name}, {"where", std::move(where)}});
    list.back()["rows"] = Json::array();
  }
  void number(const char* key, double value, const char* unit, double factor) {
    if (!std::isnan(value)) list.back()["rows"].push_back(row(key, value * factor, unit));
  }
  void word(const char* key, const std::string& value) {
    list.back()["rows"].push_back({key, value, ""});
  }
};

std::string level_words(const std::string& storey, double y) {
  return storey.empty() ? fmt::format("y = {:.4g} m", y) : storey;
}

std::string stretch_words(double x, double width) {
  std::string words;
  if (!std::isnan(x)) words += fmt::format(", x = {:.4g} m", x);
  if (!std::isnan(width)) words += fmt::format(", {:.4g} m", width);
  return words;
}

std::string layer_words(const LayerSpec& l) {
  std::string words;
  const auto add = [&](const char* key, double value) {
    if (std::isnan(value)) return;
    words += fmt::format("{}{} = {:.4g} m", words.empty() ? "" : ", ", key, value);
  };
  add("x", l.x), add("y", l.y), add("width", l.width), add("height", l.height);
  return words;
}

void add_floors_and_rings(const ModelSpec& spec, Carried& carried) {
  for (const RingBeamSpec& r : spec.ring_beam) {
    carried.add("ring_beam", r.name, level_words(r.storey, r.y) + stretch_words(r.x, r.width));
    carried.number("height", r.height, "mm", 1e3);
    carried.number("thickness", r.thickness, "mm", 1e3);
    carried.word("material", r.material);
  }
  for (const FrameSpec& f : spec.frame) {
    const std::string of = f.profile.empty() ? "" : ", " + f.profile;
    carried.add("frame", f.name, f.round + of);
    if (!f.grade.empty()) carried.word("material", f.grade);
  }
  for (const LayerSpec& l : spec.layer) {
    carried.add("layer", l.name, layer_words(l));
    carried.number("faces", l.sides, "", 1);
    if (l.fibres.horizontal > 0) carried.number("level_fibres", l.fibres.horizontal, "mm²/m", 1e6);
    if (l.fibres.vertical > 0) carried.number("upright_fibres", l.fibres.vertical, "mm²/m", 1e6);
    carried.number("youngs_modulus", l.fibres.youngs_modulus, "GPa", 1e-9);
    carried.number("fibre_strength", l.fibres.strength, "MPa", 1e-6);
    carried.number("rupture_strain", l.fibres.strain_at_rupture, "‰", 1e3);
    carried.number("bond_energy", l.bond.energy, "N/m", 1);
    carried.number("bond_slip", l.bond.slip, "mm", 1e3);
  }
  for (const FloorSpec& f : spec.floor) {
    const bool in_space = !std::isnan(f.from.z);  // along its own line
    carried.add("floor", f.name,
                in_space ? place_words(f.from) + " – " + place_words(f.to)
                         : level_words(f.storey, f.y) + stretch_words(f.x, f.width));
    carried.number("line_load", f.load, "kN/m", 1e-3);
    if (!f.joists.empty()) carried.number("joists", static_cast<double>(f.joists.size()), "", 1);
    carried.number("bearing", f.bearing, "mm", 1e3);
    if (f.thrust != 0) carried.number("thrust", f.thrust, "kN", 1e-3);
    if (f.mass > 0) carried.number("floor_mass", f.mass, "kg/m", 1);
  }
}

Json carried_by(const ModelSpec& spec) {
  Carried carried;
  add_floors_and_rings(spec, carried);
  for (const TieSpec& t : spec.tie) {
    carried.add("tie", t.name, place_words(t.from) + " – " + place_words(t.to));
    carried.number("area", t.area, "mm²", 1e6);
    carried.number("youngs_modulus", t.youngs_modulus, "MPa", 1e-6);
    carried.number("yield_strength", t.yield_strength, "MPa", 1e-6);
    carried.number("anchor_strength", t.anchor_strength, "kN", 1e-3);
    if (t.prestress > 0) carried.number("prestress", t.prestress, "MPa", 1e-6);
  }
  for (const DiaphragmSpec& d : spec.diaphragm) {
    carried.add("diaphragm", d.name, level_words(d.storey, d.y));
    carried.word("diaphragm_kind", std::string(word_of(kDiaphragmKindWords, d.kind)));
    carried.number("points", static_cast<double>(d.x.size()), "", 1);
    carried.number("axial_stiffness", d.stiffness, "MN", 1e-6);
  }
  for (const SpringSpec& s : spec.spring) {
    carried.add("spring", s.name, place_words(s.at));
    carried.word("direction", std::string(word_of(kDirectionWords, s.direction)));
    carried.number("spring_stiffness", s.stiffness, "kN/mm", 1e-6);
    carried.number("strength", s.strength, "kN", 1e-3);
    if (s.pushes_only) carried.word("pushes_only", "yes");
  }
  return std::move(carried.list);
}

// "−x": with a minus sign, not a hyphen.
std::string direction_word(Direction direction) {
  const std::string word = word_of(kDirectionWords, direction);
  return word.starts_with('-') ? "−" + word.substr(1) : word;
}

// Weight of the loads that the stage puts on blocks [N]; NaN where there are none.
double weight_of(const Stage& stage) {
  double weight = 0;
  for (const PointLoad& load : stage.loads) weight -= load.fy;
  return weight > 0 ? weight : kUnset;
}

std::string control_of(const PlaceSpec& at) {
  return at.block.empty() ? fmt::format("x = {:g} m, y = {:g} m", at.x, at.y) : at.block;
}

Json stage_of(const Stage& stage) {
  const StageSpec& s = stage.spec;
  Json rows = Json::array();
  const auto add = [&](const char* key, double value, const char* unit, double factor) {
    if (!std::isnan(value)) rows.push_back(row(key, value * factor, unit));
  };
  const PushStage* push = stage.push();
  const auto* load = std::get_if<LoadStage>(&s.action);
  if (load != nullptr) {
    add("pier_load", load->pier_load, "kN", 1e-3);
    add("pressure", load->pressure, "MPa", 1e-6);
    add("beam_load", load->beam_load, "kN", 1e-3);
    add("force", load->force, "kN", 1e-3);
    add("line_load", load->line_load, "kN/m", 1e-3);
  }
  if (s.kind() == StageKind::kGravity || (load != nullptr && load->floors))
    add("floors", weight_of(stage), "kN", 1e-3);
  if (push != nullptr) {
    rows.push_back({"direction", direction_word(push->drive.direction), ""});
    add("velocity", push->velocity, "mm/s", 1e3);
    add("fast_velocity", push->fast_velocity, "mm/s", 1e3);
    if (!goes_to_and_fro(*push)) add("until", push->until, "mm", 1e3);
    if (stage.has_pattern())
      rows.push_back(Json::array(
          {"pattern",
           translated(words_of_pattern(std::string(word_of(kPatternWords, push->pattern)))), ""}));
    for (double level : push->levels) add("level", level, "m", 1);
    for (double share : push->shares) add("share", share, "", 1);
    if (has_protocol(*push))
      rows.push_back({"amplitudes", told_levels(*push), push->amplitudes.empty() ? "%" : "mm"});
    else
      for (double target : push->targets) add("target", target, "mm", 1e3);
    if (push->stop_below > 0) add("stop_below", push->stop_below, "", 1);
  }
  if (const auto* force = std::get_if<BodyForceStage>(&s.action)) {
    add("load_factor_rate", force->rate, "1/s", 1);
    add("load_factor_until", force->factor, "", 1);
  }
  if (const auto* tilt = std::get_if<TiltStage>(&s.action)) {
    add("tilt_rate", tilt->tilt_rate, "°/s", kDegree);
    add("tilt_until", tilt->tilt_until, "°", kDegree);
  }
  for (const GroundMotion& motion : stage.base) {
    rows.push_back({"record", motion.source, ""});
    add("record_peak", peak_acceleration(motion) / 9.80665, "g", 1);
    add("record_factor", motion.factor, "", 1);
  }
  if (const auto* shake = std::get_if<ShakeStage>(&s.action)) {
    add("mass_damping", shake->mass_damping.fraction, "%", 1e2);
    add("mass_damping_at", shake->mass_damping.frequency, "Hz", 1);
    add("joint_damping", shake->joint_damping.fraction, "%", 1e2);
    add("joint_damping_at", shake->joint_damping.frequency, "Hz", 1);
    add("maxwell_damping", shake->maxwell_damping.fraction, "%", 1e2);
    add("maxwell_damping_at", shake->maxwell_damping.frequency, "Hz", 1);
    add("restitution", shake->restitution, "", 1);
  }
  if (const auto* hold = std::get_if<HoldStage>(&s.action)) add("duration", hold->duration, "s", 1);
  add("ramp", s.ramp, "s", 1);
  add("damping", s.damping, "", 1);
  if (push != nullptr && stage.control >= 0)
    rows.push_back({"control", control_of(push->control), ""});
  if (!stage.driven.empty()) {
    rows.push_back(row("driven_blocks", static_cast<double>(stage.driven.size()), ""));
    rows.push_back(row("load_height", stage.load_height, "m"));
    if (push != nullptr) add("contraflexure", push->contraflexure, "", 1);
    const FixitySpec fixity = fixity_of(s);
    if (fixity.rotation == Freedom::kBlocked)
      rows.push_back({"rotation", word_of(kFreedomWords, fixity.rotation), ""});
    if (fixity.across == Freedom::kBlocked)
      rows.push_back({"across", word_of(kFreedomWords, fixity.across), ""});
  }
  return {{"name", s.name}, {"kind", word_of(kStageKindWords, s.kind())}, {"rows", rows}};
}

}  // namespace

Json model_inputs(const ModelSpec& spec, const Model& model) {
  Json stages = Json::array();
  for (const Stage& stage : model.stages) stages.push_back(stage_of(stage));
  const SolveSpec& s = model.solve;
  return {{"wall", wall_rows(spec, model)},
          {"openings", openings_of(spec)},
          {"storeys", storeys_of(spec)},
          {"carried", carried_by(spec)},
          {"materials", materials_of(spec.material)},
          {"masonry", masonry_rows(spec.masonry)},
          {"origins", origins_of(spec)},
          {"stages", stages},
          {"settings",
           {row("points_per_face", s.points_per_face, word_of(kPointRuleWords, s.point_rule)),
            row("damping", s.damping, ""), row("step_fraction", s.step_fraction, ""),
            row("gravity", s.gravity, "m/s²"), row("mass_scaling", s.mass_scaling, "")}},
          {"notes", notes_of(model.anatomy.notes)}};
}

}  // namespace wythe::report
