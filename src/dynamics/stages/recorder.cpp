// A row closes when the driven path has grown by one window. Its forces are means over that path
// (docs/theory/integration.md, "What a row holds"). States for readings are taken at a step, so rows do not
// shift them. All data that later steps need lie in the recording, so that a run can be cut and continued.
#include "dynamics/stages/recorder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/elementary.h"
#include "dynamics/meters/balance.h"
#include "dynamics/meters/frame_uses.h"
#include "dynamics/meters/layer_uses.h"
#include "dynamics/meters/residual.h"
#include "reading/zones.h"

namespace wythe::dynamics {
namespace {

constexpr int kShearEvery = 8;         // steps between samples of base shear and kinetic energy
constexpr int kUnbalanceEvery = 32;    // steps between samples of the unbalance
constexpr double kShapesFrom = 1e-5;   // Result::rise_shapes: the first [m]
constexpr double kShapesApart = 0.05;  // and how far apart, of the displacement
constexpr double kThrough = 0.999;     // tension or shear damage that counts as cracked through

// Converts to centimetres, without a minus before zero.
double clean(double metres) { return std::round(1e2 * metres) * 1e-2 + 0.0; }

double default_window(const Model& model, double path) {
  if (std::isfinite(model.output.window)) return model.output.window;
  return path / std::max(1, model.output.rows);
}

bool has_event(const Result& result, const Message& name) {
  return std::any_of(result.events.begin(), result.events.end(),
                     [&](const Event& e) { return e.name == name; });
}

}  // namespace

Recorder::Recorder(const Model& model, const Stage& stage, double path, int frames, double read_at,
                   RunRecord& record)
    : model_(model),
      stage_(stage),
      result_(record.result),
      recording_(record.recording),
      n_(recording_.numbers),
      path_(path),
      window_(default_window(model, path)),
      frames_(frames),
      state_at_(model.output.states) {
  std::sort(state_at_.begin(), state_at_.end());
  state_at_.push_back(std::numeric_limits<double>::infinity());
  if (n_.under_way == 0) begin(read_at);
}

// Starts the results of the stage anew: the curve is that of the last stage with a curve.
void Recorder::begin(double read_at) {
  recording_ = {};
  n_.under_way = 1;
  n_.next_close = n_.leg_window = window_;
  n_.next_reading = kReadingsApart;
  n_.read_at = read_at;
  n_.due = std::min({state_at_.front(), n_.next_reading, read_at});
  const bool one_way = stage_.push() != nullptr && stage_.targets().empty();
  n_.next_shape = one_way ? kShapesFrom : std::numeric_limits<double>::infinity();
  const std::size_t joints = model_.n_joint;
  recording_.slid_off.assign(joints, 0);
  result_.curve_of = stage_.spec.kind();
  result_.curve.clear();
  result_.rise.clear();
  result_.strengthening.links.clear();
  result_.strengthening.frame_rows.clear();
  result_.strengthening.layer_rows.clear();
  result_.events.clear();
  result_.states.snapshots.clear();
  result_.states.readings.clear();
  result_.states.rise_shapes.clear();
  result_.states.frames.clear();
  result_.validity = {};
  result_.joint_crack_displacement.assign(joints, std::numeric_limits<double>::quiet_NaN());
}

void Recorder::take_snapshot(const std::string& label, const State& state) {
  const double reaction = result_.curve.empty() ? 0.0 : result_.curve.back().reaction;
  result_.states.snapshots.push_back({label, displacement_, reaction, state});
}

void Recorder::take(const WallAccess& access, State& state, const Controls& controls,
                    double reaction, double displacement, double load_factor, double travelled) {
  if (n_.start_time < 0) {
    n_.start_time = state.time - state.progress.time;
    if (!stage_.targets().empty()) {
      const std::size_t leg = state.progress.target;
      const double from = leg == 0 ? 0.0 : stage_.targets()[leg - 1];
      begin_leg(leg, from, travelled - std::fabs(displacement - from));
    }
    while (n_.next_close < travelled) plan_close();
    n_.work_at_start = state.energy.work_drive;
    n_.dead = dead_along_push(state);
    access.store_state(state);
    if (result_.curve.empty()) {
      result_.curve.push_back({});
      if (columns_of(model_).held_head) result_.curve.back().head_axial = head_axial(state);
      note_links(state, 0, 0);
      note_frames(state, 0, 0);
      note_layers(state, 0, 0);
    }
    n_.damping_at_start = state.energy.work_damping;
    take_snapshot("start", state);
  }
  displacement_ = displacement;
  load_factor_ = load_factor;
  weight_ = controls.push != nullptr ? std::fabs(controls.drive_velocity) : 1.0;
  n_.weight_sum += weight_;
  n_.reaction_sum += weight_ * reaction;
  n_.rise_weight += weight_;
  n_.rise_sum += weight_ * reaction;
  ++n_.steps;
  const bool closes = travelled >= n_.next_close || has_turned();
  sample(access, state, controls, closes);
  take_rise(displacement, travelled);
  row_closed_ = closes;
  if (closes) {
    access.store_state(state);
    close_row(state);
    take_frame(state, travelled);
  }
  take_shape(access, state);
  take_states(access, state);
  if (has_turned())
    begin_leg(static_cast<std::size_t>(state.progress.target) + 1, displacement, travelled);
}

// States are taken at the step, not at the row, so neither rows nor requested states shift a reading.
void Recorder::take_states(const WallAccess& access, State& state) {
  const double far = std::fabs(displacement_);
  const bool turns = n_.grows != 0 && far < n_.farthest && !stage_.targets().empty();
  n_.grows = far > n_.farthest ? 1 : 0;
  n_.farthest = std::max(n_.farthest, far);
  if (!turns && far < n_.due) return;
  access.store_state(state);
  while (far >= next_state_at()) {
    take_snapshot(fmt::format("{:g} mm", 1e3 * next_state_at()), state);
    result_.states.snapshots.back().asked = next_state_at();
    ++n_.next_state;
  }
  if (turns || far >= std::min(n_.next_reading, n_.read_at))
    result_.states.readings.push_back({turns ? "turn" : "", displacement_, 0, state});
  if (far >= n_.next_reading)
    n_.next_reading = kReadingsApart * (1 + std::floor(far / kReadingsApart));
  if (far >= n_.read_at) n_.read_at = std::numeric_limits<double>::infinity();
  n_.due = std::min({next_state_at(), n_.next_reading, n_.read_at});
}

// Stores how far each block has moved, until readings are closer than the next of these shapes.
void Recorder::take_shape(const WallAccess& access, State& state) {
  if (displacement_ < n_.next_shape) return;
  access.store_state(state);
  const Vec3 along = stage_.drive();
  const State& start = result_.states.snapshots.front().state;
  MovedBlocks& shape = result_.states.rise_shapes.emplace_back();
  shape.displacement = displacement_;
  const int supports = model_.space.n_support;
  const auto bodies =
      static_cast<int>(model_.solids.bodies.size() + model_.space.solids.bodies.size());
  shape.moved.assign(model_.n_block + supports + bodies, 0.0);
  for (BlockId b = 0; b < model_.n_block + supports + bodies; ++b) {
    if (b >= model_.n_block && b < model_.n_block + supports) continue;
    shape.moved[b] =
        dot(along, read_block(model_, state, b).moved - read_block(model_, start, b).moved);
  }
  const double apart = kShapesApart * displacement_;
  n_.next_shape =
      apart < kReadingsApart ? displacement_ + apart : std::numeric_limits<double>::infinity();
}

// Each window has at least one sample of base shear. The start of a push reaches the
// driven blocks first and the ground last, so the wall's own force lies between the two.
void Recorder::take_rise(double displacement, double travelled) {
  constexpr double kFirst = 1e-6, kWider = 1.02;  // first window [m], each to the one before
  const double out = std::fabs(displacement);
  if (is_load_controlled(result_) || travelled > out * (1 + 1e-9) + 1e-12) return;
  if (out < std::max(kFirst, kWider * n_.rise_from) || n_.rise_shear_weight == 0) return;
  const double force =
      0.5 * (n_.rise_sum / n_.rise_weight + n_.rise_shear_sum / n_.rise_shear_weight);
  result_.rise.push_back({0.5 * (n_.rise_from + out), displacement < 0 ? -force : force});
  n_.rise_from = out;
  n_.rise_weight = n_.rise_sum = n_.rise_shear_weight = n_.rise_shear_sum = 0;
}

bool Recorder::has_turned() const {
  return n_.leg_way != 0 && n_.leg_way * (displacement_ - n_.leg_target) >= 0;
}

// Each leg of a cyclic push has whole windows, so that a row ends where the
// push turns. A window on both sides of a turn would mix forces and works.
void Recorder::begin_leg(std::size_t leg, double from, double travelled) {
  constexpr double kFewest =
      20;  // rows of a leg, where output.window does not give a window's length
  n_.leg_way = 0;
  if (leg >= stage_.targets().size()) return;
  n_.leg_target = stage_.targets()[leg];
  n_.leg_way = n_.leg_target >= from ? 1 : -1;
  const double length = std::fabs(n_.leg_target - from);
  const double fewest = std::isfinite(model_.output.window) ? 1.0 : kFewest;
  n_.leg_window = length / std::max(fewest, std::round(length / window_));
  n_.leg_end = travelled + length;
  n_.next_close = travelled;
  plan_close();
}

// The last window of a leg closes where the push turns.
void Recorder::plan_close() {
  n_.next_close += n_.leg_window;
  if (n_.leg_way != 0 && n_.next_close > n_.leg_end - 0.5 * n_.leg_window)
    n_.next_close = std::numeric_limits<double>::infinity();
}

void Recorder::take_frame(const State& state, double travelled) {
  // frame k at (k/n)^1.5 of the path, because most cracks open in its first tenth
  constexpr double kCloserAtFirst = 1.5;
  const auto due = [&] {
    return path_ * elementary::pow(static_cast<double>(n_.next_frame) / frames_, kCloserAtFirst);
  };
  if (n_.next_frame > frames_ || travelled < due()) return;
  while (n_.next_frame <= frames_ && travelled >= due()) ++n_.next_frame;
  result_.states.frames.push_back({"", displacement_, result_.curve.back().reaction, state});
}

// The ground's force along the push, less the force that weights and dead loads cause there.
// In balance it equals the reaction. Weights and loads of driven blocks stay in both. For a
// tilted wall it is scaled to full weight, as the reaction is: W tan against W sin / cos.
double Recorder::resisted_by_ground(const WallAccess& access, const State& state) const {
  const double shear = access.base_shear(stage_.drive());
  if (stage_.spec.kind() == StageKind::kTilt) {
    const double down = -state.gravity_y / model_.solve.gravity;
    return down > 0 ? shear / down : shear;
  }
  return stage_.spec.kind() == StageKind::kPush ? shear - n_.dead : shear;
}

// Force along the push of the weights of blocks that are not driven, and of the dead loads on them [N].
double Recorder::dead_along_push(const State& state) const {
  std::vector<bool> driven(model_.n_block, false);
  for (const BlockId block : stage_.driven)
    if (block < model_.n_block) driven[block] = true;  // else a support
  double mass = 0, force = 0;
  for (std::size_t i = 0; i < driven.size(); ++i) mass += driven[i] ? 0.0 : model_.gravity_mass[i];
  for (const double node : model_.solids.node_gravity_mass) mass += node;
  for (const double node : model_.space.solids.node_gravity_mass) mass += node;
  const Vec3 along = stage_.drive();
  force = mass * dot(Vec3{state.gravity_x, state.gravity_y, state.gravity_z}, along);
  for (std::size_t k = 0; k < model_.stages.size(); ++k)
    for (const PointLoad& load : model_.stages[k].loads)
      if (!driven[load.block])
        force += state.load_scale[k] * dot(Vec3{load.fx, load.fy, load.fz}, along);
  return force;
}

void Recorder::sample(const WallAccess& access, const State& state, const Controls& controls,
                      bool all) {
  if (state.step % kShearEvery == 0 || all) {
    const double shear = resisted_by_ground(access, state);
    n_.shear_weight += weight_;
    n_.shear_sum += weight_ * shear;
    n_.rise_shear_weight += weight_;
    n_.rise_shear_sum += weight_ * shear;
    const double work = std::fabs(state.energy.work_drive - n_.work_at_start);
    if (work > 0) n_.kinetic_sum += access.kinetic_energy(controls.mass_scaling) / work;
    ++n_.shear_samples;
  }
  if (state.step % kUnbalanceEvery == 0 || all) {
    n_.unbalance_sum += access.unbalance_ratio();
    ++n_.unbalance_samples;
  }
}

// Upward force of the joints on the pushed blocks. For a head it is the axial force in the wall.
double Recorder::head_axial(const State& state) const {
  const auto is_driven = [&](BlockId block) {
    return std::find(stage_.driven.begin(), stage_.driven.end(), block) != stage_.driven.end();
  };
  const WallReading wall = read_wall(model_, state);
  double up = 0;
  for (const JointReading& joint : wall.joints) {
    const bool a = is_driven(joint.shape.a), b = is_driven(joint.shape.b);
    if (a != b) up += (b ? 1 : -1) * force_of(model_, joint, wall).y;
  }
  return up;
}

void Recorder::close_row(const State& state) {
  CurveRow row;
  row.time = state.time - n_.start_time;
  row.displacement = is_load_controlled(result_) ? top_displacement(model_, state) : displacement_;
  row.drift = stage_.load_height > 0 ? displacement_ / stage_.load_height : 0.0;
  row.reaction = n_.weight_sum > 0 ? n_.reaction_sum / n_.weight_sum : 0;
  row.base_shear = n_.shear_weight > 0 ? n_.shear_sum / n_.shear_weight : 0;
  const auto at_least_one = [](std::int64_t samples) {
    return static_cast<double>(std::max<std::int64_t>(1, samples));
  };
  row.unbalance_ratio = n_.unbalance_sum / at_least_one(n_.unbalance_samples);
  row.kinetic_ratio = n_.kinetic_sum / at_least_one(n_.shear_samples);
  row.load_factor = load_factor_;
  row.work_drive = state.energy.work_drive - n_.work_at_start;
  row.work_damping = n_.damping_at_start - state.energy.work_damping;
  const reading::LintelMeasures lintel = reading::lintel_measures(model_, state);
  row.lintel_deflection = lintel.deflection;
  row.lintel_end_rotation = lintel.end_rotation;
  row.lintel_axial = lintel.axial;
  row.head_axial = columns_of(model_).held_head ? head_axial(state) : 0;
  result_.curve.push_back(row);
  RecordedSide& side = recording_.side[displacement_ < 0 ? 1 : 0];
  side.furthest = std::max(side.furthest, std::fabs(displacement_));
  n_.full_window = n_.steps;
  n_.weight_sum = n_.shear_weight = 0;
  n_.reaction_sum = n_.shear_sum = n_.unbalance_sum = n_.kinetic_sum = 0;
  n_.steps = n_.shear_samples = n_.unbalance_samples = 0;
  plan_close();

  note_links(state, row.displacement, row.reaction);
  note_frames(state, row.displacement, row.reaction);
  note_layers(state, row.displacement, row.reaction);
  note_joints(state, row.displacement, row.reaction);
  note_limits(state, row.displacement, row.reaction);
  note_peak(state);
}

// Keeps the state at the peak: the largest row that is in balance together with the one
// before, or the largest row of all while there is none. Later rows decide on the balance
// of the last row (is_in_balance), so the state may be a row or two beside the final peak.
void Recorder::note_peak(const State& state) {
  const std::vector<CurveRow>& curve = result_.curve;
  const CurveRow& row = curve.back();
  const auto agree = [&](const CurveRow& other) {
    return std::fabs(other.reaction - other.base_shear) <= kBalance * std::fabs(row.reaction);
  };
  const bool balanced = agree(row) && agree(curve[curve.size() - 2]);
  const double force = row.displacement < 0 ? -row.reaction : row.reaction;
  RecordedSide& side = recording_.side[row.displacement < 0 ? 1 : 0];
  if (balanced < side.balanced || (balanced == side.balanced && !(force > side.peak))) return;
  side.balanced = balanced;
  side.peak = force;
  side.peak_state = state;
  side.peak_displacement = row.displacement;
}

// Stores the force of each link at the end of a row, and an event when it begins to yield.
void Recorder::note_links(const State& state, double displacement, double reaction) {
  const std::vector<LinkReading> links = read_links(model_, state);
  for (std::size_t k = 0; k < links.size(); ++k) {
    result_.strengthening.links.push_back({links[k].force, links[k].elongation, links[k].plastic});
    const Message name{"event.link_yields", {{"link", model_.links.name[k]}}};
    if (links[k].plastic == 0 || has_event(result_, name)) continue;
    result_.events.push_back(
        {name, displacement, reaction, {"place.force", {{"force_kN", 1e-3 * links[k].force}}}});
  }
}

// The same for sections of frames. A frame yields when its first fibre does.
void Recorder::note_frames(const State& state, double displacement, double reaction) {
  if (model_.frames.n == 0) return;
  const std::vector<FrameReading> sections = read_frames(model_, state);
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const FrameReading& section = sections[k];
    result_.strengthening.frame_rows.push_back({section.normal, section.shear, section.moment});
    if (section.plastic == 0) continue;
    const std::size_t member = model_.frames.member[k];
    const std::size_t frame = model_.frames.members[member].frame;
    const Message name{"event.frame_yields", {{"frame", model_.frames.name[frame]}}};
    if (!has_event(result_, name))
      result_.events.push_back({name, displacement, reaction, place_in_frame(model_, k)});
  }
}

void Recorder::note_layers(const State& state, double displacement, double reaction) {
  if (model_.layers.n == 0) return;
  const std::vector<LayerRow> rows = evaluate_layer_rows(model_, state);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    result_.strengthening.layer_rows.push_back(rows[k]);
    if (!(rows[k].broken > 0)) continue;
    const Message name{"event.layer_breaks", {{"layer", model_.layers.name[k]}}};
    if (!has_event(result_, name))
      result_.events.push_back({name, displacement, reaction, place_in_layer(rows[k])});
  }
}

void Recorder::note_joints(const State& state, double displacement, double reaction) {
  const std::vector<PointReading> points = read_points(model_, state);
  note_slid_off(points, displacement, reaction);
  struct First {
    const char* code;
    bool found;
  };
  const auto first = [&](const char* code) { return First{code, has_event(result_, {code})}; };
  First crushing = first("event.first_crushing"), crack = first("event.first_crack"),
        full_crack = first("event.first_full_crack");
  for (JointId joint = 0; joint < model_.n_joint; ++joint) {
    const auto mark = [&](First& event, const PointReading& point) {
      if (std::exchange(event.found, true)) return;
      result_.events.push_back({{event.code}, displacement, reaction, place_of(joint, point)});
    };
    const std::size_t j = joint;
    const auto& m = model_.materials[model_.joint_material[j]];
    const bool dry = m.tensile_strength == 0;
    // a new block starts with the closing of the beds that it replaced (docs/theory/cutting.md)
    constexpr double kBegunWith = 0.05;
    const bool was_put_up =
        model_.standing.any() && (!model_.standing.holds(model_.joint_a[j], 0) ||
                                  !model_.standing.holds(model_.joint_b[j], 0));
    const double least_crushing = was_put_up ? kBegunWith : 0.0;
    const PointRange range = points_of(model_, joint);
    for (PointId p = range.begin; p < range.end; ++p) {
      const PointReading& point = points[p];
      if (point.crushing > least_crushing) mark(crushing, point);
      if (dry) continue;
      if (point.damage > 0) mark(crack, point);
      if (point.damage < kThrough) continue;
      mark(full_crack, point);
      double& when = result_.joint_crack_displacement[j];
      if (std::isnan(when)) when = displacement;
    }
  }
}

Message Recorder::place_of(JointId joint, const PointReading& point) const {
  const JointKind kind = model_.anatomy.joint_kind[joint];
  return {"place.joint",
          {{"joint", Message{word_of(kJointKindCodes, kind)}},
           {"x_m", clean(point.where.x)},
           {"y_m", clean(point.where.y)}}};
}

void Recorder::note_slid_off(const std::vector<PointReading>& points, double displacement,
                             double reaction) {
  if (model_.free.any()) return;  // such a joint becomes a free contact
  for (JointId joint = 0; joint < model_.n_joint; ++joint) {
    const std::size_t j = joint;
    if (recording_.slid_off[j] != 0 || !has_slid_off(model_, points, joint)) continue;
    recording_.slid_off[j] = 1;
    if (result_.validity.joints++ > 0) continue;
    const std::size_t first = points_of(model_, joint).begin;
    result_.validity.overlap_lost = displacement;
    result_.validity.where = place_of(joint, points[first]);
    result_.events.push_back({{"event.slid_off"}, displacement, reaction, result_.validity.where});
  }
}

// Notes a limit once for each body and sense. Zones stay elastic, so the user has to know.
void Recorder::note_limits(const State& state, double displacement, double reaction) {
  for (const reading::BeyondLimit& beyond : reading::beyond_limits(model_, state)) {
    const Message name{beyond.tension ? "event.beyond_tension" : "event.beyond_compression",
                       {{"body", *beyond.body}}};
    if (has_event(result_, name)) continue;
    result_.events.push_back({name,
                              displacement,
                              reaction,
                              {"place.stress",
                               {{"stress_MPa", 1e-6 * beyond.stress},
                                {"x_m", clean(beyond.where.x)},
                                {"y_m", clean(beyond.where.y)},
                                {"limit_MPa", 1e-6 * beyond.limit}}},
                              true});
  }
}

// Checked again after each hundredth of displacement, because it evaluates the whole curve. The curve then shows why the push ended.
std::optional<LastingFall> Recorder::lasting_fall() {
  constexpr double kAgain = 1.01;
  const double way = std::fabs(displacement_), share = stage_.push()->stop_below;
  const CurveRow& row = result_.curve.back();
  const RecordedSide& side = recording_.side[displacement_ < 0 ? 1 : 0];
  const double force = displacement_ < 0 ? -row.reaction : row.reaction;
  if (way < kAgain * n_.stop_asked || !(side.peak > 0) || force >= side.peak) return std::nullopt;
  n_.stop_asked = way;
  const Responses read = read_responses(result_.curve, {.fractions = {share}});
  if (read.falls.empty() || read.falls.front().censored || !(read.falls.front().displacement > 0))
    return std::nullopt;
  return LastingFall{read.falls.front(), read.cyclic.sense};
}

void Recorder::finish(const WallAccess& access, State& state, const Controls& controls,
                      bool ran_away) {
  if (n_.start_time < 0) {  // the stage took no step
    recording_ = {};
    return;
  }
  access.store_state(state);
  // A window that ended early is too noisy to be a row, unless at least half of
  // it is there. A wall that ran away under a constant load gets no further row.
  if (2 * n_.steps >= n_.full_window && n_.steps > 0 && !ran_away) {
    sample(access, state, controls, true);
    close_row(state);
  }
  const auto rank = [](const RecordedSide& side) { return std::pair(side.balanced, side.peak); };
  const bool against = rank(recording_.side[1]) > rank(recording_.side[0]);
  RecordedSide& larger = recording_.side[against ? 1 : 0];
  if (larger.peak > 0)
    result_.states.snapshots.push_back({"peak", larger.peak_displacement,
                                        against ? -larger.peak : larger.peak,
                                        std::move(larger.peak_state)});
  take_snapshot("end", state);
  result_.states.readings.push_back(result_.states.snapshots.back());
  std::stable_sort(
      result_.states.snapshots.begin(), result_.states.snapshots.end(),
      [](const Snapshot& a, const Snapshot& b) { return a.state.time < b.state.time; });
  recording_ = {};
}

}  // namespace wythe::dynamics
