// Outlines of a drawing: closed polylines of an ASCII DXF file, R12 to 2018, in metres.
// A file is pairs of lines, a group code and its value. HEADER
// states the unit ($INSUNITS), ENTITIES holds the drawn objects.
// Polylines are read, with arcs as chords (kChordError). Other
// entities with a line or an area are reported by name and place.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "wythe/parts/error.h"

namespace wythe::io {

inline constexpr double kChordError =
    1e-3;                                // between an arc of a polyline and its chords, at most [m]
inline constexpr int kMostChords = 360;  // of one arc
inline constexpr int kMostEntities =
    1'000'000;  // a drawing of 200 000 stones has two of each: its outline and its number
inline constexpr int kMostOfAllChords =
    1'000'000;  // of a drawing: a vertex of 30 bytes may ask for 360 corners

struct DrawnOutline {
  std::string layer;
  std::string handle;  // of the entity, as the drawing program shows it; "" in old files
  int line = 0;        // of the file
  std::vector<std::array<double, 2>> corners;  // the first is not repeated [m]
};

// An entity that is not a closed outline, with the reason.
struct Unread {
  std::string layer, type, handle, problem, cure;
  int line = 0;
};

struct Drawing {
  std::vector<DrawnOutline> outlines;  // in the file's order
  std::vector<Unread> unread;
  std::vector<std::string> layers;  // that hold entities, each once
  // Objects that the drawing program does not show are ignored: layers
  // with outlines that are off or frozen, and invisible entities.
  std::vector<std::string> hidden;
  int invisible = 0;
  // Number of outlines with a thickness of their own (group 39), and the first of these, in units of the file.
  int thick = 0;
  double thickness = 0;
  std::string stated_unit;  // by the file ($INSUNITS), "mm"; "" where it states none that is read
};

[[nodiscard]] bool is_drawing(const std::string& file);  // by its ending

// Ignores texts, dimensions, points and hidden objects. `unit` ("mm", "m",
// ...) takes precedence over the file's unit; "" means the file's unit. Throws
// InputError where the file is not such a drawing, or no unit is known.
[[nodiscard]] Drawing parse_drawing(const std::string& file, const std::string& unit);

// The fault for an entity that a reader needs, "LWPOLYLINE 2F on layer stones".
[[nodiscard]] Fault fault_of(const Unread& entity, const std::string& file);

// The number of units in a metre ("mm": 1000); 0 for a word that is not a unit of a drawing or mesh.
[[nodiscard]] double units_in_a_metre(std::string_view name);
[[nodiscard]] std::string drawing_units();  // "m, mm, cm, ..."

// Compares layer names without case.
[[nodiscard]] bool same_layer(std::string_view a, std::string_view b);

}  // namespace wythe::io
