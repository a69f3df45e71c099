// The commands about campaigns: run, join shards, replay a sample, rewrite results, check a study.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "commands.h"
#include "wythe/model.h"
#include "wythe/study.h"

namespace wythe::app {

struct SlurmArguments {
  std::string tasks;                   // of a study, as typed; "": here and now
  std::string partition, time, cores;  // as typed, "": the cluster's own; cores: the whole node
  bool submit = false;
};
struct CampaignArguments {
  std::vector<std::string> studies;  // several for Slurm alone
  std::string study, out, shard, until;
  SlurmArguments slurm;
  std::string samples, seed, jobs;  // as typed, "": not given
  std::vector<std::string> overrides;
  bool resume = false, quiet = false;
  bool stored =
      false;  // with resume: only what the folder's stores hold, as the tasks of an array do
  std::string language = "en";       // of the report
  std::vector<std::string> command;  // as typed, to say how to go on
};
int campaign(const CampaignArguments& arguments);

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out, language = "en";
  std::string array;  // that the folders are shards of, "": none
};
int merge(const MergeArguments& arguments);

struct ReplayArguments {
  std::string folder, out, intensity, language = "en";
  int sample = 0, threads = 1;
  bool replaces = false;  // results of another model
  bool quiet = false;
};
int replay(const ReplayArguments& arguments);

// The study with all options of the command; without --samples a resumed campaign keeps its size.
StudySpec asked_study(const CampaignArguments& arguments);

// slurm_commands.cpp: a campaign as an array of Slurm.
int cluster_campaign(const CampaignArguments& arguments);

// store_commands.cpp: how far campaigns are, and whether their stores are whole.
inline constexpr const char* kShardsFolder = "shards";
std::string shards_of(const std::string& folder);
// Such as a study gives to the folder of an option; "heavy.bad" is a copy by hand.
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

// A folder within the one that results go to: InputError where it is a link, which would lead out of it.
void check_inner_folder(const std::string& folder);

// Of options on the command line.
[[noreturn]] void refuse(const std::string& option, const std::string& value,
                         const std::string& problem, const std::string& cure);
int whole_number(const std::string& option, const std::string& text, int least, int most,
                 const std::string& cure);
// Cores, as Python and C count them: 0, or an option that is not given, is all of them.
inline constexpr int kMostCores = 1024;
int jobs_of(const std::string& text);
int threads_of(int asked);
std::string shell_quoted(const std::string& word);
std::string shell_path(const std::string& path);  // the same, and no option where it begins with -

// samples.csv, statistics.json, report.html from the store, and the table on stdout.
int write_results(const std::string& folder, const std::string& language);

// The command that goes on with this campaign.
std::string resume_command(const CampaignArguments& arguments);

// compare_commands.cpp: a study with [[variant]], its folders and how they compare.
struct CompareArguments {
  std::vector<std::string> folders;  // of campaigns, or files of models
  std::string out, language = "en";
  bool replaces = false;  // a comparison of other campaigns
  // of models alone, as typed; "": not given
  std::string walls = {}, seed = {}, jobs = {}, stiffness = {}, strength = {}, displacement = {};
  std::vector<std::string> overrides = {};
  bool resume = false, quiet = false;
  std::vector<std::string> command = {};  // as typed, to say how to go on
};
int compare(const CompareArguments& arguments);
// compare_models_command.cpp: models before and after, run as campaigns and compared.
int compare_models(const CompareArguments& arguments);
// Whether each folder holds the walls of one model, pushed in ways that differ; those folders compared as their models are.
[[nodiscard]] bool hold_models(const std::vector<std::string>& folders);
int compare_pushed_models(const CompareArguments& arguments);
int campaign_of_options(const CampaignArguments& arguments, const StudySpec& study,
                        const CampaignOptions& options);
// The base of a study with [[variant]] and its options, each in its folder: what campaign_of_options() and
// `wythe assess` run.
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
// The first samples of the base, run before all others to measure how long they take.
struct FirstLook {
  int samples = 0;  // 0: none
  // Once they are stored; how many ran now, and how long it took [s].
  std::function<void(int ran, double seconds)> say;
};
// Refuses what can be refused before the first sample runs. `study` outlives what is returned.
OptionRuns run_options(const CampaignArguments& arguments, const StudySpec& study,
                       CampaignOptions options, const FirstLook& look = {});
// Writes what is there, and says how to go on.
int say_stopped(const CampaignArguments& arguments, const std::vector<OptionRun>& runs);
// The wall of an option; its faults name the option.
Model compile_option(const StudySpec& study, const ModelBuilder& build);
// Whether a folder holds such campaigns; then its base and options, in order.
bool holds_options(const std::string& folder);
std::vector<std::string> option_folders(const std::string& folder);
int merge_options(const MergeArguments& arguments);

struct PictureArguments {
  std::string folder, out;
  int sample = 0;
  double scale = 0;           // of displacements; 0: one that fits
  std::vector<double> at_mm;  // which states; none: all
};
int picture(const PictureArguments& arguments);

int check_study_file(const CheckArguments& arguments);

}  // namespace wythe::app
