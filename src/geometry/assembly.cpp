// The list of steps from a spec to an assembly; each step is in its own file.
#include "geometry/assembly.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/text.h"
#include "geometry/blocks_file.h"
#include "geometry/caps.h"
#include "geometry/checks.h"
#include "geometry/courses.h"
#include "geometry/faces.h"
#include "geometry/fit.h"
#include "geometry/joints.h"
#include "geometry/openings.h"
#include "geometry/polygon.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

ZoneSpec zones_of(const LintelSpec& lintel) {
  if (lintel.model == LintelModel::kSegments) return {};
  return {lintel.zones, lintel.zone_length, lintel.zone_kind, lintel.plane};
}

void add_segments(const Shape& shape, const PlacedOpening& opening, std::vector<Block>& blocks) {
  const std::size_t index = static_cast<std::size_t>(opening.index);
  if (opening.segment.empty()) return;
  const std::string& material = shape.wall.opening[index].lintel.material;
  for (std::size_t k = 0; k < opening.segment.size(); ++k) {
    Block block;
    block.id = "lintel" + std::to_string(opening.index) + "_" + std::to_string(k);
    block.outline = outline_of(opening.segment[k]);
    block.material = material;
    block.thickness = shape.wall.thickness;
    block.role = Role::kLintel;
    block.opening = opening.index;
    block.zone = zones_of(shape.wall.opening[index].lintel);
    blocks.push_back(block);
  }
}

// Neighbours in the wall become neighbours in memory: from the bottom up, then left to right.
void sort_blocks(std::vector<Block>& blocks, double course) {
  const auto key = [&](const Block& b) {
    const Vec2 corner = b.outline.front();
    return std::tuple(static_cast<long>(corner.y / course + 1e-6), corner.x, corner.y);
  };
  std::stable_sort(blocks.begin(), blocks.end(),
                   [&](const Block& a, const Block& b) { return key(a) < key(b); });
}

void lay_blocks(const Shape& shape, const Lattice& lattice,
                const std::vector<PlacedOpening>& openings, Assembly& assembly) {
  std::vector<Rect> holes;
  for (const PlacedOpening& opening : openings) holes.push_back(opening.hole);
  Masonry masonry = lay_masonry(shape.wall, lattice, holes);
  assembly.report.masonry_blocks_before_lintels = static_cast<int>(masonry.blocks.size());
  for (const PlacedOpening& opening : openings) {
    if (opening.segment.empty()) continue;
    holes.push_back(join(opening.segment.front(), opening.segment.back()));
  }
  if (holes.size() > openings.size()) masonry = lay_masonry(shape.wall, lattice, holes);
  assembly.blocks = std::move(masonry.blocks);
  for (const PlacedOpening& opening : openings) add_segments(shape, opening, assembly.blocks);
  sort_blocks(assembly.blocks, lattice.courses.step);
  if (masonry.joined_pieces == 0) return;
  assembly.report.notes.push_back(
      {"fit.joined_pieces",
       {{"pieces", masonry.joined_pieces}, {"shorter_mm", 1e3 * kSliver * lattice.columns.step}}});
}

void check_body(const WallSpec& wall, FaultList& faults) {
  (void)is_positive({"wall.thickness", wall.thickness, "m", "0.31 m"}, faults);
  (void)is_positive({"wall.unit.density", wall.unit.density, "kg/m^3", "1250 kg/m^3"}, faults);
}

// Keys that shape a generated wall and say something here; defaults written out say nothing.
std::vector<std::string> shape_keys(const WallSpec& wall) {
  const WallSpec unset;
  std::vector<std::string> keys;
  const auto add = [&](const char* key, bool stated) {
    if (stated) keys.emplace_back(key);
  };
  add("wall.length", !std::isnan(wall.length));
  add("wall.height", !std::isnan(wall.height));
  add("wall.bond", wall.bond != unset.bond);
  add("wall.fit", wall.fit != unset.fit);
  add("wall.unit.length", !std::isnan(wall.unit.length));
  add("wall.unit.height", !std::isnan(wall.unit.height));
  add("wall.unit.width", !std::isnan(wall.unit.width));
  add("wall.unit.split", wall.unit.split != unset.unit.split);
  add("wall.opening", !wall.opening.empty());
  return keys;
}

// Planes where no head joint ends: a crack that runs along them has to turn at every course.
void note_planes(const WallSpec& wall, std::vector<Message>& notes) {
  const bool has_headers = wall.bond == Bond::kFlemish || wall.bond == Bond::kEnglish;
  if (has_headers && wall.unit.split == Split::kMiddle) notes.push_back({"unit.planes_off_joints"});
}

void note_unused(const Shape& shape, std::vector<Message>& notes) {
  const bool from_file = uses_blocks_file(shape);
  const std::vector<std::string> idle =
      from_file ? shape_keys(shape.wall) : std::vector<std::string>();
  if (!idle.empty()) {
    notes.push_back(
        {idle.size() > 1 ? "keys.idle_many" : "keys.idle_one", {{"keys", joined(idle, ", ")}}});
  }
  if (!from_file && !shape.contact.empty()) {
    notes.push_back({"keys.idle_contact"});
  }
}

// Fills everything but faces; false after a fault that keeps the wall from standing.
bool raise_generated(const Shape& shape, Assembly& assembly, FaultList& faults) {
  const std::size_t before = faults.all().size();
  check_body(shape.wall, faults);
  note_planes(shape.wall, assembly.report.notes);
  const Lattice lattice = fit_lattice(shape.wall, assembly.report.notes, faults);
  const auto openings = place_openings(shape, lattice, assembly.report.notes, faults);
  if (faults.all().size() > before) return false;
  assembly.length = shape.wall.length;
  assembly.height = shape.wall.height;
  assembly.report.half_unit = lattice.columns.step;
  assembly.report.course = lattice.courses.step;
  assembly.report.courses = lattice.courses.count;
  assembly.piers = find_piers(openings, assembly.length, assembly.height);
  lay_blocks(shape, lattice, openings, assembly);
  check_slivers(assembly.blocks, lattice, faults);
  add_caps(shape, {0, 0, assembly.length, assembly.height}, assembly, faults);
  return faults.all().size() == before;
}

Rect masonry_bounds(const std::vector<Block>& blocks) {
  Rect whole;
  bool is_first = true;
  for (const Block& block : blocks) {
    if (block.role != Role::kMasonry) continue;
    whole = is_first ? bounds(block.outline) : join(whole, bounds(block.outline));
    is_first = false;
  }
  return whole;
}

bool raise_from_file(const Shape& shape, Assembly& assembly, FaultList& faults) {
  const std::size_t before = faults.all().size();
  (void)is_positive({"wall.thickness", shape.wall.thickness, "m", "0.31 m"}, faults);
  assembly.blocks = blocks_from_file(shape, faults);
  const Rect extent = masonry_bounds(assembly.blocks);
  assembly.length = extent.x1 - extent.x0;
  assembly.height = extent.y1 - extent.y0;
  assembly.piers = {{extent.x0, extent.x1, assembly.height}};
  for (const Block& block : assembly.blocks) {
    assembly.report.masonry_blocks_before_lintels += block.role == Role::kMasonry;
    assembly.report.courses = std::max(assembly.report.courses, block.course + 1);
  }
  check_overlaps(assembly.blocks, faults);
  if (faults.all().size() == before) add_caps(shape, extent, assembly, faults);
  return faults.all().size() == before;
}

double lowest_point(const std::vector<Block>& blocks) {
  double lowest = bounds(blocks.front().outline).y0;
  for (const Block& block : blocks) lowest = std::min(lowest, bounds(block.outline).y0);
  return lowest;
}

// The ground line stands in for supports where the shape has none.
void add_ground(const Shape& shape, Assembly& assembly, std::vector<Contact>& contacts) {
  const auto& blocks = assembly.blocks;
  const bool has_supports = std::any_of(blocks.begin(), blocks.end(),
                                        [](const Block& b) { return b.role == Role::kSupport; });
  if (has_supports) return;
  const double ground = uses_blocks_file(shape) ? lowest_point(blocks) : 0;
  const std::vector<Contact> found = find_ground_contacts(blocks, ground);
  contacts.insert(contacts.end(), found.begin(), found.end());
  sort_contacts(contacts, contact_tolerance(blocks));
  if (uses_blocks_file(shape)) {
    assembly.report.notes.push_back({"ground.line", {{"y_m", ground}}});
  }
}

void note_lost(const std::vector<LostContact>& lost, Assembly& assembly) {
  assembly.report.lost_joints = static_cast<int>(lost.size());
  for (std::size_t k = 0; k < std::min<std::size_t>(lost.size(), 5); ++k) {
    const LostContact& l = lost[k];
    const bool apart = l.gap > 0;
    assembly.report.notes.push_back(
        {apart ? "joint.lost_apart" : "joint.lost_short",
         {{"a", assembly.blocks[static_cast<std::size_t>(l.a)].id},
          {"b", assembly.blocks[static_cast<std::size_t>(l.b)].id},
          {apart ? "gap_mm" : "overlap_mm", 1e3 * (apart ? l.gap : l.overlap)}}});
  }
  if (lost.size() > 5) {
    assembly.report.notes.push_back({"joint.lost_more", {{"pairs", lost.size() - 5}}});
  }
}

void note_foundation(const Shape& shape, Assembly& assembly) {
  const auto falls_back = [](const Face& face) {
    return face.kind == FaceKind::kFoundation && face.material == "joint";
  };
  const auto& faces = assembly.faces;
  if (shape.material.contains("foundation") ||
      std::none_of(faces.begin(), faces.end(), falls_back)) {
    return;
  }
  assembly.report.notes.push_back({"material.no_foundation"});
}

}  // namespace

double density_of(const Shape& shape, const Block& block) {
  constexpr double kSteel = 7850;  // [kg/m^3], EN 1991-1-1 table A.4
  if (block.role == Role::kPlate) return kSteel;
  if (block.role == Role::kBeam && !std::isnan(shape.wall.beam.height))
    return shape.wall.beam.density;
  if (uses_blocks_file(shape)) return density_in_file(shape, block.material);
  return block.role == Role::kLintel ? shape.material.at(block.material) : shape.wall.unit.density;
}

Assembly build_assembly(const Shape& shape, FaultList& faults) {
  Assembly assembly;
  assembly.thickness = shape.wall.thickness;
  note_unused(shape, assembly.report.notes);
  const bool stands = uses_blocks_file(shape) ? raise_from_file(shape, assembly, faults)
                                              : raise_generated(shape, assembly, faults);
  if (!stands) {
    check_stated_materials(shape, faults);
    return assembly;
  }
  ContactSearch search = find_contacts(assembly.blocks);
  add_ground(shape, assembly, search.contacts);
  assembly.faces = name_faces(shape, assembly.blocks, search.contacts);
  note_lost(search.lost, assembly);
  note_foundation(shape, assembly);
  check_materials(shape, assembly.faces, faults);
  check_support(assembly, faults);
  return assembly;
}

}  // namespace wythe::geometry
