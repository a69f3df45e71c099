// run_batch(): checks the columns against the base model. Then the pool of a campaign
// solves the rows (campaign/runner/sample_pool.h), and the results stay in memory.
#include "wythe/parts/batch.h"

#include <fmt/format.h>

#include <cmath>
#include <mutex>
#include <set>

#include "campaign/runner/sample_pool.h"
#include "io/keys/model_key.h"
#include "units/quantity_error.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/units.h"

namespace wythe {
namespace {

// Finds the key and the unit of each column; collects the faults of all columns and numbers.
class BatchReader {
 public:
  BatchReader(const BatchSpec& batch, const StudySpec& study)
      : batch_(batch), base_(model_builder(study)({})) {}

  [[nodiscard]] SampleTable read() {
    SampleTable table;
    const io::SettableKeys keys(batch_.model_text, batch_.model_file, batch_.settings, base_);
    for (std::size_t i = 0; i < batch_.columns.size(); ++i)
      table.column.push_back(resolve(keys, batch_.columns[i], i));
    for (std::size_t r = 0; r < batch_.rows.size(); ++r) check_row(r);
    faults_.throw_if_any();
    table.value = batch_.rows;
    return table;
  }

 private:
  InputColumn resolve(const io::SettableKeys& keys, const BatchColumn& column, std::size_t i) {
    const io::ModelKey* key = keys.find(column.path);
    if (key == nullptr) {
      fault(column.path, "", "no such number in the model", keys.advice(column.path));
      return {};
    }
    if (const auto [problem, cure] = keys.idle(key->path); !problem.empty())
      fault(column.path, "", problem, cure);
    if (!seen_.insert(key->path).second)
      fault(column.path, "", "stands in two columns", "leave one out");
    std::string unit = column.unit;
    try {
      if (key->si_unit != "1" && unit.empty())
        throw QuantityError("has no unit", fmt::format("write one, e.g. {}", key->unit));
      if (key->si_unit == "1" && !unit.empty() && unit != "1")
        throw QuantityError("is a plain number, without unit", "leave the unit out");
      if (key->si_unit != "1") (void)unit_factor(unit, key->si_unit);
    } catch (const QuantityError& error) {
      fault(column.path, column.unit, error.problem(), error.cure());
    }
    // a number keeps its unit to the last digit, because a row is set as "path=number unit"
    if (key->si_unit == "1") unit = "1";
    return {
        .name = fmt::format("column {}", i), .path = column.path, .si_unit = unit, .unit = unit};
  }

  void check_row(std::size_t r) {
    const std::vector<double>& row = batch_.rows[r];
    if (row.size() != batch_.columns.size())
      return fault(
          fmt::format("row {}", r), std::to_string(row.size()),
          fmt::format("has another number of values than the {} columns", batch_.columns.size()),
          "give one number a column");
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!std::isfinite(row[i]) && bad_numbers_++ < kMostTold)
        fault(fmt::format("row {}, {}", r, batch_.columns[i].path), fmt::format("{}", row[i]),
              "is no finite number", "give a number, or leave the row out");
  }

  void fault(const std::string& path, const std::string& value, const std::string& problem,
             const std::string& cure) {
    faults_.add({.file = "inputs", .path = path, .value = value, .problem = problem, .cure = cure});
  }

  static constexpr int kMostTold = 10;
  const BatchSpec& batch_;
  ModelSpec base_;
  FaultList faults_;
  std::set<std::string> seen_;
  int bad_numbers_ = 0;
};

StudySpec study_of(const BatchSpec& batch) {
  StudySpec study;
  study.name = "batch";
  study.model_text = batch.model_text;
  study.model_file = batch.model_file;
  study.settings = batch.settings;
  study.states = batch.states;
  study.read_modes_at = batch.read_modes_at;
  return study;
}

}  // namespace

std::vector<SampleRecord> run_batch(const BatchSpec& batch, const std::atomic<bool>* stop,
                                    const std::function<void(int, int)>& progress) {
  const StudySpec study = study_of(batch);
  const ModelBuilder build = model_builder(study);
  (void)compile(build({}));
  const SampleTable samples = BatchReader(batch, study).read();
  const Compiler compiler(build({}));
  const int total = samples.n_sample();
  std::vector<SampleRecord> records(total);
  std::atomic<bool> halt{false};
  std::mutex mutex;
  int next = 0, done = 0;
  const auto poll = [&] {
    if (stop != nullptr && *stop) halt = true;
  };
  study::solve_samples({.samples = {study, samples, build, &compiler},
                        .left = total,
                        .jobs = batch.jobs,
                        .halt = halt,
                        .poll = poll,
                        .take =
                            [&] {
                              poll();
                              const std::lock_guard lock(mutex);
                              return halt || next == total ? 0 : ++next;
                            },
                        .keep =
                            [&](study::SampleJob& job) {
                              const int sample = job.sample();
                              SampleRecord record = study::record_of(job.finish(), samples, sample);
                              const std::lock_guard lock(mutex);
                              records[sample - 1] = std::move(record);
                              ++done;
                              if (progress) progress(done, total);
                            }});
  return records;
}

}  // namespace wythe
