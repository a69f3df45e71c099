// Evaluates the joint law at every point of a wall in space with a state's history, and sums over points of joints.
// Shear is a vector: the law receives the length of the elastic slip, and its stress has the same direction. A joint that a
// free contact replaces carries nothing. docs/theory/space.md, "Shear as a vector".
#include "reading/readers.h"

#include <algorithm>
#include <cmath>

#include "contact/face_in_space.h"
#include "contact/law.h"
#include "contact/parameters.h"
#include "core/elementary.h"
#include "model/fields.h"
#include "reading/space_frames.h"
#include "reading/zones_in_space.h"

namespace wythe::reading {
namespace {

using Vec = Vector<double>;

Vec vec(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vec3(const Vec& v) { return {v.x, v.y, v.z}; }

contact::Pose<double> pose_of(const State& s, BlockId block) { return pose_in_space(s, block); }

// The gap of joint j, and the frame of its components.
struct Gap {
  contact::FaceGap<double> gap;
  contact::Frame<double> frame;
};
Gap gap_of(const Model& m, const State& s, JointId joint) {
  const Space& w = m.space;
  const contact::Pose<double> b = pose_of(s, m.joint_b[joint]);
  if (const int support = m.joint_a[joint] - m.n_block; support >= 0) {
    const contact::SupportFace<double> face(
        {s.support_x[support], s.support_y[support], s.support_z[support]}, b, vec(w.arm_b[joint]),
        vec(w.tangent[joint]), vec(w.normal[joint]));
    return {face.gap(), face.frame};
  }
  const contact::PairFace<double> face(pose_of(s, m.joint_a[joint]), b, vec(w.arm_a[joint]),
                                       vec(w.arm_b[joint]), vec(w.tangent[joint]),
                                       vec(w.normal[joint]));
  return {face.gap(), face.frame};
}

contact::History<double> history_of(const State& s, std::size_t p) {
  contact::History<double> h{};
  for (const StateField& field : kStateFields)
    if (field.entity == Entity::kPoint && !(s.*field.array).empty())
      h.*contact::kHistory<double>[row_of(field.array)] = (s.*field.array)[p];
  return h;
}

// Evaluates point p, whose sides are g apart along t1, t2 and n of the frame.
PointReading evaluate_point(const State& s, std::size_t p, const contact::LawConstants<double>& law,
                            const Vec& g, const contact::Frame<double>& frame) {
  contact::History<double> h = history_of(s, p);
  const contact::Shear<double> shear =
      contact::shear_of(g.x, g.y, h.plastic_slip, s.plastic_slip_2[p]);
  h.plastic_slip = 0;
  const contact::LawUpdate<double> now = contact::with_variant(law.choice, [&](auto variant) {
    return contact::update<decltype(variant)>(law, g.z, shear.e, h);
  });
  PointReading point;
  point.opening = g.z;
  point.slip_vector = vec3(g.x * frame.t1 + g.y * frame.t2);
  point.slip = length(point.slip_vector);
  point.opened = s.kappa[p];
  point.slid = elementary::hypot(s.plastic_slip[p], s.plastic_slip_2[p]);
  point.crushed = s.crush[p];
  point.normal_stress = now.sigma;
  point.shear_stress = now.tau;
  if (shear.e > 0)
    point.shear_vector = now.tau / shear.e * vec3(shear.e1 * frame.t1 + shear.e2 * frame.t2);
  point.damage_tension = now.tension_damage;
  point.damage_shear = h.shear_damage;
  point.damage = now.damage;
  point.crushing = contact::crushed_share(law, h);
  return point;
}

// Evaluates the points of zone contacts; their frame rotates with the rigid side (docs/theory/zones.md).
void evaluate_contacts(const Model& m, const State& s, std::vector<PointReading>& points) {
  const SpaceSolids& z = m.space.solids;
  contact::Laws laws(m.materials);
  for (int contact = 0; contact < z.n_contact; ++contact) {
    const contact::LawConstants<double>& law = laws.of(z.contact_material[contact]);
    const RigidSide rigid = rigid_side(m, s, contact);
    const Vec t1 = vec(z.contact_tangent[contact]), n = vec(z.contact_normal[contact]),
              t2 = cross(n, t1);
    const contact::Frame<double> frame{turned(rigid.q, t1), turned(rigid.q, t2),
                                       turned(rigid.q, n)};
    const JointShape shape = contact_in_space(m, contact);
    const double reach = length(shape.half);
    for (std::size_t p = z.point_begin[contact];
         p < static_cast<std::size_t>(z.point_begin[contact + 1]); ++p) {
      const double r1 = m.space.point_r1[p], r2 = m.space.point_r2[p];
      const Vec arm = vec(z.contact_arm[contact]) + r1 * t1 + r2 * t2;
      const Vec moved = vec(side_moved(m, s, contact, p));
      const Vec jump = moved - (vec(rigid.moved) + swing(rigid.q, arm));
      points[p] = evaluate_point(s, p, law, frame.in(jump), frame);
      points[p].share = m.space.point_share[p];
      points[p].place = reach > 0 ? r1 / reach : 0;
      points[p].where = shape.centre + vec3(r1 * t1 + r2 * t2 + moved);
    }
  }
}

}  // namespace

std::vector<Vec3> gaps_in_space(const Model& m, const State& s, JointId j) {
  const contact::FaceGap<double> gap = gap_of(m, s, j).gap;
  std::vector<Vec3> gaps;
  for (std::size_t p = m.space.point_begin[j];
       p < static_cast<std::size_t>(m.space.point_begin[j + 1]); ++p)
    gaps.push_back(vec3(gap.j + m.space.point_r1[p] * gap.a + m.space.point_r2[p] * gap.b));
  return gaps;
}

Vec3 moved_in_space(const Model& m, const State& s, BlockId body, Vec3 arm) {
  if (body == kGroundBlock) return {};
  if (const int support = body - m.n_block; support >= 0) {
    return {s.support_x[support], s.support_y[support], s.support_z[support]};
  }
  const contact::Pose<double> pose = pose_of(s, body);
  return vec3(pose.u + swing(pose.q, vec(arm)));
}

std::vector<PointReading> points_in_space(const Model& m, const State& s) {
  std::vector<PointReading> points(m.n_history());
  contact::Laws laws(m.materials);
  for (JointId j = 0; j < m.n_joint; ++j) {
    const contact::LawConstants<double>& law = laws.of(m.joint_material[j]);
    const Gap face = gap_of(m, s, j);
    const JointShape shape = joint_shape(m, j);
    const double reach = length(shape.half);
    const BlockReading b = read_block(m, s, shape.b);
    const bool stands =
        m.standing.joins(m.joint_a[j], m.joint_b[j], s.stage);  // otherwise nothing is read
    for (std::size_t p = m.space.point_begin[j];
         p < static_cast<std::size_t>(m.space.point_begin[j + 1]); ++p) {
      const double r1 = m.space.point_r1[p], r2 = m.space.point_r2[p];
      if (stands)
        points[p] =
            evaluate_point(s, p, law, face.gap.j + r1 * face.gap.a + r2 * face.gap.b, face.frame);
      if (!s.handed_over.empty() && s.handed_over[j] != 0) {  // replaced by a free contact
        points[p].normal_stress = points[p].shear_stress = 0;
        points[p].shear_vector = {};
      }
      points[p].share = m.space.point_share[p];
      points[p].place = reach > 0 ? r1 / reach : 0;
      const Vec3 arm = shape.arm_b + r1 * shape.along + r2 * cross(shape.normal, shape.along);
      const double back = shape.a == kGroundBlock || !stands ? 0.0 : 0.5;
      const Vec3 jump = points[p].slip_vector + points[p].opening * vec3(face.frame.n);
      points[p].where = turned(arm, b.turned, b.start + b.moved) - back * jump;
    }
  }
  evaluate_contacts(m, s, points);
  return points;
}

JointReading joint_in_space(const Model& m, JointId j, const std::vector<PointReading>& points) {
  JointReading joint;
  joint.shape = joint_shape(m, j);
  joint.points = points_of(m, j);
  joint.opening = -1e300;
  const Vec3 t1 = joint.shape.along, t2 = cross(joint.shape.normal, t1);
  double reach_1 = 0, reach_2 = 0, about_1 = 0, about_2 = 0;
  for (std::size_t p = joint.points.begin; p < static_cast<std::size_t>(joint.points.end); ++p) {
    const PointReading& point = points[p];
    const double area = joint.shape.area * point.share;
    const double r1 = m.space.point_r1[p], r2 = m.space.point_r2[p];
    joint.where = joint.where + point.share * point.where;
    joint.opening = std::fmax(joint.opening, point.opening);
    joint.slip = std::fmax(joint.slip, point.slip);
    joint.slip_vector = joint.slip_vector + point.share * point.slip_vector;
    joint.damage_tension = std::fmax(joint.damage_tension, point.damage_tension);
    joint.damage_shear = std::fmax(joint.damage_shear, point.damage_shear);
    joint.damage = std::fmax(joint.damage, point.damage);
    joint.crushing = std::fmax(joint.crushing, point.crushing);
    joint.normal_stress += point.share * point.normal_stress;
    joint.compression -= area * point.normal_stress;
    joint.shear_vector = joint.shear_vector + area * point.shear_vector;
    const Vec3 force = area * (point.shear_vector + point.normal_stress * joint.shape.normal);
    joint.moment_vector = joint.moment_vector + cross(r1 * t1 + r2 * t2, force);
    about_1 -= area * point.normal_stress * r1;
    about_2 -= area * point.normal_stress * r2;
    reach_1 = std::fmax(reach_1, std::fabs(r1));
    reach_2 = std::fmax(reach_2, std::fabs(r2));
  }
  joint.shear = length(joint.shear_vector);
  joint.shear_stress = joint.shear / joint.shape.area;
  joint.moment = length(joint.moment_vector);
  const auto off = [&](double about, double reach) {
    return reach > 0 ? std::fabs(about) / reach / joint.compression : 0.0;
  };
  if (joint.compression > 0)
    joint.eccentricity =
        std::clamp(std::fmax(off(about_1, reach_1), off(about_2, reach_2)), 0.0, 1.0);
  return joint;
}

Vec3 force_in_space(const Model& m, const JointReading& joint, const WallReading& wall) {
  const JointShape& shape = joint.shape;
  const auto turn = [&](BlockId b) { return wall.blocks[b].turned.by; };
  Rotation now;
  if (shape.a != kGroundBlock)
    now.by = shape.b >= m.n_block ? turn(shape.a) : 0.5 * (turn(shape.a) + turn(shape.b));
  return joint.compression * turned(shape.normal, now) - joint.shear_vector;
}

namespace {

// Whether a place lies outside the box around support `s` by more than a hundredth of its size.
bool is_beyond(const Model& m, BlockId s, Vec3 place) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Polyhedron& part : m.space.body[s].part)
    for (const Vec3& v : part.vertex) {
      low = {std::fmin(low.x, v.x), std::fmin(low.y, v.y), std::fmin(low.z, v.z)};
      high = {std::fmax(high.x, v.x), std::fmax(high.y, v.y), std::fmax(high.z, v.z)};
    }
  const double near = 0.01 * length(high - low);
  return place.x < low.x - near || place.x > high.x + near || place.y < low.y - near ||
         place.y > high.y + near || place.z < low.z - near || place.z > high.z + near;
}

}  // namespace

bool slid_off_in_space(const Model& m, const std::vector<PointReading>& points, JointId j) {
  const PointRange range = points_of(m, j);
  const JointShape shape = joint_shape(m, j);
  const Vec3 t1 = shape.along, t2 = cross(shape.normal, t1);
  Vec3 slip;
  bool pressed = false;
  for (std::size_t p = range.begin; p < static_cast<std::size_t>(range.end); ++p) {
    slip = slip + points[p].share * points[p].slip_vector;
    pressed = pressed || points[p].opening < 0;
  }
  const double way = length(slip);
  if (!pressed || way == 0) return false;
  double reach = 0;  // of the face in the direction of its slip
  for (std::size_t p = range.begin; p < static_cast<std::size_t>(range.end); ++p) {
    const Vec3 arm = m.space.point_r1[p] * t1 + m.space.point_r2[p] * t2;
    reach = std::fmax(reach, std::fabs(dot(arm, slip)) / way);
  }
  if (way <= reach) return false;
  const BlockId a = j < m.n_joint ? m.joint_a[j] : m.space.solids.contact_block[j - m.n_joint];
  if (a < m.n_block) return true;
  return is_beyond(m, a, shape.centre + slip);
}

}  // namespace wythe::reading
