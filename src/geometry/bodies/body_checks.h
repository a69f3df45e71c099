// Checks of bodies in space, before and after their faces are found.
//
// Called by assemble (joint_faces.cpp), in this order. Faults stand at "wall.blocks.<id>".
#pragma once

#include <vector>

#include "geometry/bodies/joint_faces.h"

namespace wythe::geometry {

// Tolerances of bodies. The thickness of a body is 6 V / A, as of a cube with that side.
inline constexpr double kDeepestOverlap = 1e-2;  // of the thinner body's thickness, beside warps
inline constexpr double kThinnestBody = 2e-3;    // thickness as a share of its longest side
inline constexpr double kTiniestBody = 1e-3;     // longest side as a share of the median body's

// Makes every body closed, oriented outwards and divided into convex parts (convex_parts.h). False after a fault.
[[nodiscard]] bool prepare_bodies(std::vector<BodySpec>& bodies, std::vector<Message>& notes,
                                  FaultList& faults);

// Refuses bodies too small or too flat for a time step.
void check_sizes(const SpaceAssembly& assembly, FaultList& faults);

// Refuses bodies that are listed twice, and pairs whose parts overlap, by separating axes.
void check_overlaps(const SpaceAssembly& assembly, FaultList& faults);

// Refuses bodies without a path of joints to a fixed one; a note where no body is fixed at all.
void check_support(SpaceAssembly& assembly, FaultList& faults);

// Penetration of two convex parts [m]: the minimum over all separating axes; 0 or negative where they are apart.
[[nodiscard]] double depth_of(const Polyhedron& a, const Polyhedron& b);

}  // namespace wythe::geometry
