// The recursion of dSFMT 1.2 on pairs of 64 bits; its constants are those of the period 2^19937 - 1. Each number lies in
// [1, 2) as a double: 52 random bits behind the exponent of one.
#include "campaign/draws/generator.h"

#include "core/bits.h"
#include "core/hash.h"
#include "core/normal.h"

namespace wythe {

std::uint32_t folded(const Hash& hash) {
  return static_cast<std::uint32_t>(hash.value() ^ (hash.value() >> 32));
}

namespace {

constexpr std::size_t kShift = 155;  // of the second word of the recursion
constexpr std::uint64_t kFraction = 0x000FFFFFFFFFFFFFU, kOne = 0x3FF0000000000000U;
constexpr std::uint64_t kMaskLow = 0x57FBFFFDFFFF575FU, kMaskHigh = 0xFFFF6FEBFFFFFFEEU;
constexpr std::uint64_t kPeriodLow = 1, kPeriodHigh = 0x000EC8F3D0B00000U;
constexpr int kA = 8, kB = 7, kC = 16, kD = 29;

}  // namespace

// Moves the last pair to the part of the state space that has the full period.
Generator::Generator(std::uint32_t seed) {
  std::array<std::uint32_t, 4 * (kPairs + 1)> word{};
  word[0] = seed;
  for (std::uint32_t i = 1; i < word.size(); ++i)
    word[i] = 1812433253U * (word[i - 1] ^ (word[i - 1] >> 30)) + i;
  const auto pair = [&](std::size_t i) {
    const auto joined = [&](std::size_t k) {
      const std::uint64_t bits = word[k] | (std::uint64_t{word[k + 1]} << 32);
      return (bits & kFraction) | kOne;
    };
    return Pair{joined(4 * i), joined(4 * i + 2)};
  };
  for (std::size_t i = 0; i < kPairs; ++i) state_[i] = pair(i);
  lung_ = pair(kPairs);
  const auto fixed = [](std::uint64_t mask) {
    return (((kOne >> kB) & mask) ^ (kOne >> kC)) | kOne;
  };
  const Pair fix = {fixed(kMaskHigh) ^ (kOne >> (64 - kA)), fixed(kMaskLow)};
  std::uint64_t parity =
      ((lung_.low ^ fix.low) & kPeriodLow) ^ ((lung_.high ^ fix.high) & kPeriodHigh);
  for (int bits = 32; bits > 0; bits >>= 1) parity ^= parity >> bits;
  if ((parity & 1) == 0) lung_.low ^= 1;
  refill();
}

void Generator::refill() {
  Pair last = state_[kPairs - 1];
  for (std::size_t i = 0; i < kPairs; ++i) {
    const Pair a = state_[i], b = state_[(i + kPairs - kShift) % kPairs];
    const auto mixed = [](std::uint64_t lung, std::uint64_t was, std::uint64_t here,
                          std::uint64_t shifted, std::uint64_t far, std::uint64_t mask) {
      return (lung ^ (was >> kC) ^ (was << kD) ^ here ^ shifted ^ ((far >> kB) & mask)) & kFraction;
    };
    const Pair r = {mixed(lung_.high, last.low, a.low, a.low << kA, b.low, kMaskLow),
                    mixed(lung_.low, last.high, a.high, (a.high << kA) | (a.low >> (64 - kA)),
                          b.high, kMaskHigh)};
    lung_.low ^= r.low, lung_.high ^= r.high;
    last = state_[i] = {r.low | kOne, r.high | kOne};
  }
  at_ = 0;
}

std::uint64_t Generator::next() {
  if (at_ == 2 * kPairs) refill();
  const Pair& pair = state_[at_ / 2];
  return at_++ % 2 == 0 ? pair.low : pair.high;
}

double Generator::uniform() { return bits_as<double>(next()) - 1; }

std::vector<double> normal_numbers(int seed, const std::string& name, std::size_t count) {
  Hash hash;
  hash.add("field");
  hash.add(&seed, sizeof seed);
  hash.add(name);
  Generator generator(folded(hash));
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(normal_quantile(inside(generator.uniform())));
  return numbers;
}

namespace {

// The mixing function of SplitMix64: neighbouring places give unrelated values.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

std::vector<double> normal_numbers_at(int seed, const std::string& name,
                                      const std::vector<PlaceKey>& places) {
  Hash start;
  start.add("field in place");
  start.add(&seed, sizeof seed);
  start.add(name);
  std::vector<double> numbers;
  for (const PlaceKey& place : places) {
    std::uint64_t x = mixed(start.value());
    for (const std::int64_t part : place)
      x = mixed(x + 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(part));
    numbers.push_back(normal_quantile((static_cast<double>(x >> 12) + 0.5) * 0x1p-52));
  }
  return numbers;
}

}  // namespace wythe
