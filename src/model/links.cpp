// Ties, diaphragms and springs in the user's words -> links between points of blocks (docs/theory/links.md).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.h"
#include "model/parts.h"

namespace wythe {
namespace {

using geometry::Assembly;
using geometry::Role;

constexpr double kReach = 0.01;  // how far a point may lie off the wall [m]

// A point of the wall: its block, none where the ground holds it.
struct End {
  BlockId block = kGroundBlock;
  Vec2 at;
};

class LinkCompiler {
 public:
  LinkCompiler(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map, Model& model,
               FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {}

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

  // Whether a number is there and above 0.
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
    const double long_ = length(from.at - to.at);
    if (from.block == to.block)
      return fault("", name_in(from.block), "has both ends on one block, which holds them apart",
                   "move one end to another block, or to an anchor: anchored = true");
    if (long_ < kReach)
      return fault("", fmt::format("{:g} m", long_), "is too short to be a bar",
                   "write two places apart from each other");
    const double strength = std::min(t.yield_strength * t.area, t.anchor_strength);
    const double prestress = t.prestress * t.area;
    if (prestress >= strength)
      return fault(".prestress", fmt::format("{:g} N", prestress),
                   fmt::format("is not below what the tie bears, {:g} N", strength),
                   "lower it, or write a larger area or strength");
    add(name, LinkKind::kTie, to, from, true, t.youngs_modulus * t.area / long_);
    model_.links.tension.back() = strength;
    model_.links.compression.back() = 0;
    model_.links.prestress.back() = prestress;
  }

  void diaphragm(const DiaphragmSpec& d, const std::string& name) {
    const std::size_t before = faults_.all().size();
    double y = d.y;
    if (std::isfinite(d.y) == !d.storey.empty())
      fault("", "", d.storey.empty() ? "has no level" : "has two levels",
            "write the storey at whose top it lies, or its height y");
    else if (!d.storey.empty())
      y = top_of_storey(assembly_, d.storey, path_, faults_);
    if (d.x.size() < 2)
      fault(".x", fmt::format("{} points", d.x.size()), "has nothing to connect",
            "write two points or more, e.g. x = [\"0.2 m\", \"4.8 m\"]");
    if (!std::is_sorted(d.x.begin(), d.x.end()))
      fault(".x", "", "is not in order", "write its points from left to right");
    const bool elastic = d.kind == DiaphragmKind::kElastic;
    if (elastic) need(".stiffness", d.stiffness, "stiffness = \"300 MN\", its E A");
    if (!elastic && !std::isnan(d.stiffness))
      fault(".stiffness", "",
            "has no place in a rigid diaphragm, which is as stiff as the step allows",
            "leave it out, or write kind = \"elastic\"");
    if (faults_.all().size() > before) return;
    std::vector<End> ends;
    for (std::size_t k = 0; k < d.x.size(); ++k) {
      PlaceSpec at;
      at.x = d.x[k], at.y = y;
      ends.push_back(find(fmt::format(".x.{}", k), at, true));
    }
    if (faults_.all().size() > before) return;
    for (std::size_t k = 1; k < ends.size(); ++k) {
      const double long_ = length(ends[k].at - ends[k - 1].at);
      if (ends[k].block == ends[k - 1].block || long_ < kReach)
        return fault(fmt::format(".x.{}", k), name_in(ends[k].block),
                     "lies on the block of the point before it", "write points further apart");
      const std::string part = ends.size() == 2 ? name : fmt::format("{} {}", name, k);
      add(part, LinkKind::kDiaphragm, ends[k - 1], ends[k], true,
          elastic ? d.stiffness / long_ : kUnset);  // of a rigid one: bound_step
    }
  }

  void spring(const SpringSpec& s, const std::string& name) {
    const std::size_t before = faults_.all().size();
    const End at = find(".at", s.at);
    need(".stiffness", s.stiffness, "stiffness = \"20 kN/mm\"");
    if (faults_.all().size() > before) return;
    // the neighbour stands in `direction`: what moves there is pressed
    const double x = s.direction == Direction::kPlusX    ? -1
                     : s.direction == Direction::kMinusX ? 1
                                                         : 0;
    const double y = s.direction == Direction::kPlusY    ? -1
                     : s.direction == Direction::kMinusY ? 1
                                                         : 0;
    add(name, LinkKind::kSpring, {}, at, false, s.stiffness);
    model_.links.span_x.back() = x;
    model_.links.span_y.back() = y;
    model_.links.tension.back() = s.pushes_only ? 0 : s.strength;
    model_.links.compression.back() = s.strength;
  }

  void add(const std::string& name, LinkKind kind, const End& a, const End& b, bool follows,
           double stiffness) {
    Links& l = model_.links;
    if (std::find(l.name.begin(), l.name.end(), name) != l.name.end())
      return fault(".name", name, "is the name of another one", "give each a name of its own");
    const auto arm = [&](const End& end, double Vec2::*axis, const std::vector<double>& centroid) {
      return end.block == kGroundBlock
                 ? 0.0
                 : end.at.*axis - centroid[static_cast<std::size_t>(end.block)];
    };
    l.a.push_back(a.block);
    l.b.push_back(b.block);
    l.arm_a_x.push_back(arm(a, &Vec2::x, model_.centroid_x));
    l.arm_a_y.push_back(arm(a, &Vec2::y, model_.centroid_y));
    l.arm_b_x.push_back(arm(b, &Vec2::x, model_.centroid_x));
    l.arm_b_y.push_back(arm(b, &Vec2::y, model_.centroid_y));
    l.span_x.push_back(b.at.x - a.at.x);
    l.span_y.push_back(b.at.y - a.at.y);
    l.follows.push_back(follows ? 1 : 0);
    l.stiffness.push_back(stiffness);
    l.tension.push_back(kUnlimited);
    l.compression.push_back(kUnlimited);
    l.prestress.push_back(0);
    l.name.push_back(name);
    l.kind.push_back(kind);
    ++l.n;
  }

  // A point that does not move, on the wall or off it.
  End anchor(const PlaceSpec& at) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y))
      fault(".to", at.block, "is no point, and an anchor needs one",
            "write to = { x = \"-0.5 m\", y = \"3.1 m\" }, or leave anchored out");
    return {kGroundBlock, {at.x, at.y}};
  }

  [[nodiscard]] std::string name_in(BlockId block) const {
    return model_.anatomy.block_id[static_cast<std::size_t>(block)];
  }

  // The block at a point, or the middle of a named block. `below`: of a point between two courses the
  // lower block, which a floor lies on.
  End find(const std::string& key, const PlaceSpec& at, bool below = false) {
    const bool point = std::isfinite(at.x) && std::isfinite(at.y);
    const bool more = std::isfinite(at.width) || std::isfinite(at.height) || at.courses != 1;
    if (more || int{point} + int{!at.block.empty()} + int{at.beam} != 1) {
      fault(key, "", "must be one point, one block or the beam",
            fmt::format("write e.g. {} = {{ x = \"0 m\", y = \"3.1 m\" }}", key.substr(1)));
      return {};
    }
    const std::size_t b = point ? block_at({at.x, at.y}, below) : named(at);
    if (b == assembly_.blocks.size()) {
      fault(key, point ? fmt::format("({:g}, {:g}) m", at.x, at.y) : at.block,
            point ? "lies off the wall: no moving block is there" : "names no moving block",
            key == ".to"
                ? "move it onto the masonry, or write anchored = true for a point that stays"
                : "move it onto the masonry");
      return {};
    }
    if (is_solid(map_[b])) {
      fault(key, assembly_.blocks[b].id, "lies on a block of zones; links hold rigid blocks",
            "move it beside, or leave the block's zones out");
      return {};
    }
    const auto i = static_cast<std::size_t>(map_[b]);
    return {map_[b], point ? Vec2{at.x, at.y} : Vec2{model_.centroid_x[i], model_.centroid_y[i]}};
  }

  [[nodiscard]] std::size_t named(const PlaceSpec& at) const {
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      const geometry::Block& block = assembly_.blocks[b];
      if (map_[b] != kGroundBlock && (at.beam ? block.role == Role::kBeam : block.id == at.block))
        return b;
    }
    return assembly_.blocks.size();
  }

  // The moving block whose box is nearest, of those at the same distance the one with the nearest middle.
  [[nodiscard]] std::size_t block_at(Vec2 p, bool below) const {
    std::size_t best = assembly_.blocks.size();
    double least = kReach, nearest = std::numeric_limits<double>::infinity();
    if (below) p.y -= kReach / 2;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b) {
      if (map_[b] == kGroundBlock) continue;
      const geometry::Rect box = geometry::bounds(assembly_.blocks[b].outline);
      const double away = std::hypot(std::max({0.0, box.x0 - p.x, p.x - box.x1}),
                                     std::max({0.0, box.y0 - p.y, p.y - box.y1}));
      const double middle =
          std::hypot(0.5 * (box.x0 + box.x1) - p.x, 0.5 * (box.y0 + box.y1) - p.y);
      if (away < least - 1e-9 || (away <= least + 1e-9 && middle < nearest - 1e-9)) {
        least = std::min(least, away);
        nearest = middle;
        best = b;
      }
    }
    return best;
  }

  // Prestress comes with the first stage of loads.
  void find_stage() {
    const auto drawn = [](double force) { return force > 0; };
    const std::vector<double>& prestress = model_.links.prestress;
    if (std::none_of(prestress.begin(), prestress.end(), drawn)) return;
    for (std::size_t k = 0; k < spec_.stage.size(); ++k) {
      const StageKind kind = spec_.stage[k].kind;
      if (kind != StageKind::kGravity && kind != StageKind::kLoad) continue;
      model_.links.set_by = static_cast<int>(k);
      return;
    }
    path_ = "tie";
    fault("", "", "no stage draws its prestress in", "add a gravity stage, or leave prestress out");
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
};

}  // namespace

void compile_links(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                   Model& model, FaultList& faults) {
  LinkCompiler(spec, assembly, map, model, faults).run();
}

}  // namespace wythe
