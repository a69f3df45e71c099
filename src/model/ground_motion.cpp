// Motions of the ground: exact integrals of an acceleration that is linear between samples.
#include "wythe/parts/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary.h"

namespace wythe {
namespace {

// Position of a time: between the samples k and k + 1, its distance from k, and the slope there.
struct Place {
  std::size_t k;
  double after, slope;
};

Place place_of(const GroundMotion& m, double t) {
  const auto next = std::upper_bound(m.time.begin(), m.time.end(), t);
  const auto k =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - m.time.begin() - 1)),
               m.time.size() - 2);
  const double width = m.time[k + 1] - m.time[k];
  return {k, t - m.time[k], (m.acceleration[k + 1] - m.acceleration[k]) / width};
}

void integrate(GroundMotion& m) {
  m.velocity.assign(m.time.size(), 0.0);
  m.displacement.assign(m.time.size(), 0.0);
  for (std::size_t k = 0; k + 1 < m.time.size(); ++k) {
    const double h = m.time[k + 1] - m.time[k], a = m.acceleration[k], b = m.acceleration[k + 1];
    m.velocity[k + 1] = m.velocity[k] + 0.5 * h * (a + b);
    m.displacement[k + 1] = m.displacement[k] + h * m.velocity[k] + h * h * (2 * a + b) / 6;
  }
}

}  // namespace

double GroundMotion::acceleration_at(double t) const {
  if (empty() || t < 0 || t > time.back()) return 0;
  const Place p = place_of(*this, t);
  return acceleration[p.k] + p.slope * p.after;
}

double GroundMotion::velocity_at(double t) const {
  if (empty() || t <= 0) return 0;
  if (t >= time.back()) return velocity.back();
  const Place p = place_of(*this, t);
  return velocity[p.k] + p.after * (acceleration[p.k] + 0.5 * p.slope * p.after);
}

double GroundMotion::displacement_at(double t) const {
  if (empty() || t <= 0) return 0;
  if (t >= time.back()) return displacement.back() + velocity.back() * (t - time.back());
  const Place p = place_of(*this, t);
  const double h = p.after;
  return displacement[p.k] + h * (velocity[p.k] + h * (0.5 * acceleration[p.k] + p.slope * h / 6));
}

GroundMotion ground_motion(std::vector<double> time, std::vector<double> acceleration) {
  GroundMotion m;
  m.time = std::move(time);
  m.acceleration = std::move(acceleration);
  integrate(m);
  return m;
}

GroundMotion scaled(GroundMotion m, double factor) {
  for (auto* values : {&m.acceleration, &m.velocity, &m.displacement})
    for (double& value : *values) value *= factor;
  m.factor *= factor;
  return m;
}

GroundMotion combined(const GroundMotion& a, const GroundMotion& b, double factor) {
  if (b.empty()) return a;
  std::vector<double> time;
  std::set_union(a.time.begin(), a.time.end(), b.time.begin(), b.time.end(),
                 std::back_inserter(time));
  // the shorter motion ends at once, not along a line to the next sample of the other
  for (const auto& [one, other] : {std::pair(&a, &b), {&b, &a}})
    if (one->time.back() < other->time.back() && one->acceleration.back() != 0) {
      const double after = std::nextafter(one->time.back(), other->time.back());
      time.insert(std::upper_bound(time.begin(), time.end(), one->time.back()), after);
    }
  std::vector<double> sum;
  for (const double t : time) sum.push_back(a.acceleration_at(t) + factor * b.acceleration_at(t));
  GroundMotion m = ground_motion(std::move(time), std::move(sum));
  m.along = a.along;
  m.source = a.source;
  m.factor = a.factor;
  return m;
}

double peak_acceleration(const GroundMotion& m) {
  double peak = 0;
  for (const double a : m.acceleration) peak = std::max(peak, std::fabs(a));
  return peak;
}

// Maximum over the samples, and over zeros of the acceleration between them.
double peak_velocity(const GroundMotion& m) {
  double peak = 0;
  for (std::size_t k = 0; k < m.time.size(); ++k) {
    peak = std::max(peak, std::fabs(m.velocity[k]));
    if (k + 1 == m.time.size()) break;
    const double a = m.acceleration[k], b = m.acceleration[k + 1];
    if (a * b < 0)
      peak = std::max(
          peak, std::fabs(m.velocity_at(m.time[k] + (m.time[k + 1] - m.time[k]) * a / (a - b))));
  }
  return peak;
}

double arias_intensity(const GroundMotion& m) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < m.time.size(); ++k) {
    const double a = m.acceleration[k], b = m.acceleration[k + 1];
    sum += (m.time[k + 1] - m.time[k]) * (a * a + a * b + b * b) / 3;
  }
  return sum * M_PI / (2 * kGravityOfRecords);
}

double spectral_displacement(const GroundMotion& m, double period, double damping) {
  constexpr double kFine = 100;  // times in a period at which the response is read
  const double omega = 2 * M_PI / period, decay = damping * omega;
  const double turn = omega * std::sqrt(1 - damping * damping);
  double u = 0, v = 0, peak = 0;
  // exact solution over h for a ground acceleration a + slope t
  const auto advance = [&](double h, double a, double slope) {
    const double b = -slope / (omega * omega), c = (-a - 2 * decay * b) / (omega * omega);
    const double p = u - c, q = (v - b + decay * p) / turn;
    const double e = elementary::exp(-decay * h), cosine = elementary::cos(turn * h),
                 sine = elementary::sin(turn * h);
    u = c + b * h + e * (p * cosine + q * sine);
    v = b + e * ((q * turn - decay * p) * cosine - (p * turn + decay * q) * sine);
    peak = std::max(peak, std::fabs(u));
  };
  const auto steps_in = [&](double h) { return std::max(1.0, std::ceil(h * kFine / period)); };
  for (std::size_t k = 0; k + 1 < m.time.size(); ++k) {
    const double h = m.time[k + 1] - m.time[k], n = steps_in(h);
    const double slope = (m.acceleration[k + 1] - m.acceleration[k]) / h;
    for (double i = 0; i < n; ++i) advance(h / n, m.acceleration[k] + slope * h * i / n, slope);
  }
  for (double i = 0; i < kFine; ++i) advance(period / kFine, 0, 0);
  return peak;
}

double pseudo_acceleration(const GroundMotion& m, double period, double damping) {
  const double omega = 2 * M_PI / period;
  return omega * omega * spectral_displacement(m, period, damping);
}

}  // namespace wythe
