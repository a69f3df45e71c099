// read_model, parse_model: text -> tree -> overrides -> ModelSpec -> blocks file.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "io/blocks_json.h"
#include "io/model_key.h"
#include "io/toml_reader.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe {
namespace io {

void finish(TableReader& reader, ContactRule&) {
  if (!reader.has("between")) reader.miss("between", "is missing, a contact rule needs it");
  if (!reader.has("material"))
    reader.miss("material", "is missing, a contact rule needs it",
                "write e.g. material = \"joint\"");
}

namespace {

// A storey that does not say how its units split has the wall's way.
void inherit_split(const TableReader& reader, ModelSpec& model) {
  for (const TableReader::Entry& entry : reader.entries()) {
    const toml::array* list =
        entry.name == "storey" && entry.node ? entry.node->as_array() : nullptr;
    for (std::size_t i = 0; list && i < model.storey.size(); ++i) {
      const toml::table* storey = list->get(i)->as_table();
      if (!(*storey)["unit"]["split"]) model.storey[i].unit.split = model.wall.unit.split;
    }
  }
}

}  // namespace

void finish(TableReader& reader, ModelSpec& model) {
  inherit_split(reader, model);
  if (model.stage.empty() && !reader.context().has_fault_at("stage"))
    reader.miss("stage", "is missing, a model needs at least one stage",
                "write [[stage]] and under it name = \"gravity\"");
  std::set<std::string> names;
  for (std::size_t i = 0; i < model.stage.size(); ++i) {
    const std::string& name = model.stage[i].name;
    if (!name.empty() && !names.insert(name).second)
      reader.refuse_member("stage", i, "name", "two stages have this name",
                           "give each stage a name of its own");
  }
}

namespace {

// Where a key stands in the user's words: a line of a file, or an option as typed.
struct KeyPlace {
  std::string file;  // "model.toml", or "--set"
  int line = 0;
  std::string given;  // the key as the option has it; "": as it is
};
using Places = std::map<std::string, KeyPlace>;

// Every key of the tree and, in lists, the same by its member's name: "stage.2.at", "stage.push.at".
void note_places(const toml::node& node, const std::string& path, const std::string& file,
                 Places& places) {
  places.emplace(path, KeyPlace{file, line_of(node), ""});
  if (const toml::table* table = node.as_table())
    for (const auto& [name, inner] : *table)
      note_places(inner, under(path, std::string(name.str())), file, places);
  const toml::array* list = node.as_array();
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const toml::node& member = *list->get(i);
    note_places(member, under(path, std::to_string(i)), file, places);
    const toml::table* table = member.as_table();
    const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
    if (name) note_places(member, under(path, *name), file, places);
  }
}

// A key that an option set, and all below it, is the option's.
void note_overrides(const ReadContext& context, Places& places) {
  for (const Override& set : context.overrides)
    for (auto& [path, place] : places)
      if (path == set.path || path.starts_with(set.path + '.'))
        place = {"--set", 0, set.given + path.substr(set.path.size())};
}

// The fault with the place of its key, or of the nearest table above it that the user wrote.
Fault placed(Fault fault, const Places& places) {
  if (!fault.file.empty()) return fault;
  for (std::string path = fault.path;; path.resize(path.find_last_of('.'))) {
    const auto found = places.find(path);
    if (found != places.end()) {
      fault.file = found->second.file;
      fault.line = found->second.line;
      if (!found->second.given.empty())
        fault.path = found->second.given + fault.path.substr(path.size());
      return fault;
    }
    if (path.find('.') == std::string::npos) break;
  }
  fault.file = places.at("").file;
  return fault;
}

// The faults of a spec, each with the place of its key.
[[noreturn]] void throw_placed(const InputError& error, const ModelSpec& spec,
                               const toml::table& root, const ReadContext& context) {
  Places places;
  note_places(root, "", context.file, places);
  note_overrides(context, places);
  const std::string blocks = (std::filesystem::path(spec.folder) / spec.wall.blocks).string();
  std::vector<Fault> faults;
  for (Fault fault : error.faults()) {
    if (!spec.wall.blocks.empty() && fault.path.starts_with("wall.blocks.")) fault.file = blocks;
    faults.push_back(placed(std::move(fault), places));
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const Fault& a, const Fault& b) { return a.line < b.line; });
  throw InputError(std::move(faults));
}

// A setting of a key that the formula of a field sets anew at each place would change nothing, nor would that
// key in a whole table. Where the settings give the formula too they are those of a sample, whose value stands
// there as its mean.
void refuse_idle(const ModelSpec& spec, const ReadContext& context) {
  FaultList faults;
  for (const auto& [name, field] : spec.field) {
    const std::string formula = "field." + name + ".formula";
    const auto is_given = [&](const Override& set) { return lies_in(formula, set.path); };
    if (field.formula.empty() ||
        std::any_of(context.overrides.begin(), context.overrides.end(), is_given))
      continue;
    for (const Override& set : context.overrides) {
      if (!lies_in(field.path, angle_path(set.path))) continue;
      const bool whole = angle_path(set.path) != field.path;
      faults.add(
          {"", set.path, "",
           fmt::format("{}has no effect, it is set by {}",
                       whole ? "its " + field.path.substr(set.path.size() + 1) + " " : "", formula),
           fmt::format("{}, or change {} instead, e.g. --set {}=\"...\"",
                       whole ? "set its other keys one by one" : "leave it out", formula, formula),
           0});
    }
  }
  faults.throw_if_any();
}

}  // namespace
}  // namespace io

ModelSpec parse_model(const std::string& toml_text, const std::string& file_name,
                      const std::vector<std::string>& overrides, const std::string& blocks) {
  toml::table root = io::parse_toml(toml_text, file_name);
  io::ReadContext context{file_name};
  io::apply_overrides(context, root, overrides);
  io::resolve_materials(context, root);
  ModelSpec spec;
  spec.folder = std::filesystem::path(file_name).parent_path().string();
  io::read_table(context, root, "", spec);
  if (!spec.wall.blocks.empty()) io::read_blocks(context, root, spec, blocks);
  io::throw_faults(context);
  try {
    io::refuse_idle(spec, context);
    draw_fields(spec);
  } catch (const InputError& error) {
    io::throw_placed(error, spec, root, context);
  }
  return spec;
}

Model compile_model(const ModelSpec& spec, const std::string& toml_text,
                    const std::string& file_name, const std::vector<std::string>& overrides) {
  try {
    return compile(spec);
  } catch (const InputError& error) {
    toml::table root = io::parse_toml(toml_text, file_name);
    io::ReadContext context{file_name};
    io::apply_overrides(context, root, overrides);
    io::throw_placed(error, spec, root, context);
  }
}

Model read_and_compile(const std::string& path, const std::vector<std::string>& overrides,
                       ModelSpec* spec) {
  const std::string text = io::read_input(path, "model.toml");
  ModelSpec read = parse_model(text, path, overrides);
  Model model = compile_model(read, text, path, overrides);
  if (spec != nullptr) *spec = std::move(read);
  return model;
}

ModelSpec read_model(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_model(io::read_input(path, "model.toml"), path, overrides);
}

}  // namespace wythe
