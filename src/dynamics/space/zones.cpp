// Each step computes forces of zones on their corners, the law at contacts with rigid blocks, then nodes
// (docs/theory/zones.md, 8.13 to 8.15). Zones and contacts write rows of their own. Each node sums them in a
// fixed order, so that threads change no bit. The gap of the step before is computed only where a point slips.
#include "dynamics/space/zones.h"

#include <algorithm>

#include "contact/face_in_space.h"
#include "contact/law.h"
#include "contact/parameters.h"
#include "model/fields.h"
#include "solids/hexahedron.h"

namespace wythe::dynamics::space {
namespace {

constexpr int kZoneChunk = 32, kContactChunk = 32, kNodeChunk = 256;

int chunks_of(int n, int chunk) { return (n + chunk - 1) / chunk; }

// Calls act(i, chunk) for i = 0 .. n-1, chunk by chunk.
template <class Act>
void each(Workers* workers, int n, int size, const Act& act) {
  const auto work = [&](int chunk) {
    for (int i = chunk * size; i < std::min(n, (chunk + 1) * size); ++i)
      act(static_cast<std::size_t>(i), static_cast<std::size_t>(chunk));
  };
  if (workers != nullptr) return workers->for_each_chunk(chunks_of(n, size), work);
  for (int chunk = 0; chunk < chunks_of(n, size); ++chunk) work(chunk);
}

double length_of(const Vec& v) { return square_root(dot(v, v)); }

}  // namespace

ZoneRun::ZoneRun(const Model& model, const State& s)
    : m_(model),
      s_(model.space.solids),
      u_(static_cast<std::size_t>(s_.n_node)),
      v_(static_cast<std::size_t>(s_.n_node)),
      total_(static_cast<std::size_t>(s_.n_node), Vec{0, 0, 0}),
      corner_force_(8 * static_cast<std::size_t>(s_.n_zone), Vec{0, 0, 0}),
      side_force_(4 * static_cast<std::size_t>(s_.n_contact), Vec{0, 0, 0}),
      joint_work_(static_cast<std::size_t>(chunks_of(s_.n_contact, kContactChunk))),
      node_work_(static_cast<std::size_t>(chunks_of(s_.n_node, kNodeChunk))) {
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] = {s.node_ux[i], s.node_uy[i], s.node_uz[i]};
    v_[i] = {s.node_vx[i], s.node_vy[i], s.node_vz[i]};
  }
  for (const JointMaterial& material : model.materials)
    law_.push_back(contact::constants_of(material));
  const std::size_t first = s_.point_begin.front();
  point_.resize(static_cast<std::size_t>(s_.point_begin.back()) - first);
  for (std::size_t p = 0; p < point_.size(); ++p) {
    point_[p].history = {};
    for (const StateField& field : kStateFields)
      if (field.entity == Entity::kPoint && !(s.*field.array).empty())
        point_[p].history.*contact::kHistory<double>[row_of(field.array)] =
            (s.*field.array)[first + p];
    point_[p].plastic_2 = s.plastic_slip_2[first + p];
  }
}

void ZoneRun::store_state(State& s) const {
  for (std::size_t i = 0; i < u_.size(); ++i) {
    s.node_ux[i] = u_[i].x, s.node_uy[i] = u_[i].y, s.node_uz[i] = u_[i].z;
    s.node_vx[i] = v_[i].x, s.node_vy[i] = v_[i].y, s.node_vz[i] = v_[i].z;
  }
  const std::size_t first = s_.point_begin.front();
  for (std::size_t p = 0; p < point_.size(); ++p) {
    for (const StateField& field : kStateFields)
      if (field.entity == Entity::kPoint && !(s.*field.array).empty())
        (s.*field.array)[first + p] =
            point_[p].history.*contact::kHistory<double>[row_of(field.array)];
    s.plastic_slip_2[first + p] = point_[p].plastic_2;
  }
}

void ZoneRun::deform(Workers* workers) {
  each(workers, s_.n_zone, kZoneChunk, [&](std::size_t z, std::size_t) {
    solids::HexahedronVectors u;
    for (std::size_t k = 0; k < 8; ++k) u[k] = u_[s_.corner[8 * z + k]];
    const solids::HexahedronVectors f = solids::hexahedron_force(s_.shapes[s_.zone_shape[z]], u);
    std::copy(f.begin(), f.end(), corner_force_.begin() + static_cast<std::ptrdiff_t>(8 * z));
  });
}

// Geometry of a contact for the present rigid block and nodes: the turned face and the side.
struct ZoneRun::ContactGeometry {
  contact::Pose<double> pose;
  Vec t1, t2, n, node[4];
};
ZoneRun::ContactGeometry ZoneRun::contact_geometry(std::size_t c, const contact::Pose<double>& pose,
                                                   double back) const {
  const Vec t1 = turned(pose.q, vec(s_.contact_tangent[c]));
  const Vec n = turned(pose.q, vec(s_.contact_normal[c]));
  ContactGeometry m{pose, t1, cross(n, t1), n, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t i = s_.contact_node[4 * c + k];
    m.node[k] = u_[i] - back * v_[i];
  }
  return m;
}

// A point of it: its place from a's centroid, and the gap between side and face.
ZoneRun::ContactMotion ZoneRun::contact_motion(std::size_t c, std::size_t p,
                                               const ContactGeometry& m) const {
  const double* share = &s_.node_share[4 * (p - static_cast<std::size_t>(s_.point_begin.front()))];
  const Vec t0 = vec(s_.contact_tangent[c]), across = cross(vec(s_.contact_normal[c]), t0);
  const Vec on_side =
      (share[0] * m.node[0] + share[1] * m.node[1]) + (share[2] * m.node[2] + share[3] * m.node[3]);
  const Vec arm =
      vec(s_.contact_arm[c]) + m_.space.point_r1[p] * t0 + m_.space.point_r2[p] * across;
  const Vec swung = swing(m.pose.q, arm), jump = on_side - (m.pose.u + swung);
  return {arm + swung + jump, {dot(jump, m.t1), dot(jump, m.t2), dot(jump, m.n)}};
}

// The same in the step before; for supports see joints.h.
ZoneRun::ContactGeometry ZoneRun::contact_geometry_before(std::size_t c, const WallView& w) const {
  const double dt = w.wall_value(kTimeBefore);
  const BlockId block = s_.contact_block[c];
  if (block < w.blocks) return contact_geometry(c, pose_before(block, w), dt);
  const auto moved = [&](int k) {
    const std::int32_t support = block - w.blocks;
    return w.column_of(w.t.support, support, k) -
           w.column_of(w.t.support, support, kDriven) * w.wall_value(kSupportStep + k);
  };
  return contact_geometry(c, {{moved(0), moved(1), moved(2)}, {1, {0, 0, 0}}}, dt);
}

// Evaluates the law of variant V at the points of one contact.
template <class V>
void ZoneRun::ask(std::size_t c, const WallView& w, JointWork<double>& work) {
  const contact::LawConstants<double>& law = law_[s_.contact_material[c]];
  const BlockId block = s_.contact_block[c];
  const bool on_block = block < w.blocks;
  const auto support = [&](int k) { return w.column_of(w.t.support, block - w.blocks, k); };
  const Vec moved = on_block ? w.shift(block) : Vec{support(0), support(1), support(2)};
  const Quaternion<double> q = on_block ? w.turn(block) : Quaternion<double>{1, {0, 0, 0}};
  const ContactGeometry m = contact_geometry(c, {moved, q}, 0);
  Vec sum{0, 0, 0}, moment{0, 0, 0}, side[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const std::size_t first = s_.point_begin.front();
  for (std::size_t p = s_.point_begin[c]; p < static_cast<std::size_t>(s_.point_begin[c + 1]);
       ++p) {
    const double* share = &s_.node_share[4 * (p - first)];
    const ContactMotion now = contact_motion(c, p, m);
    Point& point = point_[p - first];
    contact::History<double> h = point.history;
    const contact::Shear<double> shear =
        contact::shear_of(now.gap.x, now.gap.y, h.plastic_slip, point.plastic_2);
    const double before = h.plastic_slip;
    h.plastic_slip = 0;
    const contact::History<double> then = h;
    const contact::LawUpdate<double> a = contact::update<V>(law, now.gap.z, shear.e, h);
    const double area = s_.contact_area[c] * m_.space.point_share[p];
    double friction = a.friction;
    if (a.slipped != 0) {
      const Vec gap = contact_motion(c, p, contact_geometry_before(c, w)).gap;
      const double along =
          contact::along(shear, contact::shear_of(gap.x, gap.y, before, point.plastic_2));
      friction = contact::friction_taken<V>(law, a, then, gap.z, along);
    }
    const double slid =
        h.plastic_slip / std::max(shear.e, 1e-300);  // share of e that is plastic now
    const double slid_1 = slid * shear.e1, slid_2 = slid * shear.e2;
    h.plastic_slip = before + slid_1;
    point.history = h;
    point.plastic_2 += slid_2;
    const Vec f = area * (a.sigma * m.n + (law.ks * (shear.e1 - slid_1)) * m.t1 +
                          (law.ks * (shear.e2 - slid_2)) * m.t2);
    work = {work.friction + friction * area, work.fracture + a.fracture * area,
            work.crushing + a.crushing * area};
    sum = sum + f;
    moment = moment + cross(now.arm, f);
    for (int k = 0; k < 4; ++k) side[k] = side[k] - share[k] * f;
  }
  std::copy_n(side, 4, side_force_.begin() + static_cast<std::ptrdiff_t>(4 * c));
  const std::ptrdiff_t row = w.layout->first_contact + static_cast<std::ptrdiff_t>(c);
  w.store_vector(sum, w.t.force, row);
  w.store_vector(moment, w.t.moment_a, row);
}

void ZoneRun::press(const WallView& wall, Workers* workers) {
  std::fill(joint_work_.begin(), joint_work_.end(), JointWork<double>{0, 0, 0});
  each(workers, s_.n_contact, kContactChunk, [&](std::size_t c, std::size_t chunk) {
    contact::with_variant(law_[s_.contact_material[c]].choice,
                          [&](auto chosen) { ask<decltype(chosen)>(c, wall, joint_work_[chunk]); });
  });
}

void ZoneRun::move(const WallView& w, double dt, double mass_scaling, Workers* workers) {
  std::fill(node_work_.begin(), node_work_.end(), BlockWork<double>{0, 0});
  const double lambda = w.wall_value(kLambda);
  const Vec gravity = w.gravity();
  each(workers, s_.n_node, kNodeChunk, [&](std::size_t i, std::size_t chunk) {
    Vec f{0, 0, 0};
    for (std::size_t e = s_.zone_begin[i]; e < static_cast<std::size_t>(s_.zone_begin[i + 1]); ++e)
      f = f + corner_force_[s_.zone_entry[e]];
    for (std::size_t e = s_.contact_begin[i]; e < static_cast<std::size_t>(s_.contact_begin[i + 1]);
         ++e)
      f = f + side_force_[s_.contact_entry[e]];
    const Vec load = s_.node_gravity_mass[i] * gravity;
    f = f + load;
    total_[i] = f;
    const Vec v0 = v_[i], damped = damping_of(f, v0, lambda, w.t.damps_components);
    v_[i] = v0 + (dt / (s_.node_mass[i] * mass_scaling)) * (f + damped);
    u_[i] = u_[i] + dt * v_[i];
    const Vec mean = 0.5 * (v0 + v_[i]);
    BlockWork<double>& work = node_work_[chunk];
    work = {work.loads + dt * dot(load, mean), work.damping + dt * dot(damped, mean)};
  });
}

void ZoneRun::tell(State& s) const {
  for (const JointWork<double>& work : joint_work_) {
    s.energy.dissipated_friction += work.friction;
    s.energy.dissipated_fracture += work.fracture;
    s.energy.dissipated_crushing += work.crushing;
  }
  for (const BlockWork<double>& work : node_work_) {
    s.energy.work_loads += work.loads;
    s.energy.work_damping += work.damping;
  }
}

double ZoneRun::unbalanced() const {
  double sum = 0;
  for (const Vec& f : total_) sum += length_of(f);
  return sum;
}

double ZoneRun::pressed(const WallView& w) const {
  double sum = 0;
  for (int c = 0; c < s_.n_contact; ++c) {
    const double sides = s_.contact_block[c] < w.blocks ? 2.0 : 1.0;
    sum += sides * length_of(w.force(w.layout->first_contact + c));
  }
  return sum;
}

double ZoneRun::kinetic(double mass_scaling) const {
  double sum = 0;
  for (std::size_t i = 0; i < v_.size(); ++i)
    sum += 0.5 * s_.node_mass[i] * mass_scaling * dot(v_[i], v_[i]);
  return sum;
}

double ZoneRun::shear(const WallView& w, const Vec3& along) const {
  double sum = 0;
  for (int c = 0; c < s_.n_contact; ++c) {
    const std::int32_t support = s_.contact_block[c] - w.blocks;
    if (support < 0 || w.is_driven_support(support)) continue;
    sum += dot(w.force(w.layout->first_contact + c), vec(along));
  }
  return sum;
}

int ZoneRun::runaway() const {
  constexpr double kFast = 100.0;  // [m/s], as of blocks
  for (std::size_t i = 0; i < v_.size(); ++i)
    if (!(length_of(v_[i]) < kFast)) return static_cast<int>(i);
  return -1;
}

Furthest ZoneRun::furthest() const {
  Furthest far;
  for (std::size_t i = 0; i < u_.size(); ++i)
    if (const double moved = length_of(u_[i]); moved > far.distance)
      far = {moved, static_cast<BlockId>(i)};
  return far;
}

}  // namespace wythe::dynamics::space
