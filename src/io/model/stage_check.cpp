// Checks the keys of a stage together. They determine its
// kind; a kind requires some keys and allows only its own.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/text.h"
#include "io/text/toml_reader.h"
#include "model/protocol.h"
#include "wythe/parts/model.h"

namespace wythe::io {
namespace {

std::string words_of(Kinds kinds) {
  std::vector<std::string> words;
  for (const auto& word : kStageKindWords)
    if (kinds & kind_bit(word.value)) words.emplace_back(word.word);
  return joined(words, ", ");
}

bool is_one_kind(Kinds kinds) { return kinds != 0 && (kinds & (kinds - 1)) == 0; }

// Union of the kinds of those present keys that belong to exactly one kind.
Kinds told_kinds(const TableReader& reader) {
  Kinds told = 0;
  for (const TableReader::Entry& entry : reader.entries())
    if (entry.node && is_one_kind(entry.key.kinds)) told |= entry.key.kinds;
  return told;
}

std::string telling_keys(const TableReader& reader) {
  std::vector<std::string> out;
  for (const TableReader::Entry& entry : reader.entries())
    if (entry.node && is_one_kind(entry.key.kinds))
      out.push_back(fmt::format("{} ({})", entry.name, words_of(entry.key.kinds)));
  return joined(out, ", ");
}

// Whether the keys determine the kind; where they do not, a fault says so.
bool has_kind(TableReader& reader, const StageSpec& stage) {
  if (reader.has("kind")) return !reader.context().has_fault_at(reader.below("kind"));
  const Kinds told = told_kinds(reader);
  if (told == 0) {
    if (stage.name == "gravity") return true;
    // a missing name or an unknown key is reported already: one message for one mistake
    if (stage.name.empty() || reader.has_unknown()) return false;
    reader.miss(
        "kind", "can't be deduced: no key of the stage shows its kind",
        "write kind = \"gravity\", or velocity (push), pier_load, pressure, beam_load, "
        "force, line_load or floors (load), rate (body_force), tilt_rate (tilt), duration (hold), "
        "record (shake)");
    return false;
  }
  if (!is_one_kind(told)) {
    reader.refuse_table("has keys of several kinds: " + telling_keys(reader),
                        "make them separate stages");
    return false;
  }
  return true;
}

void refuse_foreign_keys(TableReader& reader, StageKind kind) {
  for (const TableReader::Entry& entry : reader.entries()) {
    const bool foreign = entry.key.kinds != 0 && !(entry.key.kinds & kind_bit(kind));
    if (entry.node && foreign)
      reader.refuse(entry.name,
                    fmt::format("a {} stage has no such key", word_of(kStageKindWords, kind)),
                    fmt::format("it belongs to stages of kind {}", words_of(entry.key.kinds)));
  }
}

// Requires the keys of this kind that describe.h marks as required.
void need_keys(TableReader& reader, StageKind kind) {
  for (const TableReader::Entry& entry : reader.entries())
    if (!entry.node && (entry.key.kinds & kind_bit(kind)) &&
        std::string_view(entry.key.fallback) == kRequired)
      reader.miss(entry.name,
                  fmt::format("is missing, a {} stage needs it", word_of(kStageKindWords, kind)));
}

void check_load(TableReader& reader, const LoadStage& stage) {
  const auto is_given = [&](const char* name) { return reader.has(name); };
  const std::initializer_list<const char*> loads = {"pier_load", "pressure", "beam_load", "force",
                                                    "line_load"};
  const auto given = std::count_if(loads.begin(), loads.end(), is_given) + (stage.floors ? 1 : 0);
  if (given == 0)
    reader.refuse_table(
        "a load stage needs pier_load, pressure, beam_load, force, line_load or floors = true",
        "write e.g. pier_load = \"200 kN\"");
  if (given > 1)
    reader.refuse_table(
        "has more than one of pier_load, pressure, beam_load, force, line_load and floors",
        "make them separate stages");
  const auto place = [&](const char* key, const char* load) {
    if (is_given(key) && !is_given(load))
      reader.refuse(key, fmt::format("says where {} acts, and there is none", load),
                    "leave it out");
    if (!is_given(key) && is_given(load))
      reader.miss(
          key, fmt::format("is missing, {} needs it", load),
          fmt::format("write e.g. {} = {{ x = \"0 m\", y = \"2.7 m\", z = \"0 m\" }}", key));
  };
  place("at", "force");
  place("from", "line_load");
  place("to", "line_load");
  for (const char* key : {"along", "on", "face"})
    if (const bool of_force = is_given("force") || is_given("line_load");
        is_given(key) && of_force == (std::string_view(key) != "along"))
      reader.refuse(key,
                    of_force ? "chooses faces for a pressure, and there is none"
                             : "has no say: only force and line_load have a direction",
                    "leave it out");
}

void check_place(TableReader& reader, const PlaceSpec& at) {
  const bool has_x = at.x == at.x, has_y = at.y == at.y;
  const bool has_width = at.width == at.width, has_height = at.height == at.height;
  int ways = (has_x || has_y ? 1 : 0) + (at.block.empty() ? 0 : 1) + (at.beam ? 1 : 0);
  if (ways == 0 && !at.role.empty()) ways = 1;
  const char* cure = "write e.g. at = { x = \"0 m\", y = \"3.12 m\", courses = 3 }";
  if (reader.context().has_fault_at(reader.below("at"))) return;
  if (ways != 1)
    reader.refuse("at", "must be one of: a point x and y, a block, the beam, a role", cure);
  else if (has_x != has_y)
    reader.refuse("at", "needs both x and y", cure);
  else if (has_width != has_height || (has_width && !has_x))
    reader.refuse("at", "needs x, y, width and height for a box", cure);
}

// True when a value below the place was refused already, so the place is incomplete.
bool place_has_faults(TableReader& reader, const char* place) {
  const std::string path = reader.below(place);
  if (reader.context().has_fault_at(path)) return true;
  for (const char* name : {"x", "y", "width", "height", "block", "beam", "role"})
    if (reader.context().has_fault_at(under(path, name))) return true;
  return false;
}

// True when the key, or a member of its list, was refused already.
bool list_has_faults(TableReader& reader, const char* key) {
  const std::string path = reader.below(key);
  const std::vector<Fault>& all = reader.context().faults.all();
  return reader.context().has_fault_at(path) ||
         std::any_of(all.begin(), all.end(),
                     [&](const Fault& fault) { return fault.path.starts_with(path + "."); });
}

// Checks the keys of a pattern, or else of the pushed place.
void check_pattern(TableReader& reader, const PushStage& stage) {
  if (!reader.has("pattern")) {
    bool is_of_pattern = false;
    for (const char* key : {"levels", "shares"})
      if (reader.has(key) && !std::exchange(is_of_pattern, true))
        reader.refuse(key, "belongs to a pattern", "add e.g. pattern = \"mass_height\"");
    if (!reader.has("at") && !is_of_pattern)
      reader.miss("at", "is missing, a push needs at, or a pattern with its levels");
    return;
  }
  if (stage.pattern == Pattern::kNone) return;  // refused already
  if (reader.has("at"))
    reader.refuse("at", "is for a push without a pattern",
                  "leave it out; levels say where a pattern pushes");
  if (stage.as == Manner::kEach)
    reader.refuse("as", "would move all levels alike, and a pattern shares forces",
                  "leave it out, or push at one place");
  const bool has_levels = stage.pattern != Pattern::kMass && stage.pattern != Pattern::kArea;
  if (has_levels && !reader.has("levels"))
    reader.miss("levels", "is missing, the pattern acts at levels");
  if (!has_levels && reader.has("levels"))
    reader.refuse("levels", "has no meaning, the pattern acts on every block",
                  "leave it out, or write pattern = \"uniform\"");
  const bool has_shares = stage.pattern == Pattern::kGiven;
  if (has_shares && !reader.has("shares"))
    reader.miss("shares", "is missing, the pattern is given by them");
  if (!has_shares && reader.has("shares"))
    reader.refuse("shares", "follow from the pattern",
                  "leave it out, or write pattern = \"given\"");
  if (has_shares && reader.has("shares") && reader.has("levels") &&
      stage.shares.size() != stage.levels.size())
    reader.refuse("shares",
                  fmt::format("must be as many as levels, {} and not {}", stage.levels.size(),
                              stage.shares.size()),
                  "write one share a level");
  if (has_levels && reader.has("levels") && stage.levels.empty() &&
      !list_has_faults(reader, "levels"))
    reader.refuse("levels", "is empty", "write e.g. levels = [\"3.0 m\", \"6.2 m\"]");
}

void check_control(TableReader& reader, const PushStage& stage) {
  if (place_has_faults(reader, "control")) return;
  const PlaceSpec& at = stage.control;
  const bool point = at.x == at.x && at.y == at.y;
  const bool half = (at.x == at.x) != (at.y == at.y);
  const bool more = at.width == at.width || at.height == at.height || at.courses != 1 || at.beam;
  if (half || more || point == !at.block.empty())
    reader.refuse("control", "must be one point, or one block",
                  "write e.g. control = { x = \"0 m\", y = \"6.2 m\" }");
  if (goes_to_and_fro(stage))
    reader.refuse("control", "follows a push in one direction",
                  "leave it out of a cyclic push, or write until in the place of targets");
}

// The head turns freely with the wall, and no other key may give the place of the push.
void check_contraflexure(TableReader& reader, const PushStage& stage) {
  const char* key = "contraflexure";
  if (stage.fixity.rotation == Freedom::kBlocked)
    reader.refuse(key, "needs a head that turns, and rotation = \"blocked\" holds it",
                  "leave one of them out; a head that does not turn finds its own point");
  if (reader.has("pattern"))
    reader.refuse(key, "is for a push at one head, and a pattern pushes at several heights",
                  "leave it out, or push at = { beam = true }");
  if (stage.as == Manner::kEach)
    reader.refuse(key, "is for one head, and as = \"each\" moves several blocks alike",
                  "leave `as` out");
  if (stage.drive.direction != Direction::kPlusX && stage.drive.direction != Direction::kMinusX)
    reader.refuse(key, "is a height, and this push is not horizontal",
                  "write direction = \"+x\" or \"-x\"");
  if (goes_to_and_fro(stage))
    reader.refuse(key, "follows a push in one direction", "write until in the place of targets");
}

void check_protocol(TableReader& reader, const PushStage& stage) {
  constexpr const char* kKeys[] = {"amplitudes", "drifts", "cycles"};
  const auto is_bad = [&](const char* key) { return list_has_faults(reader, key); };
  if (std::any_of(std::begin(kKeys), std::end(kKeys), is_bad)) return;
  for (const auto& [key, list] : {std::pair("amplitudes", &stage.amplitudes),
                                  {"drifts", &stage.drifts},
                                  {"cycles", &stage.cycles}})
    if (reader.has(key) && list->empty())
      return reader.refuse(key, "is empty",
                           "write e.g. amplitudes = [\"2 mm\", \"4 mm\"], cycles = 2");
  const auto found = fault_of_protocol(stage);
  if (!found) return;
  int line = 0;
  for (const TableReader::Entry& entry : reader.entries())
    if (entry.node != nullptr && found->key.starts_with(entry.name)) line = line_of(*entry.node);
  reader.context().fault(reader.below(found->key), line, found->value, found->problem, found->cure);
}

void check_push(TableReader& reader, const PushStage& stage) {
  const double slow = std::isnan(stage.velocity) ? kWaitingVelocity : stage.velocity;
  if (stage.fast_below != PushStage{}.fast_below && reader.has("velocity") &&
      !reader.has("fast_velocity"))
    reader.refuse("fast_below", "has no effect: a stated velocity holds throughout",
                  "give fast_velocity too, or leave velocity out");
  if (stage.fast_velocity < slow)
    reader.refuse("fast_velocity", "is slower than velocity, 0.1 mm/s where none is given",
                  "write a faster one, or leave it out for one velocity throughout");
  const auto has = [&](const char* key) { return reader.has(key); };
  if (!has("until") && !has("targets") && !has("amplitudes") && !has("drifts"))
    reader.miss("until", "is missing, a push needs until or targets");
  check_protocol(reader, stage);
  if (reader.has("targets") && stage.targets.empty() &&
      !reader.context().has_fault_at(reader.below("targets")))
    reader.refuse("targets", "is empty", "write e.g. targets = [\"2 mm\", \"-2 mm\"]");
  const auto same = [](double a, double b) { return a == b; };
  const bool idle =
      !stage.targets.empty() &&
      (stage.targets.front() == 0 ||
       std::adjacent_find(stage.targets.begin(), stage.targets.end(), same) != stage.targets.end());
  if (idle)
    reader.refuse("targets", "holds a target that is reached before it is driven to",
                  "start from a displacement other than 0 and change it at each target");
  check_pattern(reader, stage);
  if (reader.has("at") && !place_has_faults(reader, "at")) check_place(reader, stage.at);
  if (reader.has("control")) check_control(reader, stage);
  if (reader.has("contraflexure")) check_contraflexure(reader, stage);
}

void check_manner(TableReader& reader, const StageSpec& stage) {
  const auto text = [&](std::string_view name, const std::string& absent) {
    for (const TableReader::Entry& entry : reader.entries())
      if (entry.node && entry.name == name) return entry.node->value_or(absent);
    return absent;
  };
  const std::string plate_joint = LoadStage{}.plate_joint;
  if (text("plate_joint", plate_joint) != plate_joint && text("as", "") != "plate")
    reader.refuse("plate_joint", "has no effect: no plate is asked for",
                  "write as = \"plate\", or leave it out");
  const auto* load = std::get_if<LoadStage>(&stage.action);
  const auto* push = std::get_if<PushStage>(&stage.action);
  const Manner as = load ? load->as : push ? push->as : Manner::kDefault;
  if (!reader.has("as") || as == Manner::kDefault) return;
  const bool of_load = as == Manner::kPressure || as == Manner::kPlate;
  if (load && !of_load)
    reader.refuse("as", "a load acts as pressure or plate", "write e.g. as = \"plate\"");
  if (load && as == Manner::kPlate && !reader.has("pier_load"))
    reader.refuse("as", "a plate stands on each pier and needs pier_load",
                  "leave `as` out, or write pier_load");
  if (push && of_load)
    reader.refuse("as", "a push acts as spreader or each", "write e.g. as = \"spreader\"");
}

void check_shake(TableReader& reader, const ShakeStage& stage) {
  const auto is_set = [](double number) { return number == number; };
  const ScaleSpec& scale = stage.scale;
  const int ways = (is_set(scale.factor) ? 1 : 0) + (is_set(scale.pga) ? 1 : 0) +
                   (is_set(scale.pgv) ? 1 : 0) + (is_set(scale.sa) || is_set(scale.period) ? 1 : 0);
  const bool half = is_set(scale.sa) != is_set(scale.period);
  if (reader.has("scale") && !reader.context().has_fault_at(reader.below("scale")) &&
      (ways != 1 || half || (is_set(scale.damping) && !is_set(scale.sa))))
    reader.refuse("scale", "must be one of factor, pga, pgv, or sa with its period (and damping)",
                  "write e.g. scale = { sa = \"5 m/s^2\", period = \"0.3 s\" }");
  const bool drives =
      std::any_of(stage.record.begin(), stage.record.end(), [&](const RecordSpec& r) {
        return is_set(r.at.x) || is_set(r.at.width) || !r.at.block.empty() || r.at.beam ||
               !r.at.role.empty();
      });
  for (const auto& [key, freedom] :
       {std::pair("rotation", stage.fixity.rotation), {"across", stage.fixity.across}})
    if (freedom == Freedom::kBlocked && !drives)
      reader.refuse(key,
                    "has no effect: it is of blocks that a record moves, and no record has `at`",
                    "leave it out, or give a second record its blocks by `at`");
  const auto check_fraction = [&](const char* key, const ViscousSpec& viscous) {
    if (reader.has(key) && (!is_set(viscous.fraction) || !is_set(viscous.frequency)))
      reader.refuse(key, "needs a fraction and the frequency where it is met",
                    fmt::format("write {} = {{ fraction = 0.02, frequency = \"4 Hz\" }}", key));
  };
  check_fraction("mass_damping", stage.mass_damping);
  check_fraction("joint_damping", stage.joint_damping);
  check_fraction("maxwell_damping", stage.maxwell_damping);
}

// Checks further requirements of a kind.
void check_needs(TableReader& reader, const StageSpec& stage) {
  need_keys(reader, stage.kind());
  if (const auto* load = std::get_if<LoadStage>(&stage.action)) check_load(reader, *load);
  if (const auto* push = std::get_if<PushStage>(&stage.action)) check_push(reader, *push);
  if (const auto* shake = std::get_if<ShakeStage>(&stage.action)) check_shake(reader, *shake);
}

}  // namespace

std::string role_advice(const std::string& role) {
  std::vector<std::string> known;
  for (const Word<BlockRole>& word : kBlockRoleWords) {
    if (role.empty() || role == word.word) return "";
    known.emplace_back(word.word);
  }
  return name_advice(role, known);
}

StageKind TableReader::kind_by_keys(StageKind stated) const {
  if (has("kind") && !context_.has_fault_at(below("kind"))) return stated;
  const Kinds told = told_kinds(*this);
  if (told & kShakeStage) return StageKind::kShake;  // beside others: its records have their faults
  for (const auto& word : kStageKindWords)
    if (kind_bit(word.value) == told) return word.value;
  return stated;
}

void finish(TableReader& reader, PlaceSpec& place) {
  if (const std::string cure = role_advice(place.role); !cure.empty())
    reader.refuse("role", "is no role of a block", cure);
}

void finish(TableReader& reader, StageSpec& stage) {
  if (!reader.has("name"))
    reader.miss("name", "is missing, a stage needs one", "write e.g. name = \"push\"");
  else if (stage.name.empty() && !reader.context().has_fault_at(reader.below("name")))
    reader.refuse("name", "is empty", "write e.g. name = \"push\"");
  if (!has_kind(reader, stage)) return;
  refuse_foreign_keys(reader, stage.kind());
  check_needs(reader, stage);
  check_manner(reader, stage);
}

}  // namespace wythe::io
