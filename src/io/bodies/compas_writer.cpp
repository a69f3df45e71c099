// compas_json(): the blocks of a state as a COMPAS assembly (compas_assembly's, with a graph of blocks).
//
// COMPAS has z up: (x, y, z) of the wall becomes (x, -z, y). Files of other versions and how they are read:
// compas_json.cpp.
#include <nlohmann/json.hpp>

#include "wythe/parts/formats.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using Json = nlohmann::ordered_json;

// A plane outline, anticlockwise, as a prism on both sides of the plane.
Polyhedron prism_of(const std::vector<Vec3>& outline, double thickness) {
  Polyhedron prism;
  const auto n = static_cast<std::int32_t>(outline.size());
  for (const double side : {-0.5, 0.5})
    for (const Vec3& p : outline) prism.vertex.push_back({p.x, p.y, side * thickness});
  std::vector<std::int32_t> back, front;
  for (std::int32_t i = 0; i < n; ++i) {
    back.push_back(n - 1 - i);
    front.push_back(n + i);
    const std::int32_t next = (i + 1) % n;
    prism.face.push_back({i, next, n + next, n + i});
  }
  prism.face.push_back(std::move(back));
  prism.face.push_back(std::move(front));
  return prism;
}

Json mesh_of(const std::vector<Polyhedron>& parts, const std::string& name) {
  Json vertex = Json::object(), face = Json::object(), facedata = Json::object();
  std::int32_t first = 0, faces = 0;
  for (const Polyhedron& part : parts) {
    for (const Vec3& v : part.vertex)
      vertex[std::to_string(first + static_cast<std::int32_t>(&v - part.vertex.data()))] = {
          {"x", v.x}, {"y", -v.z}, {"z", v.y}};
    for (const std::vector<std::int32_t>& corners : part.face) {
      Json list = Json::array();
      for (const std::int32_t corner : corners) list.push_back(first + corner);
      facedata[std::to_string(faces)] = Json::object();
      face[std::to_string(faces++)] = std::move(list);
    }
    first += static_cast<std::int32_t>(part.vertex.size());
  }
  return {{"dtype", "compas_assembly.datastructures/Block"},
          {"data",
           {{"attributes", {{"name", name}}},
            {"default_vertex_attributes", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}}},
            {"default_edge_attributes", Json::object()},
            {"default_face_attributes", Json::object()},
            {"vertex", std::move(vertex)},
            {"face", std::move(face)},
            {"facedata", std::move(facedata)},
            {"edgedata", Json::object()},
            {"max_vertex", first - 1},
            {"max_face", faces - 1}}}};
}

class Assembly {
 public:
  // Adds a block under its number.
  void add(const std::vector<Polyhedron>& parts, const std::string& name, bool is_support) {
    node_[std::to_string(count_++)] = {{"block", mesh_of(parts, name)}, {"is_support", is_support}};
  }
  void join(std::int32_t a, std::int32_t b) {
    edge_[std::to_string(a)][std::to_string(b)] = Json::object();
  }
  [[nodiscard]] std::string text(const std::string& name) {
    for (int k = 0; k < count_; ++k)
      if (!edge_.contains(std::to_string(k))) edge_[std::to_string(k)] = Json::object();
    const Json graph = {{"attributes", Json::object()},
                        {"default_node_attributes", {{"is_support", false}}},
                        {"default_edge_attributes", Json::object()},
                        {"node", std::move(node_)},
                        {"edge", std::move(edge_)},
                        {"max_node", count_ - 1}};
    return Json{{"dtype", "compas_assembly.datastructures/Assembly"},
                {"data",
                 {{"attributes", {{"name", name}}},
                  {"graph", {{"dtype", "compas.datastructures/Graph"}, {"data", graph}}}}}}
               .dump() +
           "\n";
  }

 private:
  Json node_ = Json::object(), edge_ = Json::object();
  int count_ = 0;
};

void add_plane_supports(Assembly& assembly, const Anatomy& anatomy) {
  for (std::size_t s = 0; s + 1 < anatomy.support_begin.size(); ++s) {
    std::vector<Vec3> outline;
    for (int k = anatomy.support_begin[s]; k < anatomy.support_begin[s + 1]; ++k)
      outline.push_back({anatomy.support_x[k], anatomy.support_y[k], 0});
    assembly.add({prism_of(outline, anatomy.thickness)}, "support " + std::to_string(s), true);
  }
}

}  // namespace

std::string compas_json(const Model& model, const State& state) {
  const bool in_space = dimension_of(model) == 3;
  Assembly assembly;
  for (BlockId b = 0; b < model.n_block; ++b) {
    assembly.add(in_space ? solid_now(model, state, b)
                          : std::vector{prism_of(outline_now(model, state, b),
                                                 model.anatomy.block_thickness[b])},
                 model.anatomy.block_id[b], false);
  }
  if (in_space) {
    for (int s = 0; s < model.space.n_support; ++s)
      assembly.add(solid_now(model, state, model.n_block + s),
                   model.space.body[model.n_block + s].id, true);
    BlockId solid = model.n_block + model.space.n_support;
    for (const SpaceSolidBody& body : model.space.solids.bodies)
      assembly.add(solid_now(model, state, solid++), body.body.id, false);
  } else {
    add_plane_supports(assembly, model.anatomy);
  }
  for (JointId j = 0; j < model.n_joint; ++j) {
    const JointShape joint = joint_shape(model, j);
    if (joint.a >= 0 && joint.b >= 0 && joint.a != joint.b) assembly.join(joint.a, joint.b);
  }
  return assembly.text("wall");
}

}  // namespace wythe
