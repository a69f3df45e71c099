// Constant data of blocks and joints, and current places of these and of nodes. The step keeps
// places of its own; those here can be magnified for pictures.
#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "model/space/space_roles.h"
#include "reading/readers.h"
#include "reading/zones_in_space.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

const SolidBody& body_of(const Model& model, BlockId block) {
  return model.solids.bodies[block - model.n_block];
}

// Magnified rotations stay rotations up to a quarter turn; larger ones would make blocks spin.
Rotation magnified(const Rotation& rotation, double scale) {
  constexpr double kQuarter = 1.5707963267948966;
  const double angle = length(rotation.by);
  if (angle == 0 || angle > kQuarter) return rotation;
  return {std::min(angle * scale, kQuarter) * (rotation.by / angle)};
}

// Current place of the point of a rigid block that started at `arm` from its centroid.
Vec3 place(const BlockReading& block, Vec3 arm, double scale) {
  return turned(arm, magnified(block.turned, scale), block.start + scale * block.moved);
}

Vec3 node_at_start(const Model& model, int node) {
  return {model.solids.node_x[node], model.solids.node_y[node]};
}

// Value at a point of a zone's edge from its ends p and q (8.5).
Vec3 shared(double share, Vec3 p, Vec3 q) { return (1 - share) * p + share * q; }

// Initial place of point k of a contact.
Vec3 contact_at_start(const Model& model, int contact, int k) {
  const Solids& s = model.solids;
  return shared(k == 0 ? s.share_0[contact] : s.share_1[contact],
                node_at_start(model, s.contact_p[contact]),
                node_at_start(model, s.contact_q[contact]));
}

Vec3 contact_now(const Model& model, const State& state, int contact, int k, double scale) {
  const Solids& s = model.solids;
  const Vec3 moved =
      shared(k == 0 ? s.share_0[contact] : s.share_1[contact],
             node_moved(state, s.contact_p[contact]), node_moved(state, s.contact_q[contact]));
  return contact_at_start(model, contact, k) + scale * moved;
}

JointShape contact_shape(const Model& model, JointId joint) {
  const Solids& s = model.solids;
  const int c = joint - model.n_joint;
  JointShape shape;
  shape.id = joint;
  shape.kind = JointKind::kLintelBond;
  shape.a = s.contact_block[c] < model.n_block ? s.contact_block[c] : kGroundBlock;
  const auto body = std::find_if(s.bodies.begin(), s.bodies.end(), [&](const SolidBody& one) {
    return s.contact_p[c] < one.first_node + one.n_node;
  });
  shape.b = model.n_block + static_cast<BlockId>(body - s.bodies.begin());
  shape.material = s.contact_material[c];
  shape.area = s.contact_area[c];
  const Vec3 from = contact_at_start(model, c, 0), to = contact_at_start(model, c, 1);
  shape.centre = 0.5 * (from + to);
  shape.half = 0.5 * (to - from);
  shape.along = {s.contact_tangent_x[c], s.contact_tangent_y[c]};
  if (shape.a != kGroundBlock)
    shape.arm_a = {0.5 * (s.arm_0_x[c] + s.arm_1_x[c]), 0.5 * (s.arm_0_y[c] + s.arm_1_y[c])};
  return shape;
}

// Shape data of a face in both kinds of walls.
JointShape face_shape(const Model& m, JointId j) {
  JointShape shape;
  shape.id = j;
  shape.kind = m.anatomy.joint_kind[j];
  shape.a = m.joint_a[j];
  shape.b = m.joint_b[j];
  shape.material = m.joint_material[j];
  shape.area = m.area[j];
  return shape;
}

}  // namespace

namespace reading {

// Shape of a joint in space; its half vectors reach to the farthest points along t1 and t2.
JointShape shape_in_space(const Model& m, JointId j) {
  if (j >= m.n_joint) return contact_in_space(m, j - m.n_joint);
  JointShape shape = face_shape(m, j);
  const Space& s = m.space;
  if (shape.a >= m.n_block)
    shape.a = kGroundBlock;
  else
    shape.arm_a = s.arm_a[j];
  shape.arm_b = s.arm_b[j];
  shape.centre = s.centroid[shape.b] + shape.arm_b;
  shape.along = s.tangent[j];
  shape.normal = s.normal[j];
  double reach = 0, reach_2 = 0;
  for (auto p = s.point_begin[j]; p < s.point_begin[j + 1]; ++p) {
    reach = std::max(reach, std::fabs(s.point_r1[p]));
    reach_2 = std::max(reach_2, std::fabs(s.point_r2[p]));
  }
  shape.half = reach * shape.along;
  shape.half_2 = reach_2 * cross(shape.normal, shape.along);
  return shape;
}

JointShape shape_in_plane(const Model& m, JointId j) {
  const auto with_normal = [](JointShape shape) {
    shape.normal = {-shape.along.y, shape.along.x};
    return shape;
  };
  if (j >= m.n_joint) return with_normal(contact_shape(m, j));
  JointShape shape = face_shape(m, j);
  shape.arm_a = {m.arm_a_x[j], m.arm_a_y[j]};
  shape.arm_b = {m.arm_b_x[j], m.arm_b_y[j]};
  shape.centre = Vec3{m.centroid_x[shape.b], m.centroid_y[shape.b]} + shape.arm_b;
  shape.half = {m.half_x[j], m.half_y[j]};
  shape.along = {m.tangent_x[j], m.tangent_y[j]};
  return with_normal(shape);
}

PointRange range_in_space(const Model& model, JointId joint) {
  const int contact = joint - model.n_joint;
  const auto& begin = contact < 0 ? model.space.point_begin : model.space.solids.point_begin;
  const int i = contact < 0 ? joint : contact;
  return {begin[i], begin[i + 1]};
}

PointRange range_in_plane(const Model& model, JointId joint) {
  const int per = model.n_face_point, contact = joint - model.n_joint;
  if (contact < 0) return {joint * per, (joint + 1) * per};
  return {model.n_point() + 2 * contact, model.n_point() + 2 * (contact + 1)};
}

}  // namespace reading

int joint_count(const Model& model) {
  return model.n_joint + model.solids.n_contact + model.space.solids.n_contact;
}

bool has_unit_planes(const Model& model) {
  for (JointId j = 0; j < joint_count(model); ++j)
    if (joint_shape(model, j).kind == JointKind::kSplit) return true;
  return false;
}

bool is_unit_plane(const Model& model, JointId joint) {
  const JointShape shape = joint_shape(model, joint);
  if (shape.kind == JointKind::kSplit) return true;
  const bool may_be = dimension_of(model) == 3 && shape.a != kGroundBlock && joint < model.n_joint;
  if (!may_be) return false;
  const std::string unit = unit_of(model.anatomy.block_id[shape.a]);
  return !unit.empty() && unit == unit_of(model.anatomy.block_id[shape.b]);
}

int block_count(const Model& model) {
  return model.n_block + static_cast<int>(model.solids.bodies.size());
}

std::vector<Vec3> outline_of(const Model& model, BlockId block) {
  std::vector<Vec3> outline;
  if (model.anatomy.outline_x.empty()) return outline;
  if (block >= model.n_block) {
    for (const int node : body_of(model, block).rim) outline.push_back(node_at_start(model, node));
    return outline;
  }
  const Anatomy& a = model.anatomy;
  for (int i = a.outline_begin[block]; i < a.outline_begin[block + 1]; ++i)
    outline.push_back({a.outline_x[i], a.outline_y[i]});
  return outline;
}

namespace {

// Rotation vector of a unit quaternion, by less than a full turn.
Rotation rotation_of(double w, Vec3 v) {
  const double sine = length(v);
  if (sine == 0) return {};
  const double sense = w < 0 ? -1 : 1;
  return {2 * sense * elementary::atan2(sine, sense * w) / sine * v};
}

}  // namespace

namespace reading {

// Reading of a block, support n_block + i, or deformable block n_block + n_support + i.
BlockReading block_in_space(const Model& model, const State& s, BlockId block) {
  if (const int body = block - model.n_block - model.space.n_support; body >= 0)
    return body_in_space(model, s, body);
  if (block >= model.n_block) {
    const int i = block - model.n_block;
    return {block,
            BlockRole::kMasonry,
            model.space.centroid[block],
            {s.support_x[i], s.support_y[i], s.support_z[i]},
            {}};
  }
  return {block,
          model.anatomy.block_role[block],
          model.space.centroid[block],
          {s.ux[block], s.uy[block], s.uz[block]},
          rotation_of(s.qw[block], {s.qx[block], s.qy[block], s.qz[block]})};
}

BlockReading block_in_plane(const Model& model, const State& state, BlockId block) {
  if (block >= model.n_block) {
    const SolidBody& body = body_of(model, block);
    return {block,
            body.role,
            {0.5 * (body.x0 + body.x1), 0.5 * (body.y0 + body.y1)},
            node_moved(state, body.first_node),
            {}};
  }
  const BlockId i = block;
  return {block,
          model.anatomy.block_role[i],
          {model.centroid_x[i], model.centroid_y[i]},
          {state.ux[i], state.uy[i]},
          {{0, 0, state.theta[i]}}};
}

Vec3 displacement_in_plane(const Model&, const State& s, BlockId i, Vec3 arm) {
  const Vec3 tip = turned(arm, Rotation{{0, 0, s.theta[i]}});
  return Vec3{s.ux[i], s.uy[i], 0} + tip - arm;
}

Vec3 displacement_in_space(const Model&, const State& s, BlockId i, Vec3 arm) {
  const Vec3 v{s.qx[i], s.qy[i], s.qz[i]}, half = cross(v, arm) + s.qw[i] * arm;
  return Vec3{s.ux[i], s.uy[i], s.uz[i]} + 2.0 * cross(v, half);
}

double tilt_in_plane(const State& s, BlockId i) { return std::fabs(s.theta[i]); }

double tilt_in_space(const State& s, BlockId i) {
  return 2 * elementary::acos(std::min(1.0, std::fabs(s.qw[i])));
}

std::vector<Vec3> corners_in_space(const Model& model, BlockId block) {
  const int body = block - model.n_block - model.space.n_support;
  std::vector<Vec3> corners;
  for (const Polyhedron& part :
       body < 0 ? model.space.body[block].part : model.space.solids.bodies[body].body.part)
    corners.insert(corners.end(), part.vertex.begin(), part.vertex.end());
  return corners;
}

std::vector<Vec3> corners_now_in_plane(const Model& model, const State& state, BlockId block) {
  return outline_now(model, state, block);
}

std::vector<Vec3> corners_now_in_space(const Model& model, const State& state, BlockId block) {
  std::vector<Vec3> corners;
  for (const Polyhedron& part : solid_now(model, state, block))
    corners.insert(corners.end(), part.vertex.begin(), part.vertex.end());
  return corners;
}

double volume_in_plane(const Model& model, BlockId block) {
  const std::vector<Vec3> outline = outline_of(model, block);
  double area = 0;
  for (std::size_t p = 0, q = outline.size() - 1; p < outline.size(); q = p++)
    area += 0.5 * (outline[q].x * outline[p].y - outline[p].x * outline[q].y);
  return area * model.anatomy.block_thickness[block];
}

// Volume as a sum of tetrahedra with the origin.
double volume_in_space(const Model& model, BlockId block) {
  double volume = 0;
  for (const Polyhedron& part : model.space.body[block].part)
    for (const auto& face : part.face)
      for (std::size_t k = 1; k + 1 < face.size(); ++k)
        volume +=
            dot(part.vertex[face[0]], cross(part.vertex[face[k]], part.vertex[face[k + 1]])) / 6;
  return volume;
}

}  // namespace reading

std::vector<Vec3> outline_now(const Model& model, const State& state, BlockId block, double scale) {
  std::vector<Vec3> outline;
  if (block >= model.n_block) {
    for (const int node : body_of(model, block).rim)
      outline.push_back(node_now(model, state, node, scale));
    return outline;
  }
  const BlockReading now = read_block(model, state, block);
  outline = outline_of(model, block);
  for (Vec3& corner : outline) corner = place(now, corner - now.start, scale);
  return outline;
}

Vec3 node_moved(const State& state, int node) { return {state.node_ux[node], state.node_uy[node]}; }

Vec3 node_now(const Model& model, const State& state, int node, double scale) {
  return node_at_start(model, node) + scale * node_moved(state, node);
}

namespace {

// Current places midway between the two sides of a joint.
std::vector<Vec3> between_faces(const Model& model, const State& state, JointId joint,
                                std::vector<Vec3> places, double scale) {
  const BlockReading a = read_block(model, state, model.joint_a[joint]);
  const BlockReading b = read_block(model, state, model.joint_b[joint]);
  for (Vec3& p : places) p = 0.5 * (place(a, p - a.start, scale) + place(b, p - b.start, scale));
  return places;
}

// The same for a contact of zones, on its rigid side.
std::vector<Vec3> on_rigid_side(const Model& model, const State& state, int contact,
                                std::vector<Vec3> places, double scale) {
  const BlockReading a = read_block(model, state, model.space.solids.contact_block[contact]);
  for (Vec3& p : places) p = place(a, p - a.start, scale);
  return places;
}

}  // namespace

std::vector<Vec3> reading::face_in_plane(const Model& model, const State& state, JointId joint,
                                         double scale) {
  const std::array<Vec3, 2> ends = ends_in_plane(model, state, joint, scale);
  return {ends.begin(), ends.end()};
}

std::vector<Vec3> reading::face_in_space(const Model& model, const State& state, JointId joint,
                                         double scale) {
  if (const int contact = joint - model.n_joint; contact >= 0)
    return on_rigid_side(model, state, contact, model.space.solids.contact_face[contact], scale);
  return between_faces(model, state, joint, model.space.face[joint], scale);
}

std::vector<Polyhedron> solid_now(const Model& model, const State& state, BlockId block,
                                  double scale) {
  const int body = block - model.n_block - model.space.n_support;
  std::vector<Polyhedron> parts =
      body < 0 ? model.space.body[block].part : model.space.solids.bodies[body].body.part;
  const BlockReading now = read_block(model, state, block);
  for (Polyhedron& part : parts)
    for (Vec3& vertex : part.vertex) vertex = place(now, vertex - now.start, scale);
  return parts;
}

std::array<Vec3, 2> reading::ends_in_space(const Model& model, const State& state, JointId joint,
                                           double scale) {
  const JointShape shape = joint_shape(model, joint);
  const std::vector<Vec3> places{shape.centre - shape.half, shape.centre + shape.half};
  const int contact = joint - model.n_joint;
  const std::vector<Vec3> ends = contact < 0 ? between_faces(model, state, joint, places, scale)
                                             : on_rigid_side(model, state, contact, places, scale);
  return {ends[0], ends[1]};
}

std::array<Vec3, 2> reading::ends_in_plane(const Model& model, const State& state, JointId joint,
                                           double scale) {
  if (const int contact = joint - model.n_joint; contact >= 0)
    return {contact_now(model, state, contact, 0, scale),
            contact_now(model, state, contact, 1, scale)};
  const JointShape shape = joint_shape(model, joint);
  const BlockReading b = read_block(model, state, shape.b);
  std::array<Vec3, 2> ends;
  for (const int side : {0, 1}) {
    const Vec3 half = (side == 0 ? -1.0 : 1.0) * shape.half, arm_b = shape.arm_b + half;
    const Vec3 on_b = place(b, arm_b, scale);
    const Vec3 on_a = shape.a == kGroundBlock
                          ? b.start + arm_b
                          : place(read_block(model, state, shape.a), shape.arm_a + half, scale);
    ends[side] = 0.5 * (on_a + on_b);
  }
  return ends;
}

}  // namespace wythe
