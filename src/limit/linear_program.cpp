#include "limit/linear_program.h"

#include <coin/ClpSimplex.hpp>
#include <coin/ClpSolve.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/CoinPackedVector.hpp>

#include <cmath>

namespace wythe::limit {
namespace {

constexpr double kFar = 1e8;  // objectives are multiples of a block's weight

double bound(double value) {
  if (value == kFree) return COIN_DBL_MAX;
  return value == -kFree ? -COIN_DBL_MAX : value;
}

std::vector<double> bounds(const std::vector<double>& values, std::size_t from = 0) {
  std::vector<double> out;
  for (std::size_t i = from; i < values.size(); ++i) out.push_back(bound(values[i]));
  return out;
}

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
    row_of_.push_back(rows());
    column_of_.push_back(e.column);
    value_.push_back(e.value);
  }
  row_low_.push_back(low);
  row_high_.push_back(high);
  return rows() - 1;
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

// Interior point with crossover to a vertex: 0.3 s where the simplex alone takes 3.5 s (5615 rows,
// the tuff wall). It does not tell why there is no answer; the simplex does, and
// where there is no limit it may stop far out instead.
void LinearProgramme::solve_first() {
  ClpSolve interior;
  interior.setSolveType(ClpSolve::useBarrier);
  solver_->clp.initialSolve(interior);
  if (solver_->clp.status() == 0 && std::fabs(solver_->clp.objectiveValue()) < kFar) return;
  solver_ = std::make_unique<Solver>();
  load();
  solver_->clp.primal();
}

ProgrammeStatus LinearProgramme::solve() {
  const bool first = loaded_rows_ == 0;
  if (first)
    load();
  else
    append();
  loaded_rows_ = rows();
  loaded_entries_ = value_.size();
  if (first) {
    solve_first();
  } else {
    solver_->clp.dual();
  }
  switch (solver_->clp.status()) {
    case 0: return ProgrammeStatus::kOptimal;
    case 1: return ProgrammeStatus::kInfeasible;
    case 2: return ProgrammeStatus::kUnbounded;
    default: return ProgrammeStatus::kFailed;
  }
}

double LinearProgramme::objective() const { return solver_->clp.objectiveValue(); }

std::vector<double> LinearProgramme::solution() const {
  const double* x = solver_->clp.primalColumnSolution();
  return {x, x + columns()};
}

std::vector<double> LinearProgramme::ray() const {
  const std::unique_ptr<double[]> ray(solver_->clp.unboundedRay());
  if (!ray) return {};
  return {ray.get(), ray.get() + columns()};
}

}  // namespace wythe::limit
