// Deformable blocks of walls in space: their contacts, read as joints, and their zones (as zones.h in the plane).
#pragma once

#include "core/rotation.h"
#include "reading/zones.h"
#include "wythe/parts/reading.h"

namespace wythe::reading {

// Contact c as a joint: side b is block n_block + n_support + body.
[[nodiscard]] JointShape contact_in_space(const Model& model, int contact);
// Displacement of a point of a contact on its side of zones.
[[nodiscard]] Vec3 side_moved(const Model& model, const State& state, int contact,
                              std::size_t point);
// Rotation and displacement of the rigid body of a contact; a support does not rotate.
struct RigidSide {
  Quaternion<double> q;
  Vec3 moved;
};
[[nodiscard]] RigidSide rigid_side(const Model& model, const State& state, int contact);
// Body i: its mean displacement, weighted by mass, without a rotation.
[[nodiscard]] BlockReading body_in_space(const Model& model, const State& state, int body);

[[nodiscard]] const SpaceSolidBody* first_lintel_in_space(const Model& model);
[[nodiscard]] LintelMeasures lintel_measures_in_space(const Model& model, const State& state);
[[nodiscard]] double strain_energy_in_space(const Model& model, const State& state);
[[nodiscard]] std::vector<BeyondLimit> beyond_limits_in_space(const Model& model,
                                                              const State& state);

}  // namespace wythe::reading
