// Checks each option and parses its study from the text again, because a copied tree loses its lines. Formulas
// of dependent quantities change the study, all other settings the base model. Settings of drawn values are
// refused, because all options share the samples. Faults of an option's study have the option's line.
#include "io/study/variants.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/ascii.h"
#include "core/text.h"
#include "io/keys/describe_study.h"
#include "wythe/parts/text.h"

namespace wythe::io {
namespace {

constexpr const char* kDrawn[] = {"study.", "variable.", "correlation.", "variant."};

std::string path_of(const std::string& setting) {
  return std::string(trimmed(setting.substr(0, setting.find('='))));
}

// "Steel lintel, 200 mm" -> "steel_lintel_200_mm": letters and digits of ASCII.
std::string folder_of(const std::string& name) {
  std::string out;
  for (const char c : small_letters(name)) {
    const bool plain = is_ascii_letter(c) || is_digit(c);
    if (plain)
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  if (!out.empty() && out.back() == '_') out.pop_back();
  return out;
}

void check_folder_name(TableReader& reader, VariantSpec& option, const VariantTables& before) {
  if (!reader.has("name")) return reader.miss("name", "is missing", "write e.g. name = \"tie\"");
  if (std::any_of(option.name.begin(), option.name.end(), [](unsigned char c) { return c < ' '; }))
    return reader.refuse("name", "has a character that cannot be shown", "write it on one line");
  option.folder = folder_of(option.name);
  if (option.folder.empty())
    return reader.refuse("name", "has no letter or digit to name a folder",
                         "write a name with some of a-z and 0-9");
  if (option.folder.size() > 100)
    return reader.refuse("name", "is too long for the name of a folder",
                         "write at most 100 letters");
  if (option.folder == kBaseFolder)
    return reader.refuse("name", "is the name of what options are compared with",
                         "name what the option changes");
  for (const VariantSpec& other : before.option)
    if (other.folder == option.folder)
      return reader.refuse(
          "name", fmt::format("would have the folder {} of \"{}\"", other.folder, other.name),
          "give each option a name of its own");
}

void check_settings(TableReader& reader, const VariantSpec& option) {
  for (const std::string& setting : option.set) {
    const std::string path = path_of(setting);
    for (const char* drawn : kDrawn)
      if (path.starts_with(drawn))
        reader.refuse("set",
                      fmt::format("{} would change the samples, which all options share", path),
                      "leave it out, or change it for the whole study");
    if (path.starts_with("dependent.") && !path.ends_with(".formula"))
      reader.refuse("set", fmt::format("{} is none that an option may change", path),
                    "write dependent.<name>.formula=...");
  }
  if (option.set.empty() && !reader.has("model") &&
      !reader.context().has_fault_in(reader.below("set")))
    reader.refuse_table("changes nothing",
                        "write set = [\"path=value\"] or model = \"other.toml\"");
}

// Changes the tree of the whole file into that of one option; returns its settings of the base model.
std::vector<std::string> put_variant(ReadContext& context, toml::table& root,
                                     const VariantSpec& option) {
  root.erase("variant");
  toml::table* study = root["study"].as_table();
  if (study && !option.model.empty()) {
    study->erase("model_text");
    study->erase("blocks_text");
    study->insert_or_assign("model", option.model);
    if (!option.model_text.empty()) study->insert_or_assign("model_text", option.model_text);
    if (!option.blocks_text.empty()) study->insert_or_assign("blocks_text", option.blocks_text);
  }
  std::vector<std::string> own, settings;
  for (const std::string& setting : option.set)
    (path_of(setting).starts_with("dependent.") ? own : settings).push_back(setting);
  apply_overrides(context, root, own);
  return settings;
}

}  // namespace

VariantTables take_variants(ReadContext& context, toml::table& root) {
  VariantTables out;
  out.base = kBaseFolder;
  const toml::node* node = root.get("variant");
  if (!node) return out;
  const toml::array* list = node->as_array();
  const bool good = list && std::all_of(list->begin(), list->end(),
                                        [](const toml::node& item) { return item.is_table(); });
  if (!good) {
    context.fault("variant", line_of(*node), shown(*node), "must be a list of tables",
                  "write each under [[variant]], with two brackets");
  } else {
    for (std::size_t i = 0; i < list->size() && !enough(context.faults); ++i) {
      const toml::table& table = *list->get(i)->as_table();
      TableReader reader(context, table, under("variant", std::to_string(i)));
      VariantSpec option;
      describe(reader, option);
      reader.refuse_unknown();
      check_folder_name(reader, option, out);
      check_settings(reader, option);
      out.line[option.name] = line_of(table);
      out.option.push_back(std::move(option));
    }
  }
  root.erase("variant");
  return out;
}

void VariantTables::add_faults(const std::string& file, const VariantSpec& of,
                               const InputError& error) {
  for (Fault fault : error.faults()) {
    const bool own_setting =
        fault.file == "--set" &&
        std::any_of(of.set.begin(), of.set.end(),
                    [&](const std::string& setting) { return path_of(setting) == fault.path; });
    fault.path = fmt::format("variant \"{}\": {}", of.name, fault.path);
    if (own_setting || fault.file == file) {
      fault.file = file;
      fault.line = line[of.name];
    }
    faults.push_back(std::move(fault));
  }
}

void VariantTables::throw_if_any() {
  if (!faults.empty()) throw InputError(std::move(faults));
}

void parse_options(StudySpec& study, VariantTables variants, const StudySource& source,
                   const ReadTree& read) {
  if (variants.option.empty()) return;
  study.variant = variants.base;
  // TOML trees lose their lines when copied, so each option parses the text again
  for (VariantSpec& option : variants.option) {
    toml::table tree = parse_toml(source.text, source.file);
    ReadContext context{source.file};
    apply_overrides(context, tree, source.own);
    std::vector<std::string> all = source.settings;
    for (const std::string& setting : put_variant(context, tree, option)) all.push_back(setting);
    try {
      option.study = read(context, tree, std::move(all));
    } catch (const InputError& error) {
      variants.add_faults(source.file, option, error);
      continue;
    }
    option.study.variant = option.name;
    option.study.variant_place = 1 + static_cast<int>(&option - variants.option.data());
    option.study.name = study.name.empty() ? option.name : study.name + ": " + option.name;
  }
  variants.throw_if_any();
  study.option = std::move(variants.option);
}

}  // namespace wythe::io
