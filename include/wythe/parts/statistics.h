// Statistics of a campaign's samples: strengths, displacements and failure modes, with intervals.
//
//   Campaign --statistics_of()--> Statistics --> statistics.json (io.h), report.html (report.h)
//   --until "relative_interval(peak_reaction) < 1 % and interval(share) < 0.1" --precise_enough()
//
// Every interval is a 95 % interval; equal campaigns give equal bits. Estimators, their sources
// and their bias: docs/theory/statistics.md. NaN: not known (too few samples). An infinite
// displacement lies beyond the end of the push.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/assessment.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/message.h"

namespace wythe {

struct Interval {
  double low = kUnset, high = kUnset;
  [[nodiscard]] double width() const { return high - low; }
};
struct Estimate {
  double value = kUnset;
  Interval interval;
};

// A response of one curve. A censored value is a lower bound, since the push ended too early.
struct Reading {
  double value = kUnset;
  bool censored = false;
  [[nodiscard]] bool is_known() const { return value == value; }  // not NaN
};

// A response with statistics; shown = SI * to_unit.
struct Quantity {
  const char* name;  // "peak_reaction", as in until rules
  const char* code;  // of its message: "peak force"
  const char* unit;  // "kN", "mm", "kN/mm"
  double to_unit;
  bool can_be_censored;
  Reading (*read)(const Responses&);
};
// All quantities: peak_reaction, displacement_at_peak, displacement_at_80_percent, displacement_max, initial_stiffness,
// displacement_at_50_percent, collapse_displacement, first_fall_80_percent. Arrays `quantity` and `response` have this order.
[[nodiscard]] const std::vector<Quantity>& quantities();
// Throws std::logic_error for a name that none has.
[[nodiscard]] const Quantity& quantity_named(const std::string& name);
// The name in files, "peak_reaction_kN".
[[nodiscard]] std::string key_of(const Quantity& quantity);

// Statistics of one quantity in one group. Mean, cov, min, max and median take censored values as they are;
// survival_* treat them as lower bounds (Kaplan-Meier), the mean up to the largest recorded value.
struct Summary {
  int n = 0, censored = 0,
      without_value = 0;  // n: samples with a value; of them censored; samples without a value
  double min = kUnset, max = kUnset, standard_deviation = kUnset;
  Estimate mean, cov, median;                            // BCa, BCa and percentile bootstrap
  Estimate survival_mean, survival_median;               // percentile bootstrap
  double percentile_5 = kUnset, percentile_95 = kUnset;  // linear (7.6b); infinite among bounds
};
// "all", one failure mode, or several modes together ("FM-1 + FM-2").
struct GroupSummary {
  std::string name;
  std::vector<std::string> modes;
  std::vector<Summary> quantity;
};

struct Share {
  std::string name;
  std::vector<std::string> modes;
  int count = 0;
  Estimate share;  // Wilson interval
};

// One number over a few walls. The interval of the median comes from order statistics: it contains the median of all
// such walls with at least 95 %, whatever their distribution (docs/theory/statistics.md); it needs six walls.
// A lower bound counts at its value for the lower end, and as infinite for the upper end.
struct OfWalls {
  int n = 0, bounds = 0;
  Estimate median;                             // infinite where too many are bounds
  double at_least = kUnset;                    // the median with each bound at its value
  double smallest = kUnset, largest = kUnset;  // known values only
  double log_scatter = kUnset;                 // standard deviation of ln; NaN with bounds
};
[[nodiscard]] OfWalls of_walls(const std::vector<Reading>& readings);

// Walls of one model with random fields, summarised as `wythe run --walls` does.
struct WallEnsemble {
  OfWalls peak_reaction, displacement_at_peak, displacement_at_80;
  std::vector<double> left;       // shares r of the peak for d(r)
  std::vector<OfWalls> capacity;  // d(r) for each of `left`
  std::vector<Share> mode;        // most frequent first
};

// Share of samples that get another failure mode from another reading of the same push.
struct NameSensitivity {
  NameReading reading;  // its `name` is empty
  int n = 0, differs = 0;
  Estimate share;  // Wilson
};
// Share of samples with a raised severity flag.
struct FlagCount {
  Evidence flag;  // its `value` is 0
  int n = 0, raised = 0;
  Estimate share;  // Wilson
};

// Mean of the first n samples and its Student interval (Fig. 8).
struct RunningMean {
  std::vector<int> n;
  std::vector<Estimate> mean;
};
// When a requested precision was reached: relative half-width for means, half-width for shares.
struct Precision {
  std::string what;   // key of a quantity, or "share"
  double target = 0;  // 0.01: +- 1 %, or a share +- 0.05
  int first_met = 0;  // sample size that first met it, >= kFewestSamples; 0: none
  int held_from = 0;  // sample size from which on it is met; 0: not met now
  int expected = 0;   // size that should meet it, with width ~ 1/sqrt(n); 0: met
  double now = kUnset;
};

struct Correlation {
  std::string input;  // a random variable of the study
  int n = 0;
  Estimate pearson, spearman, partial_rank;  // Fisher z intervals
};
// Correlation of every random input with one response (its key) in one group. Within a failure mode it is
// conditioned on the outcome, so it does not show a cause.
struct CorrelationTable {
  std::string group, quantity;
  int censored = 0;
  std::vector<Correlation> input;
};

// First-order index Var E[Y | X] / Var Y, estimated from all samples with bins of equal count.
struct FirstOrderIndex {
  std::string input, quantity;
  int bins = 0;
  Estimate index;
  std::vector<std::string> entangled;  // inputs with a rank correlation to it above kEntangled
};

// Probability of each mode in bins of equal count of one input.
struct ModeBin {
  double low = 0, high = 0, mean = 0;  // of the input [SI]
  int n = 0;
  std::vector<Estimate> share;  // (modes of ModeAgainstInput), Wilson
};
struct ModeAgainstInput {
  InputColumn column;  // of the input
  std::vector<std::string> modes;
  std::vector<ModeBin> bin;
};

// Mean of the curves at common displacements; each curve counts up to its last row.
struct CurvePoint {
  double displacement = 0, drift = 0;  // [m], [-]
  int n = 0;
  double mean = 0, standard_deviation = 0, low = 0, high = 0;  // reaction, 5 and 95 % [N]
};
struct MeanCurve {
  std::string group;
  int n = 0;
  std::vector<CurvePoint> point;
};

// A drift limit of a code against the samples: P(drift at 0.8 of the peak < limit).
struct DriftLimit {
  std::string element, mechanism, state, clause;
  std::string label;           // "pier, shear": name of its line in a figure
  double limit = 0;            // [-]
  int below = 0, unknown = 0;  // reached it; push ended before it
  // As a share; Kaplan-Meier where some are unknown. Beyond the farthest push `share.value` is a lower bound; NaN
  // where all are unknown.
  Estimate share;
  bool is_lower_bound = false;
};

// P(X > x), with censored values as lower bounds and the interval (7.5), and the lognormal distribution fitted to it.
struct ExceedancePoint {
  double value = 0;  // [SI]
  Estimate probability;
};
struct Exceedance {
  std::string quantity;  // of `quantities()`; displacements also as drift by load_height
  int n = 0, censored = 0;
  std::vector<ExceedancePoint> point;
  Estimate median, beta;   // lognormal, maximum likelihood, percentile bootstrap [SI], [-]
  double misfit = kUnset;  // largest distance of fit and empirical curve [-]
};

// An event of a sample: a response exceeds a threshold, or a failure mode occurs.
struct FragilityEvent {
  std::string response;       // of `quantities()`, "drift_at_80_percent", or "failure_mode"
  std::string mode;           // of "failure_mode"
  double threshold = kUnset;  // [SI], [-] of a drift
  std::string unit = {};      // shown
  double to_unit = 1;
  [[nodiscard]] bool of_mode() const { return response == "failure_mode"; }
};
// Whether the probability of an event can be given as a function of an input, or why not.
enum class FragilityVerdict {
  kTold,
  kFewSamples,  // fewer than kFewestSamples
  kNever,       // no sample shows the event
  kAlways,      // every sample shows it
  kRare,        // too few samples show it, or do not, for a slope
  kConstant,    // the input does not vary
  kTwoValues,   // it has two values, so nothing is known between them
  kSeparated,   // it separates the samples: no finite slope
  kCollinear    // the two inputs are collinear
};
inline constexpr Word<FragilityVerdict> kFragilityVerdictWords[] = {
    {"told", FragilityVerdict::kTold},
    {"few samples", FragilityVerdict::kFewSamples},
    {"never", FragilityVerdict::kNever},
    {"always", FragilityVerdict::kAlways},
    {"rare", FragilityVerdict::kRare},
    {"constant", FragilityVerdict::kConstant},
    {"two values", FragilityVerdict::kTwoValues},
    {"separated", FragilityVerdict::kSeparated},
    {"collinear", FragilityVerdict::kCollinear}};
enum class FragilityLaw { kLogistic, kLognormal };
inline constexpr Word<FragilityLaw> kFragilityLawWords[] = {
    {"logistic", FragilityLaw::kLogistic}, {"lognormal", FragilityLaw::kLognormal}};

// One model fitted to one event and one input (shown units). The slope is that of the log-odds, or 1/beta with the
// sign of the trend. `half` is the input with P = 1/2, NaN where it lies outside the samples.
struct FragilityFit {
  FragilityLaw law = FragilityLaw::kLogistic;
  Estimate slope, half;  // profile likelihood
  double log_likelihood = kUnset;
  double influence_p = kUnset;  // likelihood ratio test against no influence
  double fit_p = kUnset;        // Hosmer and Lemeshow; NaN: too few groups
};
struct FragilityPoint {
  double x = 0;  // value of the input, as shown
  Estimate probability;
};
struct FragilityOfInput {
  std::string input, unit;
  FragilityVerdict verdict = FragilityVerdict::kTold;
  double parted_low = kUnset, parted_high = kUnset;  // gap in which it separates them, as shown
  std::vector<FragilityFit> fit;       // better one first; lognormal for positive inputs only
  std::vector<FragilityPoint> point;   // curve of the better one, within the samples
  std::vector<std::string> entangled;  // inputs with a rank correlation above kEntangled
};
// Logistic regression on two inputs: log-odds = intercept + slope_a a + slope_b b, shown units. Wald intervals.
struct FragilityOfPair {
  std::string a, b;
  FragilityVerdict verdict = FragilityVerdict::kTold;
  double intercept = kUnset;
  Estimate slope_a, slope_b;
  double added_p = kUnset;  // likelihood ratio test against the better single input
  double fit_p = kUnset;
};
struct Fragility {
  FragilityEvent event;
  int n = 0, seen = 0,
      unknown = 0;              // samples; with the event; push ended before the threshold
  int repeated = 0;             // left out: inputs equal those of an earlier sample
  int doubtful = 0;             // of n: the push was not slow enough
  Estimate share;               // Wilson, of the known; widened where some are unknown
  std::vector<int> sample;      // the samples, and whether each shows the event:
  std::vector<double> outcome;  // 0, 1, 0.5 not known
  std::vector<FragilityOfInput> input;
  std::vector<FragilityOfPair> pair;
};

// How much the scatter of a response would shrink if an input were known: regression on a cubic of its ranks.
struct Measuring {
  std::string quantity, input;
  int n = 0, censored = 0;
  Estimate variance;        // share of the variance removed
  Estimate width;           // share of the interval removed, 1 - sqrt(1 - variance)
  double is_best = kUnset;  // share of replicates in which this input removes most
};

enum class IndexVerdict { kTold, kFewSamples, kCorrelated, kCensored, kDiscrete, kUnexplained };
inline constexpr Word<IndexVerdict> kIndexVerdictWords[] = {
    {"told", IndexVerdict::kTold},
    {"few samples", IndexVerdict::kFewSamples},
    {"correlated", IndexVerdict::kCorrelated},
    {"censored", IndexVerdict::kCensored},
    {"discrete", IndexVerdict::kDiscrete},
    {"unexplained", IndexVerdict::kUnexplained}};
// Sobol indices of one response from a polynomial surrogate, if it predicts unseen samples.
struct SurrogateIndices {
  struct Of {
    std::string input;
    Estimate first_order, total;
  };
  std::string quantity;
  IndexVerdict verdict = IndexVerdict::kTold;
  int n = 0, terms = 0;
  double q2 = kUnset;  // cross-validated share of the predicted variance
  std::vector<Of> input;
};
inline constexpr double kLeastQ2 = 0.8;

struct InputSummary {
  std::string name, unit;
  bool is_random = true;
  double mean = kUnset, cov = kUnset, min = kUnset, max = kUnset;  // as shown
};

// Spearman's rank correlation of two random inputs, as drawn.
struct InputCorrelation {
  std::string a, b;
  double rank = kUnset;
};
// Rank correlations of all pairs, the strongest first.
[[nodiscard]] std::vector<InputCorrelation> input_correlations(const SampleTable& samples);
// Rank correlation above which the influence of two inputs on a response can't be separated.
inline constexpr double kEntangled = 0.1;
// Fewest samples at which an until rule may stop, and of a fragility.
inline constexpr int kFewestSamples = 20;

// A sample without results, and the reason.
struct Unanswered {
  int sample = 0;
  std::string status;
  Message reason;
};

// Peak ground acceleration at which the samples reach a limit state (docs/theory/assessment.md, A.13).
struct PgaFragility {
  std::string limit_state;             // word of LimitState
  bool is_checked = false;             // the limit state to which the spectrum belongs
  int n = 0, censored = 0;             // samples with an acceleration; of them lower bounds
  Estimate median, beta_capacity;      // lognormal [m/s^2], [-]; percentile bootstrap
  double beta = kUnset;                // total, with the scatter of records [-]
  double demand = kUnset;              // of the spectrum, for the checked limit state [m/s^2]
  Estimate at_demand;                  // probability of the limit state at `demand`
  std::vector<ExceedancePoint> point;  // share of samples with a larger capacity, Kaplan-Meier
  std::vector<FragilityPoint> curve;   // probability against acceleration [m/s^2]
};
struct CampaignAssessment {
  AssessmentSpec spec;  // of the base model
  // Of the sample with the median participating mass; where no sample answers, of the base model with a
  // linear shape.
  MassAndShape mass;
  int answered = 0, without_answer = 0;  // samples that ran
  int doubtful = 0;                      // of those answered: must not be signed, bounds aside
  Message reason;                        // why there are no numbers; empty where there may be
  std::vector<Message> notes;
  std::vector<PgaFragility> fragility;  // for each limit state; empty without a spectrum
};
// Assessment of one sample that ran; `model` is that of `base`, the base model of the study.
[[nodiscard]] CodeAssessment assess_sample(const SampleRecord& record, const ModelSpec& base,
                                           const Model& model);
// Assessment of all samples that ran.
[[nodiscard]] CampaignAssessment assess_campaign(const Campaign& campaign, const ModelSpec& base,
                                                 const Model& model);

// --- samples under records (docs/theory/fragility.md) ---------------------------------------------

// A shake that counts neither as stood nor as fell.
struct LostShake {
  int sample = 0;  // counted from 1, as in the store
  double intensity = kUnset;
  std::string status;
  Message reason;
};

// Intensities between which a sample first reached a limit state: not at `low`, but at `high`. low = 0: already at
// the lowest; high infinite: at none up to `low`.
struct Bracket {
  int sample = 0;
  int wall = 0, record = 0;  // 0-based
  double low = 0, high = 0;  // [SI]
  bool is_known = true;      // false: decisive shakes do not count; the sample is left out
  bool came_back = false;    // a higher intensity did not reach it again
};

// Whether a fragility curve of a limit state can be given, or why not.
enum class LimitStateVerdict {
  kTold,
  kFewRecords,  // fewer than kFewestRecords
  kNever,       // no sample reached it
  kAlways,      // every sample reached it at its lowest intensity
  kSeparated,   // one intensity separates the samples: no dispersion
  kNoTrend      // not reached more often at higher intensities
};
inline constexpr Word<LimitStateVerdict> kLimitStateVerdictWords[] = {
    {"told", LimitStateVerdict::kTold},           {"few records", LimitStateVerdict::kFewRecords},
    {"never", LimitStateVerdict::kNever},         {"always", LimitStateVerdict::kAlways},
    {"separated", LimitStateVerdict::kSeparated}, {"no trend", LimitStateVerdict::kNoTrend}};
inline constexpr int kFewestRecords = 7;  // fewest records for a median and a dispersion

// Samples that reached a limit state at one intensity, from shakes at this intensity alone.
struct LimitStateCount {
  double intensity = 0;  // [SI]
  int n = 0, reached = 0, lost = 0;
  Estimate share;  // Wilson, as if the samples were independent
};

// Whether the scatter of a logarithm can be divided among records, walls and the rest, or why not.
enum class ScatterVerdict {
  kTold,
  kOneKind,     // fewer than kFewestForScatter records or walls
  kNotCrossed,  // not every wall was shaken by every record
  kNotReached,  // not every sample has a value
  kWide,        // brackets are wider than the remaining scatter
};
inline constexpr Word<ScatterVerdict> kScatterVerdictWords[] = {
    {"told", ScatterVerdict::kTold},
    {"one kind", ScatterVerdict::kOneKind},
    {"not crossed", ScatterVerdict::kNotCrossed},
    {"not reached", ScatterVerdict::kNotReached},
    {"wide brackets", ScatterVerdict::kWide}};
inline constexpr int kFewestForScatter = 3;
// Standard deviations of ln, from a two-way layout without repetition. A lower end of 0 means that the part
// may be zero.
struct Scatter {
  ScatterVerdict verdict = ScatterVerdict::kTold;
  int records = 0, walls = 0;
  Estimate record, wall, rest;
  double bracket = kUnset;  // rms of the uncertainty within brackets
};

struct LimitStateFragility {
  LimitStateSpec limit_state;
  LimitStateVerdict verdict = LimitStateVerdict::kTold;
  int n = 0, reached = 0, lost = 0, came_back = 0;  // samples with a bracket; of them; left out
  std::vector<Bracket> bracket;
  std::vector<LimitStateCount> count;  // by intensity
  // Lognormal: P = Phi(ln(x / median) / beta), by maximum likelihood [SI], [-].
  Estimate median, beta;
  bool by_bootstrap = false;  // over records and walls; else profile likelihood
  double log_likelihood = kUnset;
  double count_median = kUnset, count_beta = kUnset;  // from the counts alone (Baker 2015)
  // The median if every left-out sample had reached the limit state where its run was lost, and if none had.
  double median_if_reached = kUnset, median_if_not = kUnset;
  std::vector<FragilityPoint> curve;  // within the intensities of the shakes [SI]
  Scatter scatter;                    // of ln of the intensity that reaches the limit state
};

// Response at one intensity, over all samples that count there.
struct IntensitySummary {
  double intensity = 0;  // [SI]
  int n = 0, collapsed = 0, lost = 0;
  double drift_16 = kUnset, drift_50 = kUnset,
         drift_84 = kUnset;  // peak drift; infinite where more collapsed
  Scatter scatter;           // of ln of the peak drift
};

struct ShakingStatistics {
  ShakingSpec shaking;           // as the study states it
  std::vector<Message> damping;  // of the shaken stages: their damping
  int records = 0, walls = 0, samples = 0;
  int shakes = 0, stood = 0, collapsed = 0;
  std::vector<LostShake> lost;
  std::vector<IntensitySummary> intensity;
  std::vector<LimitStateFragility> fragility;
  [[nodiscard]] bool is_told() const { return shakes > 0; }
};
// Whether a shake that counts reached the limit state.
[[nodiscard]] bool reaches(const LimitStateSpec& limit, const ShakeResult& shake);
// Statistics of all shakes of the samples that ran.
[[nodiscard]] ShakingStatistics shaking_statistics(const Campaign& campaign);

struct Statistics {
  std::string study, design;
  std::uint64_t seed = 0;
  int asked = 0, run = 0, answered = 0;  // samples drawn, run, with a usable curve
  int still_rising = 0;                  // answered, but the peak ends the push: a lower bound
  int named_earlier = 0;                 // answered, but the push ended before read_modes_at
  int collapsed_before_push = 0;         // these have no results
  double load_height = 0;                // of the base model; drifts use each sample's own [m]
  double read_modes_at = kUnset;         // displacement at which modes are read [m]
  int replicates = 0;                    // of each bootstrap
  std::map<std::string, int> status;     // of the samples that ran
  std::map<std::string, int> judgement;  // of the samples with a curve: RateVerdict::judgement
  std::vector<Unanswered> unanswered;
  std::vector<std::string> modes;  // FM-1 ... FM-5 where they occur, other names, "unclear"
  std::vector<InputSummary> input;
  std::vector<InputCorrelation> input_correlation;
  std::vector<GroupSummary> group;  // all, then combined modes, then single ones
  std::vector<Share> share;         // modes, then combined modes
  WallEnsemble walls;               // medians and d(r) over all of them
  std::vector<NameSensitivity> name_sensitivity;
  std::vector<FlagCount> flag;
  std::vector<RunningMean> running;  // (quantities())
  std::vector<Precision> precision;
  std::vector<CorrelationTable> correlation;
  std::vector<FirstOrderIndex> first_order;
  std::vector<ModeAgainstInput> mode_against_input;
  std::vector<MeanCurve> mean_curve;  // all, then modes
  std::vector<DriftLimit> drift_limit;
  std::vector<Exceedance> exceedance;
  std::vector<Fragility> fragility;
  std::vector<Measuring> measuring;  // by response, largest reduction first
  std::vector<SurrogateIndices> surrogate_indices;
  ShakingStatistics shaking;      // where the samples were shaken
  CampaignAssessment assessment;  // set by assess_campaign()
  ProjectSpec project;            // of the base model; set by the caller
};

// Statistics of a campaign, which may be empty. A sample counts when its push was completed or ended by collapse and left a
// curve; the others are in `unanswered`. Cost: a few seconds for 250 samples.
[[nodiscard]] WallEnsemble ensemble_of(const Campaign& campaign);
[[nodiscard]] Statistics statistics_of(const Campaign& campaign);

// Whether a sample counts in the statistics: its run ended, and it has a force in balance.
[[nodiscard]] bool is_answered(const SampleRecord& record);
// Whether the largest reaction of an answered sample is its last, so that the wall may resist more.
[[nodiscard]] bool is_still_rising(const SampleRecord& record);

// Throws InputError with every fault of a malformed until rule and its cure; "" is no rule.
void check_rule(const std::string& rule);
// Parses an event of a study: "peak_reaction > 150 kN", "drift_at_80_percent > 0.5 %". Throws as check_rule().
[[nodiscard]] FragilityEvent fragility_event(const std::string& text);
// Whether every clause of the rule holds and kFewestSamples have answered; `measures` (optional)
// gets the state of each clause. "" is never met. Cheap: called after every sample.
[[nodiscard]] bool precise_enough(const std::string& rule, const Campaign& campaign,
                                  Message* measures = nullptr);

}  // namespace wythe
