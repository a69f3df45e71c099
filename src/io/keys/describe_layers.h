// The description of strengthening layers (describe.h says how to read it).
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// clang-format off

inline constexpr Range kFibreArea{.low = 0, .high = 0.01};          // [m^2/m]
inline constexpr Range kFaces{.low = 1, .high = 2};
inline constexpr Range kRuptureStrain{.low = 0, .high = 1, .low_open = true};

template <class Visitor>
void describe(Visitor& v, LayerFibreSpec& s) {
  v.quantity("horizontal", s.horizontal, {.unit = "m", .shown = "mm^2/m", .range = kFibreArea, .example = "46 mm^2/m",
             .doc = "Area of the fibres that run level, per metre of height, of one face."});
  v.quantity("vertical", s.vertical, {.unit = "m", .shown = "mm^2/m", .range = kFibreArea, .example = "46 mm^2/m",
             .doc = "Area of those that run upright, per metre of length, of one face."});
  v.quantity("youngs_modulus", s.youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive, .fallback = kRequired,
             .example = "72 GPa", .doc = "E of the fibres, on the area above."});
  v.quantity("strength", s.strength, {.unit = "Pa", .shown = "MPa", .range = kPositive, .fallback = "strain_at_rupture",
             .example = "1000 MPa", .doc = "Stress at which they break; no partial factor is applied."});
  v.number("strain_at_rupture", s.strain_at_rupture, {.range = kRuptureStrain, .fallback = "strength",
             .example = "0.014", .doc = "Or the strain at which they break."});
}

template <class Visitor>
void describe(Visitor& v, LayerBondSpec& s) {
  v.quantity("energy", s.energy, {.unit = "N/m", .shown = "N/m", .range = kPositive, .fallback = kRequired, .example = "400 N/m",
             .doc = "Energy per area that detaches the layer by slip (mode II), from pull tests of the system."});
  v.quantity("slip", s.slip, {.unit = "m", .shown = "mm", .range = kPositive, .fallback = kRequired, .example = "0.2 mm",
             .doc = "Slip at the greatest bond stress."});
}

template <class Visitor>
void describe(Visitor& v, LayerMortarSpec& s) {
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired, .example = "30 mm",
             .doc = "Of one face."});
  v.quantity("youngs_modulus", s.youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive, .fallback = kRequired,
             .example = "12 GPa", .doc = "E of the mortar; its shear modulus is E / 2.4."});
  v.text("joint", s.joint, {.fallback = kRequired, .example = "plaster",
         .doc = "Name of the joint material that has its strengths and energies: it cracks over the joints of the masonry. Stiffnesses there are not used."});
  v.quantity("density", s.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kNotNegative, .example = "1900 kg/m^3",
             .doc = "For its weight, on the units that it covers."});
}

template <class Visitor>
void describe(Visitor& v, LayerSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "east face",
         .doc = "A name for messages, for layers.csv and for `--set layer.east.sides=2`."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "left end of the masonry", .example = "0.5 m",
             .doc = "Left end of the rectangle that it covers."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "foot of the masonry", .example = "0 m",
             .doc = "Its foot."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength, .fallback = "to the right end", .example = "2 m",
             .doc = "Along the wall."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = "to the top", .example = "2.5 m",
             .doc = "Upwards."});
  v.integer("sides", s.sides, {.range = kFaces, .fallback = kRequired, .example = "2",
            .doc = "How many faces of the wall have it: 1 or 2. One face acts in the middle of the wall, so it bends nothing."});
  v.table("fibres", s.fibres, {.in_braces = true, .doc = "The fibres of one face."});
  v.table("bond", s.bond, {.in_braces = true, .doc = "How it holds on to the masonry."});
  v.table("mortar", s.mortar, {.in_braces = true, .optional = true, .fallback = "bears nothing by itself",
          .doc = "Mortar that presses, shears and cracks with the masonry: reinforced plaster (CRM) or a jacket, held by connectors."});
}

// clang-format on

}  // namespace wythe::io
