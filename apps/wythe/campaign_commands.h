// The commands about campaigns: run, join shards, replay a sample, rewrite results, check a study.
#pragma once

#include <string>
#include <vector>

#include "commands.h"

namespace wythe::app {

struct CampaignArguments {
  std::string study, out, shard, until;
  std::string samples, seed, jobs;  // as typed, "": not given
  std::vector<std::string> overrides;
  bool resume = false, quiet = false;
  std::string device = "cpu";
  std::string language = "en";       // of the report
  std::vector<std::string> command;  // as typed, to say how to go on
};
int campaign(const CampaignArguments& arguments);

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out, language = "en";
};
int merge(const MergeArguments& arguments);

struct ReplayArguments {
  std::string folder, out, language = "en";
  int sample = 0, threads = 1;
  bool quiet = false;
};
int replay(const ReplayArguments& arguments);

// samples.csv, statistics.json, report.html from the store, and the table on stdout.
int write_results(const std::string& folder, const std::string& language);

struct PictureArguments {
  std::string folder, out;
  int sample = 0;
  double scale = 0;           // of displacements; 0: one that fits
  std::vector<double> at_mm;  // which states; none: all
};
int picture(const PictureArguments& arguments);

int check_study_file(const CheckArguments& arguments);

}  // namespace wythe::app
