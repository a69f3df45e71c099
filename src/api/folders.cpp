// New results go into a hidden folder, and commit() moves all of them into place together
// (Replacement, wythe/parts/io.h). A page is made from its .data text, so that it can be made again.
// A second opinion beside a run gives its page another name, so that the page of the run stays.
#include "wythe/parts/folders.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "wythe/parts/assessment.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/provenance.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

// "report", or another name if the folder has a run's page. Replacement refuses the folder of a campaign.
std::string opinion_page(const std::string& folder) {
  return std::filesystem::exists(folder + "/summary.json") ? "limit" : "report";
}

// Why a folder without report.data has no page to write again.
Fault without_data(const std::string& folder, const std::string& language) {
  if (std::filesystem::exists(folder + "/comparison.json"))
    return {
        .file = folder,
        .problem = "holds a comparison, whose page is written by wythe compare alone",
        .cure = fmt::format("give the command of the comparison again with --lang {}; of models "
                            "add --resume, which pushes no wall again",
                            language)};
  if (std::filesystem::exists(folder + "/assessment.json"))
    return {.file = folder,
            .problem = "holds a verdict without the walls that it was made from",
            .cure = fmt::format("assess the model again with --lang {}", language)};
  return {.file = folder,
          .problem = "holds no data of a report (report.data)",
          .cure = "name a folder that run, campaign, assess, replay or limit wrote"};
}

}  // namespace

std::string provenance_text() {
  const Provenance p = provenance();
  return fmt::format("wythe {} ({}, {}, {}, {})", p.version, p.commit, p.compiler, p.build_type,
                     p.flags);
}

void check_language(const std::string& language, const std::string& option) {
  const std::vector<std::string> known = report_languages();
  if (std::find(known.begin(), known.end(), language) != known.end()) return;
  throw InputError({{.file = option,
                     .value = language,
                     .problem = "is no language of the report",
                     .cure = fmt::format("write one of: {}", fmt::join(known, ", "))}});
}

void write_page(const std::string& folder, const std::string& name, const std::string& data,
                const std::string& language) {
  write_text(folder + "/" + name + ".data", data);
  write_text(folder + "/" + name + ".html", report_page(data, language));
}

void rewrite_page(const std::string& folder, const std::string& language) {
  check_language(language);
  finish_replacement(folder);
  const std::string data = folder + "/report.data";
  if (!std::filesystem::exists(data)) throw InputError({without_data(folder, language)});
  std::string page;
  try {
    page = report_page(read_data(data), language);
  } catch (const IoError& error) {
    throw IoError(data + ": " + error.what());
  }
  write_text(folder + "/report.html", page);
}

void write_run_report(const std::string& folder, const ModelSpec& spec, const Model& model,
                      const Result& result, const std::string& language) {
  write_page(folder, "report", run_data(spec, model, result), language);
}

void read_result(const ModelSpec& spec, const Model& model, Result& result) {
  result.features = read_features(model, result);
  if (is_asked(spec.assessment)) result.pushed = read_pushed_wall(spec, model, result);
}

std::string write_second_opinion(const std::string& folder, const ModelSpec& spec,
                                 const Model& model, const SecondOpinion& opinion,
                                 const std::string& language, const Points& at) {
  prepare_folder(folder);
  finish_replacement(folder);
  const std::string page = opinion_page(folder);
  Replacement results(folder, [&](const std::string& name) {
    const bool is_page = name.ends_with(".html") || name.ends_with(".data");
    return is_file_of_limit(name) && (!is_page || name == page + ".html" || name == page + ".data");
  });
  for (const Mechanism& m : opinion.mechanisms) {
    const std::string path = results.path() + "/" + m.file_name();
    write_text(path + ".csv", mechanism_csv(m.curve));
    write_text(path + ".svg", mechanism_svg(model, m));
  }
  const std::string json = mechanisms_json(model, opinion);
  write_text(results.path() + "/mechanisms.json", json);
  write_page(results.path(), page, limit_data(spec, model, json), language);
  results.commit(at);
  return folder + "/" + page + ".html";
}

}  // namespace wythe
