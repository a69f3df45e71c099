// Names and times are checked and paths quoted, because Slurm and the shell read them again. A task of the array
// runs one shard.
#include "slurm_scripts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "wythe/io.h"

namespace wythe::app {
namespace {

constexpr int kNotice = 120;      // from the signal to stop to the end of a task's time [s]
constexpr long kLeastTime = 300;  // of a task [s]
constexpr int kMostTurns = 20;    // of a merge that waits for its array
constexpr const char* kTimeExample =
    "write e.g. --time 12:00:00 (hours:minutes:seconds), --time 90 "
    "(minutes) or --time 2-12 (days-hours)";

// "1:30:00" -> {1, 30, 0}; none where a part is not a number.
std::optional<std::vector<long>> parts_of(const std::string& text) {
  std::vector<long> parts;
  std::string digits;
  for (const char c : text + ":") {
    if (c >= '0' && c <= '9') {
      digits += c;
    } else if (c == ':' && !digits.empty() && digits.size() <= 6) {
      std::from_chars(digits.data(), digits.data() + digits.size(), parts.emplace_back());
      digits.clear();
    } else {
      return std::nullopt;
    }
  }
  return parts;
}

// minutes, minutes:seconds, hours:minutes:seconds, days-hours, days-hours:minutes, days-hours:minutes:seconds
std::optional<long> slurm_seconds(const std::string& text) {
  const std::size_t dash = text.find('-');
  const bool has_days = dash != std::string::npos;
  const auto days = parts_of(has_days ? text.substr(0, dash) : "0");
  const auto rest = parts_of(has_days ? text.substr(dash + 1) : text);
  if (!days || days->size() != 1 || !rest || rest->size() > 3) return std::nullopt;
  std::vector<long> clock = *rest;  // converted to hours, minutes, seconds
  if (!has_days && clock.size() < 3) clock.insert(clock.begin(), 0);
  clock.resize(3, 0);
  return ((days->front() * 24 + clock[0]) * 60 + clock[1]) * 60 + clock[2];
}

std::string head(const SlurmArguments& s, const char* what, bool is_task) {
  std::string text = "#!/bin/sh\n";
  const auto say = [&](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  say(fmt::format("--job-name=wythe_{}", what));
  say("--nodes=1");
  say("--ntasks=1");
  if (!s.partition.empty()) say("--partition=" + s.partition);
  if (!s.time.empty()) say("--time=" + s.time);
  if (is_task)
    say(s.cores.empty() ? "--exclusive" : "--cpus-per-task=" + s.cores);
  else
    say("--cpus-per-task=1");
  return text;
}

// Slurm puts the folder before a relative name, and expands % in both; a backslash prevents this.
bool slurm_misreads(const std::string& folder) {
  return folder.find_first_of("%\\") != std::string::npos;
}

std::string log_option(const SlurmJob& job, const char* name) {
  return fmt::format("#SBATCH --output={}\n#SBATCH --open-mode=append\n",
                     slurm_misreads(job.folder) ? "/dev/null" : name);
}

// In a folder with a name that Slurm misreads, the script opens its log itself.
std::string own_log(const SlurmJob& job, const char* name) {
  if (!slurm_misreads(job.folder)) return "";
  return fmt::format("if [ -n \"$SLURM_JOB_ID\" ]; then exec >> {}/{} 2>&1; fi\n",
                     shell_quoted(job.folder), name);
}

std::string program_line(const SlurmJob& job) {
  return fmt::format("WYTHE=${{WYTHE:-{}}}\n", shell_quoted(job.program));
}

// Options of a task: all that must agree with its store, and settings of its run.
std::string task_options(const CampaignArguments& a) {
  std::string text;
  const auto option = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format(" {}={}", name, shell_quoted(value));
  };
  option("--seed", a.seed);
  for (const std::string& word : a.overrides) option("--set", word);
  option("--jobs", a.slurm.cores);
  if (a.language != "en") option("--lang", a.language);
  return text;
}

}  // namespace

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

void check_slurm_name(const std::string& option, const std::string& word) {
  const bool plain = word.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.,") ==
                     std::string::npos;
  if (!plain || word.starts_with("-"))
    refuse(option, word, "is no name that Slurm gives",
           "letters, digits and _ - . , alone, e.g. --partition compute; sinfo lists the names");
}

void check_slurm_time(const std::string& option, const std::string& text) {
  if (text.empty()) return;
  const std::string lower = small_letters(text);
  if (lower == "unlimited" || lower == "infinite") return;
  const std::optional<long> seconds = slurm_seconds(text);
  if (!seconds) refuse(option, text, "is no time that Slurm reads", kTimeExample);
  if (*seconds < kLeastTime)
    refuse(
        option, text,
        fmt::format("is {} s, and a task is told to stop {} s before its end", *seconds, kNotice),
        std::string("give it 5 minutes at least: ") + kTimeExample);
}

std::string array_script(const CampaignArguments& a, const SlurmJob& job) {
  std::string text = head(a.slurm, "array", true);
  if (!job.tasks.empty()) text += "#SBATCH --array=" + ranges(job.tasks) + "\n";
  text += log_option(job, "%a.log");
  text += fmt::format(
      "#SBATCH --requeue\n"
      "#SBATCH --signal=B:TERM@{}\n"
      "# Two minutes before its time is over, or when it has to give way, a task is told to stop: "
      "it\n"
      "# stores what it has and ends. Slurm or you hand it in again, and it goes on from there.\n"
      "# The store of each shard is there already; --stored runs what it holds, and no other "
      "study.\n",
      kNotice);
  text += own_log(job, "\"$SLURM_ARRAY_TASK_ID\".log") + program_line(job);
  text += fmt::format(
      "task=${{SLURM_ARRAY_TASK_ID:?is set by Slurm: sbatch runs this script, or: "
      "SLURM_ARRAY_TASK_ID=1 sh array.sh}}\n"
      "case $task in\n"
      "''|*[!0-9]*|0*|?????*) echo \"no task $task: they are 1 to {1}\" >&2; exit 2 ;;\n"
      "esac\n"
      "study=$(( (task - 1) / {0} ))\n"
      "shard=$(( (task - 1) % {0} + 1 ))\n"
      "case $study in\n",
      job.shards, job.studies.size() * static_cast<std::size_t>(job.shards));
  for (std::size_t k = 0; k < job.studies.size(); ++k)
    text += fmt::format(
        "{}) exec \"$WYTHE\" campaign {} --out={}/\"$shard\" --shard=\"$shard\"/{}{} --resume "
        "--stored --quiet ;;\n",
        k, shell_quoted(job.studies[k].file), shell_quoted(shards_of(job.studies[k].folder)),
        job.shards, task_options(a));
  return text + "esac\necho \"no task $task: they are 1 to " +
         std::to_string(job.studies.size() * static_cast<std::size_t>(job.shards)) +
         "\" >&2\nexit 2\n";
}

// Arguments: the array's number, and how often the script has begun before the array ended. A requeued task
// counts as ended for a moment, before it is in the queue again. Then the merge waits again, each time longer.
std::string merge_script(const CampaignArguments& a, const SlurmJob& job) {
  std::string text = head(a.slurm, "merge", false) + log_option(job, "merge.log") +
                     own_log(job, "merge.log") + program_line(job);
  text += fmt::format(
      "array=$1\n"
      "turn=${{2:-1}}\n"
      "if [ -n \"$array\" ] && [ \"$turn\" -lt {} ] &&\n"
      "   [ -n \"$(squeue -h -j \"$array\" 2>/dev/null)\" ] &&\n"
      "   sbatch --dependency=afterany:\"$array\" --begin=now+$(( (turn - 1) * 30 )) merge.sh "
      "\"$array\" $((turn + 1)); then\n"
      "  echo \"tasks of the array stand in the queue again: they are joined when they have "
      "ended\"\n"
      "  exit 0\n"
      "fi\n"
      "code=0\n",
      kMostTurns);
  for (const SlurmJob::Study& study : job.studies)
    text +=
        fmt::format("\"$WYTHE\" merge {0} --out={0}{1} || code=$?\n", shell_quoted(study.folder),
                    a.language != "en" ? " --lang=" + shell_quoted(a.language) : "");
  return text + "exit $code\n";
}

std::string submit_script(const SlurmJob& job) {
  std::string text =
      "#!/bin/sh\n"
      "set -e\n"
      "CDPATH= cd -- \"$(dirname -- \"$0\")\"\n";
  if (!job.tasks.empty())
    return text +
           "array=$(sbatch --parsable array.sh)\n"
           "array=${array%%;*}\n"
           "echo \"array job $array\"\n"
           "if ! sbatch --dependency=afterany:\"$array\" merge.sh \"$array\"; then\n"
           "  echo \"array job $array is in the queue, the join of its shards is not: hand that in "
           "by\" >&2\n"
           "  echo \"  cd '$PWD' && sbatch --dependency=afterany:$array merge.sh $array\" >&2\n"
           "  exit 3\n"
           "fi\n";
  if (!job.running.empty())
    return text + "echo \"nothing to hand in: what is left runs already\"\n";
  return text + "sbatch merge.sh\n";
}

}  // namespace wythe::app
