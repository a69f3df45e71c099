// Converts outlines to a grid of nanometres and back. Each grid line keeps the first coordinate that fell on it.
// Corners within a grid line or two are merged, holes are dropped, and parts are sorted from left to right.
#include "geometry/wall/clip.h"

// Boost's own grid multiplies in 64 bits, which overflow for a span of 20 m and a stone of 0.5 m; doubles do not.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost includes such headers itself
#include <algorithm>
#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/difference.hpp>
#include <boost/geometry/algorithms/union.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>

namespace wythe::geometry {
namespace {

namespace bg = boost::geometry;

constexpr double kGrid = 1e9;  // lines per metre; the longest wall, 10 km, is far from 2^53 lines
constexpr double kRounded = 1.5;  // lines: largest distance after rounding on both sides

using Point = bg::model::d2::point_xy<double>;  // in grid lines, integers
using Outline = bg::model::polygon<Point, false, false>;
using Corners = std::vector<Vec2>;  // also in grid lines

// Converts to the grid and back, to the bits of the first coordinate on each line.
class Grid {
 public:
  Outline put(const Polygon& polygon) {
    Outline outline;
    for (const Vec2& p : polygon) outline.outer().emplace_back(put(p.x, x_), put(p.y, y_));
    bg::correct(outline);
    return outline;
  }
  [[nodiscard]] Polygon take(const Corners& corners) const {
    Polygon polygon;
    for (const Vec2& p : corners) polygon.push_back({take(p.x, x_), take(p.y, y_)});
    const auto lowest = std::min_element(polygon.begin(), polygon.end(), [](Vec2 a, Vec2 b) {
      return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    std::rotate(polygon.begin(), lowest, polygon.end());
    return polygon;
  }

 private:
  using Lines = std::map<double, double>;
  static double put(double value, Lines& lines) {
    const double line = std::round(value * kGrid);
    lines.emplace(line, value);
    return line;
  }
  static double take(double line, const Lines& lines) {
    const auto known = lines.find(line);
    return known != lines.end() ? known->second : line / kGrid;
  }
  Lines x_, y_;
};

// Whether p is no corner between a and b: it lies between them, or the outline goes there and back.
bool is_no_corner(Vec2 a, Vec2 p, Vec2 b) {
  const Vec2 way = b - a, to = p - a;
  const double size = length(way);
  if (size <= kRounded || length(to) <= kRounded) return true;
  const bool is_between = dot(to, way) >= 0 && dot(to, way) <= size * size;
  return is_between && std::fabs(cross(way, to)) <= kRounded * size;
}

Corners corners_of(const Outline& outline) {
  Corners corners;
  for (const Point& p : outline.outer()) corners.push_back({std::round(p.x()), std::round(p.y())});
  for (;;) {  // a removed corner's neighbour may be none either
    const std::size_t n = corners.size();
    std::size_t k = 0;
    while (k < n && !is_no_corner(corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n])) ++k;
    if (k == n) return corners;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

template <class Operation>
std::vector<Polygon> combine(const Polygon& a, const Polygon& b, const Operation& operation) {
  Grid grid;
  const Outline first = grid.put(a), second = grid.put(b);
  std::vector<Outline> found;
  operation(first, second, found);
  std::vector<Polygon> polygons;
  for (const Outline& outline : found)
    if (const Corners corners = corners_of(outline); corners.size() >= 3)
      polygons.push_back(grid.take(corners));
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& p, const Polygon& q) {
    return p.front().x != q.front().x ? p.front().x < q.front().x : p.front().y < q.front().y;
  });
  return polygons;
}

}  // namespace

std::vector<Polygon> difference(const Polygon& outline, const Polygon& without) {
  return combine(outline, without, [](const Outline& a, const Outline& b, auto& found) {
    bg::difference(a, b, found);
  });
}

Polygon joined_outline(const Polygon& a, const Polygon& b) {
  const std::vector<Polygon> whole =
      combine(a, b, [](const Outline& p, const Outline& q, auto& found) {
        bg::union_(p, q, found);
        std::erase_if(found, [](const Outline& outline) { return !outline.inners().empty(); });
      });
  return whole.size() == 1 ? whole.front() : Polygon{};
}

}  // namespace wythe::geometry
