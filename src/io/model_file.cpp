// read_model, parse_model: text -> tree -> overrides -> ModelSpec -> blocks file.
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "io/blocks_json.h"
#include "io/toml_reader.h"
#include "wythe/io.h"

namespace wythe {
namespace io {

void finish(Reader& reader, ContactRule&) {
  if (!reader.has("between")) reader.miss("between", "is missing, a contact rule needs it");
  if (!reader.has("material"))
    reader.miss("material", "is missing, a contact rule needs it",
                "write e.g. material = \"joint\"");
}

void finish(Reader& reader, ModelSpec& model) {
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

}  // namespace io

ModelSpec parse_model(const std::string& toml_text, const std::string& file_name,
                      const std::vector<std::string>& overrides, const std::string& blocks) {
  toml::table root = io::parse_toml(toml_text, file_name);
  io::ReadContext context{file_name};
  io::apply_overrides(context, root, overrides);
  ModelSpec spec;
  spec.folder = std::filesystem::path(file_name).parent_path().string();
  io::read_table(context, root, "", spec);
  if (!spec.wall.blocks.empty()) io::read_blocks(context, root, spec, blocks);
  io::throw_faults(context);
  return spec;
}

ModelSpec read_model(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_model(io::read_text(path), path, overrides);
}

}  // namespace wythe
