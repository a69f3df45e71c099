// Parses JSON from outside: the only place that does so (for a report's data see report/bundle.cpp).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace wythe::io {

// Throws InputError with the line where the text is not JSON or nests too deep (core/limits.h).
// Also where one object has a key twice, or a number is outside the range of a double.
[[nodiscard]] nlohmann::json parse_json(const std::string& text, const std::string& file);

}  // namespace wythe::io
