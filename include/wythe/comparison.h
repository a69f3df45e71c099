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

#include "wythe/campaign.h"
#include "wythe/statistics.h"

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

struct PairedComparison {
  std::string study, provenance;  // of the base
  std::string base_name, base_folder;
  int samples = 0;                         // drawn in all stores alike
  std::vector<InputColumn> input;          // random ones
  std::vector<std::vector<double>> value;  // (samples, input) [SI]
  std::vector<OptionComparison> option;
  std::vector<Message> notes;
};

// The first is the base. Throws InputError with the first difference of each store whose samples drew
// other inputs than the base's, and where two are the same store. Cost: about a second an option.
[[nodiscard]] PairedComparison compare_campaigns(const std::vector<ComparedCampaign>& stores);

// What a difference of drawn inputs is; "" where the samples of both that there are drew the same.
[[nodiscard]] std::string other_inputs(const SampleTable& base, const SampleTable& other);

}  // namespace wythe
