// JSON of blocks -> BlockSpec or, in space, BodySpec, in metres.
//
//   {"units": "m", "thickness": 0.2, "blocks": [{"id": "b1", "polygon": [[x, y], ...],
//    "material": "stone", "fixed": false, "beam": false}, ...]}
//                                                    or "zones": 4, "zone_length": 0.05, "zone_kind":
//                                                    "mixed", "plane": "stress" of a deformable one
//                                                    or in space "vertices" and "faces", "parts" of these,
//                                                    or "z": [z0, z1] beside the polygon
//   {"units": "m", "blocks_xyxy": [[x0, y0, x1, y1], ...], "loading_beam_xyxy": [x0, y0, x1, y1]}
#include "io/bodies/blocks_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "core/files.h"
#include "core/text.h"
#include "io/bodies/bodies_file.h"
#include "io/bodies/dxf.h"
#include "io/bodies/other_format.h"
#include "io/keys/describe.h"
#include "io/text/json.h"
#include "io/text/magnitude.h"
#include "wythe/parts/io.h"

namespace wythe::io {
namespace {

using Point = std::array<double, 2>;

std::string short_dump(const nlohmann::json& json) {
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

class BlocksReader {
 public:
  BlocksReader(ReadContext& context, std::string file, ModelSpec& spec)
      : context_(context), file_(std::move(file)), spec_(spec) {}

  // The number of file units in a metre. Bodies stay in the file's units and axes.
  [[nodiscard]] double units_in_a_metre() const { return scale_; }
  [[nodiscard]] bool is_compas() const { return is_compas_; }
  [[nodiscard]] const std::string& up() const { return up_; }

  void read(const std::string& text) {
    const nlohmann::json json = parse_json(text, file_);
    is_compas_ = io::is_compas(json);
    if (is_compas_) {
      up_ = "z";
      return parse_compas(json);
    }
    if (!json.is_object()) return refuse("", short_dump(json), "must be a JSON object", kForms);
    if (json.contains("type") && json.contains("features"))
      return refuse("", "", "is GeoJSON, which holds places on a map", kForms);
    parse_units(json);
    parse_up(json);
    parse_thickness(json);
    const bool has_boxes = json.contains("blocks_xyxy");
    if (json.contains("blocks") && has_boxes)
      refuse("blocks_xyxy", "", "stands beside \"blocks\"", "keep one of the two");
    else if (json.contains("blocks"))
      parse_polygons(json["blocks"]);
    else if (has_boxes)
      parse_boxes(json);
    else
      refuse("", "", "has neither \"blocks\" nor \"blocks_xyxy\"", kForms);
    if (json.contains("up") && spec_.body.empty() && context_.faults.empty())
      refuse("up", short_dump(json["up"]), "has no effect: the blocks lie in a plane",
             "leave it out, or give each block a depth, e.g. \"z\": [0, 0.25]");
  }

 private:
  static constexpr const char* kForms =
      R"(write e.g. {"units": "m", "blocks": [{"id": "b1", "polygon": [[0, 0], [1, 0], [1, 1]]}]})";

  void refuse(const std::string& where, const std::string& value, const std::string& problem,
              const std::string& cure) {
    const std::string path = where.empty() ? "wall.blocks" : "wall.blocks." + where;
    context_.faults.add(
        {.file = file_, .path = path, .value = value, .problem = problem, .cure = cure});
  }

  void parse_compas(const nlohmann::json& json) {
    FaultList faults;
    spec_.body = compas_bodies(json, file_, faults);
    for (Fault fault : faults.all()) {
      fault.path = "wall.blocks";
      context_.faults.add(std::move(fault));
    }
  }

  void parse_units(const nlohmann::json& json) {
    const nlohmann::json units = json.value("units", nlohmann::json());
    if (units == "mm") scale_ = 1e3;
    if (units == "m" || units == "mm") return;
    const std::string value = units.is_null() ? "" : short_dump(units);
    refuse("units", value, units.is_null() ? "is missing" : "must be \"m\" or \"mm\"",
           R"(write "units": "m" or "units": "mm")");
  }

  void parse_up(const nlohmann::json& json) {
    const nlohmann::json up = json.value("up", nlohmann::json("y"));
    if (up != "y" && up != "z")
      return refuse("up", short_dump(up), R"(must be "y" or "z")", R"(write "up": "z")");
    if (spec_.wall.up.empty()) up_ = up.get<std::string>();
  }

  void parse_thickness(const nlohmann::json& json) {
    if (!json.contains("thickness") || json["thickness"].is_null()) return;
    const auto value = parse_number(json["thickness"]);
    if (!value || *value <= 0 || !magnitude_problem(*value, "m").empty())
      return refuse("thickness", short_dump(json["thickness"]),
                    "must be a number, 1 nm or more and up to 10 km",
                    R"(write e.g. "thickness": 0.2)");
    if (std::isnan(spec_.wall.thickness)) spec_.wall.thickness = *value;
  }

  // In metres; divides, so that 200 mm is the double nearest to 0.2.
  [[nodiscard]] std::optional<double> parse_number(const nlohmann::json& json) const {
    if (!json.is_number() || !kCoordinate.holds(json.get<double>() / scale_)) return std::nullopt;
    return json.get<double>() / scale_;
  }

  void parse_polygons(const nlohmann::json& blocks) {
    if (!blocks.is_array() || blocks.empty())
      return refuse("blocks", short_dump(blocks), "must be a list of blocks", kForms);
    for (std::size_t i = 0; i < blocks.size() && !enough(context_.faults); ++i)
      if (is_in_space(blocks[i]))
        parse_body_block(blocks[i], i);
      else
        parse_polygon_block(blocks[i], i);
    if (!spec_.body.empty() && !spec_.block.empty())
      refuse(spec_.block.front().id, "", "lies in the plane, beside blocks in space",
             R"(give every block a depth, e.g. "z": [0, 0.25])");
  }

  void parse_body_block(const nlohmann::json& json, std::size_t index) {
    BodySpec body;
    body.id = "b" + std::to_string(index + 1);
    parse_word(json, "id", body.id, body.id);
    parse_word(json, "material", body.material, body.id);
    parse_flag(json, "fixed", body.fixed, body.id);
    parse_word(json, "role", body.role, body.id);
    if (const std::string cure = role_advice(body.role); !cure.empty())
      refuse(body.id + ".role", "\"" + body.role + "\"", "is no role of a block", cure);
    parse_word(json, "cut", body.cut, body.id);
    parse_word(json, "put_in", body.put_in, body.id);
    parse_zones(json, body.id, body.zone);
    refuse_unknown(json, body.id, kBodyKeys);
    parse_body_parts(json, body,
                     [&](const std::string& where, const nlohmann::json& value,
                         const std::string& problem, const std::string& cure) {
                       refuse(body.id + '.' + where, value.is_null() ? "" : short_dump(value),
                              value.is_null() ? "is missing or null" : problem, cure);
                     });
    note_id(body.id);
    spec_.body.push_back(std::move(body));
  }

  void parse_polygon_block(const nlohmann::json& json, std::size_t index) {
    if (!json.is_object())
      return refuse(std::to_string(index), short_dump(json), "must be a JSON object", kForms);
    BlockSpec block;
    block.id = "b" + std::to_string(index + 1);
    parse_word(json, "id", block.id, block.id);
    parse_word(json, "material", block.material, block.id);
    parse_flag(json, "fixed", block.fixed, block.id);
    parse_flag(json, "beam", block.beam, block.id);
    parse_zones(json, block.id, block.zone);
    refuse_unknown(json, block.id, kBlockKeys);
    parse_outline(json.value("polygon", nlohmann::json()), block);
    keep(std::move(block));
  }

  void parse_word(const nlohmann::json& json, const char* name, std::string& value,
                  const std::string& id) {
    if (!json.contains(name)) return;
    const nlohmann::json& found = json[name];
    if (found.is_string() && !found.get<std::string>().empty())
      value = found.get<std::string>();
    else if (found.is_number_integer() && std::string_view(name) == "id")
      value = found.dump();
    else
      refuse(id + '.' + name, short_dump(found), "must be a text", "");
  }

  void parse_flag(const nlohmann::json& json, const char* name, bool& value,
                  const std::string& id) {
    if (!json.contains(name)) return;
    if (json[name].is_boolean())
      value = json[name].get<bool>();
    else
      refuse(id + '.' + name, short_dump(json[name]), "must be true or false", "");
  }

  void parse_zones(const nlohmann::json& json, const std::string& id, ZoneSpec& zone) {
    if (json.contains("zones")) {
      const nlohmann::json& count = json["zones"];
      if (count.is_number_integer() && count.get<std::int64_t>() >= 0 && count < 10000)
        zone.zones = count.get<int>();
      else
        refuse(id + ".zones", short_dump(count), "must be a whole number of zones, 0 or more",
               R"(write e.g. "zones": 2)");
    }
    if (json.contains("zone_length")) {
      const auto length = parse_number(json["zone_length"]);
      if (length && *length > 0 && magnitude_problem(*length, "m").empty())
        zone.length = *length;
      else
        refuse(id + ".zone_length", short_dump(json["zone_length"]), "must be a number more than 0",
               "leave it out for zones as long as deep");
    }
    parse_choice(json, "zone_kind", kZoneKindWords, zone.kind, id);
    parse_choice(json, "plane", kPlaneWords, zone.plane, id);
    for (const char* name : {"zone_length", "zone_kind", "plane"})
      if (json.contains(name) && !json.contains("zones"))
        refuse(id + '.' + name, short_dump(json[name]), "has no effect: the block has no zones",
               R"(write "zones" too, or leave it out)");
  }

  template <class Enum, std::size_t n>
  void parse_choice(const nlohmann::json& json, const char* name, const Word<Enum> (&words)[n],
                    Enum& value, const std::string& id) {
    if (!json.contains(name)) return;
    std::string allowed;
    for (const Word<Enum>& word : words) {
      allowed += (allowed.empty() ? "\"" : ", \"") + std::string(word.word) + "\"";
      if (json[name] == word.word) {
        value = word.value;
        return;
      }
    }
    refuse(id + '.' + name, short_dump(json[name]), "must be one of " + allowed, "");
  }

  inline static const std::vector<std::string> kBlockKeys = {
      "id", "polygon", "material", "fixed", "beam", "zones", "zone_length", "zone_kind", "plane"};
  inline static const std::vector<std::string> kBodyKeys = {
      "id",    "material",    "fixed",     "vertices", "faces", "parts", "polygon", "z",
      "zones", "zone_length", "zone_kind", "plane",    "role",  "cut",   "put_in"};

  void refuse_unknown(const nlohmann::json& json, const std::string& id,
                      const std::vector<std::string>& known) {
    for (const auto& item : json.items())
      if (!enough(context_.faults) &&
          std::find(known.begin(), known.end(), item.key()) == known.end())
        refuse(id + '.' + item.key(), short_dump(item.value()), "no such key",
               name_advice(item.key(), known));
  }

  void parse_outline(const nlohmann::json& json, BlockSpec& block) {
    const std::string where = block.id + ".polygon";
    if (json.is_null())
      return refuse(where, "", "is missing", R"(write e.g. "polygon": [[0, 0], [1, 0], [1, 1]])");
    if (!json.is_array() || json.size() < 3)
      return refuse(where, short_dump(json), "must have 3 vertices or more", "");
    for (const nlohmann::json& vertex : json) {
      if (enough(context_.faults)) return;
      const bool pair = vertex.is_array() && vertex.size() == 2;
      const auto x = pair ? parse_number(vertex[0]) : std::nullopt;
      const auto y = pair ? parse_number(vertex[1]) : std::nullopt;
      if (x && y)
        block.polygon.push_back({*x, *y});
      else if (!is_far(where, vertex))
        refuse(where, short_dump(vertex), "must be two finite numbers [x, y] within 10 km", "");
    }
  }

  // Whether all are numbers and one is beyond 10 km, as in survey coordinates; reported as one fault.
  bool is_far(const std::string& where, const nlohmann::json& numbers) {
    if (!numbers.is_array() || numbers.empty() ||
        !std::all_of(numbers.begin(), numbers.end(), [](const nlohmann::json& n) {
          return n.is_number() && std::isfinite(n.get<double>());
        }))
      return false;
    const bool far = std::any_of(numbers.begin(), numbers.end(),
                                 [this](const nlohmann::json& n) { return !parse_number(n); });
    if (far && !is_far_told_)
      refuse(where, short_dump(numbers), "lies more than 10 km from the origin",
             "move all blocks towards the origin, or check their unit");
    is_far_told_ = is_far_told_ || far;
    return far;
  }

  void parse_boxes(const nlohmann::json& json) {
    const nlohmann::json& boxes = json["blocks_xyxy"];
    if (!boxes.is_array() || boxes.empty())
      return refuse("blocks_xyxy", short_dump(boxes), "must be a list of boxes",
                    R"(write e.g. "blocks_xyxy": [[0, 0, 0.2, 0.1]])");
    for (std::size_t i = 0; i < boxes.size() && !enough(context_.faults); ++i) {
      BlockSpec block;
      block.id = "b" + std::to_string(i + 1);
      parse_box(boxes[i], std::move(block));
    }
    if (!json.contains("loading_beam_xyxy")) return;
    BlockSpec beam;
    beam.id = beam.material = "beam";
    beam.beam = true;
    parse_box(json["loading_beam_xyxy"], std::move(beam));
  }

  void parse_box(const nlohmann::json& json, BlockSpec block) {
    std::vector<double> at;
    for (const nlohmann::json& item : json.is_array() ? json : nlohmann::json::array())
      if (const auto value = parse_number(item)) at.push_back(*value);
    const bool good =
        json.is_array() && json.size() == 4 && at.size() == 4 && at[0] < at[2] && at[1] < at[3];
    if (!good && is_far(block.id, json)) return;
    if (!good)
      return refuse(block.id, short_dump(json),
                    "must be four finite numbers x0 < x1, y0 < y1 within 10 km",
                    "write them as [x0, y0, x1, y1]");
    block.polygon = {Point{at[0], at[1]}, Point{at[2], at[1]}, Point{at[2], at[3]},
                     Point{at[0], at[3]}};
    keep(std::move(block));
  }

  void keep(BlockSpec block) {
    note_id(block.id);
    spec_.block.push_back(std::move(block));
  }

  void note_id(const std::string& id) {
    if (!ids_.insert(id).second)
      refuse(id, id, "two blocks have this id", "give each block an id of its own");
  }

  ReadContext& context_;
  std::string file_;
  ModelSpec& spec_;
  double scale_ = 1;  // file units in a metre
  bool is_compas_ = false;
  bool is_far_told_ = false;
  std::string up_ = "y";
  std::set<std::string> ids_;
};

// Adds a fault at a key of [wall] that the user gave.
void refuse_key(ReadContext& context, const toml::table& root, const char* key,
                const std::string& problem, const std::string& cure) {
  const toml::node* node = root["wall"][key].node();
  context.fault(std::string("wall.") + key, node ? line_of(*node) : 0, node ? shown(*node) : "",
                problem, cure);
}

// Each closed polyline is a block. Its layer gives the material, or says that the block is fixed or the beam.
void parse_drawn_blocks(ReadContext& context, const toml::table& root, const std::string& file,
                        const std::string& unit, ModelSpec& spec) {
  const Drawing drawing = parse_drawing(file, unit);
  if (!unit.empty() && !drawing.stated_unit.empty() && drawing.stated_unit != unit)
    refuse_key(context, root, "blocks_unit",
               fmt::format("stands against the drawing, which states {}", drawing.stated_unit),
               fmt::format("leave it out; or if the drawing is in {}, state that there too "
                           "($INSUNITS, by the command UNITS)",
                           unit));
  if (drawing.outlines.empty() && drawing.unread.empty() &&
      (!drawing.hidden.empty() || drawing.invisible > 0))
    context.faults.add(
        {file, "wall.blocks", joined(drawing.hidden, ", "),
         "shows no outline: all lie on layers that are off or frozen, or are invisible",
         "show them in the drawing program", 0});
  for (const Unread& entity : drawing.unread)
    if (!enough(context.faults)) context.faults.add(fault_of(entity, file));
  for (const DrawnOutline& outline : drawing.outlines) {
    BlockSpec block;
    block.id =
        outline.handle.empty() ? "b" + std::to_string(spec.block.size() + 1) : outline.handle;
    block.fixed = same_layer(outline.layer, "fixed");
    block.beam = same_layer(outline.layer, "beam");
    if (outline.layer != "0") block.material = outline.layer;
    block.polygon = outline.corners;
    spec.block.push_back(std::move(block));
  }
}

void refuse_far_bodies(ReadContext& context, const std::string& file, const ModelSpec& spec) {
  for (const BodySpec& body : spec.body)
    for (const Polyhedron& part : body.part)
      for (const Vec3 v : part.vertex) {
        const bool good =
            kCoordinate.holds(v.x) && kCoordinate.holds(v.y) && kCoordinate.holds(v.z);
        if (good || enough(context.faults)) continue;
        context.faults.add({file, "wall.blocks." + body.id,
                            fmt::format("{:.4g} {:.4g} {:.4g} m", v.x, v.y, v.z),
                            "lies farther than 10 km from the origin",
                            "move the blocks to the origin, or check their unit", 0});
        break;
      }
}

// Converts bodies from the file's units and axes to the wall's, and fixes supports by name.
void settle_bodies(ReadContext& context, const toml::table& root, const std::string& file,
                   double units_in_a_metre, ModelSpec& spec) {
  if (spec.wall.up != "y" && spec.wall.up != "z")
    return refuse_key(context, root, "up", "must be \"y\" or \"z\"", "write up = \"z\"");
  place(spec.body, units_in_a_metre, spec.wall.up == "z");
  refuse_far_bodies(context, file, spec);
  FaultList faults;
  fix_supports(spec.body, spec.wall.supports, faults);
  for (const Fault& fault : faults.all()) {
    const toml::node* node = root["wall"]["supports"].node();
    context.fault(fault.path, node ? line_of(*node) : 0, fault.value, fault.problem, fault.cure);
  }
}

// Meshes and COMPAS files have no unit, and a wall in millimetres read as metres weighs 1e9 times as much.
double stated_scale(ReadContext& context, const toml::table& root, const std::string& unit) {
  const double scale = unit.empty() ? 0 : units_in_a_metre(unit);
  if (scale == 0)
    refuse_key(context, root, "blocks_unit",
               unit.empty() ? "is missing: this file states no unit" : "is no unit that is read",
               "write one of " + drawing_units() + ", e.g. blocks_unit = \"m\"");
  return scale > 0 ? scale : 1;
}

void parse_meshes(ReadContext& context, const toml::table& root, const std::string& file,
                  const std::string& unit, ModelSpec& spec) {
  const double scale = stated_scale(context, root, unit);
  FaultList faults;
  spec.body = parse_mesh_bodies(file, faults);
  for (Fault fault : faults.all()) {
    fault.path = "wall.blocks";
    context.faults.add(std::move(fault));
  }
  if (spec.wall.up.empty()) spec.wall.up = "z";
  if (faults.empty()) settle_bodies(context, root, file, scale, spec);
}

void read_json(ReadContext& context, const toml::table& root, const std::string& file,
               const std::string& unit, ModelSpec& spec, const std::string& text) {
  const std::size_t before = context.faults.all().size();
  BlocksReader reader(context, file, spec);
  if (text.empty()) {
    const std::string own = read_text(file, kMostJson);
    refuse_other_format(file, own);
    reader.read(own);
  } else {
    reader.read(text);
  }
  if (!unit.empty() && text.empty() && !reader.is_compas())
    refuse_key(context, root, "blocks_unit", "has no meaning here: a JSON file states its units",
               "leave it out");
  if (spec.body.empty()) {
    for (const char* key : {"up", "supports"})
      if (root["wall"][key].node() != nullptr)
        refuse_key(context, root, key, "has no meaning here: the blocks lie in a plane",
                   "leave it out");
    return;
  }
  const double scale =
      reader.is_compas() ? stated_scale(context, root, unit) : reader.units_in_a_metre();
  if (spec.wall.up.empty()) spec.wall.up = reader.up();
  if (context.faults.all().size() == before) settle_bodies(context, root, file, scale, spec);
}

}  // namespace

void parse_blocks(ReadContext& context, const toml::table& root, ModelSpec& spec,
                  const std::string& text) {
  const std::string file = (std::filesystem::path(spec.folder) / spec.wall.blocks).string();
  const bool is_drawn = is_drawing(file);
  const toml::node* stated = root["wall"]["blocks_unit"].node();
  const std::string unit = stated ? shown(*stated) : "";
  try {
    if (is_drawn && text.empty())
      parse_drawn_blocks(context, root, file, unit, spec);
    else if (is_mesh_file(file) && text.empty())
      parse_meshes(context, root, file, unit, spec);
    else
      read_json(context, root, file, is_drawn || is_mesh_file(file) ? "" : unit, spec, text);
  } catch (const InputError& error) {
    for (Fault fault : error.faults()) {
      if (fault.path.empty() || !is_drawn) fault.path = "wall.blocks";
      context.faults.add(std::move(fault));
    }
  } catch (const IoError& error) {
    const toml::node* node = root["wall"]["blocks"].node();
    const std::string near = nearest_file(file);
    context.fault(
        "wall.blocks", node ? line_of(*node) : 0, spec.wall.blocks, error.what(),
        near.empty()
            ? "the path counts from the folder of the model file"
            : fmt::format("did you mean {}?",
                          (std::filesystem::path(spec.wall.blocks).parent_path() / near).string()));
  }
}

std::string blocks_text(const std::vector<BlockSpec>& blocks, double thickness) {
  nlohmann::json list = nlohmann::json::array();
  for (const BlockSpec& block : blocks) {
    list.push_back({{"id", block.id},
                    {"polygon", block.polygon},
                    {"material", block.material},
                    {"fixed", block.fixed},
                    {"beam", block.beam}});
    if (block.zone.zones == 0) continue;
    list.back()["zones"] = block.zone.zones;
    if (!std::isnan(block.zone.length)) list.back()["zone_length"] = block.zone.length;
    list.back()["zone_kind"] = word_of(kZoneKindWords, block.zone.kind);
    list.back()["plane"] = word_of(kPlaneWords, block.zone.plane);
  }
  nlohmann::json file = {{"units", "m"}};
  if (std::isfinite(thickness)) file["thickness"] = thickness;
  file["blocks"] = std::move(list);
  return file.dump(1) + "\n";
}

std::string blocks_text(const ModelSpec& spec, bool with_thickness) {
  if (!spec.body.empty()) return bodies_text(spec.body, spec.wall.up == "z");
  return blocks_text(spec.block, with_thickness ? spec.wall.thickness : kUnset);
}

}  // namespace wythe::io
