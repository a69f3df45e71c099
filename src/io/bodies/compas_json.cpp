// COMPAS: assemblies (compas_assembly, compas_cra), block models (compas_dem, compas_model), lists of meshes.
//
//   {"dtype": ".../Assembly", "data": {"graph": {"data": {"node": {"0": {"block": {"data": mesh}}}}}}}
//   {"dtype": ".../BlockModel", "data": {"elements": {guid: {"data": {"geometry": {"data": mesh},
//     "is_support": true}}}, "graph": {"node": {"0": {"element": guid}}}}}
//   [[mesh], [mesh], ...]
//   {"assembly": {"node": {"0": {"is_support": true}}}, "blocks": {"0": mesh}}          before 1.0
//
// Versions differ in many ways. "data" or "value" around an object, once, twice or not at all; elements in a
// list or by guid; a mesh under block, geometry, shape or mesh; keys of corners as texts; faces as lists of
// corners or as half-edges, from each corner to the next; coordinates left out where they are the default.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/limits.h"
#include "core/number.h"
#include "io/bodies/bodies_file.h"

namespace wythe::io {
namespace {

constexpr const char* kShapes[] = {"block", "geometry", "shape", "mesh", "_geometry"};

// The object itself, without its wrappers.
const nlohmann::json& opened(const nlohmann::json& json) {
  const nlohmann::json* inner = &json;
  for (int depth = 0; depth < kMostDepth && inner->is_object(); ++depth) {
    if (inner->contains("data") && (*inner)["data"].is_structured())
      inner = &(*inner)["data"];
    else if (inner->contains("value") && (*inner)["value"].is_structured())
      inner = &(*inner)["value"];
    else
      break;
  }
  return *inner;
}

bool is_mesh(const nlohmann::json& json) {
  return json.is_object() && json.contains("vertex") && json.contains("face") &&
         json["vertex"].is_object() && json["face"].is_object();
}

bool is_before_1(const nlohmann::json& json) {
  return json.is_object() && json.contains("assembly") && json["assembly"].is_object() &&
         json.contains("blocks") && json["blocks"].is_object();
}

bool is_flagged(const nlohmann::json& json, const char* name) {
  return json.is_object() && json.contains(name) && json[name].is_boolean() &&
         json[name].get<bool>();
}

std::string key_text(const nlohmann::json& key) {
  return key.is_string() ? key.get<std::string>() : key.dump();
}

// Keys that are numbers in ascending order, then the others.
std::vector<std::string> sorted_keys(const nlohmann::json& object) {
  std::vector<std::pair<long long, std::string>> keys;
  for (const auto& item : object.items()) {
    const auto number = leading_number<long long>(item.key());
    keys.emplace_back(number ? number->value : std::numeric_limits<long long>::max(), item.key());
  }
  std::stable_sort(keys.begin(), keys.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> sorted;
  for (auto& [number, text] : keys) sorted.push_back(std::move(text));
  return sorted;
}

class CompasReader {
 public:
  CompasReader(const std::string& file, FaultList& faults) : file_(file), faults_(faults) {}

  std::vector<BodySpec> read(const nlohmann::json& json) {
    const nlohmann::json& top = opened(json);
    if (is_before_1(top))
      parse_before_1(top);
    else if (top.is_array())
      parse_list(top);
    else if (top.is_object() && top.contains("elements"))
      parse_elements(top);
    else if (top.is_object() && graph_of(top) != nullptr)
      parse_nodes(*graph_of(top));
    else
      parse_block("0", json, false);
    if (bodies_.empty() && faults_.empty())
      refuse("", "holds no block", "save an assembly, a block model or a list of meshes");
    return std::move(bodies_);
  }

 private:
  void refuse(const std::string& value, const std::string& problem, const std::string& cure) {
    if (!enough(faults_)) faults_.add({file_, "", value, problem, cure, 0});
  }

  static const nlohmann::json* graph_of(const nlohmann::json& top) {
    const nlohmann::json* graph = top.contains("graph") ? &opened(top["graph"]) : &top;
    return graph->is_object() && graph->contains("node") && (*graph)["node"].is_object() ? graph
                                                                                         : nullptr;
  }

  void parse_list(const nlohmann::json& list) {
    int number = 0;
    for (const nlohmann::json& item : list)
      parse_block(std::to_string(number++), item.is_array() && item.size() == 1 ? item[0] : item,
                  false);
  }

  // Parses blocks by the keys of their nodes.
  void parse_before_1(const nlohmann::json& top) {
    const nlohmann::json& graph = opened(top["assembly"]);
    const nlohmann::json nodes = graph.is_object() ? graph.value("node", nlohmann::json::object())
                                                   : nlohmann::json::object();
    for (const std::string& key : sorted_keys(top["blocks"]))
      parse_block(key, top["blocks"][key],
                  nodes.is_object() && nodes.contains(key) && is_flagged(nodes[key], "is_support"));
  }

  void parse_nodes(const nlohmann::json& graph) {
    const nlohmann::json defaults =
        graph.value("default_node_attributes", nlohmann::json::object());
    const bool fixed = is_flagged(defaults, "is_support");
    for (const std::string& key : sorted_keys(graph["node"])) {
      const nlohmann::json& node = graph["node"][key];
      const bool own =
          node.is_object() && node.contains("is_support") && !node["is_support"].is_null();
      parse_block(key, node, own ? is_flagged(node, "is_support") : fixed);
    }
  }

  // Parses elements in the order of the graph, if there is one, because it numbers the blocks.
  void parse_elements(const nlohmann::json& top) {
    const nlohmann::json& elements = top["elements"];
    if (elements.is_array()) return parse_list(elements);
    if (!elements.is_object()) return refuse("elements", "is no list of blocks", "save it again");
    std::map<std::string, bool> taken;
    if (const nlohmann::json* graph = graph_of(top))
      for (const std::string& key : sorted_keys((*graph)["node"])) {
        const nlohmann::json& node = (*graph)["node"][key];
        const nlohmann::json guid =
            node.is_object() ? node.value("element", nlohmann::json()) : nlohmann::json();
        if (!guid.is_string() || !elements.contains(guid.get<std::string>())) continue;
        if (!taken.emplace(guid.get<std::string>(), true).second) continue;
        parse_block(key, elements[guid.get<std::string>()], false);
      }
    for (const auto& item : elements.items())
      if (!taken.contains(item.key()))
        parse_block(std::to_string(bodies_.size()), item.value(), false);
  }

  // Parses a block from a node, an element or a mesh, with the data on the way to the mesh.
  void parse_block(const std::string& id, const nlohmann::json& json, bool fixed) {
    if (enough(faults_)) return;
    const nlohmann::json* inner = &opened(json);
    std::vector<const nlohmann::json*> moves;
    for (int depth = 0; depth < kMostDepth && inner->is_object() && !is_mesh(*inner); ++depth) {
      fixed = fixed || is_flagged(*inner, "is_support");
      if (inner->contains("transformation")) moves.push_back(&(*inner)["transformation"]);
      if (inner->contains("features") && (*inner)["features"].is_array() &&
          !(*inner)["features"].empty())
        refuse("block " + id, "has features (cuts, holes), which only COMPAS can apply",
               "save the block's final geometry");
      const auto shape =
          std::find_if(std::begin(kShapes), std::end(kShapes), [&](const char* name) {
            return inner->contains(name) && (*inner)[name].is_structured();
          });
      if (shape == std::end(kShapes)) break;
      inner = &opened((*inner)[*shape]);
    }
    if (!is_mesh(*inner)) return refuse("block " + id, "has no mesh", "save blocks as meshes");
    if (inner->contains("attributes"))
      fixed = fixed || is_flagged((*inner)["attributes"], "is_support");
    BodySpec body;
    body.id = id;
    body.fixed = fixed;
    parse_mesh(*inner, body);
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) transform(**move, body);
    if (!body.part.empty()) bodies_.push_back(std::move(body));
  }

  static double coordinate(const nlohmann::json& mesh, const nlohmann::json& corner,
                           const char* axis) {
    for (const char* name : {"default_vertex_attributes", "dva"})
      if (!corner.contains(axis) && mesh.contains(name) && mesh[name].is_object() &&
          mesh[name].contains(axis) && mesh[name][axis].is_number())
        return mesh[name][axis].get<double>();
    if (!corner.contains(axis)) return 0;
    return corner[axis].is_number() ? corner[axis].get<double>() : std::nan("");
  }

  void parse_mesh(const nlohmann::json& mesh, BodySpec& body) {
    Polyhedron part;
    std::map<std::string, std::int32_t> number;
    for (const std::string& key : sorted_keys(mesh["vertex"])) {
      const nlohmann::json& corner = mesh["vertex"][key];
      Vec3 at = {std::nan(""), 0, 0};
      if (corner.is_object())
        at = {coordinate(mesh, corner, "x"), coordinate(mesh, corner, "y"),
              coordinate(mesh, corner, "z")};
      if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
        return refuse("block " + body.id, "vertex " + key + " has no finite coordinates",
                      "correct it");
      number[key] = static_cast<std::int32_t>(part.vertex.size());
      part.vertex.push_back(at);
    }
    for (const std::string& key : sorted_keys(mesh["face"])) {
      std::vector<std::int32_t> face;
      for (const std::string& corner : corners_of(mesh["face"][key])) {
        const auto found = number.find(corner);
        if (found == number.end())
          return refuse("block " + body.id,
                        "face " + key + " names the vertex " + corner + ", which is not there",
                        "save it again");
        face.push_back(found->second);
      }
      if (face.size() < 3)
        return refuse("block " + body.id, "face " + key + " has fewer than three corners",
                      "save it again");
      part.face.push_back(std::move(face));
    }
    if (part.face.empty())
      return refuse("block " + body.id, "has no face", "save it as a closed mesh");
    body.part.push_back(std::move(part));
  }

  // A list of keys, or half-edges {"3": "7", "7": "5", ...} from each corner to the next.
  static std::vector<std::string> corners_of(const nlohmann::json& face) {
    std::vector<std::string> corners;
    if (face.is_array())
      for (const nlohmann::json& key : face) corners.push_back(key_text(key));
    if (!face.is_object() || face.empty()) return corners;
    const std::string first = face.begin().key();
    for (std::string key = first; corners.size() < face.size();) {
      corners.push_back(key);
      if (!face.contains(key)) return {};
      key = key_text(face[key]);
      if (key == first) break;
    }
    return corners.size() == face.size() ? corners : std::vector<std::string>{};
  }

  // {"dtype": ".../Transformation", "data": {"matrix": 4 x 4}}
  void transform(const nlohmann::json& json, BodySpec& body) {
    if (json.is_null()) return;
    const nlohmann::json& inner = opened(json);
    const nlohmann::json rows = inner.is_object() ? inner.value("matrix", nlohmann::json()) : inner;
    double m[3][4];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const bool good = rows.is_array() && rows.size() == 4 && rows[i].is_array() &&
                          rows[i].size() == 4 && rows[i][k].is_number();
        if (!good)
          return refuse("block " + body.id, "has a transformation that is no matrix of 4 x 4",
                        "save it again");
        m[i][k] = rows[i][k].get<double>();
      }
    for (Polyhedron& part : body.part)
      for (Vec3& v : part.vertex)
        v = {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z + m[0][3],
             m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z + m[1][3],
             m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z + m[2][3]};
  }

  const std::string& file_;
  FaultList& faults_;
  std::vector<BodySpec> bodies_;
};

}  // namespace

bool is_compas(const nlohmann::json& json) {
  if (json.is_object() && (json.contains("dtype") || is_before_1(opened(json)))) return true;
  return json.is_array() && !json.empty();
}

std::vector<BodySpec> compas_bodies(const nlohmann::json& json, const std::string& file,
                                    FaultList& faults) {
  return CompasReader(file, faults).read(json);
}

}  // namespace wythe::io
