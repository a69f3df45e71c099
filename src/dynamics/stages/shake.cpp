// An earthquake stage, step by step. The base's mean acceleration over a step is subtracted from gravity
// (docs/theory/dynamics.md, 14.1 and 14.2). The ground's force is sampled every 8 steps, and a row has the mean.
// Displacement alone is no collapse here: a block must have fallen, left the world or tilted past 60 degrees.
#include "dynamics/stages/shake.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "model/shaking.h"
#include "wythe/parts/reading.h"

namespace wythe::dynamics {
namespace {

constexpr int kForceEvery = 8;      // steps between samples of the ground's force
constexpr double kMostTilt = 1.05;  // of a block [rad]: no block comes back from beyond it

// The rate alpha at which velocities decay [1/s].
double decay_of(const ViscousSpec& viscous) {
  return 2 * viscous.fraction * 2 * M_PI * viscous.frequency;
}

// The blocks at the top of each storey. Empty for all storeys if one of them has no such block; a note before the run says so.
std::vector<std::vector<BlockId>> storey_tops(const Model& m) {
  auto found = blocks_at_tops(m);
  const bool is_whole =
      std::none_of(found.begin(), found.end(), [](const auto& blocks) { return blocks.empty(); });
  return is_whole ? found : std::vector<std::vector<BlockId>>{};
}

class Shake final : public StageRun {
 public:
  Shake(StageContext& wall, const Stage& stage)
      : StageRun(wall, stage),
        n_(wall.record.recording.numbers),
        result_(wall.record.result),
        tops_(storey_tops(model_)),
        duration_(shake_duration(stage)),
        interval_(shake_interval(stage)) {
    if (!stage.driven_motion.empty()) drive(stage);
    const ViscousSpec& damping = stage.spec.get<ShakeStage>().mass_damping;
    if (std::isfinite(damping.fraction)) controls_.mass_damping = decay_of(damping);
    if (stage.dashpots.any()) controls_.dashpots = &stage.dashpots;
    if (progress_.time == 0) begin();
    if (!(progress_.time < duration_)) end({});
  }

  // Sets the mean acceleration of the base over the step from its exact velocity.
  // So a free block has the exact velocity of the base at every half step.
  void prepare() override {
    const double t = progress_.time, dt = controls_.dt;
    Vec3 base{};
    for (const GroundMotion& motion : stage_.base)
      base = base + ((motion.velocity_at(t + 0.5 * dt) - motion.velocity_at(t - 0.5 * dt)) / dt) *
                        motion.along;
    state_.gravity_x = -base.x;
    state_.gravity_y = -model_.solve.gravity - base.y;
    state_.gravity_z = -base.z;
    const GroundMotion& driven = stage_.driven_motion;
    if (!driven.empty()) {
      controls_.drive_velocity = (driven.displacement_at(t + dt) - driven.displacement_at(t)) / dt;
      controls_.drive_before = (driven.displacement_at(t) - driven.displacement_at(t - dt)) / dt;
    }
  }

  void after_step(double) override {
    if (state_.step % kForceEvery == 0) sample();
    if (progress_.time >= static_cast<double>(rows_in_stage()) * interval_) take_row();
    if (state_.step % kCheckEvery == 0) check_fallen();
    if (!ended() && !(progress_.time < duration_)) end({});
  }

 private:
  void begin() {
    progress_.drive_displacement = 0;
    ShakeHistory& h = result_.history;
    if (h.row.empty()) name_places(h);
    if (n_.shake_start < 0)  // a push between two shakes resets it
      n_.shake_start = state_.time - (h.row.empty() ? 0 : h.row.back().time);
    n_.shake_rows = static_cast<std::int64_t>(result_.history.row.size());
    n_.shake_frames = 0;
    wall_.access->store_state(state_);
    keep_state("start of " + stage_.spec.name);
    sample();
    take_row();
  }

  void name_places(ShakeHistory& h) const {
    for (const WatchedPoint& point : model_.watched) h.point.push_back(point.name);
    for (std::size_t k = 0; k < tops_.size(); ++k) {
      const std::vector<double>& top = model_.anatomy.storey_top;
      h.storey.push_back(model_.anatomy.storey_name[k]);
      h.storey_height.push_back(top[k] - (k > 0 ? top[k - 1] : 0));
    }
  }

  // Mean displacement of these blocks, weighted by mass.
  [[nodiscard]] PointMotion mean_of(const std::vector<BlockId>& blocks) const {
    PointMotion sum = {};
    double mass = 0;
    for (const BlockId b : blocks) {
      const double m = model_.mass[b];
      const Vec3 moved = read_block(model_, state_, b).moved;
      sum[0] += m * moved.x, sum[1] += m * moved.y, sum[2] += m * moved.z;
      mass += m;
    }
    for (double& u : sum) u /= mass;
    return sum;
  }

  [[nodiscard]] std::int64_t rows_in_stage() const {
    return static_cast<std::int64_t>(result_.history.row.size()) - n_.shake_rows;
  }

  void sample() {
    n_.base_x += wall_.access->base_shear({1, 0, 0});
    n_.base_y -= wall_.access->base_shear({0, 1, 0});
    if (dimension_of(model_) == 3) n_.base_z += wall_.access->base_shear({0, 0, 1});
    ++n_.base_samples;
  }

  void take_row() {
    wall_.access->store_state(state_);
    ShakeRow row;
    row.time = state_.time - n_.shake_start;
    for (const GroundMotion& motion : stage_.base) {
      const Vec3 a = motion.acceleration_at(progress_.time) * motion.along;
      const Vec3 u = motion.displacement_at(progress_.time) * motion.along;
      row.base_acceleration[0] += a.x, row.base_acceleration[1] += a.y;
      row.base_acceleration[2] += a.z;
      row.base_displacement[0] += u.x, row.base_displacement[1] += u.y;
      row.base_displacement[2] += u.z;
    }
    const double samples = static_cast<double>(std::max<std::int64_t>(1, n_.base_samples));
    row.base_force = {n_.base_x / samples, n_.base_y / samples, n_.base_z / samples};
    n_.base_x = n_.base_y = n_.base_z = 0;
    n_.base_samples = 0;
    const std::vector<PointReading> points = read_points(model_, state_);
    if (!model_.free.any()) note_slid_off(points);
    for (const PointReading& point : points) {
      row.opening = std::max(row.opening, point.opening);
      row.slip = std::max(row.slip, std::fabs(point.slip));
    }
    row.kinetic = wall_.access->kinetic_energy(1);
    for (const WatchedPoint& point : model_.watched) {
      const Vec3 u = displacement_of(model_, state_, point.block, point.arm);
      result_.history.motion.push_back({u.x, u.y, u.z});
      if (&point == model_.watched.data() && point.height > 0)
        row.drift = elementary::hypot(u.x, u.z) / point.height;
    }
    for (const std::vector<BlockId>& blocks : tops_)
      result_.history.storey_top.push_back(mean_of(blocks));
    result_.history.row.push_back(row);
    take_frame();
  }

  // Joints keep their faces of the start, so a block that has left its face has no support.
  void note_slid_off(const std::vector<PointReading>& points) {
    int joints = 0;
    JointId first = -1;
    for (JointId j = 0; j < model_.n_joint; ++j)
      if (has_slid_off(model_, points, j) && joints++ == 0) first = j;
    Validity& validity = result_.validity;
    if (joints > 0 && validity.joints == 0) {
      const PointReading& point = points[points_of(model_, first).begin];
      validity.overlap_lost = std::fabs(control_now());
      validity.where = {
          "place.joint",
          {{"joint", Message{word_of(kJointKindCodes, model_.anatomy.joint_kind[first])}},
           {"x_m", std::round(1e2 * point.where.x) / 1e2 + 0.0},
           {"y_m", std::round(1e2 * point.where.y) / 1e2 + 0.0}}};
    }
    validity.joints = std::max(validity.joints, joints);
  }

  void take_frame() {
    const int frames = wall_.options.frames;
    const double due = duration_ * static_cast<double>(n_.shake_frames + 1) / (frames + 1);
    if (n_.shake_frames >= frames || progress_.time < due) return;
    ++n_.shake_frames;
    result_.states.frames.push_back({"", control_now(), base_now(), state_});
  }
  void keep_state(const std::string& label) {
    result_.states.snapshots.push_back({label, control_now(), base_now(), state_});
  }
  // Direction of the first record: the first point's displacement and the ground's force are taken along it.
  [[nodiscard]] Vec3 direction() const {
    return stage_.base.empty() ? stage_.drive() : stage_.base.front().along;
  }
  [[nodiscard]] double control_now() const {
    if (model_.watched.empty()) return 0;
    const WatchedPoint& point = model_.watched.front();
    return dot(displacement_of(model_, state_, point.block, point.arm), direction());
  }
  [[nodiscard]] double base_now() const {
    if (result_.history.row.empty()) return 0;
    const auto& f = result_.history.row.back().base_force;
    return dot(Vec3{f[0], f[1], f[2]}, direction());
  }

  // A rocking wall moves far and still stands. A wall with a fallen or toppled block does not.
  void check_fallen() {
    check_motion(progress_.time / duration_);
    if (ended()) return;
    check_falls();
    for (BlockId i = 0; i < model_.n_block && !ended(); ++i)
      if (tilt_of(model_, state_, i) > kMostTilt)
        end({SolveStatus::kCollapsed,
             {"block.toppled",
              {{"block", name_of(i)},
               {"tilt_degrees", 180 / M_PI * tilt_of(model_, state_, i)},
               {"time_s", progress_.time},
               {"stage", stage_.spec.name}}},
             false});
  }

  void finish(StageEnd& how) override {
    wall_.access->store_state(state_);
    keep_state("end");
    state_.gravity_x = state_.gravity_z = 0;
    state_.gravity_y = -model_.solve.gravity;
    if (how.status == SolveStatus::kCollapsed) {
      result_.shaking.collapsed = true;
      result_.shaking.collapse_time = state_.time - n_.shake_start;
    }
    controls_.push = nullptr;
  }

  RecordingNumbers& n_;
  Result& result_;
  std::vector<std::vector<BlockId>> tops_;  // of storeys
  double duration_, interval_;
};

AppliedRecord applied(const GroundMotion& m, bool of_base) {
  return {m.source,
          record_hash(m.time, m.acceleration),
          {m.along.x, m.along.y, m.along.z},
          of_base,
          m.factor,
          peak_acceleration(m),
          peak_velocity(m),
          arias_intensity(m),
          m.duration(),
          m.velocity.back(),
          m.displacement.back()};
}

// Peaks and residuals of each storey's drift.
std::vector<StoreyDrift> evaluate_storeys(const ShakeHistory& h, std::size_t tail) {
  std::vector<StoreyDrift> out;
  for (std::size_t k = 0; k < h.storey.size(); ++k) {
    StoreyDrift storey{h.storey[k], 0, 0, 0};
    double x = 0, z = 0;
    for (std::size_t r = 0; r < h.row.size(); ++r) {
      const auto [dx, dz] = storey_drift(h, r, k);
      const double drift = elementary::hypot(dx, dz);
      if (drift > storey.peak) storey.peak = drift, storey.at = h.row[r].time;
      if (r >= tail) x += dx, z += dz;
    }
    storey.residual = elementary::hypot(x, z) / static_cast<double>(h.row.size() - tail);
    out.push_back(storey);
  }
  return out;
}

}  // namespace

double shake_duration(const Stage& stage) {
  double longest = stage.driven_motion.duration();
  for (const GroundMotion& motion : stage.base) longest = std::max(longest, motion.duration());
  return longest + stage.spec.get<ShakeStage>().free_vibration;
}

double shake_interval(const Stage& stage) {
  constexpr double kUsual = 5e-3;
  const double longest = longest_interval(shake_duration(stage));
  const double stated = stage.spec.get<ShakeStage>().interval;
  if (std::isfinite(stated)) return std::min(stated, longest);
  return std::max(kUsual, shake_duration(stage) / kMostShakeRows);
}

std::unique_ptr<StageRun> make_shake(StageContext& wall, const Stage& stage) {
  return std::make_unique<Shake>(wall, stage);
}

void evaluate_shaking(const Model& model, Result& result) {
  const ShakeHistory& h = result.history;
  ShakeReadings& r = result.shaking;
  if (h.row.empty()) return;
  r.was_shaken = true;
  for (const Stage& stage : model.stages) {
    for (const GroundMotion& motion : stage.base) r.record.push_back(applied(motion, true));
    if (!stage.driven_motion.empty()) r.record.push_back(applied(stage.driven_motion, false));
  }
  const std::size_t rows = h.row.size(), points = h.point.size();
  const std::size_t tail = rows - std::max<std::size_t>(1, rows / 10);
  for (std::size_t p = 0; p < points; ++p) {
    PeakMotion peak{h.point[p], 0, 0, 0};
    Vec3 mean{};
    for (std::size_t k = 0; k < rows; ++k) {
      const PointMotion& u = h.motion[k * points + p];
      const double moved = elementary::hypot(u[0], u[2]);
      if (moved > peak.peak) peak.peak = moved, peak.at = h.row[k].time;
      if (k >= tail) mean = mean + Vec3{u[0], 0, u[2]};
    }
    peak.residual = length(mean) / static_cast<double>(rows - tail);
    r.motion.push_back(peak);
  }
  r.storey = evaluate_storeys(h, tail);
  for (const ShakeRow& row : h.row) {
    r.peak_base_shear =
        std::max(r.peak_base_shear, elementary::hypot(row.base_force[0], row.base_force[2]));
    r.largest_opening = std::max(r.largest_opening, row.opening);
    r.largest_slip = std::max(r.largest_slip, row.slip);
    r.peak_drift = std::max(r.peak_drift, row.drift);
  }
  if (!model.watched.empty() && model.watched.front().height > 0)
    r.residual_drift = r.motion.front().residual / model.watched.front().height;
}

}  // namespace wythe::dynamics
