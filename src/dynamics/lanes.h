// How a Real takes its lanes from flat arrays.
//
//   Neighbours   lane k is joint (block) i + k of one wall: a single run
//   Walls        lane k is wall k; every wall has its own state, all share geometry: a campaign
//
// Both know   shared(array, i)   geometry, one for all walls
//             own(array, i), keep(value, array, i)          what each wall has for itself
//             of(array, ids, i)  what each wall has at entity ids[i]
//             rows(array, ids, i), keep_rows(rows, array, i)  rows of four (poses, joint forces)
//             points(array, i, n, at), keep_points(...)      the n points of joint i
//             of_wall(array)     one number a wall (time step, damping)
//             energy(array, k), keep_energy(...)   of pack k: entities are summed in kGroup lanes
//             marked(flags, i), mark(flags, i, flag)   one flag for all lanes of a Real
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "dynamics/kernels.h"
#ifndef __CUDACC__  // there a Real is a double
#include "core/pack.h"
#include "dynamics/shuffle.h"
#endif

namespace wythe::dynamics {

template <class Real>
struct Rows {
  Real c0, c1, c2, c3;
};

template <class Real>
struct Lanes;

// Raw loads and stores: width neighbours, columns of width rows of four, point k of width joints.
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

#ifndef __CUDACC__
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
    first = real(shuffle::evens(low, high));
    second = real(shuffle::odds(low, high));
  }
  WYTHE_INLINE static void store_pairs(Real first, Real second, double* to) {
    real(shuffle::zip_low<Vector>(first.lanes, second.lanes)).store(to);
    real(shuffle::zip_high<Vector>(first.lanes, second.lanes)).store(to + width);
  }

  WYTHE_INLINE static Rows<Real> load_rows(const double* rows, const std::int32_t* id) {
    Vector row[4];
    shuffle::load_rows(rows, id, row);
    shuffle::transpose(row);
    return {real(row[0]), real(row[1]), real(row[2]), real(row[3])};
  }
  WYTHE_INLINE static void store_rows(const Rows<Real>& r, double* to) {
    Vector row[4] = {r.c0.lanes, r.c1.lanes, r.c2.lanes, r.c3.lanes};
    shuffle::transpose(row);
    shuffle::store_rows(row, to);
  }

 private:
  WYTHE_INLINE static Vector raw(const double* from) { return Real::load(from).lanes; }
  WYTHE_INLINE static Real real(Vector v) { return Real(typename Real::Batch(v)); }
};
#endif

template <class R>
struct Neighbours {
  using Real = R;
  using L = Lanes<Real>;
  static constexpr std::size_t advance = L::width;  // joints (blocks) a pack takes
  static constexpr int packs = kGroup / L::width;   // packs whose energies are summed apart
  static constexpr bool any_points = true;          // a face may have any number, not only two

  WYTHE_INLINE Real shared(const double* from, std::size_t i) const { return L::load(from + i); }
  WYTHE_INLINE Real own(const double* from, std::size_t i) const { return L::load(from + i); }
  WYTHE_INLINE void keep(Real value, double* to, std::size_t i) const { L::store(value, to + i); }
  WYTHE_INLINE Real of_wall(const double* from) const { return Real(*from); }
  WYTHE_INLINE Real energy(const double* from, int k) const { return L::load(from + k * L::width); }
  WYTHE_INLINE void keep_energy(Real e, double* to, int k) const { L::store(e, to + k * L::width); }
  WYTHE_INLINE bool marked(const std::uint8_t* flags, std::size_t i) const { return flags[i] != 0; }
  WYTHE_INLINE void mark(std::uint8_t* flags, std::size_t i, bool flag) const { flags[i] = flag; }
  WYTHE_INLINE Rows<Real> rows(const double* from, const std::int32_t* id, std::size_t i) const {
    return L::load_rows(from, id + i);
  }
  WYTHE_INLINE void keep_rows(const Rows<Real>& r, double* to, std::size_t i) const {
    L::store_rows(r, to + 4 * i);
  }
  WYTHE_INLINE Real of(const double* from, const std::int32_t* id, std::size_t i) const {
    double lane[L::width];
    for (int k = 0; k < L::width; ++k) lane[k] = from[id[i + static_cast<std::size_t>(k)]];
    return L::load(lane);
  }
  template <int n_point, class Put>
  WYTHE_INLINE void points(const double* from, std::size_t i, std::ptrdiff_t n,
                           const Put& put) const {
    const double* first = from + static_cast<std::ptrdiff_t>(i) * n;
    if constexpr (n_point == 2) {
      L::load_pairs(first, put(0), put(1));
    } else {
      for (int k = 0; k < n; ++k) put(k) = L::load_point(first + k, n);
    }
  }
  template <int n_point, class Get>
  WYTHE_INLINE void keep_points(const Get& get, double* to, std::size_t i, std::ptrdiff_t n) const {
    double* first = to + static_cast<std::ptrdiff_t>(i) * n;
    if constexpr (n_point == 2) {
      L::store_pairs(get(0), get(1), first);
    } else {
      for (int k = 0; k < n; ++k) L::store_point(get(k), first + k, n);
    }
  }
};

// Arrays that each wall has for itself hold `stride` walls side by side: entity i of wall k lies at
// i stride + k. The pointers are those of the first wall this Real takes.
template <class R>
struct Walls {
  using Real = R;
  using L = Lanes<Real>;
  static constexpr std::size_t advance = 1;
  static constexpr int packs = kGroup;
  static constexpr bool any_points = false;  // others are stepped alone (fit_together)
  std::ptrdiff_t stride = 1;

  WYTHE_INLINE Real shared(const double* from, std::size_t i) const { return Real(from[i]); }
  WYTHE_INLINE Real own(const double* from, std::size_t i) const { return L::load(from + at(i)); }
  WYTHE_INLINE void keep(Real value, double* to, std::size_t i) const {
    L::store(value, to + at(i));
  }
  WYTHE_INLINE Real of_wall(const double* from) const { return L::load(from); }
  WYTHE_INLINE Real energy(const double* from, int k) const { return L::load(from + k * stride); }
  WYTHE_INLINE void keep_energy(Real e, double* to, int k) const { L::store(e, to + k * stride); }
  WYTHE_INLINE bool marked(const std::uint8_t* flags, std::size_t i) const {
    return flags[at(i)] != 0;
  }
  WYTHE_INLINE void mark(std::uint8_t* flags, std::size_t i, bool flag) const {
    flags[at(i)] = flag;
  }
  WYTHE_INLINE Rows<Real> row(const double* from, std::int32_t id) const {
    const double* row = from + 4 * at(static_cast<std::size_t>(id));
    return {L::load(row), L::load(row + stride), L::load(row + 2 * stride),
            L::load(row + 3 * stride)};
  }
  WYTHE_INLINE Rows<Real> rows(const double* from, const std::int32_t* id, std::size_t i) const {
    return row(from, id[i]);
  }
  WYTHE_INLINE void keep_rows(const Rows<Real>& r, double* to, std::size_t i) const {
    double* row = to + 4 * at(i);
    L::store(r.c0, row);
    L::store(r.c1, row + stride);
    L::store(r.c2, row + 2 * stride);
    L::store(r.c3, row + 3 * stride);
  }
  WYTHE_INLINE Real of(const double* from, const std::int32_t* id, std::size_t i) const {
    return L::load(from + at(static_cast<std::size_t>(id[i])));
  }
  template <int n_point, class Put>
  WYTHE_INLINE void points(const double* from, std::size_t i, std::ptrdiff_t n,
                           const Put& put) const {
    const double* first = from + at(i) * n;
    for (int k = 0; k < (n_point > 0 ? n_point : n); ++k) put(k) = L::load(first + k * stride);
  }
  template <int n_point, class Get>
  WYTHE_INLINE void keep_points(const Get& get, double* to, std::size_t i, std::ptrdiff_t n) const {
    double* first = to + at(i) * n;
    for (int k = 0; k < (n_point > 0 ? n_point : n); ++k) L::store(get(k), first + k * stride);
  }

 private:
  [[nodiscard]] WYTHE_INLINE std::ptrdiff_t at(std::size_t i) const {
    return static_cast<std::ptrdiff_t>(i) * stride;
  }
};

}  // namespace wythe::dynamics
