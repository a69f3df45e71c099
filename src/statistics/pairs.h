// Statistics of pairs: differences, signs, bounds. Formulas: docs/theory/statistics.md, "Pairs".
#pragma once

#include <vector>

#include "statistics/correlation.h"
#include "wythe/parts/comparison.h"

namespace wythe::study {

// P(at most k of n), each with probability one half.
[[nodiscard]] double fair_tail(int k, int n);
// Two-sided sign test of `a` against `b`; `open` ones count for the smaller side.
[[nodiscard]] double sign_test(int a, int b, int open = 0);
// p-values corrected for several tests (Holm); NaN stays.
[[nodiscard]] std::vector<double> holm(const std::vector<double>& p);

// The interval in which a pair's difference lies.
[[nodiscard]] Interval difference_bounds(const PairValue& pair);
// All numbers of a response except its gains. `cut`: means go up to the smallest bound;
// else they use pairs without a bound. `lost` pairs count in share_larger_with_lost.
[[nodiscard]] PairedResponse paired_response(std::vector<PairValue> pairs, bool cut, int lost);
// Whether a pair is used for means, where there are means.
[[nodiscard]] bool enters_means(const PairedResponse& response, const PairValue& pair);
// Differences as used for the mean.
[[nodiscard]] Column differences(const PairedResponse& response);

// `input` (n_input, n_pair) beside the differences.
[[nodiscard]] std::vector<GainAgainstInput> gains(const std::vector<Column>& input,
                                                  const std::vector<std::string>& name,
                                                  const Column& difference);

// Whether a mode has a name, so is not unclear.
[[nodiscard]] bool is_named(const std::string& mode);

// Modes of pairs; `order`: names in the order of the list.
[[nodiscard]] ModeTable mode_table(const std::vector<ChangedMode>& pairs,
                                   const std::vector<std::string>& order);

}  // namespace wythe::study
