// Blocks files: JSON with polygons, boxes or solids, a drawing, or a mesh (docs/reference/blocks.md).
#pragma once

#include <string>
#include <vector>

#include "io/text/toml_reader.h"

namespace wythe::io {

// Reads spec.wall.blocks (relative to spec.folder) into spec.block and its thickness where wall.thickness is
// unset, or into spec.body, in metres with y up; spec.wall.up then says which axis is up in the file. Faults stand at wall.blocks, in the blocks file, with the block's id.
// `text` stands for the file where it is given.
void parse_blocks(ReadContext& context, const toml::table& root, ModelSpec& spec,
                  const std::string& text);

// The same blocks as a blocks file in its native form, exact to the bit.
[[nodiscard]] std::string blocks_text(const std::vector<BlockSpec>& blocks,
                                      double thickness = kUnset);
// Of a model: its blocks or, in the axes of its file, its bodies.
[[nodiscard]] std::string blocks_text(const ModelSpec& spec, bool with_thickness = false);

}  // namespace wythe::io
