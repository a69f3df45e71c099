// Bodies of free contacts and what is between two of them.
#pragma once

#include "contact/convex_contact.h"
#include "contact/convex_contact_in_space.h"
#include "core/real.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

// The fixed body on which a joint of the ground stands, n_block + k; -1: none holds a place just below it.
[[nodiscard]] std::int32_t support_of(const Model& model, JointId joint);

// The law of two bodies in free contact, a < b: that of the largest joint between them, broken; without one
// that of the softer of their own materials.
[[nodiscard]] std::int32_t free_material_of(const Model& model, std::int32_t a, std::int32_t b);
[[nodiscard]] contact::FreeLaw free_law_of(const Model& model, std::int32_t a, std::int32_t b);

// A dead load is a weight that lies on its block. It stays there while the block falls by half of its own height, has
// slid off when it has fallen by all of it, and falls no faster than a weight does: from a quarter of the height above.
[[nodiscard]] inline double load_left(double height, double fall) {
  return clip(2 - 2 * fall / height, 0.0, 1.0);
}
[[nodiscard]] inline double load_followed(double height, double fall, double speed) {
  constexpr double kGravity = 9.81;
  const double most = 2 * kGravity * (maximum(fall, 0.0) + 0.25 * height);
  return speed <= 0 ? 1.0 : clip(2 - speed * speed / most, 0.0, 1.0);
}

// In space: the parts of blocks, supports and ground, from the bodies of the model.
[[nodiscard]] contact::SpaceParts free_parts(const Model& model);
// Shapes of free contacts of a wall in space, where they are asked for; needs bodies and joints.
void compile_free_in_space(const ModelSpec& spec, Model& model, FaultList& faults);

}  // namespace wythe
