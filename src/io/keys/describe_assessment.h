// Keys of [project] and [assessment] (docs/theory/assessment.md); describe.h calls them.
#pragma once

#include "io/keys/key.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, ProjectSpec& s) {
  v.text("title", s.title, {.fallback = "none", .example = "School in Via Roma, street facade",
         .doc = "Of the work, for the sheet that is handed over."});
  v.text("client", s.client, {.fallback = "none", .example = "Town of Pavia", .doc = "For whom."});
  v.text("author", s.author, {.fallback = "none", .example = "A. Rossi, engineer",
         .doc = "Who answers for it."});
  v.text("date", s.date, {.fallback = "none", .example = "3 May 2027",
         .doc = "Of the assessment, in the writer's own words."});
  v.text("place", s.place, {.fallback = "none", .example = "Pavia", .doc = "Where the building stands."});
}

template <class Visitor>
void describe(Visitor& v, SpectrumSpec& s) {
  v.choice("kind", s.kind, kSpectrumKindWords, {.fallback = kRequired, .example = "en1998",
           .doc = "EN 1998-1 by ground type, NTC 2018 by the site's parameters, or a table."});
  v.quantity("ground_acceleration", s.ground_acceleration, {.unit = "m/s^2", .shown = "m/s^2",
             .range = kPositive, .fallback = "required but in a table", .example = "1.5 m/s^2",
             .doc = "ag on rock, of the return period of `limit_state`."});
  v.text("ground", s.ground, {.example = "B",
         .doc = "Ground type (EN 1998-1) or subsoil category (NTC 2018), A to E."});
  v.text("shape", s.shape, {.example = "1",
         .doc = "en1998: spectrum of type \"1\", or \"2\" (magnitudes up to 5.5)."});
  v.number("amplification", s.amplification, {.range = kPositive, .fallback = "required by ntc2018",
           .example = "2.45", .doc = "ntc2018: F0 of the site."});
  v.quantity("corner_period", s.corner_period, {.unit = "s", .shown = "s", .range = kPositive,
             .fallback = "required by ntc2018 and table", .example = "0.32 s",
             .doc = "ntc2018: TC* of the site; table: TC, below which a wall that yields goes farther "
                    "than an elastic one."});
  v.number("topography", s.topography, {.range = kFromOne, .example = "1.2",
           .doc = "ST of a hill or slope."});
  v.number("damping", s.damping, {.range = kBelowOne, .example = "0.05",
           .doc = "Viscous damping of the spectrum, as a share of the critical one; a table has its own."});
  v.quantities("periods", s.periods, {.unit = "s", .shown = "s", .range = kNotNegative,
               .fallback = "required by table", .example = "[\"0 s\", \"0.2 s\", \"2 s\"]",
               .doc = "table: periods, ascending from 0 s."});
  v.quantities("accelerations", s.accelerations, {.unit = "m/s^2", .shown = "m/s^2",
               .range = kNotNegative, .fallback = "required by table",
               .example = "[\"2 m/s^2\", \"5 m/s^2\", \"0.5 m/s^2\"]",
               .doc = "table: elastic accelerations there; straight in between."});
}

template <class Visitor>
void describe(Visitor& v, SpectraSpec& s) {
  v.table("operational", s.operational, {.optional = true, .fallback = "the limit state is not looked at",
          .doc = "circolare_2019: the spectrum of SLO, whose displacement is two thirds of that of damage limitation."});
  v.table("damage_limitation", s.damage_limitation, {.optional = true, .fallback = "spectrum",
          .doc = "SLD, or DL of EN 1998-3."});
  v.table("life_safety", s.life_safety, {.optional = true, .fallback = "spectrum",
          .doc = "SLV, or SD of EN 1998-3."});
  v.table("near_collapse", s.near_collapse, {.optional = true, .fallback = "spectrum",
          .doc = "SLC, or NC of EN 1998-3."});
}

template <class Visitor>
void describe(Visitor& v, HoldSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "tie", .doc = "A name for messages."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kDistance, .fallback = kRequired,
             .example = "6.0 m", .doc = "Above the wall's base."});
  v.quantity("force", s.force, {.unit = "N", .shown = "kN", .range = kPositive, .fallback = kRequired,
             .example = "25 kN", .doc = "With which it holds the part at most, level: the least of bar, anchor plate and masonry."});
  v.quantity("travel", s.travel, {.unit = "m", .shown = "mm", .range = kDistance,
             .fallback = "not known: it counts for the onset alone", .example = "40 mm",
             .doc = "How far the part goes at this height before it lets go. The check by displacement counts what holds to the end."});
}

template <class Visitor>
void describe(Visitor& v, TeethSpec& s) {
  v.integer("corners", s.corners, {.range = kFromOne, .fallback = "none", .example = "2",
            .doc = "Walls across that the part is toothed into."});
  v.quantity("length", s.length, {.unit = "m", .shown = "m", .range = kLength, .fallback = kRequired,
             .example = "0.3 m", .doc = "Of the teeth along the part: the thickness of a wall across."});
  v.quantity("course", s.course, {.unit = "m", .shown = "mm", .range = kLength, .fallback = kRequired,
             .example = "200 mm", .doc = "Height between the faces that slide on each other."});
  v.number("friction", s.friction, {.range = kNotNegative, .fallback = kRequired, .example = "0.5",
           .doc = "Tangent of the angle of friction there."});
}

template <class Visitor>
void describe(Visitor& v, PartSpec& s) {
  v.text("name", s.name, {.fallback = "its number", .example = "top storey", .doc = "A name for messages and tables."});
  v.quantity("foot", s.foot, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "the wall's base",
             .example = "6.0 m", .doc = "Height of the line that it turns about, above the wall's base."});
  v.quantity("head", s.head, {.unit = "m", .shown = "m", .range = kLength, .fallback = "the wall's top",
             .example = "9.0 m", .doc = "Height of its top."});
  v.quantity("left", s.left, {.unit = "m", .shown = "m", .range = kDistance, .fallback = "the wall's left end",
             .example = "1.0 m", .doc = "Left end, from the wall's left."});
  v.quantity("right", s.right, {.unit = "m", .shown = "m", .range = kLength, .fallback = "the wall's right end",
             .example = "4.0 m", .doc = "Right end."});
  v.choice("falls", s.falls, kFallWords, {.example = "outwards",
           .doc = "Away from the floors, or towards them. Floors bear on the inner side."});
  v.flag("head_held", s.head_held, {.example = "true",
         .doc = "A floor or tie holds the head: the part bends outwards between foot and head, about the line that gives the least."});
  v.quantity("lean", s.lean, {.unit = "rad", .shown = "deg", .range = kLean, .example = "1 deg",
             .doc = "Out of plumb, towards the fall."});
  v.quantity("inset", s.inset, {.unit = "m", .shown = "mm", .range = kDistance,
             .fallback = "by compressive strength, else 0", .example = "20 mm",
             .doc = "How far the line it turns about lies within the face, for masonry crushes there."});
  v.quantity("bearing", s.bearing, {.unit = "m", .shown = "mm", .range = kLength, .fallback = "of each floor",
             .example = "150 mm", .doc = "Depth of its floors' bearings, from the inner face. They press at the middle of it."});
  v.list("hold", s.hold, {.optional = true, .doc = "What holds it back: ties, anchored floors."});
  v.table("teeth", s.teeth, {.in_braces = true, .optional = true, .fallback = "none",
          .example = "{ corners = 2, length = \"0.3 m\", course = \"200 mm\", friction = 0.5 }",
          .doc = "Friction of its teeth in walls across. It counts for the onset alone, for teeth are pulled out."});
}

template <class Visitor>
void describe(Visitor& v, BuildingSpec& s) {
  v.quantity("base", s.base, {.unit = "m", .shown = "m", .range = kDistance, .example = "9 m",
             .doc = "How high the foot of this wall stands in it: of a gable or an upper storey that is drawn alone."});
  v.quantity("height", s.height, {.unit = "m", .shown = "m", .range = kLength, .fallback = "of the wall",
             .example = "10.5 m", .doc = "H, above the foundation."});
  v.quantity("period", s.period, {.unit = "s", .shown = "s", .range = kPositive, .fallback = "0.05 H^(3/4), with H in m",
             .example = "0.30 s", .doc = "T1, the first period across the wall."});
  v.integer("storeys", s.storeys, {.range = kFromOne, .fallback = "those of the model", .example = "3",
            .doc = "How many storeys it has; the share of the first mode follows."});
}

template <class Visitor>
void describe(Visitor& v, AssessmentSpec& s) {
  v.text("code", s.code, {.fallback = kRequired, .example = "circolare_2019",
         .doc = "Whose limit states: `circolare_2019` (with NTC 2018) or `en1998_3`."});
  v.text("limit_state", s.limit_state, {.example = "life_safety",
         .doc = "The limit state that the spectrum belongs to, whose verdict is given: "
                "`damage_limitation`, `life_safety`, `near_collapse`."});
  v.table("spectrum", s.spectrum, {.optional = true, .fallback = "no demand, capacity alone",
          .doc = "The elastic spectrum of the demand."});
  v.table("spectra", s.spectra, {.optional = true, .fallback = "that of limit_state alone is checked",
          .doc = "Spectra of limit states, each of its own return period: every limit state that has one is checked, and the "
                 "verdict is that of the one with the least reserve."});
  v.number("confidence_factor", s.confidence_factor, {.range = kFromOne,
           .fallback = "of masonry.knowledge_level, else none, and the page says so", .example = "1.2",
           .doc = "Of the knowledge level. Beside masonry.knowledge_level it is that of the level, by which the program divides; else only "
                  "said: strengths in the file are to be divided by it already."});
  v.number("masonry_share", s.masonry_share, {.range = kPositiveToOne, .example = "1",
           .doc = "Share of the masonry's own mass that the wall itself carries in an earthquake."});
  v.quantity("added_mass", s.added_mass, {.unit = "kg", .shown = "kg", .range = kNotNegative,
             .example = "12000 kg",
             .doc = "Mass that the wall carries in an earthquake beside its own and that of its loads: live "
                    "loads' share, floors that bear on other walls."});
  v.quantity("added_height", s.added_height, {.unit = "m", .shown = "m", .range = kDistance,
             .fallback = "moves as the control point", .example = "3.0 m",
             .doc = "Height above the wall's lowest point where that mass acts."});
  v.number("record_scatter", s.record_scatter, {.range = kNotNegative, .fallback = "none, and the page says so",
           .example = "0.3",
           .doc = "Campaigns: standard deviation of the logarithm of the demand from record to record, put "
                  "to the fragility's own scatter."});
  v.table("building", s.building, {.in_braces = true, .optional = true, .fallback = "as the model has it",
          .example = "{ height = \"10.5 m\", period = \"0.30 s\", storeys = 3 }",
          .doc = "`wythe limit --assessment`, `wythe assess`: the building, for the spectrum at the height of a part."});
  v.list("part", s.part, {.optional = true,
         .doc = "`wythe limit --assessment`, `wythe assess`: parts that may fall out of the wall's plane. Rules add each storey from its foot on, "
                "and what stands above the highest floor, where these do not cover it."});
}

// clang-format on

}  // namespace wythe::io
