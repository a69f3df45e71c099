// Reads the bits of one value as another type of the same size. It replaces std::bit_cast, which some standard libraries lack.
#pragma once

#include <cstring>
#include <type_traits>

namespace wythe {

template <class To, class From>
[[nodiscard]] To bits_as(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<From> &&
                std::is_trivially_copyable_v<To>);
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

}  // namespace wythe
