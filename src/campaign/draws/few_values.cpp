// Spearman's coefficient is the correlation of middle ranks G = P(X < x) + P(X = x)/2, whose variance is (1 - sum p^3)/12. A
// variable of few values is a step function of its normal variable z, G = sum d_i [z > a_i], and by Plackett (1954)
//
//   d Cov(G, H) / d rho = sum d_i e_j phi_2(a_i, b_j; rho)          both of few values
//                       = sum d_i phi(a_i) n(rho a_i; 2 - rho^2)    the second continuous, n the normal density of that variance
//
// With rho = sin t the integrand is smooth up to full dependence.
#include "campaign/draws/few_values.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "campaign/draws/copula.h"
#include "core/elementary.h"
#include "core/normal.h"

namespace wythe {
namespace {

constexpr double kPi = std::numbers::pi;

struct Step {
  double at, height;  // of the normal variable; of the middle rank
};

std::vector<Step> steps_of(const std::vector<double>& shares) {
  std::vector<Step> steps;
  double below = 0;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    below += shares[i];
    steps.push_back({normal_quantile(below), 0.5 * (shares[i] + shares[i + 1])});
  }
  return steps;
}

double variance_of(const std::vector<double>& shares) {
  double cubes = 0;
  for (const double p : shares) cubes += p * p * p;
  return (1 - cubes) / 12;
}

// d Cov / d t at rho = sin t, of two step functions, or of one and a continuous variable (which has no steps).
double rate(double t, const std::vector<Step>& a, const std::vector<Step>& b) {
  const double r = elementary::sin(t), c = elementary::cos(t);
  double sum = 0;
  for (const Step& x : a) {
    if (b.empty()) {
      const double variance = 2 - r * r;
      sum += x.height * c *
             elementary::exp(-0.5 * x.at * x.at - 0.5 * r * r * x.at * x.at / variance) /
             (2 * kPi * std::sqrt(variance));
      continue;
    }
    for (const Step& y : b) {
      const double apart = x.at - y.at;
      const double far = apart == 0 ? 0 : 0.5 * apart * apart / (c * c);
      sum += x.height * y.height * elementary::exp(-far - x.at * y.at / (1 + r)) / (2 * kPi);
    }
  }
  return sum;
}

// The covariance of the ranks of two variables, at least one of them with few values, as a function of t with rho = sin t.
class Ranks {
 public:
  static constexpr int kPieces = 512;
  static constexpr double kPiece = 0.5 * kPi / kPieces;  // of t

  Ranks(const std::vector<double>& of_a, const std::vector<double>& of_b, double sign)
      : way_(sign < 0 ? -1 : 1) {
    const std::vector<double>& first = of_a.empty() ? of_b : of_a;
    const std::vector<double>& second = of_a.empty() ? of_a : of_b;
    a_ = steps_of(first), b_ = steps_of(second);
    unit_ = std::sqrt(variance_of(first) * (second.empty() ? 1.0 / 12 : variance_of(second)));
  }

  [[nodiscard]] double way() const { return way_; }    // sign of the correlation
  [[nodiscard]] double unit() const { return unit_; }  // covariance of a rank correlation of 1
  // Increase of the covariance from t = from to from + length, by Simpson's rule.
  [[nodiscard]] double growth(double from, double length) const {
    const auto f = [&](double t) { return rate(way_ * std::min(t, 0.5 * kPi - 1e-9), a_, b_); };
    return length / 6 * (f(from) + 4 * f(from + 0.5 * length) + f(from + length));
  }

 private:
  double way_, unit_ = 0;
  std::vector<Step> a_, b_;
};

}  // namespace

std::vector<double> shares_of_values(const VariableSpec& v) {
  constexpr std::size_t kMany =
      60;  // so many equal shares change a rank correlation by only 3e-4 of it
  if (v.distribution != DistributionKind::kEmpirical) return {};
  std::map<double, double> count;
  double all = 0;
  for (const double value : v.values)
    if (!(value < v.lower) && !(value > v.upper)) ++count[value], ++all;
  if (count.size() < 2 || count.size() > kMany) return {};
  std::vector<double> shares;
  for (const auto& [value, times] : count) shares.push_back(times / all);
  return shares;
}

RankReached gaussian_of_rank(double rank, const std::vector<double>& of_a,
                             const std::vector<double>& of_b) {
  if (of_a.empty() && of_b.empty()) return {gaussian_of_rank(rank), rank};
  const Ranks ranks(of_a, of_b, rank);
  const double wanted = std::fabs(rank) * ranks.unit(), h = Ranks::kPiece;
  double covariance = 0;
  for (int k = 0; k < Ranks::kPieces; ++k) {
    const double more = ranks.growth(k * h, h);
    if (covariance + more < wanted) {
      covariance += more;
      continue;
    }
    double low = 0, high = h;
    for (int round = 0; round < 40; ++round) {
      const double middle = 0.5 * (low + high);
      (covariance + ranks.growth(k * h, middle) < wanted ? low : high) = middle;
    }
    return {ranks.way() * elementary::sin(k * h + high), rank};
  }
  return {ranks.way(), ranks.way() * covariance / ranks.unit()};
}

double rank_of_gaussian(double rho, const std::vector<double>& of_a,
                        const std::vector<double>& of_b) {
  if (of_a.empty() && of_b.empty()) return 6 / kPi * elementary::asin(rho / 2);
  const Ranks ranks(of_a, of_b, rho);
  const double end = elementary::asin(std::min(1.0, std::fabs(rho)));
  double covariance = 0;
  for (double t = 0; t < end; t += Ranks::kPiece)
    covariance += ranks.growth(t, std::min(Ranks::kPiece, end - t));
  return ranks.way() * covariance / ranks.unit();
}

}  // namespace wythe
