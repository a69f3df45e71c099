// Coverage of intervals and bias of estimators, from
// artificial campaigns with known answers and a fixed seed.
//
// An interval of 95 % must contain the true value in 95 % of the campaigns. Over 1000 campaigns the
// observed share scatters by sqrt(0.95 0.05 / 1000) = 0.7 %. The tolerance of 2 % allows nearly three
// of these, or the known shortfall of the bootstrap at 100 samples (about 1 %) and one of these.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "statistics/bootstrap.h"
#include "statistics/correlation.h"
#include "statistics/intervals.h"
#include "statistics/survival.h"
#include "verification/record.h"

namespace wythe::verification::intervals_test {
namespace {

using namespace study;

constexpr int kCampaigns = 1000;
constexpr const char* kScatter = "scatter of 1000 toy campaigns, 0.7 %, and 1 % of the bootstrap";

double normal(RandomBits& bits) { return normal_quantile(bits.uniform()); }

// Share of campaigns whose interval holds the truth.
double coverage(double truth, const std::function<Interval(RandomBits&)>& campaign,
                int campaigns = kCampaigns) {
  RandomBits bits(20240229);
  int covered = 0;
  for (int k = 0; k < campaigns; ++k) {
    const Interval i = campaign(bits);
    covered += i.low <= truth && truth <= i.high ? 1 : 0;
  }
  return static_cast<double>(covered) / campaigns;
}

Claim covers(const std::string& what) {
  return {"coverage", what, "-", 0.95, 0.02, kScatter, true};
}

Column lognormals(RandomBits& bits, int n, double sigma) {
  Column x(n);
  for (double& value : x) value = std::exp(sigma * normal(bits));
  return x;
}

double weighted_mean(const Column& x, const Counts& count) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += count[i] * x[i], n += count[i];
  return sum / n;
}
double weighted_cov(const Column& x, const Counts& count) {
  const double mean = weighted_mean(x, count);
  double squares = 0, n = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares += count[i] * (x[i] - mean) * (x[i] - mean), n += count[i];
  return std::sqrt(squares / (n - 1)) / mean;
}

TEST(Coverage, bootstrap_mean_of_100_lognormals) {
  const double sigma = 0.3;
  verify(covers("BCa interval of a mean, 100 lognormal values, CoV 0.31"),
         coverage(std::exp(sigma * sigma / 2), [&](RandomBits& bits) {
           const Column x = lognormals(bits, 100, sigma);
           return bca_bootstrap(100, [&](const Counts& c) { return weighted_mean(x, c); }).interval;
         }));
}

TEST(Coverage, bootstrap_cov_of_100_normals) {
  Claim claim = covers("BCa interval of a CoV, 100 normal values, CoV 0.1");
  verify(claim, coverage(0.1, [&](RandomBits& bits) {
           Column x(100);
           for (double& value : x) value = 1 + 0.1 * normal(bits);
           return bca_bootstrap(100, [&](const Counts& c) { return weighted_cov(x, c); }).interval;
         }));
}

TEST(Coverage, student_mean_of_20_normals) {
  Claim claim = covers("Student interval of a mean, 20 normal values");
  claim.tolerance = 0.006;
  claim.because = "exact; scatter of 20000 toy campaigns is 0.15 %, four of these";
  const auto one = [](RandomBits& bits) {
    Moments moments;
    for (int i = 0; i < 20; ++i) moments.add(5 + normal(bits));
    return moments.student().interval;
  };
  verify(claim, coverage(5, one, 20000));
}

// Every outcome of n trials weighted by its probability: no chance involved.
double wilson_coverage(int n, double p) {
  double covered = 0;
  for (int k = 0; k <= n; ++k) {
    const Interval i = wilson(k, n).interval;
    if (i.low > p || i.high < p) continue;
    covered += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                        k * std::log(p) + (n - k) * std::log1p(-p));
  }
  return covered;
}

TEST(Coverage, wilson_share_over_all_outcomes) {
  double mean = 0;
  for (int i = 1; i < 100; ++i) mean += wilson_coverage(250, i / 100.0) / 99;
  Claim claim = covers("Wilson interval of a share, 250 samples, mean over p = 0.01 ... 0.99");
  claim.tolerance = 0.01;
  claim.because = "exact sums; Wilson's mean coverage lies within 1 % (Agresti and Coull 1998)";
  verify(claim, mean);
  EXPECT_GT(wilson_coverage(250, 0.08), 0.93);  // the paper's rarest mode
}

TEST(Coverage, kaplan_meier_mean_of_censored_times) {
  verify(covers("bootstrap interval of a restricted mean, 100 exponentials cut at 1"),
         coverage(1 - std::exp(-1.0), [](RandomBits& bits) {
           std::vector<Reading> r;
           for (int i = 0; i < 100; ++i) {
             const double x = -std::log(bits.uniform());
             r.push_back({std::fmin(x, 1.0), x > 1});
           }
           r = in_order(std::move(r));
           return percentile_bootstrap(100, [&](const Counts& c) { return survival_mean(r, c); })
               .interval;
         }));
}

TEST(Coverage, kaplan_meier_point) {
  verify(covers("interval (7.5) of a share, 100 exponentials, each cut at a random time"),
         coverage(1 - std::exp(-0.5), [](RandomBits& bits) {
           std::vector<Reading> r;
           for (int i = 0; i < 100; ++i) {
             const double x = -std::log(bits.uniform()), cut = 2 * bits.uniform();
             r.push_back({std::fmin(x, cut), x > cut});
           }
           return share_before(in_order(std::move(r)), 0.5).interval;
         }));
}

// Lognormal of median 30 and beta 0.4, cut at 45: 16 % beyond.
std::vector<Reading> cut_lognormal(RandomBits& bits, int n) {
  std::vector<Reading> r;
  for (int i = 0; i < n; ++i) {
    const double x = 30 * std::exp(0.4 * normal(bits));
    r.push_back({std::fmin(x, 45.0), x > 45});
  }
  return r;
}

TEST(Estimators, censored_lognormal_is_found) {
  RandomBits bits(5);
  const std::vector<Reading> r = cut_lognormal(bits, 100000);
  const Lognormal fit = fit_lognormal(r, Counts(r.size(), 1));
  verify({"fit", "lognormal cut at 45: median", "mm", 30, 0.005,
          "100000 values: standard error 0.4 / 316 = 0.13 %, four of these"},
         fit.median);
  verify({"fit", "lognormal cut at 45: beta", "-", 0.4, 0.012,
          "100000 values: standard error about 0.3 %, four of these"},
         fit.beta);
}

struct Pair {
  Column x, y;
};
Pair correlated(RandomBits& bits, int n, double rho) {
  Pair pair;
  for (int i = 0; i < n; ++i) {
    pair.x.push_back(normal(bits));
    pair.y.push_back(rho * pair.x.back() + std::sqrt(1 - rho * rho) * normal(bits));
  }
  return pair;
}

TEST(Coverage, correlations_of_50_pairs) {
  const double rho = 0.6;
  Claim claim = covers("Fisher z interval of Pearson's r = 0.6, 50 pairs");
  claim.tolerance = 0.01;
  claim.because = "scatter of 10000 toy campaigns, 0.22 %, and the z approximation below 0.5 %";
  const auto of_pearson = [&](RandomBits& bits) {
    const Pair p = correlated(bits, 50, rho);
    return correlate({p.x}, observed(p.y))[0].pearson.interval;
  };
  verify(claim, coverage(rho, of_pearson, 10000));
  claim.what = "Fisher z interval of Spearman's rank correlation, 50 pairs";
  claim.tolerance = 0.015;
  claim.because = "scatter of 10000 toy campaigns, 0.22 %; Bonett and Wright's spread is 1 % wide";
  const auto of_spearman = [&](RandomBits& bits) {
    const Pair p = correlated(bits, 50, rho);
    return correlate({p.x}, observed(p.y))[0].spearman.interval;
  };
  // of a normal pair: 6/pi asin(rho/2)
  verify(claim, coverage(6 / std::numbers::pi * std::asin(rho / 2), of_spearman, 10000));
}

TEST(Estimators, rank_correlations_of_a_linear_model) {
  // y = 2 a + b + e, all standard normal: r(a, y) = 2/sqrt 6, partial r(a, y | b) = 2/sqrt 5
  RandomBits bits(7);
  Column a, b, y;
  for (int i = 0; i < 20000; ++i) {
    a.push_back(normal(bits)), b.push_back(normal(bits));
    y.push_back(2 * a.back() + b.back() + normal(bits));
  }
  const std::vector<Correlation> c = correlate({a, b}, observed(y));
  const std::string because = "20000 samples: standard error below 0.004, three of these";
  verify(
      {"correlation", "y = 2a + b + e: Pearson a", "-", 2 / std::sqrt(6.0), 0.012, because, true},
      c[0].pearson.value);
  verify({"correlation", "y = 2a + b + e: Spearman a", "-",
          6 / std::numbers::pi * std::asin(1 / std::sqrt(6.0)), 0.012, because, true},
         c[0].spearman.value);
  // by the formula of three from the rank correlations of the normal pair
  const double ra = 6 / std::numbers::pi * std::asin(1 / std::sqrt(6.0));
  const double rb = 6 / std::numbers::pi * std::asin(0.5 / std::sqrt(6.0));
  verify({"correlation", "y = 2a + b + e: partial rank a", "-", ra / std::sqrt(1 - rb * rb), 0.012,
          because, true},
         c[0].partial_rank.value);
}

// Ishigami and Homma (1990) with 7 and 0.1, inputs uniform in (-pi, pi).
TEST(Estimators, first_order_indices_of_ishigami) {
  RandomBits bits(11);
  std::vector<Column> x(3);
  Column y;
  for (int i = 0; i < 4096; ++i) {
    for (Column& column : x) column.push_back((2 * bits.uniform() - 1) * std::numbers::pi);
    const double s2 = std::sin(x[1].back());
    y.push_back(std::sin(x[0].back()) * (1 + 0.1 * std::pow(x[2].back(), 4)) + 7 * s2 * s2);
  }
  const char* because = "4096 samples, 50 bins: three standard errors of 0.012";
  const double expected[] = {0.3139, 0.4424, 0};
  for (int k = 0; k < 3; ++k)
    verify({"first order", "Ishigami, input " + std::to_string(k + 1), "-", expected[k], 0.036,
            because, true},
           first_order_index(x[k], y).index.value);
}

TEST(Coverage, first_order_index_of_a_linear_model) {
  // y = sqrt(12) a + e, a uniform in (0, 1), e standard normal: half of the variance each
  const double scale = std::sqrt(12.0);
  Claim claim = covers("bootstrap interval of a first-order index, 250 samples, S = 0.5");
  claim.tolerance = 0.03;
  claim.because = "scatter of 400 toy campaigns, 1.1 %, twice, and the bias of bins, S/bins^2";
  const auto one = [&](RandomBits& bits) {
    Column a, y;
    for (int i = 0; i < 250; ++i) {
      a.push_back(bits.uniform());
      y.push_back(scale * a.back() + normal(bits));
    }
    return first_order_index(a, y).index.interval;
  };
  verify(claim, coverage(0.5, one, 400));
}

TEST(Estimators, first_order_index_has_no_bias_for_an_idle_input) {
  RandomBits bits(13);
  Moments moments;
  for (int k = 0; k < 400; ++k) {
    const Pair p = correlated(bits, 250, 0);
    moments.add(first_order_index(p.x, p.y).index.value);
  }
  verify({"first order", "idle input, mean of 400 campaigns of 250", "-", 0, 0.004,
          "scatter of one is 0.023, of the mean 0.0011; three of these", true},
         moments.mean());
}

}  // namespace
}  // namespace wythe::verification::intervals_test
