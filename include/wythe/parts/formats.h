// Results in the formats of other programs: HDF5 and COMPAS. CSV, VTU and JSON are in io.h.
#pragma once

#include <string>

#include "wythe/parts/io.h"

namespace wythe {

// Writes results.h5 of the results in `folder` into `out`, which is there and empty: the tables of
// write_export(), a group each, a dataset a column. Throws as write_export().
Exported write_export_hdf5(const std::string& folder, const std::string& out);

// The blocks as they stand in this state, as a COMPAS assembly: a mesh a block in metres with z up, the supports
// marked, an edge for each joint between two of them. Blocks of a plane wall have its thickness, half on each side
// of the plane. What reads COMPAS files here (wall.blocks) reads it again.
[[nodiscard]] std::string compas_json(const Model& model, const State& state);

}  // namespace wythe
