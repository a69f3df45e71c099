// Compares options: stores whose samples drew the same inputs are compared sample by sample.
//
//   Campaign base, options --compare_campaigns()--> PairedComparison --> comparison.json (io.h), page (report.h)
//
// A pair is one sample that answered in the base and in the option. The two walls of a pair differ only in
// the option, so their differences scatter far less than the walls do. A sample that answered on one side
// side only, or on none, is a lost pair: counted and listed, never left out silently. Intervals are 95 %.
// Estimators: docs/theory/statistics.md, "Pairs".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/verdict.h"
#include "wythe/parts/words.h"

namespace wythe {

// What the push of a wall does not tell of a slower push (slow_push.h).
struct PushDoubt {
  Message displacement = {};  // why not its displacement capacity, with its cures; empty: it does
  bool mode = false;          // whether not its failure mode
};
// The doubts of a campaign whose base model is `model`, by sample; samples without one are left out. Where several walls are pushed
// and wait at cracks, their scatter replaces all doubts but that of a push too fast for its force.
[[nodiscard]] std::map<int, PushDoubt> doubts_of(const Campaign& campaign, const Model& model);

// A store with its name for the reader.
struct ComparedCampaign {
  std::string name, folder;
  Campaign campaign;
  std::map<int, PushDoubt> doubt = {};  // by sample; only models before and after state them
};

// One number of a pair. It is a bound where the push of that side ended too early.
struct PairValue {
  int sample = 0;
  Reading base, option;
};

// How the difference of a response depends on one random input: which walls gain.
struct GainAgainstInput {
  std::string input;
  int n = 0;
  Estimate spearman;                       // interval by Fisher's z
  double p = kUnset, p_adjusted = kUnset;  // of no correlation; Holm over the inputs
  Estimate slope;  // difference per standard deviation of the input, Student
  Estimate low_third, middle_third, high_third;  // mean difference in the thirds of the input
};

// Differences option - base of one response of quantities() [SI].
struct PairedResponse {
  std::string quantity;
  int pairs = 0;          // with a value on both sides
  int without_value = 0;  // answered on both sides, but at least one lacks this number
  int bounds = 0;         // of `pairs`: at least one value is a lower bound
  int in_means = 0;       // number of `pairs` in all means, ratios and gains; 0: there are none
  int larger = 0, smaller = 0, equal = 0, undecided = 0;  // of `pairs`; bounds count as bounds
  // Where a displacement was not reached, means limit every value to this one: the smallest bound, which
  // each sample is known to reach. NaN: no value is limited. There is no mean where this would limit most
  // pairs or leave no scatter.
  double up_to = kUnset;
  Estimate base, option, difference;  // means (Student); intervals from five pairs on
  Interval difference_bootstrap;      // BCa interval of the mean difference, for heavy tails
  Estimate ratio;  // geometric mean of option / base; NaN unless all are positive
  double standard_deviation = kUnset;  // of the differences
  Interval median_bounds;              // of the median difference; infinite where open
  Interval median_interval;            // order statistics (sign test); infinite where open
  Estimate share_larger;            // larger / pairs; the interval counts the undecided either way
  Interval share_larger_with_lost;  // if every undecided or lost pair went one way, or the other
  double sign_test_p = kUnset;      // undecided pairs count against the finding
  Estimate cov_base, cov_option, cov_ratio;  // percentile bootstrap over pairs
  double correlation = kUnset;               // of the two sides
  double worth = kUnset;  // (s_a^2 + s_b^2) / s_d^2: unpaired samples that a pair replaces
  int slow_enough = 0;    // pairs in which both pushes were slow enough
  Estimate difference_slow_enough;  // their mean difference
  int doubted = 0;  // pairs with a push that does not tell this number of a slower one
  Message doubt;    // why, of the first such pair
  std::vector<GainAgainstInput> gain;  // by each random input
  std::vector<PairValue> pair;
};

struct ModeShift {
  std::string mode;
  int base = 0, option = 0;   // pairs with this mode there
  int came = 0, went = 0;     // pairs with this mode in the option only, in the base only
  Estimate share_difference;  // interval by Agresti and Min
  double p = kUnset, p_adjusted = kUnset;  // exact McNemar; Holm over the modes
};
struct ChangedMode {
  int sample = 0;
  std::string base, option;
};
struct ModeTable {
  std::vector<std::string> modes;
  std::vector<std::vector<int>> count;  // (base mode, option mode)
  int pairs = 0;                        // all pairs
  int unclear = 0;         // of them: unclear on at least one side; the other counts exclude these
  int read_apart = 0;      // of the others: read at displacements that differ by more than 1 %
  int changed_apart = 0;   // of these: the mode differs
  int doubted = 0;         // of all: with a push that does not tell the mode of a slower one
  Estimate share_changed;  // Wilson
  std::vector<ChangedMode> changed;
  std::vector<ModeShift> shift;
  std::vector<ModeShift>
      group_shift;    // FM-1 + FM-2 (piers) and FM-3 + FM-4 (spandrel) as one mode each
  double p = kUnset;  // of equal shares of modes: the smallest p_adjusted
};

struct LostPair {
  int sample = 0;
  std::string base_status, option_status;  // "" where it has not run
  Message base_reason, option_reason;
  bool base_answered = false, option_answered = false;
};

struct OptionComparison {
  std::string name, folder;
  PushLabel push;                    // of models: the way of pushing
  std::string base_folder;           // the folder of the base in that way
  std::vector<std::string> changes;  // what its study and model state beyond the base's
  int pairs = 0;
  int not_run = 0;  // samples that neither side has run
  std::vector<LostPair> lost;
  int base_alone = 0, option_alone = 0;     // lost pairs that only this side answered
  int not_slow_enough = 0;                  // pairs with a push that was not slow enough
  int too_fast = 0;                         // of them, "too fast" or not known how fast
  int rising_base = 0, rising_option = 0;   // pairs whose force was still rising on that side
  int same_bits = 0;                        // pairs with the same state hash
  double steps_base = 0, steps_option = 0;  // means over the pairs, for the cost of the option
  std::vector<PairedResponse> response;     // (quantities())
  ModeTable modes;
  std::vector<Message> notes;  // cautions to read before any number
  Message headline;            // the difference in one sentence
};

// --- before and after (docs/theory/statistics.md, "Before and after") ---------------------------------------

// Whether a change keeps within its limits. Not shown: its interval crosses a limit.
enum class ChangeAnswer { kYes, kNo, kNotShown, kNotKnown };
inline constexpr Word<ChangeAnswer> kChangeAnswerWords[] = {{"yes", ChangeAnswer::kYes},
                                                            {"no", ChangeAnswer::kNo},
                                                            {"not shown", ChangeAnswer::kNotShown},
                                                            {"not known", ChangeAnswer::kNotKnown}};
// Shares by which stiffness may change, and strength and displacement capacity may fall [-]; NaN: the default. The
// defaults were not verified against the text of a code.
struct ChangeLimits {
  double stiffness = kUnset, strength = kUnset, displacement = kUnset;
};
inline constexpr ChangeLimits kUsualLimits{.stiffness = 0.15, .strength = 0, .displacement = 0};

// Ratio after / before of a response, for one way of pushing.
struct Change {
  PushLabel push;
  int pairs = 0;
  Estimate ratio;  // geometric mean of pairs (Student); of one pair without an interval
  bool at_least = false, at_most = false;  // only one side has bounds, so `ratio` is a bound
  bool is_same = false;                    // all pairs are equal
  ChangeAnswer answer = ChangeAnswer::kNotKnown;
  Message why;  // why the answer is not known; empty where it is
};
struct CheckedChange {
  std::string quantity;     // initial_stiffness, peak_reaction, displacement_at_80_percent
  double least = 0;         // range of the ratio that the limits allow
  double most = kUnset;     // NaN: no upper limit
  bool is_default = false;  // the limit is that of kUsualLimits
  std::vector<Change> way = {};
  ChangeAnswer answer = ChangeAnswer::kNotKnown;  // over all ways
  std::size_t worst = 0;                          // the way that decides, farthest off the limits
  Message what = {}, said = {};                   // quantity and answer, in words
};
// PGA capacity of a model [m/s^2], of the decisive way of pushing (WallsVerdict).
struct ModelCapacity {
  Estimate pga;
  bool at_least = false;
};
// A model compared with the one before it, over all ways of pushing.
struct Intervention {
  std::string name;
  std::vector<std::size_t> option = {};  // into PairedComparison::option, one a way of pushing
  std::vector<CheckedChange> change = {};
  ChangeAnswer answer = ChangeAnswer::kNotKnown;
  ModelCapacity before = {}, after = {};  // NaN: the models have no [assessment]
  std::vector<Message> cautions = {};     // why not to rely on it; printed before any number
  Message sentence = {};                  // cautions, then changes
  std::vector<Message> notes = {};
};

struct PairedComparison {
  std::string study, provenance;  // of the base
  std::string base_name, base_folder;
  int samples = 0;                         // drawn alike in all stores
  std::vector<InputColumn> input;          // the random inputs
  std::vector<std::vector<double>> value;  // (samples, input) [SI]
  std::vector<OptionComparison> option;
  std::vector<Message> notes;
  std::vector<Intervention> intervention;  // for models only
};

// Compares the stores with the first one, the base. Throws InputError where samples drew other inputs than the
// base's (with the first difference of each store), and where two stores are the same. Cost: a second an option.
[[nodiscard]] PairedComparison compare_campaigns(const std::vector<ComparedCampaign>& stores);

// Campaigns of the same walls pushed in one way: the model before first, then those after it.
struct ComparedWay {
  PushLabel push;
  std::vector<ComparedCampaign> stores;
};
struct ComparedModels {
  std::vector<std::string> name;  // of the models; the model before comes first
  std::vector<ComparedWay> way;
  std::vector<ModelCapacity> capacity;  // of each model; empty without [assessment]
  std::vector<std::vector<std::string>>
      differences;  // of each model from the first (model_differences)
  std::vector<int>
      other_draws;  // models whose fields drew other numbers than the base's at the same places
  ChangeLimits limits;
};
// Compares models over all ways of pushing. Each way is an option with its own base; each model gets an Intervention.
[[nodiscard]] PairedComparison compare_models(const ComparedModels& models);
// The change of one response over its pairs and `lost` unanswered ones, judged against the limits `least` and `most`.
[[nodiscard]] Change change_of(const PairedResponse& response, int lost, double least, double most);

// Request of `wythe compare` for model files.
struct AskedModels {
  std::vector<std::string> files;           // the model before comes first
  std::vector<std::string> overrides = {};  // texts of --set, for all models
  int walls = 8, seed = 0;
};
// Keys in which a model differs from the base, names aside: "wall.floor.0.load: 10 kN/m → 12 kN/m", "+ wall.opening.shop" of
// what the base has not, "− …" of what it alone has.
[[nodiscard]] std::vector<std::string> model_differences(const ModelSpec& base,
                                                         const ModelSpec& other);
// One study for each model: its walls, and the opposite push as the only [[variant]]; one wall where nothing scatters. Throws
// InputError with every fault of the models, and where models are not comparable: with the difference and its place.
[[nodiscard]] std::vector<StudySpec> studies_of_models(const AskedModels& asked);
// Whether PGA can be given for models: they have an [assessment] with a spectrum.
[[nodiscard]] inline bool says_pga(const AssessmentSpec& spec) {
  return is_asked(spec) && spec.spectrum.kind != SpectrumKind::kNone;
}

// Describes the first difference between drawn inputs; "" where the samples present on both sides drew the same.
[[nodiscard]] std::string other_inputs(const SampleTable& base, const SampleTable& other);

}  // namespace wythe
