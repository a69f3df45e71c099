// The description of floors and of restraints of walls: a part of describe.h.
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// The descriptions are tables in manual layout, two to four lines for each key.
// clang-format off

// --- places ---------------------------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, PlaceSpec& s) {
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate,
             .fallback = "none", .example = "0 m",
             .doc = "A point in the pushed block, or a box's left end; from the wall's left."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate,
             .fallback = "none", .example = "3.12 m",
             .doc = "The same, above the wall's base."});
  v.quantity("z", s.z, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "none",
             .example = "0.1 m", .doc = "In space: the third coordinate of the point or box."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength, .fallback = "none",
             .example = "0.5 m",
             .doc = "With height: every block whose centre lies in the box is pushed."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "none", .example = "0.3 m", .doc = "Height of that box."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "m", .range = kLength, .fallback = "none",
             .example = "0.3 m", .doc = "In space: depth of that box along z."});
  v.integer("courses", s.courses, {.range = kFromOne, .example = "3",
            .doc = "Widens a point to so many courses, centred on its own."});
  v.text("block", s.block, {.fallback = "none", .example = "b12",
         .doc = "One block by its id, instead of a point; in space all whose ids begin so, with * at "
                "the end."});
  v.flag("beam", s.beam, {.example = "true", .doc = "The loading beam, instead of a point."});
  v.text("role", s.role, {.fallback = "any", .example = "slab",
         .doc = "In space: only moving blocks that are `masonry`, `lintel`, `sill` or `slab`; alone all of them, else those of the "
                "ids or box beside it."});
}

// --- floors --------------------------------------------------------------------------------------

// Removed before the table is read: they give `load` (src/io/model/floor_loads.cpp).
template <class Visitor>
void describe_floor_loads(Visitor& v) {
  if constexpr (requires { v.recipe("", Key{}); }) {
    v.recipe("g1", {.unit = "Pa", .shown = "kN/m^2", .range = kNotNegative, .fallback = "load", .example = "2.6 kN/m^2",
             .doc = "Weight of the floor's structure an area. load = (g1 + g2 + psi2 q) span / 2: the combination of an earthquake."});
    v.recipe("g2", {.unit = "Pa", .shown = "kN/m^2", .range = kNotNegative, .fallback = "load",
             .example = "1.4 kN/m^2", .doc = "Weight of what lies on it for good."});
    v.recipe("q", {.unit = "Pa", .shown = "kN/m^2", .range = kNotNegative, .fallback = "load", .example = "2 kN/m^2", .doc = "Live load."});
    v.recipe("psi2", {.range = kZeroToOne, .fallback = "load", .example = "0.3", .doc = "Share of it in an earthquake, from 0 to 1."});
    v.recipe("span", {.unit = "m", .shown = "m", .range = kLength, .fallback = "load", .example = "4.8 m", .doc = "Of the joists: this wall carries half of it."});
  }
}

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
             .doc = "Vertical load a length of wall, downwards, with all that lies on the floor; or by the five keys below."});
  describe_floor_loads(v);
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
  v.table("from", s.from, {.in_braces = true, .optional = true, .fallback = "in space: needed",
          .example = "{ x = \"0 m\", y = \"2.7 m\", z = \"0.1 m\" }",
          .doc = "In space: one end of the line it lies on, at the height of a bed joint. The line says how far "
                 "from the middle of the wall it bears; joists count from here."});
  v.table("to", s.to, {.in_braces = true, .optional = true, .fallback = "in space: needed",
          .example = "{ x = \"4 m\", y = \"2.7 m\", z = \"0.1 m\" }", .doc = "The other end."});
  v.quantity("mass", s.mass, {.unit = "kg/m", .shown = "kg/m", .range = kNotNegative,
             .example = "1200 kg/m",
             .doc = "Inertia a length of wall that moves with the blocks. Not needed for weight or for "
                    "patterns of forces; it slows a push down (docs/theory/integration.md). A shake needs it: a load without mass is not shaken. `\"rule\"`: the mass of load."});
  v.texts("origin", s.origin, {.fallback = "none", .example = "[\"load 14.4 kN/m: derived by floor_load from ...\"]",
          .doc = "Written by the program: how load and mass came about. A line holds only while the value is the one it names."});
}

// --- ties, diaphragms, springs -------------------------------------------------------------------

template <class Visitor>
void describe(Visitor& v, TieSpec& s) {
  v.text("name", s.name, {.fallback = "tie 1, tie 2 ...", .example = "tie first floor",
         .doc = "A name for messages, for links.csv and for `--set tie.NAME.area=...`."});
  v.table("from", s.from, {.in_braces = true, .optional = true, .fallback = kRequired,
          .example = "{ x = \"0 m\", y = \"3.1 m\" }",
          .doc = "One end: a point of the wall, the middle of a block, or the beam."});
  v.table("to", s.to, {.in_braces = true, .optional = true, .fallback = kRequired,
          .example = "{ x = \"4.8 m\", y = \"3.1 m\" }", .doc = "The other end, on another block."});
  v.flag("anchored", s.anchored, {.example = "true",
         .doc = "`to` is a rigid anchor: a point that does not move, on the wall or off it."});
  v.quantity("area", s.area, {.unit = "m^2", .shown = "mm^2", .range = kPositive,
             .fallback = kRequired, .example = "491 mm^2", .doc = "Area of the section."});
  v.quantity("youngs_modulus", s.youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = kRequired, .example = "200 GPa",
             .doc = "E; the stiffness is E A over the length between the ends."});
  v.quantity("yield_strength", s.yield_strength, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .may_be_unlimited = true, .example = "235 MPa",
             .doc = "Stress at which it yields; beyond it the force stays and the tie lengthens for good."});
  v.quantity("anchor_strength", s.anchor_strength, {.unit = "N", .shown = "kN", .range = kPositive,
             .may_be_unlimited = true, .example = "80 kN",
             .doc = "Force at which an anchor gives way, as yielding."});
  v.quantity("prestress", s.prestress, {.unit = "Pa", .shown = "MPa", .range = kNotNegative,
             .example = "60 MPa",
             .doc = "Stress drawn in along with the first gravity or load stage; what the wall yields to "
                    "it is lost from the tie."});
}

template <class Visitor>
void describe(Visitor& v, DiaphragmSpec& s) {
  v.text("name", s.name, {.fallback = "diaphragm 1 ...", .example = "first floor",
         .doc = "A name for messages and for links.csv."});
  v.choice("kind", s.kind, kDiaphragmKindWords, {.example = "rigid",
           .doc = "`elastic`: bars of the given stiffness between neighbouring points, both ways. `rigid`: "
                  "as stiff as shortens the time step by a tenth at most; a note gives the number."});
  v.text("storey", s.storey, {.fallback = "y", .example = "ground",
         .doc = "Name of the storey at whose top it lies."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "storey",
             .example = "3.10 m", .doc = "Its height. It holds the blocks below this height."});
  v.quantities("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = kRequired,
               .example = "[\"0.2 m\", \"2.4 m\", \"4.6 m\"]",
               .doc = "The connected points, from left to right, each on a block of its own."});
  v.quantities("z", s.z, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "in space: needed",
               .example = "[\"0 m\", \"0 m\", \"3 m\"]",
               .doc = "In space: the third coordinate of each point; bars run from each to the next."});
  v.quantity("stiffness", s.stiffness, {.unit = "N", .shown = "MN", .range = kPositive,
             .fallback = "needed by elastic", .example = "300 MN",
             .doc = "Axial stiffness E A of the strip that acts; over the distance of two points."});
}

template <class Visitor>
void describe(Visitor& v, SpringSpec& s) {
  v.text("name", s.name, {.fallback = "spring 1 ...", .example = "cross wall",
         .doc = "A name for messages and for links.csv."});
  v.table("at", s.at, {.in_braces = true, .optional = true, .fallback = kRequired,
          .example = "{ x = \"4.8 m\", y = \"2.9 m\" }",
          .doc = "The held point of the wall, the middle of a block, or the beam."});
  v.choice("direction", s.direction, kDirectionWords, {.example = "+x",
           .doc = "Where the neighbour stands, seen from the point: what moves there presses on it."});
  v.quantity("stiffness", s.stiffness, {.unit = "N/m", .shown = "kN/mm", .range = kPositive,
             .fallback = kRequired, .example = "20 kN/mm",
             .doc = "Force for a displacement along `direction`; across it the point is free."});
  v.quantity("strength", s.strength, {.unit = "N", .shown = "kN", .range = kPositive,
             .may_be_unlimited = true, .example = "50 kN",
             .doc = "Force that is not exceeded, either way; beyond it the neighbour gives way for good."});
  v.flag("pushes_only", s.pushes_only, {.example = "true",
         .doc = "Holds nothing that moves away from it: a gap opens."});
}

// clang-format on

}  // namespace wythe::io
