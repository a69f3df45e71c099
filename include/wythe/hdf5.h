// Results as one HDF5 file, beside the CSV tables of io.h: the same tables, a group each, a dataset a column.
#pragma once

#include <string>

#include "wythe/io.h"

namespace wythe {

// Writes results.h5 of the results in `folder` into `out`, which is there and empty. Throws as write_export().
Exported write_export_hdf5(const std::string& folder, const std::string& out);

}  // namespace wythe
