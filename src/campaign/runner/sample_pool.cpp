// Each worker steps its walls in a LaneSolver and adds a wall as soon as another ends. A sample that needs
// another run comes before new samples. The core time of a worker is divided equally among its walls. The
// first worker that fails stops the others, and its exception is thrown again when all have ended.
#include "campaign/runner/sample_pool.h"

#include <time.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "dynamics/executors/lane_solver.h"
#include "wythe/parts/lanes.h"

namespace wythe::study {
namespace {

// Seconds of core time that a thread used since the last call.
class CoreTime {
 public:
  CoreTime() { static_cast<void>(seconds()); }
  double seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    const double before = std::exchange(
        now_, static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec));
    return now_ - before;
  }

 private:
  double now_ = 0;
};

class Pool {
 public:
  explicit Pool(const PoolTask& task) : task_(task) {}

  void run() {
    if (task_.left <= 0) return;
    const int jobs = workers_of(task_);
    lanes_ = lanes_for((task_.left + jobs - 1) / jobs);
    {
      std::vector<std::jthread> workers;
      for (int i = 0; i < jobs && !task_.halt; ++i) workers.emplace_back([this] { work(); });
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void work() {
    try {
      solve_side_by_side();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      task_.halt = true;
    }
  }

  // Solves as many samples at once as fit side by side, and starts the next one when one ends.
  void solve_side_by_side() {
    SolveOptions how;
    how.read_modes_at = read_modes_at(task_.samples.spec);
    how.threads = 1;
    how.stop = &task_.halt;
    // a run reports progress a few times a second, so each worker notices the user's stop
    how.progress = [this](const Progress&) { task_.poll(); };
    std::map<int, std::unique_ptr<SampleJob>> under_way;
    CoreTime spent;
    dynamics::LaneSolver lanes(lanes_);
    const auto start = [&](SampleJob& job) {
      lanes.add_wall(job.sample(), job.model(), job.state(), how);
    };
    while (true) {
      while (lanes.has_room()) {
        const int sample = task_.take();
        if (sample == 0) break;
        auto job = std::make_unique<SampleJob>(task_.samples, sample);
        job->took(spent.seconds());
        if (job->refused())
          task_.keep(*job);
        else
          start(*(under_way[sample] = std::move(job)));
      }
      if (lanes.running() == 0) return;
      dynamics::LaneSolver::Ended ended = lanes.next();
      const double each = spent.seconds() / static_cast<double>(under_way.size());
      for (auto& [sample, wall] : under_way) wall->took(each);
      const auto job = under_way.find(ended.ticket);
      if (ended.result.status == SolveStatus::kInterrupted) return;
      job->second->take(std::move(ended.result));
      if (job->second->wants_another()) {
        start(*job->second);
      } else {
        task_.keep(*job->second);
        under_way.erase(job);
      }
    }
  }

  const PoolTask& task_;
  int lanes_ = 1;  // samples a worker solves side by side
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

int workers_of(const PoolTask& task) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::min(task.jobs > 0 ? task.jobs : cores, task.left);
}

void solve_samples(const PoolTask& task) { Pool(task).run(); }

}  // namespace wythe::study
