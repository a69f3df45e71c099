// read_points(): evaluates the law in the current state, with the arithmetic of the step and without storing anything;
// also sums over the points of each joint.
#include <algorithm>
#include <cmath>

#include "contact/fast_paths.h"
#include "contact/parameters.h"
#include "core/real.h"
#include "model/fields.h"
#include "reading/readers.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

using contact::LawConstants;

// Kinematics of one point in the plane (2.2, 2.3, 8.5), as in the step but evaluated singly.
struct PointMotion {
  double w, s, x, y;
};

struct Turned {
  double x, y;
};
Turned turn(const SinCos<double>& r, double x, double y) {
  return {r.cos * x - r.sin * y, r.sin * x + r.cos * y};
}

// Motion of the two faces of joint j; `phi`: mean rotation of its sides.
struct FaceMotion {
  const Model& m;
  const State& s;
  const std::vector<SinCos<double>>& block;  // rotation of each block
  JointId j;
  SinCos<double> phi;

  [[nodiscard]] PointMotion at(double xi) const {
    const BlockId a = m.joint_a[j], b = m.joint_b[j];
    const bool on_ground = a == kGroundBlock;
    const double bx0 = m.arm_b_x[j] + xi * m.half_x[j], by0 = m.arm_b_y[j] + xi * m.half_y[j];
    const Turned rb = turn(block[b], bx0, by0);
    const double pbx = s.ux[b] + rb.x - bx0, pby = s.uy[b] + rb.y - by0;
    double pax = 0, pay = 0;
    if (!on_ground) {
      const double ax0 = m.arm_a_x[j] + xi * m.half_x[j], ay0 = m.arm_a_y[j] + xi * m.half_y[j];
      const Turned ra = turn(block[a], ax0, ay0);
      pax = s.ux[a] + ra.x - ax0;
      pay = s.uy[a] + ra.y - ay0;
    }
    const Turned t = turn(phi, m.tangent_x[j], m.tangent_y[j]);
    const double jx = pbx - pax, jy = pby - pay;
    const double x0 = m.centroid_x[b] + bx0, y0 = m.centroid_y[b] + by0;
    const double share = on_ground ? 1.0 : 0.5;
    return {jy * t.x - jx * t.y, jx * t.x + jy * t.y, x0 + pbx - (1 - share) * jx,
            y0 + pby - (1 - share) * jy};
  }
};

// Motion of point k of contact c, on the edge of a zone.
PointMotion contact_motion(const Model& model, const State& s, int c, int k) {
  const Solids& m = model.solids;
  const int p = m.contact_p[c], q = m.contact_q[c];
  const double share = k == 0 ? m.share_0[c] : m.share_1[c];
  const double arm_x = k == 0 ? m.arm_0_x[c] : m.arm_1_x[c];
  const double arm_y = k == 0 ? m.arm_0_y[c] : m.arm_1_y[c];
  const double ex = (1 - share) * s.node_ux[p] + share * s.node_ux[q];
  const double ey = (1 - share) * s.node_uy[p] + share * s.node_uy[q];
  double ux = 0, uy = 0, theta = 0;
  if (const BlockId a = m.contact_block[c]; a != model.n_block) {
    ux = s.ux[a];
    uy = s.uy[a];
    theta = s.theta[a];
  }
  const SinCos<double> half = sin_cos(0.5 * theta);
  const double drop = -2 * half.sin * half.sin, sine = 2 * half.sin * half.cos;
  const double jx = ex - (ux + drop * arm_x - sine * arm_y);
  const double jy = ey - (uy + sine * arm_x + drop * arm_y);
  const double tx0 = m.contact_tangent_x[c], ty0 = m.contact_tangent_y[c];
  const double tx = tx0 + drop * tx0 - sine * ty0, ty = ty0 + sine * tx0 + drop * ty0;
  return {jy * tx - jx * ty, jx * tx + jy * ty,
          (1 - share) * m.node_x[p] + share * m.node_x[q] + ex,
          (1 - share) * m.node_y[p] + share * m.node_y[q] + ey};
}

// The history of each point, by the table of fields.
class Histories {
 public:
  explicit Histories(const State& s) {
    std::size_t k = 0;
    for (const StateField& field : kStateFields)
      if (field.entity == Entity::kPoint && !(s.*field.array).empty())
        row_[k++] = (s.*field.array).data();
  }
  [[nodiscard]] contact::History<double> at(PointId p) const {
    contact::History<double> h{};
    for (std::size_t k = 0; k < row_.size() && row_[k] != nullptr; ++k)
      h.*contact::kHistory<double>[k] = row_[k][p];
    return h;
  }

 private:
  std::array<const double*, contact::kHistory<double>.size()> row_{};
};

// Result of the law, by the fast path where the point is undamaged.
template <class V>
contact::LawUpdate<double> answer_of(const LawConstants<double>& law, const PointMotion& at,
                                     contact::History<double>& h) {
  if (contact::has_undamaged_path<V>(law) && contact::is_undamaged<V>(law, h)) {
    const contact::UndamagedStress<double> undamaged = contact::undamaged_point(law, at.w, at.s);
    if (undamaged.stays)
      return {undamaged.sigma + 0.0, undamaged.tau, 0, 0, 0, 0, 0, 0, 0, 0, 0};  // + 0: never -0
  }
  return contact::update<V>(law, at.w, at.s, h);
}

PointReading evaluate_point(contact::History<double> h, const LawConstants<double>& law,
                            const PointMotion& at) {
  PointReading point;
  point.where = {at.x, at.y};
  point.opening = at.w;
  point.slip = at.s;
  point.opened = h.kappa;
  point.slid = h.plastic_slip;
  point.crushed = h.crush;
  const contact::LawUpdate<double> now = contact::with_variant(
      law.choice, [&](auto variant) { return answer_of<decltype(variant)>(law, at, h); });
  point.normal_stress = now.sigma;
  point.shear_stress = now.tau;
  point.damage_tension = now.tension_damage;
  point.damage_shear = h.shear_damage;
  point.damage = now.damage;
  point.crushing = contact::crushed_share(law, h);
  return point;
}

std::vector<SinCos<double>> rotations_of(const State& state) {
  std::vector<SinCos<double>> rotations;
  rotations.reserve(state.theta.size());
  for (const double theta : state.theta) rotations.push_back(sin_cos(theta));
  return rotations;
}

}  // namespace

std::vector<PointReading> reading::points_in_plane(const Model& m, const State& s) {
  contact::Laws law(m.materials);
  const Histories history(s);
  const std::vector<SinCos<double>> block = rotations_of(s);
  std::vector<PointReading> points(m.n_history());
  for (JointId j = 0; j < m.n_joint; ++j) {
    const BlockId a = m.joint_a[j], b = m.joint_b[j];
    const double phi = a == kGroundBlock ? 0.0 : 0.5 * (s.theta[a] + s.theta[b]);
    const FaceMotion face{m, s, block, j, sin_cos(phi)};
    const PointRange range = points_of(m, j);
    const bool stands = m.standing.joins(a, b, s.stage);  // otherwise nothing is read
    for (PointId p = range.begin; p < range.end; ++p) {
      const int k = p - range.begin;
      const PointMotion at = face.at(m.point_xi[k]);
      if (stands)
        points[p] = evaluate_point(history.at(p), law.of(m.joint_material[j]), at);
      else
        points[p].where = {at.x, at.y};
      if (!s.handed_over.empty() && s.handed_over[j] != 0)  // replaced by a free contact
        points[p].normal_stress = points[p].shear_stress = 0;
      points[p].share = m.point_weight[k];
      points[p].place = m.point_xi[k];
    }
  }
  for (int c = 0; c < m.solids.n_contact; ++c) {
    const PointRange range = points_of(m, m.n_joint + c);
    for (PointId p = range.begin; p < range.end; ++p) {
      const int k = p - range.begin;
      points[p] = evaluate_point(history.at(p), law.of(m.solids.contact_material[c]),
                                 contact_motion(m, s, c, k));
      points[p].share = 0.5;
      points[p].place = 2 * k - 1;
    }
  }
  return points;
}

namespace {

// Largest opening of a straight face: at one of its ends, where not every rule has a point.
double opening_at_ends(const std::vector<PointReading>& points, PointRange range) {
  const PointReading &first = points[range.begin], &last = points[range.end - 1];
  const double inside = std::fmax(first.opening, last.opening);
  const double beyond = (2 - (last.place - first.place)) / (last.place - first.place);
  return inside + 0.5 * beyond * std::fabs(last.opening - first.opening);
}

}  // namespace

JointReading reading::joint_in_plane(const Model& model, JointId id,
                                     const std::vector<PointReading>& points) {
  JointReading joint;
  const JointShape shape = joint_shape(model, id);
  const PointRange range = points_of(model, id);
  joint.shape = shape;
  joint.points = range;
  joint.opening = opening_at_ends(points, range);
  double moment = 0;  // [N] for a unit half face
  for (PointId p = range.begin; p < range.end; ++p) {
    const PointReading& point = points[p];
    const double area = shape.area * point.share;
    joint.where = joint.where + point.share * point.where;
    joint.opening = std::fmax(joint.opening, point.opening);
    if (std::fabs(point.slip) > std::fabs(joint.slip)) joint.slip = point.slip;
    joint.damage_tension = std::fmax(joint.damage_tension, point.damage_tension);
    joint.damage_shear = std::fmax(joint.damage_shear, point.damage_shear);
    joint.damage = std::fmax(joint.damage, point.damage);
    joint.crushing = std::fmax(joint.crushing, point.crushing);
    joint.normal_stress += point.share * point.normal_stress;
    joint.shear_stress += point.share * point.shear_stress;
    joint.compression -= area * point.normal_stress;
    joint.shear += area * point.shear_stress;
    moment -= area * point.normal_stress * point.place;
  }
  joint.moment = moment * length(shape.half);
  if (joint.compression > 0) joint.eccentricity = std::clamp(moment / joint.compression, -1.0, 1.0);
  return joint;
}

WallReading read_wall(const Model& model, const State& state) {
  WallReading wall;
  wall.points = read_points(model, state);
  wall.blocks.reserve(block_count(model));
  for (BlockId b = 0; b < block_count(model); ++b)
    wall.blocks.push_back(read_block(model, state, b));
  wall.joints.reserve(joint_count(model));
  for (JointId j = 0; j < joint_count(model); ++j)
    wall.joints.push_back(reading::readers_of(model).joint(model, j, wall.points));
  for (std::size_t j = 0; j < state.handed_over.size(); ++j)
    wall.joints[j].handed_over = state.handed_over[j] != 0;
  for (JointReading& joint : wall.joints)
    if (!model.standing.joins(joint.shape.a, joint.shape.b, state.stage)) joint.handed_over = true;
  return wall;
}

Vec3 reading::force_in_plane(const Model& model, const JointReading& joint,
                             const WallReading& wall) {
  const JointShape& shape = joint.shape;
  const Vec3 force = joint.compression * shape.normal - joint.shear * shape.along;
  if (shape.a == kGroundBlock) return force;
  const auto turn = [&](BlockId b) { return wall.blocks[b].turned.by; };
  return turned(force,
                {shape.b >= model.n_block ? turn(shape.a) : 0.5 * (turn(shape.a) + turn(shape.b))});
}

namespace {

// Whether a place on the ground or a fixed block still lies on a face. Ground without fixed blocks is
// unlimited; a fixed block ends.
bool is_on_support(const Anatomy& a, Vec3 place) {
  if (a.support_begin.size() < 2) return true;
  bool inside = false;
  for (std::size_t s = 0; s + 1 < a.support_begin.size(); ++s) {
    const int from = a.support_begin[s], to = a.support_begin[s + 1];
    for (int p = from, q = to - 1; p < to; q = p++) {
      const double yp = a.support_y[p], yq = a.support_y[q];
      if ((yp > place.y) == (yq > place.y)) continue;
      const double xp = a.support_x[p], xq = a.support_x[q];
      if (place.x < xp + (place.y - yp) / (yq - yp) * (xq - xp)) inside = !inside;
    }
  }
  return inside;
}

}  // namespace

bool reading::slid_off_in_plane(const Model& model, const std::vector<PointReading>& points,
                                JointId joint) {
  double slip = 0;
  bool pressed = false;
  const PointRange range = points_of(model, joint);
  for (PointId p = range.begin; p < range.end; ++p) {
    slip += points[p].share * points[p].slip;
    pressed = pressed || points[p].opening < 0;
  }
  if (!pressed || slip == 0) return false;
  const Vec3 half = joint < model.n_joint ? Vec3{model.half_x[joint], model.half_y[joint]}
                                          : joint_shape(model, joint).half;
  const double reach = length(half);  // half the face
  if (std::fabs(slip) <= reach) return false;
  const JointShape shape = joint_shape(model, joint);
  if (shape.kind == JointKind::kLintelChain) return false;  // a continuous timber
  if (shape.a != kGroundBlock) return true;
  // below the middle of the face, in the ground by a hundredth of the face's length
  const double deep = 0.02 * reach;
  return !is_on_support(model.anatomy, shape.centre + slip * shape.along - deep * shape.normal);
}

}  // namespace wythe
