// Files in and out: model TOML, blocks JSON, contact law and path, the files of `wythe run`.
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

// `overrides` are the "path=value" texts of --set. The value is TOML, quotes may be left out; members
// of a list are given by name or by index: stage.push.velocity=1 mm/s, stage.2.velocity=1 mm/s.
// `blocks` is the content of the blocks file, `records` those of record files by their name in the model; where
// there is none the file itself is read.
// Throws IoError when the file can't be read, InputError with every fault otherwise.
[[nodiscard]] ModelSpec read_model(const std::string& path,
                                   const std::vector<std::string>& overrides = {});
[[nodiscard]] ModelSpec parse_model(const std::string& toml_text, const std::string& file_name,
                                    const std::vector<std::string>& overrides = {},
                                    const std::string& blocks = "",
                                    const std::map<std::string, std::string>& records = {});
// compile() of a spec that was read from `toml_text` with `overrides`; its faults name file and line.
[[nodiscard]] Model compile_model(const ModelSpec& spec, const std::string& toml_text,
                                  const std::string& file_name,
                                  const std::vector<std::string>& overrides = {});
// Reads and compiles a model file; the spec is also written to `spec` unless that is null.
[[nodiscard]] Model read_and_compile(const std::string& path,
                                     const std::vector<std::string>& overrides = {},
                                     ModelSpec* spec = nullptr);
// Throws the faults of such a spec, each with file and line of its key.
[[noreturn]] void throw_with_lines(const InputError& error, const ModelSpec& spec,
                                   const std::string& toml_text, const std::string& file_name,
                                   const std::vector<std::string>& overrides = {});
// Every key with its value, defaults included; parse_model(write_model(s)) == s.
[[nodiscard]] std::string write_model(const ModelSpec& spec);
// Identifies a spec: hash of the text of write_model and of its blocks.
[[nodiscard]] std::uint64_t spec_hash(const ModelSpec& spec);
// What `wythe materials NAME` prints: a typical material or a rule with values, source, range and scatter;
// "": the list of both. Throws InputError where the name is neither.
[[nodiscard]] std::string materials_text(const std::string& name);
// Markdown table of all keys: unit, range, default, meaning.
[[nodiscard]] std::string reference_page();
// The same keys as a JSON list, for programs that build models: {path, kind, unit, allowed, default, example,
// meaning}. In a path [] stands for the members of a list and <name> for a name.
[[nodiscard]] std::string keys_json();
// Markdown table of the curve's columns (curve.h), for docs/reference/results.md.
[[nodiscard]] std::string curve_table();
// The same of the responses (responses.h).
[[nodiscard]] std::string responses_table();
// All into docs/reference; the tables between the comments that mark it.
void write_reference(const std::string& folder);

// Study files (docs/reference/study.md). `overrides` that begin with study., variable., dependent. or
// correlation. change the study, all others its base model. The base model and files of measured
// values are read too, so that the StudySpec needs no other file. Throws as read_model does.
[[nodiscard]] StudySpec read_study(const std::string& path,
                                   const std::vector<std::string>& overrides = {});
[[nodiscard]] StudySpec parse_study(const std::string& toml_text, const std::string& file_name,
                                    const std::vector<std::string>& overrides = {});
// The study as one text, with base model and measured values; parse_study(write_study(s), s.file) == s.
[[nodiscard]] std::string write_study(const StudySpec& study);
// Whether a file is a study rather than a model: it has a [study] table.
[[nodiscard]] bool is_study(const std::string& path);
// The study of `wythe assess`: so many walls of a model file, drawn by its [scatter] and fields, and each way
// of ways_of() as a [[variant]] of the first one. Throws InputError with every fault of the model, and where
// nothing scatters.
[[nodiscard]] StudySpec assess_study(const AskedWalls& asked);
// Makes a sample's model: base model, the study's settings and states, then the sample's settings.
[[nodiscard]] ModelBuilder model_builder(const StudySpec& study);

// LAW.toml of `wythe contact`: one [material.<any>] table (usually joint).
[[nodiscard]] JointMaterial read_law(const std::string& path);
[[nodiscard]] JointMaterial parse_law(const std::string& toml_text, const std::string& file_name);
[[nodiscard]] std::vector<ContactPathRow> read_contact_path(const std::string& path);
// As check_answer_file() for that answer.
void check_contact_answer(const std::string& path, const std::vector<std::string>& inputs);
void write_contact_answer(const std::string& path, const std::vector<ContactPathRow>& rows,
                          const std::vector<ContactAnswer>& answers);

// Replaces the earlier results in a folder, all of them or none. New files are written to path(), a
// hidden folder inside; commit() moves them up and removes the old files whose names `is_replaced`
// accepts. If the program is killed at any time, the folder holds old results only, or new ones only;
// finish_replacement() then moves the rest. One program at a time: IoError where another one writes.
class Replacement {
 public:
  using Names = std::function<bool(const std::string& name)>;
  Replacement(std::string folder, Names is_replaced);
  ~Replacement();
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  // `at` is called at each point on the way, for tests: "results written", "results ready", ...
  void commit(const std::function<void(const char* point)>& at = {});
  // Puts one file into the folder at once: if the program is killed, the old one or the new one is there.
  void put(const std::string& name, const std::string& bytes,
           const std::function<void(const char* point)>& at = {});

 private:
  std::string folder_, path_;
  Names is_replaced_;
  int lock_ = -1;
};
// Finishes the commit of a program that was killed; does nothing where there is none.
void finish_replacement(const std::string& folder);

// Whose results a folder holds: a hidden file beside them names the model's file and the hash of its spec.
struct Origin {
  std::string file;  // of the model, or the folder of its campaign; "": none, asks nothing
  std::uint64_t spec_hash = 0;  // 0: not known
  bool replaces = false;        // results of another model too
};
// Throws InputError where `folder` holds results of another model or campaign: of another file, and with another
// hash.
void check_origin(const std::string& folder, const Origin& origin);
// The same for the files of `wythe limit`, which lie alone in a folder or beside those of a run.
void check_limit_folder(const std::string& folder, const Origin& origin);
[[nodiscard]] bool is_file_of_limit(const std::string& name);
// Of a comparison of these campaigns.
[[nodiscard]] Origin origin_of(const std::vector<std::string>& folders, bool replaces);
void write_origin(const std::string& folder, const Origin& origin);
// The Replacement for the files of `wythe run` and `replay` in `folder` (made if absent), with their origin. Throws
// InputError where the folder holds anything else, results of another model, or the model itself; IoError where it can't be written.
[[nodiscard]] std::unique_ptr<Replacement> replace_run(const std::string& folder,
                                                       const Origin& origin = {},
                                                       bool resumes = false);
// Writes the files of a run into `folder` (made if absent), all but report.html; removes nothing.
void write_run(const std::string& folder, const ModelSpec& spec, const Model& model,
               const Result& result);
// summary.json of a run; keys: docs/reference/results.md.
// What a shake did to the wall, in one sentence; empty where nothing shook it.
[[nodiscard]] Message shaken_sentence(const Model& model, const Result& result);
[[nodiscard]] std::string summary_json(const Model& model, const Result& result);
// The same with `project` and `assessment`, where the model file asks for them.
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
// The run, or the samples that answered, in a folder of `wythe run` or `wythe campaign`. Throws
// InputError when it holds neither, IoError when its files are damaged.
[[nodiscard]] std::vector<ComparedRun> read_compared_runs(const std::string& folder);
// A run or a campaign as CSV tables and columns.json (docs/howto/export.md).
struct Exported {
  int samples = 0, missing = 0;       // written; of the study, not run
  std::int64_t rows = 0, states = 0;  // of all curves; stored states
};
// Writes the tables of the results in `folder` into `out`, which is there and empty. Throws InputError where
// there are no results, IoError where they are damaged.
Exported write_export(const std::string& folder, const std::string& out);
// The Replacement for these tables (made if absent). Throws InputError where it holds anything else, or tables of
// other results than those of `origin`.
[[nodiscard]] std::unique_ptr<Replacement> replace_export(const std::string& out,
                                                          const Origin& origin = {});
// Content of a file of packed data, e.g. report.data; throws InputError where it can be none, and IoError.
[[nodiscard]] std::string read_data(const std::string& path);
// Writes a whole file at once or throws IoError; never leaves half a file, never follows a link.
void write_text(const std::string& path, const std::string& text);
// For a command that writes one file: throws InputError where `path` is one of its `inputs`, or a file that does
// not begin as an earlier answer of it does, with `mark` in its first lines. Nothing there is fine, an empty file too.
void check_answer_file(const std::string& path, const std::vector<std::string>& inputs,
                       const std::string& mark);
// Throws InputError when `folder` holds results of another kind, since their report would be lost.
enum class FolderFor { kRun, kCampaign };
void check_folder(const std::string& folder, FolderFor use);
// Makes `folder` and checks that results can be written into it; throws IoError.
void prepare_folder(const std::string& folder);

}  // namespace wythe
