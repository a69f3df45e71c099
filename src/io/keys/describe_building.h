// The description of a building's masonry: units, mortar, openings, storeys, ring beams and regions (describe.h says how to read it).
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/wall_spec.h"

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
void describe(Visitor& v, RealUnitSpec& s) {
  v.quantity("length", s.length, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "as drawn",
             .example = "250 mm", .doc = "Length of a unit as it was built; the drawn one is a whole number of it."});
  v.quantity("height", s.height, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "as drawn",
             .example = "65 mm", .doc = "Height of a course as it was built; the drawn one is a whole number of it."});
}

inline constexpr const char* kRealUnitDoc =
    "Size of the units as they were built, where the model draws them larger; joints count as in length and height. "
    "Nothing is computed from it: the program says what a wall of such large units is worth, and a verdict on it is "
    "not to be signed.";

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
  v.table("real", s.real, {.in_braces = true, .optional = true, .fallback = "units are drawn as they are",
          .doc = kRealUnitDoc});
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
void describe(Visitor& v, LintelSpec& s) {
  v.text("kind", s.kind, {.fallback = "no lintel", .example = "timber",
         .doc = "What it is made of; only a label: timber, stone, concrete, steel, brick. Its "
                "presence makes the lintel; any other word gets a note."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "needed with a lintel", .example = "110 mm",
             .doc = "Structural depth; the lintel occupies the nearest whole number of courses."});
  v.quantity("bearing", s.bearing, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "needed with a lintel", .example = "150 mm",
             .doc = "Length of support on each side of the opening; becomes whole half units, by a factor "
                    "of two at most."});
  v.text("material", s.material, {.fallback = "needed with a lintel", .example = "timber",
         .doc = "Name of the material with the lintel's density and moduli."});
  v.text("bond", s.bond, {.example = "joint",
         .doc = "Name of the joint material between lintel and masonry."});
  v.text("bearing_bond", s.bearing_bond, {.fallback = "bond", .example = "joint",
         .doc = "Joint material of the faces the lintel rests on, where it differs."});
  v.text("top_bond", s.top_bond, {.fallback = "bond", .example = "joint",
         .doc = "Joint material of the masonry that lies on the lintel, where it differs."});
  v.choice("model", s.model, kLintelModelWords, {.example = "zones",
           .doc = "A chain of rigid segments, or one deformable block of zones."});
  v.integer("zones", s.zones, {.range = kFromOne, .example = "2",
            .doc = "Zones through the depth, with model = zones."});
  v.quantity("zone_length", s.zone_length, {.unit = "m", .shown = "mm", .range = kLength,
             .fallback = "as long as deep", .example = "55 mm",
             .doc = "Length of a zone along the lintel, fitted to a whole number of zones; in space also through the thickness."});
  v.choice("zone_kind", s.zone_kind, kZoneKindWords, {.example = "mixed",
           .doc = "Constant-strain triangles as they are (`cst`, locking), or with one volumetric "
                  "strain for a whole zone (`mixed`)."});
  v.choice("plane", s.plane, kPlaneWords, {.example = "stress",
           .doc = "Plane stress, or plane strain."});
}

template <class Visitor>
void describe(Visitor& v, ArchSpec& s) {
  v.choice("kind", s.kind, kArchKindWords, {.fallback = "no arch", .example = "segmental",
           .doc = "Its presence makes the arch. `flat`: level, joints inclined to one centre; `segmental`: part of a "
                  "circle; `round`: half of one."});
  v.quantity("rise", s.rise, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "needed if segmental",
             .example = "150 mm",
             .doc = "Of the intrados above the springing, half the span at most; segmental arches only."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "needed with an arch",
             .example = "250 mm", .doc = "Of the voussoirs, from intrados to extrados."});
  v.quantity("skewback", s.skewback, {.unit = "rad", .shown = "deg", .range = kSkewback, .fallback = "needed if flat",
             .example = "15 deg", .doc = "Angle of the end joints from upright; flat arches only."});
  v.integer("voussoirs", s.voussoirs, {.range = kFromZero, .fallback = "as many as courses are high",
            .example = "11", .doc = "Their number; 0: as many as fit along the intrados when each is as wide as a "
            "course is high, and an odd number, for a keystone."});
  v.text("joint", s.joint, {.fallback = "as the bed joints around", .example = "joint",
         .doc = "Name of the joint material between voussoirs."});
  v.text("material", s.material, {.fallback = "the masonry's", .example = "tuff",
         .doc = "Name of a material whose density the voussoirs have."});
}

template <class Visitor>
void describe(Visitor& v, SillSpec& s) {
  v.text("kind", s.kind, {.fallback = "no sill", .example = "stone",
         .doc = "What it is made of; only a label, as a lintel's. Its presence makes the sill."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "needed with a sill",
             .example = "110 mm", .doc = "Structural depth; it occupies the nearest whole number of courses."});
  v.quantity("bearing", s.bearing, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "needed with a sill",
             .example = "150 mm",
             .doc = "How far it reaches into the masonry on each side; becomes whole half units, by a factor of two "
                    "at most."});
  v.text("material", s.material, {.fallback = "needed with a sill", .example = "stone",
         .doc = "Name of the material with its density and moduli. It bends as a chain of rigid segments and does "
                "not crack."});
  v.text("joint", s.joint, {.example = "joint", .doc = "Name of the joint material between sill and masonry."});
}

template <class Visitor>
void describe(Visitor& v, OpeningSpec& s) {
  v.text("name", s.name, {.fallback = "none", .example = "door",
         .doc = "A name for messages and for `--set wall.opening.door.width=...`."});
  v.text("storey", s.storey, {.fallback = "the whole wall", .example = "ground",
         .doc = "Name of its storey: y then counts from the storey's foot. An opening lies in one storey."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kDistance, .fallback = kRequired,
             .example = "1.70 m", .doc = "Left jamb, from the wall's left end."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kDistance, .fallback = kRequired,
             .example = "0.90 m", .doc = "Sill above the wall's base, or its storey's foot; 0 m for a door."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = kRequired, .example = "1.70 m", .doc = "Clear width."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = kRequired, .example = "2.64 m", .doc = "Clear height, sill to soffit; under an arch up to its springing."});
  v.table("lintel", s.lintel, {.in_braces = true, .optional = true, .fallback = "no lintel",
          .doc = "The lintel over the opening."});
  v.table("sill", s.sill, {.in_braces = true, .optional = true, .fallback = "no sill",
          .doc = "A stone or beam below it, laid as a lintel is above."});
  v.table("arch", s.arch, {.in_braces = true, .optional = true, .fallback = "no arch",
          .doc = "An arch of voussoirs over it, in the place of a lintel (docs/theory/conventions.md)."});
  v.text("cut", s.cut, {.fallback = "built with the wall", .example = "new opening",
         .doc = "Name of the stage of kind `cut` in which it is cut out of standing masonry; its lintel is put in then."});
}

template <class Visitor>
void describe(Visitor& v, FoundationStep& s) {
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kDistance, .fallback = kRequired, .example = "3.10 m",
             .doc = "Where the step begins, from the wall's left; it ends where the next one begins. The first begins "
                    "at 0 m."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kDistance, .fallback = kRequired, .example = "0.55 m",
             .doc = "Its height above the wall's base, which is the lowest step."});
}

template <class Visitor>
void describe(Visitor& v, RingBeamSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "roof",
         .doc = "A name for messages and for `--set ring_beam.roof.height=...`."});
  v.text("storey", s.storey, {.fallback = "y", .example = "first",
         .doc = "Name of the storey at whose top its upper side lies."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "storey", .example = "2.86 m",
             .doc = "Or the height of its foot above the wall's base; moves to the nearest bed joint."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "the wall's left end",
             .example = "0 m", .doc = "Left end; moves to the nearest half unit."});
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "up to the wall's right end", .example = "4.80 m",
             .doc = "How much of the wall's length it takes; so does its right end."});
  v.quantity("height", s.height, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "250 mm",
             .doc = "Of its section, for stiffness and weight; it occupies the nearest whole number of courses."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "the masonry's there", .example = "0.25 m", .doc = "Of its section."});
  v.text("material", s.material, {.fallback = kRequired, .example = "concrete",
         .doc = "Name of the material with its density and moduli. It does not crack or yield."});
  v.text("joint", s.joint, {.example = "joint",
         .doc = "Name of the joint material between it and the masonry below and beside it."});
  v.text("top_joint", s.top_joint, {.fallback = "joint", .example = "joint",
         .doc = "Of the masonry that lies on it, where it differs."});
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
  v.text("fit", s.fit, {.fallback = "wall.fit", .example = "cut", .doc = "As wall.fit."});
  v.table("unit", s.unit, {.fallback = "wall.unit",
          .doc = "Its masonry unit: each key that is missing here is wall.unit's, `split` too."});
  describe_joints(v, s.joints, "wall.joint", "wall.head_joint", "wall.unit_joint");
}

// Pier, box or polygon of a region.
template <class Visitor>
void describe_area(Visitor& v, RegionPlace& s) {
  v.integer("pier", s.pier, {.range = kFromZero, .fallback = "none", .example = "1",
            .doc = "Which pier, counted from 1 at the left, or at the first point of a line in plan: the strip between two openings over the whole height "
                   "of the storey or wall."});
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
}

template <class Visitor>
void describe(Visitor& v, RegionSpec& s) {
  v.text("name", s.name, {.fallback = "none", .example = "repaired corner", .doc = "A name for messages and `--set`."});
  v.text("storey", s.place.storey, {.fallback = "none", .example = "ground",
         .doc = "Name of a storey: the whole of it where nothing else says where; else piers are counted in it and y "
                "from its foot."});
  describe_area(v, s.place);
  describe_joints(v, s.joints, "as around it", "as around it, or joint", "as around it");
  v.quantity("density", s.density, {.unit = "kg/m^3", .shown = "kg/m^3", .range = kPositive,
             .fallback = "as around it", .example = "1900 kg/m^3", .doc = "Density of its masonry."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength, .fallback = "as around it",
             .example = "0.15 m",
             .doc = "Thickness of its masonry out of the plane: thinner under a window or in a niche, thicker in a pilaster, "
                    "or what acts of a wall across (docs/howto/cross_walls.md). A joint is as thick as the thinner of its blocks."});
}

// clang-format on

}  // namespace wythe::io
