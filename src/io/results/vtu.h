// VTK XML files of a state, for ParaView: blocks and zones as polygons, joints as lines, all
// displaced.
//
// Arrays are base64 of little-endian doubles, so that every bit and every NaN survives.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "wythe/parts/model.h"

namespace wythe::io {

// Cells: blocks. displacement_mm (3), rotation_mrad (in space about z alone, and rotation_x_mrad, _y_, _z_ and
// rotation_total_mrad beside it), role (BlockRole), course, block (BlockId).
[[nodiscard]] std::string blocks_vtu(const Model& model, const State& state);

// Cells: joints, then the contacts of deformable blocks (kind 5, joint -1). Opening, slip, damages,
// crushing and mean stresses as in JointReading; kind (JointKind), joint (JointId).
[[nodiscard]] std::string joints_vtu(const Model& model, const State& state);

// Cells: zones of deformable blocks. displacement_mm (3) of the middle; mean stresses stress_x_MPa,
// stress_y_MPa, stress_xy_MPa, principal_1_MPa, principal_2_MPa (tension positive); body, zone.
[[nodiscard]] std::string zones_vtu(const Model& model, const State& state);

// The arrays of doubles in such a text, by name. Throws IoError where the text is incomplete.
[[nodiscard]] std::map<std::string, std::vector<double>, std::less<>> vtu_arrays(
    const std::string& text, const std::string& file);

// One row of the series; `time` is the value on ParaView's time slider: the displacement [mm].
struct SeriesEntry {
  double time = 0;
  int part = 0;
  std::string name;  // of the part
  std::string file;  // relative to the .pvd
};
[[nodiscard]] std::string series_pvd(const std::vector<SeriesEntry>& entries);

}  // namespace wythe::io
