// The parts of a wall for which damage is evaluated, found from the places of its blocks.
//
//    +-----------------------------+      opening     an enclosed hole, or one open at the base
//    |      [C]  spandrel  [C]     |      pier        between openings, over their height
//    |  ======================     |      spandrel    above an opening, up to the next or the top
//    |  pier  |         |  pier    |      connection  [C], where a spandrel meets a pier
//    |[t]  [t]|         |[t]    [t]|      toe         [t], lower corner of a pier
//    +--------+         +----------+
//
// A storey is a row of openings that overlap in height, whatever their places along the wall; piers stand
// beside the openings of a row, spandrels reach up to the next. The masonry that is neither is a node,
// above a pier (docs/theory/failure_modes.md, "Parts").
//
// Needs no grid: blocks are painted on a fine raster and the holes are what stays empty. Called once
// a model by the readers of element_states.cpp, element_forces.cpp and features.cpp.
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
  double base = 0;          // of the masonry that is read with its foot [m]
  int left = 0, right = 0;  // toes, into WallParts::toes
  // Between the higher sill and the lower head beside it nothing holds it; its own height where
  // that is less than half of it [m].
  double clear_y0 = 0, clear_y1 = 0;
  // Half way over the openings beside it; the wall's end where there is none [m].
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
  double column = 0, course = 0;         // length and height of the usual block [m]
  std::map<std::string, Message> words;  // of each name, for a reader
};

// Of one elevation, with names and marks as all of them together have them.
[[nodiscard]] std::vector<WallParts> find_parts(const Model& model,
                                                const std::vector<Elevation>& elevations);
// Of all elevations together. `wall`, `column` and `course` are those of the first one.
[[nodiscard]] WallParts find_parts(const Model& model);
// All of them with their kinds: "pier", "spandrel", "sill", "node", "connection", "toe".
[[nodiscard]] std::vector<std::pair<const Part*, const char*>> all_parts(const WallParts& parts);
// Openings with masonry on both sides, left to right and upwards; of a wall in its plane.
[[nodiscard]] std::vector<Box> find_openings(const Model& model);

}  // namespace wythe::study
