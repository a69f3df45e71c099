// Displacements that are partly lower bounds: Kaplan-Meier and a censored lognormal.
//
// A push that ends before the force has fallen gives "farther than 50 mm". Using
// such numbers as capacities, or leaving them out, underestimates the wall.
// References: Kaplan and Meier (1958); Fay, Brittain and Proschan (2013) for the interval; Dempster, Laird and Rubin
// (1977) for the fit.
#pragma once

#include <vector>

#include "statistics/bootstrap.h"
#include "wythe/parts/statistics.h"

namespace wythe::study {

// Readings in ascending order; among equal values the observed ones come first.
[[nodiscard]] std::vector<Reading> in_order(std::vector<Reading> readings);

// Share that exceeds each observed value, and its interval (7.5): that of a share where no bound lies below. Readings
// must be sorted.
[[nodiscard]] std::vector<ExceedancePoint> kaplan_meier(const std::vector<Reading>& in_order);
// Share that has fallen before x: (7.3) without unknown readings, else Kaplan-Meier up to the last
// reading, with the interval (7.5). Beyond the last reading only a lower bound is known: the fallen
// ones, up to all. None where all are unknown.
[[nodiscard]] Estimate share_before(const std::vector<Reading>& in_order, double x);

// The same with weights, for the bootstrap.
[[nodiscard]] double survival_mean(const std::vector<Reading>& in_order, const Counts& count);
// The value at share p: quantile_of() as long as no bound lies below it (7.6b). Infinite beyond the last observed value,
// where bounds follow it.
[[nodiscard]] double survival_quantile(const std::vector<Reading>& in_order, const Counts& count,
                                       double p);

// Maximum likelihood lognormal; NaN with less than two different observed values.
struct Lognormal {
  double median = kUnset, beta = kUnset;  // [SI], standard deviation of the logarithm [-]
  [[nodiscard]] double exceedance(double x) const;
};
[[nodiscard]] Lognormal fit_lognormal(const std::vector<Reading>& readings, const Counts& count);

// The fits of the replicates, and the intervals that contain 95 % of them.
struct LognormalReplicates {
  std::vector<Lognormal> fit;
  Interval median, beta;
};
[[nodiscard]] LognormalReplicates lognormal_replicates(const std::vector<Reading>& in_order,
                                                       const Lognormal& fit);

// Exceedance curve, fit and misfit of a quantity.
[[nodiscard]] Exceedance exceedance_of(const std::string& quantity, std::vector<Reading> readings);

}  // namespace wythe::study
