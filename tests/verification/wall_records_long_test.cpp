// A one-way wall out of its plane under many records, against the equation of two rocking bodies.
// Distributions are compared, because a thousandth of the amplitude decides a single history.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "verification/held_wall.h"
#include "verification/record.h"

namespace wythe::verification::wall_records_long_test {
namespace {

// Stationary noise between 0.5 and 8 Hz by 60 cosines of drawn phase and frequency, under an envelope that grows, stays and fades;
// scaled to a peak.
RecordSpec artificial(std::uint64_t seed, double peak) {
  constexpr double kStep = 0.005, kLong = 4;
  const auto next = [&] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 11) * 0x1p-53;
  };
  for (int k = 0; k < 20; ++k) next();
  struct Wave {
    double rate, phase;
  };
  std::vector<Wave> waves;
  for (int k = 0; k < 60; ++k) {
    const double frequency = 0.5 * std::pow(16.0, next());  // evenly over the octaves
    waves.push_back({2 * M_PI * frequency, 2 * M_PI * next()});
  }
  RecordSpec record;
  record.unit = RecordUnit::kMetres;
  double most = 0;
  for (double t = 0; t <= kLong + 1e-9; t += kStep) {
    double a = 0;
    for (const Wave& w : waves) a += std::cos(w.rate * t + w.phase);
    a *= std::min({1.0, t / 0.8, (kLong - t) / 1.2});
    record.times.push_back(t);
    record.accelerations.push_back(a);
    most = std::max(most, std::fabs(a));
  }
  for (double& a : record.accelerations) a *= peak / most;
  return record;
}

GroundMotion motion_of(const RecordSpec& record) {
  return ground_motion(record.times, record.accelerations);
}

struct Peaks {
  std::vector<double> found;  // over b; 9: fell
  [[nodiscard]] double fallen() const {
    return static_cast<double>(std::count(found.begin(), found.end(), 9.0)) /
           static_cast<double>(found.size());
  }
  // The share of the records that stay below.
  [[nodiscard]] double below(double peak) const {
    return static_cast<double>(
               std::count_if(found.begin(), found.end(), [&](double p) { return p < peak; })) /
           static_cast<double>(found.size());
  }
};
// The largest distance of two distributions (Kolmogorov and Smirnov).
double distance_of(const Peaks& a, const Peaks& b) {
  double most = 0;
  for (const Peaks* of : {&a, &b})
    for (const double p : of->found)
      for (const double at : {p, std::nextafter(p, 10)})
        most = std::max(most, std::fabs(a.below(at) - b.below(at)));
  return most;
}

TEST(WallRecords, a_wall_under_many_records_falls_as_often_as_two_rocking_bodies) {
  const HeldWall w{0.12, 1.5};
  constexpr int kRecords = 48;
  Peaks equation, engine;
  std::vector<double> ratio;  // where it stands in both
  for (std::uint64_t seed = 1; seed <= kRecords; ++seed) {
    const RecordSpec record = artificial(seed, 1.7 * w.uplift());
    equation.found.push_back(bent(w, motion_of(record), record.times.back() + 2));
    engine.found.push_back(shaken_bend(w, record, 4e10));
    const double wanted = equation.found.back(), found = engine.found.back();
    if (wanted < 9 && found < 9) ratio.push_back(std::log(found / wanted));
  }
  EXPECT_GT(ratio.size(), 15U) << "records that leave it standing";
  EXPECT_GT(equation.fallen(), 0.25) << "and that do not";
  verify({"SH08", "one-way wall under 48 records: share that falls, less that of two bodies", "-",
          0, 2 * std::sqrt(0.25 / kRecords), "two standard errors of a share of 48 records", true},
         engine.fallen() - equation.fallen());
  verify({"SH08", "the same: largest distance of the two distributions of the peak", "-", 0,
          1.358 * std::sqrt(2.0 / kRecords), "Kolmogorov and Smirnov at 5 %", true},
         distance_of(equation, engine));
  std::sort(ratio.begin(), ratio.end());
  verify({"SH08", "the same: median logarithm of the peak over two bodies', where both stand", "-",
          0, 8e-2, "springs in the hinges and at the top; restitution 0.05 where it says 0", true},
         ratio[ratio.size() / 2]);
}

}  // namespace
}  // namespace wythe::verification::wall_records_long_test
