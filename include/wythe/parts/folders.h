// Writes and reads whole folders of results: all files of a run, campaign or limit analysis together. Either all
// files of a result are there or none.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/io.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/verdict.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

// Most states of a push that its page can animate.
inline constexpr int kFrames = 60;
// Called at each stage of writing, for tests.
using Points = std::function<void(const char* point)>;

// "wythe 0.1.0 (commit, compiler, build type, flags)", as a store keeps it.
[[nodiscard]] std::string provenance_text();
// Throws InputError that names `option` where the page does not exist in this language.
void check_language(const std::string& language, const std::string& option = "--lang");

// Writes NAME.html and NAME.data, from which the page can be made again.
void write_page(const std::string& folder, const std::string& name, const std::string& data,
                const std::string& language);
// Writes report.html of a folder again from its report.data. InputError: there is none.
void rewrite_page(const std::string& folder, const std::string& language);
// Writes report.html and report.data of a run, beside the files of write_run (io.h).
void write_run_report(const std::string& folder, const ModelSpec& spec, const Model& model,
                      const Result& result, const std::string& language);
// Adds to a result what solve() does not give: features and, where the model asks for one, the data
// of an assessment.
void read_result(const ModelSpec& spec, const Model& model, Result& result);

// Writes samples.csv, statistics.json and report.html from the store in `folder`; they are always of one state of it.
Statistics write_campaign_files(const std::string& folder, const Campaign& campaign,
                                const std::string& language, const Points& at = {});
[[nodiscard]] Statistics full_statistics(const Campaign& campaign);  // with its assessment

// The verdict from a campaign for each way of pushing, in a store or in memory; the model's own way comes first. `folders`
// names the folder of each for the page and assessment.json; "": there is none.
using CampaignOfWay = std::function<Campaign(std::size_t way)>;
[[nodiscard]] WallsVerdict verdict_of_campaigns(const std::vector<std::string>& folders,
                                                const CampaignOfWay& campaign_of);
// Writes assessment.json, walls.csv and report.html to `path`; `own` is the study of the model's own way.
void write_verdict_files(const std::string& path, const WallsVerdict& verdict, const StudySpec& own,
                         const std::string& language);
// The verdict from the stores in these folders.
[[nodiscard]] WallsVerdict read_verdict(const std::vector<std::string>& folders);
// Writes the files of the verdict into `folder`, from the stores in its subfolders `inner`.
WallsVerdict write_verdict(const std::string& folder, const std::vector<std::string>& inner,
                           const std::string& language, const Points& at = {});

// Writes comparison.json and comparison.html of models. Each has a name and the folders of its campaigns, one for each
// way of pushing, its own first. The model before comes first.
struct ModelFolders {
  std::string name;
  std::vector<std::string> campaign;
};
PairedComparison write_models(const std::string& folder, const std::vector<ModelFolders>& models,
                              const ChangeLimits& limits, const std::string& language,
                              const Points& at = {});

// Writes mechanisms.json, a CSV and an SVG of each mechanism, and a page, whose path is returned. The page of a run
// in the same folder stays; a folder with a campaign is refused (InputError).
std::string write_second_opinion(const std::string& folder, const ModelSpec& spec,
                                 const Model& model, const SecondOpinion& opinion,
                                 const std::string& language, const Points& at = {});

}  // namespace wythe
