// Follows docs/theory/contacts.md for blocks in their plane. Slip grows by the motion of the
// last step. Arms and axes for it are taken half a step back, where the velocities stand.
// press() gives a group the bits of update_slip(). A released joint lies between the ground
// and itself, without an area. Feature e >= 0 is edge e of a, and -1 - e is edge e of b.
#include "dynamics/passes/plane_bodies.h"

#include "contact/law.h"
#include "contact/parameters.h"
#include "dynamics/passes/law_path.h"
#include "model/free_shapes.h"

namespace wythe::dynamics {
namespace {

using contact::BodyFrame;
using contact::EdgeAxes;

constexpr double kBoxMargin = 0.05;  // of boxes, over the mean size of a block
constexpr double kSlop = 0.25;       // another face is taken if it is better by so many bevels

// Turns a direction from a body's axes to the wall's.
struct Direction2 {
  double x, y;
};
Direction2 turned(const BodyFrame& f, double x, double y) {
  return {f.c * x - f.s * y, f.s * x + f.c * y};
}

const EdgeAxes& axes_of(const PlaneBodies::PairGeometry& m, std::int32_t feature) {
  return feature >= 0 ? contact::axes_of(m.a, feature) : contact::axes_of(m.b, -1 - feature);
}
const BodyFrame& frame_of(const PlaneBodies::PairGeometry& m, std::int32_t feature) {
  return feature >= 0 ? m.frame_a : m.frame_b;
}

}  // namespace

PlaneBodies::PlaneBodies(const Model& model, const Layout& layout, int width)
    : m_(model),
      layout_(layout),
      width_(width),
      edges_(model.free),
      now_(static_cast<std::size_t>(model.n_block + model.free.n_fixed),
           Now{{0, 0, 1, 0}, 0, 0, 0, 0}),
      corner_rows_(rows_of_corners(edges_)),
      press_(press_kernel(width)) {
  const FreeShapes& f = model.free;
  double size = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.n_block); ++i) {
    double reach = 0, low = 1e300, high = -1e300;
    for (std::size_t k = f.corner_begin[f.part_begin[i]];
         k < static_cast<std::size_t>(f.corner_begin[f.part_begin[i + 1]]); ++k) {
      reach = maximum(reach, f.corner_x[k] * f.corner_x[k] + f.corner_y[k] * f.corner_y[k]);
      low = minimum(low, f.corner_y[k]), high = maximum(high, f.corner_y[k]);
    }
    reach_.push_back(square_root(reach));
    height_.push_back(high - low);
    size += 2 * reach_.back();
  }
  margin_ = kBoxMargin * size / maximum(1.0, model.n_block);
  for (const JointMaterial& material : model.materials)
    law_.push_back(contact::free_law(contact::constants_of(material), 1.0));
  chunk_of_.resize(model.n_joint);
  for (int c = 0; c < static_cast<int>(layout.chunks[kJoints].size()); ++c) {
    const Chunk& chunk = layout.chunks[kJoints][c];
    for (int n = 0; n < chunk.n; ++n) chunk_of_[chunk.first + n] = {c, n};
  }
}

contact::FreeLaw PlaneBodies::law_of(std::int32_t a, std::int32_t b) const {
  contact::FreeLaw law = law_[free_material_of(m_, a, b)];
  law.thickness = minimum(m_.free.thickness[a], m_.free.thickness[b]);
  return law;
}

BodyFrame PlaneBodies::frame_of(std::int32_t body, const WallView& wall) const {
  if (body >= m_.n_block) return {0, 0, 1, 0};
  const double c = wall.column_of(wall.t.pose, body, 2), s = wall.column_of(wall.t.pose, body, 3);
  return {m_.centroid_x[body] + wall.ux(body), m_.centroid_y[body] + wall.uy(body), 1 - 2 * s * s,
          2 * s * c};
}

Box PlaneBodies::box_of(std::int32_t body, const WallView& wall) const {
  const FreeShapes& f = m_.free;
  const BodyFrame frame = frame_of(body, wall);
  Box box{{1e300, 1e300, 0}, {-1e300, -1e300, 0}};
  for (std::size_t i = f.corner_begin[f.part_begin[body]];
       i < static_cast<std::size_t>(f.corner_begin[f.part_begin[body + 1]]); ++i) {
    const Direction2 arm = turned(frame, f.corner_x[i], f.corner_y[i]);
    const double place[2] = {frame.x + arm.x, frame.y + arm.y};
    for (int k = 0; k < 2; ++k) {
      box.low[k] = minimum(box.low[k], place[k]);
      box.high[k] = maximum(box.high[k], place[k]);
    }
  }
  return box;
}

double PlaneBodies::speed_of(BlockId i, const WallView& wall) const {
  return magnitude(wall.block(i, kVx)) + magnitude(wall.block(i, kVy)) +
         reach_[i] * magnitude(wall.block(i, kOmega));
}

double PlaneBodies::fallen_height(BlockId block, const WallView& wall) const {
  return -wall.uy(block);
}

Vector<double> PlaneBodies::place_of(std::int32_t body, const WallView& wall) const {
  const BodyFrame f = frame_of(body, wall);
  return {f.x, f.y, 0};
}

ForceMoment PlaneBodies::rates_of(std::int32_t body, const WallView& wall) const {
  if (body >= m_.n_block) return {};
  return {{wall.block(body, kVx), wall.block(body, kVy), 0}, {0, 0, wall.block(body, kOmega)}};
}

Vector<double> PlaneBodies::to_body_axes(std::int32_t body, const Vector<double>& v,
                                         const WallView& wall) const {
  const BodyFrame f = frame_of(body, wall);
  return {f.c * v.x + f.s * v.y, f.c * v.y - f.s * v.x, v.z};
}
Vector<double> PlaneBodies::to_wall_axes(std::int32_t body, const Vector<double>& v,
                                         const WallView& wall) const {
  const Direction2 d = turned(frame_of(body, wall), v.x, v.y);
  return {d.x, d.y, v.z};
}

// --- two parts ------------------------------------------------------------------------------------------

void PlaneBodies::cache_motion(std::int32_t body, const WallView& wall) {
  const ForceMoment rates = rates_of(body, wall);
  now_[body] = {frame_of(body, wall), rates.f.x, rates.f.y, rates.m.z, 0};
}

PlaneBodies::PairGeometry PlaneBodies::pair_geometry(const FreeContact& c) const {
  const FreeShapes& f = m_.free;
  return {edges_.part(f.part_begin[c.a] + c.part_a), edges_.part(f.part_begin[c.b] + c.part_b),
          now_[c.a].frame, now_[c.b].frame};
}

contact::Overlap PlaneBodies::overlap(const PairGeometry& m, std::int32_t feature, double rest) {
  return feature >= 0 ? contact::overlap_on(m.a, feature, m.b,
                                            contact::seen_from(m.frame_a, m.frame_b), rest)
                      : contact::overlap_on(m.b, -1 - feature, m.a,
                                            contact::seen_from(m.frame_b, m.frame_a), rest);
}

contact::Face PlaneBodies::face(const PairGeometry& m, std::int32_t last) const {
  return contact::face_of(m.a, m.b, contact::seen_from(m.frame_a, m.frame_b),
                          contact::seen_from(m.frame_b, m.frame_a), last, kSlop * m_.free.bevel);
}

Vector<double> PlaneBodies::normal_of(const PairGeometry& m, std::int32_t feature) {
  const EdgeAxes& axes = axes_of(m, feature);
  const Direction2 n = turned(dynamics::frame_of(m, feature), axes.nx, axes.ny);
  const double sense = feature >= 0 ? 1 : -1;
  return {sense * n.x, sense * n.y, 0};
}

double PlaneBodies::turn_slip(FreePair& pair, const PairGeometry& m, std::int32_t to) {
  const auto axis = [&](std::int32_t feature) {
    const EdgeAxes& axes = axes_of(m, feature);
    return turned(dynamics::frame_of(m, feature), axes.ax, axes.ay);
  };
  const std::int32_t from = pair.memory.feature;
  const Direction2 was = axis(from), is = axis(to);
  // along an edge of b the axis runs the other way, and so does the slip
  const double same = (from >= 0) == (to >= 0) ? 1 : -1;
  const double before = shear_energy(pair.memory, pair.law);
  pair.memory.slip_x *= same * (was.x * is.x + was.y * is.y);
  return before - shear_energy(pair.memory, pair.law);
}

PlaneBodies::SlipUpdate PlaneBodies::update_slip(FreePair& pair, const PairGeometry& m,
                                                 const Overlap& overlap, double dt) const {
  const std::int32_t feature = pair.memory.feature;
  const bool of_a = feature >= 0;
  const EdgeAxes& axes = axes_of(m, feature);
  const BodyFrame &ref = of_a ? m.frame_a : m.frame_b, &other = of_a ? m.frame_b : m.frame_a;
  const Direction2 x = turned(ref, axes.ax, axes.ay), n = turned(ref, axes.nx, axes.ny);

  // slip of `other` along the edge in the last step, at the centre of pressure
  const double place = overlap.area > 0 ? overlap.moment / overlap.area : 0.0;
  const Direction2 arm = turned(ref, axes.x + axes.ax * place, axes.y + axes.ay * place);
  const double ox = ref.x + arm.x - other.x, oy = ref.y + arm.y - other.y;
  const ForceMoment of_ref = rates_now(of_a ? pair.memory.a : pair.memory.b);
  const ForceMoment of_other = rates_now(of_a ? pair.memory.b : pair.memory.a);
  // arms and axis half a step ago, in the middle of that motion
  const auto back = [&](const ForceMoment& rates, double rx, double ry) {
    const double half = 0.5 * dt * rates.m.z;
    return Direction2{rx + half * ry, ry - half * rx};
  };
  const Direction2 r = back(of_ref, arm.x, arm.y), o = back(of_other, ox, oy);
  const Direction2 along_then = back(of_ref, x.x, x.y);
  const double vx = (of_other.f.x - of_other.m.z * o.y) - (of_ref.f.x - of_ref.m.z * r.y);
  const double vy = (of_other.f.y + of_other.m.z * o.x) - (of_ref.f.y + of_ref.m.z * r.x);

  const contact::FreeLaw& law = pair.law;
  const double k = stiffness(law), normal = k * overlap.area;
  pair.pressed = normal;
  double& slip = pair.memory.slip_x;
  // A growing area increases the force, a shrinking one reduces the slip: neither creates energy.
  const double area = overlap.cover * law.thickness;
  const double energy = shear_energy(pair.memory, law), held = law.ks * pair.memory.area * slip;
  if (area > pair.memory.area && pair.memory.area > 0) slip *= pair.memory.area / area;
  pair.memory.area = area;
  const double stiff = law.ks * area, limit = law.tan_friction * normal;
  const double slip_step = dt * (vx * along_then.x + vy * along_then.y);
  slip += slip_step;
  if (const double trial = stiff * slip; magnitude(trial) > limit) {
    const double kept = sign(trial) * limit / stiff;
    slip = kept;
  }
  // the work of the step, less the part that is stored
  pair.friction +=
      0.5 * (held + stiff * slip) * slip_step + (energy - shear_energy(pair.memory, law));
  pair.stored = k * overlap.energy + shear_energy(pair.memory, law);

  // force on `other`; its moment about the origin of the edge's axes, carried to both centroids
  const double along = k * overlap.side - stiff * slip;
  const double fx = normal * n.x + along * x.x, fy = normal * n.y + along * x.y;
  const Direction2 origin = turned(ref, axes.x, axes.y);
  const double moment = k * overlap.moment;
  const double gx = ref.x + origin.x - other.x, gy = ref.y + origin.y - other.y;
  const ForceMoment on_other{{fx, fy, 0}, {0, 0, moment + (gx * fy - gy * fx)}};
  const ForceMoment on_ref{{-fx, -fy, 0}, {0, 0, -(moment + (origin.x * fy - origin.y * fx))}};
  pair.on_a = of_a ? on_ref : on_other;
  pair.on_b = of_a ? on_other : on_ref;
  return {dt * (vx * n.x + vy * n.y),
          {slip_step, 0, 0},
          {stiff * slip, 0, 0},
          arm.x,
          arm.y,
          ox,
          oy,
          n.x,
          n.y,
          x.x,
          x.y};
}

bool PlaneBodies::add_to(Packed& packed, const FreePair& pair) const {
  const FreeContact& c = pair.memory;
  const bool of_a = c.feature >= 0;
  const std::size_t part_a = m_.free.part_begin[c.a] + c.part_a;
  const std::size_t part_b = m_.free.part_begin[c.b] + c.part_b;
  const contact::PartEdges::Range &ref = edges_.range[of_a ? part_a : part_b],
                                  &other = edges_.range[of_a ? part_b : part_a];
  if (other.corners > kMostCorners) return false;
  PressGroup& g = packed.group;
  const int k = packed.n;
  g.ref[k] = 2 * (of_a ? c.a : c.b);
  g.other[k] = 2 * (of_a ? c.b : c.a);
  g.edge[k] = 2 * (ref.first + (of_a ? c.feature : -1 - c.feature));
  g.corners[k] = kCornerRows * other.shape;
  const int rows = (other.corners + 1) / 2;
  g.corner_rows = k == 0 ? rows : std::max(g.corner_rows, rows);
  g.rest[k] = c.rest, g.area[k] = c.area, g.slip[k] = c.slip_x;
  g.kn[k] = pair.law.kn, g.ks[k] = pair.law.ks, g.thickness[k] = pair.law.thickness;
  g.tan_friction[k] = pair.law.tan_friction;
  return true;
}

void PlaneBodies::press(Packed& packed, double dt) const {
  PressGroup& g = packed.group;
  const int last = packed.n - 1;
  for (int k = packed.n; k < kGroup; ++k) {
    for (std::int32_t* row : {g.ref, g.other, g.edge, g.corners}) row[k] = row[last];
    for (double* row : {g.rest, g.area, g.slip, g.kn, g.ks, g.tan_friction, g.thickness})
      row[k] = row[last];
  }
  press_({&now_.front().frame.x, &edges_.edge.front().x, corner_rows_.data(), dt}, g);
}

bool PlaneBodies::take(const Packed& packed, int k, FreePair& pair) {
  const PressGroup& g = packed.group;
  if (!(g.cover[k] > 0)) return false;
  pair.memory.area = g.area_now[k];
  pair.memory.slip_x = g.slip_now[k];
  pair.pressed = g.pressed[k];
  pair.stored = g.stored[k];
  pair.friction = g.friction[k];
  const bool of_a = pair.memory.feature >= 0;
  (of_a ? pair.on_b : pair.on_a) = {{g.fx[k], g.fy[k], 0}, {0, 0, g.on_other[k]}};
  (of_a ? pair.on_a : pair.on_b) = {{-g.fx[k], -g.fy[k], 0}, {0, 0, g.on_ref[k]}};
  return true;
}

double PlaneBodies::mobility(const FreeContact& c, const SlipUpdate& r) const {
  const bool of_a = c.feature >= 0;
  const auto of = [&](std::int32_t body, double x, double y) {
    if (body >= m_.n_block) return 0.0;
    return 1 / m_.mass[body] + (x * x + y * y) / m_.inertia[body];
  };
  return of(of_a ? c.a : c.b, r.ref_x, r.ref_y) + of(of_a ? c.b : c.a, r.other_x, r.other_y);
}

void PlaneBodies::spread(const ViscousForce& f, const SlipUpdate& r, bool of_a, ForceMoment& on_a,
                         ForceMoment& on_b) {
  const double fx = -f.normal * r.nx - f.shear.x * r.tx, fy = -f.normal * r.ny - f.shear.x * r.ty;
  const ForceMoment on_other{{fx, fy, 0}, {0, 0, r.other_x * fy - r.other_y * fx}};
  const ForceMoment on_ref{{-fx, -fy, 0}, {0, 0, -(r.ref_x * fy - r.ref_y * fx)}};
  on_a = of_a ? on_ref : on_other;
  on_b = of_a ? on_other : on_ref;
}

void PlaneBodies::take_over_shear(FreePair& pair, const Vector<double>& on_a) const {
  const PairGeometry m = pair_geometry(pair.memory);
  const std::int32_t feature = pair.memory.feature;
  const EdgeAxes& axes = axes_of(m, feature);
  const Direction2 x = turned(dynamics::frame_of(m, feature), axes.ax, axes.ay);
  const double on_ref = (on_a.x * x.x + on_a.y * x.y) * (feature >= 0 ? 1 : -1);
  const double most = pair.law.tan_friction * pair.pressed;
  pair.memory.slip_x = clip(on_ref, -most, most) / (pair.law.ks * pair.memory.area);
}

// --- rows of forces -------------------------------------------------------------------------------------

void PlaneBodies::clear_rows(const WallView& wall) const {
  std::fill_n(wall.t.force + 4 * wall.first_free, 4 * (wall.blocks + 1), 0.0);
}

// One row for each block, then one for the ground. The last
// column sums the magnitudes that the unbalance needs.
void PlaneBodies::add(std::int32_t a, std::int32_t b, const ForceMoment& on_a,
                      const ForceMoment& on_b, const WallView& wall) const {
  double* const rows = wall.t.force + 4 * wall.first_free;
  const bool fixed = b >= m_.n_block;
  const auto put = [rows](std::int32_t body, const ForceMoment& push) {
    double* const row = rows + 4 * static_cast<std::ptrdiff_t>(body);
    row[0] += push.f.x, row[1] += push.f.y, row[2] += push.m.z;
  };
  put(a, on_a);
  put(fixed ? wall.blocks : b, on_b);
  rows[4 * static_cast<std::ptrdiff_t>(wall.blocks) + 3] +=
      (fixed ? 1.0 : 2.0) * (magnitude(on_b.f.x) + magnitude(on_b.f.y));
}

// --- joints ---------------------------------------------------------------------------------------------

std::pair<std::int32_t, std::int32_t> PlaneBodies::sides_of(JointId joint) const {
  const BlockId a = m_.joint_a[joint], b = m_.joint_b[joint];
  if (a != kGroundBlock) return std::minmax(a, b);
  const std::int32_t support = support_of(m_, joint);
  return support < 0 ? std::pair(-1, -1) : std::pair(b, support);
}

PlaneBodies::Gap PlaneBodies::gap_of(JointId joint, const WallView& wall) const {
  const std::size_t j = joint;
  const BlockId ja = m_.joint_a[j], jb = m_.joint_b[j];
  const BodyFrame b = frame_of(jb, wall);
  const Direction2 arm_b = turned(b, m_.arm_b_x[j], m_.arm_b_y[j]);
  double ax = m_.centroid_x[jb] + m_.arm_b_x[j], ay = m_.centroid_y[jb] + m_.arm_b_y[j];
  double tilt = wall.block(jb, kTheta);
  if (ja != kGroundBlock) {
    const BodyFrame a = frame_of(ja, wall);
    const Direction2 arm_a = turned(a, m_.arm_a_x[j], m_.arm_a_y[j]);
    ax = a.x + arm_a.x;
    ay = a.y + arm_a.y;
    tilt -= wall.block(ja, kTheta);
  }
  return {b.x + arm_b.x - ax, b.y + arm_b.y - ay, tilt};
}

PlaneBodies::Jump PlaneBodies::jump_of(JointId joint, const WallView& wall) const {
  const std::size_t j = joint;
  const BlockId ja = m_.joint_a[j];
  const bool ground = ja == kGroundBlock;
  const auto [jx, jy, tilt] = gap_of(joint, wall);
  const double turn_a = ground ? 0.0 : wall.block(ja, kTheta);
  const SinCos<double> mean = sin_cos(ground ? 0.0 : turn_a + 0.5 * tilt);
  const SinCos<double> half = sin_cos(0.5 * tilt);
  const double tx = mean.cos * m_.tangent_x[j] - mean.sin * m_.tangent_y[j];
  const double ty = mean.sin * m_.tangent_x[j] + mean.cos * m_.tangent_y[j];
  const double reach = m_.half_x[j] * m_.tangent_x[j] + m_.half_y[j] * m_.tangent_y[j];
  const double growth = 2 * half.sin * (ground ? half.cos : 1.0);
  return {jy * tx - jx * ty, jx * tx + jy * ty, reach * growth, tilt};
}

namespace {

bool is_tilted(double tilt) {
  constexpr double kTilted = 0.05235987755982989;  // 3 degrees
  return magnitude(tilt) > kTilted;
}

}  // namespace

bool PlaneBodies::has_failed(JointId joint, const WallView& wall) const {
  constexpr double kSlipped = 0.05;  // of the length of the face, for slip and opening
  const Gap gap = gap_of(joint, wall);
  const double hx = m_.half_x[joint], hy = m_.half_y[joint];
  const double most = 4 * kSlipped * kSlipped * (hx * hx + hy * hy);
  if (is_tilted(gap.tilt)) return true;
  if (gap.x * gap.x + gap.y * gap.y <= most) return false;  // most joints: neither is longer
  const Jump jump = jump_of(joint, wall);
  const double apart = maximum(0.0, jump.normal - magnitude(jump.growth));  // at its nearer end
  return jump.along * jump.along > most || apart * apart > most;
}

contact::History<double> PlaneBodies::history_of(JointId joint, int point,
                                                 const WallView& wall) const {
  const auto& [chunk, n] = chunk_of_[joint];
  const Chunk& run = layout_.chunks[kJoints][chunk];
  contact::History<double> h{};
  for (int row = 0; row < run.rows; ++row)
    h.*contact::kHistory<double>[row] =
        wall.t.history[layout_.point_number(run, run.history, n, point, run.rows, row, 1)];
  return h;
}

// A tilted joint bears on an edge, whose point may be undamaged.
bool PlaneBodies::holds(JointId joint, const WallView& wall) const {
  constexpr double kBroken = 0.999;  // damage of a point
  const auto law = contact::constants_of(m_.materials[m_.joint_material[joint]]);
  const Jump jump = jump_of(joint, wall);
  for (int k = 0; k < m_.n_face_point; ++k) {
    const contact::History<double> h = history_of(joint, k, wall);
    const double tension = contact::tension_left<contact::AnyVariant>(law, h.kappa);
    const double left =
        contact::strength_left<contact::AnyVariant>(law, tension, 1 - h.shear_damage);
    const bool closed = jump.normal + m_.point_xi[k] * jump.growth + h.crush <= 0;
    if (left > 1 - kBroken && !(is_tilted(jump.tilt) && closed)) return true;
  }
  return false;
}

ForceMoment PlaneBodies::joint_force(JointId joint, std::int32_t on, const WallView& wall) const {
  const double* row = wall.t.force + 4 * static_cast<std::ptrdiff_t>(layout_.joint_place[joint]);
  if (m_.joint_a[joint] == on) return {{row[0], row[1], 0}, {0, 0, row[2]}};
  return {{-row[0], -row[1], 0}, {0, 0, row[3]}};
}

double PlaneBodies::elastic_energy(JointId joint, const WallView& wall) const {
  const std::size_t j = joint;
  const JointMaterial& material = m_.materials[m_.joint_material[j]];
  const auto law = contact::constants_of(material);
  const Jump jump = jump_of(joint, wall);
  double energy = 0;
  for (int k = 0; k < m_.n_face_point; ++k) {
    contact::History<double> h = history_of(joint, k, wall);
    const double w = jump.normal + m_.point_xi[k] * jump.growth;
    const auto now = contact::update<contact::AnyVariant>(law, w, jump.along, h);
    const bool secant = now.sigma > 0 && material.unloading == Unloading::kSecant;
    const double normal =
        secant ? 0.5 * now.sigma * (w + h.crush) : 0.5 * now.sigma * now.sigma * law.inv_kn;
    energy += m_.area[j] * m_.point_weight[k] * (normal + 0.5 * now.tau * now.tau * law.inv_ks);
  }
  return energy;
}

void PlaneBodies::restore(const WallView& wall) const {
  for (JointId j = 0; j < m_.n_joint; ++j) {
    const std::int32_t place = layout_.joint_place[j];
    const BlockId a = m_.joint_a[j];
    wall.t.joint_a[place] = a == kGroundBlock ? wall.t.n_block : a;
    wall.t.joint_b[place] = m_.joint_b[j];
    wall.t.joint[layout_.number(place, kJointRows, kArea, 1)] = m_.area[j];
  }
}

// A released joint lies between the ground and itself, without an area.
void PlaneBodies::release(JointId joint, const WallView& wall) const {
  const std::int32_t place = layout_.joint_place[joint];
  wall.t.joint_a[place] = wall.t.joint_b[place] = wall.t.n_block;
  wall.t.joint[layout_.number(place, kJointRows, kArea, 1)] = 0;
  std::fill_n(wall.t.force + 4 * static_cast<std::ptrdiff_t>(place), 4, 0.0);
  const auto& [number, n] = chunk_of_[joint];
  const Chunk& chunk = layout_.chunks[kJoints][number];
  for (int k = 0; k < m_.n_face_point; ++k)
    for (const int row : {row_of(&State::crush), row_of(&State::plastic_slip)})
      wall.t.history[layout_.point_number(chunk, chunk.history, n, k, chunk.rows, row, 1)] = 0;
}

// All other faces take the full law in the next step.
void PlaneBodies::end_release(const WallView& wall) const {
  mark_released(wall.t.joint_b, wall.t.n_block, layout_.joints, width_, wall.t.joint_law_path);
}

}  // namespace wythe::dynamics
