// Solids from mesh files: OBJ, PLY and STL, ASCII and binary, in the units and axes of the file.
//
//   OBJ  every o or g is a body; without any, every solid is one. usemtl is its material
//   PLY  every solid is a body
//   STL  every solid is a body; named after its `solid` where a file has several
//
// A solid is enclosed by a closed surface (geometry/bodies/pieces.h). Called by bodies_file.cpp.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/body.h"
#include "wythe/parts/error.h"

namespace wythe::io {

// `file` names the file in faults; one solid alone is named `name`, several b1, b2, ...
struct MeshText {
  const std::string& text;
  std::string file, name;
};
[[nodiscard]] std::vector<BodySpec> parse_obj(const MeshText& mesh, FaultList& faults);
[[nodiscard]] std::vector<BodySpec> parse_ply(const MeshText& mesh, FaultList& faults);
[[nodiscard]] std::vector<BodySpec> parse_stl(const MeshText& mesh, FaultList& faults);

}  // namespace wythe::io
