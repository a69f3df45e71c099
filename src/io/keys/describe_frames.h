// The description of frames (describe.h says how to read it).
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, SectionSpec& s) {
  v.quantity("height", s.height, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "200 mm", .doc = "In the wall's plane."});
  v.quantity("width", s.width, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "200 mm", .doc = "Across the wall: the strip of masonry that it touches."});
  v.quantity("area", s.area, {.unit = "m^2", .shown = "cm^2", .range = kPositive, .fallback = kRequired,
             .example = "78.1 cm^2", .doc = "A."});
  v.quantity("shear_area", s.shear_area, {.unit = "m^2", .shown = "cm^2", .range = kPositive, .fallback = kRequired,
             .example = "16.7 cm^2", .doc = "As, of the web or 5/6 of a rectangle: for stiffness and use."});
  v.quantity("second_moment", s.second_moment, {.unit = "m^4", .shown = "cm^4", .range = kPositive,
             .fallback = kRequired, .example = "5696 cm^4", .doc = "I, for bending in the wall's plane."});
  v.quantity("plastic_modulus", s.plastic_modulus, {.unit = "m^3", .shown = "cm^3", .range = kPositive,
             .fallback = kRequired, .example = "642.5 cm^3", .doc = "Wpl, likewise."});
  v.quantity("mass", s.mass, {.unit = "kg/m", .shown = "kg/m", .range = kPositive, .fallback = kRequired,
             .example = "61.3 kg/m", .doc = "Of a length."});
  v.quantity("weak_second_moment", s.weak_second_moment, {.unit = "m^4", .shown = "cm^4", .range = kPositive,
             .fallback = "required in space", .example = "2003 cm^4", .doc = "I for bending across the wall's plane, in space."});
  v.quantity("torsion_constant", s.torsion_constant, {.unit = "m^4", .shown = "cm^4", .range = kPositive,
             .fallback = "required in space", .example = "59.3 cm^4", .doc = "It, in space."});
  v.quantity("weak_shear_area", s.weak_shear_area, {.unit = "m^2", .shown = "cm^2", .range = kPositive,
             .fallback = "shear_area", .example = "50 cm^2", .doc = "As across the wall's plane, in space: 5/6 of both flanges or of a rectangle."});
}

template <class Visitor>
void describe(Visitor& v, HoleSpec& s) {
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = kRequired,
             .example = "0.9 m", .doc = "Of its left side."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = kRequired,
             .example = "0 m", .doc = "Of its foot."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "1.8 m", .doc = "Clear, between the jambs."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "2 m", .doc = "Clear, below the head."});
}

template <class Visitor>
void describe(Visitor& v, AnchorSpec& s) {
  v.quantity("spacing", s.spacing, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "400 mm", .doc = "Between two of them along a member."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "200 mm", .doc = "Of the middle of the length that is bonded, behind the face of the masonry: the unit there holds it."});
  v.quantity("tension", s.tension, {.unit = "N", .shown = "kN", .range = kPositive, .fallback = kRequired,
             .example = "12 kN", .doc = "Strength of one when it is pulled out; it holds as much while it slips further."});
  v.quantity("shear", s.shear, {.unit = "N", .shown = "kN", .range = kPositive, .fallback = kRequired,
             .example = "15 kN", .doc = "Strength of one across its axis, likewise."});
  v.quantity("slip", s.slip, {.unit = "m", .shown = "mm", .range = kPositive, .example = "1 mm",
             .doc = "At both strengths: the stiffness is strength over slip."});
}

template <class Visitor>
void describe(Visitor& v, WedgeSpec& s) {
  v.quantity("force", s.force, {.unit = "N", .shown = "kN", .range = kPositive, .fallback = kRequired,
             .example = "80 kN", .doc = "Of all of them together, when the stage that puts the frame up has ended."});
  v.quantity("spacing", s.spacing, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "400 mm", .doc = "Between two of them along the beam."});
}

template <class Visitor>
void describe(Visitor& v, FrameSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "F1",
         .doc = "A name for messages, for frames.csv and for `--set frame.F1.count=2`."});
  v.text("round", s.round, {.fallback = "line", .example = "shop",
         .doc = "Name of the opening it stands in: columns at the jambs, a beam under the head."});
  v.points("line", s.line, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "round",
           .example = "[[\"1 m\", \"0 m\"], [\"1 m\", \"2.5 m\"], [\"4 m\", \"2.5 m\"], [\"4 m\", \"0 m\"]]",
           .doc = "Or its axis (x, y) from corner to corner, in level and upright parts; with a base beam the first point again."});
  v.choice("feet", s.feet, kFrameFeetWords, {.fallback = kRequired, .example = "fixed",
           .doc = "Where the columns end: `fixed` in the ground, `hinged` on it, on a `base_beam`, or `resting` by contact on what is below."});
  v.text("profile", s.profile, {.fallback = "section", .example = "HEB 200",
         .doc = "Rolled section, strong axis: IPE, HEA, HEB, UPN, SHS (square tube, `SHS 100x5`)."});
  v.integer("count", s.count, {.range = kFromOne, .example = "2", .doc = "How many side by side across the wall."});
  v.table("section", s.section, {.in_braces = true, .optional = true, .fallback = "profile",
          .doc = "Numbers of one piece in the place of a profile."});
  v.text("beam_profile", s.beam_profile, {.fallback = "as the columns", .example = "IPE 240", .doc = "Profile of level parts."});
  v.integer("beam_count", s.beam_count, {.range = kFromZero, .fallback = "count", .example = "2", .doc = "How many of them."});
  v.table("beam_section", s.beam_section, {.in_braces = true, .optional = true, .fallback = "as the columns",
          .doc = "Numbers of one of them in the place of a profile."});
  v.text("grade", s.grade, {.fallback = "the next three", .example = "S275",
         .doc = "Steel: S235, S275, S355 (EN 1993-1-1: fy, E = 210 GPa, G = 81 GPa)."});
  v.quantity("yield_strength", s.yield_strength, {.unit = "Pa", .shown = "MPa", .range = kPositive,
             .fallback = "the grade's", .example = "275 MPa", .doc = "fy, both ways; no partial factor is applied."});
  v.quantity("youngs_modulus", s.youngs_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "the grade's", .example = "210 GPa", .doc = "E."});
  v.quantity("shear_modulus", s.shear_modulus, {.unit = "Pa", .shown = "GPa", .range = kPositive,
             .fallback = "the grade's", .example = "81 GPa", .doc = "G."});
  v.text("joint", s.joint, {.fallback = kRequired, .example = "steel_contact",
         .doc = "Name of the joint material between it and what it touches: dry for contact alone, with strengths for a mortar bed."});
  v.quantity("gap", s.gap, {.unit = "m", .shown = "mm", .range = kNotNegative, .example = "5 mm",
             .doc = "Between it and the jambs and head of its opening at the start, up to 50 mm; the joint is dry then. Under a base beam there is none."});
  v.text("stage", s.stage, {.fallback = "the stage that cuts its opening, else the first", .example = "new opening",
         .doc = "Name of the stage of kind `cut` that puts it up, without force; before that it is not there."});
  v.table("anchors", s.anchors, {.in_braces = true, .optional = true, .fallback = "none",
          .doc = "Steel bars or studs that tie it to the masonry on both sides of its members, where masonry is."});
  v.table("wedges", s.wedges, {.in_braces = true, .optional = true, .fallback = "none",
          .doc = "Wedges or jacks between its beam and the masonry above, driven in by the stage that puts it up."});
  v.text("wall", s.wall, {.fallback = "x, y and z", .example = "front",
         .doc = "In space: the [[plan_wall]] in whose middle plane it stands; `line` and `round` are then of this wall."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "wall", .example = "0 m",
             .doc = "Or, for blocks in space: where its plane has x = y = 0, in the axes of the file."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "wall", .example = "0 m",
             .doc = "Likewise."});
  v.quantity("z", s.z, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "wall", .example = "0 m",
             .doc = "Likewise."});
  v.quantity("turn", s.turn, {.unit = "rad", .shown = "deg", .range = kAnyValue, .example = "90 deg",
             .doc = "Of its plane in plan, from x, seen with y up towards -z, with z up towards y."});
  v.table("hole", s.hole, {.in_braces = true, .optional = true, .fallback = "line",
          .doc = "For blocks in space: the opening that it stands in, in its plane."});
}

// clang-format on

}  // namespace wythe::io
