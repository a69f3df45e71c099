// Fills the arrays of bare walls from a model and a state, and reads them back; what a step touches.
#include "bare_wall.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/parameters.h"

namespace wythe::bench {
namespace {

constexpr double kNever = 1e300;
// Joints between a block's last one and its motion: its forces have left the store queue by then.
constexpr int kDelay = 16;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

// The history of point p, `lanes` apart.
void put_point(const Model& m, const State& s, JointId joint, std::size_t p, double* hot,
               double* cold, int lanes) {
  const auto c = contact::constants_of(m.materials[at(m.joint_material[at(joint)])]);
  const double kappa = s.kappa[p], crush = s.crush[p], slip = s.slip[p], ds = s.shear_damage[p];
  const double left = std::clamp(1 - (kappa - c.tension_onset) * c.tension_rate, 0.0, 1.0);
  hot[kCrush * lanes] = crush;
  hot[kCrushesBelow * lanes] = -c.fc * std::max(0.0, 1 - crush * c.inv_p_full) * c.inv_kn - crush;
  hot[kLeft * lanes] = left * (1 - ds);
  hot[kPlastic * lanes] = s.plastic_slip[p];
  hot[kDamagedFrom * lanes] =
      slip > 0 && ds < 1 && c.half_inv_GII > 0 ? ds / (slip * c.half_inv_GII) : kNever;
  cold[kKappa * lanes] = kappa;
  cold[kSlip * lanes] = slip;
  cold[kShear * lanes] = ds;
}
void read_point(const double* hot, const double* cold, int lanes, State& s, std::size_t p) {
  s.crush[p] = hot[kCrush * lanes];
  s.plastic_slip[p] = hot[kPlastic * lanes];
  s.kappa[p] = cold[kKappa * lanes];
  s.slip[p] = cold[kSlip * lanes];
  s.shear_damage[p] = cold[kShear * lanes];
}

void read_wall(const double* wall, int lanes, State& s) {
  const double half_dt = 0.5 * wall[kDt * lanes];
  s.energy.dissipated_friction = wall[kFriction * lanes];
  s.energy.dissipated_fracture = wall[kFracture * lanes];
  s.energy.dissipated_crushing = wall[kCrushing * lanes];
  s.energy.work_loads = half_dt * wall[kLoads * lanes];
  s.energy.work_damping = half_dt * wall[kDamped * lanes];
}

std::vector<BareLoad> loads_of(const BareStart& start) {
  std::vector<BareLoad> loads;
  for (std::size_t k = 0; k < start.model.stages.size(); ++k) {
    const double scale = start.state.load_scale[k];
    if (scale == 0) continue;
    for (const PointLoad& load : start.model.stages[k].loads)
      loads.push_back({load.block, load.arm_x, load.arm_y, scale * load.fx, scale * load.fy});
  }
  return loads;
}

// What a block is and carries, of one wall.
struct Blocks {
  std::vector<double> rate, turn_rate, load_x, load_y;
};
Blocks blocks_of(const BareStart& start, const std::vector<BareLoad>& loads) {
  Blocks all;
  for (std::size_t i = 0; i < at(start.model.n_block); ++i) {
    all.rate.push_back(start.dt / start.model.mass[i]);
    all.turn_rate.push_back(start.model.turn_freedom[i] * start.dt / start.model.inertia[i]);
    all.load_x.push_back(start.model.gravity_mass[i] * start.state.gravity_x);
    all.load_y.push_back(start.model.gravity_mass[i] * start.state.gravity_y);
  }
  for (const BlockId i : start.held) all.rate[at(i)] = all.turn_rate[at(i)] = 0;
  for (const BareLoad& load : loads) {
    all.load_x[at(load.block)] += load.fx;
    all.load_y[at(load.block)] += load.fy;
  }
  return all;
}

BareJoint joint_of(const Model& m, JointId joint) {
  const std::size_t j = at(joint);
  return {joint < m.n_pair ? m.joint_a[j] : -1,
          m.joint_b[j],
          m.joint_material[j],
          0,
          m.arm_a_x[j],
          m.arm_a_y[j],
          m.arm_b_x[j],
          m.arm_b_y[j],
          m.tangent_x[j],
          m.tangent_y[j],
          std::hypot(m.half_x[j], m.half_y[j]),
          0.5 * m.area[j]};
}

template <class... Arrays>
double bytes_of(const Arrays&... arrays) {
  return (static_cast<double>(arrays.size() * sizeof(arrays[0])) + ...);
}

}  // namespace

dynamics::Lines<double> law_rows(const Model& m, int lanes) {
  dynamics::Lines<double> rows;
  for (const JointMaterial& material : m.materials) {
    const contact::LawConstants<double> c = contact::constants_of(material);
    const double two_GII = c.half_inv_GII > 0 ? 1 / c.half_inv_GII : kNever;
    for (const double value :
         {c.kn, c.ks, c.inv_ks, c.inv_kn, c.ft, 1 + c.tension_onset * c.tension_rate,
          c.tension_rate, c.c_res, c.c_drop, c.tan_res, c.tan_drop, c.half_inv_GII, two_GII, c.fc,
          c.p_full, c.inv_p_full, c.crush_gain})
      rows.insert(rows.end(), at(lanes), value);
  }
  return rows;
}

std::vector<const BareKernels*> bare_here() {
  std::vector<const BareKernels*> sets{&bare_scalar()};
#if defined(__x86_64__)
  sets.push_back(&bare_sse2());
  if (__builtin_cpu_supports("avx2")) sets.push_back(&bare_avx2());
  if (__builtin_cpu_supports("avx512f")) sets.push_back(&bare_avx512());
#endif
  return sets;
}

BareWallsRun::BareWallsRun(const BareStart& start, const BareKernels& kernels)
    : kernels_(kernels), start_(start.state), load_(loads_of(start)) {
  const Model& m = start.model;
  const int lanes = kernels.lanes;
  const auto last_block = [&](JointId j) { return std::max(m.joint_a[at(j)], m.joint_b[at(j)]); };
  joint_of_.resize(at(m.n_joint));
  std::iota(joint_of_.begin(), joint_of_.end(), 0);
  std::stable_sort(joint_of_.begin(), joint_of_.end(),
                   [&](JointId p, JointId q) { return last_block(p) < last_block(q); });
  std::vector<int> last(at(m.n_block), -1);
  hot_.resize(2 * kHotRows * at(m.n_joint) * at(lanes));
  cold_.resize(2 * kColdRows * at(m.n_joint) * at(lanes));
  for (std::size_t k = 0; k < joint_of_.size(); ++k) {
    const BareJoint& joint = joint_.emplace_back(joint_of(m, joint_of_[k]));
    if (joint.a >= 0) last[at(joint.a)] = static_cast<int>(k);
    last[at(joint.b)] = static_cast<int>(k);
    busy_.push_back(static_cast<unsigned char>(joint.a < 0));
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t lane = 0; lane < at(lanes); ++lane)
        put_point(m, start.state, joint_of_[k], 2 * at(joint_of_[k]) + p,
                  &hot_[(2 * k + p) * kHotRows * at(lanes) + lane],
                  &cold_[(2 * k + p) * kColdRows * at(lanes) + lane], lanes);
  }
  order_.resize(at(m.n_block));
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](auto p, auto q) { return last[at(p)] < last[at(q)]; });
  std::size_t moved = 0;
  for (std::size_t k = 0; k < joint_.size(); ++k) {
    while (moved < order_.size() && last[at(order_[moved])] + kDelay <= static_cast<int>(k))
      ++moved;
    joint_[k].moved = static_cast<std::int32_t>(k + 1 < joint_.size() ? moved : order_.size());
  }
  const Blocks blocks = blocks_of(start, load_);
  for (std::size_t i = 0; i < at(m.n_block); ++i) {
    const State& s = start.state;
    const double c = std::cos(0.5 * s.theta[i]), h = std::sin(0.5 * s.theta[i]);
    for (const double value :
         {s.ux[i], s.uy[i], -2 * h * h, 2 * h * c, c, h, blocks.load_x[i], blocks.load_y[i], 0.0,
          s.theta[i], s.vx[i], s.vy[i], s.omega[i], blocks.rate[i], blocks.turn_rate[i],
          blocks.load_x[i], blocks.load_y[i], 0.0})
      block_.insert(block_.end(), at(lanes), value);
  }
  law_ = law_rows(m, lanes);
  for (const double value : {start.dt, start.damping, 0.0, 0.0, 0.0, 0.0, 0.0})
    wall_.insert(wall_.end(), at(lanes), value);
  view_ = {m.n_joint,     static_cast<int>(load_.size()),
           joint_.data(), order_.data(),
           load_.data(),  law_.data(),
           hot_.data(),   cold_.data(),
           block_.data(), wall_.data(),
           busy_.data()};
}

State BareWallsRun::state(int lane) const {
  State s = start_;
  const int lanes = kernels_.lanes;
  for (std::size_t i = 0; i < s.ux.size(); ++i) {
    const double* q = &block_[i * kBlockRows * at(lanes) + at(lane)];
    s.ux[i] = q[kUx * lanes];
    s.uy[i] = q[kUy * lanes];
    s.theta[i] = q[kTheta * lanes];
    s.vx[i] = q[kVx * lanes];
    s.vy[i] = q[kVy * lanes];
    s.omega[i] = q[kOmega * lanes];
  }
  for (std::size_t k = 0; k < 2 * joint_of_.size(); ++k)
    read_point(&hot_[k * kHotRows * at(lanes) + at(lane)],
               &cold_[k * kColdRows * at(lanes) + at(lane)], lanes, s,
               2 * at(joint_of_[k / 2]) + k % 2);
  read_wall(&wall_[at(lane)], lanes, s);
  return s;
}

double BareWallsRun::bytes_per_point() const {
  return bytes_of(joint_, order_, load_, law_, hot_, cold_, block_, wall_, busy_) /
         static_cast<double>(2 * joint_.size() * at(kernels_.lanes));
}

double BareWallsRun::busy_share() const {
  return std::accumulate(busy_.begin(), busy_.end(), 0.0) / static_cast<double>(busy_.size());
}

BareJointsRun::BareJointsRun(const BareStart& start, const BareKernels& kernels)
    : kernels_(kernels), start_(start.state), load_(loads_of(start)) {
  const Model& m = start.model;
  const std::size_t lanes = at(kernels.lanes), nb = at(m.n_block);
  for (JointId j = 0; j < m.n_joint;) {  // runs of one material, cut into packs
    const bool on_ground = j >= m.n_pair;
    const std::int32_t material = m.joint_material[at(j)];
    const auto first = static_cast<std::int32_t>(busy_.size());
    while (j < m.n_joint && m.joint_material[at(j)] == material && (j >= m.n_pair) == on_ground) {
      std::vector<JointId> pack;
      while (pack.size() < lanes && j < m.n_joint && m.joint_material[at(j)] == material &&
             (j >= m.n_pair) == on_ground)
        pack.push_back(j++);
      add_pack(m, pack);
      busy_.push_back(static_cast<unsigned char>(on_ground));
    }
    group_.push_back({first, static_cast<std::int32_t>(busy_.size()), material, on_ground});
  }
  std::vector<std::int32_t> place_of(at(m.n_joint));  // of each joint's force
  for (std::size_t k = 0; k < joint_of_.size(); ++k)
    if (joint_of_[k] >= 0) place_of[at(joint_of_[k])] = static_cast<std::int32_t>(k);
  for (std::size_t i = 0; i < nb; ++i)
    for (const int side : {0, 1}) {
      (side == 0 ? begin_ : middle_).push_back(static_cast<std::int32_t>(entry_.size()));
      for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e)
        if ((m.block_entry[at(e)] & 1) == side)
          entry_.push_back(place_of[at(m.block_entry[at(e)] >> 1)]);
    }
  begin_.push_back(static_cast<std::int32_t>(entry_.size()));
  const Blocks blocks = blocks_of(start, load_);
  const State& s = start.state;
  for (std::size_t i = 0; i < nb; ++i) {
    pose_.insert(pose_.end(),
                 {s.ux[i], s.uy[i], std::cos(0.5 * s.theta[i]), std::sin(0.5 * s.theta[i])});
    place_.insert(place_.end(), {s.ux[i], s.uy[i], s.theta[i], 0});
    velocity_.insert(velocity_.end(), {s.vx[i], s.vy[i], s.omega[i], 0});
    rate_.insert(rate_.end(), {blocks.rate[i], blocks.rate[i], blocks.turn_rate[i], 0});
    weight_.insert(weight_.end(), {blocks.load_x[i], blocks.load_y[i], 0, 0});
  }
  for (int k = 0; k < 2; ++k) pose_.insert(pose_.end(), {0, 0, 1, 0});
  law_ = law_rows(m, 1);
  force_.assign(4 * joint_of_.size(), 0.0);
  wall_ = {start.dt, start.damping, 0, 0, 0, 0, 0};
  view_ = {m.n_block,
           static_cast<int>(group_.size()),
           static_cast<int>(load_.size()),
           group_.data(),
           a_.data(),
           b_.data(),
           geometry_.data(),
           load_.data(),
           law_.data(),
           hot_.data(),
           cold_.data(),
           busy_.data(),
           force_.data(),
           begin_.data(),
           middle_.data(),
           entry_.data(),
           pose_.data(),
           place_.data(),
           velocity_.data(),
           rate_.data(),
           weight_.data(),
           wall_.data()};
}

// Joints of one material, less than a pack filled up with joints of nobody.
void BareJointsRun::add_pack(const Model& m, const std::vector<JointId>& joints) {
  const std::size_t lanes = at(kernels_.lanes), pack = busy_.size();
  geometry_.resize((pack + 1) * kGeometryRows * lanes);
  hot_.resize((pack + 1) * 2 * kHotRows * lanes);
  cold_.resize((pack + 1) * 2 * kColdRows * lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const bool is_there = lane < joints.size();
    BareJoint q{m.n_block + 1, m.n_block + 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    if (is_there) q = joint_of(m, joints[lane]);
    joint_of_.push_back(is_there ? joints[lane] : -1);
    a_.push_back(q.a < 0 ? m.n_block : q.a);
    b_.push_back(q.b);
    const double rows[kGeometryRows] = {q.ax, q.ay, q.bx, q.by, q.tx, q.ty, q.half, q.share};
    for (std::size_t r = 0; r < kGeometryRows; ++r)
      geometry_[(pack * kGeometryRows + r) * lanes + lane] = rows[r];
    for (std::size_t p = 0; p < 2; ++p) {
      double* hot = &hot_[(2 * pack + p) * kHotRows * lanes + lane];
      double* cold = &cold_[(2 * pack + p) * kColdRows * lanes + lane];
      if (is_there)
        put_point(m, start_, joints[lane], 2 * at(joints[lane]) + p, hot, cold, kernels_.lanes);
      else
        hot[kCrushesBelow * lanes] = -kNever, hot[kDamagedFrom * lanes] = kNever;
    }
  }
}

State BareJointsRun::state() const {
  State s = start_;
  const std::size_t lanes = at(kernels_.lanes);
  for (std::size_t i = 0; i < s.ux.size(); ++i) {
    s.ux[i] = place_[4 * i];
    s.uy[i] = place_[4 * i + 1];
    s.theta[i] = place_[4 * i + 2];
    s.vx[i] = velocity_[4 * i];
    s.vy[i] = velocity_[4 * i + 1];
    s.omega[i] = velocity_[4 * i + 2];
  }
  for (std::size_t k = 0; k < joint_of_.size(); ++k)
    for (std::size_t p = 0; joint_of_[k] >= 0 && p < 2; ++p) {
      const std::size_t point = 2 * (k / lanes) + p, lane = k % lanes;
      read_point(&hot_[point * kHotRows * lanes + lane], &cold_[point * kColdRows * lanes + lane],
                 kernels_.lanes, s, 2 * at(joint_of_[k]) + p);
    }
  read_wall(wall_.data(), 1, s);
  return s;
}

double BareJointsRun::bytes_per_point() const {
  return bytes_of(group_, a_, b_, begin_, middle_, entry_, load_, geometry_, law_, hot_, cold_,
                  force_, pose_, place_, velocity_, rate_, weight_, wall_, busy_) /
         static_cast<double>(start_.kappa.size());
}

}  // namespace wythe::bench
