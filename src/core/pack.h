// Real as a pack of doubles, one per lane, over xsimd: the templates of law and step work on N numbers at a time.
//
// Each lane has the bits that a single double would have: every operation is that of IEEE 754, minimum and maximum
// keep the order of their operands, and no multiply-add is fused. Pack is a template over the instruction
// set, so code compiled for one set never shares a function with another.
#pragma once

#include <xsimd/xsimd.hpp>

#include "core/real.h"

namespace wythe {

template <class Arch>
struct Mask {
  xsimd::batch_bool<double, Arch> lanes;
};

template <class Arch>
struct Pack {
  using Batch = xsimd::batch<double, Arch>;
  using Vector = typename Batch::register_type;
  static constexpr int width = static_cast<int>(Batch::size);

  Batch lanes;

  Pack() = default;
  WYTHE_INLINE explicit Pack(double same) : lanes(same) {}
  WYTHE_INLINE explicit Pack(Batch b) : lanes(b) {}

  [[nodiscard]] WYTHE_INLINE static Pack load(const double* from) {
    return Pack(Batch::load_unaligned(from));
  }
  WYTHE_INLINE void store(double* to) const { lanes.store_unaligned(to); }

  WYTHE_INLINE friend Pack operator+(Pack a, Pack b) { return Pack(a.lanes + b.lanes); }
  WYTHE_INLINE friend Pack operator-(Pack a, Pack b) { return Pack(a.lanes - b.lanes); }
  WYTHE_INLINE friend Pack operator*(Pack a, Pack b) { return Pack(a.lanes * b.lanes); }
  WYTHE_INLINE friend Pack operator/(Pack a, Pack b) { return Pack(a.lanes / b.lanes); }
  WYTHE_INLINE friend Mask<Arch> operator<(Pack a, Pack b) { return {a.lanes < b.lanes}; }
  WYTHE_INLINE friend Mask<Arch> operator<=(Pack a, Pack b) { return {a.lanes <= b.lanes}; }
  WYTHE_INLINE friend Mask<Arch> operator>(Pack a, Pack b) { return {a.lanes > b.lanes}; }
  WYTHE_INLINE friend Mask<Arch> operator>=(Pack a, Pack b) { return {a.lanes >= b.lanes}; }
};

template <class Arch>
[[nodiscard]] WYTHE_INLINE Mask<Arch> operator&(Mask<Arch> a, Mask<Arch> b) {
  return {a.lanes & b.lanes};
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Mask<Arch> operator|(Mask<Arch> a, Mask<Arch> b) {
  return {a.lanes | b.lanes};
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> select(Mask<Arch> condition, Pack<Arch> yes, Pack<Arch> no) {
  return Pack<Arch>(xsimd::select(condition.lanes, yes.lanes, no.lanes));
}
// a < b ? a : b in every lane. The order of the operands counts where both are equal or one is NaN.
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> minimum(Pack<Arch> a, Pack<Arch> b) {
  return Pack<Arch>(xsimd::min(a.lanes, b.lanes));
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> maximum(Pack<Arch> a, Pack<Arch> b) {
  return Pack<Arch>(xsimd::max(a.lanes, b.lanes));
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> magnitude(Pack<Arch> a) {
  return Pack<Arch>(xsimd::abs(a.lanes));
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> square_root(Pack<Arch> a) {
  return Pack<Arch>(xsimd::sqrt(a.lanes));
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE Pack<Arch> sign(Pack<Arch> a) {
  const Pack<Arch> zero(0.0), one(1.0);
  return select(a > zero, one, zero) - select(a < zero, one, zero);
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE bool any(Mask<Arch> condition) {
  return xsimd::any(condition.lanes);
}
template <class Arch>
[[nodiscard]] WYTHE_INLINE bool all(Mask<Arch> condition) {
  return xsimd::all(condition.lanes);
}

}  // namespace wythe
