// wythe report and wythe export: they find what a folder holds, a run, campaigns or an assessment, and write its page or tables.
#include "report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "assess_command.h"
#include "campaign_commands.h"
#include "interrupt.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe::app {
namespace fs = std::filesystem;

int report(const ReportArguments& a) {
  check_language(a.language);
  if (holds_campaign(a.folder)) return write_results(a.folder, a.language);
  if (holds_ways(a.folder)) return report_ways(a.folder, a.language);
  if (holds_options(a.folder)) {
    for (const std::string& store : option_folders(a.folder))
      static_cast<void>(
          write_campaign_files(store, read_answers(store), a.language, hold_for_test));
    return compare({.folders = {a.folder}, .out = a.folder, .language = a.language});
  }
  rewrite_page(a.folder, a.language);
  fmt::print("report {}/report.html\n", readable(a.folder));
  return 0;
}

namespace {

int export_one(const std::string& folder, const std::string& out, const ExportArguments& a) {
  finish_replacement(folder);
  const NewFolder folder_made(out);  // an input that cannot be read leaves no empty folder
  const Origin origin{folder, 0, a.replaces};
  const std::unique_ptr<Replacement> tables = replace_export(out, origin);
  const Exported made =
      a.hdf5 ? write_export_hdf5(folder, tables->path()) : write_export(folder, tables->path());
  write_origin(tables->path(), origin);
  tables->commit(hold_for_test);
  if (made.missing > 0)
    fmt::print(stderr, "note: {} samples of the study have not run and are in no table\n",
               made.missing);
  if (made.states == 0)
    fmt::print(stderr,
               "note: no states are stored, so there are no tables of blocks and joints; a study "
               "stores them at its `states`, a run at `output.states`\n");
  fmt::print("{} samples, {} rows of curves, {} states -> {}\n", made.samples, made.rows,
             made.states, out);
  return 0;
}

// Campaigns side by side in a folder, as written for a study with variants.
std::vector<std::string> campaigns_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  if (holds_campaign(folder) || fs::exists(fs::path(folder) / "summary.json", error)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error) && holds_campaign(entry.path().string()))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

int export_tables(const ExportArguments& a) {
  const std::vector<std::string> names = campaigns_in(a.folder);
  if (names.empty()) return export_one(a.folder, a.out, a);
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(a.out, error)) {
    const std::string name = entry.path().filename().string();
    if (std::find(names.begin(), names.end(), name) != names.end() || name.starts_with("."))
      continue;
    refuse(a.out, "", "holds " + name + ", which no export of these campaigns wrote",
           "name a new folder, an empty one, or one that holds an earlier export alone");
  }
  for (const std::string& name : names) export_one(a.folder + "/" + name, a.out + "/" + name, a);
  return 0;
}

}  // namespace wythe::app
