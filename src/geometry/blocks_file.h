// Blocks from a blocks file (spec.block, already read by src/io): checked and turned anticlockwise.
//
// Called by assembly.cpp. Faults stand at "wall.blocks.<id>".
#pragma once

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

// Joint material between two blocks of a file: the first contact rule that names both materials
// ("ground" for a support), else `otherwise`.
[[nodiscard]] std::string ruled_material(const Shape& shape, const std::string& a,
                                         const std::string& b, const std::string& otherwise);

}  // namespace wythe::geometry
