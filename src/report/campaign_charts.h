// The pictures of a campaign's page, each an SVG element, "" where there is nothing to draw.
#pragma once

#include <string>

#include "wythe/campaign.h"
#include "wythe/statistics.h"

namespace wythe::report {

// Style class of a mode's colour: FM-1 ... FM-5 have their own, other names take turns.
[[nodiscard]] std::string mode_class(const std::vector<std::string>& modes,
                                     const std::string& mode);
[[nodiscard]] std::string mode_legend(const Statistics& statistics);
// Rules of all charts here, with the modes' colours.
[[nodiscard]] std::string campaign_style();

// Every curve, coloured by mode, to its end or to where it falls to 80 % of its peak.
enum class CurvesTo { kEnd, k80Percent };
[[nodiscard]] std::string curves_svg(const Campaign& campaign, const Statistics& statistics,
                                     CurvesTo to = CurvesTo::kEnd);
[[nodiscard]] std::string mean_curves_svg(const Statistics& statistics);
[[nodiscard]] std::string shares_svg(const Statistics& statistics);
// Running mean of quantity `q` of quantities().
[[nodiscard]] std::string running_svg(const Statistics& statistics, std::size_t q);
// P(X > x) with the lognormal; displacements as drift, with the code's limits.
[[nodiscard]] std::string exceedance_svg(const Statistics& statistics,
                                         const Exceedance& exceedance);
[[nodiscard]] std::string scatter_svg(const Campaign& campaign, const Statistics& statistics,
                                      int column, std::size_t q);
// Shares of the modes in the bins of one input, stacked.
[[nodiscard]] std::string mode_bins_svg(const Statistics& statistics,
                                        const ModeAgainstInput& against);
// Spearman's correlation of every input with a response, with its interval.
[[nodiscard]] std::string correlation_svg(const CorrelationTable& table);
// Histogram of an input as drawn, with its density where it is a plain normal or lognormal.
[[nodiscard]] std::string histogram_svg(const Campaign& campaign, int column);

}  // namespace wythe::report
