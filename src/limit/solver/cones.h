// Cones of an interior point: inequalities s >= 0, and circles s0 >= |(s1, s2)| of three entries each.
//
// A pair s, z inside a circle's cone has one symmetric matrix W with W z = W^-1 s = l, after Nesterov and Todd:
//
//   W = eta [w0  w'; w  I + w w'/(1 + w0)]     W W = eta^2 (2 (w0, w)(w0, w)' - diag(1, -1, -1))
//
// Products are those of the cone: u o v = (u.v, u0 v' + v0 u'). For an inequality W is sqrt(s/z). Called by
// interior_point.cpp. Reference: M. S. Andersen, J. Dahl, Z. Liu, L. Vandenberghe, in Optimization for Machine
// Learning (2011), sections 1.2 and 1.4.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/elementary.h"

namespace wythe::limit {

class Cones {
 public:
  using Vector = Eigen::VectorXd;
  using Three = std::array<double, 3>;

  // `plain` inequalities, then `circles` of three rows.
  Cones(int plain, int circles) : plain_(plain), circle_(static_cast<std::size_t>(circles)) {}

  [[nodiscard]] int plain() const { return plain_; }
  [[nodiscard]] int circles() const { return static_cast<int>(circle_.size()); }
  [[nodiscard]] int first_row(int circle) const { return plain_ + 3 * circle; }
  // Of the barrier: what s.z is shared among.
  [[nodiscard]] int degree() const { return plain_ + circles(); }

  [[nodiscard]] Vector unit() const {
    Vector e = Vector::Ones(rows());
    for (int k = 0; k < circles(); ++k) e.segment(first_row(k) + 1, 2).setZero();
    return e;
  }

  // Of a pair inside its cones.
  void scale(const Vector& s, const Vector& z) {
    spring_ = s.head(plain_).cwiseQuotient(z.head(plain_));
    for (int k = 0; k < circles(); ++k) circle_[k] = circle_of(three(s, k), three(z, k));
  }

  // W W of a plain row, and of a circle's rows i, j.
  [[nodiscard]] double squared(int row) const { return spring_[row]; }
  [[nodiscard]] double squared(int circle, int i, int j) const {
    const Circle& c = circle_[circle];
    const double unit = i != j ? 0 : i == 0 ? -1 : 1;
    return c.eta * c.eta * (2 * c.w[i] * c.w[j] + unit);
  }
  [[nodiscard]] Vector squared_times(const Vector& v) const {
    Vector out(rows());
    out.head(plain_) = spring_.cwiseProduct(v.head(plain_));
    for (int k = 0; k < circles(); ++k)
      for (int i = 0; i < 3; ++i) {
        double sum = 0;
        for (int j = 0; j < 3; ++j) sum += squared(k, i, j) * v[first_row(k) + j];
        out[first_row(k) + i] = sum;
      }
    return out;
  }

  // l o l: what a step has to take away.
  [[nodiscard]] Vector product(const Vector& s, const Vector& z) const {
    Vector out(rows());
    out.head(plain_) = s.head(plain_).cwiseProduct(z.head(plain_));
    for (int k = 0; k < circles(); ++k) put(out, k, product(circle_[k].lambda, circle_[k].lambda));
    return out;
  }
  // (W^-1 ds) o (W dz): what the first step leaves.
  [[nodiscard]] Vector product_of_changes(const Vector& ds, const Vector& dz) const {
    Vector out(rows());
    out.head(plain_) = ds.head(plain_).cwiseProduct(dz.head(plain_));
    for (int k = 0; k < circles(); ++k) {
      const Circle& c = circle_[k];
      put(out, k, product(times(c, three(ds, k), true), times(c, three(dz, k), false)));
    }
    return out;
  }
  // W (l \ v), where l o (l \ v) = v.
  [[nodiscard]] Vector lead(const Vector& v, const Vector& z) const {
    Vector out(rows());
    out.head(plain_) = v.head(plain_).cwiseQuotient(z.head(plain_));
    for (int k = 0; k < circles(); ++k) {
      const Circle& c = circle_[k];
      put(out, k, times(c, quotient(c.lambda, three(v, k)), false));
    }
    return out;
  }
  // The change of s that goes with one of z: W (l \ v) - W W dz.
  [[nodiscard]] Vector change(const Vector& v, const Vector& s, const Vector& z,
                              const Vector& dz) const {
    Vector out = lead(v, z) - squared_times(dz);
    out.head(plain_) = (v.head(plain_) - s.head(plain_).cwiseProduct(dz.head(plain_)))
                           .cwiseQuotient(z.head(plain_));
    return out;
  }

  // Of a step from v along d inside the cones; `most` at most.
  [[nodiscard]] double longest(const Vector& v, const Vector& d, double most) const {
    for (int i = 0; i < plain_; ++i)
      if (d[i] < 0) most = std::min(most, -v[i] / d[i]);
    for (int k = 0; k < circles(); ++k)
      most = std::min(most, to_boundary(three(v, k), three(d, k)));
    return most;
  }
  // Of the circles; the inequalities keep their sign by `longest`.
  [[nodiscard]] bool is_inside(const Vector& v) const {
    for (int k = 0; k < circles(); ++k)
      if (const Three t = three(v, k); !(t[0] > 0 && determinant(t) > 0)) return false;
    return true;
  }

 private:
  struct Circle {
    double eta = 1;
    Three w{1, 0, 0}, lambda{1, 0, 0};
  };

  [[nodiscard]] int rows() const { return plain_ + 3 * circles(); }
  [[nodiscard]] Three three(const Vector& v, int circle) const {
    const int row = first_row(circle);
    return {v[row], v[row + 1], v[row + 2]};
  }
  void put(Vector& v, int circle, const Three& t) const {
    for (int i = 0; i < 3; ++i) v[first_row(circle) + i] = t[i];
  }

  // v0^2 - v1^2 - v2^2 without the cancellation near the boundary.
  [[nodiscard]] static double determinant(const Three& v) {
    const double r = elementary::hypot(v[1], v[2]);
    return (v[0] - r) * (v[0] + r);
  }
  [[nodiscard]] static Three product(const Three& u, const Three& v) {
    return {u[0] * v[0] + u[1] * v[1] + u[2] * v[2], u[0] * v[1] + v[0] * u[1],
            u[0] * v[2] + v[0] * u[2]};
  }
  [[nodiscard]] static Three quotient(const Three& l, const Three& v) {
    const double first = (l[0] * v[0] - l[1] * v[1] - l[2] * v[2]) / determinant(l);
    return {first, (v[1] - first * l[1]) / l[0], (v[2] - first * l[2]) / l[0]};
  }
  // W v, or W^-1 v.
  [[nodiscard]] static Three times(const Circle& c, const Three& v, bool inverse) {
    const double sign = inverse ? -1 : 1, eta = inverse ? 1 / c.eta : c.eta;
    const double along = c.w[1] * v[1] + c.w[2] * v[2];
    const double share = sign * v[0] + along / (1 + c.w[0]);
    return {eta * (c.w[0] * v[0] + sign * along), eta * (v[1] + share * c.w[1]),
            eta * (v[2] + share * c.w[2])};
  }
  [[nodiscard]] static Circle circle_of(const Three& s, const Three& z) {
    const double ds = std::sqrt(determinant(s)), dz = std::sqrt(determinant(z));
    const double dot = (s[0] * z[0] + s[1] * z[1] + s[2] * z[2]) / (ds * dz);
    const double gamma = std::sqrt(0.5 * (1 + dot));
    Circle c;
    c.eta = std::sqrt(ds / dz);
    for (int i = 1; i < 3; ++i) c.w[i] = (s[i] / ds - z[i] / dz) / (2 * gamma);
    c.w[0] = std::sqrt(1 + c.w[1] * c.w[1] + c.w[2] * c.w[2]);
    c.lambda = times(c, z, false);
    return c;
  }
  [[nodiscard]] static double to_boundary(const Three& v, const Three& d) {
    const double a = d[0] * d[0] - d[1] * d[1] - d[2] * d[2];
    const double b = v[0] * d[0] - v[1] * d[1] - v[2] * d[2], c = determinant(v);
    const double root = b * b - a * c;
    if (root < 0) return std::numeric_limits<double>::infinity();
    const double down = std::sqrt(root) - b;
    return down > 0 ? c / down : std::numeric_limits<double>::infinity();
  }

  int plain_;
  std::vector<Circle> circle_;
  Vector spring_;  // s/z of the plain rows
};

}  // namespace wythe::limit
