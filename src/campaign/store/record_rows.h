// How the store represents a SampleRecord. Every column of every table is named
// here once. The schema, writing and reading (store.cpp) use these lists.
//
//   each_column(v, record)    v(name, member) for the columns of `sample`
//   each_output(v, record)    its columns that are NULL where the sample has no answer
//   each_list(v)              v.list(table, list of RecordLists, columns of a member)
//
// A visitor is called with double, bool, std::int64_t, std::string or Message members. SI, exact.
#pragma once

#include <string>

#include "model/fields.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/responses.h"

namespace wythe::study {

template <class Visitor, class Record>
void each_column(Visitor& v, Record& r) {
  v("status", r.status);
  v("reason", r.reason);
  v("retried", r.retried);
  v("steps", r.steps);
  v("time_step_s", r.time_step);
  v("wall_seconds", r.wall_seconds);
  v("state_hash", r.state_hash);
  v("provenance", r.provenance);
}

template <class Visitor, class Mode>
void each_mode_column(Visitor& v, Mode& m) {
  v("failure_mode", m.name);
  v("failure_sentence", m.sentence);
  v("failure_read_at_m", m.read_at);
}

template <class Visitor, class Record>
void each_output(Visitor& v, Record& r) {
  const auto stored = [&](const OutputKey& key, auto& member) { v(key.stored, member); };
  each_response(stored, r.responses);
  each_mode_column(v, r.failure_mode);
  for (const EnergyTerm& term : kEnergyTerms) v(term.stored, r.energy.*term.value);
  each_quasi_static(stored, r.quasi_static);
  v("overlap_lost_m", r.overlap_lost);
  v("mass_blocks_kg", r.pushed.blocks);
  v("mass_loads_kg", r.pushed.loads);
  v("mass_added_kg", r.pushed.added);
}

template <class Visitor, class Evidence>
void each_evidence_column(Visitor& v, Evidence& e) {
  v("element", e.element);
  v("measure", e.measure);
  v("value", e.value);
  v("threshold", e.threshold);
  v("unit", e.unit);
}

template <class Visitor, class Shake>
void each_shake_column(Visitor& c, Shake& s) {
  c("intensity", s.intensity);
  c("status", s.status);
  c("reason", s.reason);
  c("retried", s.retried);
  c("pga_m_per_s2", s.pga);
  c("pgv_m_per_s", s.pgv);
  c("sa_m_per_s2", s.sa);
  c("peak_drift", s.peak_drift);
  c("residual_drift", s.residual_drift);
  c("peak_displacement_m", s.peak_displacement);
  c("residual_displacement_m", s.residual_displacement);
  c("uplift_m", s.uplift);
  c("slip_m", s.slip);
  c("peak_base_shear_N", s.peak_base_shear);
  c("collapsed", s.collapsed);
  c("collapse_time_s", s.collapse_time);
  c("energy_gap_ratio", s.gap_ratio);
  c("steps", s.steps);
  c("time_step_s", s.time_step);
  c("state_hash", s.state_hash);
}

// Signs have their own table, with the position of their element.
struct SignRow {
  std::int64_t of_element = 0;
  ElementSign sign;
};
struct ScoreRow {
  std::string name;
  double score = 0;
};

// A state of the pushed wall, and the drift of a pier in it.
struct MovedRow {
  MovedMass mass;
  double storey_drift = kUnset;
};
struct PierRow {
  std::string element, mark;
  DriftPoint at;
};

// The lists of a record as rows; maps and nested lists become lists of their own.
struct RecordLists {
  std::vector<FallTo> falls;
  std::vector<ScoreRow> scores;
  std::vector<Evidence> evidence, flags;
  std::vector<ElementState> elements;
  std::vector<SignRow> signs;
  std::vector<NameReading> readings;
  std::vector<Feature> features;
  std::vector<Event> events;
  std::vector<RisePoint> rise;
  std::vector<MovedRow> moved;
  std::vector<PierRow> piers;
  std::vector<ShakeResult> shakes;
};
[[nodiscard]] RecordLists lists_of(const SampleRecord& record);
void put_lists(RecordLists lists, SampleRecord& record);

template <class Visitor>
void each_list(Visitor& v) {
  const auto evidence = [](auto& c, auto& e) { each_evidence_column(c, e); };
  v.list("fall", &RecordLists::falls, [](auto& c, auto& f) {
    c("fraction", f.fraction);
    c("displacement_m", f.displacement);
    c("drift", f.drift);
    c("censored", f.censored);
    c("first_fall_m", f.first);
    c("censored_first", f.censored_first);
    c("last_fall_m", f.last);
    c("censored_last", f.censored_last);
  });
  v.list("score", &RecordLists::scores, [](auto& c, auto& s) {
    c("failure_mode", s.name);
    c("score", s.score);
  });
  v.list("evidence", &RecordLists::evidence, evidence);
  v.list("flag", &RecordLists::flags, evidence);
  v.list("element", &RecordLists::elements, [](auto& c, auto& e) {
    c("element", e.element);
    c("kind", e.kind);
    c("state", e.state);
    c("displacement_first_m", e.displacement_first);
  });
  v.list("sign", &RecordLists::signs, [](auto& c, auto& s) {
    c("of_element", s.of_element);
    c("state", s.sign.state);
    c("measure", s.sign.measure);
    c("value", s.sign.value);
    c("threshold", s.sign.threshold);
    c("unit", s.sign.unit);
    c("displacement_first_m", s.sign.displacement_first);
  });
  v.list("reading", &RecordLists::readings, [](auto& c, auto& r) {
    std::string what = text_of(r.what());  // for queries only; it follows from the others
    c("what", what);
    c("failure_mode", r.name);
    c("state", r.state);
    c("displacement_m", r.displacement);
    c("threshold", r.threshold);
    c("factor", r.factor);
  });
  v.list("feature", &RecordLists::features, [](auto& c, auto& f) {
    c("name", f.name);
    c("displacement_m", f.displacement);
    c("value_m", f.value);
  });
  v.list("event", &RecordLists::events, [](auto& c, auto& e) {
    c("name", e.name);
    c("displacement_m", e.displacement);
    c("reaction_N", e.reaction);
    c("place", e.where);
  });
  v.list("rise", &RecordLists::rise, [](auto& c, auto& p) {
    c("displacement_m", p.displacement);
    c("force_N", p.force);
  });
  v.list("moved", &RecordLists::moved, [](auto& c, auto& m) {
    c("displacement_m", m.mass.displacement);
    c("first_kg_m", m.mass.first);
    c("second_kg_m2", m.mass.second);
    c("mixed_kg_m2", m.mass.mixed);
    c("storey_drift", m.storey_drift);
  });
  v.list("shake", &RecordLists::shakes, [](auto& c, auto& s) { each_shake_column(c, s); });
  v.list("pier_drift", &RecordLists::piers, [](auto& c, auto& p) {
    c("element", p.element);
    c("mark", p.mark);
    c("displacement_m", p.at.displacement);
    c("drift", p.at.drift);
    c("shear_N", p.at.shear);
  });
}

// A packed curve: one column after the other, each over all rows, identified by name.
// A column without a name in the store is kUnset, and unknown names are ignored.
[[nodiscard]] std::string curve_column_names();
[[nodiscard]] std::vector<double> curve_columns(const std::vector<CurveRow>& curve);
[[nodiscard]] std::vector<CurveRow> curve_rows(const std::vector<double>& columns,
                                               const std::vector<std::string>& names);

// The stored arrays of a state, one after the other, and back. `rest` is the
// first state of the same model, which gives their lengths and the velocities.
[[nodiscard]] std::vector<double> state_arrays(const State& state);
[[nodiscard]] State state_at_rest(const std::vector<double>& arrays, const State& rest);

}  // namespace wythe::study
