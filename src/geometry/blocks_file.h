// Checks the blocks of a blocks file (spec.block, already read by src/io) and turns them anticlockwise.
//
// Called by assembly.cpp. Faults stand at "wall.blocks.<id>".
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/assembly.h"
#include "geometry/polygon.h"

namespace wythe::geometry {

// Blocks in the file's order. They get course numbers only where all of them are upright rectangles.
[[nodiscard]] std::vector<Block> blocks_from_file(const Shape& shape, FaultList& faults);

// Why these corners form no outline; "" where they do.
[[nodiscard]] std::string outline_problem(const Polygon& corners);

// Density of a block in a file [kg/m^3]: of its material, or that of the unit where the material has none.
[[nodiscard]] double density_in_file(const Shape& shape, const std::string& material);

// Materials of blocks, each with the id of the first block that has it.
using BlockNames = std::map<std::string, std::string>;

// Refuses contact rules that match no block's material, and block materials that are nearly a known name ([material.*], "masonry", or
// a block material of a contact rule). Any other name is accepted: such a block has the unit's density and the common joints.
void check_names(const Shape& shape, const BlockNames& blocks, FaultList& faults);

// Whether a name in a table of the builder is one of those materials; adds a fault at `path` where it is not.
bool is_material(const Shape& shape, const std::string& path, const std::string& name,
                 FaultList& faults);

// Joint material between two blocks of a file: the first contact rule that names both materials
// ("ground" for a support), else `otherwise`.
[[nodiscard]] std::string ruled_material(const Shape& shape, const std::string& a,
                                         const std::string& b, const std::string& otherwise);

}  // namespace wythe::geometry
