#include "limit/solver/linear_program.h"

#include <coin/ClpEventHandler.hpp>
#include <coin/ClpSimplex.hpp>
#include <coin/ClpSolve.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/CoinPackedVector.hpp>

#include <cmath>

namespace wythe::limit {
namespace {

constexpr double kFar = 1e8;  // objectives are multiples of a block's weight
constexpr int kMany = 8000;   // rows from which on the interior point is asked first

double bound(double value) {
  if (value == kFree) return COIN_DBL_MAX;
  return value == -kFree ? -COIN_DBL_MAX : value;
}

std::vector<double> bounds(const std::vector<double>& values, std::size_t from = 0) {
  std::vector<double> out;
  for (std::size_t i = from; i < values.size(); ++i) out.push_back(bound(values[i]));
  return out;
}

// Clp calls this from time to time; it stops Clp when the watch asks for it. Clp reports no progress.
class StopHandler : public ClpEventHandler {
 public:
  explicit StopHandler(const Watch& watch) : watch_(watch) {}
  int event(Event) override { return watch_ && watch_(0) ? 0 : -1; }  // 0: stop
  [[nodiscard]] ClpEventHandler* clone() const override { return new StopHandler(*this); }

 private:
  Watch watch_;
};

}  // namespace

struct LinearProgramme::Solver {
  ClpSimplex clp;
  Solver() {
    clp.setLogLevel(0);
    // with Clp's own 1e-7 the bound theorems differ by up to 2e-6 on the tuff wall, so by 1e-14
    clp.setPrimalTolerance(1e-9);
    clp.setDualTolerance(1e-9);
  }
};

LinearProgramme::LinearProgramme() : solver_(std::make_unique<Solver>()) {}
LinearProgramme::~LinearProgramme() = default;

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

void LinearProgramme::load() {
  CoinPackedMatrix matrix(true, row_of_.data(), column_of_.data(), value_.data(),
                          static_cast<CoinBigIndex>(value_.size()));
  matrix.setDimensions(rows(), columns());
  const auto low = bounds(low_), high = bounds(high_), row_low = bounds(row_low_),
             row_high = bounds(row_high_);
  solver_->clp.loadProblem(matrix, low.data(), high.data(), cost_.data(), row_low.data(),
                           row_high.data());
}

void LinearProgramme::append() {
  std::size_t at = loaded_entries_;
  for (int r = loaded_rows_; r < rows(); ++r) {
    CoinPackedVector row;
    for (; at < value_.size() && row_of_[at] == r; ++at) row.insert(column_of_[at], value_[at]);
    const auto i = static_cast<std::size_t>(r);
    solver_->clp.addRow(row.getNumElements(), row.getIndices(), row.getElements(),
                        bound(row_low_[i]), bound(row_high_[i]));
  }
}

// Clp's interior point with crossover to a vertex: 0.3 s where its simplex alone takes 3.5 s (5615 rows,
// the tuff wall). It does not tell why there is no answer; the simplex does, and where there is no
// limit it may stop far out instead.
ProgrammeStatus LinearProgramme::solve_by_vertices(const Watch& watch) {
  const auto stopped = [&] { return watch && watch(0); };
  const bool first = loaded_rows_ == 0;
  StopHandler handler(watch);
  if (first) {
    load();
    solver_->clp.passInEventHandler(&handler);
    ClpSolve interior;
    interior.setSolveType(ClpSolve::useBarrier);
    solver_->clp.initialSolve(interior);
    const bool found =
        solver_->clp.status() == 0 && std::fabs(solver_->clp.objectiveValue()) < kFar;
    if (!found && !stopped()) {
      solver_ = std::make_unique<Solver>();
      load();
      solver_->clp.passInEventHandler(&handler);
      solver_->clp.primal();
    }
  } else {
    append();
    solver_->clp.passInEventHandler(&handler);
    solver_->clp.dual();
  }
  loaded_rows_ = rows();
  loaded_entries_ = value_.size();
  if (stopped()) return ProgrammeStatus::kStopped;
  objective_ = solver_->clp.objectiveValue();
  accuracy_ = 0;
  const double* x = solver_->clp.primalColumnSolution();
  solution_.assign(x, x + columns());
  switch (solver_->clp.status()) {
    case 0: return ProgrammeStatus::kOptimal;
    case 1: return ProgrammeStatus::kInfeasible;
    case 2: break;
    default: return ProgrammeStatus::kFailed;
  }
  const std::unique_ptr<double[]> ray(solver_->clp.unboundedRay());
  if (ray) ray_.assign(ray.get(), ray.get() + columns());
  return ProgrammeStatus::kUnbounded;
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
    const auto r = static_cast<std::size_t>(row_of_[i]);
    if (equation[r] >= 0) f.equal.add(equation[r], column_of_[i], value_[i]);
    if (below[r] >= 0) f.below.add(below[r], column_of_[i], value_[i]);
    if (above[r] >= 0) f.below.add(above[r], column_of_[i], -value_[i]);
  }
  for (int j = 0; j < columns(); ++j) {
    const double low = low_[static_cast<std::size_t>(j)], high = high_[static_cast<std::size_t>(j)];
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
    for (int i = 0; i < 3; ++i) in_circle[static_cast<std::size_t>(first + i)] = 1;
  for (std::size_t j = 0; j < low_.size(); ++j) {
    if (high_[j] == 0 || in_circle[j]) continue;
    d.is_free[j] = low_[j] != 0;
    d.place[j] = d.is_free[j] ? d.free++ : d.held++;
  }
  for (const int first : circle_columns_)
    for (int i = 0; i < 3; ++i) d.place[static_cast<std::size_t>(first + i)] = d.held++;
  return d;
}

// The dual of a plain programme has no unknown without an inequality, which the interior point likes:
//   min c.x, A x = b, x in K or free   ->   min -b.u, c - A'u in K or nil
InequalityForm LinearProgramme::dual_form() const {
  InequalityForm f;
  for (const double right : row_low_) f.c.push_back(-right);
  const DualPlaces d = dual_places();
  f.b.resize(static_cast<std::size_t>(d.free));
  f.h.resize(static_cast<std::size_t>(d.held));
  f.circles = static_cast<int>(circle_columns_.size());
  for (std::size_t j = 0; j < low_.size(); ++j)
    if (d.place[j] >= 0)
      (d.is_free[j] ? f.b : f.h)[static_cast<std::size_t>(d.place[j])] = cost_[j];
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const auto j = static_cast<std::size_t>(column_of_[i]);
    if (d.place[j] >= 0) (d.is_free[j] ? f.equal : f.below).add(d.place[j], row_of_[i], value_[i]);
  }
  return f;
}

void LinearProgramme::take_dual(const InteriorAnswer& answer) {
  const DualPlaces d = dual_places();
  solution_.assign(low_.size(), 0);
  for (std::size_t j = 0; j < low_.size(); ++j)
    if (d.place[j] >= 0)
      solution_[j] = (d.is_free[j] ? answer.y : answer.z)[static_cast<std::size_t>(d.place[j])];
}

ProgrammeStatus LinearProgramme::solve_inside(const Watch& watch) {
  const bool by_dual = is_plain();
  const InteriorAnswer answer = interior_point(by_dual ? dual_form() : form(), watch);
  accuracy_ = answer.accuracy;
  if (answer.status == ProgrammeStatus::kOptimal) {
    objective_ = by_dual ? -answer.objective : answer.objective;
    if (by_dual)
      take_dual(answer);
    else
      solution_ = answer.x;
  }
  if (answer.status == ProgrammeStatus::kUnbounded && !by_dual) ray_ = answer.x;
  if (!by_dual) return answer.status;
  if (answer.status == ProgrammeStatus::kUnbounded) return ProgrammeStatus::kInfeasible;
  return answer.status == ProgrammeStatus::kInfeasible ? ProgrammeStatus::kUnbounded
                                                       : answer.status;
}

ProgrammeStatus LinearProgramme::solve(const Watch& watch) {
  ray_.clear();
  if (has_circles()) return solve_inside(watch);
  const bool inside = (prefers_inside_ || rows() > kMany) && loaded_rows_ == 0;
  const ProgrammeStatus status = inside ? solve_inside(watch) : solve_by_vertices(watch);
  if (status != ProgrammeStatus::kFailed) return status;
  return inside ? solve_by_vertices(watch) : solve_inside(watch);
}

}  // namespace wythe::limit
