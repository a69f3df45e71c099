// Finds the maximum likelihood median and dispersion (15.2) by Newton's method, and their
// profile intervals (15.3). First the ends of the brackets decide the verdict; without kTold
// there is no median, dispersion or interval. Logarithms are scaled by the mean and deviation of
// those ends. A difference of Phi is computed from the nearer tail, where no digits are lost.
#include "statistics/lognormal_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "statistics/intervals.h"

namespace wythe::study {
namespace {

constexpr double kDeviance95 = 3.841458820694124;  // 95 % of chi-square with one degree
constexpr int kSteps = 200;
constexpr double kFar = 60;  // standard deviations of the brackets' ends: the search stops there

double density(double z) {
  return std::isinf(z) ? 0.0 : std::exp(-0.5 * z * z) * 0.39894228040143267794;
}
// z times the density; 0 at infinity
double leaning(double z) { return std::isinf(z) ? 0.0 : z * density(z); }

// Phi(u) - Phi(l), from the nearer tail, where no digits are lost.
double between(double l, double u) {
  if (l > 0) return 0.5 * (std::erfc(l * M_SQRT1_2) - std::erfc(u * M_SQRT1_2));
  return 0.5 * (std::erfc(-u * M_SQRT1_2) - std::erfc(-l * M_SQRT1_2));
}

// The zero of a decreasing function above `low`.
double zero_of_falling(const std::function<double(double)>& f, double low, double step) {
  double high = low + step;
  for (int k = 0; k < kSteps && f(high) > 0; ++k) low = high, high += (step *= 2);
  for (int k = 0; k < kSteps; ++k) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (f(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// The point in direction `sign` where a function that is positive at `from` and decreases becomes negative; infinite if it is too far.
double crossing(const std::function<double(double)>& f, double from, double sign) {
  double near = from, step = 0.1, far = from + sign * step;
  while (f(far) > 0) {
    near = far;
    far = from + sign * (step *= 1.5);
    if (step > kFar) return sign * kInfinity;
  }
  for (int k = 0; k < kSteps; ++k) {
    const double middle = 0.5 * (near + far);
    if (middle == near || middle == far) break;
    (f(middle) > 0 ? near : far) = middle;
  }
  return 0.5 * (near + far);
}

std::vector<Between> taken_together(std::vector<Between> data) {
  std::sort(data.begin(), data.end(), [](const Between& a, const Between& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  std::vector<Between> out;
  for (const Between& d : data) {
    if (!(d.weight > 0)) continue;
    if (!out.empty() && out.back().low == d.low && out.back().high == d.high)
      out.back().weight += d.weight;
    else
      out.push_back(d);
  }
  return out;
}

// Whether the maximum likelihood is at a finite median and dispersion, from the brackets' ends.
LimitStateVerdict verdict_of(const std::vector<Between>& data) {
  double lowest_high = kInfinity, highest_low = 0;
  bool any_low = false, any_high = false;
  for (const Between& d : data) {
    any_low = any_low || d.low > 0;
    any_high = any_high || std::isfinite(d.high);
    lowest_high = std::min(lowest_high, d.high);
    highest_low = std::max(highest_low, d.low);
  }
  if (!any_high) return LimitStateVerdict::kNever;
  if (!any_low) return LimitStateVerdict::kAlways;
  return highest_low <= lowest_high ? LimitStateVerdict::kSeparated : LimitStateVerdict::kTold;
}

}  // namespace

LognormalFit::LognormalFit(std::vector<Between> data) : data_(taken_together(std::move(data))) {
  verdict_ = verdict_of(data_);
  if (!is_told()) return;
  double weight = 0, squares = 0;
  for (Between& d : data_) {
    d.low = std::log(d.low), d.high = std::log(d.high);
    for (const double end : {d.low, d.high})
      if (std::isfinite(end)) mean_ += d.weight * end, weight += d.weight;
  }
  mean_ /= weight;
  for (const Between& d : data_)
    for (const double end : {d.low, d.high})
      if (std::isfinite(end)) squares += d.weight * (end - mean_) * (end - mean_);
  scale_ = std::sqrt(squares / weight);  // not 0: the brackets are not separated
  for (Between& d : data_) d.low = (d.low - mean_) / scale_, d.high = (d.high - mean_) / scale_;
  maximise();
}

LognormalFit::Slope LognormalFit::slope(double a, double b) const {
  Slope s;
  for (const Between& d : data_) {
    // a + b x, with infinite ends unchanged
    const double u = std::isinf(d.high) ? kInfinity : a + b * d.high;
    const double l = std::isinf(d.low) ? -kInfinity : a + b * d.low;
    const double p = between(l, u);
    if (!(p > 0)) return {.value = -kInfinity, .first = {}, .second = {}};
    const double xu = std::isinf(d.high) ? 0 : d.high, xl = std::isinf(d.low) ? 0 : d.low;
    const double du = density(u) / p, dl = density(l) / p;
    const double uu = -leaning(u) / p - du * du, ll = leaning(l) / p - dl * dl, ul = du * dl;
    const double w = d.weight;
    s.value += w * std::log(p);
    s.first[0] += w * (du - dl);
    s.first[1] += w * (du * xu - dl * xl);
    s.second[0] += w * (uu + ll + 2 * ul);
    s.second[1] += w * (uu * xu + ll * xl + ul * (xu + xl));
    s.second[2] += w * (uu * xu * xu + ll * xl * xl + 2 * ul * xu * xl);
  }
  return s;
}

void LognormalFit::maximise() {
  // with one-sided outcomes only, the trend may be rising or falling; the gradient at b = 0 decides
  const bool one_sided = std::all_of(data_.begin(), data_.end(), [](const Between& d) {
    return std::isinf(d.low) || std::isinf(d.high);
  });
  if (one_sided) {
    double reached = 0, all = 0;
    for (const Between& d : data_) all += d.weight, reached += std::isinf(d.low) ? d.weight : 0;
    if (!(slope(normal_quantile(reached / all), 0).first[1] > 1e-9 * all)) {
      verdict_ = LimitStateVerdict::kNoTrend;
      return;
    }
  }
  a_ = 0, b_ = 1;
  Slope s = slope(a_, b_);
  for (int k = 0; k < kSteps && std::isfinite(s.value); ++k) {
    const auto& h = s.second;
    const double det = h[0] * h[2] - h[1] * h[1];
    if (!(det > 0)) break;
    const double da = -(h[2] * s.first[0] - h[1] * s.first[1]) / det;
    const double db = -(h[0] * s.first[1] - h[1] * s.first[0]) / det;
    double part = 1;
    Slope next = s;
    for (; part > 1e-12; part *= 0.5) {
      if (!(b_ + part * db > 0)) continue;
      next = slope(a_ + part * da, b_ + part * db);
      if (next.value >= s.value) break;
    }
    if (part <= 1e-12) break;  // no better point: at the maximum, up to rounding
    const double gain = next.value - s.value;
    a_ += part * da, b_ += part * db;
    s = next;
    if (gain <= 1e-13 * std::fabs(s.value) && std::fabs(da) + std::fabs(db) < 1e-9) break;
  }
  likelihood_ = s.value;
  const auto& h = s.second;
  const double det = h[0] * h[2] - h[1] * h[1];
  covariance_ = {-h[2] / det, h[1] / det, -h[0] / det};
}

double LognormalFit::median() const {
  return is_told() ? std::exp(mean_ - scale_ * a_ / b_) : kUnset;
}
double LognormalFit::beta() const { return is_told() ? scale_ / b_ : kUnset; }

double LognormalFit::best_with_place(double z) const {
  const auto along = [&](double b) {
    const Slope s = slope(-b * z, b);
    return std::isfinite(s.value) ? s.first[1] - z * s.first[0] : -1.0;
  };
  const double b = zero_of_falling(along, 0, 0.1);
  return slope(-b * z, b).value;
}

double LognormalFit::best_with_b(double b) const {
  // starts far to the left, where the likelihood rises or is 0
  double low = a_, high = a_, step = 1;
  const auto rises = [&](double a) {
    const Slope s = slope(a, b);
    return std::isfinite(s.value) ? s.first[0] : (a < a_ ? 1.0 : -1.0);
  };
  for (int k = 0; k < kSteps && rises(low) < 0; ++k) low -= step, step *= 2;
  step = 1;
  for (int k = 0; k < kSteps && rises(high) > 0; ++k) high += step, step *= 2;
  for (int k = 0; k < kSteps; ++k) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (rises(middle) > 0 ? low : high) = middle;
  }
  return slope(0.5 * (low + high), b).value;
}

Interval LognormalFit::profile_median() const {
  if (!is_told()) return {};
  const auto above = [&](double z) { return kDeviance95 - 2 * (likelihood_ - best_with_place(z)); };
  const double z = -a_ / b_;
  return {std::exp(mean_ + scale_ * crossing(above, z, -1)),
          std::exp(mean_ + scale_ * crossing(above, z, 1))};
}

Interval LognormalFit::profile_beta() const {
  if (!is_told()) return {};
  const auto above = [&](double log_b) {
    return kDeviance95 - 2 * (likelihood_ - best_with_b(std::exp(log_b)));
  };
  const double log_b = std::log(b_);
  return {scale_ * std::exp(-crossing(above, log_b, 1)),
          scale_ * std::exp(-crossing(above, log_b, -1))};
}

Estimate LognormalFit::at(double x) const {
  if (!is_told()) return {};
  const double z = (std::log(x) - mean_) / scale_, eta = a_ + b_ * z;
  const double deviation =
      std::sqrt(covariance_[0] + 2 * z * covariance_[1] + z * z * covariance_[2]);
  return {normal_cdf(eta),
          {normal_cdf(eta - kNormal95 * deviation), normal_cdf(eta + kNormal95 * deviation)}};
}

}  // namespace wythe::study
