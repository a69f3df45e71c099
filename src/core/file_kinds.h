// Recognises foreign files by their first bytes: an AutoCAD drawing, a web page, an archive. None of these can be read here.
#pragma once

#include <string>
#include <string_view>

namespace wythe {

struct FileKind {
  std::string what, cure;  // "a DWG drawing"; "" where the bytes match no kind
};

[[nodiscard]] FileKind foreign_kind(std::string_view bytes);

// Throws InputError with the kind and its cure where the bytes are of a foreign kind.
void refuse_foreign(const std::string& path, std::string_view bytes);

}  // namespace wythe
