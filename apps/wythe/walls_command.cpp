// Makes a study of walls from one model, which differ by its scatter, runs it, and prints means and ranges.
#include "walls_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "campaign_commands.h"
#include "campaign_table.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe::app {
namespace {

constexpr int kFewestForInterval = 6;  // of a median (OfWalls)

// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

// A study with the walls as its samples, and d(r) at all its shares.
StudySpec study_of_walls(const RunArguments& a, int walls) {
  const ModelSpec base = read_model(a.model, a.overrides);  // reports faults with their own places
  if (std::all_of(base.field.begin(), base.field.end(),
                  [](const auto& field) { return !field.second.formula.empty(); }))
    refuse(
        "--walls", std::to_string(walls),
        "asks for walls that differ, and nothing scatters within this one",
        "write [scatter] and under it use = \"clay_brick\", or add --set scatter.use=clay_brick");
  std::string shares;
  for (const double left : kSharesLeft)
    shares += fmt::format("{}{:g}", shares.empty() ? "" : ", ", left);
  const std::filesystem::path model = std::filesystem::absolute(a.model);
  const std::string text = fmt::format(
      "[study]\nname = {}\nmodel = {}\nsamples = {}\nseed = 0\ndesign = \"monte_carlo\"\n"
      "fractions = [{}]\n",
      quoted(a.model), quoted(model.string()), walls, shares);
  return parse_study(text, (model.parent_path() / kStudyOfModel).string(), a.overrides);
}

std::string number_of(double value, double scale, const char* unit) {
  if (std::isinf(value)) return "beyond the push";
  return std::isnan(value) ? "-" : fmt::format("{:.2f} {}", value * scale, unit);
}

void print_of_walls(const std::string& name, const OfWalls& of, double scale, const char* unit) {
  if (of.n == 0) return;
  const Interval& interval = of.median.interval;
  const bool is_bound = std::isinf(of.median.value);
  fmt::print("{:<10} median {}{}", name, is_bound ? "> " : "",
             number_of(is_bound ? of.at_least : of.median.value, scale, unit));
  if (!std::isnan(interval.low))
    fmt::print(" (95 %: {} to {})", number_of(interval.low, scale, unit),
               number_of(interval.high, scale, unit));
  fmt::print("; walls from {} to {}", number_of(of.smallest, scale, unit),
             of.bounds > 0 ? "beyond the push" : number_of(of.largest, scale, unit));
  if (of.bounds > 0) fmt::print(" ({} of {})", of.bounds, of.n);
  fmt::print("\n");
}

void print_walls(const WallEnsemble& walls) {
  print_of_walls("peak", walls.peak_reaction, 1e-3, "kN");
  print_of_walls("at peak", walls.displacement_at_peak, 1e3, "mm");
  for (std::size_t k = 0; k < walls.left.size(); ++k)
    print_of_walls(fmt::format("{:g} % left", 100 * walls.left[k]), walls.capacity[k], 1e3, "mm");
  for (const Share& mode : walls.mode)
    fmt::print("failure mode {}: {} wall{} ({:.0f} to {:.0f} % of all such walls)\n", mode.name,
               mode.count, mode.count == 1 ? "" : "s", 100 * mode.share.interval.low,
               100 * mode.share.interval.high);
}

// Walls without a result, and why an interval is missing.
void print_silent(const Statistics& s) {
  const int known = s.walls.peak_reaction.n;
  if (known < s.run)
    fmt::print("{} of {} walls have a peak force; medians are of these\n", known, s.run);
  for (const Unanswered& wall : s.unanswered)
    fmt::print("wall {}: {}{}\n", wall.sample, wall.status,
               wall.reason.empty() ? "" : ": " + readable(text_of(wall.reason)));
  if (known < kFewestForInterval)
    fmt::print("{} of {} walls have a peak force; the interval of a median needs six\n", known,
               s.run);
}

}  // namespace

int run_walls(const RunArguments& a) {
  const std::string language = a.language.empty() ? "en" : a.language;
  check_language(language);
  if (a.model.empty() || a.out.empty())
    refuse(a.model.empty() ? "MODEL.toml" : "--out", "", "is missing",
           "write wythe run MODEL.toml --out DIR --walls N");
  for (const auto& [option, value] :
       {std::pair("--checkpoint", a.checkpoint), std::pair("--resume", a.resume)})
    if (!value.empty())
      refuse(option, value, "is for one wall, and --walls asks for several",
             "leave it out; the same command goes on with walls that are stored");
  if (a.threads != 1)
    refuse("--threads", std::to_string(a.threads), "is for one wall, and --walls asks for several",
           "write --jobs for walls at the same time");
  for (const std::string& text : a.overrides)
    if (text.starts_with("study."))
      refuse("--set", text, "is of a study, and --walls makes its own",
             "leave it out, or write a study and run wythe campaign");
  const int walls = whole_number("--walls", a.walls, 2, kMostWalls, "write e.g. --walls 8");
  CampaignOptions options;
  options.jobs = jobs_of(a.jobs);
  options.provenance = provenance_text();
  const StudySpec study = study_of_walls(a, walls);
  const ModelBuilder build = model_builder(study);
  options.resume = holds_campaign(a.out);  // its study must be the same
  check_folder(a.out, FolderFor::kCampaign);
  CampaignOutcome outcome;
  {
    const StopSignal stop;
    options.stop = &stop.asked();
    CampaignPrinter printer(a.quiet);
    outcome =
        run_campaign(study, build, a.out, options, [&](const CampaignProgress& p) { printer(p); });
  }
  for (const Message& note : outcome.notes)
    fmt::print(stderr, "note: {}\n", readable(text_of(note)));
  const Statistics statistics = write_campaign_files(a.out, read_answers(a.out), language);
  print_rate_warning(statistics);
  print_walls(statistics.walls);
  print_silent(statistics);
  fmt::print("report {}/report.html\n", readable(a.out));
  return outcome.interrupted || statistics.answered == 0 ? kFailed : 0;
}

}  // namespace wythe::app
