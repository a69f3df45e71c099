// Scatter of a value between walls and between records: a two-way layout without repetition.
//
//   y(r, w) = m + A(r) + B(w) + E(r, w),   sigma_R^2 = (MS_R - MS_E) / n_w,   sigma_W^2 = (MS_W - MS_E) / n_r
//
// Intervals: Tukey and Williams for the two, chi-square for the rest (Searle, Casella and McCulloch, Variance
// Components (1992), sections 4.4 and 4.5; docs/theory/fragility.md).
#pragma once

#include <vector>

#include "wythe/parts/statistics.h"

namespace wythe::study {

struct Cell {
  int record = 0, wall = 0;  // 0-based
  double value = kUnset;     // logarithm; NaN: none
};
// `bracket`: root mean square of the uncertainty of a value;
// 0 if there is none. `cells` holds every existing pair once.
[[nodiscard]] Scatter scatter_of(const std::vector<Cell>& cells, double bracket);

// The value that an F distribution exceeds with this probability.
[[nodiscard]] double f_quantile_beyond(double probability, int degrees, int below);
// The value below which this share of a beta distribution lies.
[[nodiscard]] double beta_quantile(double share, double a, double b);
// 97.5 % quantile of Student's t; the degrees may be fractional.
[[nodiscard]] double student_97(double degrees);
// The same of chi-square.
[[nodiscard]] double chi_square_quantile_beyond(double probability, int degrees);

}  // namespace wythe::study
