#include "report_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "campaign_commands.h"
#include "interrupt.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/report.h"

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kData = "/report.data";
constexpr const char* kPage = "/report.html";

}  // namespace

void check_language(const std::string& language) {
  const std::vector<std::string> known = report_languages();
  if (std::find(known.begin(), known.end(), language) != known.end()) return;
  throw InputError({{.file = "--lang",
                     .path = "",
                     .value = language,
                     .problem = "is no language of the report",
                     .cure = fmt::format("write one of: {}", fmt::join(known, ", "))}});
}

void write_page(const std::string& folder, const std::string& name, const std::string& data,
                const std::string& language) {
  write_text(folder + "/" + name + ".data", data);
  write_text(folder + "/" + name + ".html", report_page(data, language));
}

void write_run_report(const std::string& folder, const ModelSpec& spec, const Model& model,
                      const Result& result, const std::string& language) {
  write_page(folder, "report", run_data(spec, model, result), language);
}

void write_campaign_report(const std::string& folder, const std::string& out,
                           const Campaign& campaign, const Statistics& statistics,
                           const std::string& language) {
  const SampleWalls walls = {
      .build = model_builder(campaign.study),
      .states = [&](int sample, const Model& model) { return read_states(folder, sample, model); }};
  write_text(out + kPage, report_page(campaign_data(campaign, statistics, walls), language));
}

int report(const ReportArguments& a) {
  check_language(a.language);
  if (holds_campaign(a.folder)) return write_results(a.folder, a.language);
  finish_replacement(a.folder);
  if (!fs::exists(a.folder + kData))
    throw InputError({{.file = a.folder,
                       .path = "",
                       .value = "",
                       .problem = "holds neither a campaign (campaign.db) nor the data of a report "
                                  "(report.data)",
                       .cure = "name a folder that run, campaign, replay or limit wrote"}});
  std::string page;
  try {
    page = report_page(read_data(a.folder + kData), a.language);
  } catch (const IoError& error) {
    throw IoError(a.folder + kData + ": " + error.what());
  }
  write_text(a.folder + kPage, page);
  fmt::print("report {}{}\n", a.folder, kPage);
  return 0;
}

int export_tables(const ExportArguments& a) {
  finish_replacement(a.folder);
  const std::unique_ptr<Replacement> tables = replace_export(a.out);
  const Exported made = write_export(a.folder, tables->path());
  tables->commit(hold_for_test);
  if (made.missing > 0)
    fmt::print(stderr, "note: {} samples of the study have not run and are in no table\n",
               made.missing);
  if (made.states == 0)
    fmt::print(stderr,
               "note: no states are stored, so there are no tables of blocks and joints; a study "
               "stores them at its `states`, a run at `output.states`\n");
  fmt::print("{} samples, {} rows of curves, {} states -> {}\n", made.samples, made.rows,
             made.states, a.out);
  return 0;
}

}  // namespace wythe::app
