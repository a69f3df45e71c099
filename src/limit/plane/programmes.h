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

// Solves a programme of Purpose::kRest, of a wall in the plane or in space. kFailed: too much is left unbalanced to tell.
[[nodiscard]] inline ProgrammeStatus solve_rest(LinearProgramme& programme,
                                                const Monitor& monitor) {
  const ProgrammeStatus found = programme.solve(monitor);
  const bool is_unsure = found == ProgrammeStatus::kOptimal && programme.residual() >= kBalanced;
  return is_unsure ? ProgrammeStatus::kFailed : found;
}

struct Units {
  double force = 1, length = 1;
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

struct StaticSolution {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  double load = 0;
  KinematicSolution dual;           // multipliers of the balance are velocities of a mechanism
  std::vector<double> shear;        // (n_joint) [N]
  std::vector<double> point_force;  // (n_joint x points) [N], compression +
  std::vector<double> link_force;   // (n_link) [N], tension +
  std::vector<double> ray;          // of the columns, for a load without limit
  double accuracy = 0;
  double error = 0;  // of the load, to first order
  int rows = 0, columns = 0;
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

// The block with the largest unbalanced force without a growing load [N]; -1: all are in equilibrium, if solved.
struct Unbalanced {
  ProgrammeStatus status = ProgrammeStatus::kFailed;
  BlockId block = -1;
  double force = 0;
};
[[nodiscard]] Unbalanced find_unbalanced(const Model& model, const LimitLoads& loads,
                                         const YieldModel& yield, const Units& units,
                                         const Monitor& monitor = {});

}  // namespace wythe::limit
