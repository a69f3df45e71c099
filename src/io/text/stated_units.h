// What rules of materials need to know of the wall: the sizes of units in the masonry of a material, as its storeys
// state them, and which joints have a material.
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

// Whether some bed joints of the masonry are of `material`, and whether the head joints between them take it too: no
// head_joint of region, storey or wall names another.
[[nodiscard]] bool has_beds_of(const toml::table& root, const std::string& material);
[[nodiscard]] bool has_heads_of_beds(const toml::table& root, const std::string& material);

}  // namespace wythe::io
