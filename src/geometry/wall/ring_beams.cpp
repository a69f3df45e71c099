// Lays a ring beam in whole courses: below the top of its storey, or from the course line nearest to y. Its ends move
// to the nearest column lines, with a note (docs/theory/ring_beams.md). Boxes of chains are tested against openings and ground,
// and against the outlines of arches.
#include "geometry/wall/ring_beams.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/text.h"
#include "geometry/wall/arches.h"
#include "geometry/wall/foundation.h"
#include "geometry/wall/lintel.h"

namespace wythe::geometry {
namespace {

// One ring beam, for messages.
struct NamedBeam {
  const RingBeamSpec& spec;
  int index;
  [[nodiscard]] std::string path(const std::string& key = "") const {
    const std::string table = "ring_beam." + std::to_string(index);
    return key.empty() ? table : table + "." + key;
  }
  [[nodiscard]] std::string name() const {
    return spec.name.empty() ? std::to_string(index) : spec.name;
  }
  [[nodiscard]] std::string called() const {
    return "ring beam " + std::to_string(index) + (spec.name.empty() ? "" : " (" + spec.name + ")");
  }
};

bool is_given(const Shape& shape, const NamedBeam& beam, FaultList& faults) {
  const std::size_t before = faults.all().size();
  const RingBeamSpec& b = beam.spec;
  if (std::isfinite(b.y) == !b.storey.empty())
    add_fault(faults, beam.path(), "",
              beam.called() + (b.storey.empty() ? " has no level" : " has two levels"),
              "write the storey at whose top it lies, or the height y of its foot");
  (void)is_positive({beam.path("height"), b.height, "m", "250 mm"}, faults);
  if (!std::isnan(b.thickness))
    (void)is_positive({beam.path("thickness"), b.thickness, "m", "0.25 m"}, faults);
  const auto found = shape.material.find(b.material);
  if (b.material.empty())
    add_fault(faults, beam.path("material"), "", "missing",
              "name the [material.*] table that holds its density and moduli");
  else if (found != shape.material.end())  // others are reported with missing materials
    (void)is_positive(
        {"material." + b.material + ".density", found->second, "kg/m^3", "2500 kg/m^3"}, faults);
  return faults.all().size() == before;
}

// Courses from `bottom` up to `top`.
struct Rows {
  int bottom, top;
};

std::optional<Rows> rows_of(const NamedBeam& beam, const Storey& storey,
                            std::vector<Message>& notes, FaultList& faults) {
  const Axis& courses = storey.lattice.courses;
  const int rows = whole_steps(beam.spec.height, courses.step);
  const bool by_storey = !beam.spec.storey.empty();
  const int bottom = by_storey ? courses.count - rows : courses.nearest(beam.spec.y);
  const std::string whose = storey.index < 0 ? "the wall" : storey.called();
  if (bottom < 0 || bottom + rows > courses.count) {
    const bool fits = rows <= courses.count;
    add_fault(faults, beam.path(fits ? "y" : "height"),
              fits ? metres(beam.spec.y) : millimetres(beam.spec.height),
              beam.called() + " does not end within " + whose + ", which ends at " +
                  metres(courses.end()),
              fits
                  ? "write y = \"" + metres(courses.line(courses.count - rows)) + "\" or less"
                  : "write height = \"" + millimetres(courses.count * courses.step) + "\" or less");
    return std::nullopt;
  }
  const double foot = courses.line(bottom);
  if (!by_storey && std::abs(foot - beam.spec.y) > 1e-9)
    notes.push_back(
        {"ring_beam.y_moved", {{"beam", beam.name()}, {"from_m", beam.spec.y}, {"to_m", foot}}});
  return Rows{bottom, bottom + rows};
}

// Moves ends to half units, as for a lintel.
bool place_ends(const NamedBeam& beam, const Axis& columns, Rect& body, std::vector<Message>& notes,
                FaultList& faults) {
  const RingBeamSpec& b = beam.spec;
  const double from = std::isnan(b.x) ? 0 : b.x;
  const double to = std::isnan(b.width) ? columns.extent : from + b.width;
  const double margin = columns.step / 2;
  if (from >= columns.extent || to > columns.extent + margin || !(to > from)) {
    add_fault(faults, beam.path(from >= columns.extent ? "x" : "width"),
              metres(from >= columns.extent ? from : to - from),
              beam.called() + " ends at " + metres(to) +
                  ", outside the wall (wall.length = " + metres(columns.extent) + ")",
              "keep x and x + width within the wall");
    return false;
  }
  const int first = columns.nearest(from), last = std::max(first + 1, columns.nearest(to));
  if (last > columns.count) {
    add_fault(faults, beam.path("width"), metres(to - from),
              beam.called() + " is shorter than half a unit at the wall's end",
              "write a smaller x");
    return false;
  }
  body.x0 = columns.line(first), body.x1 = columns.line(last);
  if (std::max(std::abs(body.x0 - from), std::abs(body.x1 - to)) > 1e-9)
    notes.push_back({"ring_beam.ends_moved",
                     {{"beam", beam.name()},
                      {"from_m", from},
                      {"to_m", to},
                      {"laid_from_m", body.x0},
                      {"laid_to_m", body.x1}}});
  return true;
}

bool is_as_thin_as_wall(const NamedBeam& beam, const Storey& storey, FaultList& faults) {
  if (!(beam.spec.thickness > storey.thickness * (1 + 1e-9))) return true;
  add_fault(faults, beam.path("thickness"), metres(beam.spec.thickness),
            beam.called() + " is thicker than the masonry there, " + metres(storey.thickness),
            "write thickness = \"" + metres(storey.thickness) + "\" or less");
  return false;
}

// A rectangle that must not overlap any other.
struct Body {
  std::string path, called;
  Rect box;
  bool is_lintel = false;
  int opening = -1;
};

std::vector<Body> bodies_of(const Shape& shape, const std::vector<PlacedOpening>& openings,
                            const std::vector<PlacedRingBeam>& beams) {
  std::vector<Body> bodies;
  for (const PlacedRingBeam& beam : beams) {
    const NamedBeam named{shape.ring_beam[beam.index], beam.index};
    bodies.push_back(
        {named.path("y"), named.called(), join(beam.segment.front(), beam.segment.back())});
    if (!named.spec.storey.empty()) bodies.back().path = named.path("storey");
  }
  for (const PlacedOpening& o : openings) {
    if (!o.sill.empty())
      bodies.push_back({opening_path(o.index, "sill"), "the sill of " + o.called,
                        join(o.sill.front(), o.sill.back()), false, o.index});
    if (!o.segment.empty())
      bodies.push_back({opening_path(o.index, "lintel"), "the lintel of " + o.called,
                        join(o.segment.front(), o.segment.back()), true, o.index});
  }
  return bodies;
}

void refuse(const Body& body, const std::string& other, FaultList& faults) {
  add_fault(faults, body.path, "", body.called + " reaches into " + other,
            "move one of them, or shorten it");
}

}  // namespace

std::vector<PlacedRingBeam> place_ring_beams(const Shape& shape, const std::vector<Storey>& storeys,
                                             std::vector<Message>& notes, FaultList& faults) {
  std::vector<PlacedRingBeam> placed;
  for (std::size_t k = 0; k < shape.ring_beam.size(); ++k) {
    const NamedBeam beam{shape.ring_beam[k], static_cast<int>(k)};
    if (!is_given(shape, beam, faults)) continue;
    const Storey* storey = beam.spec.storey.empty() ? &storey_at(storeys, beam.spec.y + 1e-9)
                                                    : find_storey(storeys, beam.spec.storey,
                                                                  beam.path("storey"), faults);
    if (storey == nullptr || storey->lattice.courses.count == 0 ||
        storey->lattice.columns.count == 0 || !is_as_thin_as_wall(beam, *storey, faults))
      continue;
    const std::optional<Rows> rows = rows_of(beam, *storey, notes, faults);
    if (!rows) continue;
    const Lattice& lattice = storey->lattice;
    Rect body{0, lattice.courses.line(rows->bottom), 0, lattice.courses.line(rows->top)};
    if (!place_ends(beam, lattice.columns, body, notes, faults)) continue;
    notes.push_back({"ring_beam.lies",
                     {{"beam", beam.name()},
                      {"foot_m", body.y0},
                      {"top_m", body.y1},
                      {"laid_mm", 1e3 * (body.y1 - body.y0)},
                      {"height_mm", 1e3 * beam.spec.height}}});
    placed.push_back({static_cast<int>(k), static_cast<int>(storey - storeys.data()),
                      std::isnan(beam.spec.thickness) ? storey->thickness : beam.spec.thickness,
                      cut_chain(body, lattice.columns)});
  }
  return placed;
}

void check_chains(const Shape& shape, const std::vector<PlacedOpening>& openings,
                  const std::vector<PlacedRingBeam>& beams, const std::vector<GroundStep>& ground,
                  FaultList& faults) {
  constexpr double kTouch = 1e-9;  // [m]
  const std::vector<Body> bodies = bodies_of(shape, openings, beams);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
      if (!(body.is_lintel && bodies[j].is_lintel) && overlaps(body.box, bodies[j].box, kTouch))
        refuse(body, bodies[j].called, faults);
    for (const PlacedOpening& o : openings) {
      if (!body.is_lintel && overlaps(body.box, o.hole, kTouch)) refuse(body, o.called, faults);
      if (!body.is_lintel && !o.arch.empty() &&
          overlap_area(outline_of(o.arch), outline_of(body.box)) > kTouch)
        refuse(body, "the arch of " + o.called, faults);
    }
    for (const GroundStep& step : ground)
      if (overlaps(body.box, box_of(step), kTouch)) refuse(body, "the ground", faults);
  }
  for (const PlacedOpening& o : openings)
    for (const GroundStep& step : ground)
      if (overlaps(o.hole, box_of(step), kTouch))
        add_fault(faults, opening_path(o.index, "y"), metres(o.hole.y0),
                  o.called + " reaches into the ground, which is at " + metres(step.y) + " there",
                  "raise the opening, or lower the step (wall.foundation)");
      else if (!o.arch.empty() &&
               overlap_area(outline_of(o.arch), outline_of(box_of(step))) > kTouch)
        add_fault(faults, opening_path(o.index, "arch"), "",
                  "the arch of " + o.called + " reaches into the ground", "raise the opening");
}

}  // namespace wythe::geometry
