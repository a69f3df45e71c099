// The list of steps from a spec to an assembly; each step is in its own file.
#include "geometry/assembly.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/text.h"
#include "geometry/blocks_file.h"
#include "geometry/caps.h"
#include "geometry/polygon.h"
#include "geometry/text.h"
#include "geometry/wall/arches.h"
#include "geometry/wall/checks.h"
#include "geometry/wall/courses.h"
#include "geometry/wall/cut_out.h"
#include "geometry/wall/faces.h"
#include "geometry/wall/fit.h"
#include "geometry/wall/foundation.h"
#include "geometry/wall/frames.h"
#include "geometry/wall/joints.h"
#include "geometry/wall/openings.h"
#include "geometry/wall/regions.h"
#include "geometry/wall/ring_beams.h"
#include "geometry/wall/storeys.h"

namespace wythe::geometry {
namespace {

ZoneSpec zones_of(const LintelSpec& lintel) {
  if (lintel.model == LintelModel::kSegments) return {};
  return {lintel.zones, lintel.zone_length, lintel.zone_kind, lintel.plane};
}

// One block for each segment; `like` has the members that they share.
void add_segments(const std::vector<Rect>& segments, const std::string& id, Block like,
                  std::vector<Block>& blocks) {
  for (std::size_t k = 0; k < segments.size(); ++k) {
    like.id = id + "_" + std::to_string(k);
    like.outline = outline_of(segments[k]);
    blocks.push_back(like);
  }
}

void add_lintel_and_sill(const Shape& shape, const PlacedOpening& opening, const Storey& storey,
                         std::vector<Block>& blocks) {
  const OpeningSpec& spec = shape.wall.opening[opening.index];
  const std::string number = std::to_string(opening.index);
  Block block;
  block.thickness = storey.thickness;
  block.storey = storey.index;
  block.opening = opening.index;
  block.role = Role::kSill;
  block.material = spec.sill.material;
  add_segments(opening.sill, "sill" + number, block, blocks);
  block.role = Role::kLintel;
  block.material = spec.lintel.material;
  block.zone = zones_of(spec.lintel);
  add_segments(opening.segment, "lintel" + number, block, blocks);
}

void add_ring_beam(const Shape& shape, const PlacedRingBeam& beam, int storey,
                   std::vector<Block>& blocks) {
  Block block;
  block.thickness = beam.thickness;
  block.storey = storey;
  block.ring_beam = beam.index;
  block.role = Role::kRingBeam;
  block.material = shape.ring_beam[beam.index].material;
  add_segments(beam.segment, "ring" + std::to_string(beam.index), block, blocks);
}

void add_voussoirs(const Shape& shape, const PlacedOpening& opening,
                   const std::vector<Storey>& storeys, std::vector<Block>& blocks) {
  const Storey& storey = storeys[opening.storey];
  const ArchSpec& arch = shape.wall.opening[opening.index].arch;
  for (std::size_t k = 0; k < opening.arch.voussoirs(); ++k) {
    Block block;
    block.id = "arch" + std::to_string(opening.index) + "_" + std::to_string(k);
    block.outline = voussoir(opening.arch, k);
    block.material = arch.material.empty() ? "masonry" : arch.material;
    block.thickness = storey.thickness;
    block.storey = storey.index;
    block.opening = opening.index;
    block.course = static_cast<int>(row_at(storeys, moments(block.outline).centroid.y));
    blocks.push_back(block);
  }
}

// Neighbours in the wall become neighbours in memory: blocks are sorted from the bottom up, then left to right.
void sort_blocks(std::vector<Block>& blocks, const std::vector<Storey>& storeys) {
  const auto key = [&](const Block& b) {
    const Vec2 corner = b.outline.front();
    return std::tuple(row_at(storeys, corner.y), corner.x, corner.y);
  };
  std::stable_sort(blocks.begin(), blocks.end(),
                   [&](const Block& a, const Block& b) { return key(a) < key(b); });
}

double narrowest_column(const std::vector<Storey>& storeys) {
  double step = storeys.front().lattice.columns.step;
  for (const Storey& storey : storeys) step = std::min(step, storey.lattice.columns.step);
  return step;
}

void add_frames(std::vector<PlacedFrame> frames, Assembly& assembly) {
  for (const PlacedFrame& frame : frames)
    assembly.blocks.insert(assembly.blocks.end(), frame.segments.begin(), frame.segments.end());
  assembly.frames = std::move(frames);
}

// Notes frames wider than the wall: several profiles side by side may need more room, and what sticks out touches nothing.
void note_wide_frames(const Shape& shape, Assembly& assembly) {
  for (const PlacedFrame& frame : assembly.frames) {
    double widest = 0;
    for (const Block& segment : frame.segments) widest = std::max(widest, segment.thickness);
    const std::string& name = shape.frame[frame.index].name;
    if (widest > assembly.thickness * (1 + 1e-9))
      assembly.report.notes.push_back(
          {"frame.wide",
           {{"name", name.empty() ? std::to_string(frame.index + 1) : name},
            {"width_mm", 1e3 * widest},
            {"thickness_mm", 1e3 * assembly.thickness}}});
  }
}

// Storeys with their lattices, and all that stands on or in them.
struct Plan {
  std::vector<Storey> storeys;
  std::vector<PlacedOpening> openings;
  std::vector<PlacedRingBeam> ring_beams;
  std::vector<GroundStep> ground;
  std::vector<PlacedFrame> frames = {};
};

// Adds the masonry that stands before a stage cuts an opening and inserts its lintel and sill.
void add_cut_out(const PlacedOpening& opening, const std::vector<Storey>& storeys,
                 std::vector<Block>& blocks) {
  int number = 0;
  for (Block& block : masonry_cut_out(opening, storeys)) {
    block.id = "cut" + std::to_string(opening.index) + "_" + std::to_string(number++);
    blocks.push_back(block);
  }
}

bool is_cut(const Shape& shape, const PlacedOpening& opening) {
  return !shape.wall.opening[opening.index].cut.empty();
}

void lay_blocks(const Shape& shape, const Plan& plan, Assembly& assembly) {
  const auto& [storeys, openings, ring_beams, ground, frames] = plan;
  std::vector<Rect> holes;
  for (const PlacedOpening& opening : openings) holes.push_back(opening.hole);
  for (const GroundStep& step : ground)
    if (step.y > 0) holes.push_back(box_of(step));
  Masonry masonry = lay_masonry(storeys, holes);
  assembly.report.masonry_blocks_before_lintels = static_cast<int>(masonry.blocks.size());
  const std::size_t bare = holes.size();
  const auto take_place = [&](const std::vector<Rect>& segments) {
    if (!segments.empty()) holes.push_back(join(segments.front(), segments.back()));
  };
  for (const PlacedOpening& opening : openings) {
    take_place(opening.segment);
    take_place(opening.sill);
  }
  for (const PlacedRingBeam& beam : ring_beams) take_place(beam.segment);
  if (holes.size() > bare) masonry = lay_masonry(storeys, holes);
  assembly.blocks = std::move(masonry.blocks);
  for (const PlacedOpening& opening : openings)
    add_lintel_and_sill(shape, opening, storeys[opening.storey], assembly.blocks);
  for (const PlacedRingBeam& beam : ring_beams)
    add_ring_beam(shape, beam, storeys[beam.storey].index, assembly.blocks);
  for (const PlacedOpening& opening : openings) {
    if (opening.arch.empty()) continue;
    masonry.joined_pieces += cut_masonry(opening.arch, storeys, assembly.blocks);
    add_voussoirs(shape, opening, storeys, assembly.blocks);
  }
  for (const PlacedOpening& opening : openings)
    if (is_cut(shape, opening)) add_cut_out(opening, storeys, assembly.blocks);
  add_frames(frames, assembly);
  sort_blocks(assembly.blocks, storeys);
  if (masonry.joined_pieces == 0) return;
  assembly.report.notes.push_back({"fit.joined_pieces",
                                   {{"pieces", masonry.joined_pieces},
                                    {"shorter_mm", 1e3 * kSliver * narrowest_column(storeys)}}});
}

// Stated keys that shape a generated wall; keys at their defaults are not listed.
std::vector<std::string> shape_keys(const Shape& shape) {
  const WallSpec& wall = shape.wall;
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
  add("wall.unit.mortar", !std::isnan(wall.unit.mortar.bed) || !std::isnan(wall.unit.mortar.head));
  add("wall.unit.real", !std::isnan(wall.unit.real.length) || !std::isnan(wall.unit.real.height));
  add("wall.opening", !wall.opening.empty());
  add("wall.foundation", !wall.foundation.empty());
  add("ring_beam", !shape.ring_beam.empty());
  for (const StoreySpec& storey : shape.storey) {
    const UnitSpec& unit = storey.unit;
    const bool sized = !std::isnan(unit.length) || !std::isnan(unit.height) ||
                       !std::isnan(unit.width) || !std::isnan(unit.density);
    add(("storey." + storey.name + ".bond").c_str(), !storey.bond.empty());
    add(("storey." + storey.name + ".fit").c_str(), !storey.fit.empty());
    add(("storey." + storey.name + ".unit").c_str(), sized);
  }
  return keys;
}

// Notes vertical planes where no head joint ends: a crack along such a plane has to turn at every course.
void note_planes(const std::vector<Storey>& storeys, std::vector<Message>& notes) {
  const auto misses = [](const Storey& s) {
    const bool has_headers = s.bond == Bond::kFlemish || s.bond == Bond::kEnglish;
    return has_headers && s.unit.split == Split::kMiddle;
  };
  if (std::any_of(storeys.begin(), storeys.end(), misses))
    notes.push_back({"unit.planes_off_joints"});
}

void note_unused(const Shape& shape, std::vector<Message>& notes) {
  const bool from_file = uses_blocks_file(shape);
  const std::vector<std::string> idle = from_file ? shape_keys(shape) : std::vector<std::string>();
  if (!idle.empty()) {
    notes.push_back(
        {idle.size() > 1 ? "keys.idle_many" : "keys.idle_one", {{"keys", joined(idle, ", ")}}});
  }
  if (!from_file && !shape.contact.empty()) {
    notes.push_back({"keys.idle_contact"});
  }
}

// Plans the wall. `cut_all`: as if every storey had fit = "cut".
Plan plan_wall(const Shape& shape, bool cut_all, std::vector<Message>& notes, FaultList& faults) {
  Plan plan;
  plan.storeys = plan_storeys(shape, cut_all, notes, faults);
  plan.ring_beams = place_ring_beams(shape, plan.storeys, notes, faults);
  std::vector<Rect> spanning;
  for (const PlacedRingBeam& beam : plan.ring_beams)
    spanning.push_back(join(beam.segment.front(), beam.segment.back()));
  plan.openings = place_openings(shape, plan.storeys, spanning, notes, faults);
  const auto is_bare = [](const Storey& s) { return s.lattice.courses.count == 0; };
  if (std::none_of(plan.storeys.begin(), plan.storeys.end(), is_bare))
    plan.ground = place_ground(shape, plan.storeys, notes, faults);
  check_chains(shape, plan.openings, plan.ring_beams, plan.ground, faults);
  if (plan.ground.empty()) return plan;
  std::vector<Rect> stands;
  for (const GroundStep& step : plan.ground) stands.push_back(box_of(step));
  const Rect wall{0, 0, shape.wall.length, plan.storeys.back().top()};
  plan.frames = place_frames(shape, plan.openings, {wall, stands}, faults);
  return plan;
}

// A fault as an item of a list: place, problem, and a size that fits.
std::string listed(const Fault& fault) {
  std::string cure =
      fault.cure.substr(0, std::min(fault.cure.find(", on the"), fault.cure.find(" (or")));
  if (cure.starts_with("write ")) cure.erase(0, 6);
  return fault.path + " = " + fault.value + (cure.empty() ? "" : " (" + cure + " fits)");
}

// Faults that remain for the same wall when units are cut.
FaultList faults_when_cut(const Shape& shape) {
  FaultList faults;
  std::vector<Message> unsaid;
  const Plan plan = plan_wall(shape, true, unsaid, faults);
  const auto is_bare = [](const Storey& storey) { return storey.lattice.courses.count == 0; };
  if (std::any_of(plan.storeys.begin(), plan.storeys.end(), is_bare)) return faults;
  Assembly laid;
  lay_blocks(shape, plan, laid);
  check_slivers(laid.blocks, plan.storeys, faults);
  return faults;
}

// Surveyed sizes seldom fit whole units. Where many do not fit and fit = "cut" would accept all of them, one fault
// says so first.
void add_plan_faults(const Shape& shape, const FaultList& found, FaultList& faults) {
  constexpr std::size_t kMany = 3, kListed = 12;
  const auto& all = found.all();
  const auto is_among = [](const std::vector<Fault>& list) {
    return [&list](const Fault& fault) {
      const auto same = [&](const Fault& f) { return f.path == fault.path; };
      return std::any_of(list.begin(), list.end(), same);
    };
  };
  std::vector<Fault> cured, left;
  const bool all_follow =
      std::all_of(shape.storey.begin(), shape.storey.end(),
                  [](const StoreySpec& s) { return s.fit.empty() || s.fit == "cut"; });
  if (shape.wall.fit == Fit::kWhole && all_follow && all.size() >= kMany) {
    const FaultList cut = faults_when_cut(shape);
    // A lintel that is not laid yet may leave slivers of its own.
    const auto is_known = [&](const Fault& fault) {
      return is_among(all)(fault) && fault.path.find(".lintel.") == std::string::npos &&
             fault.path.find(".sill.") == std::string::npos;
    };
    const bool is_clear = std::all_of(cut.all().begin(), cut.all().end(), is_known);
    for (const Fault& fault : all)
      (!is_clear || is_among(cut.all())(fault) ? left : cured).push_back(fault);
  }
  if (cured.size() < kMany) {
    for (const Fault& fault : all) faults.add(fault);
    return;
  }
  std::string list;
  for (std::size_t i = 0; i < std::min(kListed, cured.size()); ++i)
    list += (i > 0 ? ", " : "") + listed(cured[i]);
  if (cured.size() > kListed) list += " and " + std::to_string(cured.size() - kListed) + " more";
  add_fault(
      faults, "wall.fit", "\"whole\"",
      std::to_string(cured.size()) + " sizes do not fit whole units and courses within 2 %",
      "write fit = \"cut\" under [wall], for a surveyed wall: units keep their size and are cut at "
      "the edges; or mend each: " +
          list);
  for (const Fault& fault : left) faults.add(fault);
}

void copy_storeys(const std::vector<Storey>& storeys, Assembly& assembly) {
  for (const Storey& storey : storeys)
    if (storey.index >= 0)
      assembly.storeys.push_back({storey.name, storey.foot, storey.top(), storey.thickness,
                                  storey.first_course, storey.lattice.courses.count});
  assembly.thickness = storeys.front().thickness;
  assembly.top_thickness = storeys.back().thickness;
}

// Fills everything but faces; false after a fault that prevents the wall from standing.
bool raise_generated(const Shape& shape, Assembly& assembly, FaultList& faults) {
  const std::size_t before = faults.all().size();
  note_planes(stated_storeys(shape.wall, shape.storey), assembly.report.notes);
  FaultList found;
  const Plan plan = plan_wall(shape, false, assembly.report.notes, found);
  const auto& [storeys, openings, ring_beams, ground, frames] = plan;
  add_plan_faults(shape, found, faults);
  if (faults.all().size() > before) return false;
  const Lattice& lattice = storeys.front().lattice;
  copy_storeys(storeys, assembly);
  assembly.length = shape.wall.length;
  assembly.height = storeys.back().top();
  assembly.report.half_unit = lattice.columns.step;
  assembly.report.course = lattice.courses.step;
  assembly.report.courses = storeys.back().first_course + storeys.back().lattice.courses.count;
  assembly.piers = find_piers(openings, assembly.length, assembly.height);
  assembly.ground = ground;
  lay_blocks(shape, plan, assembly);
  check_slivers(assembly.blocks, storeys, faults);
  check_frames(assembly, faults);
  note_wide_frames(shape, assembly);
  assign_regions(shape, storeys, openings, assembly, faults);
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

double lowest_point(const std::vector<Block>& blocks) {
  double lowest = bounds(blocks.front().outline).y0;
  for (const Block& block : blocks) lowest = std::min(lowest, bounds(block.outline).y0);
  return lowest;
}

// Where frames may stand in a blocks file: on its supports, or on the ground line that replaces missing supports.
FrameSite site_of_file(const std::vector<Block>& blocks, const Rect& extent) {
  FrameSite site{extent, {}};
  for (const Block& block : blocks)
    if (block.role == Role::kSupport) site.ground.push_back(bounds(block.outline));
  const double lowest = lowest_point(blocks);
  if (site.ground.empty()) site.ground = {{extent.x0, lowest, extent.x1, lowest}};
  return site;
}

// In a blocks file storeys are levels above its lowest point. A block belongs to the level that
// contains its centroid, and takes its thickness where the level states one.
std::vector<Storey> mark_storeys(const Shape& shape, double foot, Assembly& assembly,
                                 FaultList& faults) {
  std::vector<Storey> storeys = level_storeys(shape, foot, faults);
  if (shape.storey.empty()) return storeys;
  for (Block& block : assembly.blocks) {
    if (block.role != Role::kMasonry) continue;
    const Storey& storey = storey_at(storeys, moments(block.outline).centroid.y);
    block.storey = storey.index;
    block.thickness = storey.thickness;
  }
  copy_storeys(storeys, assembly);
  return storeys;
}

bool raise_from_file(const Shape& shape, Assembly& assembly, FaultList& faults) {
  const std::size_t before = faults.all().size();
  if (shape.storey.empty())
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
  if (faults.all().size() == before && !shape.frame.empty()) {
    add_frames(place_frames(shape, {}, site_of_file(assembly.blocks, extent), faults), assembly);
    check_frames(assembly, faults);
    note_wide_frames(shape, assembly);
  }
  const std::vector<Storey> storeys = mark_storeys(shape, extent.y0, assembly, faults);
  if (faults.all().size() == before) assign_regions(shape, storeys, {}, assembly, faults);
  if (faults.all().size() == before) add_caps(shape, extent, assembly, faults);
  return faults.all().size() == before;
}

// A ground line replaces supports where the shape has none.
void add_ground(const Shape& shape, Assembly& assembly, std::vector<Contact>& contacts) {
  const auto& blocks = assembly.blocks;
  const bool has_supports = std::any_of(blocks.begin(), blocks.end(),
                                        [](const Block& b) { return b.role == Role::kSupport; });
  if (has_supports) return;
  const double ground = uses_blocks_file(shape) ? lowest_point(blocks) : 0;
  const std::vector<Contact> found = uses_blocks_file(shape)
                                         ? find_ground_contacts(blocks, ground)
                                         : find_step_contacts(blocks, assembly.ground);
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
         {{"a", assembly.blocks[l.a].id},
          {"b", assembly.blocks[l.b].id},
          {apart ? "gap_mm" : "overlap_mm", 1e3 * (apart ? l.gap : l.overlap)}}});
  }
  if (lost.size() > 5) {
    assembly.report.notes.push_back({"joint.lost_more", {{"pairs", lost.size() - 5}}});
  }
}

void note_foundation(const Shape& shape, Assembly& assembly) {
  if (shape.material.contains("foundation")) return;
  std::set<std::string> names;
  for (const Face& face : assembly.faces) {
    const Block& block = assembly.blocks[face.b];
    if (face.kind == FaceKind::kFoundation && face.material == bed_material(shape, block))
      names.insert("[material." + face.material + "]");
  }
  if (names.empty()) return;
  const std::vector<std::string> listed(names.begin(), names.end());
  assembly.report.notes.push_back(
      {"material.no_foundation", {{"materials", joined(listed, ", ")}}});
}

}  // namespace

double density_of(const Shape& shape, const Block& block) {
  constexpr double kSteel = 7850;  // [kg/m^3], EN 1991-1-1 table A.4
  if (block.role == Role::kPlate) return kSteel;
  if (block.role == Role::kBeam && !std::isnan(shape.wall.beam.height))
    return shape.wall.beam.density;
  if (block.role == Role::kRingBeam) {
    // the weight is that of the stated section, though its courses may be higher or lower
    const Rect laid = bounds(block.outline);
    return shape.material.at(block.material) * shape.ring_beam[block.ring_beam].height /
           (laid.y1 - laid.y0);
  }
  if (!std::isnan(block.own_density)) return block.own_density;
  if (is_chain(block)) return shape.material.at(block.material);
  if (is_voussoir(block) && block.material != "masonry") return shape.material.at(block.material);
  if (block.region >= 0) {
    const double own = shape.region[block.region].density;
    if (!std::isnan(own)) return own;
  }
  if (uses_blocks_file(shape)) return density_in_file(shape, block.material);
  if (block.storey >= 0) {
    const double own = shape.storey[block.storey].unit.density;
    if (!std::isnan(own)) return own;
  }
  return shape.wall.unit.density;
}

double Assembly::thickness_of(const Face& face) const {
  const double above = blocks[face.b].thickness;
  return face.a == kGround ? above : std::min(above, blocks[face.a].thickness);
}

namespace {

// Masonry that a stage cuts out never stands together with lintel, sill and frame of its opening.
void part_cut_out(const std::vector<Block>& blocks, ContactSearch& search) {
  const auto part = [&](const auto& contact) {
    const auto side = [&](int i) -> const Block& { return blocks[i]; };
    const auto takes_place = [](const Block& b, const Block& of) {
      return of.cut_from >= 0 &&
             (b.role == Role::kFrame || (is_chain(b) && b.opening == of.cut_from));
    };
    if (contact.a == kGround) return false;
    return takes_place(side(contact.a), side(contact.b)) ||
           takes_place(side(contact.b), side(contact.a));
  };
  std::erase_if(search.contacts, part);
  std::erase_if(search.lost, part);
}

}  // namespace

Assembly build_assembly(const Shape& shape, FaultList& faults) {
  Assembly assembly;
  assembly.thickness = assembly.top_thickness = shape.wall.thickness;
  note_unused(shape, assembly.report.notes);
  const bool stands = uses_blocks_file(shape) ? raise_from_file(shape, assembly, faults)
                                              : raise_generated(shape, assembly, faults);
  if (!stands) {
    check_stated_materials(shape, faults);
    return assembly;
  }
  ContactSearch search = find_contacts(assembly.blocks);
  part_cut_out(assembly.blocks, search);
  add_ground(shape, assembly, search.contacts);
  assembly.faces = name_faces(shape, assembly.blocks, search.contacts);
  note_lost(search.lost, assembly);
  note_foundation(shape, assembly);
  check_materials(shape, assembly.faces, faults);
  check_support(assembly, faults);
  return assembly;
}

}  // namespace wythe::geometry
