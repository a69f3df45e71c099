// wythe picture: the stored states of one sample of a campaign, side by side.
#include <fmt/format.h>

#include <cmath>

#include "campaign_commands.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe::app {
namespace {

bool is_wanted(const Snapshot& s, const std::vector<double>& at_mm) {
  for (const double mm : at_mm)
    if (std::fabs(1e3 * s.displacement - mm) < 0.5) return true;
  return at_mm.empty();
}

void check_numbers(const PictureArguments& a) {
  constexpr double kMostScale = 1e6;
  if (!(a.scale >= 0 && a.scale <= kMostScale))
    refuse("--scale", fmt::format("{}", a.scale),
           fmt::format("must be a number from 0 to {:g}", kMostScale),
           "write e.g. --scale 10, or leave it out for one that fits");
  for (const double mm : a.at_mm)
    if (!std::isfinite(mm))
      refuse("--at", fmt::format("{}", mm), "must be a finite number of millimetres",
             "write e.g. --at 10 20 40");
}

}  // namespace

int picture(const PictureArguments& a) {
  check_numbers(a);
  check_answer_file(a.out, {}, "class=\"states\"");
  const Campaign campaign = read_campaign(a.folder);
  if (a.sample < 1 || a.sample > campaign.samples.n_sample())
    refuse("--sample", std::to_string(a.sample),
           fmt::format("the campaign has samples 1 to {}", campaign.samples.n_sample()),
           "name one of them");
  const ModelBuilder build = model_builder(campaign.study);
  const Model model = compile(build(settings_of(campaign.samples, a.sample - 1)));
  std::vector<Snapshot> states;
  std::vector<double> left_out = a.at_mm;
  std::string stored;
  for (Snapshot& s : read_states(a.folder, a.sample, model))
    if (std::erase_if(left_out, [&](double mm) { return is_wanted(s, {mm}); });
        !is_wanted(s, a.at_mm))
      stored += (stored.empty() ? "" : ", ") + fmt::format("{:.1f}", 1e3 * s.displacement);
    else
      states.push_back(std::move(s));
  if (states.empty())
    refuse("--at", fmt::format("{}", fmt::join(a.at_mm, " ")),
           fmt::format("sample {} has no state there", a.sample),
           stored.empty() ? "none is stored: write study.states" : "stored are, in mm: " + stored);
  write_text(a.out, states_svg(model, states, a.scale, fmt::format("sample {}", a.sample)));
  if (!left_out.empty())
    fmt::print(stderr, "note: no state is stored at {} mm; stored are{} those drawn{}{}\n",
               fmt::format("{}", fmt::join(left_out, ", ")), stored.empty() ? " only" : ", besides",
               stored.empty() ? "" : ", in mm: ", stored);
  fmt::print("{} states of sample {} -> {}\n", states.size(), a.sample, readable(a.out));
  return 0;
}

}  // namespace wythe::app
