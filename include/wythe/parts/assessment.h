// The assessment of a pushed wall by a code: what an earthquake asks of it, and what it has.
//
//   curve ──► limit states (force drop, drift) ──► bilinear curve ──► one degree of freedom (N2)
//   [assessment.spectrum] ──► elastic spectrum ──► demand, and the acceleration of each limit state
//
// Equations, clauses and what is not in them: docs/theory/assessment.md. SI units; NaN: not known.
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

inline constexpr double kStandardGravity = 9.81;  // what codes mean by g [m/s^2]

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

// Elastic response spectrum of accelerations, horizontal.
struct ElasticSpectrum {
  SpectrumKind kind = SpectrumKind::kNone;
  double ground_acceleration = kUnset;           // ag on rock; of a table that at period 0 [m/s^2]
  double soil = 1, topography = 1;               // S or SS, ST [-]
  double eta = 1;                                // of the damping [-]
  double amplification = 2.5;                    // of the plateau over ag S [-]
  double TB = kUnset, TC = kUnset, TD = kUnset;  // corner periods [s]
  std::vector<double> periods, accelerations;    // table
  // Se(T) [m/s^2]. NaN beyond the end of a table, and where there is no spectrum.
  [[nodiscard]] double acceleration(double period) const;
  [[nodiscard]] double displacement(double period) const;  // Se T^2 / (4 pi^2) [m]
  [[nodiscard]] double peak_ground_acceleration() const;   // Se(0) [m/s^2]
  [[nodiscard]] bool is_given() const { return kind != SpectrumKind::kNone; }
};
[[nodiscard]] ElasticSpectrum spectrum_of(const SpectrumSpec& spec);
// The spectrum that a limit state is compared with: its own, else that of the asked one.
[[nodiscard]] const SpectrumSpec& spectrum_for(const AssessmentSpec& spec, LimitState state);
// Whether the spectrum is of this limit state's own return period, so that its verdict counts.
[[nodiscard]] bool is_checked(const AssessmentSpec& spec, LimitState state);
// What keys lack or hold that can't be; paths are the keys of [assessment.spectrum] and [assessment]. The
// functions below take specs without faults.
[[nodiscard]] std::vector<Fault> faults_of(const SpectrumSpec& spec);
[[nodiscard]] std::vector<Fault> faults_of(const AssessmentSpec& spec);

// --- one degree of freedom ---------------------------------------------------------------------------

// Elastic, perfectly plastic: F* up to d* yield with the slope k.
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
// N2, EN 1998-1 Annex B.5, of the spectrum times `scale`.
[[nodiscard]] SpectralDemand demand_of(const EquivalentSystem& system,
                                       const ElasticSpectrum& spectrum, double scale = 1);
// The scale at which that demand is d*: the inverse of demand_of, in closed form.
[[nodiscard]] double scale_for(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                               double displacement);
// The scale at which q* is q.
[[nodiscard]] double scale_for_q(const EquivalentSystem& system, const ElasticSpectrum& spectrum,
                                 double q);

// --- mass and shape ----------------------------------------------------------------------------------

struct MassAndShape {
  double blocks = 0, loads = 0, added = 0;  // mass by where it comes from [kg]
  double participating = 0;                 // m* = sum m Phi [kg]
  double participation = 0;                 // Gamma = m* / sum m Phi^2 [-]
  bool is_linear = false;                   // Phi grows with height; else as the wall was bent
  double read_at = kUnset;                  // displacement of that state [m]
  [[nodiscard]] double total() const { return blocks + loads + added; }
};
// Phi as the wall stood when its control displacement was `displacement`, straight between the states
// read; `read_at` is NaN where they do not reach so far.
[[nodiscard]] MassAndShape mass_and_shape(const PushedWall& wall, double displacement);
// Phi grows with height, 1 where the curve's displacement is of.
[[nodiscard]] MassAndShape mass_and_linear_shape(const AssessmentSpec& spec, const Model& model);

// --- limit states ------------------------------------------------------------------------------------

// One rule of a code that ends a limit state.
struct Criterion {
  std::string name;       // "force drop", "storey drift", "share of near collapse", "yield", "q*"
  Message words;          // for a reader
  std::string clause;     // where it stands in the code
  bool verified = false;  // checked against the printed clause
  double value = kUnset;  // of the rule, in `unit`
  std::string unit;
  double displacement =
      kUnset;            // of the control point where it is met; the last, where it isn't [m]
  bool reached = false;  // within the push
};
enum class AssessmentVerdict { kHolds, kFails, kNotShown, kNoDemand, kNotKnown };
inline constexpr Word<AssessmentVerdict> kAssessmentVerdictWords[] = {
    {"holds", AssessmentVerdict::kHolds},
    {"fails", AssessmentVerdict::kFails},
    {"not shown", AssessmentVerdict::kNotShown},  // a lower bound that is below the demand
    {"no demand", AssessmentVerdict::kNoDemand},  // no spectrum is given
    {"not known", AssessmentVerdict::kNotKnown}};

struct LimitStateCheck {
  LimitState state = LimitState::kNearCollapse;
  bool is_asked = false;    // `limit_state` of the model
  bool is_checked = false;  // it has a spectrum of its own, and a verdict
  AssessmentVerdict verdict = AssessmentVerdict::kNoDemand;
  double demand_acceleration = kUnset;  // peak ground acceleration of its spectrum [m/s^2]
  double demand_displacement = kUnset;  // of the control point [m]
  double q = kUnset;                    // q* of its demand [-]
  std::vector<Criterion> criteria = {};
  std::string governing = {};         // name of the criterion that decides
  double displacement = kUnset;       // capacity of the control point [m]
  double drift = kUnset;              // over its height [-]
  double ratio = kUnset;              // capacity over demand, displacements [-]
  double scale = kUnset;              // of the spectrum at which the limit state is reached [-]
  double acceleration = kUnset;       // peak ground acceleration then, soil included [m/s^2]
  double rock_acceleration = kUnset;  // the same over S ST [m/s^2]
  bool at_least = false;              // the push ended before: all of these are lower bounds
  // `acceleration` if the force fell where it did in tested walls that failed alike: at the least and the largest drift
  // of nine in ten. Infinite: beyond the push. NaN: no tests, or no number [m/s^2].
  double tested_low = kUnset, tested_high = kUnset;
};

// Drifts at which tested walls had lost a fifth of their force, by how they failed.
struct DriftOfTests {
  std::string mechanism;  // "shear", "flexure"
  bool stone = false;     // stone walls; else brick and block
  int walls = 0;
  double low = kUnset, high = kUnset;  // nine in ten lie between [-]
};

struct CodeAssessment {
  AssessmentVerdict verdict = AssessmentVerdict::kNotKnown;
  bool may_be_signed = false;     // nothing stands in `cautions`
  std::vector<Message> cautions;  // why the numbers are not to be signed; said before them
  Message reason;                 // why there are no numbers; empty: there are
  Message sentence;               // cautions and verdict, for a reader
  std::vector<Message> notes;     // what was assumed and what is not modelled
  AssessmentSpec spec;
  MassAndShape mass;
  Bilinear bilinear;  // of the curve up to near collapse; its ultimate is that displacement
  EquivalentSystem system;
  ElasticSpectrum spectrum;
  SpectralDemand demand;
  double demand_displacement = kUnset;  // Gamma d*max, of the control point [m]
  std::vector<LimitStateCheck> limit_states;
  std::vector<DriftOfTests> tests;  // behind tested_low and tested_high
  [[nodiscard]] const LimitStateCheck* asked() const;
  [[nodiscard]] const LimitStateCheck* at(LimitState state) const;  // null: not looked at
  // The limit state whose verdict is that of the wall: of those checked the one with the least reserve, one that fails
  // before a lower bound; where none is, the asked one.
  [[nodiscard]] const LimitStateCheck* deciding() const;
};

// What is judged of a push: of a run or of a stored sample.
struct JudgedPush {
  SolveStatus status = SolveStatus::kCompleted;
  StageKind curve_of = StageKind::kPush;
  bool is_horizontal = true;
  bool is_patterned = true;  // forces at several levels; false: at one place
  const std::vector<CurveRow>& curve;
  const Responses& responses;
  std::string judgement = {};           // RateVerdict::judgement
  SlowPushVerdict displacement = {};    // that of a slow push
  SlowPushVerdict mode = {};            // the same
  double overlap_lost = kUnset;         // Validity::overlap_lost [m]
  std::vector<RisePoint> rise = {};     // Result::rise
  std::vector<DriftPoint> drifts = {};  // ascending; empty: displacement over load height
  bool storeys_known = false;           // drifts are of storeys
  std::vector<PierDrift> piers = {};    // where they are known they stand for the storeys
  double pier_slenderness = kUnset;     // least H0 / D of the piers [-]
  std::string mechanism = {};           // "shear", "flexure", "": not known
  double mechanism_from = 0;            // displacement of the state that shows it [m]
  std::vector<DriftOfTests> tests = {};
  Message barred = {};                 // why the model's stages allow no answer; empty: they do
  std::vector<Message> cautions = {};  // of the model itself: why numbers are not to be signed
  // Strengths that the file does not state, so that nobody has divided them by the confidence factor.
  std::vector<Message> undivided = {};
  // The knowledge level by which the program divided the typology's strengths, "LC1"; "": it did not.
  std::string knowledge_level = {};
};
// Mass and shape at a displacement; called with that of the bilinear curve's yield.
using ShapeReader = std::function<MassAndShape(double displacement)>;
[[nodiscard]] CodeAssessment assess(const AssessmentSpec& spec, const JudgedPush& push,
                                    const ShapeReader& shape);

// --- a campaign

struct CampaignAssessment;  // wythe/parts/statistics.h
// Why none of its numbers is to be signed: the first of its notes, as far as they are cautions.
[[nodiscard]] std::vector<Message> cautions_of(const CampaignAssessment& assessment);
// These, then what was found or why nothing was, for a reader.
[[nodiscard]] Message sentence_of(const CampaignAssessment& assessment);

[[nodiscard]] inline bool is_asked(const AssessmentSpec& spec) { return !spec.code.empty(); }
// What the assessment reads of the states of a run, once; with the masses that `spec` asks to count.
[[nodiscard]] PushedWall read_pushed_wall(const ModelSpec& spec, const Model& model,
                                          const Result& result);
// Of a run, with what its model file asks for; from Result::pushed where that was read.
[[nodiscard]] CodeAssessment assess_run(const ModelSpec& spec, const Model& model,
                                        const Result& result);

// --- ways of pushing (docs/theory/assessment.md, "The verdict from many walls") --------------------------

// A direction and a pattern of forces that the verdict asks for, and the settings that make a model push so.
struct PushWay {
  std::string direction;  // "+x", "[1, 0, -1]"
  std::string pattern;    // word of Pattern, or "at": at the place that the file names
  std::vector<std::string> settings =
      {};  // "path=value", as for --set; none: the model as it stands
};
struct PushWays {
  std::vector<PushWay> ways;      // the model's own first
  std::vector<Message> cautions;  // what codes ask for and this model does not allow
  std::vector<Message> notes;
};
// The way a model pushes now.
[[nodiscard]] PushWay way_of(const ModelSpec& spec);
// Those that the verdict asks for: both directions, in two patterns where they differ. Throws InputError where the
// model has nothing to judge or nothing to judge it by; its faults name keys, not lines.
[[nodiscard]] PushWays ways_of(const ModelSpec& spec, const Model& model);
// In words: "forces by mass times height".
[[nodiscard]] Message words_of_pattern(const std::string& pattern);

}  // namespace wythe
