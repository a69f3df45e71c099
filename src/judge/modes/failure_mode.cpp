// Evaluates the stored states of a push: the name at one of them, the displacement where
// each sign first showed, and the name at other displacements. The parts are in wall_parts,
// the signs in element_states, the rules in mode_names, the flags in mode_flags.
#include "wythe/parts/failure_mode.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/stages/wall_run.h"
#include "judge/modes/in_space.h"
#include "judge/modes/mode_flags.h"
#include "judge/modes/mode_names.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/slow_push.h"

namespace wythe {
namespace {

using study::Elevation;
using study::WallMotion;
using study::WallParts;

constexpr double kNearly = 0.01;  // relative difference of equal displacements

double far(const Snapshot& s) { return std::fabs(s.displacement); }

const Stage* stage_of(const Model& model, const Snapshot& s) {
  const std::size_t stage = s.state.stage;
  return stage < model.stages.size() ? &model.stages[stage] : nullptr;
}

bool is_cyclic(const Model& model, const Snapshot& s) {
  const Stage* stage = stage_of(model, s);
  return stage != nullptr && !stage->targets().empty();
}

// The first state at displacement `read_at`, else the last state. For a cyclic push, the last state there before
// it goes farther, so that both directions have had their turn; else the last one at the largest displacement.
const Snapshot* state_to_read(const Model& model, const std::vector<Snapshot>& states,
                              double read_at) {
  if (states.empty()) return nullptr;
  const auto is_there = [&](const Snapshot& s) { return far(s) >= (1 - 1e-6) * read_at; };
  const auto there = std::find_if(states.begin(), states.end(), is_there);
  if (!is_cyclic(model, states.front())) return there != states.end() ? &*there : &states.back();
  const auto beyond = std::find_if(states.begin(), states.end(), [&](const Snapshot& s) {
    return far(s) > (1 + kNearly) * read_at;
  });
  if (beyond == there && there != states.end()) return &*there;
  double most = 0;
  for (auto s = states.begin(); s != beyond; ++s) most = std::max(most, far(*s));
  const Snapshot* last = nullptr;
  for (auto s = states.begin(); s != beyond; ++s)
    if (far(*s) >= (1 - kNearly) * std::min(most, read_at)) last = &*s;
  return last;
}

Message millimetres(double displacement) {
  const double mm = 1e3 * displacement;
  return {std::fabs(mm) < 9.995 ? "length.hundredths" : "length.tenths", {{"mm", mm}}};
}

// True for body force and tilt, in a state far from balance, which the wall was leaving.
bool is_falling(const Model& model, const Snapshot& s) {
  const Stage* stage = stage_of(model, s);
  return stage != nullptr && s.state.progress.balance >= 2 * model.solve.settle_ratio &&
         (stage->spec.kind() == StageKind::kBodyForce || stage->spec.kind() == StageKind::kTilt);
}

// A wall that falls moves as a mechanism, and its size depends on where the run ended. So the limit widths shrink with it.
ModeRules rules_at(const Model& model, const WallParts& parts, const Result& result,
                   const Snapshot& s, double read_at) {
  ModeRules rules = study::rules_of(parts);
  const bool fell = result.status == SolveStatus::kCollapsed && is_falling(model, s);
  if (fell && is_read_early(s.displacement, read_at)) {
    rules.crack *= far(s) / read_at;
    rules.sliding *= far(s) / read_at;
  }
  return rules;
}

// "read at 40.0 mm", and facts that a reader needs beside it.
Message words_for(const Model& model, const Result& result, const Snapshot& s, double read_at) {
  std::vector<Message> words = {{"reading.at", {{"displacement", millimetres(s.displacement)}}}};
  const bool turned = s.label == "turn";
  if (is_falling(model, s))
    words.push_back({"reading.out_of_balance"});
  else if (turned)
    words.push_back({"reading.turned"});
  if (is_read_early(s.displacement, read_at)) {
    const char* end = turned                                     ? "reading.short"
                      : result.status == SolveStatus::kCollapsed ? "reading.collapsed"
                      : result.status == SolveStatus::kCompleted ? "reading.ended"
                                                                 : "reading.stopped";
    words.push_back({end, {{"asked", millimetres(read_at)}}});
  }
  return {"reading", {{"words", std::move(words)}}};
}

// The share of its peak that the force has lost at the displacement of the reading.
double force_lost(const Result& result, double read_at) {
  double peak = 0, now = 0;
  for (const CurveRow& row : backbone_of(result.curve)) {
    if (std::fabs(row.displacement) > (1 + kNearly) * std::fabs(read_at)) break;
    now = row.reaction;
    peak = std::max(peak, now);
  }
  return peak > 0 ? 1 - now / peak : 0.0;
}

// The cause of a collapse: the first block that fell, from the run's reason. Only a block that a tie pulled away has a name of its own.
const Message& why_it_fell(const Message& reason) {
  if (reason.code != "load.largest_carried") return reason;
  for (const Argument& argument : reason.arguments)
    if (const auto* inner = std::get_if<std::vector<Message>>(&argument.value);
        inner != nullptr && !inner->empty())
      return inner->front();
  return reason;
}
bool was_pulled_away(const Result& result) {
  return why_it_fell(result.reason).code == "block.pulled_away";
}
bool is_collapsed(const Result& result) {
  return result.status == SolveStatus::kCollapsed && !result.reason.empty();
}
bool shows_nothing(const FailureMode& mode) {
  constexpr const char* kNothing[] = {"mode.none_here", "mode.no_part", "mode.no_piers",
                                      "mode.no_state", "space.loose"};
  return mode.name == "none" ||
         (mode.name == "unclear" &&
          std::any_of(std::begin(kNothing), std::end(kNothing),
                      [&](const char* code) { return mode.sentence.code == code; }));
}
// The kind of damage, if the name lies between none and one kind. A wall that fell is damaged, so that kind is its name.
const Message* only_kind(const FailureMode& mode) {
  if (mode.name != "unclear" || mode.sentence.code != "mode.between_kinds") return nullptr;
  const auto inner = [](const Message& message, const char* name) -> const std::vector<Message>* {
    for (const Argument& argument : message.arguments)
      if (argument.name == name) return std::get_if<std::vector<Message>>(&argument.value);
    return nullptr;
  };
  const auto* first = inner(mode.sentence, "first");
  const auto* second = inner(mode.sentence, "second");
  if (!first || !second || first->front().code != "damage.none") return nullptr;
  const auto* kinds = inner(second->front(), "kinds");
  return kinds && kinds->size() == 1 ? &second->front() : nullptr;
}

void name_fall(const Result& result, FailureMode& mode) {
  if (!is_collapsed(result)) return;
  if (const Message* kind = only_kind(mode)) {
    const auto surest =
        std::max_element(mode.scores.begin(), mode.scores.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    mode.name = surest->first;
    mode.words = *kind;
    mode.sentence = {"mode.fell_by", {{"kind", *kind}, {"why", why_it_fell(result.reason)}}};
    return;
  }
  if (!shows_nothing(mode)) return;
  const bool pulled = was_pulled_away(result);
  mode.name = pulled ? "part breaking away" : "unclear";
  mode.words = pulled ? Message{"damage.breaking_away"} : Message{};
  mode.sentence = pulled ? why_it_fell(result.reason)
                         : Message{"mode.fell", {{"why", why_it_fell(result.reason)}}};
}
void name_fall(const Result& result, WallMechanism& mechanism) {
  const auto is_none = [](const std::string& name) { return name == "none" || name == "partial"; };
  const bool in_doubt =
      mechanism.name == "unclear" && !mechanism.candidates.empty() &&
      std::all_of(mechanism.candidates.begin(), mechanism.candidates.end(), is_none);
  if (!is_collapsed(result) || (mechanism.name != "none" && !in_doubt)) return;
  mechanism.name = was_pulled_away(result) ? "partial" : "unclear";
  mechanism.candidates.clear();
  mechanism.sentence = was_pulled_away(result)
                           ? why_it_fell(result.reason)
                           : Message{"mode.fell", {{"why", why_it_fell(result.reason)}}};
}

// A force that fell needs a cause: in space too, "none" is not a valid name then.
FailureMode name_read_in_space(const Model& model, const Result& result, const Snapshot& read) {
  FailureMode mode = study::name_in_space(model, read.state);
  if (mode.name == "none" && is_collapsed(result))
    mode = study::name_in_space(model, read.state, study::kLeastMovementOfFall);
  if (mode.name != "none" || is_load_controlled(result)) return mode;
  const double lost = force_lost(result, read.displacement);
  if (lost < ModeRules{}.drop) return mode;
  mode.name = "unclear";
  mode.sentence = {"space.fell",
                   {{"percent", 100 * lost}, {"share_percent", 100 * mode.evidence[0].value}}};
  return mode;
}

// Length of the joints in a state that are pressed where their faces no longer overlap.
double length_slid_off(const WallMotion& motion) {
  double length = 0;
  for (const auto* list : {&motion.joints, &motion.top})
    for (const study::JointMotion& j : *list) length += j.has_slid_off ? j.length() : 0;
  return length;
}

// If half a section of the narrowest pier stands on faces that no longer overlap, no name is reliable.
bool is_slid_off(const WallParts& parts, const WallMotion& motion) {
  double narrowest = parts.wall.width();
  for (const study::Pier& p : parts.piers) narrowest = std::min(narrowest, p.box.width());
  return length_slid_off(motion) >= 0.5 * narrowest;
}

void doubt_slid_off(const WallParts& parts, const WallMotion& motion, const Validity& validity,
                    FailureMode& mode) {
  if (!is_slid_off(parts, motion)) return;
  const bool known = !std::isnan(validity.overlap_lost);
  Message doubt{known ? "mode.slid_off_from" : "mode.slid_off",
                {{"shows", mode.name == "unclear" ? mode.sentence : mode.words}}};
  if (known) doubt.arguments.emplace_back("from", millimetres(validity.overlap_lost));
  mode.sentence = std::move(doubt);
  mode.name = "unclear";
  mode.words = {};
}

// The damage of each part in the states up to the one that is read.
std::vector<study::ElementReading> readings_up_to(const Model& model, const Elevation& seen,
                                                  const WallParts& parts, const Result& result,
                                                  const Snapshot* read, const ModeRules& rules) {
  std::vector<study::ElementReading> readings;
  readings.reserve(result.states.readings.size());
  for (const Snapshot& s : result.states.readings) {
    const WallMotion then = study::evaluate_motion(model, s.state, seen);
    readings.push_back({s.displacement, study::element_states(parts, then, rules)});
    if (&s == read) break;
  }
  return readings;
}

void note_first(const ElementStates& seen, double displacement, ElementStates& elements) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t k = 0; k < elements[e].signs.size(); ++k) {
      ElementSign& sign = elements[e].signs[k];
      double& first = elements[e].displacement_first;
      if (!seen[e].signs[k].holds() || !std::isnan(sign.displacement_first)) continue;
      sign.displacement_first = displacement;
      if (sign.holds() && std::isnan(first)) first = displacement;
    }
  }
}

struct Change {
  const char *word, *code;
  double ModeRules::*threshold;
};
constexpr Change kChanges[] = {
    {"crack width", "threshold.crack", &ModeRules::crack},
    {"sliding", "threshold.sliding", &ModeRules::sliding},
    {"crossing of a pier", "threshold.pier_crossed", &ModeRules::pier_crossed},
    {"crossing of a spandrel", "threshold.spandrel_crossed", &ModeRules::spandrel_crossed},
    {"open share of a rocking foot", "threshold.rocking", &ModeRules::rocking},
    {"crushing", "threshold.crushing", &ModeRules::crushing}};

std::vector<NameReading> sensitivity_of(const Model& model, const Elevation& seen,
                                        const WallParts& parts, const Result& result,
                                        const Snapshot& read, const WallMotion& motion,
                                        const ModeRules& rules, double later) {
  std::vector<NameReading> names;
  const Snapshot* before = &read;
  const auto same_place = [](const Snapshot& a, const Snapshot& b) {
    return a.state.step == b.state.step && a.displacement == b.displacement;
  };
  for (const Snapshot& s : result.states.snapshots) {
    if (s.label == "start" || same_place(s, read) || same_place(s, *before)) continue;
    before = &s;
    const WallMotion there = study::evaluate_motion(model, s.state, seen);
    names.push_back({study::name_parts(parts, there, rules, later).name, s.label, s.displacement});
  }
  for (const Change& change : kChanges) {
    for (const double factor : {0.75, 1.25}) {
      ModeRules changed = rules;
      changed.*change.threshold *= factor;
      names.push_back({study::name_parts(parts, motion, changed, later).name, "", read.displacement,
                       change.word, factor});
    }
  }
  return names;
}

}  // namespace

Message NameReading::what() const {
  if (threshold.empty()) {
    if (state == "peak") return {"reading.at_peak"};
    if (state == "end") return {"reading.at_end"};
    return {"reading.at_state", {{"state", state}}};
  }
  Message words = as_text(threshold);
  for (const Change& change : kChanges)
    if (threshold == change.word) words = {change.code};
  return {"reading.other_threshold", {{"threshold", words}, {"factor", factor}}};
}

ElementStates read_elements(const Model& model, const State& state, const ModeRules& rules) {
  const std::vector<Elevation> walls = study::elevations_of(model);
  const std::vector<WallParts> parts = study::find_parts(model, walls);
  const WallReading now = read_wall(model, state);
  ElementStates all;
  for (std::size_t k = 0; k < walls.size(); ++k)
    for (ElementState& e :
         study::element_states(parts[k], study::evaluate_motion(model, now, walls[k]), rules))
      all.push_back(std::move(e));
  return all;
}

ElementStates read_elements(const Model& model, const State& state) {
  return read_elements(model, state, rules_for(model));
}

namespace {

// The walls that move in their planes, and the damage of each.
struct WallsInPlane {
  std::vector<FailureMode> modes;
  bool is_all = false;  // they are all that takes part
  Evidence told;        // their share of the motion
};
template <class ModeOf>
WallsInPlane walls_in_plane(const Model& model, const State& state, const ModeOf& mode_of) {
  WallsInPlane found;
  const std::vector<Elevation> elevations = study::elevations_of(model);
  const std::vector<WallParts> parts = study::find_parts(model, elevations);
  const study::WallsMoved moved = study::moved_in_plane(model, state, elevations);
  for (const std::size_t k : moved.of) found.modes.push_back(mode_of(elevations[k], parts[k]));
  found.is_all = moved.is_all;
  found.told = moved.told;
  return found;
}

// Whether all walls show one kind of damage, by name.
bool agree(const std::vector<FailureMode>& modes) {
  return !modes.empty() && modes.front().name != "unclear" && modes.front().name != "none" &&
         std::all_of(modes.begin(), modes.end(),
                     [&](const FailureMode& m) { return m.name == modes.front().name; });
}

struct NamedWall {
  FailureMode mode;
  bool is_plane = false;  // by the name of its mode, or because the model is plane
};

// Completes a mode in space with the walls that move in their planes:
// their piers and spandrels, and the name of plane walls if all agree.
NamedWall with_walls(FailureMode mode, const WallsInPlane& walls) {
  const bool may_be = mode.name == "sliding" || study::stays_in_plane(mode.name);
  mode.evidence.push_back(walls.told);
  for (const FailureMode& wall : walls.modes) {
    mode.elements.insert(mode.elements.end(), wall.elements.begin(), wall.elements.end());
    mode.evidence.insert(mode.evidence.end(), wall.evidence.begin(), wall.evidence.end());
    mode.flags.insert(mode.flags.end(), wall.flags.begin(), wall.flags.end());
  }
  if (!may_be || !walls.is_all || !agree(walls.modes)) return {std::move(mode)};
  const FailureMode& first = walls.modes.front();
  mode.name = first.name;
  mode.words = first.words;
  mode.scores = first.scores;
  mode.sensitivity = first.sensitivity;
  std::vector<Message> shown;
  for (const FailureMode& wall : walls.modes) shown.push_back(wall.sentence);
  mode.sentence =
      shown.size() == 1 ? shown.front() : Message{"space.each_wall", {{"shows", std::move(shown)}}};
  return {std::move(mode), true};
}

// The mode of one wall in its own plane, from one state.
FailureMode name_of_wall(const Model& model, const State& state, const Elevation& seen,
                         const WallParts& parts, const ModeRules& rules) {
  const WallMotion motion = study::evaluate_motion(model, state, seen);
  FailureMode mode = study::name_parts(parts, motion, rules);
  doubt_slid_off(parts, motion, {}, mode);
  mode.flags = study::state_flags(model, parts, motion.joints, rules);
  return mode;
}

// The mode in a state by `in_plane` of a wall in its plane; in space that of `in_space`, with the walls that move in theirs.
template <class InPlane, class InSpace>
NamedWall name_with(const Model& model, const State& state, const InPlane& in_plane,
                    const InSpace& in_space) {
  if (dimension_of(model) == 2) return {in_plane(Elevation{}, study::find_parts(model)), true};
  return with_walls(in_space(), walls_in_plane(model, state, in_plane));
}

NamedWall name_state(const Model& model, const State& state, const ModeRules& rules) {
  return name_with(
      model, state,
      [&](const Elevation& seen, const WallParts& parts) {
        return name_of_wall(model, state, seen, parts, rules);
      },
      [&] { return study::name_in_space(model, state); });
}

}  // namespace

FailureMode name_from_state(const Model& model, const State& state, const ModeRules& rules) {
  return name_state(model, state, rules).mode;
}

FailureMode name_from_state(const Model& model, const State& state) {
  return name_from_state(model, state, rules_for(model));
}

namespace {

// The mode of one wall in its own plane at the state that is read.
FailureMode mode_of_wall(const Model& model, const Elevation& seen, const WallParts& parts,
                         const Result& result, const Snapshot& read, double read_at) {
  const WallMotion motion = study::evaluate_motion(model, read.state, seen);
  const ModeRules rules = rules_at(model, parts, result, read, read_at);
  const std::vector<study::ElementReading> readings =
      readings_up_to(model, seen, parts, result, &read, rules);
  const double later = study::spandrel_later(parts, readings, rules);
  FailureMode mode = study::name_parts(parts, motion, rules, later);
  doubt_slid_off(parts, motion, result.validity, mode);
  for (const study::ElementReading& r : readings)
    note_first(r.elements, r.displacement, mode.elements);
  // when a sound part fails later: limit states may lie beyond the state that is read
  for (std::size_t i = readings.size();
       i < result.states.readings.size() && !is_cyclic(model, read); ++i) {
    const Snapshot& s = result.states.readings[i];
    note_first(study::element_states(parts, study::evaluate_motion(model, s.state, seen), rules),
               s.displacement, mode.elements);
  }
  mode.flags = study::state_flags(model, parts, motion.joints, rules);
  mode.flags.push_back(study::drop_flag(backbone_of(result.curve), rules));
  mode.sensitivity = sensitivity_of(model, seen, parts, result, read, motion, rules, later);
  return mode;
}

NamedWall name_read(const Model& model, const Result& result, const Snapshot& read,
                    double read_at) {
  return name_with(
      model, read.state,
      [&](const Elevation& seen, const WallParts& parts) {
        return mode_of_wall(model, seen, parts, result, read, read_at);
      },
      [&] { return name_read_in_space(model, result, read); });
}

FailureMode mode_of_push(const Model& model, const Result& result, double read_at) {
  const Snapshot* read = state_to_read(model, result.states.readings, read_at);
  if (read == nullptr) {
    FailureMode none;
    none.sentence = {"mode.no_state"};
    return none;
  }
  FailureMode mode = name_read(model, result, *read, read_at).mode;
  mode.read_at = read->displacement;
  mode.reading = words_for(model, result, *read, read_at);
  return mode;
}

WallMechanism mechanism_in(const WallParts& parts, const WallMotion& motion, const ModeRules& rules,
                           double later = 0) {
  WallMechanism mechanism = study::name_wall(parts, motion, rules, later).mechanism;
  if (!is_slid_off(parts, motion)) return mechanism;
  if (mechanism.name != "unclear") mechanism.candidates = {mechanism.name};
  mechanism.name = "unclear";
  mechanism.sentence = {"mechanism.slid_off", {{"shows", std::move(mechanism.sentence)}}};
  return mechanism;
}

// The smallest part that contains a joint.
Message place_of(const WallParts& parts, const study::JointMotion& joint) {
  const study::Part* found = nullptr;
  for (const auto& [part, kind] : study::all_parts(parts)) {
    const study::Box& b = part->box;
    const double reach = 0.5 * parts.course;
    if (joint.x < b.x0 - reach || joint.x > b.x1 + reach || joint.y < b.y0 - reach ||
        joint.y > b.y1 + reach)
      continue;
    if (found == nullptr || b.width() * b.height() < found->box.width() * found->box.height())
      found = part;
  }
  if (found == nullptr) return {"mechanism.no_part"};
  const auto words = parts.words.find(found->name);
  return words != parts.words.end() ? words->second : as_text(found->name);
}

WallMechanism mechanism_named(const FailureMode& mode) {
  WallMechanism mechanism;
  mechanism.name = mode.name;
  mechanism.sentence = mode.sentence;
  return mechanism;
}

// A force that fell needs a cause. If no pier or spandrel shows one, this says so, and where the wall moved most.
void doubt_calm(const WallParts& parts, const WallMotion& motion, double lost,
                WallMechanism& mechanism) {
  const study::JointMotion* most = nullptr;
  const auto way = [](const study::JointMotion& j) { return std::hypot(j.opened, j.slip); };
  for (const auto* list : {&motion.joints, &motion.top})
    for (const study::JointMotion& j : *list)
      if (most == nullptr || way(j) > way(*most)) most = &j;
  if (most == nullptr) return;
  double crushed = 0;
  for (const study::JointMotion& j : motion.joints) crushed = std::max(crushed, j.crushing);
  mechanism.candidates = {mechanism.name};
  mechanism.name = "unclear";
  mechanism.sentence = {crushed > 0 ? "mechanism.fell" : "mechanism.fell_uncrushed",
                        {{"percent", 100 * std::min(lost, 1.0)},  // below 0 it is all gone
                         {"mm", 1e3 * way(*most)},
                         {"place", place_of(parts, *most)}}};
  if (crushed > 0) mechanism.sentence.arguments.emplace_back("crushed_percent", 100 * crushed);
}

}  // namespace

FailureMode name_failure_mode(const Model& model, const Result& result, double read_at) {
  FailureMode mode = mode_of_push(model, result, read_at);
  name_fall(result, mode);
  return mode;
}

Result solve(const Model& model, State& state, const SolveOptions& options, RunRecord so_far) {
  Result result = dynamics::run_stages(model, state, options, std::move(so_far));
  result.failure_mode = name_failure_mode(model, result, options.read_modes_at);
  return result;
}

SlowPushVerdict mode_of_slow_push(const Model& model, const Result& result) {
  return mode_of_slow_push(model, {result.curve, result.responses, result.quasi_static},
                           result.failure_mode.read_at, is_firm(result.failure_mode));
}

WallMechanism mechanism_from_state(const Model& model, const State& state) {
  const ModeRules rules = rules_for(model);
  const std::vector<Elevation> walls = study::elevations_of(model);
  NamedWall named{.mode = {}, .is_plane = true};
  if (dimension_of(model) == 3) named = name_state(model, state, rules);
  if (walls.size() != 1 || !named.is_plane) return mechanism_named(named.mode);
  return mechanism_in(study::find_parts(model, walls).front(),
                      study::evaluate_motion(model, state, walls.front()), rules);
}

namespace {

WallMechanism mechanism_of_wall(const Model& model, const Elevation& seen, const WallParts& parts,
                                const Result& result, const Snapshot& read, double read_at) {
  const ModeRules rules = rules_at(model, parts, result, read, read_at);
  const WallMotion motion = study::evaluate_motion(model, read.state, seen);
  const double later =
      study::is_two_pier_wall(parts)
          ? study::spandrel_later(parts, readings_up_to(model, seen, parts, result, &read, rules),
                                  rules)
          : 0.0;
  WallMechanism mechanism = mechanism_in(parts, motion, rules, later);
  if (mechanism.name != "none" || is_load_controlled(result)) return mechanism;
  if (const double lost = force_lost(result, read.displacement); lost >= rules.drop)
    doubt_calm(parts, motion, lost, mechanism);
  return mechanism;
}

WallMechanism mechanism_of_push(const Model& model, const Result& result, double read_at) {
  const Snapshot* read = state_to_read(model, result.states.readings, read_at);
  if (read == nullptr) return {};
  const std::vector<Elevation> walls = study::elevations_of(model);
  NamedWall named{.mode = {}, .is_plane = true};
  if (dimension_of(model) == 3) named = name_read(model, result, *read, read_at);
  if (walls.size() != 1 || !named.is_plane) return mechanism_named(named.mode);
  return mechanism_of_wall(model, walls.front(), study::find_parts(model, walls).front(), result,
                           *read, read_at);
}

}  // namespace

WallMechanism read_mechanism(const Model& model, const Result& result, double read_at) {
  WallMechanism mechanism = mechanism_of_push(model, result, read_at);
  name_fall(result, mechanism);
  return mechanism;
}

}  // namespace wythe
