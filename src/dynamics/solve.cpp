// solve(): the stages in order, then what the curve says.
#include "wythe/solve.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "dynamics/responses.h"
#include "dynamics/stage_runner.h"

namespace wythe {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Scales a stage's own share of progress to the whole run, by expected steps.
class ProgressScale {
 public:
  explicit ProgressScale(const Model& model) {
    for (const Stage& stage : model.stages) {
      const double steps =
          dynamics::expected_seconds(stage) / dynamics::stage_time_step(model, stage);
      total_ += steps;
      until_.push_back(total_);
    }
  }
  [[nodiscard]] double overall(std::size_t stage, double share) const {
    const double before = stage == 0 ? 0.0 : until_[stage - 1];
    return total_ > 0 ? (before + share * (until_[stage] - before)) / total_ : 0.0;
  }

 private:
  double total_ = 0;
  std::vector<double> until_;
};

// Passes progress on a few times a second only.
std::function<void(const Progress&)> throttled(const Model& model, const State& state,
                                               const SolveOptions& options) {
  if (!options.progress) return {};
  const ProgressScale scale(model);
  return [scale, &state, &options, last = Clock::now()](const Progress& p) mutable {
    if (seconds_since(last) < 0.2) return;
    last = Clock::now();
    Progress shown = p;
    shown.share = scale.overall(static_cast<std::size_t>(state.stage), p.share);
    options.progress(shown);
  };
}

double top_displacement(const Model& model, const State& state) {
  double moved = 0;
  const double top = *std::max_element(model.centroid_y.begin(), model.centroid_y.end());
  for (std::size_t i = 0; i < state.ux.size(); ++i)
    if (model.centroid_y[i] > top - 0.01 * model.anatomy.height)
      moved = std::max(moved, std::fabs(state.ux[i]));
  return moved;
}

}  // namespace

Result solve(const Model& model, State& state, const SolveOptions& options) {
  const auto start = Clock::now();
  Result result;
  SolveOptions inner = options;
  inner.progress = throttled(model, state, options);
  dynamics::Stepper stepper(model, std::max(1, options.threads));
  stepper.refresh(state);
  dynamics::StageRunner runner(model, state, stepper, inner, result);
  while (static_cast<std::size_t>(state.stage) < model.stages.size()) {
    const Stage& stage = model.stages[static_cast<std::size_t>(state.stage)];
    result.time_step = dynamics::stage_time_step(model, stage);
    const dynamics::StageEnd end = runner.run(stage);
    result.status = end.status;
    result.reason = end.reason;
    if (!end.finished) break;
    ++state.stage;
    state.stage_time = 0;
  }
  ResponseOptions read;
  if (result.status == SolveStatus::kCollapsed) read.collapse = result.reason;
  result.responses = read_responses(result.curve, read);
  result.quasi_static = dynamics::judge_quasi_static(result);
  result.top_displacement = top_displacement(model, state);
  result.steps = state.step;
  result.state_hash = state_hash(state);
  dynamics::add_curve_events(result);
  result.wall_seconds = seconds_since(start);
  return result;
}

RunEstimate estimate(const Model& model) {
  RunEstimate e;
  double steps = 0;
  for (const Stage& stage : model.stages) {
    e.time_step = dynamics::stage_time_step(model, stage);
    steps += dynamics::expected_seconds(stage) / e.time_step;
  }
  e.steps = static_cast<std::int64_t>(steps);
  // a short trial at rest: the step costs the same whatever the joints do
  constexpr int kTrial = 200;
  State state = initial_state(model);
  dynamics::Stepper stepper(model, 1);
  stepper.refresh(state);
  dynamics::Controls controls;
  controls.dt = e.time_step;
  const auto start = Clock::now();
  for (int k = 0; k < kTrial; ++k) stepper.step(state, controls);
  e.seconds = seconds_since(start) / kTrial * steps;
  return e;
}

}  // namespace wythe
