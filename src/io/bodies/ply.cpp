// PLY: a header of elements with typed properties, then the elements as text or bytes.
//
// Reads x, y, z of `vertex` and the list of corners of `face`; skips everything else by its type.
#include <algorithm>

#include <fmt/format.h>

#include "core/bits.h"
#include "io/bodies/mesh_parts.h"

namespace wythe::io {
namespace {

enum class Kind { kSigned, kUnsigned, kReal };

struct Type {
  const char *name, *other;
  std::size_t bytes;
  Kind kind;
};
constexpr Type kTypes[] = {
    {"char", "int8", 1, Kind::kSigned},   {"uchar", "uint8", 1, Kind::kUnsigned},
    {"short", "int16", 2, Kind::kSigned}, {"ushort", "uint16", 2, Kind::kUnsigned},
    {"int", "int32", 4, Kind::kSigned},   {"uint", "uint32", 4, Kind::kUnsigned},
    {"float", "float32", 4, Kind::kReal}, {"double", "float64", 8, Kind::kReal}};

const Type* type_named(std::string_view name) {
  for (const Type& type : kTypes)
    if (name == type.name || name == type.other) return &type;
  return nullptr;
}

struct Property {
  std::string name;
  const Type* type = nullptr;
  const Type* count = nullptr;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> property;
};

enum class Form { kText, kLittle, kBig };

struct End {};  // thrown at the end of the file within an element

// Reads the numbers of the body in order.
class Values {
 public:
  Values(std::string_view body, Form form) : rest_(body), form_(form) {}

  double next(const Type& type) { return form_ == Form::kText ? next_word() : next_bytes(type); }

 private:
  double next_word() {
    constexpr std::string_view kBlank = " \t\r\n";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
    const std::size_t end = std::min(rest_.find_first_of(kBlank), rest_.size());
    if (end == 0) throw End{};
    const auto value = mesh_number<double>(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return value.value_or(std::nan(""));
  }

  double next_bytes(const Type& type) {
    if (rest_.size() < type.bytes) throw End{};
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.bytes; ++k) {
      const std::size_t place = form_ == Form::kLittle ? type.bytes - 1 - k : k;
      bits = bits << 8 | static_cast<unsigned char>(rest_[place]);
    }
    rest_.remove_prefix(type.bytes);
    if (type.kind == Kind::kReal)
      return type.bytes == 8
                 ? bits_as<double>(bits)
                 : static_cast<double>(bits_as<float>(static_cast<std::uint32_t>(bits)));
    const std::size_t width = 8 * type.bytes;
    if (type.kind == Kind::kSigned && (bits >> (width - 1) & 1) != 0)
      return static_cast<double>(bits) - static_cast<double>(std::uint64_t{1} << width);
    return static_cast<double>(bits);
  }

  std::string_view rest_;
  Form form_;
};

constexpr std::size_t kMostFaces = 2'000'000;  // 64 MB of text hold no more; bytes are shorter
constexpr std::size_t kMostCorners = 10'000;   // of a face, as of a solid

class PlyReader {
 public:
  PlyReader(const MeshText& mesh, FaultList& given)
      : text_(mesh.text), name_(mesh.name), given_(given), faults_(mesh.file, given) {}

  std::vector<BodySpec> read() {
    const std::size_t before = given_.all().size();
    if (!parse_header() || given_.all().size() > before) return {};
    Values values(text_.substr(body_), form_);
    try {
      for (const Element& element : elements_) parse_element(element, values);
    } catch (const End&) {
      faults_.add(0, "", "ends before its last element", "save it again");
    }
    if (given_.all().size() > before) return {};
    if (faces_.empty()) {
      faults_.add(0, "", "has no face", "save it as a mesh, not as points");
      return {};
    }
    return bodies_of_solids(name_, vertex_, std::move(faces_), faults_);
  }

 private:
  bool parse_header() {
    Lines lines(text_);
    std::string_view line;
    bool has_form = false;
    if (!lines.next(line) || trimmed(line) != "ply") {
      faults_.add(1, line, "is no PLY file: its first line is not \"ply\"", "save it again");
      return false;
    }
    while (lines.next(line)) {
      const auto words = words_of(line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        body_ = text_.size() - lines.rest().size();
        if (!has_form)
          faults_.add(lines.number(), "", "states no format", "write format ascii 1.0");
        return true;
      }
      if (words[0] == "format" && words.size() > 1)
        has_form = parse_form(words[1], lines.number());
      else if (words[0] == "element" && words.size() == 3)
        parse_count(words, lines.number());
      else if (words[0] == "property" && !elements_.empty() && words.size() >= 3)
        parse_property(words, line, lines.number());
      else
        faults_.add(lines.number(), line, "is no line of a PLY header", "save it again");
      if (faults_.enough()) return false;
    }
    faults_.add(lines.number(), "", "has no end_header", "save it again");
    return false;
  }

  bool parse_form(std::string_view word, int line) {
    if (word == "ascii") form_ = Form::kText;
    if (word == "binary_little_endian") form_ = Form::kLittle;
    if (word == "binary_big_endian") form_ = Form::kBig;
    if (word == "ascii" || word == "binary_little_endian" || word == "binary_big_endian")
      return true;
    faults_.add(line, word, "is no format of a PLY file",
                "ascii, binary_little_endian or binary_big_endian");
    return true;
  }

  // A file has no more elements than bytes; this is checked before memory is allocated.
  void parse_count(const std::vector<std::string_view>& words, int line) {
    const auto count = mesh_number<std::uint64_t>(words[2]);
    if (!count || *count > text_.size())
      return faults_.add(line, words[2], "is no count of elements this file can hold",
                         "save it again");
    if (words[1] == "face" && *count > kMostFaces)
      return faults_.add(line, words[2], fmt::format("are more than {} faces", kMostFaces),
                         "simplify the surfaces, or split the file (docs/reference/limits.md)");
    elements_.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
  }

  void parse_property(const std::vector<std::string_view>& words, std::string_view line,
                      int number) {
    Property property;
    const bool is_list = words[1] == "list" && words.size() == 5;
    property.name = words.back();
    property.type = type_named(is_list ? words[3] : words[1]);
    if (is_list) property.count = type_named(words[2]);
    const bool good =
        property.type != nullptr && words.size() == (is_list ? 5U : 3U) &&
        (!is_list || (property.count != nullptr && property.count->kind != Kind::kReal));
    if (!good) return faults_.add(number, line, "is no property that is read", "save it again");
    elements_.back().property.push_back(std::move(property));
  }

  void parse_element(const Element& element, Values& values) {
    if (element.name == "tristrips")
      return faults_.add(0, element.name, "is not read", "save faces instead of strips");
    for (std::size_t i = 0; i < element.count && !faults_.enough() && !element.property.empty();
         ++i) {
      Vec3 point = {std::nan(""), std::nan(""), std::nan("")};
      for (const Property& property : element.property) {
        const std::size_t n = property.count ? list_length(values, *property.count) : 1;
        const bool is_face = element.name == "face" && property.count &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        if (is_face && n > kMostCorners) {
          faults_.add(0, fmt::format("face {}", i),
                      fmt::format("has more than {} corners", kMostCorners),
                      "simplify it (docs/reference/limits.md)");
          return;
        }
        if (is_face) faces_.emplace_back();
        for (std::size_t k = 0; k < n; ++k) {
          const double value = values.next(*property.type);
          if (is_face) add_corner(value);
          if (property.name == "x") point.x = value;
          if (property.name == "y") point.y = value;
          if (property.name == "z") point.z = value;
        }
        if (is_face && n < 3)
          faults_.add(0, fmt::format("face {}", i), "has fewer than three corners", "leave it out");
      }
      if (element.name == "vertex") add_point(point, i);
    }
  }

  std::size_t list_length(Values& values, const Type& type) {
    const double n = values.next(type);
    if (n >= 0 && n <= static_cast<double>(text_.size())) return static_cast<std::size_t>(n);
    faults_.add(0, fmt::format("{}", n), "is no length of a list", "save it again");
    throw End{};
  }

  void add_point(Vec3 point, std::size_t i) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
      faults_.add(0, fmt::format("vertex {}", i), "has no three finite coordinates x, y, z",
                  "correct the corner");
    vertex_.push_back(point);
  }

  // Corners come before faces in every known file. A corner that does not exist yet is refused.
  void add_corner(double value) {
    const bool good =
        value >= 0 && value < static_cast<double>(vertex_.size()) && value == std::floor(value);
    if (!good)
      faults_.add(0, fmt::format("{}", value), "a face names a corner that is not there",
                  fmt::format("name corners 0 to {}", vertex_.empty() ? 0 : vertex_.size() - 1));
    faces_.back().push_back(good ? static_cast<std::int32_t>(value) : 0);
  }

  std::string_view text_;
  std::string name_;
  FaultList& given_;
  MeshFaults faults_;
  std::vector<Element> elements_;
  Form form_ = Form::kText;
  std::size_t body_ = 0;
  std::vector<Vec3> vertex_;
  geometry::FaceList faces_;
};

}  // namespace

std::vector<BodySpec> parse_ply(const MeshText& mesh, FaultList& faults) {
  return PlyReader(mesh, faults).read();
}

}  // namespace wythe::io
