// The description of structures that the builder makes in space: walls
// along plan lines, arches, domes (describe.h explains its form).
#pragma once

#include "io/keys/describe_building.h"
#include "io/keys/key.h"
#include "wythe/parts/builder.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, PlanRegionSpec& s) {
  v.text("name", s.name, {.fallback = "none", .example = "repaired corner", .doc = "A name for messages and `--set`."});
  describe_area(v, s.place);
  v.text("material", s.material, {.fallback = "the wall's", .example = "new_brick",
         .doc = "Name of its blocks' material: a density, and what `[[contact]]` calls them, so that joints within the region have a material of "
                "their own. The core of three wythes keeps its own."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength, .fallback = "the wall's",
             .example = "0.15 m",
             .doc = "Thickness of its masonry: thinner under a window or in a niche, thicker in a pilaster. For walls of one wythe."});
  v.quantity("offset", s.offset, {.unit = "m", .shown = "m", .range = kCoordinate, .example = "50 mm",
             .doc = "Distance of its middle plane from the wall's. For a line along +x it counts towards +z, or +y where z points up, "
                    "and it turns with the line."});
}

template <class Visitor>
void describe(Visitor& v, PlanWallSpec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "front",
         .doc = "Its blocks are called after it: front.c03u05a is course 3, unit 5, left half; front.lintel0; its support front.ground."});
  v.points("line", s.line, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = kRequired,
           .example = "[[\"0 m\", \"0 m\"], [\"4 m\", \"0 m\"]]",
           .doc = "Points of its middle plane in plan, [x, z], or [x, y] with wall.up = \"z\"; a corner at each inner "
                  "one. Where a line ends on another's end or middle the walls meet."});
  v.quantity("base", s.base, {.unit = "m", .shown = "m", .range = kDistance, .example = "2.9 m",
             .doc = "Height of its foot above the ground. Above 0 m it has no ground of its own: it stands on the wall or "
                    "slab below. Heights of openings count from here."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = "wall.height",
             .example = "2.4 m", .doc = "Height of the masonry, up to the foot of a gable."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "wall.thickness", .example = "0.25 m", .doc = "Of all wythes together."});
  v.text("bond", s.bond, {.fallback = "wall.bond", .example = "english", .doc = "As wall.bond; headers reach through all wythes."});
  v.text("fit", s.fit, {.fallback = "wall.fit", .example = "cut", .doc = "As wall.fit."});
  v.table("unit", s.unit, {.fallback = "wall.unit", .doc = "Its masonry unit: each key that is missing here is wall.unit's, `split` too."});
  v.integer("wythes", s.wythes, {.range = {.low = 1, .high = 3}, .example = "2",
            .doc = "Leaves through the thickness: one, two, or two with a core between them."});
  v.quantity("core", s.core, {.unit = "m", .shown = "m", .range = kLength, .fallback = "a third of the thickness",
             .example = "0.2 m", .doc = "Thickness of the core of three wythes."});
  v.integer("through_courses", s.through_courses, {.range = kFromZero, .fallback = "none", .example = "3",
            .doc = "Every how many courses through-stones tie the wythes together."});
  v.quantity("through_spacing", s.through_spacing, {.unit = "m", .shown = "m", .range = kLength,
             .fallback = "every unit of these courses", .example = "0.9 m",
             .doc = "Distance of through-stones along their course, to whole units."});
  v.quantity("gable", s.gable, {.unit = "m", .shown = "m", .range = kDistance, .example = "1.2 m",
             .doc = "Height of a gable's top above `height`, in the middle; units are cut along both slopes."});
  v.choice("meets", s.meets, kMeetingWords, {.example = "butted",
           .doc = "How it meets others. `toothed`: courses pass through by turns, at right angles, if both walls say "
                  "so. `butted`: a plane joint, at 45 degrees or more; at a corner the wall listed first goes through."});
  v.text("material", s.material, {.fallback = "masonry", .example = "old_stone",
         .doc = "Name of its blocks' material: a density, and what `[[contact]]` calls them, e.g. for a dry joint between "
                "two walls."});
  v.text("core_material", s.core_material, {.fallback = "material", .example = "rubble",
         .doc = "The same of the core of three wythes."});
  v.flag("ring_beam", s.ring_beam, {.example = "true",
         .doc = "A beam in the place of masonry: one course of segments, each as long as a unit, that bend and turn as a chain. Its material "
                "needs youngs_modulus and shear_modulus. Beams of one material that touch are cast together, round corners too."});
  v.list("opening", s.opening, {.optional = true,
         .doc = "As wall.opening; x counts from the wall's outer end at the first point of its line, corners included. "
                "A lintel is a chain of segments that bends where its material has youngs_modulus and shear_modulus, else "
                "one rigid block, or with model = zones one deformable block; a sill is rigid."});
  v.list("region", s.region, {.optional = true,
         .doc = "Parts of its masonry with another material or thickness. A block belongs to the last region that holds its "
                "centre, edge included. x counts as for openings, y from the wall's foot."});
}

template <class Visitor, class Spec>
void describe_place(Visitor& v, Spec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "vault", .doc = "Its blocks are called after it: vault.c03u05 is course 3, unit 5."});
  v.quantity("x", s.x, {.unit = "m", .shown = "m", .range = kCoordinate, .example = "0 m", .doc = "Middle of its springing."});
  v.quantity("y", s.y, {.unit = "m", .shown = "m", .range = kCoordinate, .example = "0 m", .doc = "The same."});
  v.quantity("z", s.z, {.unit = "m", .shown = "m", .range = kCoordinate, .example = "0 m", .doc = "The same."});
}

template <class Visitor, class Spec>
void describe_shell(Visitor& v, Spec& s) {
  v.quantity("span", s.span, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired, .example = "4 m",
             .doc = "Clear width at the springing, of the intrados."});
  v.quantity("rise", s.rise, {.unit = "m", .shown = "m", .range = kLength, .fallback = "half the span",
             .example = "1.2 m", .doc = "Of the intrados above the springing."});
  v.quantity("depth", s.depth, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "0.3 m", .doc = "Of the voussoirs, from intrados to extrados."});
}

template <class Visitor, class Spec>
void describe_stones(Visitor& v, Spec& s) {
  v.text("bond", s.bond, {.fallback = "running", .example = "stack",
         .doc = "`running` breaks joints from course to course; `stack` lets them run through."});
  v.text("material", s.material, {.fallback = "masonry", .example = "tuff",
         .doc = "Name of the voussoirs' material: a density, and what `[[contact]]` calls them."});
  v.flag("springers", s.springers, {.example = "false",
         .doc = "Fixed blocks that it springs from; without them it stands on what is there."});
}

template <class Visitor>
void describe(Visitor& v, StandingArchSpec& s) {
  describe_place(v, s);
  v.quantity("turn", s.turn, {.unit = "rad", .shown = "deg", .range = kAnyValue, .example = "90 deg",
             .doc = "Of the span in plan, from x, seen with y up towards -z, with z up towards y."});
  describe_shell(v, s);
  v.quantity("width", s.width, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "1 m", .doc = "Across the span: of a barrel vault its length."});
  v.integer("voussoirs", s.voussoirs, {.range = kFromZero, .fallback = kRequired, .example = "21", .doc = "Along the span."});
  v.integer("units", s.units, {.range = kFromOne, .example = "6", .doc = "Along the width: more than one make a barrel vault."});
  describe_stones(v, s);
}

template <class Visitor>
void describe(Visitor& v, DomeSpec& s) {
  describe_place(v, s);
  describe_shell(v, s);
  v.integer("courses", s.courses, {.range = kFromZero, .fallback = kRequired, .example = "12", .doc = "Below the keystone or eye."});
  v.integer("units", s.units, {.range = kFromZero, .fallback = kRequired, .example = "16", .doc = "In each course."});
  v.quantity("oculus", s.oculus, {.unit = "m", .shown = "m", .range = kDistance, .example = "0.6 m",
             .doc = "Clear diameter of an eye at the crown; 0 m for a keystone."});
  describe_stones(v, s);
}

template <class Visitor>
void describe(Visitor& v, SlabSpec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "first_floor", .doc = "Its block is called so."});
  v.texts("walls", s.walls, {.fallback = "outline", .example = "[\"front\", \"back\"]",
          .doc = "Plan walls that it rests on: two parallel ones, or three or four sides of a rectangle. It reaches into each by "
                 "`bearing`, and ends before walls beside it by `gap`."});
  v.points("outline", s.outline, {.unit = "m", .shown = "m", .range = kCoordinate, .fallback = "walls",
           .example = "[[\"0 m\", \"0 m\"], [\"4 m\", \"0 m\"], [\"4 m\", \"3 m\"], [\"0 m\", \"3 m\"]]",
           .doc = "In the place of walls: its corners in plan, in turn, as the points of a plan wall's line."});
  v.quantity("level", s.level, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "the top of its walls",
             .example = "2.7 m", .doc = "Height of its underside, within 10 mm of a bed joint of each wall that carries it. Below a wall's "
                                        "top it lies in a pocket: the units are cut."});
  v.quantity("thickness", s.thickness, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "0.2 m", .doc = "Of the slab, by which it weighs."});
  v.quantity("bearing", s.bearing, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "with walls: needed",
             .example = "120 mm", .doc = "How far it reaches into each of these walls, from the face towards the slab."});
  v.quantity("gap", s.gap, {.unit = "m", .shown = "mm", .range = kDistance, .example = "20 mm",
             .doc = "Between it and walls beside it that do not carry it; at 0 m it touches them, and pushes them as they push it."});
  v.text("material", s.material, {.fallback = kRequired, .example = "concrete",
         .doc = "Name of its material: a density, and what `[[contact]]` calls it."});
  v.text("joint", s.joint, {.fallback = "as of masonry", .example = "bearing",
         .doc = "Joint material of all its faces, on, beside and below masonry. `[[contact]]` goes first."});
  v.quantity("load", s.load, {.unit = "Pa", .shown = "kPa", .range = kNotNegative, .example = "2.5 kPa",
             .doc = "Load on all of it beside its own weight, downwards; it becomes a `[[floor]]` of its name."});
  v.quantity("mass", s.mass, {.unit = "kg/m^2", .shown = "kg/m^2", .range = kNotNegative, .example = "250 kg/m^2",
             .doc = "Inertia beside its own that moves with it. Not needed for weight or for patterns of forces "
                    "(docs/theory/integration.md); a shake needs it."});
}

template <class Visitor>
void describe(Visitor& v, BuilderSpec& s) {
  v.list("plan_wall", s.plan_wall, {.optional = true,
         .doc = "Walls in space along lines in plan, one table each (docs/theory/builder.md). What one leaves out is the "
                "wall's. Tables of the builder become bodies when the file is read: a run's folder holds them as "
                "blocks.json. A study may vary their numbers, e.g. plan_wall.front.thickness."});
  v.list("slab", s.slab, {.optional = true,
         .doc = "Floor slabs, each one rigid body that lies on walls, or in pockets cut into them, by joints."});
  v.list("arch", s.arch, {.optional = true, .doc = "Arches and barrel vaults that stand in space."});
  v.list("dome", s.dome, {.optional = true, .doc = "Domes in space."});
}

// clang-format on

}  // namespace wythe::io
