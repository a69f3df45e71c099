// solve(Model, State&) -> Result: runs the stages from where the state stands.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "wythe/parts/model.h"
#include "wythe/parts/recording.h"
#include "wythe/parts/result.h"

namespace wythe {

struct Progress {
  const char* stage = "";
  double share = 0;         // of the whole run [0, 1], by steps
  double displacement = 0;  // [m]
  double reaction = 0;      // [N]
};

struct SolveOptions {
  int threads = 1;               // inside one wall; same bits for any number
  int frames = 0;                // of the push in Result::frames; for pictures
  double read_modes_at = 40e-3;  // displacement at which a state is kept for the
                                 // failure mode [m]
  std::int64_t step_budget = 0;  // stop with budget_spent after so many, 0: none
  // Sees state and record every few hundred steps, and once more where an interrupt or a spent budget
  // `ends` the run: with a copy of both, solve() goes on and gives the same bits.
  std::function<void(const State&, const RunRecord&, bool ends)> checkpoint;
  const std::atomic<bool>* stop = nullptr;        // set from a signal handler: interrupted
  std::function<void(const Progress&)> progress;  // first of each stage, then a few times a second
};

// Runs the stages, advances `state` to the end and names the failure mode. Does not throw when the computation fails: the
// status of the result says what happened. To go on with a run, give the state and the record that
// SolveOptions::checkpoint saw: the result is that of the whole run. Without the record it is that of
// the rest.
[[nodiscard]] Result solve(const Model& model, State& state, const SolveOptions& options = {},
                           RunRecord so_far = {});

// The instruction set in use and how many walls of a campaign a core steps side by side, e.g.
// "avx2, 4 walls side by side". The environment variables WYTHE_SIMD and WYTHE_LANES choose others;
// throws InputError where the machine does not have them.
[[nodiscard]] std::string instruction_set();

// Expected steps and time of a run, for `wythe check`.
struct RunEstimate {
  double time_step = 0;  // [s]
  std::int64_t steps = 0;
  double seconds = 0;  // on this machine, from a short trial
};
[[nodiscard]] RunEstimate estimate(const Model& model);

}  // namespace wythe
