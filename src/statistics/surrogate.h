// A sparse polynomial of the inputs that approximates a response: selects the products of Legendre polynomials.
#pragma once

#include <vector>

namespace wythe {

// Degree in each input; all 0 is the mean.
using Term = std::vector<int>;
using Columns = std::vector<std::vector<double>>;  // (n_variable, n_sample)

// Values of each term, a product of Legendre polynomials orthonormal on (0, 1), at each sample: (n_term, n_sample).
[[nodiscard]] Columns legendre_products(const std::vector<Term>& terms, const Columns& inputs);

// Terms selected by least angle regression (Efron et al. 2004) with the corrected
// leave-one-out error (Blatman and Sudret, J. Comput. Phys. 230, 2011), up to total degree
// `degree`. Inputs in (0, 1), (n_input, n_sample). The mean is always included. Deterministic.
[[nodiscard]] std::vector<Term> chosen_terms(const Columns& inputs,
                                             const std::vector<double>& response, int degree);

}  // namespace wythe
