// Workers that solve samples: one for each core, with as many walls side by side as its lanes hold.
//
//   task.take() ──► lanes ──► task.keep(job), until take() gives 0 or `halt` is set
//
// The caller chooses the samples and stores the results (in a store: campaign.cpp; in memory: batch.cpp). Each
// sample gets its share of the core time of its pack. Its bits do not depend on this, nor on jobs, lanes or order.
#pragma once

#include <atomic>
#include <functional>

#include "campaign/runner/sample_run.h"

namespace wythe::study {

struct PoolTask {
  SampleTask samples;
  int left = 0;                          // number of samples that take() can still give
  int jobs = 0;                          // number of workers; 0: one for each core
  std::atomic<bool>& halt;               // true: stop now; the pool sets it if a worker fails
  std::function<void()> poll;            // called a few times a second, to see whether to halt
  std::function<int()> take;             // the next sample, from 1; 0: there is none
  std::function<void(SampleJob&)> keep;  // called with each sample that has ended
};

// How many workers solve_samples() starts.
[[nodiscard]] int workers_of(const PoolTask& task);

// Several workers call poll(), take() and keep() at once. Returns when all workers have
// ended, and throws the first failure. Samples that are running at a stop are dropped.
void solve_samples(const PoolTask& task);

}  // namespace wythe::study
