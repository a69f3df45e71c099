// Bodies of free contacts, and the law between two of them.
#pragma once

#include "contact/convex_contact.h"
#include "contact/convex_contact_in_space.h"
#include "core/real.h"
#include "wythe/parts/error.h"
#include "wythe/parts/model.h"

namespace wythe {

// The fixed body below a joint on the ground, n_block + k; -1 where no body contains a place just below it.
[[nodiscard]] std::int32_t support_of(const Model& model, JointId joint);

// The material of two bodies a < b in free contact: that of the largest joint between them, or the softer of
// their own materials where they have none.
[[nodiscard]] std::int32_t free_material_of(const Model& model, std::int32_t a, std::int32_t b);
[[nodiscard]] contact::FreeLaw free_law_of(const Model& model, std::int32_t a, std::int32_t b);

// Remaining share of a dead load, a weight lying on its block. It stays while the block falls by half of `height`, and has
// slid off after a fall of the full height. It falls no faster than a weight would: from a quarter of the height above.
[[nodiscard]] inline double load_left(double height, double fall) {
  return clip(2 - 2 * fall / height, 0.0, 1.0);
}
[[nodiscard]] inline double load_followed(double height, double fall, double speed) {
  constexpr double kGravity = 9.81;
  const double most = 2 * kGravity * (maximum(fall, 0.0) + 0.25 * height);
  return speed <= 0 ? 1.0 : clip(2 - speed * speed / most, 0.0, 1.0);
}

// Parts of blocks, supports and ground in space, from the bodies of the model.
[[nodiscard]] contact::SpaceParts free_parts(const Model& model);
// Makes shapes for free contacts in space, where the model requests them; needs bodies and joints.
void compile_free_in_space(const ModelSpec& spec, Model& model, FaultList& faults);

}  // namespace wythe
