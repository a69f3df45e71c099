// Tasks about one wall: run, replay, check, limit, contact, keys.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/job.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/number.h"
#include "io/results/curve_csv.h"
#include "io/results/element_columns.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/formats.h"
#include "wythe/io.h"
#include "wythe/reading.h"
#include "wythe/report.h"
#include "wythe/second_opinion.h"
#include "wythe/solve.h"
#include "wythe/text.h"

namespace wythe::api {
namespace {

using Json = nlohmann::ordered_json;

// A model as it was given: by its text, or by its file alone.
struct GivenModel {
  std::string text, file;
  std::vector<std::string> settings;
  ModelSpec spec;
  Model model;
};

GivenModel read_given(const Inputs& in) {
  GivenModel given;
  given.file = in.one("file", "model.toml");
  given.settings = in.all("set");
  if (in.has("model")) {
    given.text = in.one("model");
    given.spec = parse_model(given.text, given.file, given.settings);
    given.model = compile_model(given.spec, given.text, given.file, given.settings);
  } else if (in.has("file")) {
    given.model = read_and_compile(given.file, given.settings, &given.spec);
  } else {
    throw InputError(
        {{.file = "",
          .path = "model",
          .value = "",
          .problem = "is missing",
          .cure = "give the TOML as the text `model`, or the path of a file as `file`"}});
  }
  return given;
}

// A model that a program holds is of no file: what its results replace is the program's own affair.
Origin origin_of(const Job& job, const GivenModel& given) {
  std::error_code error;
  const std::string file = job.in.one("file");
  return {std::filesystem::exists(file, error) ? file : "", spec_hash(given.spec),
          job.in.real("replace", 0) != 0};
}

Table curve_of(const Result& result, const Model& model) {
  Table table;
  for (const CurveColumn& column : columns_shown(columns_of(model))) {
    std::vector<double> values;
    values.reserve(result.curve.size());
    for (const CurveRow& row : result.curve) values.push_back(row.*column.value * column.to_unit);
    table.add(column.name, std::move(values));
  }
  return table;
}

// A text of comma separated numbers under one row of titles, as the program writes it itself.
Table table_of(const std::string& csv) {
  Table table;
  std::size_t at = csv.find('\n');
  const std::string head = csv.substr(0, at);
  for (std::size_t from = 0; from <= head.size();) {
    const std::size_t comma = std::min(head.find(',', from), head.size());
    table.add(head.substr(from, comma - from), {});
    from = comma + 1;
  }
  for (std::size_t i = 0; at != std::string::npos && at + 1 < csv.size(); ++i) {
    const auto cell = leading_number(std::string_view(csv).substr(at + 1));
    table.value[i % table.column.size()].push_back(cell ? cell->value : kUnset);
    at = csv.find_first_of(",\n", at + 1);
  }
  return table;
}

template <class Row, class Value>
std::vector<double> each(const std::vector<Row>& rows, const Value& value) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(value(row));
  return values;
}

void add_vectors(Table& table, const std::string& before, const std::string& after,
                 const std::vector<Vec3>& vectors, double to_unit) {
  table.add(before + "x" + after, each(vectors, [&](Vec3 v) { return to_unit * v.x; }));
  table.add(before + "y" + after, each(vectors, [&](Vec3 v) { return to_unit * v.y; }));
  table.add(before + "z" + after, each(vectors, [&](Vec3 v) { return to_unit * v.z; }));
}

Table blocks_of(const Model& model, const State& state) {
  std::vector<Vec3> start, moved, turned;
  for (BlockId b = 0; b < block_count(model); ++b) {
    const BlockReading block = read_block(model, state, b);
    start.push_back(block.start);
    moved.push_back(block.moved);
    turned.push_back(block.turned.by);
  }
  Table table;
  add_vectors(table, "", "_m", start, 1);
  add_vectors(table, "displacement_", "_mm", moved, 1e3);
  add_vectors(table, "rotation_", "_mrad", turned, 1e3);
  return table;
}

Table joints_of(const Model& model, const State& state) {
  const WallReading wall = read_wall(model, state);
  std::vector<Vec3> centre, normal;
  for (const JointReading& joint : wall.joints) {
    centre.push_back(joint.shape.centre);
    normal.push_back(joint.shape.normal);
  }
  Table table;
  add_vectors(table, "", "_m", centre, 1);
  add_vectors(table, "normal_", "", normal, 1);
  const auto add = [&](const char* name, const auto& value) {
    table.add(name, each(wall.joints, value));
  };
  add("area_m2", [](const JointReading& j) { return j.shape.area; });
  add("block_a", [](const JointReading& j) { return double(j.shape.a); });
  add("block_b", [](const JointReading& j) { return double(j.shape.b); });
  for (const auto& column : io::kJointColumns)
    add(column.name, [&](const JointReading& j) { return column.shown(j); });
  add("compression_kN", [](const JointReading& j) { return 1e-3 * j.compression; });
  add("shear_kN", [](const JointReading& j) { return 1e-3 * j.shear; });
  add("moment_kNm", [](const JointReading& j) { return 1e-3 * j.moment; });
  add("eccentricity", [](const JointReading& j) { return j.eccentricity; });
  return table;
}

// What later answers are made from; kept as long as one of them is.
struct Done {
  ModelSpec spec;
  Model model;
  Result result;
};

void answer_states(Job& job, const std::shared_ptr<const Done>& done) {
  Json states = Json::array();
  for (std::size_t k = 0; k < done->result.snapshots.size(); ++k) {
    const Snapshot& s = done->result.snapshots[k];
    states.push_back({{"label", s.label},
                      {"displacement_mm", 1e3 * s.displacement},
                      {"reaction_kN", 1e-3 * s.reaction}});
    const std::string name = fmt::format("state {}", k);
    const auto state = [done, k]() -> const State& { return done->result.snapshots[k].state; };
    job.out.table_later(name + " blocks", [=] { return blocks_of(done->model, state()); });
    job.out.table_later(name + " joints", [=] { return joints_of(done->model, state()); });
    job.out.text_later(name + " compas", [=] { return compas_json(done->model, state()); });
    if (!done->model.in_space())
      job.out.text_later(name + " svg", [=] { return wall_svg(done->model, state(), 1); });
  }
  job.out.put("states", dumped(states));
}

void answer_run(Job& job, const std::shared_ptr<const Done>& done, const std::string& language) {
  const Result& r = done->result;
  job.out.put("summary", summary_json(done->spec, done->model, r));
  job.out.put("curve", curve_of(r, done->model));
  if (!r.history.row.empty())
    job.out.put("history", table_of(io::history_csv(r.history, done->model.in_space())));
  Json names = Json::array();
  for (const std::string& id : done->model.anatomy.block_id) names.push_back(id);
  for (const SolidBody& body : done->model.solids.bodies) names.push_back(body.id);
  job.out.put("block_ids", dumped(names));
  job.out.text_later("model", [done] { return write_model(done->spec); });
  job.out.text_later("page", [done, language] {
    return report_page(run_data(done->spec, done->model, done->result), language);
  });
  answer_states(job, done);
}

SolveOptions options_of(Job& job) {
  SolveOptions options;
  options.threads = job.in.cores("threads", 1);
  if (options.threads == 0)
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.frames = job.in.integer("frames", job.in.has("out") ? kFrames : 0, 0, 10'000);
  options.stop = &job.stop;
  options.progress = [&job](const Progress& p) {
    job.progress(p.stage, p.share, 1e3 * p.displacement, 1e-3 * p.reaction);
  };
  return options;
}

void write_done(const std::string& language, Replacement& results, const Done& done) {
  write_run(results.path(), done.spec, done.model, done.result);
  write_run_report(results.path(), done.spec, done.model, done.result, language);
  results.commit();
}

Json notes_of_model(const Model& model) {
  Json notes = Json::array();
  for (const Message& note : model.anatomy.notes) notes.push_back(text_of(note));
  return notes;
}

}  // namespace

bool do_run(Job& job) {
  job.in.check("run", {"model", "file", "set", "out", "language"}, {"threads", "frames", "replace"},
               false);
  const std::string language = job.in.one("language", "en"), out = job.in.out_folder();
  check_language(language, "language");
  const SolveOptions options = options_of(job);
  GivenModel given = read_given(job.in);
  const std::unique_ptr<Replacement> results =
      out.empty() ? nullptr : replace_run(out, origin_of(job, given));
  auto done = std::make_shared<Done>();
  done->spec = std::move(given.spec);
  done->model = std::move(given.model);
  State state = initial_state(done->model);
  done->result = solve(done->model, state, options);
  read_result(done->spec, done->model, done->result);
  if (results) write_done(language, *results, *done);
  answer_run(job, done, language);
  return done->result.status == SolveStatus::kInterrupted;
}

bool do_replay(Job& job) {
  job.in.check("replay", {"folder", "out", "language"}, {"sample", "threads", "frames", "replace"},
               false);
  const std::string language = job.in.one("language", "en"), out = job.in.out_folder();
  check_language(language, "language");
  const SolveOptions options = options_of(job);
  const Campaign campaign = read_campaign(job.in.one("folder"));
  const int sample = job.in.integer("sample", 0, 1, campaign.samples.n_sample());
  const std::unique_ptr<Replacement> results =
      out.empty() ? nullptr
                  : replace_run(out, {job.in.one("folder"), 0, job.in.real("replace", 0) != 0});
  SampleRun run =
      run_sample(campaign.study, campaign.samples, sample, model_builder(campaign.study), options);
  if (!run.refused.empty())
    throw InputError({{.file = job.in.one("folder"),
                       .path = fmt::format("sample {}", sample),
                       .value = "",
                       .problem = "was refused: " + run.refused,
                       .cure = "choose another sample"}});
  std::string stored;
  for (const SampleRecord& record : campaign.records)
    if (record.sample == sample) stored = record.state_hash;
  auto done = std::make_shared<Done>();
  done->spec = std::move(run.spec);
  done->model = std::move(run.model);
  done->result = std::move(run.result);
  if (results) write_done(language, *results, *done);
  answer_run(job, done, language);
  Json settings = run.settings;
  job.out.put("replay", dumped({{"sample", sample},
                                {"stored_state_hash", stored},
                                {"equal", stored == done->result.state_hash},
                                {"settings", settings}}));
  return done->result.status == SolveStatus::kInterrupted;
}

bool do_check(Job& job) {
  job.in.check("check", {"model", "file", "set"}, {}, false);
  const GivenModel given = read_given(job.in);
  const Model& m = given.model;
  const RunEstimate cost = estimate(m);
  job.out.put("check", dumped({{"blocks", m.n_block},
                               {"joints", m.n_joint},
                               {"points", m.n_point()},
                               {"weight_kN", 1e-3 * m.weight},
                               {"length_m", m.anatomy.length},
                               {"height_m", m.anatomy.height},
                               {"thickness_m", m.anatomy.thickness},
                               {"in_space", m.in_space()},
                               {"time_step_s", cost.time_step},
                               {"steps", cost.steps},
                               {"expected_seconds", cost.seconds},
                               {"notes", notes_of_model(m)}}));
  job.out.put("model", write_model(given.spec));
  if (!m.in_space()) job.out.put("svg", wall_svg(m, initial_state(m), 1));
  return false;
}

bool do_limit(Job& job) {
  job.in.check("limit", {"model", "file", "set", "out", "language", "only"},
               {"assessment", "replace"}, false);
  const std::string language = job.in.one("language", "en"), out = job.in.out_folder();
  check_language(language, "language");
  OpinionAsked asked{job.in.all("only"), job.in.real("assessment", 0) != 0};
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
  for (const Mechanism& m : opinion.mechanisms) {
    Table curve;
    curve.add("displacement_mm",
              each(m.curve.states, [](const ChainState& s) { return 1e3 * s.displacement; }));
    curve.add("force_kN", each(m.curve.states, [](const ChainState& s) { return 1e-3 * s.force; }));
    job.out.put(m.file_name(), std::move(curve));
    job.out.text_later(m.file_name() + " svg",
                       [model = given.model, m] { return mechanism_svg(model, m); });
  }
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
                .value = "",
                .problem = "is missing",
                .cure = "a path needs the columns opening_mm and slip_mm"});
    return kNone;
  };
  const std::vector<double>&opening = column("opening_mm"), &slip = column("slip_mm");
  if (opening.size() != slip.size() || opening.empty())
    faults.add({.file = "path",
                .path = "",
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

bool do_keys(Job& job) {
  job.in.check("keys", {}, {}, false);
  job.out.put("keys", keys_json());
  return false;
}

}  // namespace wythe::api
