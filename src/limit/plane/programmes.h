// The two linear programmes of limit analysis, each derived from its own theorem.
//
//   static     max load   with every block in equilibrium and every joint within its strength
//   kinematic  min (dissipation - power of dead loads)   such that joints flow by the normality
//              rule and the load has unit power
//
// By duality both results are equal. One is built from forces, the other from velocities, which
// makes their equality a check. Called by limit_load.cpp. In both, forces are in `force` units and
// lengths in `length` units, so that the numbers are near 1.
// Reference: R. K. Livesley, Int. J. Numer. Methods Eng. 12 (1978) 1853-1871.
#pragma once

#include <cmath>
#include <vector>

#include "limit/limit_loads.h"
#include "limit/plane/joint_yield.h"
#include "limit/solver/linear_program.h"
#include "wythe/parts/model.h"

namespace wythe::limit {

// What a static programme asks: the largest load; whether the wall stands without it; what forces it then lacks.
enum class Purpose { kLoad, kRest, kUnbalanced };

// Blocks stand where no more is left unbalanced over all of them [units of force].
inline constexpr double kBalanced = 1e-6;

struct Units {
  double force = 1, length = 1;
};

// The block with the largest unbalanced force without a growing load [N]; -1: all are in equilibrium, if solved.
struct Unbalanced {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  BlockId block = -1;
  double force = 0;
};

// What the static programmes in the plane and in space have alike, with so many equations of balance for each block.
template <int kEquations>
class StaticRows {
 public:
  // After build(Purpose::kRest). kFailed: too much is left unbalanced to tell.
  ProgrammeStatus stands(const Monitor& monitor) {
    const ProgrammeStatus found = lp_.solve(monitor);
    const bool is_unsure = found == ProgrammeStatus::kOptimal && lp_.residual() >= kBalanced;
    return is_unsure ? ProgrammeStatus::kFailed : found;
  }

  // The largest unbalanced force, after build(Purpose::kUnbalanced).
  Unbalanced worst(const Monitor& monitor) {
    Unbalanced found;
    found.status = lp_.solve(monitor);
    if (found.status != ProgrammeStatus::kOptimal) return found;
    const std::vector<double>& x = lp_.solution();
    double total = 0;
    for (std::size_t row = 0; row < balance_.size(); ++row) {
      const double unbalanced = x[slack_ + 2 * row] + x[slack_ + 2 * row + 1];
      total += unbalanced;
      if (unbalanced * u_.force > found.force)
        found = {found.status, static_cast<BlockId>(row / kEquations), unbalanced * u_.force};
    }
    return total < kBalanced ? Unbalanced{found.status} : found;
  }

 protected:
  StaticRows(const Model& m, const Units& u, bool is_force)
      : m_(m),
        u_(u),
        load_unit_(is_force ? u.force : 1.0),
        balance_(kEquations * static_cast<std::size_t>(m.n_block)) {}

  // The load is a variable for kLoad only, else it is zero.
  void add_load(Purpose purpose) {
    const bool grows = purpose == Purpose::kLoad;
    load_ = lp_.add_column(grows ? -kFree : 0, grows ? kFree : 0, grows ? -1 : 0);
  }
  void add_slack() {
    slack_ = static_cast<std::size_t>(lp_.columns());
    for (std::vector<Entry>& row : balance_)
      for (const double sign : {1.0, -1.0}) row.push_back({lp_.add_column(0, kFree, 1), sign});
  }

  // Solves for the load and forces of links; true where there is a largest load. Columns of joint j begin at first(j), those of
  // links directly follow.
  template <class Answer, class First>
  bool solve_for(Answer& answer, const Monitor& monitor, const Tolerance& tolerance,
                 const First& first) {
    answer.status = lp_.solve(monitor, tolerance);
    answer.accuracy = lp_.accuracy();
    answer.error = lp_.error() * load_unit_;
    answer.rows = lp_.rows();
    answer.columns = lp_.columns();
    if (answer.status == ProgrammeStatus::kUnbounded) answer.carrier = carrier(first);
    if (answer.status != ProgrammeStatus::kOptimal) return false;
    const std::vector<double>& x = lp_.solution();
    answer.load = x[load_] * load_unit_;
    for (std::size_t k = 0; k < m_.links.a.size(); ++k)
      answer.link_force.push_back(x[static_cast<std::size_t>(first(m_.n_joint)) + k] * u_.force);
    answer.dual.status = answer.status;
    answer.dual.accuracy = answer.accuracy;
    answer.dual.load = answer.dual.dissipation = -lp_.dual_objective() * load_unit_;
    return true;
  }

  const Model& m_;
  Units u_;
  double load_unit_;  // [N], or 1 of a factor
  LinearProgramme lp_;
  std::vector<std::vector<Entry>> balance_;  // equations of each block
  std::vector<int> balance_row_;             // of the programme; -1: held
  std::vector<Entry> sum_;
  int load_ = 0;
  std::size_t slack_ = 0;

 private:
  template <class First>
  [[nodiscard]] int carrier(const First& first) const {
    const std::vector<double>& ray = lp_.ray();
    int found = -1;
    double most = 0;
    for (int i = 0; i < m_.n_joint + m_.links.n; ++i) {
      const int link = i - m_.n_joint;
      const int begin = link < 0 ? first(i) : first(m_.n_joint) + link;
      const int end = link < 0 ? first(i + 1) : begin + 1;
      for (int k = begin; k < end && k < static_cast<int>(ray.size()); ++k)
        if (std::fabs(ray[k]) > most) most = std::fabs(ray[k]), found = i;
    }
    return found;
  }
};
[[nodiscard]] Units units_of(const Model& model, const LimitLoads& loads, const YieldModel& yield);

struct KinematicSolution {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  double load = 0;
  double dissipation = 0;
  double accuracy = 0;
  std::vector<double> vx, vy, omega;  // per unit velocity of the load
};
[[nodiscard]] KinematicSolution solve_kinematic(const Model& model, const LimitLoads& loads,
                                                const YieldModel& yield, const Units& units,
                                                const Monitor& monitor = {});

// What a static programme gives in the plane or in space.
template <class Mechanism>
struct CommonStaticSolution {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  double load = 0;
  Mechanism dual;                  // multipliers of the balance are velocities of a mechanism
  std::vector<double> link_force;  // (n_link) [N], tension +
  double accuracy = 0;
  double error = 0;  // of the load, to first order
  // of a load without limit: the joint that carries most of it, links after joints; -1: unknown
  int carrier = -1;
  int rows = 0, columns = 0;
};
struct StaticSolution : CommonStaticSolution<KinematicSolution> {
  std::vector<double> shear;        // (n_joint) [N]
  std::vector<double> point_force;  // (n_joint x points) [N], compression +
};
// Solves the static programme; adds tangents to `yield` until its stress blocks hold.
[[nodiscard]] StaticSolution solve_static(const Model& model, const LimitLoads& loads,
                                          YieldModel& yield, const Units& units,
                                          const Monitor& monitor = {},
                                          const Tolerance& tolerance = kExact);

// Whether forces without the growing load balance every block.
[[nodiscard]] ProgrammeStatus find_rest(const Model& model, const LimitLoads& loads,
                                        const YieldModel& yield, const Units& units,
                                        const Monitor& monitor);

[[nodiscard]] Unbalanced find_unbalanced(const Model& model, const LimitLoads& loads,
                                         const YieldModel& yield, const Units& units,
                                         const Monitor& monitor = {});

}  // namespace wythe::limit
