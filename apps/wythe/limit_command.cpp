// wythe limit: a second opinion on a model, and whether it agrees with stored runs.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "commands.h"
#include "report_files.h"
#include "wythe/campaign.h"
#include "wythe/io.h"
#include "wythe/limit.h"
#include "wythe/report.h"

namespace wythe::app {
namespace {

constexpr int kFailed = 3;

bool asked(const LimitArguments& a, const char* what) {
  return a.only.empty() || std::find(a.only.begin(), a.only.end(), what) != a.only.end();
}

void add_mechanisms(const LimitArguments& a, const Model& model, SecondOpinion& opinion) {
  std::vector<Hypothesis> hypotheses;
  for (const Hypothesis h :
       {Hypothesis::kInfinite, Hypothesis::kMacroBlock1, Hypothesis::kMacroBlock2})
    if (asked(a, to_string(h))) hypotheses.push_back(h);
  if (hypotheses.empty()) return;
  const Portal portal = find_portal(model);
  for (const char* mode : {"FM-1", "FM-4"})
    for (const Hypothesis h : hypotheses)
      opinion.mechanisms.push_back(cut_mechanism(model, portal, mode, h));
  if (!a.assessment) return;
  for (const Mechanism& m : opinion.mechanisms)
    opinion.assessments.push_back(assess(m.chain, m.curve, model.solve.gravity, opinion.shares));
}

// From what is left when all bond is gone to what all of it could carry at once.
void add_limits(const LimitArguments& a, const Model& model, SecondOpinion& opinion) {
  if (!asked(a, "lp")) return;
  const auto add = [&](const char* name, const LimitOptions& options) {
    opinion.limits.push_back({name, limit_load(model, options)});
  };
  add("dry", {});
  add("dry, residual friction, crushing",
      {.friction = FrictionChoice::kResidual, .crushing = CrushingChoice::kPoints});
  const bool has_bond = std::any_of(model.materials.begin(), model.materials.end(),
                                    [](const JointMaterial& m) { return m.tensile_strength > 0; });
  if (!has_bond) return;
  add("bonded", {.strength = JointStrength::kBonded});
}

void print_opinion(const SecondOpinion& opinion) {
  for (const Mechanism& m : opinion.mechanisms)
    fmt::print("{} {:<14} {:8.2f} kN at rest   {:7.1f} mm where {}\n", m.mode,
               to_string(m.hypothesis), 1e-3 * m.curve.states.front().force,
               1e3 * m.curve.states.back().displacement, to_string(m.curve.end));
  for (const NamedLimit& limit : opinion.limits) {
    const LimitAnswer& a = limit.answer;
    const double unit = a.is_force ? 1e-3 : 1;
    fmt::print("limit load {:<36} {:10.5g}{}   gap of the theorems {:.1e}   {:.1f} s\n", limit.name,
               a.load * unit, a.is_force ? " kN" : "", a.kinematic / a.load - 1, a.seconds);
  }
}

int print_comparison(const Comparison& c) {
  for (const GroupVerdict& g : c.groups)
    fmt::print("{} runs {:<7} / {:<28} peaks {:.2f}   post-peak gap {:.1f} kN ({:.0f} %)\n", g.runs,
               g.mode, g.mechanism, g.peak_ratio, 1e-3 * g.gap, 100 * g.gap_share);
  int code = 0;
  for (const BoundVerdict& b : c.bounds) {
    if (b.holds()) continue;
    code = kFailed;
    fmt::print(
        stderr,
        "{}: error of the run: its peak is {:.4f} times the limit load of its joints, {:.1f} "
        "% are allowed (1 % and its rate effect); push slower, or check the run\n",
        b.run, b.peak / b.bound, 100 * b.allowance);
  }
  return code;
}

// "report", unless the folder is a run's or a campaign's and has that one's.
std::string page_name(const std::string& folder) {
  const bool taken = std::filesystem::exists(folder + "/summary.json") || holds_campaign(folder);
  return taken ? "limit" : "report";
}

void write_opinion(const LimitArguments& a, const ModelSpec& spec, const Model& model,
                   const SecondOpinion& opinion) {
  prepare_folder(a.out);
  for (const Mechanism& m : opinion.mechanisms) {
    const std::string path = a.out + "/" + m.file_name();
    write_text(path + ".csv", mechanism_csv(m.curve));
    write_text(path + ".svg", mechanism_svg(model, m));
  }
  const std::string json = mechanisms_json(model, opinion);
  write_text(a.out + "/mechanisms.json", json);
  write_page(a.out, page_name(a.out), limit_data(spec, model, json), a.language);
}

}  // namespace

int limit(const LimitArguments& a) {
  check_language(a.language);
  const ModelSpec spec = read_model(a.model, a.overrides);
  const Model model = compile(spec);
  std::vector<ComparedRun> runs;
  if (!a.with.empty()) runs = read_compared_runs(a.with);
  SecondOpinion opinion;
  add_mechanisms(a, model, opinion);
  add_limits(a, model, opinion);
  opinion.comparison = compare(a.with, std::move(runs), opinion.mechanisms);
  write_opinion(a, spec, model, opinion);
  print_opinion(opinion);
  const int code = print_comparison(opinion.comparison);
  fmt::print("report {}/{}.html\n", a.out, page_name(a.out));
  return code;
}

}  // namespace wythe::app
