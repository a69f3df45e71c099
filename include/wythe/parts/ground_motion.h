// The motion of the ground along one direction: an acceleration that is linear between its samples, and its
// exact integrals (docs/theory/dynamics.md, "The record").
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/vector.h"

namespace wythe {

struct GroundMotion {
  Vec3 along;                        // unit vector, in the wall's axes
  std::vector<double> time;          // rises strictly, from 0 on [s]
  std::vector<double> acceleration;  // at these times, linear between them, 0 outside [m/s^2]
  std::vector<double> velocity;      // integrals up to these times [m/s], [m]
  std::vector<double> displacement;
  std::string source;  // "aigio.csv", "half_cycle", "table"
  double factor = 1;   // by which it was scaled

  [[nodiscard]] bool empty() const { return time.empty(); }
  [[nodiscard]] double duration() const { return empty() ? 0 : time.back(); }
  [[nodiscard]] double acceleration_at(double t) const;
  [[nodiscard]] double velocity_at(double t) const;  // after the end it stays
  [[nodiscard]] double displacement_at(
      double t) const;  // after the end it goes on with that velocity
};

// With integrals; at least two samples.
[[nodiscard]] GroundMotion ground_motion(std::vector<double> time,
                                         std::vector<double> acceleration);
[[nodiscard]] GroundMotion scaled(GroundMotion motion, double factor);
// a + factor b, at the times of both.
[[nodiscard]] GroundMotion combined(const GroundMotion& a, const GroundMotion& b, double factor);

// One g of records and intensities, whatever the model's gravity and whatever a code means by g [m/s^2].
inline constexpr double kGravityOfRecords = 9.80665;
[[nodiscard]] double peak_acceleration(const GroundMotion& motion);  // [m/s^2]
[[nodiscard]] double peak_velocity(const GroundMotion& motion);      // [m/s]
// pi / (2 g) times the integral of a^2 [m/s].
[[nodiscard]] double arias_intensity(const GroundMotion& motion);
// Largest |displacement| of an oscillator of this period [s] and fraction of critical damping below 1,
// by its exact solution between samples (Nigam and Jennings 1969); read at the samples and a hundred times a
// period at least, up to one period after the record [m].
[[nodiscard]] double spectral_displacement(const GroundMotion& motion, double period,
                                           double damping);
// The same times omega^2 [m/s^2].
[[nodiscard]] double pseudo_acceleration(const GroundMotion& motion, double period, double damping);

}  // namespace wythe
