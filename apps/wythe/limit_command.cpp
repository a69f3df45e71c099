// wythe limit: a second opinion on a model, and its agreement with stored runs.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "commands.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/limit.h"
#include "wythe/result.h"

namespace wythe::app {
namespace {

// One line for each part: onset, equivalent system, limit displacement; then the demand of each limit state.
void print_local(const std::vector<LocalCheck>& checks) {
  for (const LocalCheck& c : checks) {
    const LocalCapacity& k = c.capacity;
    fmt::print(
        "{:<16} {:5.2f} to {:5.2f} m   alpha0 {:.4f}   e* {:.3f}   M* {:.0f} kg   FC {:.2f}   a0* "
        "{:.3f} m/s2",
        c.name, c.foot, c.head, k.alpha0, k.mass_share, k.mass, c.confidence_factor,
        c.acceleration0);
    if (std::isfinite(k.displacement0)) fmt::print("   d0* {:.1f} mm", 1e3 * k.displacement0);
    fmt::print("\n");
    for (const LocalStateCheck& s : c.states) {
      fmt::print("  {:<18}", word_of(kLimitStateWords, s.state));
      if (std::isfinite(s.q_ratio))
        fmt::print("   onset {:.3f} of {:.3f}/{:g} m/s2: {:.2f}", c.acceleration0, s.demand, s.q,
                   s.q_ratio);
      if (std::isfinite(s.displacement_ratio))
        fmt::print("   d* {:.1f} mm, T {:.2f} s, asked {:.1f} mm: {:.2f}", 1e3 * s.displacement,
                   s.period, 1e3 * s.displacement_demand, s.displacement_ratio);
      fmt::print("\n");
    }
    fmt::print("  {}\n", text_of(c.sentence));
    for (const Message& note : c.notes) fmt::print(stderr, "{}: note: {}\n", c.name, text_of(note));
  }
}

void print_opinion(const SecondOpinion& opinion) {
  for (const Mechanism& m : opinion.mechanisms)
    fmt::print("{} {:<14} {:8.2f} kN at rest   {:7.1f} mm where {}\n", m.mode,
               word_of(kHypothesisWords, m.hypothesis), 1e-3 * m.curve.states.front().force,
               1e3 * m.curve.states.back().displacement, word_of(kChainEndWords, m.curve.end));
  for (const NamedLimit& limit : opinion.limits) {
    const LimitResult& a = limit.answer;
    const double unit = a.is_force ? 1e-3 : 1;
    fmt::print("limit load {:<36} {:10.5g}{}   gap of the theorems {:.1e}   {:.1f} s\n", limit.name,
               a.load * unit, a.is_force ? " kN" : "", a.load != 0 ? a.kinematic / a.load - 1 : 0,
               a.seconds);
  }
  print_local(opinion.local);
  for (const Refusal& r : opinion.refused)
    fmt::print(stderr, "{} left out: {}\n", text_of(r.what), r.why);
  for (const Message& note : opinion.notes) fmt::print(stderr, "note: {}\n", text_of(note));
}

void print_bracket(const BracketVerdict& b) {
  if (b.runs == 0) return;
  const double unit = b.is_force ? 1e-3 : 1;
  fmt::print(
      "peaks of {} runs {:.5g} to {:.5g}{}, limit loads of the model{} {:.5g} to {:.5g}: {} "
      "below, {} above\n",
      b.runs, b.least_peak * unit, b.most_peak * unit, b.is_force ? " kN" : "",
      b.runs > 1 ? " (nominal)" : "", b.low * unit, b.high * unit, b.below, b.above);
}

// The first sentence of a comparison: whether a run exceeds the limit load of its joints.
int print_bounds(const Comparison& c) {
  int broken = 0, silent = 0;
  double nearest = 0;
  for (const BoundVerdict& b : c.bounds) {
    if (!b.holds()) {
      ++broken;
      fmt::print(
          stderr,
          "{}: error of the run: its peak is {:.4f} times its limit load. Rigid blocks cannot "
          "exceed that load; {:.0f} % are allowed. Push slower, or check the run\n",
          b.run, b.peak / b.bound, 100 * b.allowance);
    } else if (!b.no_evidence.empty()) {
      ++silent;
      fmt::print(stderr, "{}: no evidence: its peak is below its limit load, but {}\n", b.run,
                 text_of(b.no_evidence));
    } else {
      nearest = std::max(nearest, b.peak / b.bound);
    }
  }
  const auto sound = static_cast<int>(c.bounds.size()) - broken - silent;
  if (sound > 0)
    fmt::print("{} runs within the limit loads of their own joints, the nearest at {:.3f} of it\n",
               sound, nearest);
  for (const ComparedRun& run : c.runs)
    if (!run.no_bound.empty())
      fmt::print(stderr, "{} has no limit load to compare with: {}\n", run.name, run.no_bound);
  return broken > 0 ? kFailed : 0;
}

int print_comparison(const Comparison& c) {
  const int code = print_bounds(c);
  for (const GroupVerdict& g : c.groups)
    fmt::print("{} runs {:<7} / {:<28} peaks {:.2f}   post-peak gap {:.1f} kN ({:.0f} %)\n", g.runs,
               g.mode, g.mechanism, g.peak_ratio, 1e-3 * g.gap, 100 * g.gap_share);
  print_bracket(c.bracket);
  return code;
}

SecondOpinion answered(const LimitArguments& a, const Model& model, const OpinionAsked& asked,
                       const std::atomic<bool>& stop) {
  const OpinionCost cost = cost_of(model, asked);
  if (!a.quiet && cost.seconds > 3)
    fmt::print(stderr, "{} limit loads of {} blocks: about {:.0f} s\n", cost.limit_loads,
               model.n_block, cost.seconds);
  LimitPrinter printer(a.quiet);
  return second_opinion(model, asked, &stop,
                        [&](const Message& what, double share) { printer(text_of(what), share); });
}

}  // namespace

int limit(const LimitArguments& a) {
  check_language(a.language);
  OpinionAsked asked{a.only, a.assessment};
  check_asked(asked);
  const ModelSpec spec = read_model(a.model, a.overrides);
  const Model model = compile(spec);
  hold_for_test("model read");
  const Origin origin{a.model, spec_hash(spec), a.replaces};
  check_limit_folder(a.out, origin);
  std::vector<ComparedRun> runs;
  if (!a.with.empty()) runs = read_compared_runs(a.with);
  const StopSignal stop;
  asked.parts = asks_for_parts(asked) && has_parts(spec, model);
  SecondOpinion opinion;
  try {
    opinion = answered(a, model, asked, stop.asked());
  } catch (const LimitStopped&) {
    fmt::print(stderr, "stopped by the user before the first result; nothing is written\n");
    return kFailed;
  }
  if (asked.assessment) add_local_checks(spec, model, asks_for_parts(asked), opinion);
  opinion.comparison = compare(a.with, std::move(runs), opinion.mechanisms);
  opinion.comparison.bracket = bracket_of(opinion);
  for (Message& note : notes_on(model, opinion)) opinion.notes.push_back(std::move(note));
  const std::string page =
      write_second_opinion(a.out, spec, model, opinion, a.language, hold_for_test);
  write_origin(a.out, origin);
  const int code = print_comparison(opinion.comparison);
  print_opinion(opinion);
  fmt::print("report {}\n", readable(page));
  // a stated part that cannot be checked is no answer to what was asked
  const bool lacks_part =
      !spec.assessment.part.empty() &&
      std::any_of(opinion.refused.begin(), opinion.refused.end(), [](const Refusal& r) {
        return r.what.code == "local.part" || r.what.code == "local.parts";
      });
  return stop.asked() || lacks_part ? kFailed : code;
}

}  // namespace wythe::app
