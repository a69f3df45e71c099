// wythe compare of models: pushes each model's walls both ways, in a campaign each, and compares
// the later models with the first. It also accepts folders of walls that were pushed so.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "campaign_commands.h"
#include "interrupt.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/result.h"
#include "wythe/study.h"

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

// NaN where the option was not given.
double share_of(const std::string& option, const std::string& text) {
  if (text.empty()) return kUnset;
  return option_number(
      option, text, [](double value) { return value >= 0 && value < 1; },
      "must be a share from 0 to less than 1", "write e.g. " + option + " 0.05");
}

// "wall.toml", or the whole path where two files have one name.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(fs::path(file).filename().string());
  std::vector<std::string> out;
  for (std::size_t k = 0; k < files.size(); ++k)
    out.push_back(std::count(names.begin(), names.end(), names[k]) > 1 ? files[k] : names[k]);
  return out;
}

void check_files(const std::vector<std::string>& files) {
  std::vector<Fault> faults;
  const auto add = [&](const std::string& file, const std::string& problem,
                       const std::string& cure) {
    faults.push_back({.file = file, .problem = problem, .cure = cure});
  };
  const auto model = std::find_if(files.begin(), files.end(), [](const std::string& file) {
    std::error_code error;
    return !fs::is_directory(file, error);
  });  // there is one, because folders alone are compared as campaigns
  for (const std::string& file : files) {
    std::error_code error;
    if (!fs::exists(file, error))
      add(file, "is not there", "name files of models, the one before first");
    else if (fs::is_directory(file, error))
      add(file, fmt::format("is a folder, beside {}, which is none", *model),
          "name models alone, or folders of campaigns alone");
    else if (is_study(file))
      add(file, "is a study, beside files of models", "run wythe campaign with it, or name models");
  }
  if (files.size() < 2)
    add(files.front(), "has nothing to be compared with",
        "name two models or more, the one before first");
  if (!faults.empty()) throw InputError(std::move(faults));
}

// A resumed comparison keeps the stored walls, unless more are asked for.
void keep_stored_walls(const CompareArguments& a, int asked, const std::string& base,
                       std::vector<StudySpec>& studies) {
  if (!a.resume || !holds_campaign(base)) return;
  const std::vector<int> stored = stored_batches(base);
  if (!a.walls.empty() && asked > std::accumulate(stored.begin(), stored.end(), 0)) return;
  for (StudySpec& study : studies) {
    study.batch = stored;
    for (VariantSpec& way : study.option) way.study.batch = stored;
  }
}

PushWay way_in(const std::string& campaign) {
  return way_of(model_builder(read_study_of(campaign))({}));
}
bool is_same(const PushWay& a, const PushWay& b) {
  return a.direction == b.direction && a.pattern == b.pattern;
}

// Refuses a folder with campaigns, or with a comparison of other campaigns.
void check_out(const CompareArguments& a) {
  if (holds_campaign(a.out) || holds_options(a.out))
    refuse("--out", a.out, "holds campaigns", "name another folder");
  std::error_code error;
  if (!a.replaces && fs::exists(a.out + "/comparison.json", error) &&
      !holds_options(a.out + "/before"))
    refuse("--out", a.out, "holds a comparison of other campaigns",
           "name another folder, or add --replace");
}

// The folders of one model's ways of pushing, as `wythe compare` of models or
// `wythe assess` wrote them, in the order of `ways`; empty where one is missing.
std::vector<std::string> folders_of(const std::string& folder, const std::vector<PushWay>& ways) {
  std::vector<std::string> all = option_folders(folder), out;
  for (const PushWay& way : ways) {
    const auto is_that = [&](const std::string& one) { return is_same(way_in(one), way); };
    const auto found = std::find_if(all.begin(), all.end(), is_that);
    if (found == all.end()) return {};
    out.push_back(*found);
  }
  return out;
}

void print_models(const PairedComparison& comparison, const std::string& out) {
  for (const Intervention& one : comparison.intervention) {
    fmt::print("{}{}\n", one.cautions.empty() ? "" : "WARNING ", readable(text_of(one.sentence)));
    for (const Message& note : one.notes) fmt::print("  note: {}\n", readable(text_of(note)));
  }
  fmt::print("comparison {}/comparison.html\n", readable(out));
}

ChangeLimits limits_of(const CompareArguments& a) {
  return {.stiffness = share_of("--stiffness", a.stiffness),
          .strength = share_of("--strength", a.strength),
          .displacement = share_of("--displacement", a.displacement)};
}

int write_answers(const CompareArguments& a, const std::vector<ModelFolders>& folders,
                  const ChangeLimits& limits) {
  const PairedComparison comparison =
      write_models(a.out, folders, limits, a.language, hold_for_test);
  print_models(comparison, a.out);
  const auto is_known = [](const Intervention& one) {
    return one.answer != ChangeAnswer::kNotKnown;
  };
  return std::all_of(comparison.intervention.begin(), comparison.intervention.end(), is_known)
             ? 0
             : kFailed;
}

}  // namespace

bool hold_models(const std::vector<std::string>& folders) {
  if (folders.size() < 2 || !std::all_of(folders.begin(), folders.end(), holds_options))
    return false;
  std::vector<PushWay> ways;  // two options of a study with [[variant]] may push alike
  for (const std::string& one : option_folders(folders.front())) {
    const PushWay way = way_in(one);
    if (std::any_of(ways.begin(), ways.end(), [&](const PushWay& w) { return is_same(w, way); }))
      return false;
    ways.push_back(way);
  }
  return ways.size() > 1;
}

int compare_pushed_models(const CompareArguments& a) {
  std::vector<PushWay> ways;
  for (const std::string& one : option_folders(a.folders.front())) ways.push_back(way_in(one));
  std::vector<ModelFolders> models;
  std::vector<Fault> faults;
  for (const std::string& folder : a.folders) {
    models.push_back({readable(fs::path(folder + "/").parent_path().filename().string()),
                      folders_of(folder, ways)});
    if (models.back().campaign.empty() || option_folders(folder).size() != ways.size())
      faults.push_back({.file = folder,
                        .problem = "was pushed in other ways than " + a.folders.front(),
                        .cure = "push both alike, with wythe compare of their models or with wythe "
                                "assess of each"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  const ChangeLimits limits = limits_of(a);
  const Origin origin = origin_of(a.folders, a.replaces);
  check_origin(a.out, origin);
  const int code = write_answers(a, models, limits);
  write_origin(a.out, origin);
  return code;
}

int compare_models(const CompareArguments& a) {
  check_files(a.folders);
  for (const std::string& text : a.overrides)
    if (text.starts_with("study.") || text.starts_with("variant."))
      refuse("--set", text, "is of a study, and models have none",
             "leave it out; --walls and --seed say which walls are drawn");
  AskedModels asked{.files = a.folders, .overrides = a.overrides};
  if (!a.walls.empty())
    asked.walls = whole_number("--walls", a.walls, 2, kMostWalls, "write e.g. --walls 8");
  if (!a.seed.empty())
    asked.seed = whole_number("--seed", a.seed, 0, 2'147'483'647, "write e.g. --seed 1");
  check_out(a);
  const ChangeLimits limits = limits_of(a);
  CampaignOptions options;
  options.jobs = jobs_of(a.jobs);
  options.resume = a.resume;
  options.provenance = provenance_text();
  std::vector<StudySpec> studies = studies_of_models(asked);
  keep_stored_walls(a, asked.walls, a.out + "/before/" + kBaseFolder, studies);
  hold_for_test("model read");
  std::vector<CampaignArguments> runs(studies.size());
  for (std::size_t k = 0; k < studies.size(); ++k) {
    const std::string after = studies.size() > 2 ? fmt::format("after_{}", k) : "after";
    runs[k].out = a.out + "/" + (k == 0 ? "before" : after);
    runs[k].resume = a.resume;
    runs[k].quiet = a.quiet;
    runs[k].language = a.language;
    runs[k].command = a.command;
    if (!a.resume && holds_options(runs[k].out))
      refuse("--out", runs[k].out, "holds the walls of a model already",
             "--resume goes on with them; or name another folder");
  }
  const std::vector<std::string> names = names_of(a.folders);
  std::vector<ModelFolders> folders;
  for (std::size_t k = 0; k < studies.size(); ++k) {
    if (!a.quiet) fmt::print(stderr, "{}\n", readable(names[k]));
    const OptionRuns ran = run_options(runs[k], studies[k], options);
    if (ran.interrupted) return say_stopped(runs[k], ran.runs);
    ModelFolders& of = folders.emplace_back();
    of.name = names[k];
    for (const OptionRun& run : ran.runs) {
      of.campaign.push_back(run.folder);
      static_cast<void>(write_campaign_files(run.folder, read_answers(run.folder), a.language));
    }
  }
  return write_answers(a, folders, limits);
}

}  // namespace wythe::app
