// Walks the descriptions of a model and of the builder's tables and lists each number with its path and unit. Keys
// of other kinds of stage are left out. A wrong path is corrected from the left, step by step. A key is idle (has
// no effect) if a field's formula sets it, if no rule uses it, or if the model gives the angle.
#include "io/keys/model_key.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "campaign/draws/scatter.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/model/builder_file.h"
#include "io/text/toml_reader.h"

namespace wythe::io {
namespace {

class KeyLister {
 public:
  KeyLister(std::vector<ModelKey>& out, std::string path, std::string alias)
      : out_(out), path_(std::move(path)), alias_(std::move(alias)) {}

  void quantity(const char* name, const double& value, const Key& key) {
    add(name, value, key, key.unit, key.shown);
  }
  void number(const char* name, const double& value, const Key& key) {
    add(name, value, key, "1", "1");
  }
  void recipe(const char* name, const Key& key) {
    if (!std::isfinite(key.range.low)) return;
    add(name, kUnset, key, *key.unit ? key.unit : "1", *key.unit ? key.shown : "1");
  }
  void quantities(const char*, const std::vector<double>&, const Key&) {}
  void numbers(const char*, const std::vector<double>&, const Key&) {}
  void points(const char*, const std::vector<std::array<double, 2>>&, const Key&) {}
  void integer(const char*, const int&, const Key&) {}
  void flag(const char*, const bool&, const Key&) {}
  void text(const char*, const std::string&, const Key&) {}
  void texts(const char*, const std::vector<std::string>&, const Key&) {}
  template <class E, std::size_t N>
  void choice(const char*, const E& value, const Word<E> (&)[N], const Key&) {
    if constexpr (std::is_same_v<E, StageKind>) kind_ = kind_bit(value);
  }
  template <class T>
  void table(const char* name, T& value, const Key& key) {
    if (!is_foreign(key)) inside(value, name, name);
  }
  template <class T>
  void list(const char* name, std::vector<T>& values, const Key&) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string index = fmt::format("{}.{}", name, i);
      std::string label;
      if constexpr (requires { values[i].name; }) label = values[i].name;
      inside(values[i], label.empty() ? index : fmt::format("{}.{}", name, label), index);
    }
  }
  template <class T>
  void map(const char* name, std::map<std::string, T>& values, const Key&) {
    for (auto& [label, value] : values) {
      const std::string step = fmt::format("{}.{}", name, label);
      inside(value, step, step);
    }
  }

 private:
  template <class T>
  void inside(T& value, const std::string& name, const std::string& index) {
    KeyLister inner(out_, under(path_, name), under(alias_, index));
    describe(inner, value);
  }

  // Whether a key belongs to other kinds of stage than the listed one.
  [[nodiscard]] bool is_foreign(const Key& key) const {
    return kind_ != 0 && key.kinds != 0 && !(key.kinds & kind_);
  }

  void add(const char* name, double value, const Key& key, const char* si_unit, const char* unit) {
    if (is_foreign(key)) return;
    out_.push_back({.path = under(path_, name),
                    .alias = under(alias_, name),
                    .si_unit = si_unit,
                    .unit = unit,
                    .range = key.range,
                    .value = value});
  }

  std::vector<ModelKey>& out_;
  std::string path_, alias_;
  Kinds kind_ = 0;
};

// The part of `path` up to the next dot, from `from` on.
std::string step_at(const std::string& path, std::size_t from) {
  return path.substr(from, path.find('.', from) - from);
}

}  // namespace

template <class Spec>
static std::vector<ModelKey> keys_of(Spec& spec) {
  std::vector<ModelKey> out;
  KeyLister lister(out, "", "");
  describe(lister, spec);
  return out;
}

std::vector<ModelKey> number_keys(ModelSpec model) { return keys_of(model); }

const ModelKey* find_key(const std::vector<ModelKey>& keys, const std::string& path) {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const ModelKey& key) {
    return key.path == path || key.alias == path;
  });
  return found == keys.end() ? nullptr : &*found;
}

SettableKeys::SettableKeys(const std::string& text, const std::string& file,
                           const std::vector<std::string>& settings, const ModelSpec& base)
    : keys_(number_keys(base)) {
  toml::table root = parse_toml(text, file);
  ReadContext context{file};
  apply_overrides(context, root, settings);
  // a formula of [scatter] uses the value of the key
  const auto is_made = [&](const std::string& name) {
    return name.starts_with(study::kScatterPrefix) && !root["field"][name]["formula"];
  };
  for (const auto& [name, field] : base.field)
    if (!field.formula.empty() && !is_made(name)) formula_[field.path] = name;
  // replaces keys that stand for others: rules of [masonry], tangents for angles
  resolve_materials(context, root);
  BuilderSpec built = parse_builder(file, root, base);
  for (ModelKey& key : keys_of(built)) keys_.push_back(std::move(key));
  asked_ = std::move(context.asked);
  for (const auto& [path, value] : context.derived)
    if (value.how.starts_with("given as ")) tangents_.insert(path);
}

std::pair<std::string, std::string> SettableKeys::idle(const std::string& path) const {
  if (const auto field = formula_.find(angle_path(path)); field != formula_.end())
    return {fmt::format("has no effect, it is set by field.{}.formula", field->second),
            fmt::format("leave it out, vary what the formula names, or leave field.{} out",
                        field->second)};
  if (path.starts_with("masonry.") && !asked_.contains(path.substr(8)))
    return {"no rule of the base model asks for it",
            "let a material ask for a rule that does, e.g. tensile_strength = \"rule\""};
  const std::string name = path.substr(path.rfind('.') + 1);
  if (!path.starts_with("material.") || !name.ends_with("friction_tan")) return {};
  const std::string angle = angle_path(path);
  if (tangents_.contains(angle)) return {};
  return {fmt::format("the base model gives no {}", name),
          fmt::format("write {} there in the place of the angle, or vary {}", name, angle)};
}

std::string SettableKeys::advice(const std::string& path) const {
  // the longest correct part of it, and possible next parts
  std::string right;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1)) {
    const std::string part = path.substr(0, dot + 1);
    if (std::any_of(keys_.begin(), keys_.end(),
                    [&](const ModelKey& key) { return key.path.starts_with(part); }))
      right = part;
  }
  std::vector<std::string> next;
  for (const ModelKey& key : keys_) {
    if (!key.path.starts_with(right)) continue;
    const std::string step = step_at(key.path, right.size());
    if (next.size() <= kMostCandidates && std::find(next.begin(), next.end(), step) == next.end())
      next.push_back(step);
  }
  const std::string wrong = step_at(path, right.size());
  if (const std::string near = nearest_name(wrong, next); !near.empty()) {
    const std::string whole = right + near + path.substr(right.size() + wrong.size());
    if (find_key(keys_, whole) != nullptr) return fmt::format("did you mean {}?", whole);
    if (near != wrong) return advice(whole + (whole == right + near ? "." : ""));
  }
  return fmt::format("known in {}: {}",
                     right.empty() ? "the model" : right.substr(0, right.size() - 1),
                     joined(next, ", "));
}

}  // namespace wythe::io
