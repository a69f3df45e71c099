// Displacements of which some are only lower bounds: Kaplan-Meier and a censored lognormal.
//
// A push that ends before the force has fallen says "farther than 50 mm". The largest such numbers
// are not the capacity; leaving them out, or taking them as they stand, underrates the wall.
// References: Kaplan and Meier (1958), Greenwood (1926); Klein and Moeschberger, Survival Analysis
// (2003), eq. 4.3.2 (log-log interval); Dempster, Laird and Rubin (1977) for the fit.
#pragma once

#include <vector>

#include "statistics/bootstrap.h"
#include "wythe/parts/statistics.h"

namespace wythe::study {

// Readings ascending; of equal values the observed stand before the censored.
[[nodiscard]] std::vector<Reading> in_order(std::vector<Reading> readings);

// Share that goes beyond each observed value, and its interval; readings in order.
[[nodiscard]] std::vector<ExceedancePoint> kaplan_meier(const std::vector<Reading>& in_order);
// Share that has fallen before x: (7.3) where nothing is unknown, Kaplan-Meier up to the last reading,
// Wilson's of those still going on where none has fallen yet. Beyond the last reading only a lower
// bound is known: those that fell, up to all; nothing where all are unknown.
[[nodiscard]] Estimate share_before(const std::vector<Reading>& in_order, double x);

// The same, weighted: what the bootstrap calls.
[[nodiscard]] double survival_mean(const std::vector<Reading>& in_order, const Counts& count);
// Least value that a share p does not exceed; infinite when the curve never falls so far.
[[nodiscard]] double survival_quantile(const std::vector<Reading>& in_order, const Counts& count,
                                       double p);

// Lognormal of greatest likelihood; NaN below two different observed values.
struct Lognormal {
  double median = kUnset, beta = kUnset;  // [SI], standard deviation of the logarithm [-]
  [[nodiscard]] double exceedance(double x) const;
};
[[nodiscard]] Lognormal fit_lognormal(const std::vector<Reading>& readings, const Counts& count);

// The fits of the replicates, and what 95 % of them hold.
struct LognormalReplicates {
  std::vector<Lognormal> fit;
  Interval median, beta;
};
[[nodiscard]] LognormalReplicates lognormal_replicates(const std::vector<Reading>& in_order,
                                                       const Lognormal& fit);

// Exceedance curve, fit and misfit of a quantity.
[[nodiscard]] Exceedance exceedance_of(const std::string& quantity, std::vector<Reading> readings);

}  // namespace wythe::study
