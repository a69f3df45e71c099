// The keys of a shake, of its records and of the points whose motion is recorded (describe.h).
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/wall_spec.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, RecordSpec& s) {
  v.text("file", s.file, {.fallback = "a pulse, or accelerations", .example = "aigio.csv",
         .doc = "Record of accelerations, relative to the model file: a table of numbers with a head or none (CSV and its "
                "kin, decimals behind a point or a comma), AT2, ESM, K-NET or one channel of COSMOS. `wythe check` tells what was read."});
  v.text("column", s.column, {.fallback = "the one named so", .example = "acceleration",
         .doc = "Column of a table that holds the accelerations: its head, or its number from 1. Needed where none or "
                "several are named as accelerations (acc, a, a unit such as [g]) or as directions (ns, east); of two "
                "columns without a head it is the second. Times are the column called time, t, time_s or t_s, or the "
                "first of two."});
  v.choice("unit", s.unit, kRecordUnitWords, {.fallback = "what the file states", .example = "g",
           .doc = "Unit of the accelerations; g is `solve.gravity`. Needed by a list, and by a file that states none; another "
                  "than the file's is refused."});
  v.quantity("step", s.step, {.unit = "s", .shown = "s", .range = kPositive,
             .fallback = "the times given", .example = "0.005 s",
             .doc = "Time between accelerations that stand without times, or beside numbers of rows: those that rise by more than "
                    "0.5 s a row under a head that states no seconds. Another than that of the file is refused."});
  v.numbers("times", s.times, {.fallback = "every `step`", .example = "[0, 0.01, 0.02]",
            .doc = "Times of `accelerations` in seconds; they rise."});
  v.numbers("accelerations", s.accelerations, {.fallback = "a file, or a pulse", .example = "[0, 0.2, -0.1]",
            .doc = "The record itself, in `unit`. Between its numbers it is linear."});
  v.choice("pulse", s.pulse, kPulseShapeWords, {.fallback = "a file, or accelerations", .example = "half_cycle",
           .doc = "A pulse in the place of a record: half a sine or a whole one of `period`, or a wavelet of "
                  "Ricker whose main frequency is 1 / period."});
  v.quantity("amplitude", s.amplitude, {.unit = "m/s^2", .shown = "m/s^2", .range = kAnyValue,
             .fallback = "needed by a pulse", .example = "3 m/s^2", .doc = "Peak acceleration of the pulse."});
  v.quantity("period", s.period, {.unit = "s", .shown = "s", .range = kPositive,
             .fallback = "needed by a pulse", .example = "0.5 s", .doc = "Period of the pulse."});
  v.choice("direction", s.direction, kDirectionWords, {.example = "+x",
           .doc = "Which way the base moves where the record is positive; each axis has one record at most."});
  v.table("at", s.at, {.in_braces = true, .optional = true, .fallback = "the base",
          .example = "{ block = \"floor*\" }",
          .doc = "What moves so in the place of the base: blocks, or in space supports too. All that follows "
                 "no such record moves with the base."});
  v.text("hash", s.hash, {.fallback = "not compared", .example = "9ae16a3b2f90404f",
         .doc = "Written by the program: fingerprint of the file's numbers. A file with others is refused."});
}

template <class Visitor>
void describe(Visitor& v, ScaleSpec& s) {
  v.number("factor", s.factor, {.range = kAnyValue, .fallback = "1", .example = "1.5",
           .doc = "Factor on all components; negative turns them round."});
  v.quantity("pga", s.pga, {.unit = "m/s^2", .shown = "m/s^2", .range = kPositive,
             .fallback = "none", .example = "3 m/s^2",
             .doc = "Peak acceleration that the first component gets; the others keep their ratio to it."});
  v.quantity("pgv", s.pgv, {.unit = "m/s", .shown = "m/s", .range = kPositive,
             .fallback = "none", .example = "0.3 m/s",
             .doc = "Peak velocity that the first component gets."});
  v.quantity("sa", s.sa, {.unit = "m/s^2", .shown = "m/s^2", .range = kPositive,
             .fallback = "none", .example = "5 m/s^2",
             .doc = "Pseudo-acceleration that the first component gets at `period` and `damping`."});
  v.quantity("period", s.period, {.unit = "s", .shown = "s", .range = kSpectralPeriod,
             .fallback = "needed by sa", .example = "0.3 s", .doc = "Period of `sa`."});
  v.number("damping", s.damping, {.range = kBelowOne, .fallback = "0.05", .example = "0.05",
           .doc = "Of critical, of `sa`."});
}

template <class Visitor>
void describe(Visitor& v, ViscousSpec& s) {
  v.number("fraction", s.fraction, {.range = kBelowOne, .fallback = kRequired, .example = "0.02",
           .doc = "Of critical damping, at `frequency`."});
  v.quantity("frequency", s.frequency, {.unit = "1/s", .shown = "Hz", .range = kPositive,
             .fallback = kRequired, .example = "4 Hz", .doc = "Where the fraction is met."});
}

template <class Visitor>
void describe(Visitor& v, HistorySpec& s) {
  v.text("name", s.name, {.fallback = kRequired, .example = "top",
         .doc = "Its name in `history.csv`."});
  v.table("at", s.at, {.in_braces = true, .fallback = kRequired,
          .example = "{ x = \"0 m\", y = \"3 m\" }",
          .doc = "The point, on the block there; or the centre of a block by its id."});
}

template <class Visitor>
void describe_shaking(Visitor& v, ShakeStage& s, Kinds shake) {
  v.list("record", s.record, {.kinds = shake, .in_braces = true, .optional = true, .fallback = kRequired,
         .doc = "How the base moves: one table for each direction, or one inline table. A second motion of "
                "some blocks or supports names them with `at`."});
  v.table("scale", s.scale, {.kinds = shake, .in_braces = true, .optional = true, .fallback = "as recorded",
          .example = "{ pga = \"3 m/s^2\" }",
          .doc = "One of `factor`, `pga`, `pgv` and `sa` (with `period`), for all components by one factor."});
  v.quantity("free_vibration", s.free_vibration, {.unit = "s", .shown = "s", .range = kNotNegative,
             .kinds = shake, .example = "2 s", .doc = "How long the wall is watched after the record."});
  v.quantity("interval", s.interval, {.unit = "s", .shown = "s", .range = kPositive, .kinds = shake,
             .fallback = "5 ms, or the shake by 4000", .example = "0.01 s",
             .doc = "Time between rows of `history.csv`. Peaks are read from them, so they lie 10 ms apart at most, "
                    "or the shake by 4000."});
  v.table("mass_damping", s.mass_damping, {.kinds = shake, .in_braces = true, .optional = true,
          .fallback = "none", .example = "{ fraction = 0.02, frequency = \"4 Hz\" }",
          .doc = "Viscous damping in proportion to mass, of motion against the base. It brakes rocking and "
                 "falling too; it does not shorten the time step."});
  v.table("joint_damping", s.joint_damping, {.kinds = shake, .in_braces = true, .optional = true,
          .fallback = "none", .example = "{ fraction = 0.02, frequency = \"20 Hz\" }",
          .doc = "Dashpots at closed points in proportion to their stiffness: the fraction grows with "
                 "frequency. They shorten the time step, often many times; a note says how often."});
  v.table("maxwell_damping", s.maxwell_damping, {.kinds = shake, .in_braces = true, .optional = true,
          .fallback = "none", .example = "{ fraction = 0.05, frequency = \"10 Hz\" }",
          .doc = "A spring and a dashpot in series beside each closed contact: the fraction is largest at its frequency f, "
                 "and 2 f f' / (f^2 + f'^2) of that at f'. Rigid motion is free of it, and it hardly shortens the time "
                 "step: 5 % by a tenth."});
  v.number("restitution", s.restitution, {.range = {.low = 0, .high = 1}, .kinds = shake,
           .fallback = "1: elastic", .example = "0.1",
           .doc = "Share of its speed with which a block comes back that falls flat on another or on the "
                  "ground, by dashpots at closed points; 0 stands for less than 0.05."});
}

// clang-format on

}  // namespace wythe::io
