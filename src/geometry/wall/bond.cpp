// Repeats the cycle of units that the bond has in odd and even courses, from a start at or before the wall's left end.
// Places on the grid of half columns get the bits of the grid, so that aligned joints of different courses are equal.
// Units are clipped to the wall and divided at their crack planes. Openings are cut last.
#include "geometry/wall/bond.h"

#include <algorithm>
#include <cmath>

#include "core/to_int.h"

namespace wythe::geometry {
namespace {

// A course repeats this cycle of units from `start`, at or before the wall's left end.
struct Cycle {
  double start = 0;                // [m]
  std::vector<double> unit;        // lengths [m]
  std::vector<bool> is_stretcher;  // only these have a crack plane in the middle
};

Cycle stretchers(const Lattice& lattice, double start) {
  return {start, {lattice.stretcher}, {true}};
}

Cycle headers(const Lattice& lattice, double start) { return {start, {lattice.header}, {false}}; }

// Each header is centred on the stretcher below: its left end is (stretcher - header) / 2 away.
Cycle flemish(const Lattice& lattice, bool is_odd) {
  const double shift = (lattice.stretcher - lattice.header) / 2 - lattice.stretcher;
  return {is_odd ? shift - lattice.header : 0,
          is_odd ? std::vector<double>{lattice.header, lattice.stretcher}
                 : std::vector<double>{lattice.stretcher, lattice.header},
          is_odd ? std::vector<bool>{false, true} : std::vector<bool>{true, false}};
}

Cycle cycle_of(const Lattice& lattice, Bond bond, int course) {
  const bool is_odd = course % 2 == 1;
  switch (bond) {
    case Bond::kRunning: return stretchers(lattice, is_odd ? -lattice.stretcher / 2 : 0);
    case Bond::kStack: return stretchers(lattice, 0);
    case Bond::kEnglish:
      return is_odd ? headers(lattice, -lattice.header / 2) : stretchers(lattice, 0);
    case Bond::kHeader: return headers(lattice, is_odd ? -lattice.header / 2 : 0);
    case Bond::kFlemish: return flemish(lattice, is_odd);
  }
  return {};
}

// Moves x to the half-column grid where it lies on it, so that equal places have equal bits in every course.
double settle_on_grid(const Axis& columns, double x) {
  const double line = columns.half_line(to_int(std::round(2 * x / columns.step)));
  return std::abs(line - x) < 1e-9 * columns.extent ? line : x;
}

// Adds one unit, whole or divided at its crack planes, clipped to the wall. Planes lie inside the
// wall; the pieces are named a, b, c.
void add_unit(const Piece& unit, const std::vector<double>& planes, const Axis& columns,
              std::vector<Piece>& course) {
  const double margin = 1e-9 * columns.extent;
  const double x0 = std::max(0.0, unit.x0), x1 = std::min(columns.extent, unit.x1);
  if (x1 - x0 < margin) return;
  std::vector<double> ends{x0};
  for (const double plane : planes)
    if (plane > margin && plane < columns.extent - margin) ends.push_back(plane);
  ends.push_back(x1);
  const bool is_whole = ends.size() == 2;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    course.push_back({ends[k], ends[k + 1], unit.unit,
                      is_whole ? ' ' : static_cast<char>('a' + static_cast<int>(k))});
}

// A unit of a course as the cycle gives it; it may extend beyond the wall.
struct Unit {
  double x0, x1;
  bool is_stretcher;
};
std::vector<Unit> units_of(const Storey& storey, int course) {
  const Cycle cycle = cycle_of(storey.lattice, storey.bond, course);
  const Axis& columns = storey.lattice.columns;
  std::vector<Unit> units;
  double x = cycle.start;
  for (std::size_t k = 0; x < columns.extent * (1 - 1e-9); k = (k + 1) % cycle.unit.size()) {
    const double next = settle_on_grid(columns, x + cycle.unit[k]);
    units.push_back({x, next, cycle.is_stretcher[k]});
    x = next;
  }
  return units;
}

// Crack planes of a unit: in its middle, or in line with head joints above and below except those
// within a tenth of its own ends (courses repeat in pairs, so the next one equals the one before).
std::vector<double> planes_of(const Unit& unit, const std::vector<Unit>& next, Split split,
                              const Axis& columns) {
  if (split == Split::kNone) return {};
  if (split == Split::kMiddle)
    return unit.is_stretcher ? std::vector{settle_on_grid(columns, (unit.x0 + unit.x1) / 2)}
                             : std::vector<double>{};
  std::vector<double> planes;
  const double end = 0.1 * (unit.x1 - unit.x0);
  for (const Unit& other : next)
    if (other.x0 > unit.x0 + end && other.x0 < unit.x1 - end) planes.push_back(other.x0);
  return planes;
}

Piece clip(Piece piece, double x0, double x1) {
  piece.x0 = std::max(piece.x0, x0);
  piece.x1 = std::min(piece.x1, x1);
  return piece;
}

double width(const Piece& piece) { return piece.x1 - piece.x0; }

// Neighbour that absorbs the short piece `i` of a run of at least two.
std::size_t neighbour_for(const std::vector<Piece>& run, std::size_t i) {
  if (i == 0) return 1;
  if (i + 1 == run.size()) return i - 1;
  if (run[i + 1].unit == run[i].unit) return i + 1;
  if (run[i - 1].unit == run[i].unit) return i - 1;
  return width(run[i + 1]) < width(run[i - 1]) ? i + 1 : i - 1;
}

void join_piece(std::vector<Piece>& run, std::size_t i) {
  Piece& host = run[neighbour_for(run, i)];
  host.x0 = std::min(host.x0, run[i].x0);
  host.x1 = std::max(host.x1, run[i].x1);
  run.erase(run.begin() + static_cast<std::ptrdiff_t>(i));
}

}  // namespace

std::vector<Piece> lay_course(const Storey& storey, int course) {
  const Axis& columns = storey.lattice.columns;
  const std::vector<Unit> next = units_of(storey, course + 1);
  std::vector<Piece> pieces;
  int number = 0;
  for (const Unit& unit : units_of(storey, course)) {
    const std::size_t before = pieces.size();
    add_unit({unit.x0, unit.x1, number, ' '}, planes_of(unit, next, storey.unit.split, columns),
             columns, pieces);
    number += pieces.size() > before;
  }
  return pieces;
}

std::vector<Piece> cut_pieces(const std::vector<Piece>& course, double x0, double x1,
                              double shortest, int& joined) {
  std::vector<Piece> run;
  for (const Piece& piece : course) {
    const Piece kept = clip(piece, x0, x1);
    if (width(kept) > 1e-9 * (1 + std::abs(x1))) run.push_back(kept);
  }
  const auto is_short = [&](const Piece& p) { return width(p) < shortest * (1 - 1e-6); };
  for (auto it = run.begin(); run.size() > 1 && it != run.end();) {
    it = std::find_if(run.begin(), run.end(), is_short);
    if (it == run.end()) break;
    join_piece(run, static_cast<std::size_t>(it - run.begin()));
    it = run.begin();
    ++joined;
  }
  return run;
}

}  // namespace wythe::geometry
