// Terms selected by least angle regression, where the right ones are known.
#include "statistics/surrogate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "campaign/draws/sampling.h"

namespace wythe {
namespace {

Columns design(int samples, const std::vector<std::string>& names) {
  return unit_design({.samples = samples, .seed = 3}, names);
}

// Sum of coefficients times terms.
std::vector<double> response_of(const std::vector<Term>& terms, const std::vector<double>& factor,
                                const Columns& u) {
  const Columns values = legendre_products(terms, u);
  std::vector<double> y(u.front().size(), 0.0);
  for (std::size_t t = 0; t < terms.size(); ++t)
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += factor[t] * values[t][i];
  return y;
}

TEST(LegendreProducts, are_orthonormal_over_the_unit_square) {
  const std::vector<Term> terms = {{0, 0}, {1, 0}, {0, 2}, {1, 1}, {3, 0}, {2, 1}};
  Columns grid(2);
  constexpr int kSide = 400;
  for (int i = 0; i < kSide; ++i)
    for (int k = 0; k < kSide; ++k) {
      grid[0].push_back((i + 0.5) / kSide);
      grid[1].push_back((k + 0.5) / kSide);
    }
  const Columns values = legendre_products(terms, grid);
  for (std::size_t a = 0; a < terms.size(); ++a)
    for (std::size_t b = 0; b < terms.size(); ++b) {
      double mean = 0;
      for (std::size_t i = 0; i < grid[0].size(); ++i) mean += values[a][i] * values[b][i];
      EXPECT_NEAR(mean / (kSide * kSide), a == b ? 1 : 0, 1e-4) << a << " " << b;
    }
}

TEST(ChosenTerms, are_those_of_a_sparse_polynomial) {
  const Columns u = design(80, {"a", "b", "c", "d"});
  const std::vector<Term> terms = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 2, 0, 0}, {1, 0, 1, 0}};
  const std::vector<Term> chosen = chosen_terms(u, response_of(terms, {5, 1, -2, 0.5}, u), 3);
  for (const Term& term : terms) EXPECT_EQ(std::count(chosen.begin(), chosen.end(), term), 1);
  EXPECT_LT(chosen.size(), 20U);  // of 35
}

TEST(ChosenTerms, of_pure_noise_are_few) {
  const Columns u = design(100, {"a", "b", "c"});
  const std::vector<double> noise =
      unit_design({.design = Design::kMonteCarlo, .samples = 100, .seed = 9}, {"n"})[0];
  EXPECT_LE(chosen_terms(u, noise, 3).size(), 6U);
}

TEST(ChosenTerms, of_a_constant_and_of_equal_inputs_end) {
  const Columns u = design(50, {"a", "b"});
  EXPECT_EQ(chosen_terms(u, std::vector<double>(50, 7.0), 2), (std::vector<Term>{{0, 0}}));
  const Columns twice = {u[0], u[0]};  // every term of b is one of a
  const std::vector<Term> chosen = chosen_terms(twice, response_of({{1, 0}}, {1}, twice), 2);
  EXPECT_GE(chosen.size(), 2U);
  EXPECT_LE(chosen.size(), 4U);
}

}  // namespace
}  // namespace wythe
