// The verdict from the campaigns of `wythe assess`, which lie in stores or in memory, and its files.
#include <algorithm>
#include <cmath>

#include "campaign/draws/scatter.h"
#include "model/coarse_units.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/local_check.h"
#include "wythe/parts/model.h"
#include "wythe/parts/report.h"

namespace wythe {

namespace {

// Scatter of the mean strength between walls; NaN: none.
double scatter_between(const StudySpec& study) {
  for (const VariableSpec& variable : study.variable)
    if (variable.name == kBetweenWalls) return variable.cov;
  return kUnset;
}

// The source of the differences between walls.
Message note_of_scatter(const ModelSpec& base, double between) {
  if (std::isnan(between)) return {"verdict.note.within_only"};
  const bool within = base.draws_fields();
  return {within ? "verdict.note.between" : "verdict.note.between_only",
          {{"percent", 100 * between}}};
}

// Checks of parts out of plane, for the base model. They need no runs, so they take seconds at most.
PartsOutOfPlane parts_of(const ModelSpec& base, const Model& model) {
  PartsOutOfPlane out;
  if (has_parts(base, model)) {
    SecondOpinion opinion;
    add_local_checks(base, model, true, opinion);
    out.checked = std::move(opinion.local);
    out.refused = std::move(opinion.refused);
  } else if (!base.assessment.part.empty()) {
    for (const PartSpec& part : base.assessment.part)
      out.refused.push_back({{"local.part", {{"name", part.name.empty() ? "part" : part.name}}},
                             text_of(Message{"local.parts_in_space"})});
  } else {
    out.not_looked_at = {"verdict.note.no_parts"};
  }
  return out;
}

}  // namespace

WallsVerdict verdict_of_campaigns(const std::vector<std::string>& folders,
                                  const CampaignOfWay& campaign_of) {
  std::vector<WayOfPushing> ways;
  PushWays asked;
  AssessmentSpec spec;
  PartsOutOfPlane parts;
  std::string program;
  int walls = 0;
  for (const std::string& folder : folders) {
    const Campaign campaign = campaign_of(ways.size());
    const ModelSpec base = model_builder(campaign.study)({});
    const Model model = compile(base);
    if (ways.empty()) {
      spec = base.assessment;
      program = campaign.provenance;
      asked = ways_of(base, model);
      parts = parts_of(base, model);
      const double between = scatter_between(campaign.study);
      asked.notes.push_back(note_of_scatter(base, between));
      if (std::isnan(spec.confidence_factor) && std::isnan(between))
        asked.cautions.push_back({"verdict.caution.means"});
      if (Message units = caution_of_units(base); !units.empty())
        asked.cautions.push_back(std::move(units));
      for (const study::OddScatter& odd : study::odd_scatter(base, model, between))
        asked.cautions.push_back({"verdict.caution.scatter",
                                  {{"strength", Message{odd.words}},
                                   {"percent", 100 * odd.cov},
                                   {"tested_percent", 100 * odd.tested}}});
    }
    const PushWay way = way_of(base);
    ways.push_back({.direction = way.direction,
                    .pattern = way.pattern,
                    .folder = folder,
                    .walls = judge_walls(campaign, base, model)});
    walls = std::max(walls, campaign.samples.n_sample());
  }
  WallsVerdict verdict = verdict_of(spec, std::move(ways), walls, std::move(asked.cautions),
                                    std::move(asked.notes), std::move(parts));
  verdict.program = std::move(program);
  return verdict;
}

void write_verdict_files(const std::string& path, const WallsVerdict& verdict, const StudySpec& own,
                         const std::string& language) {
  write_text(path + "/assessment.json", verdict_json(verdict));
  write_text(path + "/walls.csv", walls_csv(verdict));
  const ModelSpec base = model_builder(own)({});
  write_text(path + "/report.html", verdict_page(verdict, base, compile(base), language));
}

}  // namespace wythe
