// First period of the wall along a direction, for the default smooth start of a push.
//
//   K u = M p    static displacement u of the elastic wall under gravity along p, every contact closed
//   omega^2 = u.K u / u.M u = u.M p / u.M u    Rayleigh quotient: at most a few percent above the first
//                                              mode that moves along p
// K: joints, zones and their contacts as in step_bound.cpp; M: lumped masses and inertias.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

#include "core/elementary.h"
#include "model/parts.h"

namespace wythe {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// One component of the jump of a point, as a row over its degrees of freedom.
struct Row {
  int count = 0;
  int at[7] = {};
  double share[7] = {};
  void add(int freedom, double value) {
    at[count] = freedom;
    share[count++] = value;
  }
};

class Elastic {
 public:
  explicit Elastic(const Model& model) : m_(model), first_node_(3 * model.n_block) {
    joints();
    links();
    frames();
    zones();
    contacts();
    hold();
  }

  [[nodiscard]] double period(double px, double py) const {
    const int n = first_node_ + 2 * m_.solids.n_node;
    Eigen::SparseMatrix<double> stiffness(n, n);
    stiffness.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
    if (solver.info() != Eigen::Success) return kUnset;
    const Eigen::VectorXd mass = masses();
    Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
    for (int i = 0; i < m_.n_block; ++i) {
      force[3 * i] = mass[3 * i] * px;
      force[3 * i + 1] = mass[3 * i + 1] * py;
    }
    for (int k = first_node_; k < n; k += 2) {
      force[k] = mass[k] * px;
      force[k + 1] = mass[k + 1] * py;
    }
    const Eigen::VectorXd u = solver.solve(force);
    const double omega_squared = u.dot(force) / u.dot(mass.cwiseProduct(u));
    return omega_squared > 0 ? 2 * M_PI / std::sqrt(omega_squared) : kUnset;
  }

 private:
  void spring(const Row& row, double stiffness) {
    for (int i = 0; i < row.count; ++i)
      for (int j = 0; j < row.count; ++j)
        entries_.emplace_back(row.at[i], row.at[j], stiffness * row.share[i] * row.share[j]);
  }

  // Adds the motion along (dx, dy) of a point at (rx, ry) from the centroid of a block.
  void add_block(Row& row, int block, double sign, double dx, double dy, double rx, double ry) {
    row.add(3 * block, sign * dx);
    row.add(3 * block + 1, sign * dy);
    row.add(3 * block + 2, sign * (rx * dy - ry * dx));
  }

  void joints() {
    for (std::size_t j = 0; j < m_.area.size(); ++j) {
      const JointMaterial& material = m_.materials[m_.joint_material[j]];
      for (std::size_t p = 0; p < m_.point_xi.size(); ++p) {
        const double ex = m_.point_xi[p] * m_.half_x[j], ey = m_.point_xi[p] * m_.half_y[j];
        const auto along = [&](double dx, double dy, double stiffness) {
          Row row;
          add_block(row, m_.joint_b[j], 1, dx, dy, m_.arm_b_x[j] + ex, m_.arm_b_y[j] + ey);
          if (m_.joint_a[j] != kGroundBlock)
            add_block(row, m_.joint_a[j], -1, dx, dy, m_.arm_a_x[j] + ex, m_.arm_a_y[j] + ey);
          spring(row, stiffness * m_.area[j] * m_.point_weight[p]);
        };
        along(-m_.tangent_y[j], m_.tangent_x[j], material.normal_stiffness);
        along(m_.tangent_x[j], m_.tangent_y[j], material.shear_stiffness);
      }
    }
  }

  void links() {
    const Links& l = m_.links;
    for (std::size_t k = 0; k < l.a.size(); ++k) {
      const double length = elementary::hypot(l.span_x[k], l.span_y[k]);
      const double dx = l.span_x[k] / length, dy = l.span_y[k] / length;
      Row row;
      add_block(row, l.b[k], 1, dx, dy, l.arm_b_x[k], l.arm_b_y[k]);
      if (l.a[k] != kGroundBlock) add_block(row, l.a[k], -1, dx, dy, l.arm_a_x[k], l.arm_a_y[k]);
      spring(row, l.stiffness[k]);
    }
  }

  void frames() {
    const Frames& f = m_.frames;
    for (std::size_t k = 0; k < f.a.size(); ++k) {
      const auto along = [&](double dx, double dy, double stiffness) {
        Row row;
        add_block(row, f.b[k], 1, dx, dy, f.arm_b_x[k], f.arm_b_y[k]);
        if (f.a[k] != kGroundBlock) add_block(row, f.a[k], -1, dx, dy, f.arm_a_x[k], f.arm_a_y[k]);
        spring(row, stiffness);
      };
      along(f.axis_x[k], f.axis_y[k], 2 * f.outer_stiffness[k] + f.middle_stiffness[k]);
      along(-f.axis_y[k], f.axis_x[k], f.shear_stiffness[k]);
      Row turn;
      turn.add(3 * f.b[k] + 2, 1);
      if (f.a[k] != kGroundBlock) turn.add(3 * f.a[k] + 2, -1);
      spring(turn, 2 * f.outer_stiffness[k] * f.fibre[k] * f.fibre[k]);
    }
  }

  void zones() {
    const Solids& s = m_.solids;
    for (std::size_t z = 0; z < s.zone_shape.size(); ++z) {
      const ZoneShape& shape = s.shapes[s.zone_shape[z]];
      for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
          entries_.emplace_back(freedom(s.corner[i / 2][z], i % 2),
                                freedom(s.corner[j / 2][z], j % 2), shape.stiffness[i][j]);
    }
  }

  void contacts() {
    const Solids& s = m_.solids;
    for (std::size_t c = 0; c < s.contact_area.size(); ++c) {
      const auto& material = m_.materials[s.contact_material[c]];
      const double tx = s.contact_tangent_x[c], ty = s.contact_tangent_y[c];
      for (const bool second : {false, true}) {
        const double share = second ? s.share_1[c] : s.share_0[c];
        const double rx = second ? s.arm_1_x[c] : s.arm_0_x[c];
        const double ry = second ? s.arm_1_y[c] : s.arm_0_y[c];
        const auto along = [&](double dx, double dy, double stiffness) {
          Row row;
          for (const auto& [node, part] :
               {std::pair(s.contact_p[c], 1 - share), std::pair(s.contact_q[c], share)}) {
            row.add(freedom(node, 0), part * dx);
            row.add(freedom(node, 1), part * dy);
          }
          if (s.contact_block[c] != m_.n_block)
            add_block(row, s.contact_block[c], -1, dx, dy, rx, ry);
          spring(row, 0.5 * stiffness * s.contact_area[c]);
        };
        along(-ty, tx, material.normal_stiffness);
        along(tx, ty, material.shear_stiffness);
      }
    }
  }

  // Adds a spring at each held motion, which then is a millionth of the others.
  void hold() {
    double stiffest = 0;
    for (const auto& entry : entries_) stiffest = std::fmax(stiffest, entry.value());
    const auto fix = [&](int freedom) { entries_.emplace_back(freedom, freedom, 1e6 * stiffest); };
    for (std::size_t i = 0; i < m_.turn_freedom.size(); ++i)
      if (m_.turn_freedom[i] == 0) fix(3 * static_cast<int>(i) + 2);
    for (std::size_t k = 0; k < m_.solids.node_free_x.size(); ++k) {
      if (m_.solids.node_free_x[k] == 0) fix(freedom(static_cast<int>(k), 0));
      if (m_.solids.node_free_y[k] == 0) fix(freedom(static_cast<int>(k), 1));
    }
  }

  [[nodiscard]] int freedom(int node, std::size_t axis) const {
    return first_node_ + 2 * node + static_cast<int>(axis);
  }

  [[nodiscard]] Eigen::VectorXd masses() const {
    Eigen::VectorXd mass(first_node_ + 2 * m_.solids.n_node);
    for (int i = 0; i < m_.n_block; ++i) {
      mass[3 * i] = mass[3 * i + 1] = m_.mass[i];
      mass[3 * i + 2] = m_.inertia[i];
    }
    for (int k = 0; k < m_.solids.n_node; ++k)
      mass[freedom(k, 0)] = mass[freedom(k, 1)] = m_.solids.node_mass[k];
    return mass;
  }

  const Model& m_;
  int first_node_;
  Triplets entries_;
};

// Duration of a smooth start: after kPeriods the first mode is within 1 % of its static value
// (docs/theory/integration.md, 4.14), but at most kShare of the time to the first turn.
constexpr double kPeriods = 8, kShare = 0.2;
constexpr double kUnknown = 0.05;  // without a period [s]

// Rounds up to two digits, so that no bit of a run depends on the last bits of an eigenvalue.
double rounded_up(double x) {
  const double unit = elementary::pow(10.0, std::floor(elementary::log10(x)) - 1);
  return std::ceil(x / unit * (1 - 1e-9)) * unit;
}

}  // namespace

double first_period(const Model& model, double px, double py) {
  return Elastic(model).period(px, py);
}

void set_push_ramps(Model& model) {
  for (Stage& stage : model.stages) {
    const PushStage* push = stage.push();
    if (push == nullptr || !std::isnan(stage.spec.ramp)) continue;
    const double period = first_period(model, stage.drive_x, stage.drive_y);
    const double first = push->targets.empty() ? push->until : std::fabs(push->targets.front());
    const double most = kShare * first / push->velocity;
    const double wanted = period > 0 ? kPeriods * period : kUnknown;
    stage.spec.ramp = rounded_up(wanted < most || !(most > 0) ? wanted : most);
  }
}

}  // namespace wythe
