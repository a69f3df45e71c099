// Options side by side: a study with [[variant]] runs its base and every option on the same samples, each
// as a campaign in its own folder. Then it compares them, as it can compare any stores of equal samples.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "campaign_commands.h"
#include "interrupt.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

std::vector<OptionRun> runs_of(const StudySpec& study, const std::string& out) {
  std::vector<OptionRun> runs = {
      {&study, study.variant, out + "/" + kBaseFolder, model_builder(study)}};
  for (const VariantSpec& option : study.option)
    runs.push_back(
        {&option.study, option.name, out + "/" + option.folder, model_builder(option.study)});
  return runs;
}

// All options must compile and all folders must be free before anything is written.
void check_runs(const std::vector<OptionRun>& runs, const std::string& out, bool resume) {
  std::vector<Fault> faults;
  if (holds_campaign(out))
    faults.push_back({.file = out,
                      .problem = "holds a campaign without options",
                      .cure = "name another folder"});
  for (const OptionRun& run : runs) {
    if (!resume && holds_campaign(run.folder))
      faults.push_back({.file = run.folder,
                        .problem = "holds a campaign already",
                        .cure = "--resume goes on with it; or name another folder"});
    try {
      static_cast<void>(compile_option(*run.study, run.build));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  if (!holds_options(out)) check_folder(out, FolderFor::kCampaign);
  for (const OptionRun& run : runs) {
    check_inner_folder(run.folder);
    check_folder(run.folder, FolderFor::kCampaign);
  }
}

// One line of progress for all campaigns together.
class ProgressOfAll {
 public:
  ProgressOfAll(const std::vector<OptionRun>& runs, bool quiet) : runs_(runs), printer_(quiet) {
    for (const OptionRun& run : runs) before_ += run.done;
  }
  void operator()(std::size_t current, const CampaignProgress& p) {
    CampaignProgress all = p;
    all.done = p.done;
    all.total = p.total;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (k == current) continue;
      all.done += k < current ? runs_[k].total : runs_[k].done;
      all.total += runs_[k].total;
    }
    all.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const int now = all.done - before_;
    all.rate = all.seconds > 0 ? now / all.seconds : 0;
    all.seconds_left = all.rate > 0 ? (all.total - all.done) / all.rate : -1;
    printer_(all);
  }

 private:
  using Clock = std::chrono::steady_clock;
  const std::vector<OptionRun>& runs_;
  CampaignPrinter printer_;
  Clock::time_point start_ = Clock::now();
  int before_ = 0;
};

// Notes of options: one line for equal notes, without names where all options have them.
class NotesOfOptions {
 public:
  void add(const std::string& option, const std::string& note) {
    const auto known = std::find_if(notes_.begin(), notes_.end(),
                                    [&](const auto& other) { return other.first == note; });
    if (known == notes_.end())
      notes_.push_back({note, {option}});
    else
      known->second.push_back(option);
  }
  void print(std::size_t options) const {
    for (const auto& [note, names] : notes_) {
      const bool all = names.size() == options;
      fmt::print(stderr, "note: {}{}\n",
                 all ? "" : readable(fmt::format("{}: ", fmt::join(names, ", "))), readable(note));
    }
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_;
};

// Opens or continues every store without running a sample, so that all refusals come now.
void open_all(std::vector<OptionRun>& runs, CampaignOptions options) {
  static const std::atomic<bool> kAtOnce{true};
  options.stop = &kAtOnce;
  NotesOfOptions notes;
  for (OptionRun& run : runs) {
    const CampaignOutcome outcome = run_campaign(*run.study, run.build, run.folder, options);
    run.done = outcome.done, run.total = outcome.total;
    options.last = outcome.precise_at > 0 ? outcome.precise_at : options.last;
    for (const Message& note : outcome.notes) notes.add(run.name, text_of(note));
  }
  notes.print(runs.size());
}

std::vector<ComparedCampaign> read_all(const std::vector<std::string>& folders) {
  std::vector<ComparedCampaign> stores;
  for (const std::string& folder : folders) {
    ComparedCampaign& store = stores.emplace_back();
    store.folder = folder;
    store.campaign = read_campaign(folder);
    store.name = store.campaign.study.variant;
    if (store.name.empty()) store.name = fs::path(folder + "/").parent_path().filename().string();
  }
  std::vector<std::string> names;
  for (const ComparedCampaign& store : stores) names.push_back(store.name);
  for (ComparedCampaign& store : stores)
    if (store.name.empty() || std::count(names.begin(), names.end(), store.name) > 1)
      store.name = store.folder;
  for (ComparedCampaign& store : stores) store.name = readable(store.name);
  return stores;
}

void print_comparison(const PairedComparison& comparison, const std::string& out) {
  for (const OptionComparison& option : comparison.option) {
    fmt::print("{}\n", readable(text_of(option.headline)));
    for (const Message& note : option.notes) fmt::print("  note: {}\n", readable(text_of(note)));
  }
  fmt::print("comparison {}/comparison.html\n", out);
}

// Folders are written relative to `out`, if they are inside it.
int write_comparison(const std::vector<std::string>& folders, const std::string& out,
                     const std::string& language) {
  std::vector<ComparedCampaign> stores = read_all(folders);
  PairedComparison comparison = compare_campaigns(stores);
  const auto shown = [&](std::string& folder) {
    const fs::path inside = fs::path(folder).lexically_relative(out);
    if (!inside.empty() && *inside.begin() != "..") folder = inside.string();
    folder = readable(folder);  // a name may not be UTF-8, and JSON holds only UTF-8
  };
  shown(comparison.base_folder);
  for (OptionComparison& option : comparison.option) shown(option.folder);
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw IoError(out + ": cannot be made: " + error.message());
  Replacement results(out, [](const std::string& name) {
    return name == "comparison.json" || name == "comparison.html";
  });
  write_text(results.path() + "/comparison.json", comparison_json(comparison));
  write_text(results.path() + "/comparison.html",
             report_page(comparison_data(comparison), language));
  results.commit(hold_for_test);
  print_comparison(comparison, out);
  const bool all = std::all_of(comparison.option.begin(), comparison.option.end(),
                               [](const OptionComparison& o) { return o.pairs > 0; });
  return all ? 0 : kFailed;
}

}  // namespace

Model compile_option(const StudySpec& study, const ModelBuilder& build) try {
  return compile(build({}));
} catch (const InputError& error) {
  if (study.variant_place == 0) throw;
  std::vector<Fault> faults = error.faults();
  for (Fault& fault : faults)
    fault.path = fmt::format("variant \"{}\": {}", study.variant, fault.path);
  throw InputError(std::move(faults));
}

bool holds_options(const std::string& folder) {
  return !holds_campaign(folder) && holds_campaign(folder + "/" + kBaseFolder);
}

bool holds_ways(const std::string& folder) {
  if (!holds_options(folder)) return false;
  const StudySpec base = read_study_of(folder + "/" + kBaseFolder);
  return fs::path(base.file).filename() == kStudyOfModel;
}

std::vector<std::string> option_folders(const std::string& folder) {
  std::vector<std::pair<int, std::string>> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string path = folder + "/" + entry.path().filename().string();
    if (entry.is_directory() && is_option_name(entry.path().filename().string()) &&
        holds_campaign(path))
      found.emplace_back(read_study_of(path).variant_place, path);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> folders;
  for (auto& [place, path] : found) folders.push_back(std::move(path));
  return folders;
}

OptionRuns run_options(const CampaignArguments& a, const StudySpec& study, CampaignOptions options,
                       const FirstLook& look) {
  OptionRuns out{.runs = runs_of(study, a.out)};
  std::vector<OptionRun>& runs = out.runs;
  check_runs(runs, a.out, a.resume);
  const StopSignal stop;
  open_all(runs, options);
  options.resume = true;
  options.stop = &stop.asked();
  ProgressOfAll progress(runs, a.quiet);
  int stored = 0;
  for (const OptionRun& run : runs) stored += run.done;
  if (look.samples > 0) {
    CampaignOptions first = options;
    first.last = look.samples;
    const OptionRun& base = runs.front();
    const auto start = std::chrono::steady_clock::now();
    int ran = 0;
    const CampaignOutcome outcome =
        run_campaign(*base.study, base.build, base.folder, first, [&](const CampaignProgress& p) {
          if (p.last == nullptr) return;
          ++ran;
          hold_for_test(fmt::format("sample {}", ++stored));
        });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    out.interrupted = outcome.interrupted;
    if (!out.interrupted) look.say(ran, took.count());
  }
  for (std::size_t k = 0; k < runs.size() && !out.interrupted; ++k) {
    OptionRun& run = runs[k];
    StudySpec asked = *run.study;
    if (k > 0) asked.until.clear();  // options use the samples of the base
    const CampaignOutcome outcome =
        run_campaign(asked, run.build, run.folder, options, [&](const CampaignProgress& p) {
          progress(k, p);
          if (p.last != nullptr) hold_for_test(fmt::format("sample {}", ++stored));
        });
    run.done = outcome.done, run.total = outcome.total;
    out.interrupted = outcome.interrupted;
    if (k == 0) options.last = outcome.precise_at;
    if (k == 0 && outcome.precise_at > 0)
      fmt::print("precise enough after {} samples of the base: {}\n", outcome.precise_at,
                 text_of(outcome.until_state));
    if (k == 0 && outcome.precise_at > 0)
      for (std::size_t i = 1; i < runs.size(); ++i)
        runs[i].total = std::min(runs[i].total, outcome.precise_at);
  }
  return out;
}

int say_stopped(const CampaignArguments& a, const std::vector<OptionRun>& runs) {
  int done = 0, total = 0;
  for (const OptionRun& run : runs) {
    done += run.done, total += run.total;
    if (run.done > 0)
      static_cast<void>(write_campaign_files(run.folder, read_answers(run.folder), a.language));
  }
  fmt::print(stderr, "stopped: {} of {} samples are stored. To continue:\n  {}\n", done, total,
             resume_command(a));
  return kFailed;
}

int campaign_of_options(const CampaignArguments& a, const StudySpec& study,
                        const CampaignOptions& options) {
  const OptionRuns ran = run_options(a, study, options);
  if (ran.interrupted) return say_stopped(a, ran.runs);
  for (const OptionRun& run : ran.runs) {
    fmt::print("\n{}\n", readable(run.name));
    static_cast<void>(write_results(run.folder, a.language));
  }
  fmt::print("\n");
  std::vector<std::string> folders;
  for (const OptionRun& run : ran.runs) folders.push_back(run.folder);
  return write_comparison(folders, a.out, a.language);
}

namespace {

// A run has one wall and one way of pushing, so there are no pairs and no worse direction.
void refuse_runs(const CompareArguments& a) {
  std::vector<Fault> faults;
  for (const std::string& folder : a.folders)
    if (fs::exists(folder + "/summary.json") && !holds_campaign(folder) && !holds_options(folder)) {
      std::string models;
      for (const std::string& one : a.folders)
        models += " " + shell_path(holds_campaign(one) ? one : one + "/model.used.toml");
      faults.push_back({.file = folder,
                        .problem = "is a run of one wall, pushed one way",
                        .cure = "wythe compare" + models + " --out " + shell_path(a.out) +
                                " pushes several walls of each model both ways"});
    }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

int compare(const CompareArguments& a) {
  check_language(a.language);
  refuse_runs(a);
  if (std::any_of(a.folders.begin(), a.folders.end(),
                  [](const std::string& path) { return fs::is_regular_file(path); }))
    return compare_models(a);
  const auto refuse_given = [](const std::string& option, const std::string& value) {
    if (!value.empty())
      refuse(option, value, "is for models, and these are folders of campaigns", "leave it out");
  };
  refuse_given("--walls", a.walls);
  refuse_given("--seed", a.seed);
  refuse_given("--jobs", a.jobs);
  refuse_given("--set", a.overrides.empty() ? "" : a.overrides.front());
  if (a.resume)
    refuse("--resume", "", "is for models, and these are folders of campaigns", "leave it out");
  if (hold_models(a.folders)) return compare_pushed_models(a);
  refuse_given("--stiffness", a.stiffness);
  refuse_given("--strength", a.strength);
  refuse_given("--displacement", a.displacement);
  std::vector<std::string> folders;
  for (const std::string& folder : a.folders) {
    if (!holds_options(folder)) {
      folders.push_back(folder);
      continue;
    }
    if (holds_ways(folder))
      refuse(folder, "", "holds the walls of one model, pushed in several ways",
             "name two such folders, the model before first, or campaigns within them");
    for (std::string& inner : option_folders(folder)) folders.push_back(std::move(inner));
  }
  if (holds_options(a.out)) {
    if (origin_of(folders, false).file != origin_of(option_folders(a.out), false).file)
      refuse("--out", a.out, "holds the comparison of its own campaigns", "name another folder");
    return write_comparison(folders, a.out, a.language);
  }
  const Origin origin = origin_of(folders, a.replaces);
  check_origin(a.out, origin);
  const int code = write_comparison(folders, a.out, a.language);
  write_origin(a.out, origin);
  return code;
}

int merge_options(const MergeArguments& a) {
  check_language(a.language);
  for (const std::string& store : option_folders(a.folders.front())) {
    const std::string name = fs::path(store).filename().string();
    MergeArguments one{
        .folders = {}, .out = a.out + "/" + name, .language = a.language, .array = a.array};
    check_inner_folder(one.out);
    for (const std::string& folder : a.folders) one.folders.push_back(folder + "/" + name);
    fmt::print("\n{}\n", name);
    static_cast<void>(merge(one));
  }
  return compare({.folders = {a.out}, .out = a.out, .language = a.language});
}

}  // namespace wythe::app
