// L D L' of a sparse symmetric matrix whose pivots' signs are known: interior_point.cpp's systems.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace wythe::limit {

// Up-looking, row by row, in the order the matrix comes in. The pattern is analysed once. A pivot that
// round-off has taken to the wrong side is put back; whoever solves refines. Reference: T. A. Davis,
// Algorithm 849, ACM Trans. Math. Softw. 31 (2005) 587-591.
class SparseFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  // `upper`: upper triangle with its whole diagonal; `signs`: +1 or -1, of each pivot.
  void analyse(const Matrix& upper, std::vector<double> signs);
  // Of the values of a matrix with that pattern.
  void factorise(const double* value);
  void solve(Eigen::VectorXd& x) const;
  void solve(Eigen::VectorXd& x, Eigen::VectorXd& y) const;  // the bits of one after the other

 private:
  // Columns of L that row k meets, each before those it changes.
  void find_path(int k, const double* value, double& diagonal);

  int n_ = 0;
  std::vector<double> sign_, l_value_, d_;  // d_: reciprocal pivots
  std::vector<int> begin_, row_, parent_, l_begin_, l_row_;
  std::vector<int> path_, branch_;  // scratch
  std::vector<char> marked_;
  std::vector<double> y_;
};

}  // namespace wythe::limit
