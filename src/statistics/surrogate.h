// Sparse polynomial of the inputs that follows a response: which products of Legendre polynomials it
// needs (surrogate.cpp, a door to OpenTURNS).
#pragma once

#include <vector>

#include "campaign/draws/sampling.h"

namespace wythe {

// Degree in each input; all 0 is the mean.
using Term = std::vector<int>;

// Terms chosen by least angle regression with the corrected leave-one-out error (Blatman and Sudret, J.
// Comput. Phys. 230, 2011) among those up to `degree` in all; inputs in (0, 1), (n_input, n_sample). The
// mean is always among them. Deterministic.
[[nodiscard]] std::vector<Term> chosen_terms(const Columns& inputs,
                                             const std::vector<double>& response, int degree);

}  // namespace wythe
