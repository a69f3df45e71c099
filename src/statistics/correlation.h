// How inputs and responses go together: Pearson, Spearman, partial rank, first-order indices.
//
// Reference: Helton et al., Reliab. Eng. Syst. Saf. 91 (2006), sections 6.4 to 6.6 (ranks, partial
// correlation); Kelley, PNAS 21 (1935) (correlation ratio without its bias).
#pragma once

#include <vector>

#include "wythe/parts/statistics.h"

namespace wythe::study {

using Column = std::vector<double>;

// Ranks from 1 to n; equal values get their mean rank.
[[nodiscard]] Column ranks(const Column& values);
// The same where some are lower bounds: the mean of the ranks that each can have, (7.9) of
// docs/theory/statistics.md. Bounds that no observed value separates tie, wherever their pushes ended.
[[nodiscard]] Column ranks(const std::vector<Reading>& readings);
// None of them a bound.
[[nodiscard]] std::vector<Reading> observed(const Column& values);
// NaN when either is constant or there are fewer than three values.
[[nodiscard]] double pearson(const Column& x, const Column& y);

// Partial correlation of x[k] with y, the other columns of x held, for every k: the correlation
// of what a linear fit to the others leaves of both. NaN where nothing is left (x[k] or y follows from
// the others).
[[nodiscard]] Column partial_correlations(const std::vector<Column>& x, const Column& y);

// All three of every input with one response, with their intervals.
[[nodiscard]] std::vector<Correlation> correlate(const std::vector<Column>& inputs,
                                                 const std::vector<Reading>& response);

// First-order index by the correlation ratio over bins of equal count, less what chance adds:
//   S = (SSB - (bins - 1) MSW) / SST,  MSW = SSW / (n - bins)
// The curve of the mean within a bin is lost: S comes out low by about S / bins^2. Needs
// kFewestSamples.
[[nodiscard]] FirstOrderIndex first_order_index(const Column& input, const Column& response);

// Bin of each value when sorted into `bins` of equal count (differing by one at most).
[[nodiscard]] std::vector<int> equal_bins(const Column& values, int bins);

}  // namespace wythe::study
