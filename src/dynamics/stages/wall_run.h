// One wall on its way through its stages, a step at a time; who steps it, and with whom, is open.
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
  // `options` have to live as long as the run; the place is ready to be stepped. `so_far`: of the steps
  // that brought the state where it is; without it the run tells of the rest alone.
  WallRun(const Model& model, State& state, const SolveOptions& options,
          std::unique_ptr<WallAccess> access, RunRecord so_far = {});
  WallRun(const WallRun&) = delete;
  WallRun& operator=(const WallRun&) = delete;

  [[nodiscard]] bool ended() const { return !stage_; }
  // What the next step takes.
  const Controls& next();
  // After it, with the reaction of the drive.
  void after_step(double reaction);
  // Goes on elsewhere; the new place holds the same state.
  void move_to(std::unique_ptr<WallAccess> access);
  // What the curve says; call once, at the end.
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
  double seconds_before_;  // of the steps before
};

// solve() without the name of its failure mode, which `judge` adds.
[[nodiscard]] Result run_stages(const Model& model, State& state, const SolveOptions& options = {},
                                RunRecord so_far = {});

}  // namespace wythe::dynamics
