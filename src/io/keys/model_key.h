// The numbers of a model that a study may set: every quantity and every number key, from the model's
// own description, with its unit and admissible values.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/keys/describe.h"

namespace wythe::io {

// Whether a setting of `path` also sets the key: `path` is its path, or a table around it.
inline bool lies_in(const std::string& key, const std::string& path) {
  return key == path || key.starts_with(path + '.');
}

struct ModelKey {
  std::string path;   // members of a list by name: stage.push.velocity
  std::string alias;  // the same with the index: stage.2.velocity
  std::string si_unit = "1", unit = "1";
  Range range;
  double value = kUnset;  // in this model [SI]
};

[[nodiscard]] std::vector<ModelKey> number_keys(ModelSpec model);
// The key at a path as --set takes it, or nullptr.
[[nodiscard]] const ModelKey* find_key(const std::vector<ModelKey>& keys, const std::string& path);

// The numbers of a model's text that may be set.
class SettableKeys {
 public:
  SettableKeys() = default;
  // `base` is the model from the text with its settings.
  SettableKeys(const std::string& text, const std::string& file,
               const std::vector<std::string>& settings, const ModelSpec& base);

  [[nodiscard]] bool empty() const { return keys_.empty(); }
  [[nodiscard]] const ModelKey* find(const std::string& path) const {
    return find_key(keys_, path);
  }
  // Whether a field of the model sets this key at each place by its own formula.
  // A formula of [scatter] does not count, because it uses the key's value.
  [[nodiscard]] bool has_formula(const std::string& path) const { return formula_.contains(path); }
  // The cure for a wrong path: the nearest one, or the possible parts at the place of the error.
  [[nodiscard]] std::string advice(const std::string& path) const;
  // Why setting this key would have no effect or contradict the model, and the cure; "" where it has an effect.
  [[nodiscard]] std::pair<std::string, std::string> idle(const std::string& path) const;

 private:
  std::vector<ModelKey> keys_;
  std::set<std::string, std::less<>> asked_;  // keys of [masonry] that the model's rules use
  std::set<std::string> tangents_;            // angles that the model gives as tangents
  std::map<std::string, std::string>
      formula_;  // fields that set a key anew at each place, by that key
};

}  // namespace wythe::io
