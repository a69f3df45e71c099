// Files of a campaign's folder beside its store: samples, statistics and the page. A campaign gets an assessment only if
// its base model asks for one. Also the verdict from the stores of `wythe assess`.
#include <algorithm>
#include <filesystem>
#include <map>

#include "io/results/verdict_folder.h"
#include "model/shaking.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/report.h"
#include "wythe/parts/stored_states.h"

namespace wythe {
namespace {

// The damping of the stage with the records; for damping that samples draw, the name of the input.
std::vector<Message> damping_of_study(const StudySpec& study, const ModelSpec& base) {
  const auto shake = std::find_if(base.stage.begin(), base.stage.end(), [&](const StageSpec& s) {
    return s.kind() == StageKind::kShake && s.name == study.shaking.stage;
  });
  if (shake == base.stage.end()) return {};
  const std::vector<std::string> tables{
      "stage." + shake->name + ".", "stage." + std::to_string(shake - base.stage.begin()) + "."};
  std::map<std::string, std::string> drawn;
  const auto look = [&](const InputSpec& input) {
    for (const std::string& table : tables)
      if (input.path.starts_with(table)) {
        const std::size_t end = input.path.find('.', table.size());
        drawn.emplace(input.path.substr(table.size(), end - table.size()), input.name);
      }
  };
  for (const VariableSpec& input : study.variable) look(input);
  for (const DependentSpec& input : study.dependent) look(input);
  return damping_of(*shake, drawn);
}

}  // namespace

Statistics full_statistics(const Campaign& campaign) {
  Statistics statistics = statistics_of(campaign);
  const ModelSpec base = model_builder(campaign.study)({});
  statistics.project = base.project;
  if (statistics.shaking.is_told())
    statistics.shaking.damping = damping_of_study(campaign.study, base);
  if (is_asked(base.assessment))
    statistics.assessment = assess_campaign(campaign, base, compile(base));
  return statistics;
}

Statistics write_campaign_files(const std::string& folder, const Campaign& campaign,
                                const std::string& language, const Points& at) {
  Replacement results(folder, [](const std::string& name) {
    return name == "samples.csv" || name == "statistics.json" || name == "report.html";
  });
  write_text(results.path() + "/samples.csv", samples_csv(campaign));
  Statistics statistics = full_statistics(campaign);
  write_text(results.path() + "/statistics.json", statistics_json(statistics));
  StoredStates stored(folder);
  const SampleWalls walls = {
      .build = model_builder(campaign.study),
      .states = [&](int sample, const Model& model) { return stored.of(sample, model); }};
  write_text(results.path() + "/report.html",
             report_page(campaign_data(campaign, statistics, walls), language));
  results.commit(at);
  return statistics;
}

WallsVerdict read_verdict(const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  for (const std::string& folder : folders)
    names.push_back(std::filesystem::path(folder).filename().string());
  return verdict_of_campaigns(
      names, [&](std::size_t way) { return read_campaign(folders[way]); });  // with signs of piers
}

WallsVerdict write_verdict(const std::string& folder, const std::vector<std::string>& inner,
                           const std::string& language, const Points& at) {
  std::vector<std::string> folders;
  folders.reserve(inner.size());
  for (const std::string& name : inner) folders.push_back(folder + "/" + name);
  WallsVerdict verdict = read_verdict(folders);
  Replacement results(folder, is_file_of_verdict);
  write_verdict_files(results.path(), verdict, read_study_of(folders.front()), language);
  results.commit(at);
  return verdict;
}

}  // namespace wythe
