// Where blocks and joints are now, for pictures and files (io, report); the step has its own.
//
// A block turns about its centroid by theta and moves by (ux, uy); `scale` magnifies both, so that
// at scale 1 the outline is where it really is.
#pragma once

#include <array>
#include <vector>

#include "wythe/model.h"

namespace wythe {

struct PlacedPoint {
  double x = 0, y = 0;  // in the wall's axes [m]
};

// Outline of a block in its present place, in the order of the anatomy [m].
[[nodiscard]] std::vector<PlacedPoint> placed_outline(const Model& model, const State& state,
                                                      BlockId block, double scale = 1);

// Where a node of zones is [m].
[[nodiscard]] PlacedPoint placed_node(const Model& model, const State& state, int node,
                                      double scale = 1);
// Both ends of a zone contact, on the zone's edge [m].
[[nodiscard]] std::array<PlacedPoint, 2> placed_contact(const Model& model, const State& state,
                                                        int contact, double scale = 1);
// Both ends of a joint, half way between its two faces [m]; a ground face stays where it was.
[[nodiscard]] std::array<PlacedPoint, 2> placed_joint(const Model& model, const State& state,
                                                      JointId joint, double scale = 1);

}  // namespace wythe
