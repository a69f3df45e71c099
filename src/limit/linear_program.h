// A sparse linear programme and its solution: the only door to Clp.
//
//   minimise c.x   with   row_low <= A x <= row_high,   low <= x <= high
//
// Called by static_programme.cpp and kinematic_programme.cpp. Rows and columns are added one by one;
// after a solution more rows may follow, and solving goes on from there (dual simplex).
#pragma once

#include <limits>
#include <memory>
#include <vector>

namespace wythe::limit {

inline constexpr double kFree = std::numeric_limits<double>::infinity();

struct Entry {
  int column;
  double value;
};

enum class ProgrammeStatus { kOptimal, kInfeasible, kUnbounded, kFailed };

class LinearProgramme {
 public:
  LinearProgramme();
  ~LinearProgramme();
  LinearProgramme(const LinearProgramme&) = delete;
  LinearProgramme& operator=(const LinearProgramme&) = delete;

  int add_column(double low, double high, double cost);
  int add_row(const std::vector<Entry>& entries, double low, double high);
  [[nodiscard]] int columns() const { return static_cast<int>(low_.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(row_low_.size()); }

  // Solves, or goes on after rows were added.
  ProgrammeStatus solve();
  [[nodiscard]] double objective() const;
  [[nodiscard]] std::vector<double> solution() const;  // (columns)
  // After kUnbounded: a direction in which the objective falls for ever (columns), may be empty.
  [[nodiscard]] std::vector<double> ray() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
  std::vector<double> low_, high_, cost_, row_low_, row_high_;
  std::vector<int> row_of_, column_of_;  // of each entry
  std::vector<double> value_;
  std::size_t loaded_entries_ = 0;
  int loaded_rows_ = 0;
  void load();
  void solve_first();
  void append();
};

}  // namespace wythe::limit
