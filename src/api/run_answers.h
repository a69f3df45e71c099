// The outputs of a finished run, for the tasks run and replay.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "api/job.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/solve.h"

namespace wythe::api {

// The data for later outputs; kept as long as one of them exists.
struct Done {
  ModelSpec spec;
  Model model;
  Result result;
};

// A column: one number of each row.
template <class Row, class Value>
std::vector<double> each(const std::vector<Row>& rows, const Value& value) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(value(row));
  return values;
}

// Summary, curve, history, states, the model as read, and the page in a language.
void answer_run(Job& job, const std::shared_ptr<const Done>& done, const std::string& language);
// Options from the job: threads, frames, stop and progress.
[[nodiscard]] SolveOptions options_of(Job& job);
// Writes the files of a run, which are then put in place together.
void write_done(const std::string& language, Replacement& results, const Done& done);

}  // namespace wythe::api
