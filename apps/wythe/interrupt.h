// Ctrl-C and SIGTERM as a flag that long computations look at, and a hold for tests of them.
#pragma once

#include <atomic>
#include <string>

namespace wythe::app {

// Set once the user has asked to stop; catches the signals from the first call on.
const std::atomic<bool>& stop_asked();

// Waits once at `point` where WYTHE_TEST_HOLD names it (CONTRIBUTING.md): says "held at POINT" on
// stderr and goes on when the user has asked to stop or standard input has ended.
void hold_for_test(const std::string& point);

}  // namespace wythe::app
