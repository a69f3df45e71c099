// Fits units to the wall: an integer number of half units along the length and of courses over the height.
//
//   |--step--|--step--|--step--|--step--|   Axis: lines 0 .. count, line(count) = extent
//
// fit = "whole": the step changes by at most 2 %, with a note; otherwise a fault names sizes
// that would fit. fit = "cut": nominal steps from the start, the last one cut; a remainder shorter than
// a quarter step is joined to the previous step.
//
// Sizes are nominal, mortar included. A wall of n bare units has n - 1 joints: if its extent equals that,
// it has n steps, which share the missing joint (docs/theory/conventions.md).
#pragma once

#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

inline constexpr double kFitTolerance = 0.02;     // largest change of a size without a fault
inline constexpr double kSliver = 0.25;           // pieces below this share of a step are not laid
inline constexpr double kHeaderTolerance = 0.05;  // a header this near to half a unit becomes half

struct Axis {
  double extent = 0;                            // [m]
  double step = 0;                              // fitted [m]
  int count = 0;                                // of steps
  double origin = 0;                            // line 0 [m]
  double joint = 0;                             // thickness of mortar within a step [m]
  [[nodiscard]] double end() const;             // line(count) [m]
  [[nodiscard]] double line(int i) const;       // [m], 0 <= i <= count
  [[nodiscard]] double half_line(int q) const;  // line at q half steps, any q [m]
  [[nodiscard]] int nearest(double x) const;    // line nearest to x
  [[nodiscard]] bool is_on_line(double x) const;
};

// The lattice of a wall: columns of half units (half headers in header bond) and courses.
struct Lattice {
  Axis columns, courses;
  double stretcher = 0;  // unit length [m]
  double header = 0;     // header face [m]
};

struct Storey;  // storeys.h

// The lattice of a storey that starts at `foot`. All sizes are checked before any is fitted. Where a
// size is missing the lattice is empty (count 0); where one does not fit it is that of the cure.
[[nodiscard]] Lattice fit_lattice(const Storey& storey, std::vector<Message>& notes,
                                  FaultList& faults);

}  // namespace wythe::geometry
