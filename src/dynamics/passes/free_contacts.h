// The pass over free contacts of one wall, in its plane or in space: finds them, hands joints over to them, and
// adds their forces to the blocks (docs/theory/contacts.md). Called after the joints and before the blocks.
//
//   every step           each pair of parts that may touch: face, overlap, friction -> force on both bodies
//   every kRecheckEvery  whether a pair's joints have failed, and whether the contact has another face now
//   when due             which pairs may touch (near_pairs.h)
//
// A pair at distance s sleeps. First, until the straight paths of its two bodies and their deviations
// have used up s. Later, as long as the bodies have moved and turned against each other by less.
// Sleeping changes no bit. store_state() puts what a restart needs into the State. Bodies holds what
// depends on the dimension: PlaneBodies (plane_bodies.h), SpaceBodies (dynamics/space/space_bodies.h).
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/convex_contact.h"
#include "core/parallel.h"
#include "core/rotation.h"
#include "dynamics/executors/executor.h"
#include "dynamics/passes/contact_dashpots.h"
#include "dynamics/passes/near_pairs.h"
#include "model/free_shapes.h"
#include "wythe/parts/model.h"

namespace wythe::dynamics {

inline constexpr int kRecheckEvery = 64;  // steps between checks of joints and of faces of contacts
// The search margin around a body covers its path in this number of steps at the present speed.
inline constexpr int kSearchAhead = 16;
// A hand-over force has faded to zero after this slip (over the size of a block) or this turn [rad].
inline constexpr double kForgottenSlip = 0.05, kForgottenTurn = 0.05;

// Force on a body and moment about its centroid. For rates: velocity and spin.
struct ForceMoment {
  Vector<double> f{0, 0, 0}, m{0, 0, 0};
};
[[nodiscard]] inline ForceMoment operator+(const ForceMoment& a, const ForceMoment& b) {
  return {a.f + b.f, a.m + b.m};
}

// Two parts that may touch; it fills four lines of a cache.
struct alignas(64) FreePair {
  FreeContact memory;
  contact::FreeLaw law{};  // set when the parts touch
  // results of this step
  ForceMoment on_a{}, on_b{};
  double pressed = 0;   // normal force [N]
  double stored = 0;    // energy [J]
  double friction = 0;  // works [J]
  double lost = 0;
  [[nodiscard]] bool touches() const { return memory.area > 0; }
};
static_assert(sizeof(FreePair) == 256);
// The share of dashpots in on_a and on_b; velocities of a and b before the blocks move.
struct DampedPair {
  ForceMoment viscous_a{}, viscous_b{};
  ForceMoment rates_a{}, rates_b{};
};
// Bounds for the motion of a body.
struct Travel {
  double turned = 0;              // by rotation alone, since the wall was loaded [m]
  Vector<double> place{0, 0, 0};  // of its centroid
  Vector<double> rate{0, 0, 0};   // of its centroid, at the last search [m/s]
};
// Energy of the elastic slip [J].
[[nodiscard]] inline double shear_energy(const FreeContact& m, const contact::FreeLaw& law) {
  return 0.5 * law.ks * m.area * (m.slip_x * m.slip_x + m.slip_y * m.slip_y + m.slip_z * m.slip_z);
}

template <class Bodies>
class FreeContacts {
 public:
  using View = typename Bodies::View;

  // `width` of the packs in which the wall's joints lie.
  FreeContacts(const Model& model, const typename Bodies::Layout& layout, int width);

  // Loads a wall with the contacts and hand-overs of its state.
  void load_state(const State& state, const View& wall);
  void store_state(State& state) const;
  // Forces in the present poses, into the wall's rows for free contacts; works into the ledger. `dashpots` may be null.
  void act(State& state, double dt, const Dashpots* dashpots, const View& wall, Workers& workers);
  // Called after the blocks have moved.
  void moved(State& state, double dt, const View& wall);

  // The share of a dead load that still presses its block.
  [[nodiscard]] double load_share(BlockId block, const View& wall) const {
    return load_left(bodies_.height_of(block), bodies_.fallen_height(block, wall)) *
           load_followed(bodies_.height_of(block), bodies_.fallen_height(block, wall),
                         -bodies_.rates_of(block, wall).f.y);
  }

  [[nodiscard]] int n_near() const { return static_cast<int>(near_.size()); }

 private:
  // Two bodies with joints between them: numbers first to end - 1 of joint_of_.
  struct Jointed {
    std::int32_t a, b;  // a < b
    std::int32_t first, end;
    bool handed_over;
  };

  // Two parts whose bodies have overlapping boxes.
  struct NearPair {
    std::int32_t a, b, part_a, part_b;
    std::int32_t slot;  // in pairs_; -1: none, because it neither presses nor has a history
    std::int32_t feature = contact::kNoFeature;  // of the last update
    // The parts were `apart` when b was at `offset` from a and both had turned by
    // `turned`. They cannot touch before they have come closer by this distance [m].
    double apart = 0, turned = 0;
    Vector<double> offset{0, 0, 0};
  };
  // How long a pair sleeps, checked in every step. It cannot touch before both deviations from the
  // straight paths sum up to `until` [m], less the distance that the speed `closing` [m/s] has used up.
  struct WakeLimit {
    std::int32_t a, b;
    double until = 0, closing = 0;
  };
  // Sets how long a pair at `distance` sleeps.
  void let_sleep(WakeLimit& wake_limit, double distance) const {
    constexpr double kMore = 1 + 1e-9;  // for rounding
    const Vector<double> v = travel_[wake_limit.b].rate - travel_[wake_limit.a].rate;
    wake_limit.closing = kMore * square_root(dot(v, v));
    wake_limit.until = deviation_of(wake_limit) + distance + wake_limit.closing * since_search_;
  }
  [[nodiscard]] double deviation_of(const WakeLimit& w) const {
    return deviation_[w.a] + deviation_[w.b];
  }
  [[nodiscard]] double left_of(const WakeLimit& w) const {
    return w.until - w.closing * since_search_ - deviation_of(w);
  }

  void add_travel(double dt, const View& wall);
  void reset_travel() {
    std::fill(travelled_.begin(), travelled_.end(), 0.0);
    std::fill(deviation_.begin(), deviation_.end(), 0.0);
    since_search_ = 0;
  }
  [[nodiscard]] std::vector<NearPair> find_near(double dt, const View& wall);
  void search(double dt, const View& wall);
  [[nodiscard]] bool stays_asleep(const NearPair& near, WakeLimit& wake_limit) const;
  void assign_slot(NearPair& near);
  void release_slot(NearPair& near);
  void wake(const View& wall, Workers& workers);
  [[nodiscard]] FreePair& pair_of(const NearPair& near) { return pairs_[near.slot]; }
  [[nodiscard]] std::span<NearPair> near_of(std::int32_t a, std::int32_t b);
  [[nodiscard]] double pressed_by(std::span<const NearPair> contacts) const {
    double sum = 0;
    for (const NearPair& near : contacts) sum += near.slot >= 0 ? pairs_[near.slot].pressed : 0.0;
    return sum;
  }
  // Pairs lie scattered in memory. This fetches a pair needed soon after awake_[n] into the cache meanwhile.
  void fetch_ahead(std::size_t n) const {
    constexpr std::size_t kAhead = 6, kLine = 64;
    if (n + kAhead >= awake_.size()) return;
    const auto* pair = reinterpret_cast<const char*>(&pairs_[near_[awake_[n + kAhead]].slot]);
    for (std::size_t line = 0; line < sizeof(FreePair); line += kLine)
      __builtin_prefetch(pair + line, 1);
  }
  void update_pairs(std::size_t first, std::size_t end, double dt, bool rechecks);
  void update_pair(std::size_t number, double dt, bool rechecks);
  static void separate(FreePair& pair);
  void damp_pair(FreePair& pair, DampedPair& damped, double area_before,
                 const typename Bodies::SlipUpdate& slip_update, double dt) const;
  void clear_maxwell();
  void sum_up(State& state, const View& wall);
  [[nodiscard]] std::vector<std::size_t> find_hand_overs(const View& wall);
  void hand_over(State& state, const Jointed& pair, const View& wall);
  void rest_on_crushed(FreePair& pair, const Vector<double>& on_a) const;
  void fade_hand_overs(State& state, double dt, const View& wall);
  void apply(const HandOver& h, const View& wall);

  template <class P>
  static auto key_of(const P& p) {
    return std::tie(p.a, p.b, p.part_a, p.part_b);
  }
  template <class P>
  static std::pair<std::int32_t, std::int32_t> bodies_of(const P& p) {
    return {p.a, p.b};
  }

  const Model& model_;
  Bodies bodies_;
  std::vector<JointId> joint_of_;
  std::vector<Jointed> jointed_;  // sorted by bodies

  std::vector<NearPair> near_;          // sorted by bodies and parts
  std::vector<WakeLimit> wake_limits_;  // of each near pair
  std::vector<FreePair> pairs_;         // only where a slot was assigned
  std::vector<DampedPair> damped_;      // of each slot, where there are dashpots
  std::vector<std::int32_t> spare_;     // free slots of pairs_
  std::vector<std::size_t> awake_;      // indices in near_ of the pairs of this step, in order
  std::vector<std::int32_t> in_play_;   // their bodies, each once
  std::vector<std::uint8_t> is_in_play_;
  std::vector<HandOver> hand_overs_;
  std::vector<Travel> travel_;  // of each body
  // For each body since the last search: how far its points can have moved,
  // and how far its centroid can have left the straight path of that time [m].
  std::vector<double> travelled_, deviation_;
  std::vector<double> margin_;          // search margin of each body [m]
  double since_search_ = 0, rounding_;  // [s]; rounding error of a place in a step [m]
  bool searched_ = false, needs_search_ = false, finite_ = true, damped_before_ = true;
  bool acts_ = true;                    // some row of forces is not zero
  const Dashpots* dashpots_ = nullptr;  // of this step
};

// --- who may touch --------------------------------------------------------------------------------------

template <class Bodies>
FreeContacts<Bodies>::FreeContacts(const Model& model, const typename Bodies::Layout& layout,
                                   int width)
    : model_(model),
      bodies_(model, layout, width),
      is_in_play_(static_cast<std::size_t>(model.n_block + model.free.n_fixed), 0),
      travel_(is_in_play_.size()),
      travelled_(is_in_play_.size(), 0.0),
      deviation_(is_in_play_.size(), 0.0),
      margin_(is_in_play_.size(), 0.0) {
  const FreeShapes& f = model.free;
  double far = 0;
  for (const double edge : {f.x0, f.x1, f.y0, f.y1, f.z0, f.z1})
    far = maximum(far, magnitude(edge));
  rounding_ = 4e-16 * far;
  std::vector<std::tuple<std::int32_t, std::int32_t, JointId>> joints;
  for (JointId j = 0; j < model.n_joint; ++j)
    if (const auto [a, b] = bodies_.sides_of(j); b >= 0) joints.emplace_back(a, b, j);
  std::sort(joints.begin(), joints.end());
  for (const auto& [a, b, j] : joints) {
    const auto n = static_cast<std::int32_t>(joint_of_.size());
    if (jointed_.empty() || bodies_of(jointed_.back()) != std::pair(a, b))
      jointed_.push_back({a, b, n, n, false});
    joint_of_.push_back(j);
    jointed_.back().end = n + 1;
  }
}

template <class Bodies>
auto FreeContacts<Bodies>::near_of(std::int32_t a, std::int32_t b) -> std::span<NearPair> {
  const auto first =
      std::lower_bound(near_.begin(), near_.end(), std::pair(a, b),
                       [](const NearPair& p, const auto& wanted) { return bodies_of(p) < wanted; });
  auto end = first;
  while (end != near_.end() && bodies_of(*end) == std::pair(a, b)) ++end;
  return std::span(near_).subspan(first - near_.begin(), static_cast<std::size_t>(end - first));
}

template <class Bodies>
void FreeContacts<Bodies>::load_state(const State& state, const View& wall) {
  bodies_.restore(wall);
  for (Jointed& pair : jointed_) {
    pair.handed_over = state.handed_over[joint_of_[pair.first]] != 0;
    for (auto k = pair.first; pair.handed_over && k < pair.end; ++k)
      bodies_.release(joint_of_[k], wall);
  }
  bodies_.end_release(wall);
  near_.clear(), wake_limits_.clear(), pairs_.clear(), spare_.clear(), awake_.clear();
  for (const FreeContact& memory : state.free_contacts) {
    const auto& [a, b, part_a, part_b] = key_of(memory);
    near_.push_back({a, b, part_a, part_b, static_cast<std::int32_t>(pairs_.size())});
    wake_limits_.push_back({a, b});
    pairs_.push_back({.memory = memory, .law = bodies_.law_of(memory.a, memory.b)});
  }
  add_travel(0, wall);
  reset_travel();
  hand_overs_ = state.hand_overs;
  searched_ = needs_search_ = false;
  finite_ = acts_ = true;
}

template <class Bodies>
void FreeContacts<Bodies>::store_state(State& state) const {
  state.free_contacts.clear();
  for (const NearPair& near : near_) {
    if (near.slot < 0) continue;
    const FreePair& pair = pairs_[near.slot];
    if (pair.touches() || pair.memory.rest > 0) state.free_contacts.push_back(pair.memory);
  }
  state.hand_overs = hand_overs_;
  for (const Jointed& pair : jointed_)
    for (auto k = pair.first; k < pair.end; ++k)
      state.handed_over[joint_of_[k]] = pair.handed_over ? 1.0 : 0.0;
}

template <class Bodies>
void FreeContacts<Bodies>::moved(State& state, double dt, const View& wall) {
  double power = 0;
  for (std::size_t n = 0; dashpots_ != nullptr && n < awake_.size(); ++n) {
    const NearPair& near = near_[awake_[n]];
    if (near.slot < 0 || !pair_of(near).touches()) continue;
    const FreePair& pair = pair_of(near);
    const DampedPair& damped = damped_[near.slot];
    const auto on = [&](std::int32_t body, const ForceMoment& push, const ForceMoment& before) {
      const ForceMoment now = bodies_.rates_of(body, wall);
      power += 0.5 * (dot(push.f, before.f + now.f) + dot(push.m, before.m + now.m));
    };
    on(pair.memory.a, damped.viscous_a, damped.rates_a);
    on(pair.memory.b, damped.viscous_b, damped.rates_b);
  }
  if (power != 0) state.energy.work_damping += dt * power;
  since_search_ += dt;
  add_travel(dt, wall);
}

template <class Bodies>
void FreeContacts<Bodies>::assign_slot(NearPair& near) {
  if (near.slot >= 0) return;
  if (spare_.empty()) {
    spare_.push_back(static_cast<std::int32_t>(pairs_.size()));
    pairs_.emplace_back();
  }
  near.slot = spare_.back();
  spare_.pop_back();
  FreePair& pair = pair_of(near);
  pair.memory = {near.a, near.b, near.part_a, near.part_b, near.feature};
  pair.pressed = pair.stored = pair.friction = pair.lost = 0;
}

template <class Bodies>
void FreeContacts<Bodies>::release_slot(NearPair& near) {
  if (near.slot < 0) return;
  near.feature = pair_of(near).memory.feature;
  spare_.push_back(near.slot);
  near.slot = -1;
}

// --- two parts ------------------------------------------------------------------------------------------

template <class Bodies>
void FreeContacts<Bodies>::separate(FreePair& pair) {
  pair.friction += shear_energy(pair.memory, pair.law);
  pair.memory.area = pair.memory.slip_x = pair.memory.slip_y = pair.memory.slip_z = 0;
  pair.memory.maxwell_n = pair.memory.maxwell_x = pair.memory.maxwell_y = pair.memory.maxwell_z = 0;
  pair.pressed = pair.stored = 0;
}

template <class Bodies>
void FreeContacts<Bodies>::update_pair(std::size_t number, double dt, bool rechecks) {
  NearPair& near = near_[number];
  WakeLimit& wake_limit = wake_limits_[number];
  FreePair& pair = pair_of(near);
  FreeContact& m = pair.memory;
  const typename Bodies::PairGeometry pair_geometry = bodies_.pair_geometry(m);
  const auto sleep = [&](double distance) {
    const Travel &a = travel_[m.a], &b = travel_[m.b];
    near.apart = distance;
    near.offset = b.place - a.place;
    near.turned = a.turned + b.turned;
    let_sleep(wake_limit, distance);
  };
  wake_limit.until = near.apart = 0;
  // The parts have a distance `room` along the face, less what was crushed (`rest`). Nothing presses
  // before they come closer by `room`. When they part by more than `rest`, the crushed depth is forgotten.
  const auto rest = [&](double room) {
    if (pair.touches()) separate(pair);
    if (m.rest == 0) return sleep(room);
    const double inside = m.rest - room;
    if (inside <= 0) m.rest = 0;
    sleep(inside > 0 ? minimum(room, inside) : -inside);
  };
  pair.friction = pair.lost = 0;
  if (dashpots_ != nullptr) damped_[near.slot] = {};

  typename Bodies::Overlap overlap{};
  const bool known = m.feature != contact::kNoFeature;
  if (known) overlap = bodies_.overlap(pair_geometry, m.feature, m.rest);
  if (known && overlap.lowest > 0) return rest(overlap.lowest);  // along the last face
  if (!pair.touches() || rechecks || !(overlap.cover > 0)) {
    const bool stays = pair.touches() && overlap.cover > 0;
    const contact::Face face = bodies_.face(pair_geometry, stays ? m.feature : contact::kNoFeature);
    if (face.distance + m.rest >= 0) {
      m.feature = face.feature;
      return rest(face.distance + m.rest);
    }
    if (face.feature != m.feature) {
      const double before = overlap.energy;
      overlap = bodies_.overlap(pair_geometry, face.feature, m.rest);
      if (pair.touches()) {  // the contact goes on over another face
        pair.lost += bodies_.stiffness(pair.law) * (before - overlap.energy);
        pair.friction += bodies_.turn_slip(pair, pair_geometry, face.feature);
        m.maxwell_x = m.maxwell_y = m.maxwell_z = 0;
      }
      m.feature = face.feature;
    }
  }
  if (!(overlap.cover > 0)) {  // passes beside the face
    if (pair.touches()) separate(pair);
    return sleep(0);
  }
  if (!pair.touches()) pair.law = bodies_.law_of(m.a, m.b);
  const double before = m.area;
  const typename Bodies::SlipUpdate slip_update =
      bodies_.update_slip(pair, pair_geometry, overlap, dt);
  if (dashpots_ != nullptr && dt > 0) damp_pair(pair, damped_[near.slot], before, slip_update, dt);
}

// Takes pairs that stay on their faces in packs, and the others one by one.
template <class Bodies>
void FreeContacts<Bodies>::update_pairs(std::size_t first, std::size_t end, double dt,
                                        bool rechecks) {
  typename Bodies::Packed packed;
  const auto press = [&] {
    bodies_.press(packed, dt);
    for (int k = 0; k < packed.n; ++k)
      if (!bodies_.take(packed, k, pair_of(near_[packed.number[k]])))
        update_pair(packed.number[k], dt, false);
    packed.n = 0;
  };
  const bool in_packs = !rechecks && dashpots_ == nullptr;
  for (std::size_t n = first; n < end; ++n) {
    fetch_ahead(n);
    const FreePair& pair = pair_of(near_[awake_[n]]);
    if (!in_packs || !pair.touches() || !bodies_.add_to(packed, pair)) {
      update_pair(awake_[n], dt, rechecks);
      continue;
    }
    packed.number[packed.n++] = awake_[n];
    if (packed.n == kGroup) press();
  }
  if (packed.n > 0) press();
}

template <class Bodies>
void FreeContacts<Bodies>::damp_pair(FreePair& pair, DampedPair& damped, double area_before,
                                     const typename Bodies::SlipUpdate& slip_update,
                                     double dt) const {
  FreeContact& m = pair.memory;
  const double a = bodies_.inverse_mass(m.a), b = bodies_.inverse_mass(m.b);
  const ViscousForce f = damp_contact({pair.law.kn * m.area, pair.law.ks * m.area, pair.pressed,
                                       slip_update.held, slip_update.opened, slip_update.slid,
                                       1 / (a + b), bodies_.mobility(m, slip_update), area_before},
                                      *dashpots_, pair.law.tan_friction, dt, m);
  bodies_.spread(f, slip_update, m.feature >= 0, damped.viscous_a, damped.viscous_b);
  pair.on_a = pair.on_a + damped.viscous_a;
  pair.on_b = pair.on_b + damped.viscous_b;
  damped.rates_a = bodies_.rates_now(m.a);
  damped.rates_b = bodies_.rates_now(m.b);
}

// --- the step -------------------------------------------------------------------------------------------

template <class Bodies>
void FreeContacts<Bodies>::act(State& state, double dt, const Dashpots* dashpots, const View& wall,
                               Workers& workers) {
  constexpr int kPairChunk = 256;
  dashpots_ = dashpots;
  clear_maxwell();
  if (!finite_) return;  // the wall runs away; the stage reports that
  const bool rechecks = state.step % kRecheckEvery == 0;
  std::vector<std::size_t> gave_way;
  if (rechecks) gave_way = find_hand_overs(wall);
  if (!searched_ || needs_search_ || !gave_way.empty()) search(dt, wall);
  wake(wall, workers);
  if (dashpots_ != nullptr) damped_.resize(pairs_.size());
  const auto chunks = static_cast<int>((awake_.size() + kPairChunk - 1) / kPairChunk);
  workers.for_each_chunk(chunks, [&](int chunk) {
    update_pairs(static_cast<std::size_t>(chunk) * kPairChunk,
                 std::min(awake_.size(), static_cast<std::size_t>(chunk + 1) * kPairChunk), dt,
                 rechecks);
  });
  if (acts_) bodies_.clear_rows(wall);
  acts_ = false;
  fade_hand_overs(state, dt, wall);
  for (const std::size_t pair : gave_way) hand_over(state, jointed_[pair], wall);
  if (!gave_way.empty()) bodies_.end_release(wall);
  sum_up(state, wall);
}

template <class Bodies>
void FreeContacts<Bodies>::sum_up(State& state, const View& wall) {
  for (std::size_t n = 0; n < awake_.size(); ++n) {  // those asleep neither touch nor rub
    fetch_ahead(n);
    NearPair& near = near_[awake_[n]];
    FreePair& pair = pair_of(near);
    if (pair.friction != 0 || pair.lost != 0) {
      state.energy.dissipated_friction += pair.friction;
      state.energy.lost_in_hand_over += pair.lost;
      pair.friction = pair.lost = 0;
    }
    if (!pair.touches()) {
      if (pair.memory.rest == 0) release_slot(near);
      continue;
    }
    bodies_.add(pair.memory.a, pair.memory.b, pair.on_a, pair.on_b, wall);
    acts_ = true;
  }
}

}  // namespace wythe::dynamics

#include "dynamics/passes/hand_overs.h"
#include "dynamics/passes/waking.h"
