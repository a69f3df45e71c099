// Ring beams: rigid segments, one for each column, in whole courses at one level.
//
//   +--+--+--+--+--+--+--+--+--+--+  top of a storey      a chain like that of a lintel, with joints of the masonry
//   |  |  |  |  |  |  |  |  |  |  |  ring beam            above, below and at its ends
//   +--+--+--+--+--+--+--+--+--+--+
//
// Called by assembly.cpp, which lays the masonry around them.
#pragma once

#include <vector>

#include "geometry/wall/openings.h"

namespace wythe::geometry {

struct PlacedRingBeam {
  int index = 0;              // in the model's list
  int storey = 0;             // of the planned storeys
  double thickness = 0;       // [m]
  std::vector<Rect> segment;  // left to right
};

[[nodiscard]] std::vector<PlacedRingBeam> place_ring_beams(const Shape& shape,
                                                           const std::vector<Storey>& storeys,
                                                           std::vector<Message>& notes,
                                                           FaultList& faults);

// Refuses sills and ring beams that overlap openings, arches, ground or other chains.
void check_chains(const Shape& shape, const std::vector<PlacedOpening>& openings,
                  const std::vector<PlacedRingBeam>& beams, const std::vector<GroundStep>& ground,
                  FaultList& faults);

}  // namespace wythe::geometry
