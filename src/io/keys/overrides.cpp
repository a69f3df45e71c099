// --set path=value: values put into the TOML tree before it is read, so that they pass the same checks as the file.
// Members of a list are found by index or by their `name`.
#include <algorithm>

#include <fmt/format.h>

#include "core/number.h"
#include "core/text.h"
#include "io/text/toml_reader.h"
#include "io/text/toml_writer.h"

namespace wythe::io {
namespace {

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> steps;
  std::size_t begin = 0;
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin)) {
    steps.push_back(path.substr(begin, dot - begin));
    begin = dot + 1;
  }
  steps.push_back(path.substr(begin));
  return steps;
}

// Sets the value in TOML form, or as a text where it is not TOML: 1 mm/s, running, +x.
void put_value(toml::table& table, const std::string& key, const std::string& text) {
  try {
    toml::table parsed = parse_toml("value = " + text, "--set");
    if (toml::node* value = parsed.size() == 1 ? parsed.get("value") : nullptr) {
      value->visit([&](auto& node) { table.insert_or_assign(key, std::move(node)); });
      return;
    }
  } catch (const InputError&) {
  }
  table.insert_or_assign(key, text);
}

std::optional<std::size_t> index_in(const toml::array& list, const std::string& step) {
  if (const auto index = parse_number<std::size_t>(step))
    return *index < list.size() ? index : std::nullopt;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const toml::table* member = list.get(i)->as_table();
    const auto name = member ? (*member)["name"].value<std::string>() : std::nullopt;
    if (name == step) return i;
  }
  return std::nullopt;
}

std::vector<std::string> member_names(const toml::array& list) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const toml::table* member = list.get(i)->as_table();
    const auto name = member ? (*member)["name"].value<std::string>() : std::nullopt;
    names.push_back(name.value_or(std::to_string(i)));
  }
  return names;
}

std::string member_advice(const toml::array& list, const std::string& step) {
  const bool is_index = !step.empty() && step.find_first_not_of("0123456789") == std::string::npos;
  if (is_index) return fmt::format("it has {}, counted from 0", list.size());
  return name_advice(step, member_names(list));
}

// Follows one --set through the tree.
class Walk {
 public:
  Walk(ReadContext& context, std::string given, std::string value)
      : context_(context), given_(std::move(given)), value_(std::move(value)) {}

  void put(toml::table& root) {
    const std::vector<std::string> steps = split_path(given_);
    if (steps.size() > kMostDepth) {
      refuse(fmt::format("has {} steps, at most {} are followed", steps.size(), kMostDepth),
             "write e.g. stage.push.velocity");
      return;
    }
    toml::node* node = &root;
    for (std::size_t i = 0; i + 1 < steps.size() && node; ++i) node = descend(*node, steps[i]);
    if (node) put_last(*node, steps.back());
  }

 private:
  toml::node* descend(toml::node& node, const std::string& step) {
    if (toml::array* list = node.as_array()) return member(*list, step);
    toml::table* table = node.as_table();
    if (!table) return refuse(fmt::format("{} is a value, nothing stands below it", path_), "");
    path_ = under(path_, step);
    toml::node* next = table->get(step);
    if (!next) next = &table->insert_or_assign(step, toml::table{}).first->second;
    return next;
  }

  toml::node* member(toml::array& list, const std::string& step) {
    const auto index = index_in(list, step);
    if (!index)
      return refuse(fmt::format("{} has no member {}", path_, step), member_advice(list, step));
    path_ = under(path_, std::to_string(*index));
    return list.get(*index);
  }

  void put_last(toml::node& node, const std::string& step) {
    if (toml::array* list = node.as_array()) {
      if (toml::node* found = member(*list, step)) put_item(*list, *found);
      return;
    }
    toml::table* table = node.as_table();
    if (!table) {
      refuse(fmt::format("{} is a value, nothing stands below it", path_), "");
      return;
    }
    put_value(*table, step, value_);
    path_ = under(path_, step);
    context_.overrides.push_back({path_, given_});
  }

  // Sets an item of a list of values, e.g. output.states.0=5 mm.
  void put_item(toml::array& list, const toml::node& item) {
    toml::table holder;
    put_value(holder, "value", value_);
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const auto& n) { return &n == &item; });
    holder.get("value")->visit([&](auto& value) { list.replace(at, std::move(value)); });
    context_.overrides.push_back({path_, given_});
  }

  toml::node* refuse(const std::string& problem, const std::string& cure) {
    context_.faults.add(
        {.file = "--set", .path = given_, .value = value_, .problem = problem, .cure = cure});
    return nullptr;
  }

  ReadContext& context_;
  std::string given_, value_;
  std::string path_;
};

}  // namespace

void list_settings(const toml::table& table, const std::string& path,
                   std::vector<std::string>& texts) {
  for (const auto& [key, node] : table) {
    const std::string at = under(path, std::string(key.str()));
    if (const toml::table* inner = node.as_table())
      list_settings(*inner, at, texts);
    else
      texts.push_back(
          fmt::format("{}={}", at, node.is_string() ? quoted(shown(node)) : shown(node)));
  }
}

void apply_overrides(ReadContext& context, toml::table& root,
                     const std::vector<std::string>& texts) {
  if (texts.size() > kMostSettings) {
    context.faults.add({.file = "--set",
                        .value = fmt::format("{} settings", texts.size()),
                        .problem = fmt::format("at most {} are taken", kMostSettings),
                        .cure = "write them into the model"});
    return;
  }
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string path(trimmed(text.substr(0, equals)));
    if (equals == std::string::npos || path.empty()) {
      context.faults.add(
          {.file = "--set",
           .path = path,
           .problem = equals == std::string::npos ? "has no '='" : "has no path before '='",
           .cure = "write path=value, e.g. --set stage.push.velocity=\"1 mm/s\""});
      continue;
    }
    Walk(context, path, std::string(trimmed(text.substr(equals + 1)))).put(root);
  }
}

}  // namespace wythe::io
