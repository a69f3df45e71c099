// The handler sets a flag, which the library asks for between steps. A second signal ends the program at once.
#include "interrupt.h"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace wythe::app {
namespace {

std::atomic<bool> interrupted{false};

// A second signal has its default effect, so the program can always be ended. Two signals at nearly
// the same time count as one, because schedulers send SIGTERM both to the job and to its process.
void on_interrupt(int signal) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  static std::atomic<std::int64_t> first{0};
  const bool is_first = !interrupted.exchange(true);
  if (is_first) first.store(now.tv_sec);
  if (is_first && signal == SIGTERM) return;
  if (signal == SIGTERM && now.tv_sec <= first.load() + 1) return;
  std::signal(signal, SIG_DFL);
  if (!is_first) std::raise(signal);
}

constexpr int kPollEvery = 10;  // checks of the flag, while held [ms]

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
  while (!interrupted && ::poll(&input, 1, kPollEvery) <= 0) {
  }
}

}  // namespace wythe::app
