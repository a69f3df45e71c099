// Statistics of the samples of a campaign: strengths, displacements, failure modes, with intervals.
//
//   Campaign --statistics_of()--> Statistics --> statistics.json (io.h), report.html (report.h)
//   --until "relative_interval(peak_reaction) < 1 % and interval(share) < 0.1" --precise_enough()
//
// Every interval is a 95 % interval; the same campaign gives the same bits. Estimators, their sources
// and their bias: docs/theory/statistics.md. NaN: no answer (too few samples). An infinite
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

// A response read from one curve. A censored value is a lower bound, since the push ended too early.
struct Reading {
  double value = kUnset;
  bool censored = false;
  [[nodiscard]] bool is_known() const { return value == value; }  // not NaN
};

// A response that statistics are made for; shown = SI * to_unit.
struct Quantity {
  const char* name;  // "peak_reaction", as in until rules
  const char* code;  // of its message: "peak force"
  const char* unit;  // "kN", "mm", "kN/mm"
  double to_unit;
  bool can_be_censored;
  Reading (*read)(const Responses&);
};
// peak_reaction, displacement_at_peak, displacement_at_80_percent, displacement_max,
// initial_stiffness, displacement_at_50_percent, collapse_displacement, first_fall_80_percent: the order of every `quantity` and `response` array below.
[[nodiscard]] const std::vector<Quantity>& quantities();
// "peak_reaction_kN": what files call it.
[[nodiscard]] std::string key_of(const Quantity& quantity);

// One cell of Table 3. Censored values enter mean, cov, min, max and median as they were recorded;
// survival_* treat them as lower bounds (Kaplan-Meier), the mean up to the largest recorded value.
struct Summary {
  int n = 0, censored = 0,
      without_value = 0;  // samples with a value; of them censored; without a value, not in n
  double min = kUnset, max = kUnset, standard_deviation = kUnset;
  Estimate mean, cov, median;                            // BCa, BCa and percentile bootstrap
  Estimate survival_mean, survival_median;               // percentile bootstrap
  double percentile_5 = kUnset, percentile_95 = kUnset;  // Kaplan-Meier where censored
};
// "all", one failure mode, or modes taken together ("FM-1 + FM-2").
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

// One number over a few walls. The interval of the median is that of order statistics: it holds the median of
// all such walls with at least 95 %, whatever their distribution (docs/theory/statistics.md); from six walls on.
// A wall whose number is a lower bound counts as that below, and as unlimited above.
struct OfWalls {
  int n = 0, bounds = 0;
  Estimate median;                             // infinite where too many are bounds
  double at_least = kUnset;                    // the median with each bound at its own value
  double smallest = kUnset, largest = kUnset;  // the largest that is known
  double log_scatter = kUnset;                 // standard deviation of ln, where none is a bound
};
[[nodiscard]] OfWalls of_walls(const std::vector<Reading>& readings);

// Walls of one model that differ by what scatters within them: what `wythe run --walls` states.
struct WallEnsemble {
  OfWalls peak_reaction, displacement_at_peak, displacement_at_80;
  std::vector<double> left;       // shares of the peak at which d(r) was read
  std::vector<OfWalls> capacity;  // d(r), by them
  std::vector<Share> mode;        // most frequent first
};

// In how many samples another reading of the same push gives another failure mode.
struct NameSensitivity {
  NameReading reading;  // its `name` is empty
  int n = 0, differs = 0;
  Estimate share;  // Wilson
};
// In how many samples a severity flag is raised.
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
// When a precision that was asked for was reached. Relative half-widths for means, half-widths for shares.
struct Precision {
  std::string what;   // key of a quantity, or "share"
  double target = 0;  // 0.01: +- 1 %, or a share +- 0.05
  int first_met = 0;  // sample size, at least kFewestSamples; 0: not met
  int held_from = 0;  // sample size from which on it stayed met; 0: it is not met now
  int expected = 0;   // size at which it should be met, as the width falls with 1/sqrt(n); 0: it is
  double now = kUnset;
};

struct Correlation {
  std::string input;  // a random variable of the study
  int n = 0;
  Estimate pearson, spearman, partial_rank;  // Fisher z intervals
};
// Correlation of every random input with one response (its key) in one group. Inside a mode it is
// conditioned on the outcome, so it does not measure a cause.
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

// Mean of the curves at common displacements (Fig. 21); a curve counts up to its last row.
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

// A drift limit of the code against the samples: P(drift at 0.8 of the peak < limit).
struct DriftLimit {
  std::string element, mechanism, state, clause;
  std::string label;           // "pier, shear": of a line in a figure
  double limit = 0;            // [-]
  int below = 0, unknown = 0;  // reached it; push ended before the limit
  // Wilson; Kaplan-Meier and Greenwood where some are unknown. Beyond the farthest push the share is
  // only known to be at least `share.value`; NaN where all are unknown.
  Estimate share;
  bool is_lower_bound = false;
};

// P(X > x), censored values taken as lower bounds, and the lognormal distribution fitted to it.
struct ExceedancePoint {
  double value = 0;  // [SI]
  Estimate probability;
};
struct Exceedance {
  std::string quantity;  // of `quantities()`; displacements also as drift by load_height
  int n = 0, censored = 0;
  std::vector<ExceedancePoint> point;
  Estimate median, beta;   // lognormal, maximum likelihood, percentile bootstrap [SI], [-]
  double misfit = kUnset;  // largest gap between the fit and the samples' own curve [-]
};

// An event that a sample shows or not: a response is greater than a threshold, or a mode occurs.
struct FragilityEvent {
  std::string response;       // of `quantities()`, "drift_at_80_percent", or "failure_mode"
  std::string mode;           // of "failure_mode"
  double threshold = kUnset;  // [SI], [-] of a drift
  std::string unit = {};      // shown
  double to_unit = 1;
  [[nodiscard]] bool of_mode() const { return response == "failure_mode"; }
};
// What can be told of an event by an input.
enum class FragilityVerdict {
  kTold,
  kFewSamples,  // fewer than kFewestSamples
  kNever,       // no sample shows the event
  kAlways,      // every sample does
  kRare,        // too few do, or too few don't, for a slope
  kConstant,    // the input does not vary
  kTwoValues,   // it has two values: nothing is known between them
  kSeparated,   // it parts the samples: no finite slope
  kCollinear    // two inputs say the same
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

// One law fitted to one event and one input (shown units). Slope of log-odds per unit, or 1/beta with the
// sign of the trend; `half` is the input where P = 1/2, NaN where that lies outside the samples.
struct FragilityFit {
  FragilityLaw law = FragilityLaw::kLogistic;
  Estimate slope, half;  // profile likelihood
  double log_likelihood = kUnset;
  double influence_p = kUnset;  // likelihood ratio against no influence
  double fit_p = kUnset;        // Hosmer and Lemeshow; NaN: too few groups
};
struct FragilityPoint {
  double x = 0;  // of the input, as shown
  Estimate probability;
};
struct FragilityOfInput {
  std::string input, unit;
  FragilityVerdict verdict = FragilityVerdict::kTold;
  double parted_low = kUnset, parted_high = kUnset;  // between which it parts the samples, as shown
  std::vector<FragilityFit> fit;       // the better one first; lognormal only of a positive input
  std::vector<FragilityPoint> point;   // of the better one, within the samples
  std::vector<std::string> entangled;  // inputs with a rank correlation above kEntangled
};
// Logistic in two inputs: log-odds = intercept + slope_a a + slope_b b, as shown. Wald intervals.
struct FragilityOfPair {
  std::string a, b;
  FragilityVerdict verdict = FragilityVerdict::kTold;
  double intercept = kUnset;
  Estimate slope_a, slope_b;
  double added_p = kUnset;  // likelihood ratio against the better one of the two alone
  double fit_p = kUnset;
};
struct Fragility {
  FragilityEvent event;
  int n = 0, seen = 0,
      unknown = 0;              // samples; with the event; whose push ended before the threshold
  int repeated = 0;             // left out: all their inputs are those of an earlier sample
  int doubtful = 0;             // of n, whose push was not slow enough
  Estimate share;               // of the known, Wilson; of all, widened, where some are unknown
  std::vector<int> sample;      // those told of, and whether each shows the event:
  std::vector<double> outcome;  // 0, 1, 0.5 not known
  std::vector<FragilityOfInput> input;
  std::vector<FragilityOfPair> pair;
};

// How far a response would be known better if an input were known: a cubic of its ranks.
struct Measuring {
  std::string quantity, input;
  int n = 0, censored = 0;
  Estimate variance;        // share of the variance that goes
  Estimate width;           // share of the interval that goes, 1 - sqrt(1 - variance)
  double is_best = kUnset;  // share of the replicates in which no other input takes more
};

enum class IndexVerdict { kTold, kFewSamples, kCorrelated, kCensored, kDiscrete, kUnexplained };
inline constexpr Word<IndexVerdict> kIndexVerdictWords[] = {
    {"told", IndexVerdict::kTold},
    {"few samples", IndexVerdict::kFewSamples},
    {"correlated", IndexVerdict::kCorrelated},
    {"censored", IndexVerdict::kCensored},
    {"discrete", IndexVerdict::kDiscrete},
    {"unexplained", IndexVerdict::kUnexplained}};
// Sobol indices of one response from a polynomial surrogate, if that predicts samples it has not seen.
struct SurrogateIndices {
  struct Of {
    std::string input;
    Estimate first_order, total;
  };
  std::string quantity;
  IndexVerdict verdict = IndexVerdict::kTold;
  int n = 0, terms = 0;
  double q2 = kUnset;  // share of the variance predicted, cross-validated
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
// All pairs, the strongest first.
[[nodiscard]] std::vector<InputCorrelation> input_correlations(const SampleTable& samples);
// Above this rank correlation two inputs share their influence on a response.
inline constexpr double kEntangled = 0.1;
// Fewest samples an until rule may stop at, and of which a fragility is told.
inline constexpr int kFewestSamples = 20;

// A sample without results, and why.
struct Unanswered {
  int sample = 0;
  std::string status;
  Message reason;
};

// At which peak ground acceleration the samples reach a limit state (docs/theory/assessment.md, A.13).
struct PgaFragility {
  std::string limit_state;             // word of LimitState
  bool is_checked = false;             // the one that the spectrum belongs to
  int n = 0, censored = 0;             // samples with an acceleration; of them lower bounds
  Estimate median, beta_capacity;      // lognormal [m/s^2], [-]; percentile bootstrap
  double beta = kUnset;                // with the records' scatter [-]
  double demand = kUnset;              // acceleration of the spectrum, of the checked one [m/s^2]
  Estimate at_demand;                  // probability that the limit state is reached there
  std::vector<ExceedancePoint> point;  // share of the samples that carry more, Kaplan-Meier
  std::vector<FragilityPoint> curve;   // probability against acceleration [m/s^2]
};
struct CampaignAssessment {
  AssessmentSpec spec;  // of the base model
  // Of the sample in the middle by its participating mass; where none answers, of the base model with a
  // linear shape.
  MassAndShape mass;
  int answered = 0, without_answer = 0;  // samples that ran
  int doubtful = 0;                      // of those answered: not to be signed, but for bounds
  Message reason;                        // why there are no numbers; empty: there may be
  std::vector<Message> notes;
  std::vector<PgaFragility> fragility;  // of each limit state; empty without a spectrum
};
// Of one sample that ran; `model` is that of `base`, the study's base model.
[[nodiscard]] CodeAssessment assess_sample(const SampleRecord& record, const ModelSpec& base,
                                           const Model& model);
// Of all samples that ran.
[[nodiscard]] CampaignAssessment assess_campaign(const Campaign& campaign, const ModelSpec& base,
                                                 const Model& model);

// --- samples under records (docs/theory/fragility.md) ---------------------------------------------

// A shake that does not count, neither as stood nor as fell.
struct LostShake {
  int sample = 0;  // as the store counts
  double intensity = kUnset;
  std::string status;
  Message reason;
};

// Between which intensities a sample first reached a limit state: not at `low`, at `high`. low = 0: at the
// lowest already; high infinite: at none up to `low`.
struct Bracket {
  int sample = 0;
  int wall = 0, record = 0;  // 0-based
  double low = 0, high = 0;  // [SI]
  bool is_known = true;      // false: the shakes that would decide do not count, and it is left out
  bool came_back = false;    // at a higher intensity the limit state is not reached
};

// What can be told of a limit state.
enum class LimitStateVerdict {
  kTold,
  kFewRecords,  // fewer than kFewestRecords
  kNever,       // no sample reached it
  kAlways,      // every sample did at its lowest intensity
  kSeparated,   // one intensity parts all that did from all that did not: no dispersion
  kNoTrend      // it is reached no more often at higher intensities
};
inline constexpr Word<LimitStateVerdict> kLimitStateVerdictWords[] = {
    {"told", LimitStateVerdict::kTold},           {"few records", LimitStateVerdict::kFewRecords},
    {"never", LimitStateVerdict::kNever},         {"always", LimitStateVerdict::kAlways},
    {"separated", LimitStateVerdict::kSeparated}, {"no trend", LimitStateVerdict::kNoTrend}};
inline constexpr int kFewestRecords = 7;  // of which a median and a dispersion are told

// At one intensity: how many samples reached it there, by their shakes at this intensity alone.
struct LimitStateCount {
  double intensity = 0;  // [SI]
  int n = 0, reached = 0, lost = 0;
  Estimate share;  // Wilson, as if the samples were independent
};

// What the scatter of a logarithm comes from: records, walls, and what both do together.
enum class ScatterVerdict {
  kTold,
  kOneKind,     // fewer than kFewestForScatter records or walls
  kNotCrossed,  // not every wall met every record
  kNotReached,  // not every sample has a value
  kWide,        // the brackets are wider than the scatter that is left
};
inline constexpr Word<ScatterVerdict> kScatterVerdictWords[] = {
    {"told", ScatterVerdict::kTold},
    {"one kind", ScatterVerdict::kOneKind},
    {"not crossed", ScatterVerdict::kNotCrossed},
    {"not reached", ScatterVerdict::kNotReached},
    {"wide brackets", ScatterVerdict::kWide}};
inline constexpr int kFewestForScatter = 3;
// Standard deviations of ln; each as an estimate of a two-way layout without repetition. A lower end of 0: it
// may be nothing.
struct Scatter {
  ScatterVerdict verdict = ScatterVerdict::kTold;
  int records = 0, walls = 0;
  Estimate record, wall, rest;
  double bracket = kUnset;  // what halving the bracket leaves, root of the mean square
};

struct LimitStateFragility {
  LimitStateSpec limit_state;
  LimitStateVerdict verdict = LimitStateVerdict::kTold;
  int n = 0, reached = 0, lost = 0, came_back = 0;  // samples with a bracket; of them; left out
  std::vector<Bracket> bracket;
  std::vector<LimitStateCount> count;  // by intensity
  // Lognormal: P = Phi(ln(x / median) / beta), by maximum likelihood [SI], [-].
  Estimate median, beta;
  bool by_bootstrap = false;  // of records and walls; else by profile likelihood
  double log_likelihood = kUnset;
  double count_median = kUnset, count_beta = kUnset;  // from the counts alone (Baker 2015)
  // The median if every sample left out had reached it where its run was lost, and if none had.
  double median_if_reached = kUnset, median_if_not = kUnset;
  std::vector<FragilityPoint> curve;  // within the intensities that ran [SI]
  Scatter scatter;                    // of ln of the intensity where it is reached
};

// Response at one intensity, over all samples that count there.
struct IntensitySummary {
  double intensity = 0;  // [SI]
  int n = 0, collapsed = 0, lost = 0;
  double drift_16 = kUnset, drift_50 = kUnset,
         drift_84 = kUnset;  // peak; infinite where more collapsed
  Scatter scatter;           // of ln of the peak drift
};

struct ShakingStatistics {
  ShakingSpec shaking;           // as the study asks
  std::vector<Message> damping;  // of the shaken stages: what damps them
  int records = 0, walls = 0, samples = 0;
  int shakes = 0, stood = 0, collapsed = 0;
  std::vector<LostShake> lost;
  std::vector<IntensitySummary> intensity;
  std::vector<LimitStateFragility> fragility;
  [[nodiscard]] bool is_told() const { return shakes > 0; }
};
// Whether a shake that counts reached it.
[[nodiscard]] bool reaches(const LimitStateSpec& limit, const ShakeResult& shake);
// Of the samples that ran.
[[nodiscard]] ShakingStatistics shaking_statistics(const Campaign& campaign);

struct Statistics {
  std::string study, design;
  std::uint64_t seed = 0;
  int asked = 0, run = 0, answered = 0;  // samples drawn, run, with a usable curve
  int still_rising = 0;                  // answered, the peak at the end of the push: a lower bound
  int named_earlier = 0;                 // answered, the push ended before read_modes_at
  int collapsed_before_push = 0;         // and have no results for this reason
  double load_height = 0;                // of the base model; drifts take each sample's own [m]
  double read_modes_at = kUnset;         // where modes are to be read [m]
  int replicates = 0;                    // of every bootstrap
  std::map<std::string, int> status;     // of the samples that ran
  std::map<std::string, int> judgement;  // of the samples with a curve: RateVerdict::judgement
  std::vector<Unanswered> unanswered;
  std::vector<std::string> modes;  // FM-1 ... FM-5 where any occurs, other names, "unclear"
  std::vector<InputSummary> input;
  std::vector<InputCorrelation> input_correlation;
  std::vector<GroupSummary> group;  // all, modes taken together, then one by one
  std::vector<Share> share;         // modes, then modes taken together
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
  std::vector<Measuring> measuring;  // by response, the best first
  std::vector<SurrogateIndices> surrogate_indices;
  ShakingStatistics shaking;      // where the samples were shaken
  CampaignAssessment assessment;  // where the model asks for one; set by assess_campaign()
  ProjectSpec project;            // of the base model; set by who has it
};

// A sample counts when its push was completed or ended by collapse and left a curve; all others are
// in `unanswered`. Any campaign will do, an empty one too. Cost: a few seconds for 250 samples.
[[nodiscard]] WallEnsemble ensemble_of(const Campaign& campaign);
[[nodiscard]] Statistics statistics_of(const Campaign& campaign);

// Whether this sample counts in the statistics: it ended, and a force in balance was found.
[[nodiscard]] bool is_answered(const SampleRecord& record);
// Of an answered sample: its largest reaction is the last, so that the wall may resist more.
[[nodiscard]] bool is_still_rising(const SampleRecord& record);

// Throws InputError with every fault of a malformed rule and its cure; "" is no rule.
void check_rule(const std::string& rule);
// The same of an event of a study: "peak_reaction > 150 kN", "drift_at_80_percent > 0.5 %".
[[nodiscard]] FragilityEvent fragility_event(const std::string& text);
// True when every clause of the rule holds and kFewestSamples have answered; `measures` (optional)
// says where each clause stands. "" is never met. Cheap: called after every sample.
[[nodiscard]] bool precise_enough(const std::string& rule, const Campaign& campaign,
                                  Message* measures = nullptr);

}  // namespace wythe
