#include "space_wall.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "contact/parameters.h"
#include "dynamics/space/executor.h"
#include "wythe/parts/solve.h"

namespace wythe::bench {
namespace {

constexpr int kSteps = 100;
constexpr double kLambda = 0.8;
// Rounding grows where damping turns round a velocity that is all but 0; a wrong term shows in the first step.
constexpr double kTolerance = 1e-7;

std::size_t at_of(std::int64_t i) { return static_cast<std::size_t>(i); }

BodySpec box(const std::string& id, Vec3 low, Vec3 high, bool fixed = false) {
  Polyhedron part;
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] : {std::pair{low.x, low.y}, std::pair{high.x, low.y},
                               std::pair{high.x, high.y}, std::pair{low.x, high.y}})
      part.vertex.push_back({x, y, z});
  part.face = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  BodySpec body;
  body.id = id;
  body.part = {part};
  body.fixed = fixed;
  return body;
}

JointMaterial mortar() {
  JointMaterial m;
  m.normal_stiffness = 20e9, m.shear_stiffness = 8e9;
  m.tensile_strength = 0.15e6, m.cohesion = 0.15e6, m.residual_cohesion = 0;
  m.friction_angle = 16.2 * M_PI / 180, m.residual_friction_angle = 14.6 * M_PI / 180;
  m.mode_1_energy = 4.3, m.mode_2_energy = 125;
  m.compressive_strength = 3.96e6, m.compressive_energy = 12800;
  return m;
}

ModelSpec spec_of(int columns, int courses, double until) {
  ModelSpec spec;
  spec.name = "two leaves";
  spec.wall.blocks = "bodies.json";
  spec.wall.unit.density = 1800;
  spec.material["joint"] = mortar();
  spec.body.push_back(box("floor", {-1, -0.2, -1}, {0.2 * columns + 1, 0, 1}, true));
  for (int course = 0; course < courses; ++course)
    for (int k = 0; k < columns; ++k) {
      const double x = 0.2 * k + (course % 2 == 0 ? 0.0 : 0.1), y = 0.1 * course;
      const std::string id = fmt::format("c{}.{}", course, k);
      if ((k + 2 * course) % 4 == 0) {  // a header
        spec.body.push_back(box(id, {x, y, 0}, {x + 0.2, y + 0.1, 0.24}));
        continue;
      }
      spec.body.push_back(box(id + "a", {x, y, 0}, {x + 0.2, y + 0.1, 0.12}));
      spec.body.push_back(box(id + "b", {x, y, 0.12}, {x + 0.2, y + 0.1, 0.24}));
    }
  const StageSpec gravity{.name = "gravity"};
  const StageSpec push{.name = "push",
                       .action = PushStage{.at = {.block = fmt::format("c{}.*", courses - 1)},
                                           .drive = {.along = {1, 0, 0.5}},
                                           .velocity = 0.02,
                                           .until = until}};
  spec.stage = {gravity, push};
  return spec;
}

double gap_of(const std::vector<double>& a, const std::vector<double>& b) {
  double gap = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    gap = std::max(gap, std::fabs(a[i] - b[i]));
    size = std::max(size, std::fabs(b[i]));
  }
  return gap > 0 ? gap / size : 0;
}

constexpr std::array kArrays{&State::ux,
                             &State::uy,
                             &State::uz,
                             &State::qw,
                             &State::qx,
                             &State::qy,
                             &State::qz,
                             &State::vx,
                             &State::vy,
                             &State::vz,
                             &State::lx,
                             &State::ly,
                             &State::lz,
                             &State::kappa,
                             &State::crush,
                             &State::plastic_slip,
                             &State::plastic_slip_2,
                             &State::slip,
                             &State::shear_damage};

State engine_after(const SpaceWall& wall, int steps) {
  State state = wall.held;
  dynamics::space::SpaceProcessor processor(wall.model, 1);
  processor.load_wall(0, wall.model, state);
  processor.access(0)->choose_driven(wall.push().driven);
  dynamics::Controls controls;
  controls.dt = wall.dt;
  controls.damping = kLambda;
  processor.set(0, controls);
  for (int k = 0; k < steps; ++k) processor.step();
  processor.unload_wall(0);
  return state;
}

}  // namespace

SpaceWall::SpaceWall(int columns, int courses, double until)
    : model(compile(spec_of(columns, courses, until))), state(initial_state(model)) {
  const Result result = solve(model, state);
  hash = result.state_hash;
  dt = result.time_step;
  held = state;
  for (const BlockId block : push().driven) {
    const std::size_t i = at_of(block);
    held.vx[i] = held.vy[i] = held.vz[i] = held.lx[i] = held.ly[i] = held.lz[i] = 0;
  }
}

const SpaceWall& space_wall() {
  static const SpaceWall wall(8, 14, 2e-3);
  return wall;
}
const SpaceWall& still_wall() {
  static const SpaceWall wall(8, 14, 2e-6);
  return wall;
}
const SpaceWall& large_wall() {
  static const SpaceWall wall(60, 48, 2e-6);
  return wall;
}

std::vector<const SpaceKernels*> bare_space_here() {
  std::vector<const SpaceKernels*> sets{&bare_space_scalar()};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) sets.push_back(&bare_space_avx2());
  if (__builtin_cpu_supports("avx512f")) sets.push_back(&bare_space_avx512());
#endif
  return sets;
}

std::size_t BareSpaceRun::at(std::size_t e, std::size_t rows, std::size_t r) const {
  if (many_) return (e * rows + r) * lanes_;
  return (e / lanes_ * rows + r) * lanes_ + e % lanes_;
}

BareSpaceRun::BareSpaceRun(const SpaceWall& wall, const SpaceKernels& kernels, bool many)
    : wall_(wall), kernels_(kernels), many_(many), lanes_(at_of(kernels.lanes)) {
  law_ = law_rows(wall.model, many ? kernels.lanes : 1);
  fill_faces();
  fill_blocks();
  const std::size_t copies = many_ ? lanes_ : 1;
  for (const double value : {wall.dt, kLambda, 0.0, 0.0, 0.0, 0.0, 0.0})
    wall_rows_.insert(wall_rows_.end(), copies, value);
  view_ = {static_cast<int>(busy_.size()),
           static_cast<int>(many_ ? at_of(wall.model.n_pair)
                                  : (at_of(wall.model.n_pair) + lanes_ - 1) / lanes_),
           wall.model.n_block,
           a_.data(),
           b_.data(),
           face_.data(),
           point_.data(),
           axes_.data(),
           law_.data(),
           hot_.data(),
           cold_.data(),
           block_.data(),
           wall_rows_.data(),
           shift_.data(),
           turn_.data(),
           force_.data(),
           moment_a_.data(),
           moment_b_.data(),
           begin_.data(),
           middle_.data(),
           entry_.data(),
           busy_.data()};
}

void BareSpaceRun::fill_faces() {
  const Model& m = wall_.model;
  const Space& s = m.space;
  const std::size_t group = many_ ? 1 : lanes_, walls = many_ ? lanes_ : 1;
  const auto up = [&](std::size_t n) { return (n + group - 1) / group * group; };
  const std::size_t pairs = up(at_of(m.n_pair)), all = pairs + up(at_of(m.n_joint - m.n_pair));
  const auto shared = [&](std::size_t e, std::size_t rows, std::size_t r) {
    return many_ ? e * rows + r : at(e, rows, r);
  };
  const std::int32_t nobody = static_cast<std::int32_t>(
      many_ ? m.n_block : (m.n_block + kernels_.lanes - 1) / kernels_.lanes * kernels_.lanes);
  a_.assign(all, nobody), b_.assign(all, nobody);
  face_.assign(all * kBareFaceRows, 0), point_.assign(all * kFacePoints * kBarePointRows, 0);
  hot_.assign(all * kFacePoints * kSpaceHotRows * walls, 0);
  cold_.assign(all * kFacePoints * kColdRows * walls, 0);
  busy_.assign(all / group, 0);
  for (std::size_t e = 0; e < all; ++e)  // who fills up a pack lies flat and rests
    face_[shared(e, kBareFaceRows, kBareT)] = face_[shared(e, kBareFaceRows, kBareN + 1)] = 1;
  for (std::size_t n = 0; n < all * kFacePoints; ++n)
    for (std::size_t w = 0; w < walls; ++w) {
      const std::size_t face = n / kFacePoints, p = n % kFacePoints;
      const auto hot = [&](std::size_t r) -> double& {
        return hot_[at(face, kFacePoints * kSpaceHotRows, p * kSpaceHotRows + r) + w];
      };
      hot(kHotCrushesBelow) = -1e300, hot(kHotDamagedFrom) = 1e300;
    }
  for (std::size_t j = 0; j < at_of(m.n_joint); ++j) {
    const bool ground = j >= at_of(m.n_pair);
    const std::size_t e = ground ? pairs + j - at_of(m.n_pair) : j;
    face_at_.push_back(e);
    if (!ground) a_[e] = m.joint_a[j];
    b_[e] = m.joint_b[j];
    const auto put_vector = [&](std::size_t row, Vec3 v) {
      const double c[3] = {v.x, v.y, v.z};
      for (std::size_t k = 0; k < 3; ++k) face_[shared(e, kBareFaceRows, row + k)] = c[k];
    };
    put_vector(kBareArmA, s.arm_a[j]), put_vector(kBareArmB, s.arm_b[j]);
    put_vector(kBareT, s.tangent[j]), put_vector(kBareN, s.normal[j]);
    const auto law = contact::constants_of(m.materials[at_of(m.joint_material[j])]);
    for (std::size_t k = 0; k < kFacePoints; ++k) {
      const std::size_t p = at_of(s.point_begin[j]) + k;
      const double place[3] = {s.point_r1[p], s.point_r2[p], m.area[j] * s.point_share[p]};
      for (std::size_t r = 0; r < 3; ++r)
        point_[shared(e, kFacePoints * kBarePointRows, k * kBarePointRows + r)] = place[r];
      const State& now = wall_.held;
      const double kappa = now.kappa[p], crush = now.crush[p], slip = now.slip[p],
                   ds = now.shear_damage[p];
      const double left = std::clamp(1 - (kappa - law.tension_onset) * law.tension_rate, 0.0, 1.0);
      const double hot[kSpaceHotRows] = {
          crush,
          -law.fc * std::max(0.0, 1 - crush * law.inv_p_full) * law.inv_kn - crush,
          left * (1 - ds),
          now.plastic_slip[p],
          now.plastic_slip_2[p],
          slip > 0 && ds < 1 && law.half_inv_GII > 0 ? ds / (slip * law.half_inv_GII) : 1e300};
      const double cold[kColdRows] = {kappa, slip, ds};
      for (std::size_t w = 0; w < walls; ++w) {
        for (std::size_t r = 0; r < kSpaceHotRows; ++r)
          hot_[at(e, kFacePoints * kSpaceHotRows, k * kSpaceHotRows + r) + w] = hot[r];
        for (std::size_t r = 0; r < kColdRows; ++r)
          cold_[at(e, kFacePoints * kColdRows, k * kColdRows + r) + w] = cold[r];
      }
    }
  }
}

void BareSpaceRun::fill_blocks() {
  const Model& m = wall_.model;
  const std::size_t group = many_ ? 1 : lanes_, walls = many_ ? lanes_ : 1;
  const std::size_t all = (at_of(m.n_block) + group - 1) / group * group;
  block_.assign(all * kSpaceBlockRows * walls, 0);
  axes_.assign(all * 9, 0);
  shift_.assign(4 * (all + 1) * walls, 0), turn_.assign(4 * (all + 1) * walls, 0);
  for (std::size_t i = 0; i <= all; ++i)
    for (std::size_t w = 0; w < walls; ++w) shift_[(4 * i + 3) * walls + w] = 1;
  if (!many_)
    for (auto* rows : {&force_, &moment_a_, &moment_b_}) rows->assign(4 * a_.size(), 0);
  std::vector<bool> driven(at_of(m.n_block), false);
  for (const BlockId block : wall_.push().driven) driven[at_of(block)] = true;
  const State& now = wall_.held;
  for (std::size_t i = 0; i < all; ++i) {
    begin_.push_back(static_cast<std::int32_t>(entry_.size()));
    middle_.push_back(begin_.back());
    if (i >= at_of(m.n_block)) continue;
    for (const int side : {0, 1}) {
      if (side == 1) middle_.back() = static_cast<std::int32_t>(entry_.size());
      for (auto e = m.block_begin[i]; e < m.block_begin[i + 1]; ++e)
        if ((m.block_entry[at_of(e)] & 1) == side)
          entry_.push_back(
              static_cast<std::int32_t>(face_at_[at_of(m.block_entry[at_of(e)] >> 1)]));
    }
    const Vec3 axes[3] = {m.space.axis_1[i], m.space.axis_2[i], m.space.axis_3[i]};
    for (std::size_t k = 0; k < 3; ++k) {
      const double c[3] = {axes[k].x, axes[k].y, axes[k].z};
      for (std::size_t r = 0; r < 3; ++r)
        axes_[many_ ? i * 9 + 3 * k + r : at(i, 9, 3 * k + r)] = c[r];
    }
    const double free = driven[i] ? 0 : 1, heavy = free * m.gravity_mass[i];
    const Vec3 inertia = m.space.inertia[i];
    const double rows[kBareF] = {now.vx[i],
                                 now.vy[i],
                                 now.vz[i],
                                 now.lx[i],
                                 now.ly[i],
                                 now.lz[i],
                                 free * wall_.dt / m.mass[i],
                                 free * wall_.dt,
                                 free / inertia.x,
                                 free / inertia.y,
                                 free / inertia.z,
                                 heavy * now.gravity_x,
                                 heavy * now.gravity_y,
                                 heavy * now.gravity_z};
    const double shift[4] = {now.ux[i], now.uy[i], now.uz[i], now.qw[i]},
                 turn[4] = {now.qx[i], now.qy[i], now.qz[i], 0};
    for (std::size_t w = 0; w < walls; ++w) {
      for (std::size_t r = 0; r < kBareF; ++r) block_[at(i, kSpaceBlockRows, r) + w] = rows[r];
      for (std::size_t r = 0; r < 4; ++r) {
        shift_[(4 * i + r) * walls + w] = shift[r];
        turn_[(4 * i + r) * walls + w] = turn[r];
      }
    }
  }
  begin_.push_back(static_cast<std::int32_t>(entry_.size()));
}

State BareSpaceRun::state() const {
  const Model& m = wall_.model;
  State s = wall_.held;
  const std::size_t walls = many_ ? lanes_ : 1, w = walls - 1;
  for (std::size_t i = 0; i < at_of(m.n_block); ++i) {
    const auto four = [&](const auto& rows, std::size_t r) {
      return rows[(4 * i + r) * walls + w];
    };
    const auto own = [&](std::size_t r) { return block_[at(i, kSpaceBlockRows, r) + w]; };
    s.ux[i] = four(shift_, 0), s.uy[i] = four(shift_, 1), s.uz[i] = four(shift_, 2);
    s.qw[i] = four(shift_, 3), s.qx[i] = four(turn_, 0), s.qy[i] = four(turn_, 1);
    s.qz[i] = four(turn_, 2);
    s.vx[i] = own(kBareV), s.vy[i] = own(kBareV + 1), s.vz[i] = own(kBareV + 2);
    s.lx[i] = own(kBareL), s.ly[i] = own(kBareL + 1), s.lz[i] = own(kBareL + 2);
  }
  for (std::size_t j = 0; j < face_at_.size(); ++j)
    for (std::size_t k = 0; k < kFacePoints; ++k) {
      const std::size_t p = at_of(m.space.point_begin[j]) + k;
      const auto hot = [&](std::size_t r) {
        return hot_[at(face_at_[j], kFacePoints * kSpaceHotRows, k * kSpaceHotRows + r) + w];
      };
      const auto cold = [&](std::size_t r) {
        return cold_[at(face_at_[j], kFacePoints * kColdRows, k * kColdRows + r) + w];
      };
      s.crush[p] = hot(kHotCrush), s.plastic_slip[p] = hot(kHotPlastic1);
      s.plastic_slip_2[p] = hot(kHotPlastic2), s.kappa[p] = cold(kKappa);
      s.slip[p] = cold(kSlip), s.shear_damage[p] = cold(kShear);
    }
  return s;
}

double BareSpaceRun::bytes_per_point() const {
  const std::size_t own = (hot_.size() + cold_.size() + block_.size() + shift_.size() +
                           turn_.size() + force_.size() + moment_a_.size() + moment_b_.size()) /
                          (many_ ? lanes_ : 1);
  const std::size_t shared = (face_.size() + point_.size() + axes_.size()) / (many_ ? lanes_ : 1);
  return 8.0 * static_cast<double>(own + shared) / wall_.points();
}

void check_bare_space() {
  const State engine = engine_after(space_wall(), kSteps);
  for (const SpaceKernels* set : bare_space_here())
    for (const bool many : {false, true}) {
      BareSpaceRun run(space_wall(), *set, many);
      for (int k = 0; k < kSteps; ++k) run.step();
      const State bare = run.state();
      double gap = 0;
      for (const auto array : kArrays) gap = std::max(gap, gap_of(bare.*array, engine.*array));
      if (!(gap < kTolerance))
        throw std::runtime_error(
            fmt::format("bare kernel in space, {}{}: {:.1e} from the engine after {} steps, more "
                        "than {:.0e}: it computes "
                        "something else, so its time means nothing",
                        set->name, many ? ", side by side" : "", gap, kSteps, kTolerance));
    }
}

}  // namespace wythe::bench
