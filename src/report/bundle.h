// The bytes a page is made of: a JSON header and typed arrays, deflated. Door to zlib.
//
//   zlib( "WYTHE\0\0" version | header length, uint32 | header, UTF-8 | arrays )     little endian
//
// Each array begins at a multiple of 8 bytes from the first one; header.arrays.<name> is {type, at,
// count} and, where values were rounded, step: value = number * step; or steps, one for each of as many equal
// parts. web/src/bundle.ts reads it.
// Deflate because every browser unpacks it (DecompressionStream) and none unpacks zstd.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wythe::report {

using Json = nlohmann::ordered_json;

class Bundle {
 public:
  Json header;  // "kind" names the page; NaN becomes null
  void add(const std::string& name, std::span<const float> values);
  void add(const std::string& name, std::span<const std::int32_t> values);
  void add(const std::string& name, std::span<const std::uint8_t> values);
  // To 16 bits: off by at most half of (largest magnitude / 32767); NaN becomes 0.
  void add_rounded(const std::string& name, std::span<const double> values);
  // The same for each of `rows` equal parts by itself: small values of one row beside large ones of another
  // stay exact.
  void add_rounded(const std::string& name, std::span<const double> values, int rows);
  [[nodiscard]] std::string packed() const;

 private:
  void place(const std::string& name, const char* type, std::size_t count,
             std::span<const std::byte> bytes);
  std::string arrays_;
  Json table_ = Json::object();
};

// [0, 1] to a byte, off by at most 1/510.
[[nodiscard]] std::uint8_t share_byte(double share);

// Throws IoError: the data of a report are damaged, or what else is wrong with them; its cure.
[[noreturn]] void refuse_data(const std::string& what);

// The header alone. Throws IoError where the bytes are damaged, of another version, or stand for more than
// they should; only the header is kept in memory.
[[nodiscard]] Json header_of(std::string_view packed);

}  // namespace wythe::report
