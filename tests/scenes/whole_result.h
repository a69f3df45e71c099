// All that a run answers, as text to the last bit (hexadecimal floats), so that two runs can be compared
// whole. Left out: how many seconds it took.
#pragma once

#include <string>

#include "wythe/parts/result.h"

namespace wythe::scenes {

[[nodiscard]] std::string whole(const State& state);
[[nodiscard]] std::string whole(const Result& result);

}  // namespace wythe::scenes
