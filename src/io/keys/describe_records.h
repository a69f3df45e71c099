// The keys of a study over records, for the same visitors as describe.h.
//
//   describe(v, ShakingSpec)      [shaking], but for its records and limit states
//   describe(v, LimitStateSpec)   [[limit_state]]
//
// The unit of an intensity follows from `measure`, so that key comes before the others.
#pragma once

#include "io/keys/key.h"
#include "wythe/parts/study.h"

namespace wythe::io {

// clang-format off

template <class Visitor>
void describe(Visitor& v, ShakingSpec& s) {
  v.text("stage", s.stage, {.fallback = "the only one with a record", .example = "quake",
         .doc = "Stage of the base model whose record is exchanged."});
  v.choice("measure", s.measure, kIntensityMeasureWords, {.fallback = kRequired, .example = "pga",
           .doc = "What the intensity is: peak acceleration, peak velocity, or pseudo-acceleration, of the first component."});
  const char* const unit = unit_of(s.measure);
  const char* const example = s.measure == IntensityMeasure::kPgv ? "0.2 m/s" : "2 m/s^2";
  const Key amount{.unit = unit, .shown = unit, .range = kPositive, .fallback = "none", .example = example};
  const auto with = [&](const char* doc) { Key key = amount; key.doc = doc; return key; };
  v.quantity("period", s.period, {.unit = "s", .shown = "s", .range = kSpectralPeriod, .fallback = "needed by sa",
             .example = "0.3 s", .doc = "Period of `sa`."});
  v.number("damping", s.damping, {.range = kBelowOne, .fallback = "needed by sa", .example = "0.05",
           .doc = "Of critical, of `sa`."});
  Key levels = with("Intensities at which each record is run.");
  levels.example = s.measure == IntensityMeasure::kPgv ? R"(["0.2 m/s", "0.4 m/s"])"
                                                       : R"(["1 m/s^2", "2 m/s^2"])";
  v.quantities("levels", s.levels, levels);
  v.quantity("from", s.first, with("In the place of `levels`: the first intensity; then `step` higher, until the wall collapses or `most` is passed."));
  v.quantity("step", s.step, with("From one intensity to the next."));
  v.quantity("most", s.most, with("No intensity is higher."));
  v.integer("halvings", s.halvings, {.range = {.low = 0, .high = 20}, .fallback = "0", .example = "2",
            .doc = "How often the way between the highest intensity that stood and the one that fell is halved."});
  v.choice("pairing", s.pairing, kPairingWords, {.fallback = "each", .example = "each",
           .doc = "Each sample meets each record, or sample i the record i, in turn."});
}

template <class Visitor>
void describe(Visitor& v, LimitStateSpec& s) {
  const Key drift{.unit = "1", .shown = "%", .range = kPositive, .fallback = "none", .example = "1 %"};
  const Key way{.unit = "m", .shown = "mm", .range = kPositive, .fallback = "none", .example = "50 mm"};
  const auto with = [](Key key, const char* doc) { key.doc = doc; return key; };
  v.text("name", s.name, {.fallback = kRequired, .example = "damage", .doc = "What it is called."});
  v.quantity("peak_drift", s.peak_drift, with(drift, "Largest drift of the control point, from which on it is reached."));
  v.quantity("residual_drift", s.residual_drift, with(drift, "Drift that stays."));
  v.quantity("peak_displacement", s.peak_displacement, with(way, "Largest displacement of the control point."));
  v.quantity("residual_displacement", s.residual_displacement, with(way, "Displacement that stays."));
  v.quantity("uplift", s.uplift, with(way, "Largest opening of any joint."));
  v.quantity("slip", s.slip, with(way, "Largest slip of any joint."));
  v.flag("collapse", s.collapse, {.fallback = "false", .example = "true",
         .doc = "Reached by collapse alone; every limit state is reached by collapse."});
}

// clang-format on

}  // namespace wythe::io
