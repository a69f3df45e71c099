// Solves the homogeneous self-dual form by Mehrotra's predictor and corrector (docs/decisions/0017).
// An iteration factors one system and solves it three times with refinement. A small term on the diagonal keeps pivots
// off zero. Where round-off wins, that term grows tenfold and the search goes on from the best point. Rows of G are
// scaled to capacities of 1 at most.
#include "limit/solver/interior_point.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/elementary.h"
#include "limit/solver/cones.h"
#include "limit/solver/sparse_factor.h"

namespace wythe::limit {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

constexpr int kIterations = 150;   // 30 to 80 are usual
constexpr int kPatience = 5;       // iterations without a better point
constexpr double kAstray = 100;    // times as far off as the best point
constexpr double kRegular = 1e-9;  // on the systems' diagonal; refinement takes it back
constexpr double kMostRegular = 1e-6;
constexpr int kRefinements = 10;
constexpr int kHalvings = 40;      // of a step that round-off took out of a circle's cone
constexpr double kShorten = 0.99;  // of the step to the boundary
constexpr double kProof = 1e-8;    // of a ray's residual, to its fall

Matrix matrix_of(const Triplets& t, int rows, int columns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < t.value.size(); ++i)
    entries.emplace_back(t.row[i], t.column[i], t.value[i]);
  Matrix m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

Vector vector_of(const std::vector<double>& v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}

std::vector<double> list_of(const Vector& v) { return {v.data(), v.data() + v.size()}; }

double largest(const Vector& v) { return v.size() == 0 ? 0.0 : v.cwiseAbs().maxCoeff(); }

struct Iterate {
  Vector x, y, z, s;
  double tau = 1, kappa = 1;
};

class InteriorPoint {
 public:
  InteriorPoint(const InequalityForm& f, const Tolerance& tolerance)
      : tolerance_(tolerance),
        n_(static_cast<int>(f.c.size())),
        p_(static_cast<int>(f.b.size())),
        m_(static_cast<int>(f.h.size())),
        a_(matrix_of(f.equal, p_, n_)),
        g_(matrix_of(f.below, m_, n_)),
        at_(a_.transpose()),
        gt_(g_.transpose()),
        c_(vector_of(f.c)),
        b_(vector_of(f.b)),
        h_(vector_of(f.h)),
        cones_(m_ - 3 * f.circles, f.circles) {
    scale_rows();
    scale_ = std::max({1.0, largest(b_), largest(h_)});
    b_ /= scale_;
    h_ /= scale_;
    q_ = {Vector::Zero(n_), Vector::Zero(p_), cones_.unit(), cones_.unit()};
    build_system();
  }

  InteriorSolution solve(const Monitor& monitor) {
    InteriorSolution best;
    best.accuracy = std::numeric_limits<double>::infinity();
    Iterate best_point = q_;
    int better = 0, halved = 0;  // the last iteration that was nearer; by half
    double first = 0, least = best.accuracy;
    for (int i = 0; i < kIterations; ++i) {
      take_residuals();
      if (find_ray(best)) return best;
      const double residual = accuracy(), before = best.accuracy;
      if (i == 0) first = residual;
      if (residual < best.accuracy) keep(i, residual, best);
      if (residual < 0.5 * before) halved = i;
      if (best.accuracy < tolerance_.best || (best.accuracy < tolerance_.wanted && i > halved + 1))
        break;
      // what is left falls on the way to a solution and on that to a proof that there is none
      const double left = merit();
      if (residual < before || left < least) {
        better = i;
        best_point = q_;
        least = std::min(least, left);
      }
      // round-off has the upper hand: from the best point on with a stiffer system
      const bool astray = !(residual < kAstray * best.accuracy) &&
                          !(left < kAstray * std::max(least, tolerance_.wanted));
      if (astray || i - better > kPatience) {
        if (regular_ >= kMostRegular) break;
        regular_ *= 10;
        better = i;
        q_ = best_point;
        take_residuals();
      }
      const double done =
          elementary::log(first / best.accuracy) / elementary::log(first / tolerance_.wanted);
      if (monitor && monitor(std::clamp(done, 0.0, 1.0))) {
        best.status = ProgrammeStatus::kStopped;
        return best;
      }
      factorise();
      step();
    }
    best.status =
        best.accuracy < tolerance_.enough ? ProgrammeStatus::kOptimal : ProgrammeStatus::kFailed;
    return best;
  }

 private:
  // --- where the iterate stands -------------------------------------------------------------------

  void take_residuals() {
    primal_objective_ = c_.dot(q_.x);
    dual_objective_ = -b_.dot(q_.y) - h_.dot(q_.z);
    rx_ = at_ * q_.y + gt_ * q_.z + c_ * q_.tau;
    ry_ = b_ * q_.tau - a_ * q_.x;
    rz_ = h_ * q_.tau - g_ * q_.x - q_.s;
    rt_ = dual_objective_ - primal_objective_ - q_.kappa;
  }

  [[nodiscard]] double accuracy() const {
    const double gap =
        std::fabs(primal_objective_ - dual_objective_) /
        (1e-3 * q_.tau + std::min(std::fabs(primal_objective_), std::fabs(dual_objective_)));
    return std::max({largest(rx_) / q_.tau, largest(ry_) / q_.tau, largest(rz_) / q_.tau, gap});
  }

  // Largest residual, and the mean of s z: both fall with each step that round-off leaves alone.
  [[nodiscard]] double merit() const {
    return std::max({largest(rx_), largest(ry_), largest(rz_), mean_product()});
  }

  void keep(int iteration, double residual, InteriorSolution& answer) const {
    answer.x = list_of(scale_ / q_.tau * q_.x);
    answer.y = list_of(q_.y / q_.tau);
    answer.z = list_of(row_scale_.cwiseProduct(q_.z) / q_.tau);
    answer.objective = scale_ * primal_objective_ / q_.tau;
    answer.dual_objective = scale_ * dual_objective_ / q_.tau;
    answer.accuracy = residual;
    const double left =
        std::fabs(q_.x.dot(rx_)) + std::fabs(q_.y.dot(ry_)) + std::fabs(q_.z.dot(rz_));
    answer.error =
        scale_ / q_.tau * (std::fabs(primal_objective_ - dual_objective_) + left / q_.tau);
    answer.residual =
        scale_ / q_.tau * (ry_.lpNorm<1>() + rz_.cwiseQuotient(row_scale_).lpNorm<1>());
    answer.dual_residual = rx_.lpNorm<1>() / q_.tau;
    answer.iterations = iteration;
  }

  // A proof that no x holds, or a direction in which c.x falls for ever. There each row counts as it was given: beside
  // its capacity any row is next to nothing on the way to a load of many million weights.
  bool find_ray(InteriorSolution& answer) const {
    if (dual_objective_ > 0 && largest(at_ * q_.y + gt_ * q_.z) < kProof * dual_objective_) {
      answer.status = ProgrammeStatus::kInfeasible;
      return true;
    }
    if (primal_objective_ >= 0) return false;
    const Vector held = (g_ * q_.x + q_.s).cwiseQuotient(row_scale_);
    if (std::max(largest(a_ * q_.x), largest(held)) >= kProof * -primal_objective_) return false;
    answer.status = ProgrammeStatus::kUnbounded;
    answer.x = list_of(q_.x / -primal_objective_);
    return true;
  }

  // Each row beside a capacity of 1 at most: a joint that bears a million times as much hides no error.
  void scale_rows() {
    row_scale_ = Vector::Ones(m_);
    for (int row = 0; row < cones_.plain(); ++row)
      row_scale_[row] = 1 / std::max(1.0, std::fabs(h_[row]));
    for (int k = 0; k < cones_.circles(); ++k) {
      const int row = cones_.first_row(k);
      row_scale_.segment(row, 3).setConstant(1 / std::max(1.0, largest(h_.segment(row, 3))));
    }
    h_ = row_scale_.cwiseProduct(h_);
    g_ = row_scale_.asDiagonal() * g_;
    gt_ = g_.transpose();
  }

  // --- the systems  [0 A' G'; A 0 0; G 0 -W W] ----------------------------------------------------

  void build_system() {
    const int size = n_ + p_ + m_;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 0.0);
    const auto put = [&](const Matrix& rows, int from) {
      for (int column = 0; column < n_; ++column)
        for (Matrix::InnerIterator i(rows, column); i; ++i)
          entries.emplace_back(from + static_cast<int>(i.row()), column, i.value());
    };
    put(a_, n_);
    put(g_, n_ + p_);
    for_pairs([&](int, int, int, int low, int high) { entries.emplace_back(high, low, 0.0); });
    Matrix lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    order_ = elimination_order();
    back_ = order_.inverse();
    system_.resize(size, size);
    system_.selfadjointView<Eigen::Upper>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    system_.makeCompressed();
    std::vector<double> signs(size);
    for (int i = 0; i < size; ++i) {
      diagonal_.push_back(entry(i, i));
      signs[order_.indices()[i]] = i < n_ ? 1 : -1;
    }
    for_pairs([&](int, int, int, int low, int high) { pair_.push_back(entry(high, low)); });
    factor_.analyse(system_, std::move(signs));
  }

  // Rows i < j of each circle, and their places in the system.
  template <class Look>
  void for_pairs(const Look& look) const {
    for (int k = 0; k < cones_.circles(); ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = i + 1; j < 3; ++j) {
          const int first = n_ + p_ + cones_.first_row(k);
          look(k, i, j, first + i, first + j);
        }
  }
  // Where the system keeps the entry of two places.
  [[nodiscard]] double* entry(int one, int other) {
    const int a = order_.indices()[one], b = order_.indices()[other];
    for (Matrix::InnerIterator e(system_, std::max(a, b)); e; ++e)
      if (e.row() == std::min(a, b)) return &e.valueRef();
    return nullptr;
  }

  // Unknowns that an inequality or a circle holds, and for each the first of those it shares one with.
  void group_unknowns(std::vector<char>& held, std::vector<int>& group) const {
    held.assign(n_, 0);
    group.resize(n_);
    std::iota(group.begin(), group.end(), 0);
    const auto head = [&](int i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    int first = -1;
    for (int row = 0; row < m_; ++row) {
      if (row < cones_.plain() || (row - cones_.plain()) % 3 == 0) first = -1;
      for (Matrix::InnerIterator i(gt_, row); i; ++i) {
        const int unknown = static_cast<int>(i.row());
        held[unknown] = 1;
        if (first < 0) first = unknown;
        group[head(unknown)] = head(first);
      }
    }
    for (int i = 0; i < n_; ++i) group[i] = head(i);
  }

  // Inequalities first, then the unknowns they hold, a joint's at a time. That leaves springs between the
  // equations, taken in an order of little fill with the unknowns that nothing holds. (An unknown
  // before what holds it is a pivot of nothing: by degree alone the facade's factors blow up.)
  [[nodiscard]] Order elimination_order() const {
    std::vector<char> held;
    std::vector<int> group;
    group_unknowns(held, group);
    std::vector<int> place(n_, -1);
    int left = p_;
    for (int i = 0; i < n_; ++i)
      if (!held[i]) place[i] = left++;
    std::vector<std::vector<int>> clique(n_);
    std::vector<Eigen::Triplet<double>> pattern;
    for (int i = 0; i < left; ++i) pattern.emplace_back(i, i, 1.0);
    for (int i = 0; i < n_; ++i) {
      for (Matrix::InnerIterator e(a_, i); e; ++e) {
        const int row = static_cast<int>(e.row());
        if (held[i]) {
          clique[group[i]].push_back(row);
          continue;
        }
        pattern.emplace_back(place[i], row, 1.0);
        pattern.emplace_back(row, place[i], 1.0);
      }
    }
    for (std::vector<int>& rows : clique) {
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      for (const int i : rows)
        for (const int j : rows) pattern.emplace_back(i, j, 1.0);
    }
    Matrix rest(left, left);
    rest.setFromTriplets(pattern.begin(), pattern.end());
    Order back;
    Eigen::AMDOrdering<int>()(rest, back);
    const Order late = back.inverse();
    Order order(n_ + p_ + m_);
    int at = 0;
    for (int i = 0; i < m_; ++i) order.indices()[n_ + p_ + i] = at++;
    for (int i = 0; i < n_; ++i)
      if (held[i]) order.indices()[i] = at++;
    for (int i = 0; i < n_; ++i)
      if (!held[i]) order.indices()[i] = at + late.indices()[place[i]];
    for (int i = 0; i < p_; ++i) order.indices()[n_ + i] = at + late.indices()[i];
    return order;
  }

  void factorise() {
    cones_.scale(q_.s, q_.z);
    for (int i = 0; i < n_; ++i) *diagonal_[i] = regular_;
    for (int i = 0; i < p_; ++i) *diagonal_[n_ + i] = -regular_;
    for (int i = 0; i < cones_.plain(); ++i)
      *diagonal_[n_ + p_ + i] = -cones_.squared(i) - regular_;
    for (int k = 0; k < cones_.circles(); ++k)
      for (int i = 0; i < 3; ++i)
        *diagonal_[n_ + p_ + cones_.first_row(k) + i] = -cones_.squared(k, i, i) - regular_;
    auto place = pair_.begin();
    for_pairs([&](int k, int i, int j, int, int) { **place++ = -cones_.squared(k, i, j); });
    factor_.factorise(system_.valuePtr());
  }

  struct Three {
    Vector x, y, z;
  };
  // A right side, and what is found so far.
  struct Refined {
    Three right, found, left;
    double scale = 0, before = std::numeric_limits<double>::infinity();
    bool ends = false;
  };

  // Solves and refines until the residual no longer falls. Right sides go through the factor together.
  template <std::size_t N>
  [[nodiscard]] std::array<Three, N> solve_systems(std::array<Three, N> right) const {
    std::array<Refined, N> all;
    for (std::size_t k = 0; k < N; ++k) {
      Refined& r = all[k];
      r.found = {Vector::Zero(n_), Vector::Zero(p_), Vector::Zero(m_)};
      r.left = r.right = std::move(right[k]);
      r.scale = std::max({largest(r.right.x), largest(r.right.y), largest(r.right.z)});
    }
    std::array<Vector, N> d;
    std::vector<Vector*> under_way;
    for (int i = 0; i < kRefinements; ++i) {
      under_way.clear();
      for (std::size_t k = 0; k < N; ++k) {
        if (all[k].ends) continue;
        d[k].resize(n_ + p_ + m_);
        d[k] << all[k].left.x, all[k].left.y, all[k].left.z;
        d[k] = order_ * d[k];
        under_way.push_back(&d[k]);
      }
      if (under_way.empty()) break;
      if (under_way.size() == 2)
        factor_.solve(*under_way[0], *under_way[1]);
      else
        factor_.solve(*under_way[0]);
      for (std::size_t k = 0; k < N; ++k)
        if (!all[k].ends) add(back_ * d[k], all[k]);
    }
    std::array<Three, N> found;
    for (std::size_t k = 0; k < N; ++k) found[k] = std::move(all[k].found);
    return found;
  }

  void add(const Vector& d, Refined& r) const {
    Three next{r.found.x + d.head(n_), r.found.y + d.segment(n_, p_), r.found.z + d.tail(m_)};
    r.left.x = r.right.x - at_ * next.y - gt_ * next.z;
    r.left.y = r.right.y - a_ * next.x;
    r.left.z = r.right.z - g_ * next.x + cones_.squared_times(next.z);
    const double error = std::max({largest(r.left.x), largest(r.left.y), largest(r.left.z)});
    r.ends = !(error <= r.before);
    if (r.ends) return;
    r.found = std::move(next);
    r.ends = error < tolerance_.linear * r.scale || error > 0.7 * r.before;
    r.before = error;
  }

  // --- the step: predictor and corrector, after Mehrotra ------------------------------------------

  [[nodiscard]] double mean_product() const {
    return (q_.s.dot(q_.z) + q_.tau * q_.kappa) / (cones_.degree() + 1);
  }

  void step() {
    const double mu = mean_product();
    Three one, two;
    const auto fall = [&](const Three& t) { return c_.dot(t.x) + b_.dot(t.y) + h_.dot(t.z); };
    double denominator = 0;
    Iterate d;
    double sigma = 0, alpha = 0;
    for (const bool corrects : {false, true}) {
      Vector sz = -cones_.product(q_.s, q_.z);
      double tk = -q_.kappa * q_.tau;
      if (corrects) {
        sz += sigma * mu * cones_.unit() - cones_.product_of_changes(d.s, d.z);
        tk += sigma * mu - d.kappa * d.tau;
      }
      const double rest = 1 - sigma;
      const Three right{-rest * rx_, rest * ry_, rest * rz_ - cones_.lead(sz, q_.z)};
      if (corrects) {
        two = std::move(solve_systems<1>({right})[0]);
      } else {
        auto both = solve_systems<2>({Three{-c_, b_, h_}, right});
        one = std::move(both[0]);
        two = std::move(both[1]);
        denominator = q_.kappa / q_.tau - fall(one);
      }
      d.tau = (-rest * rt_ + tk / q_.tau + fall(two)) / denominator;
      d.x = two.x + d.tau * one.x;
      d.y = two.y + d.tau * one.y;
      d.z = two.z + d.tau * one.z;
      d.s = cones_.change(sz, q_.s, q_.z, d.z);
      d.kappa = (tk - q_.kappa * d.tau) / q_.tau;
      alpha = longest(d);
      sigma = elementary::pow(1 - alpha, 3);
    }
    alpha = std::min(1.0, kShorten * alpha);
    // round-off must not carry a circle over its edge
    for (int i = 0; i < kHalvings; ++i) {
      if (cones_.is_inside(q_.s + alpha * d.s) && cones_.is_inside(q_.z + alpha * d.z)) break;
      alpha *= 0.5;
    }
    q_.x += alpha * d.x;
    q_.y += alpha * d.y;
    q_.z += alpha * d.z;
    q_.s += alpha * d.s;
    q_.tau += alpha * d.tau;
    q_.kappa += alpha * d.kappa;
  }

  // Of a step that keeps s, z, tau and kappa positive; 1 at most.
  [[nodiscard]] double longest(const Iterate& d) const {
    double alpha = 1;
    const auto look = [&](double value, double change) {
      if (change < 0) alpha = std::min(alpha, -value / change);
    };
    alpha = cones_.longest(q_.z, d.z, cones_.longest(q_.s, d.s, alpha));
    look(q_.tau, d.tau);
    look(q_.kappa, d.kappa);
    return alpha;
  }

  Tolerance tolerance_;
  int n_, p_, m_;
  Matrix a_, g_, at_, gt_;
  Vector c_, b_, h_;
  Cones cones_;
  Vector row_scale_;  // of G and h
  double scale_ = 1;  // of b and h
  double regular_ = kRegular;
  Iterate q_;
  double primal_objective_ = 0, dual_objective_ = 0, rt_ = 0;  // c.x, -b.y - h.z
  Vector rx_, ry_, rz_;
  Matrix system_;
  Order order_, back_;
  std::vector<double*> diagonal_;  // of system_: x, y, z
  std::vector<double*> pair_;      // of system_: for_pairs()
  SparseFactor factor_;
};

}  // namespace

InteriorSolution interior_point(const InequalityForm& form, const Monitor& monitor,
                                const Tolerance& tolerance) {
  return InteriorPoint(form, tolerance).solve(monitor);
}

}  // namespace wythe::limit
