// Files of bodies in space: meshes (OBJ, PLY, STL), COMPAS, and the blocks file's third dimension.
//
//   file ──► bodies in its units and axes ──► place() ──► fix_supports() ──► ModelSpec::body
//
// Called by blocks_json.cpp, which knows the model file. Faults name their line in the file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "wythe/parts/body.h"
#include "wythe/parts/error.h"

namespace wythe::io {

[[nodiscard]] bool is_mesh_file(const std::string& file);  // by its ending

// Bodies in the file's units and axes. "stones/*.ply" reads every matching
// file in the order of names, each as one body. Throws like read_file.
[[nodiscard]] std::vector<BodySpec> parse_mesh_bodies(const std::string& file, FaultList& faults);

// Whether JSON is of COMPAS, which writes a dtype at the top, or a list of meshes (compas_json.cpp).
[[nodiscard]] bool is_compas(const nlohmann::json& json);
[[nodiscard]] std::vector<BodySpec> compas_bodies(const nlohmann::json& json,
                                                  const std::string& file, FaultList& faults);

// A block of a blocks file in space: "vertices" and "faces", "parts" of these, or "polygon" and "z".
using RefuseBlock = std::function<void(const std::string& where, const nlohmann::json& value,
                                       const std::string& problem, const std::string& cure)>;
[[nodiscard]] bool is_in_space(const nlohmann::json& block);
void parse_body_parts(const nlohmann::json& block, BodySpec& body, const RefuseBlock& refuse);

// Converts from the file's units and axes to metres with y up: (x, y, z) of a file with z up becomes (x, z, -y).
void place(std::vector<BodySpec>& bodies, double units_in_a_metre, bool z_up);

// Fixes the bodies that `supports` name: an id, the beginning of ids with * at the end, or "lowest".
void fix_supports(std::vector<BodySpec>& bodies, const std::vector<std::string>& supports,
                  FaultList& faults);

// The bodies as a blocks file, exact to the bit; in axes with z up where `z_up`.
[[nodiscard]] std::string bodies_text(const std::vector<BodySpec>& bodies, bool z_up);

}  // namespace wythe::io
