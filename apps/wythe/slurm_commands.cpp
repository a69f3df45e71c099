// Submits a campaign as a job array of Slurm.
//
//   check all studies ─► create the stores of all shards, with their samples ─► three scripts ─► sbatch
//
// From then on the study is fixed: each task continues its store, and refuses
// a study file that differs. This file contains no scheduling. The stores show
// which samples have run, so submitting again runs only the missing ones.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <utility>

#include "campaign_commands.h"
#include "slurm_scripts.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/solve.h"
#include "wythe/study.h"

extern char** environ;

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTasks = 1000;  // an array's default limit is 1001

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

std::string program() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? "wythe" : self.string();
}

// The number of shards that the campaign in a shard's folder belongs to; 0: it has not begun.
int shards_in(const std::string& folder) {
  if (holds_campaign(folder)) return campaign_progress(folder).shards;
  if (!holds_options(folder)) return 0;
  return campaign_progress(option_folders(folder).front()).shards;
}

// A study of the array: its base and options, and the folder of each within a shard's; "" if there is only one.
struct ClusterStudy {
  std::string file, folder;  // absolute
  StudySpec study;
  int shards = 1;

  [[nodiscard]] std::vector<std::pair<StudySpec*, std::string>> walls() {
    std::vector<std::pair<StudySpec*, std::string>> all = {
        {&study, study.option.empty() ? "" : std::string("/") + kBaseFolder}};
    for (VariantSpec& option : study.option) all.emplace_back(&option.study, "/" + option.folder);
    return all;
  }
  [[nodiscard]] std::string shard(int number) const {
    return fmt::format("{}/{}", shards_of(folder), number);
  }
  [[nodiscard]] ShardStores stores(const std::string& inner, bool may_shrink) const {
    ShardStores of{.folders = {}, .joined = folder + inner, .may_shrink = may_shrink};
    for (int i = 1; i <= shards; ++i) of.folders.push_back(shard(i) + inner);
    return of;
  }
};

// For file systems that ignore case, or drop a dot at the end.
std::string folder_key(const std::string& name) {
  std::string key = small_letters(name);
  key.erase(key.find_last_not_of(". ") + 1);
  return key;
}

// The folder of a study beside others in `out`, which also contains files and folders of wythe.
std::string inner_folder(const std::string& file, std::map<std::string, std::string>& taken) {
  const std::string name = fs::path(file).stem().string(), key = folder_key(name);
  if (key.empty())
    refuse("study", file, "gives no name for its folder", "rename the file, e.g. wall_a.toml");
  for (const char* own : {"slurm", kShardsFolder, kBaseFolder, "campaign", "campaign.db",
                          "campaign.lock", "samples.csv", "statistics.json", "report.html",
                          "report.data", "comparison.json", "comparison.html"})
    if (key == own)
      refuse("study", file, fmt::format("would have the folder {}, which wythe uses itself", name),
             "rename the file");
  if (const auto [other, is_new] = taken.emplace(key, file); !is_new)
    refuse("study", file,
           fmt::format("has the name of another study, {}, and so its folder", other->second),
           "rename one: capitals and a dot at the end do not tell folders apart everywhere");
  return name;
}

// A folder is either for one study or for several.
void check_kind(const std::string& out, bool several) {
  std::error_code error;
  if (several) {
    if (holds_campaign(out) || holds_options(out) || !shard_folders(out).empty())
      refuse("--out", out, "holds the campaign or the array of one study",
             "name another folder for several");
    return;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
    const std::string inner = out + "/" + entry.path().filename().string();
    if (entry.is_directory(error) && !shard_folders(inner).empty())
      refuse("--out", out, fmt::format("holds an array of several studies ({})", inner),
             "name them all, or another folder");
  }
}

void check_walls(ClusterStudy& of) {
  if (!of.study.option.empty() && holds_campaign(of.folder))
    refuse("--out", of.folder, "holds a campaign without options", "name another folder");
  if (of.study.option.empty() && holds_options(of.folder))
    refuse("--out", of.folder, "holds the campaigns of a study with [[variant]]",
           "name another folder");
  for (auto& [study, inner] : of.walls()) {
    static_cast<void>(compile_option(*study, model_builder(*study)));
    check_folder(of.folder + inner, FolderFor::kCampaign);
  }
  check_inner_folder(of.folder);
  check_inner_folder(shards_of(of.folder));
  for (int shard = 1; shard <= of.shards; ++shard) {
    check_inner_folder(of.shard(shard));
    for (auto& [study, inner] : of.walls()) check_inner_folder(of.shard(shard) + inner);
  }
}

// Variants may be added for all shards together; an existing one must not be missing.
void check_variants(ClusterStudy& of) {
  std::vector<std::string> is;
  for (auto& [study, inner] : of.walls()) is.push_back(inner.empty() ? "none" : inner.substr(1));
  for (const std::string& shard : shard_folders(of.folder)) {
    std::vector<std::string> was = {"none"};
    if (holds_options(shard)) {
      was.clear();
      for (const std::string& inner : option_folders(shard))
        was.push_back(fs::path(inner).filename().string());
    }
    const bool has_all = std::all_of(was.begin(), was.end(), [&](const std::string& one) {
      return std::find(is.begin(), is.end(), one) != is.end();
    });
    if (!has_all)
      refuse("variant", fmt::format("{}", fmt::join(is, ", ")),
             fmt::format("was {} in {} when the array was handed in", fmt::join(was, ", "), shard),
             "put back what is missing, or name another folder");
  }
}

// All shards, base and options, get one design: the largest present one, plus the samples asked beyond it.
void settle_design(ClusterStudy& of, bool may_shrink) {
  std::vector<int> design;
  const auto total = [](const std::vector<int>& batch) {
    int sum = 0;
    for (const int samples : batch) sum += samples;
    return sum;
  };
  for (auto& [study, inner] : of.walls()) {
    const std::vector<int> one = check_shards(*study, of.stores(inner, may_shrink));
    if (design.empty() || total(one) > total(design) ||
        (total(one) == total(design) && one.size() > design.size()))
      design = one;
  }
  const int asks = total(of.study.batch), has = total(design);
  if (asks < has)
    fmt::print(stderr,
               "note: {} holds a design of {} samples, {} asks for {}: all {} are run, since a "
               "design can only grow\n",
               readable(of.folder), has, readable(of.file), asks, has);
  for (auto& [study, inner] : of.walls()) {
    study->batch = design;
    static_cast<void>(check_shards(*study, of.stores(inner, false)));  // all shards may grow to it
  }
}

void check_samples(const ClusterStudy& of, const std::string& tasks) {
  if (const int samples = draw_samples(of.study).n_sample(); samples < of.shards)
    refuse("--slurm", tasks, fmt::format("is more than the {} samples of {}", samples, of.file),
           "ask for fewer tasks");
}

// Each study must be valid and have samples for all tasks, before anything is written.
std::vector<ClusterStudy> checked_studies(const CampaignArguments& a, int shards) {
  const std::string out = absolute(a.out);
  const bool several = a.studies.size() > 1;
  check_kind(out, several);
  std::vector<ClusterStudy> studies;
  std::map<std::string, std::string> taken;
  for (const std::string& file : a.studies) {
    CampaignArguments one = a;
    one.study = file;
    one.resume = false;  // the present stores are checked for all shards together
    ClusterStudy of{
        .file = absolute(file), .folder = out, .study = asked_study(one), .shards = shards};
    if (!of.study.until.empty())
      refuse("--slurm", std::to_string(shards),
             "does not go with a rule that says when it is precise enough: a shard sees only its "
             "own samples",
             "leave out `until`, and add samples later with a larger --samples");
    if (several) of.folder += "/" + inner_folder(file, taken);
    for (const std::string& shard : shard_folders(of.folder))
      if (const int was = shards_in(shard); was != shards)
        refuse("--slurm", std::to_string(shards),
               fmt::format("does not fit {}, which is one of {} shards", shard, was),
               fmt::format("write --slurm {}, or name another folder", was));
    check_walls(of);
    check_variants(of);
    settle_design(of, a.samples.empty());
    check_samples(of, a.slurm.tasks);
    studies.push_back(std::move(of));
  }
  return studies;
}

void make_stores(std::vector<ClusterStudy>& studies) {
  for (ClusterStudy& of : studies)
    for (auto& [study, inner] : of.walls())
      make_shards(*study, model_builder(*study), of.stores(inner, false), provenance_text());
}

// For each task: which process runs it now, or whether it has samples left.
SlurmJob job_of(std::vector<ClusterStudy>& studies, int shards, const std::string& folder) {
  SlurmJob job;
  job.shards = shards;
  job.program = program();
  job.folder = folder;
  int task = 0;
  for (ClusterStudy& of : studies) {
    job.studies.push_back({of.file, of.folder});
    for (int shard = 1; shard <= shards; ++shard) {
      ++task;
      bool is_done = true;
      std::string writer;
      for (auto& [study, inner] : of.walls()) {
        const StoreProgress progress = campaign_progress(of.shard(shard) + inner);
        is_done = is_done && progress.done >= progress.total;
        if (writer.empty()) writer = progress.writer;
      }
      if (!writer.empty()) {
        job.running.push_back(task);
        fmt::print("task {} is left alone: {} runs it\n", task, readable(writer));
      } else if (!is_done) {
        job.tasks.push_back(task);
      }
    }
  }
  return job;
}

// Submits the script by its path; it contains no text from outside.
void hand_in(const std::string& script) {
  std::string shell = "/bin/sh", path = script;
  char* words[] = {shell.data(), path.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawn(&child, "/bin/sh", nullptr, nullptr, words, environ);
  if (error != 0) throw IoError(script + ": cannot be run: " + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  constexpr int kJoinAlone = 3;  // of submit_script
  if (WIFEXITED(status) && WEXITSTATUS(status) == kJoinAlone)
    throw IoError(script + ": Slurm took the array, but not the join; what to do stands above");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw IoError(script +
                  ": Slurm did not take the jobs (its words stand above); the scripts are written, "
                  "hand them in where sbatch works: sh " +
                  shell_quoted(script));
}

void write_scripts(const CampaignArguments& a, const SlurmJob& job, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  write_text(folder + "/array.sh", array_script(a, job));
  write_text(folder + "/merge.sh", merge_script(a, job));
  write_text(folder + "/submit.sh", submit_script(job));
}

// Refuses options that make no sense for tasks, or have another form here. Returns the number of shards.
int check_arguments(const CampaignArguments& a) {
  const SlurmArguments& s = a.slurm;
  const int shards =
      whole_number("--slurm", s.tasks, 1, kMostTasks, "write the number of tasks, e.g. --slurm 40");
  if (!a.shard.empty()) refuse("--shard", a.shard, "is given by --slurm itself", "leave it out");
  if (a.stored) refuse("--stored", "", "is for the tasks of an array", "leave it out");
  if (!a.jobs.empty())
    refuse("--jobs", a.jobs, "is given by --cores here", "write --cores " + a.jobs);
  if (static_cast<int>(a.studies.size()) * shards > kMostTasks)
    refuse("--slurm", s.tasks,
           fmt::format("asks for {} tasks in all", static_cast<int>(a.studies.size()) * shards),
           fmt::format("{} at most: fewer tasks a study", kMostTasks));
  check_slurm_name("--partition", s.partition);
  check_slurm_time("--time", s.time);
  if (!s.cores.empty())
    static_cast<void>(whole_number("--cores", s.cores, 1, kMostCores, "cores of a node"));
  return shards;
}

}  // namespace

int cluster_campaign(const CampaignArguments& a) {
  const int shards = check_arguments(a);
  const std::string out = absolute(a.out), folder = out + "/slurm";
  check_inner_folder(folder);
  std::vector<ClusterStudy> studies = checked_studies(a, shards);
  make_stores(studies);
  const SlurmJob job = job_of(studies, shards, folder);
  write_scripts(a, job, folder);
  const std::string script = folder + "/submit.sh";
  if (!job.tasks.empty())
    fmt::print("{} of {} tasks have samples left: {}\n", job.tasks.size(),
               static_cast<std::size_t>(shards) * a.studies.size(), ranges(job.tasks));
  else if (!job.running.empty())
    fmt::print("nothing to hand in: what is left runs already\n");
  else
    fmt::print("all samples have run; what is left is to join them\n");
  if (!a.slurm.submit) {
    fmt::print("to hand it in: sh {}\nhow far it is: wythe status {}\n", shell_quoted(script),
               shell_quoted(out));
    return 0;
  }
  std::fflush(stdout);
  hand_in(script);
  fmt::print("how far it is: wythe status {}\n", shell_quoted(out));
  return 0;
}

}  // namespace wythe::app
