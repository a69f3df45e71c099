// Least angle regression adds terms one by one. The residual moves at equal angles to all terms added, until another
// term has the same correlation. After each term, least squares on the terms gives the leave-one-out error, and the
// number of terms with the smallest error is kept. One factorisation X = Q R grows with the terms and serves both.
#include "statistics/surrogate.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wythe {
namespace {

using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

double legendre(int degree, double u) {
  const double t = 2 * u - 1;
  double before = 1, now = degree == 0 ? 1 : t;
  for (int k = 2; k <= degree; ++k) {
    const double next = ((2 * k - 1) * t * now - (k - 1) * before) / k;
    before = now, now = next;
  }
  return std::sqrt(2.0 * degree + 1) * now;
}

// All terms of the degrees 1 to `degree`, by degree.
std::vector<Term> terms_up_to(std::size_t inputs, int degree) {
  std::vector<Term> terms;
  Term term(inputs, 0);
  const auto add = [&](const auto& self, std::size_t k, int left) -> void {
    if (k + 1 == inputs) {
      term[k] = left;
      terms.push_back(term);
      return;
    }
    for (int d = left; d >= 0; --d) {
      term[k] = d;
      self(self, k + 1, left - d);
    }
  };
  for (int d = 1; d <= degree; ++d) add(add, 0, d);
  return terms;
}

// Least squares with a constant on columns that are added one by one.
class GrowingFit {
 public:
  explicit GrowingFit(const Vector& response)
      : residual_(response.array() - response.mean()),
        leverage_(Vector::Constant(response.size(), 1.0 / static_cast<double>(response.size()))) {}

  // Adds a column with mean 0 and length 1, for mean + length times it; false where earlier columns give it.
  bool add(const Vector& column, double mean, double length) {
    constexpr double kSame = 1e-7;
    const Index k = static_cast<Index>(direction_.size());
    Vector q = column, r = Vector::Zero(k);
    for (int round = 0; round < 2; ++round)  // a second time, against rounding
      for (Index j = 0; j < k; ++j) {
        const double share = direction_[j].dot(q);
        r[j] += share;
        q -= share * direction_[j];
      }
    const double left = q.norm();
    if (left < kSame) return false;
    q /= left;
    Vector inverse(k + 1);  // the new column of R^-1
    if (k > 0) inverse.head(k) = -(inverse_ * r) / left;
    inverse[k] = 1 / left;
    inverse_.conservativeResize(k + 1, k + 1);
    inverse_.row(k).setZero();
    inverse_.col(k) = inverse;
    slope_.push_back(1 / length), shift_.push_back(mean / length);
    double of_constant = 0;
    for (Index j = 0; j <= k; ++j) {
      trace_ += inverse[j] * inverse[j] * slope_[j] * slope_[j];
      of_constant += inverse[j] * shift_[j];
    }
    trace_ += of_constant * of_constant;
    residual_ -= q.dot(residual_) * q;
    leverage_.array() += q.array().square();
    direction_.push_back(std::move(q));
    return true;
  }

  // Corrected leave-one-out error, times n: sum (e/(1 - h))^2 n/(n - p) (1 + tr (X'X)^-1), p columns with the constant.
  [[nodiscard]] double left_out_error() const {
    constexpr double kFixed = 1e-10;
    const auto n = static_cast<double>(residual_.size());
    const double p = static_cast<double>(direction_.size()) + 1;
    if (p >= n || (1 - leverage_.array()).minCoeff() < kFixed)
      return std::numeric_limits<double>::infinity();
    const double error = (residual_.array() / (1 - leverage_.array())).square().sum();
    return error * n / (n - p) * (1 + trace_ + 1 / n);
  }

  // The direction at equal angles to all columns with their signs, and the cosine of that angle.
  [[nodiscard]] std::pair<Vector, double> equiangular(const std::vector<double>& sign) const {
    const Eigen::Map<const Vector> s(sign.data(), static_cast<Index>(sign.size()));
    const Vector on_directions = inverse_.transpose() * s;
    const double cosine = 1 / on_directions.norm();
    Vector line = Vector::Zero(residual_.size());
    for (std::size_t j = 0; j < direction_.size(); ++j)
      line += cosine * on_directions[static_cast<Index>(j)] * direction_[j];
    return {line, cosine};
  }

 private:
  Vector residual_, leverage_;
  std::vector<Vector> direction_;  // columns of Q
  Eigen::MatrixXd inverse_;        // R^-1
  std::vector<double> slope_, shift_;
  double trace_ = 0;  // of (X'X)^-1 without 1/n
};

}  // namespace

Columns legendre_products(const std::vector<Term>& terms, const Columns& inputs) {
  Columns columns;
  for (const Term& term : terms) {
    std::vector<double>& column = columns.emplace_back(inputs.front().size(), 1.0);
    for (std::size_t k = 0; k < term.size(); ++k)
      if (term[k] > 0)
        for (std::size_t i = 0; i < column.size(); ++i)
          column[i] *= legendre(term[k], inputs[k][i]);
  }
  return columns;
}

std::vector<Term> chosen_terms(const Columns& inputs, const std::vector<double>& response,
                               int degree) {
  constexpr double kNothing = 1e-10;  // of the first correlation, or of a column's length
  constexpr double kWorse = 2;        // times the smallest error: no further
  const std::vector<Term> terms = terms_up_to(inputs.size(), degree);
  const Columns values = legendre_products(terms, inputs);
  const auto n = static_cast<Index>(response.size()), count = static_cast<Index>(terms.size());
  Eigen::MatrixXd x(n, count);
  Vector mean(count), length(count);
  for (Index j = 0; j < count; ++j) {
    x.col(j) = Eigen::Map<const Vector>(values[j].data(), n);
    mean[j] = x.col(j).mean();
    x.col(j).array() -= mean[j];
    length[j] = x.col(j).norm();
    x.col(j) /= length[j] > kNothing ? length[j] : std::numeric_limits<double>::infinity();
  }
  const Vector y = Eigen::Map<const Vector>(response.data(), n);
  GrowingFit fit(y);
  Vector left = y.array() - y.mean();
  std::vector<Index> taken;
  std::vector<double> sign;
  std::vector<bool> open(terms.size(), true);
  const auto is_open = [&](Index j) { return open[j]; };

  std::vector<Term> best = {Term(inputs.size(), 0)};
  double smallest = fit.left_out_error();
  const double first = (x.transpose() * left).cwiseAbs().maxCoeff();
  while (true) {
    const Vector correlation = x.transpose() * left;
    Index next = -1;
    for (Index j = 0; j < count; ++j)
      if (is_open(j) && (next < 0 || std::fabs(correlation[j]) > std::fabs(correlation[next])))
        next = j;
    if (next < 0 || !(std::fabs(correlation[next]) > kNothing * first)) return best;
    open[next] = false;
    if (!fit.add(x.col(next), mean[next], length[next])) continue;
    taken.push_back(next), sign.push_back(correlation[next] < 0 ? -1 : 1);
    const double error = fit.left_out_error();
    if (error < smallest) {
      smallest = error;
      best.resize(1);
      for (const Index j : taken) best.push_back(terms[j]);
    }
    if (!(error <= kWorse * smallest)) return best;

    const auto [line, cosine] = fit.equiangular(sign);
    const Vector along = x.transpose() * line;
    const double equal = std::fabs(correlation[next]);
    double step = equal / cosine;
    for (Index j = 0; j < count; ++j)
      if (is_open(j))
        for (const double s : {1.0, -1.0}) {
          const double to = (equal - s * correlation[j]) / (cosine - s * along[j]);
          if (to > 0 && to < step) step = to;
        }
    left -= step * line;
  }
}

}  // namespace wythe
