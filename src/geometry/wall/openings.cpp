// Places openings one by one: hole, sill, lintel, arch. An edge moves to a joint line within its reach. Beyond that, the
// edge stays where units may be cut; otherwise a fault names the nearest span that fits, and the opening takes that
// span. Pairs of openings are compared at the end.
#include "geometry/wall/openings.h"

#include <algorithm>
#include <cmath>

#include "core/limits.h"
#include "geometry/text.h"
#include "geometry/wall/arches.h"
#include "geometry/wall/lintel.h"

namespace wythe::geometry {
namespace {

// One direction of an opening.
struct Span {
  const PlacedOpening& placed;
  std::string start_key, size_key;  // "x", "width"
  const char *start_moved_code, *size_changed_code;
  double start, size;   // as stated, from the corner of the wall [m]
  double base;          // zero of the user's measure: 0, or foot of the named storey [m]
  std::string outside;  // name of what lies beyond: "outside the wall (wall.length = 5.1 m)"
  std::string fit_key;  // "wall.fit"
};

bool is_given(const OpeningSpec& opening, int i, FaultList& faults) {
  bool given = is_not_negative({opening_path(i, "x"), opening.x, "m", "1.70 m"}, faults);
  given &= is_not_negative({opening_path(i, "y"), opening.y, "m", "0 m"}, faults);
  given &= is_positive({opening_path(i, "width"), opening.width, "m", "1.70 m"}, faults);
  given &= is_positive({opening_path(i, "height"), opening.height, "m", "2.64 m"}, faults);
  return given;
}

// How far an edge may move to the nearest line: by 2 % of the opening or the thickness of a joint. With
// fit = "cut" level edges may move by a sliver as well, which avoids thin strips of units; vertical
// edges may not.
double reach_of(const Span& span, const Axis& axis, Fit fit) {
  const double reach = std::max(kFitTolerance * span.size, axis.joint);
  const bool is_level = span.start_key == "y";
  return fit == Fit::kCut && is_level ? std::max(reach, kSliver * axis.step) : reach;
}

// Range of lines of an axis in which an opening may lie.
struct Room {
  int first, last;
};

std::string floor_line(double height) {
  return "floor line at " + metres(height) +
         ": an opening lies in one storey, so make two of one that goes through";
}

// Why the span can't be laid as stated, with its key; "" where it can.
struct SpanFault {
  std::string key, problem;
  bool cut_cures = false;
};

// Whether at least half of an opening of usual size lies beyond the wall's end: then its place is wrong, and not its size.
bool is_beyond(const Span& span, const Axis& axis) {
  return span.start_key == "x" && span.size <= 0.5 * (axis.end() - axis.origin) &&
         span.start + 0.5 * span.size > axis.end() - 1e-9;
}

SpanFault fault_of(const Span& span, const Axis& axis, Fit fit) {
  const double end = span.start + span.size, reach = reach_of(span, axis, fit);
  const double slack = std::max(kFitTolerance * span.size, axis.joint);
  if (end > axis.end() + slack)
    return {is_beyond(span, axis) ? span.start_key : span.size_key,
            "ends at " + metres(end - span.base) + ", " + span.outside};
  if (span.start < axis.origin - slack)
    return {span.start_key, "begins at " + metres(span.start - span.base) + ", below the " +
                                floor_line(axis.origin - span.base)};
  for (const auto& [key, edge] : {std::pair(span.start_key, span.start), {span.size_key, end}}) {
    const double off = std::abs(axis.line(axis.nearest(edge)) - edge);
    if (fit == Fit::kWhole && off > reach + 1e-9)
      return {key,
              "has an edge at " + metres(edge - span.base) + ", " + millimetres(off) +
                  " from the nearest joint line, more than 2 % of its " + span.size_key,
              true};
  }
  if (end - span.start < kSliver * axis.step)
    return {span.size_key, "is smaller than a quarter of a unit"};
  return {};
}

void note_move(const Span& span, const char* code, double from, double to,
               std::vector<Message>& notes) {
  if (std::abs(to - from) < 1e-9) return;
  const double base = code == span.start_moved_code ? span.base : 0;
  notes.push_back(
      {code, {{"opening", span.placed.words}, {"from_m", from - base}, {"to_m", to - base}}});
}

// Whether the stated height fits where it counts from the ground and not from the storey's foot. An opening that is a little
// too high is not meant so.
bool is_from_ground(const Span& span, const Axis& axis) {
  const double slack = std::max(kFitTolerance * span.size, axis.joint);
  const double start = span.start - span.base;
  const double beyond = span.start + span.size - axis.end();
  return span.base > 0 && beyond > std::max(slack, 0.5 * span.size) &&
         start > axis.origin - slack && start + span.size < axis.end() + slack;
}

// The nearest span within `room`: where units are cut what is left of the stated one, else on joint
// lines. The cure names it, and further checks use it.
void cure_span(const Span& span, const SpanFault& fault, const Axis& axis, Fit fit, Room room,
               double& start, double& end, FaultList& faults) {
  if (room.last <= room.first) room = {0, axis.count};
  const double last = std::max(axis.end() - span.size, axis.origin);
  const double wanted = is_from_ground(span, axis) ? span.start - span.base
                        : is_beyond(span, axis)    ? last
                                                   : span.start;
  start = std::max(wanted, axis.line(room.first));
  end = std::min(wanted + span.size, axis.line(room.last));
  const bool on_lines = fit == Fit::kWhole || end - start < axis.step;
  if (on_lines) {
    const int i = std::clamp(axis.nearest(wanted), room.first, room.last - 1);
    const int j = std::clamp(axis.nearest(axis.line(i) + span.size), i + 1, room.last);
    start = axis.line(i);
    end = axis.line(j);
  }
  std::string keys;
  const auto write = [&](const std::string& key, double stated, double value) {
    if (std::abs(stated - value) > 1e-9)
      keys += (keys.empty() ? "" : " and ") + key + " = \"" + metres(value) + "\"";
  };
  write(span.start_key, span.start - span.base, start - span.base);
  write(span.size_key, span.size, end - start);
  add_fault(faults, opening_path(span.placed.index, fault.key),
            metres(fault.key == span.start_key ? span.start - span.base : span.size),
            span.placed.called + " " + fault.problem,
            "write " + keys +
                (on_lines ? ", on the joint lines every " + millimetres(axis.step) : "") +
                (fault.cut_cures ? "; or " + span.fit_key + " = \"cut\"" : ""));
}

// Places both edges of one direction; false after a fault, with the span of its cure.
bool snap_span(const Span& span, const Axis& axis, Fit fit, Room room, double& start, double& end,
               std::vector<Message>& notes, FaultList& faults) {
  const SpanFault fault = fault_of(span, axis, fit);
  if (!fault.problem.empty()) {
    cure_span(span, fault, axis, fit, room, start, end, faults);
    return false;
  }
  const auto snapped = [&](double edge) {
    const double line = axis.line(axis.nearest(edge));
    return std::abs(line - edge) <= reach_of(span, axis, fit) + 1e-9 ? line : edge;
  };
  start = snapped(span.start);
  end = std::min(snapped(span.start + span.size), axis.end());
  if (end - start < 1e-6 * axis.step) {
    cure_span(span, {span.size_key, "would move to one joint line"}, axis, fit, room, start, end,
              faults);
    return false;
  }
  note_move(span, span.start_moved_code, span.start, start, notes);
  note_move(span, span.size_changed_code, span.size, end - start, notes);
  return true;
}

// The named storey, or the one that contains the middle of the opening; nullptr after a fault.
const Storey* storey_of(const OpeningSpec& opening, int i, const std::vector<Storey>& storeys,
                        FaultList& faults) {
  if (!opening.storey.empty())
    return find_storey(storeys, opening.storey, opening_path(i, "storey"), faults);
  return &storey_at(storeys, opening.y + opening.height / 2);
}

// Which of lintel, arch and sill an opening has, with all their numbers.
struct Given {
  bool lintel, arch, sill;
};

// False where numbers are missing. After other faults the hole is that of their cures.
bool place_hole(const OpeningSpec& opening, PlacedOpening& placed, const Storey& storey, double top,
                const Given& has, std::vector<Message>& notes, FaultList& faults) {
  const Axis &columns = storey.lattice.columns, &courses = storey.lattice.courses;
  if (columns.count == 0 || courses.count == 0) return false;
  const int depth = has.lintel ? whole_steps(opening.lintel.depth, courses.step) : 0;
  const int below = has.sill ? whole_steps(opening.sill.depth, courses.step) : 0;
  const int bearing = std::max(has.lintel ? whole_steps(opening.lintel.bearing, columns.step) : 0,
                               has.sill ? whole_steps(opening.sill.bearing, columns.step) : 0);
  const double base = opening.storey.empty() ? 0 : storey.foot;
  const auto outside = [](const char* key, double extent) {
    return std::string("outside the wall (wall.") + key + " = " + metres(extent) + ")";
  };
  const std::string fit_key = storey.path_of("fit");
  const Span level{placed,
                   "x",
                   "width",
                   "opening.x_moved",
                   "opening.width_changed",
                   opening.x,
                   opening.width,
                   0,
                   outside("length", columns.extent),
                   fit_key};
  const Span upright{placed,
                     "y",
                     "height",
                     "opening.y_moved",
                     "opening.height_changed",
                     opening.y + base,
                     opening.height,
                     base,
                     courses.end() < top ? "above the " + floor_line(courses.end() - base)
                     : opening.storey.empty()
                         ? outside("height", top)
                         : "above the top of its storey at " + metres(courses.end() - base) +
                               " (heights count from the storey's foot)",
                     fit_key};
  Rect& hole = placed.hole;
  (void)snap_span(level, columns, storey.fit, {bearing, columns.count - bearing}, hole.x0, hole.x1,
                  notes, faults);
  (void)snap_span(upright, courses, storey.fit, {below, courses.count - depth}, hole.y0, hole.y1,
                  notes, faults);
  return true;
}

bool overlap(const PlacedOpening& a, const PlacedOpening& b) {
  return overlaps(a.hole, b.hole, 1e-9);
}

void refuse_overlap(const PlacedOpening& a, const PlacedOpening& b, FaultList& faults) {
  add_fault(faults, opening_path(b.index, "x"), metres(b.stated_x),
            b.called + " overlaps " + a.called,
            "move or shrink one of them, or make them one opening");
}

void refuse_lintel_in_opening(const PlacedOpening& a, const PlacedOpening& b, FaultList& faults) {
  if (a.segment.empty() || a.index == b.index) return;
  const Rect lintel = join(a.segment.front(), a.segment.back());
  const bool meets_lintel = !b.segment.empty() && a.index < b.index &&
                            overlaps(lintel, join(b.segment.front(), b.segment.back()), 1e-9);
  if (!overlaps(lintel, b.hole, 1e-9) && !meets_lintel) return;
  add_fault(faults, opening_path(a.index, "lintel.bearing"), "",
            "the lintel of " + a.called + " reaches into " +
                (meets_lintel ? "the lintel of " : "") + b.called,
            "shorten the bearing or move the opening");
}

// Refuses voussoirs of a, or the space under them, that overlap the opening, lintel or arch of b.
void refuse_arch_in_opening(const PlacedOpening& a, const PlacedOpening& b, FaultList& faults) {
  if (a.arch.empty() || a.index == b.index) return;
  constexpr double kTouch = 1e-9;  // [m^2]
  const Polygon arch = outline_of(a.arch);
  const auto meets = [&](const Polygon& other) { return overlap_area(arch, other) > kTouch; };
  std::string what;
  if (!b.segment.empty() && meets(outline_of(join(b.segment.front(), b.segment.back()))))
    what = "reaches into the lintel of ";
  else if (!b.arch.empty() && meets(outline_of(b.arch)))
    what = "overlaps the arch of ";
  else if (meets(outline_of(b.hole)))
    what = "reaches into ";
  if (what.empty() || (!b.arch.empty() && a.index > b.index && what.starts_with("overlaps")))
    return;
  add_fault(faults, opening_path(a.index, "arch"), "",
            "the arch of " + a.called + " " + what + b.called,
            "move the openings apart, or make the arch less deep");
}

void check_pairs(const std::vector<PlacedOpening>& openings, FaultList& faults) {
  for (std::size_t i = 0; i < openings.size() && !enough(faults); ++i) {
    for (std::size_t j = 0; j < openings.size(); ++j) {
      if (i != j && overlap(openings[i], openings[j])) {  // their lintels and arches overlap too
        if (i < j) refuse_overlap(openings[i], openings[j], faults);
        continue;
      }
      refuse_lintel_in_opening(openings[i], openings[j], faults);
      refuse_arch_in_opening(openings[i], openings[j], faults);
    }
  }
}

void note_bare_head(const PlacedOpening& opening, double height, const std::vector<Rect>& spanning,
                    std::vector<Message>& notes) {
  const Rect& hole = opening.hole;
  const auto spans = [&](const Rect& beam) {
    return std::abs(beam.y0 - hole.y1) < 1e-9 && beam.x0 < hole.x0 - 1e-9 &&
           beam.x1 > hole.x1 + 1e-9;
  };
  if (!opening.segment.empty() || hole.y1 > height - 1e-9 ||
      std::any_of(spanning.begin(), spanning.end(), spans))
    return;
  notes.push_back({"opening.bare_head", {{"opening", opening.words}}});
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

std::vector<PlacedOpening> place_openings(const Shape& shape, const std::vector<Storey>& storeys,
                                          const std::vector<Rect>& spanning,
                                          std::vector<Message>& notes, FaultList& faults) {
  std::vector<PlacedOpening> placed;
  const double top = storeys.back().top();
  for (std::size_t k = 0; k < shape.wall.opening.size(); ++k) {
    const OpeningSpec& opening = shape.wall.opening[k];
    const int i = static_cast<int>(k);
    const Given given{check_lintel(shape, i, faults), check_arch(shape, i, faults),
                      check_sill(shape, i, faults)};
    if (!is_given(opening, i, faults)) continue;
    const Storey* storey = storey_of(opening, i, storeys, faults);
    if (storey == nullptr) continue;
    PlacedOpening result{.index = i,
                         .storey = static_cast<int>(storey - storeys.data()),
                         .stated_x = opening.x,
                         .called = opening_name(i, opening.name),
                         .words = opening_words(i, opening.name),
                         .hole = {},
                         .segment = {},
                         .arch = {}};
    if (!place_hole(opening, result, *storey, top, given, notes, faults)) continue;
    if (given.sill) place_sill(opening.sill, storey->lattice, result, notes, faults);
    if (given.lintel) place_lintel(opening.lintel, storey->lattice, result, notes, faults);
    if (given.arch) place_arch(opening.arch, *storey, result, notes, faults);
    const bool is_framed = std::any_of(
        shape.frame.begin(), shape.frame.end(),
        [&](const FrameSpec& f) { return !f.round.empty() && f.round == opening.name; });
    if (opening.lintel.kind.empty() && opening.arch.kind == ArchKind::kNone && !is_framed)
      note_bare_head(result, top, spanning, notes);
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
