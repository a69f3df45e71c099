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

// The numbers that a model's text lets others set.
class SettableKeys {
 public:
  SettableKeys() = default;
  // `base` is what the text with its settings gave.
  SettableKeys(const std::string& text, const std::string& file,
               const std::vector<std::string>& settings, const ModelSpec& base);

  [[nodiscard]] bool empty() const { return keys_.empty(); }
  [[nodiscard]] const ModelKey* find(const std::string& path) const {
    return find_key(keys_, path);
  }
  // Whether a field of the model sets this key anew at each place by its own formula; one that [scatter] made does
  // not, for it begins from the key.
  [[nodiscard]] bool has_formula(const std::string& path) const { return formula_.contains(path); }
  // What to write instead of a path that is none: the nearest, or what stands where it goes wrong.
  [[nodiscard]] std::string advice(const std::string& path) const;
  // Why setting this key would change nothing or contradict the model, and the cure; "" where it acts.
  [[nodiscard]] std::pair<std::string, std::string> idle(const std::string& path) const;

 private:
  std::vector<ModelKey> keys_;
  std::set<std::string, std::less<>> asked_;  // keys of [masonry] that the model's rules take
  std::set<std::string> tangents_;            // angles that it gives as tangents
  std::map<std::string, std::string>
      formula_;  // fields that set a key anew at each place, by that key
};

}  // namespace wythe::io
