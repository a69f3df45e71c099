// Reads and writes files: model TOML, blocks JSON, contact law and path, and the files of `wythe run`.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "wythe/parts/campaign.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/study.h"
#include "wythe/parts/wall_spec.h"

namespace wythe {

struct PairedComparison;  // comparison.h
struct AskedWalls;        // verdict.h
struct WallsVerdict;
class InputError;  // error.h

// Reads a model file. `overrides` are the "path=value" texts of --set. The value is TOML, quotes are optional; a
// member of a list is given by name or by index: stage.push.velocity=1 mm/s, stage.2.velocity=1 mm/s.
// `blocks` is the content of the blocks file, `records` maps names of record files to their content. A file that is
// not among them is read from disk.
// Throws IoError when a file can't be read, InputError with every fault otherwise.
[[nodiscard]] ModelSpec read_model(const std::string& path,
                                   const std::vector<std::string>& overrides = {});
[[nodiscard]] ModelSpec parse_model(const std::string& toml_text, const std::string& file_name,
                                    const std::vector<std::string>& overrides = {},
                                    const std::string& blocks = "",
                                    const std::map<std::string, std::string>& records = {});
// The model as TOML with every value, defaults included; parse_model(write_model(s)) == s.
[[nodiscard]] std::string write_model(const ModelSpec& spec);
// Hash of a spec: of the text of write_model and of its blocks.
[[nodiscard]] std::uint64_t spec_hash(const ModelSpec& spec);
// The text of `wythe materials NAME`: a typical material or a rule with values, source, range and scatter.
// "" lists both. Throws InputError where the name is neither.
[[nodiscard]] std::string materials_text(const std::string& name);
// Markdown table of all keys: unit, range, default, meaning.
[[nodiscard]] std::string reference_page();
// The same keys as a JSON list, for programs that make models: {path, kind, unit, allowed, default, example,
// meaning}. In a path [] stands for a member of a list and <name> for a name.
[[nodiscard]] std::string keys_json();
// Markdown table of the curve's columns (curve.h), for docs/reference/results.md.
[[nodiscard]] std::string curve_table();
// Markdown table of the responses (responses.h), for docs/reference/results.md.
[[nodiscard]] std::string responses_table();
// Writes all into docs/reference, the tables between the comments that mark them. Writes the responses as a type of
// TypeScript into `headers` (web/src/headers/responses.ts).
void write_reference(const std::string& folder, const std::string& headers);

// Reads a study file (docs/reference/study.md). `overrides` that begin with study., variable., dependent. or
// correlation. change the study, all others its base model. It also reads the base model and files of
// measured values, so that the StudySpec needs no other file. Throws as read_model() does.
[[nodiscard]] StudySpec read_study(const std::string& path,
                                   const std::vector<std::string>& overrides = {});
[[nodiscard]] StudySpec parse_study(const std::string& toml_text, const std::string& file_name,
                                    const std::vector<std::string>& overrides = {});
// The study with base model and measured values as one text; parse_study(write_study(s), s.file) == s.
[[nodiscard]] std::string write_study(const StudySpec& study);
// Whether a file is a study rather than a model: it has a [study] table.
[[nodiscard]] bool is_study(const std::string& path);
// The study of `wythe assess`: `asked` walls of a model, drawn by its [scatter] and fields. Each way of
// ways_of() is a [[variant]] of the first one. Throws InputError with every fault of the model, and where
// nothing scatters.
[[nodiscard]] StudySpec assess_study(const AskedWalls& asked);
// Builds the model of a sample: base model, settings and states of the study, then settings of the sample.
[[nodiscard]] ModelBuilder model_builder(const StudySpec& study);

// Reads LAW.toml of `wythe contact`: one table [material.NAME].
[[nodiscard]] JointMaterial read_law(const std::string& path);
[[nodiscard]] JointMaterial parse_law(const std::string& toml_text, const std::string& file_name);
[[nodiscard]] std::vector<ContactPathRow> read_contact_path(const std::string& path);
// check_answer_file() with the mark of that answer.
void check_contact_answer(const std::string& path, const std::vector<std::string>& inputs);
void write_contact_answer(const std::string& path, const std::vector<ContactPathRow>& rows,
                          const std::vector<ContactAnswer>& answers);

// Replaces the earlier results in a folder, all of them or none. New files go to path(), a hidden
// subfolder; commit() moves them up and removes old files whose names `is_replaced`
// accepts. If the program is killed, the folder holds only old results or only new ones;
// finish_replacement() then moves the rest. IoError where another program writes at the same time.
class Replacement {
 public:
  using Names = std::function<bool(const std::string& name)>;
  Replacement(std::string folder, Names is_replaced);
  ~Replacement();
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  // Calls `at` after each stage, for tests: "results written", "results ready", ...
  void commit(const std::function<void(const char* point)>& at = {});
  // Writes one file into the folder at once: a killed program leaves the old file or the new one.
  void put(const std::string& name, const std::string& bytes,
           const std::function<void(const char* point)>& at = {});

 private:
  std::string folder_, path_;
  Names is_replaced_;
  int lock_ = -1;
};
// Completes the commit() of a program that was killed; does nothing where there is none.
void finish_replacement(const std::string& folder);

// Origin of the results in a folder: a hidden file holds the model's file and the hash of its spec.
struct Origin {
  std::string file;             // of the model, or the folder of its campaign; "": no check
  std::uint64_t spec_hash = 0;  // 0: not known
  bool replaces = false;        // may replace results of another model
};
// Throws InputError where `folder` holds results of another model or campaign (both file and hash differ), or results
// without a record of their origin.
void check_origin(const std::string& folder, const Origin& origin);
// check_origin() for the files of `wythe limit`, which may lie beside those of a run.
void check_limit_folder(const std::string& folder, const Origin& origin);
[[nodiscard]] bool is_file_of_limit(const std::string& name);  // names of its files
// The origin of a comparison of these campaigns.
[[nodiscard]] Origin origin_of(const std::vector<std::string>& folders, bool replaces);
void write_origin(const std::string& folder, const Origin& origin);
// The Replacement for the files of `wythe run` and `replay` in `folder` (made if absent), with their origin. Throws InputError where
// the folder holds other files, results of another model, or the model itself; IoError where it can't be written.
[[nodiscard]] std::unique_ptr<Replacement> replace_run(const std::string& folder,
                                                       const Origin& origin = {},
                                                       bool resumes = false);
// Writes the files of a run into `folder` (made if absent), except report.html; removes nothing.
void write_run(const std::string& folder, const ModelSpec& spec, const Model& model,
               const Result& result);
// What a shake did to the wall, in one sentence.
// Empty where no stage shook it.
[[nodiscard]] Message shaken_sentence(const Model& model, const Result& result);
[[nodiscard]] std::string summary_json(const Model& model, const Result& result);
// summary.json of a run (keys: docs/reference/results.md), with `project` and `assessment` where the model has them.
[[nodiscard]] std::string summary_json(const ModelSpec& spec, const Model& model,
                                       const Result& result);
// samples.csv of a campaign; columns: docs/reference/store.md.
[[nodiscard]] std::string samples_csv(const Campaign& campaign);
// statistics.json of a campaign; keys: docs/reference/statistics.md.
[[nodiscard]] std::string statistics_json(const Statistics& statistics);
// assessment.json and walls.csv of `wythe assess`; keys and columns: docs/reference/assess.md.
[[nodiscard]] std::string verdict_json(const WallsVerdict& verdict);
[[nodiscard]] std::string walls_csv(const WallsVerdict& verdict);
// comparison.json of `wythe compare`; keys: docs/reference/comparison.md.
[[nodiscard]] std::string comparison_json(const PairedComparison& comparison);
// mechanisms.json and mechanism_<name>.csv of `wythe limit`; keys: docs/reference/limit.md.
[[nodiscard]] std::string mechanisms_json(const Model& model, const SecondOpinion& opinion);
[[nodiscard]] std::string mechanism_csv(const CapacityCurve& curve);
// Reads the run, or the answered samples, from a folder of `wythe run` or `wythe campaign`. Throws
// InputError where it holds neither, IoError where its files are damaged.
[[nodiscard]] std::vector<ComparedRun> read_compared_runs(const std::string& folder);
// Counts of an export: CSV tables of a run or a campaign with columns.json (docs/howto/export.md).
struct Exported {
  int samples = 0, missing = 0;       // samples written; samples of the study that did not run
  std::int64_t rows = 0, states = 0;  // rows of all curves; stored states
};
// Writes the tables of the results in `folder` into `out`, an existing empty folder. Throws InputError where
// there are no results, IoError where they are damaged.
Exported write_export(const std::string& folder, const std::string& out);
// The Replacement for exported tables (made if absent). Throws InputError where the folder holds other files, or tables of
// results of another origin.
[[nodiscard]] std::unique_ptr<Replacement> replace_export(const std::string& out,
                                                          const Origin& origin = {});
// Reads a file of packed data, such as report.data. Throws InputError where it is no such file, IoError as read_file().
[[nodiscard]] std::string read_data(const std::string& path);
// Writes a whole file at once, never half a file and never through a link. Throws IoError.
void write_text(const std::string& path, const std::string& text);
// Check before a command writes one file. Throws InputError where `path` is one of its `inputs`, or a file without `mark`
// in its first lines, which is no earlier answer. No file and an empty file are accepted.
void check_answer_file(const std::string& path, const std::vector<std::string>& inputs,
                       const std::string& mark);
// Throws InputError when `folder` holds results of the other kind, whose report would be lost.
enum class FolderFor { kRun, kCampaign };
void check_folder(const std::string& folder, FolderFor use);
// Makes `folder` and checks that it is writable; throws IoError.
void prepare_folder(const std::string& folder);

}  // namespace wythe
