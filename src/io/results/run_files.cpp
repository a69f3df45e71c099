// The files of `wythe run` except report.html (contract: docs/reference/results.md).
//
//   force_displacement.csv   elements.csv   model.used.toml   state_blocks_NN.vtu   state_joints_NN.vtu
//   state_zones_NN.vtu (with deformable blocks)
//   frames.csv (with frames)
//   layers.csv (with layers)
//   links.csv (with ties, diaphragms or springs)
//   history.csv, record_N.csv (of shakes)
//   run.pvd                  summary.json, written last
//   checkpoint.wythe         of an unfinished run (checkpoint.cpp)
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

#include "core/files.h"
#include "core/hash.h"
#include "core/limits.h"
#include "core/text.h"
#include "io/bodies/blocks_json.h"
#include "io/model/record_file.h"
#include "io/results/curve_csv.h"
#include "io/results/verdict_folder.h"
#include "io/results/vtu.h"
#include "model/protocol.h"
#include "wythe/parts/checkpoint.h"
#include "wythe/parts/element_forces.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

namespace fs = std::filesystem;

std::string inside(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

constexpr const char* kOrigin = ".wythe_model";
// Each folder of results has one of these, except a campaign's.
constexpr const char* kResults[] = {"summary.json",    "force_displacement.csv",
                                    "mechanisms.json", "columns.json",
                                    "results.h5",      "comparison.json"};

// state_blocks_00.vtu, state_joints_00.vtu, state_zones_00.vtu; record_1.csv
bool is_numbered(const std::string& name) {
  if (name.starts_with("record_") && name.ends_with(".csv")) return true;
  for (const char* begin : {"state_blocks_", "state_joints_", "state_zones_"})
    if (name.starts_with(begin) && name.ends_with(".vtu")) return true;
  return false;
}

// Whether `wythe run` writes this file; `replay` writes two more.
bool is_file_of_run(const std::string& name, bool of_replay) {
  for (const char* file :
       {"force_displacement.csv", "elements.csv", "links.csv", "frames.csv", "layers.csv",
        "history.csv", "summary.json", "run.pvd", "report.html", "report.data", "model.used.toml",
        "blocks.json", kCheckpointFile, kOrigin})
    if (name == file) return true;
  return is_numbered(name) || (of_replay && (name == "model.toml" || name == "settings.txt"));
}

// Refuses to overwrite a checkpoint, with which hours of computing would be lost.
void refuse_checkpoint(const std::string& folder) {
  const std::string file = inside(folder, kCheckpointFile);
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file, error))) return;
  throw InputError(
      {{.file = file,
        .problem = "is the checkpoint of a run that has not come to its end",
        .cure = fmt::format("go on with: wythe run --resume {}; or remove the file, or "
                            "name another folder",
                            folder)}});
}

// A folder belongs to a run if it has a run's curve or checkpoint, and no files of
// others; hidden files do not count. The files of a second opinion may be in it as well.
void refuse_others(const std::string& folder, const char* command = "run") {
  std::error_code error;
  const auto has = [&](const char* name) { return fs::exists(inside(folder, name), error); };
  const bool of_replay = has("settings.txt"), may_be_limit = std::string_view(command) == "limit";
  const bool may_be_verdict = std::string_view(command) == "assess";
  const bool of_run = !may_be_verdict && (has("summary.json") || has("force_displacement.csv") ||
                                          has(kCheckpointFile));
  const bool of_limit = may_be_limit && has("mechanisms.json");
  const bool of_verdict = may_be_verdict && has("assessment.json");
  const auto is_known = [&](const std::string& name) {
    return (of_run && is_file_of_run(name, of_replay)) ||
           (may_be_limit && (of_run || of_limit) && is_file_of_limit(name)) ||
           (of_verdict && is_file_of_verdict(name));
  };
  std::vector<std::string> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || name == "lost+found") continue;
    if (!is_known(name))
      others.push_back(name);
    else
      check_output(entry.path().string());
  }
  if (others.empty()) return;
  std::sort(others.begin(), others.end());
  const std::size_t more = others.size() - 1;
  throw InputError(
      {{.file = folder,
        .problem =
            fmt::format("holds {}{}, which no {} wrote: results are not put among other files",
                        others.front(), more > 0 ? fmt::format(" and {} more", more) : "", command),
        .cure = fmt::format(
            "name a new folder, an empty one, or one that holds an earlier {} alone", command)}});
}

void write_states(const std::string& folder, const Model& model,
                  const std::vector<Snapshot>& snapshots) {
  std::vector<io::SeriesEntry> series;
  int number = 0;
  for (const Snapshot& snapshot : snapshots) {
    const std::string blocks = fmt::format("state_blocks_{:02}.vtu", number);
    const std::string joints = fmt::format("state_joints_{:02}.vtu", number);
    write_file(inside(folder, blocks), io::blocks_vtu(model, snapshot.state));
    write_file(inside(folder, joints), io::joints_vtu(model, snapshot.state));
    const double millimetres = snapshot.displacement * 1e3;
    series.push_back({.time = millimetres, .part = 0, .name = "blocks", .file = blocks});
    series.push_back({.time = millimetres, .part = 1, .name = "joints", .file = joints});
    if (model.solids.n_zone + model.space.solids.n_zone > 0) {
      const std::string zones = fmt::format("state_zones_{:02}.vtu", number);
      write_file(inside(folder, zones), io::zones_vtu(model, snapshot.state));
      series.push_back({.time = millimetres, .part = 2, .name = "zones", .file = zones});
    }
    ++number;
  }
  write_file(inside(folder, "run.pvd"), io::series_pvd(series));
}

// The spec as the program understood it: stages and settings with resolved defaults. A
// blocks file is copied as blocks.json, so that the folder can be run again at any place.
std::string used_model(const std::string& folder, const ModelSpec& spec, const Model& model) {
  ModelSpec used = spec;
  used.solve = model.solve;
  for (std::size_t k = 0; k < used.stage.size() && k < model.stages.size(); ++k)
    used.stage[k] = model.stages[k].spec;
  for (StageSpec& stage : used.stage)
    if (auto* push = std::get_if<PushStage>(&stage.action); push && has_protocol(*push))
      push->targets.clear();  // its levels give them
  if (!used.wall.blocks.empty()) {
    write_file(inside(folder, "blocks.json"), io::blocks_text(used));
    used.wall.blocks = "blocks.json";
  }
  int records = 0;
  for (StageSpec& stage : used.stage)
    for (RecordSpec& record : records_of(stage)) {
      if (record.file.empty()) continue;
      record.file = fmt::format("record_{}.csv", ++records);
      write_file(inside(folder, record.file), io::record_text(record));
      record.column.clear();
      record.unit = RecordUnit::kMetres;
      record.step = kUnset;
    }
  return write_model(used);
}

}  // namespace

std::uint64_t spec_hash(const ModelSpec& spec) {
  Hash hash;
  hash.add(write_model(spec));
  hash.add(io::blocks_text(spec));
  for (const StageSpec& stage : spec.stage)
    for (const RecordSpec& record : records_of(stage)) {
      hash.add(record.read_times);
      hash.add(record.read_accelerations);
    }
  return hash.value();
}

void check_folder(const std::string& folder, FolderFor use) {
  const bool run = use == FolderFor::kRun;
  if (!run) refuse_checkpoint(folder);
  std::error_code error;
  for (const char* name :
       {"campaign.db", "campaign.db-wal", "campaign.db-shm", "campaign.db-journal", "campaign.lock",
        "samples.csv", "statistics.json", "report.html"})
    if (!run) check_output(inside(folder, name));
  if (!run && !fs::exists(inside(folder, "campaign.db"), error))
    for (const char* name : {"samples.csv", "statistics.json", "report.html", "mechanisms.json",
                             "columns.json", "results.h5"})
      if (fs::exists(inside(folder, name), error) &&
          !fs::exists(inside(folder, "summary.json"), error))
        throw InputError({{.file = folder,
                           .problem = fmt::format("holds {}, which no campaign in it wrote", name),
                           .cure = "name another folder"}});
  if (!fs::exists(inside(folder, run ? "campaign.db" : "summary.json"), error)) return;
  throw InputError({{.file = folder,
                     .problem = run ? "holds a campaign, whose report would be lost"
                                    : "holds the results of a run, whose report would be lost",
                     .cure = "name another folder"}});
}

namespace {

// The same name for a file in all spellings; a name that cannot be resolved is unchanged.
std::string full_name(const std::string& file) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : path.string();
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

// Refuses a model.used.toml in the folder as input, because results would replace it.
void refuse_model_inside(const std::string& folder, const Origin& origin) {
  std::error_code error;
  const fs::path file = full_name(origin.file);
  if (origin.file.empty() || !fs::is_regular_file(file, error) ||
      !is_file_of_run(file.filename().string(), true) ||
      !fs::equivalent(file.parent_path(), folder, error))
    return;
  throw InputError({{.file = origin.file,
                     .problem = "lies among the results that would replace it",
                     .cure = "name another folder, or move the model out of this one"}});
}

// `result`: a file of which the folder has to know the origin.
void check_origin_of(const char* result, const std::string& folder, const Origin& origin) {
  const std::string kept = inside(folder, kOrigin);
  std::error_code error;
  if (origin.replaces || origin.file.empty()) return;
  if (!fs::exists(fs::symlink_status(inside(folder, result), error))) return;
  std::string hash, file;
  if (fs::is_regular_file(fs::symlink_status(kept, error))) {
    std::istringstream lines(read_file(kept, kMostToml));
    std::getline(lines, hash) && std::getline(lines, file, '\0');
  }
  if (file.empty())
    throw InputError(
        {{.file = folder,
          .problem = fmt::format("holds results, and {}, which names their model, is missing or "
                                 "damaged",
                                 kOrigin),
          .cure = "name another folder, or replace them with --replace"}});
  const bool is_same = origin.spec_hash != 0 && hash == hash_text(origin.spec_hash);
  if (is_same || file == full_name(origin.file)) return;
  throw InputError({{.file = folder,
                     .problem = "holds results of another model or campaign, " + file,
                     .cure = "name another folder, or replace them with --replace"}});
}

}  // namespace

void check_origin(const std::string& folder, const Origin& origin) {
  for (const char* result : kResults) check_origin_of(result, folder, origin);
}

void write_origin(const std::string& folder, const Origin& origin) {
  if (!origin.file.empty())
    write_file(inside(folder, kOrigin),
               hash_text(origin.spec_hash) + '\n' + full_name(origin.file));
}

bool is_file_of_limit(const std::string& name) {
  for (const char* file :
       {"mechanisms.json", "limit.html", "limit.data", "report.html", "report.data"})
    if (name == file) return true;
  return name.starts_with("mechanism_") && (name.ends_with(".csv") || name.ends_with(".svg"));
}

void check_limit_folder(const std::string& folder, const Origin& origin) {
  check_folder(folder, FolderFor::kRun);
  refuse_others(folder, "limit");
  check_origin(folder, origin);
}

Origin origin_of(const std::vector<std::string>& folders, bool replaces) {
  std::vector<std::string> names;
  for (const std::string& folder : folders) names.push_back(full_name(folder));
  return {joined(names, ", "), 0, replaces};
}

void check_answer_file(const std::string& path, const std::vector<std::string>& inputs,
                       const std::string& mark) {
  std::error_code error;
  const auto refuse = [&](const char* problem) {
    throw InputError(
        {{.file = path, .problem = problem, .cure = "name another file, or remove this one"}});
  };
  check_output(path);
  for (const std::string& input : inputs)
    if (fs::equivalent(path, input, error)) refuse("is what this command reads, and would be lost");
  if (!fs::exists(path, error) || fs::is_empty(path, error)) return;
  constexpr std::size_t kBeginning = 400;
  std::string text;
  try {
    text = read_file(path, kMostPacked);
  } catch (const InputError&) {  // larger than any result
  }
  if (text.substr(0, kBeginning).find(mark) == std::string::npos)
    refuse("is there, and is no earlier answer of this command");
}

void prepare_folder(const std::string& folder) {
  check_folder(folder, FolderFor::kRun);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw IoError(folder + ": is a file; name a folder for the results");
  }
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  // writes a file of some size, so that permissions, read-only mounts and full disks show here
  const std::string probe = inside(folder, ".wythe_probe");
  write_file(probe, std::string(65536, ' '));
  fs::remove(probe, error);
}

std::unique_ptr<Replacement> replace_run(const std::string& folder, const Origin& origin,
                                         bool resumes) {
  check_folder(folder, FolderFor::kRun);
  finish_replacement(folder);
  if (!resumes) refuse_checkpoint(folder);
  refuse_others(folder);
  if (!resumes) refuse_model_inside(folder, origin);
  if (!resumes) check_origin(folder, origin);
  prepare_folder(folder);
  const bool of_replay = fs::exists(inside(folder, "settings.txt"));
  auto results = std::make_unique<Replacement>(
      folder, [of_replay](const std::string& name) { return is_file_of_run(name, of_replay); });
  write_origin(results->path(), origin);
  return results;
}

bool is_file_of_verdict(const std::string& name) {
  return name == "assessment.json" || name == "walls.csv" || name == "report.html";
}

void check_verdict_folder(const std::string& folder, const Origin& origin) {
  std::error_code error;
  if (fs::exists(inside(folder, std::string(kBaseFolder) + "/campaign.db"), error))
    throw InputError(
        {{.file = folder,
          .problem = "holds the campaigns of an assessment, whose report would be lost",
          .cure = "name another folder"}});
  check_folder(folder, FolderFor::kRun);
  finish_replacement(folder);
  refuse_others(folder, "assess");
  check_origin_of("assessment.json", folder, origin);
}

std::unique_ptr<Replacement> replace_verdict(const std::string& folder, const Origin& origin) {
  check_verdict_folder(folder, origin);
  prepare_folder(folder);
  auto results = std::make_unique<Replacement>(
      folder, [](const std::string& name) { return is_file_of_verdict(name) || name == kOrigin; });
  write_origin(results->path(), origin);
  return results;
}

void write_run(const std::string& folder, const ModelSpec& spec, const Model& model,
               const Result& result) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": cannot be made: " + error.message());
  write_file(inside(folder, "force_displacement.csv"),
             io::curve_csv(result.curve, columns_of(model)));
  write_file(inside(folder, "elements.csv"),
             element_forces_csv(read_element_forces(model, result)));
  if (result.shaking.was_shaken)
    write_file(inside(folder, "history.csv"), io::history_csv(result.history, dimension_of(model)));
  if (model.links.n > 0)
    write_file(inside(folder, "links.csv"), io::links_csv(model.links.name, result));
  if (model.frames.n > 0) write_file(inside(folder, "frames.csv"), io::frames_csv(model, result));
  if (model.layers.n > 0) write_file(inside(folder, "layers.csv"), io::layers_csv(model, result));
  write_file(inside(folder, "model.used.toml"), used_model(folder, spec, model));
  write_states(folder, model, result.states.snapshots);
  write_file(inside(folder, "summary.json"), summary_json(spec, model, result));
}

std::string read_data(const std::string& path) { return read_file(path, kMostPacked); }

void write_text(const std::string& path, const std::string& text) { write_file(path, text); }

}  // namespace wythe
