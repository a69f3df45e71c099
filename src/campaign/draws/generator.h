// The random numbers of studies and fields: dSFMT-19937, version 1.2 (Saito and Matsumoto 2008), the generator of
// OpenTURNS 1.20, so that old seeds keep their samples. One object for each stream, with the same bits on all machines.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/hash.h"

namespace wythe {

// The seed made from a hash.
[[nodiscard]] std::uint32_t folded(const Hash& hash);
// Limits u to [2^-54, 1 - 2^-53], where every quantile is finite.
[[nodiscard]] inline double inside(double u) { return std::clamp(u, 0x1p-54, 1 - 0x1p-53); }

class Generator {
 public:
  explicit Generator(std::uint32_t seed);

  // Uniform in [0, 1), a multiple of 2^-52.
  double uniform();
  // An integer from 0 to `n` - 1, n > 0.
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
// One number for each place, which depends only on the seed, the name and that place.
using PlaceKey = std::array<std::int64_t, 3>;
[[nodiscard]] std::vector<double> normal_numbers_at(int seed, const std::string& name,
                                                    const std::vector<PlaceKey>& places);

}  // namespace wythe
