// Layers of the model file -> strands of fibres with nodes on blocks (docs/theory/layers.md).
//
//   lines across the layer  ->  pieces of a line within each block  ->  nodes on a piece  ->  fibres between nodes
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/elementary.h"
#include "core/to_int.h"
#include "model/parts.h"

namespace wythe {
namespace {

using geometry::Assembly;

constexpr double kClose = 2e-3;          // largest distance between pieces of a strand [m]
constexpr double kShortestPiece = 1e-3;  // of a piece [m]
constexpr int kMostNodes = 4;            // for each piece
constexpr int kMostLines = 10'000;       // of a layer in one direction: courses of 10 mm over 100 m
constexpr double kWidest = 2;            // distance of nodes over decay length of the bond (22.4)

// Extent of a layer or block: from..to along a strand, or across it.
struct Span {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
  [[nodiscard]] double length() const { return to - from; }
  void take(double at) { from = std::min(from, at), to = std::max(to, at); }
};

struct Piece {
  std::size_t block;  // of the assembly
  Span along;
};

// A line of fibres and the width that it represents.
struct Line {
  double across, breadth;
};

// All fibres in one direction, both faces together.
struct Fibres {
  bool upright = false;
  double stiffness = 0, strength = 0;  // E A, f A per metre of width [N/m]
};

class LayerCompiler {
 public:
  LayerCompiler(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map, Model& model,
                FaultList& faults)
      : spec_(spec), assembly_(assembly), map_(map), model_(model), faults_(faults) {}

  void run() {
    if (spec_.layer.empty()) return;
    if (spec_.solve.contacts == Contacts::kFree)
      faults_.add({"", "solve.contacts", "free", "does not know layers yet",
                   "leave it out, or leave the layers out", 0});
    find_bonded();
    for (std::size_t k = 0; k < spec_.layer.size(); ++k) {
      path_ = fmt::format("layer.{}", k);
      add(spec_.layer[k],
          spec_.layer[k].name.empty() ? fmt::format("{}", k + 1) : spec_.layer[k].name);
    }
  }

 private:
  void fault(const std::string& key, std::string value, std::string problem, std::string cure) {
    faults_.add({"", path_ + key, std::move(value), std::move(problem), std::move(cure), 0});
  }

  // Finds pairs of blocks with a bonded joint.
  void find_bonded() {
    for (int j = 0; j < model_.n_pair; ++j) {
      const JointMaterial& law = model_.materials[model_.joint_material[j]];
      if (law.tensile_strength > 0 || law.cohesion > 0)
        bonded_.insert(std::minmax(model_.joint_a[j], model_.joint_b[j]));
    }
  }

  [[nodiscard]] std::vector<std::size_t> masonry() const {
    std::vector<std::size_t> blocks;
    for (std::size_t b = 0; b < assembly_.blocks.size(); ++b)
      if (holds_layers(spec_, assembly_.blocks[b])) blocks.push_back(b);
    return blocks;
  }
  [[nodiscard]] Span span_of(std::size_t block, bool of_y) const {
    Span span;
    for (const Vec2& v : assembly_.blocks[block].outline) span.take(of_y ? v.y : v.x);
    return span;
  }

  bool check(const LayerSpec& layer) {
    const std::size_t before = faults_.all().size();
    const LayerFibreSpec& f = layer.fibres;
    const auto number = [](double value, const char* unit, double shown) {
      return std::isnan(value) ? std::string() : fmt::format("{:g} {}", value * shown, unit);
    };
    if (layer.sides != 1 && layer.sides != 2)
      fault(".sides", fmt::format("{}", layer.sides), "must be 1 or 2: a wall has two faces",
            "write sides = 2, or sides = 1 for one face");
    const auto is_area = [](double area) { return area >= 0 && std::isfinite(area); };
    if (!is_area(f.horizontal) || !is_area(f.vertical))
      fault(".fibres", "", "has an area that is none, such as one below 0",
            "write e.g. vertical = \"46 mm^2/m\"");
    else if (f.horizontal == 0 && f.vertical == 0 && layer.mortar.thickness > 0)
      return faults_.all().size() == before;
    else if (f.horizontal == 0 && f.vertical == 0)
      fault(".fibres", "", "has no fibres in either direction",
            "write horizontal = \"46 mm^2/m\", vertical = \"46 mm^2/m\" or one of them");
    const auto need = [&](const std::string& key, double value, const char* unit, double shown,
                          const char* example) {
      if (!(value > 0 && std::isfinite(value)))
        fault(key, number(value, unit, shown), "must be more than 0",
              fmt::format("write {}", example));
    };
    need(".fibres.youngs_modulus", f.youngs_modulus, "GPa", 1e-9, "youngs_modulus = \"72 GPa\"");
    need(".bond.energy", layer.bond.energy, "N/m", 1, "energy = \"400 N/m\"");
    need(".bond.slip", layer.bond.slip, "mm", 1e3, "slip = \"0.2 mm\"");
    const bool has_strength = !std::isnan(f.strength),
               has_strain = !std::isnan(f.strain_at_rupture);
    if (!has_strength && !has_strain)
      fault(".fibres.strength", "", "is missing",
            "write strength = \"1000 MPa\", or strain_at_rupture = 0.014");
    if (has_strength) need(".fibres.strength", f.strength, "MPa", 1e-6, "strength = \"1000 MPa\"");
    if (has_strain)
      need(".fibres.strain_at_rupture", f.strain_at_rupture, "", 1, "strain_at_rupture = 0.014");
    if (has_strength && has_strain && f.youngs_modulus > 0) {
      constexpr double kSame = 0.01;
      const double other = f.youngs_modulus * f.strain_at_rupture;
      if (!(std::fabs(other - f.strength) <= kSame * f.strength))
        fault(".fibres.strength", number(f.strength, "MPa", 1e-6),
              fmt::format("contradicts strain_at_rupture, which times youngs_modulus is {:.4g} MPa",
                          1e-6 * other),
              "leave one of both out");
    }
    return faults_.all().size() == before;
  }

  // Computes the rectangle of a layer, within the masonry.
  bool place(const LayerSpec& layer, Span& x, Span& y) {
    const std::size_t before = faults_.all().size();
    Span wall_x, wall_y;
    for (const std::size_t b : masonry()) {
      wall_x.take(span_of(b, false).from), wall_x.take(span_of(b, false).to);
      wall_y.take(span_of(b, true).from), wall_y.take(span_of(b, true).to);
    }
    const auto fit = [&](const char* start, double at, const char* size, double length,
                         const Span& wall, Span& out) {
      out.from = std::isnan(at) ? wall.from : at;
      out.to = std::isnan(length) ? wall.to : out.from + length;
      if (out.from > wall.from - kShortestPiece && out.to < wall.to + kShortestPiece &&
          out.from < out.to)
        return;
      fault(std::isnan(at) ? std::string(".") + size : std::string(".") + start,
            fmt::format("from {:g} to {:g} m", out.from, out.to),
            fmt::format("reaches out of the masonry, which goes from {:.4g} to {:.4g} m", wall.from,
                        wall.to),
            fmt::format("move it inside, or leave {} and {} out to cover all of it", start, size));
    };
    fit("x", layer.x, "width", layer.width, wall_x, x);
    fit("y", layer.y, "height", layer.height, wall_y, y);
    return faults_.all().size() == before;
  }

  void add(const LayerSpec& layer, const std::string& name) {
    const std::vector<std::string>& names = model_.layers.name;
    if (std::find(names.begin(), names.end(), name) != names.end())
      return fault(".name", name, "is the name of another layer", "give each a name of its own");
    Span x, y;
    if (!check(layer) || !place(layer, x, y)) return;
    const LayerFibreSpec& f = layer.fibres;
    if (f.horizontal == 0 && f.vertical == 0) return;  // mortar only
    const double strength =
        std::isnan(f.strength) ? f.youngs_modulus * f.strain_at_rupture : f.strength;
    const std::size_t crossed = model_.layers.cross_a.size();
    strands_ = 0, bonded_crossings_ = 0, widest_ = 0;
    detaches_ = breaks_ = std::numeric_limits<double>::infinity();
    for (const bool upright : {false, true}) {
      const double area = layer.sides * (upright ? f.vertical : f.horizontal);
      if (!(area > 0)) continue;
      const Fibres fibres{upright, f.youngs_modulus * area, strength * area};
      detaches_ =
          std::min(detaches_, std::sqrt(2 * fibres.stiffness * layer.sides * layer.bond.energy));
      breaks_ = std::min(breaks_, fibres.strength);
      const std::vector<Line> all = lines(upright ? x : y, upright);
      if (all.size() > kMostLines)
        return fault(upright ? ".width" : ".height",
                     fmt::format("{:.4g} m", (upright ? x : y).length()),
                     fmt::format("holds more than {} lines of fibres: its blocks are too small, or "
                                 "differ too much in size",
                                 kMostLines),
                     "let it cover the larger blocks alone, or make a layer for each size");
      for (const Line& line : all)
        if (!lay(layer, fibres, line, upright ? y : x)) return;
    }
    if (model_.layers.cross_a.size() == crossed)
      return fault("", name, "crosses no joint of the masonry, so it can hold nothing together",
                   "make it larger, or write fibres in the other direction too");
    if (bonded_crossings_ == 0)
      return fault("", name,
                   "lies on dry joints: without mortar it hangs on connectors alone, and these are "
                   "not in the model",
                   "leave it out, or give the joints the strength that they have");
    model_.layers.name.push_back(name);
    note(layer, name, model_.layers.cross_a.size() - crossed);
  }

  // Lines of fibres over the width `over`: between the joints parallel to them, so that each course, or each half
  // unit, has one.
  [[nodiscard]] std::vector<Line> lines(const Span& over, bool upright) const {
    std::vector<double> at, sizes;
    for (const std::size_t b : masonry()) {
      sizes.push_back(span_of(b, !upright).length());
      for (const Vec2& v : assembly_.blocks[b].outline) at.push_back(upright ? v.x : v.y);
    }
    std::sort(at.begin(), at.end());
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2),
                     sizes.end());
    const double block = sizes[sizes.size() / 2];
    constexpr double kNarrow = 0.4, kBroad = 1.1;  // of the width of a block
    std::vector<double> cuts = {over.from};
    for (const double c : at)
      if (c - cuts.back() > kNarrow * block && over.to - c > kNarrow * block) cuts.push_back(c);
    cuts.push_back(over.to);
    std::vector<Line> lines;
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const double broad = cuts[k] - cuts[k - 1];
      const int least = cuts.size() == 2 ? 2 : 1;
      const int wanted = std::min(to_int(std::ceil(broad / (kBroad * block))), kMostLines + 1);
      const int n = std::max(least, wanted);
      for (int i = 0; i < n; ++i) lines.push_back({cuts[k - 1] + (i + 0.5) * broad / n, broad / n});
    }
    return lines;
  }

  // Pieces of a line within blocks, from its start on. A block that only touches the line gives no piece.
  [[nodiscard]] std::vector<Piece> pieces(const Line& line, const Span& over, bool upright) const {
    std::vector<Piece> pieces;
    for (const std::size_t b : masonry()) {
      const std::vector<Vec2>& outline = assembly_.blocks[b].outline;
      std::vector<double> hits;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 p = outline[i], q = outline[(i + 1) % outline.size()];
        const double pc = upright ? p.x : p.y, qc = upright ? q.x : q.y;
        if ((pc <= line.across) == (qc <= line.across)) continue;
        const double pa = upright ? p.y : p.x, qa = upright ? q.y : q.x;
        hits.push_back(pa + (line.across - pc) / (qc - pc) * (qa - pa));
      }
      std::sort(hits.begin(), hits.end());
      for (std::size_t i = 1; i < hits.size(); i += 2) {
        const Span along{std::max(hits[i - 1], over.from), std::min(hits[i], over.to)};
        if (along.length() > kShortestPiece) pieces.push_back({b, along});
      }
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& a, const Piece& b) { return a.along.from < b.along.from; });
    return pieces;
  }

  // Lays the strands of one line; a gap, such as an opening, ends a strand.
  bool lay(const LayerSpec& layer, const Fibres& fibres, const Line& line, const Span& over) {
    const std::vector<Piece> all = pieces(line, over, fibres.upright);
    std::vector<Piece> strand;
    for (const Piece& piece : all) {
      if (is_solid(map_[piece.block])) {
        fault("", assembly_.blocks[piece.block].id, "is cut into zones; layers hold rigid blocks",
              "leave its zones out, or the layer beside it");
        return false;
      }
      if (!strand.empty() && piece.along.from - strand.back().along.to > kClose) {
        add_strand(layer, fibres, line, strand);
        strand.clear();
      }
      strand.push_back(piece);
    }
    add_strand(layer, fibres, line, strand);
    return true;
  }

  struct Node {
    std::size_t block;  // of the assembly
    double at, length, rate;
  };

  [[nodiscard]] std::vector<Node> nodes_of(const LayerSpec& layer, const Fibres& fibres,
                                           const std::vector<Piece>& strand) {
    const double energy = layer.sides * layer.bond.energy;  // per metre across and along
    const double rate = elementary::log(2.0) / layer.bond.slip;
    const double decay_by_rate = std::sqrt(fibres.stiffness / (2 * energy));
    std::vector<Node> nodes;
    for (const Piece& piece : strand) {
      const double long_ = piece.along.length();
      const int n = static_cast<int>(
          std::clamp(std::ceil(long_ * rate / decay_by_rate), 1.0, double{kMostNodes}));
      const double apart = long_ / n;
      widest_ = std::max(widest_, apart * rate / (kWidest * decay_by_rate));
      spacing_ = std::max(spacing_, apart);
      for (int k = 0; k < n; ++k)
        nodes.push_back({piece.block, piece.along.from + (k + 0.5) * apart, apart,
                         std::min(rate, kWidest * decay_by_rate / apart)});
    }
    return nodes;
  }

  void add_strand(const LayerSpec& layer, const Fibres& fibres, const Line& line,
                  const std::vector<Piece>& strand) {
    if (strand.size() < 2) return;
    Layers& l = model_.layers;
    const std::vector<Node> nodes = nodes_of(layer, fibres, strand);
    const double energy = layer.sides * layer.bond.energy * line.breadth;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Node& node = nodes[k];
      const bool last = k + 1 == nodes.size();
      const Node& next = last ? node : nodes[k + 1];
      const BlockId a = map_[node.block], b = map_[next.block];
      const auto arm = [&](BlockId block, double at) {
        const Vec2 p = fibres.upright ? Vec2{line.across, at} : Vec2{at, line.across};
        return Vec2{p.x - model_.centroid_x[block], p.y - model_.centroid_y[block]};
      };
      const Vec2 arm_a = arm(a, node.at), arm_b = arm(b, next.at);
      const double span = last ? 1 : next.at - node.at;
      l.a.push_back(a);
      l.b.push_back(b);
      l.arm_a_x.push_back(arm_a.x);
      l.arm_a_y.push_back(arm_a.y);
      l.arm_b_x.push_back(arm_b.x);
      l.arm_b_y.push_back(arm_b.y);
      l.span_x.push_back(fibres.upright ? 0 : span);
      l.span_y.push_back(fibres.upright ? span : 0);
      l.stiffness.push_back(last ? 0 : fibres.stiffness * line.breadth / span);
      l.strength.push_back(fibres.strength * line.breadth);
      l.bond_energy.push_back(energy * node.length);
      l.bond_rate.push_back(node.rate);
      l.crossing.push_back(a == b ? -1 : static_cast<std::int32_t>(l.cross_a.size()));
      if (a != b) {
        l.cross_a.push_back(a);
        l.cross_b.push_back(b);
        if (bonded_.count(std::minmax(a, b)) > 0) ++bonded_crossings_;
      }
      l.layer.push_back(static_cast<std::int32_t>(l.name.size()));
      l.strand.push_back(strands_);
      l.length.push_back(node.length);
      l.x.push_back(fibres.upright ? line.across : node.at);
      l.y.push_back(fibres.upright ? node.at : line.across);
      ++l.n;
    }
    ++strands_;
  }

  void note(const LayerSpec& layer, const std::string& name, std::size_t crossings) {
    std::vector<Message>& notes = model_.anatomy.notes;
    notes.push_back({"layer.stands",
                     {{"layer", name},
                      {"strands", strands_},
                      {"crossings", crossings},
                      {"detaches_kN_per_m", 1e-3 * detaches_},
                      {"breaks_kN_per_m", 1e-3 * breaks_}}});
    if (widest_ > 1)
      notes.push_back({"layer.coarse",
                       {{"layer", name},
                        {"slip_mm", 1e3 * layer.bond.slip * widest_},
                        {"spacing_mm", 1e3 * spacing_}}});
  }

  const ModelSpec& spec_;
  const Assembly& assembly_;
  const BlockMap& map_;
  Model& model_;
  FaultList& faults_;
  std::string path_;
  std::set<std::pair<BlockId, BlockId>> bonded_;

  // of the current layer
  int strands_ = 0, bonded_crossings_ = 0;
  double widest_ = 0, spacing_ = 0;   // nodes over the number that the bond requires; distance [m]
  double detaches_ = 0, breaks_ = 0;  // in the weaker direction [N/m]
};

}  // namespace

void compile_layers(const ModelSpec& spec, const Assembly& assembly, const BlockMap& map,
                    Model& model, FaultList& faults) {
  LayerCompiler(spec, assembly, map, model, faults).run();
}

}  // namespace wythe
