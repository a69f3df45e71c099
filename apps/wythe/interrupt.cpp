#include "interrupt.h"

#include <csignal>

namespace wythe::app {
namespace {

std::atomic<bool> interrupted{false};

void on_interrupt(int) { interrupted.store(true); }

}  // namespace

const std::atomic<bool>& stop_asked() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  return interrupted;
}

}  // namespace wythe::app
