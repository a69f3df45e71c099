// Bootstrap: how far an estimate scatters, from the samples themselves.
//
// A replicate draws n samples out of n with replacement; it is told as a count for each sample, so
// that a statistic over sorted values needs no sorting again. Random bits are splitmix64 from a
// fixed seed: the same samples give the same intervals, and every statistic sees the same
// replicates. Reference: Efron and Tibshirani, An Introduction to the Bootstrap (1993).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "wythe/statistics.h"

namespace wythe::study {

inline constexpr int kReplicates = 2000;
inline constexpr int kFewestForBootstrap = 5;  // fewer samples say nothing about their own scatter

// Random numbers: splitmix64 (Steele, Lea and Flood 2014).
class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  // 0 ... n - 1; uneven by less than n / 2^32.
  int below(int n) {
    return static_cast<int>(((next() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
  }
  double uniform() { return (static_cast<double>(next() >> 11) + 0.5) * 0x1.0p-53; }  // (0, 1)

 private:
  std::uint64_t state_;
};

// A statistic of n samples, each taken count[i] times.
using Counts = std::vector<int>;
using Statistic = std::function<double(const Counts& count)>;

// Ascending values of the statistic over the replicates; NaN (undefined there) left out.
[[nodiscard]] std::vector<double> replicates(int n, const Statistic& statistic);
// 2.5 and 97.5 % of the replicates.
[[nodiscard]] Estimate percentile_bootstrap(int n, const Statistic& statistic);
// Bias-corrected and accelerated; the acceleration from the jackknife.
[[nodiscard]] Estimate bca_bootstrap(int n, const Statistic& statistic);

}  // namespace wythe::study
