// The numbers of a model that a study may set: every quantity and every number key, from the model's
// own description, with its unit and admissible values.
#pragma once

#include <string>
#include <vector>

#include "io/describe.h"

namespace wythe::io {

// Whether a setting of `path` sets the key too: it is its path, or that of a table around it.
inline bool lies_in(const std::string& key, const std::string& path) {
  return key == path || key.starts_with(path + '.');
}

struct ModelKey {
  std::string path;   // members of a list by name: stage.push.velocity
  std::string alias;  // the same by index: stage.2.velocity
  std::string si_unit = "1", unit = "1";
  Range range;
  double value = kUnset;  // of this model [SI]
};

[[nodiscard]] std::vector<ModelKey> number_keys(ModelSpec model);
// The key at a path as --set takes it, or nullptr.
[[nodiscard]] const ModelKey* find_key(const std::vector<ModelKey>& keys, const std::string& path);
// What to write instead of a path that is none: the nearest, or what stands where it goes wrong.
[[nodiscard]] std::string key_advice(const std::vector<ModelKey>& keys, const std::string& path);

}  // namespace wythe::io
