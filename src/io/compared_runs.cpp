// Stored runs and campaigns, read back to be compared with mechanisms and limit loads.
//
// A run is force_displacement.csv, summary.json and model.used.toml; a campaign its store. The bound
// of a run is the limit load of its own model with all its joints' strength, without crushing.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "wythe/error.h"
#include "wythe/io.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) throw IoError(path.string() + ": cannot be read");
  return text.str();
}

// Rows of a curve while the push goes on; a cyclic one gives its envelope of first loading.
std::vector<CurveRow> first_loading(const std::vector<CurveRow>& rows) {
  std::vector<CurveRow> kept;
  for (const CurveRow& row : rows)
    if (kept.empty() || row.displacement > kept.back().displacement) kept.push_back(row);
  return kept;
}

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> values;
  const char* at = line.data();
  const char* end = at + line.size();
  while (at < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) break;
    values.push_back(value);
    at = next < end ? next + 1 : next;
  }
  return values;
}

std::vector<CurveRow> read_curve(const fs::path& path) {
  std::istringstream text(text_of(path));
  std::string line;
  std::getline(text, line);
  if (!line.starts_with("time_s,displacement_mm,drift_percent,reaction_kN"))
    throw IoError(path.string() + ": is not a curve of wythe run");
  std::vector<CurveRow> rows;
  for (int number = 2; std::getline(text, line); ++number) {
    const std::vector<double> v = numbers_of(line);
    if (v.size() < 4)
      throw IoError(path.string() + ":" + std::to_string(number) + ": too few numbers");
    rows.push_back({.time = v[0], .displacement = 1e-3 * v[1], .reaction = 1e3 * v[3]});
  }
  if (rows.empty()) throw IoError(path.string() + ": holds no row; run wythe run to its end");
  return first_loading(rows);
}

// The larger of two measures: what damping and motion took of the work that was put in; and by how
// much the run's own verdict puts its peak above that of a slow push (responses.cpp has the factor).
double rate_effect(const QuasiStatic& q) {
  constexpr double kLift = 1.7;
  const double work = std::max(0.0, q.damping_share) + std::max(0.0, q.kinetic_ratio_mean);
  return std::max(work, kLift * q.shear_gap);
}

void set_bound(const Model& model, ComparedRun& run) {
  try {
    run.bound = limit_load(model, {.strength = JointStrength::kBonded}).load;
  } catch (const InputError& error) {
    run.no_bound = error.what();
  }
}

ComparedRun read_run(const fs::path& folder) {
  ComparedRun run{.name = "run", .mode = ""};
  run.curve = read_curve(folder / "force_displacement.csv");
  try {
    const Json summary = Json::parse(text_of(folder / "summary.json"));
    run.mode = summary.at("failure_mode").at("name").get<std::string>();
    run.load_factor = summary.at("load_factor").get<double>();
    const Json& meter = summary.at("quasi_static");
    QuasiStatic q;
    q.damping_share = meter.at("damping_share").get<double>();
    q.kinetic_ratio_mean = meter.at("kinetic_ratio_mean").get<double>();
    q.shear_gap = meter.at("shear_gap").get<double>();
    run.rate_effect = rate_effect(q);
  } catch (const Json::exception& error) {
    throw IoError((folder / "summary.json").string() + ": " + error.what());
  }
  const Model model = compile(read_model((folder / "model.used.toml").string()));
  run.wall = in_words(model);
  set_bound(model, run);
  return run;
}

ComparedRun read_sample(const SampleRecord& record) {
  ComparedRun run{.name = "sample " + std::to_string(record.sample),
                  .mode = record.failure_mode.name};
  run.curve = first_loading(record.curve);
  run.rate_effect = rate_effect(record.quasi_static);
  return run;
}

// Samples of a dry wall are held against the limit load of their own models; with bond the bound is
// far, and 250 limit loads would take as long as the campaign.
std::vector<ComparedRun> read_samples(const std::string& folder) {
  const Campaign campaign = read_campaign(folder);
  const ModelBuilder build = model_builder(campaign.study);
  const Model base = compile(build({}));
  const std::string wall = in_words(base);
  std::vector<ComparedRun> runs;
  for (const SampleRecord& record : campaign.records) {
    if (!record.answered()) continue;
    runs.push_back(read_sample(record));
    runs.back().wall = wall;
    if (!has_bond(base))
      set_bound(compile(build(settings_of(campaign.samples, record.sample - 1))), runs.back());
  }
  return runs;
}

}  // namespace

std::vector<ComparedRun> read_compared_runs(const std::string& folder) {
  if (holds_campaign(folder)) return read_samples(folder);
  if (fs::exists(fs::path(folder) / "summary.json")) return {read_run(folder)};
  throw InputError({{.file = "--with",
                     .path = "",
                     .value = folder,
                     .problem = "holds neither a run (summary.json) nor a campaign (campaign.db)",
                     .cure = "name the --out folder of a finished wythe run or wythe campaign"}});
}

}  // namespace wythe
