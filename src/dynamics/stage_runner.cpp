#include "dynamics/stage_runner.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/real.h"

namespace wythe::dynamics {
namespace {

constexpr int kSettleEvery = 50;  // steps between looks at the unbalance
constexpr int kWatchEvery = 500;  // steps between looks at collapse, interrupt, budget

}  // namespace

double smooth_step(double x) {
  const double c = clip(x, 0.0, 1.0);
  return c * c * (3.0 - 2.0 * c);
}

double stage_mass_scaling(const Model& model, const Stage& stage) {
  const bool quasi_static =
      stage.spec.kind == StageKind::kGravity || stage.spec.kind == StageKind::kLoad;
  return quasi_static ? model.solve.mass_scaling : 1.0;
}

double stage_time_step(const Model& model, const Stage& stage) {
  return model.solve.step_fraction * 2.0 / model.omega_max *
         std::sqrt(stage_mass_scaling(model, stage));
}

double driven_path(const Stage& stage) {
  if (stage.spec.targets.empty()) return stage.spec.until;
  double path = 0, at = 0;
  for (const double target : stage.spec.targets) {
    path += std::fabs(target - at);
    at = target;
  }
  return path;
}

StageRunner::StageRunner(const Model& model, State& state, Stepper& stepper,
                         const SolveOptions& options, Result& result)
    : model_(model), state_(state), stepper_(stepper), options_(options), result_(result) {}

StageEnd StageRunner::run(const Stage& stage) {
  controls_ = {};
  controls_.dt = stage_time_step(model_, stage);
  controls_.mass_scaling = stage_mass_scaling(model_, stage);
  controls_.damping = stage.spec.damping;
  stepper_.choose_driven(stage.driven);
  const std::int64_t first = state_.step;
  StageEnd end;
  switch (stage.spec.kind) {
    case StageKind::kGravity:
    case StageKind::kLoad: end = run_quasi_static(stage); break;
    case StageKind::kPush: end = run_push(stage); break;
    case StageKind::kBodyForce:
    case StageKind::kTilt: end = run_factor(stage); break;
    case StageKind::kHold: end = run_hold(stage); break;
  }
  result_.stages.push_back({stage.spec.name, state_.stage_time, state_.step - first,
                            unbalance_ratio(model_, stepper_.workspace()),
                            end.status == SolveStatus::kCompleted});
  result_.energy = energy_ledger(model_, state_, controls_.mass_scaling);
  return end;
}

void StageRunner::set_ramp(const Stage& stage, double share) {
  if (stage.spec.kind == StageKind::kGravity) {
    state_.gravity_x = 0;
    state_.gravity_y = -model_.solve.gravity * share;
  } else {
    state_.load_scale[static_cast<std::size_t>(state_.stage)] = share;
  }
}

StageEnd StageRunner::run_quasi_static(const Stage& stage) {
  const double ramp = stage.spec.ramp;
  const double limit = ramp + model_.solve.settle_limit;
  while (true) {
    set_ramp(stage, smooth_step((state_.stage_time + controls_.dt) / ramp));
    stepper_.step(state_, controls_);
    if (state_.stage_time >= ramp && state_.step % kSettleEvery == 0) {
      const double ratio = unbalance_ratio(model_, stepper_.workspace());
      if (ratio < model_.solve.settle_ratio) return {};
      if (state_.stage_time > limit) return unsettled(stage, ratio);
    }
    if (state_.step % kWatchEvery == 0) {
      const StageEnd watched = watch(stage, 0);
      if (!watched.finished) return watched;
    }
  }
}

StageEnd StageRunner::unsettled(const Stage& stage, double ratio) const {
  return {SolveStatus::kNotSettled,
          fmt::format(
              "stage \"{}\" did not settle: unbalance ratio {:.2g} after {:.3g} s, wanted {:.2g}",
              stage.spec.name, ratio, state_.stage_time, model_.solve.settle_ratio),
          false};
}

StageEnd StageRunner::run_push(const Stage& stage) {
  const std::vector<double> targets =
      stage.spec.targets.empty() ? std::vector<double>{stage.spec.until} : stage.spec.targets;
  const double path = driven_path(stage);
  Recorder recorder(model_, stage, path, options_.frames, result_);
  controls_.push = &stage;
  if (state_.stage_time == 0) state_.drive_displacement = state_.travelled = state_.turn_time = 0;
  StageEnd end;
  while (static_cast<std::size_t>(state_.target) < targets.size() && end.finished) {
    const double target = targets[static_cast<std::size_t>(state_.target)];
    const double sense = target >= state_.drive_displacement ? 1.0 : -1.0;
    const double start =
        smooth_step((state_.stage_time - state_.turn_time + controls_.dt) / stage.spec.ramp);
    controls_.drive_velocity = sense * stage.spec.velocity * start;
    const DriveForce drive = stepper_.step(state_, controls_);
    state_.travelled += std::fabs(controls_.drive_velocity) * controls_.dt;
    recorder.take(stepper_, state_, controls_, drive.reaction, state_.drive_displacement, 0,
                  state_.travelled);
    if (sense * (state_.drive_displacement - target) >= 0) {
      ++state_.target;
      state_.turn_time = state_.stage_time;
    }
    if (state_.step % kWatchEvery == 0) end = watch(stage, state_.travelled / path);
    if (recorder.row_closed() && stage.spec.stop_below > 0 && recorder.fell_below())
      end = {SolveStatus::kCollapsed,
             fmt::format("the reaction fell below {:g} of its peak at {:.2f} mm",
                         stage.spec.stop_below, 1e3 * state_.drive_displacement),
             false};
  }
  if (end.finished) state_.target = 0;
  controls_.push = nullptr;
  recorder.finish(stepper_, state_, controls_);
  return end;
}

void StageRunner::set_factor(const Stage& stage, double factor) {
  const double g = model_.solve.gravity;
  if (stage.spec.kind == StageKind::kTilt) {
    const SinCos<double> tilt = sin_cos(factor);
    state_.gravity_x = g * tilt.sin * stage.drive_x;
    state_.gravity_y = -g * tilt.cos;
  } else {
    state_.gravity_x = g * factor * stage.drive_x;
    state_.gravity_y = -g;
  }
  state_.body_factor = factor;
}

StageEnd StageRunner::run_factor(const Stage& stage) {
  const bool tilting = stage.spec.kind == StageKind::kTilt;
  const double rate = tilting ? stage.spec.tilt_rate : stage.spec.rate;
  const double last = tilting ? stage.spec.tilt_until : stage.spec.factor;
  Recorder recorder(model_, stage, last, options_.frames, result_);
  const double balanced = model_.solve.settle_ratio;
  double factor = state_.body_factor;
  double last_growth = state_.stage_time, moved_then = furthest_block(nullptr);
  StageEnd end;
  while (factor < last && end.finished) {
    // The factor grows only while the wall is in balance; at collapse it stands still.
    const double share = smooth_step(2.0 - state_.balance / balanced);
    factor += rate * share * smooth_step((state_.stage_time + controls_.dt) / stage.spec.ramp) *
              controls_.dt;
    set_factor(stage, std::min(factor, last));
    stepper_.step(state_, controls_);
    const double moved = furthest_block(nullptr);
    const double carried = tilting ? std::tan(factor) : factor;
    recorder.take(stepper_, state_, controls_, carried * model_.weight, moved, carried, factor);
    if (state_.step % kSettleEvery == 0) {
      state_.balance = unbalance_ratio(model_, stepper_.workspace());
      if (share > 0) {
        state_.load_factor = carried;
        last_growth = state_.stage_time;
        moved_then = moved;
      }
    }
    if (state_.stage_time - last_growth > model_.solve.settle_limit)
      end = standstill(stage, carried, moved, moved_then);
    else if (state_.step % kWatchEvery == 0)
      end = watch(stage, factor / last);
  }
  recorder.finish(stepper_, state_, controls_);
  result_.load_factor = state_.load_factor;
  if (end.status == SolveStatus::kCollapsed)
    end.reason = fmt::format("{}; the largest load factor carried is {:.4f}", end.reason,
                             result_.load_factor);
  return end;
}

// The factor has not grown for the settling limit: a mechanism creeps on, or the wall trembles.
StageEnd StageRunner::standstill(const Stage& stage, double carried, double moved,
                                 double then) const {
  if (moved > 1.05 * then)
    return {SolveStatus::kCollapsed,
            fmt::format("the wall keeps moving at the load factor {:.4f} in stage \"{}\"", carried,
                        stage.spec.name),
            false};
  return {SolveStatus::kNotSettled,
          fmt::format("the wall neither settles nor collapses at load factor {:.4f}", carried),
          false};
}

// The last push before a stage, or null.
const Stage* StageRunner::push_before(const Stage& stage) const {
  const Stage* last = nullptr;
  for (const Stage& other : model_.stages) {
    if (&other == &stage) break;
    if (other.spec.kind == StageKind::kPush) last = &other;
  }
  return last;
}

// Nothing new: loads stay, and what an earlier push drives stays where it is.
StageEnd StageRunner::run_hold(const Stage& stage) {
  if (const Stage* push = push_before(stage)) {
    stepper_.choose_driven(push->driven);
    controls_.push = push;
  }
  while (state_.stage_time < stage.spec.duration) {
    stepper_.step(state_, controls_);
    if (state_.step % kWatchEvery != 0) continue;
    const StageEnd end = watch(stage, state_.stage_time / stage.spec.duration);
    if (!end.finished) return end;
  }
  return {};
}

double StageRunner::furthest_block(BlockId* block) const {
  double furthest = 0;
  for (std::size_t i = 0; i < state_.ux.size(); ++i) {
    const double moved = state_.ux[i] * state_.ux[i] + state_.uy[i] * state_.uy[i];
    if (moved <= furthest) continue;
    furthest = moved;
    if (block != nullptr) *block = static_cast<BlockId>(i);
  }
  return std::sqrt(furthest);
}

// Interrupt, budget, instability, and collapse: a block farther off than the push can have brought it.
StageEnd StageRunner::watch(const Stage& stage, double share) {
  const double allowed = std::fabs(state_.drive_displacement) + model_.solve.collapse_displacement;
  if (options_.progress)
    options_.progress({stage.spec.name.c_str(), share, state_.drive_displacement,
                       result_.curve.empty() ? 0.0 : result_.curve.back().reaction});
  const BlockId runaway = runaway_block(state_);
  if (runaway >= 0)
    return {
        SolveStatus::kUnstable,
        fmt::format("block {} runs away at {:.4g} s in stage \"{}\": the step is too large; lower "
                    "solve.step_fraction",
                    model_.anatomy.block_id[static_cast<std::size_t>(runaway)], state_.time,
                    stage.spec.name),
        false};
  BlockId block = 0;
  const double moved = furthest_block(&block);
  if (moved > allowed)
    return {SolveStatus::kCollapsed,
            fmt::format("block {} has moved {:.0f} mm in stage \"{}\"",
                        model_.anatomy.block_id[static_cast<std::size_t>(block)], 1e3 * moved,
                        stage.spec.name),
            false};
  if (options_.stop != nullptr && options_.stop->load())
    return {SolveStatus::kInterrupted,
            fmt::format("stopped by the user in stage \"{}\" at {:.3f} s", stage.spec.name,
                        state_.time),
            false};
  if (options_.step_budget > 0 && state_.step >= options_.step_budget)
    return {SolveStatus::kBudgetSpent, fmt::format("{} steps spent", state_.step), false};
  return {};
}

}  // namespace wythe::dynamics
