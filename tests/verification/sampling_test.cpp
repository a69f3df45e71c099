// Samples against known results: strata, moments, truncated probabilities, correlations, and
// the order of integration errors (CF28 and the textbook formulas of each distribution).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "campaign/draws/copula.h"
#include "campaign/draws/correlation.h"
#include "campaign/draws/margin.h"
#include "campaign/draws/sampling.h"
#include "verification/record.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/study.h"

namespace wythe::sampling_test {
namespace {

using verification::verify;

constexpr double kPi = std::numbers::pi;

VariableSpec variable(const std::string& name, DistributionKind kind) {
  VariableSpec out;
  out.name = name;
  out.si_unit = out.unit = "1";
  out.distribution = kind;
  return out;
}

VariableSpec with_moments(const std::string& name, DistributionKind kind, double mean, double cov) {
  VariableSpec out = variable(name, kind);
  out.mean = mean;
  out.cov = cov;
  return out;
}

StudySpec study_of(std::vector<VariableSpec> variables, int samples,
                   Design design = Design::kLatinHypercube) {
  StudySpec out;
  out.variable = std::move(variables);
  for (VariableSpec& variable : out.variable) variable.path = variable.name;
  out.batch = {samples};
  out.seed = 2026;
  out.design = design;
  return out;
}

std::vector<double> column(const SampleTable& table, std::size_t j) {
  std::vector<double> out;
  for (const std::vector<double>& row : table.value) out.push_back(row[j]);
  return out;
}

double mean_of(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v;
  return sum / static_cast<double>(x.size());
}

double deviation_of(const std::vector<double>& x) {
  const double mean = mean_of(x);
  double sum = 0;
  for (const double v : x) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double pearson_of(const std::vector<double>& x, const std::vector<double>& y) {
  const double mx = mean_of(x), my = mean_of(y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mx) * (y[i] - my);
  return sum / static_cast<double>(x.size()) / deviation_of(x) / deviation_of(y);
}

std::vector<double> ranks_of(const std::vector<double>& x) {
  std::vector<double> out;
  for (const double v : x)
    out.push_back(
        static_cast<double>(std::count_if(x.begin(), x.end(), [&](double w) { return w < v; })));
  return out;
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// --- strata --------------------------------------------------------------------------------------

int strata_hit_once(const std::vector<double>& u) {
  std::set<int> hit;
  for (const double v : u) hit.insert(static_cast<int>(v * static_cast<double>(u.size())));
  return static_cast<int>(hit.size());
}

TEST(LatinHypercube, every_stratum_of_every_variable_holds_one_sample) {
  const std::vector<std::string> names = {"fc", "ft_j", "ft_u", "phi", "R"};
  const Columns u = unit_design({.samples = 250, .seed = 2026}, names);
  for (std::size_t j = 0; j < names.size(); ++j)
    verify({.id = "CF28",
            .what = "strata of 250 that hold a sample: " + names[j],
            .unit = "-",
            .expected = 250,
            .tolerance = 0,
            .because = "exact: one in each (McKay et al. 1979)"},
           strata_hit_once(u[j]));
}

// Of n uniform positions in their strata none lies at the centre and their mean is 1/2 within the
// scatter of a mean of n uniforms, 1/sqrt(12 n) = 0.018 for 250: five of it.
TEST(LatinHypercube, position_in_the_stratum_is_random) {
  const std::vector<double> u = unit_design({.samples = 250, .seed = 1}, {"x"})[0];
  std::vector<double> position;
  for (const double v : u) position.push_back(v * 250 - std::floor(v * 250));
  EXPECT_NEAR(mean_of(position), 0.5, 5 / std::sqrt(12.0 * 250));
  EXPECT_NEAR(deviation_of(position), 1 / std::sqrt(12.0), 0.05);
}

// The digital shift keeps the net: any 2^k first points have one in each of 2^k strata.
TEST(Sobol, every_stratum_holds_one_sample) {
  const Columns u =
      unit_design({.design = Design::kSobol, .samples = 256, .seed = 5}, {"a", "b", "c", "d", "e"});
  for (const std::vector<double>& one : u) EXPECT_EQ(strata_hit_once(one), 256);
  EXPECT_NE(u[0], unit_design({.design = Design::kSobol, .samples = 256, .seed = 6}, {"a"})[0]);
}

// 2-D net property: each of the 16 x 16 boxes holds one of the first 256 points of the first pair.
TEST(Sobol, every_box_of_a_pair_holds_one_sample) {
  const Columns u = unit_design({.design = Design::kSobol, .samples = 256, .seed = 5}, {"a", "b"});
  std::set<int> boxes;
  for (std::size_t i = 0; i < 256; ++i)
    boxes.insert(16 * static_cast<int>(u[0][i] * 16) + static_cast<int>(u[1][i] * 16));
  EXPECT_EQ(boxes.size(), 256U);
}

// --- moments -------------------------------------------------------------------------------------

struct Known {
  const char* what;
  std::function<VariableSpec()> make;
  double mean, deviation;
};

VariableSpec ranged(DistributionKind kind, double low, double mode, double high) {
  VariableSpec out = variable("x", kind);
  out.low = low;
  out.mode = mode;
  out.high = high;
  return out;
}

VariableSpec beta(double a, double b, double low, double high) {
  VariableSpec out = ranged(DistributionKind::kBeta, low, kUnset, high);
  out.alpha = a;
  out.beta = b;
  return out;
}

VariableSpec beta_by_moments() {
  VariableSpec out = ranged(DistributionKind::kBeta, 1, kUnset, 3);
  out.mean = 1.5;
  out.cov = 0.2;
  return out;
}

VariableSpec weibull(double shape, double scale, double location) {
  VariableSpec out = variable("x", DistributionKind::kWeibull);
  out.shape = shape;
  out.scale = scale;
  out.location = location;
  return out;
}

VariableSpec lognormal_by_median() {
  VariableSpec out = variable("x", DistributionKind::kLognormal);
  out.median = 2;
  out.log_standard_deviation = 0.5;
  return out;
}

VariableSpec truncated_normal(double mean, double deviation, double lower, double upper) {
  VariableSpec out = variable("x", DistributionKind::kNormal);
  out.mean = mean;
  out.standard_deviation = deviation;
  out.lower = lower;
  out.upper = upper;
  return out;
}

VariableSpec empirical(std::vector<double> values) {
  VariableSpec out = variable("x", DistributionKind::kEmpirical);
  out.values = std::move(values);
  return out;
}

// Normal(1, 0.5) on [0.5, 2]: a = -1, b = 2; Johnson, Kotz & Balakrishnan 1994, section 13.10.
double density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * kPi); }
double truncated_mean() {
  return 1 + 0.5 * (density(-1) - density(2)) / (normal_cdf(2) - normal_cdf(-1));
}
double truncated_deviation() {
  const double kept = normal_cdf(2) - normal_cdf(-1);
  const double shift = (density(-1) - density(2)) / kept;
  return 0.5 * std::sqrt(1 + (-1 * density(-1) - 2 * density(2)) / kept - shift * shift);
}

const Known kKnown[] = {
    {"normal", [] { return with_moments("x", DistributionKind::kNormal, 3.96, 0.125); }, 3.96,
     0.495},
    {"lognormal", [] { return with_moments("x", DistributionKind::kLognormal, 0.15, 0.3); }, 0.15,
     0.045},
    {"lognormal by median", lognormal_by_median, 2 * std::exp(0.125),
     2 * std::exp(0.125) * std::sqrt(std::expm1(0.25))},
    {"uniform", [] { return ranged(DistributionKind::kUniform, 1, kUnset, 4); }, 2.5,
     3 / std::sqrt(12.0)},
    {"uniform by mean", [] { return with_moments("x", DistributionKind::kUniform, 2, 0.1); }, 2,
     0.2},
    {"triangular", [] { return ranged(DistributionKind::kTriangular, 1, 2, 6); }, 3,
     std::sqrt((1 + 4 + 36 - 2 - 6 - 12) / 18.0)},
    {"triangular by mean", [] { return with_moments("x", DistributionKind::kTriangular, 2, 0.1); },
     2, 0.2},
    {"beta", [] { return beta(2, 3, 1, 6); }, 1 + 5 * 0.4, 5 * std::sqrt(2 * 3 / (25.0 * 6.0))},
    {"beta by mean", beta_by_moments, 1.5, 0.3},
    {"weibull", [] { return weibull(2, 3, 1); }, 1 + 3 * std::tgamma(1.5),
     3 * std::sqrt(1 - std::tgamma(1.5) * std::tgamma(1.5))},
    {"weibull by mean", [] { return with_moments("x", DistributionKind::kWeibull, 5, 0.2); }, 5, 1},
    {"truncated normal", [] { return truncated_normal(1, 0.5, 0.5, 2); }, truncated_mean(),
     truncated_deviation()},
    {"empirical",
     [] {
       return empirical({1, 2, 4, 4, 9});
     },
     4, std::sqrt((9 + 4 + 25) / 5.0)}};

// Stratified samples of a monotone quantile function: the mean's error is below the mean width of
// the strata over sqrt(n) (Stein 1987), some 1e-4 of the deviation at n = 4000 for these; the
// deviation of long tails depends on the last strata, 1 % at most.
TEST(Moments, of_every_distribution_are_its_closed_form) {
  for (const Known& known : kKnown) {
    const SampleTable table = draw_samples(study_of({known.make()}, 4000));
    const std::vector<double> x = column(table, 0);
    verify({.id = "CF28",
            .what = std::string("mean of Latin hypercube samples: ") + known.what,
            .unit = "-",
            .expected = known.mean,
            .tolerance = 5e-4,
            .because = "strata 1/n wide: n = 4000"},
           mean_of(x));
    verify({.id = "CF28",
            .what = std::string("deviation of Latin hypercube samples: ") + known.what,
            .unit = "-",
            .expected = known.deviation,
            .tolerance = 1e-2,
            .because = "place of the samples in the outer strata"},
           deviation_of(x));
  }
}

TEST(Lognormal, parameters_are_those_of_table_2) {
  struct Row {
    double mean, cov, sigma, mu;
  };
  for (const Row& row :
       {Row{0.15, 0.3, 0.293560, -1.940209}, Row{0.23, 0.22, 0.217406, -1.493309}}) {
    const Margin margin(with_moments("x", DistributionKind::kLognormal, row.mean, row.cov));
    const double middle = std::log(margin.quantile(0.5));
    const double upper = std::log(margin.quantile(normal_cdf(1)));
    const std::string what = row.mean < 0.2 ? "ft_j" : "ft_u";
    verify({.id = "CF28",
            .what = "mu_ln of " + what,
            .unit = "-",
            .expected = row.mu,
            .tolerance = 1e-6,
            .because = "six digits given"},
           middle);
    verify({.id = "CF28",
            .what = "sigma_ln of " + what,
            .unit = "-",
            .expected = row.sigma,
            .tolerance = 2e-6,
            .because = "six digits given"},
           upper - middle);
  }
}

// --- truncation ----------------------------------------------------------------------------------

TEST(Truncation, probability_cut_off_is_that_of_the_tails) {
  const Margin margin(truncated_normal(1, 0.5, 0.5, 2));
  verify({.id = "truncation",
          .what = "probability cut off a normal at -1 and +2 deviations",
          .unit = "-",
          .expected = normal_cdf(-1) + normal_cdf(-2),
          .tolerance = 1e-12,
          .because = "round-off of two normal probabilities"},
         margin.cut_off());
  const Margin few(empirical({1, 2, 3, 4, 5}));
  EXPECT_EQ(few.cut_off(), 0);
  VariableSpec cut = empirical({1, 2, 3, 4, 5});
  cut.lower = 2;
  EXPECT_NEAR(Margin(cut).cut_off(), 0.2, 1e-15);  // one of five; 2 itself stays
  EXPECT_EQ(Margin(cut).quantile(1e-9), 2);
}

TEST(Truncation, samples_stay_inside_and_keep_their_strata) {
  const std::vector<double> x =
      column(draw_samples(study_of({truncated_normal(1, 0.5, 0.5, 2)}, 500)), 0);
  EXPECT_GE(*std::min_element(x.begin(), x.end()), 0.5);
  EXPECT_LE(*std::max_element(x.begin(), x.end()), 2.0);
  const double below = normal_cdf(-1), kept = normal_cdf(2) - normal_cdf(-1);
  std::vector<double> u;
  for (const double v : x) u.push_back((normal_cdf((v - 1) / 0.5) - below) / kept);
  EXPECT_EQ(strata_hit_once(u), 500);
}

// --- correlation ---------------------------------------------------------------------------------

StudySpec correlated(int samples, Design design, double value, bool rank) {
  StudySpec study = study_of({with_moments("a", DistributionKind::kLognormal, 1, 0.3),
                              with_moments("b", DistributionKind::kNormal, 5, 0.1),
                              with_moments("c", DistributionKind::kNormal, 1, 0.1)},
                             samples, design);
  study.correlation.push_back({.a = "a", .b = "b", .value = value, .rank = rank});
  return study;
}

// A rank correlation of n samples scatters by about (1 - r^2) / sqrt(n) = 0.006 at n = 10000.
TEST(CorrelationOfSamples, rank_correlation_is_reached) {
  const std::pair<Design, const char*> designs[] = {{Design::kLatinHypercube, "Latin hypercube"},
                                                    {Design::kMonteCarlo, "Monte Carlo"},
                                                    {Design::kSobol, "Sobol"}};
  for (const auto& [design, words] : designs) {
    const SampleTable table = draw_samples(correlated(10000, design, 0.6, true));
    const double rank = pearson_of(ranks_of(column(table, 0)), ranks_of(column(table, 1)));
    verify({.id = "copula",
            .what = std::string("rank correlation drawn: ") + words,
            .unit = "-",
            .expected = 0.6,
            .tolerance = 0.02,
            .because = "three times its scatter, n = 10000",
            .absolute = true},
           rank);
    EXPECT_NEAR(pearson_of(ranks_of(column(table, 0)), ranks_of(column(table, 2))), 0, 0.03);
  }
}

// Independent columns scatter by 1/sqrt(250) = 0.063, the largest of 200 pairs reaches 0.19; three
// rounds leave 0.004.
TEST(CorrelationOfSamples, inputs_of_a_latin_hypercube_are_as_uncorrelated_as_asked) {
  std::vector<VariableSpec> variables;
  for (const char* name : {"fc", "ft_j", "ft_u", "phi", "R"})
    variables.push_back(with_moments(name, DistributionKind::kLognormal, 1, 0.3));
  double most = 0;
  for (std::uint64_t seed = 2020; seed < 2040; ++seed) {
    StudySpec study = study_of(variables, 250, Design::kLatinHypercube);
    study.seed = seed;
    const std::vector<InputCorrelation> pairs = input_correlations(draw_samples(study));
    EXPECT_EQ(pairs.size(), 10U);
    most = std::max(most, std::fabs(pairs.front().rank));
  }
  verify({.id = "CF28",
          .what = "largest rank correlation of five independent inputs, 250 samples, 20 seeds",
          .unit = "-",
          .expected = 0,
          .tolerance = 0.01,
          .because = "twice what three rounds leave",
          .absolute = true},
         most);
  // a variable more at the end leaves the others as they were
  StudySpec study = study_of(variables, 250, Design::kLatinHypercube);
  const std::vector<double> before = column(draw_samples(study), 4);
  study.variable.push_back(with_moments("w", DistributionKind::kNormal, 1, 0.1));
  study.variable.back().path = "w";
  EXPECT_EQ(column(draw_samples(study), 4), before);
}

TEST(CorrelationOfSamples, gaussian_correlation_is_that_of_the_logarithms) {
  const SampleTable table = draw_samples(correlated(10000, Design::kLatinHypercube, -0.7, false));
  std::vector<double> logs = column(table, 0);
  for (double& value : logs) value = std::log(value);
  EXPECT_NEAR(pearson_of(logs, column(table, 1)), -0.7, 0.02);  // as above
}

TEST(CorrelationOfSamples, latin_hypercube_keeps_its_values) {
  const SampleTable tied = draw_samples(correlated(250, Design::kLatinHypercube, 0.6, true));
  StudySpec free = correlated(250, Design::kLatinHypercube, 0.6, true);
  free.correlation.clear();
  const SampleTable untied = draw_samples(free);
  for (const std::size_t j : {0U, 1U}) {
    std::vector<double> a = column(tied, j), b = column(untied, j);
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b);
  }
  EXPECT_EQ(column(tied, 0), column(untied, 0));  // the first of a pair stays as it was
  EXPECT_EQ(column(tied, 2), column(untied, 2));  // one without correlation too
  EXPECT_NE(column(tied, 1), column(untied, 1));
}

// Higham 2002, section 4: nearest correlation matrix of [1 1 0; 1 1 1; 0 1 1] is 0.7607 and 0.1573.
// Ours stays off the singular one by its least eigenvalue 6e-4 n = 0.0018: entries move by less.
TEST(NearestCorrelation, is_highams) {
  CorrelationMatrix m(3);
  m.at(0, 1) = m.at(1, 0) = m.at(1, 2) = m.at(2, 1) = 1;
  const CorrelationMatrix nearest = nearest_positive_definite(m);
  verify({.id = "Higham 2002",
          .what = "nearest correlation matrix, entry 1 2",
          .unit = "-",
          .expected = 0.7607,
          .tolerance = 3e-3,
          .because = "least eigenvalue 0.0018"},
         nearest.at(0, 1));
  verify({.id = "Higham 2002",
          .what = "nearest correlation matrix, entry 1 3",
          .unit = "-",
          .expected = 0.1573,
          .tolerance = 3e-3,
          .because = "least eigenvalue 0.0018",
          .absolute = true},
         nearest.at(0, 2));
  EXPECT_FALSE(is_positive_definite(m));
  EXPECT_TRUE(is_positive_definite(nearest));
}

TEST(RankCorrelation, gives_the_gaussian_one) {
  for (const double rank : {-0.99, -0.3, 0.0, 0.5, 0.9})
    EXPECT_NEAR(6 / std::numbers::pi * std::asin(gaussian_of_rank(rank) / 2), rank, 1e-14);
  EXPECT_NEAR(gaussian_of_rank(0.5), 0.5176380902, 1e-10);  // 2 sin(15 deg)
}

// --- integration ---------------------------------------------------------------------------------

// Root mean square error, over 100 seeds, of the mean of x y exp(z) on the unit cube: 0.25 (e - 1).
double integration_error(Design design) {
  constexpr int kSeeds = 100;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Columns u =
        unit_design({.design = design, .samples = 512, .seed = seed}, {"x", "y", "z"});
    double sum = 0;
    for (std::size_t i = 0; i < 512; ++i) sum += u[0][i] * u[1][i] * std::exp(u[2][i]);
    const double error = sum / 512 - 0.25 * (std::numbers::e - 1);
    squares += error * error;
  }
  return std::sqrt(squares / kSeeds);
}

// With e = exp(1): variance (e^2 - 1)/18 - (e - 1)^2/16; main effects (e - 1)^2/48 of x and of y and
// ((e^2 - 1)/2 - (e - 1)^2)/16 of z, which strata take out of the error (Stein 1987).
TEST(Integration, errors_are_those_of_theory) {
  const double e1 = std::numbers::e - 1, e2 = std::numbers::e * std::numbers::e - 1;
  const double variance = e2 / 18 - e1 * e1 / 16;
  const double main_effects = e1 * e1 / 24 + (e2 / 2 - e1 * e1) / 16;
  const char* because = "100 errors: their root mean square scatters by 7 %";
  verify({.id = "Stein 1987",
          .what = "error of a mean by Monte Carlo",
          .unit = "-",
          .expected = std::sqrt(variance / 512),
          .tolerance = 0.25,
          .because = because},
         integration_error(Design::kMonteCarlo));
  const double stratified = integration_error(Design::kLatinHypercube);
  verify({.id = "Stein 1987",
          .what = "error of a mean by Latin hypercube",
          .unit = "-",
          .expected = std::sqrt((variance - main_effects) / 512),
          .tolerance = 0.25,
          .because = because},
         stratified);
  EXPECT_LT(integration_error(Design::kSobol), stratified / 5);
}

// --- what a sample depends on --------------------------------------------------------------------

TEST(Samples, are_the_same_when_drawn_again) {
  for (const Design design : {Design::kLatinHypercube, Design::kMonteCarlo, Design::kSobol}) {
    const StudySpec study = correlated(40, design, 0.5, true);
    EXPECT_EQ(draw_samples(study).value, draw_samples(study).value);
    StudySpec other = study;
    other.seed = 2027;
    EXPECT_NE(draw_samples(study).value, draw_samples(other).value);
  }
}

TEST(Samples, of_a_batch_do_not_know_of_later_ones) {
  for (const Design design : {Design::kLatinHypercube, Design::kMonteCarlo, Design::kSobol}) {
    StudySpec study = correlated(40, design, 0.5, true);
    const SampleTable first = draw_samples(study);
    study.batch = {40, 25};
    SampleTable both = draw_samples(study);
    ASSERT_EQ(both.n_sample(), 65);
    EXPECT_NE(both.value[40], both.value[0]);
    both.value.resize(40);
    EXPECT_EQ(both.value, first.value);
  }
}

TEST(Samples, of_a_variable_do_not_know_of_the_others) {
  for (const Design design : {Design::kLatinHypercube, Design::kMonteCarlo, Design::kSobol}) {
    StudySpec study = correlated(40, design, 0.5, true);
    study.correlation.clear();
    const std::vector<double> alone = column(draw_samples(study), 0);
    study.variable.pop_back();
    EXPECT_EQ(column(draw_samples(study), 0), alone);
  }
}

TEST(Samples, of_a_larger_monte_carlo_study_begin_with_those_of_a_smaller) {
  const SampleTable small = draw_samples(correlated(30, Design::kMonteCarlo, 0.5, true));
  SampleTable large = draw_samples(correlated(60, Design::kMonteCarlo, 0.5, true));
  large.value.resize(30);
  EXPECT_EQ(large.value, small.value);
}

}  // namespace
}  // namespace wythe::sampling_test
