// Blocks files: JSON with polygons, boxes or solids, a drawing, or a mesh (docs/reference/blocks.md).
#pragma once

#include <string>
#include <vector>

#include "io/text/toml_reader.h"

namespace wythe::io {

// Reads spec.wall.blocks (relative to spec.folder) in metres with y up. Goes into spec.block, and its thickness
// where wall.thickness is unset. In space it goes into spec.body, and spec.wall.up says which axis is up in the
// file. Faults are at wall.blocks, in the blocks file, with the block's id. `text` replaces the content of the file.
void parse_blocks(ReadContext& context, const toml::table& root, ModelSpec& spec,
                  const std::string& text);

// These blocks as a blocks file in its native form, exact to the bit.
[[nodiscard]] std::string blocks_text(const std::vector<BlockSpec>& blocks,
                                      double thickness = kUnset);
// For a model: its blocks, or its bodies in the axes of its file.
[[nodiscard]] std::string blocks_text(const ModelSpec& spec, bool with_thickness = false);

}  // namespace wythe::io
