// Designs: where each sample lies in the probability of each variable.
//
//   unit_design()         u(i, j) in (0, 1)
//   impose_correlation()  correlates columns of u (correlation.h)
//   Margin                u -> value of one variable, truncation included (margin.h)
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "wythe/parts/study.h"

namespace wythe {

using Columns = std::vector<std::vector<double>>;  // (n_variable, n_sample)

struct DesignRequest {
  Design design = Design::kLatinHypercube;
  int samples = 0;
  std::uint64_t seed = 0;
  int batch = 0;
};
// One column for each name, from its own stream. So a column does not depend on the
// others, except for the dimension of a Sobol sequence, which follows the order of names.
//   Latin hypercube  one sample in each of n equal strata, at random in it (McKay et al. 1979)
//   Monte Carlo      independent
//   Sobol            the first n points of the sequence, digitally shifted by the seed
[[nodiscard]] Columns unit_design(const DesignRequest& request,
                                  const std::vector<std::string>& names);
// Largest number of variables of a Sobol design.
[[nodiscard]] int most_sobol_variables();

}  // namespace wythe
