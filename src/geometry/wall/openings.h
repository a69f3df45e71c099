// Openings and lintels on the lattice, and the piers beside them.
//
//        | spandrel            |
//        |--+---+---+---+---+--|  lintel: whole courses above the head, whole columns of bearing
//        |  |               |  |
//   pier |  |    opening    |  | pier
//
// An opening's edges move to the nearest column or course line by 2 % of its size or less (a note);
// with fit = "cut" units are cut at the edges instead. Faults name the nearest sizes that fit.
#pragma once

#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/wall/fit.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Corners of the voussoirs, from left to right, one more than there are; empty without an arch.
struct PlacedArch {
  std::vector<Vec2> intrados, extrados;  // [m]
  [[nodiscard]] bool empty() const { return intrados.empty(); }
  [[nodiscard]] std::size_t voussoirs() const { return empty() ? 0 : intrados.size() - 1; }
};

struct PlacedOpening {
  int index = 0;              // in wall.opening
  int storey = 0;             // of the planned storeys, from the ground up
  std::string called;         // "opening 0 (door)", in faults
  Message words;              // the same, in notes
  Rect hole;                  // [m]
  std::vector<Rect> segment;  // lintel segments, left to right; empty without lintel
  PlacedArch arch;
  std::vector<Rect> sill = {};  // its segments; empty without
};

// `spanning`: ring beams, which carry what lies over an opening right below them.
[[nodiscard]] std::vector<PlacedOpening> place_openings(const Shape& shape,
                                                        const std::vector<Storey>& storeys,
                                                        const std::vector<Rect>& spanning,
                                                        std::vector<Message>& notes,
                                                        FaultList& faults);

// Intervals of the wall's length outside every opening, with the lower adjacent opening's top.
[[nodiscard]] std::vector<Pier> find_piers(const std::vector<PlacedOpening>& openings,
                                           double length, double height);

}  // namespace wythe::geometry
