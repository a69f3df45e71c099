#include "walls_command.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "campaign_commands.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/campaign.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/io.h"
#include "wythe/statistics.h"
#include "wythe/stored_states.h"
#include "wythe/text.h"

namespace wythe::app {
namespace {

constexpr int kMostWalls = 100'000;
constexpr int kFailed = 3;
constexpr int kFewestForInterval = 6;  // of a median (OfWalls)

// A study with the walls as its samples, and d(r) read at all its shares.
StudySpec study_of_walls(const RunArguments& a, int walls) {
  std::string shares;
  for (const double left : kSharesLeft)
    shares += fmt::format("{}{:g}", shares.empty() ? "" : ", ", left);
  const std::filesystem::path model = std::filesystem::absolute(a.model);
  const std::string text = fmt::format(
      "[study]\nname = '''{}'''\nmodel = '''{}'''\nsamples = {}\nseed = 0\ndesign = "
      "\"monte_carlo\"\n"
      "fractions = [{}]\n",
      a.model, model.string(), walls, shares);
  return parse_study(text, (model.parent_path() / "walls of the model").string(), a.overrides);
}

std::string number_of(double value, double scale, const char* unit) {
  if (std::isinf(value)) return "not reached";
  return std::isnan(value) ? "-" : fmt::format("{:.2f} {}", value * scale, unit);
}

void print_of_walls(const std::string& name, const OfWalls& of, double scale, const char* unit) {
  if (of.n == 0) return;
  const Interval& interval = of.median.interval;
  fmt::print("{:<10} median {}", name, number_of(of.median.value, scale, unit));
  if (!std::isnan(interval.low))
    fmt::print(" (95 %: {} to {})", number_of(interval.low, scale, unit),
               number_of(interval.high, scale, unit));
  fmt::print("; walls from {} to {}", number_of(of.smallest, scale, unit),
             of.bounds > 0 ? "farther than the push" : number_of(of.largest, scale, unit));
  if (of.bounds > 0) fmt::print(" ({} of {})", of.bounds, of.n);
  fmt::print("\n");
}

void print_walls(const WallEnsemble& walls) {
  print_of_walls("peak", walls.peak_reaction, 1e-3, "kN");
  print_of_walls("at peak", walls.displacement_at_peak, 1e3, "mm");
  for (std::size_t k = 0; k < walls.left.size(); ++k)
    print_of_walls(fmt::format("{:g} % left", 100 * walls.left[k]), walls.capacity[k], 1e3, "mm");
  for (const Share& mode : walls.mode)
    fmt::print("failure mode {}: {} walls ({:.0f} to {:.0f} % of all such walls)\n", mode.name,
               mode.count, 100 * mode.share.interval.low, 100 * mode.share.interval.high);
  if (walls.peak_reaction.n < kFewestForInterval)
    fmt::print("fewer than six walls give no interval of a median\n");
}

}  // namespace

int run_walls(const RunArguments& a) {
  const std::string language = a.language.empty() ? "en" : a.language;
  check_language(language);
  for (const auto& [option, value] :
       {std::pair("--checkpoint", a.checkpoint), std::pair("--resume", a.resume)})
    if (!value.empty())
      refuse(option, value, "is for one wall, and --walls asks for several",
             "leave it out; wythe campaign --resume goes on with walls that are stored");
  const int walls = whole_number("--walls", a.walls, 2, kMostWalls, "write e.g. --walls 8");
  CampaignOptions options;
  if (!a.jobs.empty())
    options.jobs = whole_number("--jobs", a.jobs, 1, 4096, "leave it out for one wall a core");
  options.provenance = provenance_text();
  const StudySpec study = study_of_walls(a, walls);
  const ModelBuilder build = model_builder(study);
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
  print_walls(statistics.walls);
  fmt::print("report {}/report.html\n", a.out);
  return outcome.interrupted || statistics.answered == 0 ? kFailed : 0;
}

}  // namespace wythe::app
