// Finds the format of a text from its first two lines, and refuses the file if its ending says another. A text with
// an unknown beginning goes to the reader of .dxf, .obj, .ply or .stl. With another ending it is refused, as it is
// no JSON.
#include "io/bodies/other_format.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/text.h"
#include "wythe/parts/error.h"
#include "wythe/parts/text.h"

namespace wythe::io {
namespace {

struct Format {
  const char *ending, *what;
};
constexpr Format kJson{".json", "JSON"}, kDxf{".dxf", "a DXF drawing"}, kObj{".obj", "an OBJ mesh"},
    kPly{".ply", "a PLY mesh"}, kStl{".stl", "an STL mesh"}, kOff{".off", "an OFF mesh"};

std::string_view line_from(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// The format of a text; null if its beginning is of no known format.
const Format* format_of(std::string_view text) {
  if (text.starts_with('{') || text.starts_with('[')) return &kJson;
  const std::string_view first = line_from(text), second = line_from(text);
  if (first == "0" && second == "SECTION") return &kDxf;
  if (first == "ply" && second.starts_with("format")) return &kPly;
  if (first.starts_with("solid") && second.starts_with("facet")) return &kStl;
  if (first == "OFF") return &kOff;
  if (first.starts_with("v ") && second.starts_with("v ")) return &kObj;
  return nullptr;
}

}  // namespace

void refuse_other_format(const std::string& file, std::string_view text) {
  const auto refuse = [&](std::string value, std::string problem, std::string cure) {
    throw InputError({{.file = file,
                       .value = std::move(value),
                       .problem = std::move(problem),
                       .cure = std::move(cure)}});
  };
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text = trimmed(text);
  if (text.empty()) return refuse("", "is empty", "export it again, or name another file");
  const std::string ending = small_letters(std::filesystem::path(file).extension().string());
  const auto is_named = [&](const Format& format) { return ending == format.ending; };
  const bool is_named_else = is_named(kDxf) || is_named(kObj) || is_named(kPly) || is_named(kStl);
  const Format* is = format_of(text);
  if (is == nullptr && is_named_else) return;  // the reader of that format reports the fault
  if (is == nullptr)
    return refuse(std::string(line_from(text)), "is no JSON: it begins so",
                  "blocks come as JSON, or in a file whose name ends in .dxf, .obj, .ply or .stl "
                  "(docs/reference/blocks.md)");
  if (is == &kOff) return refuse("", "is an OFF mesh", "save it as OBJ, PLY or STL");
  if (is_named(*is) || (is == &kJson && !is_named_else)) return;
  refuse("", fmt::format("is {}, and its name ends in \"{}\"", is->what, ending),
         fmt::format("name it {}{}", std::filesystem::path(file).stem().string(), is->ending));
}

}  // namespace wythe::io
