// Lintels and sills: rigid segments, one for each column, in the whole courses directly above or below an opening.
//
//   bearing |--|                 |--|
//           +--+--+--+--+--+--+--+--+   n courses, n = max(1, round(depth / course))
//           |  +-----------------+  |
//
// The bearing is a whole number of columns, at most kBearingFactor times the stated one; a longer one is refused.
// Called by openings.cpp.
#pragma once

#include "geometry/wall/openings.h"

namespace wythe::geometry {

inline constexpr double kBearingFactor = 2;

// Number of steps nearest to a size, at least one.
[[nodiscard]] int whole_steps(double size, double step);

// Divides a level body into rigid segments: joints lie on column lines; ends shorter than half a column stay
// with their neighbour.
[[nodiscard]] std::vector<Rect> cut_chain(const Rect& body, const Axis& columns);

// False when opening `index` has no lintel, or its lintel lacks numbers (then with faults).
[[nodiscard]] bool check_lintel(const Shape& shape, int index, FaultList& faults);
[[nodiscard]] bool check_sill(const Shape& shape, int index, FaultList& faults);

// Computes opening.segment; with fit = "cut" first moves the opening's head to a course line.
void place_lintel(const LintelSpec& lintel, const Lattice& lattice, PlacedOpening& opening,
                  std::vector<Message>& notes, FaultList& faults);

// Computes opening.sill; with fit = "cut" first moves the opening's foot to a course line.
void place_sill(const SillSpec& sill, const Lattice& lattice, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults);

}  // namespace wythe::geometry
