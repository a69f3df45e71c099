// The description of floors and of what holds walls: a part of describe.h.
#pragma once

#include "io/key.h"
#include "wythe/wall_spec.h"

namespace wythe::io {

// The descriptions are tables laid out by hand, two to four lines a key.
// clang-format off

// --- floors --------------------------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, FloorSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "first floor",
         .doc = "A name for messages and for `--set floor.roof.load=...`."});
  v.text("storey", s.storey, {.fallback = "y", .example = "ground",
         .doc = "Name of the storey on whose top it lies."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "storey",
             .example = "3.10 m",
             .doc = "Height of its bearing above the wall's base, within 10 mm of a bed joint: the blocks "
                    "that end there carry it."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kDistance,
             .fallback = "the wall's left end", .example = "0 m",
             .doc = "Left end, from the wall's left."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "up to the wall's right end", .example = "4.80 m",
             .doc = "How much of the wall's length it lies on. All of it needs masonry below."});
  v.quantity("load", s.load, {.unit = "N/m", .shown = "kN/m", .range = kNotNegative,
             .fallback = "0 kN/m", .example = "12 kN/m",
             .doc = "Vertical load a length of wall, downwards, with all that lies on the floor."});
  v.quantities("joists", s.joists, {.unit = "m", .shown = "m", .range = kDistance,
               .fallback = "a line load", .example = "[\"0.3 m\", \"0.9 m\", \"1.5 m\"]",
               .doc = "Where joists lie, from the wall's left: they share load times width as point "
                      "loads; one over a head joint lies on both blocks."});
  v.quantity("bearing", s.bearing, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "not looked at", .example = "150 mm",
             .doc = "Depth of the bearing into the wall. A note gives the mean pressure there and says "
                    "when it is beyond the strength. No effect on the motion: the model is plane and "
                    "knows no eccentricity across the wall."});
  v.quantity("thrust", s.thrust, {.unit = "N", .shown = "kN", .range = kAnyValue, .example = "8 kN",
             .doc = "Horizontal force of a roof on the wall, in its plane, to the right; shared as the load."});
  v.quantity("mass", s.mass, {.unit = "kg/m", .shown = "kg/m", .range = kNotNegative,
             .example = "1200 kg/m",
             .doc = "Inertia a length of wall that moves with the blocks. Not needed for weight or for "
                    "patterns of forces; it slows a push down (docs/theory/integration.md)."});
}

// clang-format on

}  // namespace wythe::io
