// Finds the maximum likelihood coefficients (7.17) by Fisher scoring, on inputs of mean 0 and deviation 1. A step that
// would lower the likelihood is halved. Intervals of slope and half come from the profile likelihood, the band from the
// information matrix. With a slope beyond kSteepest or a singular matrix, is_finite() is false and no number is valid.
#include "statistics/binary_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "statistics/intervals.h"

namespace wythe::study {
namespace {

// A steeper slope is no valid result: P would go from 5 to 95 % within 0.2 standard deviations of the input.
constexpr double kSteepest = 30;

struct Point {
  double p, q, slope;  // probability, its complement (each with all its digits), d p / d eta
};

Point point_at(FragilityLaw law, double eta) {
  if (law == FragilityLaw::kLogistic) {
    const double e = std::exp(-std::fabs(eta)), small = e / (1 + e), large = 1 / (1 + e);
    return {eta > 0 ? large : small, eta > 0 ? small : large, small * large};
  }
  constexpr double kRootTwoPi = 2.5066282746310002;
  return {normal_cdf(eta), normal_cdf(-eta), std::exp(-eta * eta / 2) / kRootTwoPi};
}

// The probability is at least 1e-300 here, so that logarithms of outcomes far off stay finite.
double log_of(double p) { return std::log(std::max(p, 1e-300)); }

double log_likelihood_of(const Point& at, double y) {
  return (y > 0 ? y * log_of(at.p) : 0) + (y < 1 ? (1 - y) * log_of(at.q) : 0);
}

// Solves the p equations of a positive definite matrix by elimination; false where it is singular.
bool invert(std::array<std::array<double, 3>, 3> m, std::size_t p,
            std::array<std::array<double, 3>, 3>& inverse) {
  inverse = {};
  for (std::size_t i = 0; i < p; ++i) inverse[i][i] = 1;
  for (std::size_t i = 0; i < p; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < p; ++r)
      if (std::fabs(m[r][i]) > std::fabs(m[pivot][i])) pivot = r;
    if (!(std::fabs(m[pivot][i]) > 1e-12)) return false;
    std::swap(m[i], m[pivot]), std::swap(inverse[i], inverse[pivot]);
    for (std::size_t r = 0; r < p; ++r) {
      const double factor = r == i ? 0 : m[r][i] / m[i][i];
      for (std::size_t c = 0; c < p; ++c)
        m[r][c] -= factor * m[i][c], inverse[r][c] -= factor * inverse[i][c];
    }
    const double diagonal = m[i][i];
    for (std::size_t c = 0; c < p; ++c) m[i][c] /= diagonal, inverse[i][c] /= diagonal;
  }
  return true;
}

// The point where the profile likelihood has fallen from `best` by half the quantile of chi^2.
// `from` is the estimate, `first` a step in the search direction, `last` the end of the
// search. The square root of the fall is nearly linear, so false position needs few steps.
double end_of_interval(const std::function<double(double)>& profile, double best, double from,
                       double first, double last) {
  const auto root = [&](double at) {
    return std::sqrt(std::max(0.0, 2 * (best - profile(at)))) - kNormal95;
  };
  double inner = from, outer = from + first, at_inner = -kNormal95, at_outer = root(outer);
  while (at_outer < 0) {
    if (std::fabs(outer - from) >= std::fabs(last - from))
      return first > 0 ? kInfinity : -kInfinity;
    inner = outer, at_inner = at_outer;
    outer = from + 2 * (outer - from);
    at_outer = root(outer);
  }
  for (int step = 0; step < 40 && std::fabs(outer - inner) > 1e-6 * std::fabs(first); ++step) {
    double middle = inner - at_inner * (outer - inner) / (at_outer - at_inner);
    if (step % 3 == 2) middle = 0.5 * (inner + outer);  // bisection, so that neither end stays
    const double at = root(middle);
    if (std::fabs(at) < 1e-7) return middle;
    (at < 0 ? inner : outer) = middle;
    (at < 0 ? at_inner : at_outer) = at;
  }
  return 0.5 * (inner + outer);
}

}  // namespace

bool parts(const Column& x, const Column& y) {
  double least[2] = {kInfinity, kInfinity}, most[2] = {-kInfinity, -kInfinity};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (y[i] != 0 && y[i] != 1) continue;
    const int kind = y[i] == 1 ? 1 : 0;
    least[kind] = std::min(least[kind], x[i]), most[kind] = std::max(most[kind], x[i]);
  }
  return most[0] <= least[1] || most[1] <= least[0];
}

double chi_square_beyond(double x, int degrees) {
  if (!(x > 0)) return 1;
  const double half = x / 2;
  // Q(k + 2) = Q(k) + (x/2)^(k/2) e^(-x/2) / Gamma(k/2 + 1)
  double q = degrees % 2 == 1 ? std::erfc(std::sqrt(half)) : std::exp(-half);
  for (int k = degrees % 2 == 1 ? 1 : 2; k < degrees; k += 2)
    q += std::exp(0.5 * k * std::log(half) - half - std::lgamma(0.5 * k + 1));
  return std::min(q, 1.0);
}

BinaryFit::BinaryFit(const BinaryData& data) : data_(data), p_(data.x.size() + 1) {
  for (Column& x : data_.x) {
    Moments moments;
    for (const double v : x) moments.add(v);
    mean_.push_back(moments.mean()), scale_.push_back(moments.standard_deviation());
    for (double& v : x) v = (v - mean_.back()) / scale_.back();
  }
  maximise();
}

double BinaryFit::eta(const Vector& b, std::size_t sample) const {
  double sum = b[0];
  for (std::size_t k = 0; k + 1 < p_; ++k) sum += b[k + 1] * data_.x[k][sample];
  return sum;
}

double BinaryFit::likelihood(const Vector& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < data_.y.size(); ++i)
    sum += log_likelihood_of(point_at(data_.law, eta(b, i)), data_.y[i]);
  return sum;
}

void BinaryFit::maximise() {
  b_ = {};
  log_likelihood_ = likelihood(b_);
  for (int step = 0; step < 100; ++step) {
    std::array<Vector, 3> information = {};
    Vector score = {};
    for (std::size_t i = 0; i < data_.y.size(); ++i) {
      const Point at = point_at(data_.law, eta(b_, i));
      const double spread = std::max(at.p * at.q, 1e-300);
      const double pull = (data_.y[i] * at.q - (1 - data_.y[i]) * at.p) * at.slope / spread;
      const double weight = at.slope * at.slope / spread;
      const Vector row = {1, data_.x[0][i], p_ > 2 ? data_.x[1][i] : 0};
      for (std::size_t r = 0; r < p_; ++r) {
        score[r] += pull * row[r];
        for (std::size_t c = 0; c < p_; ++c) information[r][c] += weight * row[r] * row[c];
      }
    }
    if (!invert(information, p_, covariance_)) return;
    Vector move = {};
    double decrement = 0;
    for (std::size_t r = 0; r < p_; ++r) {
      for (std::size_t c = 0; c < p_; ++c) move[r] += covariance_[r][c] * score[c];
      decrement += move[r] * score[r];
    }
    if (decrement < 1e-16 * (1 + std::fabs(log_likelihood_))) {
      finite_ = true;
      return;
    }
    for (double share = 1; share > 1e-6; share /= 2) {  // the likelihood never falls
      Vector next = b_;
      for (std::size_t r = 0; r < p_; ++r) next[r] += share * move[r];
      const double there = likelihood(next);
      if (there < log_likelihood_ && share > 2e-6) continue;
      b_ = next, log_likelihood_ = there;
      break;
    }
    for (std::size_t k = 1; k < p_; ++k)
      if (std::fabs(b_[k]) > kSteepest) return;
  }
}

double BinaryFit::intercept() const {
  double at = b_[0];
  for (std::size_t k = 0; k + 1 < p_; ++k) at -= slope(k) * mean_[k];
  return at;
}

Interval BinaryFit::wald_slope(std::size_t k) const {
  const double half = kNormal95 * std::sqrt(covariance_[k + 1][k + 1]) / scale_[k];
  return {slope(k) - half, slope(k) + half};
}

Estimate BinaryFit::at(const std::vector<double>& x) const {
  Vector row = {1, 0, 0};
  for (std::size_t k = 0; k + 1 < p_; ++k) row[k + 1] = (x[k] - mean_[k]) / scale_[k];
  double middle = 0, variance = 0;
  for (std::size_t r = 0; r < p_; ++r) {
    middle += b_[r] * row[r];
    for (std::size_t c = 0; c < p_; ++c) variance += row[r] * covariance_[r][c] * row[c];
  }
  const double half = kNormal95 * std::sqrt(variance);
  return {point_at(data_.law, middle).p,
          {point_at(data_.law, middle - half).p, point_at(data_.law, middle + half).p}};
}

double BinaryFit::probability(std::size_t sample) const {
  return point_at(data_.law, eta(b_, sample)).p;
}

// The maximum likelihood of eta = offset + t d over t, by Fisher scoring in one variable; the likelihood never falls.
double BinaryFit::best_along(double t, const Line& line) const {
  double best = -kInfinity, step = 0;
  for (int tries = 0; tries < 60; ++tries) {
    double now = 0, score = 0, information = 0;
    for (std::size_t i = 0; i < data_.y.size(); ++i) {
      const auto [offset, d] = line(data_.x[0][i]);
      const Point at = point_at(data_.law, offset + (t + step) * d);
      const double spread = std::max(at.p * at.q, 1e-300), y = data_.y[i];
      now += log_likelihood_of(at, y);
      score += (y * at.q - (1 - y) * at.p) * at.slope / spread * d;
      information += at.slope * at.slope / spread * d * d;
    }
    if (now < best) {
      step /= 2;
      if (std::fabs(step) < 1e-9 * (1 + std::fabs(t))) break;
      continue;
    }
    const bool is_still = now <= best + 1e-10;
    best = now, t += step;
    if (is_still || !(information > 0)) break;
    step = score / information;
  }
  return best;
}

double BinaryFit::best_with_slope(double slope) const {
  return best_along(b_[0], [&](double z) { return std::pair(slope * z, 1.0); });
}

double BinaryFit::best_with_half(double place) const {
  return best_along(b_[1], [&](double z) { return std::pair(0.0, z - place); });
}

Interval BinaryFit::profile_slope() const {
  const double error = std::sqrt(covariance_[1][1]), reach = 4 * kSteepest;
  const auto profile = [&](double s) { return best_with_slope(s); };
  return {end_of_interval(profile, log_likelihood_, b_[1], -1.96 * error, -reach) / scale_[0],
          end_of_interval(profile, log_likelihood_, b_[1], 1.96 * error, reach) / scale_[0]};
}

Estimate BinaryFit::half() const {
  const double place = -b_[0] / b_[1];
  const double error = std::sqrt(covariance_[0][0] + 2 * place * covariance_[0][1] +
                                 place * place * covariance_[1][1]) /
                       std::fabs(b_[1]);
  const auto profile = [&](double at) { return best_with_half(at); };
  // a point more than six standard deviations from the samples is not given
  const auto [low, high] = std::minmax_element(data_.x[0].begin(), data_.x[0].end());
  const auto shown = [&](double z) { return mean_[0] + scale_[0] * z; };
  const double step = std::min(1.96 * error, 1.0);
  return {shown(place),
          {shown(end_of_interval(profile, log_likelihood_, place, -step, *low - 6)),
           shown(end_of_interval(profile, log_likelihood_, place, step, *high + 6))}};
}

double BinaryFit::influence_p() const {
  const double n = static_cast<double>(data_.y.size());
  const double yes = std::accumulate(data_.y.begin(), data_.y.end(), 0.0);
  const double none = yes * log_of(yes / n) + (n - yes) * log_of(1 - yes / n);
  return chi_square_beyond(2 * (log_likelihood_ - none), static_cast<int>(p_) - 1);
}

double BinaryFit::fit_p() const {
  constexpr double kFewestExpected = 2;
  std::vector<std::pair<double, double>> in_order;  // probability, outcome
  for (std::size_t i = 0; i < data_.y.size(); ++i)
    if (data_.y[i] == 0 || data_.y[i] == 1) in_order.emplace_back(probability(i), data_.y[i]);
  std::sort(in_order.begin(), in_order.end());
  const double wished = std::max(5.0, static_cast<double>(in_order.size()) / 10);
  struct Bin {
    double n = 0, expected = 0, seen = 0;
    [[nodiscard]] bool is_enough(double least) const {
      return n >= least && expected >= kFewestExpected && n - expected >= kFewestExpected;
    }
  };
  std::vector<Bin> bins(1);
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    const bool tied = i > 0 && in_order[i].first == in_order[i - 1].first;
    if (!tied && bins.back().is_enough(wished)) bins.emplace_back();
    ++bins.back().n, bins.back().expected += in_order[i].first,
        bins.back().seen += in_order[i].second;
  }
  if (bins.size() > 1 && !bins.back().is_enough(0)) {  // the rest joins the last group
    const Bin rest = bins.back();
    bins.pop_back();
    bins.back().n += rest.n, bins.back().expected += rest.expected, bins.back().seen += rest.seen;
  }
  if (bins.size() < p_ + 1) return kUnset;
  double sum = 0;
  for (const Bin& b : bins)
    sum += (b.seen - b.expected) * (b.seen - b.expected) / (b.expected * (1 - b.expected / b.n));
  return chi_square_beyond(sum, static_cast<int>(bins.size() - p_));
}

}  // namespace wythe::study
