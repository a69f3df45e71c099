// A facade from a drawing (DXF) as the text of a model file.
#pragma once

#include <string>

namespace wythe {

// Where what is drawn; upper and lower case are the same. "none": there is none.
struct DrawingLayers {
  std::string outline = "outline", openings = "openings", lintels = "lintels";
};
// [wall] and its [[wall.opening]] as TOML, from closed rectangles; `unit` ("mm") goes before what the file states,
// "": the file's. Throws InputError with every fault, IoError where the file can't be read.
[[nodiscard]] std::string drawing_text(const std::string& path, const std::string& unit,
                                       const DrawingLayers& layers = {});

}  // namespace wythe
