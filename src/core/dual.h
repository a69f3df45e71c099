// Forward-mode derivative: a value and its partials with respect to N variables.
// Used to check the tangent of the joint law against finite differences.
#pragma once

#include <array>

#include "core/real.h"

namespace wythe {

template <int N>
struct Dual {
  double value = 0;
  std::array<double, N> partial{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants mix freely with duals
  Dual(double v, int variable) : value(v) { partial[variable] = 1.0; }
};

namespace detail {
template <int N>
Dual<N> chain(double value, const Dual<N>& a, double da, const Dual<N>& b, double db) {
  Dual<N> r(value);
  for (std::size_t i = 0; i < N; ++i) r.partial[i] = da * a.partial[i] + db * b.partial[i];
  return r;
}
}  // namespace detail

template <int N>
Dual<N> operator+(const Dual<N>& a, const Dual<N>& b) {
  return detail::chain(a.value + b.value, a, 1.0, b, 1.0);
}
template <int N>
Dual<N> operator-(const Dual<N>& a, const Dual<N>& b) {
  return detail::chain(a.value - b.value, a, 1.0, b, -1.0);
}
template <int N>
Dual<N> operator-(const Dual<N>& a) {
  return Dual<N>(0.0) - a;
}
template <int N>
Dual<N> operator*(const Dual<N>& a, const Dual<N>& b) {
  return detail::chain(a.value * b.value, a, b.value, b, a.value);
}
template <int N>
Dual<N> operator/(const Dual<N>& a, const Dual<N>& b) {
  const double q = a.value / b.value;
  return detail::chain(q, a, 1.0 / b.value, b, -q / b.value);
}
template <int N>
bool operator<(const Dual<N>& a, const Dual<N>& b) {
  return a.value < b.value;
}
template <int N>
bool operator>(const Dual<N>& a, const Dual<N>& b) {
  return a.value > b.value;
}
template <int N>
bool operator<=(const Dual<N>& a, const Dual<N>& b) {
  return a.value <= b.value;
}
template <int N>
bool operator>=(const Dual<N>& a, const Dual<N>& b) {
  return a.value >= b.value;
}

template <int N>
Dual<N> select(bool condition, const Dual<N>& yes, const Dual<N>& no) {
  return condition ? yes : no;
}
template <int N>
Dual<N> minimum(const Dual<N>& a, const Dual<N>& b) {
  return a.value < b.value ? a : b;
}
template <int N>
Dual<N> maximum(const Dual<N>& a, const Dual<N>& b) {
  return a.value > b.value ? a : b;
}
template <int N>
Dual<N> square_root(const Dual<N>& a) {
  Dual<N> r(std::sqrt(a.value));
  for (std::size_t i = 0; i < N; ++i) r.partial[i] = 0.5 / r.value * a.partial[i];
  return r;
}
template <int N>
Dual<N> magnitude(const Dual<N>& a) {
  return a.value < 0 ? -a : a;
}
template <int N>
Dual<N> sign(const Dual<N>& a) {
  return Dual<N>(sign(a.value));
}
template <int N>
double value_of(const Dual<N>& a) {
  return a.value;
}

}  // namespace wythe
