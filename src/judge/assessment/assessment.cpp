// assess(): from a pushed wall's curve to limit states, and from a spectrum to their demand.
//
//   refuse ──► limit states by force and drift ──► bilinear curve up to near collapse ──► m*, Gamma, T*
//   ──► demand, capacity over demand, acceleration of each limit state ──► verdict and its cautions
//
// docs/theory/assessment.md. What a curve does not show is never estimated: a push
// that ended early gives lower bounds, and a push without a peak gives no number.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "judge/assessment/assessment_parts.h"

namespace wythe {
namespace {

// --- rules of the codes -------------------------------------------------------------------------------

// A drift limit at which a storey's piers have failed. `by_slenderness`: times H0 / D.
struct DriftRule {
  LimitState state;
  const char* mechanism;
  double drift;
  bool by_slenderness;
  const char* clause;
  bool verified;  // checked against a transcription of the printed text (docs/theory/assessment.md)
};
constexpr DriftRule kCircolare[] = {
    {LimitState::kNearCollapse, "shear", 0.005, false, "Circolare 7/2019, C8.7.1.3.1.1", true},
    {LimitState::kNearCollapse, "flexure", 0.010, false, "Circolare 7/2019, C8.7.1.3.1.1", true}};
constexpr DriftRule kEn1998[] = {
    {LimitState::kLifeSafety, "shear", 0.004, false, "EN 1998-3, C.4.3.1", false},
    {LimitState::kLifeSafety, "flexure", 0.008, true, "EN 1998-3, C.4.2.1", false},
    {LimitState::kNearCollapse, "shear", 0.004 * 4 / 3, false, "EN 1998-3, C.4.3.2", false},
    {LimitState::kNearCollapse, "flexure", 0.008 * 4 / 3, true, "EN 1998-3, C.4.2.2", false}};

struct Rules {
  const char *force_drop, *life_safety, *yield;  // clauses
  bool verified;
};
constexpr const char* kOfBuildings = "Circolare 7/2019, C8.7.1.3.1";
constexpr Rules kCircolareClauses = {kOfBuildings, kOfBuildings, kOfBuildings, true};
constexpr Rules kEn1998Clauses = {"EN 1998-3, C.4.1.1", "EN 1998-3, C.4.1.2", "EN 1998-3, C.4.1.3",
                                  false};
constexpr double kForceLeft = 0.8, kShareOfCollapse = 0.75;
// Circolare 7/2019, C8.7.1.3.1: largest q* at life safety and at near collapse. EN 1998-3 has no such limit.
constexpr double kMostQLifeSafety = 3.0, kMostQNearCollapse = 4.0;
constexpr double kOperationalShare = 2.0 / 3;  // of damage limitation, the same clause
// Damage limitation, the same clause: all piers of a storey at their shear strength, but not
// before this share of the largest base shear. A computed force still grows a little after a
// pier has yielded. So a pier counts as at its strength from a share of its largest shear on.
constexpr double kLeastShear = 0.75, kAtStrength = 0.95;

bool is_circolare(const AssessmentSpec& spec) {
  return value_of(kAssessmentCodeWords, spec.code) == AssessmentCode::kCircolare2019;
}

// --- the curve up to a displacement -------------------------------------------------------------------

std::vector<CurveRow> cut_at(const std::vector<CurveRow>& curve, double displacement) {
  std::vector<CurveRow> out;
  for (const CurveRow& row : curve) {
    if (row.displacement < displacement || out.empty()) {
      out.push_back(row);
      continue;
    }
    CurveRow last = row;
    const CurveRow& before = out.back();
    const double share =
        (displacement - before.displacement) / (row.displacement - before.displacement);
    last.displacement = displacement;
    last.reaction = before.reaction + share * (row.reaction - before.reaction);
    last.base_shear = before.base_shear + share * (row.base_shear - before.base_shear);
    out.push_back(last);
    break;
  }
  return out;
}

// --- limit states -------------------------------------------------------------------------------------

// Where the force falls: at the drop on the curve, or at a drift at which it fell in tests.
enum class Falls { kOnCurve, kAtLeastOfTests, kAtMostOfTests };

class Judge {
 public:
  Judge(const AssessmentSpec& spec, const JudgedPush& push, const ShapeReader& shape,
        Falls falls = Falls::kOnCurve)
      : spec_(spec), push_(push), shape_(shape), falls_(falls) {}

  CodeAssessment all() {
    out_.spec = spec_;
    const auto asked = value_of(kLimitStateWords, spec_.limit_state);
    if (asked) out_.spectrum = spectrum_of(spectrum_for(spec_, *asked));
    note_assumptions();
    out_.reason = refusal();
    if (out_.reason.empty()) judge();
    conclude();
    return std::move(out_);
  }

 private:
  // Why this push cannot be assessed; empty if it can.
  [[nodiscard]] Message refusal() const {
    if (push_.curve_of == StageKind::kBodyForce) return {"assessment.of_body_force"};
    if (push_.curve_of == StageKind::kTilt) return {"assessment.of_tilt"};
    if (push_.curve_of != StageKind::kPush || push_.curve.size() < 2)
      return {"assessment.without_push"};
    if (!push_.barred.empty()) return push_.barred;
    if (push_.responses.cyclic.sense != 0) return {"assessment.of_cycles"};
    if (!push_.is_horizontal) return {"assessment.not_horizontal"};
    if (!(push_.responses.peak_reaction > 0))
      return {"assessment.without_peak", {{"why", push_.responses.peak_reason}}};
    if (!(push_.responses.bilinear.stiffness > 0)) return {"assessment.without_stiffness"};
    return {};
  }

  void judge() {
    LimitStateCheck collapse = near_collapse();
    if (collapse.at_least && push_.responses.censored_peak) {
      out_.reason = {"assessment.still_rising",
                     {{"displacement_mm", 1e3 * push_.curve.back().displacement}}};
      return;
    }
    if (!idealise(collapse)) return;
    LimitStateCheck safety = life_safety(collapse);
    LimitStateCheck damage = damage_limitation(collapse);
    if (asks_operational()) out_.limit_states.push_back(operational(damage));
    for (LimitStateCheck* check : {&damage, &safety, &collapse})
      out_.limit_states.push_back(std::move(*check));
    if (out_.spectrum.is_given() && !find_demand()) return;
    for (LimitStateCheck& check : out_.limit_states)
      if (!compare(check)) return;
  }

  [[nodiscard]] bool asks_operational() const {
    return is_circolare(spec_) &&
           (is_checked(spec_, LimitState::kOperational) ||
            value_of(kLimitStateWords, spec_.limit_state) == LimitState::kOperational);
  }

  // A drift limit, and the drift limit of each mechanism.
  struct Rule {
    double drift = 0;
    bool is_shear = true;
    const char* clause = "";
    bool verified = false;
  };
  using RuleOf = std::function<std::optional<Rule>(const std::string& mechanism)>;

  [[nodiscard]] const Rules& clauses() const {
    return is_circolare(spec_) ? kCircolareClauses : kEn1998Clauses;
  }

  LimitStateCheck near_collapse() {
    const Responses& r = push_.responses;
    LimitStateCheck check{.state = LimitState::kNearCollapse};
    Criterion drop{.name = "force drop",
                   .words = {"assessment.force_drop", {{"percent", 100 * (1 - kForceLeft)}}},
                   .clause = clauses().force_drop,
                   .verified = clauses().verified,
                   .value = kForceLeft,
                   .unit = "-",
                   .displacement = r.displacement_at_80,
                   .reached = !r.censored_80};
    if (falls_ != Falls::kOnCurve)
      if (const auto tested =
              first_at([this](const std::string& mechanism) { return rule_of_tests(mechanism); }))
        drop.displacement = tested->displacement, drop.reached = tested->reached;
    check.criteria.push_back(std::move(drop));
    add_drifts(check);
    return decided(std::move(check));
  }

  LimitStateCheck life_safety(const LimitStateCheck& collapse) {
    LimitStateCheck check{.state = LimitState::kLifeSafety};
    // EN 1998-3 takes a share of the global near collapse only; here of the governing one, which is never more
    check.criteria.push_back({.name = "share of near collapse",
                              .words = {"assessment.share_of_collapse"},
                              .clause = clauses().life_safety,
                              .verified = clauses().verified,
                              .value = kShareOfCollapse,
                              .unit = "-",
                              .displacement = kShareOfCollapse * collapse.displacement,
                              .reached = !collapse.at_least});
    add_drifts(check);
    return decided(std::move(check));
  }

  LimitStateCheck damage_limitation(const LimitStateCheck& collapse) {
    LimitStateCheck check{.state = LimitState::kDamageLimitation};
    check.criteria.push_back({.name = "yield",
                              .words = {"assessment.yield"},
                              .clause = clauses().yield,
                              .verified = clauses().verified,
                              .value = 1,
                              .unit = "-",
                              .displacement = out_.bilinear.yield_displacement,
                              .reached = !collapse.at_least});
    if (is_circolare(spec_)) add_strengths(check, collapse);
    return decided(std::move(check));
  }

  // All piers of one storey at their shear strength, at the earliest at three quarters of the base shear.
  void add_strengths(LimitStateCheck& check, const LimitStateCheck& collapse) {
    std::optional<double> first;
    bool known = !push_.piers.empty();
    for (const PierDrift& of : push_.piers) {
      double all = 0;
      for (const PierDrift& pier : push_.piers) {
        if (pier.storey != of.storey) continue;
        const double at = strength_at(pier, collapse.displacement);
        known = known && std::isfinite(at);
        all = std::fmax(all, at);
      }
      if (!first || all < *first) first = all;
    }
    if (!known) {
      out_.notes.push_back({"assessment.note.strengths"});
      return;
    }
    const double floor = rising_to(kLeastShear, collapse.displacement);
    check.criteria.push_back({.name = "shear strength of piers",
                              .words = {"assessment.strength_of_piers"},
                              .clause = kOfBuildings,
                              .verified = true,
                              .value = 1,
                              .unit = "-",
                              .displacement = std::fmax(*first, floor),
                              .reached = !collapse.at_least});
  }
  // Earliest displacement at which the pier can have reached its strength:
  // the last state before it carries it. NaN where no shears are known.
  [[nodiscard]] static double strength_at(const PierDrift& pier, double until) {
    double most = 0;
    for (const DriftPoint& at : pier.drifts) {
      if (std::isnan(at.shear)) return kUnset;
      if (at.displacement <= until) most = std::fmax(most, at.shear);
    }
    double before = 0;
    for (const DriftPoint& at : pier.drifts) {
      if (at.displacement > until || at.shear >= kAtStrength * most) break;
      before = at.displacement;
    }
    return pier.drifts.empty() ? kUnset : before;
  }
  // Displacement at which the curve first carries this share of the largest force up to `until`.
  [[nodiscard]] double rising_to(double share, double until) const {
    double most = 0;
    for (const CurveRow& row : push_.curve)
      if (row.displacement <= until) most = std::fmax(most, row.reaction);
    CurveRow before;
    for (const CurveRow& row : push_.curve) {
      if (row.reaction >= share * most) {
        const double part = (share * most - before.reaction) / (row.reaction - before.reaction);
        return before.displacement + part * (row.displacement - before.displacement);
      }
      before = row;
    }
    return before.displacement;
  }

  LimitStateCheck operational(const LimitStateCheck& damage) {
    LimitStateCheck check{.state = LimitState::kOperational};
    check.criteria.push_back({.name = "share of damage limitation",
                              .words = {"assessment.share_of_damage"},
                              .clause = kOfBuildings,
                              .verified = true,
                              .value = kOperationalShare,
                              .unit = "-",
                              .displacement = kOperationalShare * damage.displacement,
                              .reached = !damage.at_least});
    return decided(std::move(check));
  }

  void add_drifts(LimitStateCheck& check) {
    if (auto first =
            first_at([&](const std::string& mechanism) { return rule_of(check.state, mechanism); }))
      check.criteria.push_back(*std::move(first));
  }

  // The first pier at its limit. Where no piers are known, the storeys or the whole wall.
  [[nodiscard]] std::optional<Criterion> first_at(const RuleOf& rule_of) const {
    if (push_.piers.empty()) return whole_met(rule_of);
    std::optional<Criterion> first;
    for (const PierDrift& pier : push_.piers) {
      const std::optional<Criterion> met = pier_met(rule_of, pier);
      if (!met) continue;
      const bool is_first =
          !first || (met->reached && !first->reached) ||
          (met->reached == first->reached && met->displacement < first->displacement);
      if (is_first) first = met;
    }
    return first;
  }

  // Failure kind of a pier, as far as the states up to this displacement show it.
  [[nodiscard]] static std::string kind_at(const PierDrift& pier, double displacement) {
    if (std::isnan(pier.shear_from) && std::isnan(pier.flexure_from)) return pier.mechanism;
    if (pier.shear_from <= displacement) return "shear";
    return pier.flexure_from <= displacement ? "flexure" : "";
  }

  [[nodiscard]] static std::optional<Criterion> pier_met(const RuleOf& rule_of,
                                                         const PierDrift& pier) {
    return met(
        pier.drifts, [&](double displacement) { return rule_of(kind_at(pier, displacement)); },
        [&](const Rule& rule) { return pier_criterion(rule, pier.mark); });
  }
  [[nodiscard]] std::optional<Criterion> whole_met(const RuleOf& rule_of) const {
    const auto rule_at = [&](double displacement) {
      return rule_of(displacement < push_.mechanism_from ? "" : push_.mechanism);
    };
    if (auto found = met(drifts(), rule_at, whole_criterion)) return found;
    const auto rule = rule_at(0);  // without known drifts no displacement is granted
    if (!rule) return std::nullopt;
    Criterion none = whole_criterion(*rule);
    none.displacement = 0;
    return none;
  }

  // Displacement at which a drift first reaches the limit of its failure kind. The kind is the one known
  // at that displacement, since later states must not decide. Between two states the earlier one counts.
  template <typename RuleAt, typename InWords>
  [[nodiscard]] static std::optional<Criterion> met(const std::vector<DriftPoint>& drifts,
                                                    const RuleAt& rule_at,
                                                    const InWords& in_words) {
    std::optional<Criterion> last;
    DriftPoint before;
    for (const DriftPoint& now : drifts) {
      for (const double known : {before.displacement, now.displacement}) {
        const auto rule = rule_at(known);
        if (!rule) continue;
        last = in_words(*rule);
        last->displacement = now.displacement;
        if (now.drift < rule->drift) continue;
        const bool inside = known < now.displacement && before.drift < rule->drift;
        const double share = inside ? (rule->drift - before.drift) / (now.drift - before.drift) : 1;
        last->displacement = before.displacement + share * (now.displacement - before.displacement);
        last->reached = true;
        return last;
      }
      before = now;
    }
    return last;
  }

  // Warns of a pier that fails in shear beyond a limit state. With that kind known, the limit state would have come earlier.
  void caution_of_kinds(const LimitStateCheck& check, std::vector<Message>& say) const {
    for (const PierDrift& pier : push_.piers) {
      if (!std::isfinite(pier.shear_from) || pier.shear_from <= check.displacement) continue;
      PierDrift sheared = pier;
      sheared.mechanism = "shear", sheared.shear_from = sheared.flexure_from = kUnset;
      const auto then = pier_met(
          [this](const std::string& mechanism) {
            return rule_of(LimitState::kNearCollapse, mechanism);
          },
          sheared);
      if (!then || !then->reached || then->displacement >= check.displacement) continue;
      say.push_back({"assessment.caution.kind_changes",
                     {{"mark", pier.mark},
                      {"from_mm", 1e3 * pier.shear_from},
                      {"displacement_mm", 1e3 * check.displacement},
                      {"then_mm", 1e3 * then->displacement}}});
    }
  }

  // The rule of a mechanism, or the smaller limit where the mechanism is not known.
  [[nodiscard]] std::optional<Rule> rule_of(LimitState state, const std::string& mechanism) const {
    std::optional<Rule> least;
    const auto take = [&](const DriftRule& rule) {
      if (rule.state != state || (!mechanism.empty() && mechanism != rule.mechanism)) return;
      const double drift = rule.drift * (rule.by_slenderness ? push_.pier_slenderness : 1);
      if (!(drift > 0)) return;  // the piers' shape is not known
      if (!least || drift < least->drift)
        least =
            Rule{drift, std::string_view(rule.mechanism) == "shear", rule.clause, rule.verified};
    };
    if (is_circolare(spec_))
      for (const DriftRule& rule : kCircolare) take(rule);
    else
      for (const DriftRule& rule : kEn1998) take(rule);
    return least;
  }
  // Drift of tested walls with this mechanism. Where it is not known, the smallest or largest of all.
  [[nodiscard]] std::optional<Rule> rule_of_tests(const std::string& mechanism) const {
    std::optional<Rule> out;
    for (const DriftOfTests& tests : push_.tests) {
      if (!mechanism.empty() && mechanism != tests.mechanism) continue;
      const bool least = falls_ == Falls::kAtLeastOfTests;
      const double drift = least ? tests.low : tests.high;
      if (!out || (least ? drift < out->drift : drift > out->drift))
        out = Rule{drift, tests.mechanism == "shear", ""};
    }
    return out;
  }
  [[nodiscard]] static Criterion whole_criterion(const Rule& rule) {
    return {.name = rule.is_shear ? "storey drift, shear" : "storey drift, flexure",
            .words = {rule.is_shear ? "assessment.drift_shear" : "assessment.drift_flexure",
                      {{"percent", 100 * rule.drift}}},
            .clause = rule.clause,
            .verified = rule.verified,
            .value = rule.drift,
            .unit = "-"};
  }
  [[nodiscard]] static Criterion pier_criterion(const Rule& rule, const std::string& mark) {
    Criterion c = whole_criterion(rule);
    c.name = rule.is_shear ? "pier drift, shear" : "pier drift, flexure";
    c.words = {rule.is_shear ? "assessment.pier_shear" : "assessment.pier_flexure",
               {{"mark", mark}, {"percent", 100 * rule.drift}}};
    return c;
  }

  // Drifts of storeys where they are known, else the displacement over its height.
  [[nodiscard]] std::vector<DriftPoint> drifts() const {
    if (!push_.drifts.empty()) return push_.drifts;
    const double height = push_.responses.load_height;
    std::vector<DriftPoint> out;
    if (!(height > 0)) return out;
    double furthest = 0;
    for (const CurveRow& row : push_.curve) {
      if (!(row.displacement > furthest)) continue;
      furthest = row.displacement;
      out.push_back({furthest, furthest / height});
    }
    return out;
  }

  // The first criterion that is met decides. If none is met, the limit state lies beyond the end of the push.
  LimitStateCheck decided(LimitStateCheck check) const {
    check.is_asked = value_of(kLimitStateWords, spec_.limit_state) == check.state;
    const Criterion* first = nullptr;
    for (const Criterion& c : check.criteria)
      if (std::isfinite(c.displacement) &&
          (first == nullptr || c.displacement < first->displacement))
        first = &c;
    if (first == nullptr) return check;
    // the end of a push is no criterion: one that is met at the same displacement takes its place
    for (const Criterion& c : check.criteria)
      if (c.reached && c.displacement <= first->displacement) first = &c;
    check.governing = first->name;
    check.displacement = first->displacement;
    check.at_least = !first->reached;
    if (push_.responses.load_height > 0)
      check.drift = check.displacement / push_.responses.load_height;
    return check;
  }

  // The bilinear curve up to near collapse, and the system of one degree of freedom.
  bool idealise(const LimitStateCheck& collapse) {
    const std::vector<CurveRow> curve = cut_at(push_.curve, collapse.displacement);
    std::vector<RisePoint> rise = push_.rise;
    while (rise.size() > 2 && rise.back().displacement > collapse.displacement) rise.pop_back();
    const Responses cut = read_responses(curve, {.rise = rise});
    out_.bilinear = cut.bilinear;
    out_.bilinear.censored = collapse.at_least;
    Bilinear& b = out_.bilinear;
    if (!(b.stiffness > 0) || !(b.force > 0)) return fails({"assessment.without_bilinear"});
    // the curve beyond the push may still lower the equivalent force; 0.8 peak is its lower bound
    if (collapse.at_least && b.force > kForceLeft * cut.peak_reaction) {
      b.force = kForceLeft * cut.peak_reaction;
      b.yield_displacement = b.force / b.stiffness;
      b.ductility = b.ultimate_displacement / b.yield_displacement;
    }
    out_.mass = shape_(b.yield_displacement);
    const MassAndShape& m = out_.mass;
    if (!(m.participating > 0) || !(m.participation > 0) || !std::isfinite(m.participating))
      return fails({"assessment.without_mass"});
    out_.system = {.mass = m.participating,
                   .participation = m.participation,
                   .stiffness = b.stiffness,
                   .force = b.force / m.participation};
    return true;
  }

  bool fails(Message why) {
    out_.reason = std::move(why);
    return false;
  }

  bool find_demand() {
    out_.demand = demand_of(out_.system, out_.spectrum);
    out_.demand_displacement = out_.system.participation * out_.demand.displacement;
    return std::isfinite(out_.demand.displacement) || beyond(out_.spectrum);
  }
  bool beyond(const ElasticSpectrum& spectrum) {
    return fails({"assessment.period_beyond_table",
                  {{"period_s", out_.system.period()},
                   {"last_s", spectrum.periods.empty() ? kUnset : spectrum.periods.back()}}});
  }

  bool compare(LimitStateCheck& check) {
    const ElasticSpectrum spectrum = spectrum_of(spectrum_for(spec_, check.state));
    if (!spectrum.is_given()) return true;
    const SpectralDemand demand = demand_of(out_.system, spectrum);
    if (!std::isfinite(demand.displacement)) return beyond(spectrum);
    const double equivalent = check.displacement / out_.system.participation;
    check.is_checked = is_checked(spec_, check.state);
    check.q = demand.q;
    check.demand_acceleration = spectrum.peak_ground_acceleration();
    check.demand_displacement = out_.system.participation * demand.displacement;
    check.ratio = check.displacement / check.demand_displacement;
    check.scale = scale_for(out_.system, spectrum, equivalent);
    check.at_least = check.at_least || out_.bilinear.censored;
    if (is_circolare(spec_) && check.state == LimitState::kLifeSafety)
      limit_q(check, spectrum, kMostQLifeSafety);
    if (is_circolare(spec_) && check.state == LimitState::kNearCollapse)
      limit_q(check, spectrum, kMostQNearCollapse);
    check.acceleration = check.scale * spectrum.peak_ground_acceleration();
    check.rock_acceleration = check.scale * spectrum.ground_acceleration;
    if (check.is_checked)
      check.verdict = check.scale >= 1 ? AssessmentVerdict::kHolds
                      : check.at_least ? AssessmentVerdict::kNotShown
                                       : AssessmentVerdict::kFails;
    return true;
  }

  // The capacity counts only up to the demand at which q* reaches this limit, however far the wall goes.
  void limit_q(LimitStateCheck& check, const ElasticSpectrum& spectrum, double most) {
    const double scale = scale_for_q(out_.system, spectrum, most);
    Criterion c{.name = "q*",
                .words = {"assessment.q_limit", {{"q", check.q}, {"limit", most}}},
                .clause = kOfBuildings,
                .verified = true,
                .value = most,
                .unit = "-"};
    const SpectralDemand then = demand_of(out_.system, spectrum, scale);
    c.displacement = out_.system.participation * then.displacement;
    c.reached = scale <= check.scale;
    if (c.reached) check.governing = c.name, check.scale = scale;
    check.criteria.push_back(std::move(c));
  }

  // --- what is said -----------------------------------------------------------------------------------

  // No public text of EN 1998-1 was found, so its spectrum is from memory (docs/theory/assessment.md).
  [[nodiscard]] bool has_recalled_spectrum() const {
    const auto is_recalled = [](const SpectrumSpec& of) {
      return of.kind == SpectrumKind::kEn1998;
    };
    return is_recalled(spec_.spectrum) || is_recalled(spec_.spectra.operational) ||
           is_recalled(spec_.spectra.damage_limitation) || is_recalled(spec_.spectra.life_safety) ||
           is_recalled(spec_.spectra.near_collapse);
  }

  void note_assumptions() {
    out_.notes.push_back({"assessment.note.out_of_plane"});
    out_.notes.push_back({"assessment.note.one_pattern"});
    if (!push_.is_patterned) out_.notes.push_back({"assessment.note.one_place"});
    out_.notes.push_back({"assessment.note.masses"});
    if (!is_circolare(spec_) || has_recalled_spectrum())
      out_.notes.push_back({"assessment.note.clauses"});
    if (std::isnan(spec_.confidence_factor))
      out_.notes.push_back({"assessment.note.no_confidence_factor"});
    else if (is_undivided())
      out_.notes.push_back({"assessment.note.undivided", {{"factor", spec_.confidence_factor}}});
    else if (!push_.knowledge_level.empty())
      out_.notes.push_back(
          {"assessment.note.divided",
           {{"factor", spec_.confidence_factor}, {"level", push_.knowledge_level}}});
    else
      out_.notes.push_back(
          {"assessment.note.confidence_factor", {{"factor", spec_.confidence_factor}}});
    if (out_.spectrum.is_given()) out_.notes.push_back({"assessment.note.scaled"});
    note_oddities();
    if (!push_.piers.empty())
      out_.notes.push_back({"assessment.note.pier_drift"});
    else
      out_.notes.push_back(push_.storeys_known ? Message{"assessment.note.storey_drift"}
                                               : Message{"assessment.note.whole_drift"});
    const auto is_unknown = [](const PierDrift& pier) { return pier.mechanism.empty(); };
    const bool any_unknown = push_.piers.empty()
                                 ? push_.mechanism.empty()
                                 : std::any_of(push_.piers.begin(), push_.piers.end(), is_unknown);
    if (any_unknown) out_.notes.push_back({"assessment.note.no_mechanism"});
  }

  [[nodiscard]] bool is_undivided() const {
    return spec_.confidence_factor > 1 && !push_.undivided.empty();
  }

  // Notes inputs that are possible, but are more often mistakes.
  void note_oddities() {
    const SpectrumSpec& s = spec_.spectrum;
    if (s.kind != SpectrumKind::kTable || s.accelerations.empty()) return;
    const double largest = *std::max_element(s.accelerations.begin(), s.accelerations.end());
    if (s.accelerations.front() <= 0.01 * largest)
      out_.notes.push_back({"assessment.note.table_start",
                            {{"first", s.accelerations.front()}, {"largest", largest}}});
  }

  void collect_cautions() {
    std::vector<Message>& say = out_.cautions;
    say = push_.cautions;
    if (is_undivided())
      say.push_back({"assessment.caution.undivided",
                     {{"factor", spec_.confidence_factor}, {"strengths", push_.undivided}}});
    if (push_.judgement != "slow enough" && push_.judgement != "usable")
      say.push_back(push_.judgement == "too fast" ? Message{"assessment.too_fast"}
                                                  : Message{"assessment.rate_unknown"});
    else
      caution_of_promises();
    if (push_.status != SolveStatus::kCompleted && push_.status != SolveStatus::kCollapsed)
      say.push_back({"assessment.caution.unfinished"});
    const LimitStateCheck* check = out_.deciding();
    if (check == nullptr) return;
    for (const LimitStateCheck& collapse : out_.limit_states)
      if (collapse.state == LimitState::kNearCollapse) caution_of_kinds(collapse, say);
    if (std::fabs(push_.overlap_lost) <= check->displacement)
      say.push_back({"assessment.caution.overlap",
                     {{"displacement_mm", 1e3 * std::fabs(push_.overlap_lost)}}});
    if (check->at_least)
      say.push_back({"assessment.caution.bound",
                     {{"displacement_mm", 1e3 * push_.curve.back().displacement}}});
  }

  // The displacement ends the curve that gives every limit state. The failure mode matters for flexure only: its limits are larger.
  void caution_of_promises() {
    if (push_.displacement.is_missing())
      out_.cautions.push_back({"assessment.caution.drift", {{"why", push_.displacement.reason}}});
    const bool any_flexure =
        push_.mechanism == "flexure" ||
        std::any_of(push_.piers.begin(), push_.piers.end(),
                    [](const PierDrift& pier) { return pier.mechanism == "flexure"; });
    if (any_flexure && push_.mode.is_missing())
      out_.cautions.push_back({"assessment.caution.mode", {{"why", push_.mode.reason}}});
  }

  void conclude() {
    out_.verdict = verdict();
    if (out_.verdict == AssessmentVerdict::kNotKnown) out_.limit_states.clear();
    collect_cautions();
    out_.may_be_signed = out_.cautions.empty() && out_.verdict != AssessmentVerdict::kNotKnown;
    const Message said = verdict_in_words();
    out_.sentence =
        out_.cautions.empty()
            ? said
            : Message{"assessment.unsigned", {{"cautions", out_.cautions}, {"verdict", said}}};
  }
  [[nodiscard]] AssessmentVerdict verdict() const {
    const LimitStateCheck* check = out_.deciding();
    if (!out_.reason.empty() || check == nullptr) return AssessmentVerdict::kNotKnown;
    return check->verdict;
  }
  [[nodiscard]] Message verdict_in_words() const {
    if (out_.verdict == AssessmentVerdict::kNotKnown)
      return {"assessment.not_known", {{"why", out_.reason}}};
    const LimitStateCheck& check = *out_.deciding();
    const Message state = study::words_of_state(check.state);
    if (out_.verdict == AssessmentVerdict::kNoDemand)
      return {check.at_least ? "assessment.no_demand_bound" : "assessment.no_demand",
              {{"state", state}, {"displacement_mm", 1e3 * check.displacement}}};
    return {verdict_code(check),
            {{"state", state},
             {"ratio", check.ratio},
             {"pga_g", check.acceleration / kStandardGravity},
             {"demand_g", check.demand_acceleration / kStandardGravity},
             {"limit",
              check.state == LimitState::kLifeSafety ? kMostQLifeSafety : kMostQNearCollapse}}};
  }
  [[nodiscard]] const char* verdict_code(const LimitStateCheck& check) const {
    if (out_.verdict == AssessmentVerdict::kFails)
      return check.governing == "q*" ? "assessment.fails_by_q" : "assessment.fails";
    if (out_.verdict == AssessmentVerdict::kNotShown) return "assessment.not_shown";
    return check.at_least ? "assessment.holds_bound" : "assessment.holds";
  }

  const AssessmentSpec& spec_;
  const JudgedPush& push_;
  const ShapeReader& shape_;
  const Falls falls_;
  CodeAssessment out_;
};

}  // namespace

const LimitStateCheck* CodeAssessment::asked() const {
  for (const LimitStateCheck& check : limit_states)
    if (check.is_asked) return &check;
  return nullptr;
}

const LimitStateCheck* CodeAssessment::at(LimitState state) const {
  for (const LimitStateCheck& check : limit_states)
    if (check.state == state) return &check;
  return nullptr;
}

const LimitStateCheck* CodeAssessment::deciding() const {
  const LimitStateCheck* least = nullptr;
  const auto goes_before = [](const LimitStateCheck& a, const LimitStateCheck& b) {
    const bool a_fails = a.verdict == AssessmentVerdict::kFails;
    const bool b_fails = b.verdict == AssessmentVerdict::kFails;
    return a_fails != b_fails ? a_fails : a.scale < b.scale;
  };
  for (const LimitStateCheck& check : limit_states)
    if (check.is_checked && (least == nullptr || goes_before(check, *least))) least = &check;
  return least != nullptr ? least : asked();
}

Message study::words_of_state(LimitState state) {
  switch (state) {
    case LimitState::kOperational: return {"assessment.operational"};
    case LimitState::kDamageLimitation: return {"assessment.damage_limitation"};
    case LimitState::kLifeSafety: return {"assessment.life_safety"};
    case LimitState::kNearCollapse: break;
  }
  return {"assessment.near_collapse"};
}

CodeAssessment assess(const AssessmentSpec& spec, const JudgedPush& push,
                      const ShapeReader& shape) {
  CodeAssessment out = Judge(spec, push, shape).all();
  // no drifts are known from tests of walls that leave their plane
  if (push.tests.empty() || out.limit_states.empty() || push.mechanism == study::kOutOfPlane)
    return out;
  out.tests = push.tests;
  const CodeAssessment least = Judge(spec, push, shape, Falls::kAtLeastOfTests).all();
  const CodeAssessment most = Judge(spec, push, shape, Falls::kAtMostOfTests).all();
  for (LimitStateCheck& check : out.limit_states) {
    const LimitStateCheck *low = least.at(check.state), *high = most.at(check.state);
    check.tested_low = low != nullptr ? low->acceleration : 0;
    check.tested_high = high != nullptr && !high->at_least
                            ? high->acceleration
                            : std::numeric_limits<double>::infinity();
  }
  return out;
}

}  // namespace wythe
