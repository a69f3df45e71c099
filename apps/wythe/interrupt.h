// Ctrl-C and SIGTERM as a flag that long computations look at.
#pragma once

#include <atomic>

namespace wythe::app {

// Set once the user has asked to stop; catches the signals from the first call on.
const std::atomic<bool>& stop_asked();

}  // namespace wythe::app
