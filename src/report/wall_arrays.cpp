#include "report/wall_arrays.h"

#include <algorithm>
#include <cmath>

#include "dynamics/zone_state.h"
#include "model/deformed.h"

namespace wythe::report {
namespace {

template <class To, class From>
std::vector<To> as(const std::vector<From>& values) {
  std::vector<To> out;
  out.reserve(values.size());
  for (const From& v : values) out.push_back(static_cast<To>(v));
  return out;
}

void add_floats(Bundle& bundle, const std::string& name, const std::vector<double>& values) {
  bundle.add(name, std::span<const float>(as<float>(values)));
}

// What one joint shows: the largest of its points, and the resultant of their stresses.
struct JointFace {
  double opening = -HUGE_VAL, slip = 0, damage = 0, crushing = 0;
  double compression = 0, shear = 0, moment = 0;  // [N], [N], [N] per half face
};

// `area` and `xi` of each point: of the face it stands for, and where on it from -1 to 1.
template <class Area, class Xi>
JointFace face_of(const PointStress* points, int count, Area area, Xi xi) {
  JointFace face;
  for (int k = 0; k < count; ++k) {
    const PointStress& p = points[k];
    face.opening = std::fmax(face.opening, p.opening);
    if (std::fabs(p.slip) > std::fabs(face.slip)) face.slip = p.slip;
    face.damage = std::fmax(face.damage, p.damage);
    face.crushing = std::fmax(face.crushing, p.crushing);
    face.compression -= area(k) * p.normal_stress;
    face.shear += area(k) * p.shear_stress;
    face.moment -= area(k) * p.normal_stress * xi(k);
  }
  return face;
}

// All joints, then all contacts of zones.
std::vector<JointFace> faces_of(const Model& model, const State& state) {
  std::vector<JointFace> faces;
  const std::vector<PointStress> points = point_stresses(model, state);
  for (JointId j = 0; j < model.n_joint; ++j)
    faces.push_back(face_of(
        &points[j * model.n_face_point], model.n_face_point,
        [&](int k) { return model.area[j] * model.point_weight[k]; },
        [&](int k) { return model.point_xi[k]; }));
  const std::vector<PointStress> contacts = dynamics::contact_stresses(model, state);
  for (std::size_t c = 0; 2 * c < contacts.size(); ++c)
    faces.push_back(face_of(
        &contacts[2 * c], 2, [&](int) { return 0.5 * model.solids.contact_area[c]; },
        [](int k) { return 2.0 * k - 1; }));
  return faces;
}

// The stage that pushes, or nullptr.
const Stage* push_of(const Model& model) {
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage)
    if (!stage->driven.empty()) return &*stage;
  return nullptr;
}

template <class T, class Make>
std::vector<T> followed(std::vector<T> list, std::size_t count, Make make) {
  for (std::size_t i = 0; i < count; ++i) list.push_back(static_cast<T>(make(i)));
  return list;
}

// Deformable blocks follow the rigid ones, each with the nodes of its rim as its outline.
void add_blocks(Bundle& bundle, const Model& model) {
  const Anatomy& a = model.anatomy;
  const Solids& s = model.solids;
  std::vector<std::int32_t> rim, begin(a.outline_begin.begin(), a.outline_begin.end());
  for (const SolidBody& body : s.bodies) {
    rim.insert(rim.end(), body.rim.begin(), body.rim.end());
    begin.push_back(begin.back() + static_cast<std::int32_t>(body.rim.size()));
  }
  bundle.add("wall.outline_begin", std::span<const std::int32_t>(begin));
  add_floats(bundle, "wall.outline_x",
             followed(a.outline_x, rim.size(), [&](auto i) { return s.node_x[rim[i]]; }));
  add_floats(bundle, "wall.outline_y",
             followed(a.outline_y, rim.size(), [&](auto i) { return s.node_y[rim[i]]; }));
  const std::size_t n = s.bodies.size();
  const auto body = [&](std::size_t i) -> const SolidBody& { return s.bodies[i]; };
  add_floats(bundle, "wall.centroid_x", followed(model.centroid_x, n, [&](auto i) {
               return 0.5 * (body(i).x0 + body(i).x1);
             }));
  add_floats(bundle, "wall.centroid_y", followed(model.centroid_y, n, [&](auto i) {
               return 0.5 * (body(i).y0 + body(i).y1);
             }));
  add_floats(bundle, "wall.thickness", followed(a.block_thickness, n, [&](auto i) {
               return s.shapes[s.zone_shape[body(i).first_zone]].thickness;
             }));
  const auto roles = followed(a.block_role, n, [&](auto i) { return body(i).role; });
  bundle.add("wall.role", std::span<const std::uint8_t>(as<std::uint8_t>(roles)));
  if (n == 0) return;
  bundle.add("wall.rim", std::span<const std::int32_t>(rim));
  add_floats(bundle, "wall.node_x", s.node_x);
  add_floats(bundle, "wall.node_y", s.node_y);
  std::vector<std::int32_t> corners;  // four a zone
  for (int z = 0; z < s.n_zone; ++z)
    for (const auto& corner : s.corner) corners.push_back(corner[z]);
  bundle.add("wall.zone", std::span<const std::int32_t>(corners));
}

// Contacts of zones follow the joints: between a block and a deformable one, along an edge.
void add_joints(Bundle& bundle, const Model& model) {
  const Solids& s = model.solids;
  const auto n = static_cast<std::size_t>(s.n_contact);
  State rest;
  rest.node_ux.assign(s.n_node, 0), rest.node_uy.assign(s.n_node, 0);
  const auto half = [&](std::size_t c, double PlacedPoint::*along) {
    const auto ends = placed_contact(model, rest, static_cast<int>(c));
    return 0.5 * (ends[1].*along - ends[0].*along);
  };
  const auto body_at = [&](std::size_t c) {
    const auto after = std::find_if(s.bodies.begin(), s.bodies.end(), [&](const SolidBody& body) {
      return s.contact_p[c] < body.first_node + body.n_node;
    });
    return model.n_block + (after - s.bodies.begin());
  };
  const auto add_blocks_of = [&](const char* name, const std::vector<BlockId>& joints, auto make) {
    bundle.add(name, std::span<const BlockId>(followed(joints, n, make)));
  };
  add_blocks_of("wall.joint_a", model.joint_a, [&](auto c) {
    return s.contact_block[c] < model.n_block ? s.contact_block[c] : kGroundBlock;
  });
  add_blocks_of("wall.joint_b", model.joint_b, body_at);
  const auto kinds =
      followed(model.anatomy.joint_kind, n, [](auto) { return JointKind::kLintelBond; });
  bundle.add("wall.kind", std::span<const std::uint8_t>(as<std::uint8_t>(kinds)));
  add_floats(bundle, "wall.half_x",
             followed(model.half_x, n, [&](auto c) { return half(c, &PlacedPoint::x); }));
  add_floats(bundle, "wall.half_y",
             followed(model.half_y, n, [&](auto c) { return half(c, &PlacedPoint::y); }));
  add_floats(bundle, "wall.arm_a_x", model.arm_a_x);  // of joints only
  add_floats(bundle, "wall.arm_a_y", model.arm_a_y);
  add_floats(bundle, "wall.arm_b_x", model.arm_b_x);
  add_floats(bundle, "wall.arm_b_y", model.arm_b_y);
  if (n == 0) return;
  bundle.add("wall.contact_p", std::span<const std::int32_t>(s.contact_p));
  bundle.add("wall.contact_q", std::span<const std::int32_t>(s.contact_q));
  add_floats(bundle, "wall.share_0", s.share_0);
  add_floats(bundle, "wall.share_1", s.share_1);
}

}  // namespace

void add_wall(Bundle& bundle, const Model& model) {
  const Anatomy& a = model.anatomy;
  const Solids& s = model.solids;
  const int bodies = static_cast<int>(s.bodies.size());
  Json wall = {{"length", a.length},
               {"height", a.height},
               {"thickness", a.thickness},
               {"courses", a.courses},
               {"blocks", model.n_block + bodies},
               {"joints", model.n_joint + s.n_contact},
               {"pairs", model.n_pair}};
  if (bodies > 0) {
    wall["bodies"] = bodies, wall["nodes"] = s.n_node, wall["zones"] = s.n_zone;
    wall["contacts"] = s.n_contact;
  }
  if (const Stage* push = push_of(model)) {
    wall["push"] = {push->drive_x, push->drive_y};
    wall["load_height"] = push->load_height;
    bundle.add("wall.driven", std::span<const BlockId>(push->driven));
  }
  bundle.header["wall"] = wall;
  add_blocks(bundle, model);
  add_joints(bundle, model);
  bundle.add("wall.support_begin", std::span<const int>(a.support_begin));
  add_floats(bundle, "wall.support_x", a.support_x);
  add_floats(bundle, "wall.support_y", a.support_y);
}

int states_kept(int states, int room, int samples_after) {
  if (states <= room - samples_after) return states;
  return std::min({states, room, 1});
}

void FrameArrays::add(const Model& model, const State& state) {
  ++count_;
  ux_.insert(ux_.end(), state.ux.begin(), state.ux.end());
  uy_.insert(uy_.end(), state.uy.begin(), state.uy.end());
  theta_.insert(theta_.end(), state.theta.begin(), state.theta.end());
  for (const SolidBody& body : model.solids.bodies) {  // its first node stands for it
    ux_.push_back(state.node_ux[body.first_node]);
    uy_.push_back(state.node_uy[body.first_node]);
    theta_.push_back(0);
  }
  node_ux_.insert(node_ux_.end(), state.node_ux.begin(), state.node_ux.end());
  node_uy_.insert(node_uy_.end(), state.node_uy.begin(), state.node_uy.end());
  for (const ZoneStress& zone : zone_stresses(model, state)) {
    const auto [greater, smaller] = dynamics::principal_stresses(zone);
    greater_.push_back(greater);
    smaller_.push_back(smaller);
  }
  for (const JointFace& face : faces_of(model, state)) {
    opening_.push_back(std::fmax(0.0, face.opening));
    slip_.push_back(face.slip);
    damage_.push_back(share_byte(face.damage));
    crushing_.push_back(share_byte(face.crushing));
    if (!with_forces_) continue;
    compression_.push_back(face.compression);
    shear_.push_back(face.shear);
    const bool presses = face.compression > 0;
    eccentricity_.push_back(presses ? std::clamp(face.moment / face.compression, -1.0, 1.0) : 0.0);
  }
}

void FrameArrays::write(Bundle& bundle) const {
  bundle.add_rounded("frame.ux", ux_);
  bundle.add_rounded("frame.uy", uy_);
  bundle.add_rounded("frame.theta", theta_);
  if (!node_ux_.empty()) {
    bundle.add_rounded("frame.node_ux", node_ux_);
    bundle.add_rounded("frame.node_uy", node_uy_);
    bundle.add_rounded("frame.zone_greater", greater_);
    bundle.add_rounded("frame.zone_smaller", smaller_);
  }
  bundle.add_rounded("frame.opening", opening_);
  bundle.add_rounded("frame.slip", slip_);
  bundle.add("frame.damage", std::span<const std::uint8_t>(damage_));
  bundle.add("frame.crushing", std::span<const std::uint8_t>(crushing_));
  if (!with_forces_) return;
  bundle.add_rounded("frame.compression", compression_);
  bundle.add_rounded("frame.shear", shear_);
  bundle.add_rounded("frame.eccentricity", eccentricity_);
}

}  // namespace wythe::report
