// Reads the stored states of a push: the name at one of them, when each sign first showed, and what
// the name would be elsewhere. The parts are in wall_parts, the signs in element_states, the rules
// in mode_names, the flags in mode_flags.
#include "wythe/failure_mode.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/mode_flags.h"
#include "study/mode_names.h"

namespace wythe {
namespace {

using study::JointMotion;
using study::WallParts;

// One stored state of the push, read once.
struct Reading {
  const Snapshot* snapshot;
  std::vector<JointMotion> joints;
};

bool same_place(const Reading& a, const Snapshot& b) {
  return a.snapshot->state.step == b.state.step && a.snapshot->displacement == b.displacement;
}

std::vector<Reading> readings_of(const Model& model, const Result& result) {
  std::vector<Reading> readings;
  for (const Snapshot& s : result.snapshots) {
    if (s.label == "start" || (!readings.empty() && same_place(readings.back(), s))) continue;
    readings.push_back({&s, study::read_joint_motion(model, s.state)});
  }
  return readings;
}

// The farthest state up to `read_at`, the last of equals.
const Reading* reading_at(const std::vector<Reading>& readings, double read_at) {
  constexpr double kNearly = 1.01;
  const Reading* found = nullptr;
  const auto far = [](const Reading& r) { return std::fabs(r.snapshot->displacement); };
  for (const Reading& r : readings)
    if (far(r) <= kNearly * read_at && (found == nullptr || far(r) >= far(*found))) found = &r;
  return found;
}

// All states up to the one that is read, in order of time.
std::vector<const Snapshot*> states_up_to(const Snapshot& read, const Result& result) {
  std::vector<const Snapshot*> states;
  for (const auto* list : {&result.readings, &result.snapshots})
    for (const Snapshot& s : *list)
      if (s.label != "start" && s.state.step <= read.state.step) states.push_back(&s);
  std::stable_sort(states.begin(), states.end(), [](const Snapshot* a, const Snapshot* b) {
    return a->state.step < b->state.step;
  });
  return states;
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
  const char* word;
  double ModeRules::*threshold;
};
constexpr Change kChanges[] = {{"crack width", &ModeRules::crack},
                               {"sliding", &ModeRules::sliding},
                               {"crossing of a pier", &ModeRules::pier_crossed},
                               {"crossing of a spandrel", &ModeRules::spandrel_crossed},
                               {"open share of a rocking foot", &ModeRules::rocking},
                               {"crushing", &ModeRules::crushing}};

std::vector<NameReading> sensitivity_of(const WallParts& parts,
                                        const std::vector<Reading>& readings, const Reading& read,
                                        const ModeRules& rules) {
  std::vector<NameReading> names;
  for (const Reading& r : readings)
    if (&r != &read)
      names.push_back({study::name_parts(parts, r.joints, rules).name, r.snapshot->label,
                       r.snapshot->displacement});
  for (const Change& change : kChanges) {
    for (const double factor : {0.75, 1.25}) {
      ModeRules changed = rules;
      changed.*change.threshold *= factor;
      names.push_back({study::name_parts(parts, read.joints, changed).name, "",
                       read.snapshot->displacement, change.word, factor});
    }
  }
  return names;
}

}  // namespace

std::string NameReading::what() const {
  if (!threshold.empty()) return fmt::format("{} x {:g}", threshold, factor);
  const bool is_place = state == "peak" || state == "end";
  return fmt::format("at {}{}", is_place ? "the " : "", state);
}

ElementStates read_elements(const Model& model, const State& state, const ModeRules& rules) {
  return study::element_states(study::find_parts(model), study::read_joint_motion(model, state),
                               rules);
}

ElementStates read_elements(const Model& model, const State& state) {
  return read_elements(model, state, rules_for(model));
}

FailureMode name_from_state(const Model& model, const State& state, const ModeRules& rules) {
  const WallParts parts = study::find_parts(model);
  const std::vector<JointMotion> joints = study::read_joint_motion(model, state);
  FailureMode mode = study::name_parts(parts, joints, rules);
  mode.flags = study::state_flags(model, parts, joints, rules);
  return mode;
}

FailureMode name_from_state(const Model& model, const State& state) {
  return name_from_state(model, state, rules_for(model));
}

FailureMode name_failure_mode(const Model& model, const Result& result, double read_at) {
  const std::vector<Reading> readings = readings_of(model, result);
  const Reading* read = reading_at(readings, read_at);
  if (read == nullptr) {
    FailureMode none;
    none.sentence = "no state of a push to read";
    return none;
  }
  const WallParts parts = study::find_parts(model);
  const ModeRules rules = rules_for(model);
  FailureMode mode = study::name_parts(parts, read->joints, rules);
  mode.read_at = read->snapshot->displacement;
  for (const Snapshot* s : states_up_to(*read->snapshot, result))
    note_first(study::element_states(parts, study::read_joint_motion(model, s->state), rules),
               s->displacement, mode.elements);
  mode.flags = study::state_flags(model, parts, read->joints, rules);
  mode.flags.push_back(study::drop_flag(result.curve, rules));
  mode.sensitivity = sensitivity_of(parts, readings, *read, rules);
  return mode;
}

}  // namespace wythe
