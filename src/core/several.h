// Several numbers that take the same operations together: the points of a face. Each operation is done for all parts in
// turn, so that the processor works on the others while one result is pending; any() tests all parts
// with one branch. Each part has the bits it would have alone.
#pragma once

#include <type_traits>

#include "core/real.h"

namespace wythe {

template <class Mask, int n>
struct SeveralMask {
  Mask first;
  [[no_unique_address]] SeveralMask<Mask, n - 1> rest;

  WYTHE_INLINE friend SeveralMask operator&(SeveralMask a, SeveralMask b) {
    return {static_cast<Mask>(a.first & b.first), a.rest & b.rest};
  }
  WYTHE_INLINE friend SeveralMask operator|(SeveralMask a, SeveralMask b) {
    return {static_cast<Mask>(a.first | b.first), a.rest | b.rest};
  }
  // Combines the masks of all parts into one: any_part() by or, all_parts() by and.
  [[nodiscard]] WYTHE_INLINE Mask any_part() const {
    if constexpr (n == 1)
      return first;
    else
      return static_cast<Mask>(first | rest.any_part());
  }
  [[nodiscard]] WYTHE_INLINE Mask all_parts() const {
    if constexpr (n == 1)
      return first;
    else
      return static_cast<Mask>(first & rest.all_parts());
  }
  WYTHE_INLINE friend bool any(SeveralMask m) { return any(m.any_part()); }
  WYTHE_INLINE friend bool all(SeveralMask m) { return all(m.all_parts()); }
};
template <class Mask>
struct SeveralMask<Mask, 0> {
  WYTHE_INLINE friend SeveralMask operator&(SeveralMask, SeveralMask) { return {}; }
  WYTHE_INLINE friend SeveralMask operator|(SeveralMask, SeveralMask) { return {}; }
};

template <class Real, int n>
struct Several {
  using Mask = SeveralMask<bool_of_t<Real>, n>;

  Real first;
  [[no_unique_address]] Several<Real, n - 1> rest;

  Several() = default;
  // All parts equal, so that constants of the law mix freely with them.
  WYTHE_INLINE Several(Real same) : first(same), rest(same) {}  // NOLINT: implicit on purpose
  WYTHE_INLINE explicit Several(double same) requires(!std::is_same_v<Real, double>)
      : Several(Real(same)) {}
  WYTHE_INLINE Several(Real head, Several<Real, n - 1> tail) : first(head), rest(tail) {}

  template <int k>
  [[nodiscard]] WYTHE_INLINE Real& part() {
    if constexpr (k == 0)
      return first;
    else
      return rest.template part<k - 1>();
  }
  template <int k>
  [[nodiscard]] WYTHE_INLINE const Real& part() const {
    if constexpr (k == 0)
      return first;
    else
      return rest.template part<k - 1>();
  }

  WYTHE_INLINE friend Several operator+(Several a, Several b) {
    return {a.first + b.first, a.rest + b.rest};
  }
  WYTHE_INLINE friend Several operator-(Several a, Several b) {
    return {a.first - b.first, a.rest - b.rest};
  }
  WYTHE_INLINE friend Several operator*(Several a, Several b) {
    return {a.first * b.first, a.rest * b.rest};
  }
  WYTHE_INLINE friend Several operator/(Several a, Several b) {
    return {a.first / b.first, a.rest / b.rest};
  }
  WYTHE_INLINE friend Mask operator<(Several a, Several b) {
    return {a.first < b.first, a.rest < b.rest};
  }
  WYTHE_INLINE friend Mask operator<=(Several a, Several b) {
    return {a.first <= b.first, a.rest <= b.rest};
  }
  WYTHE_INLINE friend Mask operator>(Several a, Several b) {
    return {a.first > b.first, a.rest > b.rest};
  }
  WYTHE_INLINE friend Mask operator>=(Several a, Several b) {
    return {a.first >= b.first, a.rest >= b.rest};
  }
  WYTHE_INLINE friend Several select(Mask m, Several yes, Several no) {
    return {select(m.first, yes.first, no.first), select(m.rest, yes.rest, no.rest)};
  }
  WYTHE_INLINE friend Several minimum(Several a, Several b) {
    return {minimum(a.first, b.first), minimum(a.rest, b.rest)};
  }
  WYTHE_INLINE friend Several maximum(Several a, Several b) {
    return {maximum(a.first, b.first), maximum(a.rest, b.rest)};
  }
  WYTHE_INLINE friend Several square_root(Several a) {
    return {square_root(a.first), square_root(a.rest)};
  }
  WYTHE_INLINE friend Several magnitude(Several a) {
    return {magnitude(a.first), magnitude(a.rest)};
  }
  WYTHE_INLINE friend Several sign(Several a) { return {sign(a.first), sign(a.rest)}; }
};

template <class Real>
struct Several<Real, 0> {
  using Mask = SeveralMask<bool_of_t<Real>, 0>;
  Several() = default;
  WYTHE_INLINE Several(Real) {}  // NOLINT: as above
  WYTHE_INLINE friend Several operator+(Several, Several) { return {}; }
  WYTHE_INLINE friend Several operator-(Several, Several) { return {}; }
  WYTHE_INLINE friend Several operator*(Several, Several) { return {}; }
  WYTHE_INLINE friend Several operator/(Several, Several) { return {}; }
  WYTHE_INLINE friend Mask operator<(Several, Several) { return {}; }
  WYTHE_INLINE friend Mask operator<=(Several, Several) { return {}; }
  WYTHE_INLINE friend Mask operator>(Several, Several) { return {}; }
  WYTHE_INLINE friend Mask operator>=(Several, Several) { return {}; }
  WYTHE_INLINE friend Several select(Mask, Several, Several) { return {}; }
  WYTHE_INLINE friend Several minimum(Several, Several) { return {}; }
  WYTHE_INLINE friend Several maximum(Several, Several) { return {}; }
  WYTHE_INLINE friend Several square_root(Several) { return {}; }
  WYTHE_INLINE friend Several magnitude(Several) { return {}; }
  WYTHE_INLINE friend Several sign(Several) { return {}; }
};

// Calls act(k) for k = 0 .. n - 1, each k a compile-time constant.
template <int n, int k = 0, class Act>
WYTHE_INLINE void for_each_part(const Act& act) {
  if constexpr (k < n) {
    act(std::integral_constant<int, k>{});
    for_each_part<n, k + 1>(act);
  }
}

}  // namespace wythe
