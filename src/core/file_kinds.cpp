// Most kinds are recognised by their first bytes. ZIP archives are distinguished by names in their first 4 and last 64 KiB,
// texts by words of their first lines. The first matching entry of the table decides. Bytes that match none are left to
// the reader of the file.
#include "core/file_kinds.h"

#include <algorithm>
#include <iterator>

#include "core/text.h"
#include "wythe/parts/error.h"
#include "wythe/parts/text.h"

namespace wythe {
namespace {

using namespace std::string_view_literals;

constexpr const char* kAsMesh = "save it as OBJ, PLY or STL in the program that made it";
constexpr const char* kAsText = "name the file it was made from, or type its values into one";
constexpr const char* kUnpack = "unpack it, and name the file in it";

struct Beginning {
  std::string_view bytes;
  const char *what, *cure;
};
constexpr Beginning kBeginnings[] = {
    {"AC10"sv, "a DWG drawing",
     "save it as ASCII DXF (\"AutoCAD 2013 DXF\", say) in the drawing program"},
    {"AutoCAD Binary DXF"sv, "a binary DXF drawing",
     "save it as ASCII DXF (\"AutoCAD 2013 DXF\", say) in the drawing program"},
    {"version https://git-lfs.github.com/spec/"sv, "a pointer of git-lfs, not the file itself",
     "fetch the file: git lfs pull"},
    {"3D Geometry File Format"sv, "a Rhino 3DM file", kAsMesh},
    {"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p\0"sv, "a SketchUp file", kAsMesh},
    {"glTF"sv, "a glTF file", kAsMesh},
    {"PK\x03\x04"sv, "a ZIP archive", kUnpack},
    {"\x1f\x8b"sv, "a file packed by gzip", kUnpack},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive", kUnpack},
    {"Rar!\x1a\x07"sv, "a RAR archive", kUnpack},
    {"\xd0\xcf\x11\xe0"sv, "a file of an older Office (XLS, DOC)", "save its table as CSV"},
    {"%PDF-"sv, "a PDF", kAsText},
    {"\x89PNG"sv, "a picture (PNG)", kAsText},
    {"\xff\xd8\xff"sv, "a picture (JPEG)", kAsText},
    {"GIF8"sv, "a picture (GIF)", kAsText},
    {"SQLite format 3\0"sv, "a database (SQLite)",
     "a campaign.db is named by its folder, in status, report or export"},
    {"\x89HDF\r\n"sv, "an HDF5 file", "write what is needed of it as CSV"}};

constexpr std::size_t kHead = 4096;

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// Kinds of ZIP archives in which programs keep their documents.
FileKind kind_of_archive(std::string_view bytes) {
  const std::string_view end = bytes.substr(bytes.size() - std::min(bytes.size(), 16 * kHead));
  const auto has = [&](std::string_view name) {
    return holds(bytes.substr(0, kHead), name) || holds(end, name);
  };
  if (has("xl/work")) return {"a spreadsheet (XLSX)", "save its table as CSV"};
  if (has("opendocument.spreadsheet")) return {"a spreadsheet (ODS)", "save its table as CSV"};
  if (has("word/document")) return {"a text of Word (DOCX)", kAsText};
  return {"a ZIP archive", kUnpack};
}

// Kinds of texts that a word of their first lines identifies.
FileKind kind_of_text(std::string_view bytes) {
  std::string_view text = bytes.substr(0, kHead);
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::string head = small_letters(trimmed(text));
  const auto is_xml_of = [&](std::string_view root) {
    return head.starts_with(root) || (head.starts_with("<?xml") && holds(head, root));
  };
  if (is_xml_of("<!doctype html") || is_xml_of("<html"))
    return {"a page of the web (HTML), not the file that it shows",
            "download the file itself, and name that"};
  if (is_xml_of("<svg")) return {"a picture (SVG)", kAsText};
  if (is_xml_of("<collada")) return {"a COLLADA file", kAsMesh};
  if (is_xml_of("<kml")) return {"a KML file of maps", kAsText};
  if (!head.starts_with("iso-10303-21")) return {};
  if (holds(head, "'ifc")) return {"an IFC model of a building", kAsMesh};
  return {"a STEP file", kAsMesh};
}

}  // namespace

FileKind foreign_kind(std::string_view bytes) {
  const auto* found =
      std::find_if(std::begin(kBeginnings), std::end(kBeginnings),
                   [&](const Beginning& one) { return bytes.starts_with(one.bytes); });
  if (found == std::end(kBeginnings)) return kind_of_text(bytes);
  if (found->bytes.starts_with("PK")) return kind_of_archive(bytes);
  return {found->what, found->cure};
}

void refuse_foreign(const std::string& path, std::string_view bytes) {
  const FileKind kind = foreign_kind(bytes);
  if (kind.what.empty()) return;
  throw InputError({{.file = path, .problem = "is " + kind.what, .cure = kind.cure}});
}

}  // namespace wythe
