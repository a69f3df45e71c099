// Frames in space: the plane's frames, laid into the vertical plane of a wall (docs/theory/frames.md, "In space").
//
//      y up                    the plane stands at `origin`, with x along it in plan; segments are prisms centred on
//       |   /                  the plane
//       |  / across = x x y
//       | /
//  origin------ x along
#pragma once

#include "geometry/bodies/joint_faces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

// Places the frames of a model of bodies, and adds their segments to the bodies.
[[nodiscard]] std::vector<SpaceFrame> place_frames_in_space(const ModelSpec& spec,
                                                            std::vector<BodySpec>& bodies,
                                                            FaultList& faults);

}  // namespace wythe::geometry
