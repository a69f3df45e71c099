// Blocks files: JSON with polygons or boxes, or a drawing (docs/reference/blocks.md).
#pragma once

#include <string>
#include <vector>

#include "io/toml_reader.h"

namespace wythe::io {

// Reads spec.wall.blocks (relative to spec.folder) into spec.block, and its thickness where
// wall.thickness is unset. Faults stand at wall.blocks, in the blocks file, with the block's id.
// `text` stands for the file where it is given.
void read_blocks(ReadContext& context, const toml::table& root, ModelSpec& spec,
                 const std::string& text);

// The same blocks as a blocks file in its native form, exact to the bit.
[[nodiscard]] std::string blocks_text(const std::vector<BlockSpec>& blocks,
                                      double thickness = kUnset);

}  // namespace wythe::io
