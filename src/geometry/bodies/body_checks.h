// What bodies in space must obey before and after their faces are found.
//
// Called by assemble (joint_faces.cpp), in this order. Faults stand at "wall.blocks.<id>".
#pragma once

#include <vector>

#include "geometry/bodies/joint_faces.h"

namespace wythe::geometry {

// Tolerances of bodies; the thickness of a body is 6 V / A, the side of a cube.
inline constexpr double kDeepestOverlap = 1e-2;  // of the thinner body's thickness, beside warps
inline constexpr double kThinnestBody = 2e-3;    // thickness as a share of its longest side
inline constexpr double kTiniestBody = 1e-3;     // longest side as a share of the median body's

// Every body closed, turned outside out and in convex parts (convex_parts.h). False after a fault.
[[nodiscard]] bool prepare_bodies(std::vector<BodySpec>& bodies, std::vector<Message>& notes,
                                  FaultList& faults);

// Bodies too small or too flat for a time step.
void check_sizes(const SpaceAssembly& assembly, FaultList& faults);

// Bodies that stand twice, and pairs whose parts lie in each other, by separating axes.
void check_overlaps(const SpaceAssembly& assembly, FaultList& faults);

// Bodies with no way through joints to a fixed one; a note where none is fixed at all.
void check_support(SpaceAssembly& assembly, FaultList& faults);

// How deep two convex parts lie in each other [m]: the least over all separating axes; 0 or less apart.
[[nodiscard]] double depth_of(const Polyhedron& a, const Polyhedron& b);

}  // namespace wythe::geometry
