// The keys of walls in space, beside those of every wall (describe.h).
#pragma once

#include "io/keys/key.h"
#include "io/keys/stage_records.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe_space(Visitor& v, WallSpec& s) {
  v.text("up", s.up, {.fallback = "z in OBJ, PLY, STL and COMPAS files, y in others", .example = "z",
         .doc = "In space: the axis of the blocks file that points up, `y` or `z`. Places and directions "
                "in the model file are in the file's axes; the height of a `[[diaphragm]]` is y with both."});
  v.texts("supports", s.supports, {.fallback = "those the file marks", .example = "[\"foot*\"]",
          .doc = "In space: blocks of the file that stand still, by id, or all whose ids begin so with "
                 "* at the end; `lowest` are those that reach down to the lowest point."});
}

template <class Visitor>
void describe_space(Visitor& v, StageRecords& r, Kinds directed, Kinds load) {
  v.numbers("along", r.push.drive.along, {.kinds = directed | load, .fallback = "direction; of force and line_load: downwards",
            .example = "[1, 0, 0.5]",
            .doc = "In space: any direction as a vector, in the place of `direction`."});
  v.quantity("force", r.load.force, {.unit = "N", .shown = "kN", .range = kNotNegative, .kinds = load,
             .fallback = "one of the loads, or floors", .example = "20 kN",
             .doc = "In space: a load at one point, `at`: a point of a block, or a block's centroid. It keeps its "
                    "direction and goes along with its block."});
  v.quantity("line_load", r.load.line_load, {.unit = "N/m", .shown = "kN/m", .range = kNotNegative, .kinds = load,
             .fallback = "one of the loads, or floors", .example = "12 kN/m",
             .doc = "In space: a load along the line from `from` to `to`, on the faces of blocks that look "
                    "against it there."});
  v.table("from", r.load.from, {.kinds = load, .in_braces = true, .optional = true, .fallback = "needed by line_load",
          .example = "{ x = \"0 m\", y = \"2.7 m\", z = \"0 m\" }", .doc = "In space: one end of that line."});
  v.table("to", r.load.to, {.kinds = load, .in_braces = true, .optional = true, .fallback = "needed by line_load",
          .example = "{ x = \"4 m\", y = \"2.7 m\", z = \"0 m\" }", .doc = "The other end."});
  v.table("on", r.push.on, {.kinds = load, .in_braces = true, .optional = true, .fallback = "every block",
          .example = "{ block = \"leaf*\" }",
          .doc = "In space: the blocks whose free faces the pressure acts on."});
  v.text("face", r.load.face, {.kinds = load, .fallback = "up: +y, or +z where z points up",
         .example = "-z",
         .doc = "In space: where those faces look. The pressure acts against that direction and keeps "
                "its own."});
}

template <class Visitor>
void describe_space(Visitor& v, SolveSpec& s) {
  v.choice("damping_form", s.damping_form, kDampingFormWords, {.example = "components",
           .doc = "In space: local damping of force and moment as vectors, which knows no axes, or of "
                  "each component in the wall's axes, as in the paper."});
}

// clang-format on

}  // namespace wythe::io
