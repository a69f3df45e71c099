// The motion of the ground along one direction: an acceleration that is linear between samples, with its
// exact integrals (docs/theory/dynamics.md, "The record").
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/vector.h"

namespace wythe {

struct GroundMotion {
  Vec3 along;                        // unit vector, in the wall's axes
  std::vector<double> time;          // rises strictly, from 0 on [s]
  std::vector<double> acceleration;  // linear between these times, 0 outside [m/s^2]
  std::vector<double> velocity;      // exact integrals at these times [m/s], [m]
  std::vector<double> displacement;
  std::string source;  // "aigio.csv", "half_cycle", "table"
  double factor = 1;   // scale factor of the acceleration

  [[nodiscard]] bool empty() const { return time.empty(); }
  [[nodiscard]] double duration() const { return empty() ? 0 : time.back(); }
  [[nodiscard]] double acceleration_at(double t) const;  // 0 outside its times [m/s^2]
  [[nodiscard]] double velocity_at(double t) const;      // constant after the end
  [[nodiscard]] double displacement_at(
      double t) const;  // after the end it grows at constant velocity
};

// A motion with its integrals; it needs at least two samples.
[[nodiscard]] GroundMotion ground_motion(std::vector<double> time,
                                         std::vector<double> acceleration);
[[nodiscard]] GroundMotion scaled(GroundMotion motion, double factor);  // with its integrals
// The sum a + factor b, sampled at the times of both.
[[nodiscard]] GroundMotion combined(const GroundMotion& a, const GroundMotion& b, double factor);

// The g of records and intensities, independent of solve.gravity and of the g of a code [m/s^2].
inline constexpr double kGravityOfRecords = 9.80665;
[[nodiscard]] double peak_acceleration(const GroundMotion& motion);  // [m/s^2]
[[nodiscard]] double peak_velocity(const GroundMotion& motion);      // [m/s]
// Arias intensity: pi / (2 g) times the integral of a^2 over time [m/s].
[[nodiscard]] double arias_intensity(const GroundMotion& motion);
// Largest |displacement| [m] of an oscillator with this period [s] and this damping, a fraction of critical below 1.
// The solution between samples is exact (Nigam and Jennings 1969). It is read at the samples and at least a hundred
// times a period, until one period after the record.
[[nodiscard]] double spectral_displacement(const GroundMotion& motion, double period,
                                           double damping);
// spectral_displacement() times omega^2 [m/s^2].
[[nodiscard]] double pseudo_acceleration(const GroundMotion& motion, double period, double damping);

}  // namespace wythe
