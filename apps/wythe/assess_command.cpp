// Runs the walls of a verdict and prints it: ways of pushing, parts out of plane, the sentence.
// After the first pair of walls it says how long the others may take. Writes the pages of walls that have run.
#include "assess_command.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numeric>
#include <thread>

#include "campaign_commands.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/solve.h"
#include "wythe/study.h"

namespace wythe::app {
namespace {

constexpr double kNarrowest = 0.05;  // interval of a share: 1560 walls
constexpr int kPair = 2;             // walls run first, to measure how long the others take

double number_between(const std::string& option, const std::string& text, double above,
                      const char* range) {
  return option_number(
      option, text, [&](double value) { return value > above && value <= 1; },
      std::string("must be a number ") + range, "write e.g. " + option + " 0.3");
}

// The number of walls in each way of pushing. A resumed assessment keeps it unless more are asked for.
StudySpec asked_walls(const AssessArguments& a) {
  AskedWalls asked{.model_file = a.model, .overrides = a.overrides};
  if (!a.walls.empty())
    asked.walls = whole_number("--walls", a.walls, 2, kMostWalls, "write e.g. --walls 8");
  if (!a.seed.empty())
    asked.seed = whole_number("--seed", a.seed, 0, 2'147'483'647, "write e.g. --seed 1");
  if (!a.between.empty())
    asked.between = number_between("--between", a.between, 0, "more than 0 and up to 1");
  StudySpec study = assess_study(asked);
  const std::string base = a.out + "/" + kBaseFolder;
  if (!a.resume || !holds_campaign(base)) return study;
  const std::vector<int> stored = stored_batches(base);
  const auto walls_in = [](const std::vector<int>& batches) {
    return std::accumulate(batches.begin(), batches.end(), 0);
  };
  if (!a.walls.empty() && walls_in(study.batch) > walls_in(stored)) return study;
  study.batch = stored;
  for (VariantSpec& way : study.option) way.study.batch = study.batch;
  return study;
}

// How many times faster walls run side by side than alone. Equal walls gain 3.5 times in four lanes and 6 in eight
// (docs/evidence/benchmarks.md). Walls with scatter crack at different times, and gained 1.0 to 1.3 and 1.6 to 1.9 times.
double gain_of(int lanes) { return 1 + 0.1 * (lanes - 1); }

// Time for the walls that are not stored yet. It is measured with
// a first pair, or taken from the core time of the stored walls.
class Forecast {
 public:
  Forecast(const StudySpec& study, const std::string& out, const CampaignOptions& options)
      : base_(out + "/" + kBaseFolder),
        walls_(std::accumulate(study.batch.begin(), study.batch.end(), 0)),
        ways_(static_cast<int>(study.option.size()) + 1),
        jobs_(options.jobs > 0
                  ? options.jobs
                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

  // `most`: largest possible number of walls.
  void say(int most, int ran, double took) const {
    const StoreProgress there = campaign_progress(base_);
    if (there.done == 0) return;
    const int of = ran > 0 ? ran : there.done;
    const double alone =  // of one wall on a core of its own
        (ran > 0 ? took * std::min(jobs_, ran) : there.seconds) / of * gain_of(lanes(of));
    const auto time = [&](int walls) {
      const int left = ways_ * walls - there.done;
      return duration_text(alone * left / gain_of(lanes(walls)) / std::min(jobs_, walls));
    };
    if (ways_ * walls_ <= there.done) return;
    const std::string more =
        most > walls_ ? fmt::format(", and up to {} for {} walls", time(most), most) : "";
    fmt::print(stderr, "{} ways of pushing, {} walls each: about {} on {} core{}{}\n", ways_,
               walls_, time(walls_), jobs_, jobs_ == 1 ? "" : "s", more);
  }

 private:
  [[nodiscard]] int lanes(int walls) const { return lanes_for((walls + jobs_ - 1) / jobs_); }

  std::string base_;
  int walls_, ways_, jobs_;
};

void print_way(const WayOfPushing& way) {
  constexpr double kToG = 1 / kStandardGravity;
  const WallCapacity& c = way.capacity;
  const Interval& interval = c.with_tests;
  fmt::print("{:<4} {:<32} ", way.direction, text_of(words_of_pattern(way.pattern)));
  if (std::isnan(c.median.value)) {
    fmt::print("no answer in any of {} walls\n", way.walls.size());
    return;
  }
  fmt::print("{}{:.3f} g", c.at_least ? "at least " : "", c.median.value * kToG);
  if (!std::isnan(interval.low) && !std::isinf(interval.high))
    fmt::print(" ({:.3f} to {:.3f})", interval.low * kToG, interval.high * kToG);
  fmt::print(": not met in {} of {} walls", way.counts.not_met,
             way.counts.met + way.counts.not_met);
  if (way.counts.not_shown > 0) fmt::print(", {} not shown", way.counts.not_shown);
  if (way.counts.lost > 0) fmt::print(", {} lost", way.counts.lost);
  fmt::print("\n");
}

// The result of a part, then its cautions.
void print_part(const LocalCheck& part) {
  Message said = part.sentence;
  if (said.code == "local.unsigned")
    for (const Argument& argument : part.sentence.arguments)
      if (argument.name == "verdict") said = std::get<std::vector<Message>>(argument.value).front();
  fmt::print("out of plane: {}\n", readable(text_of(said)));
  for (const Message& caution : part.cautions)
    fmt::print("  doubtful: {}\n", readable(text_of(caution)));
}

void print_verdict(const WallsVerdict& v, const std::string& out) {
  fmt::print("{}{}\n", v.may_be_signed ? "" : "WARNING ", text_of(v.sentence));
  for (const WayOfPushing& way : v.ways) print_way(way);
  for (const WayOfPushing& way : v.ways)
    for (const JudgedWall& wall : way.walls)
      if (wall.is_lost())
        fmt::print("lost: {}/{}, wall {}: {}\n", out, way.folder, wall.wall,
                   readable(text_of(wall.lost)));
  for (const LocalCheck& part : v.parts.checked) print_part(part);
  for (const Refusal& part : v.parts.refused)
    fmt::print("not checked: {}: {}\n", readable(text_of(part.what)), readable(part.why));
  fmt::print("report {}/report.html\n", readable(out));
}

std::vector<std::string> folder_names(const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  names.reserve(folders.size());
  for (const std::string& folder : folders)
    names.push_back(std::filesystem::path(folder).filename().string());
  return names;
}

void write_campaigns(const std::vector<std::string>& folders, const std::string& language) {
  for (const std::string& folder : folders)
    static_cast<void>(write_campaign_files(folder, read_answers(folder), language));
}

// All walls of a study in all its ways of pushing, and their verdict, unless the user stopped it.
struct Round {
  OptionRuns ran;
  WallsVerdict verdict;
};
Round run_round(const AssessArguments& a, const CampaignArguments& as_campaign,
                const StudySpec& study, const CampaignOptions& options, int most) {
  const Forecast forecast(study, a.out, options);
  FirstLook look;
  if (!a.quiet)
    look = {.samples = kPair,
            .say = [&](int ran, double seconds) { forecast.say(most, ran, seconds); }};
  Round out{.ran = run_options(as_campaign, study, options, look), .verdict = {}};
  if (out.ran.interrupted) return out;
  std::vector<std::string> folders;
  for (const OptionRun& run : out.ran.runs) folders.push_back(run.folder);
  write_campaigns(folders, a.language);
  out.verdict = write_verdict(a.out, folder_names(folders), a.language, hold_for_test);
  return out;
}

}  // namespace

int report_ways(const std::string& folder, const std::string& language) {
  const std::vector<std::string> stores = option_folders(folder);
  write_campaigns(stores, language);
  // Without a verdict it is one model of a comparison, or an assessment that was stopped.
  if (!std::filesystem::exists(folder + "/assessment.json")) {
    for (const std::string& store : stores) fmt::print("report {}/report.html\n", readable(store));
    return 0;
  }
  int done = 0, walls = 0;
  for (const std::string& store : stores) {
    const StoreProgress there = campaign_progress(store);
    done += there.done, walls += there.samples;
  }
  if (done < walls) {
    fmt::print(
        stderr,
        "note: {} of {} pushes have run, so the verdict and its page stay as they are; wythe "
        "assess MODEL.toml --out {} --resume goes on\n",
        done, walls, shell_path(folder));
    return kFailed;
  }
  const WallsVerdict verdict = write_verdict(folder, folder_names(stores), language, hold_for_test);
  print_verdict(verdict, folder);
  return verdict.verdict != AssessmentVerdict::kNotKnown ? 0 : kFailed;
}

int assess(const AssessArguments& asked) {
  AssessArguments a = asked;
  check_language(a.language);
  CampaignOptions options;
  options.jobs = jobs_of(a.jobs);
  options.resume = a.resume;
  options.provenance = provenance_text();
  double width = kUnset;
  if (!a.until.empty())
    width = number_between("--until", a.until, kNarrowest, "more than 0.05 and up to 1");
  const int most = std::isnan(width) ? 0 : most_walls(width);
  StudySpec study = asked_walls(a);
  hold_for_test("model read");
  CampaignArguments as_campaign;
  as_campaign.out = a.out;
  as_campaign.resume = a.resume;
  as_campaign.quiet = a.quiet;
  as_campaign.language = a.language;
  as_campaign.command = a.command;
  while (true) {
    const Round round = run_round(a, as_campaign, study, options, most);
    if (round.ran.interrupted) return say_stopped(as_campaign, round.ran.runs);
    const WallsVerdict& verdict = round.verdict;
    const bool is_known = verdict.verdict != AssessmentVerdict::kNotKnown;
    const WallCounts& counts = verdict.worst.counts;
    const int next = is_known && most > 0 ? next_walls(counts, width) : 0;
    if (next == 0) {
      print_verdict(verdict, a.out);
      if (is_known && most > 0)
        fmt::print("the share that does not meet it is known to {:.2f} after {} walls\n",
                   counts.probability().interval.width(), counts.walls);
      return is_known ? 0 : kFailed;
    }
    if (!a.quiet)
      fmt::print(stderr, "{} walls: not met in {} of {}; going on with {} walls\n", counts.walls,
                 counts.not_met, counts.met + counts.not_met, next);
    if (!a.resume) as_campaign.command.emplace_back("--resume");
    a.resume = as_campaign.resume = options.resume = true;
    a.walls = std::to_string(next);
    study = asked_walls(a);
  }
}

}  // namespace wythe::app
