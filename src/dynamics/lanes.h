// How a Real takes neighbours from flat arrays: one double, or a pack of them.
//
//   load, store              width neighbours
//   load_rows, store_rows    columns of width rows of four (poses, joint forces)
//   load_points, store_point point k of width joints, n points a joint
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/pack.h"

namespace wythe::dynamics {

template <class Real>
struct Rows {
  Real c0, c1, c2, c3;
};

template <class Real>
struct Lanes;

template <>
struct Lanes<double> {
  static constexpr int width = 1;
  WYTHE_INLINE static double load(const double* from) { return *from; }
  WYTHE_INLINE static void store(double value, double* to) { *to = value; }
  WYTHE_INLINE static Rows<double> load_rows(const double* rows, const std::int32_t* id) {
    const double* row = rows + 4 * static_cast<std::ptrdiff_t>(*id);
    return {row[0], row[1], row[2], row[3]};
  }
  WYTHE_INLINE static void store_rows(const Rows<double>& r, double* to) {
    to[0] = r.c0;
    to[1] = r.c1;
    to[2] = r.c2;
    to[3] = r.c3;
  }
  WYTHE_INLINE static double load_point(const double* from, std::ptrdiff_t) { return *from; }
  WYTHE_INLINE static void store_point(double value, double* to, std::ptrdiff_t) { *to = value; }
  WYTHE_INLINE static void load_pairs(const double* from, double& first, double& second) {
    first = from[0];
    second = from[1];
  }
  WYTHE_INLINE static void store_pairs(double first, double second, double* to) {
    to[0] = first;
    to[1] = second;
  }
};

template <class Arch>
struct Lanes<Pack<Arch>> {
  using Real = Pack<Arch>;
  using Vector = typename Real::Vector;
  static constexpr int width = Real::width;

  WYTHE_INLINE static Real load(const double* from) { return Real::load(from); }
  WYTHE_INLINE static void store(Real value, double* to) { value.store(to); }

  WYTHE_INLINE static Real load_point(const double* from, std::ptrdiff_t stride) {
    double lane[width];
    for (int k = 0; k < width; ++k) lane[k] = from[k * stride];
    return Real::load(lane);
  }
  WYTHE_INLINE static void store_point(Real value, double* to, std::ptrdiff_t stride) {
    double lane[width];
    value.store(lane);
    for (int k = 0; k < width; ++k) to[k * stride] = lane[k];
  }

  // Pairs (first, second) of width joints, taken apart and put together.
  WYTHE_INLINE static void load_pairs(const double* from, Real& first, Real& second) {
    const Vector low = raw(from), high = raw(from + width);
    if constexpr (width == 2) {
      first = real(__builtin_shufflevector(low, high, 0, 2));
      second = real(__builtin_shufflevector(low, high, 1, 3));
    } else {
      first = real(__builtin_shufflevector(low, high, 0, 2, 4, 6));
      second = real(__builtin_shufflevector(low, high, 1, 3, 5, 7));
    }
  }
  WYTHE_INLINE static void store_pairs(Real first, Real second, double* to) {
    const Vector a = first.lanes, b = second.lanes;
    if constexpr (width == 2) {
      real(__builtin_shufflevector(a, b, 0, 2)).store(to);
      real(__builtin_shufflevector(a, b, 1, 3)).store(to + width);
    } else {
      real(__builtin_shufflevector(a, b, 0, 4, 1, 5)).store(to);
      real(__builtin_shufflevector(a, b, 2, 6, 3, 7)).store(to + width);
    }
  }

  WYTHE_INLINE static Rows<Real> load_rows(const double* rows, const std::int32_t* id) {
    const auto row = [&](int k) { return rows + 4 * static_cast<std::ptrdiff_t>(id[k]); };
    if constexpr (width == 2) {
      const double *r0 = row(0), *r1 = row(1);
      const Vector a = raw(r0), b = raw(r0 + 2), c = raw(r1), d = raw(r1 + 2);
      return {real(__builtin_shufflevector(a, c, 0, 2)), real(__builtin_shufflevector(a, c, 1, 3)),
              real(__builtin_shufflevector(b, d, 0, 2)), real(__builtin_shufflevector(b, d, 1, 3))};
    } else {
      return transpose(raw(row(0)), raw(row(1)), raw(row(2)), raw(row(3)));
    }
  }
  WYTHE_INLINE static void store_rows(const Rows<Real>& r, double* to) {
    if constexpr (width == 2) {
      const Vector a = r.c0.lanes, b = r.c1.lanes, c = r.c2.lanes, d = r.c3.lanes;
      real(__builtin_shufflevector(a, b, 0, 2)).store(to);
      real(__builtin_shufflevector(c, d, 0, 2)).store(to + 2);
      real(__builtin_shufflevector(a, b, 1, 3)).store(to + 4);
      real(__builtin_shufflevector(c, d, 1, 3)).store(to + 6);
    } else {
      const Rows<Real> t = transpose(r.c0.lanes, r.c1.lanes, r.c2.lanes, r.c3.lanes);
      t.c0.store(to);
      t.c1.store(to + 4);
      t.c2.store(to + 8);
      t.c3.store(to + 12);
    }
  }

 private:
  WYTHE_INLINE static Vector raw(const double* from) { return Real::load(from).lanes; }
  WYTHE_INLINE static Real real(Vector v) { return Real(typename Real::Batch(v)); }
  WYTHE_INLINE static Rows<Real> transpose(Vector a, Vector b, Vector c, Vector d) {
    const Vector ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Vector ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Vector cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Vector cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {real(__builtin_shufflevector(ab0, cd0, 0, 1, 4, 5)),
            real(__builtin_shufflevector(ab1, cd1, 0, 1, 4, 5)),
            real(__builtin_shufflevector(ab0, cd0, 2, 3, 6, 7)),
            real(__builtin_shufflevector(ab1, cd1, 2, 3, 6, 7))};
  }
};

}  // namespace wythe::dynamics
