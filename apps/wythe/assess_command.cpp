#include "assess_command.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <thread>

#include "campaign_commands.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/campaign.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/io.h"
#include "wythe/solve.h"
#include "wythe/stored_states.h"
#include "wythe/text.h"

namespace wythe::app {
namespace {

constexpr int kFailed = 3;
constexpr int kMostWalls = 100'000;

double coefficient(const std::string& option, const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !(value > 0) || !(value <= 1))
    refuse(option, text, "must be a number above 0 and up to 1", "write e.g. " + option + " 0.2");
  return value;
}

// The walls in each way; a resumed assessment keeps their number unless more are asked for.
StudySpec asked_walls(const AssessArguments& a) {
  AskedWalls asked{.model_file = a.model, .overrides = a.overrides};
  if (!a.walls.empty())
    asked.walls = whole_number("--walls", a.walls, 2, kMostWalls, "write e.g. --walls 8");
  if (!a.seed.empty())
    asked.seed = whole_number("--seed", a.seed, 0, 2'147'483'647, "write e.g. --seed 1");
  if (!a.between.empty()) asked.between = coefficient("--between", a.between);
  StudySpec study = assess_study(asked);
  const std::string base = a.out + "/" + kBaseFolder;
  if (!a.resume || !a.walls.empty() || !holds_campaign(base)) return study;
  study.batch = stored_batches(base);
  for (VariantSpec& way : study.option) way.study.batch = study.batch;
  return study;
}

void print_forecast(const StudySpec& study, const CampaignOptions& options) {
  const int walls = std::accumulate(study.batch.begin(), study.batch.end(), 0);
  const auto ways = static_cast<int>(study.option.size()) + 1;
  const int cores = options.jobs > 0
                        ? options.jobs
                        : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const double push = estimate(compile(model_builder(study)({}))).seconds;
  fmt::print(stderr, "{} ways of pushing, {} walls each: at most about {} on {} core{}\n", ways,
             walls, duration_text(push * ways * walls / cores), cores, cores == 1 ? "" : "s");
}

void print_way(const WayOfPushing& way) {
  constexpr double kToG = 1 / kStandardGravity;
  const WallCapacity& c = way.capacity;
  const Interval& interval = c.median.interval;
  fmt::print("{:<4} {:<32} {}{:.3f} g", way.direction, text_of(words_of_pattern(way.pattern)),
             c.at_least ? "at least " : "", c.median.value * kToG);
  if (!std::isnan(interval.low) && !std::isinf(interval.high))
    fmt::print(" ({:.3f} to {:.3f})", interval.low * kToG, interval.high * kToG);
  fmt::print(": not met in {} of {} walls", way.counts.not_met,
             way.counts.met + way.counts.not_met);
  if (way.counts.not_shown > 0) fmt::print(", {} not shown", way.counts.not_shown);
  if (way.counts.lost > 0) fmt::print(", {} lost", way.counts.lost);
  fmt::print("\n");
}

void print_verdict(const WallsVerdict& v, const std::string& out) {
  fmt::print("{}{}\n", v.may_be_signed ? "" : "WARNING ", text_of(v.sentence));
  for (const WayOfPushing& way : v.ways) print_way(way);
  for (const WayOfPushing& way : v.ways)
    for (const JudgedWall& wall : way.walls)
      if (wall.is_lost())
        fmt::print("lost: {}/{}, wall {}: {}\n", out, way.folder, wall.wall,
                   readable(text_of(wall.lost)));
  fmt::print("report {}/report.html\n", out);
}

}  // namespace

int assess(const AssessArguments& a) {
  check_language(a.language);
  CampaignOptions options;
  if (!a.jobs.empty())
    options.jobs = whole_number("--jobs", a.jobs, 1, 4096, "leave it out for one wall a core");
  options.resume = a.resume;
  options.provenance = provenance_text();
  const StudySpec study = asked_walls(a);
  hold_for_test("model read");
  if (!a.quiet) print_forecast(study, options);
  CampaignArguments as_campaign;
  as_campaign.out = a.out;
  as_campaign.resume = a.resume;
  as_campaign.quiet = a.quiet;
  as_campaign.language = a.language;
  as_campaign.command = a.command;
  const OptionRuns ran = run_options(as_campaign, study, options);
  if (ran.interrupted) return say_stopped(as_campaign, ran.runs);
  std::vector<std::string> folders;
  for (const OptionRun& run : ran.runs) {
    folders.push_back(std::filesystem::path(run.folder).filename().string());
    static_cast<void>(write_campaign_files(run.folder, read_answers(run.folder), a.language));
  }
  const WallsVerdict verdict = write_verdict(a.out, folders, a.language, hold_for_test);
  print_verdict(verdict, a.out);
  return verdict.verdict == AssessmentVerdict::kNotKnown ? kFailed : 0;
}

}  // namespace wythe::app
