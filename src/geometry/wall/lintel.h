// Lintels and sills: rigid segments, one a column, in the whole courses right above or below an opening.
//
//   bearing |--|                 |--|
//           +--+--+--+--+--+--+--+--+   n courses, n = max(1, round(depth / course))
//           |  +-----------------+  |
//
// The bearing becomes whole columns, at most kBearingFactor times what is stated; more is refused.
// Called by openings.cpp.
#pragma once

#include "geometry/wall/openings.h"

namespace wythe::geometry {

inline constexpr double kBearingFactor = 2;

// Whole steps nearest to a size, one at least.
[[nodiscard]] int whole_steps(double size, double step);

// A level body as rigid segments: joints stand on the column lines; ends shorter than half a column are not
// cut off.
[[nodiscard]] std::vector<Rect> cut_chain(const Rect& body, const Axis& columns);

// False when opening `index` has no lintel or its lintel lacks numbers (then with faults).
[[nodiscard]] bool check_lintel(const Shape& shape, int index, FaultList& faults);
[[nodiscard]] bool check_sill(const Shape& shape, int index, FaultList& faults);

// Fills opening.segment; with fit = "cut" first moves the opening's head to a course line.
void place_lintel(const LintelSpec& lintel, const Lattice& lattice, PlacedOpening& opening,
                  std::vector<Message>& notes, FaultList& faults);

// Fills opening.sill; with fit = "cut" first moves the opening's foot to a course line.
void place_sill(const SillSpec& sill, const Lattice& lattice, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults);

}  // namespace wythe::geometry
