// Blocks files, COMPAS, drawings and meshes, through to the assembled wall.
#include "fuzz/model_texts.h"
#include "fuzz/targets.h"
#include "wythe/parts/io.h"

namespace wythe::fuzz {
namespace {

void read_file_of_blocks(const std::string& name, const std::string& bytes,
                         const std::string& more) {
  put(name, bytes);
  static_cast<void>(compile(parse_model(wall_of(name, more), (scratch() / "model.toml").string())));
}

void parse_blocks(const std::string& bytes) {
  read_file_of_blocks("blocks.json", bytes, "thickness = \"0.2 m\"\n");
}
void parse_compas(const std::string& bytes) {
  read_file_of_blocks("compas.json", bytes, "blocks_unit = \"m\"\nsupports = [\"lowest\"]\n");
}
void read_drawn(const std::string& bytes) {
  read_file_of_blocks("stones.dxf", bytes, "blocks_unit = \"m\"\nthickness = \"1 m\"\n");
}
void read_solids(const std::string& name, const std::string& bytes) {
  read_file_of_blocks(name, bytes, "blocks_unit = \"m\"\nsupports = [\"lowest\"]\n");
}
void parse_obj(const std::string& bytes) { read_solids("stones.obj", bytes); }
void parse_ply(const std::string& bytes) { read_solids("stones.ply", bytes); }
void parse_stl(const std::string& bytes) { read_solids("stones.stl", bytes); }

}  // namespace

std::vector<Target> solid_targets() {
  return {{"blocks", parse_blocks}, {"compas", parse_compas}, {"dxf", read_drawn},
          {"obj", parse_obj},       {"ply", parse_ply},       {"stl", parse_stl}};
}

}  // namespace wythe::fuzz
