// Checks of a code for a part that falls on its face: the spectrum at
// its height, the onset with factor q, and the displacement against d*.
//
// Equations (21.9) to (21.14) of docs/theory/local_mechanisms.md. Called by `wythe limit --assessment`.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/assessment/assessment_parts.h"
#include "judge/local/local_parts.h"
#include "limit/limit_loads.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/error.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

constexpr double kBehaviour = 2;            // q at life safety, C8.7.1.2.1.7
constexpr double kFactorLeastKnown = 1.35;  // of LC1 and KL1
constexpr double kFrom = 0.8, kTo = 1.1;    // a and b of C7.2.3, of T1

// Limit displacement of a part and its demand: C8.7.1.2.1.6 and C8.7.1.2.1.8.
struct Way {
  double of_d0;    // share of d0*
  double period;   // T over sqrt(d*/a(d*))
  double damping;  // of the part
};
constexpr Way kLifeSafety = {0.4, 1.68 * std::numbers::pi, 0.08};
constexpr Way kNearCollapse = {0.6, 1.56 * std::numbers::pi, 0.10};

// Largest displacement of a table up to a period. It may fall again with the period, and a part passes all shorter periods.
double most_of_table(const ElasticSpectrum& table, double until) {
  double most = table.displacement(until);
  const std::vector<double>&T = table.periods, &a = table.accelerations;
  for (std::size_t i = 0; i + 1 < T.size() && T[i] < until; ++i) {
    most = std::max(most, table.displacement(T[i]));
    const double slope = (a[i + 1] - a[i]) / (T[i + 1] - T[i]);
    const double highest = -2 * (a[i] - slope * T[i]) / (3 * slope);  // of T^2 (p + slope T)
    if (slope < 0 && highest > T[i] && highest < std::min(T[i + 1], until))
      most = std::max(most, table.displacement(highest));
  }
  return most;
}

// Peak acceleration and displacements at the place of the part (21.9), (21.10):
// the larger of the ground's values and those of the building's first mode.
class SpectrumAt {
 public:
  SpectrumAt(const SpectrumSpec& given, const BuildingAt& at, double damping)
      : given_(given), ground_(spectrum_of(given)), at_(at) {
    const double percent = 100 * damping;
    if (at.share() > 0)
      of_mode_ =
          ground_.acceleration(at.period) * at.share() * std::sqrt(1 + 0.0004 * percent * percent);
    gain_ = 1.1 / std::sqrt(damping);
  }
  // NaN where either lies beyond the end of a table.
  [[nodiscard]] double peak() const { return larger(ground_.peak_ground_acceleration(), of_mode_); }
  // Displacement demand of a part with this damping.
  [[nodiscard]] double displacement(double T, double damping) const {
    return larger(of_ground(T, damping), of_mode_ == 0 ? 0 : at_height(T, damping));
  }

 private:
  [[nodiscard]] static double larger(double a, double b) {
    return std::isnan(a) || std::isnan(b) ? kUnset : std::max(a, b);
  }
  [[nodiscard]] static double squared(double T) {
    return (T / (2 * std::numbers::pi)) * (T / (2 * std::numbers::pi));
  }
  // A table has its own damping, so the part's does not count.
  [[nodiscard]] double of_ground(double T, double damping) const {
    if (ground_.kind == SpectrumKind::kTable) return most_of_table(ground_, T);
    SpectrumSpec of_part = given_;
    of_part.damping = damping;
    return spectrum_of(of_part).displacement(T);
  }
  [[nodiscard]] double at_height(double T, double damping) const {
    const double low = kFrom * at_.period, high = kTo * at_.period;
    const double gain = gain_ * study::eta_of(damping);
    double share = 1;
    if (T < low) share = 1 + (gain - 1) * std::pow(1 - T / low, 1.6);
    if (T > high) share = 1 + (gain - 1) * std::pow(T / high - 1, 1.2);
    const double asked = gain * of_mode_ / share * squared(T);
    return T > high ? std::max(asked, gain * of_mode_ * squared(high)) : asked;  // [C8.7.1.12]
  }

  const SpectrumSpec& given_;
  ElasticSpectrum ground_;
  BuildingAt at_;
  double of_mode_ = 0, gain_ = 1;
};

AssessmentVerdict verdict_of(double ratio) {
  if (std::isnan(ratio)) return AssessmentVerdict::kNotKnown;
  return ratio >= 1 ? AssessmentVerdict::kHolds : AssessmentVerdict::kFails;
}

// Limit displacement of a part at a limit state (21.12), and its period there (21.13).
void check_displacement(const SpectrumAt& spectrum, const Way& way, double most,
                        const LocalCheck& part, LocalStateCheck& s) {
  const double d0 = part.capacity.displacement0, a0 = part.acceleration0_to_end;
  if (!(d0 > 0) || !(a0 > 0)) return;
  s.displacement = std::min(way.of_d0 * d0, most);
  s.period = way.period * std::sqrt(s.displacement / (a0 * (1 - s.displacement / d0)));
  s.displacement_demand = spectrum.displacement(s.period, way.damping);
  s.displacement_ratio = s.displacement / s.displacement_demand;
}

// A part high in the building with nothing on it vibrates by itself, so it is not rigid up to its onset (C8.7.1.2.1.5).
bool is_free(const LocalCheck& part) {
  return part.building.share() > 0 && part.floors == 0 && std::isnan(part.hinge);
}

LocalStateCheck check_state(const AssessmentSpec& spec, LimitState state, const LocalCheck& part) {
  LocalStateCheck s;
  s.state = state;
  const SpectrumSpec& given = spectrum_for(spec, state);
  const double damping = given.kind == SpectrumKind::kTable ? 0.05 : given.damping;
  if (!(damping > 0) && part.building.share() > 0)
    throw InputError({{.path = "assessment.spectrum.damping",
                       .value = "0",
                       .problem = "without damping the building brings its part into resonance "
                                  "without end, and (21.10) has no value",
                       .cure = "write damping = 0.05"}});
  const SpectrumAt spectrum(given, part.building, damping);
  s.ground_demand = spectrum_of(given).peak_ground_acceleration();
  s.demand = spectrum.peak();
  if (state != LimitState::kNearCollapse) {
    s.q = state == LimitState::kLifeSafety ? kBehaviour : 1;
    s.q_ratio = std::max(part.acceleration0, 0.0) * s.q / s.demand;  // (21.11)
  }
  const LocalCapacity& c = part.capacity;
  if (state == LimitState::kLifeSafety)
    check_displacement(spectrum, kLifeSafety, std::min(c.slides_off, c.lets_go), part, s);
  if (state == LimitState::kNearCollapse)
    check_displacement(spectrum, kNearCollapse, c.slides_off, part, s);
  // where known, the displacement decides, as it says more than the onset with q; below its onset a part does not move
  const double onset = part.acceleration0 / s.demand;
  s.by_onset = std::isfinite(s.displacement) && !is_free(part) && onset > s.displacement_ratio;
  const double by_way = s.by_onset ? onset : s.displacement_ratio;
  const double ratio = std::isnan(s.displacement) ? s.q_ratio : by_way;
  s.verdict = part.acceleration0 > 0 ? verdict_of(ratio) : AssessmentVerdict::kFails;
  s.acceleration = part.acceleration0 > 0 ? ratio * s.ground_demand : 0;
  return s;
}

// Factor that divides the onset. If the line of rotation lies at the face, as if masonry
// had infinite strength, codes take the factor of the lowest knowledge level.
void find_factor(const AssessmentSpec& spec, bool crushes, LocalCheck& part) {
  const bool is_stated = std::isfinite(spec.confidence_factor);
  if (!crushes) {
    part.confidence_factor = std::max(kFactorLeastKnown, is_stated ? spec.confidence_factor : 1.0);
    part.notes.push_back({"local.note.factor", {{"factor", part.confidence_factor}}});
    return;
  }
  part.confidence_factor = is_stated ? spec.confidence_factor : 1;
  if (!is_stated) part.cautions.push_back({"local.caution.factor"});
}

void find_building(const ModelSpec& spec, const Model& model, LocalCheck& part) {
  const BuildingSpec& given = spec.assessment.building;
  double top = 0;
  for (const BlockId b : study::moving_blocks(model))
    top = std::max(top, study::extent_of(model, b).high - study::foot_of(model));
  BuildingAt& at = part.building;
  at.height += given.base;
  at.top = std::isfinite(given.height) ? given.height : given.base + top;
  constexpr double kHigher = 1.2;  // than the model: the rest may lie below it
  if (given.base == 0 && at.top > kHigher * top)
    part.notes.push_back({"local.note.base", {{"top_m", at.top}, {"model_m", top}}});
  at.storeys = given.storeys > 0 ? given.storeys
                                 : std::max(1, static_cast<int>(model.anatomy.storey_name.size()));
  at.period = std::isfinite(given.period) ? given.period : 0.05 * std::pow(at.top, 0.75);
  if (!(at.height > 1e-6)) {
    at.height = 0;
    return;
  }
  if (at.top < at.height)
    part.cautions.push_back(
        {"local.caution.building", {{"height_m", at.top}, {"part_m", at.height}}});
  part.notes.push_back(
      {std::isfinite(given.period) ? "local.note.height" : "local.note.height_by_rule",
       {{"height_m", at.height},
        {"top_m", at.top},
        {"period_s", at.period},
        {"storeys", at.storeys},
        {"share", at.share()}}});
}

Message sentence_of(const LocalCheck& part) {
  const LocalStateCheck* s = part.deciding();
  const Message who = as_text(part.name);
  if (!(part.capacity.alpha0 > 0))
    return {"local.falls_by_itself", {{"part", who}, {"alpha0", part.capacity.alpha0}}};
  if (s == nullptr)
    return {"local.no_demand",
            {{"part", who},
             {"alpha0", part.capacity.alpha0},
             {"a0_g", part.acceleration0 / kStandardGravity}}};
  if (s->verdict == AssessmentVerdict::kNotKnown)
    return {"local.not_known", {{"part", who}, {"alpha0", part.capacity.alpha0}}};
  const bool by_way = std::isfinite(s->displacement) && !s->by_onset;
  const bool holds = s->verdict == AssessmentVerdict::kHolds;
  return {holds ? (by_way ? "local.holds_by_way" : "local.holds_by_q")
                : (by_way ? "local.fails_by_way" : "local.fails_by_q"),
          {{"part", who},
           {"state", study::words_of_state(s->state)},
           {"ratio", by_way        ? s->displacement_ratio
                     : s->by_onset ? s->acceleration / s->ground_demand
                                   : s->q_ratio},
           {"pga_g", s->acceleration / kStandardGravity},
           {"demand_g", s->ground_demand / kStandardGravity}}};
}

void say(LocalCheck& part) {
  part.may_be_signed = part.cautions.empty() && part.deciding() != nullptr &&
                       part.verdict != AssessmentVerdict::kNotKnown;
  part.sentence = sentence_of(part);
  if (!part.beside.empty())
    part.sentence = {"local.beside", {{"verdict", part.sentence}, {"weaker", part.beside}}};
  if (!part.cautions.empty())
    part.sentence = {"local.unsigned", {{"cautions", part.cautions}, {"verdict", part.sentence}}};
}

}  // namespace

// Failed states come first, then states without an answer, then states that hold; among equals, the smallest reserve.
const LocalStateCheck* LocalCheck::deciding() const {
  const auto rank = [](const LocalStateCheck& s) {
    if (s.verdict == AssessmentVerdict::kFails) return 0;
    return s.verdict == AssessmentVerdict::kNotKnown ? 1 : 2;
  };
  const LocalStateCheck* least = nullptr;
  for (const LocalStateCheck& s : states)
    if (least == nullptr || rank(s) < rank(*least) ||
        (rank(s) == rank(*least) &&
         s.acceleration / s.ground_demand < least->acceleration / least->ground_demand))
      least = &s;
  return least;
}

double LocalCheck::reserve() const {
  if (!(capacity.alpha0 > 0)) return verdict == AssessmentVerdict::kFails ? 0 : kUnset;
  const LocalStateCheck* state = deciding();
  return state == nullptr ? kUnset
                          : std::fmin(state->acceleration / state->ground_demand, reserve_beside);
}

namespace {

// Takes the curve and checks the limit states that are asked for.
void check_curve(const AssessmentSpec& asked, double g, const LocalCapacity& curve,
                 LocalCheck& part) {
  part.capacity = curve;
  const auto acceleration = [&](double alpha) {  // (21.8)
    const double share = part.capacity.is_one_body ? part.capacity.mass_share : 1;
    return alpha * g / (share * part.confidence_factor);
  };
  part.acceleration0 = acceleration(part.capacity.alpha0);
  part.acceleration0_to_end = acceleration(part.capacity.alpha0_to_end);
  part.states.clear();
  for (const LimitState state :
       {LimitState::kDamageLimitation, LimitState::kLifeSafety, LimitState::kNearCollapse})
    if (is_asked(asked) && is_checked(asked, state))
      part.states.push_back(check_state(asked, state, part));
  const LocalStateCheck* least = part.deciding();
  part.verdict = least != nullptr ? least->verdict : AssessmentVerdict::kNoDemand;
  if (!(part.capacity.alpha0 > 0)) part.verdict = AssessmentVerdict::kFails;
}

// Whether a curve says more of the same part. Each is on the safe side, so the best one counts: what holds before what is not
// known, and that before what fails.
bool is_better(const LocalCheck& a, const LocalCheck& b) {
  const auto rank = [](const LocalCheck& c) {
    if (c.verdict == AssessmentVerdict::kFails) return 0;
    return c.verdict == AssessmentVerdict::kHolds ? 2 : 1;
  };
  if (rank(a) != rank(b)) return rank(a) > rank(b);
  const double mine = a.reserve(), others = b.reserve();
  if (!std::isnan(mine) && !std::isnan(others) && mine != others) return mine > others;
  const auto way = [](const LocalCapacity& c) {
    return c.no_displacement.empty() ? c.displacement0 : HUGE_VAL;
  };
  return way(a.capacity) > way(b.capacity);
}

}  // namespace

void study::conclude(const ModelSpec& spec, const Model& model, bool crushes,
                     const std::vector<LocalCapacity>& curves, LocalCheck& part) {
  const AssessmentSpec& asked = spec.assessment;
  find_factor(asked, crushes, part);
  find_building(spec, model, part);
  LocalCheck other = part;
  check_curve(asked, model.solve.gravity, curves.front(), part);
  for (std::size_t k = 1; k < curves.size(); ++k) {
    check_curve(asked, model.solve.gravity, curves[k], other);
    if (is_better(other, part)) part = other;
  }
  if (!part.capacity.no_displacement.empty()) part.notes.push_back(part.capacity.no_displacement);
  if (std::isfinite(part.capacity.slides_off) &&
      part.capacity.slides_off < kLifeSafety.of_d0 * part.capacity.displacement0)
    part.notes.push_back(
        {"local.note.slides_off", {{"displacement_mm", 1e3 * part.capacity.slides_off}}});
  if (part.capacity.lets_go < kLifeSafety.of_d0 * part.capacity.displacement0)
    part.notes.push_back(
        {"local.note.lets_go", {{"displacement_mm", 1e3 * part.capacity.lets_go}}});
  else if (std::isfinite(part.capacity.without_holds_from))
    part.notes.push_back(
        {"local.note.holds_short", {{"displacement_mm", 1e3 * part.capacity.without_holds_from}}});
  if (part.capacity.ends_with_hold)
    part.notes.push_back(
        {"local.note.ends_with_hold", {{"displacement_mm", 1e3 * part.capacity.displacement0}}});
  if (!part.capacity.is_one_body)
    part.notes.push_back({"local.note.share", {{"share", part.capacity.mass_share}}});
  if (value_of(kAssessmentCodeWords, asked.code) == AssessmentCode::kEn1998)
    part.notes.push_back({"local.note.italian"});
  if (!(part.capacity.alpha0 > 0)) part.cautions.push_back({"local.caution.falls"});
  if (part.capacity.alpha0 > 0 && part.capacity.alpha0_to_end <= 0)
    part.cautions.push_back({"local.caution.stands_by_holds"});
  const bool any_by_onset =
      std::any_of(part.states.begin(), part.states.end(),
                  [](const LocalStateCheck& s) { return std::isnan(s.displacement); });
  // an onset that hangs on what holds it says nothing of the way after that has let go
  constexpr double kMost = 0.5;  // of the onset
  const double bare = curves.back().alpha0_to_end;
  for (const LocalStateCheck& s : part.states)
    if (s.by_onset && s.verdict == AssessmentVerdict::kHolds && s.displacement_ratio < 1 &&
        bare < kMost * part.capacity.alpha0) {
      part.cautions.push_back({"local.caution.held_onset", {{"ratio", s.displacement_ratio}}});
      break;
    }
  if (is_free(part) && any_by_onset) part.cautions.push_back({"local.caution.free"});
  for (const LocalStateCheck& s : part.states)
    if (s.verdict == AssessmentVerdict::kNotKnown) {
      part.cautions.push_back({"local.caution.not_known"});
      break;
    }
  say(part);
}

void study::add_weaker(Message weaker, double reserve, bool holds, LocalCheck& part) {
  part.reserve_beside = reserve;
  if (holds)
    part.beside = std::move(weaker);
  else
    part.cautions.push_back(std::move(weaker));
  say(part);
}

// Whether rules may look for parts: a body force across the wall has its own mechanism.
static bool is_pushed_or_alone(const Model& model) {
  const Stage* grows = limit::growing_stage(model);
  return grows == nullptr || grows->push() != nullptr;
}

bool has_parts(const ModelSpec& spec, const Model& model) {
  if (dimension_of(model) == 3) return false;
  return !spec.assessment.part.empty() || is_pushed_or_alone(model);
}

namespace {

template <class Answer>
bool attempt(SecondOpinion& opinion, const Message& what, Answer answer) {
  try {
    opinion.local.push_back(answer());
    return true;
  } catch (const InputError& error) {
    opinion.refused.push_back({what, error.what()});
    return false;
  }
}

// Returns the parts that were checked.
std::vector<PartSpec> check_parts(const ModelSpec& spec, const Model& model,
                                  std::vector<PartSpec> parts, bool are_found,
                                  SecondOpinion& opinion) {
  std::vector<PartSpec> checked;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    PartSpec& part = parts[k];
    if (part.name.empty()) part.name = "part " + std::to_string(k + 1);
    const std::string path = are_found ? "wall" : "assessment.part." + part.name;
    const Message what = {are_found ? "local.part_found" : "local.part", {{"name", part.name}}};
    if (attempt(opinion, what, [&] {
          LocalCheck check = study::check_of_part(spec, model, part, path);
          if (are_found) check.by = "found";
          return check;
        }))
      checked.push_back(part);
  }
  return checked;
}

}  // namespace

void add_local_checks(const ModelSpec& spec, const Model& model, bool asks_for_parts,
                      SecondOpinion& opinion) {
  if (asks_for_parts && has_parts(spec, model)) {
    const std::vector<PartSpec> named =
        check_parts(spec, model, spec.assessment.part, false, opinion);
    if (is_pushed_or_alone(model))
      check_parts(spec, model, study::found_parts(spec, model, named), true, opinion);
  } else if (asks_for_parts && !spec.assessment.part.empty()) {
    opinion.refused.push_back({{"local.parts"}, text_of(Message{"local.parts_in_space"})});
  }
  const Stage* grows = limit::growing_stage(model);
  if (grows == nullptr || grows->spec.kind() != StageKind::kBodyForce) return;
  const NamedLimit* of = nullptr;
  for (const NamedLimit& limit : opinion.limits) {
    const LimitOptions& o = limit.answer.options;
    const bool is_dry = o.strength == JointStrength::kDry && o.crushing == CrushingChoice::kNone;
    if (is_dry && (of == nullptr || o.loads_are_masses)) of = &limit;
  }
  if (of == nullptr) return;
  attempt(opinion, {"local.part", {{"name", grows->spec.name}}},
          [&] { return study::check_of_limit(spec, model, *of); });
}

}  // namespace wythe
