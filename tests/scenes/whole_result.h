// All results of a run as text to the last bit (hexadecimal floats), so that
// two runs can be compared completely. Only the time in seconds is left out.
#pragma once

#include <string>

#include "wythe/parts/result.h"

namespace wythe::scenes {

[[nodiscard]] std::string whole(const State& state);
[[nodiscard]] std::string whole(const Result& result);

}  // namespace wythe::scenes
