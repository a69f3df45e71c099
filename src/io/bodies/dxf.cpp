// Reads pairs of group codes section by section: the unit in HEADER, hidden layers in TABLES, outlines in ENTITIES.
// An entity is processed when the next one begins. A drawn entity that is no closed flat polyline goes to
// Drawing::unread. An arc has the same chords from both ends, so two stones that share it still touch.
#include "io/bodies/dxf.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/elementary.h"
#include "core/file_kinds.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/number.h"
#include "core/text.h"
#include "io/bodies/other_format.h"
#include "io/keys/key.h"

namespace wythe::io {
namespace {

constexpr const char* kSaveAsDxf =
    "save it as ASCII DXF (\"AutoCAD 2013 DXF\", say) in the drawing program";

struct Unit {
  const char* name;
  int code;      // of $INSUNITS
  double metre;  // how many make a metre
};
constexpr Unit kUnits[] = {{"m", 6, 1},    {"mm", 4, 1e3},        {"cm", 5, 1e2},
                           {"dm", 14, 10}, {"in", 1, 1 / 0.0254}, {"ft", 2, 1 / 0.3048}};

struct Group {
  int code = 0;
  std::string_view value;
  int line = 0;  // of the code
};

[[noreturn]] void refuse(const std::string& file, std::string value, std::string problem,
                         std::string cure, int line = 0) {
  throw InputError({{.file = file,
                     .value = std::move(value),
                     .problem = std::move(problem),
                     .cure = std::move(cure),
                     .line = line}});
}

template <class T>
std::optional<T> from_text(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  return parse_number<T>(text);
}

// Reads the pairs of the file one by one.
class Groups {
 public:
  Groups(const std::string& file, std::string_view text) : file_(file), rest_(text) {}

  // False at the end of the file.
  bool next(Group& group) {
    if (rest_.find_first_not_of(" \t\r\n") == std::string_view::npos) return false;
    group.line = line_ + 1;
    const std::string_view code = take_line();
    const auto number = from_text<int>(code);
    if (!number)
      refuse(file_, std::string(trimmed(code).substr(0, 40)),
             "is no group code: a DXF file is pairs of lines, a number and its value", kSaveAsDxf,
             group.line);
    if (rest_.empty())
      refuse(file_, "", "ends in the middle of a pair: the file is not whole", "export it again",
             group.line);
    group.code = *number;
    group.value = take_line();
    return true;
  }

 private:
  std::string_view take_line() {
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_;
    return line;
  }
  const std::string& file_;
  std::string_view rest_;
  int line_ = 0;
};

// Entities that are not an outline of masonry.
bool is_annotation(std::string_view type) {
  static const std::set<std::string_view> kAnnotations = {
      "TEXT",   "MTEXT",       "ATTDEF",    "ATTRIB",    "DIMENSION", "ARC_DIMENSION",
      "LEADER", "MULTILEADER", "POINT",     "TOLERANCE", "VIEWPORT",  "LARGE_RADIAL_DIMENSION",
      "IMAGE",  "SEQEND",      "ACAD_TABLE"};
  return kAnnotations.contains(type);
}

std::string cure_for(std::string_view type) {
  if (type == "INSERT") return "explode the block reference in the drawing program";
  if (type == "LINE") return "join the lines to a closed polyline (PEDIT, Join)";
  if (type == "ARC")
    return "join it with its neighbours to a closed polyline (PEDIT, Join), whose arcs are read";
  if (type == "CIRCLE") return "draw it anew as a closed polyline of two arcs";
  if (type == "SPLINE" || type == "ELLIPSE")
    return "draw it anew as a closed polyline of straight segments and arcs";
  return "draw a closed polyline there, or take it out of the file";
}

struct Vertex {
  std::optional<double> x, y;
  double bulge =
      0;  // of the segment that begins here: tan(angle / 4), positive to the right of the chord
  int flags = 0;
};

using Corner = std::array<double, 2>;

// Inner corners of the chords for the arc from a to b, within kChordError of it; none where
// they would be more than kMostChords. An arc in the opposite direction has the same corners.
std::optional<std::vector<Corner>> chords_of(const Corner& a, const Corner& b, double bulge) {
  std::vector<Corner> corners;
  const double dx = b[0] - a[0], dy = b[1] - a[1], chord = elementary::hypot(dx, dy);
  const bool is_straight = std::abs(bulge) < 1 && std::abs(bulge) * chord / 2 <= kChordError;
  if (is_straight || chord == 0) return corners;  // rounding alone makes no arc
  const double angle = 4 * elementary::atan(bulge),
               radius = chord * (1 + bulge * bulge) / 4 / std::abs(bulge);
  const double widest = 2 * elementary::acos(std::max(0.0, 1 - kChordError / radius));
  const double count = std::ceil(std::abs(angle) / widest - 1e-9);
  if (!(count <= kMostChords)) return std::nullopt;
  // distance of the centre to the left of the chord, as a share of the chord
  const double off = (1 - bulge * bulge) / 4 / bulge;
  const Corner centre{(a[0] + b[0]) / 2 - off * dy, (a[1] + b[1]) / 2 + off * dx};
  const auto n = static_cast<int>(count);
  for (int k = 1; k < n; ++k) {
    const double turn = angle * k / n, c = elementary::cos(turn), s = elementary::sin(turn);
    const double x = a[0] - centre[0], y = a[1] - centre[1];
    corners.push_back({centre[0] + c * x - s * y, centre[1] + s * x + c * y});
  }
  return corners;
}

// Whether the last corner equals the first up to rounding of an export (1e-6 of the outline's size).
bool returns_to_start(const std::vector<Corner>& corners) {
  double x0 = corners[0][0], x1 = x0, y0 = corners[0][1], y1 = y0;
  for (const Corner& c : corners) {
    x0 = std::min(x0, c[0]), x1 = std::max(x1, c[0]);
    y0 = std::min(y0, c[1]), y1 = std::max(y1, c[1]);
  }
  return elementary::hypot(corners.front()[0] - corners.back()[0],
                           corners.front()[1] - corners.back()[1]) <=
         1e-6 * std::max(x1 - x0, y1 - y0);
}

// A name with its characters beyond ASCII: "\\U+00E9" -> é.
std::string plain_name(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned code = 0;
    const char* const from = name.data() + i + 3;
    const bool is_coded = name.substr(i).starts_with("\\U+") && name.size() >= i + 7 &&
                          std::from_chars(from, from + 4, code, 16).ptr == from + 4 &&
                          code > 0x1f && (code < 0xd800 || code > 0xdfff);  // no halves of pairs
    if (!is_coded) {
      out += name[i];
      continue;
    }
    if (code < 0x80) {
      out += static_cast<char>(code);
    } else if (code < 0x800) {
      out += static_cast<char>(0xc0 | (code >> 6));
      out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
      out += static_cast<char>(0xe0 | (code >> 12));
      out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
      out += static_cast<char>(0x80 | (code & 0x3f));
    }
    i += 6;
  }
  return out;
}

std::string layer_key(std::string name) {
  for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return name;
}

// One entity while its groups are read.
struct Entity {
  std::string type, layer = "0", handle;
  int line = 0;
  int flags = 0;
  bool on_paper = false;  // on a sheet, not in the drawing itself
  bool is_invisible = false;
  double thickness = 0;  // as the file has it
  double normal = 1;     // z of the extrusion direction
  std::vector<Vertex> vertices;
};

class DrawingReader {
 public:
  DrawingReader(const std::string& file, std::string_view text, const std::string& unit)
      : file_(file), groups_(file, text) {
    for (const Unit& known : kUnits)
      if (unit == known.name) scale_ = known.metre;
    if (!unit.empty() && scale_ == 0)
      refuse(file_, unit, "is no unit of a drawing", "write one of " + drawing_units());
  }

  Drawing read() {
    Group group;
    bool whole = false;
    while (!whole && groups_.next(group)) {
      if (group.code != 0) continue;
      if (group.value == "EOF") whole = true;
      if (group.value == "SECTION" && groups_.next(group)) parse_section(group);
    }
    if (!whole)
      refuse(file_, "", "has no EOF at its end: the file is not whole, or no DXF",
             "export it again");
    if (!has_entities_) refuse(file_, "", "has no section ENTITIES", kSaveAsDxf);
    return std::move(drawing_);
  }

 private:
  void parse_section(const Group& name) {
    if (name.value == "HEADER") return parse_header();
    if (name.value == "TABLES") return parse_tables();
    if (name.value == "ENTITIES") return parse_entities();
  }

  void parse_header() {
    Group group;
    std::string variable;
    while (groups_.next(group) && !(group.code == 0 && group.value == "ENDSEC")) {
      if (group.code == 9) variable = group.value;
      if (group.code == 70 && variable == "$INSUNITS") stated_ = from_text<int>(group.value);
    }
  }

  // Collects layers that are off (a negative colour) or frozen.
  void parse_tables() {
    constexpr int kFrozen = 1;
    Group group;
    std::string name;
    bool in_layer = false, is_hidden = false;
    while (groups_.next(group)) {
      if (group.code == 0) {
        if (in_layer && is_hidden) hidden_.insert(layer_key(name));
        if (group.value == "ENDSEC") return;
        in_layer = group.value == "LAYER";
        is_hidden = false;
        name.clear();
      } else if (in_layer && group.code == 2) {
        name = plain_name(trimmed(group.value));
      } else if (in_layer && group.code == 70) {
        is_hidden = is_hidden || (from_text<int>(group.value).value_or(0) & kFrozen) != 0;
      } else if (in_layer && group.code == 62) {
        is_hidden = is_hidden || from_text<int>(group.value).value_or(0) < 0;
      }
    }
  }

  void find_scale() {
    for (const Unit& known : kUnits)
      if (stated_ == known.code) {
        drawing_.stated_unit = known.name;
        if (scale_ <= 0) scale_ = known.metre;
      }
    if (scale_ > 0) return;
    const bool none = !stated_ || *stated_ == 0;
    refuse(
        file_, none ? "" : fmt::format("$INSUNITS {}", *stated_),
        none ? "does not say its unit ($INSUNITS is missing or 0)" : "has a unit that is not read",
        "say it: wall.blocks_unit = \"mm\" in a model, --unit mm for wythe drawing (" +
            drawing_units() + ")");
  }

  void parse_entities() {
    find_scale();
    has_entities_ = true;
    Group group;
    Entity entity;
    while (groups_.next(group)) {
      if (group.code != 0) {
        take(group, entity);
        continue;
      }
      const bool goes_on = entity.type == "POLYLINE" && group.value == "VERTEX";
      if (goes_on) {
        entity.vertices.emplace_back();
        in_vertex_ = true;
        continue;
      }
      finish(entity);
      if (group.value == "ENDSEC") return;
      entity = {};
      entity.type = group.value;
      entity.line = group.line;
      in_vertex_ = false;
    }
  }

  double number(const Group& group) {
    const auto value = from_text<double>(group.value);
    if (!value || !std::isfinite(*value))
      refuse(file_, std::string(group.value.substr(0, 40)), "must be a number", "export it again",
             group.line + 1);
    return *value;
  }

  int integer(const Group& group) {
    const auto value = from_text<int>(group.value);
    if (!value)
      refuse(file_, std::string(group.value.substr(0, 40)), "must be a whole number",
             "export it again", group.line + 1);
    return *value;
  }

  void take(const Group& group, Entity& entity) {
    const bool is_polyline = entity.type == "LWPOLYLINE" || in_vertex_;
    switch (group.code) {
      case 5:
        if (!in_vertex_) entity.handle = trimmed(group.value);
        break;
      case 8:
        if (!in_vertex_) entity.layer = plain_name(trimmed(group.value));
        break;
      case 60:
        if (!in_vertex_) entity.is_invisible = integer(group) == 1;
        break;
      case 67: entity.on_paper = entity.on_paper || integer(group) == 1; break;
      case 70:
        if (is_polyline && in_vertex_) entity.vertices.back().flags = integer(group);
        if (!in_vertex_ && (entity.type == "LWPOLYLINE" || entity.type == "POLYLINE"))
          entity.flags = integer(group);
        break;
      case 39:
        if (!in_vertex_) entity.thickness = number(group);
        break;
      case 230: entity.normal = number(group); break;
      case 10:
        if (!is_polyline) break;
        if (!in_vertex_) entity.vertices.emplace_back();
        entity.vertices.back().x = number(group);
        break;
      case 20:
        if (is_polyline && !entity.vertices.empty()) entity.vertices.back().y = number(group);
        break;
      case 42:
        if (is_polyline && !entity.vertices.empty()) entity.vertices.back().bulge = number(group);
        break;
      default: break;
    }
  }

  void finish(const Entity& entity) {
    if (entity.type.empty() || entity.on_paper || is_annotation(entity.type)) return;
    if (hidden_.contains(layer_key(entity.layer))) {
      if (left_.insert(layer_key(entity.layer)).second) drawing_.hidden.push_back(entity.layer);
      return;
    }
    if (entity.is_invisible) {
      ++drawing_.invisible;
      return;
    }
    if (layers_.insert(entity.layer).second) drawing_.layers.push_back(entity.layer);
    if (++entities_ > kMostEntities)
      refuse(file_, "", fmt::format("has more than {} entities", kMostEntities),
             "leave out of the drawing what is no masonry, or split it (docs/reference/limits.md)",
             entity.line);
    if (entity.type != "LWPOLYLINE" && entity.type != "POLYLINE")
      return leave(entity, "is no closed polyline", cure_for(entity.type));
    add_outline(entity);
  }

  void leave(const Entity& e, std::string problem, std::string cure) {
    drawing_.unread.push_back(
        {e.layer, e.type, e.handle, std::move(problem), std::move(cure), e.line});
  }

  void add_outline(const Entity& entity) {
    constexpr int kClosed = 1, kCurved = 2 | 4, kNotPlane = 8 | 16 | 64;
    if ((entity.flags & kNotPlane) != 0)
      return leave(entity, "is a polyline in space or a mesh", "draw it flat, in the plane z = 0");
    if (entity.normal <= 0 || std::abs(entity.normal - 1) > 1e-9)
      return leave(entity, "lies in another plane than x and y",
                   "draw the wall in the plane of x and y (FLATTEN)");
    if (entity.type == "POLYLINE" && (entity.flags & kCurved) != 0)
      return leave(
          entity, "is a fitted curve",
          "draw it anew with straight segments and arcs, the same on both sides of a joint");
    DrawnOutline outline{entity.layer, entity.handle, entity.line, {}};
    for (const Vertex& vertex : entity.vertices) {
      if (!vertex.x || !vertex.y)
        return leave(entity, "has a vertex without x or y", "export it again");
      outline.corners.push_back({*vertex.x / scale_, *vertex.y / scale_});
      if (!kCoordinate.holds(outline.corners.back()[0]) ||
          !kCoordinate.holds(outline.corners.back()[1]))
        return leave(entity, "lies more than 10 km from the origin",
                     "move the drawing to the origin, or check its unit");
    }
    const bool returns = outline.corners.size() > 1 && returns_to_start(outline.corners);
    if ((entity.flags & kClosed) == 0 && !returns)
      return leave(entity, "is open", "close it (PEDIT, Close)");
    if (returns) outline.corners.pop_back();
    if (!lay_arcs(entity, outline)) return;
    if (outline.corners.size() < 3)
      return leave(entity, "has fewer than 3 corners", "draw it anew, or take it out of the file");
    if (entity.thickness != 0 && ++drawing_.thick == 1) drawing_.thickness = entity.thickness;
    drawing_.outlines.push_back(std::move(outline));
  }

  // Replaces arcs by chords; false where that is impossible.
  bool lay_arcs(const Entity& entity, DrawnOutline& outline) {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < outline.corners.size(); ++i) {
      corners.push_back(outline.corners[i]);
      const Corner& next = outline.corners[(i + 1) % outline.corners.size()];
      const auto arc = chords_of(corners.back(), next, entity.vertices[i].bulge);
      if (!arc) {
        leave(entity, fmt::format("has an arc that needs more than {} chords", kMostChords),
              "draw it anew, or check the drawing's unit");
        return false;
      }
      chords_ += arc->size();
      if (chords_ > kMostOfAllChords)
        refuse(file_, "",
               fmt::format("its arcs need more than {} chords of {:g} mm off them",
                           kMostOfAllChords, 1e3 * kChordError),
               "draw small curves with straight segments, or check the drawing's unit",
               entity.line);
      corners.insert(corners.end(), arc->begin(), arc->end());
    }
    outline.corners = std::move(corners);
    return true;
  }

  const std::string& file_;
  Groups groups_;
  double scale_ = 0;           // file units in a metre; 0: not known yet
  std::optional<int> stated_;  // $INSUNITS
  bool has_entities_ = false, in_vertex_ = false;
  std::size_t chords_ = 0;  // so far
  int entities_ = 0;        // so far
  std::set<std::string> layers_;
  std::set<std::string> hidden_, left_;  // in small letters
  Drawing drawing_;
};

// Files before 2007 use the code page of their machine. Bytes that are not UTF-8 are read as Latin-1.
std::string as_utf8(std::string text) {
  if (is_utf8(text)) return text;
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | (byte >> 6));
      out += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return out;
}

}  // namespace

bool same_layer(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

bool is_drawing(const std::string& file) {
  return same_layer(std::filesystem::path(file).extension().string(), ".dxf");
}

double units_in_a_metre(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (name == unit.name) return unit.metre;
  return 0;
}

std::string drawing_units() {
  std::string names;
  for (const Unit& unit : kUnits) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

Drawing parse_drawing(const std::string& file, const std::string& unit) {
  std::string text = read_file(file, kMostDxf);
  refuse_foreign(file, text);
  refuse_other_format(file, text);
  if (text.find('\0') != std::string::npos) refuse(file, "", "is no text", kSaveAsDxf);
  text = as_utf8(std::move(text));
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return DrawingReader(file, text, unit).read();
}

Fault fault_of(const Unread& entity, const std::string& file) {
  const std::string handle = entity.handle.empty() ? "" : " " + entity.handle;
  return {.file = file,
          .path = fmt::format("{}{} on layer {}", entity.type, handle, entity.layer),
          .problem = entity.problem,
          .cure = entity.cure,
          .line = entity.line};
}

}  // namespace wythe::io
