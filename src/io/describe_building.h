// The description of a building's masonry: units, mortar, storeys and regions (describe.h says how to read it).
#pragma once

#include "io/key.h"
#include "wythe/wall_spec.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, MortarSpec& s) {
  v.quantity("bed", s.bed, {.unit = "m", .shown = "mm", .range = kDistance, .fallback = "head",
             .example = "10 mm", .doc = "Thickness of a bed joint."});
  v.quantity("head", s.head, {.unit = "m", .shown = "mm", .range = kDistance, .fallback = "bed",
             .example = "10 mm", .doc = "Thickness of a head joint; 0 mm where units stand without mortar."});
}

inline constexpr const char* kMortarDoc =
    "Thickness of the mortar. With it length, height and width are those of the bare unit, and a wall or storey may "
    "measure n units with n - 1 joints; without it they include the joint.";

template <class Visitor>
void describe(Visitor& v, UnitSpec& s) {
  v.quantity("length", s.length, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = kRequired, .example = "310 mm",
             .doc = "Nominal length of a unit, head joint included (without it where `mortar` is given); fitted to "
                    "whole half units."});
  v.quantity("height", s.height, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = kRequired, .example = "110 mm",
             .doc = "Nominal course height, bed joint included (without it where `mortar` is given); fitted to whole "
                    "courses."});
  v.quantity("width", s.width, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "half the length", .example = "155 mm",
             .doc = "Width of a header's face, joint included (flemish, english, header bond)."});
  v.choice("split", s.split, kSplitWords, {.example = "middle",
           .doc = "Potential crack planes inside the units: down the middle of each stretcher; in "
                  "line with the head joints above and below, where cracks go through (in running "
                  "bond the same); or none."});
  v.quantity("density", s.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kPositive,
             .fallback = kRequired, .example = "1250 kg/m^3",
             .doc = "Density of the masonry, units and mortar together."});
  v.table("mortar", s.mortar, {.in_braces = true, .optional = true, .fallback = "sizes include the joint",
          .doc = kMortarDoc});
}

// Names of joint materials, of the wall or of a part of it.
template <class Visitor>
void describe_joints(Visitor& v, MasonryJoints& s, const char* joint, const char* head, const char* unit) {
  v.text("joint", s.joint, {.fallback = joint, .example = "old_mortar",
         .doc = "Name of the material of the masonry's bed joints."});
  v.text("head_joint", s.head_joint, {.fallback = head, .example = "dry",
         .doc = "Name of that of its head joints: filled badly, or dry (no tensile strength, no cohesion)."});
  v.text("unit_joint", s.unit_joint, {.fallback = unit, .example = "unit",
         .doc = "Name of that of the crack planes inside its units."});
}

template <class Visitor>
void describe(Visitor& v, StoreySpec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "ground",
         .doc = "Its name, different from the other storeys'; openings, floors and regions name it, and "
                "`--set storey.ground.height=...`."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "3.25 m", .doc = "From its foot to that of the storey above."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "wall.thickness", .example = "0.38 m",
             .doc = "Its masonry's thickness. A joint between two thicknesses has the smaller one; the eccentricity "
                    "out of the plane is not modelled."});
  v.text("bond", s.bond, {.fallback = "wall.bond", .example = "flemish", .doc = "As wall.bond."});
  v.table("unit", s.unit, {.fallback = "wall.unit",
          .doc = "Its masonry unit: each key that is missing here is wall.unit's, `split` too."});
  describe_joints(v, s.joints, "wall.joint", "wall.head_joint", "wall.unit_joint");
}

template <class Visitor>
void describe(Visitor& v, RegionSpec& s) {
  v.text("name", s.name, {.fallback = "none", .example = "repaired corner", .doc = "A name for messages and `--set`."});
  v.text("storey", s.storey, {.fallback = "none", .example = "ground",
         .doc = "Name of a storey: the whole of it where nothing else says where; else piers are counted in it and y "
                "from its foot."});
  v.integer("pier", s.pier, {.range = kFromZero, .fallback = "none", .example = "1",
            .doc = "Which pier of the storey, from the left, the first is 1: the strip between two openings over the "
                   "storey's whole height."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "none", .example = "1.20 m",
             .doc = "Left end of a box."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "none", .example = "0 m",
             .doc = "Its lower end, above the wall's base or the storey's foot."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength, .fallback = "none", .example = "0.9 m",
             .doc = "Its width."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = "none",
             .example = "1.1 m", .doc = "Its height."});
  v.points("polygon", s.polygon, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "none",
           .example = "[[\"0 m\", \"0 m\"], [\"1 m\", \"0 m\"], [\"0 m\", \"2 m\"]]",
           .doc = "Or its corners (x, y), once around."});
  describe_joints(v, s.joints, "as around it", "as around it, or joint", "as around it");
  v.quantity("density", s.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kPositive,
             .fallback = "as around it", .example = "1900 kg/m^3", .doc = "Density of its masonry."});
}

// clang-format on

}  // namespace wythe::io
