// The longest stable step in space: omega^2 <= 2 max lambda(M^-1 K_own). K_own is the 6 x 6 stiffness of a block's
// joints (once on a support), since (x - y) k (x - y) <= 2 x k x + 2 y k y (docs/theory/space.md).
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/free_shapes.h"
#include "model/shaking.h"
#include "model/space/space.h"
#include "model/space/space_roles.h"
#include "model/space/space_solids.h"

namespace wythe {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 row(Vec3 direction, Vec3 arm) {
  const Vec3 turn = cross(arm, direction);
  Vector6 r;
  r << direction.x, direction.y, direction.z, turn.x, turn.y, turn.z;
  return r;
}

// Stress per displacement, or per velocity, normal to a joint and along it.
struct Springs {
  double normal, shear;
};

// Stiffness of joint j for a block with `arm` from its centroid to the face.
Matrix6 own_stiffness(const Model& m, std::size_t j, const Springs& springs, Vec3 arm) {
  const Space& s = m.space;
  const Vec3 t1 = s.tangent[j], n = s.normal[j], t2 = cross(n, t1);
  Matrix6 sum = Matrix6::Zero();
  for (std::size_t p = s.point_begin[j]; p < static_cast<std::size_t>(s.point_begin[j + 1]); ++p) {
    const Vec3 to = arm + s.point_r1[p] * t1 + s.point_r2[p] * t2;
    const double area = m.area[j] * s.point_share[p];
    const auto spring = [&](Vec3 direction, double stiffness) {
      const Vector6 r = row(direction, to);
      sum += area * stiffness * r * r.transpose();
    };
    spring(n, springs.normal);
    spring(t1, springs.shear);
    spring(t2, springs.shear);
  }
  return sum;
}

// Stiffness of possible free contacts for a block: on all facets without a joint, with the
// stiffest material of its joints. Zero without free contacts.
Matrix6 free_stiffness(const Model& m, const contact::SpaceParts& parts, std::size_t i) {
  Matrix6 sum = Matrix6::Zero();
  const JointMaterial& own = m.materials[m.free.material[i]];
  double kn = own.normal_stiffness, ks = own.shear_stiffness;
  const auto each_joint = [&](const auto& visit) {
    for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e)
      visit(static_cast<std::size_t>(m.block_entry[e] >> 1), (m.block_entry[e] & 1) != 0);
  };
  each_joint([&](std::size_t j, bool) {
    const JointMaterial& other = m.materials[m.joint_material[j]];
    kn = std::fmax(kn, other.normal_stiffness);
    ks = std::fmax(ks, other.shear_stiffness);
  });
  const auto vec3 = [](const contact::Vec& v) { return Vec3{v.x, v.y, v.z}; };
  for (auto part = m.free.part_begin[i]; part < m.free.part_begin[i + 1]; ++part)
    for (const contact::Facet& facet : parts.facets_of(part)) {
      const Vec3 x = vec3(facet.x), y = vec3(facet.y), z = vec3(facet.z);
      double area = 0, covered = 0;
      Matrix6 all = Matrix6::Zero();
      // exact for triangles: a third of each at the middle of each side
      for (auto c = facet.begin + 1; c + 1 < facet.end; ++c) {
        const Vec3 corner[3] = {vec3(parts.corner[facet.begin]), vec3(parts.corner[c]),
                                vec3(parts.corner[c + 1])};
        const double of = 0.5 * length(cross(corner[1] - corner[0], corner[2] - corner[0]));
        area += of;
        for (int k = 0; k < 3; ++k) {
          const Vec3 middle = 0.5 * (corner[k] + corner[(k + 1) % 3]);
          for (const auto& [direction, stiffness] : {std::pair(z, kn), {x, ks}, {y, ks}}) {
            const Vector6 r = row(direction, middle);
            all += of / 3 * stiffness * r * r.transpose();
          }
        }
      }
      each_joint([&](std::size_t j, bool is_b) {
        const Vec3 arm = is_b ? m.space.arm_b[j] : m.space.arm_a[j];
        const bool parallel = std::fabs(dot(m.space.normal[j], z)) > 0.999;
        const double off = dot(arm - vec3(facet.origin), z);
        if (parallel && std::fabs(off) < 0.05 * std::sqrt(area)) covered += m.area[j];
      });
      sum += std::fmax(0.0, 1 - covered / area) * all;
    }
  return 2 * sum;
}

// Force and moment of unit tension in link k at one of its ends.
Vector6 link_row(const Model& m, std::size_t k, bool is_b) {
  const Links& l = m.links;
  const Vec3 span{l.span_x[k], l.span_y[k], l.span_z[k]};
  const Vec3 arm = is_b ? Vec3{l.arm_b_x[k], l.arm_b_y[k], l.arm_b_z[k]}
                        : Vec3{l.arm_a_x[k], l.arm_a_y[k], l.arm_a_z[k]};
  return row(geometry::unit(span), arm);
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

// The block's principal axes as columns, each divided by the root of its inertia: M^(-1/2).
Matrix6 to_unit_mass(const Model& m, std::size_t i) {
  const Space& s = m.space;
  Matrix6 turn = Matrix6::Zero();
  const Vec3 axes[3] = {s.axis_1[i], s.axis_2[i], s.axis_3[i]};
  const double inertia[3] = {s.inertia[i].x, s.inertia[i].y, s.inertia[i].z};
  for (int a = 0; a < 3; ++a) {
    turn(a, a) = 1 / std::sqrt(m.mass[i]);
    const double scale = 1 / std::sqrt(inertia[a]);
    turn(3, 3 + a) = scale * axes[a].x;
    turn(4, 3 + a) = scale * axes[a].y;
    turn(5, 3 + a) = scale * axes[a].z;
  }
  return turn;
}

// Largest eigenvalue of `k` plus the stiffness from springs_at(joint) for block i, over its inertia.
template <class SpringsAt>
double highest_eigenvalue(const Model& m, std::size_t i, Matrix6 k, const SpringsAt& springs_at) {
  const Space& s = m.space;
  for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e) {
    const auto entry = m.block_entry[e];
    const std::size_t j = entry >> 1;
    const double share = static_cast<int>(j) < m.n_pair ? 2.0 : 1.0;
    k += share * own_stiffness(m, j, springs_at(j), (entry & 1) != 0 ? s.arm_b[j] : s.arm_a[j]);
  }
  const Matrix6 turn = to_unit_mass(m, i);
  const Matrix6 scaled = turn.transpose() * k * turn;
  return Eigen::SelfAdjointEigenSolver<Matrix6>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

double own_bound(const Model& m, std::size_t i, const Matrix6& links) {
  return highest_eigenvalue(m, i, links, [&](std::size_t j) {
    const JointMaterial& law = m.materials[m.joint_material[j]];
    return Springs{law.normal_stiffness, law.shear_stiffness};
  });
}

// Raises the inertia of lintel segments that would determine the time step, until their bound is that of masonry. Weights
// stay, and a note gives the added mass (docs/decisions/0009).
void raise_light_inertia(Model& m, std::vector<double>& bound) {
  constexpr double kMuch = 0.03;
  const auto is_segment = [&](std::size_t i) {
    return m.anatomy.block_role[i] == BlockRole::kFrame || !chain_of(m.anatomy.block_id[i]).empty();
  };
  double masonry = 0, all = 0, added = 0, raised = 0;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    all += m.mass[i];
    if (!is_segment(i)) masonry = std::fmax(masonry, bound[i]);
  }
  for (std::size_t i = 0; i < bound.size() && masonry > 0; ++i) {
    if (!is_segment(i) || !(bound[i] > masonry)) continue;
    const double factor = bound[i] / masonry;
    added += (factor - 1) * m.mass[i];
    m.mass[i] *= factor;
    m.space.inertia[i] = factor * m.space.inertia[i];
    bound[i] = masonry;
    ++raised;
  }
  if (raised > 0)
    m.anatomy.notes.push_back({added / all > kMuch ? "inertia.blocks_drag"
                               : raised == 1       ? "inertia.block_raised"
                                                   : "inertia.blocks_raised",
                               {{"blocks", raised}, {"of_wall_percent", 100 * added / all}}});
}

// Adds to `sum` of each block the stiffness of frame sections: once on the ground, twice otherwise.
void add_frames(const Model& m, std::vector<Matrix6>& sum) {
  const Frames& f = m.frames;
  for (std::size_t k = 0; k < f.a.size(); ++k) {
    const Vec3 axis{f.axis_x[k], f.axis_y[k], f.axis_z[k]}, left = f.left[k];
    const Vec3 across = cross(axis, left);
    const auto add = [&](BlockId block, double share, Vec3 arm) {
      Matrix6& of = sum[block];
      const auto spring = [&](Vec3 direction, double stiffness) {
        const Vector6 r = row(direction, arm);
        of += share * stiffness * r * r.transpose();
      };
      spring(axis, 2 * f.outer_stiffness[k] + f.middle_stiffness[k]);
      spring(left, f.shear_stiffness[k]);
      spring(across, f.aside_stiffness[k]);
      for (const auto& [about, stiffness] :
           {std::pair(across, 2 * f.outer_stiffness[k] * f.fibre[k] * f.fibre[k]),
            {left, f.lean_stiffness[k]},
            {axis, f.twist_stiffness[k]}}) {
        Vector6 r = Vector6::Zero();
        r[3] = about.x, r[4] = about.y, r[5] = about.z;
        of += share * stiffness * r * r.transpose();
      }
    };
    const bool on_ground = f.a[k] == kGroundBlock;
    if (!on_ground) add(f.a[k], 2, {f.arm_a_x[k], f.arm_a_y[k], f.arm_a_z[k]});
    add(f.b[k], on_ground ? 1 : 2, {f.arm_b_x[k], f.arm_b_y[k], f.arm_b_z[k]});
  }
}

// Adds to `sum` of each block twice the stiffness of zone contacts.
void add_contacts(const Model& m, std::vector<Matrix6>& sum) {
  const SpaceSolids& s = m.space.solids;
  for (std::size_t c = 0; c < static_cast<std::size_t>(s.n_contact); ++c) {
    if (s.contact_block[c] >= m.n_block) continue;
    const JointMaterial& law = m.materials[s.contact_material[c]];
    const Vec3 t1 = s.contact_tangent[c], n = s.contact_normal[c], t2 = cross(n, t1);
    for (std::size_t p = s.point_begin[c]; p < static_cast<std::size_t>(s.point_begin[c + 1]);
         ++p) {
      const Vec3 to = s.contact_arm[c] + m.space.point_r1[p] * t1 + m.space.point_r2[p] * t2;
      const double area = 2 * s.contact_area[c] * m.space.point_share[p];
      for (const auto& [direction, stiffness] : {std::pair(n, law.normal_stiffness),
                                                 {t1, law.shear_stiffness},
                                                 {t2, law.shear_stiffness}}) {
        const Vector6 r = row(direction, to);
        sum[s.contact_block[c]] += area * stiffness * r * r.transpose();
      }
    }
  }
}

constexpr double kMostRaised =
    0.03;  // of the wall's mass: most that nodes gain; more would drag on a push

// The bound to which nodes are raised: `least`, that of rigid blocks, or a larger one with which they gain no more than
// kMostRaised of the wall's mass. The gain decreases as the bound grows.
double bound_to_raise_to(const Model& m, double least, const std::vector<double>& bound) {
  const SpaceSolids& s = m.space.solids;
  const double wall = std::accumulate(m.mass.begin(), m.mass.end(), 0.0) +
                      std::accumulate(s.node_mass.begin(), s.node_mass.end(), 0.0);
  const auto drags = [&](double limit) {
    double added = 0;
    for (std::size_t i = 0; i < bound.size(); ++i)
      added += std::fmax(0, bound[i] / limit - 1) * s.node_mass[i];
    return added > kMostRaised * wall;
  };
  if (!drags(least)) return least;
  double low = least, high = *std::max_element(bound.begin(), bound.end());
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (drags(middle) ? low : high) = middle;
  }
  return high;
}

// As in the plane (step_bound.cpp): nodes that would determine the step against the bound `rigid` of rigid blocks gain
// inertia but no weight, up to kMostRaised; beyond that the step becomes shorter. A note names each body and its gain.
void raise_light_nodes(Model& m, double rigid, std::vector<double>& bound) {
  const double limit = bound_to_raise_to(m, rigid, bound);
  SpaceSolids& s = m.space.solids;
  const double blocks = std::accumulate(m.mass.begin(), m.mass.end(), 0.0);
  for (const SpaceSolidBody& body : s.bodies) {
    double before = 0, added = 0, worst = 1;
    std::size_t at_node = 0;
    for (int k = body.first_node; k < body.first_node + body.n_node; ++k) {
      const std::size_t i = k;
      before += s.node_mass[i];
      if (!(bound[i] > limit)) continue;
      const double factor = bound[i] / limit;
      if (factor > worst) at_node = i;
      worst = std::fmax(worst, factor);
      added += (factor - 1) * s.node_mass[i];
      s.node_mass[i] *= factor;
      bound[i] = limit;
    }
    if (added <= 0) continue;
    const double of_wall = added / (blocks + before);
    Message note{limit > rigid ? "inertia.nodes_shared" : "inertia.nodes_raised",
                 {{"block", body.body.id},
                  {"of_block_percent", 100 * added / before},
                  {"of_wall_percent", 100 * of_wall},
                  {"times", worst},
                  {"x_m", s.node[at_node].x},
                  {"y_m", s.node[at_node].y}}};
    if (limit > rigid) note.arguments.emplace_back("shorter", std::sqrt(limit / rigid));
    m.anatomy.notes.push_back(std::move(note));
  }
}

// Adds the nodes of zones to the bound of the step; `blocks` is that of rigid blocks.
double bound_nodes(Model& m, double blocks) {
  std::vector<double> bound = space_node_bounds(m);
  if (bound.empty()) return blocks;
  const bool raises = m.solve.raise_light_inertia && blocks > 0;
  if (raises) raise_light_nodes(m, blocks, bound);
  const auto greatest = std::max_element(bound.begin(), bound.end());
  if (!(*greatest > blocks)) return blocks;
  const auto node = static_cast<int>(greatest - bound.begin());
  const SpaceSolids& s = m.space.solids;
  const auto body = std::find_if(s.bodies.begin(), s.bodies.end(), [&](const SpaceSolidBody& one) {
    return node < one.first_node + one.n_node;
  });
  if (blocks > 0 && !raises)
    m.anatomy.notes.push_back({"step.ruled_by_node",
                               {{"block", body->body.id},
                                {"x_m", s.node[node].x},
                                {"y_m", s.node[node].y},
                                {"times", std::sqrt(*greatest / blocks)}}});
  return *greatest;
}

// Stiffness of rigid diaphragms, which state none: they raise the squared frequency of their ends by a tenth of
// the wall's, and no more (docs/theory/links.md, 9.5).
void set_rigid_links(Model& m, double bound) {
  constexpr double kShare = 0.1;
  std::vector<double> least(m.links.a.size(), 1e300);
  each_link_end(m, [&](std::size_t k, std::size_t i, const Vector6& row) {
    const double mobility = (to_unit_mass(m, i).transpose() * row).squaredNorm();
    least[k] = std::fmin(least[k], kShare * bound / (2 * mobility));
  });
  for (std::size_t k = 0; k < least.size(); ++k)
    if (std::isnan(m.links.stiffness[k])) {
      m.links.stiffness[k] = least[k];
      if (m.links.kind[k] > LinkKind::kSpring) continue;  // noted with its frame
      m.anatomy.notes.push_back(
          {"link.rigid", {{"link", m.links.name[k]}, {"stiffness_kN_per_mm", 1e-6 * least[k]}}});
    }
}

// Adds links to the bounds of their blocks; a note where one of them determines the step.
double bound_links(Model& m, const std::vector<Matrix6>& free, double before) {
  set_rigid_links(m, before);
  std::vector<Matrix6> sum = free;
  each_link_end(m, [&](std::size_t k, std::size_t i, const Vector6& row) {
    const double share = m.links.a[k] == kGroundBlock ? 1.0 : 2.0;
    sum[i] += share * m.links.stiffness[k] * row * row.transpose();
  });
  std::size_t worst = 0;
  double most = before;
  each_link_end(m, [&](std::size_t k, std::size_t i, const Vector6&) {
    const double bound = own_bound(m, i, sum[i]);
    if (bound > most) most = bound, worst = k, m.stiffest_block = static_cast<BlockId>(i);
  });
  constexpr double kMuchShorter = 1.1;
  if (const double times = std::sqrt(most / before); times > kMuchShorter)
    m.anatomy.notes.push_back(
        {"step.ruled_by_link", {{"link", m.links.name[worst]}, {"times", times}}});
  return most;
}

}  // namespace

double dashpot_rate_in_space(const Model& m, const Dashpots& dashpots) {
  double most = 0;
  for (int i = 0; i < m.n_block; ++i)
    most = std::fmax(most, highest_eigenvalue(
                               m, static_cast<std::size_t>(i), Matrix6::Zero(), [&](std::size_t j) {
                                 return Springs{dashpots.normal[j], dashpots.shear[j]};
                               }));
  return most;
}

void bound_space_step(Model& m) {
  std::vector<double> bound;
  std::vector<Matrix6> free(m.n_block, Matrix6::Zero());
  if (m.free.any()) {
    const contact::SpaceParts parts = free_parts(m);
    for (int i = 0; i < m.n_block; ++i)
      free[i] = free_stiffness(m, parts, static_cast<std::size_t>(i));
  }
  add_contacts(m, free);
  if (m.frames.n > 0) add_frames(m, free);
  for (int i = 0; i < m.n_block; ++i)
    bound.push_back(own_bound(m, static_cast<std::size_t>(i), free[i]));
  if (m.solve.raise_light_inertia) raise_light_inertia(m, bound);
  double most = 0;
  for (int i = 0; i < m.n_block; ++i)
    if (bound[i] > most) most = bound[i], m.stiffest_block = i;
  if (m.links.n > 0) most = bound_links(m, free, most);
  m.omega_max = std::sqrt(bound_nodes(m, most));
}

}  // namespace wythe
