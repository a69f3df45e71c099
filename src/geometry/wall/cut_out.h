// Openings that a stage cuts out of standing masonry (docs/theory/cutting.md): the masonry that stands there before.
//
//        |--+---+---+---+--|
//        |==|===|===|===|==|  = where the lintel comes     - masonry that stays
//        |--|###|###|###|--|  # where the opening comes      its pieces are cut at the outline
//        |--|#|###|###|#|--|
//
// Called by assembly.cpp and by the builder in space.
#pragma once

#include <string>
#include <vector>

#include "geometry/wall/openings.h"

namespace wythe::geometry {

// Pieces of the courses where the opening, its lintel and its sill come; each with its cut_from.
[[nodiscard]] std::vector<Block> masonry_cut_out(const PlacedOpening& opening,
                                                 const std::vector<Storey>& storeys);

// The number of the stage of kind cut with this name, which comes after gravity; 0 where `name` is empty, and a fault at
// `path` where there is none such.
[[nodiscard]] int find_cut_stage(const std::vector<StageSpec>& stages, const std::string& path,
                                 const std::string& name, FaultList& faults);

}  // namespace wythe::geometry
