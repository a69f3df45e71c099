// Finds openings as holes in a raster of the blocks, sorts them into storeys, and divides the masonry into parts. A
// cell is a quarter of the usual block, which is half a unit long and a course high, or of median size where blocks
// have no such sizes. Edges of holes move to the nearest block edge, and rows of openings are filled from below.
#include "judge/modes/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/text.h"

#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

constexpr double kToe = 0.25;   // of a pier's width: the compressed corner
constexpr double kReach = 2.5;  // columns on either side of a jamb: the connection

bool is_wall(BlockRole role) {
  return role != BlockRole::kPlate && role != BlockRole::kBeam && role != BlockRole::kFrame &&
         role != BlockRole::kCutOut;
}

// Corners of a block.
using Outline = std::vector<Vec3>;

Box join(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::max(a.x1, b.x1), std::min(a.y0, b.y0), std::max(a.y1, b.y1)};
}

Box hull_of(const Outline& outline) {
  Box box{outline.front().x, outline.front().x, outline.front().y, outline.front().y};
  for (const Vec3& p : outline)
    box = {std::min(box.x0, p.x), std::max(box.x1, p.x), std::min(box.y0, p.y),
           std::max(box.y1, p.y)};
  return box;
}

Box hull_of(const std::vector<Outline>& parts) {
  Box box = hull_of(parts.front());
  for (const Outline& part : parts) box = join(box, hull_of(part));
  return box;
}

// Extent of the pieces of one unit along the wall.
struct Range {
  double low = 1e300, high = -1e300;
  void take(const Box& box) { low = std::min(low, box.x0), high = std::max(high, box.x1); }
  [[nodiscard]] double length() const { return high - low; }
};

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
  std::vector<Box> ground;     // below each level foundation joint, from the wall's foot up to it

  void take(const Box& box) {
    if (xs.empty()) wall = box;
    wall = join(wall, box);
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

// Length and height of the usual block: those of the model, else medians. The
// pieces of a cut unit count together: front.c03u05a and front.c03u05b are one.
struct UsualBlock {
  double column = 0, course = 0;
};
// The unit to which a block belongs: front.c03u05 for front.c03u05a.w1.
std::string unit_of(const std::string& id, const std::string& wall) {
  const std::string piece = id.substr(0, id.find('.', wall.size() + 1));
  return is_digit(piece.back()) ? piece : piece.substr(0, piece.size() - 1);
}

UsualBlock usual_block(const Model& m, const Elevation& seen, const std::vector<BlockId>& blocks,
                       const std::vector<Box>& boxes) {
  const Anatomy& a = m.anatomy;
  std::vector<double> widths, heights;
  std::map<std::string, Range> units;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    heights.push_back(boxes[k].height());
    const std::string& id = a.block_id[blocks[k]];
    const std::string wall = seen.of.empty() ? "" : wall_of(id);
    if (wall.empty())
      widths.push_back(boxes[k].width());
    else if (m.anatomy.block_role[blocks[k]] == BlockRole::kMasonry)
      units[unit_of(id, wall)].take(boxes[k]);
  }
  for (const auto& [unit, range] : units) widths.push_back(0.5 * range.length());
  return {a.half_unit > 0 ? a.half_unit : median(widths),
          a.course_height > 0 ? a.course_height : median(heights)};
}

Frame frame_of(const Model& m, const Elevation& seen) {
  Frame f;
  std::vector<BlockId> blocks;
  std::vector<Box> boxes;
  for (BlockId b = 0; b < m.n_block; ++b) {
    if (!is_wall(m.anatomy.block_role[b]) || !seen.holds(b)) continue;
    blocks.push_back(b);
    boxes.push_back(hull_of(outlines_of(m, seen, b)));
    f.take(boxes.back());
  }
  for (const SolidBody& body : m.solids.bodies) f.take({body.x0, body.x1, body.y0, body.y1});
  for (const BlockId body : seen.bodies) f.take(hull_of(outlines_of(m, seen, body)));
  for (JointId j = 0; j < m.n_joint; ++j) {
    const JointShape joint = joint_shape(m, j);
    if (joint.a != kGroundBlock || !seen.holds(joint.b)) continue;
    const Vec3 centre = seen.place(joint.centre);
    const auto [half, up] = reach_of(seen, joint.half, joint.half_2);
    const double x = centre.x, y = centre.y;
    if (up <= half && y > f.wall.y0 + 1e-6) f.ground.push_back({x - half, x + half, f.wall.y0, y});
  }
  std::sort(f.xs.begin(), f.xs.end());
  std::sort(f.ys.begin(), f.ys.end());
  const UsualBlock usual = usual_block(m, seen, blocks, boxes);
  f.column = usual.column, f.course = usual.course;
  return f;
}

double nearest(const std::vector<double>& sorted, double value) {
  const auto above = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (above == sorted.begin()) return sorted.front();
  if (above == sorted.end()) return sorted.back();
  return *above - value < value - *(above - 1) ? *above : *(above - 1);
}

struct Hole {
  Box box;
  bool at_edge = false;
  double filled = 1;  // share of the box
};

// The wall on a raster of cells that are a quarter of a block wide and high.
class Raster {
 public:
  Raster(const Model& m, const Elevation& seen, const Frame& f) : wall_(f.wall) {
    constexpr double kCells = 4;       // for each block
    constexpr double kMost = 1 << 12;  // cells along a side
    nx_ = count(wall_.width(), f.column, kCells, kMost);
    ny_ = count(wall_.height(), f.course, kCells, kMost);
    dx_ = wall_.width() / nx_;
    dy_ = wall_.height() / ny_;
    cell_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), kEmpty);
    for (BlockId b = 0; b < block_count(m); ++b)
      if (b >= m.n_block || (is_wall(m.anatomy.block_role[b]) && seen.holds(b)))
        for (const Outline& part : outlines_of(m, seen, b)) paint(part);
    for (const BlockId body : seen.bodies)
      for (const Outline& part : outlines_of(m, seen, body)) paint(part);
    for (const Box& g : f.ground)  // a wall on steps has no opening below them
      paint({{g.x0, g.y0, 0}, {g.x1, g.y0, 0}, {g.x1, g.y1, 0}, {g.x0, g.y1, 0}});
  }

  // Holes that do not touch the top.
  std::vector<Hole> holes() {
    std::vector<Hole> found;
    for (int i = 0; i < nx_; ++i) {
      for (int j = 0; j < ny_; ++j) {
        if (at(i, j) != kEmpty) continue;
        const Range r = flood(i, j);
        if (r.j1 == ny_ - 1) continue;
        Hole hole;
        hole.box = {wall_.x0 + r.i0 * dx_, wall_.x0 + (r.i1 + 1) * dx_, wall_.y0 + r.j0 * dy_,
                    wall_.y0 + (r.j1 + 1) * dy_};
        hole.at_edge = r.i0 == 0 || r.i1 == nx_ - 1;
        hole.filled = static_cast<double>(r.cells) / ((r.i1 + 1 - r.i0) * (r.j1 + 1 - r.j0));
        found.push_back(hole);
      }
    }
    return found;
  }

 private:
  enum Cell : char { kEmpty, kFull, kSeen };
  struct Range {
    int i0, i1, j0, j1;
    int cells = 0;
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
      r = {std::min(r.i0, p), std::max(r.i1, p), std::min(r.j0, q), std::max(r.j1, q), r.cells + 1};
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

struct Opening : Box {
  bool at_edge = false;  // masonry on one side only
  int storey = 0;        // from 0
  double filled = 1;     // share of the box
};

// A gap at the edge counts as an opening if it is upright and as wide as a door
// against its height. The space below a cornice or an inclined side does not.
bool is_gap_at_edge(const Hole& hole, const Frame& f) {
  return hole.filled >= 0.75 && hole.box.height() >= 1.9 * f.course &&
         hole.box.width() >= 0.25 * hole.box.height();
}

std::vector<Opening> openings_of(const Model& m, const Elevation& seen, const Frame& f) {
  std::vector<Opening> openings;
  if (!(f.column > 0) || !(f.course > 0)) return openings;
  double widest = 0, highest = 0;
  for (Hole hole : Raster(m, seen, f).holes()) {
    Box& box = hole.box;
    box = {nearest(f.xs, box.x0), nearest(f.xs, box.x1), nearest(f.ys, box.y0),
           nearest(f.ys, box.y1)};
    // smaller ones are gaps between blocks
    if (box.width() < 0.9 * f.column || box.height() < 0.9 * f.course) continue;
    if (hole.at_edge && !is_gap_at_edge(hole, f)) continue;
    openings.push_back({box, hole.at_edge, 0, hole.filled});
    widest = std::max(widest, box.width()), highest = std::max(highest, box.height());
  }
  // smaller than a quarter of the largest in both directions: the pocket of a joist, a vent
  std::erase_if(openings, [&](const Box& o) {
    constexpr double kQuarter = 0.2501;
    return o.width() <= kQuarter * widest && o.height() <= kQuarter * highest;
  });
  std::sort(openings.begin(), openings.end(),
            [](const Box& a, const Box& b) { return a.x0 != b.x0 ? a.x0 < b.x0 : a.y0 < b.y0; });
  return openings;
}

// Whether the masonry is an arch alone: its one opening is round and stands on the ground, most of its joints are inclined, it is
// no deeper over the crown than a third of the span, and nothing stands at its upper corners. A wall with an arch over its
// opening has level beds, and one of irregular stones has masonry over and beside the arch.
bool is_bare_arch(const Model& m, const Elevation& seen, const Frame& f,
                  const std::vector<Opening>& openings) {
  constexpr double kRound = 0.9;      // share of its box that a rectangle exceeds
  constexpr double kOnGround = 0.1;   // of the height
  constexpr double kInclined = 0.17;  // least part of a unit normal along either axis: 10 degrees
  if (openings.size() != 1 || openings[0].at_edge || openings[0].filled > kRound ||
      openings[0].y0 > f.wall.y0 + kOnGround * f.wall.height())
    return false;
  constexpr double kDeepest = 1.0 / 3, kCorner = 0.05;
  if (f.wall.y1 - openings[0].y1 > kDeepest * openings[0].width()) return false;
  for (BlockId b = 0; b < m.n_block; ++b) {
    if (!seen.holds(b)) continue;
    for (const auto& outline : outlines_of(m, seen, b))
      for (const auto& p : outline) {
        const double inwards = std::min(p.x - f.wall.x0, f.wall.x1 - p.x);
        if (inwards < kCorner * f.wall.width() && f.wall.y1 - p.y < kCorner * f.wall.height())
          return false;
      }
  }
  double all = 0, inclined = 0;
  for (JointId j = 0; j < m.n_joint; ++j) {
    const JointShape joint = joint_shape(m, j);
    if (!seen.holds(joint.b)) continue;
    const Vec3 normal = seen.in_plane(joint.normal);
    all += joint.area;
    if (std::fabs(normal.x) > kInclined && std::fabs(normal.y) > kInclined) inclined += joint.area;
  }
  return inclined > 0.5 * all;
}

double shared(double a0, double a1, double b0, double b1) {
  return std::min(a1, b1) - std::max(a0, b0);
}
bool meet(double a0, double a1, double b0, double b1) { return shared(a0, a1, b0, b1) > 1e-9; }

// Openings of a row: their middles lie below the lowest head. Rows are
// filled upwards, so each opening overlaps in height with every other.
struct Row {
  double sill = 0, head = 0;    // lowest and highest
  double lowest_head = 0;       // of its openings
  double width = 0;             // of all its openings
  std::vector<std::size_t> of;  // openings
};

std::vector<Row> rows_of(const std::vector<Opening>& openings) {
  std::vector<std::size_t> upwards(openings.size());
  for (std::size_t i = 0; i < upwards.size(); ++i) upwards[i] = i;
  const auto middle = [&](std::size_t i) { return 0.5 * (openings[i].y0 + openings[i].y1); };
  std::stable_sort(upwards.begin(), upwards.end(),
                   [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
  std::vector<Row> rows;
  for (const std::size_t i : upwards) {
    const Opening& o = openings[i];
    if (rows.empty() || middle(i) >= rows.back().lowest_head)
      rows.push_back({o.y0, o.y1, o.y1, 0, {}});
    Row& row = rows.back();
    row.sill = std::min(row.sill, o.y0), row.head = std::max(row.head, o.y1);
    row.lowest_head = std::min(row.lowest_head, o.y1);
    row.width += o.width();
    row.of.push_back(i);
  }
  return rows;
}

// Two rows that overlap in height are one storey. The openings of the smaller
// row, such as a staircase window or a high gate, go to the other row.
std::vector<Row> storeys_of(const std::vector<Opening>& openings) {
  std::vector<Row> rows = rows_of(openings);
  const auto tangled = [&] {
    return std::adjacent_find(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
      return meet(a.sill, a.head, b.sill, b.head);
    });
  };
  for (auto lower = tangled(); lower != rows.end(); lower = tangled()) {
    auto odd = lower, stays = lower + 1;
    if (odd->width >= stays->width * (1 - 1e-9)) std::swap(odd, stays);  // the upper of equal ones
    stays->of.insert(stays->of.end(), odd->of.begin(), odd->of.end());
    stays->width += odd->width;
    rows.erase(odd);
  }
  return rows;
}

// The free edge on one side of a pier: stacked openings count as one.
struct Side {
  double x = 0;          // the pier's edge [m]
  double reach = 0;      // half way over the opening, or the wall's end [m]
  bool is_open = false;  // else the wall's end
  double sill = 0, head = 0;
};

// Codes for a kind of part: a single one, one of many, one of many in a storey.
struct Called {
  const char *alone, *number, *of_storey;
};
constexpr Called kPier{"part.pier", "part.pier_number", "part.pier_of_storey"};
constexpr Called kNode{"part.node", "part.node_number", "part.node_of_storey"};
constexpr Called kSill{"part.sill", "part.sill_number", "part.sill_of_storey"};
constexpr Called kSpandrel{"part.spandrel", "part.spandrel_number", "part.spandrel_of_storey"};

class Finder {
 public:
  // `marks`: numbers used so far, by letter.
  Finder(const Model& m, const Elevation& seen, int elevation, std::map<std::string, int>& marks)
      : model_(m),
        seen_(seen),
        frame_(frame_of(m, seen)),
        openings_(openings_of(m, seen, frame_)),
        elevation_(elevation),
        marks_(marks) {
    parts_.is_arch = is_bare_arch(m, seen, frame_, openings_);
    if (parts_.is_arch) openings_.clear();
    rows_ = storeys_of(openings_);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (const std::size_t i : rows_[k].of) openings_[i].storey = static_cast<int>(k);
    parts_.wall = frame_.wall;
    parts_.column = frame_.column;
    parts_.course = frame_.course;
    parts_.openings = static_cast<int>(openings_.size());
    parts_.storeys = std::max(1, static_cast<int>(rows_.size()));
  }

  WallParts find() {
    if (rows_.empty()) add_whole_wall();
    for (std::size_t k = 0; k < rows_.size(); ++k) add_piers(k);
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (const Opening& o : openings_)
        if (o.storey == static_cast<int>(k)) add_spandrels(o);
    name_parts();
    return std::move(parts_);
  }

 private:
  void add_whole_wall() {
    Side left{.x = frame_.wall.x0, .reach = frame_.wall.x0};
    Side right{.x = frame_.wall.x1, .reach = frame_.wall.x1};
    left.sill = right.sill = frame_.wall.y0, left.head = right.head = frame_.wall.y1;
    left.is_open = true;
    add_pier(left, right, 0);
  }

  // Adds piers between the openings of a row, and other openings that reach into its height.
  void add_piers(std::size_t storey) {
    const Row& row = rows_[storey];
    double foot = row.sill, head = row.head;  // the height range that all its openings share
    for (const std::size_t i : row.of)
      foot = std::max(foot, openings_[i].y0), head = std::min(head, openings_[i].y1);
    if (foot >= head) foot = row.sill, head = row.head;
    Side left{.x = frame_.wall.x0, .reach = frame_.wall.x0};
    for (auto o = openings_.begin(); o != openings_.end();) {
      if (!meet(o->y0, o->y1, foot, head) && o->storey != static_cast<int>(storey)) {
        ++o;
        continue;
      }
      Box gap = *o;
      for (++o; o != openings_.end() && o->x0 < gap.x1 - 1e-9; ++o) {
        if (!meet(o->y0, o->y1, foot, head) && o->storey != static_cast<int>(storey)) continue;
        gap = {gap.x0, std::max(gap.x1, o->x1), std::min(gap.y0, o->y0), std::max(gap.y1, o->y1)};
      }
      const double middle = 0.5 * (gap.x0 + gap.x1);
      const Side right{gap.x0, middle, true, gap.y0, gap.y1};
      if (right.x - left.x > 0.5 * frame_.column) add_pier(left, right, storey);
      left = {gap.x1, middle, true, gap.y0, gap.y1};
    }
    const Side end{.x = frame_.wall.x1, .reach = frame_.wall.x1};
    if (end.x - left.x > 0.5 * frame_.column) add_pier(left, end, storey);
  }

  // From the lower sill to the lower head beside the pier; its clear height starts at the higher sill.
  void add_pier(const Side& left, const Side& right, std::size_t storey) {
    const Side& a = left.is_open ? left : right;
    const Side& b = right.is_open ? right : left;
    Pier pier;
    pier.storey = static_cast<int>(storey) + 1;
    pier.box = {left.x, right.x, std::min(a.sill, b.sill), std::min(a.head, b.head)};
    pier.reach_x0 = left.reach, pier.reach_x1 = right.reach;
    pier.clear_y0 = std::max(a.sill, b.sill), pier.clear_y1 = pier.box.y1;
    if (pier.clear_y1 - pier.clear_y0 < 0.5 * pier.box.height()) pier.clear_y0 = pier.box.y0;
    pier.base = base_of(pier.box, storey);
    if (pier.base < pier.box.y1) {  // a step may lie higher than the sill beside the pier
      pier.box.y0 = std::max(pier.box.y0, pier.base);
      pier.clear_y0 = std::max(pier.clear_y0, pier.base);
    }
    add_toes(pier);
    const double top = storey + 1 < rows_.size() ? rows_[storey + 1].sill : frame_.wall.y1;
    if (top - pier.box.y1 > 0.5 * frame_.course)
      parts_.nodes.push_back({"", {left.x, right.x, pier.box.y1, top}, "", pier.storey});
    parts_.piers.push_back(pier);
  }

  // Base of a pier: the ground below the lowest piers; for others half way down to the heads of the storey below.
  [[nodiscard]] double base_of(const Box& pier, std::size_t storey) const {
    if (storey == 0) return ground_below(pier);
    return std::min(pier.y0, 0.5 * (pier.y0 + rows_[storey - 1].head));
  }

  // Lowest ground below the pier; the wall's foot where none is in line with it.
  [[nodiscard]] double ground_below(const Box& pier) const {
    double under = 0, lowest = frame_.wall.y1;
    for (const Box& g : frame_.ground) {
      const double common = std::min(g.x1, pier.x1) - std::max(g.x0, pier.x0);
      if (common > 0) under += common, lowest = std::min(lowest, g.y1);
    }
    return under > (1 - 1e-6) * pier.width() ? lowest : frame_.wall.y0;
  }

  void add_toes(Pier& pier) {
    const double reach = std::min(kToe * pier.box.width(), 0.5 * pier.box.height());
    const double top = pier.box.y0 + reach;
    pier.left = static_cast<int>(parts_.toes.size());
    pier.right = pier.left + 1;
    const double below = pier.base - 0.5 * frame_.course;
    const double wide = kToe * pier.box.width();
    parts_.toes.push_back({"", {pier.box.x0, pier.box.x0 + wide, below, top}, "", pier.storey});
    parts_.toes.push_back({"", {pier.box.x1 - wide, pier.box.x1, below, top}, "", pier.storey});
  }

  void add_spandrels(const Opening& o) {
    double top = frame_.wall.y1;
    bool is_lowest = true;
    for (const Opening& other : openings_) {
      const bool in_line = meet(o.x0, o.x1, other.x0, other.x1);
      if (other.y0 >= o.y1 - 1e-9 && (in_line || other.storey > o.storey))
        top = std::min(top, other.y0);
      if (in_line && other.y1 <= o.y0 + 1e-9) is_lowest = false;
    }
    if (o.y0 - frame_.wall.y0 > 0.5 * frame_.course && is_lowest && o.storey == 0) {
      Spandrel sill;
      sill.storey = 1;
      sill.box = {o.x0, o.x1, frame_.wall.y0, o.y0};
      sill.is_sill = true;
      parts_.spandrels.push_back(sill);
    }
    top = foot_of_ring_beam({o.x0, o.x1, o.y1, top});
    if (top - o.y1 < 0.5 * frame_.course) return;
    Spandrel spandrel;
    spandrel.storey = o.storey + 1;
    spandrel.opening = o.height();
    spandrel.box = {o.x0, o.x1, o.y1, top};
    spandrel.lintel = lintel_depth(spandrel.box);
    if (o.x0 > frame_.wall.x0 + 1e-9) spandrel.left = add_connection(o.x0, spandrel);
    if (o.x1 < frame_.wall.x1 - 1e-9) spandrel.right = add_connection(o.x1, spandrel);
    parts_.spandrels.push_back(spandrel);
  }

  int add_connection(double jamb, const Spandrel& of) {
    const double reach = std::min(kReach * frame_.column, 0.5 * of.box.width());
    const Box box{jamb - reach, jamb + reach, of.box.y0 - 0.5 * frame_.course, of.box.y1};
    parts_.connections.push_back({"", box, "", of.storey});
    return static_cast<int>(parts_.connections.size()) - 1;
  }

  // Upper end of the masonry above an opening: below a ring beam at its top.
  [[nodiscard]] double foot_of_ring_beam(const Box& above) const {
    double top = above.y1;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      if (model_.anatomy.block_role[b] != BlockRole::kRingBeam || !is_within(above, b)) continue;
      const Box box = hull_of(outlines_of(model_, seen_, b));
      if (box.y1 > above.y1 - 0.5 * frame_.course) top = std::min(top, box.y0);
    }
    return top;
  }

  [[nodiscard]] double lintel_depth(const Box& spandrel) const {
    double depth = 0;
    const Anatomy& a = model_.anatomy;
    for (BlockId b = 0; b < model_.n_block; ++b) {
      const bool is_ring = a.block_role[b] == BlockRole::kRingBeam;
      if (!is_ring && a.block_role[b] != BlockRole::kLintel) continue;
      if (!is_within(spandrel, b)) continue;
      const Box box = hull_of(outlines_of(model_, seen_, b));
      if (is_ring && box.y0 > spandrel.y0 + 0.5 * frame_.course) continue;  // not at its foot
      depth = std::max(depth, box.y1 - spandrel.y0);
    }
    for (const SolidBody& body : model_.solids.bodies)
      if (spandrel.holds(0.5 * (body.x0 + body.x1), 0.5 * (body.y0 + body.y1)))
        depth = std::max(depth, body.y1 - spandrel.y0);
    for (const BlockId body : seen_.bodies) {
      const Box box = hull_of(outlines_of(model_, seen_, body));
      if (spandrel.holds(0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)))
        depth = std::max(depth, box.y1 - spandrel.y0);
    }
    return depth;
  }

  [[nodiscard]] bool is_within(const Box& box, BlockId block) const {
    const Vec3 at = seen_.place(centroid_of(model_, block));
    return seen_.holds(block) && box.holds(at.x, at.y);
  }

  // "left pier", "pier 3", "pier 2 of storey 1"; "left connection of spandrel 2".
  void name_parts() {
    const bool bare = openings_.empty();
    Counter count(parts_.storeys > 1);
    for (Pier& pier : parts_.piers) {
      Message words = count.next(kPier, pier.storey, parts_.piers.size());
      if (bare) words = {"part.wall"};
      if (parts_.piers.size() == 2 && parts_.storeys == 1)
        words = {&pier == parts_.piers.data() ? "part.left_pier" : "part.right_pier"};
      name(pier, words, "P");
      name(parts_.toes[pier.left],
           {bare ? "part.left_toe_of_wall" : "part.left_toe", {{"pier", words}}}, "T");
      name(parts_.toes[pier.right],
           {bare ? "part.right_toe_of_wall" : "part.right_toe", {{"pier", words}}}, "T");
    }
    for (Part& node : parts_.nodes)
      name(node, count.next(kNode, node.storey, parts_.nodes.size()), "N");
    const auto is_sill = [](const Spandrel& s) { return s.is_sill; };
    const std::size_t sills =
        std::count_if(parts_.spandrels.begin(), parts_.spandrels.end(), is_sill);
    const std::size_t above = parts_.spandrels.size() - sills;
    for (Spandrel& s : parts_.spandrels) {
      const Message words =
          s.is_sill ? count.next(kSill, s.storey, sills) : count.next(kSpandrel, s.storey, above);
      name(s, words, s.is_sill ? "B" : "S");
      const auto connect = [&](int at, const char* alone, const char* of) {
        if (at < 0) return;
        name(parts_.connections[at],
             above == 1 ? Message{alone} : Message{of, {{"spandrel", words}}}, "C");
      };
      connect(s.left, "part.left_connection", "part.left_connection_of");
      connect(s.right, "part.right_connection", "part.right_connection_of");
    }
  }

  // Numbers the parts of a kind, from 1 in each storey; a single one gets no number.
  class Counter {
   public:
    explicit Counter(bool by_storey) : by_storey_(by_storey) {}
    Message next(const Called& called, int storey, std::size_t all) {
      const int number = ++count_[{called.alone, by_storey_ ? storey : 0}];
      if (all == 1) return {called.alone};
      if (!by_storey_) return {called.number, {{"number", number}}};
      return {called.of_storey, {{"number", number}, {"storey", storey}}};
    }

   private:
    bool by_storey_;
    std::map<std::pair<std::string_view, int>, int> count_;
  };

  void name(Part& part, const Message& words, const std::string& letter) {
    part.elevation = elevation_;
    part.name = called(seen_.wall.empty()
                           ? words
                           : Message{"part.of_wall", {{"wall", seen_.wall}, {"part", words}}});
    part.mark = letter + std::to_string(++marks_[letter]);
  }

  std::string called(const Message& words) {
    std::string name = text_of(words);
    parts_.words[name] = words;
    return name;
  }

  const Model& model_;
  const Elevation& seen_;
  Frame frame_;
  std::vector<Opening> openings_;
  std::vector<Row> rows_;  // upwards
  int elevation_;
  std::map<std::string, int>& marks_;
  WallParts parts_;
};

}  // namespace

std::vector<WallParts> find_parts(const Model& model, const std::vector<Elevation>& elevations) {
  std::map<std::string, int> marks;
  std::vector<WallParts> all;
  for (std::size_t k = 0; k < elevations.size(); ++k)
    all.push_back(Finder(model, elevations[k], static_cast<int>(k), marks).find());
  return all;
}

WallParts find_parts(const Model& model) {
  std::vector<WallParts> each = find_parts(model, elevations_of(model));
  if (each.empty()) return {};
  WallParts all = std::move(each.front());
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  for (std::size_t k = 1; k < each.size(); ++k) {
    WallParts& one = each[k];
    const int toes = static_cast<int>(all.toes.size()),
              connections = static_cast<int>(all.connections.size());
    for (Pier& pier : one.piers) pier.left += toes, pier.right += toes;
    for (Spandrel& s : one.spandrels)
      for (int* side : {&s.left, &s.right})
        if (*side >= 0) *side += connections;
    append(all.piers, one.piers), append(all.spandrels, one.spandrels);
    append(all.connections, one.connections), append(all.toes, one.toes);
    append(all.nodes, one.nodes);
    all.words.merge(one.words);
    all.openings += one.openings;
    all.storeys = std::max(all.storeys, one.storeys);
  }
  return all;
}

std::vector<std::pair<const Part*, const char*>> all_parts(const WallParts& parts) {
  std::vector<std::pair<const Part*, const char*>> all;
  for (const Pier& p : parts.piers) all.emplace_back(&p, "pier");
  for (const Spandrel& s : parts.spandrels) all.emplace_back(&s, s.is_sill ? "sill" : "spandrel");
  for (const Part& p : parts.nodes) all.emplace_back(&p, "node");
  for (const Part& p : parts.connections) all.emplace_back(&p, "connection");
  for (const Part& p : parts.toes) all.emplace_back(&p, "toe");
  return all;
}

std::vector<Box> find_openings(const Model& model) {
  const Elevation plane;
  std::vector<Box> between;
  for (const Opening& o : openings_of(model, plane, frame_of(model, plane)))
    if (!o.at_edge) between.push_back(o);
  return between;
}

}  // namespace wythe::study
