// report.html in a folder of results, and the command that writes it again.
#pragma once

#include <string>

#include "wythe/campaign.h"
#include "wythe/model.h"
#include "wythe/result.h"
#include "wythe/statistics.h"
#include "wythe/wall_spec.h"

namespace wythe::app {

// States of a push that its page can play.
inline constexpr int kFrames = 60;

// Throws InputError before a long run rather than after it.
void check_language(const std::string& language);
// NAME.html, and NAME.data from which it can be made again.
void write_page(const std::string& folder, const std::string& name, const std::string& data,
                const std::string& language);
// report.html, and report.data from which `wythe report` makes it again.
void write_run_report(const std::string& folder, const ModelSpec& spec, const Model& model,
                      const Result& result, const std::string& language);
// report.html alone, into `out`: the store in `folder` has all of it.
void write_campaign_report(const std::string& folder, const std::string& out,
                           const Campaign& campaign, const Statistics& statistics,
                           const std::string& language);

struct ReportArguments {
  std::string folder, language = "en";
};
int report(const ReportArguments& arguments);

struct ExportArguments {
  std::string folder, out;
};
int export_tables(const ExportArguments& arguments);

}  // namespace wythe::app
