// Openings and lintels on the lattice, and the piers beside them.
//
//        | spandrel            |
//        |--+---+---+---+---+--|  lintel: whole courses above the head, whole columns of bearing
//        |  |               |  |
//   pier |  |    opening    |  | pier
//
// The edges of an opening move to the nearest column or course line by at most 2 % of its size (a note);
// with fit = "cut" units are cut at its edges instead. Faults name the nearest sizes that fit.
#pragma once

#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"
#include "geometry/wall/fit.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {

// Corners of voussoirs from left to right, one more than voussoirs; empty without an arch.
struct PlacedArch {
  std::vector<Vec2> intrados, extrados;  // [m]
  [[nodiscard]] bool empty() const { return intrados.empty(); }
  [[nodiscard]] std::size_t voussoirs() const { return empty() ? 0 : intrados.size() - 1; }
};

struct PlacedOpening {
  int index = 0;              // in wall.opening
  int storey = 0;             // index of the planned storey, from the ground up
  double stated_x = 0;        // [m]; its hole may lie elsewhere
  std::string called;         // name in faults, "opening 0 (door)"
  Message words;              // name in notes
  Rect hole;                  // [m]
  std::vector<Rect> segment;  // lintel segments, left to right; empty without lintel
  PlacedArch arch;
  std::vector<Rect> sill = {};  // its segments; empty without
};

// Places all openings. `spanning`: ring beams, which carry the masonry over an opening directly below them.
[[nodiscard]] std::vector<PlacedOpening> place_openings(const Shape& shape,
                                                        const std::vector<Storey>& storeys,
                                                        const std::vector<Rect>& spanning,
                                                        std::vector<Message>& notes,
                                                        FaultList& faults);

// Intervals of the wall's length outside all openings, with the top of the lower adjacent opening.
[[nodiscard]] std::vector<Pier> find_piers(const std::vector<PlacedOpening>& openings,
                                           double length, double height);

}  // namespace wythe::geometry
