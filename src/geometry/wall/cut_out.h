// Openings that a stage cuts out of standing masonry (docs/theory/cutting.md): the masonry before the cut.
//
//        |--+---+---+---+--|
//        |==|===|===|===|==|  = place of the lintel         - masonry that stays
//        |--|###|###|###|--|  # place of the opening          its pieces are cut at the outline
//        |--|#|###|###|#|--|
//
// Called by assembly.cpp and by the builder in space.
#pragma once

#include <string>
#include <vector>

#include "geometry/wall/openings.h"

namespace wythe::geometry {

// Pieces of the courses at the place of the opening, its lintel and its sill; each has its cut_from.
[[nodiscard]] std::vector<Block> masonry_cut_out(const PlacedOpening& opening,
                                                 const std::vector<Storey>& storeys);

// Number of the cut stage with this name, which must follow gravity. 0 where `name` is empty; adds a fault at
// `path` where there is no such stage.
[[nodiscard]] int find_cut_stage(const std::vector<StageSpec>& stages, const std::string& path,
                                 const std::string& name, FaultList& faults);

}  // namespace wythe::geometry
