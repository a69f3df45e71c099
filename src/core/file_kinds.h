// What a file is by its first bytes, where it is none that is read: a drawing of AutoCAD, a page of the web, an archive.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

struct FileKind {
  std::string what, cure;  // "a DWG drawing"; "" where the bytes say nothing
};

[[nodiscard]] FileKind foreign_kind(std::string_view bytes);

// Throws InputError where the bytes are of such a kind.
void refuse_foreign(const std::string& path, std::string_view bytes);

}  // namespace wythe
