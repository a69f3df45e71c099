// Parts of the masonry with other materials: a storey, a pier of it, a box or a polygon.
//
// A block lies in a region when its centroid does, edge included; of several regions the one listed last
// has it. faces.h defines the material of a joint between two regions.
// Called by assembly.cpp once the masonry is laid; writes Block::region.
#pragma once

#include "geometry/assembly.h"
#include "geometry/wall/openings.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Refuses a region without a place, with several places, without changes or without blocks.
void assign_regions(const Shape& shape, const std::vector<Storey>& storeys,
                    const std::vector<PlacedOpening>& openings, Assembly& assembly,
                    FaultList& faults);

}  // namespace wythe::geometry
