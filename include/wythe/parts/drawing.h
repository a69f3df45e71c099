// A facade from a drawing (DXF) as the text of a model file.
#pragma once

#include <string>
#include <vector>

#include "wythe/parts/message.h"

namespace wythe {

struct ModelSpec;

// Where what is drawn; upper and lower case are the same. "none": there is none.
struct DrawingLayers {
  std::string outline = "outline", openings = "openings", lintels = "lintels";
};
// [wall] and its [[wall.opening]] as TOML, from closed rectangles; `unit` ("mm") goes before what the file states,
// "": the file's. Throws InputError with every fault, IoError where the file can't be read.
[[nodiscard]] std::string drawing_text(const std::string& path, const std::string& unit,
                                       const DrawingLayers& layers = {});

// What was left aside of the drawing that a model's blocks come from; empty for other models.
[[nodiscard]] std::vector<Message> notes_of_drawing(const ModelSpec& spec);

}  // namespace wythe
