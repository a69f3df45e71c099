// Deformable blocks of the assembly -> grids of zones, and their faces -> contacts of zone edges.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/elementary.h"
#include "geometry/wall/joints.h"
#include "model/parts.h"
#include "solids/mesh.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Block;
using geometry::Face;
using geometry::Rect;

constexpr double kThinnest = 20;  // longest side of a zone over its shortest
constexpr int kMostZones = 20000;

// Key path of the zones of a block.
std::string path_of(const Block& block) {
  if (block.opening >= 0) return fmt::format("wall.opening.{}.lintel", block.opening);
  return "wall.blocks." + block.id;
}

class BodyBuilder {
 public:
  BodyBuilder(const ModelSpec& spec, Model& model, FaultList& faults)
      : spec_(spec), shape_(spec), model_(model), faults_(faults) {}

  void add(const Block& block) {
    path_ = path_of(block);
    sound_ = true;
    const auto found = spec_.material.find(block.material);
    if (found == spec_.material.end())
      return fault("material", block.material, "is no [material.*] table; zones need its moduli",
                   fmt::format("add [material.{}] with density, youngs_modulus, shear_modulus",
                               block.material));
    check_material(block.material, found->second);
    const double height = box_of(block).y1 - box_of(block).y0;
    size_ = std::isnan(block.zone.length) ? height / block.zone.zones : block.zone.length;
    body_ = {solids::elasticity_of(found->second, block.zone.plane), block.thickness,
             geometry::density_of(shape_, block)};
    if (is_upright(block))
      add_rectangle(block);
    else
      add_polygon(block);
    if (!sound_) return;
    SolidBody& added = model_.solids.bodies.back();
    added.id = block.id;
    added.role = block.role == geometry::Role::kLintel ? BlockRole::kLintel : BlockRole::kMasonry;
    added.tension_limit = found->second.tension_limit;
    added.compression_limit = found->second.compression_limit;
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + "." + key, std::move(value), std::move(problem), std::move(cure), 0});
    sound_ = false;
  }

  // Reports the faults of each material once, for any number of blocks.
  void check_material(const std::string& name, const JointMaterial& material) {
    const auto [state, is_new] = checked_.try_emplace(name, true);
    if (is_new)
      for (const MaterialFault& f : solids::check_elasticity(material)) {
        faults_.add({"", "material." + name + "." + f.key, f.value, f.problem, f.cure, 0});
        state->second = false;
      }
    sound_ = sound_ && state->second;
  }

  static Rect box_of(const Block& block) { return geometry::bounds(block.outline); }
  static bool is_upright(const Block& block) {
    const Rect box = box_of(block);
    const double size = std::max(box.x1 - box.x0, box.y1 - box.y0);
    return geometry::is_upright_rectangle(block.outline, 1e-6 * size);
  }

  void add_rectangle(const Block& block) {
    const Rect box = box_of(block);
    const double length = box.x1 - box.x0, height = box.y1 - box.y0;
    const double columns = std::clamp(std::round(length / size_), 1.0, 1e6);
    const solids::Grid grid{box.x0,          box.y0, box.x1, box.y1, static_cast<int>(columns),
                            block.zone.zones};
    const double w = length / grid.columns, h = height / grid.rows;
    check_count(columns * grid.rows);
    check_slenderness(std::max(w, h), std::min(w, h), w < h);
    if (!sound_) return;
    solids::add_grid(grid, block.zone.kind, body_, model_.solids);
    model_.anatomy.notes.push_back({"zones.grid",
                                    {{"block", block.id},
                                     {"columns", grid.columns},
                                     {"rows", grid.rows},
                                     {"width_mm", 1e3 * w},
                                     {"height_mm", 1e3 * h}}});
  }

  void add_polygon(const Block& block) {
    solids::Outline outline;
    double longest = 0;
    for (std::size_t k = 0; k < block.outline.size(); ++k) {
      const Vec2 p = block.outline[k], q = block.outline[(k + 1) % block.outline.size()];
      outline.x.push_back(p.x);
      outline.y.push_back(p.y);
      longest = std::max(longest, elementary::hypot(q.x - p.x, q.y - p.y));
    }
    const double parts = std::clamp(std::round(longest / size_), 1.0, 1e3);
    outline.parts = static_cast<int>(parts);
    check_count(parts * parts * static_cast<double>(outline.x.size()));
    if (!sound_) return;
    const solids::Triangles mesh = solids::triangulate(outline);
    check_slenderness(mesh.longest, mesh.shortest_height, false);
    if (!sound_) return;
    solids::add_triangles(mesh, body_, model_.solids);
    model_.anatomy.notes.push_back({"zones.triangles",
                                    {{"block", block.id},
                                     {"triangles", mesh.corner.size()},
                                     {"side_mm", 1e3 * mesh.longest}}});
  }

  void check_count(double zones) {
    if (zones > kMostZones)
      fault("zones", fmt::format("{:.0f} zones", zones),
            fmt::format("makes more than {} zones", kMostZones),
            "write fewer zones, or a greater zone_length");
  }

  void check_slenderness(double longest, double shortest, bool is_short) {
    if (longest <= kThinnest * shortest) return;
    fault(is_short ? "zone_length" : "zones",
          fmt::format("{:.3g} x {:.3g} mm", 1e3 * longest, 1e3 * shortest),
          fmt::format("zones are too thin: one way they are over {:g} times as long as the other",
                      kThinnest),
          is_short ? "write a greater zone_length"
                   : "write fewer zones through the depth or a smaller zone_length; cut a pointed "
                     "polygon into better shaped blocks");
  }

  const ModelSpec& spec_;
  const geometry::Shape shape_;
  Model& model_;
  FaultList& faults_;
  std::map<std::string, bool> checked_;
  std::string path_;
  solids::ZoneMaterial body_;
  double size_ = 0;  // requested length of a zone [m]
  bool sound_ = true;
};

// The common part of a face and an edge of a body's rim.
struct Overlap {
  int p, q;         // nodes
  double from, to;  // along the face, from its start [m]
  double share_0, share_1;
};

// Divides a face at the nodes of the body's rim: one contact for each covered edge.
class ContactBuilder {
 public:
  ContactBuilder(const Assembly& assembly, const BlockMap& map, Model& model)
      : assembly_(assembly), map_(map), m_(model), s_(model.solids) {
    reach_ = 2 * geometry::contact_tolerance(assembly.blocks);
  }

  void add(const SolidFace& solid) {
    const Face& face = *solid.face;
    const bool zone_is_b = is_solid(map_[face.b]);
    const int mine = zone_is_b ? face.b : face.a, other = zone_is_b ? face.a : face.b;
    const BlockId rigid = other == geometry::kGround ? kGroundBlock : map_[other];
    block_ = rigid == kGroundBlock ? m_.n_block : rigid;
    body_ = solid_of(map_[mine]);
    material_ = solid.material;
    thickness_ = assembly_.thickness_of(face);
    // n points from the rigid block to the zones, on the left of the face
    p0_ = zone_is_b ? face.p0 : face.p1;
    const Vec2 p1 = zone_is_b ? face.p1 : face.p0;
    length_ = elementary::hypot(p1.x - p0_.x, p1.y - p0_.y);
    t_ = {(p1.x - p0_.x) / length_, (p1.y - p0_.y) / length_};
    for (const Overlap& overlap : overlaps()) push(overlap);
  }

 private:
  // The rim has its zones on the left, so where it meets the face it runs along it.
  [[nodiscard]] std::vector<Overlap> overlaps() const {
    const std::vector<std::int32_t>& rim = s_.bodies[body_].rim;
    std::vector<Overlap> found;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const int p = rim[k], q = rim[(k + 1) % rim.size()];
      const Vec2 a = seen_from_start(p), b = seen_from_start(q);
      if (std::fabs(a.y) > reach_ || std::fabs(b.y) > reach_ || !(b.x > a.x)) continue;
      const double from = snap(std::max(a.x, 0.0), a.x, b.x);
      const double to = snap(std::min(b.x, length_), a.x, b.x);
      if (to - from <= kSame * (b.x - a.x)) continue;
      found.push_back({p, q, from, to, (from - a.x) / (b.x - a.x), (to - a.x) / (b.x - a.x)});
    }
    std::sort(found.begin(), found.end(),
              [](const Overlap& x, const Overlap& y) { return x.from < y.from; });
    return found;
  }

  // Coordinates along and across the face.
  [[nodiscard]] Vec2 seen_from_start(int node) const {
    const Vec2 d{s_.node_x[node] - p0_.x, s_.node_y[node] - p0_.y};
    return {d.x * t_.x + d.y * t_.y, d.y * t_.x - d.x * t_.y};
  }

  // A corner within this distance of a node coincides with it.
  static constexpr double kSame = 1e-6;  // of an edge
  static double snap(double at, double a, double b) {
    if (std::fabs(at - a) < kSame * (b - a)) return a;
    return std::fabs(at - b) < kSame * (b - a) ? b : at;
  }

  void push(const Overlap& o) {
    const bool ground = block_ == m_.n_block;
    const double cx = ground ? 0.0 : m_.centroid_x[block_];
    const double cy = ground ? 0.0 : m_.centroid_y[block_];
    s_.contact_block.push_back(block_);
    s_.contact_p.push_back(o.p);
    s_.contact_q.push_back(o.q);
    s_.share_0.push_back(o.share_0);
    s_.share_1.push_back(o.share_1);
    s_.arm_0_x.push_back(p0_.x + o.from * t_.x - cx);
    s_.arm_0_y.push_back(p0_.y + o.from * t_.y - cy);
    s_.arm_1_x.push_back(p0_.x + o.to * t_.x - cx);
    s_.arm_1_y.push_back(p0_.y + o.to * t_.y - cy);
    s_.contact_tangent_x.push_back(t_.x);
    s_.contact_tangent_y.push_back(t_.y);
    s_.contact_area.push_back((o.to - o.from) * thickness_);
    s_.contact_material.push_back(material_);
    ++s_.n_contact;
  }

  const Assembly& assembly_;
  const BlockMap& map_;
  Model& m_;
  Solids& s_;
  double reach_ = 0;  // distance of a node from the face [m]
  BlockId block_ = 0;
  int body_ = 0, material_ = 0;
  double thickness_ = 0, length_ = 0;
  Vec2 p0_, t_;
};

}  // namespace

void compile_solids(const ModelSpec& spec, const Assembly& assembly, Model& model,
                    FaultList& faults) {
  BodyBuilder builder(spec, model, faults);
  for (const Block& block : assembly.blocks)
    if (block.zone.zones > 0) builder.add(block);
}

void compile_contacts(const Assembly& assembly, const BlockMap& map, std::vector<SolidFace> faces,
                      Model& model, FaultList& faults) {
  const auto of = [&](int block) { return block == geometry::kGround ? kGroundBlock : map[block]; };
  std::stable_sort(faces.begin(), faces.end(), [&](const SolidFace& x, const SolidFace& y) {
    return model.stated(x.material) < model.stated(y.material);
  });
  ContactBuilder builder(assembly, map, model);
  for (const SolidFace& solid : faces) {
    if (is_solid(of(solid.face->a)) && is_solid(of(solid.face->b))) {
      const Block& block = assembly.blocks[solid.face->b];
      faults.add({"", path_of(block) + ".zones", "", "two blocks of zones touch each other",
                  "make one of them rigid, or put a rigid course between them", 0});
      continue;
    }
    builder.add(solid);
  }
  solids::join_nodes(model.solids);
}

}  // namespace wythe
