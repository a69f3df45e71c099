// The parts of a wall that damage is read on, found from where its blocks stand.
//
//    +-----------------------------+      opening     an enclosed hole, or one open at the base
//    |      [C]  spandrel  [C]     |      pier        between openings, over their height
//    |  ======================     |      spandrel    above an opening, up to the next or the top
//    |  pier  |         |  pier    |      connection  [C], where a spandrel meets a pier
//    |[t]  [t]|         |[t]    [t]|      toe         [t], lower corner of a pier
//    +--------+         +----------+
//
// Needs no grid: blocks are painted on a fine raster and the holes are what stays empty. Called once
// a model by the readers of element_states.cpp and features.cpp.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wythe/model.h"

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
};

struct Pier : Part {
  double base = 0;          // of the wall under it [m]
  int left = 0, right = 0;  // toes, into WallParts::toes
};

struct Spandrel : Part {
  double lintel = 0;          // depth taken by lintels at its foot [m]
  bool is_sill = false;       // below a window, on the ground
  int left = -1, right = -1;  // connections, -1: none (a sill, an opening at the wall's end)
};

struct WallParts {
  std::vector<Pier> piers;          // left to right, lower storeys first
  std::vector<Spandrel> spandrels;  // and sills
  std::vector<Part> connections;    // left and right of each spandrel
  std::vector<Part> toes;           // left and right of each pier
  Box wall;                         // masonry and lintels
  int openings = 0;
  double column = 0, course = 0;         // length and height of the usual block [m]
  std::map<std::string, Message> words;  // of each name, for a reader
};

[[nodiscard]] WallParts find_parts(const Model& model);
// Holes in the wall, left to right and upwards.
[[nodiscard]] std::vector<Box> find_openings(const Model& model);

}  // namespace wythe::study
