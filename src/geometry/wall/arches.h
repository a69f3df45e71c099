// Arches: voussoirs over an opening, and the masonry around cut to them.
//
//            ___---___              extrados: parallel at `depth`
//        _--/  |   |  \--_
//       /  \ __+---+__ /  \         intrados: a polygon through the corners of the voussoirs, which stand on a circle
//      /_--               --_\      through the springing and the crown, or (flat) on a level line
//    end joint |  span   |          all joints run to one centre
//
// Angles, or lengths of a flat intrados, are equal for all voussoirs; the two sides mirror each other. Called by
// openings.cpp and assembly.cpp.
#pragma once

#include <string>
#include <vector>

#include "geometry/wall/openings.h"

namespace wythe::geometry {

// False when opening `index` has no arch or its arch lacks numbers (then with faults).
[[nodiscard]] bool check_arch(const Shape& shape, int index, FaultList& faults);

// Fills opening.arch.
void place_arch(const ArchSpec& arch, const Storey& storey, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults);

// Voussoirs and the room under them, down to the springing: what the masonry leaves free. Convex.
[[nodiscard]] Polygon outline_of(const PlacedArch& arch);

// Voussoir k of the arch, from the left.
[[nodiscard]] Polygon voussoir(const PlacedArch& arch, std::size_t k);

// Cuts the masonry along the arch. Pieces smaller than a sliver of their course become part of a neighbour; the
// number of these.
int cut_masonry(const PlacedArch& arch, const std::vector<Storey>& storeys,
                std::vector<Block>& blocks);

}  // namespace wythe::geometry
