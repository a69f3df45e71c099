// Models before and after, from the campaigns of `wythe compare`, and their files.
#include <algorithm>
#include <filesystem>

#include "wythe/parts/comparison.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/model.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;

// Whether the same place of both walls draws the same number. An opening renumbers the units after it.
bool draw_alike(const ModelSpec& base, const ModelSpec& other) {
  return std::all_of(base.field.begin(), base.field.end(), [&](const auto& named) {
    const FieldSpec& was = named.second;
    const auto found = other.field.find(named.first);
    if (!was.formula.empty()) return true;
    if (found == other.field.end()) return false;
    return was.drawn_for == found->second.drawn_for || (was.in_place && found->second.in_place);
  });
}

ModelCapacity capacity_of(const std::vector<std::string>& folders) {
  const WallCapacity capacity = read_verdict(folders).worst.capacity;
  return {{capacity.median.value, capacity.with_tests}, capacity.at_least};
}

// A folder relative to `out`, if it is inside it.
std::string shown(const std::string& folder, const std::string& out) {
  const fs::path inside = fs::path(folder).lexically_relative(out);
  return inside.empty() || *inside.begin() == ".." ? folder : inside.string();
}

}  // namespace

PairedComparison write_models(const std::string& folder, const std::vector<ModelFolders>& models,
                              const ChangeLimits& limits, const std::string& language,
                              const Points& at) {
  ComparedModels asked;
  asked.limits = limits;
  std::vector<ModelSpec> spec;
  for (const ModelFolders& model : models) {
    asked.name.push_back(model.name);
    spec.push_back(model_builder(read_study_of(model.campaign.front()))({}));
    asked.differences.push_back(model_differences(spec.front(), spec.back()));
    if (!draw_alike(spec.front(), spec.back()))
      asked.other_draws.push_back(static_cast<int>(spec.size()) - 1);
    if (says_pga(spec.back().assessment)) asked.capacity.push_back(capacity_of(model.campaign));
  }
  if (asked.capacity.size() != models.size()) asked.capacity.clear();
  for (std::size_t way = 0; way < models.front().campaign.size(); ++way) {
    ComparedWay& one = asked.way.emplace_back();
    for (const ModelFolders& model : models) {
      ComparedCampaign& store = one.stores.emplace_back();
      store.folder = model.campaign[way];
      store.campaign = read_campaign(store.folder);
      const ModelSpec base = model_builder(store.campaign.study)({});
      store.doubt = doubts_of(store.campaign, compile(base));
      if (one.push.direction.empty()) {
        const PushWay own = way_of(base);
        one.push = {own.direction, own.pattern};
      }
    }
  }
  const bool is_several = std::any_of(asked.way.begin(), asked.way.end(), [&](const auto& one) {
    return one.push.pattern != asked.way.front().push.pattern;
  });
  for (ComparedWay& one : asked.way) {
    one.push.is_several = is_several;
    for (std::size_t k = 0; k < models.size(); ++k)
      one.stores[k].name = models[k].name + ", " + one.push.text();
  }
  PairedComparison comparison = compare_models(asked);
  comparison.base_folder = shown(comparison.base_folder, folder);
  for (OptionComparison& option : comparison.option) {
    option.folder = shown(option.folder, folder);
    option.base_folder = shown(option.base_folder, folder);
  }
  prepare_folder(folder);
  Replacement results(folder, [](const std::string& name) {
    return name == "comparison.json" || name == "comparison.html";
  });
  write_text(results.path() + "/comparison.json", comparison_json(comparison));
  write_text(results.path() + "/comparison.html",
             report_page(comparison_data(comparison), language));
  results.commit(at);
  return comparison;
}

}  // namespace wythe
