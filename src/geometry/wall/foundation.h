// Stepped ground: the levels at which the wall begins, from left to right.
//
//   +-----------------------------+
//   |          masonry            |     each step is a rectangle of ground below the masonry, from the
//   |        +--------------------+     wall's base up to its level. The joints on it are foundation joints;
//   |        |///////  step 1  ///|     soil beside a step is not in contact
//   +--------+ - - - - - - - - - -+  y = 0: the lowest step
//
// Edges move to the nearest column or course line as those of openings do; with fit = "cut" units are cut at
// them instead. Called by assembly.cpp.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "geometry/wall/joints.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Steps from left to right; level ground is one step. Empty after faults.
[[nodiscard]] std::vector<GroundStep> place_ground(const Shape& shape,
                                                   const std::vector<Storey>& storeys,
                                                   std::vector<Message>& notes, FaultList& faults);

// The box below a step that has no masonry.
[[nodiscard]] inline Rect box_of(const GroundStep& step) { return {step.x0, 0, step.x1, step.y}; }

// Contacts of blocks' bottom edges with the steps.
[[nodiscard]] std::vector<Contact> find_step_contacts(const std::vector<Block>& blocks,
                                                      const std::vector<GroundStep>& ground);

}  // namespace wythe::geometry
