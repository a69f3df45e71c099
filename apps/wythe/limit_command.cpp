// wythe limit: a second opinion on a model, and whether it agrees with stored runs.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "commands.h"
#include "interrupt.h"
#include "progress.h"
#include "report_files.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/limit.h"
#include "wythe/report.h"

namespace wythe::app {
namespace {

constexpr int kFailed = 3;

bool asked(const LimitArguments& a, const char* what) {
  return a.only.empty() || std::find(a.only.begin(), a.only.end(), what) != a.only.end();
}

// What can't be answered is kept with its reason; the rest goes on.
template <class Answer>
void attempt(SecondOpinion& opinion, const Message& what, Answer answer) {
  try {
    answer();
  } catch (const InputError& error) {
    opinion.refused.push_back({what, error.what()});
  } catch (const LimitStopped& stopped) {
    opinion.refused.push_back({what, stopped.what()});
  }
}

void add_mechanisms(const LimitArguments& a, const Model& model, SecondOpinion& opinion) {
  std::vector<Hypothesis> hypotheses;
  for (const auto& [word, hypothesis] : kHypothesisWords)
    if (asked(a, word)) hypotheses.push_back(hypothesis);
  if (hypotheses.empty()) {
    if (a.assessment) opinion.notes.push_back({"limit.no_mechanism_asked"});
    return;
  }
  attempt(opinion, {"limit.macro_blocks"}, [&] {
    const Portal portal = find_portal(model);
    for (const char* mode : {"FM-1", "FM-4"})
      for (const Hypothesis h : hypotheses)
        attempt(opinion, in_words(mode, h),
                [&] { opinion.mechanisms.push_back(cut_mechanism(model, portal, mode, h)); });
  });
  if (!a.assessment) return;
  for (const Mechanism& m : opinion.mechanisms)
    opinion.assessments.push_back(assess(m.chain, m.curve, model.solve.gravity, opinion.shares));
}

struct LimitCase {
  const char *name, *code;
  LimitOptions options;
};

// From what is left when all bond is gone to what all of it could carry at once.
std::vector<LimitCase> limit_cases(const Model& model) {
  std::vector<LimitCase> cases = {
      {"dry", "strength.dry", {}},
      {"dry, residual friction, crushing",
       "strength.dry_crushing",
       {.friction = FrictionChoice::kResidual, .crushing = CrushingChoice::kPoints}}};
  if (has_bond(model))
    cases.push_back({"bonded", "strength.bonded", {.strength = JointStrength::kBonded}});
  return cases;
}

// Once stopped, what is left is refused in these words.
void add_limits(const LimitArguments& a, const Model& model, const std::atomic<bool>& stop,
                SecondOpinion& opinion) {
  if (!asked(a, "lp")) return;
  const std::vector<LimitCase> cases = limit_cases(model);
  const double expected = expected_seconds(model) * static_cast<double>(cases.size());
  if (!a.quiet && expected > 3)
    fmt::print(stderr, "{} limit loads of {} blocks: about {:.0f} s\n", cases.size(), model.n_block,
               expected);
  LimitPrinter printer(a.quiet);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Message what{"limit.of_case", {{"case", Message{cases[i].code}}}};
    LimitWatch watch{.stop = &stop};
    watch.progress = [&](double share) {
      printer(text_of(what), (static_cast<double>(i) + share) / static_cast<double>(cases.size()));
    };
    attempt(opinion, what, [&] {
      if (stop) throw LimitStopped();
      opinion.limits.push_back({cases[i].name, limit_load(model, cases[i].options, watch)});
    });
  }
}

// Nothing answered: the reasons are the answer. Each reason once.
void throw_if_nothing(const SecondOpinion& opinion) {
  if (!opinion.mechanisms.empty() || !opinion.limits.empty()) return;
  std::vector<Fault> faults;
  for (const Refusal& r : opinion.refused) {
    const auto same = [&](const Fault& f) { return f.problem == r.why; };
    if (std::none_of(faults.begin(), faults.end(), same))
      faults.push_back(
          {.file = "", .path = text_of(r.what), .value = "", .problem = r.why, .cure = ""});
  }
  throw InputError(std::move(faults));
}

void print_opinion(const SecondOpinion& opinion) {
  for (const Mechanism& m : opinion.mechanisms)
    fmt::print("{} {:<14} {:8.2f} kN at rest   {:7.1f} mm where {}\n", m.mode,
               word_of(kHypothesisWords, m.hypothesis), 1e-3 * m.curve.states.front().force,
               1e3 * m.curve.states.back().displacement, word_of(kChainEndWords, m.curve.end));
  for (const NamedLimit& limit : opinion.limits) {
    const LimitAnswer& a = limit.answer;
    const double unit = a.is_force ? 1e-3 : 1;
    fmt::print("limit load {:<36} {:10.5g}{}   gap of the theorems {:.1e}   {:.1f} s\n", limit.name,
               a.load * unit, a.is_force ? " kN" : "", a.load != 0 ? a.kinematic / a.load - 1 : 0,
               a.seconds);
  }
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

// The first sentence of a comparison: whether a run passes what its joints can carry.
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

// "report", unless the folder is a run's and has that one's; a campaign's is refused.
std::string page_name(const std::string& folder) {
  return std::filesystem::exists(folder + "/summary.json") ? "limit" : "report";
}

void write_opinion(const LimitArguments& a, const ModelSpec& spec, const Model& model,
                   const SecondOpinion& opinion) {
  prepare_folder(a.out);
  finish_replacement(a.out);
  const std::string page = page_name(a.out);
  Replacement results(a.out, [&](const std::string& name) {
    return name == "mechanisms.json" || name == page + ".html" || name == page + ".data" ||
           (name.starts_with("mechanism_") && (name.ends_with(".csv") || name.ends_with(".svg")));
  });
  for (const Mechanism& m : opinion.mechanisms) {
    const std::string path = results.path() + "/" + m.file_name();
    write_text(path + ".csv", mechanism_csv(m.curve));
    write_text(path + ".svg", mechanism_svg(model, m));
  }
  const std::string json = mechanisms_json(model, opinion);
  write_text(results.path() + "/mechanisms.json", json);
  write_page(results.path(), page, limit_data(spec, model, json), a.language);
  results.commit(hold_for_test);
}

}  // namespace

int limit(const LimitArguments& a) {
  check_language(a.language);
  ModelSpec spec;
  const Model model = read_and_compile(a.model, a.overrides, &spec);
  hold_for_test("model read");
  std::vector<ComparedRun> runs;
  if (!a.with.empty()) runs = read_compared_runs(a.with);
  const StopSignal stop;
  SecondOpinion opinion;
  opinion.notes = left_aside(model);
  add_mechanisms(a, model, opinion);
  add_limits(a, model, stop.asked(), opinion);
  if (stop.asked() && opinion.mechanisms.empty() && opinion.limits.empty()) {
    fmt::print(stderr, "stopped by the user before the first result; nothing is written\n");
    return kFailed;
  }
  throw_if_nothing(opinion);
  opinion.comparison = compare(a.with, std::move(runs), opinion.mechanisms);
  opinion.comparison.bracket = bracket_of(opinion);
  for (Message& note : notes_on(model, opinion)) opinion.notes.push_back(std::move(note));
  write_opinion(a, spec, model, opinion);
  const int code = print_comparison(opinion.comparison);
  print_opinion(opinion);
  fmt::print("report {}/{}.html\n", a.out, page_name(a.out));
  return stop.asked() ? kFailed : code;
}

}  // namespace wythe::app
