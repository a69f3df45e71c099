// Refuses blocks files that are empty, or whose content has another format than their ending.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

// Throws InputError that names the format: a DXF drawing named .json, JSON named .obj, a table.
void refuse_other_format(const std::string& file, std::string_view text);

}  // namespace wythe::io
