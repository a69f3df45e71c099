// As passes/plane_bodies.cpp, with facets instead of edges. Slip has three components: two along the facet, and the twist
// times the radius of gyration of the contact area (docs/theory/contacts.md, "Two parts in space"). Supports may be driven;
// their velocity is that of the last step. A released joint lies between the resting pose and itself, without an area.
#include "dynamics/space/space_bodies.h"

#include <algorithm>

#include "contact/law.h"
#include "contact/parameters.h"
#include "dynamics/passes/law_path.h"
#include "dynamics/space/dashpots.h"
#include "model/free_shapes.h"

namespace wythe::dynamics::space {
namespace {

using contact::Facet;
using contact::SpaceFrame;

constexpr double kBoxMargin = 0.05;  // of boxes, over the mean size of a block
constexpr double kSlop = 0.25;       // another face is taken if it is better by so many bevels

double length(const Vec& v) { return square_root(dot(v, v)); }

const Facet& facet_of(const SpaceBodies::PairGeometry& m, std::int32_t feature) {
  return feature >= 0 ? m.a.facet[feature] : m.b.facet[-1 - feature];
}
const SpaceFrame& frame_of(const SpaceBodies::PairGeometry& m, std::int32_t feature) {
  return feature >= 0 ? m.frame_a : m.frame_b;
}

}  // namespace

SpaceBodies::SpaceBodies(const Model& model, const Layout& layout, int width)
    : m_(model),
      layout_(layout),
      width_(width),
      now_(static_cast<std::size_t>(model.n_block + model.free.n_fixed),
           Now{{{0, 0, 0}, {1, {0, 0, 0}}}, {}}) {
  parts_ = free_parts(model);
  double size = 0;
  for (std::int32_t i = 0; i < model.n_block; ++i) {
    double reach = 0, low = 1e300, high = -1e300;
    for (auto part = model.free.part_begin[i]; part < model.free.part_begin[i + 1]; ++part)
      for (const Facet& facet : parts_.facets_of(part))
        for (auto c = facet.begin; c < facet.end; ++c) {
          const Vec& corner = parts_.corner[c];
          reach = maximum(reach, length(corner));
          low = minimum(low, corner.y), high = maximum(high, corner.y);
        }
    reach_.push_back(reach);
    height_.push_back(high - low);
    size += 2 * reach;
  }
  margin_ = kBoxMargin * size / maximum(1.0, model.n_block);
  for (const JointMaterial& material : model.materials)
    law_.push_back(contact::free_law(contact::constants_of(material), 1.0));
  chunk_of_.resize(model.n_joint);
  for (int c = 0; c < static_cast<int>(layout.joints.size()); ++c) {
    const Chunk& chunk = layout.joints[c];
    for (int n = 0; n < chunk.n; ++n) chunk_of_[chunk.first + n] = {c, n};
  }
}

contact::FreeLaw SpaceBodies::law_of(std::int32_t a, std::int32_t b) const {
  contact::FreeLaw law = law_[free_material_of(m_, a, b)];
  law.thickness = minimum(m_.free.thickness[a], m_.free.thickness[b]);
  return law;
}

// Supports may be driven, so they have a pose; other ground has the wall's axes.
SpaceFrame SpaceBodies::frame_of(std::int32_t body, const WallView& wall) const {
  const int support = body - m_.n_block;
  if (support >= m_.space.n_support) return {{0, 0, 0}, {1, {0, 0, 0}}};
  const Vec start = vec(m_.space.centroid[body]);
  if (support < 0) return {start + wall.shift(body), wall.turn(body)};
  return {start + wall.vector(wall.t.support, support), {1, {0, 0, 0}}};
}

Box SpaceBodies::box_of(std::int32_t body, const WallView& wall) const {
  const SpaceFrame frame = frame_of(body, wall);
  Box box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  const FreeShapes& f = m_.free;
  for (auto part = f.part_begin[body]; part < f.part_begin[body + 1]; ++part)
    for (const Facet& facet : parts_.facets_of(part))
      for (auto c = facet.begin; c < facet.end; ++c) {
        const Vec p = frame.at + turned(frame.turn, parts_.corner[c]);
        const double place[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 3; ++k) {
          box.low[k] = minimum(box.low[k], place[k]);
          box.high[k] = maximum(box.high[k], place[k]);
        }
      }
  return box;
}

double SpaceBodies::speed_of(std::int32_t body, const WallView& wall) const {
  const ForceMoment rates = rates_of(body, wall);
  return length(rates.f) + reach_[body] * length(rates.m);
}

double SpaceBodies::turned_in(double dt, std::int32_t body, const WallView& wall) const {
  constexpr double kMore = 1.05;  // in case damping by mass slowed blocks after they turned
  if (body >= m_.n_block) return 0;
  // no body turns faster with this momentum than about its axis of least inertia
  double light = 0;
  for (int k = 0; k < 3; ++k) light = maximum(light, wall.body(body, kInverse + k));
  return kMore * dt * reach_[body] * light * length(wall.body_vector(body, kL));
}

double SpaceBodies::fallen_height(BlockId block, const WallView& wall) const {
  return -wall.shift(block).y;
}

Vec SpaceBodies::place_of(std::int32_t body, const WallView& wall) const {
  return frame_of(body, wall).at;
}

// Driven supports have the velocity of their last step.
ForceMoment SpaceBodies::rates_of(std::int32_t body, const WallView& wall) const {
  if (const std::int32_t support = body - m_.n_block; support >= 0) {
    if (support >= m_.space.n_support || !(wall.wall_value(kStep) > 0)) return {};
    return {velocity_of(support, wall), {0, 0, 0}};
  }
  const Quaternion<double> q = wall.turn(body);
  const Vec l = turned_back(q, wall.body_vector(body, kL));
  Vec spin{0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const auto axis_row = [&](int c) {
      return wall.t.axes[layout_.number(body, kAxisRows, 3 * k + c, 1)];
    };
    const Vec axis{axis_row(0), axis_row(1), axis_row(2)};
    spin = spin + (wall.body(body, kInverse + k) * dot(axis, l)) * axis;
  }
  return {wall.body_vector(body, kV), turned(q, spin)};
}

Vec SpaceBodies::to_body_axes(std::int32_t body, const Vec& v, const WallView& wall) const {
  return turned_back(frame_of(body, wall).turn, v);
}
Vec SpaceBodies::to_wall_axes(std::int32_t body, const Vec& v, const WallView& wall) const {
  return turned(frame_of(body, wall).turn, v);
}

// --- two parts ------------------------------------------------------------------------------------------

void SpaceBodies::cache_motion(std::int32_t body, const WallView& wall) {
  now_[body] = {frame_of(body, wall), rates_of(body, wall)};
}

SpaceBodies::PairGeometry SpaceBodies::pair_geometry(const FreeContact& c) const {
  const FreeShapes& f = m_.free;
  return {contact::part_of(parts_, f.part_begin[c.a] + c.part_a),
          contact::part_of(parts_, f.part_begin[c.b] + c.part_b), now_[c.a].frame, now_[c.b].frame};
}

contact::SpaceOverlap SpaceBodies::overlap(const PairGeometry& m, std::int32_t feature,
                                           double rest) {
  return feature >= 0 ? contact::overlap_on(m.a, feature, m.b,
                                            contact::seen_from(m.frame_a, m.frame_b), rest)
                      : contact::overlap_on(m.b, -1 - feature, m.a,
                                            contact::seen_from(m.frame_b, m.frame_a), rest);
}

contact::Face SpaceBodies::face(const PairGeometry& m, std::int32_t last) const {
  return contact::face_of(m.a, m.b, contact::seen_from(m.frame_a, m.frame_b),
                          contact::seen_from(m.frame_b, m.frame_a), last, kSlop * m_.free.bevel);
}

Vec SpaceBodies::normal_of(const PairGeometry& m, std::int32_t feature) {
  const Vec n = turned(space::frame_of(m, feature).turn, facet_of(m, feature).z);
  return feature >= 0 ? n : -1.0 * n;
}

double SpaceBodies::turn_slip(FreePair& pair, const PairGeometry& m, std::int32_t to) {
  FreeContact& c = pair.memory;
  const double before = shear_energy(c, pair.law);
  struct Axes {
    Vec x, y, n;  // n from a to b
  };
  const auto axes = [&](std::int32_t feature) -> Axes {
    const Facet& f = facet_of(m, feature);
    const Quaternion<double>& q = space::frame_of(m, feature).turn;
    const double sense = feature >= 0 ? 1 : -1;
    return {sense * turned(q, f.x), sense * turned(q, f.y), sense * turned(q, f.z)};
  };
  const Axes was = axes(c.feature), is = axes(to);
  const Vec slip = c.slip_x * was.x + c.slip_y * was.y;
  c.slip_x = dot(slip, is.x);
  c.slip_y = dot(slip, is.y);
  c.slip_z *= dot(was.n, is.n);
  return before - shear_energy(c, pair.law);
}

SpaceBodies::SlipUpdate SpaceBodies::update_slip(FreePair& pair, const PairGeometry& m,
                                                 const Overlap& overlap, double dt) const {
  FreeContact& c = pair.memory;
  const bool of_a = c.feature >= 0;
  const Facet& facet = facet_of(m, c.feature);
  const SpaceFrame &ref = of_a ? m.frame_a : m.frame_b, &other = of_a ? m.frame_b : m.frame_a;
  const Vec x = turned(ref.turn, facet.x), y = turned(ref.turn, facet.y),
            z = turned(ref.turn, facet.z);
  const Vec origin = turned(ref.turn, facet.origin);  // from the reference's centroid

  // slip and twist of `other` on the facet in the last step, at the centre of pressure
  const double over = overlap.force.z > 0 ? 1 / overlap.force.z : 0.0;
  const Vec arm = origin + (-overlap.moment.y * over) * x + (overlap.moment.x * over) * y;
  const Vec arm_other = ref.at + arm - other.at;
  const ForceMoment &of_ref = now_[of_a ? c.a : c.b].rates,
                    &of_other = now_[of_a ? c.b : c.a].rates;
  // arms and axes half a step ago, in the middle of that motion
  const auto back = [&](const ForceMoment& rates, const Vec& r) {
    return r - (0.5 * dt) * cross(rates.m, r);
  };
  const Vec v = (of_other.f + cross(of_other.m, back(of_other, arm_other))) -
                (of_ref.f + cross(of_ref.m, back(of_ref, arm)));
  const double radius = square_root(overlap.spread), twist = dot(of_other.m - of_ref.m, z);

  const contact::FreeLaw& law = pair.law;
  const double normal = law.kn * overlap.force.z;
  pair.pressed = normal;
  // A growing area increases the force, a shrinking one reduces the slip: neither creates energy.
  const double energy = shear_energy(c, law);
  const Vec held = law.ks * c.area * Vec{c.slip_x, c.slip_y, c.slip_z};
  if (overlap.cover > c.area && c.area > 0)
    for (double* slip : {&c.slip_x, &c.slip_y, &c.slip_z}) *slip *= c.area / overlap.cover;
  c.area = overlap.cover;
  const double stiff = law.ks * c.area, limit = law.tan_friction * normal;
  const Vec start{c.slip_x, c.slip_y, c.slip_z};
  const Vec slip_step = dt * Vec{dot(v, back(of_ref, x)), dot(v, back(of_ref, y)), radius * twist};
  Vec slip = start + slip_step;
  if (const double reach = length(slip); stiff * reach > limit) {
    const Vec kept = (limit / (stiff * reach)) * slip;
    slip = kept;
  }
  c.slip_x = slip.x, c.slip_y = slip.y, c.slip_z = slip.z;
  // the work of the step, less the part that is stored
  pair.friction += 0.5 * dot(held + stiff * slip, slip_step) + (energy - shear_energy(c, law));
  pair.stored = law.kn * overlap.energy + shear_energy(c, law);

  // force on `other`, moment about the origin of the facet's axes, carried to both centroids
  const Vec rubs = (-stiff * slip.x) * x + (-stiff * slip.y) * y;
  const Vec pressed = law.kn * (overlap.force.x * x + overlap.force.y * y + overlap.force.z * z);
  const Vec force = pressed + rubs;
  const Vec moment = law.kn * (overlap.moment.x * x + overlap.moment.y * y + overlap.moment.z * z) +
                     cross(arm - origin, rubs) + (-stiff * radius * slip.z) * z;
  const Vec to_other = ref.at + origin - other.at;
  const ForceMoment on_other{force, moment + cross(to_other, force)};
  const ForceMoment on_ref{-1.0 * force, -1.0 * (moment + cross(origin, force))};
  pair.on_a = of_a ? on_ref : on_other;
  pair.on_b = of_a ? on_other : on_ref;
  return {dt * dot(v, z), slip_step, stiff * slip, arm, arm_other, x, y, z, radius};
}

// The largest over all directions, from the least inertia.
double SpaceBodies::mobility(const FreeContact& c, const SlipUpdate& r) const {
  const bool of_a = c.feature >= 0;
  const auto of = [&](std::int32_t body, const Vec& arm) {
    if (body >= m_.n_block) return 0.0;
    const Vec3& inertia = m_.space.inertia[body];
    const double least = minimum(inertia.x, minimum(inertia.y, inertia.z));
    return 1 / m_.mass[body] + (dot(arm, arm) + r.radius * r.radius) / least;
  };
  return of(of_a ? c.a : c.b, r.ref) + of(of_a ? c.b : c.a, r.other);
}

void SpaceBodies::spread(const ViscousForce& f, const SlipUpdate& r, bool of_a, ForceMoment& on_a,
                         ForceMoment& on_b) {
  const Vec force = -f.normal * r.z - f.shear.x * r.x - f.shear.y * r.y;
  const Vec twist = (-r.radius * f.shear.z) * r.z;
  const ForceMoment on_other{force, cross(r.other, force) + twist};
  const ForceMoment on_ref{-1.0 * force, -1.0 * (cross(r.ref, force) + twist)};
  on_a = of_a ? on_ref : on_other;
  on_b = of_a ? on_other : on_ref;
}

void SpaceBodies::take_over_shear(FreePair& pair, const Vec& on_a) const {
  const PairGeometry m = pair_geometry(pair.memory);
  FreeContact& c = pair.memory;
  const Facet& facet = facet_of(m, c.feature);
  const Quaternion<double>& q = space::frame_of(m, c.feature).turn;
  const double sense = c.feature >= 0 ? 1 : -1;
  Vec along{sense * dot(on_a, turned(q, facet.x)), sense * dot(on_a, turned(q, facet.y)), 0};
  const double most = pair.law.tan_friction * pair.pressed, force = length(along);
  if (force > most) along = (most / force) * along;
  const double stiff = pair.law.ks * c.area;
  c.slip_x = along.x / stiff, c.slip_y = along.y / stiff, c.slip_z = 0;
}

// --- rows of forces -------------------------------------------------------------------------------------

void SpaceBodies::clear_rows(const WallView& wall) const {
  const std::ptrdiff_t rows = m_.n_block + m_.free.n_fixed;
  for (double* table : {wall.t.force, wall.t.moment_a})
    std::fill_n(table + 4 * wall.first_free, 4 * rows, 0.0);
}

// One row for each body. The last column sums the magnitudes that the unbalance needs.
void SpaceBodies::add(std::int32_t a, std::int32_t b, const ForceMoment& on_a,
                      const ForceMoment& on_b, const WallView& wall) const {
  const auto put = [&](std::int32_t body, const ForceMoment& push) {
    const double f[4] = {push.f.x, push.f.y, push.f.z, body < m_.n_block ? length(push.f) : 0.0};
    const double m[3] = {push.m.x, push.m.y, push.m.z};
    for (int c = 0; c < 4; ++c) wall.column_of(wall.t.force, wall.first_free + body, c) += f[c];
    for (int c = 0; c < 3; ++c) wall.column_of(wall.t.moment_a, wall.first_free + body, c) += m[c];
  };
  put(a, on_a);
  put(b, on_b);
}

// --- joints ---------------------------------------------------------------------------------------------

std::pair<std::int32_t, std::int32_t> SpaceBodies::sides_of(JointId joint) const {
  return std::minmax(m_.joint_a[joint], m_.joint_b[joint]);
}

int SpaceBodies::points_of_face(JointId joint) const {
  return m_.space.point_begin[joint + 1] - m_.space.point_begin[joint];
}

SpaceBodies::Jump SpaceBodies::jump_of(JointId joint, const WallView& wall) const {
  const Space& s = m_.space;
  const auto pose = [&](BlockId i) { return contact::Pose<double>{wall.shift(i), wall.turn(i)}; };
  const contact::Pose<double> b = pose(m_.joint_b[joint]);
  if (const int support = m_.joint_a[joint] - m_.n_block; support >= 0) {
    const contact::SupportFace<double> face(wall.vector(wall.t.support, support), b,
                                            vec(s.arm_b[joint]), vec(s.tangent[joint]),
                                            vec(s.normal[joint]));
    return {face.gap(), length(b.q.v)};
  }
  const contact::PairFace<double> face(pose(m_.joint_a[joint]), b, vec(s.arm_a[joint]),
                                       vec(s.arm_b[joint]), vec(s.tangent[joint]),
                                       vec(s.normal[joint]));
  return {face.gap(), length(face.p)};
}

bool SpaceBodies::is_tilted(const Jump& jump) {
  constexpr double kTilted = 0.02617694830787315;  // sine of half of 3 degrees
  return jump.tilt > kTilted;
}

bool SpaceBodies::has_failed(JointId joint, const WallView& wall) const {
  constexpr double kSlipped = 0.05;  // of the size of the face, for slip and opening
  const Jump jump = jump_of(joint, wall);
  const Vec& g = jump.gap.j;
  const double most = kSlipped * square_root(m_.area[joint]);
  if (is_tilted(jump) || square_root(g.x * g.x + g.y * g.y) > most) return true;
  if (!(g.z > most)) return false;
  for (int k = 0; k < points_of_face(joint); ++k)
    if (!(gap_at(joint, k, jump).z > most)) return false;
  return true;
}

double& SpaceBodies::history_number(JointId joint, int point, int row, const WallView& wall) const {
  const auto& [number, n] = chunk_of_[joint];
  const Chunk& chunk = layout_.joints[number];
  return wall.t.history[layout_.point_number(chunk, chunk.history, n, point, chunk.rows, row, 1)];
}
int SpaceBodies::rows_of(JointId joint) const {
  return layout_.joints[chunk_of_[joint].first].rows;
}

contact::History<double> SpaceBodies::history_of(JointId joint, int point,
                                                 const WallView& wall) const {
  contact::History<double> h{};
  for (int row = 0; row + 1 < rows_of(joint); ++row)
    h.*contact::kHistory<double>[row] = history_number(joint, point, row, wall);
  return h;
}

Vec SpaceBodies::gap_at(JointId joint, int point, const Jump& jump) const {
  const std::size_t p = m_.space.point_begin[joint] + point;
  return jump.gap.j + m_.space.point_r1[p] * jump.gap.a + m_.space.point_r2[p] * jump.gap.b;
}

// A tilted joint bears on an edge, whose points may be undamaged.
bool SpaceBodies::holds(JointId joint, const WallView& wall) const {
  constexpr double kBroken = 0.999;  // damage of a point
  const auto law = contact::constants_of(m_.materials[m_.joint_material[joint]]);
  const Jump jump = jump_of(joint, wall);
  for (int k = 0; k < points_of_face(joint); ++k) {
    const contact::History<double> h = history_of(joint, k, wall);
    const double tension = contact::tension_left<contact::AnyVariant>(law, h.kappa);
    const double left =
        contact::strength_left<contact::AnyVariant>(law, tension, 1 - h.shear_damage);
    const bool closed = gap_at(joint, k, jump).z + h.crush <= 0;
    if (left > 1 - kBroken && !(is_tilted(jump) && closed)) return true;
  }
  return false;
}

ForceMoment SpaceBodies::joint_force(JointId joint, std::int32_t on, const WallView& wall) const {
  const std::int32_t place = layout_.joint_place[joint];
  if (m_.joint_a[joint] == on) return {wall.force(place), wall.vector(wall.t.moment_a, place)};
  return {-1.0 * wall.force(place), wall.vector(wall.t.moment_b, place)};
}

double SpaceBodies::elastic_energy(JointId joint, const WallView& wall) const {
  const JointMaterial& material = m_.materials[m_.joint_material[joint]];
  const auto law = contact::constants_of(material);
  const Jump jump = jump_of(joint, wall);
  double energy = 0;
  for (int k = 0; k < points_of_face(joint); ++k) {
    contact::History<double> h = history_of(joint, k, wall);
    const Vec g = gap_at(joint, k, jump);
    const contact::Shear<double> shear = contact::shear_of(
        g.x, g.y, h.plastic_slip, history_number(joint, k, rows_of(joint) - 1, wall));
    h.plastic_slip = 0;
    const auto now = contact::update<contact::AnyVariant>(law, g.z, shear.e, h);
    const bool secant = now.sigma > 0 && material.unloading == Unloading::kSecant;
    const double normal =
        secant ? 0.5 * now.sigma * (g.z + h.crush) : 0.5 * now.sigma * now.sigma * law.inv_kn;
    energy += m_.area[joint] * m_.space.point_share[m_.space.point_begin[joint] + k] *
              (normal + 0.5 * now.tau * now.tau * law.inv_ks);
  }
  return energy;
}

void SpaceBodies::restore(const WallView& wall) const {
  for (JointId j = 0; j < m_.n_joint; ++j) {
    const std::int32_t place = layout_.joint_place[j];
    const BlockId a = m_.joint_a[j];
    wall.t.joint_a[place] = a >= m_.n_block ? a - m_.n_block : a;
    wall.t.joint_b[place] = m_.joint_b[j];
    wall.t.face[layout_.number(place, kFaceRows, kFaceArea, 1)] = m_.area[j];
  }
}

// A released joint lies between the resting pose and itself, without an area.
void SpaceBodies::release(JointId joint, const WallView& wall) const {
  const std::int32_t place = layout_.joint_place[joint];
  const bool on_support = m_.joint_a[joint] >= m_.n_block;
  wall.t.joint_a[place] = on_support ? m_.space.n_support : wall.t.n_block;
  wall.t.joint_b[place] = wall.t.n_block;
  wall.t.face[layout_.number(place, kFaceRows, kFaceArea, 1)] = 0;
  for (double* table : {wall.t.force, wall.t.moment_a, wall.t.moment_b})
    std::fill_n(table + 4 * static_cast<std::ptrdiff_t>(place), 4, 0.0);
  for (int k = 0; k < points_of_face(joint); ++k)
    for (const int row : {row_of(&State::crush), row_of(&State::plastic_slip), rows_of(joint) - 1})
      history_number(joint, k, row, wall) = 0;
}

// All other faces take the full law in the next step.
void SpaceBodies::end_release(const WallView& wall) const {
  mark_released(wall.t.joint_b, wall.t.n_block, layout_.n_joint, width_, wall.t.law_path);
}

}  // namespace wythe::dynamics::space
