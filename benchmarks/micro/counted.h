// A double that counts what is done with it: how many operations a step of the templates takes.
#pragma once

#include <cmath>
#include <cstdint>

#include "dynamics/passes/access.h"

namespace wythe::bench {

struct Counts {
  std::int64_t arithmetic = 0;  // + - * /
  std::int64_t other = 0;       // comparisons, minima, maxima, choices, magnitudes
};
inline thread_local Counts counts;

struct Counted {
  double value = 0;
  Counted() = default;
  explicit Counted(double v) : value(v) {}
};

inline Counted arithmetic(double v) { return ++counts.arithmetic, Counted(v); }
inline Counted other(double v) { return ++counts.other, Counted(v); }
inline bool compared(bool b) { return ++counts.other, b; }

inline Counted operator+(Counted a, Counted b) { return arithmetic(a.value + b.value); }
inline Counted operator-(Counted a, Counted b) { return arithmetic(a.value - b.value); }
inline Counted operator*(Counted a, Counted b) { return arithmetic(a.value * b.value); }
inline Counted operator/(Counted a, Counted b) { return arithmetic(a.value / b.value); }
inline bool operator<(Counted a, Counted b) { return compared(a.value < b.value); }
inline bool operator<=(Counted a, Counted b) { return compared(a.value <= b.value); }
inline bool operator>(Counted a, Counted b) { return compared(a.value > b.value); }
inline bool operator>=(Counted a, Counted b) { return compared(a.value >= b.value); }
inline Counted select(bool condition, Counted yes, Counted no) {
  return other(condition ? yes.value : no.value);
}
inline Counted minimum(Counted a, Counted b) {
  return other(a.value < b.value ? a.value : b.value);
}
inline Counted maximum(Counted a, Counted b) {
  return other(a.value > b.value ? a.value : b.value);
}
inline Counted square_root(Counted a) { return arithmetic(std::sqrt(a.value)); }
inline Counted magnitude(Counted a) { return other(std::fabs(a.value)); }
inline Counted sign(Counted a) {
  const Counted zero(0.0), one(1.0);
  return select(a > zero, one, zero) - select(a < zero, one, zero);
}

}  // namespace wythe::bench

namespace wythe::dynamics {

template <>
struct Lanes<bench::Counted> {
  using Real = bench::Counted;
  static constexpr int width = 1;
  static Real load(const double* from) { return Real(*from); }
  static void store(Real value, double* to) { *to = value.value; }
  static Rows<Real> load_rows(const double* rows, const std::int32_t* id) {
    const double* row = rows + 4 * static_cast<std::ptrdiff_t>(*id);
    return {Real(row[0]), Real(row[1]), Real(row[2]), Real(row[3])};
  }
  static void store_rows(const Rows<Real>& r, double* to) {
    to[0] = r.c0.value;
    to[1] = r.c1.value;
    to[2] = r.c2.value;
    to[3] = r.c3.value;
  }
};

}  // namespace wythe::dynamics
