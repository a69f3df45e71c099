// Ties, diaphragms and springs of the model file -> links between points of blocks (docs/theory/links.md).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/elementary.h"
#include "geometry/polygon.h"
#include "model/parts.h"
#include "model/shaking.h"
#include "model/space/space.h"
#include "model/space/space_places.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Role;

constexpr double kReach = 0.01;  // distance of a point from the wall [m]

// A point of the wall with its block; no block where the ground holds it.
struct End {
  BlockId block = kGroundBlock;
  Vec3 at;
};

// Ends of links in a wall in the plane.
class PlaneSite {
 public:
  PlaneSite(const ModelSpec&, const Assembly& assembly, const BlockMap& map, const Model& model)
      : assembly_(assembly), map_(map), model_(model) {}

  [[nodiscard]] static Vec3 in_wall(Vec3 v) { return v; }
  [[nodiscard]] static std::optional<Vec3> point_of(const PlaceSpec& at) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return std::nullopt;
    return Vec3{at.x, at.y, 0};
  }
  [[nodiscard]] static const char* example() { return "{ x = \"-0.5 m\", y = \"3.1 m\" }"; }
  [[nodiscard]] static bool is_foreign(const PlaceSpec& at) { return std::isfinite(at.z); }
  [[nodiscard]] static bool knows(Vec3 direction) { return direction.z == 0; }
  [[nodiscard]] static double distance(Vec3 a, Vec3 b) {
    return length(Vec2{b.x - a.x, b.y - a.y});
  }
  [[nodiscard]] Vec3 centroid(BlockId block) const {
    return {model_.centroid_x[block], model_.centroid_y[block], 0};
  }

  // The moving block whose box is nearest to a point; of equally near ones the one with the nearest centre; or the named
  // block. `below`: for a point between two courses take the lower block, on which a floor lies.
  [[nodiscard]] std::optional<std::size_t> body_at(Vec3 p, bool below) const {
    const std::size_t b = block_at({p.x, p.y}, below);
    return b == assembly_.blocks.size() ? std::nullopt : std::optional(b);
  }
  [[nodiscard]] std::optional<std::size_t> named(const PlaceSpec& at) const {
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (map_[b] != kGroundBlock && (at.beam ? block.role == Role::kBeam : block.id == at.block))
        return b;
    }
    return std::nullopt;
  }
  [[nodiscard]] BlockId block_of(std::size_t b) const { return map_[b]; }
  [[nodiscard]] std::string id_of(std::size_t b) const { return assembly_.blocks[b].id; }
  [[nodiscard]] static bool is_support(std::size_t) { return false; }

  // Points of a diaphragm.
  [[nodiscard]] std::vector<PlaceSpec> points_of(const DiaphragmSpec& d, const std::string& path,
                                                 FaultList& faults) const {
    double y = d.y;
    if (std::isfinite(d.y) == !d.storey.empty())
      faults.add({"", path, "", d.storey.empty() ? "has no level" : "has two levels",
                  "write the storey at whose top it lies, or its height y", 0});
    else if (!d.storey.empty())
      y = top_of_storey(assembly_, d.storey, path, faults);
    if (!d.z.empty())
      faults.add({"", path + ".z", "", "is for walls in space, and this one is in its plane",
                  "leave it out", 0});
    if (!std::is_sorted(d.x.begin(), d.x.end()))
      faults.add(
          {"", path + ".x", "", "is not in order", "write its points from left to right", 0});
    std::vector<PlaceSpec> points(d.x.size());
    for (std::size_t k = 0; k < points.size(); ++k) points[k].x = d.x[k], points[k].y = y;
    return points;
  }

 private:
  [[nodiscard]] std::size_t block_at(Vec2 p, bool below) const {
    std::size_t best = assembly_.blocks.size();
    double least = kReach, nearest = std::numeric_limits<double>::infinity();
    if (below) p.y -= kReach / 2;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock) continue;
      const geometry::Rect box = geometry::bounds(assembly_.blocks[b].outline);
      const double away = elementary::hypot(std::max({0.0, box.x0 - p.x, p.x - box.x1}),
                                            std::max({0.0, box.y0 - p.y, p.y - box.y1}));
      const double middle =
          elementary::hypot(0.5 * (box.x0 + box.x1) - p.x, 0.5 * (box.y0 + box.y1) - p.y);
      if (away < least - 1e-9 || (away <= least + 1e-9 && middle < nearest - 1e-9)) {
        least = std::min(least, away);
        nearest = middle;
        best = b;
      }
    }
    return best;
  }

  const Assembly& assembly_;
  const BlockMap& map_;
  const Model& model_;
};

// Ends of links in space; a body of the assembly is a support where its number is not below n_block.
class SpaceSite {
 public:
  SpaceSite(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
            const std::vector<BlockId>& id, const Model& model)
      : assembly_(assembly), id_(id), model_(model), places_(spec, assembly) {}

  [[nodiscard]] Vec3 in_wall(Vec3 v) const { return places_.in_wall(v); }
  [[nodiscard]] std::optional<Vec3> point_of(const PlaceSpec& at) const {
    return places_.point_of(at);
  }
  [[nodiscard]] static const char* example() {
    return "{ x = \"-0.5 m\", y = \"3.1 m\", z = \"0 m\" }";
  }
  [[nodiscard]] static bool is_foreign(const PlaceSpec& at) {
    return std::isfinite(at.depth) || at.beam;
  }
  [[nodiscard]] static bool knows(Vec3) { return true; }
  [[nodiscard]] static double distance(Vec3 a, Vec3 b) { return length(b - a); }
  [[nodiscard]] Vec3 centroid(BlockId block) const { return model_.space.centroid[block]; }
  [[nodiscard]] std::optional<std::size_t> body_at(Vec3 p, bool below) const {
    if (below) p.y -= kReach / 2;
    const std::optional<std::size_t> free = places_.body_at(p, false);
    return free ? free : places_.body_at(p, true);
  }
  [[nodiscard]] std::optional<std::size_t> named(const PlaceSpec& at) const {
    for (std::size_t k = 0; k < assembly_.body.size(); ++k)
      if (assembly_.body[k].id == at.block) return k;
    return std::nullopt;
  }
  [[nodiscard]] BlockId block_of(std::size_t k) const { return id_[k]; }
  [[nodiscard]] std::string id_of(std::size_t k) const { return assembly_.body[k].id; }
  [[nodiscard]] bool is_support(std::size_t k) const { return assembly_.body[k].fixed; }

  [[nodiscard]] std::vector<PlaceSpec> points_of(const DiaphragmSpec& d, const std::string& path,
                                                 FaultList& faults) const {
    const double y = level_of(d, path, faults);
    if (d.z.size() != d.x.size())
      faults.add({"", path + ".z", fmt::format("{} numbers", d.z.size()),
                  fmt::format("must be as many as x, {}", d.x.size()),
                  "write the third coordinate of each point", 0});
    std::vector<PlaceSpec> points(std::min(d.x.size(), d.z.size()));
    for (std::size_t k = 0; k < points.size(); ++k) {  // y is the height, z the other level axis
      const bool up = places_.z_up();
      points[k].x = d.x[k], points[k].y = up ? d.z[k] : y, points[k].z = up ? y : d.z[k];
    }
    return points;
  }

 private:
  // Height of the named storey's top, or y [m].
  [[nodiscard]] double level_of(const DiaphragmSpec& d, const std::string& path,
                                FaultList& faults) const {
    if (std::isfinite(d.y) == !d.storey.empty())
      faults.add({"", path, "", d.storey.empty() ? "has no level" : "has two levels",
                  "write the storey at whose top it lies, or its height y", 0});
    if (d.storey.empty()) return d.y;
    const std::vector<std::string>& names = model_.anatomy.storey_name;
    const auto found = std::find(names.begin(), names.end(), d.storey);
    if (found != names.end()) return model_.anatomy.storey_top[found - names.begin()];
    faults.add({"", path + ".storey", d.storey, "is not among the storeys",
                "write [[storey]] tables with names, or a height y", 0});
    return kUnset;
  }

  const geometry::SpaceAssembly& assembly_;
  const std::vector<BlockId>& id_;
  const Model& model_;
  SpacePlaces places_;
};

template <class Site>
class LinkCompiler {
 public:
  template <class Built, class Numbers>
  LinkCompiler(const ModelSpec& spec, const Built& assembly, const Numbers& map, Model& model,
               FaultList& faults)
      : spec_(spec), site_(spec, assembly, map, model), model_(model), faults_(faults) {}

  void run() {
    for (std::size_t k = 0; k < spec_.tie.size(); ++k) {
      path_ = fmt::format("tie.{}", k);
      tie(spec_.tie[k], name_of(spec_.tie[k].name, "tie", k));
    }
    for (std::size_t k = 0; k < spec_.diaphragm.size(); ++k) {
      path_ = fmt::format("diaphragm.{}", k);
      diaphragm(spec_.diaphragm[k], name_of(spec_.diaphragm[k].name, "diaphragm", k));
    }
    for (std::size_t k = 0; k < spec_.spring.size(); ++k) {
      path_ = fmt::format("spring.{}", k);
      spring(spec_.spring[k], name_of(spec_.spring[k].name, "spring", k));
    }
    find_stage();
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  static std::string name_of(const std::string& given, const char* kind, std::size_t k) {
    return given.empty() ? fmt::format("{} {}", kind, k + 1) : given;
  }

  // Whether a number is present and positive; adds a fault otherwise.
  bool need(const char* key, double value, const char* example) {
    if (value > 0) return true;
    fault(key, std::isnan(value) ? "" : fmt::format("{:g}", value), "is missing",
          fmt::format("write {}", example));
    return false;
  }

  void tie(const TieSpec& t, const std::string& name) {
    const std::size_t before = faults_.all().size();
    const End from = find(".from", t.from);
    const End to = t.anchored ? anchor(t.to) : find(".to", t.to);
    need(".area", t.area, "area = \"491 mm^2\"");
    need(".youngs_modulus", t.youngs_modulus, "youngs_modulus = \"200 GPa\"");
    if (faults_.all().size() > before) return;
    const double long_ = Site::distance(to.at, from.at);
    if (from.block == to.block)
      return fault("", name_in(from.block), "has both ends on one block, which holds them apart",
                   "move one end to another block, or to an anchor: anchored = true");
    if (long_ < kReach)
      return fault("", fmt::format("{:g} m", long_), "is too short to be a bar",
                   "write two places apart from each other");
    const double strength = std::min(t.yield_strength * t.area, t.anchor_strength);
    const double prestress = t.prestress * t.area;
    if (prestress >= strength)
      return fault(
          ".prestress", fmt::format("{:g} MPa", 1e-6 * t.prestress),
          fmt::format("times its area is {:.4g} kN, not below what the tie bears, {:.4g} kN",
                      1e-3 * prestress, 1e-3 * strength),
          "lower it, or write a larger area or strength");
    add(name, LinkKind::kTie, to, from, true, t.youngs_modulus * t.area / long_);
    model_.links.tension.back() = strength;
    model_.links.compression.back() = 0;
    model_.links.prestress.back() = prestress;
  }

  void diaphragm(const DiaphragmSpec& d, const std::string& name) {
    const std::size_t before = faults_.all().size();
    const std::vector<PlaceSpec> points = site_.points_of(d, path_, faults_);
    if (d.x.size() < 2)
      fault(".x", fmt::format("{} points", d.x.size()), "has nothing to connect",
            "write two points or more, e.g. x = [\"0.2 m\", \"4.8 m\"]");
    const bool elastic = d.kind == DiaphragmKind::kElastic;
    if (elastic) need(".stiffness", d.stiffness, "stiffness = \"300 MN\", its E A");
    if (!elastic && !std::isnan(d.stiffness))
      fault(".stiffness", "",
            "has no place in a rigid diaphragm, which is as stiff as the step allows",
            "leave it out, or write kind = \"elastic\"");
    if (faults_.all().size() > before) return;
    std::vector<End> ends;
    for (std::size_t k = 0; k < points.size(); ++k)
      ends.push_back(find(fmt::format(".x.{}", k), points[k], true));
    if (faults_.all().size() > before) return;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double long_ = Site::distance(ends[k - 1].at, ends[k].at);
      if (ends[k].block == ends[k - 1].block || long_ < kReach)
        return fault(fmt::format(".x.{}", k), name_in(ends[k].block),
                     "lies on the block of the point before it", "write points further apart");
      const std::string part = ends.size() == 2 ? name : fmt::format("{} {}", name, k);
      add(part, LinkKind::kDiaphragm, ends[k - 1], ends[k], true,
          elastic ? d.stiffness / long_ : kUnset);  // rigid ones: set by bound_step
    }
  }

  void spring(const SpringSpec& s, const std::string& name) {
    const std::size_t before = faults_.all().size();
    const End at = find(".at", s.at);
    need(".stiffness", s.stiffness, "stiffness = \"20 kN/mm\"");
    if (faults_.all().size() > before) return;
    // the neighbour stands in `direction`: motion towards it compresses the spring
    // from its neighbour: motion towards it compresses the spring
    const Vec3 from = site_.in_wall(Vec3{} - vector_of(s.direction));
    if (!site_.knows(from))
      return fault(".direction", "", "is out of the wall's plane, in which the model is",
                   "write +x, -x, +y or -y");
    add(name, LinkKind::kSpring, {}, at, false, s.stiffness);
    model_.links.span_x.back() = from.x;
    model_.links.span_y.back() = from.y;
    model_.links.span_z.back() = from.z;
    model_.links.tension.back() = s.pushes_only ? 0 : s.strength;
    model_.links.compression.back() = s.strength;
  }

  void add(const std::string& name, LinkKind kind, const End& a, const End& b, bool follows,
           double stiffness) {
    Links& l = model_.links;
    if (std::find(l.name.begin(), l.name.end(), name) != l.name.end())
      return fault(".name", name, "is the name of another one", "give each a name of its own");
    const auto arm = [&](const End& end) {
      return end.block == kGroundBlock ? Vec3{} : end.at - site_.centroid(end.block);
    };
    add_link(l, {name, kind, a.block, b.block, arm(a), arm(b), b.at - a.at, follows, stiffness});
  }

  // A fixed point, on the wall or off it.
  End anchor(const PlaceSpec& at) {
    const std::optional<Vec3> point = site_.point_of(at);
    if (!point || site_.is_foreign(at))
      fault(".to", at.block, "is no point, and an anchor needs one",
            fmt::format("write to = {}, or leave anchored out", site_.example()));
    return {kGroundBlock, point.value_or(Vec3{})};
  }

  [[nodiscard]] std::string name_in(BlockId block) const { return model_.anatomy.block_id[block]; }

  // The block at a point, or the centre of a named block.
  End find(const std::string& key, const PlaceSpec& at, bool below = false) {
    const std::optional<Vec3> point = site_.point_of(at);
    const bool more = std::isfinite(at.width) || std::isfinite(at.height) || at.courses != 1 ||
                      !at.role.empty() || site_.is_foreign(at);
    if (std::isfinite(at.z) && !site_.knows(Vec3{0, 0, 1})) {
      fault(key + ".z", fmt::format("{:g} m", at.z),
            "has no meaning here: the wall lies in a plane", "leave z out");
      return {};
    }
    if (more || int{point.has_value()} + int{!at.block.empty()} + int{at.beam} != 1) {
      fault(key, "", "must be one point, one block or the beam",
            fmt::format("write e.g. {} = {}", key.substr(1), site_.example()));
      return {};
    }
    const std::optional<std::size_t> b = point ? site_.body_at(*point, below) : site_.named(at);
    if (!b) {
      const auto place = [&] {
        return std::isfinite(at.z) ? fmt::format("({:g}, {:g}, {:g}) m", at.x, at.y, at.z)
                                   : fmt::format("({:g}, {:g}) m", at.x, at.y);
      };
      fault(key, point ? place() : at.block,
            point ? "lies off the wall: no moving block is there" : "names no moving block",
            key == ".to"
                ? "move it onto the masonry, or write anchored = true for a point that stays"
                : "move it onto the masonry");
      return {};
    }
    if (site_.is_support(*b)) {
      fault(key, site_.id_of(*b), "is a support, which holds links by itself",
            "swap the ends, and write anchored = true for the one that stays");
      return {};
    }
    const BlockId block = site_.block_of(*b);
    if (is_solid(block)) {
      fault(key, site_.id_of(*b), "lies on a block of zones; links hold rigid blocks",
            "move it beside, or leave the block's zones out");
      return {};
    }
    return {block, point ? *point : site_.centroid(block)};
  }

  // Finds the stage that applies prestress: the first one with loads.
  void find_stage() {
    const auto drawn = [](double force) { return force > 0; };
    const std::vector<double>& prestress = model_.links.prestress;
    if (std::none_of(prestress.begin(), prestress.end(), drawn)) return;
    for (std::size_t k = 0; k < spec_.stage.size(); ++k) {
      const StageKind kind = spec_.stage[k].kind();
      if (kind != StageKind::kGravity && kind != StageKind::kLoad) continue;
      model_.links.set_by = static_cast<int>(k);
      return;
    }
    path_ = "tie";
    fault("", "", "no stage draws its prestress in", "add a gravity stage, or leave prestress out");
  }

  const ModelSpec& spec_;
  Site site_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
};

}  // namespace

void add_link(Links& l, const NewLink& link) {
  l.a.push_back(link.a);
  l.b.push_back(link.b);
  l.arm_a_x.push_back(link.arm_a.x);
  l.arm_a_y.push_back(link.arm_a.y);
  l.arm_a_z.push_back(link.arm_a.z);
  l.arm_b_x.push_back(link.arm_b.x);
  l.arm_b_y.push_back(link.arm_b.y);
  l.arm_b_z.push_back(link.arm_b.z);
  l.span_x.push_back(link.span.x);
  l.span_y.push_back(link.span.y);
  l.span_z.push_back(link.span.z);
  l.follows.push_back(link.follows ? 1 : 0);
  l.stiffness.push_back(link.stiffness);
  l.tension.push_back(link.tension);
  l.compression.push_back(link.compression);
  l.prestress.push_back(0);
  l.jack.push_back(link.jack);
  l.name.push_back(link.name);
  l.kind.push_back(link.kind);
  ++l.n;
}

void compile_links(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                   Model& model, FaultList& faults) {
  LinkCompiler<PlaneSite>(spec, assembly, map, model, faults).run();
}

void compile_links(const ModelSpec& spec, const geometry::SpaceAssembly& assembly,
                   const std::vector<BlockId>& id, Model& model, FaultList& faults) {
  LinkCompiler<SpaceSite>(spec, assembly, id, model, faults).run();
}

}  // namespace wythe
