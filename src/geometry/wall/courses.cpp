// Finds the solid runs of each course and lays the pieces of its bond in them. A band is divided at the sides of all
// holes that reach into it. Adjacent strips of equal height form one run, so that no joint arises there. Where units may
// split, units are numbered through the whole wall; pieces of one number are one unit.
#include "geometry/wall/courses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace wythe::geometry {
namespace {

constexpr double kMargin = 1e-9;  // closer coordinates are equal [m]

// Rectangles of the band y0..y1 that the holes over x0..x1 leave solid, from the bottom up.
std::vector<Rect> solid_parts(const Rect& strip, std::vector<Rect> holes) {
  std::sort(holes.begin(), holes.end(), [](const Rect& a, const Rect& b) { return a.y0 < b.y0; });
  std::vector<Rect> parts;
  double bottom = strip.y0;
  for (const Rect& hole : holes) {
    if (!overlaps(strip, hole, kMargin)) continue;
    if (hole.y0 - bottom > kMargin) parts.push_back({strip.x0, bottom, strip.x1, hole.y0});
    bottom = std::max(bottom, hole.y1);
  }
  if (strip.y1 - bottom > kMargin) parts.push_back({strip.x0, bottom, strip.x1, strip.y1});
  return parts;
}

std::vector<double> breaks_along(const Rect& band, const std::vector<Rect>& holes) {
  std::vector<double> x{band.x0, band.x1};
  for (const Rect& hole : holes) {
    if (!overlaps(band, hole, kMargin)) continue;
    x.push_back(hole.x0);
    x.push_back(hole.x1);
  }
  std::sort(x.begin(), x.end());
  const auto near = [](double a, double b) { return b - a < kMargin; };
  x.erase(std::unique(x.begin(), x.end(), near), x.end());
  return x;
}

bool continues(const Rect& run, const Rect& next) {
  return std::abs(run.x1 - next.x0) < kMargin && run.y0 == next.y0 && run.y1 == next.y1;
}

// The solid runs of one course, from left to right.
std::vector<Rect> solid_runs(const Rect& band, const std::vector<Rect>& holes) {
  std::vector<Rect> runs;
  const std::vector<double> x = breaks_along(band, holes);
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    for (const Rect& part : solid_parts({x[k], band.y0, x[k + 1], band.y1}, holes)) {
      const auto before = std::find_if(runs.begin(), runs.end(),
                                       [&](const Rect& run) { return continues(run, part); });
      if (before == runs.end())
        runs.push_back(part);
      else
        before->x1 = part.x1;
    }
  }
  return runs;
}

std::string name_of(int course, const Piece& piece, std::set<std::string>& used) {
  const std::string text = fmt::format("c{:02d}u{:02d}", course, piece.unit);
  std::string id = text;
  if (piece.half != ' ') id += piece.half;
  // an opening can leave two pieces of a unit that is not split in its middle
  for (char letter = 'c'; !used.insert(id).second; ++letter) id = text + letter;
  return id;
}

struct CourseSite {
  const Storey& storey;
  int course;
  int first_unit;  // number of the first unit of the course
};

Block block_of(const CourseSite& site, const Piece& piece, const Rect& run,
               std::set<std::string>& used) {
  Block block;
  block.id = name_of(site.course, piece, used);
  block.outline = outline_of({piece.x0, run.y0, piece.x1, run.y1});
  block.material = "masonry";
  block.thickness = site.storey.thickness;
  block.course = site.course;
  block.storey = site.storey.index;
  block.unit = site.storey.unit.split != Split::kNone ? site.first_unit + piece.unit : -1;
  return block;
}

// `first_unit` is the number of the storey's first unit; afterwards that of the next storey's.
void lay_storey(const Storey& storey, const std::vector<Rect>& holes, int& first_unit,
                Masonry& masonry) {
  const Axis &columns = storey.lattice.columns, &courses = storey.lattice.courses;
  const double shortest = kSliver * columns.step;
  for (int row = 0; row < courses.count; ++row) {
    const int course = storey.first_course + row;
    const std::vector<Piece> laid = lay_course(storey, course);
    const Rect band{0, courses.line(row), columns.extent, courses.line(row + 1)};
    std::set<std::string> used;
    for (const Rect& run : solid_runs(band, holes)) {
      for (const Piece& piece : cut_pieces(laid, run.x0, run.x1, shortest, masonry.joined_pieces)) {
        masonry.blocks.push_back(block_of({storey, course, first_unit}, piece, run, used));
      }
    }
    first_unit += laid.back().unit + 1;
  }
}

}  // namespace

Masonry lay_masonry(const std::vector<Storey>& storeys, const std::vector<Rect>& holes) {
  Masonry masonry;
  int first_unit = 0;
  for (const Storey& storey : storeys) lay_storey(storey, holes, first_unit, masonry);
  return masonry;
}

}  // namespace wythe::geometry
