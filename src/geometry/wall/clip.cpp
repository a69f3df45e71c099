// Takes outlines to Clipper's grid of nanometres and back. Each grid line keeps the first coordinate that fell on it.
// Corners within a line or two are merged and holes are dropped. Parts are sorted from left to right.
#include "geometry/wall/clip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <polyclipping/clipper.hpp>

namespace wythe::geometry {
namespace {

namespace clipping = ClipperLib;

constexpr double kGrid =
    1e9;  // lines a metre; the longest wall, 10 km, is far from its largest number

// To the grid and back, to the bits of the coordinates that went there.
class Grid {
 public:
  clipping::Path put(const Polygon& outline) {
    clipping::Path path;
    for (const Vec2& p : outline) path.emplace_back(put(p.x, x_), put(p.y, y_));
    return path;
  }
  [[nodiscard]] Polygon take(const clipping::Path& path) const {
    Polygon outline;
    for (const clipping::IntPoint& p : path) outline.push_back({take(p.X, x_), take(p.Y, y_)});
    const auto lowest = std::min_element(outline.begin(), outline.end(), [](Vec2 a, Vec2 b) {
      return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    std::rotate(outline.begin(), lowest, outline.end());
    return outline;
  }

 private:
  using Lines = std::map<clipping::cInt, double>;
  static clipping::cInt put(double value, Lines& lines) {
    const clipping::cInt line = std::llround(value * kGrid);
    return lines.emplace(line, value).first->first;
  }
  static double take(clipping::cInt line, const Lines& lines) {
    const auto known = lines.find(line);
    return known != lines.end() ? known->second : static_cast<double>(line) / kGrid;
  }
  Lines x_, y_;
};

std::vector<Polygon> combine(clipping::ClipType what, const Polygon& a, const Polygon& b) {
  Grid grid;
  clipping::Clipper clipper;
  clipper.AddPath(grid.put(a), clipping::ptSubject, true);
  clipper.AddPath(grid.put(b), clipping::ptClip, true);
  clipping::Paths found;
  clipper.Execute(what, found, clipping::pftNonZero, clipping::pftNonZero);
  clipping::CleanPolygons(
      found);  // corners within a line or two of the grid, or in line with their neighbours
  std::vector<Polygon> outlines;
  for (const clipping::Path& path : found)
    if (path.size() >= 3 && clipping::Orientation(path)) outlines.push_back(grid.take(path));
  std::sort(outlines.begin(), outlines.end(), [](const Polygon& p, const Polygon& q) {
    return p.front().x != q.front().x ? p.front().x < q.front().x : p.front().y < q.front().y;
  });
  return outlines;
}

}  // namespace

std::vector<Polygon> difference(const Polygon& outline, const Polygon& without) {
  return combine(clipping::ctDifference, outline, without);
}

Polygon joined_outline(const Polygon& a, const Polygon& b) {
  const std::vector<Polygon> whole = combine(clipping::ctUnion, a, b);
  return whole.size() == 1 ? whole.front() : Polygon{};
}

}  // namespace wythe::geometry
