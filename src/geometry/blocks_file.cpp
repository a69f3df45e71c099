// Checks ids, densities and names of a file's blocks, then makes an outline of each polygon. Corners that repeat a
// neighbour are removed. So are corners on the line of their neighbours, which would divide a joint in two; blocks with
// zones keep them as nodes. wall/checks.cpp tests for overlaps later.
#include "geometry/blocks_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/elementary.h"
#include "core/text.h"
#include "geometry/polygon.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

constexpr std::size_t kMostOutlineCorners = 1000;  // all pairs of edges are compared

std::string path_of(const BlockSpec& block) { return "wall.blocks." + block.id; }

bool is_finite(const Polygon& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

// Corners of the outline, without repetitions (up to rounding) and without corners on the straight line of their
// neighbours, which would divide a joint in two. A block with zones keeps the latter: they are its
// nodes.
Polygon corners_of(const BlockSpec& block) {
  constexpr double kRounding = 1e-6;  // share of the outline's size, as for contacts
  Polygon corners;
  for (const auto& [x, y] : block.polygon) corners.push_back({x, y});
  if (corners.empty() || corners.size() > kMostOutlineCorners || !is_finite(corners))
    return corners;
  const Rect box = bounds(corners);
  const double size = std::max(box.x1 - box.x0, box.y1 - box.y0), near = kRounding * size;
  // drawings repeat the first corner with an error of the last printed digit
  constexpr double kPrinted = 1e-5;  // [m]
  const double closes = std::max(near, std::min(kPrinted, 1e-3 * size));
  const auto apart = [&] {
    return elementary::hypot(corners.back().x - corners.front().x,
                             corners.back().y - corners.front().y);
  };
  while (corners.size() > 3 && apart() <= closes) corners.pop_back();
  const auto is_idle = [&](Vec2 before, Vec2 at, Vec2 after) {
    const double to = elementary::hypot(at.x - before.x, at.y - before.y);
    if (to <= near) return true;
    if (block.zone.zones > 0) return false;
    const double x = after.x - before.x, y = after.y - before.y, length = elementary::hypot(x, y);
    const double along = (at.x - before.x) * x + (at.y - before.y) * y;
    const double off = std::abs((at.x - before.x) * y - (at.y - before.y) * x);
    return length > near && off <= near * length && along > 0 && along < length * length;
  };
  for (std::size_t i = 0, seen = 0; corners.size() > 3 && seen < corners.size();) {
    const std::size_t n = corners.size();
    if (is_idle(corners[(i + n - 1) % n], corners[i % n], corners[(i + 1) % n])) {
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i % n));
      i = (i % n + n - 2) % (n - 1);  // the previous corner has another neighbour now
      seen = 0;
    } else {
      ++i;
      ++seen;
    }
  }
  return corners;
}

bool add_outline(const BlockSpec& spec, Block& block, FaultList& faults) {
  Polygon corners = corners_of(spec);
  const std::string problem = outline_problem(corners);
  if (!problem.empty()) {
    add_fault(faults, path_of(spec), std::to_string(spec.polygon.size()) + " corners", problem,
              corners.size() > kMostOutlineCorners
                  ? "leave out corners that lie nearly on the line of their neighbours"
                  : "list the corners once around the block, in metres");
    return false;
  }
  if (moments(corners).area < 0) std::reverse(corners.begin(), corners.end());
  block.outline = std::move(corners);
  return true;
}

Role role_of(const BlockSpec& block) {
  if (block.fixed) return Role::kSupport;
  return block.beam ? Role::kBeam : Role::kMasonry;
}

// Refuses zones for supports, which do not move, and for the beam, which takes loads.
void refuse_zones(const BlockSpec& block, FaultList& faults) {
  if (block.zone.zones == 0 || !(block.fixed || block.beam)) return;
  add_fault(faults, path_of(block) + ".zones", std::to_string(block.zone.zones),
            block.fixed ? "a fixed block does not deform" : "the loading beam is rigid",
            "leave zones out of this block");
}

void refuse_repeated_ids(const Shape& shape, FaultList& faults) {
  std::set<std::string> seen;
  for (const BlockSpec& block : shape.block) {
    if (seen.insert(block.id).second) continue;
    add_fault(faults, path_of(block), "\"" + block.id + "\"", "two blocks have this id",
              "give every block its own id");
  }
}

void check_densities(const Shape& shape, FaultList& faults) {
  for (const BlockSpec& block : shape.block) {
    const double density = density_in_file(shape, block.material);
    if (block.fixed || (std::isfinite(density) && density > 0)) continue;
    if (std::isnan(density) || density == shape.wall.unit.density) {
      (void)is_positive({"wall.unit.density", density, "kg/m^3", "1250 kg/m^3"}, faults);
      return;
    }
    (void)is_positive({"material." + block.material + ".density", density, "kg/m^3", "1250 kg/m^3"},
                      faults);
  }
}

// Levels of bottom edges of the masonry, each once, lowest first.
std::vector<double> bottoms_of(const std::vector<Block>& blocks, double tolerance) {
  std::vector<double> bottoms;
  for (const Block& block : blocks) {
    if (block.role == Role::kMasonry) bottoms.push_back(bounds(block.outline).y0);
  }
  std::sort(bottoms.begin(), bottoms.end());
  const auto near = [&](double a, double b) { return b - a <= tolerance; };
  bottoms.erase(std::unique(bottoms.begin(), bottoms.end(), near), bottoms.end());
  return bottoms;
}

void number_courses(std::vector<Block>& blocks) {
  if (blocks.empty()) return;
  Rect whole = bounds(blocks.front().outline);
  for (const Block& block : blocks) whole = join(whole, bounds(block.outline));
  const double tolerance = 1e-6 * std::max(whole.x1 - whole.x0, whole.y1 - whole.y0);
  const auto is_upright = [&](const Block& b) {
    return is_upright_rectangle(b.outline, tolerance);
  };
  if (!std::all_of(blocks.begin(), blocks.end(), is_upright)) return;
  const std::vector<double> bottoms = bottoms_of(blocks, tolerance);
  for (Block& block : blocks) {
    if (block.role != Role::kMasonry) continue;
    const double bottom = bounds(block.outline).y0 - tolerance;
    block.course = static_cast<int>(std::lower_bound(bottoms.begin(), bottoms.end(), bottom) -
                                    bottoms.begin());
  }
}

bool names_pair(const ContactRule& rule, const std::string& a, const std::string& b) {
  if (rule.between.size() != 2) return false;
  return (rule.between[0] == a && rule.between[1] == b) ||
         (rule.between[0] == b && rule.between[1] == a);
}

// Refuses contact rules that match no block: their joints would have another law than the user expects.
void check_rules(const Shape& shape, const BlockNames& blocks, FaultList& faults) {
  std::vector<std::string> known{"ground"};
  for (const auto& [material, id] : blocks) known.push_back(material);
  for (std::size_t i = 0; i < shape.contact.size(); ++i) {
    const std::vector<std::string>& between = shape.contact[i].between;
    const std::string path = "contact." + std::to_string(i) + ".between";
    if (between.size() != 2)
      add_fault(faults, path, std::to_string(between.size()) + " names",
                "a contact rule names two block materials",
                "write e.g. between = [\"masonry\", \"ground\"]");
    for (const std::string& name : between)
      if (name != "ground" && !blocks.contains(name))
        add_fault(faults, path, "\"" + name + "\"", "is no material of a block",
                  name_advice(name, known));
    for (std::size_t k = 0; k < i && between.size() == 2; ++k)
      if (names_pair(shape.contact[k], between[0], between[1]))
        add_fault(faults, path, between[0] + ", " + between[1],
                  "has a rule already, contact." + std::to_string(k),
                  "keep one rule for each pair of materials");
  }
}

// Names that a block may have: tables of the model, and block materials of contact rules.
std::vector<std::string> names_of_materials(const Shape& shape) {
  std::vector<std::string> names{"masonry"};
  for (const auto& [name, density] : shape.material) names.push_back(name);
  for (const ContactRule& rule : shape.contact)
    names.insert(names.end(), rule.between.begin(), rule.between.end());
  return names;
}

}  // namespace

bool is_material(const Shape& shape, const std::string& path, const std::string& name,
                 FaultList& faults) {
  const std::vector<std::string> known = names_of_materials(shape);
  if (std::find(known.begin(), known.end(), name) != known.end()) return true;
  add_fault(faults, path, "\"" + name + "\"", "there is no such material",
            "add [material." + name + "] with its density; " + name_advice(name, known));
  return false;
}

void check_names(const Shape& shape, const BlockNames& blocks, FaultList& faults) {
  check_rules(shape, blocks, faults);
  const std::vector<std::string> known = names_of_materials(shape);
  for (const auto& [material, id] : blocks) {
    if (std::find(known.begin(), known.end(), material) != known.end()) continue;
    const std::string meant = nearest_name(material, known);
    if (!meant.empty())
      add_fault(faults, "wall.blocks." + id + ".material", "\"" + material + "\"",
                "there is no such material", "did you mean " + meant + "?");
  }
}

std::string outline_problem(const Polygon& corners) {
  if (!is_finite(corners)) return "a corner is missing or not a finite number";
  if (corners.size() < 3) return "an outline needs at least 3 different corners";
  if (corners.size() > kMostOutlineCorners)
    return "an outline has at most " + std::to_string(kMostOutlineCorners) + " corners";
  if (moments(corners).area == 0) return "the outline has no area";
  if (!is_simple(corners)) return "the outline crosses or touches itself";
  return "";
}

std::vector<Block> blocks_from_file(const Shape& shape, FaultList& faults) {
  if (shape.block.empty()) {
    add_fault(faults, "wall.blocks", shape.wall.blocks, "the blocks file holds no block",
              "list at least one polygon");
  }
  refuse_repeated_ids(shape, faults);
  check_densities(shape, faults);
  BlockNames names;
  for (const BlockSpec& block : shape.block) names.try_emplace(block.material, block.id);
  check_names(shape, names, faults);
  std::vector<Block> blocks;
  for (const BlockSpec& stated : shape.block) {
    Block block;
    block.id = stated.id;
    block.material = stated.material;
    block.thickness = shape.wall.thickness;
    block.role = role_of(stated);
    block.zone = stated.zone;
    refuse_zones(stated, faults);
    if (add_outline(stated, block, faults)) blocks.push_back(std::move(block));
  }
  number_courses(blocks);
  return blocks;
}

double density_in_file(const Shape& shape, const std::string& material) {
  const auto found = shape.material.find(material);
  const bool has_own = found != shape.material.end() && std::isfinite(found->second);
  return has_own ? found->second : shape.wall.unit.density;
}

std::string ruled_material(const Shape& shape, const std::string& a, const std::string& b,
                           const std::string& otherwise) {
  for (const ContactRule& rule : shape.contact) {
    if (names_pair(rule, a, b)) return rule.material;
  }
  return otherwise;
}

}  // namespace wythe::geometry
