// Progress on stderr: a bar on a terminal, else a plain line from time to time.
#pragma once

#include <chrono>
#include <string>

#include "wythe/solve.h"
#include "wythe/study.h"

namespace wythe::app {

// "12 s", "3 min", "5 h", "2 days"; "more than a century" for unrealistic times.
[[nodiscard]] std::string duration_text(double seconds);

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

// The same for a limit analysis: the present task, and the share of all tasks.
class LimitPrinter {
 public:
  explicit LimitPrinter(bool quiet);
  ~LimitPrinter();
  LimitPrinter(const LimitPrinter&) = delete;
  LimitPrinter& operator=(const LimitPrinter&) = delete;
  void operator()(const std::string& what, double share);

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = Clock::now();
};

// The same for a campaign: a line for every sample where there is no terminal.
class CampaignPrinter {
 public:
  explicit CampaignPrinter(bool quiet);
  ~CampaignPrinter();
  CampaignPrinter(const CampaignPrinter&) = delete;
  CampaignPrinter& operator=(const CampaignPrinter&) = delete;
  void operator()(const CampaignProgress& progress);

 private:
  bool quiet_, terminal_, drawn_ = false;
};

}  // namespace wythe::app
