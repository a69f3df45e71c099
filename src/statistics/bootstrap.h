// Bootstrap: estimates the scatter of an estimate from the samples themselves.
//
// A replicate draws n samples out of n with replacement; it is stored as a count for each sample, so that a
// statistic over sorted values needs no sorting again. Random bits are splitmix64 from a fixed seed: the same
// samples give the same intervals, and every statistic sees the same replicates. References: Efron and Tibshirani,
// An Introduction to the Bootstrap (1993); of more samples than kMostResampled: Bickel, Goetze and van Zwet,
// Statistica Sinica 7 (1997), (7.1b) of docs/theory/statistics.md.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "statistics/intervals.h"
#include "wythe/parts/statistics.h"

namespace wythe::study {

inline constexpr int kReplicates = 2000;
inline constexpr int kMostResampled = 2000;  // of more samples, this number is resampled

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

// Calls visit with the counts of each replicate in turn.
void each_replicate(int n, const std::function<void(const Counts& count)>& visit);
// Ascending values of the statistic over the replicates, without NaN (where it is undefined).
[[nodiscard]] std::vector<double> replicates(int n, const Statistic& statistic);

// Efron's acceleration from the statistic with each sample left out in turn: their skewness.
[[nodiscard]] double acceleration_of(const std::vector<double>& left_out);
// Interval from the 2.5 and 97.5 % quantiles of the replicates, and the bias-corrected
// and accelerated one. Replicates may be in any order and may include NaN.
[[nodiscard]] Estimate percentile_interval(double value, std::vector<double> replicates);
[[nodiscard]] Estimate bca_interval(double value, std::vector<double> replicates,
                                    double acceleration);

// The interval of a statistic of n samples; none below kFewestForBootstrap, at most kMostResampled (the caller uses Resampled).
[[nodiscard]] Estimate percentile_bootstrap(int n, const Statistic& statistic);
// With the acceleration from the jackknife.
[[nodiscard]] Estimate bca_bootstrap(int n, const Statistic& statistic);

// The samples to resample: all n, or m of them, one at random from each of m equal parts. (At random, because every kth point of a
// Sobol sequence lies in one half.) An interval from m of n samples is wider than that from all by sqrt(n/m); `of_all` corrects this:
//   end = all + (end_m - part) sqrt(m/n)
class Resampled {
 public:
  explicit Resampled(std::size_t n, int most = kMostResampled);
  [[nodiscard]] int size() const { return m_; }
  [[nodiscard]] bool is_all() const { return place_.empty(); }
  template <class Item>
  [[nodiscard]] std::vector<Item> of(const std::vector<Item>& all) const {
    if (is_all()) return all;
    std::vector<Item> taken;
    for (const std::size_t i : place_) taken.push_back(all[i]);
    return taken;
  }
  // The scatter of a replicate, reduced to that of all samples.
  [[nodiscard]] double narrowed(double scatter) const { return shrink_ * scatter; }
  // Converts a replicate, or an end of its interval, from scatter about `part` to scatter about `all`.
  [[nodiscard]] double of_all(double end, double part, double all) const;
  [[nodiscard]] Estimate of_all(const Estimate& part, double all) const;

 private:
  int m_;
  double shrink_ = 1;
  std::vector<std::size_t> place_;
};

}  // namespace wythe::study
