// Parses mesh files by their ending and solids from JSON: corners and faces, parts, or an outline between two
// depths. Coordinates stay in the file's axes until place() divides by the units in a metre and turns z up into y
// up. A path with * makes one body of each file. "lowest" fixes bodies whose foot is within 1/1000 of the height.
#include "io/bodies/bodies_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/elementary.h"
#include "core/file_kinds.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/bodies/dxf.h"
#include "io/bodies/meshes.h"
#include "io/bodies/other_format.h"
#include "io/keys/key.h"

namespace wythe::io {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& file) { return fs::path(file).extension().string(); }

std::vector<BodySpec> parse_mesh(const std::string& file, FaultList& faults) {
  const std::string text = read_file(file, kMostMesh), ending = ending_of(file);
  refuse_foreign(file, text);
  refuse_other_format(file, text);
  const MeshText mesh{text, file, fs::path(file).stem().string()};
  const std::size_t before = faults.all().size();
  std::vector<BodySpec> bodies = same_layer(ending, ".obj")   ? parse_obj(mesh, faults)
                                 : same_layer(ending, ".ply") ? parse_ply(mesh, faults)
                                                              : parse_stl(mesh, faults);
  if (bodies.empty() && faults.all().size() == before)
    faults.add({file, "", "", "holds no face", "save it as a mesh of closed solids", 0});
  return bodies;
}

// Files of one folder that match the pattern, sorted; numbers in names sort by value.
std::vector<std::string> files_like(const std::string& pattern) {
  const fs::path path(pattern);
  const std::string name = path.filename().string();
  const std::string head = name.substr(0, name.find('*')), tail = name.substr(name.find('*') + 1);
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry :
       fs::directory_iterator(path.parent_path().empty() ? "." : path.parent_path(), error)) {
    const std::string own = entry.path().filename().string();
    if (own.size() >= head.size() + tail.size() && own.starts_with(head) && own.ends_with(tail))
      found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return found;
}

bool is_point(const nlohmann::json& json) {
  return json.is_array() && json.size() == 3 &&
         std::all_of(json.begin(), json.end(),
                     [](const nlohmann::json& x) { return x.is_number(); });
}

void parse_solid(const nlohmann::json& json, BodySpec& body, const RefuseBlock& refuse) {
  const nlohmann::json vertices = json.value("vertices", nlohmann::json()),
                       faces = json.value("faces", nlohmann::json());
  if (!vertices.is_array() || vertices.size() < 4)
    return refuse("vertices", vertices, "must be a list of 4 corners or more",
                  R"(write e.g. "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])");
  if (!faces.is_array() || faces.size() < 4)
    return refuse("faces", faces, "must be a list of 4 faces or more",
                  R"(write e.g. "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])");
  Polyhedron part;
  for (const nlohmann::json& v : vertices) {
    if (!is_point(v)) return refuse("vertices", v, "must be three numbers [x, y, z]", "");
    part.vertex.push_back({v[0].get<double>(), v[1].get<double>(), v[2].get<double>()});
  }
  for (const nlohmann::json& f : faces) {
    part.face.emplace_back();
    for (const nlohmann::json& i :
         f.is_array() && f.size() >= 3 ? f : nlohmann::json::array({nullptr})) {
      const bool good = i.is_number_integer() && i >= 0 && i < vertices.size();
      if (!good)
        return refuse("faces", f,
                      "must be a list of three corners or more, by their place from 0 on",
                      fmt::format("name corners 0 to {}", vertices.size() - 1));
      part.face.back().push_back(i.get<std::int32_t>());
    }
  }
  body.part.push_back(std::move(part));
}

// Removes corners that repeat the one before them up to rounding (1e-6 of the outline's size).
void leave_repeats_out(std::vector<std::array<double, 2>>& outline) {
  constexpr double kRounding = 1e-6;
  double size = 0;
  for (const auto& p : outline)
    size = std::max({size, std::abs(p[0] - outline[0][0]), std::abs(p[1] - outline[0][1])});
  const auto repeat = [&](const auto& p, const auto& q) {
    return elementary::hypot(p[0] - q[0], p[1] - q[1]) <= kRounding * size;
  };
  outline.erase(std::unique(outline.begin(), outline.end(), repeat), outline.end());
  while (outline.size() > 3 && repeat(outline.front(), outline.back())) outline.pop_back();
}

// Parses a prism: the outline of a block between two depths z.
void parse_prism(const nlohmann::json& json, BodySpec& body, const RefuseBlock& refuse) {
  const nlohmann::json& z = json["z"];
  const bool good = z.is_array() && z.size() == 2 && z[0].is_number() && z[1].is_number() &&
                    z[0].get<double>() < z[1].get<double>();
  if (!good)
    return refuse("z", z, "must be two numbers, the smaller one first",
                  R"(write e.g. "z": [0, 0.25])");
  const nlohmann::json polygon = json.value("polygon", nlohmann::json());
  if (!polygon.is_array() || polygon.size() < 3)
    return refuse("polygon", polygon, "must have 3 vertices or more", "");
  std::vector<std::array<double, 2>> outline;
  double twice = 0;
  for (const nlohmann::json& p : polygon) {
    if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number())
      return refuse("polygon", p, "must be two numbers [x, y]", "");
    outline.push_back({p[0].get<double>(), p[1].get<double>()});
  }
  leave_repeats_out(outline);
  if (outline.size() < 3)
    return refuse("polygon", polygon, "must have 3 different vertices or more", "");
  const auto n = static_cast<std::int32_t>(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()];
    twice += (p[0] - outline[0][0]) * (q[1] - outline[0][1]) -
             (q[0] - outline[0][0]) * (p[1] - outline[0][1]);
  }
  if (twice < 0) std::reverse(outline.begin(), outline.end());
  Polyhedron part;
  for (const nlohmann::json& depth : z)
    for (const auto& p : outline) part.vertex.push_back({p[0], p[1], depth.get<double>()});
  part.face.resize(2);
  for (std::int32_t i = 0; i < n; ++i) {
    part.face[0].push_back(n - 1 - i);
    part.face[1].push_back(n + i);
    part.face.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  body.part.push_back(std::move(part));
}

bool is_named(const std::string& id, const std::string& pattern) {
  if (pattern.ends_with('*')) return id.starts_with(pattern.substr(0, pattern.size() - 1));
  return id == pattern;
}

double lowest_of(const BodySpec& body) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Polyhedron& part : body.part)
    for (const Vec3 v : part.vertex) lowest = std::min(lowest, v.y);
  return lowest;
}

// Fixes the bodies whose lowest corner is the lowest of all, within a thousandth of the wall's height.
bool fix_lowest(std::vector<BodySpec>& bodies) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const BodySpec& body : bodies)
    for (const Polyhedron& part : body.part)
      for (const Vec3 v : part.vertex) {
        low = std::min(low, v.y);
        high = std::max(high, v.y);
      }
  for (BodySpec& body : bodies)
    if (lowest_of(body) <= low + 1e-3 * (high - low)) body.fixed = true;
  return !bodies.empty();
}

}  // namespace

bool is_mesh_file(const std::string& file) {
  const std::string ending = ending_of(file);
  return same_layer(ending, ".obj") || same_layer(ending, ".ply") || same_layer(ending, ".stl");
}

std::vector<BodySpec> parse_mesh_bodies(const std::string& file, FaultList& faults) {
  if (fs::path(file).filename().string().find('*') == std::string::npos)
    return parse_mesh(file, faults);
  std::vector<BodySpec> bodies;
  const std::vector<std::string> files = files_like(file);
  if (files.empty())
    faults.add(
        {file, "", "", "names no file", "the path counts from the folder of the model file", 0});
  for (const std::string& own : files) {
    if (enough(faults)) break;
    BodySpec whole;  // all solids of one file form one body
    for (BodySpec& body : parse_mesh(own, faults)) {
      if (whole.part.empty()) whole.material = body.material;
      for (Polyhedron& part : body.part) whole.part.push_back(std::move(part));
    }
    whole.id = fs::path(own).stem().string();
    if (!whole.part.empty()) bodies.push_back(std::move(whole));
  }
  return bodies;
}

bool is_in_space(const nlohmann::json& block) {
  return block.is_object() &&
         (block.contains("vertices") || block.contains("parts") || block.contains("z"));
}

void parse_body_parts(const nlohmann::json& block, BodySpec& body, const RefuseBlock& refuse) {
  if (block.contains("z")) return parse_prism(block, body, refuse);
  if (!block.contains("parts")) return parse_solid(block, body, refuse);
  const nlohmann::json& parts = block["parts"];
  if (!parts.is_array() || parts.empty())
    return refuse("parts", parts, "must be a list of solids",
                  R"(write e.g. "parts": [{"vertices": [...], "faces": [...]}])");
  for (const nlohmann::json& part : parts) {
    if (!part.is_object() || part.contains("parts") || !is_in_space(part))
      return refuse("parts", part, "must be an object with vertices and faces, or polygon and z",
                    "");
    if (part.contains("z"))
      parse_prism(part, body, refuse);
    else
      parse_solid(part, body, refuse);
  }
}

void place(std::vector<BodySpec>& bodies, double units_in_a_metre, bool z_up) {
  for (BodySpec& body : bodies)
    for (Polyhedron& part : body.part)
      for (Vec3& v : part.vertex) {
        // divides, so that 200 mm is the double nearest to 0.2
        const Vec3 m = v / units_in_a_metre;
        v = z_up ? Vec3{m.x, m.z, -m.y} : m;
      }
}

void fix_supports(std::vector<BodySpec>& bodies, const std::vector<std::string>& supports,
                  FaultList& faults) {
  for (const std::string& pattern : supports) {
    bool found = pattern == "lowest" && fix_lowest(bodies);
    for (BodySpec& body : bodies) {
      if (pattern == "lowest" || !is_named(body.id, pattern)) continue;
      body.fixed = found = true;
    }
    if (found) continue;
    std::vector<std::string> ids;
    for (const BodySpec& body : bodies)
      if (ids.size() < kMostCandidates) ids.push_back(body.id);
    const std::string near = nearest_name(pattern, ids);
    faults.add({"", "wall.supports", "\"" + pattern + "\"", "names no block of the file",
                near.empty()
                    ? fmt::format("write an id like {}, ids that begin alike with * at the end, or "
                                  "\"lowest\"",
                                  ids.empty() ? "b1" : ids.front())
                    : "did you mean " + near + "?",
                0});
  }
}

std::string bodies_text(const std::vector<BodySpec>& bodies, bool z_up) {
  nlohmann::json list = nlohmann::json::array();
  for (const BodySpec& body : bodies) {
    nlohmann::json parts = nlohmann::json::array();
    for (const Polyhedron& part : body.part) {
      nlohmann::json vertices = nlohmann::json::array();
      for (const Vec3 v : part.vertex)
        vertices.push_back(z_up ? nlohmann::json{v.x, -v.z, v.y} : nlohmann::json{v.x, v.y, v.z});
      parts.push_back({{"vertices", std::move(vertices)}, {"faces", part.face}});
    }
    list.push_back({{"id", body.id},
                    {"parts", std::move(parts)},
                    {"material", body.material},
                    {"fixed", body.fixed}});
    if (!body.role.empty()) list.back()["role"] = body.role;
    if (!body.cut.empty()) list.back()["cut"] = body.cut;
    if (!body.put_in.empty()) list.back()["put_in"] = body.put_in;
    const ZoneSpec& zone = body.zone;
    if (zone.zones == 0) continue;
    list.back()["zones"] = zone.zones;
    if (!std::isnan(zone.length)) list.back()["zone_length"] = zone.length;
    if (zone.kind != ZoneKind::kMixed)
      list.back()["zone_kind"] = word_of(kZoneKindWords, zone.kind);
    if (zone.plane != Plane::kStress) list.back()["plane"] = word_of(kPlaneWords, zone.plane);
  }
  return nlohmann::json{{"units", "m"}, {"up", z_up ? "z" : "y"}, {"blocks", std::move(list)}}.dump(
             1) +
         "\n";
}

}  // namespace wythe::io
