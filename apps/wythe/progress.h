// Progress on stderr: a bar on a terminal, a plain line now and then otherwise.
#pragma once

#include <chrono>

#include "wythe/solve.h"

namespace wythe::app {

class ProgressPrinter {
 public:
  explicit ProgressPrinter(bool quiet);
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;
  void operator()(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = Clock::now();
};

}  // namespace wythe::app
