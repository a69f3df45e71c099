// The random numbers of studies and fields: dSFMT-19937 in its version 1.2 (Saito and Matsumoto 2008), the generator of
// OpenTURNS 1.20, so that a seed keeps the samples it has always had. One object a stream, with the same bits everywhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/hash.h"

namespace wythe {

// The seed that stands for a hash.
[[nodiscard]] std::uint32_t folded(const Hash& hash);
// u as a share that every quantile is finite for, in [2^-54, 1 - 2^-53].
[[nodiscard]] inline double inside(double u) { return std::clamp(u, 0x1p-54, 1 - 0x1p-53); }

class Generator {
 public:
  explicit Generator(std::uint32_t seed);

  // Uniform in [0, 1), a multiple of 2^-52.
  double uniform();
  // A whole number below `n`, n > 0.
  std::uint64_t below(std::uint64_t n) { return next() % n; }

 private:
  static constexpr std::size_t kPairs = 191;
  struct Pair {
    std::uint64_t low, high;
  };

  std::uint64_t next();
  void refill();

  std::array<Pair, kPairs> state_{};
  Pair lung_{};
  std::size_t at_ = 0;
};

// `count` independent standard normal numbers of the stream `name` of a seed.
[[nodiscard]] std::vector<double> normal_numbers(int seed, const std::string& name,
                                                 std::size_t count);
// One for each place, of the seed, the name and that place alone.
using PlaceKey = std::array<std::int64_t, 3>;
[[nodiscard]] std::vector<double> normal_numbers_at(int seed, const std::string& name,
                                                    const std::vector<PlaceKey>& places);

}  // namespace wythe
