// Rearrangements of 2, 4 or 8 doubles, for any vector type of the compiler (GCC, clang).
//
//   load_rows           `width` rows of four doubles, scattered, as four vectors of whole rows
//   transpose           those -> four columns, and back
//   store_rows          four vectors of whole rows -> consecutive memory
//
// For width 4 vector k is row k; for 2 the halves of two rows; for 8 rows k and k + 4.
// Tested for every width on any processor (tests/unit/core/shuffle_test.cpp): the compiler splits vectors
// that the processor lacks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/real.h"

namespace wythe::dynamics::shuffle {

template <class V>
inline constexpr int width_of = static_cast<int>(sizeof(V) / sizeof(double));

// Unaligned loads and stores as one instruction (GCC makes two of a memcpy).
template <class V>
struct [[gnu::packed, gnu::may_alias]] Unaligned {
  V vector;
};
template <class V>
[[nodiscard]] WYTHE_INLINE V load(const double* from) {
  return reinterpret_cast<const Unaligned<V>*>(from)->vector;
}
template <class V>
WYTHE_INLINE void store(V vector, double* to) {
  reinterpret_cast<Unaligned<V>*>(to)->vector = vector;
}

namespace detail {
// Every second and next element, pairwise: (a0 b0 a2 b2 ...), (a1 b1 a3 b3 ...).
template <class V>
[[nodiscard]] WYTHE_INLINE V first_of_pairs(V a, V b) {
  if constexpr (width_of<V> == 2) return __builtin_shufflevector(a, b, 0, 2);
  if constexpr (width_of<V> == 4) return __builtin_shufflevector(a, b, 0, 4, 2, 6);
  if constexpr (width_of<V> == 8) return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
template <class V>
[[nodiscard]] WYTHE_INLINE V second_of_pairs(V a, V b) {
  if constexpr (width_of<V> == 2) return __builtin_shufflevector(a, b, 1, 3);
  if constexpr (width_of<V> == 4) return __builtin_shufflevector(a, b, 1, 5, 3, 7);
  if constexpr (width_of<V> == 8) return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
// Lower and upper two of each four.
template <class V>
[[nodiscard]] WYTHE_INLINE V low_halves(V a, V b) {
  if constexpr (width_of<V> == 4) return __builtin_shufflevector(a, b, 0, 1, 4, 5);
  if constexpr (width_of<V> == 8) return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
template <class V>
[[nodiscard]] WYTHE_INLINE V high_halves(V a, V b) {
  if constexpr (width_of<V> == 4) return __builtin_shufflevector(a, b, 2, 3, 6, 7);
  if constexpr (width_of<V> == 8) return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
}  // namespace detail

template <class V>
WYTHE_INLINE void load_rows(const double* rows, const std::int32_t* id, V (&to)[4]) {
  constexpr int width = width_of<V>;
  const auto row = [&](int k) { return rows + 4 * static_cast<std::ptrdiff_t>(id[k]); };
  if constexpr (width == 2) {
    for (int k = 0; k < 4; ++k) to[k] = load<V>(row(k % 2) + 2 * (k / 2));
  } else if constexpr (width == 4) {
    for (int k = 0; k < 4; ++k) to[k] = load<V>(row(k));
  } else {
    typedef double Half __attribute__((vector_size(32)));
    for (int k = 0; k < 4; ++k) {
      const Half low = load<Half>(row(k)), high = load<Half>(row(k + 4));
      to[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    }
  }
}

// Width 2: (row0 lo, row1 lo, row0 hi, row1 hi) <-> (c0, c1, c2, c3); else rows <-> columns.
template <class V>
WYTHE_INLINE void transpose(V (&v)[4]) {
  const V a0 = detail::first_of_pairs(v[0], v[1]), a1 = detail::second_of_pairs(v[0], v[1]);
  const V b0 = detail::first_of_pairs(v[2], v[3]), b1 = detail::second_of_pairs(v[2], v[3]);
  if constexpr (width_of<V> == 2) {
    v[0] = a0;
    v[1] = a1;
    v[2] = b0;
    v[3] = b1;
  } else {
    v[0] = detail::low_halves(a0, b0);
    v[1] = detail::low_halves(a1, b1);
    v[2] = detail::high_halves(a0, b0);
    v[3] = detail::high_halves(a1, b1);
  }
}

template <class V>
WYTHE_INLINE void store_rows(const V (&row)[4], double* to) {
  constexpr int width = width_of<V>;
  if constexpr (width == 2) {
    for (int k = 0; k < 4; ++k) store(row[k], to + 4 * (k % 2) + 2 * (k / 2));
  } else if constexpr (width == 4) {
    for (int k = 0; k < 4; ++k) store(row[k], to + 4 * k);
  } else {
    typedef double Half __attribute__((vector_size(32)));
    for (int k = 0; k < 4; ++k) {
      const Half low = __builtin_shufflevector(row[k], row[k], 0, 1, 2, 3);
      const Half high = __builtin_shufflevector(row[k], row[k], 4, 5, 6, 7);
      store(low, to + 4 * k);
      store(high, to + 4 * (k + 4));
    }
  }
}

}  // namespace wythe::dynamics::shuffle
