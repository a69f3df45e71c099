// Arches: voussoirs over an opening; the masonry around is cut to them.
//
//            ___---___              extrados: parallel at `depth`
//        _--/  |   |  \--_
//       /  \ __+---+__ /  \         intrados: a polygon through corners of voussoirs, which lie on a circle
//      /_--               --_\      through springing and crown or, of a flat arch, on a level line
//    end joint |  span   |          all joints point to one centre
//
// All voussoirs have equal angles, or equal lengths of a flat intrados; both sides are mirror images. Called by
// openings.cpp and assembly.cpp.
#pragma once

#include <vector>

#include "geometry/wall/openings.h"

namespace wythe::geometry {

// False when opening `index` has no arch, or its arch lacks numbers (then with faults).
[[nodiscard]] bool check_arch(const Shape& shape, int index, FaultList& faults);

// Computes opening.arch.
void place_arch(const ArchSpec& arch, const Storey& storey, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults);

// Outline of voussoirs and the space below, down to the springing: the area without masonry. Convex.
[[nodiscard]] Polygon outline_of(const PlacedArch& arch);

// Outline of voussoir k, counted from the left.
[[nodiscard]] Polygon voussoir(const PlacedArch& arch, std::size_t k);

// Cuts the masonry along the arch. Pieces smaller than a sliver of their course are united with a neighbour; returns
// their number.
int cut_masonry(const PlacedArch& arch, const std::vector<Storey>& storeys,
                std::vector<Block>& blocks);

}  // namespace wythe::geometry
