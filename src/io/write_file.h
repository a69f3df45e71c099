// Writes a file whole or not at all: temporary name in the same folder, every call checked, rename.
// A reader never sees half a file, and a full disk leaves the previous version in place.
#pragma once

#include <string>
#include <string_view>

namespace wythe::io {

// Throws IoError with the path and the system's reason.
void write_file(const std::string& path, std::string_view text);

}  // namespace wythe::io
