// Ctrl-C and SIGTERM as a flag for long computations, and a hold for tests of them.
#pragma once

#include <atomic>
#include <string>

namespace wythe::app {

// While it lives, the first Ctrl-C or SIGTERM sets a flag, so that computed results
// are kept. A second one ends the program at once, and so does any signal outside its
// lifetime, when there is nothing to keep. SIGTERM twice within a second counts once.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  [[nodiscard]] const std::atomic<bool>& asked() const;
};

// Waits once at `point` if WYTHE_TEST_HOLD names it (CONTRIBUTING.md): prints "held at
// POINT" on stderr and continues when the user asks to stop or standard input ends.
void hold_for_test(const std::string& point);

}  // namespace wythe::app
