// run_data(): the data for the page of a run. Numbers and keys are those of summary.json.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/decimal_point.h"
#include "dynamics/meters/residual.h"
#include "judge/modes/wall_parts.h"
#include "model/shaking.h"
#include "report/bundle.h"
#include "report/model_inputs.h"
#include "report/translation.h"
#include "report/wall_arrays.h"
#include "wythe/parts/element_forces.h"
#include "wythe/parts/io.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"
#include "wythe/parts/responses.h"

namespace wythe {
namespace {

using namespace report;

struct Frame {
  const Snapshot* snapshot;
  std::vector<Json> labels;  // "peak", "20 mm"; none for those between
  double reaction = 0;       // [N]
};

Json label_of(const Snapshot& s) {
  return std::isnan(s.asked) ? Json(s.label)
                             : translated(Message{"length.asked", {{"mm", 1e3 * s.asked}}});
}

// A wall that falls under a constant load has no frames of its path. Instead
// it has states of the fall, each farther than the last one by this share.
constexpr double kFarther = 1.12;

std::vector<Frame> states_of_fall(const Result& result) {
  std::vector<Frame> fall;
  if (!is_load_controlled(result) || result.states.frames.empty()) return fall;
  const Snapshot& last = result.states.frames.back();
  double far = std::fabs(last.displacement);
  for (const Snapshot& s : result.states.readings) {
    if (s.state.time <= last.state.time || std::fabs(s.displacement) < kFarther * far) continue;
    far = std::fabs(s.displacement);
    fall.push_back({&s, {}, last.reaction});
  }
  return fall;
}

// Snapshots and frames by time, each state once with all its labels.
std::vector<Frame> frames_of(const Result& result) {
  std::vector<Frame> all = states_of_fall(result);
  for (const auto* list : {&result.states.snapshots, &result.states.frames})
    for (const Snapshot& s : *list)
      all.push_back(
          {&s, s.label.empty() ? std::vector<Json>{} : std::vector<Json>{label_of(s)}, s.reaction});
  std::stable_sort(all.begin(), all.end(), [](const Frame& a, const Frame& b) {
    return a.snapshot->state.time < b.snapshot->state.time;
  });
  std::vector<Frame> frames;
  for (Frame& f : all) {
    const bool same = !frames.empty() &&
                      frames.back().snapshot->state.time == f.snapshot->state.time &&
                      state_hash(frames.back().snapshot->state) == state_hash(f.snapshot->state);
    if (same)
      frames.back().labels.insert(frames.back().labels.end(), f.labels.begin(), f.labels.end());
    else
      frames.push_back(std::move(f));
  }
  return frames;
}

// The energy ledger of each state; the page subtracts the first.
Json energy_of(const Model& model, const std::vector<Frame>& frames) {
  Json rows = Json::array();
  for (const Frame& f : frames) {
    const EnergyLedger e = dynamics::energy_ledger(model, f.snapshot->state, 1);
    Json row = Json::object();
    for (const EnergyTerm& term : kEnergyTerms) row[term.name] = e.*term.value;
    rows.push_back(std::move(row));
  }
  return rows;
}

constexpr double kMostNumbers = 12e6;  // of all states: 6 MB for a hundred states of 5 000 blocks

std::vector<Frame> frames_that_fit(const Model& model, const Result& result) {
  std::vector<Frame> all = frames_of(result), frames;
  std::vector<bool> labelled;
  for (const Frame& f : all) labelled.push_back(!f.labels.empty());
  const double most = std::min(1e6, kMostNumbers / std::max(1.0, state_numbers(model)));
  const std::vector<bool> shown = states_shown(labelled, static_cast<int>(most));
  for (std::size_t i = 0; i < all.size(); ++i)
    if (shown[i]) frames.push_back(std::move(all[i]));
  return frames;
}

void add_frames(Bundle& bundle, const Model& model, const Result& result) {
  const std::vector<Frame> frames = frames_that_fit(model, result);
  Json list = Json::array();
  FrameArrays arrays(true);
  for (const Frame& f : frames) {
    arrays.add(model, f.snapshot->state);
    list.push_back({{"labels", f.labels},
                    {"displacement_mm", f.snapshot->displacement * 1e3},
                    {"reaction_kN", f.reaction * 1e-3}});
    if (result.shaking.was_shaken && result.curve.empty())  // since the beginning of the shaking
      list.back()["time_s"] = f.snapshot->state.time - result.states.snapshots.front().state.time;
  }
  bundle.header["frames"] = list;
  bundle.header["energy"] = energy_of(model, frames);
  arrays.write(bundle);
}

void add_curve(Bundle& bundle, const std::vector<CurveRow>& curve, ShownColumns of) {
  for (const CurveColumn& column : columns_shown(of)) {
    std::vector<float> values;
    values.reserve(curve.size());
    for (const CurveRow& row : curve)
      values.push_back(static_cast<float>(row.*column.value * column.to_unit));
    bundle.add(fmt::format("curve.{}", column.name), values);
  }
}

// The history of the first point along the first record, and that of the base.
void add_shaking(Bundle& bundle, const Model& model, const Result& result) {
  const ShakeHistory& h = result.history;
  if (h.row.empty() || model.watched.empty() || result.shaking.record.empty()) return;
  const auto& along = result.shaking.record.front().along;
  const auto on = [&](const std::array<double, 3>& v) {
    return v[0] * along[0] + v[1] * along[1] + v[2] * along[2];
  };
  std::map<std::string, std::vector<float>> columns;
  for (std::size_t k = 0; k < h.row.size(); ++k) {
    const auto put = [&](const char* name, double value) {
      columns[name].push_back(static_cast<float>(value));
    };
    put("time_s", h.row[k].time);
    put("acceleration_g", on(h.row[k].base_acceleration) / 9.80665);
    put("base_shear_kN", 1e-3 * on(h.row[k].base_force));
    put("displacement_mm", 1e3 * on(h.motion[k * h.point.size()]));
    put("opening_mm", 1e3 * h.row[k].opening);
    for (std::size_t storey = 0; storey < h.storey.size(); ++storey) {
      const auto [x, z] = storey_drift(h, k, storey);
      put(fmt::format("storey_{}_percent", storey).c_str(), 1e2 * on({x, 0, z}));
    }
  }
  for (const auto& [name, values] : columns) bundle.add("shake." + name, values);
}

// The places of piers, spandrels, nodes and toes, and the forces of piers and
// spandrels: one array for each quantity, with all elements of a state together.
void add_parts(Bundle& bundle, const Model& model, const Result& result) {
  const study::WallParts parts = study::find_parts(model);
  Json list = Json::array();
  for (const auto& [part, kind] : study::all_parts(parts))
    list.push_back({{"name", part->name},
                    {"mark", part->mark},
                    {"kind", kind},
                    {"storey", part->storey},
                    {"box", {part->box.x0, part->box.x1, part->box.y0, part->box.y1}}});
  if (dimension_of(model) == 3) list.clear();  // drawn only for walls in the plane
  bundle.header["wall"]["parts"] = list;

  const std::vector<ElementForces> elements = read_element_forces(model, result);
  std::map<std::string, std::vector<float>> columns;
  Json names = Json::array(), displacements = Json::array();
  for (const ElementForces& e : elements) names.push_back(e.element);
  const std::size_t rows = elements.empty() ? 0 : elements.front().rows.size();
  for (std::size_t r = 0; r < rows; ++r) {
    displacements.push_back(1e3 * elements.front().rows[r].displacement);
    for (const ElementForces& e : elements) {
      const ElementForces::Row& row = e.rows[r];
      const auto put = [&](const char* name, double value) {
        columns[name].push_back(static_cast<float>(value));
      };
      put("axial_1", 1e-3 * row.end[0].axial), put("axial_2", 1e-3 * row.end[1].axial);
      put("shear_1", 1e-3 * row.end[0].shear), put("shear_2", 1e-3 * row.end[1].shear);
      put("moment_1", 1e-3 * row.end[0].moment), put("moment_2", 1e-3 * row.end[1].moment);
      put("drift", 1e2 * row.drift), put("distortion", 1e2 * row.distortion);
    }
  }
  if (rows == 0) return;
  bundle.header["forces"] = {{"elements", names}, {"displacement_mm", displacements}};
  for (const auto& [name, values] : columns) bundle.add("forces." + name, values);
}

// The sentence without the meanings of its modes, which follow further down.
Message brief(Message sentence) {
  if (sentence.code == "mode.between_modes") sentence.code = "mode.between_kinds";
  if (sentence.code == "mode.none_nearest") sentence.code = "mode.none_nearest_brief";
  for (Argument& argument : sentence.arguments)
    if (auto* parts = std::get_if<std::vector<Message>>(&argument.value))
      for (Message& part : *parts) part = brief(std::move(part));
  return sentence;
}

// A sentence for each frame: its largest use and place, and whether it yields.
Json frames_translated(const Model& model, const Result& result) {
  Json list = Json::array();
  for (std::size_t k = 0; k < result.strengthening.frame_uses.size(); ++k)
    list.push_back({{"name", model.frames.name[k]},
                    {"words", translated(sentence_of(result.strengthening.frame_uses[k],
                                                     model.frames.name[k]))}});
  return list;
}

// A sentence for each layer: its largest use and place, and whether fibres break.
Json layers_translated(const Model& model, const Result& result) {
  Json list = Json::array();
  for (std::size_t k = 0; k < result.strengthening.layer_uses.size(); ++k)
    list.push_back(
        translated(sentence_of(result.strengthening.layer_uses[k], model.layers.name[k])));
  return list;
}

Json mode_of(const Model& model, const Result& result) {
  const FailureMode& mode = result.failure_mode;
  const Message& sentence = mode.sentence;
  return {{"words", translated(mode.words)},
          {"sentence", translated(shortened(sentence))},
          {"brief", translated(brief(shortened(sentence)))},
          {"mechanism", translated(read_mechanism(model, result).sentence)},
          {"lists_parts", sentence.code == "mode.parts" || sentence.code == "mode.parts_only"}};
}

}  // namespace

std::string run_data(const ModelSpec& spec, const Model& model, const Result& result) {
  Bundle bundle;
  bundle.header["kind"] = "run";
  bundle.header["title"] = spec.name;
  bundle.header["note"] = spec.note;
  bundle.header["weight_kN"] = model.weight * 1e-3;
  const DecimalPoint point;
  bundle.header["summary"] = Json::parse(summary_json(spec, model, result));
  translate_messages(bundle.header["summary"]);
  bundle.header["mode"] = mode_of(model, result);
  if (model.frames.n > 0) bundle.header["frames_said"] = frames_translated(model, result);
  if (model.layers.n > 0) bundle.header["layers_said"] = layers_translated(model, result);
  bundle.header["names"] = names_of(model);
  bundle.header["inputs"] = model_inputs(spec, model);
  bundle.header["model_text"] = write_model(spec);
  add_wall(bundle, model);
  add_parts(bundle, model, result);
  add_fields(bundle, spec, model);
  add_curve(bundle, result.curve, columns_of(model));
  add_shaking(bundle, model, result);
  add_frames(bundle, model, result);
  return bundle.packed();
}

}  // namespace wythe
