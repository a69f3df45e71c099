// JSON from outside to a tree: the one place that parses it (of a report's data: report/bundle.cpp).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace wythe::io {

// Throws InputError with the line where that is not JSON, nests too deep (core/limits.h), names a key twice
// in one object, or holds a number that no computer does.
[[nodiscard]] nlohmann::json parse_json(const std::string& text, const std::string& file);

}  // namespace wythe::io
