#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace wythe::app {
namespace {

constexpr int kBarWidth = 30;
constexpr double kPlainEvery = 5.0;  // seconds between plain lines

std::string time_left(double elapsed, double share) {
  if (share < 0.01) return "";
  const double left = elapsed * (1 - share) / share;
  return left < 90 ? fmt::format(", {:.0f} s left", left)
                   : fmt::format(", {:.0f} min left", left / 60);
}

}  // namespace

ProgressPrinter::ProgressPrinter(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressPrinter::~ProgressPrinter() {
  if (drawn_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void ProgressPrinter::operator()(const Progress& p) {
  if (quiet_) return;
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string text =
      fmt::format("{:3.0f} %  {}  {:.2f} mm  {:.1f} kN{}", 100 * p.share, p.stage,
                  1e3 * p.displacement, 1e-3 * p.reaction, time_left(elapsed, p.share));
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(p.share * kBarWidth);
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    fmt::print(stderr, "\r\x1b[K[{}] {}", bar, text);
  } else if (std::chrono::duration<double>(now - last_).count() >= kPlainEvery) {
    fmt::print(stderr, "{}\n", text);
    last_ = now;
  }
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace wythe::app
