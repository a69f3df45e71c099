// A range in words, with its unit: "more than 0 MPa", "from 0 to less than 1".
#pragma once

#include <string>

#include "io/keys/key.h"

namespace wythe::io {

[[nodiscard]] std::string range_text(const Key& key);  // "any" when nothing is excluded
// `name = "example"` with the quotes TOML needs; "" without an example.
enum class ValueKind { kQuantity, kBare, kText };
[[nodiscard]] std::string example_text(const std::string& name, const Key& key, ValueKind kind);

}  // namespace wythe::io
