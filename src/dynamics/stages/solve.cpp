// run_stages() and WallRun: runs the stages in order, then evaluates the curve.
#include "wythe/parts/solve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "dynamics/executors/executor.h"
#include "dynamics/meters/balance.h"
#include "dynamics/meters/frame_uses.h"
#include "dynamics/meters/layer_uses.h"
#include "dynamics/meters/residual.h"
#include "dynamics/meters/responses.h"
#include "dynamics/stages/shake.h"
#include "dynamics/stages/wall_run.h"
#include "model/size.h"
#include "reading/free_contacts.h"

namespace wythe {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Scales a stage's share of progress to the whole run, by expected steps.
class ProgressScale {
 public:
  explicit ProgressScale(const Model& model) {
    for (const Stage& stage : model.stages) {
      const double steps = pace_of(stage.spec).seconds / dynamics::stage_time_step(model, stage);
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

// Forwards the first progress message of each stage, then only a few messages a second.
std::function<void(const Progress&)> throttled(const Model& model, const State& state,
                                               const SolveOptions& options) {
  if (!options.progress) return {};
  const ProgressScale scale(model);
  return [scale, &state, &options, last = Clock::now(), stage = -1](const Progress& p) mutable {
    if (state.stage == stage && seconds_since(last) < 0.2) return;
    stage = static_cast<int>(state.stage);
    last = Clock::now();
    Progress shown = p;
    shown.share = scale.overall(static_cast<std::size_t>(state.stage), p.share);
    options.progress(shown);
  };
}

}  // namespace

namespace dynamics {

WallRun::WallRun(const Model& model, State& state, const SolveOptions& options,
                 std::unique_ptr<WallAccess> access, RunRecord so_far)
    : model_(model),
      state_(state),
      options_(options),
      record_(std::move(so_far)),
      wall_{model, state, options_, record_, std::move(access), {}},
      start_(Clock::now()),
      seconds_before_(record_.result.wall_seconds) {
  options_.progress = throttled(model, state, options);
  start_stages();
}

// Starts the next stage that takes a step, if any.
void WallRun::start_stages() {
  while (!stage_ && static_cast<std::size_t>(state_.stage) < model_.stages.size()) {
    const Stage& stage = model_.stages[state_.stage];
    record_.result.time_step = stage_time_step(model_, stage);
    stage_ = StageRun::start(wall_, stage);
    if (!stage_->ended()) return;
    close_stage();  // the stage has nothing to do
  }
}

void WallRun::close_stage() {
  const StageEnd end = stage_->close();
  stage_.reset();
  record_.result.status = end.status;
  record_.result.reason = end.reason;
  if (!end.finished) return;
  ++state_.stage;
  state_.progress.time = 0;
}

const Controls& WallRun::next() {
  stage_->prepare();
  return wall_.controls;
}

double WallRun::seconds() const { return seconds_before_ + seconds_since(start_); }

// Handles the caller's checkpoint, an interrupt and the step budget. This comes
// last in a step, so that a run that is cut here and continued gives the same.
void WallRun::poll_caller() {
  const bool asked = options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  const bool spent = options_.step_budget > 0 && state_.step >= options_.step_budget;
  if (options_.checkpoint && (asked || spent || state_.step % kCheckEvery == 0)) {
    wall_.access->store_state(state_);
    record_.result.wall_seconds = seconds();
    options_.checkpoint(state_, record_, asked || spent);
  }
  if (asked)
    stage_->end({SolveStatus::kInterrupted,
                 {"stop.by_user",
                  {{"stage", model_.stages[state_.stage].spec.name}, {"time_s", state_.time}}},
                 false});
  else if (spent)
    stage_->end(
        {SolveStatus::kBudgetSpent, {"stop.budget_spent", {{"steps", state_.step}}}, false});
}

void WallRun::after_step(double reaction) {
  stage_->after_step(reaction);
  if (!stage_->ended()) poll_caller();
  if (!stage_->ended()) return;
  const int stage = state_.stage;
  close_stage();
  if (state_.stage > stage) start_stages();
}

void WallRun::move_to(std::unique_ptr<WallAccess> access) {
  wall_.access = std::move(access);
  if (stage_) wall_.access->choose_driven(stage_->driven());
}

// Whether the curve, which belongs to the last push so far, is of driven supports.
bool WallRun::is_of_supports() const {
  for (int k = std::min(state_.stage, static_cast<int>(model_.stages.size()) - 1); k >= 0; --k) {
    const Stage& stage = model_.stages[k];
    if (stage.spec.kind() == StageKind::kPush) return drives_supports(model_, stage);
  }
  return false;
}

Result WallRun::finish() {
  Result& result = record_.result;
  result.responses = read_responses(result.curve, reading_of(model_, result));
  evaluate_shaking(model_, result);
  result.quasi_static = judge_quasi_static(result, is_of_supports());
  result.top_displacement = top_displacement(model_, state_);
  result.debris = reading::evaluate_debris(model_, state_);
  result.steps = state_.step;
  result.state_hash = state_hash(state_);
  add_curve_events(result);
  result.strengthening.frame_uses = evaluate_frame_uses(model_, result);
  result.strengthening.layer_uses = evaluate_layer_uses(model_, result);
  result.wall_seconds = seconds();
  return std::move(result);
}

Result run_stages(const Model& model, State& state, const SolveOptions& options, RunRecord so_far) {
  const auto processor = processor_for(model, 1, std::max(1, options.threads));
  processor->load_wall(0, model, state);
  WallRun run(model, state, options, processor->access(0), std::move(so_far));
  while (!run.ended()) {
    processor->set(0, run.next());
    processor->step();
    run.after_step(processor->reaction(0));
  }
  processor->unload_wall(0);
  return run.finish();
}

}  // namespace dynamics

namespace {

// Processor seconds of this thread. Other threads and processes do not count.
double processor_seconds() {
  timespec now{};
  // WebAssembly has no clock for a thread
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Gives every block its own velocity, so that each joint soon opens or slides by more than it does before it cracks.
void shake_loose(double dt, State& state) {
  constexpr double kFar = 1e-4;           // [m]; joints crack at some 1e-5
  constexpr int kSteps = 30;              // steps for this displacement
  constexpr double kGolden = 0.61803399;  // no two neighbours get the same velocity
  double turn = 0;
  for (std::vector<double>* velocity : {&state.vx, &state.vy, &state.vz})
    for (double& v : *velocity) {
      turn += kGolden;
      turn -= std::floor(turn);
      v = kFar / (kSteps * dt) * (2 * turn - 1);
    }
}

// Processor seconds for one step of a stage, with recording and checks; 0 where the stage ends at once.
double step_seconds(const Model& model, std::size_t stage) {
  constexpr int kBefore = 20, kSteps = 200;  // steps before measuring, and steps measured
  constexpr double kLongest = 0.3;           // [s], of a large wall
  State state = initial_state(model);
  state.stage = static_cast<int>(stage);
  shake_loose(dynamics::stage_time_step(model, model.stages[stage]), state);
  const auto processor = dynamics::processor_for(model, 1);
  processor->load_wall(0, model, state);
  dynamics::WallRun run(model, state, {}, processor->access(0), {});
  const auto step = [&] {
    if (run.ended() || state.stage != static_cast<int>(stage)) return false;
    processor->set(0, run.next());
    processor->step();
    run.after_step(processor->reaction(0));
    return true;
  };
  double start = processor_seconds(), last = start;
  for (int i = 0; i < kBefore && last - start < kLongest && step(); ++i) last = processor_seconds();
  start = last;
  int counted = 0;
  while (counted < kSteps && last - start < kLongest && step()) {
    ++counted;
    last = processor_seconds();
  }
  processor->unload_wall(0);
  return counted > 0 ? (last - start) / counted : 0;
}

}  // namespace

RunEstimate estimate(const Model& model) {
  RunEstimate e;
  double steps = 0;
  std::vector<double> own, each;  // of a stage: steps, seconds of a step
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    e.time_step = dynamics::stage_time_step(model, model.stages[i]);
    own.push_back(pace_of(model.stages[i].spec).seconds / e.time_step);
    each.push_back(step_seconds(model, i));
    steps += own.back();
  }
  const double dearest = each.empty() ? 0 : *std::max_element(each.begin(), each.end());
  for (std::size_t i = 0; i < own.size(); ++i)
    e.seconds += own[i] * (each[i] > 0 ? each[i] : dearest);
  constexpr double kMostSteps = 9e18;  // the largest number of steps that the result can hold
  e.steps = static_cast<std::int64_t>(steps < kMostSteps ? steps : kMostSteps);
  return e;
}

}  // namespace wythe
