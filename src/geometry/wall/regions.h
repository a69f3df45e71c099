// Parts of the masonry with other materials: a storey, a pier of it, a box or a polygon.
//
// A block lies in a region when its centroid does, on the edge included; of several the one listed last
// has it. Which material a joint between two regions takes is said in faces.h.
// Called by assembly.cpp when the masonry is laid; writes Block::region.
#pragma once

#include "geometry/assembly.h"
#include "geometry/wall/openings.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Refuses a region without place, with more than one, that changes nothing or holds no block.
void assign_regions(const Shape& shape, const std::vector<Storey>& storeys,
                    const std::vector<PlacedOpening>& openings, Assembly& assembly,
                    FaultList& faults);

}  // namespace wythe::geometry
