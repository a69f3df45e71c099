// Bodies on top of the wall: a stiff plate on each pier, or one loading beam over the length.
//
//    +----plate----+        +----plate----+          +------------- beam -------------+
//    |    pier     |        |    pier     |          |              wall              |
//
// Called by assembly.cpp once the masonry is laid.
#pragma once

#include <string>

#include "geometry/assembly.h"
#include "geometry/polygon.h"

namespace wythe::geometry {

// Adds plates for stages with as = "plate" and a pier_load, or a beam where wall.beam.height is stated.
// `extent` is the bounding box of the masonry.
void add_caps(const Shape& shape, const Rect& extent, Assembly& assembly, FaultList& faults);

// Joint material under the plates; "" when no stage asks for plates.
[[nodiscard]] std::string plate_joint(const Shape& shape);

}  // namespace wythe::geometry
