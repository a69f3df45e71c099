// Lays walls along plan lines: courses of the plane's builder, cut where walls meet, become solids.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/elementary.h"
#include "core/limits.h"
#include "core/text.h"
#include "core/to_int.h"
#include "geometry/bodies/solid_cut.h"
#include "geometry/builder/builder.h"
#include "geometry/text.h"
#include "geometry/wall/arches.h"
#include "geometry/wall/bond.h"
#include "geometry/wall/checks.h"
#include "geometry/wall/courses.h"
#include "geometry/wall/cut_out.h"
#include "geometry/wall/frames.h"
#include "geometry/wall/openings.h"
#include "geometry/wall/regions.h"

namespace wythe::geometry {
namespace {

constexpr double kMargin = 1e-9;  // [m]
constexpr double kLeastPiece =
    0.25;  // of a half unit's face: smaller pieces below a gable are joined to others

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t k = text.find(what); k != std::string::npos; k = text.find(what, k + by.size()))
    text.replace(k, what.size(), by);
}

bool states(const PlanWallSpec& spec, const std::string& key) {
  const UnitSpec& unit = spec.unit;
  if (key == "height") return !std::isnan(spec.height);
  if (key == "thickness") return !std::isnan(spec.thickness);
  if (key == "fit") return !spec.fit.empty();
  if (key == "unit.length") return !std::isnan(unit.length);
  if (key == "unit.height") return !std::isnan(unit.height);
  if (key == "unit.width") return !std::isnan(unit.width);
  if (key == "unit.density") return !std::isnan(unit.density);
  return key.starts_with("opening");
}

// Copies faults of the plane's builder, with the keys of the plan wall's table.
void take_faults(const Site& site, const StraightWall& wall, const FaultList& found,
                 FaultList& faults) {
  const PlanWallSpec& spec = site.spec.plan_wall[wall.index];
  for (Fault fault : found.all()) {
    if (enough(faults)) return;
    const std::string key = fault.path.starts_with("wall.") ? fault.path.substr(5) : "";
    if (key == "length") fault.path = wall.path + ".line";
    if (states(spec, key)) fault.path = wall.path + "." + key;
    for (std::string* text : {&fault.problem, &fault.cure}) {
      replace_all(*text, "wall.length", "with what its corners take, its length");
      replace_all(*text, "the wall's", wall.name + "'s");
      replace_all(*text, ", or a length of", ", or a length, corners included, of");
      replace_all(*text, "the openings leave", "openings or teeth leave");
    }
    const auto same = [&](const Fault& f) {
      return f.path == fault.path && f.problem == fault.problem;
    };
    if (std::none_of(faults.all().begin(), faults.all().end(), same)) faults.add(fault);
  }
}

// Storeys and openings of one wall, from the plane's builder.
class Layout {
 public:
  Layout(const Site& site, const StraightWall& wall) {
    spec_.wall = wall.wall;
    spec_.material = site.model.material;
  }
  [[nodiscard]] Shape shape() const { return Shape(spec_); }

 private:
  ModelSpec spec_;
};

void plan_courses(const Site& site, StraightWall& wall, std::vector<Message>& notes,
                  FaultList& faults) {
  const Layout layout(site, wall);
  FaultList found;
  std::vector<Message> said;
  const Shape own = layout.shape();
  wall.storeys = plan_storeys(own, false, said, found);
  for (Message& note : said)
    notes.push_back({"plan_wall.says", {{"wall", wall.name}, {"said", std::move(note)}}});
  take_faults(site, wall, found, faults);
}

// --- one wall ---------------------------------------------------------------------------------------

struct Slot {
  double x0, x1;
};

class WallBuilder {
 public:
  WallBuilder(const Site& site, const std::vector<StraightWall>& walls, const StraightWall& wall)
      : site_(site),
        spec_(site.spec.plan_wall[wall.index]),
        axes_{site.z_up()},
        walls_(walls),
        wall_(wall) {
    storeys_ = wall.storeys;
    for (Storey& storey : storeys_) storey.first_course = wall.phase;
    add_gable_courses();
  }

  std::vector<BuiltBody> build(std::vector<Message>& notes, FaultList& faults) {
    const Layout layout(site_, wall_);
    const Shape own = layout.shape();
    FaultList found;
    std::vector<Message> said;
    const std::vector<PlacedOpening> openings = place_openings(own, wall_.storeys, {}, said, found);
    check_openings(found);
    if (found.empty()) {
      check_meetings(openings, found);
      lay(openings, said);
      check_slivers(blocks_, storeys_, found);
      take_regions(openings, said, found);
    }
    for (Message& note : said)
      notes.push_back({"plan_wall.says", {{"wall", wall_.name}, {"said", std::move(note)}}});
    take_faults(site_, wall_, found, faults);
    if (!found.empty()) return {};
    if (wall_.base == 0) add_ground();
    for (const Block& block : blocks_) add_solids(block);
    for (const PlacedOpening& opening : openings) {
      const LintelSpec& lintel = spec_.opening[opening.index].lintel;
      if (!opening.segment.empty() && !bends(lintel) && lintel.model == LintelModel::kSegments)
        notes.push_back({"lintel.rigid", {{"opening", opening.words}, {"wall", wall_.name}}});
      add_spanning(opening);
    }
    return std::move(bodies_);
  }

 private:
  [[nodiscard]] const Storey& storey() const { return storeys_.front(); }
  [[nodiscard]] const Axis& courses() const { return storey().lattice.courses; }
  [[nodiscard]] double length() const { return storey().lattice.columns.extent; }

  // Adds courses of the same height above the wall, up to the top of the gable.
  void add_gable_courses() {
    if (!(spec_.gable > 0) || courses().count == 0) return;
    Storey above = storey();
    Axis& rows = above.lattice.courses;
    above.first_course = storey().first_course + rows.count;
    above.foot = rows.end();
    rows.origin = rows.end();
    rows.count = to_int(std::ceil(spec_.gable / rows.step - 1e-9));
    rows.extent = rows.count * rows.step;
    above.height = rows.extent;
    storeys_.push_back(above);
  }

  // Checks openings as a wall in the plane does, and as only a wall in space needs.
  void check_openings(FaultList& faults) const {
    for (std::size_t i = 0; i < spec_.opening.size(); ++i) {
      const OpeningSpec& opening = spec_.opening[i];
      const int index = static_cast<int>(i);
      const LintelSpec& lintel = opening.lintel;
      const auto refuse = [&](const char* key, const std::string& value, const char* cure) {
        add_fault(faults, opening_path(index, key), "\"" + value + "\"",
                  "is for walls in their plane; this one is in space", cure);
      };
      if (lintel.zone_kind == ZoneKind::kCst)
        refuse("lintel.zone_kind", "cst", "leave it out: in space there is one kind of zone");
      if (lintel.plane == Plane::kStrain) refuse("lintel.plane", "strain", "leave it out");
      constexpr const char* kContact =
          "leave it out, and write [[contact]] between the materials of lintel and wall";
      for (const auto& [key, name] : {std::pair("lintel.bond", lintel.bond),
                                      {"lintel.bearing_bond", lintel.bearing_bond},
                                      {"lintel.top_bond", lintel.top_bond},
                                      {"sill.joint", opening.sill.joint},
                                      {"arch.joint", opening.arch.joint}})
        if (!name.empty() && name != "joint") refuse(key, name, kContact);
      for (const auto& [key, name] : {std::pair("lintel.material", lintel.material),
                                      {"sill.material", opening.sill.material},
                                      {"arch.material", opening.arch.material}})
        if (!name.empty() && !site_.model.material.contains(name))
          add_fault(faults, opening_path(index, key), "\"" + name + "\"",
                    "there is no such material", "add [material." + name + "] with its density");
    }
  }

  [[nodiscard]] Rect band(int row, double x0, double x1) const {
    return {x0, courses().line(row), x1, courses().line(row + 1)};
  }

  // Refuses teeth in an opening or its lintel: they would be unsupported.
  void check_meetings(const std::vector<PlacedOpening>& openings, FaultList& faults) const {
    const auto check = [&](const StraightWall& other, double x0, double x1) {
      const Rect zone{x0, 0, x1, courses().line(std::min(courses().count, other.rows()))};
      for (const PlacedOpening& opening : openings) {
        std::vector<Rect> taken{opening.hole};
        for (const std::vector<Rect>* part : {&opening.segment, &opening.sill})
          if (!part->empty()) taken.push_back(join(part->front(), part->back()));
        const auto meets = [&](const Rect& rect) { return overlaps(rect, zone, kMargin); };
        if (std::any_of(taken.begin(), taken.end(), meets))
          add_fault(faults, opening_path(opening.index, "x"), metres(opening.hole.x0),
                    opening.called + ", its lintel or sill, reaches into where the wall " +
                        other.name + " is toothed in, from " + metres(x0) + " to " + metres(x1),
                    "move it, shorten its bearing, or write meets = \"butted\"");
      }
    };
    for (int e = 0; e < 2; ++e) {
      const WallEnd& end = wall_.end[e];
      if (end.kind == EndKind::kFree || !end.toothed) continue;
      const StraightWall& other = walls_[end.other];
      check(other, e == 0 ? 0 : length() - other.thickness, e == 0 ? other.thickness : length());
    }
    for (const Tee& tee : wall_.tees) {
      const StraightWall& other = walls_[tee.other];
      const double x = tee.at - wall_.begin(), half = 0.5 * other.thickness;
      if (other.end[tee.end].toothed) check(other, x - half, x + half);
    }
  }

  // Holes in this wall: for teeth of other walls, and in its own ends where the other wall goes through.
  void cut_teeth(std::vector<Rect>& holes) {
    for (int e = 0; e < 2; ++e) {
      const WallEnd& end = wall_.end[e];
      if (end.kind == EndKind::kFree || !end.toothed) continue;
      const StraightWall& other = walls_[end.other];
      const double x0 = e == 0 ? 0 : length() - other.thickness;
      for (int row = 0; row < std::min(courses().count, other.rows()); ++row)
        if (!wall_.goes_through(e, row)) holes.push_back(band(row, x0, x0 + other.thickness));
    }
    for (const Tee& tee : wall_.tees) {
      const StraightWall& other = walls_[tee.other];
      if (!other.end[tee.end].toothed) continue;
      const double x = tee.at - wall_.begin(), half = 0.5 * other.thickness;
      for (int row = 0; row < std::min(courses().count, other.rows()); ++row) {
        if (other.goes_through(tee.end, row))
          holes.push_back(band(row, x - half, x + half));
        else
          bridge(row, x, half, holes);
      }
    }
  }

  // Lays a unit across a tooth in the course above or below, where a head joint would stand over the tooth or near it.
  void bridge(int row, double x, double half, std::vector<Rect>& holes) {
    const double unit = storey().lattice.stretcher, lap = kLeastPiece * unit / 2;
    int before = -1;
    bool cuts = false;
    for (const Piece& piece : lay_course(storey(), row + storey().first_course)) {
      cuts |= piece.unit != before && piece.x0 > kMargin && std::fabs(piece.x0 - x) < half + lap;
      before = piece.unit;
    }
    if (!cuts) return;
    const Rect place = band(row, x - unit / 2, x + unit / 2);
    const auto meets = [&](const Rect& hole) { return overlaps(hole, place, kMargin); };
    if (place.x0 < 0 || place.x1 > length() || std::any_of(holes.begin(), holes.end(), meets)) {
      ++bare_teeth_;
      return;
    }
    holes.push_back(place);
    bridges_.push_back({row, x});
  }

  void add_bridges() {
    int number = 0;
    for (const auto& [row, x] : bridges_) {
      const bool split = storey().unit.split != Split::kNone;
      const double reach = storey().lattice.stretcher / 2;
      for (int k = 0; k < (split ? 2 : 1); ++k) {
        Block block;
        block.course = row + storey().first_course;
        block.outline =
            outline_of(band(row, split && k == 1 ? x : x - reach, split && k == 0 ? x : x + reach));
        block.unit = split ? 1000000 + number : -1;
        block.id =
            fmt::format("c{:02}t{}{}", block.course, number, split ? k == 0 ? "a" : "b" : "");
        blocks_.push_back(block);
      }
      ++number;
    }
  }

  void lay(const std::vector<PlacedOpening>& openings, std::vector<Message>& notes) {
    std::vector<Rect> holes;
    for (const PlacedOpening& opening : openings) {
      holes.push_back(opening.hole);
      for (const std::vector<Rect>* part : {&opening.segment, &opening.sill})
        if (!part->empty()) holes.push_back(join(part->front(), part->back()));
    }
    cut_teeth(holes);
    Masonry masonry = lay_masonry(storeys_, holes);
    blocks_ = std::move(masonry.blocks);
    add_bridges();
    for (const PlacedOpening& opening : openings)
      if (!opening.arch.empty())
        masonry.joined_pieces += cut_masonry(opening.arch, storeys_, blocks_);
    if (storeys_.size() > 1) cut_gable(masonry.joined_pieces);
    for (const PlacedOpening& opening : openings)
      if (!cut_of(opening.index).empty())
        for (Block& block : masonry_cut_out(opening, storeys_)) blocks_.push_back(std::move(block));
    if (bare_teeth_ > 0) notes.push_back({"plan_wall.bare_teeth", {{"teeth", bare_teeth_}}});
    const auto is_tied = [&](const Block& block) { return is_through(block); };
    if (spec_.through_courses > 0 && std::none_of(blocks_.begin(), blocks_.end(), is_tied))
      notes.push_back({"plan_wall.no_through_stone",
                       {{"courses", courses().count}, {"each", spec_.through_courses}}});
    if (masonry.joined_pieces > 0)
      notes.push_back({"fit.joined_pieces",
                       {{"pieces", masonry.joined_pieces},
                        {"shorter_mm", 1e3 * kSliver * storey().lattice.columns.step}}});
  }

  // --- regions ---

  [[nodiscard]] std::string region_path(int index, const char* key = "") const {
    return fmt::format("{}.region.{}{}{}", wall_.path, index, *key != 0 ? "." : "", key);
  }

  [[nodiscard]] std::string region_called(int index) const {
    return named_region(index).called() + " of the wall " + wall_.name;
  }

  [[nodiscard]] NamedRegion named_region(int index) const {
    const PlanRegionSpec& region = spec_.region[index];
    return {region.place, region_path(index), index, region.name, kUnset, false};
  }

  [[nodiscard]] bool has_own_depth(const Block& block) const {
    if (block.region < 0 || spec_.wythes > 1) return false;
    const PlanRegionSpec& region = spec_.region[block.region];
    return !std::isnan(region.thickness) || region.offset != 0;
  }

  // Refuses a region that changes nothing, or has a depth of its own in a wall of several wythes.
  void check_region(int index, FaultList& faults) const {
    const PlanRegionSpec& region = spec_.region[index];
    const bool is_thick = !std::isnan(region.thickness);
    if (region.material.empty() && !is_thick && region.offset == 0)
      add_fault(faults, region_path(index), "", named_region(index).called() + " changes nothing",
                "write material, thickness or offset, or leave it out");
    if (spec_.wythes > 1 && (is_thick || region.offset != 0))
      add_fault(faults, region_path(index, is_thick ? "thickness" : "offset"), "",
                "is for walls of one wythe, and this one has " + std::to_string(spec_.wythes),
                "leave it out, or make a [[plan_wall]] of this part");
    if (is_thick)
      (void)is_positive({region_path(index, "thickness"), region.thickness, "m", "0.15 m"}, faults);
  }

  // A block belongs to the last region that holds its centroid.
  void take_regions(const std::vector<PlacedOpening>& openings, std::vector<Message>& notes,
                    FaultList& faults) {
    std::vector<NamedRegion> regions;
    for (int i = 0; i < static_cast<int>(spec_.region.size()); ++i) {
      check_region(i, faults);
      regions.push_back(named_region(i));
    }
    mark_regions(regions, {wall_.storeys, openings, length(), storeys_.back().top()}, blocks_,
                 notes, faults);
    if (!faults.empty()) return;
    check_region_beds(faults);
    check_region_meetings(faults);
  }

  // Refuses blocks that would stand beside those above or below them.
  void check_region_beds(FaultList& faults) const {
    std::set<int> told;
    for (const Block& block : blocks_) {
      if (!has_own_depth(block) || told.contains(block.region)) continue;
      const Rect box = bounds(block.outline);
      const std::vector<double> n = depths(block);
      for (const Block& other : blocks_) {
        const Rect there = bounds(other.outline);
        const bool touches =
            std::fabs(there.y1 - box.y0) < kMargin || std::fabs(there.y0 - box.y1) < kMargin;
        if (!touches || there.x0 > box.x1 - kMargin || there.x1 < box.x0 + kMargin) continue;
        const std::vector<double> m = depths(other);
        if (std::min(n.back(), m.back()) - std::max(n.front(), m.front()) > kMargin) continue;
        told.insert(block.region);
        add_fault(
            faults, region_path(block.region, "offset"), metres(spec_.region[block.region].offset),
            "puts " + named_region(block.region).called() + " beside what lies above or below it",
            "write a smaller distance, to either side");
        break;
      }
    }
  }

  // Along this wall, where the other wall of a meeting touches it; of an end that stands against a face, only if that is oblique.
  [[nodiscard]] std::vector<std::pair<Slot, const StraightWall*>> meetings() const {
    std::vector<std::pair<Slot, const StraightWall*>> found;
    for (int e = 0; e < 2; ++e) {
      const WallEnd& end = wall_.end[e];
      if (end.kind == EndKind::kFree) continue;
      const StraightWall& other = walls_[end.other];
      const bool is_oblique = end.face.x != 0 || end.face.y != 0;
      const double deep = end.reach > 0 ? std::max(2 * end.reach, other.thickness)
                          : is_oblique  ? wall_.thickness
                                        : 0;
      if (deep > 0)
        found.push_back({e == 0 ? Slot{0, deep} : Slot{length() - deep, length()}, &other});
    }
    for (const Tee& tee : wall_.tees) {
      const StraightWall& other = walls_[tee.other];
      const double sine = std::fabs(cross(wall_.along, other.along));
      const double x = tee.at - wall_.begin(), half = 0.5 * other.thickness / sine;
      found.push_back({{x - half, x + half}, &other});
    }
    return found;
  }

  // Refuses a depth of its own where another wall is toothed in or stands against this one: their blocks are as deep as the wall.
  void check_region_meetings(FaultList& faults) const {
    std::set<int> told;
    for (const auto& [slot, other] : meetings())
      for (const Block& block : blocks_) {
        const Rect box = bounds(block.outline);
        if (!has_own_depth(block) || told.contains(block.region) || box.x1 < slot.x0 + kMargin ||
            box.x0 > slot.x1 - kMargin ||
            box.y0 > courses().line(std::min(courses().count, other->rows())) - kMargin)
          continue;
        told.insert(block.region);
        add_fault(faults, region_path(block.region), "",
                  named_region(block.region).called() + " has a depth of its own where the wall " +
                      other->name + " meets this one, from " + metres(slot.x0) + " to " +
                      metres(slot.x1),
                  "end it beside that place");
      }
  }

  [[nodiscard]] const std::string& material_of(const Block& block) const {
    const bool own = block.region >= 0 && !spec_.region[block.region].material.empty();
    return own ? spec_.region[block.region].material : spec_.material;
  }

  // --- gable ---

  [[nodiscard]] Polygon below_gable() const {
    const double l = length(), h = courses().end();
    return {{0, 0}, {l, 0}, {l, h}, {l / 2, h + spec_.gable}, {0, h}};
  }

  // Cuts units under the slopes; small pieces are joined to the next unit towards the middle.
  void cut_gable(int& joined) {
    const Polygon roof = below_gable();
    const Axis& columns = storey().lattice.columns;
    const double least = kLeastPiece * columns.step * courses().step;
    std::vector<Block> kept;
    for (std::size_t begin = 0; begin < blocks_.size();) {
      std::size_t end = begin;
      while (end < blocks_.size() && blocks_[end].course == blocks_[begin].course) ++end;
      std::vector<Block> row(blocks_.begin() + static_cast<std::ptrdiff_t>(begin),
                             blocks_.begin() + static_cast<std::ptrdiff_t>(end));
      begin = end;
      if (bounds(row.front().outline).y1 > courses().end() + kMargin)
        cut_row(row, roof, least, joined);
      kept.insert(kept.end(), row.begin(), row.end());
    }
    blocks_ = std::move(kept);
  }

  static void cut_row(std::vector<Block>& row, const Polygon& roof, double least, int& joined) {
    const auto area = [&](const Block& block) {
      const Polygon part = part_inside(block.outline, roof);
      return part.size() < 3 ? 0.0 : moments(part).area;
    };
    std::erase_if(row, [&](const Block& block) { return area(block) < 1e-12; });
    while (row.size() > 1) {
      const auto small =
          std::find_if(row.begin(), row.end(), [&](const Block& b) { return area(b) < least; });
      if (small == row.end()) break;
      const auto k = small - row.begin();
      const bool left = 2 * k < static_cast<std::ptrdiff_t>(row.size());
      Block& host = row[left ? k + 1 : k - 1];
      host.outline = outline_of(join(bounds(host.outline), bounds(small->outline)));
      row.erase(small);
      ++joined;
    }
    for (Block& block : row) block.outline = part_inside(block.outline, roof);
  }

  // --- solids ---

  [[nodiscard]] Vec3 place(Vec2 p, double across) const {
    const double s = p.x + wall_.begin();
    return axes_.place({wall_.from.x + s * wall_.along.x + across * wall_.across.x,
                        wall_.from.y + s * wall_.along.y + across * wall_.across.y},
                       p.y + wall_.base);
  }

  [[nodiscard]] Polyhedron prism(const Polygon& outline, double n0, double n1) const {
    std::vector<Vec3> back, front;
    for (const Vec2 p : outline) {
      back.push_back(place(p, n0));
      front.push_back(place(p, n1));
    }
    return solid_between(back, front);
  }

  // Thicknesses of the wythes from one face to the other.
  [[nodiscard]] std::vector<double> depths(const Block& block) const {
    const double half = wall_.thickness / 2;
    if (has_own_depth(block)) {
      const PlanRegionSpec& region = spec_.region[block.region];
      const double own = std::isnan(region.thickness) ? half : region.thickness / 2;
      return {region.offset - own, region.offset + own};
    }
    if (spec_.wythes == 1) return {-half, half};
    if (spec_.wythes == 2) return {-half, 0, half};
    const double core = std::isnan(spec_.core) ? wall_.thickness / 3 : spec_.core;
    return {-half, -core / 2, core / 2, half};
  }

  // Whether a block passes through all wythes: a header or a through-stone.
  [[nodiscard]] bool is_through(const Block& block) const {
    const int course = block.course;
    const std::vector<Piece> pieces = lay_course(storey(), course);
    const Rect box = bounds(block.outline);
    const double x = 0.5 * (box.x0 + box.x1);
    Slot unit{0, 0};
    int number = -1;
    for (const Piece& piece : pieces)
      if (x >= piece.x0 && x <= piece.x1) number = piece.unit;
    bool first = true;
    for (const Piece& piece : pieces) {
      if (piece.unit != number) continue;
      if (first) unit.x0 = piece.x0;
      unit.x1 = piece.x1;
      first = false;
    }
    const Lattice& lattice = storey().lattice;
    const Bond bond = wall_.wall.bond;
    if (bond == Bond::kHeader || (bond == Bond::kEnglish && course % 2 == 1)) return true;
    if (bond == Bond::kFlemish &&
        unit.x1 - unit.x0 < 0.5 * (lattice.header + lattice.stretcher) - kMargin)
      return lattice.header < lattice.stretcher - kMargin;
    const int row = course - storey().first_course;
    if (spec_.through_courses < 1 || row % spec_.through_courses != spec_.through_courses - 1)
      return false;
    const double spacing = std::isnan(spec_.through_spacing) ? 0 : spec_.through_spacing;
    const int every = std::max(1, to_int(std::round(spacing / lattice.stretcher)));
    return number % every == every / 2;
  }

  [[nodiscard]] std::string name_of(const Block& block) const {
    if (spec_.ring_beam) return fmt::format("{}.beam.s{}", wall_.name, bodies_.size());
    // the bond counts courses from the phase on, ids count them from the ground
    const std::size_t end = block.id.find_first_not_of("0123456789", 1);
    if (block.id.empty() || block.id.front() != 'c') return wall_.name + "." + block.id;
    return fmt::format("{}.c{:02}{}", wall_.name, block.course - storey().first_course,
                       block.id.substr(end));
  }

  // Cuts off what lies beyond an oblique face that the wall stands against; false where nothing is left.
  bool cut_at_faces(Polyhedron& part) const {
    for (const WallEnd& end : wall_.end)
      if (end.face.x != 0 || end.face.y != 0)
        part = cut(part, axes_.place(end.face, 0), end.face_at).above;
    return !part.vertex.empty();
  }

  // Name of the stage that cuts an opening; "": the opening is built with the wall.
  [[nodiscard]] const std::string& cut_of(int opening) const { return spec_.opening[opening].cut; }

  bool keep(const std::string& id, const std::string& material, Polyhedron part, int course,
            int wythe = 0) {
    if (!cut_at_faces(part)) return false;
    BuiltBody built;
    built.body.id = id;
    if (!material.empty()) built.body.material = material;
    built.body.part = {part};
    built.wall = wall_.name;
    built.course = course;
    built.wythe = wythe;
    bodies_.push_back(std::move(built));
    return true;
  }

  void add_solids(const Block& block) {
    const std::vector<double> n = depths(block);
    const std::string id = name_of(block);
    const bool is_cut = block.cut_from >= 0;
    const std::string piece = is_cut ? fmt::format(".cut{}_{}", block.cut_from, cut_pieces_++) : "";
    const int course = spec_.ring_beam ? -1 : block.course - storey().first_course;
    const auto add = [&](const std::string& wythe, const std::string& material, double n0,
                         double n1, int number) {
      if (!keep(id + wythe + piece, material, prism(block.outline, n0, n1), course, number)) return;
      if (is_cut) bodies_.back().body.cut = cut_of(block.cut_from);
      if (spec_.ring_beam) bodies_.back().body.role = "ring_beam";
      if (has_own_depth(block)) bodies_.back().region = region_called(block.region);
    };
    if (n.size() == 2 || is_through(block))
      return add(n.size() > 2 ? ".t" : "", material_of(block), n.front(), n.back(), 0);
    for (std::size_t k = 0; k + 1 < n.size(); ++k) {
      const bool core = n.size() == 4 && k == 1 && !spec_.core_material.empty();
      add(fmt::format(".w{}", k + 1), core ? spec_.core_material : material_of(block), n[k],
          n[k + 1], static_cast<int>(k) + 1);
    }
  }

  // Whether a lintel of segments bends: it is a chain of segments where its material has both moduli (model/space/space.cpp),
  // otherwise one rigid block.
  [[nodiscard]] bool bends(const LintelSpec& lintel) const {
    const auto body = site_.model.material.find(lintel.material);
    return body != site_.model.material.end() && body->second.youngs_modulus > 0 &&
           body->second.shear_modulus > 0;
  }

  // Adds lintel and sill. A sill is one rigid block; voussoirs are blocks of their own.
  void add_spanning(const PlacedOpening& opening) {
    const OpeningSpec& spec = spec_.opening[opening.index];
    const double half = wall_.thickness / 2;
    const auto add = [&](const std::string& id, const std::string& material,
                         const Polygon& outline) {
      const bool stays = keep(wall_.name + "." + id, material.empty() ? spec_.material : material,
                              prism(outline, -half, half), -1);
      if (stays) bodies_.back().body.put_in = spec.cut;
      if (stays && !id.starts_with("arch"))
        bodies_.back().body.role = id.starts_with("sill") ? "sill" : "lintel";
    };
    const std::string number = std::to_string(opening.index);
    const bool zones = spec.lintel.model == LintelModel::kZones,
               is_chain = bends(spec.lintel) && !zones;
    if (!opening.segment.empty() && !is_chain) {
      add("lintel" + number, spec.lintel.material,
          outline_of(join(opening.segment.front(), opening.segment.back())));
      if (zones) bodies_.back().body.zone = {spec.lintel.zones, spec.lintel.zone_length};
    }
    for (std::size_t k = 0; k < opening.segment.size() && is_chain; ++k)
      add(fmt::format("lintel{}.s{}", number, k), spec.lintel.material,
          outline_of(opening.segment[k]));
    if (!opening.sill.empty())
      add("sill" + number, spec.sill.material,
          outline_of(join(opening.sill.front(), opening.sill.back())));
    for (std::size_t k = 0; k < opening.arch.voussoirs(); ++k)
      add(fmt::format("arch{}_{}", number, k), spec.arch.material, voussoir(opening.arch, k));
  }

  // Adds fixed slabs, one course deep and as deep as what stands on them, below each part of the lowest course.
  void add_ground() {
    struct Run {
      double x0, x1, n0, n1;
    };
    std::vector<Run> slots, runs;
    for (const Block& block : blocks_) {
      const Rect box = bounds(block.outline);
      const std::vector<double> n = depths(block);
      if (box.y0 < kMargin) slots.push_back({box.x0, box.x1, n.front(), n.back()});
    }
    std::sort(slots.begin(), slots.end(), [](const Run& a, const Run& b) { return a.x0 < b.x0; });
    for (const Run& slot : slots)
      if (!runs.empty() && slot.x0 < runs.back().x1 + kMargin && slot.n0 == runs.back().n0 &&
          slot.n1 == runs.back().n1)
        runs.back().x1 = std::max(runs.back().x1, slot.x1);
      else
        runs.push_back(slot);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const Run& run = runs[k];
      if (keep(wall_.name + ".ground" + (k == 0 ? "" : std::to_string(k + 1)), spec_.material,
               prism(outline_of({run.x0, -courses().step, run.x1, 0}), run.n0, run.n1), -1))
        bodies_.back().body.fixed = true;
    }
  }

  const Site& site_;
  const PlanWallSpec& spec_;
  PlanAxes axes_;
  const std::vector<StraightWall>& walls_;
  const StraightWall& wall_;
  std::vector<Storey> storeys_;
  std::vector<Block> blocks_;
  std::vector<std::pair<int, double>> bridges_;  // row, middle [m]
  int bare_teeth_ = 0;                           // teeth without a bridge
  int cut_pieces_ = 0;                           // number of cut-out pieces so far
  std::vector<BuiltBody> bodies_;
};

// Places one of the model's frames in a wall.
class FrameInWall {
 public:
  FrameInWall(const Site& site, const StraightWall& wall, std::size_t index, FaultList& faults)
      : site_(site), wall_(wall), frame_(site.model.frame[index]), index_(index), faults_(faults) {}

  FrameSpec placed() {
    const PlanAxes axes{site_.z_up()};
    const Vec2 corner =
        wall_.from + Vec2{wall_.begin() * wall_.along.x, wall_.begin() * wall_.along.y};
    const Vec3 origin = axes.place(corner, wall_.base);
    const Vec3 along = axes.place(wall_.along, 0);
    frame_.x = origin.x;
    frame_.y = site_.z_up() ? -origin.z : origin.y;
    frame_.z = site_.z_up() ? origin.y : origin.z;
    frame_.turn = elementary::atan2(-along.z, along.x);
    frame_.wall = "";
    const Layout layout(site_, wall_);
    const Shape shape = layout.shape();
    std::vector<Message> said;
    FaultList found;
    const std::vector<PlacedOpening> openings =
        place_openings(shape, wall_.storeys, {}, said, found);
    for (const PlacedOpening& opening : openings) take(opening);
    if (!frame_.round.empty())
      add_fault(faults_, fmt::format("frame.{}.round", index_), "\"" + frame_.round + "\"",
                "is no opening of the wall " + wall_.name,
                "name an opening of its [[plan_wall]], or write the frame's axis: line");
    return frame_;
  }

 private:
  void take(const PlacedOpening& opening) {
    const OpeningSpec& spec = wall_.wall.opening[opening.index];
    const Rect& hole = opening.hole;
    const bool is_round = !frame_.round.empty() && frame_.round == spec.name;
    if ((is_round || stands_in(hole)) && frame_.stage.empty()) frame_.stage = spec.cut;
    if (!is_round) return;
    frame_.hole = {hole.x0, hole.y0, hole.x1 - hole.x0, hole.y1 - hole.y0};
    frame_.round = "";
  }

  // Whether it reaches into the hole: its own hole, or a part of its line, as deep as its section (as in
  // model/plane/standing.cpp).
  [[nodiscard]] bool stands_in(const Rect& hole) const {
    constexpr double kTouch = 1e-6;  // [m]
    const HoleSpec& own = frame_.hole;
    if (overlaps({own.x, own.y, own.x + own.width, own.y + own.height}, hole, kTouch)) return true;
    FaultList told;  // where the frame is placed
    const FrameSections sections = sections_of(frame_, index_, told).value_or(FrameSections{});
    for (std::size_t k = 1; k < frame_.line.size(); ++k) {
      const auto &p = frame_.line[k - 1], &q = frame_.line[k];
      const bool upright = std::fabs(q[1] - p[1]) > std::fabs(q[0] - p[0]);
      const double x = upright ? sections.column.height / 2 : 0;
      const double y = upright ? 0 : sections.beam.height / 2;
      const Rect part{std::min(p[0], q[0]) - x, std::min(p[1], q[1]) - y, std::max(p[0], q[0]) + x,
                      std::max(p[1], q[1]) + y};
      if (overlaps(part, hole, kTouch)) return true;
    }
    return false;
  }

  const Site& site_;
  const StraightWall& wall_;
  FrameSpec frame_;
  std::size_t index_;
  FaultList& faults_;
};

double count_of(const StraightWall& wall, const PlanWallSpec& spec) {
  const UnitSpec& unit = wall.wall.unit;
  return wall.wall.length / unit.length * 2 * (wall.wall.height + spec.gable) / unit.height *
         std::clamp(spec.wythes, 1, 3);
}

bool check_count(const Site& site, const std::vector<StraightWall>& walls, FaultList& faults) {
  double count = 0;
  for (const StraightWall& wall : walls) {
    const double own = count_of(wall, site.spec.plan_wall[wall.index]);
    if (own > 0) count += own;
  }
  if (count <= static_cast<double>(kMostBuilt)) return true;
  add_fault(faults, "plan_wall", fmt::format("{:.3g} blocks", count),
            fmt::format("are more than {} blocks, the most that are built", kMostBuilt),
            "write larger units or smaller walls");
  return false;
}

}  // namespace

std::vector<FrameSpec> frames_in_walls(const Site& site, const std::vector<StraightWall>& walls,
                                       FaultList& faults) {
  std::vector<FrameSpec> frames = site.model.frame;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const std::string path = fmt::format("frame.{}", k);
    (void)find_cut_stage(site.model.stage, path + ".stage", frames[k].stage, faults);
    if (frames[k].wall.empty() && !frames[k].round.empty())
      add_fault(faults, path + ".wall", "", "is missing: its opening is one of a wall",
                "write wall = \"the name of a [[plan_wall]]\"");
    if (frames[k].wall.empty()) continue;
    for (const auto& [key, stated] : {std::pair(".x", !std::isnan(frames[k].x)),
                                      {".y", !std::isnan(frames[k].y)},
                                      {".z", !std::isnan(frames[k].z)},
                                      {".turn", frames[k].turn != 0}})
      if (stated)
        add_fault(faults, path + key, "", "stands beside wall, which says where the plane is",
                  "leave it out, or leave wall out");
    if (!frames[k].round.empty() && has_hole(frames[k]))
      add_fault(faults, path + ".hole", "", "stands beside round, which says where the opening is",
                "write one of both");
    std::vector<std::string> names;
    for (const StraightWall& wall : walls) names.push_back(wall.name);
    const auto found = std::find(names.begin(), names.end(), frames[k].wall);
    if (found == names.end())
      add_fault(faults, path + ".wall", "\"" + frames[k].wall + "\"", "is no straight wall",
                name_advice(frames[k].wall, names));
    else
      frames[k] = FrameInWall(site, walls[found - names.begin()], k, faults).placed();
  }
  return frames;
}

std::vector<BuiltBody> build_plan_walls(const Site& site, std::vector<StraightWall>& walls,
                                        std::vector<Message>& notes, FaultList& faults) {
  walls = read_plan(site, notes, faults);
  if (!check_count(site, walls, faults)) return {};
  for (StraightWall& wall : walls) plan_courses(site, wall, notes, faults);
  match_courses(walls, faults);
  if (!faults.empty()) return {};
  std::vector<BuiltBody> bodies;
  for (const StraightWall& wall : walls) {
    std::vector<BuiltBody> own = WallBuilder(site, walls, wall).build(notes, faults);
    std::move(own.begin(), own.end(), std::back_inserter(bodies));
  }
  return bodies;
}

}  // namespace wythe::geometry
