// The assessment of a run: collects the input of assess() from its model and its states.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>

#include "judge/assessment/assessment_parts.h"
#include "judge/modes/element_states.h"
#include "judge/modes/in_space.h"
#include "judge/modes/tested_range.h"
#include "judge/modes/tested_walls.h"
#include "materials/origin.h"
#include "model/coarse_units.h"
#include "wythe/parts/element_forces.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

// Heights of the storeys' tops above the foot: those of the file, or else the levels that are pushed [m].
std::vector<double> levels_of(const ModelSpec& spec, const Stage& push) {
  std::vector<double> levels;
  double top = 0;
  for (const StoreySpec& storey : spec.storey) levels.push_back(top += storey.height);
  if (levels.empty()) levels = push.push()->levels;
  std::sort(levels.begin(), levels.end());
  return levels;
}

// For each level the blocks whose outline contains it.
std::vector<std::vector<BlockId>> blocks_at(const Model& model, const std::vector<double>& levels) {
  std::vector<std::vector<BlockId>> found(levels.size());
  const double foot = study::foot_of(model);
  for (const BlockId b : study::moving_blocks(model)) {
    const study::Extent extent = study::extent_of(model, b);
    const double low = extent.low - foot, high = extent.high - foot;
    const double slack = 1e-6 * high;
    for (std::size_t k = 0; k < levels.size(); ++k)
      if (levels[k] > low + slack && levels[k] <= high + slack) found[k].push_back(b);
  }
  return found;
}

// The largest drift of any storey at each shape of moved_masses().
std::vector<DriftPoint> storey_drifts(const ModelSpec& spec, const Model& model,
                                      const Result& result) {
  const Stage* push = study::push_of(model);
  const std::vector<double> levels = levels_of(spec, *push);
  if (levels.empty()) return {};
  const std::vector<std::vector<BlockId>> blocks = blocks_at(model, levels);
  std::vector<DriftPoint> out;
  for (const auto& [displacement, moved] : study::shapes_of(model, result)) {
    double below = 0, at = 0, largest = 0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      if (blocks[k].empty()) return {};
      double sum = 0;
      for (const BlockId b : blocks[k]) sum += moved[b];
      const double mean = sum / static_cast<double>(blocks[k].size());
      largest = std::fmax(largest, std::fabs(mean - below) / (levels[k] - at));
      below = mean, at = levels[k];
    }
    out.push_back({displacement, largest});
  }
  return out;
}

// In space, the piers of walls along the push. Piers of walls across it do not count.
std::vector<study::Pier> piers_along(const Model& model) {
  std::vector<study::Pier> along;
  const Stage* stage = study::push_of(model);
  if (stage == nullptr) return along;
  const std::vector<study::Elevation> walls = study::elevations_of(model);
  const std::vector<study::WallParts> parts = study::find_parts(model, walls);
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (study::is_along(walls[k], stage->drive()))
      along.insert(along.end(), parts[k].piers.begin(), parts[k].piers.end());
  return along;
}

// Slenderness of the stockiest pier, with zero moment at mid-height: H0 / D = height / 2 / width.
double slenderness_of(const Model& model) {
  const Anatomy& anatomy = model.anatomy;
  double least = kUnset;
  if (dimension_of(model) == 3)  // no builder says which piers exist
    for (const study::Pier& pier : piers_along(model))
      least = std::fmin(least, 0.5 * pier.box.height() / pier.box.width());
  for (std::size_t k = 0; k < anatomy.pier_height.size(); ++k) {
    const double width = anatomy.pier_x1[k] - anatomy.pier_x0[k];
    least = std::fmin(least, 0.5 * anatomy.pier_height[k] / width);
  }
  return least;
}

// Drifts of every pier, at the states_by_displacement().
std::vector<PierDrift> pier_drifts(const Model& model, const Result& result) {
  std::vector<PierDrift> out;
  const Vec3 push = study::push_of(model)->drive();
  for (const ElementForces& element :
       read_element_forces(model, study::states_by_displacement(result))) {
    if (element.kind != "pier" || element.rows.empty()) continue;
    PierDrift& pier = out.emplace_back();
    const double along = dot(element.along, push);
    pier.mark = element.mark;
    pier.element = element.element;
    for (const ElementForces::Row& row : element.rows)
      pier.drifts.push_back({row.displacement, std::fabs(row.drift),
                             along * 0.5 * (row.end[0].shear + row.end[1].shear)});
  }
  return out;
}

bool drives(const Stage& stage) {
  const StageKind kind = stage.spec.kind();
  return kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt;
}

// Forces along the push before or during it: dead loads, and ties prestressed
// against a rigid anchor. Absolute values are added [N], so two that cancel count.
double thrust_on(const Model& model, const Stage& push) {
  const Links& links = model.links;
  double sum = 0;
  for (const Stage& stage : model.stages) {
    for (const PointLoad& load : stage.loads)
      sum += std::fabs(load.fx * push.drive_x + load.fz * push.drive_z);
    if (&stage == &push) break;
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(links.n); ++k)
    if (links.a[k] == kGroundBlock &&
        links.span_x[k] * push.drive_x + links.span_z[k] * push.drive_z != 0)
      sum += std::fabs(links.prestress[k]);
  return sum;
}

// Why a push cannot be assessed: its curve must begin at rest and without force.
Message barred_by_stages(const Model& model, const Stage& push) {
  for (const Stage& stage : model.stages) {
    if (&stage == &push) break;
    if (drives(stage))
      return {stage.push() != nullptr ? "assessment.driven_before" : "assessment.held_before",
              {{"stage", stage.spec.name}, {"push", push.spec.name}}};
  }
  if (const double force = thrust_on(model, push); force > 0)
    return {"assessment.thrust", {{"force_kN", 1e-3 * force}}};
  return {};
}

}  // namespace

namespace study {

// Mechanism of a wall in space. It comes from the piers where the wall stays in its plane (judge/modes/in_space.h).
std::string mechanism_in_space(const FailureMode& mode) {
  const bool breaks_in_plane = mode.name == "part breaking away" && stays_in_planes(mode);
  if (breaks_in_plane) return mechanism_of(mode);
  if (leaves_plane(mode.name)) return kOutOfPlane;
  if (mode.name != "sliding" && !stays_in_plane(mode.name)) return "";
  if (std::string by_piers = mechanism_of(mode); !by_piers.empty()) return by_piers;
  const bool shears = mode.name == "sliding" || mode.name == "in-plane shear";
  return shears ? "shear" : "flexure";
}

namespace {
bool is_shear(const ElementSign& sign) {
  return sign.state == kDiagonal || sign.state == kSliding || sign.state == kBaseSliding;
}
}  // namespace

// "shear" where any pier shows it, "flexure" where piers show only that, "" where nothing is known.
std::string mechanism_of(const FailureMode& mode, const std::string& pier) {
  bool flexure = false;
  for (const ElementState& element : mode.elements) {
    if (element.kind != "pier" || (!pier.empty() && element.element != pier)) continue;
    for (const ElementSign& sign : element.signs) {
      if (!sign.holds()) continue;
      if (is_shear(sign)) return "shear";
      flexure = true;
    }
  }
  return flexure ? "flexure" : "";
}

// The storey in "pier 2 of storey 1"; 0 where the name has none.
int storey_of(const std::string& element) {
  static const std::string kOf = " of storey ";
  const std::size_t at = element.find(kOf);
  return at == std::string::npos ? 0 : std::atoi(element.c_str() + at + kOf.size());
}

// Displacements from which a pier shows shear, and flexure. A sign that disappears again counts.
void find_kinds(const FailureMode& mode, PierDrift& pier) {
  for (const ElementState& element : mode.elements) {
    if (element.element != pier.element) continue;
    pier.shear_from = pier.flexure_from = std::numeric_limits<double>::infinity();
    for (const ElementSign& sign : element.signs) {
      const bool is_dated = std::isfinite(sign.displacement_first);
      if (!is_dated && !sign.holds()) continue;
      double& from = is_shear(sign) ? pier.shear_from : pier.flexure_from;
      from = std::fmin(from, is_dated ? sign.displacement_first : mode.read_at);
    }
  }
}

JudgedPush judged_push(const Model& model) {
  static const std::vector<CurveRow> kNoCurve;
  static const Responses kNoResponses;
  JudgedPush push{.curve = kNoCurve, .responses = kNoResponses};
  push.pier_slenderness = slenderness_of(model);
  // the curve is that of the last stage that has one
  const Stage* last = nullptr;
  for (const Stage& stage : model.stages)
    if (drives(stage)) last = &stage;
  push.curve_of = last == nullptr ? StageKind::kHold : last->spec.kind();
  if (last == nullptr) return push;
  push.is_horizontal = std::fabs(last->drive_y) < 1e-12;
  push.is_patterned = last->has_pattern();
  push.barred = barred_by_stages(model, *last);
  return push;
}

namespace {
double counted_mass(const FloorSpec& floor, const Model& model) {  // of its load [kg/m]
  return floor.load > 0 ? floor.load / model.solve.gravity : 0;
}
double length_of(const FloorSpec& floor, const Model& model) {
  if (std::isfinite(floor.from.x))  // along a line, in space
    return length(
        Vec3{floor.to.x - floor.from.x, floor.to.y - floor.from.y, floor.to.z - floor.from.z});
  return std::isnan(floor.width) ? model.anatomy.length : floor.width;
}
}  // namespace

std::vector<Message> cautions_of_inputs(const ModelSpec& spec, const Model& model) {
  const auto is_odd = [](std::string_view code) {
    return code == "density.odd" || code == "value.odd" || code == "scale.large" ||
           code == "value.thousands" || code == "scale.high" || code == "scale.long" ||
           code == "scale.small";
  };
  std::vector<Message> say, odd;
  for (const Message& note : model.anatomy.notes)
    if (is_odd(note.code)) odd.push_back(note);
  if (const std::size_t count = odd.size(); count > 0)
    say.push_back({"assessment.caution.odd_inputs", {{"count", count}, {"notes", std::move(odd)}}});
  double left_out = 0;
  std::vector<Message> names;
  for (const FloorSpec& floor : spec.floor) {
    const double counted = counted_mass(floor, model);
    if (!(floor.mass > 1.001 * counted)) continue;
    left_out += (floor.mass - counted) * length_of(floor, model);
    names.push_back(as_text(floor.name));
  }
  if (left_out > 1.001 * spec.assessment.added_mass)
    say.push_back({"assessment.caution.floor_mass",
                   {{"floors", std::move(names)},
                    {"mass", left_out},
                    {"added", spec.assessment.added_mass}}});
  return say;
}

std::vector<Message> cautions_of_demand(const AssessmentSpec& spec) {
  constexpr double kDamping = 0.05;            // of critical: both codes [-]
  constexpr double kOfNtc = 1.4;               // the largest ST of NTC 2018, Table 3.2.V [-]
  constexpr double kOfEn = 1.2 * kOfNtc;       // of EN 1998-5, Annex A, with a loose layer [-]
  constexpr double kLeastAmplification = 2.2;  // F0, NTC 2018, 3.2.3.2.1 [-]
  double damping = 0;
  Message topography, amplification;
  const SpectraSpec& states = spec.spectra;
  for (const SpectrumSpec* of : {&spec.spectrum, &states.operational, &states.damage_limitation,
                                 &states.life_safety, &states.near_collapse}) {
    const bool is_ntc = of->kind == SpectrumKind::kNtc2018;
    if (!is_ntc && of->kind != SpectrumKind::kEn1998) continue;
    damping = std::fmax(damping, of->damping);
    const double most = is_ntc ? kOfNtc : kOfEn;
    if (topography.empty() && of->topography > most * (1 + 1e-9))
      topography = {"assessment.caution.topography", {{"value", of->topography}, {"most", most}}};
    if (is_ntc && amplification.empty() && of->amplification < kLeastAmplification)
      amplification = {"assessment.caution.amplification",
                       {{"value", of->amplification}, {"least", kLeastAmplification}}};
  }
  std::vector<Message> say;
  if (damping > kDamping * (1 + 1e-9))
    say.push_back({"assessment.caution.spectrum_damping", {{"percent", 100 * damping}}});
  for (Message* caution : {&topography, &amplification})
    if (!caution->empty()) say.push_back(std::move(*caution));
  // 0.15 m/s^2 where 0.15 g was meant: EN 1998-1, 3.2.1(5) asks for nothing up to 0.04 g, and no site of NTC 2018 has less
  // than 0.05 g in 475 years. Damage and operation belong to shorter periods.
  constexpr double kLeastGround = 0.04 * kStandardGravity;
  for (const LimitState state : {LimitState::kLifeSafety, LimitState::kNearCollapse}) {
    if (!is_checked(spec, state)) continue;
    const double ground = spectrum_of(spectrum_for(spec, state)).ground_acceleration;
    if (!(ground > 0 && ground < kLeastGround)) continue;
    say.push_back({"assessment.caution.ground_acceleration",
                   {{"state", words_of_state(state)},
                    {"value_g", ground / kStandardGravity},
                    {"least_g", kLeastGround / kStandardGravity}}});
    break;
  }
  if (spec.masonry_share < 1)
    say.push_back({"assessment.caution.masonry_share", {{"percent", 100 * spec.masonry_share}}});
  return say;
}

std::vector<Message> notes_of_masses(const ModelSpec& spec, const Model& model) {
  std::vector<Message> notes;
  for (const FloorSpec& floor : spec.floor) {
    const double counted = counted_mass(floor, model);
    if (floor.mass > 1.001 * counted)
      notes.push_back({"assessment.note.floor_mass",
                       {{"floor", floor.name}, {"mass", floor.mass}, {"counted", counted}}});
  }
  const double foot = foot_of(model);
  double top = 0;
  for (const BlockId b : moving_blocks(model))
    top = std::fmax(top, extent_of(model, b).high - foot);
  if (spec.assessment.added_height > top * (1 + 1e-9))
    notes.push_back({"assessment.note.added_height",
                     {{"height_m", spec.assessment.added_height}, {"top_m", top}}});
  return notes;
}

namespace {
bool is_strength(const std::string& key) {
  return key == "cohesion" || key == "residual_cohesion" || key.ends_with("strength");
}

// The knowledge level of a typical value, such as "LC1"; empty where the value was used without one.
std::string level_in(const materials::Origin& origin) {
  const std::size_t at = origin.by.find(" at LC");
  return origin.kind == materials::Origin::kTypical && at != std::string::npos
             ? origin.by.substr(at + 4, 3)
             : "";
}
std::string knowledge_level_of(const ModelSpec& spec) {
  for (const std::string& line : spec.masonry.origin)
    if (const auto origin = materials::origin_of(line); origin && is_strength(origin->key))
      if (std::string level = level_in(*origin); !level.empty()) return level;
  return "";
}

// Typical values, and values derived from them by a rule, that no confidence factor has divided.
std::vector<Message> undivided_strengths(const ModelSpec& spec) {
  bool is_any_typical = false;
  std::vector<Message> found;
  const auto look = [&](const std::string& table, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      const auto origin = materials::origin_of(line);
      if (!origin || origin->kind == materials::Origin::kGiven || !is_strength(origin->key))
        continue;
      if (origin->value.starts_with("0 ")) continue;  // nothing to divide
      if (!level_in(*origin).empty()) continue;       // the program divided it
      is_any_typical = is_any_typical || origin->kind == materials::Origin::kTypical;
      found.push_back(as_text(table + "." + origin->key + " " + origin->value));
    }
  };
  look("masonry", spec.masonry.origin);
  for (const auto& [name, material] : spec.material) look("material." + name, material.origin);
  // values derived only from values of the file are already divided like these
  return is_any_typical ? found : std::vector<Message>{};
}

// The drifts at which tested walls of similar masonry failed.
std::vector<DriftOfTests> tests_of(const Model& model) {
  std::vector<DriftOfTests> out;
  const bool stone = is_dry(model);
  for (const TestedDriftKind& kind : kTestedDrifts) {
    const std::string name = kind.kind;
    if (kind.stone != stone || (name != "shear" && name != "rocking")) continue;
    out.push_back({name == "shear" ? "shear" : "flexure", stone, kind.walls, kind.low, kind.high});
  }
  return out;
}

// Warns if what the curve follows lies below the roof: a failure above it would not be seen. A push in a pattern
// follows a mean of the blocks that it pushes, or its control point. Storeys state where the roof is. Levels of a
// push do not: without storeys the roof is the top of the wall. Storeys of a file of blocks may end far below it, so
// half the height of the wall is the least in any case. Shares that a push states may leave the upper levels
// nearly free: their resultant is no lower than that of an even acceleration, at half the height.
void caution_of_control(const ModelSpec& spec, const Model& model, JudgedPush& push) {
  const Stage* stage = push_of(model);
  if (stage == nullptr || !(stage->load_height > 0)) return;
  const double foot = foot_of(model);
  const auto top_of = [&](const std::vector<BlockId>& blocks) {
    double top = 0;
    for (const BlockId b : blocks) top = std::fmax(top, extent_of(model, b).high - foot);
    return top;
  };
  const std::vector<double> levels = levels_of(spec, *stage);
  const double of_wall = top_of(moving_blocks(model));
  const double roof = spec.storey.empty() || levels.empty() ? of_wall : levels.back();
  const double below = levels.size() > 1 ? levels[levels.size() - 2] : 0;
  constexpr double kHalf = 0.5;  // of the uppermost storey, and of the height
  const double lowest = std::fmax(roof - kHalf * (roof - below), kHalf * of_wall);
  const double height = stage->load_height;
  if (stage->control >= 0 || !stage->has_pattern()) {
    if (height < lowest)
      push.cautions.push_back(
          {"assessment.caution.control", {{"height_m", height}, {"roof_m", roof}}});
    return;
  }
  const double top = top_of(stage->driven);
  const bool is_low = stage->push()->pattern == Pattern::kGiven && height < kHalf * roof;
  if (top < lowest || is_low)
    push.cautions.push_back(
        {"assessment.caution.levels", {{"top_m", top}, {"height_m", height}, {"roof_m", roof}}});
}

// Keeps the piers of walls along the push. The drift of a pier is along its own wall, so others do not count.
void keep_piers_along(const Model& model, JudgedPush& push) {
  std::set<std::string> along;
  for (const Pier& pier : piers_along(model)) along.insert(pier.mark);
  std::erase_if(push.piers, [&](const PierDrift& pier) { return !along.contains(pier.mark); });
}

// A wall that leaves its plane has no pier drifts. A push across all walls is out of plane, whatever name
// the failure has. A failure without a name counts as out of plane if any wall stands across the push.
void caution_in_space(const AssessmentSpec& spec, const Model& model, const FailureMode& mode,
                      JudgedPush& push) {
  push.mechanism = mechanism_in_space(mode);
  const Stage* stage = push_of(model);
  const WallsByPush walls = stage != nullptr ? walls_by_push(model, stage->drive()) : WallsByPush{};
  const bool is_named = push.mechanism == kOutOfPlane;
  const bool is_across = walls.all_across() || (push.mechanism.empty() && !walls.all_along());
  if (walls.all_across())
    push.mechanism = kOutOfPlane;  // whatever a state shows
  else if (!push.mechanism.empty())
    push.mechanism_from = mode.read_at;
  // piers count only for walls that stay in their planes
  if (push.mechanism == kOutOfPlane || push.mechanism.empty())
    push.piers.clear(), push.pier_slenderness = kUnset;
  if (is_named)
    push.cautions.push_back({"assessment.caution.out_of_plane", {{"mode", mode.name}}});
  else if (is_across)
    push.cautions.push_back({"assessment.caution.across",
                             {{"mode", mode.name.empty() ? "unclear" : mode.name},
                              {"off", walls.walls - walls.along},
                              {"walls", walls.walls}}});
  else if (mode.name == "sliding" && !stays_in_planes(mode))  // the name may mean both
    push.cautions.push_back({"assessment.caution.sliding"});
  else if (push.mechanism != "shear" && push.piers.empty() &&
           value_of(kAssessmentCodeWords, spec.code) == AssessmentCode::kEn1998)
    push.cautions.push_back({"assessment.caution.no_piers"});
}

}  // namespace

}  // namespace study

CodeAssessment study::judged(const ModelSpec& spec, const Model& model, JudgedPush push,
                             const FailureMode& mode, const PushedWall& wall) {
  push.mechanism = mechanism_of(mode);
  push.tests = tests_of(model);
  push.cautions = cautions_of_inputs(spec, model);
  push.undivided = undivided_strengths(spec);
  push.knowledge_level = knowledge_level_of(spec);
  caution_of_control(spec, model, push);
  for (Message& caution : cautions_of_demand(spec.assessment))
    push.cautions.push_back(std::move(caution));
  const bool in_space = dimension_of(model) == 3;
  push.drifts = wall.storeys;
  push.storeys_known = !wall.storeys.empty();
  push.piers = wall.piers;
  if (in_space) keep_piers_along(model, push);
  if (in_space) caution_in_space(spec.assessment, model, mode, push);
  for (PierDrift& pier : push.piers) {
    pier.mechanism = mechanism_of(mode, pier.element);
    find_kinds(mode, pier);
    pier.storey = storey_of(pier.element);
  }
  CodeAssessment out = assess(spec.assessment, push, [&](double displacement) {
    const MassAndShape shape = mass_and_shape(wall, displacement);
    return std::isfinite(shape.read_at) ? shape : mass_and_linear_shape(spec.assessment, model);
  });
  if (!in_space) return out;
  std::erase_if(out.notes, [](const Message& note) {
    return note.code == "assessment.note.out_of_plane" ||
           note.code == "assessment.note.whole_drift";
  });
  if (push.piers.empty() && !push.storeys_known)
    out.notes.push_back({"assessment.note.space_drift"});
  if (push.piers.empty() && push.mechanism_from > 0 &&
      push.mechanism != "shear")  // the limit for shear is the smaller one anyway
    out.notes.push_back({"assessment.note.kind_from", {{"from_mm", 1e3 * push.mechanism_from}}});
  return out;
}

PushedWall read_pushed_wall(const ModelSpec& spec, const Model& model, const Result& result) {
  PushedWall wall;
  const JudgedPush push = study::judged_push(model);
  if (!push.is_horizontal || push.curve_of != StageKind::kPush) return wall;
  MassAndShape masses;
  std::vector<MovedMass> moved = study::moved_masses(spec.assessment, model, result, masses);
  if (!std::isfinite(masses.total())) return wall;  // loads without gravity give no mass
  wall.moved = std::move(moved);
  wall.blocks = masses.blocks, wall.loads = masses.loads, wall.added = masses.added;
  wall.storeys = storey_drifts(spec, model, result);
  wall.piers = pier_drifts(model, result);
  return wall;
}

namespace {
// One push shows the capacity of this wall in one direction. A verdict needs many walls and both directions.
void bar_signing(CodeAssessment& out) {
  if (out.verdict == AssessmentVerdict::kNotKnown) return;
  Message said = out.sentence;
  if (said.code == "assessment.unsigned")
    for (const Argument& argument : out.sentence.arguments)
      if (argument.name == "verdict") said = std::get<std::vector<Message>>(argument.value).front();
  out.may_be_signed = false;
  out.cautions.push_back({"assessment.caution.one_push"});
  out.sentence = {"assessment.unsigned",
                  {{"cautions", out.cautions}, {"verdict", std::move(said)}}};
}
}  // namespace

CodeAssessment assess_run(const ModelSpec& spec, const Model& model, const Result& result) {
  const JudgedPush of_model = study::judged_push(model);
  JudgedPush push{.status = result.status,
                  .curve_of = of_model.curve_of,
                  .is_horizontal = of_model.is_horizontal,
                  .is_patterned = of_model.is_patterned,
                  .curve = result.curve,
                  .responses = result.responses,
                  .judgement = result.quasi_static.judgement,
                  .displacement = displacement_of_slow_push(model, result),
                  .mode = mode_of_slow_push(model, result),
                  .overlap_lost = result.validity.overlap_lost,
                  .rise = result.rise,
                  .pier_slenderness = of_model.pier_slenderness,
                  .barred = of_model.barred};
  CodeAssessment out = study::judged(
      spec, model, std::move(push), result.failure_mode,
      result.pushed.is_read() ? result.pushed : read_pushed_wall(spec, model, result));
  for (Message& note : study::notes_of_masses(spec, model)) out.notes.push_back(std::move(note));
  if (Message units = caution_of_units(spec); !units.empty())
    out.cautions.push_back(std::move(units));
  bar_signing(out);
  return out;
}

}  // namespace wythe
