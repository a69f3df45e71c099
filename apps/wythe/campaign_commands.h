// The commands for campaigns: run, merge shards, replay a sample, rewrite results, check a study.
#pragma once

#include <charconv>
#include <functional>
#include <string>
#include <vector>

#include "commands.h"
#include "wythe/model.h"
#include "wythe/study.h"

namespace wythe::app {

struct SlurmArguments {
  std::string tasks;                   // of a study, as typed; "": no array
  std::string partition, time, cores;  // as typed, "": the cluster's own; cores: the whole node
  bool submit = false;
};
struct CampaignArguments {
  std::vector<std::string> studies;  // several only for Slurm
  std::string study, out, shard, until;
  SlurmArguments slurm;
  std::string samples, seed, jobs;  // as typed, "": not given
  std::vector<std::string> overrides;
  bool resume = false, quiet = false;
  bool stored =
      false;  // with resume: run only samples in the folder's stores, as tasks of an array do
  std::string language = "en";       // of the report
  std::vector<std::string> command;  // as typed, for the command that continues
};
int campaign(const CampaignArguments& arguments);

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out, language = "en";
  std::string array;  // array whose shards the folders are, "": none
};
int merge(const MergeArguments& arguments);

struct ReplayArguments {
  std::string folder, out, intensity, language = "en";
  int sample = 0, threads = 1;
  bool replaces = false;  // over results of another model
  bool quiet = false;
};
int replay(const ReplayArguments& arguments);

// The study with all options of the command; without --samples a resumed campaign keeps its size.
StudySpec asked_study(const CampaignArguments& arguments);

// slurm_commands.cpp: a campaign as an array of Slurm.
int cluster_campaign(const CampaignArguments& arguments);

// store_commands.cpp: the progress of campaigns, and whether their stores are undamaged.
inline constexpr const char* kShardsFolder = "shards";
std::string shards_of(const std::string& folder);
// Whether a study gives such a name to the folder of an option; "heavy.bad" is a manual copy.
bool is_option_name(const std::string& name);
// Folders of the shards that an array left in `folder`, by number.
std::vector<std::string> shard_folders(const std::string& folder);
struct StatusArguments {
  std::string folder;
};
int status(const StatusArguments& arguments);
struct StoreArguments {
  std::string folder;
};
int check_store(const StoreArguments& arguments);

// Refuses a folder within that of the results if it is a link, which would lead out of it.
void check_inner_folder(const std::string& folder);

// Throws the fault of an option on the command line.
[[noreturn]] void refuse(const std::string& option, const std::string& value,
                         const std::string& problem, const std::string& cure);
// The number that an option states; refuses a text that is none, or none that fits.
template <class Number = double, class Fits>
Number option_number(const std::string& option, const std::string& text, const Fits& fits,
                     const std::string& problem, const std::string& cure) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !fits(number)) refuse(option, text, problem, cure);
  return number;
}
int whole_number(const std::string& option, const std::string& text, int least, int most,
                 const std::string& cure);
// Number of cores, as in Python and C: 0, or no option, means all of them.
inline constexpr int kMostCores = 1024;
int jobs_of(const std::string& text);
int threads_of(int asked);
std::string shell_quoted(const std::string& word);
std::string shell_path(const std::string& path);  // the same, with ./ before a leading -

// samples.csv, statistics.json, report.html from the store, and the table on stdout.
int write_results(const std::string& folder, const std::string& language);

// The command that continues this campaign.
std::string resume_command(const CampaignArguments& arguments);

// compare_commands.cpp: a study with [[variant]], its folders and their comparison.
struct CompareArguments {
  std::vector<std::string> folders;  // of campaigns, or files of models
  std::string out, language = "en";
  bool replaces = false;  // a comparison of other campaigns
  // only for models, as typed; "": not given
  std::string walls = {}, seed = {}, jobs = {}, stiffness = {}, strength = {}, displacement = {};
  std::vector<std::string> overrides = {};
  bool resume = false, quiet = false;
  std::vector<std::string> command = {};  // as typed, for the command that continues
};
int compare(const CompareArguments& arguments);
// compare_models_command.cpp: models before and after, run as campaigns and compared.
int compare_models(const CompareArguments& arguments);
// Whether each folder has the walls of one model, pushed in several ways. Such folders are compared like their models.
[[nodiscard]] bool hold_models(const std::vector<std::string>& folders);
int compare_pushed_models(const CompareArguments& arguments);
int campaign_of_options(const CampaignArguments& arguments, const StudySpec& study,
                        const CampaignOptions& options);
// The base of a study with [[variant]] and its options, each in its
// folder, as campaign_of_options() and `wythe assess` run them.
struct OptionRun {
  const StudySpec* study;
  std::string name, folder;
  ModelBuilder build;
  int done = 0, total = 0;
};
struct OptionRuns {
  std::vector<OptionRun> runs;
  bool interrupted = false;
};
// The first samples of the base, which run before all others to measure their time.
struct FirstLook {
  int samples = 0;  // 0: none
  // Called when they are stored, with the number that ran now and the time [s].
  std::function<void(int ran, double seconds)> say;
};
// Refuses all that can be refused before the first sample runs. `study` must outlive the result.
OptionRuns run_options(const CampaignArguments& arguments, const StudySpec& study,
                       CampaignOptions options, const FirstLook& look = {});
// Writes the available results, and prints how to continue.
int say_stopped(const CampaignArguments& arguments, const std::vector<OptionRun>& runs);
// The model of an option; its faults name the option.
Model compile_option(const StudySpec& study, const ModelBuilder& build);
// Whether a folder has such campaigns; if so, its base and options, in order.
bool holds_options(const std::string& folder);
std::vector<std::string> option_folders(const std::string& folder);
// Whether these campaigns are one model pushed in several ways, as `wythe assess` and `wythe compare` of models leave them.
// They are not compared with each other.
bool holds_ways(const std::string& folder);
int merge_options(const MergeArguments& arguments);

struct PictureArguments {
  std::string folder, out;
  int sample = 0;
  double scale = 0;           // of displacements; 0: one that fits
  std::vector<double> at_mm;  // which states; empty: all
};
int picture(const PictureArguments& arguments);

int check_study_file(const CheckArguments& arguments);

}  // namespace wythe::app
