// Lets OpenTURNS choose the terms: Legendre products up to a total degree, thinned by least angle regression.
// OpenTURNS is held with its default settings for one caller at a time. A constant response keeps the mean alone.
#include "statistics/surrogate.h"

#include <openturns/ComposedDistribution.hxx>
#include <openturns/CorrectedLeaveOneOut.hxx>
#include <openturns/Exception.hxx>
#include <openturns/FixedStrategy.hxx>
#include <openturns/FunctionalChaosAlgorithm.hxx>
#include <openturns/LARS.hxx>
#include <openturns/LeastSquaresMetaModelSelectionFactory.hxx>
#include <openturns/LeastSquaresStrategy.hxx>
#include <openturns/LinearEnumerateFunction.hxx>
#include <openturns/Log.hxx>
#include <openturns/OrthogonalProductPolynomialFactory.hxx>
#include <openturns/Uniform.hxx>

#include <algorithm>

namespace wythe {

std::vector<Term> chosen_terms(const Columns& inputs, const std::vector<double>& response,
                               int degree) {
  const OT::UnsignedInteger dimension = inputs.size(), n = response.size();
  const OpenTurnsAsDelivered held;
  OT::Log::Show(OT::Log::NONE);  // it would write warnings between our lines
  OT::Sample x(n, dimension), y(n, 1);
  for (OT::UnsignedInteger i = 0; i < n; ++i) {
    for (OT::UnsignedInteger k = 0; k < dimension; ++k) x(i, k) = inputs[k][i];
    y(i, 0) = response[i];
  }
  const OT::ComposedDistribution cube(
      OT::ComposedDistribution::DistributionCollection(dimension, OT::Uniform(0.0, 1.0)));
  const OT::LinearEnumerateFunction order(dimension);
  const OT::OrthogonalProductPolynomialFactory basis(
      OT::ComposedDistribution::DistributionCollection(dimension, OT::Uniform(0.0, 1.0)), order);
  const OT::UnsignedInteger terms = order.getStrataCumulatedCardinal(degree);
  OT::FunctionalChaosAlgorithm algorithm(
      x, y, cube, OT::FixedStrategy(basis, terms),
      OT::LeastSquaresStrategy(
          OT::LeastSquaresMetaModelSelectionFactory(OT::LARS(), OT::CorrectedLeaveOneOut())));
  std::vector<Term> chosen = {Term(dimension, 0)};
  try {
    algorithm.run();
  } catch (const OT::Exception&) {  // nothing to choose: the response is one value
    return chosen;
  }
  for (const OT::UnsignedInteger at : algorithm.getResult().getIndices()) {
    const OT::Indices degrees = order(at);
    Term term(degrees.begin(), degrees.end());
    if (std::any_of(term.begin(), term.end(), [](int d) { return d > 0; })) chosen.push_back(term);
  }
  return chosen;
}

}  // namespace wythe
