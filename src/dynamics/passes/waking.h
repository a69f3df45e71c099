// Which pairs of free contacts are updated in a step: the search for near pairs, how far bodies have moved since, and
// which pairs sleep meanwhile (docs/theory/contacts.md). A part of free_contacts.h, which includes it.
#pragma once

#include "dynamics/passes/free_contacts.h"

namespace wythe::dynamics {

// All parts of all bodies whose boxes overlap, widened by their margins, except pairs whose joints still hold.
template <class Bodies>
auto FreeContacts<Bodies>::find_near(double dt, const View& wall) -> std::vector<NearPair> {
  std::vector<Box> boxes;
  for (std::int32_t body = 0; body < static_cast<std::int32_t>(travel_.size()); ++body) {
    const double speed = body < model_.n_block ? bodies_.speed_of(body, wall) : 0.0;
    const double margin = bodies_.margin() + kSearchAhead * dt * speed;
    boxes.push_back(bodies_.box_of(body, wall));
    for (double& low : boxes.back().low) low -= margin;
    for (double& high : boxes.back().high) high += margin;
    margin_[body] = margin;
  }
  const auto parts = [&](std::int32_t body) {
    return model_.free.part_begin[static_cast<std::size_t>(body) + 1] -
           model_.free.part_begin[body];
  };
  std::vector<NearPair> found;
  found.reserve(near_.size());
  auto joints = jointed_.begin();
  for (const auto& pair : near_pairs(boxes, model_.n_block, 0.0)) {
    while (joints != jointed_.end() && bodies_of(*joints) < pair) ++joints;
    if (joints != jointed_.end() && bodies_of(*joints) == pair && !joints->handed_over) continue;
    const auto [a, b] = pair;
    for (std::int32_t i = 0; i < parts(a); ++i)
      for (std::int32_t j = 0; j < parts(b); ++j) found.push_back({a, b, i, j, -1});
  }
  return found;
}

template <class Bodies>
void FreeContacts<Bodies>::search(double dt, const View& wall) {
  std::vector<NearPair> found = find_near(dt, wall);
  std::vector<WakeLimit> wake_limit;
  wake_limit.reserve(found.size());
  for (const NearPair& near : found) wake_limit.push_back({near.a, near.b});
  // keeps the data of pairs that were near before
  std::size_t next = 0;
  for (std::size_t k = 0; k < near_.size(); ++k) {
    NearPair& old = near_[k];
    while (next < found.size() && key_of(found[next]) < key_of(old)) ++next;
    if (next < found.size() && key_of(found[next]) == key_of(old)) {
      wake_limit[next].until = left_of(wake_limits_[k]);
      found[next] = old;
    } else {
      release_slot(old);
    }
  }
  near_ = std::move(found);
  wake_limits_ = std::move(wake_limit);
  reset_travel();
  for (std::size_t i = 0; i < travel_.size(); ++i)
    travel_[i].rate = bodies_.rates_of(static_cast<std::int32_t>(i), wall).f;
  for (WakeLimit& each : wake_limits_)
    if (each.until > 0) let_sleep(each, each.until);
  needs_search_ = false;
  searched_ = true;
}

// Adds an upper bound of the motion of the points of each body in the last step.
template <class Bodies>
void FreeContacts<Bodies>::add_travel(double dt, const View& wall) {
  bool needs_search = false, finite = true;
  bodies_.for_each_travel(
      dt, wall, [&](std::int32_t body, const Vector<double>& now, double turned) {
        Travel& travel = travel_[body];
        const Vector<double> went = now - travel.place;
        const double turns = turned + rounding_;
        const double travelled = travelled_[body] + (Bodies::at_most(went) + turns);
        travelled_[body] = travelled;
        deviation_[body] += Bodies::at_most(went - dt * travel.rate) + turns;
        travel.turned += turns;
        travel.place = now;
        needs_search |= travelled > margin_[body];
        finite &= travelled < 1e300;  // false for NaN too
      });
  needs_search_ = needs_search_ || needs_search;
  finite_ = finite_ && finite;
}

// Checks a pair whose time is up by the relative motion of its bodies.
template <class Bodies>
bool FreeContacts<Bodies>::stays_asleep(const NearPair& near, WakeLimit& wake_limit) const {
  constexpr double kRounding = 1e-11;  // of the following terms [m]
  if (!(near.apart > 0)) return false;
  const Travel &a = travel_[near.a], &b = travel_[near.b];
  const Vector<double> drift = (b.place - a.place) - near.offset;
  const double left =
      near.apart - square_root(dot(drift, drift)) - (a.turned + b.turned - near.turned) - kRounding;
  if (!(left > 0)) return false;
  let_sleep(wake_limit, left);
  return true;
}

// Finds the pairs that may touch in this step, and stores the motion of their bodies.
template <class Bodies>
void FreeContacts<Bodies>::wake(const View& wall, Workers& workers) {
  constexpr std::size_t kBodyChunk = 256;
  awake_.clear();
  in_play_.clear();
  const auto enters = [&](std::int32_t body) {
    if (is_in_play_[body] != 0) return;
    is_in_play_[body] = 1;
    in_play_.push_back(body);
  };
  for (std::size_t k = 0; k < wake_limits_.size(); ++k) {
    WakeLimit& wake_limit = wake_limits_[k];
    if (left_of(wake_limit) > 0 || stays_asleep(near_[k], wake_limit)) continue;
    awake_.push_back(k);
    assign_slot(near_[k]);
    enters(near_[k].a);
    enters(near_[k].b);
  }
  for (const std::int32_t body : in_play_) is_in_play_[body] = 0;
  const auto chunks = static_cast<int>((in_play_.size() + kBodyChunk - 1) / kBodyChunk);
  workers.for_each_chunk(chunks, [&](int chunk) {
    const std::size_t end =
        std::min(in_play_.size(), static_cast<std::size_t>(chunk + 1) * kBodyChunk);
    for (std::size_t n = static_cast<std::size_t>(chunk) * kBodyChunk; n < end; ++n)
      bodies_.cache_motion(in_play_[n], wall);
  });
}

}  // namespace wythe::dynamics
