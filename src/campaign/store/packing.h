// Packs arrays of numbers to compressed bytes and back: curves and states of the store. The only access to zstd.
//
// A packed array is a zstd frame with a checksum; inside, little-endian IEEE numbers one after the
// other: float64 for curves (exactly as computed), float32 for states (pictures).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wythe::study {

[[nodiscard]] std::string pack_doubles(std::span<const double> numbers);
[[nodiscard]] std::string pack_floats(std::span<const double> numbers);

// `what` names the array in the IoError that is thrown when the bytes are damaged or do
// not hold `count` numbers. Memory is allocated only if the head of the frame agrees.
[[nodiscard]] std::vector<double> unpack_doubles(std::string_view bytes, std::size_t count,
                                                 const std::string& what);
[[nodiscard]] std::vector<double> unpack_floats(std::string_view bytes, std::size_t count,
                                                const std::string& what);

// A hash of the unpacked bytes, and their number. It is equal for equal numbers, however they were packed.
struct PackedContent {
  std::uint64_t hash = 0, bytes = 0;
  bool operator==(const PackedContent&) const = default;
};
[[nodiscard]] PackedContent packed_content(std::string_view bytes, const std::string& what);

}  // namespace wythe::study
