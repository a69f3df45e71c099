// Executor::step() is the order of a time step. Before and after its passes come dead loads, links, dashpots,
// drive and ledger, wall by wall. Each chunk keeps its own sums of work, and the ledger adds them in the order of
// chunks. So no bit depends on threads (docs/theory/determinism.md). A lane without a wall holds a wall at rest.
#include "dynamics/executors/processor.h"

#include <algorithm>

#include "dynamics/passes/frames.h"
#include "dynamics/passes/layers.h"
#include "dynamics/passes/links.h"
#include "dynamics/passes/plane_bodies.h"

namespace wythe::dynamics {

void Executor::step() {
  begin_step();  // dead loads follow; forces of links, frames, layers  passes/links.h, frames.h, layers.h
  run(kJoints);            // openings and slips, the law, forces of joints      passes/joints.h
  run(kZones);             // forces of deformable blocks on their nodes         passes/solids.h
  run(kEdges);             // the law between these and rigid blocks
  update_free_contacts();  // free contacts, and joints that give way to them    passes/free_contacts.h
  apply_dashpots();  // dashpots of the joints that are left               passes/joint_dashpots.h
  run(kBlocks);      // central differences with local damping, poses      passes/blocks.h
  run(kNodes);       // the same for nodes                                 passes/solids.h
  drive();           // the driven blocks, and their reaction              passes/drive.h
  end_step();        // works into the ledger, clock
}

namespace {

// The widest set that is no wider than the number of lanes.
const Kernels& kernels_for(int lanes, const Kernels& most) {
  const Kernels* widest = &scalar_kernels();
  for (const Kernels* set : kernels_here())
    if (set->width <= std::min(lanes, most.width)) widest = set;
  return *widest;
}

class HostWallAccess final : public WallAccess {
 public:
  HostWallAccess(Processor& processor, const Model& model, int lane)
      : processor_(processor), model_(model), lane_(lane), view_(processor.view(lane)) {}

  [[nodiscard]] double unbalance_ratio() const override { return unbalance_of(view_); }
  [[nodiscard]] double kinetic_energy(double mass_scaling) const override {
    return kinetic_of(view_, model_.mass.data(), model_.inertia.data(), mass_scaling);
  }
  [[nodiscard]] double base_shear(const Vec3& along) const override {
    return shear_of(view_, along.x, along.y);
  }
  [[nodiscard]] BlockId runaway_block() const override { return runaway_of(view_); }
  [[nodiscard]] Furthest furthest_block() const override { return furthest_of(view_); }
  [[nodiscard]] double moved(BlockId i, const Vec3& along) const override {
    return moved_along(view_, i, along.x, along.y);
  }
  void choose_driven(const std::vector<BlockId>& blocks) override {
    dynamics::choose_driven(view_, blocks);
    if (model_.standing.any()) hold_still(view_, model_, processor_.state(lane_).stage);
  }
  void store_state(State& state) const override { processor_.store_state(lane_, state); }
  void reload_wall(State& state) override { processor_.load_wall(lane_, model_, state); }

 private:
  Processor& processor_;
  const Model& model_;
  int lane_;
  WallView view_;
};

// Works that a pass does: terms `first` to `end` - 1.
struct Terms {
  int first, end;
};
constexpr Terms terms_of(Pass pass) {
  switch (pass) {
    case kJoints:
    case kEdges: return {kFriction, kLoads};
    case kBlocks:
    case kNodes: return {kLoads, kTerms};
    default: return {0, 0};
  }
}

// When masonry is cut out, its last forces go on acting on its neighbours and fade
// (docs/theory/cutting.md). When the stage has ended, nothing of them is left.
void release(const Model& model, const State& state, const WallView& wall) {
  const double share = 1 - state.load_scale[state.stage];
  for (int i = 0; i < model.n_block; ++i) {
    if (state.release_x[i] == 0 && state.release_y[i] == 0 && state.release_m[i] == 0) continue;
    wall.block(i, kLoadX) += share * state.release_x[i];
    wall.block(i, kLoadY) += share * state.release_y[i];
    wall.block(i, kLoadM) += share * state.release_m[i];
  }
}

// Adds the dead loads of all stages, in their order, to their blocks in the present pose.
void place_loads(const Model& model, const State& state, const WallView& wall,
                 const FreeContacts<PlaneBodies>* free) {
  for (const Stage& stage : model.stages) {
    for (const PointLoad& load : stage.loads) clear_load(load.block, wall);
    for (const PointLoad& mass : stage.carried) clear_load(mass.block, wall);
  }
  const std::size_t now = state.stage;
  const bool cuts = model.standing.any() && now < model.stages.size() &&
                    model.stages[now].spec.kind() == StageKind::kCut;
  for (int i = 0; cuts && i < model.n_block; ++i) clear_load(i, wall);
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const double scale = state.load_scale[k];
    if (scale == 0) continue;
    for (const PointLoad& load : model.stages[k].loads)
      add_load(load, free == nullptr ? scale : scale * free->load_share(load.block, wall), wall);
  }
  if (cuts) release(model, state, wall);
  if (now >= model.stages.size()) return;
  for (const PointLoad& mass : model.stages[now].carried)
    add_carried(mass, state.gravity_x, state.gravity_y + model.solve.gravity, wall);
}

// Adds the forces of links, layers and frames in the present pose. Their works go into the ledger.
void take_links(const Model& model, State& state, const WallView& wall) {
  if (wall.layers > 0) {
    const LayerWork work = add_layer_forces(wall);
    state.energy.dissipated_fracture += work.fracture;
    state.energy.work_damping -= work.damping;
  }
  if (wall.frames > 0) state.energy.dissipated_friction += add_frame_forces(wall);
  if (wall.links == 0) return;
  const LinkWork work = add_link_forces(wall, links_set(model, state), jacks_set(model, state));
  state.energy.dissipated_friction += work.dissipated;
  state.energy.work_loads += work.tensioned;
}

}  // namespace

Processor::Processor(const Model& model, int lanes, int threads, const Kernels& kernels)
    : model_(model),
      kernels_(lanes == 1 ? kernels : kernels_for(lanes, kernels)),
      width_(lanes == 1 ? 1 : kernels_.width),
      layout_(model, lanes == 1 ? Layout::kNeighbours : Layout::kWalls),
      rest_(initial_state(model)),
      wall_(static_cast<std::size_t>(lanes)),
      bank_(static_cast<std::size_t>(lanes / width_)),
      workers_(lanes == 1 ? threads : 1) {
  for (Bank& bank : bank_) {
    bank.tables = make_tables(layout_, model_, width_, bank.memory);
    for (int pass = 0; pass < kPasses; ++pass)
      bank.works[pass].resize(layout_.chunks[pass].size() * kTerms *
                              static_cast<std::size_t>(width_));
  }
  for (int lane = 0; lane < lanes; ++lane) {
    wall_[lane].view = view_of(layout_, model_, bank_of(lane).tables, lane % width_);
    load_lane(layout_, bank_of(lane).tables, lane % width_, model_, rest_);
    set(lane, {});
  }
  if (model_.free.any() && lanes == 1)
    free_ = std::make_unique<FreeContacts<PlaneBodies>>(model_, layout_, kernels_.width);
}

Processor::~Processor() = default;

int Processor::n_near() const { return free_ ? free_->n_near() : 0; }

void Processor::load_wall(int lane, const Model& model, State& state) {
  Wall& wall = wall_[lane];
  wall.model = &model;
  wall.state = &state;
  wall.dashpot_state = {};
  load_lane(layout_, bank_of(lane).tables, lane % width_, model, state);
  if (model.standing.any()) stand(layout_, bank_of(lane).tables, model, state);
  if (free_) free_->load_state(state, wall.view);
  set(lane, {});
}

void Processor::unload_wall(int lane) {
  Wall& wall = wall_[lane];
  store_state(lane, *wall.state);
  wall.model = nullptr;
  wall.state = nullptr;
  load_lane(layout_, bank_of(lane).tables, lane % width_, model_, rest_);  // at rest: costs least
  set(lane, {});
}

std::unique_ptr<WallAccess> Processor::access(int lane) {
  return std::make_unique<HostWallAccess>(*this, *wall_[lane].model, lane);
}

void Processor::set(int lane, const Controls& controls) {
  Controls& now = wall_[lane].controls;
  const bool same = now.dt == controls.dt && now.mass_scaling == controls.mass_scaling;
  now = controls;
  view(lane).wall_value(kDt) = controls.dt;
  view(lane).wall_value(kDamping) = controls.damping;
  view(lane).wall_value(kTimeBefore) = time_before(controls);
  if (!same || controls.dt == 0) set_rates(view(lane), controls.dt, controls.mass_scaling);
}

void Processor::begin_step() {
  for (int lane = 0; lane < lanes(); ++lane) {
    const Wall& wall = wall_[lane];
    if (wall.model == nullptr) continue;
    place_loads(*wall.model, *wall.state, wall.view, free_.get());
    if (wall.controls.dt > 0) take_links(*wall.model, *wall.state, wall.view);
    if (wall.controls.mass_damping > 0)
      wall.state->energy.work_damping +=
          damp_by_mass(wall.view, wall.controls.mass_damping, wall.controls.dt);
    wall.view.wall_value(kGravityX) = wall.state->gravity_x;
    wall.view.wall_value(kGravityY) = wall.state->gravity_y;
  }
}

void Processor::apply_dashpots() {
  if (layout_.damped == 0) return;
  bool any = false;
  for (Wall& wall : wall_) {
    wall.view.wall_value(kHasDashpots) = wall.view.wall_value(kElementGain) = 0;
    if (wall.model == nullptr || !(wall.controls.dt > 0)) continue;
    const Dashpots* dashpots = wall.controls.dashpots;
    if (dashpots == nullptr)
      clear_elements(layout_, wall.view, wall.dashpot_state);
    else
      load_dashpots(layout_, wall.view, *dashpots, wall.controls.dt, wall.dashpot_state);
    any = any || dashpots != nullptr;
  }
  if (any) run(kDashpots);
}

void Processor::run_chunk(Pass pass, Bank& bank, std::size_t chunk) {
  constexpr int kMostLanes = 8;
  double sums[kTerms * kGroup * kMostLanes];
  const Terms terms = terms_of(pass);
  const int of_term = kGroup * width_;
  std::fill(sums + terms.first * of_term, sums + terms.end * of_term, 0.0);
  const Kernel kernel = (width_ == 1 && lanes() == 1 ? kernels_.neighbours : kernels_.walls)[pass];
  kernel(bank.tables, layout_.chunks[pass][chunk], sums);
  double* works = &bank.works[pass][chunk * kTerms * static_cast<std::size_t>(width_)];
  for (int term = terms.first; term < terms.end; ++term)
    for (int wall = 0; wall < width_; ++wall) {
      double sum = 0;
      for (int k = 0; k < kGroup; ++k) sum += sums[term * of_term + k * width_ + wall];
      works[term * width_ + wall] = sum;
    }
}

void Processor::run(Pass pass) {
  const auto chunks = static_cast<int>(layout_.chunks[pass].size());
  if (chunks == 0) return;
  for (Bank& bank : bank_) {
    if (chunks == 1)
      run_chunk(pass, bank, 0);
    else
      workers_.for_each_chunk(chunks,
                              [&](int c) { run_chunk(pass, bank, static_cast<std::size_t>(c)); });
  }
}

void Processor::store_state(int lane, State& state) const {
  const Wall& wall = wall_[lane];
  store_lane(layout_, wall.view.t, static_cast<int>(wall.view.lane), *wall.model, state);
  if (free_) free_->store_state(state);
}

void Processor::update_free_contacts() {
  if (!free_ || wall_[0].model == nullptr || !(wall_[0].controls.dt > 0)) return;
  free_->act(*wall_[0].state, wall_[0].controls.dt, wall_[0].controls.dashpots, wall_[0].view,
             workers_);
}

void Processor::drive() {
  for (int lane = 0; lane < lanes(); ++lane) {
    Wall& wall = wall_[lane];
    wall.reaction = 0;
    if (wall.controls.push == nullptr) continue;
    State& s = *wall.state;
    WallWork work{s.energy.work_drive, s.energy.work_damping, s.energy.work_loads};
    wall.reaction =
        drive_blocks(drive_of(*wall.controls.push), view(lane), wall.controls.drive_velocity, work);
    s.energy.work_drive = work.drive;
    s.energy.work_damping = work.damping;
    s.energy.work_loads = work.loads;
    s.progress.drive_displacement += wall.controls.dt * wall.controls.drive_velocity;
  }
}

void Processor::end_step() {
  for (int lane = 0; lane < lanes(); ++lane) {
    const Wall& wall = wall_[lane];
    if (wall.model == nullptr) continue;
    double* const ledger[kTerms] = {
        &wall.state->energy.dissipated_friction, &wall.state->energy.dissipated_fracture,
        &wall.state->energy.dissipated_crushing, &wall.state->energy.work_loads,
        &wall.state->energy.work_damping};
    for (const Pass pass : {kJoints, kEdges, kBlocks, kNodes}) {
      const std::vector<double>& works = bank_of(lane).works[pass];
      const std::size_t chunk = kTerms * static_cast<std::size_t>(width_);
      for (int term = terms_of(pass).first; term < terms_of(pass).end; ++term) {
        double sum = *ledger[term];
        for (std::size_t k = term * width_ + lane % width_; k < works.size(); k += chunk)
          sum += works[k];
        *ledger[term] = sum;
      }
    }
    if (free_) free_->moved(*wall.state, wall.controls.dt, wall.view);
    if (wall.controls.dashpots != nullptr && layout_.damped > 0)
      wall.state->energy.work_damping +=
          dashpot_work(layout_, wall.view, *wall.model, wall.controls.dt);
    advance_clock(*wall.state, wall.controls);
  }
}

}  // namespace wythe::dynamics
