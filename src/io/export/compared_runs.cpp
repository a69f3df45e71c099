// Stored runs and campaigns, read back to be compared with mechanisms and limit loads.
//
// A run is force_displacement.csv, summary.json and model.used.toml; a campaign is its store. The bound
// of a run is the limit load of its own model with the full strength of its joints, without crushing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/files.h"
#include "core/limits.h"
#include "core/messages.h"
#include "io/text/csv.h"
#include "io/text/json.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;
using namespace io;

// Rows of a curve while the push advances; for a cyclic push the envelope of first loading.
std::vector<CurveRow> first_loading(const std::vector<CurveRow>& rows) {
  std::vector<CurveRow> kept;
  for (const CurveRow& row : rows)
    if (kept.empty() || row.displacement > kept.back().displacement) kept.push_back(row);
  return kept;
}

constexpr std::size_t kMostCompared = 200'000;  // a run has 200 rows unless it is asked for more

std::vector<CurveRow> parse_curve(const std::string& path) {
  const std::string text = read_text(path, kMostCsv);
  CsvLines lines(text, path);
  if (!lines.next() ||
      !lines.text().starts_with("time_s,displacement_mm,drift_percent,reaction_kN"))
    throw IoError(path + ": is not a curve of wythe run");
  std::vector<CurveRow> rows;
  while (lines.next()) {
    const std::vector<std::string>& cells = lines.cells();
    const auto number = [&](std::size_t i) {
      return i < cells.size() ? number_in(cells[i]) : kUnset;
    };
    const CurveRow row{
        .time = number(0), .displacement = 1e-3 * number(1), .reaction = 1e3 * number(3)};
    if (!std::isfinite(row.displacement + row.reaction))
      throw IoError(path + ":" + std::to_string(lines.line()) +
                    ": needs finite numbers in its first four columns; run the model again");
    rows.push_back(row);
    if (rows.size() > kMostCompared)
      throw IoError(fmt::format(
          "{}: has more than {} rows, which no page draws; run the model again with fewer "
          "(output.rows, output.window)",
          path, kMostCompared));
  }
  if (rows.empty()) throw IoError(path + ": holds no row; run wythe run to its end");
  return rows;
}

// The model with its push in the opposite direction.
Model reversed(Model model) {
  for (Stage& stage : model.stages) {
    if (stage.push() == nullptr) continue;
    stage.drive_x = -stage.drive_x;
    stage.drive_y = -stage.drive_y;
    stage.drive_z = -stage.drive_z;
  }
  return model;
}

// Dead loads of the driven blocks along the push: they are part of a reaction, but not of a limit load.
double weight_on_push(const Model& model) {
  const Stage* push = nullptr;
  for (const Stage& stage : model.stages)
    if (stage.push() != nullptr) push = &stage;
  if (push == nullptr) return 0;
  double sum = 0;
  for (const BlockId b : push->driven)
    if (b < model.n_block)  // a support in space loads no joint
      sum -= model.solve.gravity * model.gravity_mass[b] * push->drive_y;
  for (const Stage& stage : model.stages) {
    if (&stage == push) break;
    for (const PointLoad& load : stage.loads)
      if (std::find(push->driven.begin(), push->driven.end(), load.block) != push->driven.end())
        sum += dot(Vec3{load.fx, load.fy, load.fz}, push->drive());
  }
  return sum;
}

void set_bound(const Model& model, ComparedRun& run) {
  const LimitOptions bonded{.strength = JointStrength::kBonded};
  run.weight_on_push = weight_on_push(model);
  try {
    run.bound = limit_load(model, bonded).load;
    if (run.peak_back > 0) run.bound_back = limit_load(reversed(model), bonded).load;
  } catch (const InputError& error) {
    run.no_bound = error.what();
  }
}

// A number, or NaN for null.
double number_of(const nlohmann::json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

// The values of summary.json; throws IoError for a missing key.
struct SummaryFile {
  const std::string& file;
  const nlohmann::json& json;
  [[nodiscard]] const nlohmann::json& at(const std::string& key) const {
    if (!json.is_object() || !json.contains(key)) refuse(key, "is missing");
    return json.at(key);
  }
  [[nodiscard]] std::string text(const std::string& table, const std::string& key) const {
    const nlohmann::json& in = at(table);
    if (!in.is_object() || !in.contains(key)) refuse(table + "." + key, "is missing");
    if (!in.at(key).is_string()) refuse(table + "." + key, "is no text");
    return in.at(key).get<std::string>();
  }
  [[noreturn]] void refuse(const std::string& key, const char* what) const {
    throw IoError(file + ": " + key + " " + what +
                  ": this is no summary of wythe run, or it was changed; run the model again");
  }
};

// The rows for the comparison: first loading along the push, and
// the highest force in the other direction where targets lie there.
void take_curve(const Model& model, std::vector<CurveRow> rows, ComparedRun& run) {
  std::vector<double> targets;
  for (const Stage& stage : model.stages)
    if (stage.push() != nullptr) targets = stage.push()->targets;
  const bool forth = targets.empty() || *std::max_element(targets.begin(), targets.end()) > 0;
  const bool back = !targets.empty() && *std::min_element(targets.begin(), targets.end()) < 0;
  if (!forth)
    for (CurveRow& row : rows) row.displacement = -row.displacement, row.reaction = -row.reaction;
  if (forth && back)
    for (const CurveRow& row : rows) run.peak_back = std::max(run.peak_back, -row.reaction);
  run.curve = first_loading(rows);
}

ComparedRun parse_run(const fs::path& folder) {
  ComparedRun run{.name = "run", .mode = ""};
  std::vector<CurveRow> rows = parse_curve((folder / "force_displacement.csv").string());
  const std::string file = (folder / "summary.json").string();
  const nlohmann::json summary = parse_json(read_text(file, kMostJson), file);
  const SummaryFile said{file, summary};
  run.mode = said.text("failure_mode", "name");
  run.load_factor = std::fmax(0.0, number_of(said.at("load_factor")));
  const nlohmann::json& meter = said.at("quasi_static");
  const std::string verdict = said.text("quasi_static", "verdict");
  const std::string data = meter.contains("verdict_message") ? meter["verdict_message"].dump() : "";
  run.rate_verdict = message_of(data, verdict);
  run.judgement = said.text("quasi_static", "judgement");
  run.capacity = 1e3 * number_of(said.at("peak_reaction_kN"));
  const Model model = compile(read_model((folder / "model.used.toml").string()));
  run.wall = described(model);
  take_curve(model, std::move(rows), run);
  set_bound(model, run);
  return run;
}

ComparedRun parse_sample(const Model& model, const SampleRecord& record) {
  ComparedRun run{.name = "sample " + std::to_string(record.sample),
                  .mode = record.failure_mode.name};
  take_curve(model, record.curve, run);
  run.rate_verdict = record.quasi_static.verdict;
  run.judgement = record.quasi_static.judgement;
  if (!std::isfinite(record.responses.peak_reaction))
    run.capacity = std::numeric_limits<double>::quiet_NaN();
  else if (record.responses.peak_reaction > 0)
    run.capacity = record.responses.peak_reaction;
  return run;
}

// Samples of a dry wall are compared with the limit load of their own models. With
// bond the bound is far away, and 250 limit loads would take as long as the campaign.
std::vector<ComparedRun> parse_samples(const std::string& folder) {
  const Campaign campaign = read_campaign(folder);
  const ModelBuilder build = model_builder(campaign.study);
  const Model base = compile(build({}));
  const Message wall = described(base);
  std::vector<ComparedRun> runs;
  for (const SampleRecord& record : campaign.records) {
    if (!record.answered()) continue;
    runs.push_back(parse_sample(base, record));
    runs.back().wall = wall;
    if (!has_bond(base))
      set_bound(compile(build(settings_of(campaign.samples, record.sample - 1))), runs.back());
  }
  return runs;
}

}  // namespace

std::vector<ComparedRun> read_compared_runs(const std::string& folder) {
  finish_replacement(folder);
  if (holds_campaign(folder)) return parse_samples(folder);
  if (fs::exists(fs::path(folder) / "summary.json")) return {parse_run(folder)};
  throw InputError({{.file = "--with",
                     .value = folder,
                     .problem = "holds neither a run (summary.json) nor a campaign (campaign.db)",
                     .cure = "name the --out folder of a finished wythe run or wythe campaign"}});
}

}  // namespace wythe
