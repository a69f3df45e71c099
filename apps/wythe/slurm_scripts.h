// The three scripts of a Slurm array: its tasks, the merge of their stores, and the one that submits both.
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
  std::vector<int> tasks;    // that have samples left: task t runs the shard (t - 1) % shards + 1
  std::vector<int> running;  // being run by a process now
  std::string program, folder;  // folder of the scripts and logs
};

[[nodiscard]] std::string array_script(const CampaignArguments& arguments, const SlurmJob& job);
[[nodiscard]] std::string merge_script(const CampaignArguments& arguments, const SlurmJob& job);
[[nodiscard]] std::string submit_script(const SlurmJob& job);

// "1-3,7": the tasks of an array.
[[nodiscard]] std::string ranges(const std::vector<int>& tasks);

// Throw InputError where Slurm would interpret the words differently.
void check_slurm_name(const std::string& option, const std::string& word);
// A time limit as in sbatch, at least five minutes.
void check_slurm_time(const std::string& option, const std::string& text);

}  // namespace wythe::app
