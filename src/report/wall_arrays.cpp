// Writes a wall's shapes and states to arrays, under the names that web/src/wall/wall.ts reads. An array is
// indexed by block, joint or node. Numbers of states are rounded to 16 bits over all frames. A joint
// that became a free contact has the opening -1 and is not drawn. A field has the unit of its key.
#include "report/wall_arrays.h"

#include <algorithm>
#include <cmath>

#include "model/field_places.h"
#include "report/translation.h"
#include "report/wall_picture.h"
#include "wythe/parts/field_notes.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/units.h"

namespace wythe::report {
namespace {

template <class To, class From>
std::vector<To> as(const std::vector<From>& values) {
  std::vector<To> out;
  out.reserve(values.size());
  for (const From& v : values) out.push_back(static_cast<To>(v));
  return out;
}

void add_floats(Bundle& bundle, const std::string& name, const std::vector<double>& values) {
  bundle.add(name, as<float>(values));
}

// Words for the numbers of an enum in an array.
template <class E, std::size_t N>
Json words_by_number(const Word<E> (&words)[N]) {
  Json list = Json::array();
  for (std::size_t number = 0; number < N; ++number)
    list.push_back(word_of(words, static_cast<E>(number)));
  return list;
}

// The stage that pushes, or nullptr.
const Stage* push_of(const Model& model) {
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage)
    if (!stage->driven.empty()) return &*stage;
  return nullptr;
}

// One number from each entry of a list.
template <class Rows, class Value>
void add_column(Bundle& bundle, const std::string& name, const Rows& rows, Value value) {
  std::vector<float> column;
  column.reserve(rows.size());
  for (const auto& row : rows) column.push_back(static_cast<float>(value(row)));
  bundle.add(name, column);
}

// The nodes of zones, the outlines of deformable blocks by nodes, and the zones' corners.
void add_nodes(Bundle& bundle, const Solids& s) {
  std::vector<std::int32_t> rim, corners;  // four a zone
  for (const SolidBody& body : s.bodies) rim.insert(rim.end(), body.rim.begin(), body.rim.end());
  bundle.add("wall.rim", rim);
  add_floats(bundle, "wall.node_x", s.node_x);
  add_floats(bundle, "wall.node_y", s.node_y);
  for (int z = 0; z < s.n_zone; ++z)
    for (const auto& corner : s.corner) corners.push_back(corner[z]);
  bundle.add("wall.zone", corners);
}

// Deformable blocks follow the rigid ones, each with the nodes on its outline.
void add_blocks(Bundle& bundle, const Model& model) {
  const Solids& s = model.solids;
  const State rest = initial_state(model);
  std::vector<std::int32_t> begin = {0};
  std::vector<Vec3> outline;
  std::vector<BlockReading> blocks;
  for (BlockId b = 0; b < block_count(model); ++b) {
    for (const Vec3& corner : outline_of(model, b)) outline.push_back(corner);
    begin.push_back(static_cast<std::int32_t>(outline.size()));
    blocks.push_back(read_block(model, rest, b));
  }
  std::vector<double> thickness = model.anatomy.block_thickness;
  for (const SolidBody& body : s.bodies)
    thickness.push_back(s.shapes[s.zone_shape[body.first_zone]].thickness);
  std::vector<std::uint8_t> role;
  for (const BlockReading& block : blocks) role.push_back(static_cast<std::uint8_t>(block.role));
  bundle.add("wall.outline_begin", begin);
  add_column(bundle, "wall.outline_x", outline, [](const Vec3& p) { return p.x; });
  add_column(bundle, "wall.outline_y", outline, [](const Vec3& p) { return p.y; });
  add_column(bundle, "wall.centroid_x", blocks, [](const auto& b) { return b.start.x; });
  add_column(bundle, "wall.centroid_y", blocks, [](const auto& b) { return b.start.y; });
  add_floats(bundle, "wall.thickness", thickness);
  bundle.add("wall.role", role);
  if (!s.bodies.empty()) add_nodes(bundle, s);
}

// Contacts of zones follow the joints. They lie between a rigid block and a deformable one, along an edge.
void add_joints(Bundle& bundle, const Model& model) {
  const Solids& s = model.solids;
  std::vector<JointShape> joints;
  std::vector<BlockId> a, b;
  std::vector<std::uint8_t> kind;
  for (JointId j = 0; j < joint_count(model); ++j) {
    joints.push_back(joint_shape(model, j));
    a.push_back(joints.back().a);
    b.push_back(joints.back().b);
    kind.push_back(static_cast<std::uint8_t>(joints.back().kind));
  }
  bundle.add("wall.joint_a", a);
  bundle.add("wall.joint_b", b);
  bundle.add("wall.kind", kind);
  add_column(bundle, "wall.half_x", joints, [](const auto& j) { return j.half.x; });
  add_column(bundle, "wall.half_y", joints, [](const auto& j) { return j.half.y; });
  joints.resize(model.n_joint);  // contacts have nodes, not arms
  add_column(bundle, "wall.arm_a_x", joints, [](const auto& j) { return j.arm_a.x; });
  add_column(bundle, "wall.arm_a_y", joints, [](const auto& j) { return j.arm_a.y; });
  add_column(bundle, "wall.arm_b_x", joints, [](const auto& j) { return j.arm_b.x; });
  add_column(bundle, "wall.arm_b_y", joints, [](const auto& j) { return j.arm_b.y; });
  if (s.n_contact == 0) return;
  bundle.add("wall.contact_p", s.contact_p);
  bundle.add("wall.contact_q", s.contact_q);
  add_floats(bundle, "wall.share_0", s.share_0);
  add_floats(bundle, "wall.share_1", s.share_1);
}

// Ties, diaphragms and springs with their ends relative to the centroids; `along` is the direction from a to b at the start.
Json links_of(const Model& model) {
  const Links& l = model.links;
  const State rest = initial_state(model);
  const std::vector<LinkReading> links = read_links(model, rest);
  const auto arm = [&](BlockId block, const Vec3& end) {
    if (block == kGroundBlock) return Json{0, 0};
    const Vec3 from = end - read_block(model, rest, block).start;
    return Json{from.x, from.y};
  };
  Json list = Json::array();
  for (std::size_t k = 0; k < links.size(); ++k)
    list.push_back({{"name", l.name[k]},
                    {"kind", word_of(kLinkKindWords, l.kind[k])},
                    {"a", l.a[k]},
                    {"b", l.b[k]},
                    {"arm_a", arm(l.a[k], links[k].ends[0])},
                    {"arm_b", arm(l.b[k], links[k].ends[1])},
                    {"along", {l.span_x[k], l.span_y[k]}}});
  return list;
}

// Two directions of the plane that a section of a frame stands in, as its members have it: along the wall and up.
struct PlaneWays {
  Vec3 along{1, 0, 0}, up{0, 1, 0};
};
PlaneWays plane_of(const Model& model, std::size_t section) {
  if (dimension_of(model) == 2) return {};
  const Frames& f = model.frames;
  const FrameMember& member = f.members[f.member[section]];
  // a foot at the end of the way looks back along it
  const bool back = f.a[section] == kGroundBlock && f.place[section] > 0.5 * member.length;
  const double forth = back ? -1 : 1, x = member.direction_x, y = member.direction_y;
  const Vec3 way = forth * Vec3{f.axis_x[section], f.axis_y[section], f.axis_z[section]};
  const Vec3 left = forth * f.left[section];
  return {x * way - y * left, y * way + x * left};
}

// Members of frames, and sections along them where they stand on their block; in space also the plane of each.
void add_members(Json& wall, const Model& model) {
  const Frames& f = model.frames;
  const State rest = initial_state(model);
  const std::vector<FrameReading> read = read_frames(model, rest);
  Json members = Json::array(), sections = Json::array();
  for (const FrameMember& member : f.members)
    members.push_back({{"frame", f.name[member.frame]},
                       {"words", translated(member.words)},
                       {"length", member.length},
                       {"way", {member.direction_x, member.direction_y}}});
  for (std::size_t k = 0; k < f.a.size(); ++k) {
    const BlockReading block = read_block(model, rest, f.b[k]);
    const Vec3 arm = read[k].where - block.start - block.moved;
    const auto [along, up] = plane_of(model, k);
    sections.push_back({{"member", f.member[k]},
                        {"place", f.place[k]},
                        {"a", f.a[k]},
                        {"b", f.b[k]},
                        {"arm", {dot(arm, along), dot(arm, up)}}});
    if (dimension_of(model) == 3)
      members[f.member[k]].update(
          {{"along", {along.x, along.y, along.z}}, {"up", {up.x, up.y, up.z}}});
    if (f.outer_stiffness[k] == 0) sections.back()["hinged"] = true;
  }
  wall["members"] = members;
  wall["sections"] = sections;
}

Json storeys_of(const Anatomy& a) {
  Json list = Json::array();
  for (std::size_t k = 0; k < a.storey_top.size(); ++k)
    list.push_back({{"name", a.storey_name[k]}, {"top", a.storey_top[k]}});
  return list;
}

}  // namespace

void add_wall(Bundle& bundle, const Model& model) {
  const Anatomy& a = model.anatomy;
  const Solids& s = model.solids;
  const int bodies = static_cast<int>(s.bodies.size());
  Json wall = {{"length", a.length},
               {"height", a.height},
               {"thickness", a.thickness},
               {"courses", a.courses},
               {"blocks", model.n_block + bodies},
               {"joints", model.n_joint + s.n_contact},
               {"pairs", model.n_pair},
               {"roles", words_by_number(kBlockRoleWords)},
               {"kinds", words_by_number(kJointKindWords)}};
  if (bodies > 0) {
    wall["bodies"] = bodies, wall["nodes"] = s.n_node, wall["zones"] = s.n_zone;
    wall["contacts"] = s.n_contact;
  }
  if (model.links.n > 0 && dimension_of(model) == 2) wall["links"] = links_of(model);
  if (model.frames.n > 0) add_members(wall, model);
  if (!a.storey_top.empty()) wall["storeys"] = storeys_of(a);
  if (dimension_of(model) == 3) {
    add_space(bundle, model, wall);
    bundle.header["wall"] = wall;
    return;
  }
  if (const Stage* push = push_of(model)) {
    wall["push"] = {push->drive_x, push->drive_y};
    wall["load_height"] = push->load_height;
    std::vector<BlockId> driven;
    wall["pushed"] = Json::array();
    for (const PushPart& part : push_parts(model, *push)) {
      driven.insert(driven.end(), part.blocks.begin(), part.blocks.end());
      wall["pushed"].push_back({{"end", driven.size()}, {"length", part.length}});
    }
    bundle.add("wall.driven", driven);
  }
  bundle.header["wall"] = wall;
  add_blocks(bundle, model);
  add_joints(bundle, model);
  bundle.add("wall.support_begin", a.support_begin);
  add_floats(bundle, "wall.support_x", a.support_x);
  add_floats(bundle, "wall.support_y", a.support_y);
}

void add_fields(Bundle& bundle, const ModelSpec& spec, const Model& model, int sample) {
  Json list = bundle.header["wall"].value("fields", Json::array());
  const std::vector<Message> notes = notes_of_fields(spec);
  for (const DrawnField& field : model.anatomy.fields) {
    const FieldTarget target = *field_target(field.path);
    const std::string si_unit = target.key->si_unit, unit = target.key->shown;
    const double factor = unit_factor(unit, si_unit);  // SI value of one unit
    std::vector<double> values = field.of_joint.empty() ? field.of_block : field.of_joint;
    for (double& value : values) value /= factor;
    double sum = 0, count = 0;
    for (const double value : values)
      if (!std::isnan(value)) sum += value, ++count;
    // a field with a formula does not use the value in the file
    const bool follows = !spec.field.at(field.name).formula.empty();
    add_floats(bundle, "wall.field_" + std::to_string(list.size()), values);
    list.push_back({{"name", field.name},
                    {"path", field.path},
                    {"unit", unit},
                    {"mean", follows ? sum / count : mean_of(spec, target) / factor},
                    {"follows", follows},
                    {"onBlocks", field.of_joint.empty()}});
    std::vector<Message> own;
    for (const Message& note : notes)
      if (note.arguments.front() == Argument("field", field.name)) own.push_back(note);
    if (!own.empty())
      list.back()["note"] =
          translated(own.size() == 1 ? own.front() : Message{"field.notes", {{"notes", own}}});
    if (sample > 0) list.back()["sample"] = sample;
  }
  if (!list.empty()) bundle.header["wall"]["fields"] = list;
}

int states_kept(int states, int room, int samples_after) {
  if (states <= room - samples_after) return states;
  return std::min({states, room, 1});
}

double state_numbers(const Model& m) {
  if (dimension_of(m) == 3)
    return 6.0 * (m.n_block + m.space.solids.n_zone + m.space.n_support) + 5.0 * joint_count(m) +
           4.0 * m.frames.n;
  return 3.0 * m.n_block + 4.0 * (m.n_joint + m.solids.n_contact) + 2.0 * m.solids.n_node +
         2.0 * m.solids.n_zone + m.links.n + 4.0 * m.frames.n;
}

std::vector<bool> states_shown(const std::vector<bool>& labelled, int most) {
  const auto all = static_cast<int>(labelled.size());
  const auto named = static_cast<int>(std::count(labelled.begin(), labelled.end(), true));
  const std::int64_t others = all - named, room = std::clamp(most - named, 0, all - named);
  std::vector<bool> shown = labelled;
  std::int64_t seen = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (labelled[i]) continue;
    shown[i] = (seen + 1) * room / others > seen * room / others;
    ++seen;
  }
  return shown;
}

void FrameArrays::add(const Model& model, const State& state) {
  ++count_;
  in_space_ = dimension_of(model) == 3;
  if (with_forces_)
    for (const FrameReading& section : read_frames(model, state)) {
      section_normal_.push_back(section.normal);
      section_shear_.push_back(section.shear);
      section_moment_.push_back(section.moment);
      section_use_.push_back(section.use);
    }
  if (in_space_) return space_.add(model, state);
  const WallReading wall = read_wall(model, state);
  for (const BlockReading& block : wall.blocks) {
    ux_.push_back(block.moved.x);
    uy_.push_back(block.moved.y);
    turned_.push_back(block.turned.by.z);
  }
  for (int node = 0; node < model.solids.n_node; ++node) {
    const Vec3 moved = node_moved(state, node);
    node_ux_.push_back(moved.x);
    node_uy_.push_back(moved.y);
  }
  for (const ZoneReading& zone : read_zones(model, state)) {
    const auto [greater, smaller] = principal_stresses(zone);
    greater_.push_back(greater);
    smaller_.push_back(smaller);
  }
  if (model.links.n > 0)
    for (const LinkReading& link : read_links(model, state)) link_force_.push_back(link.force);
  for (const JointReading& joint : wall.joints) {
    // a joint between separated blocks is not drawn as a crack: the page gets an opening of -1
    const bool shown = !joint.handed_over;
    opening_.push_back(shown ? std::fmax(0.0, joint.opening) : -1.0);
    slip_.push_back(shown ? joint.slip : 0.0);
    damage_.push_back(shown ? share_byte(joint.damage) : std::uint8_t{0});
    crushing_.push_back(share_byte(joint.crushing));
    if (!with_forces_) continue;
    compression_.push_back(joint.compression);
    shear_.push_back(joint.shear);
    eccentricity_.push_back(joint.eccentricity);
  }
}

void FrameArrays::write(Bundle& bundle) const {
  if (!section_use_.empty()) {
    bundle.add_rounded("frame.section_normal", section_normal_);
    bundle.add_rounded("frame.section_shear", section_shear_);
    bundle.add_rounded("frame.section_moment", section_moment_);
    bundle.add_rounded("frame.section_use", section_use_);
  }
  if (in_space_) return space_.write(bundle, count_);
  bundle.add_rounded("frame.ux", ux_);
  bundle.add_rounded("frame.uy", uy_);
  bundle.add_rounded("frame.theta", turned_);
  if (!node_ux_.empty()) {
    bundle.add_rounded("frame.node_ux", node_ux_);
    bundle.add_rounded("frame.node_uy", node_uy_);
    bundle.add_rounded("frame.zone_greater", greater_);
    bundle.add_rounded("frame.zone_smaller", smaller_);
  }
  if (!link_force_.empty()) bundle.add_rounded("frame.link_force", link_force_);
  bundle.add_rounded("frame.opening", opening_);
  bundle.add_rounded("frame.slip", slip_);
  bundle.add("frame.damage", damage_);
  bundle.add("frame.crushing", crushing_);
  if (!with_forces_) return;
  bundle.add_rounded("frame.compression", compression_);
  bundle.add_rounded("frame.shear", shear_);
  bundle.add_rounded("frame.eccentricity", eccentricity_);
}

}  // namespace wythe::report
