// Reads zones of a plane wall: energy (8.3), stresses in the axes of the wall, exceeded limits, measures of a lintel.
// Stress is linear in the rotated frame of a zone and is rotated back. Where a lintel has no node line or no column
// of zones in its middle, both beside it count by half. See docs/theory/zones.md, "Measures of a lintel".
#include "reading/zones.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "reading/readers.h"
#include "reading/zones_in_space.h"
#include "solids/zone.h"
#include "wythe/parts/curve.h"

namespace wythe {
namespace reading {
namespace {

using solids::ZoneVectors;

ZoneVectors<double> displacements(const Solids& m, const State& s, std::size_t zone) {
  ZoneVectors<double> u;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t node = m.corner[k][zone];
    u.x[k] = s.node_ux[node];
    u.y[k] = s.node_uy[node];
  }
  return u;
}

const ZoneShape& shape_of(const Solids& m, std::size_t zone) {
  return m.shapes[m.zone_shape[zone]];
}

double mean_of(const SolidBody& body, const std::vector<double>& values, int column) {
  double sum = 0;
  for (int j = 0; j <= body.rows; ++j) sum += values[body.node(column, j)];
  return sum / (body.rows + 1);
}

// Rotation of a column of nodes, from the lowest to the highest.
double turn_of(const Solids& m, const SolidBody& body, const State& s, int column) {
  const std::size_t low = body.node(column, 0);
  const std::size_t high = body.node(column, body.rows);
  const double height = m.node_y[high] - m.node_y[low];
  return elementary::atan2(s.node_ux[low] - s.node_ux[high],
                           height + s.node_uy[high] - s.node_uy[low]);
}

// Axial force in one column of zones, in their own rotated axes.
double axial_of(const Solids& m, const SolidBody& body, const State& s, int column) {
  double force = 0;
  for (int j = 0; j < body.rows; ++j) {
    const std::size_t z = body.zone(column, j);
    const ZoneShape& shape = shape_of(m, z);
    const auto stress =
        solids::zone_stress(shape, solids::zone_motion(shape, displacements(m, s, z)).d);
    force += stress.x * shape.thickness * (body.y1 - body.y0) / body.rows;
  }
  return force;
}

}  // namespace

double strain_energy(const Model& model, const State& s) {
  double energy = strain_energy_in_space(model, s);
  for (std::size_t z = 0; z < model.solids.zone_shape.size(); ++z)
    energy += solids::zone_energy(shape_of(model.solids, z), displacements(model.solids, s, z));
  return energy;
}

std::vector<BeyondLimit> beyond_limits(const Model& model, const State& state) {
  return readers_of(model).beyond_limits(model, state);
}

std::vector<BeyondLimit> beyond_limits_in_plane(const Model& model, const State& state) {
  std::vector<BeyondLimit> found;
  const auto has_limit = [](const SolidBody& body) {
    return std::isfinite(body.tension_limit) || std::isfinite(body.compression_limit);
  };
  const auto& bodies = model.solids.bodies;
  if (std::none_of(bodies.begin(), bodies.end(), has_limit)) return found;
  const std::vector<ZoneReading> zones = read_zones(model, state);
  for (const SolidBody& body : bodies)
    for (int z = body.first_zone; z < body.first_zone + body.n_zone; ++z) {
      const ZoneReading& zone = zones[z];
      const auto [greatest, least] = principal_stresses(zone);
      const auto& at = zone.corner;
      const Vec3 middle = 0.25 * (at[0] + at[1] + at[2] + at[3]);
      if (greatest > body.tension_limit)
        found.push_back({&body.id, true, greatest, body.tension_limit, middle});
      if (-least > body.compression_limit)
        found.push_back({&body.id, false, -least, body.compression_limit, middle});
    }
  return found;
}

const SolidBody* first_lintel(const Model& model) {
  for (const SolidBody& body : model.solids.bodies)
    if (body.role == BlockRole::kLintel) return &body;
  return nullptr;
}

LintelMeasures lintel_measures(const Model& model, const State& state) {
  return readers_of(model).lintel(model, state);
}

LintelMeasures lintel_measures_in_plane(const Model& model, const State& s) {
  const SolidBody* body = first_lintel(model);
  if (body == nullptr) return {};
  const Solids& m = model.solids;
  const int last = body->columns, left = last / 2, right = (last + 1) / 2;
  const auto sag = [&](int column) { return -mean_of(*body, s.node_uy, column); };
  LintelMeasures now;
  now.deflection = 0.5 * (sag(left) + sag(right)) - 0.5 * (sag(0) + sag(last));
  now.end_rotation = turn_of(m, *body, s, last) - turn_of(m, *body, s, 0);
  // an even number of columns has a node line in the middle, with a column on each side
  const int before = (last - 1) / 2, after = last / 2;
  now.axial = 0.5 * (axial_of(m, *body, s, before) + axial_of(m, *body, s, after));
  return now;
}

}  // namespace reading

ShownColumns columns_of(const Model& model) {
  ShownColumns of{.lintel_of_zones = reading::first_lintel(model) != nullptr ||
                                     reading::first_lintel_in_space(model) != nullptr};
  for (const Stage& stage : model.stages)  // the curve belongs to the last push
    if (const PushStage* push = stage.push())
      of.held_head = push->fixity.across == Freedom::kBlocked && dimension_of(model) == 2;
  return of;
}

std::vector<ZoneReading> read_zones(const Model& model, const State& s) {
  const Solids& m = model.solids;
  std::vector<ZoneReading> zones;
  for (std::size_t z = 0; z < m.zone_shape.size(); ++z) {
    const ZoneShape& shape = reading::shape_of(m, z);
    const auto motion = solids::zone_motion(shape, reading::displacements(m, s, z));
    const auto stress = solids::zone_stress(shape, motion.d);
    const double c = motion.cos, n = motion.sin;
    ZoneReading now;
    now.sigma_x = c * c * stress.x + n * n * stress.y - 2 * c * n * stress.xy;
    now.sigma_y = n * n * stress.x + c * c * stress.y + 2 * c * n * stress.xy;
    now.tau = c * n * (stress.x - stress.y) + (c * c - n * n) * stress.xy;
    now.corners = m.corner[2][z] == m.corner[3][z] ? 3 : 4;
    for (int k = 0; k < 4; ++k) {
      now.corner[k] = node_now(model, s, m.corner[k][z]);
      if (k < now.corners) now.moved = now.moved + node_moved(s, m.corner[k][z]) / now.corners;
    }
    zones.push_back(now);
  }
  return zones;
}

std::pair<double, double> principal_stresses(const ZoneReading& zone) {
  const double middle = 0.5 * (zone.sigma_x + zone.sigma_y);
  const double radius = elementary::hypot(0.5 * (zone.sigma_x - zone.sigma_y), zone.tau);
  return {middle + radius, middle - radius};
}

}  // namespace wythe
