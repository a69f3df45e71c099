// A sparse linear programme and its solution: the only door to the interior point.
//
//   minimise c.x   with   a <= A x <= b,   l <= x <= u,   circles
//
// Called by static_programme.cpp, kinematic_programme.cpp and in_space.cpp. Rows and columns are added one by one;
// after a solution more rows may follow, and solving begins anew. The solution is the middle of the best face
// (docs/decisions/0017).
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "limit/solver/interior_point.h"

namespace wythe::limit {

inline constexpr double kFree = std::numeric_limits<double>::infinity();

struct Entry {
  int column;
  double value;
};

class LinearProgramme {
 public:
  int add_column(double low, double high, double cost);
  int add_row(const std::vector<Entry>& entries, double low, double high);
  // |(r1.x, r2.x)| <= capacity + r0.x
  void add_circle(std::array<std::vector<Entry>, 3> rows, double capacity);
  // Three columns (t, a, b) with |(a, b)| <= t; `cost` is that of t. Returns the place of t.
  int add_circle_columns(double cost);
  [[nodiscard]] int columns() const { return static_cast<int>(low_.size()); }
  [[nodiscard]] int rows() const {
    return static_cast<int>(row_low_.size() + 3 * circle_rows_.size());
  }

  // `monitor` is called several times a second.
  ProgrammeStatus solve(const Monitor& monitor = {}, const Tolerance& tolerance = kExact);
  [[nodiscard]] double objective() const { return objective_; }
  // Of the programme's own dual, and the multipliers of the rows with equal bounds there (rows; others 0).
  [[nodiscard]] double dual_objective() const { return dual_objective_; }
  [[nodiscard]] const std::vector<double>& multipliers() const { return multipliers_; }
  [[nodiscard]] const std::vector<double>& solution() const { return solution_; }  // (columns)
  // What is left of the residuals and of the gap of the programme's own dual.
  [[nodiscard]] double accuracy() const { return accuracy_; }
  // Of the objective, to first order: that gap, and residuals times their multipliers.
  [[nodiscard]] double error() const { return error_; }
  // Sum of the residuals of rows and bounds.
  [[nodiscard]] double residual() const { return residual_; }
  // After kUnbounded: a direction in which the objective falls for ever (columns), may be empty.
  [[nodiscard]] const std::vector<double>& ray() const { return ray_; }

 private:
  struct CircleRows {
    std::array<std::vector<Entry>, 3> row;
    double capacity;
  };
  // Where the inequalities, circles and equations of the dual lie that belong to the columns.
  struct DualPlaces {
    std::vector<int> place;     // (columns), -1: column is nil
    std::vector<char> is_free;  // (columns)
    int free = 0, held = 0;     // how many
  };
  std::vector<double> low_, high_, cost_, row_low_, row_high_;
  std::vector<int> row_of_, column_of_;  // of each entry
  std::vector<double> value_;
  std::vector<CircleRows> circle_rows_;
  std::vector<int> circle_columns_;  // the first of each three
  double objective_ = 0, dual_objective_ = 0, accuracy_ = 0, error_ = 0, residual_ = 0;
  std::vector<double> solution_, multipliers_, ray_;
  [[nodiscard]] bool is_plain() const;
  [[nodiscard]] InequalityForm form() const;
  [[nodiscard]] InequalityForm dual_form() const;
  void add_circles(InequalityForm& form) const;
  [[nodiscard]] DualPlaces dual_places() const;
  void take_dual(const InteriorSolution& answer);
  void take_multipliers(const InteriorSolution& answer);
};

}  // namespace wythe::limit
