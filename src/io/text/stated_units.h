// Properties of the wall for rules of materials: the sizes of units in the masonry
// of a material, as given for its storeys, and the joints that have a material.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

namespace wythe::io {

struct StatedSize {
  double value = 0;  // [m]; NaN where it can't be read
  std::string path;  // "wall.unit.height", "storey.ground.unit.height"
};

// The sizes for `material`, or for the whole wall if it is not a joint of a storey or region. `key` is course_height,
// unit_length or joint_thickness. Only different sizes, from the ground up; empty where none is given.
[[nodiscard]] std::vector<StatedSize> stated_sizes(const toml::table& root,
                                                   const std::string& material,
                                                   const std::string& key);

// Whether some bed joints of the masonry are of `material`, and whether the head joints between
// them have it too. They do unless head_joint of region, storey or wall names another one.
[[nodiscard]] bool has_beds_of(const toml::table& root, const std::string& material);
[[nodiscard]] bool has_heads_of_beds(const toml::table& root, const std::string& material);

}  // namespace wythe::io
