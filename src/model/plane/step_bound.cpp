// Sums the stiffness that joints, zones, links, frames and layers give each block with all contacts closed.
// The largest eigenvalue over the block's inertia bounds omega^2 (4.4); nodes of zones follow (8.7). The order matters:
// light blocks gain inertia first, then rigid links get their stiffness from the bound, then light nodes gain inertia.
#include "model/plane/step_bound.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/elementary.h"
#include "model/shaking.h"

namespace wythe {
namespace {

// Stress per displacement, or per velocity, normal to a joint and along it.
struct Springs {
  double normal, shear;
};
Springs springs_of(const JointMaterial& material) {
  return {material.normal_stiffness, material.shear_stiffness};
}

// Stiffness of one point at (rx, ry) from a block's centroid, in (ux, uy, theta).
Eigen::Matrix3d point_stiffness(const Springs& springs, double area, double tx, double ty,
                                double rx, double ry) {
  const Eigen::Vector3d n(-ty, tx, rx * tx + ry * ty);
  const Eigen::Vector3d t(tx, ty, rx * ty - ry * tx);
  return area * (springs.normal * n * n.transpose() + springs.shear * t * t.transpose());
}

// Stiffness in (ux, uy, theta) that the points of joint j give to a block with `arm` to the face centre.
Eigen::Matrix3d own_stiffness(const Model& m, std::size_t j, const Springs& springs, double arm_x,
                              double arm_y) {
  const double tx = m.tangent_x[j], ty = m.tangent_y[j];
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  for (std::size_t p = 0; p < m.point_xi.size(); ++p) {
    const double rx = arm_x + m.point_xi[p] * m.half_x[j];
    const double ry = arm_y + m.point_xi[p] * m.half_y[j];
    k += point_stiffness(springs, m.area[j] * m.point_weight[p], tx, ty, rx, ry);
  }
  return k;
}

// Stiffness of zone contacts for each rigid block in contact.
std::vector<Eigen::Matrix3d> contact_stiffness(const Model& m) {
  const Solids& s = m.solids;
  std::vector<Eigen::Matrix3d> sum(static_cast<std::size_t>(m.n_block) + 1,
                                   Eigen::Matrix3d::Zero());
  for (std::size_t c = 0; c < s.contact_area.size(); ++c) {
    const Springs material = springs_of(m.materials[s.contact_material[c]]);
    const double tx = s.contact_tangent_x[c], ty = s.contact_tangent_y[c];
    const double half = 0.5 * s.contact_area[c];
    sum[s.contact_block[c]] += point_stiffness(material, half, tx, ty, s.arm_0_x[c], s.arm_0_y[c]) +
                               point_stiffness(material, half, tx, ty, s.arm_1_x[c], s.arm_1_y[c]);
  }
  return sum;
}

// omega^2 at each node: its share of the frequency of each zone, and twice its share of each contact
// (once on the ground).
std::vector<double> node_bounds(const Model& m) {
  const Solids& s = m.solids;
  std::vector<double> stiffness(s.n_node, 0.0);
  for (std::size_t z = 0; z < s.zone_shape.size(); ++z) {
    const ZoneShape& shape = s.shapes[s.zone_shape[z]];
    for (std::size_t k = 0; k < 4; ++k)
      stiffness[s.corner[k][z]] += shape.share[k] * shape.mass * shape.omega_squared;
  }
  for (std::size_t c = 0; c < s.contact_area.size(); ++c) {
    const auto& material = m.materials[s.contact_material[c]];
    const double sides = s.contact_block[c] == m.n_block ? 1.0 : 2.0;
    const double k = sides * 0.5 * s.contact_area[c] *
                     std::max(material.normal_stiffness, material.shear_stiffness);
    const double to_q = s.share_0[c] + s.share_1[c];
    stiffness[s.contact_q[c]] += k * to_q;
    stiffness[s.contact_p[c]] += k * (2 - to_q);
  }
  for (std::size_t i = 0; i < stiffness.size(); ++i) stiffness[i] /= s.node_mass[i];
  return stiffness;
}

// Direction of link `k` at one of its ends, in (ux, uy, theta) of the block there.
Eigen::Vector3d link_row(const Model& m, std::size_t k, bool is_b) {
  const Links& l = m.links;
  const double length = elementary::hypot(l.span_x[k], l.span_y[k]);
  const double x = l.span_x[k] / length, y = l.span_y[k] / length;
  const double rx = is_b ? l.arm_b_x[k] : l.arm_a_x[k], ry = is_b ? l.arm_b_y[k] : l.arm_a_y[k];
  return {x, y, rx * y - ry * x};
}

// visit(link, block, row) for both ends of every link, except ends in the ground.
template <class Visit>
void each_link_end(const Model& m, const Visit& visit) {
  for (std::size_t k = 0; k < m.links.a.size(); ++k) {
    if (m.links.a[k] != kGroundBlock)
      visit(k, static_cast<std::size_t>(m.links.a[k]), link_row(m, k, false));
    visit(k, static_cast<std::size_t>(m.links.b[k]), link_row(m, k, true));
  }
}

// Stiffness of rigid diaphragms, which state none: they raise the squared frequency bound of their ends
// by a tenth of the wall's, and no more.
void set_rigid_links(Model& m, double bound) {
  constexpr double kShare = 0.1;
  std::vector<double> least(m.links.a.size(), std::numeric_limits<double>::infinity());
  each_link_end(m, [&](std::size_t k, std::size_t i, const Eigen::Vector3d& row) {
    const double mobility =
        (row[0] * row[0] + row[1] * row[1]) / m.mass[i] + row[2] * row[2] / m.inertia[i];
    least[k] = std::min(least[k], kShare * bound / (2 * mobility));
  });
  for (std::size_t k = 0; k < least.size(); ++k)
    if (std::isnan(m.links.stiffness[k])) {
      m.links.stiffness[k] = least[k];
      if (m.links.kind[k] > LinkKind::kSpring) continue;  // noted with its frame
      m.anatomy.notes.push_back(
          {"link.rigid", {{"link", m.links.name[k]}, {"stiffness_kN_per_mm", 1e-6 * least[k]}}});
    }
}

// Stiffness of links for each block: once where the other end is the ground, twice otherwise.
std::vector<Eigen::Matrix3d> link_stiffness(const Model& m) {
  std::vector<Eigen::Matrix3d> sum(m.n_block, Eigen::Matrix3d::Zero());
  each_link_end(m, [&](std::size_t k, std::size_t i, const Eigen::Vector3d& row) {
    const double share = m.links.a[k] == kGroundBlock ? 1.0 : 2.0;
    sum[i] += share * m.links.stiffness[k] * row * row.transpose();
  });
  return sum;
}

// Stiffness of frame sections for block i: once where the other side is the ground, twice otherwise.
std::vector<Eigen::Matrix3d> frame_stiffness(const Model& m) {
  const Frames& f = m.frames;
  std::vector<Eigen::Matrix3d> sum(f.n > 0 ? m.n_block : 0, Eigen::Matrix3d::Zero());
  const auto add = [&](BlockId block, double share, std::size_t k, double rx, double ry) {
    const double nx = f.axis_x[k], ny = f.axis_y[k];
    const Eigen::Vector3d along(nx, ny, rx * ny - ry * nx), across(-ny, nx, rx * nx + ry * ny);
    Eigen::Matrix3d& of = sum[block];
    of += share * (2 * f.outer_stiffness[k] + f.middle_stiffness[k]) * along * along.transpose();
    of += share * f.shear_stiffness[k] * across * across.transpose();
    of(2, 2) += share * 2 * f.outer_stiffness[k] * f.fibre[k] * f.fibre[k];
  };
  for (std::size_t k = 0; k < f.a.size(); ++k) {
    const bool on_ground = f.a[k] == kGroundBlock;
    if (!on_ground) add(f.a[k], 2, k, f.arm_a_x[k], f.arm_a_y[k]);
    add(f.b[k], on_ground ? 1 : 2, k, f.arm_b_x[k], f.arm_b_y[k]);
  }
  return sum;
}

// Stiffness of fibres of layers for each block where they cross joints, twice as for links.
std::vector<Eigen::Matrix3d> layer_stiffness(const Model& m) {
  const Layers& l = m.layers;
  std::vector<Eigen::Matrix3d> sum(l.n > 0 ? m.n_block : 0, Eigen::Matrix3d::Zero());
  for (std::size_t k = 0; k < l.a.size(); ++k) {
    if (l.crossing[k] < 0) continue;
    const double length = elementary::hypot(l.span_x[k], l.span_y[k]);
    const double nx = l.span_x[k] / length, ny = l.span_y[k] / length;
    const auto add = [&](BlockId block, double rx, double ry) {
      const Eigen::Vector3d along(nx, ny, rx * ny - ry * nx);
      sum[block] += 2 * l.stiffness[k] * along * along.transpose();
    };
    add(l.a[k], l.arm_a_x[k], l.arm_a_y[k]);
    add(l.b[k], l.arm_b_x[k], l.arm_b_y[k]);
  }
  return sum;
}

// Stiffness of possible free contacts for a block: on all sides without a joint, with the stiffest
// material of its joints. Zero without free contacts.
Eigen::Matrix3d free_stiffness(const Model& m, std::size_t i) {
  Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
  if (!m.free.any()) return k;
  const Anatomy& a = m.anatomy;
  const JointMaterial& own = m.materials[m.free.material[i]];
  JointMaterial law;
  law.normal_stiffness = own.normal_stiffness;
  law.shear_stiffness = own.shear_stiffness;
  const auto joints = [&](const auto& visit) {
    for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
      const auto entry = m.block_entry[e];
      visit(static_cast<std::size_t>(entry >> 1), (entry & 1) != 0);
    }
  };
  joints([&](std::size_t j, bool) {
    if (a.joint_kind[j] == JointKind::kLintelChain) return;
    const auto& other = m.materials[m.joint_material[j]];
    law.normal_stiffness = std::max(law.normal_stiffness, other.normal_stiffness);
    law.shear_stiffness = std::max(law.shear_stiffness, other.shear_stiffness);
  });
  const int from = a.outline_begin[i], to = a.outline_begin[i + 1];
  for (int v = from; v < to; ++v) {
    const auto p = static_cast<std::size_t>(v),
               q = static_cast<std::size_t>(v + 1 == to ? from : v + 1);
    const double ex = a.outline_x[q] - a.outline_x[p], ey = a.outline_y[q] - a.outline_y[p];
    const double length = elementary::hypot(ex, ey), tx = ex / length, ty = ey / length;
    const double px = a.outline_x[p] - m.centroid_x[i], py = a.outline_y[p] - m.centroid_y[i];
    double covered = 0;
    joints([&](std::size_t j, bool is_b) {
      const double rx = (is_b ? m.arm_b_x[j] : m.arm_a_x[j]) - px;
      const double ry = (is_b ? m.arm_b_y[j] : m.arm_a_y[j]) - py;
      const bool parallel = std::fabs(tx * m.tangent_y[j] - ty * m.tangent_x[j]) < 1e-3;
      const double along = tx * rx + ty * ry;
      if (parallel && std::fabs(tx * ry - ty * rx) < 1e-2 * length && along > 0 && along < length)
        covered += 2 * elementary::hypot(m.half_x[j], m.half_y[j]);
    });
    const double area = std::max(0.0, length - covered) * a.block_thickness[i];
    // two Gauss points integrate over a side exactly
    for (const double share : {0.21132486540518712, 0.7886751345948129})
      k += point_stiffness(springs_of(law), 0.5 * area, tx, ty, px + share * ex, py + share * ey);
  }
  return 2 * k;
}

// Largest eigenvalue of `k` plus the stiffness from springs_at(joint) for block i, over its inertia.
template <class SpringsAt>
double highest_eigenvalue(const Model& m, std::size_t i, Eigen::Matrix3d k,
                          const SpringsAt& springs_at) {
  for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
    const auto entry = m.block_entry[e];
    const std::size_t j = entry >> 1;
    const bool is_b = (entry & 1) != 0;
    const double share = static_cast<int>(j) < m.n_pair ? 2.0 : 1.0;
    k += share * own_stiffness(m, j, springs_at(j), is_b ? m.arm_b_x[j] : m.arm_a_x[j],
                               is_b ? m.arm_b_y[j] : m.arm_a_y[j]);
  }
  const double im = 1 / std::sqrt(m.mass[i]), ii = 1 / std::sqrt(m.inertia[i]);
  const Eigen::Vector3d scale(im, im, ii);
  const Eigen::Matrix3d scaled = scale.asDiagonal() * k * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

// Largest eigenvalue of the block's own stiffness over its inertia: omega^2 [1/s^2]. `more` is added to it.
double own_bound(const Model& m, std::size_t i, const Eigen::Matrix3d& zones,
                 const Eigen::Matrix3d& more = Eigen::Matrix3d::Zero()) {
  return highest_eigenvalue(m, i, 2.0 * zones + more + free_stiffness(m, i), [&](std::size_t j) {
    return springs_of(m.materials[m.joint_material[j]]);
  });
}

// Raises the inertia of blocks other than masonry that would determine the time step, until their bound is that
// of masonry; weights stay. Returns the added mass [kg].
double raise_light_inertia(Model& m, std::vector<double>& bound, int& raised) {
  double masonry = 0, added = 0;
  for (std::size_t i = 0; i < bound.size(); ++i)
    if (m.anatomy.block_role[i] == BlockRole::kMasonry) masonry = std::max(masonry, bound[i]);
  for (std::size_t i = 0; i < bound.size() && masonry > 0; ++i) {
    if (!(bound[i] > masonry)) continue;
    const double factor = bound[i] / masonry;
    added += (factor - 1) * m.mass[i];
    m.mass[i] *= factor;
    m.inertia[i] *= factor;
    bound[i] = masonry;
    ++raised;
  }
  return added;
}

// The body a node belongs to.
const SolidBody& body_of(const Solids& s, std::size_t node) {
  std::size_t k = 0;
  while (k + 1 < s.bodies.size() && static_cast<int>(node) >= s.bodies[k + 1].first_node) ++k;
  return s.bodies[k];
}

// Share of the wall's mass above which added inertia increases the drag of a push by more than a percent or two
// (docs/decisions/0009).
constexpr double kMuch = 0.03;

// As raise_light_inertia() for nodes of zones, against the masonry's bound `limit`; a note names each body and its gain.
void raise_light_nodes(Model& m, double limit, std::vector<double>& bound) {
  Solids& s = m.solids;
  for (const SolidBody& body : s.bodies) {
    double before = 0, added = 0, worst = 1;
    std::size_t at = 0;
    for (int k = body.first_node; k < body.first_node + body.n_node; ++k) {
      const std::size_t i = k;
      before += s.node_mass[i];
      if (!(bound[i] > limit)) continue;
      const double factor = bound[i] / limit;
      if (factor > worst) at = i;
      worst = std::max(worst, factor);
      added += (factor - 1) * s.node_mass[i];
      s.node_mass[i] *= factor;
      bound[i] = limit;
    }
    if (added <= 0) continue;
    const double of_wall = added / std::accumulate(m.mass.begin(), m.mass.end(), before);
    m.anatomy.notes.push_back({of_wall > kMuch ? "inertia.nodes_drag" : "inertia.nodes_raised",
                               {{"block", body.id},
                                {"of_block_percent", 100 * added / before},
                                {"of_wall_percent", 100 * of_wall},
                                {"times", worst},
                                {"x_m", s.node_x[at]},
                                {"y_m", s.node_y[at]}}});
  }
}

// Adds links to the bounds of their blocks; a note where one of them determines the step.
void bound_links(Model& m, const std::vector<Eigen::Matrix3d>& zones, std::vector<double>& bound) {
  if (m.links.n == 0) return;
  const double before = *std::max_element(bound.begin(), bound.end());
  set_rigid_links(m, before);
  const std::vector<Eigen::Matrix3d> links = link_stiffness(m);
  std::size_t worst = 0;
  double most = 0;
  each_link_end(m, [&](std::size_t k, std::size_t i, const Eigen::Vector3d&) {
    bound[i] = std::max(bound[i], own_bound(m, i, zones[i], links[i]));
    if (bound[i] > most) most = bound[i], worst = k;
  });
  constexpr double kMuchShorter = 1.1;
  const double times = std::sqrt(most / before);
  if (times > kMuchShorter)
    m.anatomy.notes.push_back(
        {"step.ruled_by_link", {{"link", m.links.name[worst]}, {"times", times}}});
}

// Adds the nodes of zones to the bound of the step.
void bound_nodes(Model& m, double blocks) {
  std::vector<double> bound = node_bounds(m);
  if (bound.empty()) return;
  if (m.solve.raise_light_inertia && blocks > 0) raise_light_nodes(m, blocks, bound);
  const auto greatest = std::max_element(bound.begin(), bound.end());
  if (!(*greatest > blocks)) return;
  m.omega_max = std::sqrt(*greatest);
  if (!(blocks > 0)) return;
  const std::size_t node = greatest - bound.begin();
  m.anatomy.notes.push_back({"step.ruled_by_node",
                             {{"block", body_of(m.solids, node).id},
                              {"x_m", m.solids.node_x[node]},
                              {"y_m", m.solids.node_y[node]},
                              {"times", std::sqrt(*greatest / blocks)}}});
}

}  // namespace

double dashpot_rate(const Model& m, const Dashpots& dashpots) {
  double most = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
    most = std::max(most, highest_eigenvalue(m, i, Eigen::Matrix3d::Zero(), [&](std::size_t j) {
                      return Springs{dashpots.normal[j], dashpots.shear[j]};
                    }));
  return most;
}

void bound_step(Model& m) {
  std::vector<double> bound;
  std::vector<Eigen::Matrix3d> zones = contact_stiffness(m);
  const std::vector<Eigen::Matrix3d> frames = frame_stiffness(m);
  for (std::size_t i = 0; i < frames.size(); ++i) zones[i] += 0.5 * frames[i];  // zones count twice
  const std::vector<Eigen::Matrix3d> layers = layer_stiffness(m);
  for (std::size_t i = 0; i < layers.size(); ++i) zones[i] += 0.5 * layers[i];
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.n_block); ++i)
    bound.push_back(own_bound(m, i, zones[i]));
  if (m.solve.raise_light_inertia) {
    int raised = 0;
    const double added = raise_light_inertia(m, bound, raised);
    const double all = std::accumulate(m.mass.begin(), m.mass.end(), 0.0);
    const double of_wall = added / (all - added);
    if (raised > 0)
      m.anatomy.notes.push_back({of_wall > kMuch ? "inertia.blocks_drag"
                                 : raised == 1   ? "inertia.block_raised"
                                                 : "inertia.blocks_raised",
                                 {{"blocks", raised}, {"of_wall_percent", 100 * of_wall}}});
  }
  if (!bound.empty()) bound_links(m, zones, bound);
  double blocks = 0;
  if (!bound.empty()) {
    const auto greatest = std::max_element(bound.begin(), bound.end());
    m.stiffest_block = static_cast<BlockId>(greatest - bound.begin());
    blocks = *greatest;
  }
  m.omega_max = std::sqrt(blocks);
  bound_nodes(m, blocks);
}

}  // namespace wythe
