// The bits of one value as another of the same size: std::bit_cast, which not every standard library of C++20 has.
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
