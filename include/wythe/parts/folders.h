// Whole folders of results, as the commands write them and other programs find them: the files of a run, a
// campaign or a second opinion together, all of them or none.
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

// States of a push that its page can play.
inline constexpr int kFrames = 60;
// Called at each point on the way, for tests.
using Points = std::function<void(const char* point)>;

// "wythe 0.1.0 (commit, compiler, build type, flags)": what a store keeps of the program.
[[nodiscard]] std::string provenance_text();
// Throws InputError, naming `option`, where the page has no words in this language.
void check_language(const std::string& language, const std::string& option = "--lang");

// NAME.html, and NAME.data from which it can be made again.
void write_page(const std::string& folder, const std::string& name, const std::string& data,
                const std::string& language);
// report.html and report.data of a run, beside the files of write_run (io.h).
void write_run_report(const std::string& folder, const ModelSpec& spec, const Model& model,
                      const Result& result, const std::string& language);
// Features and, where one is asked for, what an assessment needs: all that a result holds
// beside what solve() gives.
void read_result(const ModelSpec& spec, const Model& model, Result& result);

// samples.csv, statistics.json and report.html from the store in `folder`: never one newer than another.
Statistics write_campaign_files(const std::string& folder, const Campaign& campaign,
                                const std::string& language, const Points& at = {});
[[nodiscard]] Statistics full_statistics(const Campaign& campaign);  // with its assessment

// The verdict from campaigns in these folders, one way of pushing each, the model's own first.
[[nodiscard]] WallsVerdict read_verdict(const std::vector<std::string>& folders);
// assessment.json, walls.csv and report.html in `folder`, from the campaigns in its folders `inner`.
WallsVerdict write_verdict(const std::string& folder, const std::vector<std::string>& inner,
                           const std::string& language, const Points& at = {});

// comparison.json and comparison.html in `folder` of models: of each its name and the folders of its campaigns, one a way
// of pushing, its own first; the model before first.
struct ModelFolders {
  std::string name;
  std::vector<std::string> campaign;
};
PairedComparison write_models(const std::string& folder, const std::vector<ModelFolders>& models,
                              const ChangeLimits& limits, const std::string& language,
                              const Points& at = {});

// mechanisms.json, a CSV and an SVG of each mechanism, and a page, whose path it gives. A folder that holds a
// run keeps that run's page; one that holds a campaign is refused (InputError).
std::string write_second_opinion(const std::string& folder, const ModelSpec& spec,
                                 const Model& model, const SecondOpinion& opinion,
                                 const std::string& language, const Points& at = {});

}  // namespace wythe
