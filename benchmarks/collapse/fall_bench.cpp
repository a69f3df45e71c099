// What a step of a wall costs while it stands, while it falls, and as a pile: in the plane and in space, all of one run.
//
//   fall_bench [THREADS] -> JSON: of each model and moment ms a step, joints left, pairs in touch, hash of the state
//
// A dry wall of 3 000 blocks settles; then its base is accelerated until it cannot stand, and it is followed until its
// blocks lie on each other. A step is timed over a tenth of a second of the wall's time, on the way: the least of three
// runs from the same state, by the processor's time on one thread and by the clock on several. Collapse is no reason to stop
// here, so that the steps are taken without stages. Called by tools/bench.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/executors/executor.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"

namespace {

using namespace wythe;

constexpr double kG = 9.81, kTimed = 0.1;  // [m/s^2], [s]
constexpr int kRuns = 3;

struct FallingWall {
  const char* model;
  double State::*gravity;      // the component that the base's acceleration joins
  double acceleration, until;  // [g], [s]
  std::vector<std::pair<const char*, double>> moment;  // when the timing begins [s]
};
const std::vector<FallingWall>& falls() {
  static const std::vector<FallingWall> all = {
      {"falling_tower.toml",
       &State::gravity_x,
       0.6,
       1.5,
       {{"falling, 0.5 s", 0.5},
        {"falling, 1.5 s", 1.5},
        {"falling, 2.25 s", 2.25},
        {"pile", 4.0}}},
      {"falling_wall.toml",
       &State::gravity_z,
       0.3,
       1.0,
       {{"falling, 0.5 s", 0.5}, {"falling, 1.4 s", 1.4}, {"pile", 2.5}}}};
  return all;
}

class Timed {
 public:
  Timed(const FallingWall& fall, int threads)
      : fall_(fall),
        model_(compile(read_model(std::string(WYTHE_SOURCE_DIR "/benchmarks/") + fall.model))),
        state_(initial_state(model_)),
        threads_(threads),
        executor_(dynamics::processor_for(model_, 1, threads)) {
    executor_->load_wall(0, model_, state_);
  }

  void run() {
    state_.gravity_y = -kG;
    damp(0.8);
    step_for(0.4);
    damp(0.1);
    time_moment("standing");
    const double start = now_;
    const auto after = [&](double t) { return start + t; };
    state_.*fall_.gravity = fall_.acceleration * kG;
    for (const auto& [name, begin] : fall_.moment) {
      if (now_ < after(fall_.until) && begin >= fall_.until) step_for(after(fall_.until) - now_);
      if (begin >= fall_.until) state_.*fall_.gravity = 0;
      step_for(after(begin) - now_);
      time_moment(name);
    }
  }

 private:
  void damp(double lambda) {
    controls_.damping = lambda;
    controls_.dt = model_.solve.step_fraction * 2 / (model_.omega_max * std::sqrt(1 + lambda));
    executor_->set(0, controls_);
  }
  [[nodiscard]] double clock() const {
    if (threads_ == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  }
  long step_for(double time) {
    const long steps = std::max(0L, std::lround(time / controls_.dt));
    for (long k = 0; k < steps; ++k) executor_->step();
    now_ += static_cast<double>(steps) * controls_.dt;
    return steps;
  }
  void time_moment(const char* name) {
    executor_->access(0)->store_state(state_);
    const State before = state_;
    const double start = now_;
    double seconds = 1e300;
    long steps = 0;
    for (int run = 0; run < kRuns; ++run) {
      now_ = start;
      state_ = before;
      executor_->load_wall(0, model_, state_);
      executor_->set(0, controls_);
      const double begin = clock();
      steps = step_for(kTimed);
      seconds = std::min(seconds, clock() - begin);
    }
    executor_->access(0)->store_state(state_);
    std::size_t joints = 0, touching = 0;
    for (const double gone : state_.handed_over) joints += gone == 0 ? 1 : 0;
    for (const FreeContact& c : state_.free_contacts) touching += c.area > 0 ? 1 : 0;
    fmt::print(
        "{}{{\"model\": \"{}\", \"moment\": \"{}\", \"blocks\": {}, \"ms\": {:.4f}, \"joints\": "
        "{}, "
        "\"free_contacts\": {}, \"state\": \"{}\"}}",
        first_ ? "" : ",\n ", fall_.model, name, model_.n_block,
        1e3 * seconds / static_cast<double>(steps), joints, touching, state_hash(state_));
    std::fflush(stdout);
    first_ = false;
  }

  static inline bool first_ = true;
  const FallingWall& fall_;
  const Model model_;
  State state_;
  const int threads_;
  std::unique_ptr<dynamics::Executor> executor_;
  dynamics::Controls controls_;
  double now_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    const int threads = argc > 1 ? std::atoi(argv[1]) : 1;
    fmt::print("[");
    for (const FallingWall& fall : falls()) Timed(fall, threads).run();
    fmt::print("]\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "fall_bench: {}\n", e.what());
    return 1;
  }
}
