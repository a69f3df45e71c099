#include "dynamics/recorder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/balance.h"
#include "dynamics/residual.h"
#include "reading/zones.h"

namespace wythe::dynamics {
namespace {

constexpr int kShearEvery = 8;       // steps between samples of base shear and kinetic energy
constexpr int kUnbalanceEvery = 32;  // steps between samples of the unbalance
constexpr double kReadEvery = 1e-3;  // between readings [m]
constexpr double kThrough = 0.999;   // tension or shear damage that counts as cracked through

const char* kind_name(JointKind kind) {
  switch (kind) {
    case JointKind::kBed: return "bed joint";
    case JointKind::kHead: return "head joint";
    case JointKind::kSplit: return "unit";
    case JointKind::kFoundation: return "foundation joint";
    case JointKind::kLintelChain: return "lintel";
    case JointKind::kLintelBond: return "lintel bearing";
    case JointKind::kPlate: return "plate joint";
    case JointKind::kBeam: return "beam joint";
    case JointKind::kOther: break;
  }
  return "joint";
}

// Centimetres, without a minus before zero.
double clean(double metres) { return std::round(1e2 * metres) * 1e-2 + 0.0; }

double default_window(const Model& model, double path) {
  if (std::isfinite(model.output.window)) return model.output.window;
  return path / std::max(1, model.output.rows);
}

bool has_event(const Result& result, const char* name) {
  return std::any_of(result.events.begin(), result.events.end(),
                     [&](const Event& e) { return e.name == name; });
}

}  // namespace

Recorder::Recorder(const Model& model, const Stage& stage, double path, int frames, double read_at,
                   Result& result)
    : model_(model),
      stage_(stage),
      result_(result),
      path_(path),
      window_(default_window(model, path)),
      leg_window_(window_),
      frames_(frames),
      start_time_(-1),
      work_at_start_(0),
      next_close_(window_),
      next_reading_(kReadEvery),
      read_at_(read_at),
      state_at_(model.output.states),
      slid_off_(static_cast<std::size_t>(model.n_joint), false) {
  std::sort(state_at_.begin(), state_at_.end());
  state_at_.push_back(std::numeric_limits<double>::infinity());
  due_ = std::min({state_at_.front(), next_reading_, read_at_});
  // The curve is that of the last stage that has one.
  result_.curve_of = stage.spec.kind;
  result_.curve.clear();
  result_.rise.clear();
  result_.events.clear();
  result_.snapshots.clear();
  result_.readings.clear();
  result_.frames.clear();
  result_.validity = {};
  result_.joint_crack_displacement.clear();
  if (result_.joint_crack_displacement.empty())
    result_.joint_crack_displacement.assign(static_cast<std::size_t>(model.n_joint),
                                            std::numeric_limits<double>::quiet_NaN());
}

void Recorder::take_snapshot(const std::string& label, const State& state) {
  const double reaction = result_.curve.empty() ? 0.0 : result_.curve.back().reaction;
  result_.snapshots.push_back({label, displacement_, reaction, state});
}

void Recorder::take(const Place& place, State& state, const Controls& controls, double reaction,
                    double displacement, double load_factor, double travelled) {
  if (start_time_ < 0) {
    start_time_ = state.time - state.stage_time;
    if (!stage_.spec.targets.empty() && stage_.spec.kind == StageKind::kPush) {
      const auto leg = static_cast<std::size_t>(state.target);
      const double from = leg == 0 ? 0.0 : stage_.spec.targets[leg - 1];
      begin_leg(leg, from, travelled - std::fabs(displacement - from));
    }
    while (next_close_ < travelled) plan_close();
    work_at_start_ = state.work_drive;
    dead_ = dead_along_push(state);
    if (result_.curve.empty()) result_.curve.push_back({});
    place.bring_up(state);
    damping_at_start_ = state.work_damping;
    take_snapshot("start", state);
  }
  displacement_ = displacement;
  load_factor_ = load_factor;
  weight_ = controls.push != nullptr ? std::fabs(controls.drive_velocity) : 1.0;
  weight_sum_ += weight_;
  reaction_sum_ += weight_ * reaction;
  rise_weight_ += weight_;
  rise_sum_ += weight_ * reaction;
  ++steps_;
  const bool closes = travelled >= next_close_ || has_turned();
  sample(place, state, controls, closes);
  take_rise(displacement, travelled);
  row_closed_ = closes;
  if (closes) {
    place.bring_up(state);
    close_row(state);
    take_frame(state, travelled);
  }
  take_states(place, state);
  if (has_turned()) begin_leg(static_cast<std::size_t>(state.target) + 1, displacement, travelled);
}

// At the step, not at the row, so that neither rows nor the states asked for move a reading.
void Recorder::take_states(const Place& place, State& state) {
  const double far = std::fabs(displacement_);
  const bool turns = grows_ && far < farthest_ && !stage_.spec.targets.empty();
  grows_ = far > farthest_;
  farthest_ = std::max(farthest_, far);
  if (!turns && far < due_) return;
  place.bring_up(state);
  while (far >= state_at_[next_state_]) {
    take_snapshot(fmt::format("{:g} mm", 1e3 * state_at_[next_state_]), state);
    ++next_state_;
  }
  if (turns || far >= std::min(next_reading_, read_at_))
    result_.readings.push_back({turns ? "turn" : "", displacement_, 0, state});
  if (far >= next_reading_) next_reading_ = kReadEvery * (1 + std::floor(far / kReadEvery));
  if (far >= read_at_) read_at_ = std::numeric_limits<double>::infinity();
  due_ = std::min({state_at_[next_state_], next_reading_, read_at_});
}

// Windows of at least one sample of base shear; the push's beginning is felt at the driven blocks first
// and at the ground last, so the wall's own force lies between the two.
void Recorder::take_rise(double displacement, double travelled) {
  constexpr double kFirst = 1e-6, kWider = 1.02;  // first window [m], each to the one before
  const double out = std::fabs(displacement);
  if (is_load_controlled(result_) || travelled > out * (1 + 1e-9) + 1e-12) return;
  if (out < std::max(kFirst, kWider * rise_from_) || rise_shear_weight_ == 0) return;
  const double force = 0.5 * (rise_sum_ / rise_weight_ + rise_shear_sum_ / rise_shear_weight_);
  result_.rise.push_back({0.5 * (rise_from_ + out), displacement < 0 ? -force : force});
  rise_from_ = out;
  rise_weight_ = rise_sum_ = rise_shear_weight_ = rise_shear_sum_ = 0;
}

bool Recorder::has_turned() const {
  return leg_way_ != 0 && leg_way_ * (displacement_ - leg_target_) >= 0;
}

// A leg of a cyclic push has whole windows of its own, so that a row ends where the push turns: forces
// and works of a window on both sides of a turn would mix.
void Recorder::begin_leg(std::size_t leg, double from, double travelled) {
  constexpr double kFewest =
      20;  // rows of a leg, where output.window does not say how long they are
  leg_way_ = 0;
  if (leg >= stage_.spec.targets.size()) return;
  leg_target_ = stage_.spec.targets[leg];
  leg_way_ = leg_target_ >= from ? 1 : -1;
  const double length = std::fabs(leg_target_ - from);
  const double fewest = std::isfinite(model_.output.window) ? 1.0 : kFewest;
  leg_window_ = length / std::max(fewest, std::round(length / window_));
  leg_end_ = travelled + length;
  next_close_ = travelled;
  plan_close();
}

// The last window of a leg closes where the push turns.
void Recorder::plan_close() {
  next_close_ += leg_window_;
  if (leg_way_ != 0 && next_close_ > leg_end_ - 0.5 * leg_window_)
    next_close_ = std::numeric_limits<double>::infinity();
}

void Recorder::take_frame(const State& state, double travelled) {
  // frame k at (k/n)^1.5 of the path: most cracks open in its first tenth
  constexpr double kCloserAtFirst = 1.5;
  const auto due = [&] {
    return path_ * std::pow(static_cast<double>(next_frame_) / frames_, kCloserAtFirst);
  };
  if (next_frame_ > frames_ || travelled < due()) return;
  while (next_frame_ <= frames_ && travelled >= due()) ++next_frame_;
  result_.frames.push_back({"", displacement_, result_.curve.back().reaction, state});
}

// The ground's force along the push, less what weights and dead loads bring there: in balance it is the
// reaction. Weights and loads of driven blocks stay in both. Of a tilted wall it is scaled to full
// weight, as the reaction is: W tan against W sin / cos.
double Recorder::resisted_by_ground(const Place& place, const State& state) const {
  const double shear = place.base_shear(stage_.drive_x, stage_.drive_y);
  if (stage_.spec.kind == StageKind::kTilt) {
    const double down = -state.gravity_y / model_.solve.gravity;
    return down > 0 ? shear / down : shear;
  }
  return stage_.spec.kind == StageKind::kPush ? shear - dead_ : shear;
}

// Force along the push of the weights of blocks that are not driven, and of the dead loads on them [N].
double Recorder::dead_along_push(const State& state) const {
  std::vector<bool> driven(static_cast<std::size_t>(model_.n_block), false);
  for (const BlockId block : stage_.driven) driven[static_cast<std::size_t>(block)] = true;
  double mass = 0, force = 0;
  for (std::size_t i = 0; i < driven.size(); ++i) mass += driven[i] ? 0.0 : model_.heavy_mass[i];
  for (const double node : model_.solids.node_heavy_mass) mass += node;
  force = mass * (state.gravity_x * stage_.drive_x + state.gravity_y * stage_.drive_y);
  for (std::size_t k = 0; k < model_.stages.size(); ++k)
    for (const PointLoad& load : model_.stages[k].loads)
      if (!driven[static_cast<std::size_t>(load.block)])
        force += state.load_scale[k] * (load.fx * stage_.drive_x + load.fy * stage_.drive_y);
  return force;
}

void Recorder::sample(const Place& place, const State& state, const Controls& controls, bool all) {
  if (state.step % kShearEvery == 0 || all) {
    const double shear = resisted_by_ground(place, state);
    shear_weight_ += weight_;
    shear_sum_ += weight_ * shear;
    rise_shear_weight_ += weight_;
    rise_shear_sum_ += weight_ * shear;
    const double work = std::fabs(state.work_drive - work_at_start_);
    if (work > 0) kinetic_sum_ += place.kinetic_energy(controls.mass_scaling) / work;
    ++shear_samples_;
  }
  if (state.step % kUnbalanceEvery == 0 || all) {
    unbalance_sum_ += place.unbalance_ratio();
    ++unbalance_samples_;
  }
}

void Recorder::close_row(const State& state) {
  CurveRow row;
  row.time = state.time - start_time_;
  row.displacement = is_load_controlled(result_) ? top_displacement(model_, state) : displacement_;
  row.drift = stage_.load_height > 0 ? displacement_ / stage_.load_height : 0.0;
  row.reaction = weight_sum_ > 0 ? reaction_sum_ / weight_sum_ : 0;
  row.base_shear = shear_weight_ > 0 ? shear_sum_ / shear_weight_ : 0;
  row.unbalance_ratio = unbalance_sum_ / static_cast<double>(std::max(1L, unbalance_samples_));
  row.kinetic_ratio = kinetic_sum_ / static_cast<double>(std::max(1L, shear_samples_));
  row.load_factor = load_factor_;
  row.work_drive = state.work_drive - work_at_start_;
  row.work_damping = damping_at_start_ - state.work_damping;
  const reading::LintelMeasures lintel = reading::lintel_measures(model_, state);
  row.lintel_deflection = lintel.deflection;
  row.lintel_end_rotation = lintel.end_rotation;
  row.lintel_axial = lintel.axial;
  result_.curve.push_back(row);
  Side& side = side_[displacement_ < 0 ? 1 : 0];
  const double force = displacement_ < 0 ? -row.reaction : row.reaction;
  const bool low = force < stage_.spec.stop_below * side.peak;
  low_rows_ = low && std::fabs(displacement_) >= side.furthest ? low_rows_ + 1 : 0;
  side.furthest = std::max(side.furthest, std::fabs(displacement_));
  full_window_ = steps_;
  weight_sum_ = shear_weight_ = 0;
  reaction_sum_ = shear_sum_ = unbalance_sum_ = kinetic_sum_ = 0;
  steps_ = shear_samples_ = unbalance_samples_ = 0;
  plan_close();

  note_joints(state, row.displacement, row.reaction);
  note_limits(state, row.displacement, row.reaction);
  note_peak(state);
}

// The state at the peak: of the largest row in balance with the one before; while there is none, of the
// largest row of all. Rows to come decide on the balance of the last (is_in_balance), so the state
// may be a row or two beside the peak that is read.
void Recorder::note_peak(const State& state) {
  const std::vector<CurveRow>& curve = result_.curve;
  const CurveRow& row = curve.back();
  const auto agree = [&](const CurveRow& other) {
    return std::fabs(other.reaction - other.base_shear) <= kBalance * std::fabs(row.reaction);
  };
  const bool balanced = agree(row) && agree(curve[curve.size() - 2]);
  const double force = row.displacement < 0 ? -row.reaction : row.reaction;
  Side& side = side_[row.displacement < 0 ? 1 : 0];
  if (balanced < side.balanced || (balanced == side.balanced && !(force > side.peak))) return;
  side.balanced = balanced;
  side.peak = force;
  side.peak_state = state;
  side.peak_displacement = row.displacement;
}

void Recorder::note_joints(const State& state, double displacement, double reaction) {
  const std::vector<PointReading> points = read_points(model_, state);
  note_slid_off(points, displacement, reaction);
  for (JointId joint = 0; joint < model_.n_joint; ++joint) {
    const auto mark = [&](const char* name, const PointReading& point) {
      if (!has_event(result_, name))
        result_.events.push_back({name, displacement, reaction, place_of(joint, point)});
    };
    const auto j = static_cast<std::size_t>(joint);
    const auto& m = model_.materials[static_cast<std::size_t>(model_.joint_material[j])];
    const bool dry = m.tensile_strength == 0;
    const PointRange range = points_of(model_, joint);
    for (PointId p = range.begin; p < range.end; ++p) {
      const PointReading& point = points[static_cast<std::size_t>(p)];
      if (point.crushing > 0) mark("first crushing", point);
      if (dry) continue;
      if (point.damage > 0) mark("first crack", point);
      if (point.damage < kThrough) continue;
      mark("first full crack", point);
      double& when = result_.joint_crack_displacement[j];
      if (std::isnan(when)) when = displacement;
    }
  }
}

std::string Recorder::place_of(JointId joint, const PointReading& point) const {
  return fmt::format("{} at ({:.2f}, {:.2f}) m",
                     kind_name(model_.anatomy.joint_kind[static_cast<std::size_t>(joint)]),
                     clean(point.where.x), clean(point.where.y));
}

void Recorder::note_slid_off(const std::vector<PointReading>& points, double displacement,
                             double reaction) {
  for (JointId joint = 0; joint < model_.n_joint; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    if (slid_off_[j] || !has_slid_off(model_, points, joint)) continue;
    slid_off_[j] = true;
    if (result_.validity.joints++ > 0) continue;
    const auto first = static_cast<std::size_t>(points_of(model_, joint).begin);
    result_.validity.overlap_lost = displacement;
    result_.validity.where = place_of(joint, points[first]);
    result_.events.push_back(
        {"blocks slid off each other", displacement, reaction, result_.validity.where});
  }
}

// Once a body and sense: zones stay elastic, so the user must know.
void Recorder::note_limits(const State& state, double displacement, double reaction) {
  for (const reading::BeyondLimit& beyond : reading::beyond_limits(model_, state)) {
    const std::string name = fmt::format("{} beyond its {} limit", beyond.body->id,
                                         beyond.tension ? "tension" : "compression");
    if (has_event(result_, name.c_str())) continue;
    result_.events.push_back(
        {name, displacement, reaction,
         fmt::format("{:.3g} MPa at ({:.2f}, {:.2f}) m, limit {:.3g} MPa; it stays elastic",
                     1e-6 * beyond.stress, clean(beyond.where.x), clean(beyond.where.y),
                     1e-6 * beyond.limit),
         true});
  }
}

bool Recorder::fell_below() const {
  constexpr int kRows = 3;
  return low_rows_ >= kRows;
}

void Recorder::finish(const Place& place, State& state, const Controls& controls, bool ran_away) {
  if (start_time_ < 0) return;
  place.bring_up(state);
  // A window cut short is too noisy a mean to stand beside the others; a wall that ran away under a load
  // that stands still has no more rows.
  if (2 * steps_ >= full_window_ && steps_ > 0 && !ran_away) {
    sample(place, state, controls, true);
    close_row(state);
  }
  const auto rank = [](const Side& side) { return std::pair(side.balanced, side.peak); };
  const bool against = rank(side_[1]) > rank(side_[0]);
  Side& larger = side_[against ? 1 : 0];
  if (larger.peak > 0)
    result_.snapshots.push_back({"peak", larger.peak_displacement,
                                 against ? -larger.peak : larger.peak,
                                 std::move(larger.peak_state)});
  take_snapshot("end", state);
  result_.readings.push_back(result_.snapshots.back());
  std::stable_sort(
      result_.snapshots.begin(), result_.snapshots.end(),
      [](const Snapshot& a, const Snapshot& b) { return a.state.time < b.state.time; });
}

}  // namespace wythe::dynamics
