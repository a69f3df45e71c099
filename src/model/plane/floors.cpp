// Floors and roofs: dead loads on the blocks of a course, and the inertia that belongs to them.
//
//      q q q q q q q q q q          each block carries the load on its upper edge, at the middle of the
//    +----+----+----+----+----+     loaded part. Where no upper edge has this level (an opening,
//    |    |    |    |    |    |     a higher lintel) nothing would carry the floor: a fault
//
// Reads the assembly; compile() calls it before the stages, which apply the loads.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "model/parts.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Role;

constexpr double kReachOfLevel = 0.01;  // distance of the stated level from the bed joint [m]
constexpr double kFewMicrons = 5e-6;    // a gap due to rounded input [m]

// A part of a block's upper side.
struct Edge {
  std::size_t block;
  double x0, x1, y;
};

// Share of the floor that one block carries, at (x, y).
struct Part {
  std::size_t block;
  double x, y, share;
};

class FloorCompiler {
 public:
  FloorCompiler(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map, Model& model,
                FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {
    find_edges();
  }

  std::vector<PointLoad> run() {
    for (std::size_t k = 0; k < spec_.floor.size(); ++k) {
      path_ = fmt::format("floor.{}", k);
      floor_ = &spec_.floor[k];
      if (check_numbers()) lay();
    }
    return std::move(loads_);
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  // Finds upper edges: outlines are anticlockwise, so an upper edge runs to the left.
  void find_edges() {
    double top = -std::numeric_limits<double>::infinity();
    base_ = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock) continue;
      for (const Vec2& v : assembly_.blocks[b].outline)
        base_ = std::min(base_, v.y), top = std::max(top, v.y);
    }
    tolerance_ = 1e-6 * (top - base_);
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock || assembly_.blocks[b].role == Role::kPlate) continue;
      const auto& outline = assembly_.blocks[b].outline;
      for (std::size_t v = 0; v < outline.size(); ++v) {
        const Vec2 p = outline[v], n = outline[(v + 1) % outline.size()];
        if (std::fabs(p.y - n.y) <= tolerance_ && p.x - n.x > tolerance_)
          edges_.push_back({b, n.x, p.x, 0.5 * (p.y + n.y)});
      }
    }
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.x0 < b.x0; });
  }

  // Checks that concern several keys at once.
  bool check_numbers() {
    const FloorSpec& f = *floor_;
    const std::size_t before = faults_.all().size();
    const auto is_stated = [](const PlaceSpec& p) {
      return std::isfinite(p.x) || std::isfinite(p.y) || std::isfinite(p.z) || !p.block.empty();
    };
    if (is_stated(f.from) || is_stated(f.to))
      fault(is_stated(f.from) ? ".from" : ".to", "",
            "is for walls in space, and this one is in its plane",
            "write y or storey, x and width");
    if (std::isfinite(f.y) == !f.storey.empty())
      fault("", "", f.storey.empty() ? "has no level" : "has two levels",
            "write the storey on whose top it lies, or the height y of its bearing");
    const bool line = f.joists.empty();
    if (!(f.load > 0) && f.thrust == 0 && !(f.mass > 0))
      fault("", "", "does nothing to the wall", "write e.g. load = \"12 kN/m\"");
    if (std::isfinite(f.bearing) && !line)
      fault(".bearing", "", "says nothing of joists, whose width is not known",
            "leave it out, or leave joists out for a line load");
    return faults_.all().size() == before;
  }

  // Height of the named storey's top, or y, above the wall's base [m].
  [[nodiscard]] double stated_level() {
    if (floor_->storey.empty()) return floor_->y;
    return top_of_storey(assembly_, floor_->storey, path_, faults_) - base_;
  }

  // Height of the bed joint at the stated level [m].
  [[nodiscard]] double find_level() {
    const double stated = stated_level();
    if (std::isnan(stated)) return kUnset;
    double below = kUnset, above = kUnset, nearest = kUnset;
    for (const Edge& e : edges_) {
      const double y = e.y - base_;
      if (!(std::fabs(nearest - stated) <= std::fabs(y - stated))) nearest = y;
      if (y <= stated && !(below >= y)) below = y;
      if (y >= stated && !(above <= y)) above = y;
    }
    if (std::fabs(nearest - stated) <= kReachOfLevel) return nearest + base_;
    std::string cure = "write ";
    if (std::isfinite(below)) cure += fmt::format("y = \"{:.3f} m\"", below);
    if (std::isfinite(below) && std::isfinite(above)) cure += " or ";
    if (std::isfinite(above)) cure += fmt::format("y = \"{:.3f} m\"", above);
    const bool by_storey = !floor_->storey.empty();
    fault(by_storey ? ".storey" : ".y", fmt::format("{:g} m", stated),
          "no block ends at this height, so there is no bed joint to lie on", cure);
    return kUnset;
  }

  void lay() {
    const double level = find_level();
    if (std::isnan(level)) return;
    std::vector<Edge> at;
    for (const Edge& e : edges_)
      if (std::fabs(e.y - level) <= 2 * tolerance_) at.push_back(e);
    double left = at.front().x0, right = at.front().x1, zero = assembly_left();
    for (const Edge& e : at) left = std::min(left, e.x0), right = std::max(right, e.x1);
    const double x0 = std::isfinite(floor_->x) ? zero + floor_->x : left;
    const double x1 = std::isfinite(floor_->width) ? x0 + floor_->width : right;
    if (x0 < left - kReachOfLevel || x1 > right + kReachOfLevel || !(x1 - x0 > tolerance_))
      return fault(
          std::isfinite(floor_->x) ? ".x" : ".width", "",
          fmt::format("the floor goes from {:.3f} to {:.3f} m, the wall at this height from "
                      "{:.3f} to {:.3f} m",
                      x0 - zero, x1 - zero, left - zero, right - zero),
          "keep x and x + width within the wall");
    const double from = std::max(x0, left), to = std::min(x1, right);
    const std::vector<Part> parts =
        floor_->joists.empty() ? line(at, from, to, zero) : joists(at, from, to, zero);
    for (const Part& part : parts)
      if (is_solid(map_[part.block]))
        return fault("", assembly_.blocks[part.block].id,
                     "would lie on a block of zones; loads act on rigid blocks",
                     "end the floor beside it, or leave the block's zones out");
    for (const Part& part : parts)
      if (const int k = assembly_.blocks[part.block].cut_from; k >= 0)
        return fault_of_cut(spec_.wall.opening[k], part.x - zero);
    for (const Part& part : parts)
      if (const double thickness = assembly_.blocks[part.block].thickness;
          floor_->bearing > thickness)
        return fault(".bearing", fmt::format("{:g} m", floor_->bearing),
                     fmt::format("is deeper than the wall is thick there, {:g} m", thickness),
                     "write how much of the thickness the floor lies on");
    if (!parts.empty()) put(parts, level, from, to, zero);
  }

  // Refuses a floor that hangs in the air once the opening is cut.
  void fault_of_cut(const OpeningSpec& opening, double x) {
    fault(
        "", "",
        fmt::format("lies at x = {:.3f} m on masonry that stage \"{}\" cuts out{}", x, opening.cut,
                    opening.name.empty() ? "" : " for opening \"" + opening.name + "\""),
        "make the opening lower, so that a course over its lintel or frame carries the floor, or "
        "end the floor beside it (x, width)");
  }

  // Left end of the wall, the zero of x [m].
  [[nodiscard]] double assembly_left() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (map_[b] != kGroundBlock)
        for (const Vec2& v : assembly_.blocks[b].outline) least = std::min(least, v.x);
    return least;
  }

  // Shares of a line load; empty with a fault where a part of the line lies on nothing.
  std::vector<Part> line(const std::vector<Edge>& at, double from, double to, double zero) {
    std::vector<Part> parts;
    double reached = from;
    const auto gap = [&](double end) {
      if (end - reached <= kFewMicrons + tolerance_) return false;
      fault("", "",
            fmt::format("lies on nothing between {:.3f} and {:.3f} m: an opening is there, or a "
                        "block that reaches through this height",
                        reached - zero, end - zero),
            "make it two floors that end beside the gap (x, width), or write joists");
      return true;
    };
    for (const Edge& e : at) {
      const double a = std::max(e.x0, from), b = std::min(e.x1, to);
      if (b - a <= tolerance_) continue;
      if (gap(a)) return {};
      parts.push_back({e.block, 0.5 * (a + b), e.y, (b - a) / (to - from)});
      reached = std::max(reached, b);
    }
    if (gap(to)) return {};
    return parts;
  }

  // Refuses one x twice in a list: that place would get two shares of the load.
  void refuse_joists_at_one_place() {
    constexpr double kOnePlace = 1e-3;  // [m]
    const std::vector<double>& joists = floor_->joists;
    for (std::size_t k = 0; k < joists.size(); ++k)
      for (std::size_t i = 0; i < k; ++i)
        if (std::fabs(joists[k] - joists[i]) < kOnePlace) {
          fault(fmt::format(".joists.{}", k), fmt::format("{:g} m", joists[k]),
                fmt::format("joist {} lies there already", i),
                "list each joist once; one that carries more is a [[floor]] of its own");
          break;
        }
  }

  // Shares of joists; a joist over a head joint lies on both blocks.
  std::vector<Part> joists(const std::vector<Edge>& at, double from, double to, double zero) {
    std::vector<Part> parts;
    const std::size_t before = faults_.all().size();
    refuse_joists_at_one_place();
    const auto n = static_cast<double>(floor_->joists.size());
    for (std::size_t k = 0; k < floor_->joists.size(); ++k) {
      const double x = zero + floor_->joists[k];
      std::vector<Part> under;
      for (const Edge& e : at)
        if (x >= e.x0 - kFewMicrons && x <= e.x1 + kFewMicrons)
          under.push_back({e.block, std::clamp(x, e.x0, e.x1), e.y, 0});
      if (under.empty() || x < from - kFewMicrons || x > to + kFewMicrons)
        fault(fmt::format(".joists.{}", k), fmt::format("{:g} m", floor_->joists[k]),
              under.empty() ? "lies on nothing: no block ends at this height there"
                            : "lies beside the floor",
              fmt::format("write an x between {:.3f} and {:.3f} m, on masonry", from - zero,
                          to - zero));
      for (Part& part : under) {
        part.share = 1 / (n * static_cast<double>(under.size()));
        parts.push_back(part);
      }
    }
    if (faults_.all().size() > before) parts.clear();
    return parts;
  }

  void put(const std::vector<Part>& parts, double level, double from, double to, double zero) {
    const double length = to - from, load = floor_->load > 0 ? floor_->load * length : 0.0;
    double inertia = 0;
    for (const Part& part : parts) {
      const BlockId block = map_[part.block];
      if (load > 0 || floor_->thrust != 0)
        loads_.push_back({block, part.x - model_.centroid_x[block],
                          part.y - model_.centroid_y[block], part.share * floor_->thrust,
                          -part.share * load});
      model_.mass[block] += part.share * floor_->mass * length;
      inertia += part.share * floor_->mass * length;
    }
    const std::string name =
        floor_->name.empty() ? path_.substr(path_.find('.') + 1) : floor_->name;
    auto& notes = model_.anatomy.notes;
    notes.push_back({"floor.lies",
                     {{"floor", name},
                      {"y_m", level - base_},
                      {"from_m", from - zero},
                      {"to_m", to - zero},
                      {"load_kN", 1e-3 * load}}});
    if (inertia > 0) notes.push_back({"floor.inertia", {{"floor", name}, {"mass_kg", inertia}}});
    if (std::isfinite(floor_->bearing)) note_bearing(name);
  }

  // Notes the mean pressure of the bearing: the plane has no eccentricity across the wall.
  void note_bearing(const std::string& name) {
    const double pressure = floor_->load / floor_->bearing;
    double strength = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < model_.anatomy.joint_kind.size(); ++j)
      if (model_.anatomy.joint_kind[j] == JointKind::kBed)
        strength =
            std::min(strength, model_.materials[model_.joint_material[j]].compressive_strength);
    model_.anatomy.notes.push_back(
        {pressure > strength    ? "floor.bearing_crushes"
         : std::isinf(strength) ? "floor.bearing_only"
                                : "floor.bearing",
         {{"floor", name}, {"pressure_MPa", 1e-6 * pressure}, {"strength_MPa", 1e-6 * strength}}});
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  const FloorSpec* floor_ = nullptr;
  std::string path_;
  std::vector<Edge> edges_;
  double base_ = 0, tolerance_ = 0;
  std::vector<PointLoad> loads_;
};

}  // namespace

double top_of_storey(const Assembly& assembly, const std::string& name, const std::string& path,
                     FaultList& faults) {
  std::vector<std::string> names;
  for (const geometry::StoreyBand& storey : assembly.storeys) {
    if (storey.name == name) return storey.top;
    if (!storey.name.empty()) names.push_back(storey.name);
  }
  faults.add({"", path + ".storey", name, "is not among the storeys",
              names.empty() ? "write [[storey]] tables with names, or a height y"
                            : "write one of: " + joined(names, ", "),
              0});
  return kUnset;
}

std::vector<PointLoad> compile_floors(const ModelSpec& spec, const Assembly& assembly,
                                      const BlockMap& map, Model& model, FaultList& faults) {
  if (spec.floor.empty()) return {};
  return FloorCompiler(spec, assembly, map, model, faults).run();
}

}  // namespace wythe
