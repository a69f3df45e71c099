// solve(Model, State&) -> Result: runs the stages from the current state.
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
  double share = 0;         // of the steps of the whole run [0, 1]
  double displacement = 0;  // [m]
  double reaction = 0;      // [N]
};

struct SolveOptions {
  int threads = 1;               // within one wall; any number gives the same bits
  int frames = 0;                // number of KeptStates::frames of a push, for pictures
  double read_modes_at = 40e-3;  // displacement at which the state for the
                                 // failure mode is stored [m]
  std::int64_t step_budget = 0;  // most steps, then budget_spent; 0: no limit
  // Gets state and record every few hundred steps, and once more (`ends`) where an interrupt or a spent budget
  // ends the run. With a copy of both, solve() continues with the same bits.
  std::function<void(const State&, const RunRecord&, bool ends)> checkpoint;
  const std::atomic<bool>* stop = nullptr;        // set by a signal handler: interrupted
  std::function<void(const Progress&)> progress;  // at each stage's start, a few times a second
};

// Runs the stages, advances `state` to the end and names the failure mode. A failure of the computation does not throw: it is the
// status of the result. To continue a run, pass the state and the record that
// SolveOptions::checkpoint received: the result is that of the whole run. Without the record it covers only the
// rest.
[[nodiscard]] Result solve(const Model& model, State& state, const SolveOptions& options = {},
                           RunRecord so_far = {});

// The instruction set in use and the number of walls that a core steps side by side, e.g.
// "avx2, 4 walls side by side". The environment variables WYTHE_SIMD and WYTHE_LANES override the choice;
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
