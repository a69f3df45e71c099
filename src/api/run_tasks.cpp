// Tasks about one wall: run, check, limit, contact, keys.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/job.h"
#include "api/run_answers.h"
#include "core/files.h"
#include "core/limits.h"
#include "dynamics/stages/wall_run.h"
#include "limit/limit_loads.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/formats.h"
#include "wythe/parts/io.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"
#include "wythe/parts/second_opinion.h"
#include "wythe/parts/solve.h"

namespace wythe::api {
namespace {

using Json = nlohmann::ordered_json;

// A model given as a text, or only as a file.
struct GivenModel {
  ModelSpec spec;
  Model model;
};

GivenModel read_given(const Inputs& in) {
  GivenModel given;
  const std::string file = in.one("file", "model.toml");
  const std::vector<std::string> settings = in.all("set");
  if (in.has("model")) {
    given.spec = parse_model(in.one("model"), file, settings);
  } else if (in.has("file")) {
    given.spec = read_model(file, settings);
  } else {
    throw InputError(
        {{.path = "model",
          .problem = "is missing",
          .cure = "give the TOML as the text `model`, or the path of a file as `file`"}});
  }
  given.model = compile(given.spec);
  return given;
}

// A model given as a text belongs to no file, so the caller has to take care which files its results replace.
Origin origin_of(const Job& job, const GivenModel& given) {
  std::error_code error;
  const std::string file = job.in.one("file");
  return {std::filesystem::exists(file, error) ? file : "", spec_hash(given.spec),
          job.in.real("replace", 0) != 0};
}

// A run from start to end, in one call or in pieces.
struct RunUnderWay {
  std::shared_ptr<Done> done = std::make_shared<Done>();
  State state;
  RunRecord record;
  SolveOptions options;
  std::string language;
  std::unique_ptr<Replacement> results;
  bool goes_on = false;
};

// Solves to the end, or to where it is stopped. The next wythe_do continues a run in pieces from there, with the same bits.
bool solve_on(Job& job, const std::shared_ptr<RunUnderWay>& run) {
  Done& done = *run->done;
  State state_then;
  RunRecord record_then;
  if (run->goes_on)
    run->options.checkpoint = [&](const State& state, const RunRecord& record, bool ends) {
      if (!ends) return;
      state_then = state;
      record_then = record;
    };
  done.result = dynamics::run_stages(done.model, run->state, run->options, std::move(run->record));
  const bool stopped = done.result.status == SolveStatus::kInterrupted;
  if (stopped && run->goes_on) {
    job.stop = false;
    run->state = std::move(state_then);
    run->record = std::move(record_then);
    job.rest = [run](Job& same) { return solve_on(same, run); };
    if (dimension_of(done.model) == 2)
      job.out.text_later("svg", [run] { return wall_svg(run->done->model, run->state, 1); });
    return true;
  }
  // Here and not at each stop: it reads all states of the push so far.
  done.result.failure_mode = name_failure_mode(done.model, done.result);
  read_result(done.spec, done.model, done.result);
  if (run->results) write_done(run->language, *run->results, done);
  answer_run(job, run->done, run->language);
  return stopped;
}

bool do_run(Job& job) {
  job.in.check("run", {"model", "file", "set", "out", "language"},
               {"threads", "frames", "replace", "goes_on"}, false);
  auto run = std::make_shared<RunUnderWay>();
  const std::string out = job.in.out_folder();
  run->language = job.in.one("language", "en");
  check_language(run->language, "language");
  run->options = options_of(job);
  run->goes_on = job.in.real("goes_on", 0) != 0;
  GivenModel given = read_given(job.in);
  if (!out.empty()) run->results = replace_run(out, origin_of(job, given));
  run->done->spec = std::move(given.spec);
  run->done->model = std::move(given.model);
  run->state = initial_state(run->done->model);
  return solve_on(job, run);
}

bool do_check(Job& job) {
  job.in.check("check", {"model", "file", "set", "language"}, {}, false);
  const std::string language = job.in.one("language", "en");
  check_language(language, "language");
  const auto given = std::make_shared<const GivenModel>(read_given(job.in));
  const Model& m = given->model;
  const Json counts = {{"blocks", m.n_block},
                       {"joints", m.n_joint},
                       {"points", m.n_point()},
                       {"weight_kN", 1e-3 * m.weight},
                       {"length_m", m.anatomy.length},
                       {"height_m", m.anatomy.height},
                       {"thickness_m", m.anatomy.thickness},
                       {"in_space", dimension_of(m) == 3},
                       {"notes", texts_of(m.anatomy.notes, language)}};
  job.out.put("counts", dumped(counts));
  job.out.text_later("check", [given, facts = counts]() mutable {
    const RunEstimate cost = estimate(given->model);
    facts["time_step_s"] = cost.time_step;
    facts["steps"] = cost.steps;
    facts["expected_seconds"] = cost.seconds;
    return dumped(facts);
  });
  job.out.text_later("model", [given] { return write_model(given->spec); });
  if (dimension_of(m) == 2)
    job.out.text_later("svg",
                       [given] { return wall_svg(given->model, initial_state(given->model), 1); });
  return false;
}

// The state for the picture of a limit load: the blocks moved by its mechanism, far enough to be visible.
State moved_by(const Model& model, const LimitResult& limit) {
  constexpr double kFarthest = 0.06;  // of the wall's height
  State state = initial_state(model);
  if (const Stage* grows = limit::growing_stage(model); grows != nullptr)
    state.stage = static_cast<int>(grows - model.stages.data());
  double fastest = 0;
  for (std::size_t b = 0; b < limit.vx.size(); ++b)
    fastest = std::max(fastest, std::hypot(limit.vx[b], limit.vy[b]));
  if (!(fastest > 0) || limit.vx.size() > state.ux.size()) return state;
  const double size = kFarthest * model.anatomy.height / fastest;
  for (std::size_t b = 0; b < limit.vx.size(); ++b) {
    state.ux[b] += size * limit.vx[b];
    state.uy[b] += size * limit.vy[b];
    state.theta[b] += size * limit.omega[b];
  }
  return state;
}

bool do_limit(Job& job) {
  job.in.check("limit", {"model", "file", "set", "out", "language", "only"},
               {"assessment", "quick", "replace"}, false);
  const std::string language = job.in.one("language", "en"), out = job.in.out_folder();
  check_language(language, "language");
  OpinionAsked asked{.only = job.in.all("only"),
                     .assessment = job.in.real("assessment", 0) != 0,
                     .quick = job.in.real("quick", 0) != 0};
  check_asked(asked, "only");
  const GivenModel given = read_given(job.in);
  asked.parts = asks_for_parts(asked) && has_parts(given.spec, given.model);
  const Origin origin = origin_of(job, given);
  if (!out.empty()) check_limit_folder(out, origin);
  const SecondOpinion opinion = [&] {
    SecondOpinion made = second_opinion(
        given.model, asked, &job.stop,
        [&](const Message& what, double share) { job.progress(text_of(what), share, 0, 0); });
    if (asked.assessment) add_local_checks(given.spec, given.model, asks_for_parts(asked), made);
    for (Message& note : notes_on(given.model, made)) made.notes.push_back(std::move(note));
    return made;
  }();
  if (!out.empty()) {
    static_cast<void>(write_second_opinion(out, given.spec, given.model, opinion, language));
    write_origin(out, origin);
  }
  job.out.put("mechanisms", mechanisms_json(given.model, opinion));
  const auto model = std::make_shared<const Model>(given.model);  // for all pictures
  for (const Mechanism& m : opinion.mechanisms) {
    Table curve;
    curve.add("displacement_mm",
              each(m.curve.states, [](const ChainState& s) { return 1e3 * s.displacement; }));
    curve.add("force_kN", each(m.curve.states, [](const ChainState& s) { return 1e-3 * s.force; }));
    job.out.put(m.file_name(), std::move(curve));
    job.out.text_later(m.file_name() + " svg", [model, m] { return mechanism_svg(*model, m); });
  }
  for (const NamedLimit& limit : opinion.limits)
    if (dimension_of(*model) == 2)
      job.out.text_later(limit.name + " svg", [model, answer = limit.answer] {
        return wall_svg(*model, moved_by(*model, answer), 1);
      });
  return job.stop;
}

bool do_contact(Job& job) {
  job.in.check("contact", {"law", "file"}, {}, true);
  const JointMaterial law = job.in.has("law")
                                ? parse_law(job.in.one("law"), job.in.one("file", "law.toml"))
                                : read_law(job.in.one("file"));
  FaultList faults;
  const auto column = [&](const char* name) -> const std::vector<double>& {
    const auto found = job.in.column.find(name);
    static const std::vector<double> kNone;
    if (found != job.in.column.end()) return found->second;
    faults.add({.file = "path",
                .path = name,
                .problem = "is missing",
                .cure = "a path needs the columns opening_mm and slip_mm"});
    return kNone;
  };
  const std::vector<double>&opening = column("opening_mm"), &slip = column("slip_mm");
  if (opening.size() != slip.size() || opening.empty())
    faults.add({.file = "path",
                .value = fmt::format("{} and {} rows", opening.size(), slip.size()),
                .problem = "needs as many rows of opening as of slip, and one at least",
                .cure = "give both for each point of the path"});
  faults.throw_if_any();
  std::vector<ContactPathRow> path;
  constexpr double kFarthest = 1e6;  // [mm], as in a path file
  for (std::size_t i = 0; i < opening.size(); ++i) {
    if (!(std::fabs(opening[i]) <= kFarthest) || !(std::fabs(slip[i]) <= kFarthest))
      faults.add({.file = "path",
                  .path = fmt::format("row {}", i),
                  .value = fmt::format("{}, {}", opening[i], slip[i]),
                  .problem = "must be finite numbers below a kilometre",
                  .cure = "write millimetres"});
    path.push_back({.opening = 1e-3 * opening[i], .slip = 1e-3 * slip[i]});
  }
  faults.throw_if_any();
  const std::vector<ContactAnswer> answers = drive_contact(law, path);
  Table table;
  const auto add = [&](const char* name, double ContactAnswer::*value, double to_unit) {
    table.add(name, each(answers, [&](const ContactAnswer& a) { return to_unit * (a.*value); }));
  };
  add("normal_stress_MPa", &ContactAnswer::normal_stress, 1e-6);
  add("shear_stress_MPa", &ContactAnswer::shear_stress, 1e-6);
  add("damage_tension", &ContactAnswer::damage_tension, 1);
  add("damage_shear", &ContactAnswer::damage_shear, 1);
  add("damage", &ContactAnswer::damage, 1);
  add("crushing", &ContactAnswer::crushing, 1);
  add("dissipated_N_per_m", &ContactAnswer::dissipated, 1);
  job.out.put("answer", std::move(table));
  return false;
}

bool do_report(Job& job) {
  job.in.check("report", {"folder", "language"}, {}, false);
  const std::string folder = job.in.one("folder");
  if (folder.empty())
    throw InputError(
        {{.path = "folder", .problem = "is missing", .cure = "name the folder of results"}});
  rewrite_page(folder, job.in.one("language", "en"));
  return false;
}

bool do_keys(Job& job) {
  job.in.check("keys", {}, {}, false);
  job.out.put("keys", keys_json());
  return false;
}

}  // namespace

const Tasks& run_tasks() {
  static const Tasks kTasks = {{"run", do_run},         {"check", do_check},   {"limit", do_limit},
                               {"contact", do_contact}, {"report", do_report}, {"keys", do_keys},
                               {"assess", do_assess}};
  return kTasks;
}

}  // namespace wythe::api
