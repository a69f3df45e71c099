// Each region is a box or a polygon; it marks the blocks whose centroid it contains. Piers are counted
// from the left between the openings of one storey. Heights are above the storey's foot where a storey is named. A
// later region takes blocks from an earlier one, with a note. It changes only the mark and a thickness.
#include "geometry/wall/regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/blocks_file.h"
#include "geometry/polygon.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

// The area of a region in the wall's elevation; a box where it has no polygon.
struct RegionArea {
  Rect box;
  Polygon polygon;
};

bool has_box(const RegionPlace& r) {
  return !(std::isnan(r.x) && std::isnan(r.y) && std::isnan(r.width) && std::isnan(r.height));
}

bool changes_something(const RegionSpec& r) {
  const MasonryJoints& j = r.joints;
  return !std::isnan(r.density) || !std::isnan(r.thickness) || !j.joint.empty() ||
         !j.head_joint.empty() || !j.unit_joint.empty();
}

// Whether the place is stated in exactly one way; a storey alone is one.
bool has_one_place(const NamedRegion& region, FaultList& faults) {
  const RegionPlace& r = region.place;
  const int ways = (r.pier > 0) + has_box(r) + !r.polygon.empty();
  if (ways == 1 || (ways == 0 && !r.storey.empty())) return true;
  add_fault(
      faults, region.at(), "",
      region.called() + (ways == 0 ? " has no place" : " has more than one place"),
      region.in_storeys
          ? "write storey = \"...\", with pier = 1 for a pier of it; or x, y, width and height; or "
            "polygon = [[\"0 m\", \"0 m\"], ...]"
          : "write pier = 1; or x, y, width and height; or polygon = [[\"0 m\", \"0 m\"], ...]");
  return false;
}

std::optional<RegionArea> pier_area(const NamedRegion& region, const Storey& storey,
                                    const RegionSite& site, FaultList& faults) {
  std::vector<PlacedOpening> beside;
  for (const PlacedOpening& opening : site.openings)
    if (site.storeys[opening.storey].index == storey.index) beside.push_back(opening);
  const std::vector<Pier> piers = find_piers(beside, site.length, storey.height);
  const auto k = static_cast<std::size_t>(region.place.pier) - 1;
  const bool is_last = storey.index == site.storeys.back().index;  // a gable belongs to it
  const double top = is_last ? std::max(storey.top(), site.height) : storey.top();
  if (k < piers.size()) return RegionArea{{piers[k].x0, storey.foot, piers[k].x1, top}, {}};
  const std::string whose = storey.index < 0 ? "the wall" : storey.called();
  add_fault(faults, region.at("pier"), std::to_string(region.place.pier),
            whose + " has " + std::to_string(piers.size()) + " piers between its openings",
            "write pier = 1" + (piers.size() > 1 ? " to " + std::to_string(piers.size()) : ""));
  return std::nullopt;
}

std::optional<RegionArea> box_area(const NamedRegion& region, double base, FaultList& faults) {
  const RegionPlace& r = region.place;
  bool given = is_positive({region.at("width"), r.width, "m", "1.20 m"}, faults);
  given &= is_positive({region.at("height"), r.height, "m", "0.60 m"}, faults);
  for (const auto& [key, value] : {std::pair("x", r.x), {"y", r.y}})
    if (!std::isfinite(value)) {
      add_fault(faults, region.at(key), "", "missing: a box needs x, y, width and height",
                std::string("write e.g. ") + key + " = \"1.20 m\"");
      given = false;
    }
  if (!given) return std::nullopt;
  return RegionArea{{r.x, r.y + base, r.x + r.width, r.y + base + r.height}, {}};
}

std::optional<RegionArea> polygon_area(const NamedRegion& region, double base, FaultList& faults) {
  RegionArea area;
  for (const auto& [x, y] : region.place.polygon) area.polygon.push_back({x, y + base});
  const std::string problem = outline_problem(area.polygon);
  if (problem.empty()) return area;
  add_fault(faults, region.at("polygon"), std::to_string(area.polygon.size()) + " corners",
            region.called() + ": " + problem, "list its corners once around, the first not again");
  return std::nullopt;
}

std::optional<RegionArea> area_of(const NamedRegion& region, const RegionSite& site,
                                  FaultList& faults) {
  const RegionPlace& place = region.place;
  if (!has_one_place(region, faults)) return std::nullopt;
  const Storey* storey = nullptr;
  if (!place.storey.empty()) {
    storey = find_storey(site.storeys, place.storey, region.at("storey"), faults);
    if (storey == nullptr) return std::nullopt;
  }
  const double base = storey == nullptr ? 0 : storey->foot;
  if (has_box(place)) return box_area(region, base, faults);
  if (!place.polygon.empty()) return polygon_area(region, base, faults);
  if (storey == nullptr && site.storeys.front().index < 0) storey = &site.storeys.front();
  if (storey == nullptr) {
    add_fault(faults, region.at("storey"), "", "missing: piers are counted in a storey",
              "write storey = \"" + site.storeys.front().name + "\"");
    return std::nullopt;
  }
  if (place.pier > 0) return pier_area(region, *storey, site, faults);
  return RegionArea{{0, storey->foot, site.length, storey->top()}, {}};
}

bool on_edge(Vec2 p, Vec2 from, Vec2 to, double tolerance) {
  const Vec2 along = to - from, out = p - from;
  const double size = length(along);
  const double away = std::abs(along.x * out.y - along.y * out.x) / size;
  const double at = (along.x * out.x + along.y * out.y) / size;
  return away <= tolerance && at >= -tolerance && at <= size + tolerance;
}

// Point-in-polygon test by crossings of a line to the right; a point within the tolerance of an edge is inside.
bool holds(const Polygon& polygon, Vec2 p, double tolerance) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (on_edge(p, a, b, tolerance)) return true;
    const bool crosses = (a.y > p.y) != (b.y > p.y);
    if (crosses && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool holds(const RegionArea& area, Vec2 p, double tolerance) {
  if (!area.polygon.empty()) return holds(area.polygon, p, tolerance);
  const Rect& box = area.box;
  return p.x >= box.x0 - tolerance && p.x <= box.x1 + tolerance && p.y >= box.y0 - tolerance &&
         p.y <= box.y1 + tolerance;
}

// Gives the region its blocks, and counts them by the region that they had; false where there are none.
bool take_blocks(const NamedRegion& region, const RegionArea& area, double tolerance,
                 const std::vector<Vec2>& centre, std::vector<Block>& blocks,
                 std::map<int, int>& taken) {
  bool found = false;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].role != Role::kMasonry || !holds(area, centre[b], tolerance)) continue;
    found = true;
    if (blocks[b].region >= 0) ++taken[blocks[b].region];
    blocks[b].region = region.index;
    if (!std::isnan(region.thickness)) blocks[b].thickness = region.thickness;
  }
  return found;
}

}  // namespace

void mark_regions(const std::vector<NamedRegion>& regions, const RegionSite& site,
                  std::vector<Block>& blocks, std::vector<Message>& notes, FaultList& faults) {
  std::vector<Vec2> centre;
  if (!regions.empty())
    for (const Block& block : blocks) centre.push_back(moments(block.outline).centroid);
  const double tolerance = 1e-9 * std::max(site.length, site.height);
  std::map<int, std::string> name;
  for (const NamedRegion& region : regions) {
    name[region.index] = region.name.empty() ? std::to_string(region.index) : region.name;
    const std::optional<RegionArea> area = area_of(region, site, faults);
    if (!area) continue;
    std::map<int, int> taken;
    if (!take_blocks(region, *area, tolerance, centre, blocks, taken))
      add_fault(faults, region.at(), "",
                region.called() + " holds no block: none has its centre there",
                "move it into the wall, or make it as large as a block");
    for (const auto& [other, count] : taken)
      notes.push_back(
          {"region.takes",
           {{"region", name[region.index]}, {"blocks", count}, {"other", name[other]}}});
  }
}

namespace {

// Whether the region changes something, by numbers that can be.
bool is_sound(const RegionSpec& spec, const NamedRegion& region, FaultList& faults) {
  if (!changes_something(spec)) {
    add_fault(faults, region.at(), "", region.called() + " changes nothing",
              "write joint, head_joint, unit_joint, density or thickness, or leave it out");
    return false;
  }
  return (std::isnan(spec.density) ||
          is_positive({region.at("density"), spec.density, "kg/m^3", "1900 kg/m^3"}, faults)) &&
         (std::isnan(spec.thickness) ||
          is_positive({region.at("thickness"), spec.thickness, "m", "0.15 m"}, faults));
}

}  // namespace

void assign_regions(const Shape& shape, const std::vector<Storey>& storeys,
                    const std::vector<PlacedOpening>& openings, Assembly& assembly,
                    FaultList& faults) {
  std::vector<NamedRegion> regions;
  for (std::size_t i = 0; i < shape.region.size(); ++i) {
    const RegionSpec& spec = shape.region[i];
    const NamedRegion region{spec.place, "region." + std::to_string(i), static_cast<int>(i),
                             spec.name, spec.thickness};
    if (is_sound(spec, region, faults)) regions.push_back(region);
  }
  mark_regions(regions, {storeys, openings, assembly.length, assembly.height}, assembly.blocks,
               assembly.report.notes, faults);
}

}  // namespace wythe::geometry
