// Tasks about many walls: batch, campaign, results, and replay of one sample.
#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "api/job.h"
#include "api/run_answers.h"
#include "core/limits.h"
#include "io/text/toml_reader.h"
#include "wythe/parts/batch.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/io.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/slow_push.h"

namespace wythe::api {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& path, const std::string& value,
                         const std::string& problem, const std::string& cure) {
  throw InputError({{.path = path, .value = value, .problem = problem, .cure = cure}});
}

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Numbers of the results, one row for each record: NaN where a record has no answer.
Table answers_of(const std::vector<SampleRecord>& records) {
  Table table;
  SampleRecord none;
  each_response(
      [&](const OutputKey& key, const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, bool>)
          if (key.listed != OutputKey::kNowhere) table.add(key.column, {});
      },
      none.responses);
  for (const SampleRecord& record : records) {
    std::size_t c = 0;
    each_response(
        [&](const OutputKey& key, const auto& value) {
          using Value = std::decay_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, bool>)
            if (key.listed != OutputKey::kNowhere)
              table.value[c++].push_back(record.answered() ? key.to_unit * value : kNoNumber);
        },
        record.responses);
  }
  return table;
}

// Why a record ended, or why one that completed has no capacity; and why it has no stiffness.
std::string reason_of(const SampleRecord& record) {
  if (!record.answered()) return text_of(record.reason);
  const std::string ended =
      text_of(record.reason.empty() ? record.responses.peak_reason : record.reason);
  const std::string stiffness = text_of(why_no_stiffness(record.responses));
  return ended + (ended.empty() || stiffness.empty() ? "" : "; ") + stiffness;
}

// Words of the results, one row for each record.
std::string rows_of(const std::vector<SampleRecord>& records) {
  Json rows = Json::array();
  for (const SampleRecord& record : records) {
    Json row = {{"status", record.status}, {"state_hash", record.state_hash}};
    if (record.answered()) row["failure_mode"] = record.failure_mode.name;
    if (record.answered()) row["rate_judgement"] = record.quasi_static.judgement;
    if (const std::string why = reason_of(record); !why.empty()) row["reason"] = why;
    if (record.retried) row["retried"] = true;
    if (record.sample > 0) row["sample"] = record.sample;
    rows.push_back(std::move(row));
  }
  return dumped(rows);
}

// All curves below each other; `row` is the number of the record, from 0.
Table curves_of(const std::vector<SampleRecord>& records) {
  Table table;
  std::vector<double> row;
  std::vector<std::vector<double>> value(std::size(kCurveColumns));
  for (std::size_t r = 0; r < records.size(); ++r)
    for (const CurveRow& at : records[r].curve) {
      row.push_back(static_cast<double>(r));
      for (std::size_t c = 0; c < value.size(); ++c)
        value[c].push_back(at.*kCurveColumns[c].value * kCurveColumns[c].to_unit);
    }
  table.add("row", std::move(row));
  for (std::size_t c = 0; c < value.size(); ++c)
    table.add(kCurveColumns[c].name, std::move(value[c]));
  return table;
}

std::string file_text(const std::string& path) { return io::read_input(path, "model.toml"); }

BatchSpec batch_of(const Inputs& in) {
  BatchSpec batch;
  batch.model_file = in.one("file", "model.toml");
  if (!in.has("model") && !in.has("file"))
    refuse("model", "", "is missing", "give the TOML as the text `model`, or a path as `file`");
  batch.model_text = in.has("model") ? in.one("model") : file_text(batch.model_file);
  batch.settings = in.all("set");
  const std::vector<std::string> paths = in.all("path"), units = in.all("unit");
  if (paths.size() != units.size())
    refuse("unit", std::to_string(units.size()),
           fmt::format("must be as many as the {} paths", paths.size()),
           "give a unit for each path, \"\" for a plain number");
  std::size_t rows = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    batch.columns.push_back({paths[i], units[i]});
    const auto column = in.column.find(fmt::format("input {}", i));
    if (column == in.column.end())
      refuse(fmt::format("input {}", i), "", "is missing", "give a column for each path");
    if (i == 0) rows = column->second.size();
    if (column->second.size() != rows)
      refuse(paths[i], std::to_string(column->second.size()),
             fmt::format("has another number of rows than {}, which has {}", paths[0], rows),
             "give all columns the same length");
  }
  if (in.column.size() != paths.size())
    refuse("input", std::to_string(in.column.size()), "there are more columns than paths",
           "give a path for each column");
  batch.rows.assign(rows, std::vector<double>(paths.size()));
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t r = 0; r < rows; ++r)
      batch.rows[r][i] = in.column.at(fmt::format("input {}", i))[r];
  batch.jobs = in.cores("jobs", 0);
  return batch;
}

StudySpec study_of(const Inputs& in, const std::string& out, bool resume) {
  std::vector<std::string> settings = in.all("set");
  for (const char* key : {"samples", "seed"})
    if (in.number.contains(key))
      settings.push_back(fmt::format("study.{}={}", key, in.integer(key, 0, 0, 1 << 30)));
  if (in.has("until")) settings.push_back("study.until=" + in.one("until"));
  const std::string file = in.one("file", "study.toml");
  StudySpec study =
      in.has("study") ? parse_study(in.one("study"), file, settings) : read_study(file, settings);
  if (!study.option.empty())
    refuse("variant", "", "a study with [[variant]] is several campaigns",
           "run it by the program: wythe campaign STUDY.toml --out DIR");
  if (resume && !in.number.contains("samples") && holds_campaign(out))
    study.batch = stored_batches(out);
  return study;
}

void answer_campaign(Job& job, const std::string& folder, const Campaign& campaign,
                     const Statistics& statistics) {
  job.out.put("statistics", statistics_json(statistics));
  job.out.put("samples_csv", samples_csv(campaign));
  job.out.put("rows", rows_of(campaign.records));
  Table inputs;
  std::vector<double> numbers;
  for (const SampleRecord& record : campaign.records) numbers.push_back(record.sample);
  inputs.add("sample", numbers);
  for (std::size_t c = 0; c < campaign.samples.column.size(); ++c) {
    const InputColumn& column = campaign.samples.column[c];
    std::vector<double> values;
    for (const SampleRecord& record : campaign.records)
      values.push_back(record.inputs[c] * column.to_unit + column.offset);
    inputs.add(column_title(column), std::move(values));
  }
  job.out.put("inputs", std::move(inputs));
  job.out.put("answers", answers_of(campaign.records));
  job.out.table_later("curves", [folder] { return curves_of(read_campaign(folder).records); });
}

bool do_batch(Job& job) {
  job.in.check("batch", {"model", "file", "set", "path", "unit"},
               {"jobs", "curves", "read_modes_at_mm"}, true);
  BatchSpec batch = batch_of(job.in);
  batch.read_modes_at = 1e-3 * job.in.real("read_modes_at_mm", kUnset);
  const std::vector<SampleRecord> records = run_batch(batch, &job.stop, [&](int done, int total) {
    job.progress(fmt::format("{} of {} rows", done, total), double(done) / total, 0, 0);
  });
  job.out.put("answers", answers_of(records));
  job.out.put("rows", rows_of(records));
  if (job.in.real("curves", 0) != 0) job.out.put("curves", curves_of(records));
  for (const SampleRecord& record : records)
    if (record.status.empty()) return true;
  return false;
}

bool do_campaign(Job& job) {
  job.in.check("campaign", {"study", "file", "set", "out", "until", "language"},
               {"samples", "seed", "jobs", "resume", "shard", "shards"}, false);
  const Inputs& in = job.in;
  const std::string out = in.out_folder(), language = in.one("language", "en");
  check_language(language, "language");
  if (!in.has("study") && !in.has("file"))
    refuse("study", "", "is missing", "give the TOML as the text `study`, or a path as `file`");
  if (out.empty()) refuse("out", "", "is missing", "name the folder of the campaign");
  CampaignOptions options;
  options.resume = in.real("resume", 0) != 0;
  options.jobs = in.cores("jobs", 0);
  options.shards = in.integer("shards", 1, 1, 1 << 20);
  options.shard = in.integer("shard", 1, 1, options.shards);
  options.stop = &job.stop;
  options.provenance = provenance_text();
  const StudySpec study = study_of(in, out, options.resume);
  check_folder(out, FolderFor::kCampaign);
  const CampaignOutcome outcome =
      run_campaign(study, model_builder(study), out, options, [&](const CampaignProgress& p) {
        job.progress(fmt::format("{} of {} samples", p.done, p.total),
                     p.total > 0 ? double(p.done) / p.total : 1, 0, 0);
      });
  const Campaign campaign = read_campaign(out);
  answer_campaign(job, out, campaign, write_campaign_files(out, campaign, language));
  Json notes = Json::array();
  for (const Message& note : outcome.notes) notes.push_back(text_of(note));
  job.out.put("outcome", dumped({{"done", outcome.done},
                                 {"total", outcome.total},
                                 {"precise_at", outcome.precise_at},
                                 {"until", text_of(outcome.until_state)},
                                 {"notes", notes}}));
  return outcome.interrupted;
}

bool do_results(Job& job) {
  job.in.check("results", {"folder"}, {}, false);
  const std::string folder = job.in.one("folder");
  if (folder.empty()) refuse("folder", "", "is missing", "name the folder of a campaign");
  const Campaign campaign = read_campaign(folder);
  answer_campaign(job, folder, campaign, full_statistics(campaign));
  job.out.text_later("study", [study = campaign.study] { return write_study(study); });
  return false;
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

}  // namespace

const Tasks& study_tasks() {
  static const Tasks kTasks = {{"batch", do_batch},
                               {"campaign", do_campaign},
                               {"results", do_results},
                               {"replay", do_replay}};
  return kTasks;
}

}  // namespace wythe::api
