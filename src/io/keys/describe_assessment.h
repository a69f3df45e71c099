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
}

// clang-format on

}  // namespace wythe::io
