// Converts the drawing of a facade (DXF) into the text of a model file.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

struct ModelSpec;

// Names of the layers to read; upper and lower case are equal. "none": there is no such layer.
struct DrawingLayers {
  std::string outline = "outline", openings = "openings", lintels = "lintels";
};
// [wall] and its [[wall.opening]] as TOML, from closed rectangles. `unit` ("mm") overrides the unit of the file;
// "": the file's own. Throws InputError with every fault, IoError where the file can't be read.
[[nodiscard]] std::string drawing_text(const std::string& path, const std::string& unit,
                                       const DrawingLayers& layers = {});

// What was ignored in the drawing from which a model's blocks come; empty for other models.
[[nodiscard]] std::vector<Message> notes_of_drawing(const ModelSpec& spec);

}  // namespace wythe
