// The storeys of a building from the ground up, each with the values it inherits from the wall.
//
//   +---------------------------+  end of its courses = foot of the storey above, to the bit
//   |  first: unit, bond, ...   |  courses first_course, first_course + 1, ...
//   +---------------------------+
//   |  ground                   |
//   +---------------------------+  foot 0
//
// A wall without [[storey]] is one storey, the wall itself. Called by assembly.cpp and model/size.cpp.
#pragma once

#include <string>
#include <vector>

#include "geometry/shape.h"
#include "geometry/wall/fit.h"

namespace wythe::geometry {

struct Storey {
  int index = -1;                                // in the model's list; -1: the wall itself
  std::string name;                              // "" for the wall itself
  double length = 0, height = 0, thickness = 0;  // [m]
  Bond bond = Bond::kRunning;
  Fit fit = Fit::kWhole;
  UnitSpec unit;         // nominal, mortar included
  double foot = 0;       // [m]
  int first_course = 0;  // counted over all storeys
  Lattice lattice;
  std::vector<std::string> own;  // keys that it states itself: "unit.length"

  [[nodiscard]] double top() const { return foot + height; }
  [[nodiscard]] double bed_mortar() const;   // 0 where units are nominal [m]
  [[nodiscard]] double head_mortar() const;  // the same
  [[nodiscard]] std::string called() const;  // "storey 0 (ground)"
  // Key path of a value that the user wrote, or may write: "storey.0.unit.length" or "wall.unit.length".
  [[nodiscard]] std::string path_of(const std::string& key) const;
};

// Storeys from the ground up, at least one, unchecked and without lattices.
[[nodiscard]] std::vector<Storey> stated_storeys(const WallSpec& wall,
                                                 const std::vector<StoreySpec>& storey);

// As stated_storeys(), but checked and with lattices; `cut_all`: as if each had fit = "cut".
[[nodiscard]] std::vector<Storey> plan_storeys(const Shape& shape, bool cut_all,
                                               std::vector<Message>& notes, FaultList& faults);

// Storeys of a blocks file: levels with a thickness from `foot` upwards, without lattices.
[[nodiscard]] std::vector<Storey> level_storeys(const Shape& shape, double foot, FaultList& faults);

// The last storey whose foot is at or below y; the first one where there is none.
[[nodiscard]] const Storey& storey_at(const std::vector<Storey>& storeys, double y);

// Index of the row of units at y, counted from the ground over all storeys.
[[nodiscard]] long row_at(const std::vector<Storey>& storeys, double y);

// The storey with this name; nullptr after a fault at `path`.
[[nodiscard]] const Storey* find_storey(const std::vector<Storey>& storeys, const std::string& name,
                                        const std::string& path, FaultList& faults);

}  // namespace wythe::geometry
