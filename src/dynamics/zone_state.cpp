#include "dynamics/zone_state.h"

#include <algorithm>
#include <cmath>

#include "contact/parameters.h"
#include "core/real.h"
#include "solids/zone.h"

namespace wythe {
namespace dynamics {
namespace {

using solids::ZoneVectors;

ZoneVectors<double> displacements(const Solids& m, const State& s, std::size_t zone) {
  ZoneVectors<double> u;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto node = static_cast<std::size_t>(m.corner[k][zone]);
    u.x[k] = s.node_ux[node];
    u.y[k] = s.node_uy[node];
  }
  return u;
}

const ZoneShape& shape_of(const Solids& m, std::size_t zone) {
  return m.shapes[static_cast<std::size_t>(m.zone_shape[zone])];
}

// Kinematics of point k of contact c, as in dynamics/passes/solids.h but in plain steps.
struct EdgeMotion {
  double w, s, x, y;
};
EdgeMotion edge_motion(const Model& model, const State& s, std::size_t c, int k) {
  const Solids& m = model.solids;
  const auto p = static_cast<std::size_t>(m.contact_p[c]),
             q = static_cast<std::size_t>(m.contact_q[c]);
  const double share = k == 0 ? m.share_0[c] : m.share_1[c];
  const double arm_x = k == 0 ? m.arm_0_x[c] : m.arm_1_x[c];
  const double arm_y = k == 0 ? m.arm_0_y[c] : m.arm_1_y[c];
  const double ex = (1 - share) * s.node_ux[p] + share * s.node_ux[q];
  const double ey = (1 - share) * s.node_uy[p] + share * s.node_uy[q];
  double ux = 0, uy = 0, theta = 0;
  if (m.contact_block[c] != model.n_block) {
    const auto a = static_cast<std::size_t>(m.contact_block[c]);
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

double mean_of(const SolidBody& body, const std::vector<double>& values, int column) {
  double sum = 0;
  for (int j = 0; j <= body.rows; ++j)
    sum += values[static_cast<std::size_t>(body.node(column, j))];
  return sum / (body.rows + 1);
}

// Turn of a column of nodes, from its lowest to its highest.
double turn_of(const Solids& m, const SolidBody& body, const State& s, int column) {
  const auto low = static_cast<std::size_t>(body.node(column, 0));
  const auto high = static_cast<std::size_t>(body.node(column, body.rows));
  const double height = m.node_y[high] - m.node_y[low];
  return std::atan2(s.node_ux[low] - s.node_ux[high], height + s.node_uy[high] - s.node_uy[low]);
}

// Axial force in one column of zones, in their own turned axes.
double axial_of(const Solids& m, const SolidBody& body, const State& s, int column) {
  double force = 0;
  for (int j = 0; j < body.rows; ++j) {
    const auto z = static_cast<std::size_t>(body.zone(column, j));
    const ZoneShape& shape = shape_of(m, z);
    const auto stress =
        solids::zone_stress(shape, solids::zone_motion(shape, displacements(m, s, z)).d);
    force += stress.x * shape.thickness * (body.y1 - body.y0) / body.rows;
  }
  return force;
}

}  // namespace

double strain_energy(const Model& model, const State& s) {
  double energy = 0;
  for (std::size_t z = 0; z < model.solids.zone_shape.size(); ++z)
    energy += solids::zone_energy(shape_of(model.solids, z), displacements(model.solids, s, z));
  return energy;
}

std::vector<PointStress> contact_stresses(const Model& m, const State& s) {
  std::vector<PointStress> points;
  const auto first = static_cast<std::size_t>(m.n_point());
  for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(m.solids.n_contact); ++i) {
    const std::size_t c = i / 2, p = first + i;
    const EdgeMotion at = edge_motion(m, s, c, static_cast<int>(i % 2));
    contact::History<double> h{s.kappa[p], s.crush[p],        s.plastic_slip[p],
                               s.slip[p],  s.shear_damage[p], s.tension_set[p]};
    const JointMaterial& material =
        m.materials[static_cast<std::size_t>(m.solids.contact_material[c])];
    const contact::LawConstants<double> law = contact::constants_of(material);
    const contact::Answer<double> now = contact::with_variant(law.choice, [&](auto variant) {
      return contact::update<decltype(variant)>(law, at.w, at.s, h);
    });
    points.push_back({at.w, at.s, now.sigma, now.tau, now.tension_damage, h.shear_damage,
                      now.damage, std::min(1.0, h.crush * law.inv_p_full), at.x, at.y});
  }
  return points;
}

std::pair<double, double> principal_stresses(const ZoneStress& zone) {
  const double middle = 0.5 * (zone.sigma_x + zone.sigma_y);
  const double radius = std::hypot(0.5 * (zone.sigma_x - zone.sigma_y), zone.tau);
  return {middle + radius, middle - radius};
}

std::vector<BeyondLimit> beyond_limits(const Model& model, const State& state) {
  std::vector<BeyondLimit> found;
  const auto has_limit = [](const SolidBody& body) {
    return std::isfinite(body.tension_limit) || std::isfinite(body.compression_limit);
  };
  const auto& bodies = model.solids.bodies;
  if (std::none_of(bodies.begin(), bodies.end(), has_limit)) return found;
  const std::vector<ZoneStress> zones = zone_stresses(model, state);
  for (const SolidBody& body : bodies)
    for (int z = body.first_zone; z < body.first_zone + body.n_zone; ++z) {
      const ZoneStress& zone = zones[static_cast<std::size_t>(z)];
      const auto [greatest, least] = principal_stresses(zone);
      const double x = 0.25 * (zone.x[0] + zone.x[1] + zone.x[2] + zone.x[3]);
      const double y = 0.25 * (zone.y[0] + zone.y[1] + zone.y[2] + zone.y[3]);
      if (greatest > body.tension_limit)
        found.push_back({&body, true, greatest, body.tension_limit, x, y});
      if (-least > body.compression_limit)
        found.push_back({&body, false, -least, body.compression_limit, x, y});
    }
  return found;
}

const SolidBody* first_lintel(const Model& model) {
  for (const SolidBody& body : model.solids.bodies)
    if (body.role == BlockRole::kLintel) return &body;
  return nullptr;
}

LintelMeasures lintel_measures(const Model& model, const State& s) {
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

}  // namespace dynamics

std::vector<ZoneStress> zone_stresses(const Model& model, const State& s) {
  const Solids& m = model.solids;
  std::vector<ZoneStress> zones;
  for (std::size_t z = 0; z < m.zone_shape.size(); ++z) {
    const ZoneShape& shape = dynamics::shape_of(m, z);
    const auto motion = solids::zone_motion(shape, dynamics::displacements(m, s, z));
    const auto stress = solids::zone_stress(shape, motion.d);
    const double c = motion.cos, n = motion.sin;
    ZoneStress now;
    now.sigma_x = c * c * stress.x + n * n * stress.y - 2 * c * n * stress.xy;
    now.sigma_y = n * n * stress.x + c * c * stress.y + 2 * c * n * stress.xy;
    now.tau = c * n * (stress.x - stress.y) + (c * c - n * n) * stress.xy;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto node = static_cast<std::size_t>(m.corner[k][z]);
      now.x[k] = m.node_x[node] + s.node_ux[node];
      now.y[k] = m.node_y[node] + s.node_uy[node];
    }
    zones.push_back(now);
  }
  return zones;
}

}  // namespace wythe
