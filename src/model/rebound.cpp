// Drops the wall flat at 1 m/s and steps the vertical motion of its blocks on springs and dashpots of their beds.
// Beds act in compression only, and weight is left out. The fall ends when the ground has carried nothing for as long as a
// shock needs up and down. The result is the final momentum over the mass. See docs/theory/dynamics.md, "The step".
#include "model/rebound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "model/geometry.h"

namespace wythe {
namespace {

struct Bed {
  int low, high;  // blocks; low = -1: the ground
  double k, c;    // [N/m], [N s/m]
};

// Whether a joint is nearly level.
bool is_flat(const Model& m, JointId j) {
  constexpr double kFlat = 0.9;
  return std::fabs(geometry_of(m).normal(m, j).y) > kFlat;
}

std::vector<Bed> beds_of(const Model& m, const Dashpots& d) {
  std::vector<Bed> beds;
  for (int j = 0; j < m.n_joint; ++j) {
    if (!is_flat(m, j)) continue;
    const double area = m.area[j];
    const double k = m.materials[m.joint_material[j]].normal_stiffness * area;
    int low = j < m.n_pair ? m.joint_a[j] : -1, high = m.joint_b[j];
    if (low >= 0 && m.centroid_y[low] > m.centroid_y[high]) std::swap(low, high);
    beds.push_back({low, high, k, d.normal[j] * area});
  }
  return beds;
}

// Least number of beds between each block and the ground; -1: there is no path.
std::vector<int> levels_of(int blocks, const std::vector<Bed>& beds) {
  std::vector<std::vector<int>> next(blocks);
  std::vector<int> level(blocks, -1);
  std::queue<int> open;
  for (const Bed& bed : beds) {
    if (bed.low >= 0) {
      next[bed.low].push_back(bed.high);
      next[bed.high].push_back(bed.low);
    } else if (level[bed.high] < 0) {
      level[bed.high] = 1;
      open.push(bed.high);
    }
  }
  for (; !open.empty(); open.pop())
    for (const int other : next[open.front()])
      if (level[other] < 0) {
        level[other] = level[open.front()] + 1;
        open.push(other);
      }
  return level;
}

}  // namespace

std::optional<double> rebound_of_wall(const Model& m, const Dashpots& d) {
  constexpr double kNearlyAll = 0.95;  // of the mass that beds carry
  constexpr int kMostBlocks = 3000, kMostSteps = 40000;
  if (d.normal.empty() || m.n_block < 2 || m.n_block > kMostBlocks ||
      m.solids.n_zone + m.space.solids.n_zone > 0)
    return std::nullopt;
  const std::vector<Bed> beds = beds_of(m, d);
  const std::vector<int> level = levels_of(m.n_block, beds);
  double all = 0, held = 0;
  for (int i = 0; i < m.n_block; ++i) {
    all += m.mass[i];
    if (level[i] > 0) held += m.mass[i];
  }
  const int levels = *std::max_element(level.begin(), level.end());
  if (levels < 2 || held < kNearlyAll * all) return std::nullopt;

  // stable, and fine enough that the first step of an impact has no influence
  std::vector<double> stiff(m.n_block), viscous(static_cast<std::size_t>(m.n_block));
  double slowest = std::numeric_limits<double>::infinity(), dt = slowest;
  for (const Bed& bed : beds)
    for (const int block : {bed.low, bed.high}) {
      if (block < 0) continue;
      stiff[block] += 2 * bed.k, viscous[block] += 2 * bed.c;
    }
  for (int i = 0; i < m.n_block; ++i) {
    if (level[i] <= 0) continue;
    const double omega = std::sqrt(stiff[i] / m.mass[i]);
    const double xi = 0.5 * viscous[i] / (m.mass[i] * omega);
    slowest = std::min(slowest, omega);
    dt = std::min(dt, 0.1 * 2 / omega * (std::sqrt(1 + xi * xi) - xi));
  }
  const double over = 2 * M_PI * levels / slowest;  // time of a shock up and down

  std::vector<double> y(m.n_block, 0.0), v(static_cast<std::size_t>(m.n_block), -1.0),
      force(static_cast<std::size_t>(m.n_block));
  bool touched = false;
  double apart = 0;
  for (int step = 0; step < kMostSteps && apart < over; ++step) {
    std::fill(force.begin(), force.end(), 0.0);
    bool presses = false;
    for (const Bed& bed : beds) {
      if (level[bed.high] <= 0) continue;
      const double gap = y[bed.high] - (bed.low < 0 ? 0 : y[bed.low]);
      if (!(gap < 0)) continue;
      const double rate = v[bed.high] - (bed.low < 0 ? 0 : v[bed.low]);
      const double f = std::fmax(0, -bed.k * gap - bed.c * rate);
      force[bed.high] += f;
      if (bed.low >= 0) force[bed.low] -= f;
      presses = presses || (bed.low < 0 && f > 0);
    }
    for (int i = 0; i < m.n_block; ++i) {
      if (level[i] <= 0) continue;
      v[i] += dt * force[i] / m.mass[i];
      y[i] += dt * v[i];
    }
    touched = touched || presses;
    apart = touched && !presses ? apart + dt : 0;
  }
  if (apart < over) return std::nullopt;
  double momentum = 0;
  for (int i = 0; i < m.n_block; ++i)
    if (level[i] > 0) momentum += m.mass[i] * v[i];
  return momentum / held;
}

}  // namespace wythe
