// The bytes of a page's data: a JSON header and typed arrays, deflated. Packs with zlib (deflate.h).
//
//   zlib( "WYTHE\0\0" version | header length, uint32 | header, UTF-8 | arrays )     little endian
//
// Each array begins at a multiple of 8 bytes from the first one; header.arrays.<name> is {type, at,
// count} and, where values were rounded, step: value = number * step; or steps, one for each of as many equal
// parts. web/src/base/bundle.ts reads it.
// Deflate because every browser unpacks it (DecompressionStream) and none unpacks zstd.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace wythe::report {

using Json = nlohmann::ordered_json;

class Bundle {
 public:
  Json header;  // "kind" names the page; NaN becomes null
  void add(const std::string& name, std::span<const float> values);
  void add(const std::string& name, std::span<const std::int32_t> values);
  void add(const std::string& name, std::span<const std::uint8_t> values);
  // Rounds to 16 bits: the error is at most half of (largest magnitude / 32767); NaN becomes 0.
  void add_rounded(const std::string& name, std::span<const double> values);
  // The same for each of `rows` equal parts separately, so that
  // small values of one row stay exact beside large ones of another.
  void add_rounded(const std::string& name, std::span<const double> values, int rows);
  [[nodiscard]] std::string packed() const;

 private:
  void place(const std::string& name, const char* type, std::size_t count,
             std::span<const std::byte> bytes);
  std::string arrays_;
  Json table_ = Json::object();
};

// Converts [0, 1] to a byte; the error is at most 1/510.
[[nodiscard]] std::uint8_t share_byte(double share);

// Throws an IoError: the data of a report are damaged or have the fault `what`; with the cure.
[[noreturn]] void refuse_data(const std::string& what);

// Only the header. Throws IoError where the bytes are damaged, of another
// version, or unpack to more than they should. Only the header is kept in memory.
[[nodiscard]] Json header_of(std::string_view packed);

}  // namespace wythe::report
