// Reads zones of a wall in space: contacts as joints, energies, stresses, and the measures of a lintel by sections.
// A lintel has the direction of its longer horizontal side, towards +x, or +z where it runs along z. So its left end does
// not depend on the numbers of its corners.
#include "reading/zones_in_space.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "solids/hexahedron.h"

namespace wythe {
namespace reading {
namespace {

Vec3 moved_of(const State& s, std::size_t node) {
  return {s.node_ux[node], s.node_uy[node], s.node_uz[node]};
}

solids::HexahedronVectors displacements(const SpaceSolids& m, const State& s, std::size_t zone) {
  solids::HexahedronVectors u;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3 moved = moved_of(s, static_cast<std::size_t>(m.corner[8 * zone + k]));
    u[k] = {moved.x, moved.y, moved.z};
  }
  return u;
}

const HexahedronShape& shape_of(const SpaceSolids& m, std::size_t zone) {
  return m.shapes[m.zone_shape[zone]];
}

// Rotation vector of a matrix, by less than half a turn.
Rotation rotation_of(const double (&r)[3][3]) {
  const Vec3 twice{r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]};
  const double sine = 0.5 * length(twice), cosine = 0.5 * (r[0][0] + r[1][1] + r[2][2] - 1);
  if (sine == 0) return {};
  return {elementary::atan2(sine, cosine) / (2 * sine) * twice};
}

}  // namespace

JointShape contact_in_space(const Model& model, int contact) {
  const SpaceSolids& s = model.space.solids;
  JointShape shape;
  shape.id = model.n_joint + contact;
  shape.kind = JointKind::kLintelBond;
  const BlockId rigid = s.contact_block[contact];
  shape.a = rigid < model.n_block ? rigid : kGroundBlock;
  shape.b = model.n_block + model.space.n_support + s.contact_body[contact];
  shape.material = s.contact_material[contact];
  shape.area = s.contact_area[contact];
  shape.centre = model.space.centroid[rigid] + s.contact_arm[contact];
  shape.along = s.contact_tangent[contact];
  shape.normal = s.contact_normal[contact];
  double reach = 0;
  for (std::size_t p = s.point_begin[contact];
       p < static_cast<std::size_t>(s.point_begin[contact + 1]); ++p)
    reach = std::fmax(reach, std::fabs(model.space.point_r1[p]));
  shape.half = reach * shape.along;
  if (shape.a != kGroundBlock) shape.arm_a = s.contact_arm[contact];
  return shape;
}

Vec3 side_moved(const Model& model, const State& state, int contact, std::size_t point) {
  const SpaceSolids& s = model.space.solids;
  Vec3 sum;
  for (std::size_t k = 0; k < 4; ++k)
    sum = sum + s.node_share[4 * (point - static_cast<std::size_t>(s.point_begin[0])) + k] *
                    moved_of(state, static_cast<std::size_t>(
                                        s.contact_node[4 * static_cast<std::size_t>(contact) + k]));
  return sum;
}

RigidSide rigid_side(const Model& model, const State& s, int contact) {
  const BlockId block = model.space.solids.contact_block[contact];
  if (const int support = block - model.n_block; support >= 0) {
    return {{1, {0, 0, 0}}, {s.support_x[support], s.support_y[support], s.support_z[support]}};
  }
  return {{s.qw[block], {s.qx[block], s.qy[block], s.qz[block]}},
          {s.ux[block], s.uy[block], s.uz[block]}};
}

BlockReading body_in_space(const Model& model, const State& state, int body) {
  const SpaceSolids& s = model.space.solids;
  const SpaceSolidBody& of = s.bodies[body];
  Vec3 sum;
  double mass = 0;
  for (std::size_t i = of.first_node; i < static_cast<std::size_t>(of.first_node + of.n_node);
       ++i) {
    sum = sum + s.node_gravity_mass[i] * moved_of(state, i);
    mass += s.node_gravity_mass[i];
  }
  return {model.n_block + model.space.n_support + body, of.role, of.centroid, sum / mass, {}};
}

double strain_energy_in_space(const Model& model, const State& state) {
  const SpaceSolids& s = model.space.solids;
  double energy = 0;
  for (std::size_t z = 0; z < static_cast<std::size_t>(s.n_zone); ++z)
    energy += solids::hexahedron_energy(shape_of(s, z), displacements(s, state, z));
  return energy;
}

std::vector<BeyondLimit> beyond_limits_in_space(const Model& model, const State& state) {
  std::vector<BeyondLimit> found;
  const SpaceSolids& s = model.space.solids;
  for (const SpaceSolidBody& body : s.bodies) {
    if (!std::isfinite(body.tension_limit) && !std::isfinite(body.compression_limit)) continue;
    for (std::size_t z = body.first_zone;
         z < static_cast<std::size_t>(body.first_zone + body.n_zone); ++z) {
      const auto u = displacements(s, state, z);
      const auto principal = solids::principal_of(solids::hexahedron_stress(shape_of(s, z), u));
      Vec3 middle;
      for (std::size_t k = 0; k < 8; ++k)
        middle = middle + 0.125 * (s.node[s.corner[8 * z + k]] +
                                   moved_of(state, static_cast<std::size_t>(s.corner[8 * z + k])));
      if (principal[0] > body.tension_limit)
        found.push_back({&body.body.id, true, principal[0], body.tension_limit, middle});
      if (-principal[2] > body.compression_limit)
        found.push_back({&body.body.id, false, -principal[2], body.compression_limit, middle});
    }
  }
  return found;
}

// Sections of a lintel from its left end to its right end, along its longer horizontal side, towards +x or +z.
class LintelStations {
 public:
  LintelStations(const SpaceSolids& m, const SpaceSolidBody& body) : m_(m), body_(body) {
    const Vec3 a = m.node[body.node(body.count[0], 0, 0)] - m.node[body.node(0, 0, 0)],
               c = m.node[body.node(0, 0, body.count[2])] - m.node[body.node(0, 0, 0)];
    runs_along_c_ = length(c) > length(a);
    along_ = runs_along_c_ ? c / length(c) : a / length(a);
    is_reversed_ = along_.x < -1e-9 || (std::fabs(along_.x) <= 1e-9 && along_.z < 0);
    if (is_reversed_) along_ = -1.0 * along_;
  }
  [[nodiscard]] int count() const { return body_.count[runs_along_c_ ? 2 : 0]; }

  // Deflection of a section, averaged over its nodes [m].
  [[nodiscard]] double sag(const State& s, int station) const {
    double sum = 0, n = 0;
    each_place(1, [&](int across, int up) { sum -= s.node_uy[node(station, up, across)], ++n; });
    return sum / n;
  }
  // Rotation of a section, from its lowest nodes to its highest, in the vertical plane of the lintel.
  [[nodiscard]] double turn(const State& s, int station) const {
    const int top = body_.count[1];
    double along = 0, high = 0;
    for (int across = 0; across <= others(); ++across) {
      const std::size_t low = node(station, 0, across),
                        up = static_cast<std::size_t>(node(station, top, across));
      const Vec3 between = m_.node[up] - m_.node[low] + moved_of(s, up) - moved_of(s, low);
      along += dot(between, along_), high += between.y;
    }
    return elementary::atan2(-along, high);
  }
  // Axial force in one layer of zones normal to the lintel.
  [[nodiscard]] double axial(const State& s, int layer) const {
    const Vec3 up = m_.node[node(0, body_.count[1], 0)] - m_.node[node(0, 0, 0)],
               wide = m_.node[node(0, 0, others())] - m_.node[node(0, 0, 0)];
    const double area = length(cross(up, wide)) / (body_.count[1] * others());
    double force = 0;
    each_place(0, [&](int across, int row) {
      const int i = is_reversed_ ? count() - 1 - layer : layer;
      const std::size_t z = runs_along_c_ ? body_.zone(across, row, i) : body_.zone(i, row, across);
      const auto [xx, yy, zz, xy, yz, zx] =
          solids::hexahedron_stress(shape_of(m_, z), displacements(m_, s, z));
      const Vec3 d = along_;
      force += area * (xx * d.x * d.x + yy * d.y * d.y + zz * d.z * d.z +
                       2 * (xy * d.x * d.y + yz * d.y * d.z + zx * d.z * d.x));
    });
    return force;
  }

 private:
  [[nodiscard]] int others() const { return body_.count[runs_along_c_ ? 0 : 2]; }
  [[nodiscard]] int node(int station, int up, int across) const {
    const int i = is_reversed_ ? count() - station : station;
    return runs_along_c_ ? body_.node(across, up, i) : body_.node(i, up, across);
  }
  // Calls `act` for the zones of a section, or with `more` = 1 for its nodes.
  template <class Act>
  void each_place(int more, const Act& act) const {
    for (int across = 0; across < others() + more; ++across)
      for (int up = 0; up < body_.count[1] + more; ++up) act(across, up);
  }

  const SpaceSolids& m_;
  const SpaceSolidBody& body_;
  bool runs_along_c_ = false, is_reversed_ = false;
  Vec3 along_;
};

const SpaceSolidBody* first_lintel_in_space(const Model& model) {
  for (const SpaceSolidBody& body : model.space.solids.bodies)
    if (body.role == BlockRole::kLintel) return &body;
  return nullptr;
}

LintelMeasures lintel_measures_in_space(const Model& model, const State& s) {
  const SpaceSolidBody* body = first_lintel_in_space(model);
  if (body == nullptr) return {};
  const LintelStations lintel(model.space.solids, *body);
  const int last = lintel.count(), left = last / 2, right = (last + 1) / 2;
  LintelMeasures now;
  now.deflection = 0.5 * (lintel.sag(s, left) + lintel.sag(s, right)) -
                   0.5 * (lintel.sag(s, 0) + lintel.sag(s, last));
  now.end_rotation = lintel.turn(s, last) - lintel.turn(s, 0);
  now.axial = 0.5 * (lintel.axial(s, (last - 1) / 2) + lintel.axial(s, last / 2));
  return now;
}

}  // namespace reading

std::vector<SpaceZoneReading> read_space_zones(const Model& model, const State& state) {
  const SpaceSolids& s = model.space.solids;
  std::vector<SpaceZoneReading> zones;
  for (std::size_t z = 0; z < static_cast<std::size_t>(s.n_zone); ++z) {
    SpaceZoneReading now;
    const HexahedronShape& shape = reading::shape_of(s, z);
    const solids::HexahedronVectors u = reading::displacements(s, state, z);
    now.stress = solids::hexahedron_stress(shape, u);
    now.turned = reading::rotation_of(solids::hexahedron_motion(shape, u).turn);
    now.principal = solids::principal_of(now.stress);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t node = s.corner[8 * z + k];
      const Vec3 moved = reading::moved_of(state, node);
      now.corner[k] = s.node[node] + moved;
      now.middle = now.middle + 0.125 * s.node[node];
      now.moved = now.moved + 0.125 * moved;
    }
    zones.push_back(now);
  }
  return zones;
}

}  // namespace wythe
