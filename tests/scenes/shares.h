// Repeatable numbers for tests that try many cases.
#pragma once

#include <cstdint>

namespace wythe::scenes {

// In [-1, 1].
class Shares {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
  }

 private:
  std::uint64_t state_ = 11;
};

}  // namespace wythe::scenes
