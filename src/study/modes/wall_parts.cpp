#include "study/modes/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wythe/reading.h"

namespace wythe::study {
namespace {

constexpr double kToe = 0.25;   // of a pier's width: the compressed corner
constexpr double kReach = 2.5;  // columns on either side of a jamb: the connection

bool is_wall(BlockRole role) { return role == BlockRole::kMasonry || role == BlockRole::kLintel; }

// Corners of a block.
using Outline = std::vector<Vec3>;

Box hull_of(const Outline& outline) {
  Box box{outline.front().x, outline.front().x, outline.front().y, outline.front().y};
  for (const Vec3& p : outline)
    box = {std::min(box.x0, p.x), std::max(box.x1, p.x), std::min(box.y0, p.y),
           std::max(box.y1, p.y)};
  return box;
}

bool is_inside(const Outline& o, double x, double y) {
  bool inside = false;
  for (std::size_t p = 0, q = o.size() - 1; p < o.size(); q = p++) {
    if ((o[p].y > y) == (o[q].y > y)) continue;
    const double cross = o[p].x + (y - o[p].y) / (o[q].y - o[p].y) * (o[q].x - o[p].x);
    if (x < cross) inside = !inside;
  }
  return inside;
}

struct Frame {
  Box wall;
  double column = 0, course = 0;
  std::vector<double> xs, ys;  // of all corners, sorted

  void take(const Box& box) {
    if (xs.empty()) wall = box;
    wall = {std::min(wall.x0, box.x0), std::max(wall.x1, box.x1), std::min(wall.y0, box.y0),
            std::max(wall.y1, box.y1)};
    xs.insert(xs.end(), {box.x0, box.x1});
    ys.insert(ys.end(), {box.y0, box.y1});
  }
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Frame frame_of(const Model& m) {
  const Anatomy& a = m.anatomy;
  Frame f;
  std::vector<double> widths, heights;
  for (BlockId b = 0; b < m.n_block; ++b) {
    if (!is_wall(a.block_role[b])) continue;
    const Box box = hull_of(outline_of(m, b));
    f.take(box);
    widths.push_back(box.width());
    heights.push_back(box.height());
  }
  for (const SolidBody& body : m.solids.bodies) f.take({body.x0, body.x1, body.y0, body.y1});
  std::sort(f.xs.begin(), f.xs.end());
  std::sort(f.ys.begin(), f.ys.end());
  f.column = a.half_unit > 0 ? a.half_unit : median(widths);
  f.course = a.course_height > 0 ? a.course_height : median(heights);
  return f;
}

double nearest(const std::vector<double>& sorted, double value) {
  const auto above = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (above == sorted.begin()) return sorted.front();
  if (above == sorted.end()) return sorted.back();
  return *above - value < value - *(above - 1) ? *above : *(above - 1);
}

// The wall painted on cells a quarter of a block wide and high.
class Raster {
 public:
  Raster(const Model& m, const Frame& f) : wall_(f.wall) {
    constexpr double kCells = 4;       // a block
    constexpr double kMost = 1 << 12;  // cells along a side
    nx_ = count(wall_.width(), f.column, kCells, kMost);
    ny_ = count(wall_.height(), f.course, kCells, kMost);
    dx_ = wall_.width() / nx_;
    dy_ = wall_.height() / ny_;
    cell_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), kEmpty);
    for (BlockId b = 0; b < block_count(m); ++b)
      if (b >= m.n_block || is_wall(m.anatomy.block_role[b])) paint(outline_of(m, b));
  }

  // Bounding boxes of the holes that touch neither side nor the top.
  std::vector<Box> holes() {
    std::vector<Box> found;
    for (int i = 0; i < nx_; ++i) {
      for (int j = 0; j < ny_; ++j) {
        if (at(i, j) != kEmpty) continue;
        const Range r = flood(i, j);
        if (r.i0 == 0 || r.i1 == nx_ - 1 || r.j1 == ny_ - 1) continue;
        found.push_back({wall_.x0 + r.i0 * dx_, wall_.x0 + (r.i1 + 1) * dx_, wall_.y0 + r.j0 * dy_,
                         wall_.y0 + (r.j1 + 1) * dy_});
      }
    }
    return found;
  }

 private:
  enum Cell : char { kEmpty, kFull, kSeen };
  struct Range {
    int i0, i1, j0, j1;
  };

  static int count(double length, double block, double cells, double most) {
    return static_cast<int>(std::clamp(std::ceil(cells * length / block - 1e-6), 1.0, most));
  }
  Cell& at(int i, int j) {
    return cell_[static_cast<std::size_t>(i) * static_cast<std::size_t>(ny_) +
                 static_cast<std::size_t>(j)];
  }

  void paint(const Outline& outline) {
    const Box box = hull_of(outline);
    const int i0 = std::max(0, static_cast<int>((box.x0 - wall_.x0) / dx_) - 1);
    const int j0 = std::max(0, static_cast<int>((box.y0 - wall_.y0) / dy_) - 1);
    for (int i = i0; i < nx_ && wall_.x0 + i * dx_ < box.x1; ++i)
      for (int j = j0; j < ny_ && wall_.y0 + j * dy_ < box.y1; ++j)
        if (is_inside(outline, wall_.x0 + (i + 0.5) * dx_, wall_.y0 + (j + 0.5) * dy_))
          at(i, j) = kFull;
  }

  Range flood(int i, int j) {
    Range r{i, i, j, j};
    std::vector<std::pair<int, int>> open{{i, j}};
    at(i, j) = kSeen;
    while (!open.empty()) {
      const auto [p, q] = open.back();
      open.pop_back();
      r = {std::min(r.i0, p), std::max(r.i1, p), std::min(r.j0, q), std::max(r.j1, q)};
      constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
      for (const auto& step : kSteps) {
        const int u = p + step[0], v = q + step[1];
        if (u < 0 || v < 0 || u >= nx_ || v >= ny_ || at(u, v) != kEmpty) continue;
        at(u, v) = kSeen;
        open.emplace_back(u, v);
      }
    }
    return r;
  }

  Box wall_;
  int nx_ = 0, ny_ = 0;
  double dx_ = 0, dy_ = 0;
  std::vector<Cell> cell_;
};

std::vector<Box> openings_of(const Model& m, const Frame& f) {
  std::vector<Box> openings;
  if (!(f.column > 0) || !(f.course > 0)) return openings;
  for (Box hole : Raster(m, f).holes()) {
    hole = {nearest(f.xs, hole.x0), nearest(f.xs, hole.x1), nearest(f.ys, hole.y0),
            nearest(f.ys, hole.y1)};
    // anything smaller is a gap between blocks
    if (hole.width() >= 0.9 * f.column && hole.height() >= 0.9 * f.course) openings.push_back(hole);
  }
  std::sort(openings.begin(), openings.end(),
            [](const Box& a, const Box& b) { return a.x0 != b.x0 ? a.x0 < b.x0 : a.y0 < b.y0; });
  return openings;
}

bool meet(double a0, double a1, double b0, double b1) { return a0 < b1 - 1e-9 && b0 < a1 - 1e-9; }

struct Span {
  double lo, hi;
};

// Overlapping spans joined, in order.
std::vector<Span> joined(std::vector<Span> spans) {
  std::sort(spans.begin(), spans.end(), [](Span a, Span b) { return a.lo < b.lo; });
  std::vector<Span> out;
  for (const Span& next : spans) {
    if (out.empty() || next.lo >= out.back().hi - 1e-9) out.push_back(next);
    out.back().hi = std::max(out.back().hi, next.hi);
  }
  return out;
}

class Finder {
 public:
  explicit Finder(const Model& m)
      : model_(m), frame_(frame_of(m)), openings_(openings_of(m, frame_)) {
    parts_.wall = frame_.wall;
    parts_.column = frame_.column;
    parts_.course = frame_.course;
    parts_.openings = static_cast<int>(openings_.size());
  }

  WallParts find() {
    std::vector<Span> gaps;
    for (const Box& o : openings_) gaps.push_back({o.x0, o.x1});
    gaps = joined(gaps);
    gaps.push_back({frame_.wall.x1, frame_.wall.x1});
    double x0 = frame_.wall.x0;
    for (const Span& gap : gaps) {
      if (gap.lo - x0 > 0.5 * frame_.column) add_piers(x0, gap.lo);
      x0 = gap.hi;
    }
    for (const Box& o : openings_) add_spandrels(o);
    name_parts();
    return std::move(parts_);
  }

 private:
  // One pier a storey: from the lowest sill to the lowest head of the openings beside it.
  void add_piers(double x0, double x1) {
    std::vector<Box> beside;
    std::vector<Span> storeys;
    for (const Box& o : openings_) {
      if (std::fabs(o.x1 - x0) > frame_.column && std::fabs(o.x0 - x1) > frame_.column) continue;
      beside.push_back(o);
      storeys.push_back({o.y0, o.y1});
    }
    storeys = joined(storeys);
    if (storeys.empty()) storeys.push_back({frame_.wall.y0, frame_.wall.y1});
    double base = frame_.wall.y0;
    for (const Span& storey : storeys) {
      double head = storey.hi;
      for (const Box& o : beside)
        if (meet(o.y0, o.y1, storey.lo, storey.hi)) head = std::min(head, o.y1);
      Pier pier;
      pier.box = {x0, x1, storey.lo, head};
      pier.base = base;
      base = head;
      add_toes(pier);
      parts_.piers.push_back(pier);
    }
  }

  void add_toes(Pier& pier) {
    const double reach = std::min(kToe * pier.box.width(), 0.5 * pier.box.height());
    const double top = pier.box.y0 + reach;
    pier.left = static_cast<int>(parts_.toes.size());
    pier.right = pier.left + 1;
    const double below = pier.base - 0.5 * frame_.course;
    parts_.toes.push_back({"", {pier.box.x0, pier.box.x0 + kToe * pier.box.width(), below, top}});
    parts_.toes.push_back({"", {pier.box.x1 - kToe * pier.box.width(), pier.box.x1, below, top}});
  }

  void add_spandrels(const Box& o) {
    double top = frame_.wall.y1, floor = frame_.wall.y0;
    for (const Box& other : openings_) {
      if (!meet(o.x0, o.x1, other.x0, other.x1)) continue;
      if (other.y0 >= o.y1 - 1e-9) top = std::min(top, other.y0);
      if (other.y1 <= o.y0 + 1e-9) floor = std::max(floor, other.y1);
    }
    if (o.y0 - frame_.wall.y0 > 0.5 * frame_.course && floor <= frame_.wall.y0 + 1e-9) {
      Spandrel sill;
      sill.box = {o.x0, o.x1, frame_.wall.y0, o.y0};
      sill.is_sill = true;
      parts_.spandrels.push_back(sill);
    }
    if (top - o.y1 < 0.5 * frame_.course) return;
    Spandrel spandrel;
    spandrel.box = {o.x0, o.x1, o.y1, top};
    spandrel.lintel = lintel_depth(spandrel.box);
    spandrel.left = add_connection(o.x0, spandrel.box);
    spandrel.right = add_connection(o.x1, spandrel.box);
    parts_.spandrels.push_back(spandrel);
  }

  int add_connection(double jamb, const Box& spandrel) {
    const double reach = std::min(kReach * frame_.column, 0.5 * spandrel.width());
    parts_.connections.push_back(
        {"", {jamb - reach, jamb + reach, spandrel.y0 - 0.5 * frame_.course, spandrel.y1}});
    return static_cast<int>(parts_.connections.size()) - 1;
  }

  [[nodiscard]] double lintel_depth(const Box& spandrel) const {
    double depth = 0;
    const Anatomy& a = model_.anatomy;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (a.block_role[b] != BlockRole::kLintel) continue;
      if (spandrel.holds(model_.centroid_x[b], model_.centroid_y[b]))
        depth = std::max(depth, hull_of(outline_of(model_, b)).y1 - spandrel.y0);
    }
    for (const SolidBody& body : model_.solids.bodies)
      if (spandrel.holds(0.5 * (body.x0 + body.x1), 0.5 * (body.y0 + body.y1)))
        depth = std::max(depth, body.y1 - spandrel.y0);
    return depth;
  }

  // "left pier", "pier 3"; "spandrel", "spandrel 2"; "left connection of spandrel 2".
  void name_parts() {
    const std::size_t n = parts_.piers.size();
    for (std::size_t i = 0; i < n; ++i) {
      Pier& pier = parts_.piers[i];
      Message words{"part.pier_number", {{"number", i + 1}}};
      if (n == 1) words = {openings_.empty() ? "part.wall" : "part.pier"};
      if (n == 2) words = {i == 0 ? "part.left_pier" : "part.right_pier"};
      const bool bare = n == 1 && openings_.empty();
      pier.name = called(words);
      parts_.toes[static_cast<std::size_t>(pier.left)].name =
          called({bare ? "part.left_toe_of_wall" : "part.left_toe", {{"pier", words}}});
      parts_.toes[static_cast<std::size_t>(pier.right)].name =
          called({bare ? "part.right_toe_of_wall" : "part.right_toe", {{"pier", words}}});
    }
    const auto is_sill = [](const Spandrel& s) { return s.is_sill; };
    const auto sills = std::count_if(parts_.spandrels.begin(), parts_.spandrels.end(), is_sill);
    const auto above = static_cast<std::ptrdiff_t>(parts_.spandrels.size()) - sills;
    int next_sill = 0, next = 0;
    for (Spandrel& s : parts_.spandrels) {
      const int number = s.is_sill ? ++next_sill : ++next;
      const bool alone = (s.is_sill ? sills : above) == 1;
      Message words{s.is_sill ? "part.sill" : "part.spandrel"};
      if (!alone)
        words = {s.is_sill ? "part.sill_number" : "part.spandrel_number", {{"number", number}}};
      s.name = called(words);
      if (s.left >= 0)
        parts_.connections[static_cast<std::size_t>(s.left)].name =
            called(above == 1 ? Message{"part.left_connection"}
                              : Message{"part.left_connection_of", {{"spandrel", words}}});
      if (s.right >= 0)
        parts_.connections[static_cast<std::size_t>(s.right)].name =
            called(above == 1 ? Message{"part.right_connection"}
                              : Message{"part.right_connection_of", {{"spandrel", words}}});
    }
  }

  std::string called(const Message& words) {
    std::string name = text_of(words);
    parts_.words[name] = words;
    return name;
  }

  const Model& model_;
  Frame frame_;
  std::vector<Box> openings_;
  WallParts parts_;
};

}  // namespace

WallParts find_parts(const Model& model) { return Finder(model).find(); }

std::vector<Box> find_openings(const Model& model) { return openings_of(model, frame_of(model)); }

}  // namespace wythe::study
