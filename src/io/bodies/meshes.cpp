// Readers of OBJ and STL; that of PLY is in ply.cpp.
#include "io/bodies/meshes.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/bits.h"
#include "io/bodies/mesh_parts.h"
#include "wythe/parts/text.h"

namespace wythe::io {
namespace {

std::optional<Vec3> point_in(const std::vector<std::string_view>& words, std::size_t first) {
  if (words.size() < first + 3) return std::nullopt;
  const auto x = mesh_number<double>(words[first]), y = mesh_number<double>(words[first + 1]),
             z = mesh_number<double>(words[first + 2]);
  if (!x || !y || !z || !std::isfinite(*x) || !std::isfinite(*y) || !std::isfinite(*z))
    return std::nullopt;
  return Vec3{*x, *y, *z};
}

class ObjReader {
 public:
  ObjReader(const MeshText& mesh, FaultList& faults)
      : lines_(mesh.text), name_(mesh.name), faults_(mesh.file, faults) {}

  std::vector<BodySpec> read() {
    std::string_view line;
    while (!faults_.enough() && lines_.next(line)) parse_line(line.substr(0, line.find('#')));
    std::vector<BodySpec> bodies;
    std::erase_if(groups_, [](const Group& group) { return group.face.empty(); });
    if (groups_.size() == 1) {
      bodies = bodies_of_solids(groups_[0].name.empty() ? name_ : groups_[0].name, vertex_,
                                groups_[0].face, faults_);
      for (BodySpec& body : bodies) set_material(body, groups_[0]);
    }
    for (std::size_t g = 0; groups_.size() > 1 && g < groups_.size(); ++g) {
      const std::string& own = groups_[g].name;
      bodies.push_back(
          body_of_faces(own.empty() ? fmt::format("b{}", g + 1) : own, vertex_, groups_[g].face));
      set_material(bodies.back(), groups_[g]);
    }
    return bodies;
  }

 private:
  struct Group {
    std::string name, material;
    geometry::FaceList face;
  };

  static void set_material(BodySpec& body, const Group& group) {
    if (!group.material.empty()) body.material = group.material;
  }

  void parse_line(std::string_view line) {
    const auto words = words_of(line);
    if (words.empty()) return;
    if (words[0] == "v") return parse_corner(words, line);
    if (words[0] == "f") return parse_face(words, line);
    if (words[0] == "o" || words[0] == "g")
      return open_group(trimmed(line.substr(line.find(words[0]) + 1)));
    if (words[0] == "usemtl" && words.size() > 1) material_ = words[1];
    for (const char* curved : {"curv", "surf", "curv2", "cstype"})
      if (words[0] == curved)
        faults_.add(lines_.number(), line, "is a curved surface, which is not read",
                    "save the model as a mesh of polygons");
  }

  void parse_corner(const std::vector<std::string_view>& words, std::string_view line) {
    const auto point = point_in(words, 1);
    if (!point)
      faults_.add(lines_.number(), line, "must be three finite numbers", "write e.g. v 0 0.25 1.5");
    vertex_.push_back(point.value_or(Vec3{}));
  }

  void open_group(std::string_view name) {
    const auto [found, is_new] = place_.emplace(name, groups_.size());
    current_ = found->second;
    if (is_new) groups_.push_back({std::string(name), "", {}});
  }

  void parse_face(const std::vector<std::string_view>& words, std::string_view line) {
    if (groups_.empty()) open_group("");
    std::vector<std::int32_t> face;
    for (std::size_t k = 1; k < words.size(); ++k) {
      const auto number = mesh_number<std::int64_t>(words[k].substr(0, words[k].find('/')));
      const auto count = static_cast<std::int64_t>(vertex_.size());
      const std::int64_t index = !number ? -1 : *number < 0 ? count + *number : *number - 1;
      if (!number || *number == 0 || index < 0 || index >= count)
        return faults_.add(
            lines_.number(), words[k], "is no corner listed before this face",
            fmt::format("name corners 1 to {}, or -1 to -{} from the last on", count, count));
      face.push_back(static_cast<std::int32_t>(index));
    }
    if (face.size() < 3)
      return faults_.add(lines_.number(), line, "must name three corners or more", "");
    if (groups_[current_].material.empty()) groups_[current_].material = material_;
    groups_[current_].face.push_back(std::move(face));
  }

  Lines lines_;
  std::string name_;
  MeshFaults faults_;
  std::vector<Vec3> vertex_;
  std::vector<Group> groups_;
  std::map<std::string, std::size_t> place_;  // of each group, by its name
  std::size_t current_ = 0;
  std::string material_;
};

class StlReader {
 public:
  StlReader(const MeshText& mesh, FaultList& faults)
      : text_(mesh.text), name_(mesh.name), faults_(mesh.file, faults) {}

  std::vector<BodySpec> read() {
    if (is_binary())
      parse_binary();
    else
      parse_ascii();
    std::vector<BodySpec> bodies;
    std::erase_if(solids_, [](const Solid& solid) { return solid.face.empty(); });
    for (Solid& solid : solids_) {
      const bool has_own = solids_.size() > 1 && !solid.name.empty();
      for (BodySpec& body :
           bodies_of_solids(has_own ? solid.name : name_, vertex_, std::move(solid.face), faults_))
        bodies.push_back(std::move(body));
    }
    return bodies;
  }

 private:
  struct Solid {
    std::string name;
    geometry::FaceList face;
  };
  static constexpr std::size_t kHead = 84, kTriangle = 50;

  [[nodiscard]] std::uint32_t count() const {
    std::uint32_t n = 0;
    for (std::size_t k = 0; k < 4; ++k)
      n |= static_cast<std::uint32_t>(static_cast<unsigned char>(text_[80 + k])) << (8 * k);
    return n;
  }

  // A binary file may begin with "solid" too, so its length decides.
  [[nodiscard]] bool is_binary() const {
    if (text_.size() >= kHead && kHead + kTriangle * count() == text_.size()) return true;
    return !small_letters(trimmed(std::string_view(text_).substr(0, 512))).starts_with("solid");
  }

  [[nodiscard]] double number_at(std::size_t place) const {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k)
      bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(text_[place + k])) << (8 * k);
    return static_cast<double>(bits_as<float>(bits));
  }

  void parse_binary() {
    if (text_.size() < kHead || kHead + kTriangle * count() != text_.size())
      return faults_.add(
          0, fmt::format("{} bytes", text_.size()),
          "is no STL file: neither \"solid\" nor a count of triangles that fits its length",
          "save it again");
    solids_.push_back({});
    for (std::uint32_t t = 0; t < count() && !faults_.enough(); ++t) {
      const std::size_t place = kHead + kTriangle * t + 12;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = {number_at(place + 12 * k), number_at(place + 12 * k + 4),
                        number_at(place + 12 * k + 8)};
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
          faults_.add(0, fmt::format("triangle {}", t + 1), "has a corner that is no finite number",
                      "correct the corner");
        vertex_.push_back(p);
      }
      close_triangle(0);
    }
  }

  void parse_ascii() {
    Lines lines(text_);
    std::string_view line;
    std::size_t open = 0;  // corners of the triangle so far
    while (!faults_.enough() && lines.next(line)) {
      const auto words = words_of(line);
      if (words.empty()) continue;
      const std::string word = small_letters(words[0]);
      if (word == "solid") {
        const std::string_view name = trimmed(trimmed(line).substr(word.size()));
        solids_.push_back({std::string(name), {}});
      } else if (word == "vertex") {
        const auto point = point_in(words, 1);
        if (!point)
          faults_.add(lines.number(), line, "must be three finite numbers",
                      "write e.g. vertex 0 0.25 1.5");
        vertex_.push_back(point.value_or(Vec3{}));
        ++open;
      } else if (word == "endloop") {
        close_triangle(lines.number(), open);
        open = 0;
      }
    }
    if (open > 0) faults_.add(lines.number(), "", "ends within a triangle", "save it again");
  }

  void close_triangle(int line, std::size_t corners = 3) {
    if (corners != 3)
      return faults_.add(line, fmt::format("{} corners", corners), "a facet has three corners", "");
    const auto last = static_cast<std::int32_t>(vertex_.size());
    if (solids_.empty()) solids_.push_back({});
    solids_.back().face.push_back({last - 3, last - 2, last - 1});
  }

  const std::string& text_;
  std::string name_;
  MeshFaults faults_;
  std::vector<Vec3> vertex_;
  std::vector<Solid> solids_;
};

}  // namespace

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlank = " \t\r\n\f\v";
  for (std::size_t from = line.find_first_not_of(kBlank); from != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, from), line.size());
    words.push_back(line.substr(from, end - from));
    from = line.find_first_not_of(kBlank, end);
  }
  return words;
}

bool Lines::next(std::string_view& line) {
  joined_.clear();
  bool goes_on = true;
  number_ = lines_ + 1;
  bool any = false;
  while (goes_on && !rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++lines_;
    goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    if (goes_on || !joined_.empty()) (joined_ += line) += goes_on ? " " : "";
    any = true;
  }
  if (!joined_.empty()) line = joined_;
  return any;
}

void MeshFaults::add(int line, std::string_view value, std::string problem, std::string cure) {
  if (enough()) return;
  std::string shown(value.substr(0, 60));
  std::erase_if(shown, [](char c) {
    return static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126;
  });
  faults_.add({.file = file_,
               .value = std::move(shown),
               .problem = std::move(problem),
               .cure = std::move(cure),
               .line = line});
}

BodySpec body_of_faces(std::string id, const std::vector<Vec3>& vertex,
                       const geometry::FaceList& faces) {
  BodySpec body;
  body.id = std::move(id);
  Polyhedron part;
  std::map<std::int32_t, std::int32_t> number;
  for (const auto& face : faces)
    for (const std::int32_t i : face) number[i] = 0;
  for (auto& [old, now] : number) {
    now = static_cast<std::int32_t>(part.vertex.size());
    part.vertex.push_back(vertex[old]);
  }
  part.face = faces;
  for (auto& face : part.face)
    for (std::int32_t& i : face) i = number[i];
  body.part.push_back(std::move(part));
  return body;
}

namespace {

// The corners that these faces use, in their order, and the faces with
// new numbers. The time does not depend on other solids of the file.
std::vector<Vec3> take_own(const std::vector<Vec3>& vertex, geometry::FaceList& faces) {
  std::vector<std::int32_t> used;
  for (const auto& face : faces) used.insert(used.end(), face.begin(), face.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Vec3> own;
  for (const std::int32_t i : used) own.push_back(vertex[i]);
  for (auto& face : faces)
    for (std::int32_t& i : face)
      i = static_cast<std::int32_t>(std::lower_bound(used.begin(), used.end(), i) - used.begin());
  return own;
}

}  // namespace

std::vector<BodySpec> bodies_of_solids(const std::string& name, const std::vector<Vec3>& all,
                                       geometry::FaceList faces, MeshFaults& faults) {
  constexpr std::size_t kMostAtAnEdge = 100;    // eight cubes around an edge have fewer
  constexpr std::size_t kMostSolids = 250'000;  // docs/reference/limits.md
  const std::vector<Vec3> vertex = take_own(all, faces);
  geometry::weld_corners(vertex, faces);
  std::vector<BodySpec> bodies;
  if (const std::size_t most = geometry::most_faces_at_an_edge(faces); most > kMostAtAnEdge) {
    faults.add(0, "", fmt::format("has an edge at which {} faces meet", most),
               "save closed solids, each with surfaces of its own");
    return bodies;
  }
  const auto solids = geometry::solids_of(vertex, faces);
  if (solids.size() > kMostSolids) {
    faults.add(0, "", fmt::format("has {} surfaces, more than {}", solids.size(), kMostSolids),
               "join faces at their corners, or split the file (docs/reference/limits.md)");
    return bodies;
  }
  for (const std::vector<int>& solid : solids) {
    geometry::FaceList own;
    for (const int f : solid) own.push_back(faces[f]);
    const std::string id = solids.size() == 1 ? name : fmt::format("{}{}", name, bodies.size() + 1);
    bodies.push_back(body_of_faces(id, vertex, own));
  }
  return bodies;
}

std::vector<BodySpec> parse_obj(const MeshText& mesh, FaultList& faults) {
  return ObjReader(mesh, faults).read();
}

std::vector<BodySpec> parse_stl(const MeshText& mesh, FaultList& faults) {
  return StlReader(mesh, faults).read();
}

}  // namespace wythe::io
