// A lintel or sill occupies whole courses and whole columns of bearing, rounded and at least one. First the opening's edge
// moves to a course line; the bearing is counted from the jamb. Then the body is divided at column lines; with
// model = "zones" a lintel stays one block.
#include "geometry/wall/lintel.h"

#include <algorithm>
#include <cmath>

#include "core/to_int.h"
#include "geometry/text.h"

namespace wythe::geometry {
namespace {

// A lintel or a sill: an integer number of columns long and of courses deep.
struct Beam {
  const char* what;  // "lintel", also the name of its table
  double depth, bearing;
  const char *depth_changed, *bearing_changed;  // codes of notes
  [[nodiscard]] std::string path(int opening, const std::string& key) const {
    return opening_path(opening, what + ("." + key));
  }
};

Beam beam_of(const LintelSpec& lintel) {
  return {"lintel", lintel.depth, lintel.bearing, "lintel.depth_changed", "lintel.bearing_changed"};
}
Beam beam_of(const SillSpec& sill) {
  return {"sill", sill.depth, sill.bearing, "sill.depth_changed", "sill.bearing_changed"};
}

void check_body(const Shape& shape, const std::string& path, const char* what,
                const std::string& material, FaultList& faults) {
  if (material.empty()) {
    add_fault(faults, path, "", "missing",
              std::string("name the [material.*] table that holds the ") + what +
                  "'s density and moduli");
    return;
  }
  const auto found = shape.material.find(material);
  if (found == shape.material.end()) return;  // reported with other missing materials
  (void)is_positive({"material." + material + ".density", found->second, "kg/m^3", "500 kg/m^3"},
                    faults);
}

bool check_beam(const Shape& shape, int index, const Beam& beam, const std::string& material,
                FaultList& faults) {
  check_body(shape, beam.path(index, "material"), beam.what, material, faults);
  bool given = is_positive({beam.path(index, "depth"), beam.depth, "m", "110 mm"}, faults);
  // without bearing a lintel would be as long as the opening and unsupported
  given &= is_positive({beam.path(index, "bearing"), beam.bearing, "m", "150 mm"}, faults);
  return given;
}

void note_size(const PlacedOpening& opening, const char* code, double stated, double laid,
               std::vector<Message>& notes) {
  if (std::abs(laid / stated - 1) <= kFitTolerance) return;
  notes.push_back({code,
                   {{"opening", opening.words},
                    {"from_mm", 1e3 * stated},
                    {"to_mm", 1e3 * laid},
                    {"change_percent", 100 * (laid / stated - 1)}}});
}

// Notes keys of zones beside a chain of rigid segments: they have no effect, but a user may compare both models.
void note_idle_keys(const LintelSpec& lintel, const PlacedOpening& opening,
                    std::vector<Message>& notes) {
  const LintelSpec unset;
  const bool stated = lintel.zones != unset.zones || !std::isnan(lintel.zone_length) ||
                      lintel.zone_kind != unset.zone_kind || lintel.plane != unset.plane;
  if (lintel.model == LintelModel::kSegments && stated)
    notes.push_back({"lintel.idle_keys", {{"opening", opening.words}}});
}

// The jamb moved outwards by `columns` columns; on the lattice where the jamb is.
double end_of(const Axis& axis, double jamb, int columns) {
  if (!axis.is_on_line(jamb)) return jamb + columns * axis.step;
  const int i = axis.nearest(jamb) + columns;
  return i < 0 || i > axis.count ? jamb + columns * axis.step : axis.line(i);
}

bool ends_inside(const Rect& body, const Axis& axis, const PlacedOpening& opening, const Beam& beam,
                 FaultList& faults) {
  const double margin = 1e-9 * axis.extent;
  if (body.x0 >= -margin && body.x1 <= axis.extent + margin) return true;
  // whole columns beside the opening; in a surveyed wall the last one may be cut
  const double beside = std::min(opening.hole.x0, axis.extent - opening.hole.x1);
  const int room = static_cast<int>(beside / axis.step + 1e-9);
  const std::string what = beam.what;
  add_fault(faults, beam.path(opening.index, "bearing"), millimetres(beam.bearing),
            "the " + what + " of " + opening.called + " reaches outside the wall: it would span " +
                metres(body.x0) + " to " + metres(body.x1),
            room > 0 ? "write bearing = \"" + millimetres(room * axis.step) + "\""
                     : "leave at least one half unit (" + millimetres(axis.step) +
                           ") of wall beside the opening, or the " + what + " out");
  return false;
}

bool lies_under_top(int bottom, int top, const Axis& courses, const PlacedOpening& opening,
                    const LintelSpec& lintel, FaultList& faults) {
  if (top <= courses.count) return true;
  add_fault(faults, opening_path(opening.index, "lintel.depth"), millimetres(lintel.depth),
            "deeper than the masonry above " + opening.called + " (" +
                millimetres(courses.end() - opening.hole.y1) + ")",
            bottom < courses.count
                ? "write depth = \"" + millimetres((courses.count - bottom) * courses.step) + "\""
                : "lower the opening, or leave the lintel out");
  return false;
}

bool lies_over_foot(int top, int depth, const Axis& courses, const PlacedOpening& opening,
                    const SillSpec& sill, FaultList& faults) {
  if (depth <= top) return true;
  add_fault(
      faults, opening_path(opening.index, "sill.depth"), millimetres(sill.depth),
      "deeper than the masonry of the storey below " + opening.called + " (" +
          millimetres(top * courses.step) + ")",
      top > 0 ? "write depth = \"" + millimetres(top * courses.step) + "\"" : "leave the sill out");
  return false;
}

}  // namespace

std::vector<Rect> cut_chain(const Rect& body, const Axis& columns) {
  std::vector<double> x{body.x0};
  for (int i = 0; i <= columns.count; ++i) {
    const double line = columns.line(i), least = columns.step / 2 * (1 - 1e-6);
    if (line - body.x0 > least && body.x1 - line > least) x.push_back(line);
  }
  x.push_back(body.x1);
  std::vector<Rect> segments;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    segments.push_back({x[k], body.y0, x[k + 1], body.y1});
  }
  return segments;
}

namespace {

void note_edge(const PlacedOpening& opening, const char* code, double from, double to,
               std::vector<Message>& notes) {
  if (std::abs(to - from) > 1e-9)
    notes.push_back({code, {{"opening", opening.words}, {"from_m", from}, {"to_m", to}}});
}

void move_head_to_course(const Axis& courses, PlacedOpening& opening, std::vector<Message>& notes) {
  const int lowest = courses.nearest(opening.hole.y0) + 1;
  const double line = courses.line(std::max(lowest, courses.nearest(opening.hole.y1)));
  note_edge(opening, "opening.head_moved", opening.hole.y1, line, notes);
  opening.hole.y1 = line;
}

void move_foot_to_course(const Axis& courses, PlacedOpening& opening, std::vector<Message>& notes) {
  int at = courses.nearest(opening.hole.y0);
  while (at > 0 && courses.line(at) > opening.hole.y1 - courses.step / 2) --at;
  note_edge(opening, "opening.foot_moved", opening.hole.y0, courses.line(at), notes);
  opening.hole.y0 = courses.line(at);
}

// The kind is only a label. An unknown one gets a note, since the user may expect an effect.
void note_unknown_kind(const char* code, const std::string& kind, const std::string& material,
                       const PlacedOpening& opening, std::vector<Message>& notes) {
  static const std::vector<std::string> kKnown = {"timber", "stone", "concrete", "steel", "brick"};
  if (std::find(kKnown.begin(), kKnown.end(), kind) != kKnown.end()) return;
  notes.push_back({code, {{"opening", opening.words}, {"kind", kind}, {"material", material}}});
}

bool bears_as_stated(double laid, const Axis& columns, const PlacedOpening& opening,
                     const Beam& beam, FaultList& faults) {
  if (laid <= kBearingFactor * beam.bearing * (1 + 1e-9)) return true;
  add_fault(faults, beam.path(opening.index, "bearing"), millimetres(beam.bearing),
            "would become " + millimetres(laid) + ", " + times(laid / beam.bearing) +
                " times as long: a " + beam.what + " bears on whole half units of " +
                millimetres(columns.step),
            "write bearing = \"" + millimetres(laid) + "\", or smaller units");
  return false;
}

}  // namespace

int whole_steps(double size, double step) { return std::max(1, to_int(std::round(size / step))); }

bool check_lintel(const Shape& shape, int index, FaultList& faults) {
  const LintelSpec& lintel = shape.wall.opening[index].lintel;
  if (lintel.kind.empty()) return false;
  return check_beam(shape, index, beam_of(lintel), lintel.material, faults);
}

bool check_sill(const Shape& shape, int index, FaultList& faults) {
  const SillSpec& sill = shape.wall.opening[index].sill;
  if (sill.kind.empty()) return false;
  return check_beam(shape, index, beam_of(sill), sill.material, faults);
}

void place_lintel(const LintelSpec& lintel, const Lattice& lattice, PlacedOpening& opening,
                  std::vector<Message>& notes, FaultList& faults) {
  const Axis &columns = lattice.columns, &courses = lattice.courses;
  const Beam beam = beam_of(lintel);
  move_head_to_course(courses, opening, notes);
  const int bottom = courses.nearest(opening.hole.y1);
  const int top = bottom + whole_steps(lintel.depth, courses.step);
  const int bearing = whole_steps(lintel.bearing, columns.step);
  Rect body{end_of(columns, opening.hole.x0, -bearing), opening.hole.y1,
            end_of(columns, opening.hole.x1, bearing), courses.line(top)};
  bool fits = ends_inside(body, columns, opening, beam, faults);
  fits &= lies_under_top(bottom, top, courses, opening, lintel, faults);
  fits &= bears_as_stated(bearing * columns.step, columns, opening, beam, faults);
  if (!fits) return;
  note_unknown_kind("lintel.idle_kind", lintel.kind, lintel.material, opening, notes);
  note_idle_keys(lintel, opening, notes);
  note_size(opening, beam.depth_changed, lintel.depth, body.y1 - body.y0, notes);
  note_size(opening, beam.bearing_changed, lintel.bearing, body.x1 - opening.hole.x1, notes);
  opening.segment =
      lintel.model == LintelModel::kZones ? std::vector<Rect>{body} : cut_chain(body, columns);
}

void place_sill(const SillSpec& sill, const Lattice& lattice, PlacedOpening& opening,
                std::vector<Message>& notes, FaultList& faults) {
  const Axis &columns = lattice.columns, &courses = lattice.courses;
  const Beam beam = beam_of(sill);
  move_foot_to_course(courses, opening, notes);
  const int top = courses.nearest(opening.hole.y0);
  const int depth = whole_steps(sill.depth, courses.step);
  const int bearing = whole_steps(sill.bearing, columns.step);
  const Rect body{end_of(columns, opening.hole.x0, -bearing),
                  courses.line(std::max(0, top - depth)), end_of(columns, opening.hole.x1, bearing),
                  opening.hole.y0};
  bool fits = ends_inside(body, columns, opening, beam, faults);
  fits &= lies_over_foot(top, depth, courses, opening, sill, faults);
  fits &= bears_as_stated(bearing * columns.step, columns, opening, beam, faults);
  if (!fits) return;
  note_unknown_kind("sill.idle_kind", sill.kind, sill.material, opening, notes);
  note_size(opening, beam.depth_changed, sill.depth, body.y1 - body.y0, notes);
  note_size(opening, beam.bearing_changed, sill.bearing, body.x1 - opening.hole.x1, notes);
  opening.sill = cut_chain(body, columns);
}

}  // namespace wythe::geometry
