// Results in the formats of other programs: HDF5 and COMPAS. CSV, VTU and JSON are in io.h.
#pragma once

#include <string>

#include "wythe/parts/io.h"

namespace wythe {

// Writes results.h5 of the results in `folder` into `out`, an existing empty folder: each table of
// write_export() is a group, each column a dataset. Throws as write_export() does.
Exported write_export_hdf5(const std::string& folder, const std::string& out);

// The blocks of a state as a COMPAS assembly: one mesh a block [m, z up], supports marked, and one edge for each
// joint between two blocks. Blocks of a plane wall extend by half the thickness on each side of
// the plane. The reader of COMPAS files (wall.blocks) accepts the result.
[[nodiscard]] std::string compas_json(const Model& model, const State& state);

}  // namespace wythe
