// A wall in space as arrays of a page: bodies and joint faces once,
// their motion and cracks in each state (web/src/wall/space.ts reads them).
//
//   space.vertex (3), face and corner lists of convex parts     at the start, seen from `middle`, so that
//   space.outline (3) of each joint's face                       places far from the origin stay exact
//   frame.moved, frame.turned (n_frame, n_body, 3)               zones follow the blocks, supports the zones
//
// A zone of a deformable block is a body of its own, which moves and turns
// like the mean of the zone. So the picture shows how a lintel bends.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "report/wall_arrays.h"
#include "wythe/parts/reading.h"

namespace wythe::report {
namespace {

void put(std::vector<float>& to, const Vec3& v) {
  to.insert(to.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

std::int32_t count_of(std::size_t n) { return static_cast<std::int32_t>(n); }

// The middle of the bounds of all moving bodies.
Vec3 middle_of(const Model& model) {
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  const auto widen = [&](const Vec3& v) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  };
  for (int b = 0; b < model.n_block; ++b)
    for (const Polyhedron& part : model.space.body[b].part)
      for (const Vec3& v : part.vertex) widen(v);
  for (const Vec3& v : model.space.solids.node) widen(v);
  return 0.5 * (low + high);
}

// Nested lists: the first index of each one in the list below it.
struct Parts {
  std::vector<std::int32_t> part_begin = {0}, vertex_begin = {0}, face_begin = {0},
                            corner_begin = {0};
  std::vector<float> vertex;
  std::vector<std::int32_t> corner;  // indices of vertices within their part

  void add(const BodySpec& body, const Vec3& middle) {
    for (const Polyhedron& part : body.part) {
      for (const Vec3& v : part.vertex) put(vertex, v - middle);
      for (const auto& face : part.face) {
        corner.insert(corner.end(), face.begin(), face.end());
        corner_begin.push_back(count_of(corner.size()));
      }
      vertex_begin.push_back(count_of(vertex.size() / 3));
      face_begin.push_back(count_of(corner_begin.size() - 1));
    }
    part_begin.push_back(count_of(vertex_begin.size() - 1));
  }
  void write(Bundle& bundle) const {
    bundle.add("space.part_begin", part_begin);
    bundle.add("space.vertex_begin", vertex_begin);
    bundle.add("space.face_begin", face_begin);
    bundle.add("space.corner_begin", corner_begin);
    bundle.add("space.corner", corner);
    bundle.add("space.vertex", vertex);
  }
};

// Blocks, zones and supports: the bodies of the page.
std::vector<BodySpec> bodies_shown(const Model& model) {
  const auto first = model.space.body.begin(), support = first + model.n_block;
  std::vector<BodySpec> bodies(first, support);
  for (std::size_t i = 0; i < bodies.size();
       ++i)  // not drawn, as on the page of a wall in the plane
    if (model.anatomy.block_role[i] == BlockRole::kCutOut) bodies[i].part.clear();
  const SpaceSolids& s = model.space.solids;
  for (const SpaceSolidBody& of : s.bodies)
    for (int z = of.first_zone; z < of.first_zone + of.n_zone; ++z) {
      BodySpec& body = bodies.emplace_back();
      body.id = of.body.id;
      body.material = of.body.material;
      Polyhedron& part = body.part.emplace_back();
      for (std::size_t k = 0; k < 8; ++k)
        part.vertex.push_back(s.node[s.corner[8 * static_cast<std::size_t>(z) + k]]);
      part.face = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                   {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    }
  bodies.insert(bodies.end(), support, model.space.body.end());
  return bodies;
}

// The number of a block or support among the bodies.
BlockId shown_as(const Model& model, BlockId id) {
  return id < model.n_block ? id : id + model.space.solids.n_zone;
}

// The zone that contains all four nodes of a contact's side.
std::int32_t zone_of(const SpaceSolids& s, std::size_t contact) {
  const SpaceSolidBody& body = s.bodies[s.contact_body[contact]];
  for (std::int32_t z = body.first_zone; z < body.first_zone + body.n_zone; ++z) {
    const auto corner = s.corner.begin() + 8 * static_cast<std::ptrdiff_t>(z);
    int found = 0;
    for (std::size_t k = 0; k < 4; ++k)
      found += std::find(corner, corner + 8, s.contact_node[4 * contact + k]) != corner + 8 ? 1 : 0;
    if (found == 4) return z;
  }
  return body.first_zone;
}

// Names of bodies and of their materials, each material once.
void add_names(Bundle& bundle, const std::vector<BodySpec>& bodies, Json& space) {
  std::unordered_map<std::string, std::int32_t> known;
  std::vector<std::int32_t> material;
  space["names"] = Json::array(), space["materials"] = Json::array();
  for (const BodySpec& body : bodies) {
    space["names"].push_back(body.id);
    const auto [entry, is_new] = known.try_emplace(body.material, count_of(known.size()));
    if (is_new) space["materials"].push_back(body.material);
    material.push_back(entry->second);
  }
  bundle.add("space.material", material);
}

void add_faces(Bundle& bundle, const Model& model, const Vec3& middle) {
  const SpaceSolids& s = model.space.solids;
  std::vector<std::int32_t> begin = {0};
  std::vector<float> outline;
  std::vector<std::uint8_t> kind;
  std::vector<BlockId> a, b;
  const auto add = [&](JointId joint, const std::vector<Vec3>& face, BlockId side_a,
                       BlockId side_b) {
    for (const Vec3& corner : face) put(outline, corner - middle);
    begin.push_back(count_of(outline.size() / 3));
    kind.push_back(static_cast<std::uint8_t>(joint_shape(model, joint).kind));
    a.push_back(shown_as(model, side_a));
    b.push_back(side_b);
  };
  for (std::size_t j = 0; j < static_cast<std::size_t>(model.n_joint); ++j)
    add(static_cast<JointId>(j), model.space.face[j], model.joint_a[j], model.joint_b[j]);
  for (std::size_t c = 0; c < static_cast<std::size_t>(s.n_contact); ++c)
    add(model.n_joint + static_cast<JointId>(c), s.contact_face[c], s.contact_block[c],
        model.n_block + zone_of(s, c));
  bundle.add("space.joint_a", a);
  bundle.add("space.joint_b", b);
  bundle.add("space.kind", kind);
  bundle.add("space.outline_begin", begin);
  bundle.add("space.outline", outline);
}

// Direction of the last driving stage, and the blocks that it drives; none for a load on all of them.
Json load_of(const Model& model) {
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage) {
    const StageKind kind = stage->spec.kind();
    const bool drives =
        kind == StageKind::kPush || kind == StageKind::kBodyForce || kind == StageKind::kTilt;
    if (!drives || !(dot(stage->drive(), stage->drive()) > 0)) continue;
    std::vector<BlockId> driven = stage->driven;
    for (BlockId& id : driven) id = shown_as(model, id);
    return {{"direction", {stage->drive_x, stage->drive_y, stage->drive_z}}, {"driven", driven}};
  }
  return nullptr;
}

// Ties, diaphragms and springs with their ends at the start. Both ends of a spring are where it holds its block; -1: the ground.
Json links_of(const Model& model, const Vec3& middle) {
  const Links& l = model.links;
  const std::vector<LinkReading> rest = read_links(model, initial_state(model));
  const auto place = [&](const Vec3& end) {
    const Vec3 p = end - middle;
    return Json{p.x, p.y, p.z};
  };
  const auto body = [&](BlockId block) {
    return block == kGroundBlock ? kGroundBlock : shown_as(model, block);
  };
  Json list = Json::array();
  for (std::size_t k = 0; k < rest.size(); ++k)
    list.push_back({{"name", l.name[k]},
                    {"kind", word_of(kLinkKindWords, l.kind[k])},
                    {"a", body(l.a[k])},
                    {"b", body(l.b[k])},
                    {"from", place(rest[k].ends[0])},
                    {"to", place(rest[k].ends[1])},
                    {"along", {l.span_x[k], l.span_y[k], l.span_z[k]}}});
  return list;
}

// As in docs/theory/links.md: a yielded link keeps a part of its elongation. A link with limit 0 does not yield.
std::uint8_t state_of(const Links& links, std::size_t k, const LinkReading& link) {
  constexpr double kYielded = 1e-6;  // of the elongation at the limit
  const double limit = link.plastic > 0 ? links.tension[k] : links.compression[k];
  if (limit > 0 && std::fabs(link.plastic) * links.stiffness[k] > kYielded * limit) return 2;
  return link.force == 0 && (links.tension[k] == 0 || links.compression[k] == 0) ? 1 : 0;
}

}  // namespace

void add_space(Bundle& bundle, const Model& model, Json& wall) {
  const Space& s = model.space;
  const Vec3 middle = middle_of(model);
  Json space = {{"supports", s.n_support},
                {"middle", {middle.x, middle.y, middle.z}},
                {"load", load_of(model)}};
  const std::vector<BodySpec> bodies = bodies_shown(model);
  add_names(bundle, bodies, space);
  if (model.links.n > 0) space["links"] = links_of(model, middle);
  wall["space"] = space;
  wall["joints"] = joint_count(model);
  Parts parts;
  for (const BodySpec& body : bodies) parts.add(body, middle);
  parts.write(bundle);
  std::vector<float> centroid;
  const auto support = s.centroid.begin() + model.n_block;
  std::for_each(s.centroid.begin(), support, [&](const Vec3& c) { put(centroid, c - middle); });
  for (const SpaceZoneReading& zone : read_space_zones(model, initial_state(model)))
    put(centroid, zone.middle - middle);
  std::for_each(support, s.centroid.end(), [&](const Vec3& c) { put(centroid, c - middle); });
  bundle.add("space.centroid", centroid);
  std::vector<std::uint8_t> role;
  for (const BlockRole one : model.anatomy.block_role)
    role.push_back(static_cast<std::uint8_t>(one));
  for (const SpaceSolidBody& body : s.solids.bodies)
    role.insert(role.end(), static_cast<std::size_t>(body.n_zone),
                static_cast<std::uint8_t>(body.role));
  bundle.add("space.role", role);
  add_faces(bundle, model, middle);
}

void SpaceFrames::add(const Model& model, const State& state) {
  const WallReading wall = read_wall(model, state);
  const auto put_three = [](std::vector<double>& to, const Vec3& v) {
    to.insert(to.end(), {v.x, v.y, v.z});
  };
  for (const BlockReading& block : wall.blocks) {
    put_three(moved_, block.moved);
    put_three(turned_, block.turned.by);
  }
  for (const SpaceZoneReading& zone : read_space_zones(model, state)) {
    put_three(moved_, zone.moved);
    put_three(turned_, zone.turned.by);
  }
  for (std::size_t i = 0; i < state.support_x.size(); ++i) {  // supports do not turn
    put_three(moved_, {state.support_x[i], state.support_y[i], state.support_z[i]});
    put_three(turned_, {});
  }
  for (const JointReading& joint : wall.joints) {
    const bool shown = !joint.handed_over;  // as in the plane (wall_arrays.cpp)
    opening_.push_back(shown ? std::fmax(0.0, joint.opening) : 0.0);
    slip_.push_back(shown ? joint.slip : 0.0);
    stress_.push_back(joint.normal_stress);
    damage_.push_back(shown ? share_byte(joint.damage) : std::uint8_t{0});
    crushing_.push_back(share_byte(joint.crushing));
  }
  if (model.links.n == 0) return;
  const std::vector<LinkReading> links = read_links(model, state);
  for (std::size_t k = 0; k < links.size(); ++k) {
    link_force_.push_back(links[k].force);
    link_state_.push_back(state_of(model.links, k, links[k]));
  }
}

void SpaceFrames::write(Bundle& bundle, int count) const {
  bundle.add_rounded("frame.moved", moved_, count);
  bundle.add_rounded("frame.turned", turned_, count);
  bundle.add_rounded("frame.opening", opening_, count);
  bundle.add_rounded("frame.slip", slip_, count);
  bundle.add_rounded("frame.stress", stress_, count);
  bundle.add("frame.damage", damage_);
  bundle.add("frame.crushing", crushing_);
  if (link_force_.empty()) return;
  bundle.add_rounded("frame.link_force", link_force_);
  bundle.add("frame.link_state", link_state_);
}

}  // namespace wythe::report
