#include "interrupt.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace wythe::app {
namespace {

std::atomic<bool> interrupted{false};

// The second signal takes the default way: nothing makes the program deaf.
void on_interrupt(int signal) {
  interrupted.store(true);
  std::signal(signal, SIG_DFL);
}

constexpr int kLookEvery = 10;  // at the flag, while held [ms]

}  // namespace

StopSignal::StopSignal() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

StopSignal::~StopSignal() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& StopSignal::asked() const { return interrupted; }

void hold_for_test(const std::string& point) {
  static std::atomic<bool> held{false};
  const char* asked = std::getenv("WYTHE_TEST_HOLD");
  if (asked == nullptr || point != asked || held.exchange(true)) return;
  fmt::print(stderr, "held at {}\n", point);
  std::fflush(stderr);
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!interrupted && ::poll(&input, 1, kLookEvery) <= 0) {
  }
}

}  // namespace wythe::app
