// Compares the edges of near blocks in pairs. The ends of a contact are corners of its blocks, never new points, so
// neighbours share their bits. A pair of blocks may lie in several cells; it counts in the cell where the overlap of its
// boxes begins. Contacts are sorted by height and place, so their order does not depend on the search.
#include "geometry/wall/joints.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace wythe::geometry {
namespace {

struct Edge {
  Vec2 start, end;
};

Edge edge_of(const Polygon& outline, std::size_t i) {
  return {outline[i], outline[(i + 1) % outline.size()]};
}

Rect widen(const Rect& r, double by) { return {r.x0 - by, r.y0 - by, r.x1 + by, r.y1 + by}; }

bool meet(const Rect& a, const Rect& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

std::vector<Rect> bounds_of(const std::vector<Block>& blocks, double margin) {
  std::vector<Rect> boxes;
  boxes.reserve(blocks.size());
  for (const Block& block : blocks) boxes.push_back(widen(bounds(block.outline), margin));
  return boxes;
}

Rect join_all(const std::vector<Rect>& boxes) {
  Rect whole = boxes.front();
  for (const Rect& box : boxes) whole = join(whole, box);
  return whole;
}

// Square cells over the assembly, about one for each block; each block is listed in every cell it touches.
struct CellGrid {
  Rect whole;
  double cell = 1;  // side [m]
  int columns = 1;
  [[nodiscard]] int column(double x) const { return static_cast<int>((x - whole.x0) / cell); }
  [[nodiscard]] int row(double y) const { return static_cast<int>((y - whole.y0) / cell); }
  [[nodiscard]] int number(int row_index, int column_index) const {
    return row_index * columns + column_index;
  }
};

CellGrid make_grid(const std::vector<Rect>& boxes) {
  CellGrid grid;
  grid.whole = join_all(boxes);
  const double width = grid.whole.x1 - grid.whole.x0, height = grid.whole.y1 - grid.whole.y0;
  const double n = static_cast<double>(boxes.size());
  grid.cell = std::max(std::sqrt(width * height / n), std::max(width, height) / (4 * n + 1));
  // large blocks that overlap would fill every cell, so cells are made wider then
  const auto cells_of = [&](const Rect& box) {
    return (std::floor((box.x1 - box.x0) / grid.cell) + 2) *
           (std::floor((box.y1 - box.y0) / grid.cell) + 2);
  };
  const auto entries = [&] {
    double sum = 0;
    for (const Rect& box : boxes) sum += cells_of(box);
    return sum;
  };
  constexpr double kEntriesPerBlock = 64;
  while (grid.cell < std::max(width, height) && entries() > kEntriesPerBlock * n) grid.cell *= 2;
  grid.columns = grid.column(grid.whole.x1) + 1;
  return grid;
}

struct Entry {
  int cell, block;
};

std::vector<Entry> fill_cells(const CellGrid& grid, const std::vector<Rect>& boxes) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Rect& box = boxes[i];
    for (int r = grid.row(box.y0); r <= grid.row(box.y1); ++r) {
      for (int c = grid.column(box.x0); c <= grid.column(box.x1); ++c) {
        entries.push_back({grid.number(r, c), static_cast<int>(i)});
      }
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell, a.block) < std::tie(b.cell, b.block);
  });
  return entries;
}

// The cell in which a pair counts: the one with the lower left corner of the overlap of its boxes.
int home_cell(const CellGrid& grid, const Rect& a, const Rect& b) {
  return grid.number(grid.row(std::max(a.y0, b.y0)), grid.column(std::max(a.x0, b.x0)));
}

double along(const Edge& edge, Vec2 p) {
  const Vec2 t = edge.end - edge.start;
  return dot(p - edge.start, t) / length(t);
}

double aside(const Edge& edge, Vec2 p) {
  const Vec2 t = edge.end - edge.start;
  return cross(t, p - edge.start) / length(t);
}

double edge_length(const Edge& edge) { return length(edge.end - edge.start); }

bool is_anti_parallel(const Edge& e, const Edge& f) {
  return dot(e.end - e.start, f.end - f.start) < -0.99 * edge_length(e) * edge_length(f);
}

// The common part of two facing edges; its ends are existing corners.
struct Overlap {
  Vec2 from, to;  // along e
  double size;    // [m]
  double gap;     // [m]
};

Overlap overlap_of(const Edge& e, const Edge& f) {
  const double first = along(e, f.end), last = along(e, f.start), whole = edge_length(e);
  Overlap overlap;
  overlap.from = first > 0 ? f.end : e.start;
  overlap.to = last < whole ? f.start : e.end;
  overlap.size = std::min(last, whole) - std::max(first, 0.0);
  // each end is a corner of one edge; the gap is its distance from the line of the other edge
  const double gap_from = first > 0 ? aside(e, f.end) : aside(f, e.start);
  const double gap_to = last < whole ? aside(e, f.start) : aside(f, e.end);
  overlap.gap = std::max(std::abs(gap_from), std::abs(gap_to));
  return overlap;
}

// Side a is the lower block, or the left one where the normal is level. Outlines are anticlockwise, so
// the outward normal of e lies on its right; for e reversed it lies on its left.
Contact make_contact(int i, int j, const Overlap& overlap) {
  const Vec2 t = overlap.to - overlap.from;
  const Vec2 normal{t.y, -t.x};  // out of i
  const double level = 1e-6 * length(t);
  const bool i_first = normal.y > level || (std::abs(normal.y) <= level && normal.x > 0);
  if (i_first) return {i, j, overlap.to, overlap.from};
  return {j, i, overlap.from, overlap.to};
}

struct PairSearch {
  const std::vector<Block>& blocks;
  double tolerance;
  ContactSearch& found;
};

void test_edges(const PairSearch& search, int i, int j, const Edge& e, const Edge& f) {
  if (!is_anti_parallel(e, f)) return;
  const Overlap overlap = overlap_of(e, f);
  const double shorter = std::min(edge_length(e), edge_length(f));
  if (overlap.size <= search.tolerance || overlap.gap > kWidestGap * shorter) return;
  if (overlap.gap > search.tolerance) {
    search.found.lost.push_back({i, j, overlap.size, overlap.gap});
  } else if (overlap.size < kShortestContact * shorter) {
    search.found.lost.push_back({i, j, overlap.size, 0});
  } else {
    search.found.contacts.push_back(make_contact(i, j, overlap));
  }
}

void test_pair(const PairSearch& search, int i, int j) {
  const Polygon& a = search.blocks[i].outline;
  const Polygon& b = search.blocks[j].outline;
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t m = 0; m < b.size(); ++m) {
      test_edges(search, i, j, edge_of(a, k), edge_of(b, m));
    }
  }
}

// Gaps up to kWidestGap of an edge matter, so the longest edge determines the search distance.
double search_margin(const std::vector<Block>& blocks, double tolerance) {
  double largest = 0;
  for (const Block& block : blocks) {
    const Rect box = bounds(block.outline);
    largest = std::max({largest, box.x1 - box.x0, box.y1 - box.y0});
  }
  return std::max(tolerance, kWidestGap * largest / 2);
}

}  // namespace

double contact_tolerance(const std::vector<Block>& blocks) {
  if (blocks.empty()) return 0;
  const Rect whole = join_all(bounds_of(blocks, 0));
  return kContactTolerance * std::max(whole.x1 - whole.x0, whole.y1 - whole.y0);
}

std::vector<std::pair<int, int>> near_pairs(const std::vector<Block>& blocks, double margin,
                                            std::size_t most) {
  std::vector<std::pair<int, int>> pairs;
  if (blocks.empty()) return pairs;
  const std::vector<Rect> boxes = bounds_of(blocks, margin);
  const CellGrid grid = make_grid(boxes);
  const std::vector<Entry> entries = fill_cells(grid, boxes);
  const auto is_fixed = [&](const Entry& entry) {
    return blocks[entry.block].role == Role::kSupport;
  };
  // index of the next movable entry: pairs of two supports are skipped altogether
  std::vector<std::size_t> next_free(entries.size() + 1, entries.size());
  for (std::size_t k = entries.size(); k-- > 0;)
    next_free[k] = is_fixed(entries[k]) ? next_free[k + 1] : k;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Rect& a = boxes[entries[k].block];
    const auto next = [&](std::size_t m) { return is_fixed(entries[k]) ? next_free[m] : m; };
    for (std::size_t m = next(k + 1); m < entries.size() && entries[m].cell == entries[k].cell;
         m = next(m + 1)) {
      const Rect& b = boxes[entries[m].block];
      if (meet(a, b) && home_cell(grid, a, b) == entries[k].cell) {
        pairs.emplace_back(entries[k].block, entries[m].block);
        if (pairs.size() >= most) return pairs;
      }
    }
  }
  return pairs;
}

void sort_contacts(std::vector<Contact>& contacts, double tolerance) {
  const auto key = [&](const Contact& c) {
    const double height = (c.p0.y + c.p1.y) / (4 * std::max(tolerance, 1e-12));
    return std::tuple(std::llround(height), c.p0.x + c.p1.x, c.a, c.b);
  };
  std::sort(contacts.begin(), contacts.end(),
            [&](const Contact& a, const Contact& b) { return key(a) < key(b); });
}

ContactSearch find_contacts(const std::vector<Block>& blocks) {
  ContactSearch found;
  const double tolerance = contact_tolerance(blocks);
  const PairSearch search{blocks, tolerance, found};
  for (const auto& [i, j] : near_pairs(blocks, search_margin(blocks, tolerance))) {
    test_pair(search, i, j);
  }
  sort_contacts(found.contacts, tolerance);
  return found;
}

std::vector<Contact> find_ground_contacts(const std::vector<Block>& blocks, double ground) {
  std::vector<Contact> contacts;
  const double tolerance = contact_tolerance(blocks);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Polygon& outline = blocks[i].outline;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Edge edge = edge_of(outline, k);
      const bool lies_on_ground = std::abs(edge.start.y - ground) <= tolerance &&
                                  std::abs(edge.end.y - ground) <= tolerance;
      if (!lies_on_ground || edge.end.x - edge.start.x <= tolerance) continue;
      contacts.push_back({kGround, static_cast<int>(i), edge.start, edge.end});
    }
  }
  return contacts;
}

}  // namespace wythe::geometry
