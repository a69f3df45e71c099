// Options side by side: stores whose samples drew the same inputs, compared sample by sample.
//
//   Campaign base, options --compare_campaigns()--> PairedComparison --> comparison.json (io.h), page (report.h)
//
// A pair is one sample that answered in the base and in the option. The two walls of a pair differ by the
// option alone, so their differences scatter far less than the walls do. A sample that answered on one
// side only, or on none, is a lost pair: counted and listed, never left out silently. Intervals are 95 %.
// Estimators: docs/theory/statistics.md, "Pairs".
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/verdict.h"
#include "wythe/parts/words.h"

namespace wythe {

// A store and what it is called.
struct ComparedCampaign {
  std::string name, folder;
  Campaign campaign;
};

// One number of a pair; a bound where the push of that side ended too early.
struct PairValue {
  int sample = 0;
  Reading base, option;
};

// How a difference goes with one random input: who gains.
struct GainAgainstInput {
  std::string input;
  int n = 0;
  Estimate spearman;                       // Fisher
  double p = kUnset, p_adjusted = kUnset;  // of no correlation; Holm over the inputs
  Estimate slope;  // difference per standard deviation of the input, Student
  Estimate low_third, middle_third, high_third;  // mean difference there
};

// Option less base, of one of quantities(). SI.
struct PairedResponse {
  std::string quantity;
  int pairs = 0;          // with a value on both sides
  int without_value = 0;  // answered on both sides, but one or both have no such number
  int bounds = 0;         // of `pairs`: one or both are lower bounds
  int in_means = 0;  // of `pairs`: those that all means, ratios and gains are of; 0: there are none
  int larger = 0, smaller = 0, equal = 0, undecided = 0;  // of `pairs`, bounds taken as such
  // Where a displacement was not reached, means take every value up to here only: the smallest of the
  // bounds, which no sample's own value can fall short of. NaN: nothing is cut. There is no mean where
  // that would cut most pairs or leave no scatter.
  double up_to = kUnset;
  Estimate base, option, difference;  // means (Student); from five pairs on with intervals
  Interval difference_bootstrap;      // of the same mean, BCa: another view where tails are heavy
  Estimate ratio;  // geometric mean of option / base; NaN unless all are positive
  double standard_deviation = kUnset;  // of the differences
  Interval median_bounds;              // of the median difference, which bounds may leave open
  Interval median_interval;            // order statistics (sign test); infinite where open
  Estimate share_larger;            // larger / pairs; the interval lets the undecided go either way
  Interval share_larger_with_lost;  // if every lost pair went one way, or the other
  double sign_test_p = kUnset;      // undecided pairs against the finding
  Estimate cov_base, cov_option, cov_ratio;  // percentile bootstrap over pairs
  double correlation = kUnset;               // of the two sides
  double worth = kUnset;  // samples without pairing that give as narrow an interval, for each pair
  int slow_enough = 0;    // pairs both of whose pushes were slow enough
  Estimate difference_slow_enough;     // mean difference of those
  std::vector<GainAgainstInput> gain;  // by each random input
  std::vector<PairValue> pair;
};

struct ModeShift {
  std::string mode;
  int base = 0, option = 0;   // pairs with this mode there
  int came = 0, went = 0;     // pairs that have it in the option only, in the base only
  Estimate share_difference;  // (Agresti and Min)
  double p = kUnset, p_adjusted = kUnset;  // exact McNemar; Holm over the modes
};
struct ChangedMode {
  int sample = 0;
  std::string base, option;
};
struct ModeTable {
  std::vector<std::string> modes;
  std::vector<std::vector<int>> count;  // (base mode, option mode)
  int pairs = 0;                        // all
  int unclear = 0;         // of them: unclear on a side or both; what changes is of the others
  int read_apart = 0;      // of the others: read at displacements that differ by more than 1 %
  int changed_apart = 0;   // of these: of another mode
  Estimate share_changed;  // Wilson
  std::vector<ChangedMode> changed;
  std::vector<ModeShift> shift;
  std::vector<ModeShift>
      group_shift;    // of FM-1 + FM-2 (piers) and FM-3 + FM-4 (spandrel) taken as one
  double p = kUnset;  // of equal shares: the smallest p_adjusted
};

struct LostPair {
  int sample = 0;
  std::string base_status, option_status;  // "" where it has not run
  Message base_reason, option_reason;
  bool base_answered = false, option_answered = false;
};

struct OptionComparison {
  std::string name, folder;
  PushLabel push;                    // of models: which way it was pushed
  std::string base_folder;           // and its base then
  std::vector<std::string> changes;  // what its study and model say and the base's do not
  int pairs = 0;
  int not_run = 0;  // samples that neither side has run
  std::vector<LostPair> lost;
  int base_alone = 0, option_alone = 0;     // lost pairs that only this side answered
  int not_slow_enough = 0;                  // pairs with a push that was not slow enough
  int too_fast = 0;                         // of them, "too fast" or not known how fast
  int rising_base = 0, rising_option = 0;   // pairs whose force was still rising there
  int same_bits = 0;                        // pairs with the same state hash
  double steps_base = 0, steps_option = 0;  // mean of the pairs: what the option costs
  std::vector<PairedResponse> response;     // (quantities())
  ModeTable modes;
  std::vector<Message> notes;  // what to know before any number
  Message headline;            // the difference in one sentence
};

// --- before and after (docs/theory/statistics.md, "Before and after") ---------------------------------------

// Whether a change keeps within its limits. Not shown: its interval reaches over a limit.
enum class ChangeAnswer { kYes, kNo, kNotShown, kNotKnown };
inline constexpr Word<ChangeAnswer> kChangeAnswerWords[] = {{"yes", ChangeAnswer::kYes},
                                                            {"no", ChangeAnswer::kNo},
                                                            {"not shown", ChangeAnswer::kNotShown},
                                                            {"not known", ChangeAnswer::kNotKnown}};
// By which share stiffness may change, and strength and displacement capacity may fall [-]. None of the defaults was
// verified against the text of a code. NaN: the default.
struct ChangeLimits {
  double stiffness = kUnset, strength = kUnset, displacement = kUnset;
};
inline constexpr ChangeLimits kUsualLimits{.stiffness = 0.15, .strength = 0, .displacement = 0};

// After over before, pushed one way.
struct Change {
  PushLabel push;
  int pairs = 0;
  Estimate ratio;  // geometric mean of pairs (Student); of one pair without an interval
  bool at_least = false, at_most = false;  // only one side holds bounds: `ratio` is one, too
  bool is_same = false;                    // all pairs are equal
  ChangeAnswer answer = ChangeAnswer::kNotKnown;
  Message why;  // it is not known; empty: it is
};
struct CheckedChange {
  std::string quantity;     // initial_stiffness, peak_reaction, displacement_at_80_percent
  double least = 0;         // ratios that the limits allow
  double most = kUnset;     // NaN: any
  bool is_default = false;  // the limit is that of kUsualLimits
  std::vector<Change> way = {};
  ChangeAnswer answer = ChangeAnswer::kNotKnown;  // of all ways
  std::size_t worst = 0;                          // the way that has it, farthest from the limits
  Message what = {}, said = {};                   // quantity and answer, in words
};
// PGA that a model carries [m/s^2], of the way that decides (WallsVerdict).
struct ModelCapacity {
  Estimate pga;
  bool at_least = false;
};
// A model against the one before it, pushed all ways.
struct Intervention {
  std::string name;
  std::vector<std::size_t> option = {};  // of PairedComparison::option, one a way of pushing
  std::vector<CheckedChange> change = {};
  ChangeAnswer answer = ChangeAnswer::kNotKnown;
  ModelCapacity before = {}, after = {};  // NaN: the models have no [assessment]
  std::vector<Message> cautions = {};     // why not to rely on it, before any number
  Message sentence = {};                  // cautions and changes
  std::vector<Message> notes = {};
};

struct PairedComparison {
  std::string study, provenance;  // of the base
  std::string base_name, base_folder;
  int samples = 0;                         // drawn in all stores alike
  std::vector<InputColumn> input;          // random ones
  std::vector<std::vector<double>> value;  // (samples, input) [SI]
  std::vector<OptionComparison> option;
  std::vector<Message> notes;
  std::vector<Intervention> intervention;  // of models alone
};

// The first is the base. Throws InputError with the first difference of each store whose samples drew
// other inputs than the base's, and where two are the same store. Cost: about a second an option.
[[nodiscard]] PairedComparison compare_campaigns(const std::vector<ComparedCampaign>& stores);

// The same walls pushed one way: the campaign of the model before, then of those after it.
struct ComparedWay {
  PushLabel push;
  std::vector<ComparedCampaign> stores;
};
struct ComparedModels {
  std::vector<std::string> name;  // of the models, the one before first
  std::vector<ComparedWay> way;
  std::vector<ModelCapacity> capacity;  // of each model; none without [assessment]
  std::vector<int>
      other_draws;  // models whose places in the wall drew other numbers than the base's
  ChangeLimits limits;
};
// Models in all their ways: each way an option of its own, beside the base pushed that way, and what each model changes.
[[nodiscard]] PairedComparison compare_models(const ComparedModels& models);
// The change of one response in so many pairs, of which `lost` did not answer, against `least` and `most`.
[[nodiscard]] Change change_of(const PairedResponse& response, int lost, double least, double most);

// What `wythe compare` of model files is asked for.
struct AskedModels {
  std::vector<std::string> files;           // the one before first
  std::vector<std::string> overrides = {};  // --set, of all
  int walls = 8, seed = 0;
};
// A study for each model: its walls, and its push the other way as the only [[variant]]; one wall where nothing scatters.
// Throws InputError with every fault of the models, and where they are not comparable: what differs, and where it stands.
[[nodiscard]] std::vector<StudySpec> studies_of_models(const AskedModels& asked);
// Whether PGA is told of models: they have an [assessment] with a spectrum.
[[nodiscard]] inline bool says_pga(const AssessmentSpec& spec) {
  return is_asked(spec) && spec.spectrum.kind != SpectrumKind::kNone;
}

// What a difference of drawn inputs is; "" where the samples of both that there are drew the same.
[[nodiscard]] std::string other_inputs(const SampleTable& base, const SampleTable& other);

}  // namespace wythe
