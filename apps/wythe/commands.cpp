// The commands around one wall: run, check, materials, new, drawing, contact. Most of the file prints what a
// run answers: model, push, falls, cycles, assessment.
#include "commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "campaign_commands.h"
#include "checkpoints.h"
#include "interrupt.h"
#include "notes.h"
#include "progress.h"
#include "walls_command.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/solve.h"

namespace wythe::app {
namespace {

int exit_code(SolveStatus status) {
  return status == SolveStatus::kCompleted || status == SolveStatus::kCollapsed ? 0 : 3;
}

// The summary at the beginning of `check` and `run`.
void print_model(const ModelSpec& spec, const Model& m, bool is_check) {
  fmt::print("blocks {}   joints {}   contact points {}   weight {:.1f} kN\n", m.n_block, m.n_joint,
             m.n_point(), 1e-3 * m.weight);
  if (!spec.body.empty() && !spec.note.empty()) fmt::print("note: {}\n", readable(spec.note));
  print_notes(m.anatomy.notes, is_check);
  print_notes(notes_of_drawing(spec), is_check);
  print_notes(notes_of_fields(spec), is_check);
}

// A number, or a dash where there is none.
std::string shown(double value, int decimals) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, decimals);
}

constexpr double kMuchDrag = 0.1;  // of a loop's energy

// Falls from which a push recovered, and the decisive share; for a push, or for one direction.
template <class Readings>
void print_falls(const Readings& q) {
  for (const Dip& dip : q.dips)
    fmt::print("a dip to {:.0f} % of the {} from {:.2f} to {:.2f} mm was made good {}\n",
               1e2 * dip.lowest, dip.before_peak ? "force before it" : "peak", 1e3 * dip.from,
               1e3 * dip.back, dip.before_peak ? "before the peak" : "and does not count");
  if (!threshold_decides(q.drift_capacity).value_or(false)) return;
  const auto at = [&](double left) {
    for (const FallTo& fall : q.drift_capacity)
      if (fall.fraction == left)
        return fmt::format("{}{:.2f} mm", fall.censored ? "> " : "", 1e3 * fall.displacement);
    return std::string();
  };
  fmt::print("the threshold decides the drift: 85 % at {}, 75 % at {}\n", at(0.85), at(0.75));
}

void print_cycles(const CyclicReadings& c) {
  const bool along = c.sense > 0;
  const DirectionReadings& other = along ? c.negative : c.positive;
  fmt::print(
      "these are values of the envelope {} the push; {} it: peak {} kN at {} mm, 80 % at {}{} mm\n",
      along ? "along" : "against", along ? "against" : "along",
      shown(1e-3 * other.peak_reaction, 2), shown(1e3 * other.displacement_at_peak, 2),
      other.censored_80 ? "> " : "", shown(1e3 * other.displacement_at_80, 2));
  print_falls(other);
  fmt::print("{:>5} {:<10} {:>14} {:>14} {:>7} {:>8} {:>9} {:>8}\n", "cycle", "", "mm", "kN",
             "kept", "kN/mm", "J", "damping");
  bool much_drag = false;
  for (std::size_t k = 0; k < c.cycles.size(); ++k) {
    const Cycle& y = c.cycles[k];
    const bool drags = !y.in_balance || std::fabs(y.drag) > kMuchDrag * std::fabs(y.dissipated);
    much_drag = much_drag || drags;
    const auto both = [](double high, double low) {
      return shown(high, 2) + " / " + shown(low, 2);
    };
    fmt::print("{:>5} {:<10} {:>14} {:>14} {:>7} {:>8} {:>9} {:>8}{}\n", k + 1, y.kind,
               both(1e3 * y.displacement_max, 1e3 * y.displacement_min),
               both(1e-3 * y.reaction_max, 1e-3 * y.reaction_min),
               y.repeat > 1 ? shown(1e2 * y.kept, 0) + " %" : "", shown(1e-6 * y.stiffness, 2),
               shown(y.dissipated, 2), shown(1e2 * y.damping_ratio, 1) + " %", drags ? " *" : "");
  }
  if (much_drag)
    fmt::print(
        "* a force is out of balance, or more than a tenth of the energy went into motion and "
        "damping: push slower\n");
}

void print_load(const Result& r) {
  const Responses& q = r.responses;
  if (std::isnan(q.peak_reaction)) {
    fmt::print("capacity not known: {}\n", text_of(q.peak_reason));
    return;
  }
  const bool tilt = r.curve_of == StageKind::kTilt;
  fmt::print(
      "capacity {}load factor {:.4f}{}: {:.2f} kN, the top at {:.2f} mm{}\n",
      q.censored_peak ? "at least " : "", r.load_factor,
      tilt ? fmt::format(", a tilt of {:.2f} degrees", std::atan(r.load_factor) * 180 / M_PI) : "",
      1e-3 * q.peak_reaction, 1e3 * q.displacement_at_peak,
      q.censored_peak ? "; the wall did not fall: let the load grow farther" : "");
}

void print_push(const Result& r) {
  const Responses& q = r.responses;
  if (std::isnan(q.peak_reaction)) {
    fmt::print("peak not known: {}\n", text_of(q.peak_reason));
    return;
  }
  fmt::print("peak {}{:.2f} kN at {:.2f} mm   80 % at {}{:.2f} mm   stiffness {}\n",
             q.censored_peak ? "at least " : "", 1e-3 * q.peak_reaction,
             1e3 * q.displacement_at_peak, q.censored_80 ? "> " : "", 1e3 * q.displacement_at_80,
             std::isnan(q.initial_stiffness)
                 ? "not known"
                 : fmt::format("{:.1f} kN/mm", 1e-6 * q.initial_stiffness));
  if (const Message why = why_no_stiffness(q); !why.empty()) fmt::print("{}\n", text_of(why));
  if (const FlatPeak flat = flat_peak(r); flat.says_little(q.displacement_at_peak))
    fmt::print(
        "the curve is flat there: the force is within {:.0f} % of its peak from {:.2f} mm to {}\n",
        1e2 * kFlatPeak, 1e3 * flat.from,
        flat.is_bound ? "where the push ended" : fmt::format("{:.2f} mm", 1e3 * flat.to));
  if (q.censored_80 && !q.censored_first_80)
    fmt::print("the push ended before the fall below 80 % had lasted: {:.2f} mm is a lower bound\n",
               1e3 * q.displacement_at_80);
  print_falls(q);
  if (q.peak_raw > 1.02 * q.peak_reaction)
    fmt::print(
        "the largest force of all, {:.2f} kN at {:.2f} mm, is out of balance and not a strength\n",
        1e-3 * q.peak_raw, 1e3 * q.displacement_at_peak_raw);
}

void print_assessment(const ModelSpec& spec, const Model& model, const Result& r) {
  if (!is_asked(spec.assessment)) return;
  const CodeAssessment a = assess_run(spec, model, r);
  fmt::print("assessment, {}: {}\n", spec.assessment.code, text_of(a.sentence));
  if (!a.limit_states.empty())
    fmt::print("m* {:.0f} kg   Gamma {:.3f}   T* {:.3f} s{}\n", a.system.mass,
               a.system.participation, a.system.period(),
               a.spectrum.is_given() ? fmt::format("   q* {:.2f}", a.demand.q) : "");
  fmt::print("note: {}\n", text_of(a.notes.front()));
}

// Verdicts besides that of the force. The first line already says why a displacement is not known.
void print_slow_push(const SlowPushVerdict& displacement, const SlowPushVerdict& mode,
                     bool is_usable) {
  if (mode.verdict == "no push" || (mode.reason.code == "promise.force" && !is_usable)) return;
  const bool is_new = mode.is_missing() && mode.reason.code != displacement.reason.code;
  fmt::print("rate, for the displacement: {}; for the failure mode: {}{}\n", displacement.verdict,
             mode.verdict, is_new ? ": " + text_of(mode.reason) : "");
}

// For many elements the numbers of those with each sign; elements.csv and the page list each element.
std::string counted(Message sentence) {
  constexpr std::size_t kListed = 3;
  std::vector<Message>* parts = nullptr;
  for (Argument& argument : sentence.arguments)
    if (argument.name == "parts") parts = std::get_if<std::vector<Message>>(&argument.value);
  if (parts == nullptr || parts->size() <= kListed) return text_of(sentence);
  std::vector<std::pair<std::string, int>> signs;
  for (const Message& part : *parts)
    for (const Argument& argument : part.arguments)
      if (const auto* shown = std::get_if<std::vector<Message>>(&argument.value);
          shown && argument.name == "signs")
        for (const Message& sign : *shown) {
          const std::string word = text_of(sign);
          auto at = std::find_if(signs.begin(), signs.end(),
                                 [&](const auto& known) { return known.first == word; });
          if (at == signs.end()) at = signs.insert(at, {word, 0});
          ++at->second;
        }
  std::stable_sort(signs.begin(), signs.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string words;
  for (const auto& [word, count] : signs)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", word, count);
  *parts = {as_text(fmt::format("{} elements: {}", parts->size(), words))};
  return text_of(sentence);
}

void print_result(const ModelSpec& spec, const Model& model, const Result& r,
                  const std::string& out) {
  print_doubt(model, r);
  fmt::print("status {}{}\n", to_string(r.status),
             r.reason.empty() ? "" : ": " + readable(text_of(r.reason)));
  if (const Message shaken = shaken_sentence(model, r); !shaken.empty())
    fmt::print("{}\nenergy: {:.2f} % of it does not balance\n", text_of(shaken),
               1e2 * r.energy.gap_ratio);
  if (!r.curve.empty()) {
    if (is_load_controlled(r))
      print_load(r);
    else
      print_push(r);
    if (r.responses.cyclic.sense != 0) print_cycles(r.responses.cyclic);
    fmt::print("failure mode {}{}{}: {}\n", r.failure_mode.name,
               r.failure_mode.reading.empty() ? "" : ", ", text_of(r.failure_mode.reading),
               counted(r.failure_mode.sentence));
    fmt::print("mechanism: {}\n", text_of(read_mechanism(model, r).sentence));
    if (!r.validity.holds())
      fmt::print(
          "warning: from {:.2f} mm on {} compressed joint{} lost more than half of the contact "
          "face; results that depend on them are not reliable: they still stand on each other. "
          "Write "
          "contacts = \"free\" in [solve] to see them fall. The first: {}\n",
          1e3 * r.validity.overlap_lost, r.validity.joints, r.validity.joints == 1 ? "" : "s",
          text_of(r.validity.where));
    fmt::print("rate: {}\n", text_of(r.quasi_static.verdict));
    for (std::size_t k = 0; k < r.strengthening.frame_uses.size(); ++k)
      fmt::print("{}\n", text_of(sentence_of(r.strengthening.frame_uses[k], model.frames.name[k])));
    for (std::size_t k = 0; k < r.strengthening.layer_uses.size(); ++k)
      fmt::print("{}\n", text_of(sentence_of(r.strengthening.layer_uses[k], model.layers.name[k])));
    print_slow_push(displacement_of_slow_push(model, r), mode_of_slow_push(model, r),
                    r.quasi_static.judgement == "usable");
    print_assessment(spec, model, r);
    const TestedRange range = compare_with_tests(model, r);
    if (const Message note = drift_note_of(range); !note.empty())
      fmt::print("drift: {}\n", text_of(note));
    if (const Message note = note_of(range); !note.empty())
      fmt::print("tests: {}\n", text_of(note));
    for (const Event& e : r.events)
      if (e.is_beyond_limit)
        fmt::print("warning: {} from {:.2f} mm on: {}\n", text_of(e.name), 1e3 * e.displacement,
                   text_of(e.where));
  }
  if (r.debris.blocks > 0)
    fmt::print("debris {} block{}, {:.3g} m3, {:.0f} kg, up to {:.2f} m outside the wall\n",
               r.debris.blocks, r.debris.blocks == 1 ? "" : "s", r.debris.volume, r.debris.mass,
               r.debris.reach);
  if (r.debris.load > 0)
    fmt::print("loads of {:.4g} kN lay on blocks that fell, and no longer act\n",
               r.debris.load * 1e-3);
  fmt::print("{} steps of {:.3g} s in {:.1f} s   state {}\n", r.steps, r.time_step, r.wall_seconds,
             r.state_hash);
  fmt::print("report {}/report.html\n", readable(out));
}

// Published micro-models use crack planes in units with 1e6 N/mm3 to keep them closed.
// Between rigid blocks such planes cost many steps and leave out the flexibility of units.
void print_stiff_planes(ModelSpec spec, const RunEstimate& now) {
  constexpr double kMuch = 3;  // times the steps
  const auto unit = spec.material.find("unit"), joint = spec.material.find("joint");
  if (unit == spec.material.end() || joint == spec.material.end()) return;
  const double published = unit->second.normal_stiffness;
  const double length =
      std::isnan(spec.masonry.unit_length) ? spec.wall.unit.length : spec.masonry.unit_length;
  const double equivalent = 2 * spec.masonry.unit_youngs_modulus / length;
  const bool known = equivalent > 0;
  unit->second.normal_stiffness =
      std::min(published, known ? equivalent : 4 * joint->second.normal_stiffness);
  unit->second.shear_stiffness =
      std::min(unit->second.shear_stiffness, unit->second.normal_stiffness);
  double step = 0;
  try {
    step = estimate(compile(spec)).time_step;
  } catch (const InputError&) {  // a softer law would have snap-back
    return;
  }
  if (!(step > kMuch * now.time_step)) return;
  fmt::print(
      "warning: the crack planes inside the units, kn {:.3g} GPa/m, cost {:.0f} times as many "
      "steps: "
      "about {:.0f} would do. Such a stiffness keeps planes closed between elastic units; rigid "
      "units "
      "need their own flexibility, kn = Eu/(l/2){}: write normal_stiffness = \"rule\" and "
      "shear_stiffness = \"rule\" in [material.unit]{}\n",
      1e-9 * published, step / now.time_step, static_cast<double>(now.steps) * now.time_step / step,
      known ? fmt::format(", here {:.3g} GPa/m", 1e-9 * equivalent) : "",
      known ? "" : ", and unit_youngs_modulus in [masonry]");
}

}  // namespace

int run(const RunArguments& arguments) {
  if (!arguments.walls.empty()) return run_walls(arguments);
  if (!arguments.jobs.empty())
    refuse("--jobs", arguments.jobs, "is for --walls alone", "write --threads, or add --walls N");
  RunStart start = start_of(arguments);
  hold_for_test("model read");
  const Model& model = start.from.model;
  const std::unique_ptr<Replacement> results = replace_run(
      start.out, {start.from.order.model_file, start.from.model.spec_hash, arguments.replaces},
      start.is_resumed);
  if (!arguments.quiet) print_model(start.from.spec, model, false);
  State state = start.from.state;
  if (start.is_resumed && !arguments.quiet)
    fmt::print("goes on after {} steps, in stage \"{}\"\n", state.step,
               model.stages[state.stage].spec.name);
  const StopSignal stop;  // until the results are written
  SolveOptions options;
  options.threads = threads_of(arguments.threads);
  options.stop = &stop.asked();
  options.frames = kFrames;
  if (start.has_checkpoints()) options.checkpoint = CheckpointWriter(start, *results);
  Result result;
  {
    ProgressPrinter progress(arguments.quiet);
    options.progress = [&](const Progress& p) {
      progress(p);
      hold_for_test(fmt::format("stage {}", p.stage));
    };
    result = solve(model, state, options, std::move(start.from.record));
  }
  read_result(start.from.spec, model, result);
  write_run(results->path(), start.from.spec, model, result);
  write_run_report(results->path(), start.from.spec, model, result, start.from.order.language);
  results->commit(hold_for_test);
  print_result(start.from.spec, model, result, start.out);
  if (result.status == SolveStatus::kInterrupted && start.has_checkpoints())
    fmt::print("go on with: wythe run --resume {}\n", readable(start.out));
  return exit_code(result.status);
}

void print_storeys(const ModelSpec& spec) {
  double foot = 0;
  for (const StoreySpec& storey : spec.storey) {
    const double thickness = std::isnan(storey.thickness) ? spec.wall.thickness : storey.thickness;
    fmt::print("storey {}: {:.3f} to {:.3f} m, {:.3f} m thick\n", readable(storey.name), foot,
               foot + storey.height, thickness);
    foot += storey.height;
  }
}

bool stops_early(const Model& model) {
  return std::any_of(model.stages.begin(), model.stages.end(), [](const Stage& stage) {
    return stage.push() != nullptr && stage.push()->stop_below > 0;
  });
}

// Facts that a forecast cannot include: how often a push or a load waits.
std::string bound_of(const Model& model, const RunEstimate& e) {
  constexpr double kLeast = 0.5, kMost = 2.5;  // of the forecast (docs/evidence/rate.md)
  if (adapts(model))
    return fmt::format(" ({} to {}: the push waits where the wall cracks{})",
                       duration_text(kLeast * e.seconds), duration_text(kMost * e.seconds),
                       stops_early(model) ? "; less if the force falls to stop_below first" : "");
  const auto by_load = [](const Stage& stage) {
    return stage.spec.kind() == StageKind::kBodyForce || stage.spec.kind() == StageKind::kTilt;
  };
  if (std::none_of(model.stages.begin(), model.stages.end(), by_load)) return "";
  return " (where the wall almost falls, the load waits for it, often many times as long)";
}

int check(const CheckArguments& arguments) {
  if (is_study(arguments.file)) return check_study_file(arguments);
  ModelSpec spec = read_model(arguments.file, arguments.overrides);
  const Model model = compile(spec);
  hold_for_test("model read");
  const RunEstimate e = estimate(model);
  fmt::print("{}: valid\n", readable(arguments.file));
  print_model(spec, model, true);
  fmt::print("wall {:.3f} x {:.3f} x {:.3f} m", model.anatomy.length, model.anatomy.height,
             model.anatomy.thickness);
  if (model.anatomy.courses > 0)
    fmt::print(", {} courses, {} lost joints, {} masonry blocks before lintels",
               model.anatomy.courses, model.anatomy.lost_joints,
               model.anatomy.masonry_blocks_before_lintels);
  fmt::print("\n");
  print_storeys(spec);
  fmt::print("time step {:.3g} s (stiffest block {})   about {} steps, {} on one core{}\n",
             e.time_step, model.anatomy.block_id[model.stiffest_block], e.steps,
             duration_text(e.seconds), bound_of(model, e));
  print_stiff_planes(std::move(spec), e);
  return 0;
}

int materials(const std::string& name) {
  fmt::print("{}", materials_text(name));
  return 0;
}

int new_starter(const NewArguments& arguments) {
  const std::vector<std::string> files = write_starter(arguments.kind, arguments.folder);
  for (const std::string& file : files) fmt::print("wrote {}\n", file);
  const bool is_pair = arguments.kind == "opening" || arguments.kind == "strengthening";
  const char* command = arguments.kind == "study" ? "campaign" : is_pair ? "compare" : "run";
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(shell_path(file));
  const std::string models = is_pair ? fmt::format("{}", fmt::join(names, " ")) : names.front();
  const std::string out = shell_path((std::filesystem::path(arguments.folder) / "result").string());
  fmt::print("next: wythe check {}\n      wythe {} {} --out {}\n", names.front(), command, models,
             out);
  return 0;
}

int drawing(const DrawingArguments& a) {
  fmt::print("{}", drawing_text(a.file, a.unit, {a.outline, a.openings, a.lintels}));
  return 0;
}

int contact(const ContactArguments& arguments) {
  check_contact_answer(arguments.out, {arguments.law, arguments.path});
  const JointMaterial material = read_law(arguments.law);
  const auto path = read_contact_path(arguments.path);
  const auto answers = drive_contact(material, path);
  write_contact_answer(arguments.out, path, answers);
  fmt::print("{} rows -> {}   dissipated {:.6g} N/m\n", path.size(), arguments.out,
             answers.back().dissipated);
  return 0;
}

}  // namespace wythe::app
