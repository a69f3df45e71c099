// The stages as classes: SettlingStage (gravity, load, cut), Push, Factor (body force, tilt) and Hold, with equations
// 4.7 to 4.7c and 4.9 of docs/theory/integration.md. Their common part comes first: step, runaways, collapse. Unbalance
// is checked every 50 steps, collapse every 500. The first reason to end counts, unless a block has run away.
#include "dynamics/stages/stage_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/elementary.h"
#include "core/real.h"
#include "dynamics/meters/residual.h"
#include "dynamics/passes/dashpots.h"
#include "dynamics/stages/cutting.h"
#include "dynamics/stages/recorder.h"
#include "dynamics/stages/shake.h"
#include "model/shaking.h"
#include "wythe/parts/reading.h"

namespace wythe::dynamics {
namespace {

constexpr int kSettleEvery = 50;  // steps between checks of the unbalance

// Stages that apply a load and then wait until the wall is in balance.
bool settles(StageKind kind) {
  return kind == StageKind::kGravity || kind == StageKind::kLoad || kind == StageKind::kCut;
}

}  // namespace

double smooth_step(double x) {
  const double c = clip(x, 0.0, 1.0);
  return c * c * (3.0 - 2.0 * c);
}

double stage_mass_scaling(const Model& model, const Stage& stage) {
  return settles(stage.spec.kind()) ? model.solve.mass_scaling : 1.0;
}

// Dashpots use the velocities of the half step before: omega^2 dt^2/4 + rate dt/2 <= 1. The step of a shake
// is at most half of the longest step, a quarter where impacts rebound (docs/theory/dynamics.md, "The step").
double stage_time_step(const Model& model, const Stage& stage) {
  const double of_impacts = rebounds(stage.dashpots) ? 0.25 : 0.5;
  const double fraction = stage.spec.kind() == StageKind::kShake
                              ? std::min(model.solve.step_fraction, of_impacts)
                              : model.solve.step_fraction;
  const double step = fraction * 2.0 / model.omega_max *
                      std::sqrt(stage_mass_scaling(model, stage) / (1.0 + stage.spec.damping));
  return stage.dashpots.any() ? step * share_of_step(model.omega_max, stage.dashpots) : step;
}

double driven_path(const Stage& stage) {
  if (stage.targets().empty()) return stage.spec.get<PushStage>().until;
  double path = 0, at = 0;
  for (const double target : stage.targets()) {
    path += std::fabs(target - at);
    at = target;
  }
  return path;
}

StageRun::StageRun(StageContext& wall, const Stage& stage)
    : wall_(wall),
      model_(wall.model),
      stage_(stage),
      state_(wall.state),
      progress_(state_.progress),
      controls_(wall.controls),
      driven_(&stage.driven) {
  if (progress_.time == 0) progress_.first_step = state_.step;
  controls_ = {};
  controls_.dt = stage_time_step(model_, stage);
  controls_.mass_scaling = stage_mass_scaling(model_, stage);
  controls_.damping = stage.spec.damping;
  wall.access->choose_driven(stage.driven);
}

void StageRun::drive(const Stage& push) {
  driven_ = &push.driven;
  controls_.push = &push;
  wall_.access->choose_driven(push.driven);
}

void StageRun::end(StageEnd how) {
  if (ended_) return;
  end_ = std::move(how);
  ended_ = true;
}

StageEnd StageRun::close() {
  // A wall that ran away has not completed, settled or collapsed, whatever its rows show.
  if (wall_.access->runaway_block() >= 0) end_ = runs_away();
  finish(end_);
  wall_.access->store_state(state_);
  wall_.record.result.stages.push_back(
      {stage_.spec.name, progress_.time, state_.step - progress_.first_step,
       wall_.access->unbalance_ratio(), end_.status == SolveStatus::kCompleted});
  wall_.record.result.energy = energy_ledger(model_, state_, controls_.mass_scaling);
  return end_;
}

std::string StageRun::name_of(BlockId block) const {
  if (block < model_.n_block) return model_.anatomy.block_id[block];
  const int node = block - model_.n_block;
  std::string name = "of zones";
  for (const SolidBody& body : model_.solids.bodies)
    if (node >= body.first_node) name = body.id;
  for (const SpaceSolidBody& body : model_.space.solids.bodies)
    if (node >= body.first_node) name = body.body.id;
  return name;
}

// Whether weights and dead loads in force exceed the strength of all joints on the ground.
bool StageRun::is_overloaded() const {
  double load = -state_.gravity_y * model_.weight / model_.solve.gravity, bears = 0;
  for (std::size_t k = 0; k < model_.stages.size(); ++k)
    for (const PointLoad& dead : model_.stages[k].loads) load -= state_.load_scale[k] * dead.fy;
  for (int i = model_.n_pair; i < model_.n_joint; ++i) {
    const std::size_t j = i;
    bears += model_.area[j] * model_.materials[model_.joint_material[j]].compressive_strength;
  }
  return load > bears;
}

// How many joints are crushed through; empty where none is.
std::optional<Message> StageRun::crushed() const {
  wall_.access->store_state(state_);
  const std::vector<PointReading> points = read_points(model_, state_);
  int joints = 0;
  for (JointId j = 0; j < model_.n_joint; ++j) {
    const PointRange range = points_of(model_, j);
    joints += std::any_of(points.begin() + range.begin, points.begin() + range.end,
                          [](const PointReading& point) { return point.crushing >= 1; });
  }
  if (joints == 0) return std::nullopt;
  return Message{is_overloaded() ? "joints.overloaded" : "joints.crushed",
                 {{"joints", joints}, {"of", model_.n_joint}}};
}

// A motion that is NaN or faster than any fall is an error of the computation. The exception is a
// load beyond the strength of the joints on the ground: such a wall collapses with any time step.
StageEnd StageRun::runs_away() const {
  const std::optional<Message> why = crushed();
  const bool falls = why && is_overloaded();
  Message reason{falls ? "block.falls_overloaded"
                 : why ? "block.runs_away_crushed"
                       : "block.runs_away",
                 {{"block", name_of(wall_.access->runaway_block())},
                  {"time_s", state_.time},
                  {"stage", stage_.spec.name}}};
  if (why) reason.arguments.emplace_back("why", *why);
  return {falls ? SolveStatus::kCollapsed : SolveStatus::kUnstable, std::move(reason), false};
}

void StageRun::check_motion(double share) {
  const SolveOptions& options = wall_.options;
  if (options.progress)
    options.progress(
        {stage_.spec.name.c_str(), share, progress_.drive_displacement,
         wall_.record.result.curve.empty() ? 0.0 : wall_.record.result.curve.back().reaction});
  if (wall_.access->runaway_block() >= 0) return end(runs_away());
  if (model_.free.any()) check_world_bounds();
}

// Checks for instability, and for collapse: a block farther away than the push can have moved it.
void StageRun::check_run(double share) {
  if (state_.step % kCheckEvery != 0 || ended_) return;
  check_motion(share);
  if (ended_) return;
  if (controls_.push != nullptr && stage_.has_pattern() && stage_.drive().y == 0)
    return check_falls();
  // a head is driven at the end of an arm, and moves farther than that end where the pier turns
  const double driven =
      std::fmax(std::fabs(progress_.drive_displacement), std::fabs(progress_.control_moved));
  const double allowed = driven + model_.solve.collapse_displacement;
  const Furthest furthest = wall_.access->furthest_block();
  if (furthest.distance > allowed && !turns_with_push(furthest)) end(fallen(furthest));
}

// The push at a place that moves the wall, or moved it last; null where there is none, or where its blocks do not show how the
// wall turns.
const Stage* StageRun::last_push() const {
  for (int k = state_.stage; k >= 0; --k) {
    const Stage& stage = model_.stages[static_cast<std::size_t>(k)];
    if (stage.push() == nullptr) continue;
    const bool moves_blocks =
        !stage.driven.empty() &&
        *std::max_element(stage.driven.begin(), stage.driven.end()) < model_.n_block;
    return stage.has_pattern() || stage.drive().y != 0 || !moves_blocks ? nullptr : &stage;
  }
  return nullptr;
}

// Whether a wall that is pushed outwards carries half of its largest force in balance. Unloading tells nothing.
bool StageRun::carries_its_push() const {
  constexpr double kCarried = 0.5, kOutwards = 0.98;
  const std::vector<CurveRow>& curve = wall_.record.result.curve;
  if (curve.size() < 2) return true;  // at its beginning nothing tells of a loss
  const auto carried = [](const CurveRow& row) {
    return std::fmin(std::fabs(row.reaction), std::fabs(row.base_shear));
  };
  double most = 0, of_all = 0, furthest = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    of_all = std::fmax(of_all, carried(curve[i]));
    if (is_in_balance(curve, i)) most = std::fmax(most, carried(curve[i]));
    furthest = std::fmax(furthest, std::fabs(curve[i].displacement));
  }
  const CurveRow& last = curve.back();
  if (std::fabs(last.displacement) < kOutwards * furthest) return true;
  if (most == 0) most = of_all;
  return most > 0 && carried(last) >= kCarried * most;
}

// A wall that turns about its foot moves its corners farther than the pushed place, in the ratio of their distances from the
// foot. That alone is no collapse.
bool StageRun::turns_with_push(const Furthest& furthest) const {
  const Stage* push = last_push();
  if (push == nullptr || furthest.block >= model_.n_block || pulled_away(furthest.block) ||
      (controls_.push != nullptr && !carries_its_push()))
    return false;
  wall_.access->store_state(state_);
  const auto each_corner = [&](BlockId b, const auto& look) {
    if (dimension_of(model_) == 2)
      for (const Vec3& corner : outline_of(model_, b)) look(corner);
    else
      for (const Polyhedron& part : model_.space.body[b].part)
        for (const Vec3& corner : part.vertex) look(corner);
  };
  const Vec3 along = push->drive() / length(push->drive());
  double foot = HUGE_VAL, near = HUGE_VAL, far = -HUGE_VAL, top = -HUGE_VAL;
  for (BlockId b = 0; b < model_.n_block; ++b)
    each_corner(b, [&](const Vec3& corner) {
      foot = std::fmin(foot, corner.y);
      near = std::fmin(near, dot(corner, along)), far = std::fmax(far, dot(corner, along));
    });
  each_corner(furthest.block, [&](const Vec3& corner) { top = std::fmax(top, corner.y); });
  double moved = 0, height = 0;
  for (const BlockId b : push->driven) {
    const BlockReading pushed = read_block(model_, state_, b);
    moved += dot(pushed.moved, along), height += pushed.start.y - foot;
  }
  const double reach = std::sqrt((top - foot) * (top - foot) + (far - near) * (far - near));
  return height > 0 && furthest.distance <=
                           std::fabs(moved) / height * reach + model_.solve.collapse_displacement;
}

// The link with the largest force (now or at prestress) that pulled a block in its direction of motion; -1: none.
int StageRun::pulled_by(BlockId block, double& force) const {
  constexpr double kMostly = 0.5;  // of the way
  int found = -1;
  if (block >= model_.n_block || model_.links.n == 0) return found;
  wall_.access->store_state(state_);
  const Vec3 moved = read_block(model_, state_, block).moved;
  const std::vector<LinkReading> links = read_links(model_, state_);
  for (int k = 0; k < model_.links.n; ++k) {
    const std::size_t i = k;
    const bool at_a = model_.links.a[i] == block;
    if (!at_a && model_.links.b[i] != block) continue;
    const Vec3 along = links[i].ends[at_a ? 1 : 0] - links[i].ends[at_a ? 0 : 1];
    const double pulled = std::max(links[i].force, model_.links.prestress[i]);
    if (pulled > force && dot(along, moved) > kMostly * length(along) * length(moved))
      force = pulled, found = k;
  }
  return found;
}

bool StageRun::pulled_away(BlockId block) const {
  double force = 0;
  return pulled_by(block, force) >= 0;
}

// The reason why a block went too far: a tie pulled it, or the wall cannot stand under its loads alone.
StageEnd StageRun::fallen(const Furthest& furthest) const {
  double force = 0;
  if (const int link = pulled_by(furthest.block, force); link >= 0)
    return {SolveStatus::kCollapsed,
            {"block.pulled_away",
             {{"block", name_of(furthest.block)},
              {"tie", model_.links.name[link]},
              {"moved_mm", 1e3 * furthest.distance},
              {"force_kN", 1e-3 * force},
              {"stage", stage_.spec.name}}},
            false};
  const bool loads = settles(stage_.spec.kind());
  const std::optional<Message> why = loads ? crushed() : std::nullopt;
  Message reason{why     ? "block.moved_away_crushed"
                 : loads ? "block.cannot_stand"
                         : "block.moved_away",
                 {{"block", name_of(furthest.block)},
                  {"moved_mm", 1e3 * furthest.distance},
                  {"stage", stage_.spec.name}}};
  if (why) reason.arguments.emplace_back("why", *why);
  return {SolveStatus::kCollapsed, std::move(reason), false};
}

// A block without ground below it falls for ever.
void StageRun::check_world_bounds() {
  wall_.access->store_state(state_);
  const FreeShapes& world = model_.free;
  for (BlockId block = 0; block < model_.n_block; ++block) {
    const BlockReading now = read_block(model_, state_, block);
    const Vec3 at = now.start + now.moved;
    const bool inside = at.x > world.x0 && at.x < world.x1 && at.y > world.y0 && at.y < world.y1 &&
                        (dimension_of(model_) == 2 || (at.z > world.z0 && at.z < world.z1));
    if (inside) continue;
    return end(
        {SolveStatus::kCollapsed,
         {"block.left_the_world",
          {{"block", name_of(block)}, {"x_m", at.x}, {"y_m", at.y}, {"stage", stage_.spec.name}}},
         false});
  }
}

// A pattern drives the mean of all blocks. The few blocks of a mechanism move many times
// as far along the push while the wall still stands. So only a fall counts as collapse.
void StageRun::check_falls() {
  wall_.access->store_state(state_);
  Furthest lowest{0, -1};
  const auto look = [&](const std::vector<double>& moved, int first) {
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (-moved[i] > lowest.distance) lowest = {-moved[i], first + static_cast<BlockId>(i)};
  };
  look(state_.uy, 0);
  look(state_.node_uy, model_.n_block);
  if (lowest.distance <= model_.solve.collapse_displacement) return;
  end({SolveStatus::kCollapsed,
       {"block.fallen",
        {{"block", name_of(lowest.block)},
         {"fallen_mm", 1e3 * lowest.distance},
         {"stage", stage_.spec.name}}},
       false});
}

namespace {

// Limits for falling walls (docs/theory/integration.md, 4.7b and 4.7c).
constexpr int kDoublings = 3;          // in succession, that count as a fall
constexpr double kFaster = 1.2;        // growth of energy / displacement while the latter doubles
constexpr double kSteady = 1.7;        // growth of the displacement while the time doubles
constexpr double kFirstTime = 0.25;    // after the ramp [s]; it is doubled again and again
constexpr double kWayOfFaster = 0.05;  // of collapse_displacement
constexpr double kWayOfSteady = 0.1;   // the same
constexpr double kWayAtLast = 0.01;    // the same, after the settling limit
constexpr double kOfWork =
    0.25;  // of the loads' work, stored in joints: a larger share is bending of a soft wall
constexpr double kOfFreeFall = 0.1;  // of gravity: a wall that moved farther may be a soft one

class SettlingStage : public StageRun {
 public:
  SettlingStage(StageContext& wall, const Stage& stage)
      : StageRun(wall, stage), n_(wall.record.recording.numbers) {
    if (progress_.time > 0) return;
    n_.fall_way = n_.fall_kinetic = n_.fall_most = n_.fall_then = 0;
    n_.fall_work = n_.fall_elastic = 0;
    n_.fall_faster = n_.fall_steady = 0;
  }

  void prepare() override {
    const double share = smooth_step((progress_.time + controls_.dt) / stage_.spec.ramp);
    if (stage_.spec.kind() == StageKind::kGravity) {
      state_.gravity_x = state_.gravity_z = 0;
      state_.gravity_y = -model_.solve.gravity * share;
    }
    if (stage_.spec.kind() == StageKind::kLoad || stage_.spec.kind() == StageKind::kCut ||
        !stage_.loads.empty() || model_.links.set_by == state_.stage)
      state_.load_scale[state_.stage] = share;
  }

  void after_step(double) override {
    const double ramp = stage_.spec.ramp;
    if (progress_.time >= ramp && state_.step % kSettleEvery == 0) {
      const double ratio = wall_.access->unbalance_ratio();
      if (ratio < model_.solve.settle_ratio) return end({});
      const Furthest furthest = wall_.access->furthest_block();
      follow_motion(furthest.distance);
      if (is_falling(furthest.distance)) return end(fallen(furthest));
      if (progress_.time > ramp + model_.solve.settle_limit)
        return end(still_falls(furthest.distance) ? fallen(furthest) : unsettled(ratio));
    }
    check_run(0);
  }

 private:
  [[nodiscard]] double time_at_rest() const { return progress_.time - stage_.spec.ramp; }

  // Loads are constant now. A wall that comes to rest gains less energy in each
  // further equal displacement, and moves less in each further equal time.
  void follow_motion(double way) {
    const double kinetic = wall_.access->kinetic_energy(1);
    if (n_.fall_way == 0) n_.fall_way = way, n_.fall_kinetic = kinetic;
    if (way >= 2 * n_.fall_way) {
      const bool faster = kinetic * n_.fall_way >= kFaster * n_.fall_kinetic * way;
      n_.fall_faster = faster ? n_.fall_faster + 1 : 0;
      n_.fall_way = way, n_.fall_kinetic = kinetic;
    }
    n_.fall_most = std::max(n_.fall_most, way);
    const double now = time_at_rest(), before = now - kSettleEvery * controls_.dt;
    double next = kFirstTime;
    while (next <= before) next *= 2;
    if (now < next) return;
    wall_.access->store_state(state_);
    const double work = state_.energy.work_loads, elastic = elastic_energy(model_, state_);
    const bool is_bent = elastic - n_.fall_elastic > kOfWork * (work - n_.fall_work);
    const bool steady = n_.fall_then > 0 && n_.fall_most >= kSteady * n_.fall_then && !is_bent;
    n_.fall_work = work, n_.fall_elastic = elastic;
    n_.fall_steady = steady ? n_.fall_steady + 1 : 0;
    n_.fall_then = n_.fall_most;
  }
  // A slack tie or a free contact may stop a moving wall; joints alone do not.
  [[nodiscard]] bool is_falling(double way) const {
    if (model_.links.n > 0 || model_.free.any()) return false;
    const double collapse = model_.solve.collapse_displacement, time = time_at_rest();
    const double softest =
        kOfFreeFall * model_.solve.gravity * (1 - stage_.spec.damping) * time * time;
    return (n_.fall_faster >= kDoublings && n_.fall_way >= kWayOfFaster * collapse) ||
           (n_.fall_steady >= kDoublings && way >= kWayOfSteady * collapse && way < softest);
  }
  // At the end of the settling time, the wall is farther away than ever, and the second half added nearly as much as the first.
  [[nodiscard]] bool still_falls(double way) const {
    return n_.fall_steady > 0 && way >= n_.fall_most && way > n_.fall_then &&
           way >= kWayAtLast * model_.solve.collapse_displacement;
  }

  [[nodiscard]] StageEnd unsettled(double ratio) const {
    return {SolveStatus::kNotSettled,
            {"stage.not_settled",
             {{"stage", stage_.spec.name},
              {"ratio", ratio},
              {"time_s", progress_.time},
              {"wanted", model_.solve.settle_ratio}}},
            false};
  }

  RecordingNumbers& n_;
};

class Push : public StageRun {
 public:
  Push(StageContext& wall, const Stage& stage)
      : StageRun(wall, stage),
        push_(stage.spec.get<PushStage>()),
        targets_(push_.targets.empty() ? std::vector<double>{push_.until} : push_.targets),
        path_(driven_path(stage)),
        recorder_(model_, stage, path_, wall.options.frames, wall.options.read_modes_at,
                  wall.record) {
    controls_.push = &stage;
    if (progress_.time == 0) {
      progress_.drive_displacement = progress_.travelled = progress_.turn_time = progress_.pace = 0;
      progress_.control_start = progress_.control_moved = progress_.control_furthest = 0;
      if (stage.control >= 0) progress_.control_start = control_now();
    }
    if (!target_left()) end({});
  }

  void prepare() override {
    const double start =
        smooth_step((progress_.time - progress_.turn_time + controls_.dt) / stage_.spec.ramp);
    controls_.drive_velocity = sense() * velocity() * start;
    controls_.drive_before = velocity_before();
  }

  void after_step(double reaction) override {
    follow_control();
    recorder_.take(*wall_.access, state_, controls_, reaction, displacement(), 0,
                   progress_.travelled);
    set_pace();
    if (sense_ * (displacement() - target()) >= 0) {
      ++progress_.target;
      progress_.turn_time = progress_.time;
    }
    check_run(progress_.travelled / path_);
    if (recorder_.row_closed() && push_.stop_below > 0) end_where_it_fell();
    if (!ended() && !target_left()) end({});
    if (stage_.control >= 0) end_where_control_stays_back();
  }

 private:
  // The wall stands, so the stages after this push are run.
  void end_where_it_fell() {
    const std::optional<LastingFall> found = recorder_.lasting_fall();
    if (!found) return;
    const auto& [fall, sense] = *found;
    end({SolveStatus::kCompleted,
         {sense == 0  ? "push.fell_below"
          : sense > 0 ? "push.fell_below_along"
                      : "push.fell_below_against",
          {{"share", fall.fraction},
           {"from_mm", 1e3 * (sense < 0 ? -fall.displacement : fall.displacement)},
           {"displacement_mm", 1e3 * displacement()}}}});
  }
  [[nodiscard]] bool target_left() const {
    return static_cast<std::size_t>(progress_.target) < targets_.size();
  }
  [[nodiscard]] double target() const { return targets_[progress_.target]; }
  // Displacement of the control point, or of the driven mean, to which rows and targets refer [m].
  [[nodiscard]] double displacement() const {
    return stage_.control >= 0 ? progress_.control_moved : progress_.drive_displacement;
  }
  [[nodiscard]] double control_now() const {
    return wall_.access->moved(stage_.control, stage_.drive());
  }
  // Updates the path so far: by the driven mean in each step, or by the control point
  // from one furthest point to the next. So vibrations of the control point do not count.
  void follow_control() {
    if (stage_.control < 0) {
      progress_.travelled += std::fabs(controls_.drive_velocity) * controls_.dt;
      return;
    }
    progress_.control_moved = control_now() - progress_.control_start;
    const double out = sense_ * progress_.control_moved;
    if (out <= progress_.control_furthest) return;
    progress_.travelled += out - progress_.control_furthest;
    progress_.control_furthest = out;
  }
  // Ends the push if the control point takes no part in the failure, because it would never reach its target.
  void end_where_control_stays_back() {
    constexpr double kBack = 0.25, kBeyond = 20;  // of the path
    const double back = progress_.control_furthest - sense_ * progress_.control_moved;
    const bool goes_back = back > kBack * path_;
    if (!goes_back && std::fabs(progress_.drive_displacement) < kBeyond * path_) return;
    end({SolveStatus::kNotSettled,
         {goes_back ? "push.control_goes_back" : "push.control_stays_behind",
          {{"block", name_of(stage_.control)},
           {"displacement_mm", 1e3 * progress_.control_moved},
           {"mean_mm", 1e3 * progress_.drive_displacement}}},
         false});
  }
  [[nodiscard]] bool has_servo() const { return std::isfinite(push_.fast_velocity); }
  [[nodiscard]] double velocity() const {
    if (!has_servo()) return push_.velocity;
    return push_.velocity + progress_.pace * (push_.fast_velocity - push_.velocity);
  }
  // Pushes faster where the wall is near balance. A full change takes the time of the smooth start.
  void set_pace() {
    if (!has_servo() || state_.step % kSettleEvery != 0) return;
    const double ratio = wall_.access->unbalance_ratio();
    const double wanted = smooth_step(2.0 - ratio / push_.fast_below);
    const double most = std::min(1.0, kSettleEvery * controls_.dt / stage_.spec.ramp);
    progress_.pace += clip(wanted - progress_.pace, -most, most);
  }
  // Velocity of the step before. A turn comes after the smooth start.
  [[nodiscard]] double velocity_before() const {
    const double ran = progress_.time - progress_.turn_time;
    if (ran > 0) return sense_ * velocity() * smooth_step(ran / stage_.spec.ramp);
    if (progress_.target == 0) return 0;
    const auto last = static_cast<std::size_t>(progress_.target) - 1;
    const double from = last > 0 ? targets_[last - 1] : 0.0;
    return (targets_[last] >= from ? 1.0 : -1.0) * velocity();
  }
  // Direction of the push in this step. It is kept, because the step may pass the target.
  double sense() { return sense_ = target() >= displacement() ? 1.0 : -1.0; }

  void finish(StageEnd& how) override {
    if (how.finished) progress_.target = 0;
    controls_.push = nullptr;
    // a control block that moves back does not turn the push, so there is no row for it
    const bool at_furthest = stage_.control < 0 || displacement() >= progress_.control_furthest;
    recorder_.finish(*wall_.access, state_, controls_, !at_furthest);
  }

  const PushStage& push_;
  std::vector<double> targets_;
  double path_;
  Recorder recorder_;
  double sense_ = 1;  // in this step
};

// Body force and tilt: the load factor grows while the wall is in balance.
class Factor : public StageRun {
 public:
  Factor(StageContext& wall, const Stage& stage)
      : StageRun(wall, stage),
        tilting_(stage.spec.kind() == StageKind::kTilt),
        rate_(tilting_ ? stage.spec.get<TiltStage>().tilt_rate
                       : stage.spec.get<BodyForceStage>().rate),
        last_(tilting_ ? stage.spec.get<TiltStage>().tilt_until
                       : stage.spec.get<BodyForceStage>().factor),
        recorder_(model_, stage, last_, wall.options.frames, wall.options.read_modes_at,
                  wall.record),
        factor_(progress_.body_factor) {
    if (progress_.time == 0) note_growth(moved());
    if (!(factor_ < last_)) end({});
  }

  void prepare() override {
    // The factor grows only while the wall is in balance, and stops at collapse.
    share_ = smooth_step(2.0 - progress_.balance / model_.solve.settle_ratio);
    factor_ += rate_ * share_ * smooth_step((progress_.time + controls_.dt) / stage_.spec.ramp) *
               controls_.dt;
    set_factor(std::min(factor_, last_));
  }

  void after_step(double) override {
    const double now = moved();
    const double carried = tilting_ ? elementary::tan(factor_) : factor_;
    recorder_.take(*wall_.access, state_, controls_, carried * model_.weight, now, carried,
                   factor_);
    if (state_.step % kSettleEvery == 0) {
      progress_.balance = wall_.access->unbalance_ratio();
      if (share_ > 0) {
        progress_.load_factor = carried;
        note_growth(now);
      }
    }
    if (progress_.time - progress_.last_growth > model_.solve.settle_limit)
      end(standstill(carried, now));
    else
      check_run(factor_ / last_);
    if (!ended() && !(factor_ < last_)) end({});
  }

 private:
  [[nodiscard]] double moved() const { return wall_.access->furthest_block().distance; }

  void note_growth(double moved) {
    progress_.last_growth = progress_.time;
    progress_.moved_then = moved;
  }

  void set_factor(double factor) {
    const double g = model_.solve.gravity;
    if (tilting_) {
      const SinCos<double> tilt = sin_cos(factor);
      state_.gravity_x = g * tilt.sin * stage_.drive_x;
      state_.gravity_z = g * tilt.sin * stage_.drive_z;
      state_.gravity_y = -g * tilt.cos;
    } else {
      state_.gravity_x = g * factor * stage_.drive_x;
      state_.gravity_z = g * factor * stage_.drive_z;
      state_.gravity_y = -g;
    }
    progress_.body_factor = factor;
  }

  // The factor has not grown for the settling limit: a mechanism moves on, or the wall vibrates.
  [[nodiscard]] StageEnd standstill(double carried, double now) const {
    if (now > 1.05 * progress_.moved_then)
      return {SolveStatus::kCollapsed,
              {"load.keeps_moving", {{"factor", carried}, {"stage", stage_.spec.name}}},
              false};
    return {SolveStatus::kNotSettled, {"load.standstill", {{"factor", carried}}}, false};
  }

  void finish(StageEnd& how) override {
    recorder_.finish(*wall_.access, state_, controls_, !how.finished);
    wall_.record.result.load_factor = progress_.load_factor;
    if (how.status == SolveStatus::kCollapsed)
      how.reason = {"load.largest_carried",
                    {{"why", std::move(how.reason)}, {"factor", wall_.record.result.load_factor}}};
  }

  bool tilting_;
  double rate_, last_;
  Recorder recorder_;
  double factor_;     // between steps equal to body_factor
  double share_ = 0;  // of the rate, in this step
};

// No new action: loads are constant, and blocks driven by an earlier push keep their place.
class Hold : public StageRun {
 public:
  Hold(StageContext& wall, const Stage& stage)
      : StageRun(wall, stage), hold_(stage.spec.get<HoldStage>()) {
    if (const Stage* push = push_before(); push != nullptr && !hold_.release) drive(*push);
    end_when_over();
  }

  void prepare() override {}
  void after_step(double) override {
    check_run(progress_.time / hold_.duration);
    keep_state();
    end_when_over();
  }

 private:
  // Keeps states for the film of a fall after a release: at equal times, and the last one.
  void keep_state() {
    const auto states_at = [&](double time) {
      return std::floor(wall_.options.frames * time / hold_.duration);
    };
    if (!hold_.release || !(states_at(progress_.time) > states_at(progress_.time - controls_.dt)))
      return;
    wall_.access->store_state(state_);
    wall_.record.result.states.frames.push_back({"", progress_.drive_displacement, 0, state_});
  }
  void finish(StageEnd&) override {
    if (!hold_.release) return;
    wall_.access->store_state(state_);
    wall_.record.result.states.snapshots.push_back(
        {"fallen", progress_.drive_displacement, 0, state_});
  }
  void end_when_over() {
    if (!ended() && !(progress_.time < hold_.duration)) end({});
  }
  // The last push before this stage, or null.
  [[nodiscard]] const Stage* push_before() const {
    const Stage* last = nullptr;
    for (const Stage& other : model_.stages) {
      if (&other == &stage_) break;
      if (other.push() != nullptr) last = &other;
    }
    return last;
  }

  const HoldStage& hold_;
};

}  // namespace

std::unique_ptr<StageRun> StageRun::start(StageContext& wall, const Stage& stage) {
  switch (stage.spec.kind()) {
    case StageKind::kGravity:
    case StageKind::kLoad: return std::make_unique<SettlingStage>(wall, stage);
    case StageKind::kCut: begin_cut(wall); return std::make_unique<SettlingStage>(wall, stage);
    case StageKind::kPush: return std::make_unique<Push>(wall, stage);
    case StageKind::kBodyForce:
    case StageKind::kTilt: return std::make_unique<Factor>(wall, stage);
    case StageKind::kHold: return std::make_unique<Hold>(wall, stage);
    case StageKind::kShake: return make_shake(wall, stage);
  }
  return nullptr;
}

}  // namespace wythe::dynamics
