// Tables of the curve, of blocks and of joints. States and pages are made when they are requested.
#include "api/run_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/number.h"
#include "io/results/curve_csv.h"
#include "io/results/element_columns.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/formats.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/report.h"
#include "wythe/parts/text.h"

namespace wythe::api {
namespace {

using Json = nlohmann::ordered_json;

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

// A table from a text of comma-separated numbers under one row of titles, as the program itself writes it.
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

void answer_states(Job& job, const std::shared_ptr<const Done>& done) {
  Json states = Json::array();
  for (std::size_t k = 0; k < done->result.states.snapshots.size(); ++k) {
    const Snapshot& s = done->result.states.snapshots[k];
    states.push_back({{"label", s.label},
                      {"displacement_mm", 1e3 * s.displacement},
                      {"reaction_kN", 1e-3 * s.reaction}});
    const std::string name = fmt::format("state {}", k);
    const auto state = [done, k]() -> const State& {
      return done->result.states.snapshots[k].state;
    };
    job.out.table_later(name + " blocks", [=] { return blocks_of(done->model, state()); });
    job.out.table_later(name + " joints", [=] { return joints_of(done->model, state()); });
    job.out.text_later(name + " compas", [=] { return compas_json(done->model, state()); });
    if (dimension_of(done->model) == 2)
      job.out.text_later(name + " svg", [=] { return wall_svg(done->model, state(), 1); });
  }
  job.out.put("states", dumped(states));
}

}  // namespace

void answer_run(Job& job, const std::shared_ptr<const Done>& done, const std::string& language) {
  const Result& r = done->result;
  job.out.put("summary", summary_json(done->spec, done->model, r));
  job.out.put("reason", text_of(r.reason, language));
  job.out.put("curve", curve_of(r, done->model));
  if (!r.history.row.empty())
    job.out.put("history", table_of(io::history_csv(r.history, dimension_of(done->model))));
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

}  // namespace wythe::api
