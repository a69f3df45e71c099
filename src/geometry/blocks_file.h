// Blocks from a blocks file (spec.block, already read by src/io): checked and turned anticlockwise.
//
// Called by assembly.cpp. Faults stand at "wall.blocks.<id>".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"

namespace wythe::geometry {

// Blocks in the file's order. Courses are numbered only where every block is an upright rectangle.
[[nodiscard]] std::vector<Block> blocks_from_file(const Shape& shape, FaultList& faults);

// Why these corners make no outline; "" where they do.
[[nodiscard]] std::string outline_problem(const Polygon& corners);

// Density of a file's block: of its material, or the unit's where that has none [kg/m^3].
[[nodiscard]] double density_in_file(const Shape& shape, const std::string& material);

// Materials that blocks bear, each with the id of the first block that does.
using BlockNames = std::map<std::string, std::string>;

// Refuses contact rules that name no block's material, and names of blocks that nearly are a material's ([material.*], "masonry", or
// what a contact rule calls blocks). Any other name is a block's own: it takes the unit's density and the common joints.
void check_names(const Shape& shape, const BlockNames& blocks, FaultList& faults);

// A name that the model states in a table of the builder is one of those materials; a fault at `path` where it is not.
bool is_material(const Shape& shape, const std::string& path, const std::string& name,
                 FaultList& faults);

// Joint material between two blocks of a file: the first contact rule that names both materials
// ("ground" for a support), else `otherwise`.
[[nodiscard]] std::string ruled_material(const Shape& shape, const std::string& a,
                                         const std::string& b, const std::string& otherwise);

}  // namespace wythe::geometry
