// wythe assess: the verdict on a wall from many walls of its model, pushed both ways.
#pragma once

#include <string>
#include <vector>

namespace wythe::app {

struct AssessArguments {
  std::string model, out, language = "en";
  std::string walls, until, seed, between, jobs;  // as typed, "": not given
  std::vector<std::string> overrides;
  bool resume = false, quiet = false;
  std::vector<std::string> command;  // as typed, for the command that continues
};
int assess(const AssessArguments& arguments);
// Writes the pages of one model that was pushed in several ways (holds_ways), and of their verdict where there is one.
int report_ways(const std::string& folder, const std::string& language);

}  // namespace wythe::app
