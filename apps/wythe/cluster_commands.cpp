// A campaign as a job array of Slurm; how far any campaign has come, and whether its stores are whole.
//
// --slurm N writes three scripts. The array: task t runs shard t of N, one process on its node, and goes on where it
// stopped. The join of the shards, after the array has ended. And the one that hands both to sbatch.
//
// Nothing here schedules: what has run is read from the stores alone, so handing in again runs only what is missing.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "campaign_commands.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/io.h"
#include "wythe/stored_states.h"
#include "wythe/text.h"

extern char** environ;

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

constexpr int kUnfinished = 3;    // exit code
constexpr int kMostTasks = 1000;  // an array's default limit is 1001

struct ClusterStudy {
  std::string file, folder;  // absolute
  int samples = 0;
};

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

std::string shards_of(const std::string& folder) { return folder + "/" + kShardsFolder; }

// "1-3,7": the tasks of an array.
std::string ranges(const std::vector<int>& tasks) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t j = i;
    while (j + 1 < tasks.size() && tasks[j + 1] == tasks[j] + 1) ++j;
    text += fmt::format("{}{}", text.empty() ? "" : ",", tasks[i]);
    if (j > i) text += fmt::format("-{}", tasks[j]);
    i = j + 1;
  }
  return text;
}

// Slurm reads these words in its own way: only such letters as names and times of it have.
void check_word(const std::string& option, const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.:,") ==
                     std::string::npos;
  if (!plain || word.starts_with("-"))
    refuse(option, word, "is no name or time of Slurm",
           "letters, digits and _ - . : , alone, e.g. --partition compute --time 12:00:00");
}

std::string program() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? "wythe" : self.string();
}

// The samples of a shard that its folder holds, of the least of its options.
int done_in(const std::string& folder) {
  if (holds_campaign(folder)) return campaign_progress(folder).done;
  if (!holds_options(folder)) return 0;
  int least = std::numeric_limits<int>::max();
  for (const std::string& option : option_folders(folder))
    least = std::min(least, campaign_progress(option).done);
  return least;
}

// How many shards the campaign in a shard's folder is one of; 0: it has not begun.
int shards_in(const std::string& folder) {
  if (holds_campaign(folder)) return campaign_progress(folder).shards;
  if (!holds_options(folder)) return 0;
  return campaign_progress(option_folders(folder).front()).shards;
}

int samples_of_shard(int samples, int shard, int shards) {
  return samples / shards + (shard <= samples % shards ? 1 : 0);
}

class ClusterJob {
 public:
  ClusterJob(const CampaignArguments& a, const SlurmArguments& s, std::vector<ClusterStudy> studies,
             int shards)
      : a_(a), s_(s), studies_(std::move(studies)), shards_(shards), out_(absolute(a.out)) {
    for (std::size_t k = 0; k < studies_.size(); ++k)
      for (int shard = 1; shard <= shards; ++shard) {
        const std::string folder = fmt::format("{}/{}", shards_of(studies_[k].folder), shard);
        if (studies_.size() > 1) check_inner_folder(studies_[k].folder);
        check_inner_folder(shards_of(studies_[k].folder));
        check_inner_folder(folder);
        const int asked = samples_of_shard(studies_[k].samples, shard, shards);
        if (done_in(folder) < asked) missing_.push_back(static_cast<int>(k) * shards + shard);
      }
  }

  [[nodiscard]] const std::vector<int>& missing() const { return missing_; }
  [[nodiscard]] std::string folder() const { return out_ + "/slurm"; }

  void write() const {
    check_inner_folder(folder());
    std::error_code error;
    fs::create_directories(folder(), error);
    if (error) throw IoError(folder() + ": cannot be made: " + error.message());
    write_text(folder() + "/array.sh", array());
    write_text(folder() + "/merge.sh", merge());
    write_text(folder() + "/submit.sh", submit());
  }

 private:
  [[nodiscard]] std::string head(const char* what, bool whole_node) const {
    std::string text = "#!/bin/sh\n";
    const auto say = [&](const std::string& option) { text += "#SBATCH " + option + "\n"; };
    say(fmt::format("--job-name=wythe_{}", what));
    say("--nodes=1");
    say("--ntasks=1");
    if (!s_.partition.empty()) say("--partition=" + s_.partition);
    if (!s_.time.empty()) say("--time=" + s_.time);
    if (whole_node)
      say(s_.cores.empty() ? "--exclusive" : "--cpus-per-task=" + s_.cores);
    else
      say("--cpus-per-task=1");
    return text;
  }
  [[nodiscard]] std::string quoted_program() const {
    return fmt::format("WYTHE=${{WYTHE:-{}}}\n", shell_quoted(program()));
  }

  [[nodiscard]] std::string array() const {
    std::string text = head("array", true);
    if (!missing_.empty()) text += "#SBATCH --array=" + ranges(missing_) + "\n";
    text +=
        "#SBATCH --output=%a.log\n"
        "#SBATCH --open-mode=append\n"
        "#SBATCH --requeue\n"
        "#SBATCH --signal=B:TERM@120\n"
        "# Two minutes before its time is over, or when it has to give way, a task is told to "
        "stop: it stores\n"
        "# what it has and ends. Slurm or you hand it in again, and it goes on from there.\n";
    text += quoted_program();
    text += fmt::format(
        "study=$(( (SLURM_ARRAY_TASK_ID - 1) / {0} ))\n"
        "shard=$(( (SLURM_ARRAY_TASK_ID - 1) % {0} + 1 ))\n"
        "case $study in\n",
        shards_);
    for (std::size_t k = 0; k < studies_.size(); ++k) {
      text += fmt::format(
          "{}) exec \"$WYTHE\" campaign {} --out {}/\"$shard\" --shard \"$shard\"/{}", k,
          shell_quoted(studies_[k].file), shell_quoted(shards_of(studies_[k].folder)), shards_);
      const auto option = [&](const char* name, const std::string& value) {
        if (!value.empty()) text += fmt::format(" {} {}", name, shell_quoted(value));
      };
      option("--samples", a_.samples);
      option("--seed", a_.seed);
      option("--jobs", s_.cores);
      if (a_.language != "en") option("--lang", a_.language);
      for (const std::string& word : a_.overrides) option("--set", word);
      text += " --resume --quiet ;;\n";
    }
    return text + "esac\n";
  }

  [[nodiscard]] std::string merge() const {
    std::string text = head("merge", false) + "#SBATCH --output=merge.log\n" + quoted_program();
    for (const ClusterStudy& study : studies_)
      text += fmt::format("\"$WYTHE\" merge {0} --out {0}{1}\n", shell_quoted(study.folder),
                          a_.language != "en" ? " --lang " + shell_quoted(a_.language) : "");
    // a task that gave way counts as ended for a moment, before it stands in the queue again
    return text +
           "if [ -n \"$1\" ] && [ -n \"$(squeue -h -j \"$1\" 2>/dev/null)\" ]; then\n"
           "  sbatch --dependency=afterany:\"$1\" merge.sh \"$1\"\n"
           "fi\n";
  }

  [[nodiscard]] std::string submit() const {
    std::string text = "#!/bin/sh\nset -e\ncd \"$(dirname \"$0\")\"\n";
    if (missing_.empty()) return text + "sbatch merge.sh\n";
    return text +
           "array=$(sbatch --parsable array.sh)\n"
           "array=${array%%;*}\n"
           "echo \"array job $array\"\n"
           "sbatch --dependency=afterany:\"$array\" merge.sh \"$array\"\n";
  }

  const CampaignArguments& a_;
  const SlurmArguments& s_;
  std::vector<ClusterStudy> studies_;
  int shards_;
  std::string out_;
  std::vector<int> missing_;  // tasks that have samples left
};

// The script has no word from outside in it; it is run by its path.
void hand_in(const std::string& script) {
  std::string shell = "/bin/sh", path = script;
  char* words[] = {shell.data(), path.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawn(&child, "/bin/sh", nullptr, nullptr, words, environ);
  if (error != 0) throw IoError(script + ": cannot be run: " + std::strerror(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw IoError(script +
                  ": Slurm did not take the jobs (its words stand above); the scripts are written, "
                  "hand them in where sbatch works: sh " +
                  script);
}

// Each has to read, stand and have samples for all tasks, before anything is written.
std::vector<ClusterStudy> checked_studies(const CampaignArguments& a, int shards) {
  const std::string out = absolute(a.out);
  std::vector<ClusterStudy> studies;
  std::set<std::string> folders;
  for (const std::string& file : a.studies) {
    CampaignArguments one = a;
    one.study = file;
    const StudySpec study = asked_study(one);
    if (!study.until.empty())
      refuse("--slurm", std::to_string(shards),
             "does not go with a rule that says when it is precise enough: a shard sees only its "
             "own samples",
             "leave out `until`, and add samples later with a larger --samples");
    static_cast<void>(compile_option(study, model_builder(study)));
    for (const VariantSpec& option : study.option)
      static_cast<void>(compile_option(option.study, model_builder(option.study)));
    ClusterStudy of{
        .file = absolute(file), .folder = out, .samples = draw_samples(study).n_sample()};
    if (a.studies.size() > 1) of.folder += "/" + fs::path(file).stem().string();
    for (const std::string& shard : shard_folders(of.folder))
      if (const int was = shards_in(shard); was != shards)
        refuse("--slurm", std::to_string(shards),
               fmt::format("does not fit {}, which is one of {} shards", shard, was),
               fmt::format("write --slurm {}, or name another folder", was));
    if (!folders.insert(of.folder).second)
      refuse("study", file, "has the name of another study, and so its folder", "rename one");
    if (of.samples < shards)
      refuse("--slurm", std::to_string(shards),
             fmt::format("is more than the {} samples of {}", of.samples, file),
             "ask for fewer tasks");
    studies.push_back(std::move(of));
  }
  return studies;
}

}  // namespace

int cluster_campaign(const CampaignArguments& a) {
  const SlurmArguments& s = a.slurm;
  const int shards =
      whole_number("--slurm", s.tasks, 1, kMostTasks, "write the number of tasks, e.g. --slurm 40");
  if (!a.shard.empty()) refuse("--shard", a.shard, "is given by --slurm itself", "leave it out");
  if (!a.jobs.empty())
    refuse("--jobs", a.jobs, "is given by --cores here", "write --cores " + a.jobs);
  if (static_cast<int>(a.studies.size()) * shards > kMostTasks)
    refuse("--slurm", s.tasks,
           fmt::format("asks for {} tasks in all", static_cast<int>(a.studies.size()) * shards),
           fmt::format("{} at most: fewer tasks a study", kMostTasks));
  check_word("--partition", s.partition);
  check_word("--time", s.time);
  if (!s.cores.empty())
    static_cast<void>(whole_number("--cores", s.cores, 1, 4096, "cores of a node"));
  const ClusterJob job(a, s, checked_studies(a, shards), shards);
  job.write();
  const std::string script = job.folder() + "/submit.sh";
  if (job.missing().empty())
    fmt::print("all samples have run; what is left is to join them\n");
  else
    fmt::print("{} of {} tasks have samples left: {}\n", job.missing().size(),
               static_cast<std::size_t>(shards) * a.studies.size(), ranges(job.missing()));
  if (!s.submit) {
    fmt::print("to hand it in: sh {}\nhow far it is: wythe status {}\n", shell_quoted(script),
               shell_quoted(a.out));
    return 0;
  }
  std::fflush(stdout);
  hand_in(script);
  fmt::print("how far it is: wythe status {}\n", shell_quoted(a.out));
  return 0;
}

std::vector<std::string> shard_folders(const std::string& folder) {
  std::vector<std::pair<int, std::string>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(shards_of(folder), error)) {
    const std::string name = entry.path().filename().string(),
                      path = shards_of(folder) + "/" + name;
    if (!holds_campaign(path) && !holds_options(path)) continue;
    found.emplace_back(std::atoi(name.c_str()), path);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> folders;
  for (auto& [number, path] : found) folders.push_back(std::move(path));
  return folders;
}

namespace {

struct Line {
  std::string name, folder;  // "": a shard that has not begun
  StoreProgress of;
};

// Campaigns below a folder: itself, its options, its shards, and those of the studies in it.
class Overview {
 public:
  // Without counting, stores that do not read have their line too.
  explicit Overview(const std::string& folder, bool counts = true) : counts_(counts) {
    collect(folder, "", 0);
  }
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

 private:
  void collect(const std::string& folder, const std::string& name, int depth) {
    const std::vector<std::string> shards = shard_folders(folder);
    if (!shards.empty()) {  // what is joined already is in them
      add_shards(shards, name.empty() ? "" : name + ", ", depth);
    } else if (holds_campaign(folder)) {
      lines_.push_back({name, folder, progress_of(folder)});
    } else if (depth <= kDeepest) {
      std::error_code error;
      std::vector<std::string> inner;
      for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_directory(error)) inner.push_back(entry.path().filename().string());
      std::sort(inner.begin(), inner.end());
      for (const std::string& one : inner)
        collect(folder + "/" + one, name.empty() ? one : name + ", " + one, depth + 1);
    }
  }
  // Those that no task has begun too: each store knows how many there are.
  void add_shards(const std::vector<std::string>& shards, const std::string& name, int depth) {
    const auto called = [&](int shard) { return fmt::format("{}shard {}", name, shard); };
    const std::size_t before = lines_.size();
    std::set<int> begun;
    for (const std::string& shard : shards) {
      const int number = std::atoi(fs::path(shard).filename().c_str());
      collect(shard, called(number), depth + 1);
      begun.insert(number);
    }
    if (lines_.size() == before) return;
    const StoreProgress like = lines_[before].of;
    for (std::size_t k = before; k < lines_.size(); ++k)
      if (counts_ && lines_[k].of.shards != like.shards)
        refuse("folder", lines_[k].folder,
               fmt::format("is one of {} shards, {} of {}: together they are no campaign",
                           lines_[k].of.shards, lines_[before].folder, like.shards),
               "keep the shards of one array in a folder");
    for (int shard = 1; shard <= like.shards; ++shard) {
      if (begun.contains(shard)) continue;
      StoreProgress none;
      none.samples = like.samples, none.shards = like.shards;
      none.total = samples_of_shard(like.samples, shard, like.shards);
      lines_.push_back({called(shard) + ", not begun", "", none});
    }
  }

  StoreProgress progress_of(const std::string& folder) const {
    return counts_ ? campaign_progress(folder) : StoreProgress{};
  }

  static constexpr int kDeepest = 2;
  bool counts_;
  std::vector<Line> lines_;
};

std::string left_text(const StoreProgress& p) {
  if (p.done >= p.total) return "";
  if (p.done == 0) return "time left not known yet";
  return "about " + duration_text(p.seconds / p.done * (p.total - p.done)) + " of one core left";
}

}  // namespace

int status(const StatusArguments& a) {
  const std::vector<Line> lines = Overview(a.folder).lines();
  if (lines.empty() && fs::exists(a.folder + "/slurm/array.sh")) {
    fmt::print("no task of the array has begun\n");
    return kUnfinished;
  }
  if (lines.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  StoreProgress all;
  for (const Line& line : lines) {
    const StoreProgress& p = line.of;
    fmt::print("{}{}{} of {} samples{}{}{}\n", readable(line.name), line.name.empty() ? "" : ": ",
               p.done, p.total, p.failed > 0 ? fmt::format(", {} without an answer", p.failed) : "",
               p.writer.empty() ? "" : ", " + readable(p.writer) + " writes",
               p.done < p.total ? "; " + left_text(p) : "");
    all.done += p.done, all.total += p.total, all.failed += p.failed, all.seconds += p.seconds;
  }
  if (lines.size() > 1)
    fmt::print("all: {} of {} samples{}{}\n", all.done, all.total,
               all.failed > 0 ? fmt::format(", {} without an answer", all.failed) : "",
               all.done < all.total ? "; " + left_text(all) : "");
  return all.done == all.total ? 0 : kUnfinished;
}

int check_store(const StoreArguments& a) {
  const std::vector<Line> lines = Overview(a.folder, false).lines();
  std::vector<std::string> folders;
  for (const Line& line : lines)
    if (!line.folder.empty()) folders.push_back(line.folder);
  if (folders.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  int damaged = 0;
  for (const std::string& folder : folders) {
    try {
      check_campaign(folder);
      fmt::print("{}: whole\n", readable(folder));
    } catch (const IoError& error) {
      ++damaged;
      fmt::print(stderr, "{}\n", readable(error.what()));
    }
  }
  if (damaged > 0)
    throw IoError(fmt::format(
        "{} of {} stores damaged; wythe store rescue DIR --out NEW saves what still reads", damaged,
        folders.size()));
  return 0;
}

int rescue_store(const StoreArguments& a) {
  check_language(a.language);
  check_folder(a.out, FolderFor::kCampaign);
  const Rescue rescue = a.by.study.empty() ? rescue_campaign(a.folder, a.out) : rescue_by_study(a);
  for (const Rescue::Lost& lost : rescue.lost)
    fmt::print("sample {} is lost: {}\n", lost.sample, readable(lost.why));
  fmt::print("{} samples kept, {} lost; go on with wythe campaign STUDY.toml --out {} --resume\n",
             rescue.kept, rescue.lost.size(), shell_quoted(a.out));
  if (rescue.kept > 0)
    static_cast<void>(write_campaign_files(a.out, read_answers(a.out), a.language));
  return 0;
}

}  // namespace wythe::app
