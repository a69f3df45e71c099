// Distributions by their closed forms, with the same bits on all machines. Boost finds roots and gives the
// incomplete beta function. That one calls libm, so a value drawn from a beta may differ by an ulp between machines.
#include "campaign/draws/margin.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "campaign/draws/distribution.h"
#include "campaign/draws/generator.h"
#include "core/check.h"
#include "core/elementary.h"
#include "core/gamma.h"
#include "core/normal.h"

namespace wythe {
namespace {

double normal_density(double z) { return 0.3989422804014327 * elementary::exp(-0.5 * z * z); }

struct Moments {
  double mean, deviation;
};

Moments moments_of(const VariableSpec& s) {
  return {s.mean, is_set(s.cov) ? s.cov * std::fabs(s.mean) : s.standard_deviation};
}

Distribution normal(double mean, double deviation) {
  const auto z = [=](double x) { return (x - mean) / deviation; };
  return {.below = [z](double x) { return normal_share(z(x)); },
          .above = [z](double x) { return normal_share(-z(x)); },
          .density = [z, deviation](double x) { return normal_density(z(x)) / deviation; },
          .quantile = [=](double u) { return mean + deviation * normal_quantile(u); }};
}

Distribution make_normal(const VariableSpec& s) {
  const auto [mean, deviation] = moments_of(s);
  return normal(mean, deviation);
}

Distribution lognormal(double of_log, double spread) {
  const auto z = [of_log, spread](double x) {
    return x > 0 ? (elementary::log(x) - of_log) / spread : -kInfinity;
  };
  return {
      .below = [z](double x) { return normal_share(z(x)); },
      .above = [z](double x) { return normal_share(-z(x)); },
      .density = [z, spread](double x) { return x > 0 ? normal_density(z(x)) / (spread * x) : 0; },
      .quantile = [of_log, spread](
                      double u) { return elementary::exp(of_log + spread * normal_quantile(u)); }};
}

Distribution make_lognormal(const VariableSpec& s) {
  if (is_set(s.median)) return lognormal(elementary::log(s.median), s.log_standard_deviation);
  const auto [mean, deviation] = moments_of(s);
  const double ratio = deviation / mean;
  const double spread = std::sqrt(elementary::log1p(ratio * ratio));
  return lognormal(elementary::log(mean) - 0.5 * spread * spread, spread);
}

Distribution uniform(double low, double high) {
  const double width = high - low;
  return {.below = [=](double x) { return std::clamp((x - low) / width, 0.0, 1.0); },
          .above = [=](double x) { return std::clamp((high - x) / width, 0.0, 1.0); },
          .density = [=](double x) { return x >= low && x <= high ? 1 / width : 0; },
          .quantile = [=](double u) { return low + u * width; }};
}

Distribution make_uniform(const VariableSpec& s) {
  if (is_set(s.low)) return uniform(s.low, s.high);
  const auto [mean, deviation] = moments_of(s);
  const double half = std::sqrt(3.0) * deviation;
  return uniform(mean - half, mean + half);
}

// Two parabolas that meet at the mode, where the share (mode - low) / (high - low) lies below.
Distribution triangular(double low, double mode, double high) {
  const double width = high - low, left = mode - low, right = high - mode;
  return {.below =
              [=](double x) {
                if (x <= low || x >= high) return x <= low ? 0.0 : 1.0;
                return x < mode ? (x - low) * (x - low) / (width * left)
                                : 1 - (high - x) * (high - x) / (width * right);
              },
          .above =
              [=](double x) {
                if (x <= low || x >= high) return x <= low ? 1.0 : 0.0;
                return x < mode ? 1 - (x - low) * (x - low) / (width * left)
                                : (high - x) * (high - x) / (width * right);
              },
          .density =
              [=](double x) {
                if (x < low || x > high) return 0.0;
                if (x == mode) return 2 / width;
                return x < mode ? 2 * (x - low) / (width * left) : 2 * (high - x) / (width * right);
              },
          .quantile =
              [=](double u) {
                return u < left / width ? low + std::sqrt(u * width * left)
                                        : high - std::sqrt((1 - u) * width * right);
              }};
}

Distribution make_triangular(const VariableSpec& s) {
  if (is_set(s.low)) return triangular(s.low, s.mode, s.high);
  const auto [mean, deviation] = moments_of(s);
  const double half = std::sqrt(6.0) * deviation;
  return triangular(mean - half, mean, mean + half);
}

Distribution beta(double a, double b, double low, double high) {
  if (!(a > 0) || !(b > 0) || !(high > low))
    throw std::domain_error("alpha and beta of a beta distribution must be more than 0");
  const double width = high - low;
  const auto share = [=](double x) { return std::clamp((x - low) / width, 0.0, 1.0); };
  return {.below = [=](double x) { return boost::math::ibeta(a, b, share(x)); },
          .above = [=](double x) { return boost::math::ibetac(a, b, share(x)); },
          .density =
              [=](double x) {
                const double t = share(x);
                return t > 0 && t < 1 ? boost::math::ibeta_derivative(a, b, t) / width : 0;
              },
          .quantile = [=](double u) { return low + width * boost::math::ibeta_inv(a, b, u); }};
}

// alpha + beta from the variance: with x = (mean - low) / (high - low), s2 = variance / (high - low)^2
// is x (1 - x) / (alpha + beta + 1).
Distribution make_beta(const VariableSpec& s) {
  if (is_set(s.alpha)) return beta(s.alpha, s.beta, s.low, s.high);
  const auto [mean, deviation] = moments_of(s);
  const double width = s.high - s.low, x = (mean - s.low) / width;
  const double sum = x * (1 - x) * width * width / (deviation * deviation) - 1;
  return beta(x * sum, (1 - x) * sum, s.low, s.high);
}

// F(x) = 1 - exp(-((x - location) / scale)^shape)
Distribution weibull(double scale, double shape, double location) {
  const auto power = [=](double x) {
    return x > location ? elementary::pow((x - location) / scale, shape) : 0.0;
  };
  return {.below = [=](double x) { return -elementary::expm1(-power(x)); },
          .above = [=](double x) { return elementary::exp(-power(x)); },
          .density =
              [=](double x) {
                return x > location ? shape / (x - location) * power(x) * elementary::exp(-power(x))
                                    : 0;
              },
          .quantile =
              [=](double u) {
                return location + scale * elementary::pow(-elementary::log1p(-u), 1 / shape);
              }};
}

// Shape of a Weibull distribution from location 0 whose deviation is `ratio` of its mean: the root of
// Gamma(1 + 2/k) / Gamma(1 + 1/k)^2 = 1 + ratio^2, which falls as k grows.
double weibull_shape(double ratio) {
  const auto excess = [&](double log_shape) {
    const double inverse = elementary::exp(-log_shape);
    return log_gamma_1p(2 * inverse) - 2 * log_gamma_1p(inverse) - elementary::log1p(ratio * ratio);
  };
  constexpr double low = -4, high = 30;  // ln of the shape: ratios from 1e-13 to 1e26
  if (!(excess(low) > 0) || !(excess(high) < 0))
    throw std::domain_error("no Weibull distribution has this ratio of deviation to mean");
  return elementary::exp(root_between(excess, low, high));
}

Distribution make_weibull(const VariableSpec& s) {
  const double location = is_set(s.location) ? s.location : 0.0;
  if (is_set(s.shape)) return weibull(s.scale, s.shape, location);
  const auto [mean, deviation] = moments_of(s);
  const double above = mean - location;
  if (!(above > 0))
    throw std::domain_error("the mean of a Weibull distribution lies above its location");
  const double shape = weibull_shape(deviation / above);
  return weibull(above / elementary::exp(log_gamma_1p(1 / shape)), shape, location);
}

// For each kind: its parameters, and how it is made. Measured values have no formula.
struct KindRow {
  DistributionKind kind;
  study::DistributionForms takes;
  Distribution (*make)(const VariableSpec&);
};

const KindRow& kind_of(DistributionKind kind) {
  using D = DistributionKind;
  static const std::vector<KindRow> kKinds = {
      {D::kNormal, {"a normal", {{"mean", "spread"}}}, make_normal},
      {D::kLognormal,
       {"a lognormal", {{"mean", "spread"}, {"median", "log_standard_deviation"}}},
       make_lognormal},
      {D::kUniform, {"a uniform", {{"low", "high"}, {"mean", "spread"}}}, make_uniform},
      {D::kTriangular,
       {"a triangular", {{"low", "mode", "high"}, {"mean", "spread"}}},
       make_triangular},
      {D::kBeta,
       {"a beta", {{"alpha", "beta", "low", "high"}, {"mean", "spread", "low", "high"}}},
       make_beta},
      {D::kWeibull,
       {"a Weibull", {{"shape", "scale"}, {"mean", "spread"}}, {"location"}},
       make_weibull},
      {D::kEmpirical, {"an empirical", {{}}}, nullptr}};
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const KindRow& k) { return k.kind == kind; });
  WYTHE_ASSERT(found != kKinds.end(), "a kind of distribution without its line");
  return *found;
}

}  // namespace

double root_between(const std::function<double(double)>& f, double low, double high) {
  std::uintmax_t evaluations = 100;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(), evaluations);
  return 0.5 * (a + b);
}

const study::DistributionForms& study::forms_of(DistributionKind kind) {
  return kind_of(kind).takes;
}

Margin::Margin(const VariableSpec& spec)
    : lower_(is_set(spec.lower) ? spec.lower : -kInfinity),
      upper_(is_set(spec.upper) ? spec.upper : kInfinity) {
  if (spec.distribution == DistributionKind::kEmpirical) {
    const double share = 1.0 / static_cast<double>(spec.values.size());
    for (const double value : spec.values) {
      if (value < lower_)
        below_ += share;
      else if (value > upper_)
        above_ += share;
      else
        values_.push_back(value);
    }
    std::sort(values_.begin(), values_.end());
    return;
  }
  stated_ = kind_of(spec.distribution).make(spec);
  if (lower_ > -kInfinity) below_ = stated_.below(lower_);
  if (upper_ < kInfinity) above_ = stated_.above(upper_);
}

double Margin::density(double x) const {
  if (!stated_.density || x < lower_ || x > upper_ || !(kept() > 0)) return 0;
  return stated_.density(x) / kept();
}

double Margin::kept() const { return std::max(0.0, 1 - below_ - above_); }

double Margin::quantile(double u) const {
  if (!values_.empty()) {
    const auto count = static_cast<double>(values_.size());
    return values_[std::min(values_.size() - 1, static_cast<std::size_t>(u * count))];
  }
  return std::clamp(stated_.quantile(inside(below_ + u * kept())), lower_, upper_);
}

}  // namespace wythe
