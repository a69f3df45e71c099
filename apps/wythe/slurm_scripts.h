// The three scripts of an array of Slurm: its tasks, the join of what they leave, and the one that hands both in.
#pragma once

#include <string>
#include <vector>

#include "campaign_commands.h"

namespace wythe::app {

struct SlurmJob {
  struct Study {
    std::string file, folder;  // absolute
  };
  std::vector<Study> studies;
  int shards = 1;            // of each
  std::vector<int> tasks;    // those that have samples left: task t runs shard (t - 1) % shards + 1
  std::vector<int> running;  // those that a process runs now
  std::string program, folder;  // folder of the scripts and logs
};

[[nodiscard]] std::string array_script(const CampaignArguments& arguments, const SlurmJob& job);
[[nodiscard]] std::string merge_script(const CampaignArguments& arguments, const SlurmJob& job);
[[nodiscard]] std::string submit_script(const SlurmJob& job);

// "1-3,7": the tasks of an array.
[[nodiscard]] std::string ranges(const std::vector<int>& tasks);

// Throw InputError where Slurm would read the words otherwise.
void check_slurm_name(const std::string& option, const std::string& word);
// A limit of time as sbatch takes it, of five minutes at least.
void check_slurm_time(const std::string& option, const std::string& text);

}  // namespace wythe::app
