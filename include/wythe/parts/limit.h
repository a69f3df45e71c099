// A second opinion on a model without time integration: limit analysis of its blocks, and the
// collapse of three macro-blocks cut from it.
//
//   Model --limit_load()--> LimitResult           largest load that rigid-plastic joints carry, by
//                                                 linear programming; static and kinematic theorem
//   Model --find_portal()--> Portal               two piers, one opening, a spandrel
//   Portal --cut_mechanism()--> Mechanism         FM-1 or FM-4: bodies, hinges, their loads
//   Chain --follow()--> CapacityCurve             force against displacement, down to no force
//   curves of runs --compare()--> Comparison      do they agree
//
// Theory: docs/theory/limit_analysis.md.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "wythe/parts/local_check.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/vector.h"

namespace wythe {

// --- limit analysis of the block model ------------------------------------------------------------

// Strength of joints besides compression and friction.
enum class JointStrength { kDry, kBonded };  // bonded: tension ft and cohesion c
inline constexpr Word<JointStrength> kJointStrengthWords[] = {{"dry", JointStrength::kDry},
                                                              {"bonded", JointStrength::kBonded}};
enum class FrictionChoice { kPeak, kResidual };
inline constexpr Word<FrictionChoice> kFrictionChoiceWords[] = {
    {"peak", FrictionChoice::kPeak}, {"residual", FrictionChoice::kResidual}};
// How crushing limits a joint: not at all; at each contact point by its share of fc A, as
// in the D-RBA; or by a stress block at fc, M <= N l/2 (1 - N/(fc A)).
enum class CrushingChoice { kNone, kPoints, kStressBlock };
inline constexpr Word<CrushingChoice> kCrushingChoiceWords[] = {
    {"none", CrushingChoice::kNone},
    {"contact points", CrushingChoice::kPoints},
    {"stress block", CrushingChoice::kStressBlock}};

// Tolerance of the friction circle in space: relative excess of a shear force [-].
inline constexpr double kFrictionCircle = 1e-4;

struct LimitOptions {
  JointStrength strength = JointStrength::kDry;
  FrictionChoice friction = FrictionChoice::kPeak;
  CrushingChoice crushing = CrushingChoice::kNone;
  bool loads_are_masses = false;  // a body force also acts on masses that press blocks
};

// A limit load. The growing load is the force of the push stage along its direction [N], or
// lambda W on every block (body force and tilt, lambda = tan of the angle) [-].
struct LimitResult {
  LimitOptions options;
  bool is_force = true;
  double load = 0;       // static theorem: largest load in equilibrium within joint strengths
  double kinematic = 0;  // kinematic theorem: least load of a mechanism; equal to `load`
  // joint forces at that load: compression on each point [N] (n_point)
  std::vector<double> point_force;
  std::vector<double>
      shear_force;  // on block b along t [N] (n_joint); in space along t1, at points (n_point)
  std::vector<double> shear_force_2;  // in space along t2 (n_point)
  std::vector<double> link_force;     // of ties, diaphragms and springs, tension + [N] (n_link)
  // collapse mechanism per unit velocity of the load: [-], [-], [1/m] (n_block)
  std::vector<double> vx, vy, omega;
  std::vector<double> vz, omega_x, omega_y;  // in space; omega is about z
  // In space: largest relative excess of a shear force over its friction circle. The load is exact for joints whose
  // friction and cohesion are higher by at most this share.
  double friction_excess = 0;  // above kFrictionCircle notes_on() reports it
  double dissipation = 0;      // of the joints in that mechanism, per unit velocity of the load
  int rows = 0, columns = 0,
      cuts = 0;         // size of the static programme; tangents of its stress blocks
  double accuracy = 0;  // relative, of the less accurate of the two programmes
  double seconds = 0;
};
// Receives the progress of one limit load [0, 1] a few times a second; a flag stops the analysis.
struct LimitMonitor {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double share)> progress = {};
};
struct LimitStopped : std::runtime_error {
  LimitStopped() : std::runtime_error("stopped by the user") {}
};
// Limit load of a model with associated flow and small displacements. Deformable blocks count as rigid ones with their
// outline, weight and contacts; lists of the result cover rigid blocks and joints only. Throws
// InputError where no load grows, where the dead loads alone have no equilibrium (names a block that
// cannot stand), and where the load has no limit; LimitStopped when `monitor` asks to stop.
[[nodiscard]] LimitResult limit_load(const Model& model, const LimitOptions& options,
                                     const LimitMonitor& monitor = {});
// What limit analysis treats differently from the run (stages, deformable blocks).
[[nodiscard]] std::vector<Message> left_aside(const Model& model);
// Estimated time of a limit load of the model on a usual machine [s].
[[nodiscard]] double expected_seconds(const Model& model);

// The model with each deformable block as one rigid block, appended after its own blocks and joints.
[[nodiscard]] Model with_rigid_bodies(Model model);
// The wall that stands when the growing load begins, after the cuts of stages; without cuts the model itself.
[[nodiscard]] Model with_what_stands(Model model);
// Whether some joint has a finite tensile strength. Joints of unlimited strength (the chain
// of a lintel) do not count.
[[nodiscard]] bool has_bond(const Model& model);

// --- a chain of macro-blocks ------------------------------------------------------------------------

// A load of constant direction at a point of its body, such as self-weight at the centroid.
struct BodyLoad {
  Vec2 at;                // at the start
  double fx = 0, fy = 0;  // [N]
  bool is_weight = false;
};
struct MacroBlock {
  std::string name;  // "left pier", "spandrel", "right pier"
  std::vector<Vec2> outline;
  std::vector<BodyLoad> loads;
};
// Rigid bodies hinged to each other and, at both ends, to the ground; they have one degree of freedom:
//
//             C12 o------o            one body:  hinges {C1}
//     body 1     /  body 2 \  C23     three:     hinges {C1, C12, C23, C3}
//               /           o
//          C1  o             \  body 3
//         =====               o  C3
//                            =====
struct Chain {
  std::vector<MacroBlock> bodies;  // 1 or 3
  std::vector<Vec2> hinges;        // 1 or 4
  int loaded_body = 0;
  Vec2 load_point;       // where the horizontal force acts, on the loaded body
  double direction = 1;  // of the force: +1 or -1 along x
};

struct ChainState {
  double displacement = 0;       // of the load point along the force [m]
  double force = 0;              // at the load point, in equilibrium with the loads [N]
  std::vector<double> rotation;  // of each body, anticlockwise, since the start [rad]
  std::vector<double> rate;      // rotation rate of each body over that of the first [-]
  std::vector<Vec2> hinges;      // current positions
};
enum class ChainEnd { kNoForce, kLocked, kTurnsBack };
inline constexpr Word<ChainEnd> kChainEndWords[] = {
    {"the force is zero", ChainEnd::kNoForce},
    {"the chain locks", ChainEnd::kLocked},
    {"the load point turns back", ChainEnd::kTurnsBack}};
struct CapacityCurve {
  std::vector<ChainState> states;  // the first is at rest
  ChainEnd end = ChainEnd::kNoForce;
  [[nodiscard]] double force_at(double displacement) const;  // 0 beyond the end
};
// Present position of a point of a body.
[[nodiscard]] Vec2 placed(const Chain& chain, const ChainState& state, std::size_t body, Vec2 at);
// Forces in the hinges at the start [N]: C1 and C3 act on the bodies, C12 on the first body, C23 on
// the last. One body: its only hinge.
[[nodiscard]] std::vector<Vec2> hinge_forces(const Chain& chain, double force);
// Force at each displacement by virtual work in the displaced geometry, F v_load + sum P v = 0, until it is zero. Throws
// InputError where the load point does not move, or where the chain falls without a force.
[[nodiscard]] CapacityCurve follow(const Chain& chain);

// Displacement-based assessment of a chain by Circolare 7/2019, C8.7.1.2.1, with an equivalent system of
// one degree of freedom. The caller chooses the shares of d0 for the limit states.
struct Assessment {
  double alpha0 = 0;              // force at rest over weight of all moving loads [-]
  double alpha0_by_weights = 0;   // multiplier of horizontal forces proportional to all loads [-]
  double participating_mass = 0;  // M* = (sum P dx)^2 / (g sum P dx^2) [kg]
  double mass_share = 0;          // e* = g M* / sum P [-]
  double acceleration0 = 0;       // a0* = alpha0_by_weights g / e* [m/s^2], confidence factor 1
  double displacement0 = 0;       // d0 of the load point, where the force is zero [m]
  double life_safety = 0,
         near_collapse = 0;  // displacements of the limit states, of the load point [m]
  // Displacement of the equivalent system over that of the load point, (sum P dx^2) / (dx_load sum P dx) [-]. It is the
  // displacement that belongs to a0* and a spectrum.
  double spectral_share = 0;
  [[nodiscard]] double spectral(double displacement) const { return spectral_share * displacement; }
};
struct LimitStateShares {
  double life_safety = 0.4, near_collapse = 0.6;  // of d0
};
[[nodiscard]] Assessment assess(const Chain& chain, const CapacityCurve& curve, double gravity,
                                const LimitStateShares& shares = {});

// --- macro-blocks of a wall with one opening --------------------------------------------------------

enum class Hypothesis { kInfinite, kMacroBlock1, kMacroBlock2 };
inline constexpr Word<Hypothesis> kHypothesisWords[] = {
    {"infinite", Hypothesis::kInfinite},
    {"macro_block_1", Hypothesis::kMacroBlock1},
    {"macro_block_2", Hypothesis::kMacroBlock2}};
[[nodiscard]] Message in_words(const std::string& mode, Hypothesis hypothesis);  // "FM-1 infinite"

// Geometry of a wall with one opening, derived from its blocks. Heights are above the base of the wall.
struct Portal {
  double left = 0, right = 0;            // ends of the wall [m]
  double jamb_left = 0, jamb_right = 0;  // of the opening [m]
  double foot = 0, head = 0, top = 0;    // sill, head of the opening, top of the wall [m]
  double thickness = 0;                  // [m]
  double block_height = 0;               // of one course [m]
  double compressive_strength = 0;       // fc [Pa], of the weakest bed or foundation joint
  std::string strength_material;         // the material of that joint
  Vec2 load_point;                       // mean centroid of the driven blocks [m]
  double direction = 1;                  // of the push, along x
};
// Finds the portal. Throws InputError with every fault: not one opening, no horizontal push, a loading beam, a load
// point outside the wall.
[[nodiscard]] Portal find_portal(const Model& model);

struct NamedNumber {
  std::string name;
  double value = 0;
  std::string unit;
};
struct Mechanism {
  std::string mode;  // "FM-1", "FM-4"
  Hypothesis hypothesis = Hypothesis::kInfinite;
  Chain chain;
  std::vector<NamedNumber> inputs;  // all numbers that entered the mechanism
  CapacityCurve curve;
  // "mechanism_fm1_infinite"
  [[nodiscard]] std::string file_name() const;
};
// Cuts the mechanism `mode`, "FM-1" or "FM-4". Throws InputError where fc is needed but unlimited, and where crushing
// takes a pier's whole foot.
[[nodiscard]] Mechanism cut_mechanism(const Model& model, const Portal& portal,
                                      const std::string& mode, Hypothesis hypothesis);

// --- comparison with runs ---------------------------------------------------------------------------

// A run to compare with: a stored run or a sample of a campaign.
struct ComparedRun {
  std::string name;  // "run", "sample 17"
  std::string mode;  // its failure mode
  std::vector<CurveRow> curve = {};
  double load_factor = 0;  // of a body force or tilt
  // Its capacity [N]. NaN: the run has none. Unset: the run does not state it, so its highest force counts.
  std::optional<double> capacity = {};
  std::string judgement = {};  // RateVerdict::judgement of its push rate
  Message rate_verdict = {};   // with its reason and cure
  double bound = -1;           // limit load of its own model [N] or [-]; -1: none
  std::string no_bound = {};   // why `bound` is missing
  double weight_on_push = 0;   // component of the driven blocks' dead loads along the push [N]
  // Of a cyclic run, against the push: highest force [N] and its limit load.
  double peak_back = 0, bound_back = -1;
  Message wall = {};  // described() of its model or of its campaign's base model
};
struct CurveVerdict {
  std::string run, mode, mechanism;
  double peak_ratio = 0;  // peak of the run / force of the mechanism at rest
  double gap = 0;         // mean |difference| over the run's post-peak branch [N]
  double gap_share = 0;   // gap over the peak of the run [-]
};
// Relative excess of a run of rigid blocks over its limit load that is accepted: 2 %, since a
// capacity may be out of balance by 2 % of its force (docs/theory/limit_analysis.md).
inline constexpr double kBoundTolerance = 0.02;
// The peak of a run against the limit load that it cannot exceed.
struct BoundVerdict {
  std::string run;
  double peak = 0, bound = 0;  // [N] or [-]
  double allowance = kBoundTolerance;
  bool is_force = true;
  Message no_evidence = {};  // why a peak below the bound proves nothing; empty: it does
  [[nodiscard]] bool holds() const { return peak <= bound * (1 + allowance); }
};
struct EnvelopePoint {
  double displacement = 0, low = 0, mean = 0, high = 0;  // [m], [N]
  double percentile_5 = 0, percentile_95 = 0;            // of the runs [N]
  int runs = 0;
};
// Averages over the runs of one mode.
struct GroupVerdict {
  std::string mode, mechanism;
  int runs = 0;
  double mean_peak = 0;                           // of the runs [N]
  double peak_ratio = 0, gap = 0, gap_share = 0;  // means over the runs
};
// Peaks of runs against the least and the largest limit load of the compared model (nominal strengths in a campaign).
struct BracketVerdict {
  double low = 0, high = 0;              // least and largest limit load [N] or [-]
  double least_peak = 0, most_peak = 0;  // of the runs
  bool is_force = true;
  int runs = 0, below = 0, above = 0;
};
struct Comparison {
  std::string with;  // the folder
  std::vector<ComparedRun> runs;
  std::vector<CurveVerdict> curves;
  std::vector<GroupVerdict> groups;
  std::vector<BoundVerdict> bounds;
  BracketVerdict bracket = {};
};
[[nodiscard]] CurveVerdict compare(const ComparedRun& run, const Mechanism& mechanism);
// Compares each run with the mechanisms of its mode, or with all where its mode has none.
[[nodiscard]] Comparison compare(std::string with, std::vector<ComparedRun> runs,
                                 const std::vector<Mechanism>& mechanisms);
// Blocks, weights, loads and push of a model as a text; only runs with equal texts are comparable.
[[nodiscard]] Message described(const Model& model);
// Lowest, mean and highest force of the runs at equal displacements, with percentiles 5 and 95
// (interpolated between order statistics), up to the displacement that half of the runs reach.
[[nodiscard]] std::vector<EnvelopePoint> envelope(const std::vector<ComparedRun>& runs,
                                                  const std::string& mode);

// A limit load with its name, as `wythe limit` writes it.
struct NamedLimit {
  std::string name;  // "dry", "bonded", ...
  LimitResult answer;
};
// A requested analysis that is not possible.
struct Refusal {
  Message what;     // "FM-1 Macro-Block 2"
  std::string why;  // the fault with its cure
};
struct SecondOpinion {
  std::vector<NamedLimit> limits;
  std::vector<Mechanism> mechanisms;
  std::vector<Assessment> assessments;  // of each mechanism, or none
  std::vector<LocalCheck> local = {};   // of parts out of plane
  LimitStateShares shares;
  std::vector<Refusal> refused = {};
  std::vector<Message> notes = {};  // for the user
  Comparison comparison;
};
// Peaks of the compared runs and the limit loads of `opinion`.
[[nodiscard]] BracketVerdict bracket_of(const SecondOpinion& opinion);
// Warnings for the reader, such as a mechanism that crushing makes stronger, or runs of another model.
[[nodiscard]] std::vector<Message> notes_on(const Model& model, const SecondOpinion& opinion);

}  // namespace wythe
