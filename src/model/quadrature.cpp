// Finds the points of a rule by bisection, as roots of Legendre polynomials, with the same bits on every machine.
// One half of a face mirrors the other bit for bit. docs/theory/kinematics.md, "Points".
#include "model/quadrature.h"

#include <fmt/core.h>

#include <cmath>

namespace wythe {
namespace {

constexpr int kMostPoints = 16;

// Legendre polynomials of degree n and n - 1 at x.
struct Legendre {
  double now, before;
};
Legendre legendre(int n, double x) {
  Legendre p{1, 0};
  for (int k = 1; k <= n; ++k) p = {((2 * k - 1) * x * p.now - (k - 1) * p.before) / k, p.now};
  return p;
}

// A root of `value` between two places of opposite sign, to the last bit of bisection. It needs no
// starting value and no library function, so it is the same number on every machine.
template <class Value>
double root_between(double low, double high, const Value& value) {
  const bool rising = value(high) > 0;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    ((value(middle) > 0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Roots of `value` in (0, 1); their distances must exceed the step of the search.
template <class Value>
std::vector<double> positive_roots(const Value& value) {
  constexpr int kSteps = 512;
  std::vector<double> roots;
  for (int k = 0; k < kSteps; ++k) {
    const double low = (k + 0.5) / (kSteps + 1), high = (k + 1.5) / (kSteps + 1);
    if ((value(low) > 0) != (value(high) > 0)) roots.push_back(root_between(low, high, value));
  }
  return roots;
}

// Mirrors one half of a face to the other bit for bit, so that a wall and its mirror image behave equally.
template <class Weight>
FaceQuadrature symmetric(int n, const std::vector<double>& positive, const Weight& weight) {
  FaceQuadrature rule;
  const auto add = [&](double xi) {
    rule.xi.push_back(xi);
    rule.weight.push_back(weight(std::fabs(xi)));
  };
  for (auto x = positive.rbegin(); x != positive.rend(); ++x) add(-*x);
  if (n % 2 == 1) add(0);
  for (const double x : positive) add(x);
  return rule;
}

FaceQuadrature trapezoid(int n) {
  FaceQuadrature rule;
  for (int k = 0; k < n; ++k) {
    const int from_end = k < n - 1 - k ? k : n - 1 - k;
    const double beyond = 1.0 - 2.0 * from_end / (n - 1);
    rule.xi.push_back(from_end == k ? -beyond : beyond);
    rule.weight.push_back((k == 0 || k == n - 1 ? 0.5 : 1.0) / (n - 1));
  }
  return rule;
}

// Ends and the roots of P'_(n-1);  weight 1/(n (n-1) P_(n-1)^2)  (Abramowitz & Stegun 25.4.32, halved).
FaceQuadrature lobatto(int n) {
  const auto slope = [&](double x) {  // (x^2 - 1)/(n - 1) P'_(n-1)
    const Legendre p = legendre(n - 1, x);
    return x * p.now - p.before;
  };
  std::vector<double> positive = positive_roots(slope);
  positive.push_back(1);
  return symmetric(n, positive, [&](double x) {
    const double p = legendre(n - 1, x).now;
    return 1.0 / (n * (n - 1) * p * p);
  });
}

// Roots of P_n;  weight (1 - x^2)/(n P_(n-1))^2  (Abramowitz & Stegun 25.4.29, halved).
FaceQuadrature gauss(int n) {
  const std::vector<double> positive = positive_roots([&](double x) { return legendre(n, x).now; });
  return symmetric(n, positive, [&](double x) {
    const double p = n * legendre(n, x).before;
    return (1 - x * x) / (p * p);
  });
}

}  // namespace

QuadratureChoice quadrature_choice(const SolveSpec& solve) {
  const int n = solve.points_per_face;
  switch (solve.point_rule) {
    case PointRule::kDefault:
      if (n == 0) return {PointRule::kLobatto, 3};
      return {n == 2 ? PointRule::kCorners : PointRule::kTrapezoid, n};
    case PointRule::kCorners: return {PointRule::kCorners, n == 0 ? 2 : n};
    case PointRule::kTrapezoid:
    case PointRule::kLobatto:
    case PointRule::kGauss: break;
  }
  return {solve.point_rule, n == 0 ? 3 : n};
}

void check_points(const SolveSpec& solve, FaultList& faults) {
  const auto [rule, points] = quadrature_choice(solve);
  if (points < 2 || points > kMostPoints)
    faults.add({"", "solve.points_per_face", std::to_string(points),
                fmt::format("must be between 2 and {}", kMostPoints), "write points_per_face = 3",
                0});
  else if (rule == PointRule::kCorners && points != 2)
    faults.add({"", "solve.points_per_face", std::to_string(points),
                "does not go with point_rule = \"corners\": a face has two ends",
                "write points_per_face = 2 or point_rule = \"lobatto\"", 0});
}

FaceQuadrature face_points(PointRule rule, int points) {
  switch (rule) {
    case PointRule::kLobatto: return lobatto(points);
    case PointRule::kGauss: return gauss(points);
    case PointRule::kDefault:
    case PointRule::kCorners:
    case PointRule::kTrapezoid: break;
  }
  return trapezoid(points);
}

}  // namespace wythe
