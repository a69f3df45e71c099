// Relations of inputs and responses: Pearson, Spearman, partial rank correlation, first-order indices.
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
// The same where some values are lower bounds: each gets the mean of its possible ranks, (7.9) of
// docs/theory/statistics.md. Bounds with no observed value between them get equal ranks, wherever their pushes ended.
[[nodiscard]] Column ranks(const std::vector<Reading>& readings);
// Readings without bounds.
[[nodiscard]] std::vector<Reading> observed(const Column& values);
// NaN when either is constant or there are fewer than three values.
[[nodiscard]] double pearson(const Column& x, const Column& y);

// Partial correlation of x[k] with y for every k, with the other
// columns of x held: the correlation of the residuals of a linear
// fit to the others. NaN where x[k] or y follows from the others.
[[nodiscard]] Column partial_correlations(const std::vector<Column>& x, const Column& y);

// The three correlations of every input with one response, with their intervals.
[[nodiscard]] std::vector<Correlation> correlate(const std::vector<Column>& inputs,
                                                 const std::vector<Reading>& response);

// First-order index by the correlation ratio over bins of equal count, less the part of chance:
//   S = (SSB - (bins - 1) MSW) / SST,  MSW = SSW / (n - bins)
// The variation of the mean within a bin is lost, so S is
// too small by about S / bins^2. Needs kFewestSamples.
[[nodiscard]] FirstOrderIndex first_order_index(const Column& input, const Column& response);

// Bin of each value when sorted into `bins` of equal count (differing by one at most).
[[nodiscard]] std::vector<int> equal_bins(const Column& values, int bins);

}  // namespace wythe::study
