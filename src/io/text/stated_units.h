// The sizes of unit that the masonry of a material has, as its storeys state them: what rules ask of the wall.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

namespace wythe::io {

struct StatedSize {
  double value = 0;  // [m]; NaN where it can't be read
  std::string path;  // "wall.unit.height", "storey.ground.unit.height"
};

// Of `material`, or of the whole wall where it is no joint of a storey or region; `key` is course_height,
// unit_length or joint_thickness. Different sizes only, from the ground up; empty where none is stated.
[[nodiscard]] std::vector<StatedSize> stated_sizes(const toml::table& root,
                                                   const std::string& material,
                                                   const std::string& key);

}  // namespace wythe::io
