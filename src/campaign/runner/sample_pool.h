// Workers that solve samples: one a core, each with as many walls side by side as its lanes hold.
//
//   task.take() ──► lanes ──► task.keep(job), until take() gives 0 or `halt` is set
//
// The caller decides which samples there are and where each result goes (a store: campaign.cpp; memory: batch.cpp).
// Each sample gets its share of the core time of its pack. Its bits depend on none of this, nor on jobs, lanes or order.
#pragma once

#include <atomic>
#include <functional>

#include "campaign/runner/sample_run.h"

namespace wythe::study {

struct PoolTask {
  SampleTask samples;
  int left = 0;                          // samples that take() will give
  int jobs = 0;                          // workers; 0: one a core
  std::atomic<bool>& halt;               // true: stop now; set by the pool where a worker fails
  std::function<void()> poll;            // called a few times a second, to see whether to halt
  std::function<int()> take;             // the next sample, from 1; 0: there is none
  std::function<void(SampleJob&)> keep;  // one that has ended
};

// How many workers solve_samples() starts.
[[nodiscard]] int workers_of(const PoolTask& task);

// poll(), take() and keep() are called by several workers at once. Returns when all workers have ended;
// throws what the first failure threw. Samples that were under way at a halt are dropped.
void solve_samples(const PoolTask& task);

}  // namespace wythe::study
