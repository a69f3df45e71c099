// One step of hundreds of walls side by side in the memory of a device: one thread a wall and entity.
//
// The arrays are those of LaneStepper with as many lanes as walls, so that neighbouring threads read
// neighbouring numbers. A step is about a dozen launches (device_kernels.h); stages, ramps and rows stay
// with the host, which sends some numbers a wall before a step and takes four after it. What it asks
// between steps is answered by one thread a wall, in the host's order of terms.
//
// `Device` is where memory and threads are (device_memory.h): a graphics processor (gpu.cu), or this
// processor for the tests.
#pragma once

#include <cstring>

#include "contact/parameters.h"
#include "dynamics/device_kernels.h"
#include "dynamics/device_memory.h"
#include "dynamics/side_by_side.h"
#include "dynamics/step_arrays.h"

namespace wythe::dynamics {

template <class Device>
class DeviceStepper final : public SideBySide {
 public:
  DeviceStepper(const Model& model, int walls, Device device = {});
  ~DeviceStepper() override {
    device_.release(loads_);
    device_.release(driven_);
  }

  [[nodiscard]] int lanes() const override { return walls_; }
  [[nodiscard]] const Model& model() const override { return model_; }
  void put(int lane, const Model& model, State& state) override;
  void drop(int lane) override;
  [[nodiscard]] std::unique_ptr<Place> place(int lane) override;
  void set(int lane, const Controls& controls) override;
  void step() override;
  [[nodiscard]] double reaction(int lane) const override { return answer_[at(lane)]; }
  // Walls enter when their count of steps is in phase with the others', so that the host asks about
  // all of them after the same step.
  [[nodiscard]] bool takes_part(int lane) const override;

 private:
  static constexpr int kPhase = 800;  // of 8, 32 and 50 (recorder.cpp, stage_run.cpp: kSettleEvery)
  struct Wall {
    const Model* model = nullptr;
    State* state = nullptr;
    Controls controls;
    bool steps = false;  // has entered: takes part in every step
    // the ledger when it took its lane [J]
    double damping_then = 0, loads_then = 0;
    double friction_then = 0, fracture_then = 0, crushing_then = 0;
    std::vector<std::size_t> first_driven;  // of each stage, in driven_
    std::size_t first_load = 0;             // in loads_
    int n_load = 0;
  };
  class DevicePlace;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] std::size_t of(int lane, std::size_t row) const {
    return row * at(walls_) + at(lane);
  }
  void mirror_arrays();
  [[nodiscard]] JointArrays joints();
  [[nodiscard]] EdgeArrays edges();
  [[nodiscard]] BlockArrays blocks();
  [[nodiscard]] NodeArrays nodes();
  [[nodiscard]] MoveControls controls() const;
  [[nodiscard]] WallView view();
  [[nodiscard]] WallSizes sizes();
  [[nodiscard]] device::LawRows law() const {
    return {mirror_.there(law_.data()), mirror_.there(choice_.data()), walls_};
  }
  [[nodiscard]] device::WorkRows joint_work() {
    return {mirror_.there(joint_work_.data()), 3, walls_};
  }
  [[nodiscard]] device::WorkRows block_work() {
    return {mirror_.there(block_work_.data()), 2, walls_};
  }
  void joint_pass();
  void edge_pass();
  void turn_pass();
  void list_stages();
  void move_columns(int lane, const std::vector<std::vector<double>*>& arrays,
                    std::vector<double>& flat, bool out);
  [[nodiscard]] std::vector<std::vector<double>*> kept();
  [[nodiscard]] double answer_to(int lane, device::Ask ask);
  void aim(int lane, double px, double py);
  void forget() { fresh_.assign(device::kAsks, -1); }  // what was answered
  void copy_out(int lane, State& state);

  const Model model_;
  const int walls_;
  Device device_;
  Workspace work_;  // sizes and addresses; the numbers are the device's
  State all_;
  std::vector<double> mass_, heavy_mass_, inertia_, node_mass_, node_heavy_mass_;
  std::vector<double> law_, joint_work_, block_work_, rows_, answer_, asked_, flat_, sums_;
  std::vector<contact::LawChoice> choice_;
  std::vector<device::WallStage> stage_;
  Mirror<Device> mirror_;
  std::vector<Wall> wall_;
  device::StageLoad* loads_ = nullptr;  // of all walls, on the device
  BlockId* driven_ = nullptr;
  std::int64_t count_ = 0;
  std::vector<std::int64_t> fresh_;  // step after which answers were taken (kAsks)
};

// --- arrays --------------------------------------------------------------------------------------

template <class Device>
DeviceStepper<Device>::DeviceStepper(const Model& model, int walls, Device device)
    : model_(model),
      walls_(walls),
      device_(std::move(device)),
      work_(model, walls),
      all_(initial_state(model)),
      mirror_(device_),
      wall_(at(walls)) {
  const auto in_all = [&](const std::vector<double>& of_entity) {
    std::vector<double> all;
    for (const double value : of_entity) all.insert(all.end(), at(walls_), value);
    return all;
  };
  for (auto* array : kept()) array->assign(array->size() * at(walls_), 0.0);
  mass_ = in_all(model.mass);
  heavy_mass_ = in_all(model.heavy_mass);
  inertia_ = in_all(model.inertia);
  node_mass_ = in_all(model.solids.node_mass);
  node_heavy_mass_ = in_all(model.solids.node_heavy_mass);
  for (const JointMaterial& m : model.materials) choice_.push_back(contact::choice_of(m));
  law_.resize(model.materials.size() * device::kLawRows * at(walls_));
  joint_work_.resize(3 * at(model.n_joint + model.solids.n_contact) * at(walls_));
  block_work_.resize(2 * at(model.n_block + model.solids.n_node) * at(walls_));
  rows_.resize((device::kRows + model.stages.size()) * at(walls_));
  answer_.resize(4 * at(walls_));
  asked_.resize(device::kAsks * at(walls_));
  forget();
  stage_.resize(at(walls_));
  sums_.resize(5 * device::SumWork::kParts);
  std::size_t longest = 0;
  for (auto* array : kept()) longest += array->size() / at(walls_);
  flat_.resize(longest + law_.size() / at(walls_) + 8 * at(model.n_block + model.solids.n_node));
  for (int lane = 0; lane < walls_; ++lane) set(lane, {});
  mirror_arrays();
  turn_pass();
}

template <class Device>
void DeviceStepper<Device>::mirror_arrays() {
  const auto add = [&](const auto&... arrays) { (mirror_.add(arrays), ...); };
  const Model& m = model_;
  const Solids& z = m.solids;
  Workspace& w = work_;
  add(m.joint_a, m.joint_b, m.joint_material, m.arm_a_x, m.arm_a_y, m.arm_b_x, m.arm_b_y,
      m.tangent_x, m.tangent_y, m.area, m.point_xi, m.point_weight, m.block_begin, m.block_entry,
      m.turn_freedom);
  for (const auto& corner : z.corner) add(corner);
  add(z.zone_shape, z.shapes, z.contact_block, z.contact_p, z.contact_q, z.contact_material,
      z.share_0, z.share_1, z.arm_0_x, z.arm_0_y, z.arm_1_x, z.arm_1_y, z.contact_tangent_x,
      z.contact_tangent_y, z.contact_area, z.zone_begin, z.zone_entry, z.contact_begin,
      z.contact_entry, z.node_free_x, z.node_free_y);
  add(w.half_length, w.block_middle, w.pose, w.force, w.busy, w.contact_x, w.contact_y, w.contact_m,
      w.load_x, w.load_y, w.load_m, w.total_x, w.total_y, w.total_m, w.is_free, w.zone_force,
      w.contact_block_force, w.contact_edge_force, w.node_total_x, w.node_total_y);
  add(mass_, heavy_mass_, inertia_, node_mass_, node_heavy_mass_, law_, choice_, joint_work_,
      block_work_, rows_, answer_, asked_, flat_, sums_, stage_);
  for (const auto* array : kept()) add(*array);
  mirror_.add(kEdgeXi, 2);
  mirror_.add(kEdgeWeight, 2);
}

// Motion and history of all walls (kStateFields).
template <class Device>
std::vector<std::vector<double>*> DeviceStepper<Device>::kept() {
  std::vector<std::vector<double>*> arrays;
  for (const StateField& field : kStateFields) arrays.push_back(&(all_.*field.array));
  return arrays;
}

template <class Device>
JointArrays DeviceStepper<Device>::joints() {
  JointArrays v = joint_arrays(model_, work_, all_);
  mirror_.turn(v.a, v.b, v.arm_a_x, v.arm_a_y, v.arm_b_x, v.arm_b_y, v.tangent_x, v.tangent_y,
               v.half_length, v.area, v.xi, v.weight, v.pose, v.kappa, v.crush, v.plastic_slip,
               v.slip, v.shear_damage, v.tension_set, v.busy, v.force);
  return v;
}

template <class Device>
EdgeArrays DeviceStepper<Device>::edges() {
  EdgeArrays v = edge_arrays(model_, work_, all_, walls_);
  JointArrays& j = v.joint;
  mirror_.turn(j.area, j.xi, j.weight, j.pose, j.kappa, j.crush, j.plastic_slip, j.slip,
               j.shear_damage, j.tension_set, j.busy, v.block, v.p, v.q, v.share_0, v.share_1,
               v.arm_0_x, v.arm_0_y, v.arm_1_x, v.arm_1_y, v.tangent_x, v.tangent_y, v.ux, v.uy,
               v.block_force, v.edge_force);
  return v;
}

template <class Device>
BlockArrays DeviceStepper<Device>::blocks() {
  BlockArrays v = block_arrays(model_, work_, all_);
  v.mass = mass_.data();
  v.heavy_mass = heavy_mass_.data();
  v.inertia = inertia_.data();
  mirror_.turn(v.mass, v.heavy_mass, v.inertia, v.turn_freedom, v.is_free, v.contact_x, v.contact_y,
               v.contact_m, v.load_x, v.load_y, v.load_m, v.total_x, v.total_y, v.total_m, v.ux,
               v.uy, v.theta, v.vx, v.vy, v.omega, v.pose);
  return v;
}

template <class Device>
NodeArrays DeviceStepper<Device>::nodes() {
  NodeArrays v = node_arrays(model_.solids, work_, all_);
  v.mass = node_mass_.data();
  v.heavy_mass = node_heavy_mass_.data();
  mirror_.turn(v.mass, v.heavy_mass, v.free_x, v.free_y, v.total_x, v.total_y, v.ux, v.uy, v.vx,
               v.vy);
  return v;
}

template <class Device>
MoveControls DeviceStepper<Device>::controls() const {
  const double* rows = mirror_.there(rows_.data());
  const auto row = [&](device::Row r) { return rows + r * walls_; };
  return {row(device::kDt), row(device::kDamping), row(device::kScale), row(device::kGravityX),
          row(device::kGravityY)};
}

template <class Device>
WallView DeviceStepper<Device>::view() {
  WallView v = wall_view(work_, all_, walls_, 0);
  for (Strided* s :
       {&v.ux,      &v.uy,        &v.theta,        &v.vx,           &v.vy,
        &v.omega,   &v.contact_x, &v.contact_y,    &v.contact_m,    &v.load_x,
        &v.load_y,  &v.load_m,    &v.total_x,      &v.total_y,      &v.total_m,
        &v.is_free, &v.pose,      &v.force,        &v.node_ux,      &v.node_uy,
        &v.node_vx, &v.node_vy,   &v.node_total_x, &v.node_total_y, &v.contact_block_force})
    mirror_.turn(s->first);
  return v;
}

template <class Device>
WallSizes DeviceStepper<Device>::sizes() {
  WallSizes n = sizes_of(model_);
  mirror_.turn(n.contact_block);
  n.mass = {mirror_.there(mass_.data()), walls_};
  n.inertia = {mirror_.there(inertia_.data()), walls_};
  n.node_mass = {mirror_.there(node_mass_.data()), walls_};
  return n;
}

// --- a wall comes, is asked and goes -------------------------------------------------------------

// Moves one lane of arrays (host addresses of mirrored ones) from or to `flat`, in one launch.
template <class Device>
void DeviceStepper<Device>::move_columns(int lane, const std::vector<std::vector<double>*>& arrays,
                                         std::vector<double>& flat, bool out) {
  device::Columns c;
  c.walls = walls_;
  c.lane = lane;
  c.flat = mirror_.there(flat_.data());
  c.out = out;
  std::size_t n = 0;
  for (std::vector<double>* array : arrays) {
    if (array->empty()) continue;
    c.array[c.n] = mirror_.there(array->data());
    c.begin[c.n++] = n;
    n += array->size() / at(walls_);
  }
  c.begin[c.n] = n;
  if (n == 0) return;
  if (!out) device_.upload(c.flat, flat.data(), n);
  device_.run(n, 1, c);
  if (!out) return;
  flat.resize(n);
  device_.download(flat.data(), c.flat, n);
}

template <class Device>
void DeviceStepper<Device>::put(int lane, const Model& model, State& state) {
  Wall& wall = wall_[at(lane)] = {};
  wall.model = &model;
  wall.state = &state;
  wall.damping_then = state.work_damping;
  wall.loads_then = state.work_loads;
  wall.friction_then = state.dissipated_friction;
  wall.fracture_then = state.dissipated_fracture;
  wall.crushing_then = state.dissipated_crushing;
  set(lane, {});
  list_stages();

  std::vector<double> flat;
  const auto append = [&](const std::vector<double>& more) {
    flat.insert(flat.end(), more.begin(), more.end());
  };
  for (const StateField& field : kStateFields) append(state.*field.array);
  move_columns(lane, kept(), flat, false);

  flat.clear();
  for (const auto* array : {&model.mass, &model.heavy_mass, &model.inertia, &model.solids.node_mass,
                            &model.solids.node_heavy_mass})
    append(*array);
  append(std::vector<double>(3 * at(model.n_block), 0.0));
  for (const JointMaterial& material : model.materials) {
    const contact::LawConstants<double> constants = contact::constants_of(material);
    const std::size_t n = flat.size();
    flat.resize(n + device::kLawRows);
    std::memcpy(flat.data() + n, &constants, device::kLawRows * sizeof(double));
  }
  move_columns(lane,
               {&mass_, &heavy_mass_, &inertia_, &node_mass_, &node_heavy_mass_, &work_.load_x,
                &work_.load_y, &work_.load_m, &law_},
               flat, false);
  flat = {0, state.work_drive, 0, 0};
  for (std::size_t row = 0; row < 4; ++row) answer_[of(lane, row)] = flat[row];
  move_columns(lane, {&answer_}, flat, false);
  flat.assign((joint_work_.size() + block_work_.size()) / at(walls_), 0.0);
  move_columns(lane, {&joint_work_, &block_work_}, flat, false);
  turn_pass();
  forget();
}

// Loads and driven blocks of all walls' stages, one list after the other.
template <class Device>
void DeviceStepper<Device>::list_stages() {
  std::vector<device::StageLoad> loads(1);  // never empty
  std::vector<BlockId> driven(1);
  for (Wall& wall : wall_) {
    if (wall.model == nullptr) continue;
    wall.first_load = loads.size();
    wall.first_driven.clear();
    int number = 0;
    for (const Stage& stage : wall.model->stages) {
      for (const PointLoad& load : stage.loads) loads.push_back({load, number});
      ++number;
      wall.first_driven.push_back(driven.size());
      driven.insert(driven.end(), stage.driven.begin(), stage.driven.end());
    }
    wall.n_load = static_cast<int>(loads.size() - wall.first_load);
  }
  device_.release(loads_);
  device_.release(driven_);
  loads_ = device_.template allocate<device::StageLoad>(loads.size());
  driven_ = device_.template allocate<BlockId>(driven.size());
  device_.upload(loads_, loads.data(), loads.size());
  device_.upload(driven_, driven.data(), driven.size());
}

template <class Device>
void DeviceStepper<Device>::copy_out(int lane, State& state) {
  std::vector<double> flat;
  move_columns(lane, kept(), flat, true);
  auto from = flat.begin();
  for (const StateField& field : kStateFields) {
    std::copy_n(from, (state.*field.array).size(), (state.*field.array).begin());
    from += static_cast<std::ptrdiff_t>((state.*field.array).size());
  }
  const Wall& wall = wall_[at(lane)];
  const Solids& z = model_.solids;
  device_.run(device::SumWork::kParts, 1,
              device::SumWork{joint_work(), block_work(), at(model_.n_joint + z.n_contact),
                              at(model_.n_block + z.n_node), lane, mirror_.there(sums_.data())});
  device_.download(sums_.data(), mirror_.there(sums_.data()), sums_.size());
  const auto sum = [&](int row) {
    double all = 0;
    for (int k = 0; k < device::SumWork::kParts; ++k)
      all += sums_[at(row * device::SumWork::kParts + k)];
    return all;
  };
  state.dissipated_friction = wall.friction_then + sum(0);
  state.dissipated_fracture = wall.fracture_then + sum(1);
  state.dissipated_crushing = wall.crushing_then + sum(2);
  state.work_loads = wall.loads_then + sum(3) + answer_[of(lane, 3)];
  state.work_damping = wall.damping_then + sum(4) + answer_[of(lane, 2)];
}

template <class Device>
void DeviceStepper<Device>::drop(int lane) {
  copy_out(lane, *wall_[at(lane)].state);
  wall_[at(lane)] = {};
  set(lane, {});
}

template <class Device>
double DeviceStepper<Device>::answer_to(int lane, device::Ask ask) {
  // all walls are asked at once: they are in phase, and one thread takes as long as many
  if (fresh_[at(ask)] != count_) {
    double* answers = mirror_.there(asked_.data());
    device_.run(1, walls_,
                device::LookAt{view(), sizes(), mirror_.there(rows_.data()), answers, walls_, ask});
    for (const device::Ask row : {ask, ask == device::kDistance ? device::kFurthest : ask}) {
      const std::size_t first = of(0, at(row));
      device_.download(&asked_[first], answers + first, at(walls_));
      fresh_[at(row)] = count_;
    }
  }
  return asked_[of(lane, at(ask))];
}

template <class Device>
class DeviceStepper<Device>::DevicePlace final : public Place {
 public:
  DevicePlace(DeviceStepper& stepper, int lane) : s_(stepper), lane_(lane) {}

  [[nodiscard]] double unbalance_ratio() const override {
    return s_.answer_to(lane_, device::kUnbalance);
  }
  [[nodiscard]] double kinetic_energy(double mass_scaling) const override {
    return s_.answer_to(lane_, device::kKinetic) * mass_scaling;
  }
  [[nodiscard]] double base_shear(double px, double py) const override {
    s_.aim(lane_, px, py);
    return s_.answer_to(lane_, device::kShear);
  }
  [[nodiscard]] BlockId runaway_block() const override {
    return static_cast<BlockId>(s_.answer_to(lane_, device::kRunaway));
  }
  [[nodiscard]] Furthest furthest_block() const override {
    const double distance = s_.answer_to(lane_, device::kDistance);
    return {distance, static_cast<BlockId>(s_.answer_to(lane_, device::kFurthest))};
  }
  void choose_driven(const std::vector<BlockId>& blocks) override {
    std::vector<double> is_free(at(s_.model_.n_block), 1.0);
    for (const BlockId block : blocks) is_free[at(block)] = 0.0;
    s_.move_columns(lane_, {&s_.work_.is_free}, is_free, false);
    s_.forget();
  }
  void bring_up(State& state) const override { s_.copy_out(lane_, state); }

 private:
  DeviceStepper& s_;
  int lane_;
};

template <class Device>
std::unique_ptr<Place> DeviceStepper<Device>::place(int lane) {
  return std::make_unique<DevicePlace>(*this, lane);
}

// The direction in which a wall's base shear is asked for; the device learns it at once.
template <class Device>
void DeviceStepper<Device>::aim(int lane, double px, double py) {
  if (rows_[of(lane, device::kAimX)] == px && rows_[of(lane, device::kAimY)] == py) return;
  rows_[of(lane, device::kAimX)] = px;
  rows_[of(lane, device::kAimY)] = py;
  fresh_[device::kShear] = -1;
  device_.upload(mirror_.there(rows_.data()), rows_.data(), rows_.size());
}

// --- the step ------------------------------------------------------------------------------------

template <class Device>
bool DeviceStepper<Device>::takes_part(int lane) const {
  const Wall& wall = wall_[at(lane)];
  return wall.steps || (count_ - wall.state->step) % kPhase == 0;
}

template <class Device>
void DeviceStepper<Device>::set(int lane, const Controls& c) {
  Wall& wall = wall_[at(lane)];
  wall.controls = c;
  wall.steps = c.dt > 0;
  const auto put_row = [&](device::Row row, double value) { rows_[of(lane, row)] = value; };
  put_row(device::kDt, c.dt);
  put_row(device::kDamping, c.damping);
  put_row(device::kScale, c.mass_scaling);
  put_row(device::kVelocity, c.drive_velocity);
  const State* state = wall.state;
  put_row(device::kGravityX, state == nullptr ? 0.0 : state->gravity_x);
  put_row(device::kGravityY, state == nullptr ? 0.0 : state->gravity_y);
  for (std::size_t k = 0; k < model_.stages.size(); ++k)
    rows_[of(lane, device::kRows + k)] = state == nullptr ? 0.0 : state->load_scale[k];
  device::WallStage& stage = stage_[at(lane)] = {};
  if (wall.model == nullptr) return;
  stage.loads = loads_ + wall.first_load;
  stage.n_load = wall.n_load;
  if (c.push == nullptr) return;
  stage.drive = drive_of(*c.push);
  stage.drive.driven =
      driven_ + wall.first_driven[at(static_cast<int>(c.push - wall.model->stages.data()))];
}

template <class Device>
void DeviceStepper<Device>::joint_pass() {
  const JointArrays v = joints();
  const std::int32_t* material = mirror_.there(model_.joint_material.data());
  const auto at_begin = [&](const JointChunk& chunk) -> const JointMaterial& {
    return model_.materials[at(model_.joint_material[at(chunk.begin)])];
  };
  const auto& chunks = work_.joint_chunks;
  for (std::size_t c = 0; c < chunks.size();) {
    const JointChunk& first = chunks[c];
    const auto begin = at(first.begin);
    std::size_t end = begin;
    for (; c < chunks.size() && chunks[c].on_ground == first.on_ground &&
           contact::choice_of(at_begin(chunks[c])) == contact::choice_of(at_begin(first));
         ++c)
      end = at(chunks[c].end);
    contact::with_variant(contact::choice_of(at_begin(first)), [&](auto chosen) {
      using V = decltype(chosen);
      if (first.on_ground)
        device_.run(
            end - begin, walls_,
            device::Joints<V, true>{v, material, law(), joint_work(), controls().dt, begin});
      else
        device_.run(
            end - begin, walls_,
            device::Joints<V, false>{v, material, law(), joint_work(), controls().dt, begin});
    });
  }
}

template <class Device>
void DeviceStepper<Device>::edge_pass() {
  const Solids& z = model_.solids;
  const EdgeArrays v = edges();
  const std::int32_t* material = mirror_.there(z.contact_material.data());
  for (const JointChunk& chunk : work_.contact_chunks)
    contact::with_variant(
        contact::choice_of(model_.materials[at(z.contact_material[at(chunk.begin)])]),
        [&](auto chosen) {
          device_.run(
              at(chunk.end - chunk.begin), walls_,
              device::Edges<decltype(chosen)>{v, material, law(), joint_work(), controls().dt,
                                              at(chunk.begin), at(model_.n_joint)});
        });
}

template <class Device>
void DeviceStepper<Device>::turn_pass() {
  device_.run(at(model_.n_block), walls_, device::Turn{blocks(), walls_});
}

template <class Device>
void DeviceStepper<Device>::step() {
  const Solids& z = model_.solids;
  double* const rows = mirror_.there(rows_.data());
  double* const answer = mirror_.there(answer_.data());
  device::WallStage* const stage = mirror_.there(stage_.data());
  device_.upload(rows, rows_.data(), rows_.size());
  device_.upload(stage, stage_.data(), stage_.size());

  joint_pass();
  if (z.n_zone > 0) {
    ZoneArrays v = zone_arrays(z, work_, all_, walls_);
    for (auto& corner : v.corner) mirror_.turn(corner);
    mirror_.turn(v.ux, v.uy, v.low_force, v.high_force);
    device_.run(at(z.n_zone), walls_,
                device::Zones{v, mirror_.there(z.shapes.data()), mirror_.there(z.zone_shape.data()),
                              walls_});
    edge_pass();
  }
  GatherArrays gather = gather_arrays(model_, work_);
  mirror_.turn(gather.begin, gather.middle, gather.entry, gather.force, gather.contact_x,
               gather.contact_y, gather.contact_m);
  device_.run(at(model_.n_block), walls_, device::Gather{gather, walls_});
  device_.run(
      1, walls_,
      device::ContactsAndLoads{view(), mirror_.there(z.contact_block.data()), model_.n_block,
                               z.n_contact, stage, rows + device::kRows * walls_, walls_});
  device_.run(at(model_.n_block), walls_, device::Move{blocks(), controls(), block_work()});
  if (z.n_node > 0) {
    NodeSums sums = node_sums(z, work_);
    mirror_.turn(sums.zone_begin, sums.zone_entry, sums.contact_begin, sums.contact_entry,
                 sums.zone_force, sums.edge_force, sums.total_x, sums.total_y);
    device_.run(at(z.n_node), walls_,
                device::Nodes{nodes(), sums, controls(), block_work(), at(model_.n_block)});
  }
  device_.run(1, walls_, device::DriveWalls{view(), sizes(), stage, rows, answer, walls_});
  turn_pass();
  device_.download(answer_.data(), answer, answer_.size());

  ++count_;
  for (std::size_t lane = 0; lane < wall_.size(); ++lane) {
    Wall& wall = wall_[lane];
    if (wall.model == nullptr || !wall.steps) continue;
    wall.state->work_drive = answer_[at(walls_) + lane];
    if (wall.controls.push != nullptr)
      wall.state->drive_displacement += wall.controls.dt * wall.controls.drive_velocity;
    advance_clock(*wall.state, wall.controls);
  }
}

}  // namespace wythe::dynamics
