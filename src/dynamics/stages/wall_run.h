// One wall in its stages, a step at a time. The caller decides which executor steps it, alone or with others.
//
//   WallRun run(model, state, options, place);
//   while (!run.ended()) run.after_step(step(run.next()));
//   Result result = run.finish();
#pragma once

#include <chrono>

#include "dynamics/stages/stage_run.h"

namespace wythe::dynamics {

class WallRun {
 public:
  // `options` have to live as long as the run, and the executor has to be ready. `so_far`: the results
  // of the steps that led to the state. Without it, the results cover only the rest of the run.
  WallRun(const Model& model, State& state, const SolveOptions& options,
          std::unique_ptr<WallAccess> access, RunRecord so_far = {});
  WallRun(const WallRun&) = delete;
  WallRun& operator=(const WallRun&) = delete;

  [[nodiscard]] bool ended() const { return !stage_; }
  // Controls of the next step.
  const Controls& next();
  // Called after the step, with the reaction of the drive.
  void after_step(double reaction);
  // Continues with another executor, which holds the same state.
  void move_to(std::unique_ptr<WallAccess> access);
  // Evaluates the curve; call once, at the end.
  Result finish();

 private:
  [[nodiscard]] bool is_of_supports() const;
  void start_stages();
  void close_stage();
  void poll_caller();
  [[nodiscard]] double seconds() const;

  const Model& model_;
  State& state_;
  SolveOptions options_;
  RunRecord record_;
  StageContext wall_;
  std::unique_ptr<StageRun> stage_;
  std::chrono::steady_clock::time_point start_;
  double seconds_before_;  // seconds of earlier parts of the run
};

// solve() without the name of its failure mode, which `judge` adds.
[[nodiscard]] Result run_stages(const Model& model, State& state, const SolveOptions& options = {},
                                RunRecord so_far = {});

}  // namespace wythe::dynamics
