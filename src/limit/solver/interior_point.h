// Interior-point method for sparse linear programmes of many thousand rows, with circles.
//
//   minimise c.x   with   A x = b,   G x + s = h,   s in K       x has no bounds of its own
//   its dual:  maximise -b.y - h.z   with   A'y + G'z + c = 0,   z in K
//
// K: s >= 0, and for the last three rows of each circle s0 >= |(s1, s2)| (cones.h).
//
// Homogeneous and self-dual: it ends with both answers, or with a proof that there is none. Called by
// linear_program.cpp alone. Reference: E. D. Andersen and K. D. Andersen, in High Performance
// Optimization (2000) 197-232; how it compares with a simplex: docs/decisions/0017.
#pragma once

#include <functional>
#include <vector>

namespace wythe::limit {

enum class ProgrammeStatus { kOptimal, kInfeasible, kUnbounded, kStopped, kFailed };

// Asked now and then with the share of the work done [0, 1]; true: stop.
using Monitor = std::function<bool(double share)>;

// Entries of a sparse matrix, in any order.
struct Triplets {
  std::vector<int> row, column;
  std::vector<double> value;
  void add(int r, int c, double v) {
    row.push_back(r);
    column.push_back(c);
    value.push_back(v);
  }
};

struct InequalityForm {
  std::vector<double> c, b, h;
  Triplets equal, below;  // A, G
  int circles = 0;        // of three rows each, the last ones of G
};

// How far a search goes [-].
struct Tolerance {
  double wanted = 1e-9;   // of residuals, and of the gap between both objectives
  double best = 1e-14;    // beyond what is wanted, as long as iterations halve it
  double enough = 1e-7;   // where round-off allows no more
  double linear = 1e-11;  // of the residual of a linear system, to its right side
};
inline constexpr Tolerance kExact{};
inline constexpr Tolerance kQuick{.wanted = 1e-8, .best = 1e-8, .enough = 1e-7, .linear = 1e-9};

struct InteriorSolution {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  std::vector<double> x;     // after kUnbounded a direction in which c.x falls for ever
  std::vector<double> y, z;  // of the dual
  double objective = 0, dual_objective = 0;
  double accuracy = 0;  // what is left of the residuals and of the gap between both objectives
  double error = 0;  // of the objective, to first order: that gap, and residuals times multipliers
  // Sums of the residuals of A x = b and G x + s = h, and of the dual.
  double residual = 0, dual_residual = 0;
  int iterations = 0;
};

[[nodiscard]] InteriorSolution interior_point(const InequalityForm& form,
                                              const Monitor& monitor = {},
                                              const Tolerance& tolerance = kExact);

}  // namespace wythe::limit
