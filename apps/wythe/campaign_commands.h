// The commands about campaigns: run, join shards, replay a sample, rewrite results, check a study.
#pragma once

#include <string>
#include <vector>

#include "commands.h"
#include "wythe/campaign.h"
#include "wythe/model.h"

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

// Those files alone; whether any sample answered.
bool write_campaign_files(const std::string& folder, const std::string& language);
// The command that goes on with this campaign.
std::string resume_command(const CampaignArguments& arguments);

// compare_commands.cpp: a study with [[variant]], its folders and how they compare.
struct CompareArguments {
  std::vector<std::string> folders;
  std::string out, language = "en";
};
int compare(const CompareArguments& arguments);
int campaign_of_options(const CampaignArguments& arguments, const StudySpec& study,
                        CampaignOptions options);
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
