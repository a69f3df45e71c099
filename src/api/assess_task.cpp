// The task assess: the verdict of `wythe assess` without stores, for engines that have none. Its records stay in memory.
//
//   assess_study ──► a wall in a way ──► record, as a text ──┐ from this process or from others
//                                                            └──► verdict_of_campaigns ──► texts, files
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "api/job.h"
#include "campaign/runner/handed_sample.h"
#include "campaign/runner/sample_run.h"
#include "dynamics/stages/wall_run.h"
#include "io/results/verdict_folder.h"
#include "wythe/parts/error.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/model.h"
#include "wythe/parts/report.h"
#include "wythe/parts/study_notes.h"

namespace wythe::api {
namespace {

using Json = nlohmann::ordered_json;

// As of the command.
constexpr double kNarrowest = 0.05;  // interval of a share
constexpr int kMostWalls = 100'000;

[[noreturn]] void refuse(const std::string& path, double value, const std::string& problem,
                         const std::string& cure) {
  throw InputError(
      {{.path = path, .value = fmt::format("{}", value), .problem = problem, .cure = cure}});
}

double share_between(const Inputs& in, const char* name, double above, const char* range) {
  const double share = in.real(name, kUnset);
  if (in.number.contains(name) && (!(share > above) || !(share <= 1)))
    refuse(name, share, fmt::format("must be a number {}", range), "write e.g. 0.3");
  return share;
}

// Sizes of the designs, one after another, as `wythe assess --resume` adds them.
std::vector<int> batches_of(const Inputs& in) {
  const auto given = in.column.find("walls");
  if (given == in.column.end()) return {AskedWalls{}.walls};
  std::vector<int> out;
  double all = 0;
  for (const double walls : given->second) {
    all += walls;
    if (!(walls >= 2) || !(all <= kMostWalls) || walls != static_cast<int>(walls))
      refuse("walls", walls, fmt::format("must be a whole number from 2 to {}", kMostWalls),
             "write e.g. 8");
    out.push_back(static_cast<int>(walls));
  }
  if (out.empty()) refuse("walls", 0, "has no row", "give one number, or leave the column out");
  return out;
}

// One way of pushing all walls.
struct Way {
  StudySpec study;
  SampleTable samples;
  ModelBuilder build;
};

Way way_of(const StudySpec& study, const std::vector<int>& batches) {
  Way way{study, {}, model_builder(study)};
  way.study.batch = batches;
  way.samples = draw_samples(way.study);
  return way;
}

// The model's own way comes first. Refuses all that can be refused before the first wall is pushed.
std::vector<StudySpec> studies_of(const Inputs& in) {
  if (!in.has("file"))
    throw InputError(
        {{.path = "file", .problem = "is missing", .cure = "give the path of the model's file"}});
  AskedWalls asked{.model_file = in.one("file"), .overrides = in.all("set")};
  asked.walls = batches_of(in).front();
  asked.seed = in.integer("seed", 0, 0, 2'147'483'647);
  asked.between = share_between(in, "between", 0, "more than 0 and up to 1");
  const StudySpec own = assess_study(asked);
  std::vector<StudySpec> studies = {own};
  for (const VariantSpec& option : own.option) studies.push_back(option.study);
  return studies;
}

// Pushes one wall (from 1), as a campaign does. "": it was stopped.
std::string pushed(Job& job, const Way& way, int wall, const std::string& name) {
  SolveOptions options;
  options.threads = 1;
  options.stop = &job.stop;
  options.progress = [&](const Progress& p) {
    job.progress(name, p.share, 1e3 * p.displacement, 1e-3 * p.reaction);
  };
  const auto solver = [](const Model& model, State& state, const SolveOptions& how) {
    return dynamics::run_stages(model, state, how);
  };
  const SampleRun run = study::run_task({way.study, way.samples, way.build}, wall, solver, options);
  if (run.refused.empty() && run.result.status == SolveStatus::kInterrupted) return "";
  return study::handed_text(way.study, way.samples, study::record_of(run, way.samples, wall));
}

std::string name_of(std::size_t way, int wall) {
  return fmt::format("way {}, wall {}", way + 1, wall);
}

// What the task would push, for a caller who hands the walls out.
Json plan_of(const std::vector<StudySpec>& studies, const std::vector<int>& batches) {
  Json plan = {{"ways", Json::array()},
               {"walls", std::accumulate(batches.begin(), batches.end(), 0)},
               {"notes", Json::array()}};
  std::vector<Message> notes;
  for (const StudySpec& study : studies) {
    const Way way = way_of(study, batches);
    const ModelSpec base = way.build({});
    static_cast<void>(compile(base));
    const PushWay push = wythe::way_of(base);
    plan["ways"].push_back({{"direction", push.direction},
                            {"pattern", push.pattern},
                            {"words", text_of(words_of_pattern(push.pattern))}});
    for (std::vector<Message> of_way :
         {notes_of(way.study, base), notes_of_values(way.study, way.samples, way.build)})
      for (Message& note : of_way)
        if (std::find(notes.begin(), notes.end(), note) == notes.end())
          notes.push_back(std::move(note));
  }
  for (const Message& note : notes) plan["notes"].push_back(text_of(note));
  return plan;
}

// Records of one way, of which those not given are pushed here; fewer than `walls` where it is stopped.
Campaign campaign_of(Job& job, const Way& way, std::size_t place,
                     const std::vector<std::string>& records) {
  Campaign campaign{.study = way.study,
                    .samples = way.samples,
                    .records = {},
                    .load_height = 0,
                    .provenance = provenance_text()};
  const int walls = way.samples.n_sample();
  for (int wall = 1; wall <= walls && !job.stop; ++wall) {
    const std::size_t k = place * walls + wall - 1;
    std::string text = k < records.size() ? records[k] : "";
    if (text.empty()) text = pushed(job, way, wall, name_of(place, wall));
    if (text.empty()) break;
    campaign.records.push_back(study::handed_record(way.study, way.samples, wall, text));
  }
  return campaign;
}

}  // namespace

bool do_assess(Job& job) {
  const Inputs& in = job.in;
  in.check("assess", {"file", "set", "out", "language", "record"},
           {"seed", "between", "until", "replace", "plan", "way", "wall"}, true);
  const std::string language = in.one("language", "en"), out = in.out_folder();
  check_language(language, "language");
  const std::vector<int> batches = batches_of(in);
  const double until = share_between(in, "until", kNarrowest, "more than 0.05 and up to 1");
  const std::vector<StudySpec> studies = studies_of(in);
  const auto ways = static_cast<int>(studies.size());
  const int walls = std::accumulate(batches.begin(), batches.end(), 0);
  if (in.number.contains("wall")) {
    const int place = in.integer("way", 0, 0, ways - 1), wall = in.integer("wall", 1, 1, walls);
    job.out.put("record", pushed(job, way_of(studies[place], batches), wall, name_of(place, wall)));
    return job.stop;
  }
  const ModelSpec base = model_builder(studies.front())({});
  const Origin origin{in.one("file"), spec_hash(base), in.real("replace", 0) != 0};
  if (!out.empty()) check_verdict_folder(out, origin);
  Json plan = plan_of(studies, batches);
  job.out.put("plan", dumped(plan));
  if (in.real("plan", 0) != 0) return false;
  const std::vector<std::string> records = in.all("record");
  if (!records.empty() && records.size() != studies.size() * walls)
    refuse("record", static_cast<double>(records.size()),
           fmt::format("must be {}: one of each way and wall", studies.size() * walls),
           "give an empty text for a wall that is to be pushed here");
  const WallsVerdict verdict =
      verdict_of_campaigns(std::vector<std::string>(studies.size()), [&](std::size_t place) {
        return campaign_of(job, way_of(studies[place], batches), place, records);
      });
  if (job.stop) return true;
  const bool is_known = verdict.verdict != AssessmentVerdict::kNotKnown;
  plan["next"] = is_known && !std::isnan(until) ? next_walls(verdict.worst.counts, until) : 0;
  job.out.put("plan", dumped(plan));
  job.out.put("assessment", verdict_json(verdict));
  job.out.put("walls", walls_csv(verdict));
  if (out.empty()) return false;
  const std::unique_ptr<Replacement> results = replace_verdict(out, origin);
  write_verdict_files(results->path(), verdict, studies.front(), language);
  results->commit();
  return false;
}

}  // namespace wythe::api
