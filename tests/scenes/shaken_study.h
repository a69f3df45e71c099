// A study over records that runs in a second: one rigid block under half sine pulses.
#pragma once

#include <string>

#include "wythe/parts/study.h"

namespace wythe::scenes {

// The text of the study; `shaking` goes under [shaking], `more` to the end. Records: periods of half_cycle pulses [s].
[[nodiscard]] std::string shaken_text(const std::string& shaking,
                                      const std::vector<double>& periods, int samples = 2,
                                      const std::string& more = "");
[[nodiscard]] StudySpec shaken_study(const std::string& shaking, const std::vector<double>& periods,
                                     int samples = 2, const std::string& more = "");

}  // namespace wythe::scenes
