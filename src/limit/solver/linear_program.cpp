// Brings rows, bounds and circles into the interior point's form: equal bounds give equations, others inequalities.
// A programme of equations alone, such as the kinematic one, goes in as its dual, which the interior point handles
// better. Its unknowns are then the multipliers of that dual, and "infeasible" and "unbounded" change places.
#include "limit/solver/linear_program.h"

#include <cmath>

namespace wythe::limit {
int LinearProgramme::add_column(double low, double high, double cost) {
  low_.push_back(low);
  high_.push_back(high);
  cost_.push_back(cost);
  return columns() - 1;
}

int LinearProgramme::add_row(const std::vector<Entry>& entries, double low, double high) {
  for (const Entry& e : entries) {
    if (e.value == 0) continue;
    row_of_.push_back(static_cast<int>(row_low_.size()));
    column_of_.push_back(e.column);
    value_.push_back(e.value);
  }
  row_low_.push_back(low);
  row_high_.push_back(high);
  return static_cast<int>(row_low_.size()) - 1;
}

void LinearProgramme::add_circle(std::array<std::vector<Entry>, 3> rows, double capacity) {
  circle_rows_.push_back({std::move(rows), capacity});
}

int LinearProgramme::add_circle_columns(double cost) {
  circle_columns_.push_back(add_column(-kFree, kFree, cost));
  add_column(-kFree, kFree, 0);
  add_column(-kFree, kFree, 0);
  return circle_columns_.back();
}

// Equations between unknowns that are free, not negative, in circles, or nil: the kinematic programme.
bool LinearProgramme::is_plain() const {
  if (!circle_rows_.empty()) return false;
  for (std::size_t r = 0; r < row_low_.size(); ++r)
    if (row_low_[r] != row_high_[r]) return false;
  for (std::size_t j = 0; j < low_.size(); ++j) {
    const bool nil = low_[j] == 0 && high_[j] == 0;
    if (!nil && (high_[j] != kFree || (low_[j] != 0 && low_[j] != -kFree))) return false;
  }
  return true;
}

// Rows with equal bounds and columns with equal bounds are equations; every other bound is an inequality.
InequalityForm LinearProgramme::form() const {
  InequalityForm f;
  f.c = cost_;
  std::vector<int> equation(row_low_.size(), -1), above(equation), below(equation);
  const auto number = [](std::vector<double>& right, double value) {
    right.push_back(value);
    return static_cast<int>(right.size()) - 1;
  };
  for (std::size_t r = 0; r < row_low_.size(); ++r) {
    if (row_low_[r] == row_high_[r]) {
      equation[r] = number(f.b, row_low_[r]);
      continue;
    }
    if (std::isfinite(row_high_[r])) below[r] = number(f.h, row_high_[r]);
    if (std::isfinite(row_low_[r])) above[r] = number(f.h, -row_low_[r]);
  }
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const std::size_t r = row_of_[i];
    if (equation[r] >= 0) f.equal.add(equation[r], column_of_[i], value_[i]);
    if (below[r] >= 0) f.below.add(below[r], column_of_[i], value_[i]);
    if (above[r] >= 0) f.below.add(above[r], column_of_[i], -value_[i]);
  }
  for (int j = 0; j < columns(); ++j) {
    const double low = low_[j], high = high_[j];
    if (low == high) {
      f.equal.add(number(f.b, low), j, 1);
      continue;
    }
    if (std::isfinite(high)) f.below.add(number(f.h, high), j, 1);
    if (std::isfinite(low)) f.below.add(number(f.h, -low), j, -1);
  }
  add_circles(f);
  return f;
}

// Behind all inequalities: h - G x = (capacity + r0.x, r1.x, r2.x), and columns as they are.
void LinearProgramme::add_circles(InequalityForm& f) const {
  for (const CircleRows& circle : circle_rows_)
    for (std::size_t i = 0; i < 3; ++i) {
      const int row = static_cast<int>(f.h.size());
      f.h.push_back(i == 0 ? circle.capacity : 0);
      for (const Entry& e : circle.row[i]) f.below.add(row, e.column, -e.value);
    }
  for (const int first : circle_columns_)
    for (int i = 0; i < 3; ++i) {
      f.below.add(static_cast<int>(f.h.size()), first + i, -1);
      f.h.push_back(0);
    }
  f.circles = static_cast<int>(circle_rows_.size() + circle_columns_.size());
}

LinearProgramme::DualPlaces LinearProgramme::dual_places() const {
  DualPlaces d;
  d.place.assign(low_.size(), -1);
  d.is_free.assign(low_.size(), 0);
  std::vector<char> in_circle(low_.size(), 0);
  for (const int first : circle_columns_)
    for (int i = 0; i < 3; ++i) in_circle[first + i] = 1;
  for (std::size_t j = 0; j < low_.size(); ++j) {
    if (high_[j] == 0 || in_circle[j]) continue;
    d.is_free[j] = low_[j] != 0;
    d.place[j] = d.is_free[j] ? d.free++ : d.held++;
  }
  for (const int first : circle_columns_)
    for (int i = 0; i < 3; ++i) d.place[first + i] = d.held++;
  return d;
}

// The dual of a plain programme has no unknown without an inequality, which the interior point likes:
//   min c.x, A x = b, x in K or free   ->   min -b.u, c - A'u in K or nil
InequalityForm LinearProgramme::dual_form() const {
  InequalityForm f;
  for (const double right : row_low_) f.c.push_back(-right);
  const DualPlaces d = dual_places();
  f.b.resize(d.free);
  f.h.resize(d.held);
  f.circles = static_cast<int>(circle_columns_.size());
  for (std::size_t j = 0; j < low_.size(); ++j)
    if (d.place[j] >= 0) (d.is_free[j] ? f.b : f.h)[d.place[j]] = cost_[j];
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const std::size_t j = column_of_[i];
    if (d.place[j] >= 0) (d.is_free[j] ? f.equal : f.below).add(d.place[j], row_of_[i], value_[i]);
  }
  return f;
}

void LinearProgramme::take_dual(const InteriorSolution& answer) {
  const DualPlaces d = dual_places();
  solution_.assign(low_.size(), 0);
  for (std::size_t j = 0; j < low_.size(); ++j)
    if (d.place[j] >= 0) solution_[j] = (d.is_free[j] ? answer.y : answer.z)[d.place[j]];
  multipliers_.clear();
  for (const double u : answer.x) multipliers_.push_back(-u);
}

// form() numbers the equations in the order of their rows.
void LinearProgramme::take_multipliers(const InteriorSolution& answer) {
  multipliers_.assign(row_low_.size(), 0);
  std::size_t equation = 0;
  for (std::size_t r = 0; r < row_low_.size(); ++r)
    if (row_low_[r] == row_high_[r]) multipliers_[r] = answer.y[equation++];
}

ProgrammeStatus LinearProgramme::solve(const Monitor& monitor, const Tolerance& tolerance) {
  ray_.clear();
  const bool by_dual = is_plain();
  const InteriorSolution answer =
      interior_point(by_dual ? dual_form() : form(), monitor, tolerance);
  accuracy_ = answer.accuracy;
  error_ = answer.error;
  residual_ = by_dual ? answer.dual_residual : answer.residual;
  if (answer.status == ProgrammeStatus::kOptimal) {
    objective_ = by_dual ? -answer.objective : answer.objective;
    dual_objective_ = by_dual ? -answer.objective : answer.dual_objective;
    if (by_dual) {
      take_dual(answer);
    } else {
      solution_ = answer.x;
      take_multipliers(answer);
    }
  }
  if (answer.status == ProgrammeStatus::kUnbounded && !by_dual) ray_ = answer.x;
  if (!by_dual) return answer.status;
  if (answer.status == ProgrammeStatus::kUnbounded) return ProgrammeStatus::kInfeasible;
  return answer.status == ProgrammeStatus::kInfeasible ? ProgrammeStatus::kUnbounded
                                                       : answer.status;
}

}  // namespace wythe::limit
