// Checks of a built assembly: no overlaps, no slivers, every block supported by the ground.
//
// Called by assembly.cpp; reads the assembly, writes faults.
#pragma once

#include <vector>

#include "geometry/assembly.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Adds a fault for each pair of blocks that share more than a film of the contact tolerance.
void check_overlaps(const std::vector<Block>& blocks, FaultList& faults);

// Adds faults for pieces of a generated wall thinner than a tenth of a half unit or of a course.
void check_slivers(const std::vector<Block>& blocks, const std::vector<Storey>& storeys,
                   FaultList& faults);

// Adds a fault for each block without a chain of faces to the ground.
void check_support(const Assembly& assembly, FaultList& faults);

}  // namespace wythe::geometry
