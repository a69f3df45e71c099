// read_model, parse_model: text -> tree -> overrides -> ModelSpec -> blocks file.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "geometry/builder/builder.h"
#include "io/bodies/blocks_json.h"
#include "io/keys/meant_names.h"
#include "io/keys/model_key.h"
#include "io/model/builder_file.h"
#include "io/model/record_file.h"
#include "io/text/thousands.h"
#include "io/text/toml_reader.h"
#include "wythe/parts/io.h"
#include "wythe/parts/study.h"

namespace wythe {
namespace io {

void finish(TableReader& reader, ContactRule&) {
  if (!reader.has("between")) reader.miss("between", "is missing, a contact rule needs it");
  if (!reader.has("material"))
    reader.miss("material", "is missing, a contact rule needs it",
                "write e.g. material = \"joint\"");
}

namespace {

// Refuses a table without `kind`, because it has properties of something
// that is not there. kind = "" leaves it out on purpose, as a variant does.
void need_kind(TableReader& reader, const char* what, const char* example) {
  const auto& entries = reader.entries();
  const auto stands = [](const TableReader::Entry& entry) { return entry.node != nullptr; };
  if (reader.has("kind") || reader.has_unknown() ||
      std::none_of(entries.begin(), entries.end(), stands))
    return;
  reader.miss("kind",
              fmt::format("is missing: without it the opening has no {0}, and this table says how "
                          "the {0} is",
                          what),
              fmt::format("write e.g. kind = \"{}\", or leave the {} out", example, what));
}

}  // namespace

void finish(TableReader& reader, LintelSpec&) { need_kind(reader, "lintel", "timber"); }
void finish(TableReader& reader, SillSpec&) { need_kind(reader, "sill", "stone"); }
void finish(TableReader& reader, ArchSpec&) { need_kind(reader, "arch", "segmental"); }

namespace {

// A storey or wall without a `split` mode for its units takes that of the wall.
template <class Table>
void inherit_split(const TableReader& reader, const char* name, const ModelSpec& model,
                   std::vector<Table>& tables) {
  for (const TableReader::Entry& entry : reader.entries()) {
    const toml::array* list = entry.name == name && entry.node ? entry.node->as_array() : nullptr;
    for (std::size_t i = 0; list && i < tables.size(); ++i) {
      const toml::table* table = list->get(i)->as_table();
      if (!(*table)["unit"]["split"]) tables[i].unit.split = model.wall.unit.split;
    }
  }
}

// Refuses two members of one name: --set and a study find a member by name, and would take the first.
template <class Spec>
void refuse_same_names(TableReader& reader, const char* list, const std::vector<Spec>& members) {
  std::set<std::string> names;
  const std::string path = std::string_view(list) == "opening" ? under("wall", list) : list;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (!members[i].name.empty() && !names.insert(members[i].name).second)
      reader.refuse_member(path, i, "name", fmt::format("two {}s have this name", list),
                           fmt::format("give each {} a name of its own", list));
}

}  // namespace

void finish(TableReader& reader, ModelSpec& model) {
  inherit_split(reader, "storey", model, model.storey);
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
  refuse_same_names(reader, "opening", model.wall.opening);
  refuse_same_names(reader, "region", model.region);
  refuse_same_names(reader, "floor", model.floor);
  names.clear();
  for (std::size_t i = 0; i < model.history.size(); ++i) {
    const std::string& name = model.history[i].name;
    if (name.empty() && (reader.context().has_fault_at(fmt::format("history.{}.name", i)) ||
                         reader.context().has_fault_at("history")))
      continue;
    if (name.empty() || !names.insert(name).second)
      reader.refuse_member("history", i, "name",
                           name.empty() ? "is missing" : "two points have this name",
                           "give each point a name of its own");
  }
}

namespace {

// Notes each key of the tree and, in lists, also by its member's name: "stage.2.at", "stage.push.at".
// Numbers of a list have a place of their own only where they stand in another line than the list.
void note_places(const toml::node& node, const std::string& path, const std::string& file,
                 std::map<std::string, KeyPlace>& places) {
  places.emplace(path, KeyPlace{file, line_of(node), ""});
  if (const toml::table* table = node.as_table())
    for (const auto& [name, inner] : *table)
      note_places(inner, under(path, std::string(name.str())), file, places);
  const toml::array* list = node.as_array();
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const toml::node& member = *list->get(i);
    if (member.is_value() && line_of(member) == line_of(node)) continue;
    note_places(member, under(path, std::to_string(i)), file, places);
  }
  for (std::size_t i = 0; list && i < list->size();
       ++i) {  // a number stays a place, also where it is another member's name
    const toml::node& member = *list->get(i);
    const toml::table* table = member.as_table();
    const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
    if (name) note_places(member, under(path, *name), file, places);
  }
}

// A key that an option set, and all keys below it, belong to the option.
void note_overrides(const ReadContext& context, std::map<std::string, KeyPlace>& places) {
  for (const Override& set : context.overrides)
    for (auto& [path, place] : places)
      if (path == set.path || path.starts_with(set.path + '.'))
        place = {"--set", 0, set.given + path.substr(set.path.size())};
}

KeyPlaces places_of(const toml::table& root, const ReadContext& context) {
  KeyPlaces places;
  note_places(root, "", context.file, places.key);
  note_overrides(context, places.key);
  return places;
}

// Refuses settings without effect: a key that the formula of a field sets
// at each place, also within a whole table. If the settings give the
// formula too, they are those of a sample, and its value is the mean.
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

// The materials of the mortar of layers: of [[layer]] the names under mortar.joint.
std::set<std::string, std::less<>> mortars_in(const toml::table& root) {
  std::set<std::string, std::less<>> names;
  if (const toml::array* layers = root["layer"].as_array())
    for (const toml::node& layer : *layers)
      if (const toml::table* table = layer.as_table())
        if (const auto name = (*table)["mortar"]["joint"].value<std::string>()) names.insert(*name);
  return names;
}
}  // namespace

BuilderSpec parse_builder(const std::string& file, const toml::table& root, const ModelSpec& spec) {
  ReadContext silent{file};
  TableReader reader(silent, root, "");
  BuilderSpec built;
  describe(reader, built);
  inherit_split(reader, "plan_wall", spec, built.plan_wall);
  return built;
}

namespace {

// Refuses keys of a beam that does not exist, and of a blocks file that is not given.
void refuse_keys_of_nothing(const ModelSpec& spec, bool has_unit, FaultList& faults) {
  const WallSpec& wall = spec.wall;
  const auto refuse = [&](const char* path, bool stated, const char* problem, const char* cure) {
    if (stated) faults.add({"", path, "", problem, cure, 0});
  };
  const BeamSpec bare;
  const bool has_beam = !std::isnan(wall.beam.height);
  const char* const no_beam = "has no effect: the wall has no beam";
  const char* const beam_cure = "give the beam its height, or leave this out";
  refuse("wall.beam.density", !has_beam && wall.beam.density != bare.density, no_beam, beam_cure);
  refuse("wall.beam.rotation", !has_beam && wall.beam.rotation != bare.rotation, no_beam,
         beam_cure);
  refuse("wall.beam.joint", !has_beam && wall.beam.joint != bare.joint, no_beam, beam_cure);
  refuse("wall.unit_joint", !spec.block.empty() && !wall.joints.unit_joint.empty(),
         "has no effect: blocks of a file are whole units",
         "leave it out, or name it in a rule of [[contact]]");
  if (!wall.blocks.empty()) return;
  const char* const no_file = "has no effect: the wall is built, and no blocks file is read";
  refuse("wall.blocks_unit", has_unit, no_file, "leave it out, or name blocks");
  refuse("wall.supports", !wall.supports.empty(), no_file, "leave it out, or name blocks");
}

// Notes quantities of a tree that most likely mean thousands: "12.000 kg".
void note_thousands(const toml::node& node, const std::string& path, std::vector<Message>& notes) {
  if (const toml::table* table = node.as_table())
    for (const auto& [name, inner] : *table)
      note_thousands(inner, under(path, std::string(name.str())), notes);
  if (const toml::array* list = node.as_array())
    for (std::size_t i = 0; i < list->size(); ++i) {
      const toml::table* table = list->get(i)->as_table();
      const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
      note_thousands(*list->get(i), under(path, name.value_or(std::to_string(i))), notes);
    }
  if (const auto* text = node.as_string())
    if (const std::string thousands = as_thousands(text->get()); !thousands.empty())
      notes.push_back(
          {"value.thousands", {{"key", path}, {"value", text->get()}, {"thousands", thousands}}});
}

}  // namespace
}  // namespace io

ModelSpec parse_model(const std::string& toml_text, const std::string& file_name,
                      const std::vector<std::string>& overrides, const std::string& blocks,
                      const std::map<std::string, std::string>& records) {
  toml::table root = io::parse_toml(toml_text, file_name);
  io::refuse_study(root, file_name);
  io::ReadContext context{file_name};
  context.records = &records;
  io::apply_overrides(context, root, overrides);
  ModelSpec spec;
  io::note_thousands(root, "", spec.text_notes);
  io::read_names_as_meant(context, root, io::known_names<ModelSpec>());
  KeyPlaces places = io::places_of(root, context);
  const toml::node_view<toml::node> plaster = root["masonry"]["reinforced_plaster"];
  const bool is_plastered = plaster && plaster.value_or(true);
  io::resolve_materials(context, root);
  io::resolve_floors(context, root);
  context.mortars = io::mortars_in(root);
  spec.folder = std::filesystem::path(file_name).parent_path().string();
  io::parse_table(context, root, "", spec);
  if (is_plastered && !spec.layer.empty())
    spec.text_notes.push_back(
        {"layer.counted_twice", {{"key", std::string("masonry.reinforced_plaster")}}});
  if (!spec.wall.blocks.empty())
    places.blocks = (std::filesystem::path(spec.folder) / spec.wall.blocks).string();
  spec.places = std::make_shared<const KeyPlaces>(std::move(places));
  const BuilderSpec built = io::parse_builder(file_name, root, spec);
  if (!spec.wall.blocks.empty() && built.empty() && !context.has_fault_at("wall.blocks"))
    io::parse_blocks(context, root, spec, blocks);
  io::parse_records(context, spec);
  io::throw_faults(context);
  try {
    FaultList idle;
    io::refuse_keys_of_nothing(spec, static_cast<bool>(root["wall"]["blocks_unit"]), idle);
    if (built.empty() && spec.wall.blocks.empty() && !spec.wall.up.empty())
      idle.add({"", "wall.up", spec.wall.up,
                "has no effect: this wall lies in its plane, where y points up",
                "leave it out, or lay the wall with [[plan_wall]]", 0});
    idle.throw_if_any();
    if (!built.empty()) lay_bodies(built, spec);
    io::refuse_idle(spec, context);
    draw_fields(spec);
  } catch (const InputError& error) {
    throw InputError(spec.places->placed(error.faults()));
  }
  return spec;
}

ModelSpec read_model(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_model(io::read_input(path, "model.toml"), path, overrides);
}

}  // namespace wythe
