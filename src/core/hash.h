// 64-bit FNV-1a hash over bytes. It identifies states and specs; it is not for security.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wythe {

class Hash {
 public:
  void add(const void* bytes, std::size_t count) {
    const auto* p = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ p[i]) * 0x100000001b3ULL;
  }
  void add(std::string_view text) { add(text.data(), text.size()); }
  // -0 and 0 count as the same state; every other bit matters.
  void add(double number) {
    const double clean = number + 0.0;
    add(&clean, sizeof clean);
  }
  void add(const std::vector<double>& numbers) {
    for (const double number : numbers) add(number);
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] std::string text() const {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string digits(16, '0');
    for (std::size_t i = 0; i < 16; ++i) digits[15 - i] = kDigits[(value_ >> (4 * i)) & 15U];
    return digits;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace wythe
