#include "geometry/openings.h"

#include <algorithm>
#include <cmath>

#include "geometry/lintel.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

// One direction of one opening.
struct Span {
  int opening;
  std::string start_key, size_key;  // "x", "width"
  double start, size;               // as stated [m]
};

bool is_given(const OpeningSpec& opening, int i, FaultList& faults) {
  bool given = is_not_negative({opening_path(i, "x"), opening.x, "m", "1.70 m"}, faults);
  given &= is_not_negative({opening_path(i, "y"), opening.y, "m", "0 m"}, faults);
  given &= is_positive({opening_path(i, "width"), opening.width, "m", "1.70 m"}, faults);
  given &= is_positive({opening_path(i, "height"), opening.height, "m", "2.64 m"}, faults);
  return given;
}

bool is_inside(const Span& span, const Axis& axis, const std::string& extent_key,
               FaultList& faults) {
  const double end = span.start + span.size;
  if (end <= axis.extent + kFitTolerance * span.size) return true;
  add_fault(
      faults, opening_path(span.opening, span.size_key), metres(span.size),
      "the opening ends at " + metres(end) + ", outside the wall (wall." + extent_key + " = " +
          metres(axis.extent) + ")",
      span.start_key + " + " + span.size_key + " must be " + metres(axis.extent) + " or less");
  return false;
}

// How far an edge may move to the nearest line: 2 % of the opening, and with fit = "cut" upright
// edges not at all beyond that, while level edges move up to a sliver (no thin strips of units).
double reach_of(const Span& span, const Axis& axis, Fit fit) {
  const double reach = kFitTolerance * span.size;
  const bool is_level = span.start_key == "y";
  return fit == Fit::kCut && is_level ? std::max(reach, kSliver * axis.step) : reach;
}

struct SnapAsk {
  std::string key;  // of the fault
  double edge;      // stated [m]
  double origin;    // 0 for a position, the opening's start for a size
  double stated;    // value of the key
};

bool snap_edge(const Span& span, const Axis& axis, Fit fit, const SnapAsk& ask, double& edge,
               FaultList& faults) {
  const double line = axis.line(axis.nearest(ask.edge));
  edge = ask.edge;
  if (std::abs(line - ask.edge) <= reach_of(span, axis, fit) + 1e-9) edge = line;
  if (edge == line || fit == Fit::kCut) return true;
  const int below = line <= ask.edge ? axis.nearest(ask.edge) : axis.nearest(ask.edge) - 1;
  std::string sizes = metres(axis.line(below + 1) - ask.origin);
  if (axis.line(below) > ask.origin || ask.origin == 0) {
    sizes = metres(axis.line(below) - ask.origin) + " or " + sizes;
  }
  add_fault(faults, opening_path(span.opening, ask.key), metres(ask.stated),
            "the edge at " + metres(ask.edge) + " lies " + millimetres(std::abs(line - ask.edge)) +
                " from the nearest joint line, more than 2 %"
                " of the opening's " +
                span.size_key,
            ask.key + " = " + sizes + " fits the units of " + millimetres(axis.step) +
                "; or wall.fit = \"cut\"");
  return false;
}

void note_move(const Span& span, const std::string& key, double from, double to,
               std::vector<std::string>& notes) {
  if (std::abs(to - from) < 1e-9) return;
  notes.push_back("opening " + std::to_string(span.opening) + " " + key + " " + metres(from) +
                  " -> " + metres(to));
}

// Both edges of one direction; false after a fault.
bool snap_span(const Span& span, const Axis& axis, Fit fit, double& start, double& end,
               std::vector<std::string>& notes, FaultList& faults) {
  const double stated_end = span.start + span.size;
  bool fits =
      snap_edge(span, axis, fit, {span.start_key, span.start, 0, span.start}, start, faults);
  fits &= snap_edge(span, axis, fit, {span.size_key, stated_end, start, span.size}, end, faults);
  if (!fits) return false;
  end = std::min(end, axis.extent);
  if (end - start < kSliver * axis.step) {
    add_fault(faults, opening_path(span.opening, span.size_key), metres(span.size),
              "smaller than a quarter of a unit", "make it larger or leave the opening out");
    return false;
  }
  note_move(span, span.start_key, span.start, start, notes);
  note_move(span, span.size_key, span.size, end - start, notes);
  return true;
}

bool place_hole(const OpeningSpec& opening, int i, const Lattice& lattice, Fit fit, Rect& hole,
                std::vector<std::string>& notes, FaultList& faults) {
  if (!is_given(opening, i, faults) || lattice.columns.count == 0 || lattice.courses.count == 0) {
    return false;
  }
  const Span level{i, "x", "width", opening.x, opening.width};
  const Span upright{i, "y", "height", opening.y, opening.height};
  bool inside = is_inside(level, lattice.columns, "length", faults);
  inside &= is_inside(upright, lattice.courses, "height", faults);
  if (!inside) return false;
  bool fits = snap_span(level, lattice.columns, fit, hole.x0, hole.x1, notes, faults);
  fits &= snap_span(upright, lattice.courses, fit, hole.y0, hole.y1, notes, faults);
  return fits;
}

std::string number_of(const PlacedOpening& opening) { return std::to_string(opening.index); }

void refuse_overlap(const PlacedOpening& a, const PlacedOpening& b, FaultList& faults) {
  if (!overlaps(a.hole, b.hole, 1e-9)) return;
  add_fault(faults, opening_path(b.index, "x"), metres(b.hole.x0),
            "opening " + number_of(b) + " overlaps opening " + number_of(a),
            "move or shrink one of them, or make them one opening");
}

void refuse_lintel_in_opening(const PlacedOpening& a, const PlacedOpening& b, FaultList& faults) {
  if (a.segment.empty() || a.index == b.index) return;
  const Rect lintel = join(a.segment.front(), a.segment.back());
  const bool meets_lintel = !b.segment.empty() && a.index < b.index &&
                            overlaps(lintel, join(b.segment.front(), b.segment.back()), 1e-9);
  if (!overlaps(lintel, b.hole, 1e-9) && !meets_lintel) return;
  add_fault(faults, opening_path(a.index, "lintel.bearing"), "",
            std::string("the lintel reaches into ") +
                (meets_lintel ? "the lintel of opening " : "opening ") + number_of(b),
            "shorten the bearing or move the opening");
}

void check_pairs(const std::vector<PlacedOpening>& openings, FaultList& faults) {
  for (std::size_t i = 0; i < openings.size(); ++i) {
    for (std::size_t j = 0; j < openings.size(); ++j) {
      if (i < j) refuse_overlap(openings[i], openings[j], faults);
      refuse_lintel_in_opening(openings[i], openings[j], faults);
    }
  }
}

void note_bare_head(const PlacedOpening& opening, double height, std::vector<std::string>& notes) {
  if (!opening.segment.empty() || opening.hole.y1 > height - 1e-9) return;
  notes.push_back("opening " + number_of(opening) +
                  " has no lintel: the masonry above it hangs on its joints");
}

struct Interval {
  double x0, x1;
};

std::vector<Interval> union_of(const std::vector<PlacedOpening>& openings) {
  std::vector<Interval> intervals, merged;
  for (const PlacedOpening& o : openings) intervals.push_back({o.hole.x0, o.hole.x1});
  std::sort(intervals.begin(), intervals.end(), [](auto a, auto b) { return a.x0 < b.x0; });
  for (const Interval& next : intervals) {
    if (merged.empty() || next.x0 > merged.back().x1 + 1e-9) merged.push_back(next);
    merged.back().x1 = std::max(merged.back().x1, next.x1);
  }
  return merged;
}

double lower_adjacent_top(const std::vector<PlacedOpening>& openings, double x0, double x1,
                          double height) {
  double top = height;
  for (const PlacedOpening& o : openings) {
    const bool is_adjacent = std::abs(o.hole.x1 - x0) < 1e-9 || std::abs(o.hole.x0 - x1) < 1e-9;
    if (is_adjacent) top = std::min(top, o.hole.y1);
  }
  return top;
}

}  // namespace

std::vector<PlacedOpening> place_openings(const ModelSpec& spec, const Lattice& lattice,
                                          std::vector<std::string>& notes, FaultList& faults) {
  std::vector<PlacedOpening> placed;
  for (std::size_t k = 0; k < spec.wall.opening.size(); ++k) {
    const OpeningSpec& opening = spec.wall.opening[k];
    const int i = static_cast<int>(k);
    const bool lintel_is_given = check_lintel(spec, i, faults);
    PlacedOpening result{.index = i, .hole = {}, .segment = {}};
    if (!place_hole(opening, i, lattice, spec.wall.fit, result.hole, notes, faults)) continue;
    if (lintel_is_given) place_lintel(opening.lintel, lattice, result, notes, faults);
    if (opening.lintel.kind.empty()) note_bare_head(result, spec.wall.height, notes);
    placed.push_back(result);
  }
  check_pairs(placed, faults);
  return placed;
}

std::vector<Pier> find_piers(const std::vector<PlacedOpening>& openings, double length,
                             double height) {
  std::vector<Interval> gaps = union_of(openings);
  gaps.push_back({length, length});
  std::vector<Pier> piers;
  double x0 = 0;
  for (const Interval& gap : gaps) {
    if (gap.x0 - x0 > 1e-9) {
      piers.push_back({x0, gap.x0, lower_adjacent_top(openings, x0, gap.x0, height)});
    }
    x0 = gap.x1;
  }
  return piers;
}

}  // namespace wythe::geometry
