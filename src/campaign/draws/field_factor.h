// Factors F of a correlation matrix C = F F^T, of points on a line, on a grid of lines, or anywhere.
//
//   z = F w,  w independent standard normal   =>   cov(z) = F F^T = C
//
// Both kernels are products of a function of dx (in space, of the distance in plan) and one of dy. So on a grid
// of nx columns and ny rows C is the Kronecker product of two small matrices. Z = Fx W Fy^T has C for its
// covariance, exactly, with nx^3 + ny^3 instead of (nx ny)^3 operations. A wall of courses lies on such a grid.
//
// The loops are written here because LAPACK adds in an order that differs between machines, and so would
// the bits of every wall. The exponential of the kernel is that of core/real.h for the same reason.
#pragma once

#include <cstddef>
#include <vector>

#include "wythe/parts/field.h"

namespace wythe {

// Correlation of two places at distance `d`, of one direction, correlation length `length` [m].
[[nodiscard]] double correlation_at(FieldKernel kernel, double d, double length);

// A matrix of n rows and `rank` columns, row by row.
struct FieldFactor {
  std::size_t n = 0, rank = 0;
  std::vector<double> value;
  [[nodiscard]] double at(std::size_t i, std::size_t k) const { return value[i * rank + k]; }
};

// F of the n x n correlation matrix `c` (row by row), by Cholesky with the largest pivot first. It stops
// when the largest remaining pivot is n times the rounding of 1. F F^T is C to the accuracy of its entries.
[[nodiscard]] FieldFactor factor_of(std::vector<double> c, std::size_t n);

// Places of a field: columns and rows of coordinates, and the column and row of each place.
class FieldGrid {
 public:
  FieldGrid(const std::vector<double>& x, const std::vector<double>& y, double same);
  // In space: columns are places in plan, and their distance is that in plan.
  FieldGrid(const std::vector<double>& x, const std::vector<double>& z,
            const std::vector<double>& y, double same);

  // Number of operations to factor and draw, on the grid or place by place, whichever is cheaper.
  [[nodiscard]] double cost() const;
  // Number of independent normal numbers that draw() takes.
  [[nodiscard]] std::size_t numbers() const;
  // Sets kernel and correlation lengths.
  void correlate(FieldKernel kernel, double along, double across);
  // The field z at each place, from numbers() independent normal numbers.
  [[nodiscard]] std::vector<double> draw(const std::vector<double>& w) const;

  [[nodiscard]] std::size_t columns() const { return x_.size(); }
  [[nodiscard]] std::size_t rows() const { return y_.size(); }
  // Distance from the first to the last column, in plan the diagonal of their box; from the lowest row to the highest [m].
  [[nodiscard]] double width() const;
  [[nodiscard]] double height() const { return y_.back() - y_.front(); }

 private:
  [[nodiscard]] bool is_grid() const;
  [[nodiscard]] double between_columns(std::size_t i, std::size_t k) const;
  std::vector<double> x_, z_, y_;          // z_ of columns, empty in a plane
  std::vector<std::size_t> column_, row_;  // of each place
  FieldFactor along_, across_;             // of a grid; else along_ is for the places
};

}  // namespace wythe
