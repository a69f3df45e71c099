// The library calls these printers while it works. Each draws over its last line on a terminal, and writes seldom
// elsewhere.
#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "wythe/io.h"

namespace wythe::app {
namespace {

constexpr int kBarWidth = 30;
constexpr double kPlainEvery = 5.0;  // seconds between plain lines

std::string seconds_left(double left) { return ", " + duration_text(left) + " left"; }

std::string time_left(double elapsed, double share) {
  return !(share >= 0.01) ? "" : seconds_left(elapsed * (1 - share) / share) + " at this pace";
}

std::string bar(double share) {
  const auto filled = static_cast<std::size_t>(share * kBarWidth);  // of [0, 1]
  return std::string(filled, '#') + std::string(kBarWidth - filled, '.');
}

// The result of the last sample: peak and mode, or why there is none.
std::string last_sample(const SampleRecord& record) {
  if (!record.shakes.empty()) return fmt::format("  sample {}: {}", record.sample, record.status);
  if (!record.answered())
    return fmt::format("  sample {}: {}{}", record.sample, record.status,
                       record.status == "collapsed" ? " before the push" : "");
  return fmt::format("  sample {}: {:.1f} kN, {}", record.sample,
                     1e-3 * record.responses.peak_reaction, record.failure_mode.name);
}

}  // namespace

std::string duration_text(double seconds) {
  if (!(seconds < 3.2e9)) return "more than a century";
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 90 * 60) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

ProgressPrinter::ProgressPrinter(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressPrinter::~ProgressPrinter() {
  if (drawn_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void ProgressPrinter::operator()(const Progress& progress) {
  if (quiet_) return;
  Progress p = progress;
  p.share = p.share > 0 ? std::min(p.share, 1.0) : 0;  // forecasts may be too short, or NaN
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string text =
      fmt::format("{:3.0f} %  {}  {:.2f} mm  {:.1f} kN{}", 100 * p.share, readable(p.stage),
                  1e3 * p.displacement, 1e-3 * p.reaction, time_left(elapsed, p.share));
  if (terminal_) {
    fmt::print(stderr, "\r\x1b[K[{}] {}", bar(p.share), text);
  } else if (std::chrono::duration<double>(now - last_).count() >= kPlainEvery) {
    fmt::print(stderr, "{}\n", text);
    last_ = now;
  }
  std::fflush(stderr);
  drawn_ = true;
}

LimitPrinter::LimitPrinter(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

LimitPrinter::~LimitPrinter() {
  if (drawn_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void LimitPrinter::operator()(const std::string& what, double share) {
  if (quiet_) return;
  const auto now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const bool due = std::chrono::duration<double>(now - last_).count() >= kPlainEvery;
  if (!terminal_ && !due) return;
  const std::string text =
      fmt::format("{:3.0f} %  {}{}", 100 * share, what, time_left(elapsed, share));
  if (terminal_)
    fmt::print(stderr, "\r\x1b[K[{}] {}", bar(share), text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
  last_ = now;
  drawn_ = true;
}

CampaignPrinter::CampaignPrinter(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

CampaignPrinter::~CampaignPrinter() {
  if (drawn_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void CampaignPrinter::operator()(const CampaignProgress& p) {
  if (quiet_) return;
  std::string text = fmt::format("{} of {} samples", p.done, p.total);
  if (p.rate > 0)
    text += fmt::format("  {:.1f} a minute{}", 60 * p.rate, seconds_left(p.seconds_left));
  if (p.last != nullptr) text += last_sample(*p.last);
  if (terminal_)
    fmt::print(stderr, "\r\x1b[K[{}] {}",
               bar(p.total > 0 ? static_cast<double>(p.done) / p.total : 1), text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace wythe::app
