// Hundreds of walls side by side in the memory of a device: one thread a wall and entity.
//
// The tables are those of walls in lanes with as many lanes as walls, so that neighbouring threads read
// neighbouring numbers. A step is about a dozen launches (device_kernels.h); stages, ramps and rows stay
// with the host, which sends some numbers a wall before a step and takes four after it. What it asks
// between steps is answered by one thread a wall, in the host's order of terms.
//
// `Device` is where memory and threads are (device_memory.h): a graphics processor (gpu.cu), or this
// processor for the tests.
#pragma once

#include <array>

#include "contact/parameters.h"
#include "dynamics/executors/device_kernels.h"
#include "dynamics/executors/device_memory.h"
#include "dynamics/executors/executor.h"

namespace wythe::dynamics {

template <class Device>
class DeviceExecutor final : public Executor {
 public:
  DeviceExecutor(const Model& model, int walls, Device device = {});
  ~DeviceExecutor() override {
    device_.release(loads_);
    device_.release(driven_);
    device_.release(share_);
  }

  [[nodiscard]] int lanes() const override { return walls_; }
  [[nodiscard]] const Model& model() const override { return model_; }
  void put(int lane, const Model& model, State& state) override;
  void drop(int lane) override;
  [[nodiscard]] std::unique_ptr<WallAccess> access(int lane) override;
  void set(int lane, const Controls& controls) override;
  [[nodiscard]] double reaction(int lane) const override { return answer_.here[at(lane)]; }
  // Walls enter when their count of steps is in phase with the others', so that the host asks about
  // all of them after the same step.
  [[nodiscard]] bool takes_part(int lane) const override;

 private:
  static constexpr int kPhase = 800;  // of 8, 32 and 50 (recorder.cpp, stage_run.cpp: kSettleEvery)
  struct Wall {
    const Model* model = nullptr;
    State* state = nullptr;
    Controls controls;
    bool steps = false;                     // has entered: takes part in every step
    std::array<double, kTerms> then{};      // the ledger when it took its lane [J]
    std::vector<std::size_t> first_driven;  // of each stage, in driven_
    std::size_t first_load = 0;             // in loads_
    int n_load = 0;
  };
  class DeviceWallAccess;

  static std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] std::size_t of(int lane, std::int64_t row) const {
    return at(row) * at(walls_) + at(lane);
  }
  void begin_step() override;
  void run(Pass pass) override;
  void drive() override;
  void end_step() override;

  template <class P>
  void run_chunk(Pass pass, const Chunk& chunk);
  [[nodiscard]] device::Works works_of(Pass pass);
  void list_stages();
  void copy_column(int lane, bool out);
  [[nodiscard]] double answer_to(int lane, device::Ask ask);
  void aim(int lane, double px, double py);
  void watch(int lane, BlockId i, double px, double py);
  void forget() { fresh_.assign(device::kAsks, -1); }  // what was answered
  void copy_out(int lane, State& state);
  [[nodiscard]] WallView view() const { return view_of(layout_, model_, there_, 0); }

  const Model model_;
  const int walls_;
  Device device_;
  const Layout layout_;
  Memory memory_;  // of one wall, here: what a lane takes and gives
  Tables here_;
  Shared<Device, double> shared_, own_, flat_;
  Shared<Device, std::int32_t> ids_;
  Shared<Device, ZoneShape> shapes_;
  Shared<Device, std::uint8_t> ways_;
  Tables there_;  // of all walls, in the device's memory
  Shared<Device, double> joint_works_, block_works_, sums_;
  std::vector<double> wall_;  // (kWallRows, walls)
  Shared<Device, double> load_scale_, answer_, asked_, aim_, watch_;
  Shared<Device, device::WallStage> stage_;
  std::vector<Wall> walls_here_;
  device::StageLoad* loads_ = nullptr;  // of all walls, on the device
  BlockId* driven_ = nullptr;
  double* share_ = nullptr;
  std::int64_t count_ = 0;
  std::vector<std::int64_t> fresh_;  // step after which answers were taken (kAsks)
};

// --- memory --------------------------------------------------------------------------------------

template <class Device>
DeviceExecutor<Device>::DeviceExecutor(const Model& model, int walls, Device device)
    : model_(model),
      walls_(walls),
      device_(std::move(device)),
      layout_(model, Layout::kWalls),
      here_(make_tables(layout_, model_, 1, memory_)),
      shared_(device_, memory_.shared.size()),
      own_(device_, memory_.own.size() * at(walls), false),
      flat_(device_, memory_.own.size()),
      ids_(device_, memory_.ids.size()),
      shapes_(device_, memory_.shapes.size()),
      ways_(device_, memory_.ways.size() * at(walls), false),
      joint_works_(device_, 3 * at(layout_.joints + layout_.edges) * at(walls)),
      block_works_(device_, 2 * at(layout_.blocks + layout_.nodes) * at(walls)),
      sums_(device_, 3 * device::SumWorks::kParts),
      wall_(kWallRows * at(walls)),
      load_scale_(device_, model.stages.size() * at(walls)),
      answer_(device_, device::kAnswers * at(walls)),
      asked_(device_, device::kAsks * at(walls)),
      aim_(device_, 2 * at(walls)),
      watch_(device_, 3 * at(walls)),
      stage_(device_, at(walls)),
      walls_here_(at(walls)) {
  there_.lanes = walls;
  there_.n_block = layout_.blocks;
  point_tables(layout_, there_, shared_.there, own_.there, ids_.there, shapes_.there, ways_.there);
  shared_.here = memory_.shared;
  ids_.here = memory_.ids;
  shapes_.here = memory_.shapes;
  shared_.send();
  ids_.send();
  shapes_.send();
  forget();
  const State rest = initial_state(model_);
  for (int lane = 0; lane < walls_; ++lane) {
    put_wall(layout_, here_, 0, model_, rest);
    copy_column(lane, false);
    set(lane, {});
  }
}

// One lane of what each wall has for itself, from or to the tables here.
template <class Device>
void DeviceExecutor<Device>::copy_column(int lane, bool out) {
  flat_.here.swap(memory_.own);
  if (!out) flat_.send();
  device_.run(flat_.here.size(), 1, device::Column{own_.there, flat_.there, walls_, lane, out});
  if (out) flat_.fetch();
  flat_.here.swap(memory_.own);
}

template <class Device>
device::Works DeviceExecutor<Device>::works_of(Pass pass) {
  const bool joints = pass == kJoints || pass == kEdges;
  double* rows = joints ? joint_works_.there : block_works_.there;
  if (pass == kEdges) rows += 3 * at(layout_.joints) * at(walls_);
  if (pass == kNodes) rows += 2 * at(layout_.blocks) * at(walls_);
  return {rows, joints ? 3 : 2, walls_};
}

// --- a wall comes, is asked and goes -------------------------------------------------------------

template <class Device>
void DeviceExecutor<Device>::put(int lane, const Model& model, State& s) {
  Wall& wall = walls_here_[at(lane)] = {};
  wall.model = &model;
  wall.state = &s;
  wall.then = {s.dissipated_friction, s.dissipated_fracture, s.dissipated_crushing, s.work_loads,
               s.work_damping};
  set(lane, {});
  list_stages();
  put_wall(layout_, here_, 0, model, s);
  copy_column(lane, false);
  const Lines<std::uint8_t> ways(memory_.ways.size() * at(walls_));  // none is known to be whole
  device_.upload(ways_.there, ways.data(), ways.size());
  ids_.here = memory_.ids;  // blocks that this wall loads or drives
  ids_.send();
  for (std::size_t row = 0; row < device::kAnswers; ++row)
    answer_.here[of(lane, row)] = row == 1 ? s.work_drive : 0;
  answer_.send();
  for (const auto& [pass, n] : {std::pair{kJoints, layout_.joints + layout_.edges},
                                std::pair{kBlocks, layout_.blocks + layout_.nodes}}) {
    const device::Works works = works_of(pass);
    Shared<Device, double> none(device_, at(works.terms) * at(n));
    none.send();
    device_.run(none.here.size(), 1, device::Column{works.rows, none.there, walls_, lane, false});
  }
  forget();
}

// Loads and driven blocks of all walls' stages, one list after the other.
template <class Device>
void DeviceExecutor<Device>::list_stages() {
  std::vector<device::StageLoad> loads(1);  // never empty
  std::vector<BlockId> driven(1);
  std::vector<double> share(1);
  for (Wall& wall : walls_here_) {
    if (wall.model == nullptr) continue;
    wall.first_load = loads.size();
    wall.first_driven.clear();
    int number = 0;
    for (const Stage& stage : wall.model->stages) {
      for (const PointLoad& load : stage.loads) loads.push_back({load, number});
      ++number;
      wall.first_driven.push_back(driven.size());
      driven.insert(driven.end(), stage.driven.begin(), stage.driven.end());
      share.insert(share.end(), stage.driven_share.begin(), stage.driven_share.end());
    }
    wall.n_load = static_cast<int>(loads.size() - wall.first_load);
  }
  device_.release(loads_);
  device_.release(driven_);
  device_.release(share_);
  loads_ = device_.template allocate<device::StageLoad>(loads.size());
  driven_ = device_.template allocate<BlockId>(driven.size());
  device_.upload(loads_, loads.data(), loads.size());
  share_ = device_.template allocate<double>(share.size());
  device_.upload(driven_, driven.data(), driven.size());
  device_.upload(share_, share.data(), share.size());
}

template <class Device>
void DeviceExecutor<Device>::copy_out(int lane, State& state) {
  const Wall& wall = walls_here_[at(lane)];
  copy_column(lane, true);
  read_wall(layout_, here_, 0, *wall.model, state);
  constexpr int kParts = device::SumWorks::kParts;
  const auto sum = [&](Pass pass, std::int64_t n, int first, double from_drive) {
    device_.run(kParts, 1, device::SumWorks{works_of(pass), at(n), lane, sums_.there});
    sums_.fetch();
    for (int term = 0; term < works_of(pass).terms; ++term) {
      double all = 0;
      for (int k = 0; k < kParts; ++k) all += sums_.here[at(term * kParts + k)];
      // works of driven blocks come with the drive: loads, then damping
      if (pass == kBlocks) all += answer_.here[of(lane, term == 0 ? 3 : 2)] * from_drive;
      if (pass == kBlocks && term == 0) all += answer_.here[of(lane, 5)];
      if (pass == kJoints && term == 0) all += answer_.here[of(lane, 4)];
      double* const ledger[kTerms] = {&state.dissipated_friction, &state.dissipated_fracture,
                                      &state.dissipated_crushing, &state.work_loads,
                                      &state.work_damping};
      *ledger[first + term] = wall.then[at(first + term)] + all;
    }
  };
  sum(kJoints, layout_.joints + layout_.edges, kFriction, 0);
  sum(kBlocks, layout_.blocks + layout_.nodes, kLoads, 1);
}

template <class Device>
void DeviceExecutor<Device>::drop(int lane) {
  copy_out(lane, *walls_here_[at(lane)].state);
  walls_here_[at(lane)] = {};
  set(lane, {});
}

template <class Device>
double DeviceExecutor<Device>::answer_to(int lane, device::Ask ask) {
  // all walls are asked at once: they are in phase, and one thread takes as long as many
  if (fresh_[at(ask)] != count_) {
    device_.run(1, walls_, device::LookAt{view(), aim_.there, watch_.there, asked_.there, ask});
    asked_.fetch();
    fresh_[at(ask)] = count_;
    if (ask == device::kDistance) fresh_[device::kFurthest] = count_;
  }
  return asked_.here[of(lane, ask)];
}

template <class Device>
class DeviceExecutor<Device>::DeviceWallAccess final : public WallAccess {
 public:
  DeviceWallAccess(DeviceExecutor& executor, int lane) : x_(executor), lane_(lane) {}

  [[nodiscard]] double unbalance_ratio() const override {
    return x_.answer_to(lane_, device::kUnbalance);
  }
  [[nodiscard]] double kinetic_energy(double mass_scaling) const override {
    return x_.answer_to(lane_, device::kKinetic) * mass_scaling;
  }
  [[nodiscard]] double base_shear(const Vec3& along) const override {
    x_.aim(lane_, along.x, along.y);
    return x_.answer_to(lane_, device::kShear);
  }
  [[nodiscard]] BlockId runaway_block() const override {
    return static_cast<BlockId>(x_.answer_to(lane_, device::kRunaway));
  }
  [[nodiscard]] Furthest furthest_block() const override {
    const double distance = x_.answer_to(lane_, device::kDistance);
    return {distance, static_cast<BlockId>(x_.answer_to(lane_, device::kFurthest))};
  }
  [[nodiscard]] double moved(BlockId i, const Vec3& along) const override {
    x_.watch(lane_, i, along.x, along.y);
    return x_.answer_to(lane_, device::kMoved);
  }
  void choose_driven(const std::vector<BlockId>& blocks) override {
    x_.copy_column(lane_, true);
    dynamics::choose_driven(view_of(x_.layout_, x_.model_, x_.here_, 0), blocks);
    x_.copy_column(lane_, false);
    x_.forget();
  }
  void bring_up(State& state) const override { x_.copy_out(lane_, state); }

 private:
  DeviceExecutor& x_;
  int lane_;
};

template <class Device>
std::unique_ptr<WallAccess> DeviceExecutor<Device>::access(int lane) {
  return std::make_unique<DeviceWallAccess>(*this, lane);
}

// The direction in which a wall's base shear is asked for; the device learns it at once.
template <class Device>
void DeviceExecutor<Device>::aim(int lane, double px, double py) {
  double &x = aim_.here[of(lane, 0)], &y = aim_.here[of(lane, 1)];
  if (x == px && y == py) return;
  x = px, y = py;
  fresh_[device::kShear] = -1;
  aim_.send();
}

// The block and direction in which a wall's motion is asked for.
template <class Device>
void DeviceExecutor<Device>::watch(int lane, BlockId i, double px, double py) {
  double* row[3] = {&watch_.here[of(lane, 0)], &watch_.here[of(lane, 1)],
                    &watch_.here[of(lane, 2)]};
  if (*row[0] == px && *row[1] == py && *row[2] == i) return;
  *row[0] = px, *row[1] = py, *row[2] = i;
  fresh_[device::kMoved] = -1;
  watch_.send();
}

// --- the step ------------------------------------------------------------------------------------

template <class Device>
bool DeviceExecutor<Device>::takes_part(int lane) const {
  const Wall& wall = walls_here_[at(lane)];
  return wall.steps || (count_ - wall.state->step) % kPhase == 0;
}

template <class Device>
void DeviceExecutor<Device>::set(int lane, const Controls& c) {
  Wall& wall = walls_here_[at(lane)];
  device::WallStage& stage = stage_.here[at(lane)];
  const bool same = wall.controls.dt == c.dt && wall.controls.mass_scaling == c.mass_scaling;
  stage = {};
  stage.new_rates = !same || c.dt == 0;
  stage.velocity = c.drive_velocity;
  stage.mass_scaling = c.mass_scaling;
  wall.controls = c;
  wall.steps = c.dt > 0;
  const State* state = wall.state;
  const double rows[kWallRows] = {c.dt, c.damping, state == nullptr ? 0.0 : state->gravity_x,
                                  state == nullptr ? 0.0 : state->gravity_y, time_before(c)};
  for (int row = 0; row < kWallRows; ++row) wall_[of(lane, row)] = rows[row];
  for (std::size_t k = 0; k < model_.stages.size(); ++k)
    load_scale_.here[of(lane, static_cast<std::int64_t>(k))] =
        state == nullptr ? 0.0 : state->load_scale[k];
  if (wall.model == nullptr) return;
  stage.links_set = links_set(*wall.model, *state);
  stage.loads = loads_ + wall.first_load;
  stage.n_load = wall.n_load;
  if (c.push == nullptr) return;
  stage.drive = drive_of(*c.push);
  const std::size_t first = wall.first_driven[at(c.push - wall.model->stages.data())];
  stage.drive.driven = driven_ + first;
  stage.drive.share = share_ + first;
}

template <class Device>
void DeviceExecutor<Device>::begin_step() {
  device_.upload(there_.wall, wall_.data(), wall_.size());
  stage_.send();
  load_scale_.send();
  device_.run(1, walls_, device::SetRates{view(), stage_.there});
  device_.run(1, walls_, device::PlaceLoads{view(), stage_.there, load_scale_.there});
  if (model_.links.n > 0)
    device_.run(1, walls_, device::PullLinks{view(), stage_.there, answer_.there});
}

template <class Device>
template <class P>
void DeviceExecutor<Device>::run_chunk(Pass pass, const Chunk& chunk) {
  device_.run(at(chunk.end - chunk.begin), walls_,
              device::RunPass<P>{there_, chunk, works_of(pass)});
}

template <class Device>
void DeviceExecutor<Device>::run(Pass pass) {
  using A = device::Access;
  for (const Chunk& chunk : layout_.chunks[pass]) {
    if (pass == kZones) run_chunk<Zones<A>>(pass, chunk);
    if (pass == kBlocks) run_chunk<Blocks<A>>(pass, chunk);
    if (pass == kNodes) run_chunk<Nodes<A>>(pass, chunk);
    if (pass != kJoints && pass != kEdges) continue;
    contact::with_variant(chunk.choice, [&](auto chosen) {
      using V = decltype(chosen);
      if (pass == kEdges) return run_chunk<Edges<V, A>>(pass, chunk);
      if (chunk.on_ground) return run_chunk<Joints<V, true, 0, A>>(pass, chunk);
      if (chunk.at_ends) return run_chunk<Joints<V, false, 2, A>>(pass, chunk);
      run_chunk<Joints<V, false, 0, A>>(pass, chunk);
    });
  }
}

template <class Device>
void DeviceExecutor<Device>::drive() {
  device_.run(1, walls_, device::DriveWalls{view(), stage_.there, answer_.there});
  answer_.fetch();
}

template <class Device>
void DeviceExecutor<Device>::end_step() {
  ++count_;
  for (std::size_t lane = 0; lane < walls_here_.size(); ++lane) {
    Wall& wall = walls_here_[lane];
    if (wall.model == nullptr || !wall.steps) continue;
    wall.state->work_drive = answer_.here[at(walls_) + lane];
    if (wall.controls.push != nullptr)
      wall.state->drive_displacement += wall.controls.dt * wall.controls.drive_velocity;
    advance_clock(*wall.state, wall.controls);
  }
}

}  // namespace wythe::dynamics
