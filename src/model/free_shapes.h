// Bodies of free contacts and what is between two of them.
#pragma once

#include "contact/meeting.h"
#include "contact/meeting_in_space.h"
#include "wythe/error.h"
#include "wythe/model.h"

namespace wythe {

// The fixed body on which a joint of the ground stands, n_block + k; -1: none holds a place just below it.
[[nodiscard]] std::int32_t support_of(const Model& model, JointId joint);

// The law of two bodies in free contact, a < b: that of the largest joint between them, broken; without one
// that of the softer of their own materials.
[[nodiscard]] contact::FreeLaw free_law_of(const Model& model, std::int32_t a, std::int32_t b);

// In space: the parts of blocks, supports and ground, from the bodies of the model.
[[nodiscard]] contact::SpaceParts free_parts(const Model& model);
// Shapes of free contacts of a wall in space, where they are asked for; needs bodies and joints.
void compile_free_in_space(const ModelSpec& spec, Model& model, FaultList& faults);

}  // namespace wythe
