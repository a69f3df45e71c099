// Assessment of a pushed wall by a code: the demand of an earthquake against the capacity of the wall.
//
//   curve ──► limit states (force drop, drift) ──► bilinear curve ──► one degree of freedom (N2)
//   [assessment.spectrum] ──► elastic spectrum ──► demand, and the acceleration of each limit state
//
// Equations, clauses and limits: docs/theory/assessment.md. All numbers are SI; NaN means not known.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/pushed_wall.h"
#include "wythe/parts/result.h"
#include "wythe/parts/slow_push.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

inline constexpr double kStandardGravity = 9.81;  // the value of g in codes [m/s^2]

// --- words of [assessment] ---------------------------------------------------------------------------

enum class GroundType { kA, kB, kC, kD, kE };
inline constexpr Word<GroundType> kGroundTypeWords[] = {{"A", GroundType::kA},
                                                        {"B", GroundType::kB},
                                                        {"C", GroundType::kC},
                                                        {"D", GroundType::kD},
                                                        {"E", GroundType::kE}};
enum class AssessmentCode { kCircolare2019, kEn1998 };
inline constexpr Word<AssessmentCode> kAssessmentCodeWords[] = {
    {"circolare_2019", AssessmentCode::kCircolare2019}, {"en1998_3", AssessmentCode::kEn1998}};
enum class LimitState { kDamageLimitation, kLifeSafety, kNearCollapse, kOperational };
inline constexpr Word<LimitState> kLimitStateWords[] = {
    {"damage_limitation", LimitState::kDamageLimitation},
    {"life_safety", LimitState::kLifeSafety},
    {"near_collapse", LimitState::kNearCollapse},
    {"operational", LimitState::kOperational}};

// --- demand ------------------------------------------------------------------------------------------

// Elastic response spectrum Se(T) of horizontal accelerations: parametric (EN 1998-1, NTC 2018) or a table.
struct ElasticSpectrum {
  SpectrumKind kind = SpectrumKind::kNone;
  double ground_acceleration = kUnset;           // ag on rock; of a table Se(0) [m/s^2]
  double soil = 1, topography = 1;               // S or SS, ST [-]
  double eta = 1;                                // damping correction factor [-]
  double amplification = 2.5;                    // of the plateau over ag S [-]
  double TB = kUnset, TC = kUnset, TD = kUnset;  // corner periods [s]
  std::vector<double> periods, accelerations;    // table
  // Se(T) [m/s^2]. NaN beyond the end of a table, and where no spectrum is given.
  [[nodiscard]] double acceleration(double period) const;
  [[nodiscard]] double displacement(double period) const;  // Se T^2 / (4 pi^2) [m]
  [[nodiscard]] double peak_ground_acceleration() const;   // Se(0) [m/s^2]
  [[nodiscard]] bool is_given() const { return kind != SpectrumKind::kNone; }
};
[[nodiscard]] ElasticSpectrum spectrum_of(const SpectrumSpec& spec);  // of a spec without faults
// The spectrum for a limit state: its own, else that of the limit state which the model asks for.
[[nodiscard]] const SpectrumSpec& spectrum_for(const AssessmentSpec& spec, LimitState state);
// Whether the spectrum belongs to the return period of this limit state; only then does the verdict count.
[[nodiscard]] bool is_checked(const AssessmentSpec& spec, LimitState state);
// Missing and inadmissible keys; paths are those of [assessment.spectrum] and [assessment]. The functions
// below require specs without faults.
[[nodiscard]] std::vector<Fault> faults_of(const SpectrumSpec& spec);
[[nodiscard]] std::vector<Fault> faults_of(const AssessmentSpec& spec);

// --- one degree of freedom ---------------------------------------------------------------------------

// Elastic-perfectly plastic system: F* = k* d* up to dy*, then F* = Fy*.
struct EquivalentSystem {
  double mass = kUnset;           // m* [kg]
  double participation = kUnset;  // Gamma: d = Gamma d*, F = Gamma F* [-]
  double stiffness = kUnset;      // k* [N/m]
  double force = kUnset;          // Fy* [N]
  [[nodiscard]] double yield() const { return force / stiffness; }  // dy* [m]
  [[nodiscard]] double period() const;                              // T* [s]
};
struct SpectralDemand {
  double elastic = kUnset;       // Sde(T*) [m]
  double q = kUnset;             // q* = Se m* / Fy* [-]
  double displacement = kUnset;  // d*max [m]
};
// Demand by the N2 method (EN 1998-1, Annex B.5) under the spectrum times `scale`.
[[nodiscard]] SpectralDemand demand_of(const EquivalentSystem& system,
                                       const ElasticSpectrum& spectrum, double scale = 1);
// The scale of the spectrum at which the demand equals d* = `displacement` [m]: demand_of() inverted in closed form.
[[nodiscard]] double scale_for(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                               double displacement);
// The scale of the spectrum at which q* equals q.
[[nodiscard]] double scale_for_q(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                                 double q);

// --- mass and shape ----------------------------------------------------------------------------------

struct MassAndShape {
  double blocks = 0, loads = 0, added = 0;  // mass by where it comes from [kg]
  double participating = 0;                 // m* = sum m Phi [kg]
  double participation = 0;                 // Gamma = m* / sum m Phi^2 [-]
  bool is_linear = false;                   // Phi grows with height; else Phi is that of a state
  double read_at = kUnset;                  // displacement of the state that gave Phi [m]
  [[nodiscard]] double total() const { return blocks + loads + added; }
};
// Phi of the state whose control displacement was `displacement` [m], interpolated linearly between stored
// states. `read_at` is NaN where the states end earlier.
[[nodiscard]] MassAndShape mass_and_shape(const PushedWall& wall, double displacement);
// Phi proportional to height, 1 at the control point of the curve's displacement.
[[nodiscard]] MassAndShape mass_and_linear_shape(const AssessmentSpec& spec, const Model& model);

// --- limit states ------------------------------------------------------------------------------------

// One rule of a code that may end a limit state.
struct Criterion {
  std::string name;       // "force drop", "storey drift", "share of near collapse", "yield", "q*"
  Message words;          // the rule in words
  std::string clause;     // its clause in the code
  bool verified = false;  // checked against the printed text of the clause
  double value = kUnset;  // limit that the rule sets, in `unit`
  std::string unit;
  double displacement =
      kUnset;            // of the control point where the rule is met; else its last one [m]
  bool reached = false;  // the rule was met during the push
};
enum class AssessmentVerdict { kHolds, kFails, kNotShown, kNoDemand, kNotKnown };
inline constexpr Word<AssessmentVerdict> kAssessmentVerdictWords[] = {
    {"holds", AssessmentVerdict::kHolds},
    {"fails", AssessmentVerdict::kFails},
    {"not shown", AssessmentVerdict::kNotShown},  // the capacity is a lower bound below the demand
    {"no demand", AssessmentVerdict::kNoDemand},  // no spectrum is given
    {"not known", AssessmentVerdict::kNotKnown}};

struct LimitStateCheck {
  LimitState state = LimitState::kNearCollapse;
  bool is_asked = false;    // the one that `limit_state` of the model names
  bool is_checked = false;  // it has a spectrum of its own, and a verdict
  AssessmentVerdict verdict = AssessmentVerdict::kNoDemand;
  double demand_acceleration = kUnset;  // peak ground acceleration of its spectrum [m/s^2]
  double demand_displacement = kUnset;  // of the control point [m]
  double q = kUnset;                    // q* of its demand [-]
  std::vector<Criterion> criteria = {};
  std::string governing = {};         // name of the criterion that is reached first
  double displacement = kUnset;       // capacity of the control point [m]
  double drift = kUnset;              // displacement over height of the control point [-]
  double ratio = kUnset;              // displacement capacity over demand [-]
  double scale = kUnset;              // of the spectrum that just reaches the limit state [-]
  double acceleration = kUnset;       // peak ground acceleration at that scale, with soil [m/s^2]
  double rock_acceleration = kUnset;  // the same on rock: over S ST [m/s^2]
  bool at_least = false;              // the push ended earlier: all capacities are lower bounds
  // `acceleration` if the force dropped at the least and at the largest drift of tested walls with the same mechanism
  // (nine in ten lie between). Infinite: beyond the push. NaN: no tests, or no number [m/s^2].
  double tested_low = kUnset, tested_high = kUnset;
};

// Drifts at which tested walls had lost a fifth of their force, by mechanism.
struct DriftOfTests {
  std::string mechanism;  // "shear", "flexure"
  bool stone = false;     // stone walls; else brick and block
  int walls = 0;
  double low = kUnset, high = kUnset;  // nine walls of ten lie between [-]
};

struct CodeAssessment {
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  bool may_be_signed = false;     // `cautions` is empty
  std::vector<Message> cautions;  // why the numbers must not be signed; printed before them
  Message reason;                 // why there are no numbers; empty where there are
  Message sentence;               // cautions and verdict, for a reader
  std::vector<Message> notes;     // assumptions, and effects that are not modelled
  AssessmentSpec spec;
  MassAndShape mass;
  Bilinear bilinear;  // of the curve up to near collapse, which is its ultimate displacement
  EquivalentSystem system;
  ElasticSpectrum spectrum;
  SpectralDemand demand;
  double demand_displacement = kUnset;  // Gamma d*max, of the control point [m]
  std::vector<LimitStateCheck> limit_states;
  std::vector<DriftOfTests> tests;                     // source of tested_low and tested_high
  [[nodiscard]] const LimitStateCheck* asked() const;  // null: not checked
  [[nodiscard]] const LimitStateCheck* at(LimitState state) const;  // null where it was not checked
  // The limit state whose verdict counts for the wall. Of those checked it is the one with the least reserve, where a
  // failed check precedes a lower bound. Without a checked one it is the limit state that the model asks for.
  [[nodiscard]] const LimitStateCheck* deciding() const;
};

// All that an assessment reads of one push, of a run or of a stored sample.
struct JudgedPush {
  SolveStatus status = SolveStatus::kCompleted;
  StageKind curve_of = StageKind::kPush;
  bool is_horizontal = true;
  bool is_patterned = true;  // forces at several levels; false: at one place
  const std::vector<CurveRow>& curve;
  const Responses& responses;
  std::string judgement = {};           // RateVerdict::judgement
  SlowPushVerdict displacement = {};    // whether a slower push would tell the same displacement
  SlowPushVerdict mode = {};            // whether a slower push would tell the same failure mode
  double overlap_lost = kUnset;         // Validity::overlap_lost [m]
  std::vector<RisePoint> rise = {};     // Result::rise
  std::vector<DriftPoint> drifts = {};  // ascending; empty: displacement over load height
  bool storeys_known = false;           // drifts are of storeys
  std::vector<PierDrift> piers = {};    // of piers; where known they replace `drifts`
  double pier_slenderness = kUnset;     // least H0 / D of the piers [-]
  std::string mechanism = {};           // "shear", "flexure"; "" where not known
  double mechanism_from = 0;            // displacement of the first state that shows it [m]
  std::vector<DriftOfTests> tests = {};
  Message barred = {};                 // why the model's stages allow no assessment; empty: they do
  std::vector<Message> cautions = {};  // of the model itself: why its numbers must not be signed
  // Strengths that the program chose, since the file does not state them: the confidence factor has not divided them.
  std::vector<Message> undivided = {};
  // The knowledge level, such as "LC1", by which the program divided the typology's strengths; "" where it did not.
  std::string knowledge_level = {};
};
// Mass and shape of the wall at a displacement; the assessment calls it with the yield displacement of the bilinear curve.
using ShapeReader = std::function<MassAndShape(double displacement)>;
[[nodiscard]] CodeAssessment assess(const AssessmentSpec& spec, const JudgedPush& push,
                                    const ShapeReader& shape);

// --- a campaign

struct CampaignAssessment;  // wythe/parts/statistics.h
// Why none of its numbers must be signed: the cautions at the head of its notes.
[[nodiscard]] std::vector<Message> cautions_of(const CampaignAssessment& assessment);
// The cautions, then the result or the reason why there is none.
[[nodiscard]] Message sentence_of(const CampaignAssessment& assessment);

[[nodiscard]] inline bool is_asked(const AssessmentSpec& spec) { return !spec.code.empty(); }
// Reads from the states of a run what an assessment needs, once; it counts the masses that `spec` asks for.
[[nodiscard]] PushedWall read_pushed_wall(const ModelSpec& spec, const Model& model,
                                          const Result& result);
// Assesses a run as its model file asks; uses Result::pushed where it has been read.
[[nodiscard]] CodeAssessment assess_run(const ModelSpec& spec, const Model& model,
                                        const Result& result);

// --- ways of pushing (docs/theory/assessment.md, "The verdict from many walls") --------------------------

// A direction and a load pattern that the verdict asks for, with the settings that make a model push in this way.
struct PushWay {
  std::string direction;  // "+x", "[1, 0, -1]"
  std::string pattern;    // word of Pattern, or "at": at the place that the file names
  std::vector<std::string> settings =
      {};  // "path=value", as for --set; none: the model as it stands
};
struct PushWays {
  std::vector<PushWay> ways;      // the one of the model itself first
  std::vector<Message> cautions;  // what codes ask for but the model does not allow
  std::vector<Message> notes;
};
// The way in which a model pushes as it stands.
[[nodiscard]] PushWay way_of(const ModelSpec& spec);
// All ways that the verdict needs: both directions, and two patterns where these differ. Throws InputError where the
// model has no push or no [assessment] to judge it by; the faults name keys, not lines.
[[nodiscard]] PushWays ways_of(const ModelSpec& spec, const Model& model);
// A pattern in words: "forces by mass times height".
[[nodiscard]] Message words_of_pattern(const std::string& pattern);

}  // namespace wythe
