// The step is Executor::step() (executors/processor.cpp). Joints and blocks run in chunks over all walls,
// zones wall by wall. Each chunk keeps its works, and they are added in a fixed order. Contacts need the step
// that driven supports made before. Where a stage computes it from its clock, a restart has the same bits.
#include "dynamics/space/executor.h"

#include <algorithm>
#include <cmath>

#include "dynamics/executors/processor.h"
#include "dynamics/space/frames.h"
#include "dynamics/space/space_bodies.h"

namespace wythe::dynamics::space {
namespace {

// The widest set that is no wider than the number of lanes.
const KernelSet& kernels_for(int lanes, const KernelSet& most) {
  const KernelSet* widest = &scalar_kernels();
  for (const KernelSet* set : kernels_here())
    if (set->width <= std::min(lanes, most.width)) widest = set;
  return *widest;
}

class SpaceWallAccess final : public WallAccess {
 public:
  SpaceWallAccess(SpaceProcessor& processor, const Model& model, int lane)
      : processor_(processor), model_(model), lane_(lane), view_(processor.view(lane)) {}

  [[nodiscard]] double unbalance_ratio() const override {
    return space::unbalance_of(view_, model_, zones());
  }
  [[nodiscard]] double kinetic_energy(double mass_scaling) const override {
    return space::kinetic_of(view_, mass_scaling) +
           (zones() != nullptr ? zones()->kinetic(mass_scaling) : 0.0);
  }
  [[nodiscard]] double base_shear(const Vec3& along) const override {
    return space::shear_of(view_, model_, along) +
           (zones() != nullptr ? zones()->shear(view_, along) : 0.0);
  }
  // Blocks are checked first, then nodes.
  [[nodiscard]] BlockId runaway_block() const override {
    const BlockId block = space::runaway_of(view_);
    if (block >= 0 || zones() == nullptr) return block;
    const int node = zones()->runaway();
    return node >= 0 ? view_.blocks + node : -1;
  }
  [[nodiscard]] Furthest furthest_block() const override {
    const Furthest block = space::furthest_of(view_);
    if (zones() == nullptr) return block;
    const Furthest node = zones()->furthest();
    return node.distance > block.distance ? Furthest{node.distance, view_.blocks + node.block}
                                          : block;
  }
  [[nodiscard]] double moved(BlockId i, const Vec3& along) const override {
    return dot(view_.shift(i), vec(along));
  }
  void choose_driven(const std::vector<BlockId>& blocks) override {
    space::choose_driven(view_, blocks);
    if (model_.standing.any()) hold_still(view_, model_, processor_.state(lane_).stage);
  }
  void store_state(State& state) const override { processor_.store_state(lane_, state); }
  void reload_wall(State& state) override { processor_.load_wall(lane_, model_, state); }

 private:
  [[nodiscard]] const ZoneRun* zones() const { return processor_.zones(lane_); }

  SpaceProcessor& processor_;
  const Model& model_;
  int lane_;
  const WallView& view_;
};

}  // namespace

SpaceProcessor::SpaceProcessor(const Model& model, int lanes, int threads, const KernelSet& kernels)
    : model_(model),
      kernels_(lanes == 1 ? kernels : kernels_for(lanes, kernels)),
      width_(lanes == 1 ? 1 : kernels_.width),
      layout_(model, lanes == 1 ? dynamics::Layout::kNeighbours : dynamics::Layout::kWalls),
      rest_(initial_state(model)),
      wall_(static_cast<std::size_t>(lanes)),
      bank_(static_cast<std::size_t>(lanes / width_)),
      workers_(lanes == 1 ? threads : 1) {
  for (Bank& bank : bank_) {
    bank.tables = make_tables(layout_, model_, width_, bank.memory);
    bank.joint_works.resize(layout_.joints.size() * kTerms * static_cast<std::size_t>(width_));
    bank.block_works.resize(layout_.blocks.size() * kTerms * static_cast<std::size_t>(width_));
  }
  for (int lane = 0; lane < lanes; ++lane) {
    Wall& wall = wall_[lane];
    wall.view = view_of(layout_, model_, bank_[lane / width_].tables, lane % width_);
    load_lane(wall.view, model_, rest_);
    set(lane, {});
  }
  if (model_.free.any() && lanes == 1)
    free_ = std::make_unique<FreeContacts<SpaceBodies>>(model_, layout_, kernels_.width);
}

SpaceProcessor::~SpaceProcessor() = default;

int SpaceProcessor::n_near() const { return free_ ? free_->n_near() : 0; }

void SpaceProcessor::load_wall(int lane, const Model& model, State& state) {
  Wall& wall = wall_[lane];
  wall.model = &model;
  wall.state = &state;
  wall.dashpot_state = {};
  wall.has_stepped = false;
  load_lane(wall.view, model, state);
  if (model.standing.any()) stand(wall.view, model, state);
  if (free_) free_->load_state(state, wall.view);
  wall.zones.reset();
  if (model.space.solids.n_zone > 0) wall.zones = std::make_unique<ZoneRun>(model, state);
  set(lane, {});
}

void SpaceProcessor::unload_wall(int lane) {
  Wall& wall = wall_[lane];
  store_state(lane, *wall.state);
  wall.model = nullptr;
  wall.state = nullptr;
  wall.zones.reset();
  load_lane(wall.view, model_, rest_);  // at rest: costs least
  set(lane, {});
}

std::unique_ptr<WallAccess> SpaceProcessor::access(int lane) {
  return std::make_unique<SpaceWallAccess>(*this, *wall_[lane].model, lane);
}

void SpaceProcessor::set(int lane, const Controls& controls) {
  Wall& wall = wall_[lane];
  const bool same =
      wall.controls.dt == controls.dt && wall.controls.mass_scaling == controls.mass_scaling;
  wall.controls = controls;
  wall.view.wall_value(kStep) = controls.dt;
  wall.view.wall_value(kLambda) = controls.damping;
  wall.view.wall_value(kTimeBefore) = time_before(controls);
  // from the clock alone, if the stage gives it, so that a restart has the same bits
  if (std::isfinite(controls.drive_before))
    keep_support_step(wall, controls.drive_before);
  else if (!wall.has_stepped)
    keep_support_step(wall, controls.drive_velocity);
  if (!same || controls.dt == 0) set_rates(wall.view, controls.dt, controls.mass_scaling);
}

// Stores how far driven supports go in a step, for the contacts of the next step.
void SpaceProcessor::keep_support_step(Wall& wall, double velocity) {
  const Controls& c = wall.controls;
  const Vec step = c.push == nullptr ? Vec{0, 0, 0} : (c.dt * velocity) * vec(c.push->drive());
  wall.view.wall_value(kSupportStep) = step.x;
  wall.view.wall_value(kSupportStep + 1) = step.y;
  wall.view.wall_value(kSupportStep + 2) = step.z;
}

void SpaceProcessor::begin_step() {
  for (const Wall& wall : wall_) {
    if (wall.model == nullptr) continue;
    State& state = *wall.state;
    for (const Stage& stage : wall.model->stages) {
      for (const PointLoad& load : stage.loads) clear_load(load.block, wall.view);
      for (const PointLoad& mass : stage.carried) clear_load(mass.block, wall.view);
    }
    const std::size_t now = state.stage;
    const bool cuts = wall.model->standing.any() && now < wall.model->stages.size() &&
                      wall.model->stages[now].spec.kind() == StageKind::kCut;
    for (int i = 0; cuts && i < wall.view.blocks; ++i) clear_load(i, wall.view);
    for (std::size_t k = 0; k < wall.model->stages.size(); ++k)
      if (state.load_scale[k] != 0)
        for (const PointLoad& load : wall.model->stages[k].loads)
          add_load(load,
                   free_ ? state.load_scale[k] * free_->load_share(load.block, wall.view)
                         : state.load_scale[k],
                   wall.view);
    if (cuts) release(wall.view, state, 1 - state.load_scale[now]);
    if (wall.model->frames.n > 0 && wall.controls.dt > 0)
      state.energy.dissipated_friction += add_frame_forces(wall.view, *wall.model, state);
    if (wall.view.links > 0 && wall.controls.dt > 0) {
      const LinkWork work =
          add_link_forces(wall.view, links_set(*wall.model, state), jacks_set(*wall.model, state));
      state.energy.dissipated_friction += work.dissipated;
      state.energy.work_loads += work.tensioned;
    }
    add_carried(wall.view, *wall.model, state);
    if (wall.controls.mass_damping > 0)
      wall.state->energy.work_damping +=
          damp_by_mass(wall.view, wall.controls.mass_damping, wall.controls.dt);
    wall.view.wall_value(kGravity) = state.gravity_x;
    wall.view.wall_value(kGravity + 1) = state.gravity_y;
    wall.view.wall_value(kGravity + 2) = state.gravity_z;
  }
}

void SpaceProcessor::apply_dashpots() {
  if (layout_.damped == 0) return;
  bool any = false;
  for (Wall& wall : wall_) {
    wall.view.wall_value(kHasDashpots) = wall.view.wall_value(kElementGain) = 0;
    if (wall.model == nullptr || !(wall.controls.dt > 0)) continue;
    const Dashpots* dashpots = wall.controls.dashpots;
    if (dashpots == nullptr)
      clear_elements(wall.view, wall.dashpot_state);
    else
      load_dashpots(wall.view, *dashpots, wall.controls.dt, wall.dashpot_state);
    any = any || dashpots != nullptr;
  }
  if (any) run(kDashpots);
}

void SpaceProcessor::run_chunk(Kernel kernel, Bank& bank, const Chunk& chunk, double* works) const {
  constexpr int kMostLanes = 8;
  double sums[kTerms * kGroup * kMostLanes] = {};
  kernel(bank.tables, chunk, sums);
  if (works == nullptr) return;
  for (int term = 0; term < kTerms; ++term)
    for (int wall = 0; wall < width_; ++wall) {
      double sum = 0;
      for (int k = 0; k < kGroup; ++k) sum += sums[(term * kGroup + k) * width_ + wall];
      works[term * width_ + wall] = sum;
    }
}

void SpaceProcessor::run_zones(Pass pass) {
  Workers* workers = lanes() == 1 ? &workers_ : nullptr;
  for (Wall& wall : wall_) {
    if (!wall.zones) continue;
    if (pass == kZones) wall.zones->deform(workers);
    if (pass == kEdges) wall.zones->press(wall.view, workers);
    if (pass == kNodes)
      wall.zones->move(wall.view, wall.controls.dt, wall.controls.mass_scaling, workers);
  }
}

void SpaceProcessor::run(Pass pass) {
  if (pass == kZones || pass == kEdges || pass == kNodes) return run_zones(pass);
  const std::vector<Chunk>& chunks = pass == kBlocks ? layout_.blocks : layout_.joints;
  const Kernel kernel = (pass == kJoints     ? kernels_.joints
                         : pass == kDashpots ? kernels_.dashpots
                                             : kernels_.blocks)[lanes() == 1 ? 0 : 1];
  const auto width = static_cast<std::size_t>(width_);
  for (Bank& bank : bank_) {
    std::vector<double>& works = pass == kBlocks ? bank.block_works : bank.joint_works;
    workers_.for_each_chunk(static_cast<int>(chunks.size()), [&](int c) {
      double* of_chunk = &works[static_cast<std::size_t>(c) * kTerms * width];
      run_chunk(kernel, bank, chunks[c], pass == kDashpots ? nullptr : of_chunk);
    });
  }
}

void SpaceProcessor::store_state(int lane, State& state) const {
  const Wall& wall = wall_[lane];
  store_lane(wall.view, *wall.model, state);
  if (wall.zones) wall.zones->store_state(state);
  if (free_) free_->store_state(state);
}

void SpaceProcessor::update_free_contacts() {
  if (!free_ || wall_[0].model == nullptr || !(wall_[0].controls.dt > 0)) return;
  free_->act(*wall_[0].state, wall_[0].controls.dt, wall_[0].controls.dashpots, wall_[0].view,
             workers_);
}

void SpaceProcessor::drive() {
  for (Wall& wall : wall_) {
    wall.reaction = 0;
    wall.has_stepped = true;
    if (wall.controls.push == nullptr) {
      keep_support_step(wall, 0);
      continue;
    }
    State& s = *wall.state;
    WallWork work{s.energy.work_drive, s.energy.work_damping, s.energy.work_loads};
    wall.reaction =
        space::drive(*wall.controls.push, wall.view, wall.controls.drive_velocity, work);
    s.energy.work_drive = work.drive;
    s.energy.work_damping = work.damping;
    s.energy.work_loads = work.loads;
    s.progress.drive_displacement += wall.controls.dt * wall.controls.drive_velocity;
    keep_support_step(wall, wall.controls.drive_velocity);
  }
}

void SpaceProcessor::end_step() {
  for (int lane = 0; lane < lanes(); ++lane) {
    const Wall& wall = wall_[lane];
    if (wall.model == nullptr) continue;
    double* const ledger[kTerms] = {
        &wall.state->energy.dissipated_friction, &wall.state->energy.dissipated_fracture,
        &wall.state->energy.dissipated_crushing, &wall.state->energy.work_loads,
        &wall.state->energy.work_damping};
    const Bank& bank = bank_[lane / width_];
    for (const std::vector<double>* works : {&bank.joint_works, &bank.block_works})
      for (std::size_t k = lane % width_; k < works->size(); k += static_cast<std::size_t>(width_))
        *ledger[k / static_cast<std::size_t>(width_) % kTerms] += (*works)[k];
    if (wall.zones) wall.zones->tell(*wall.state);
    if (free_) free_->moved(*wall.state, wall.controls.dt, wall.view);
    if (wall.controls.dashpots != nullptr && layout_.damped > 0)
      wall.state->energy.work_damping += dashpot_work(wall.view, *wall.model, wall.controls.dt);
    advance_clock(*wall.state, wall.controls);
  }
}

}  // namespace wythe::dynamics::space

namespace wythe::dynamics {

std::unique_ptr<Executor> processor_for(const Model& model, int lanes, int threads) {
  if (model.in_space()) return std::make_unique<space::SpaceProcessor>(model, lanes, threads);
  return std::make_unique<Processor>(model, lanes, threads);
}

}  // namespace wythe::dynamics
