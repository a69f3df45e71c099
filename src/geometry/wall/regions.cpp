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

// Data of the wall for its regions.
struct RegionSite {
  const std::vector<Storey>& storeys;
  const std::vector<PlacedOpening>& openings;
  const Assembly& assembly;
  FaultList& faults;
};

// One region, for messages.
struct NamedRegion {
  const RegionSpec& spec;
  int index;
  [[nodiscard]] std::string path(const std::string& key = "") const {
    const std::string table = "region." + std::to_string(index);
    return key.empty() ? table : table + "." + key;
  }
  [[nodiscard]] std::string called() const {
    return "region " + std::to_string(index) + (spec.name.empty() ? "" : " (" + spec.name + ")");
  }
};

// The area of a region; a box where it has no polygon.
struct Area {
  Rect box;
  Polygon polygon;
};

bool has_box(const RegionSpec& r) {
  return !(std::isnan(r.x) && std::isnan(r.y) && std::isnan(r.width) && std::isnan(r.height));
}

bool changes_something(const RegionSpec& r) {
  const MasonryJoints& j = r.joints;
  return !std::isnan(r.density) || !std::isnan(r.thickness) || !j.joint.empty() ||
         !j.head_joint.empty() || !j.unit_joint.empty();
}

// Whether the place is stated in exactly one way; a storey alone is one.
bool has_one_place(const NamedRegion& region, FaultList& faults) {
  const RegionSpec& r = region.spec;
  const int ways = (r.pier > 0) + has_box(r) + !r.polygon.empty();
  if (ways == 1 || (ways == 0 && !r.storey.empty())) return true;
  add_fault(faults, region.path(), "",
            region.called() + (ways == 0 ? " has no place" : " has more than one place"),
            "write storey = \"...\", with pier = 1 for a pier of it; or x, y, width and height; or "
            "polygon = [[\"0 m\", \"0 m\"], ...]");
  return false;
}

std::optional<Area> pier_area(const NamedRegion& region, const Storey& storey,
                              const RegionSite& site) {
  std::vector<PlacedOpening> beside;
  for (const PlacedOpening& opening : site.openings)
    if (site.storeys[opening.storey].index == storey.index) beside.push_back(opening);
  const std::vector<Pier> piers = find_piers(beside, site.assembly.length, storey.height);
  const auto k = static_cast<std::size_t>(region.spec.pier) - 1;
  if (k < piers.size()) return Area{{piers[k].x0, storey.foot, piers[k].x1, storey.top()}, {}};
  const std::string whose = storey.index < 0 ? "the wall" : storey.called();
  add_fault(site.faults, region.path("pier"), std::to_string(region.spec.pier),
            whose + " has " + std::to_string(piers.size()) + " piers between its openings",
            "write pier = 1" + (piers.size() > 1 ? " to " + std::to_string(piers.size()) : ""));
  return std::nullopt;
}

std::optional<Area> box_area(const NamedRegion& region, double base, FaultList& faults) {
  const RegionSpec& r = region.spec;
  bool given = is_positive({region.path("width"), r.width, "m", "1.20 m"}, faults);
  given &= is_positive({region.path("height"), r.height, "m", "0.60 m"}, faults);
  for (const auto& [key, value] : {std::pair("x", r.x), {"y", r.y}})
    if (!std::isfinite(value)) {
      add_fault(faults, region.path(key), "", "missing: a box needs x, y, width and height",
                std::string("write e.g. ") + key + " = \"1.20 m\"");
      given = false;
    }
  if (!given) return std::nullopt;
  return Area{{r.x, r.y + base, r.x + r.width, r.y + base + r.height}, {}};
}

std::optional<Area> polygon_area(const NamedRegion& region, double base, FaultList& faults) {
  Area area;
  for (const auto& [x, y] : region.spec.polygon) area.polygon.push_back({x, y + base});
  const std::string problem = outline_problem(area.polygon);
  if (problem.empty()) return area;
  add_fault(faults, region.path("polygon"), std::to_string(area.polygon.size()) + " corners",
            region.called() + ": " + problem, "list its corners once around, the first not again");
  return std::nullopt;
}

std::optional<Area> area_of(const NamedRegion& region, const RegionSite& site) {
  if (!changes_something(region.spec)) {
    add_fault(site.faults, region.path(), "", region.called() + " changes nothing",
              "write joint, head_joint, unit_joint, density or thickness, or leave it out");
    return std::nullopt;
  }
  if (!std::isnan(region.spec.density) &&
      !is_positive({region.path("density"), region.spec.density, "kg/m^3", "1900 kg/m^3"},
                   site.faults))
    return std::nullopt;
  if (!std::isnan(region.spec.thickness) &&
      !is_positive({region.path("thickness"), region.spec.thickness, "m", "0.15 m"}, site.faults))
    return std::nullopt;
  if (!has_one_place(region, site.faults)) return std::nullopt;
  const Storey* storey = nullptr;
  if (!region.spec.storey.empty()) {
    storey = find_storey(site.storeys, region.spec.storey, region.path("storey"), site.faults);
    if (storey == nullptr) return std::nullopt;
  }
  const double base = storey == nullptr ? 0 : storey->foot;
  if (has_box(region.spec)) return box_area(region, base, site.faults);
  if (!region.spec.polygon.empty()) return polygon_area(region, base, site.faults);
  if (storey == nullptr && site.storeys.front().index < 0) storey = &site.storeys.front();
  if (storey == nullptr) {
    add_fault(site.faults, region.path("storey"), "", "missing: piers are counted in a storey",
              "write storey = \"" + site.storeys.front().name + "\"");
    return std::nullopt;
  }
  if (region.spec.pier > 0) return pier_area(region, *storey, site);
  return Area{{0, storey->foot, site.assembly.length, storey->top()}, {}};
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

bool holds(const Area& area, Vec2 p, double tolerance) {
  if (!area.polygon.empty()) return holds(area.polygon, p, tolerance);
  const Rect& box = area.box;
  return p.x >= box.x0 - tolerance && p.x <= box.x1 + tolerance && p.y >= box.y0 - tolerance &&
         p.y <= box.y1 + tolerance;
}

std::string name_of(const RegionSpec& region, int index) {
  return region.name.empty() ? std::to_string(index) : region.name;
}

// Assigns blocks to the region; false where there are none.
bool fill(const Shape& shape, int index, const Area& area, const std::vector<Vec2>& centre,
          Assembly& assembly) {
  const double tolerance = 1e-9 * std::max(assembly.length, assembly.height);
  bool found = false;
  std::map<int, int> taken;  // number of blocks by their previous region
  for (std::size_t b = 0; b < centre.size(); ++b) {
    Block& block = assembly.blocks[b];
    if (block.role != Role::kMasonry || !holds(area, centre[b], tolerance)) continue;
    found = true;
    if (block.region >= 0) ++taken[block.region];
    block.region = index;
    const double thickness = shape.region[index].thickness;
    if (!std::isnan(thickness)) block.thickness = thickness;
  }
  const auto name = [&](int i) { return name_of(shape.region[i], i); };
  for (const auto& [other, blocks] : taken)
    assembly.report.notes.push_back(
        {"region.takes", {{"region", name(index)}, {"blocks", blocks}, {"other", name(other)}}});
  return found;
}

}  // namespace

void assign_regions(const Shape& shape, const std::vector<Storey>& storeys,
                    const std::vector<PlacedOpening>& openings, Assembly& assembly,
                    FaultList& faults) {
  const RegionSite site{storeys, openings, assembly, faults};
  std::vector<Vec2> centre;
  if (!shape.region.empty())
    for (const Block& block : assembly.blocks) centre.push_back(moments(block.outline).centroid);
  for (std::size_t i = 0; i < shape.region.size(); ++i) {
    const NamedRegion region{shape.region[i], static_cast<int>(i)};
    const std::optional<Area> area = area_of(region, site);
    if (!area || fill(shape, region.index, *area, centre, assembly)) continue;
    add_fault(faults, region.path(), "",
              region.called() + " holds no block: none has its centre there",
              "move it into the wall, or make it as large as a block");
  }
}

}  // namespace wythe::geometry
