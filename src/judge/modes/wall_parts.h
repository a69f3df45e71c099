// The parts of a wall for which damage is evaluated, found from the places of its blocks.
//
//    +-----------------------------+      opening     an enclosed hole, or one open at the base
//    |      [C]  spandrel  [C]     |      pier        between openings, over their height
//    |  ======================     |      spandrel    above an opening, up to the next or the top
//    |  pier  |         |  pier    |      connection  [C], where a spandrel meets a pier
//    |[t]  [t]|         |[t]    [t]|      toe         [t], lower corner of a pier
//    +--------+         +----------+
//
// A storey is a row of openings that overlap in height, wherever they are along the wall.
// Piers stand beside the openings of a row, spandrels reach up to the next row. The rest
// of the masonry, above a pier, is a node (docs/theory/failure_modes.md, "Parts").
//
// An arch alone has neither piers nor spandrels: it is one part, and its hinges are counted (mode_names.cpp).
//
// No grid is needed: blocks are painted on a fine raster, and the holes are the empty cells.
// Called once for each model by element_states.cpp, element_forces.cpp and features.cpp.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "judge/modes/elevations.h"
#include "wythe/parts/model.h"

namespace wythe::study {

struct Box {
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // [m]
  [[nodiscard]] double width() const { return x1 - x0; }
  [[nodiscard]] double height() const { return y1 - y0; }
  [[nodiscard]] bool holds(double x, double y) const {
    return x > x0 && x < x1 && y > y0 && y < y1;
  }
};

struct Part {
  std::string name;
  Box box;
  std::string mark = {};  // "P3", "S1", "N2", on pictures
  int storey = 0;         // 1 is the lowest
  int elevation = 0;      // into elevations_of(); its box is in the axes of that
};

struct Pier : Part {
  double base = 0;          // lower end of the masonry that counts as its foot [m]
  int left = 0, right = 0;  // toes, into WallParts::toes
  // The height between the higher sill and the lower head beside it, where masonry
  // does not hold it. Its own height where that is less than half of it [m].
  double clear_y0 = 0, clear_y1 = 0;
  // Half way across the openings beside it; the wall's end where there is none [m].
  double reach_x0 = 0, reach_x1 = 0;
};

struct Spandrel : Part {
  double opening = 0;         // height of the opening below it [m]
  double lintel = 0;          // depth taken by lintels at its foot [m]
  bool is_sill = false;       // below a window, on the ground
  int left = -1, right = -1;  // connections, -1: none (a sill, an opening at the wall's end)
};

struct WallParts {
  std::vector<Pier> piers;          // lower storeys first, left to right
  std::vector<Spandrel> spandrels;  // and sills, so too
  std::vector<Part> connections;    // left and right of each spandrel
  std::vector<Part> toes;           // left and right of each pier
  std::vector<Part> nodes;          // above each pier
  Box wall;                         // masonry and lintels
  int openings = 0, storeys = 1;
  bool is_arch = false;                  // an arch without a wall: one part, no opening
  double column = 0, course = 0;         // length and height of the usual block [m]
  std::map<std::string, Message> words;  // of each name, for a reader
};

// Parts of one elevation, with names and marks that are unique over all elevations.
[[nodiscard]] std::vector<WallParts> find_parts(const Model& model,
                                                const std::vector<Elevation>& elevations);
// Parts of all elevations together. `wall`, `column` and `course` are those of the first one.
[[nodiscard]] WallParts find_parts(const Model& model);
// All parts with their kinds: "pier", "spandrel", "sill", "node", "connection", "toe".
[[nodiscard]] std::vector<std::pair<const Part*, const char*>> all_parts(const WallParts& parts);
// Openings with masonry on both sides of a wall in its plane, from left to right and upwards.
[[nodiscard]] std::vector<Box> find_openings(const Model& model);

}  // namespace wythe::study
