// Fits units to the wall: whole half units along the length, whole courses along the height.
//
//   |--step--|--step--|--step--|--step--|   Axis: lines 0 .. count, line(count) = extent
//
// fit = "whole": the step changes by 2 % or less, reported as a note; else a fault with the sizes
// that would fit. fit = "cut": nominal steps from the start, the last one cut; a rest shorter than
// a quarter step is joined to the step before it.
//
// Sizes are nominal, mortar included. A wall of n bare units has n - 1 joints: where that is what its
// extent says, it holds n steps, which share the missing joint (docs/theory/conventions.md).
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/error.h"
#include "wythe/parts/message.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::geometry {

inline constexpr double kFitTolerance = 0.02;     // largest change of a size that needs no consent
inline constexpr double kSliver = 0.25;           // pieces below this share of a step are not laid
inline constexpr double kHeaderTolerance = 0.05;  // a header this near half a unit is taken as half

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

// The wall's lattice: columns of half units (half headers in header bond) and courses.
struct Lattice {
  Axis columns, courses;
  double stretcher = 0;  // unit length [m]
  double header = 0;     // header face [m]
};

struct Storey;  // storeys.h

// The lattice of a storey that stands on `foot`. Everything is checked before anything is fitted; where
// a size is missing the lattice is empty (count 0), where one does not fit it is that of the cure.
[[nodiscard]] Lattice fit_lattice(const Storey& storey, std::vector<Message>& notes,
                                  FaultList& faults);

}  // namespace wythe::geometry
