// Ctrl-C and SIGTERM as a flag that long computations look at, and a hold for tests of them.
#pragma once

#include <atomic>
#include <string>

namespace wythe::app {

// While it lives, the first Ctrl-C or SIGTERM sets a flag, so that what was computed is kept; a second
// one, and any before or after, ends the program at once: then there is nothing to keep. SIGTERM twice within
// a second counts once.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  [[nodiscard]] const std::atomic<bool>& asked() const;
};

// Waits once at `point` where WYTHE_TEST_HOLD names it (CONTRIBUTING.md): says "held at POINT" on
// stderr and goes on when the user has asked to stop or standard input has ended.
void hold_for_test(const std::string& point);

}  // namespace wythe::app
