// The pass over free contacts of one wall, in its plane or in space: finds them, hands joints over to them, and
// adds their forces to the blocks (docs/theory/contacts.md). Called after the joints and before the blocks.
//
//   every step       each pair of parts that may touch: face, overlap, friction -> force on both bodies
//   every kLookEvery whether a pair's joints have given way, and whether another face has become the contact's
//   when due         which pairs may touch (near_pairs.h)
//
// A pair that is apart by s sleeps until the fastest body can have moved by s / 2; that changes no bit.
// What a restart needs goes into the State by bring_up(). What depends on the dimension is in Bodies:
// PlaneBodies (plane_bodies.h), SpaceBodies (dynamics/space/space_bodies.h).
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/meeting.h"
#include "core/parallel.h"
#include "core/rotation.h"
#include "dynamics/passes/near_pairs.h"
#include "model/free_shapes.h"
#include "wythe/model.h"

namespace wythe::dynamics {

inline constexpr int kLookEvery = 64;  // steps between looks at joints and at faces of contacts
// After such a way nothing is left of what a hand-over could not give to the contact: over the size of a block; [rad].
inline constexpr double kForgottenSlip = 0.05, kForgottenTurn = 0.05;

// Force on a body and moment about its centroid.
struct Push {
  Vector<double> f{0, 0, 0}, m{0, 0, 0};
};
[[nodiscard]] inline Push operator+(const Push& a, const Push& b) { return {a.f + b.f, a.m + b.m}; }

// Two parts that may touch.
struct FreePair {
  FreeContact memory;
  contact::FreeLaw law{};
  bool touches = false;
  // of this step
  Push on_a{}, on_b{};
  double pressed = 0;   // normal force [N]
  double stored = 0;    // energy [J]
  double slid = 0;      // plastic slip [m]
  double friction = 0;  // works [J]
  double lost = 0;
};
// Energy of the elastic slip [J].
[[nodiscard]] inline double shear_energy(const FreeContact& m, const contact::FreeLaw& law) {
  return 0.5 * law.ks * m.area * (m.slip_x * m.slip_x + m.slip_y * m.slip_y + m.slip_z * m.slip_z);
}

template <class Bodies>
class FreeContacts {
 public:
  using View = typename Bodies::View;

  FreeContacts(const Model& model, const typename Bodies::Layout& layout);

  // A wall takes its place with the contacts and hand-overs of its state.
  void put(const State& state, const View& wall);
  void bring_up(State& state) const;
  // Forces at the present poses, into the wall's rows for free contacts; works into the ledger.
  void act(State& state, double dt, const View& wall, Workers& workers);
  // After the blocks have moved.
  void moved(double dt, const View& wall);

  // How much of a dead load still presses its block.
  [[nodiscard]] double load_share(BlockId block, const View& wall) const {
    return load_left(bodies_.height_of(block), bodies_.fall_of(block, wall)) *
           load_followed(bodies_.height_of(block), bodies_.fall_of(block, wall),
                         -bodies_.rates_of(block, wall).f.y);
  }

  [[nodiscard]] int candidates() const { return static_cast<int>(pairs_.size()); }
  [[nodiscard]] int searches() const { return searches_; }

 private:
  // Two bodies with joints between them: numbers first to end - 1 of joint_of_.
  struct Jointed {
    std::int32_t a, b;  // a < b
    std::int32_t first, end;
    bool handed_over;
  };

  void search(const View& wall);
  [[nodiscard]] const Jointed* jointed(std::int32_t a, std::int32_t b) const;
  [[nodiscard]] std::span<FreePair> pairs_of(std::int32_t a, std::int32_t b);
  void meet(std::size_t number, double dt, bool looks, const View& wall);
  static void part_company(FreePair& pair);
  void sum_up(State& state, const View& wall);
  [[nodiscard]] std::vector<std::size_t> find_hand_overs(const View& wall);
  void hand_over(State& state, const Jointed& pair, const View& wall);
  void rest_on_crushed(FreePair& pair, const Vector<double>& on_a, const View& wall) const;
  void fade_hand_overs(State& state, double dt, const View& wall);
  void apply(const HandOver& h, const View& wall);

  static std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }
  static auto key_of(const FreeContact& c) { return std::tie(c.a, c.b, c.part_a, c.part_b); }
  template <class P>
  static std::pair<std::int32_t, std::int32_t> bodies_of(const P& p) {
    return {p.a, p.b};
  }

  const Model& model_;
  Bodies bodies_;
  std::vector<JointId> joint_of_;
  std::vector<Jointed> jointed_;  // sorted by bodies

  std::vector<FreePair> pairs_;     // sorted by bodies and parts
  std::vector<double> wake_;        // travel at which each may touch
  std::vector<std::size_t> awake_;  // those of this step, in order
  std::vector<HandOver> hand_overs_;
  double travel_ = 0;  // what no body can have moved farther than, since the last search [m]
  bool searched_ = false;
  bool acts_ = true;  // rows of forces are not all zero
  int searches_ = 0;
};

// --- who may touch --------------------------------------------------------------------------------------

template <class Bodies>
FreeContacts<Bodies>::FreeContacts(const Model& model, const typename Bodies::Layout& layout)
    : model_(model), bodies_(model, layout) {
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
auto FreeContacts<Bodies>::jointed(std::int32_t a, std::int32_t b) const -> const Jointed* {
  const auto found =
      std::lower_bound(jointed_.begin(), jointed_.end(), std::pair(a, b),
                       [](const Jointed& p, const auto& wanted) { return bodies_of(p) < wanted; });
  return found != jointed_.end() && bodies_of(*found) == std::pair(a, b) ? &*found : nullptr;
}

template <class Bodies>
std::span<FreePair> FreeContacts<Bodies>::pairs_of(std::int32_t a, std::int32_t b) {
  const auto first = std::lower_bound(
      pairs_.begin(), pairs_.end(), std::pair(a, b),
      [](const FreePair& p, const auto& wanted) { return bodies_of(p.memory) < wanted; });
  auto end = first;
  while (end != pairs_.end() && bodies_of(end->memory) == std::pair(a, b)) ++end;
  return {first, end};
}

template <class Bodies>
void FreeContacts<Bodies>::put(const State& state, const View& wall) {
  bodies_.restore(wall);
  for (Jointed& pair : jointed_) {
    pair.handed_over = state.handed_over[at(joint_of_[at(pair.first)])] != 0;
    for (auto k = pair.first; pair.handed_over && k < pair.end; ++k)
      bodies_.release(joint_of_[at(k)], wall);
  }
  pairs_.clear();
  for (const FreeContact& memory : state.free_contacts)
    pairs_.push_back(
        {.memory = memory, .law = bodies_.law_of(memory.a, memory.b), .touches = memory.area > 0});
  wake_.assign(pairs_.size(), 0.0);
  hand_overs_ = state.hand_overs;
  travel_ = 0;
  searched_ = false;
  acts_ = true;
}

template <class Bodies>
void FreeContacts<Bodies>::bring_up(State& state) const {
  state.free_contacts.clear();
  for (const FreePair& pair : pairs_)
    if (pair.touches || pair.memory.rest > 0) state.free_contacts.push_back(pair.memory);
  state.hand_overs = hand_overs_;
  for (const Jointed& pair : jointed_)
    for (auto k = pair.first; k < pair.end; ++k)
      state.handed_over[at(joint_of_[at(k)])] = pair.handed_over ? 1.0 : 0.0;
}

template <class Bodies>
void FreeContacts<Bodies>::search(const View& wall) {
  const std::int32_t bodies = model_.n_block + model_.free.n_fixed;
  std::vector<Box> boxes;
  for (std::int32_t body = 0; body < bodies; ++body) boxes.push_back(bodies_.box_of(body, wall));
  const auto parts = [&](std::int32_t body) {
    return model_.free.part_begin[at(body) + 1] - model_.free.part_begin[at(body)];
  };
  std::vector<FreePair> found;
  for (const auto& [a, b] : near_pairs(boxes, model_.n_block, bodies_.margin())) {
    if (const Jointed* joints = jointed(a, b); joints != nullptr && !joints->handed_over) continue;
    const contact::FreeLaw law = bodies_.law_of(a, b);
    for (std::int32_t i = 0; i < parts(a); ++i)
      for (std::int32_t j = 0; j < parts(b); ++j)
        found.push_back(
            {.memory = {.a = a, .b = b, .part_a = i, .part_b = j, .feature = contact::kNoFeature},
             .law = law});
  }
  // what is known of those that were there before
  auto old = pairs_.begin();
  for (FreePair& pair : found) {
    while (old != pairs_.end() && key_of(old->memory) < key_of(pair.memory)) ++old;
    if (old != pairs_.end() && key_of(old->memory) == key_of(pair.memory)) pair = *old;
  }
  pairs_ = std::move(found);
  wake_.assign(pairs_.size(), 0.0);
  travel_ = 0;
  searched_ = true;
  ++searches_;
}

template <class Bodies>
void FreeContacts<Bodies>::moved(double dt, const View& wall) {
  double most = 0;
  for (int i = 0; i < model_.n_block; ++i) {
    const double speed = bodies_.speed_of(i, wall);
    most = speed <= most ? most : speed;  // what is no number stays
  }
  travel_ += 1.05 * dt * most;  // damping by mass may have slowed blocks since they moved
}

// --- two parts ------------------------------------------------------------------------------------------

template <class Bodies>
void FreeContacts<Bodies>::part_company(FreePair& pair) {
  pair.friction += shear_energy(pair.memory, pair.law);
  pair.touches = false;
  pair.memory.area = pair.memory.slip_x = pair.memory.slip_y = pair.memory.slip_z = 0;
  pair.pressed = pair.stored = 0;
}

template <class Bodies>
void FreeContacts<Bodies>::meet(std::size_t number, double dt, bool looks, const View& wall) {
  FreePair& pair = pairs_[number];
  FreeContact& m = pair.memory;
  const typename Bodies::Meeting meeting = bodies_.meeting(m, wall);
  const auto sleep = [&](double distance) { wake_[number] = travel_ + 0.5 * distance; };
  // Nothing presses before the parts come closer by `room`; out of each other they are when they part by the rest
  // of it. What was crushed then counts no more.
  const auto rest = [&](double room) {
    if (pair.touches) part_company(pair);
    if (m.rest == 0) return sleep(room);
    const double inside = m.rest - room;
    if (inside <= 0) m.rest = 0;
    sleep(inside > 0 ? minimum(room, inside) : -inside);
  };
  pair.friction = pair.lost = pair.slid = 0;

  typename Bodies::Overlap overlap{};
  const bool known = m.feature != contact::kNoFeature;
  if (known) overlap = bodies_.overlap(meeting, m.feature, m.rest);
  if (known && overlap.lowest > 0) return rest(overlap.lowest);  // along the last face
  if (!pair.touches || looks || !(overlap.cover > 0)) {
    const bool stays = pair.touches && overlap.cover > 0;
    const contact::Face face = bodies_.face(meeting, stays ? m.feature : contact::kNoFeature);
    if (face.distance + m.rest >= 0) {
      m.feature = face.feature;
      return rest(face.distance + m.rest);
    }
    if (face.feature != m.feature) {
      const double before = overlap.energy;
      overlap = bodies_.overlap(meeting, face.feature, m.rest);
      if (pair.touches) {  // the contact goes on over another face
        pair.lost += bodies_.stiffness(pair.law) * (before - overlap.energy);
        pair.friction += bodies_.turn_slip(pair, meeting, face.feature);
      }
      m.feature = face.feature;
    }
  }
  if (!(overlap.cover > 0)) {  // passes beside the face
    if (pair.touches) part_company(pair);
    return sleep(0);
  }
  pair.touches = true;
  bodies_.rub(pair, meeting, overlap, dt, wall);
}

// --- the step -------------------------------------------------------------------------------------------

template <class Bodies>
void FreeContacts<Bodies>::act(State& state, double dt, const View& wall, Workers& workers) {
  constexpr int kPairChunk = 256;
  if (!(travel_ < 1e300)) return;  // the wall runs away, which others say
  const bool looks = state.step % kLookEvery == 0;
  std::vector<std::size_t> gave_way;
  if (looks) gave_way = find_hand_overs(wall);
  if (!searched_ || travel_ > bodies_.margin() || !gave_way.empty()) search(wall);
  awake_.clear();
  for (std::size_t k = 0; k < wake_.size(); ++k)
    if (wake_[k] <= travel_) awake_.push_back(k);
  const auto chunks = static_cast<int>((awake_.size() + kPairChunk - 1) / kPairChunk);
  workers.for_each_chunk(chunks, [&](int chunk) {
    const std::size_t end = std::min(awake_.size(), at(chunk + 1) * kPairChunk);
    for (std::size_t n = at(chunk) * kPairChunk; n < end; ++n) meet(awake_[n], dt, looks, wall);
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
  for (const std::size_t number : awake_) {  // those asleep neither touch nor rub
    FreePair& pair = pairs_[number];
    if (pair.friction != 0 || pair.lost != 0) {
      state.dissipated_friction += pair.friction;
      state.lost_in_hand_over += pair.lost;
      pair.friction = pair.lost = 0;
    }
    if (!pair.touches) continue;
    bodies_.add(pair.memory.a, pair.memory.b, pair.on_a, pair.on_b, wall);
    acts_ = true;
  }
}

// --- from joints to free contacts -----------------------------------------------------------------------

// All joints of a pair at once: those that still hold keep the others.
template <class Bodies>
std::vector<std::size_t> FreeContacts<Bodies>::find_hand_overs(const View& wall) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < jointed_.size(); ++k) {
    Jointed& pair = jointed_[k];
    bool gives = false;
    for (auto n = pair.first; !pair.handed_over && n < pair.end; ++n)
      gives = gives || bodies_.gives_way(joint_of_[at(n)], wall);
    for (auto n = pair.first; gives && n < pair.end; ++n)
      gives = !bodies_.holds(joint_of_[at(n)], wall);
    if (!gives) continue;
    pair.handed_over = true;
    found.push_back(k);
  }
  return found;
}

// Where a joint was crushed the blocks overlap by more than they press: as much of it rests as makes the contact press
// with the joint's normal force.
template <class Bodies>
void FreeContacts<Bodies>::rest_on_crushed(FreePair& pair, const Vector<double>& on_a,
                                           const View& wall) const {
  constexpr int kHalvings = 60;
  const typename Bodies::Meeting meeting = bodies_.meeting(pair.memory, wall);
  const std::int32_t feature = pair.memory.feature;
  const double wanted = -dot(on_a, bodies_.normal_of(meeting, feature));
  const auto presses = [&](double rest) {
    return bodies_.stiffness(pair.law) * bodies_.pressing(bodies_.overlap(meeting, feature, rest));
  };
  if (presses(0) <= wanted) return;
  double low = 0, high = -bodies_.overlap(meeting, feature, 0).lowest;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (presses(middle) > wanted ? low : high) = middle;
  }
  pair.memory.rest = high;
}

// What the joints gave in this step and the free contact does not, stays as a force that fades.
template <class Bodies>
void FreeContacts<Bodies>::hand_over(State& state, const Jointed& pair, const View& wall) {
  Push before, after;
  double energy = 0, pressed = 0;
  for (auto k = pair.first; k < pair.end; ++k) {
    before = before + bodies_.push_of(joint_of_[at(k)], pair.a, wall);
    energy += bodies_.elastic_energy(joint_of_[at(k)], wall);
    bodies_.release(joint_of_[at(k)], wall);
  }
  const std::span<FreePair> contacts = pairs_of(pair.a, pair.b);
  for (const FreePair& p : contacts) pressed += p.pressed;
  double bears = 0;
  for (FreePair& p : contacts) {
    if (!p.touches) continue;
    const auto again = [&] { meet(at(&p - pairs_.data()), 0.0, false, wall); };
    const Vector<double> share = (p.pressed / pressed) * before.f;
    rest_on_crushed(p, share, wall);
    again();
    if (!p.touches) continue;
    bodies_.take_over_shear(p, share, wall);
    again();
    after = after + p.on_a;
    energy -= p.stored;
    bears += p.pressed;
  }
  state.lost_in_hand_over += energy;
  if (!(bears > 0)) return;  // the joint's force stood on nothing
  const Vector<double> f = bodies_.into(pair.a, before.f - after.f, wall);
  const Vector<double> m = bodies_.into(pair.a, before.m - after.m, wall);
  const HandOver rest{pair.a, pair.b, 1, bears, f.x, f.y, f.z, m.x, m.y, m.z};
  const auto place = std::lower_bound(
      hand_overs_.begin(), hand_overs_.end(), rest,
      [](const HandOver& p, const HandOver& q) { return bodies_of(p) < bodies_of(q); });
  apply(*hand_overs_.insert(place, rest), wall);
}

template <class Bodies>
void FreeContacts<Bodies>::apply(const HandOver& h, const View& wall) {
  const Push a{
      bodies_.out_of(h.a, h.share * Vector<double>{h.force_x, h.force_y, h.force_z}, wall),
      bodies_.out_of(h.a, h.share * Vector<double>{h.moment_x, h.moment_y, h.moment_z}, wall)};
  const Vector<double> arm = bodies_.place_of(h.a, wall) - bodies_.place_of(h.b, wall);
  bodies_.add(h.a, h.b, a, {-1.0 * a.f, -1.0 * (a.m + cross(arm, a.f))}, wall);
  acts_ = true;
}

// Less of each as its contact unloads, and as the bodies slide or turn on each other: the difference belongs to the poses
// in which they were handed over. What it works goes into the ledger.
template <class Bodies>
void FreeContacts<Bodies>::fade_hand_overs(State& state, double dt, const View& wall) {
  for (HandOver& h : hand_overs_) {
    double pressed = 0;
    for (const FreePair& pair : pairs_of(h.a, h.b)) pressed += pair.pressed;
    // b is carried to the centroid of a, where the force acts
    const Vector<double> arm = bodies_.place_of(h.a, wall) - bodies_.place_of(h.b, wall);
    const Push va = bodies_.rates_of(h.a, wall), vb = bodies_.rates_of(h.b, wall);
    const Vector<double> slides = va.f - (vb.f + cross(vb.m, arm)), turns = va.m - vb.m;
    const double moved =
        square_root(dot(slides, slides)) / (kForgottenSlip * bodies_.size_of(h.a)) +
        square_root(dot(turns, turns)) / kForgottenTurn;
    const double share = minimum(h.share - dt * moved, pressed / h.pressed);
    const double mean = 0.5 * (h.share + maximum(share, 0.0));
    const Vector<double> f =
        bodies_.out_of(h.a, mean * Vector<double>{h.force_x, h.force_y, h.force_z}, wall);
    const Vector<double> m =
        bodies_.out_of(h.a, mean * Vector<double>{h.moment_x, h.moment_y, h.moment_z}, wall);
    state.lost_in_hand_over -= dt * (dot(f, slides) + dot(m, turns));
    h.share = share;
  }
  std::erase_if(hand_overs_, [](const HandOver& h) { return !(h.share > 0); });
  for (const HandOver& h : hand_overs_) apply(h, wall);
}

}  // namespace wythe::dynamics
