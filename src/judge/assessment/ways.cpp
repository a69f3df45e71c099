// The ways of pushing that a verdict needs: both directions, with two patterns of forces. The opposite
// push is the mirror image of the model's own, so that a symmetric wall gives the same result for both.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "judge/assessment/assessment_parts.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

constexpr const char* kAtPlace = "at";  // a push without a pattern

bool drives(const StageSpec& stage) {
  const StageKind kind = stage.kind();
  return kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt;
}
// Number of the stage whose curve is judged, the last one that drives the wall; the number of stages if none does.
std::size_t driving_stage(const ModelSpec& spec) {
  for (std::size_t k = spec.stage.size(); k-- > 0;)
    if (drives(spec.stage[k])) return k;
  return spec.stage.size();
}

std::string list_of(const std::vector<double>& numbers, const char* unit) {
  std::string out;
  for (const double x : numbers)
    out += fmt::format(
        "{}{}", out.empty() ? "" : ", ",
        *unit == 0 ? fmt::format("{:.17g}", x) : fmt::format("\"{:.17g} {}\"", x, unit));
  return "[" + out + "]";
}

// --- directions ---------------------------------------------------------------------------------------

Direction opposite(Direction d) {
  switch (d) {
    case Direction::kPlusX: return Direction::kMinusX;
    case Direction::kMinusX: return Direction::kPlusX;
    case Direction::kPlusY: return Direction::kMinusY;
    case Direction::kMinusY: return Direction::kPlusY;
    case Direction::kPlusZ: return Direction::kMinusZ;
    case Direction::kMinusZ: break;
  }
  return Direction::kPlusZ;
}

std::string direction_of(const DriveSpec& drive) {
  if (drive.along.empty()) return word_of(kDirectionWords, drive.direction);
  std::string out;
  for (const double x : drive.along) out += fmt::format("{}{:g}", out.empty() ? "" : ", ", x);
  return "[" + out + "]";
}

std::vector<double> reversed(std::vector<double> along) {
  for (double& x : along) x = x == 0 ? 0 : -x;  // no -0
  return along;
}

// Middle of the moving blocks, in plan.
Vec3 middle_of(const Model& model) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 low{kFar, 0, kFar}, high{-kFar, 0, -kFar};
  for (BlockId b = 0; b < model.n_block; ++b)
    for (const Vec3& v : corners_of(model, b)) {
      low.x = std::fmin(low.x, v.x), low.z = std::fmin(low.z, v.z);
      high.x = std::fmax(high.x, v.x), high.z = std::fmax(high.z, v.z);
    }
  return {0.5 * (low.x + high.x), 0, 0.5 * (low.z + high.z)};
}

class Ways {
 public:
  Ways(const ModelSpec& spec, const Model& model)
      : spec_(spec), model_(model), number_(driving_stage(spec)) {}

  PushWays all() {
    check();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    find_patterns();
    const PushWay own = way_of(spec_);
    const std::vector<std::string> mirrored = mirror();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    for (const auto& [pattern, settings] : patterns_) {
      out_.ways.push_back({own.direction, pattern, settings});
      PushWay& other = out_.ways.emplace_back(out_.ways.back());
      other.direction = opposite_;
      other.settings.insert(other.settings.end(), mirrored.begin(), mirrored.end());
    }
    return std::move(out_);
  }

  // Only the model's own push and its mirror image, without an assessment.
  PushWays both() {
    check_push();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    const PushWay own = way_of(spec_);
    std::vector<std::string> mirrored = mirror();
    if (!faults_.empty()) throw InputError(std::move(faults_));
    out_.ways = {own, {opposite_, own.pattern, std::move(mirrored)}};
    return std::move(out_);
  }

 private:
  [[nodiscard]] const PushStage& push() const { return spec_.stage[number_].get<PushStage>(); }
  [[nodiscard]] std::string key(const std::string& name) const {
    return fmt::format("stage.{}.{}", number_, name);
  }
  void refuse(const std::string& path, std::string problem, std::string cure) {
    faults_.push_back({"", path, "", std::move(problem), std::move(cure), 0});
  }

  // Refuses a model without a push, or without a demand.
  void check() {
    const AssessmentSpec& asked = spec_.assessment;
    if (!is_asked(asked))
      refuse(
          "assessment", "is missing: nothing says what the wall must carry",
          "write [assessment] with code = \"circolare_2019\" and under it [assessment.spectrum]");
    else if (asked.spectrum.kind == SpectrumKind::kNone)
      refuse("assessment.spectrum", "is missing: nothing says what the earthquake asks for",
             "write [assessment.spectrum] with kind = \"ntc2018\", \"en1998\" or \"table\"");
    else if (!(spectrum_of(asked.spectrum).peak_ground_acceleration() > 0))
      refuse(asked.spectrum.kind == SpectrumKind::kTable
                 ? "assessment.spectrum.accelerations"
                 : "assessment.spectrum.ground_acceleration",
             "asks for no peak ground acceleration, which every wall carries",
             "write that of the place; in a table the first one is that of period 0 s");
    check_push();
    const double mass = is_asked(asked) ? mass_and_linear_shape(asked, model_).total() : 1;
    if (!(mass > 0) || !std::isfinite(mass))
      refuse("assessment", "finds no mass that an earthquake moves",
             "write gravity in [solve], densities of units, or added_mass");
  }

  void check_push() {
    if (number_ == spec_.stage.size())
      return refuse("stage", text_of({"assessment.without_push"}),
                    "write [[stage]] with name = \"push\", a place or a pattern, and until");
    const std::string stage = fmt::format("stage.{}", number_);
    const char* cure =
        "let the last stage push the wall: a place or a pattern, direction and until";
    const StageKind kind = spec_.stage[number_].kind();
    if (kind != StageKind::kPush)
      return refuse(
          stage,
          text_of({kind == StageKind::kTilt ? "assessment.of_tilt" : "assessment.of_body_force"}),
          cure);
    const JudgedPush judged = study::judged_push(model_);
    for (const auto& [name, list] : {std::pair("targets", &push().targets),
                                     {"amplitudes", &push().amplitudes},
                                     {"drifts", &push().drifts}})
      if (!list->empty())
        return refuse(key(name), text_of({"assessment.of_cycles"}),
                      fmt::format("write until in the place of {}", name));
    if (!judged.is_horizontal)
      return refuse(push().drive.along.empty() ? key("direction") : key("along"),
                    text_of({"assessment.not_horizontal"}), "push the wall sideways");
    if (!judged.barred.empty()) refuse(stage, text_of(judged.barred), cure);
  }

  // --- patterns -----------------------------------------------------------------------------------------

  void only(const char* cure) {
    out_.cautions.push_back(
        {"verdict.caution.one_pattern",
         {{"pattern", words_of_pattern(way_of(spec_).pattern)}, {"cure", Message{cure}}}});
  }

  void find_patterns() {
    const std::string own = way_of(spec_).pattern;
    patterns_.push_back({own, {}});
    const auto add = [&](Pattern pattern, std::vector<std::string> settings) {
      const std::string word = word_of(kPatternWords, pattern);
      settings.insert(settings.begin(), key("pattern") + "=" + word);
      patterns_.push_back({word, std::move(settings)});
    };
    switch (push().pattern) {
      case Pattern::kNone:
        if (spec_.storey.size() > 1) return only("verdict.cure.levels");
        out_.notes.push_back({"verdict.note.one_level"});
        return;
      case Pattern::kMassHeight:
      case Pattern::kUniform:
        if (push().levels.size() < 2) {
          out_.notes.push_back({"verdict.note.one_level"});
          return;
        }
        return add(push().pattern == Pattern::kUniform ? Pattern::kMassHeight : Pattern::kUniform,
                   {});
      case Pattern::kMass: {
        if (spec_.storey.empty()) return only("verdict.cure.levels");
        std::vector<double> levels;
        double top = 0;
        for (const StoreySpec& storey : spec_.storey) levels.push_back(top += storey.height);
        return add(Pattern::kMassHeight, {key("levels") + "=" + list_of(levels, "m")});
      }
      case Pattern::kGiven:
      case Pattern::kArea: return only("verdict.cure.levels");
    }
  }

  // --- the other way --------------------------------------------------------------------------------------

  std::vector<std::string> mirror() {
    std::vector<std::string> settings;
    if (push().drive.along.empty()) {
      opposite_ = word_of(kDirectionWords, opposite(push().drive.direction));
      settings.push_back(key("direction") + "=" + opposite_);
    } else {
      DriveSpec other = push().drive;
      other.along = reversed(other.along);
      opposite_ = direction_of(other);
      settings.push_back(key("along") + "=" + list_of(other.along, ""));
    }
    mirror_place("at", push().at, settings);
    mirror_place("control", push().control, settings);
    return settings;
  }

  void mirror_place(const std::string& name, const PlaceSpec& at,
                    std::vector<std::string>& settings) {
    if (!at.block.empty() || !at.role.empty()) {
      if (name == "at") out_.notes.push_back({"verdict.note.same_place"});
      return;
    }
    if (at.beam || (std::isnan(at.x) && std::isnan(at.z))) return;
    const Stage& stage = *study::push_of(model_);
    const double length = std::hypot(stage.drive_x, stage.drive_z);
    const double ux = stage.drive_x / length, uz = stage.drive_z / length;
    const bool is_box = at.width == at.width || at.depth == at.depth;
    if (is_box && ux != 0 && uz != 0)
      return refuse(key(name), "is a box, which has no mirror image across this direction",
                    "name a point, push along x or z, or push in a pattern");
    const Vec3 middle = middle_of(model_);
    const auto or_zero = [](double x) { return std::isnan(x) ? 0.0 : x; };
    // the middle of a box is mirrored, and its corner follows from it
    const double x = at.x + 0.5 * or_zero(at.width), z = at.z + 0.5 * or_zero(at.depth);
    const double way = or_zero((middle.x - x) * ux) + or_zero((middle.z - z) * uz);
    const auto set = [&](const char* axis, double from, double along) {
      if (!std::isnan(from) && along != 0)
        settings.push_back(
            fmt::format("{}.{}=\"{:.12g} m\"", key(name), axis, from + 2 * way * along));
    };
    set("x", at.x, ux);
    set("z", at.z, uz);
    if (name == "at") out_.notes.push_back({"verdict.note.other_side"});
  }

  const ModelSpec& spec_;
  const Model& model_;
  std::size_t number_;
  std::string opposite_;
  std::vector<std::pair<std::string, std::vector<std::string>>> patterns_;
  std::vector<Fault> faults_;
  PushWays out_;
};

}  // namespace

PushWay way_of(const ModelSpec& spec) {
  const std::size_t k = driving_stage(spec);
  if (k == spec.stage.size()) return {};
  const auto* push = std::get_if<PushStage>(&spec.stage[k].action);
  return {direction_of(drive_of(spec.stage[k])), push == nullptr || push->pattern == Pattern::kNone
                                                     ? kAtPlace
                                                     : word_of(kPatternWords, push->pattern)};
}

PushWays ways_of(const ModelSpec& spec, const Model& model) { return Ways(spec, model).all(); }

PushWays study::both_directions(const ModelSpec& spec, const Model& model) {
  return Ways(spec, model).both();
}

Message words_of_pattern(const std::string& pattern) {
  const std::optional<Pattern> known = value_of(kPatternWords, pattern);
  switch (known.value_or(Pattern::kNone)) {
    case Pattern::kGiven: return {"verdict.pattern.given"};
    case Pattern::kMassHeight: return {"verdict.pattern.mass_height"};
    case Pattern::kUniform: return {"verdict.pattern.uniform"};
    case Pattern::kMass: return {"verdict.pattern.mass"};
    case Pattern::kArea: return {"verdict.pattern.area"};
    case Pattern::kNone: break;
  }
  return {"verdict.pattern.at"};
}

}  // namespace wythe
