// Runs one stage: sets the controls of every step, watches settling, stop criteria and collapse.
//
//   gravity, load   ramp with a smooth start, then settle below settle_ratio
//   push            smooth start to the velocity, along one or several target displacements
//   body force      lambda grows only while the unbalance is below settle_ratio: the largest carried
//   tilt            the same with the direction of gravity
//   hold            nothing new for a duration
#pragma once

#include "dynamics/recorder.h"
#include "dynamics/step.h"
#include "wythe/solve.h"

namespace wythe::dynamics {

// How a stage ended.
struct StageEnd {
  SolveStatus status = SolveStatus::kCompleted;
  std::string reason;
  bool finished = true;  // false: the run ends here
};

class StageRunner {
 public:
  StageRunner(const Model& model, State& state, Stepper& stepper, const SolveOptions& options,
              Result& result);
  StageEnd run(const Stage& stage);

 private:
  StageEnd run_quasi_static(const Stage& stage);
  StageEnd run_push(const Stage& stage);
  StageEnd run_factor(const Stage& stage);
  StageEnd run_hold(const Stage& stage);

  void set_ramp(const Stage& stage, double share);
  void set_factor(const Stage& stage, double factor);
  StageEnd watch(const Stage& stage, double share);
  [[nodiscard]] const Stage* push_before(const Stage& stage) const;
  [[nodiscard]] StageEnd unsettled(const Stage& stage, double ratio) const;
  [[nodiscard]] StageEnd standstill(const Stage& stage, double carried, double moved,
                                    double then) const;
  [[nodiscard]] std::string name_of(BlockId block) const;
  [[nodiscard]] double furthest_block(BlockId* block) const;

  const Model& model_;
  State& state_;
  Stepper& stepper_;
  const SolveOptions& options_;
  Result& result_;
  Controls controls_;
};

// Smooth start: 0 at 0, 1 at 1, no slope at either end; 3 x^2 - 2 x^3.
[[nodiscard]] double smooth_step(double x);

// Time step of a stage [s]; quasi-static stages take the mass scaling.
[[nodiscard]] double stage_time_step(const Model& model, const Stage& stage);
[[nodiscard]] double stage_mass_scaling(const Model& model, const Stage& stage);
// Length of the driven path of a push, all targets included [m].
[[nodiscard]] double driven_path(const Stage& stage);

}  // namespace wythe::dynamics
