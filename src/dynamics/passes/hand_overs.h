// From joints to free contacts: finds pairs of blocks whose joints have failed, and hands over their forces
// without a jump (docs/theory/contacts.md, 13.8). The last part of free_contacts.h, which includes it.
#pragma once

#include "dynamics/passes/free_contacts.h"

namespace wythe::dynamics {

// All joints of a pair are handed over at once: one joint that still holds keeps the others.
template <class Bodies>
std::vector<std::size_t> FreeContacts<Bodies>::find_hand_overs(const View& wall) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < jointed_.size(); ++k) {
    Jointed& pair = jointed_[k];
    bool gives = false;
    for (auto n = pair.first; !pair.handed_over && n < pair.end; ++n)
      gives = gives || bodies_.has_failed(joint_of_[n], wall);
    for (auto n = pair.first; gives && n < pair.end; ++n)
      gives = !bodies_.holds(joint_of_[n], wall);
    if (!gives) continue;
    pair.handed_over = true;
    found.push_back(k);
  }
  return found;
}

// At a crushed joint the blocks overlap by more than their force needs. A part of the
// overlap, `rest`, is taken off so that the contact presses with the joint's normal force.
template <class Bodies>
void FreeContacts<Bodies>::rest_on_crushed(FreePair& pair, const Vector<double>& on_a) const {
  constexpr int kHalvings = 60;
  const typename Bodies::PairGeometry pair_geometry = bodies_.pair_geometry(pair.memory);
  const std::int32_t feature = pair.memory.feature;
  const double wanted = -dot(on_a, bodies_.normal_of(pair_geometry, feature));
  const auto presses = [&](double rest) {
    return bodies_.stiffness(pair.law) *
           bodies_.pressing(bodies_.overlap(pair_geometry, feature, rest));
  };
  if (presses(0) <= wanted) return;
  double low = 0, high = -bodies_.overlap(pair_geometry, feature, 0).lowest;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (presses(middle) > wanted ? low : high) = middle;
  }
  pair.memory.rest = high;
}

// Sets Maxwell elements to zero in a stage without them.
template <class Bodies>
void FreeContacts<Bodies>::clear_maxwell() {
  for (std::size_t k = 0; dashpots_ == nullptr && damped_before_ && k < pairs_.size(); ++k) {
    FreeContact& m = pairs_[k].memory;
    m.maxwell_n = m.maxwell_x = m.maxwell_y = m.maxwell_z = 0;
  }
  damped_before_ = dashpots_ != nullptr;
}

// The difference between the joints' forces and the free contact's force stays as a force that fades.
template <class Bodies>
void FreeContacts<Bodies>::hand_over(State& state, const Jointed& pair, const View& wall) {
  ForceMoment before, after;
  double energy = 0;
  for (auto k = pair.first; k < pair.end; ++k) {
    before = before + bodies_.joint_force(joint_of_[k], pair.a, wall);
    energy += bodies_.elastic_energy(joint_of_[k], wall);
    bodies_.release(joint_of_[k], wall);
  }
  const std::span<NearPair> contacts = near_of(pair.a, pair.b);
  const double pressed = pressed_by(contacts);
  double bears = 0;
  for (const NearPair& near : contacts) {
    if (near.slot < 0) continue;
    FreePair& p = pair_of(near);
    if (!p.touches()) continue;
    const auto again = [&] {
      update_pair(static_cast<std::size_t>(&near - near_.data()), 0.0, false);
    };
    const Vector<double> share = (p.pressed / pressed) * before.f;
    rest_on_crushed(p, share);
    again();
    if (!p.touches()) continue;
    bodies_.take_over_shear(p, share);
    again();
    after = after + p.on_a;
    energy -= p.stored;
    bears += p.pressed;
  }
  state.energy.lost_in_hand_over += energy;
  if (!(bears > 0)) return;  // no contact presses, so nothing carries the force on
  const Vector<double> f = bodies_.to_body_axes(pair.a, before.f - after.f, wall);
  const Vector<double> m = bodies_.to_body_axes(pair.a, before.m - after.m, wall);
  const HandOver rest{pair.a, pair.b, 1, bears, f.x, f.y, f.z, m.x, m.y, m.z};
  const auto place = std::lower_bound(
      hand_overs_.begin(), hand_overs_.end(), rest,
      [](const HandOver& p, const HandOver& q) { return bodies_of(p) < bodies_of(q); });
  apply(*hand_overs_.insert(place, rest), wall);
}

template <class Bodies>
void FreeContacts<Bodies>::apply(const HandOver& h, const View& wall) {
  const ForceMoment a{
      bodies_.to_wall_axes(h.a, h.share * Vector<double>{h.force_x, h.force_y, h.force_z}, wall),
      bodies_.to_wall_axes(h.a, h.share * Vector<double>{h.moment_x, h.moment_y, h.moment_z},
                           wall)};
  const Vector<double> arm = bodies_.place_of(h.a, wall) - bodies_.place_of(h.b, wall);
  bodies_.add(h.a, h.b, a, {-1.0 * a.f, -1.0 * (a.m + cross(arm, a.f))}, wall);
  acts_ = true;
}

// Each force fades as its contact unloads, and as the bodies slide or turn against each
// other, because it belongs to the poses at the hand-over. Its work goes into the ledger.
template <class Bodies>
void FreeContacts<Bodies>::fade_hand_overs(State& state, double dt, const View& wall) {
  for (HandOver& h : hand_overs_) {
    const double pressed = pressed_by(near_of(h.a, h.b));
    // velocity of b, taken to the centroid of a, where the force acts
    const Vector<double> arm = bodies_.place_of(h.a, wall) - bodies_.place_of(h.b, wall);
    const ForceMoment va = bodies_.rates_of(h.a, wall), vb = bodies_.rates_of(h.b, wall);
    const Vector<double> slides = va.f - (vb.f + cross(vb.m, arm)), turns = va.m - vb.m;
    const double moved =
        square_root(dot(slides, slides)) / (kForgottenSlip * bodies_.size_of(h.a)) +
        square_root(dot(turns, turns)) / kForgottenTurn;
    const double share = minimum(h.share - dt * moved, pressed / h.pressed);
    const double mean = 0.5 * (h.share + maximum(share, 0.0));
    const Vector<double> f =
        bodies_.to_wall_axes(h.a, mean * Vector<double>{h.force_x, h.force_y, h.force_z}, wall);
    const Vector<double> m =
        bodies_.to_wall_axes(h.a, mean * Vector<double>{h.moment_x, h.moment_y, h.moment_z}, wall);
    state.energy.lost_in_hand_over -= dt * (dot(f, slides) + dot(m, turns));
    h.share = share;
  }
  std::erase_if(hand_overs_, [](const HandOver& h) { return !(h.share > 0); });
  for (const HandOver& h : hand_overs_) apply(h, wall);
}

}  // namespace wythe::dynamics
