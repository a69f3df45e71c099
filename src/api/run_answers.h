// The answers of a finished run, for the tasks run and replay.
#pragma once

#include <memory>
#include <string>

#include "api/job.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/solve.h"

namespace wythe::api {

// What later answers are made from; kept as long as one of them is.
struct Done {
  ModelSpec spec;
  Model model;
  Result result;
};

// Summary, curve, history, states, the model as it was read, and the page in a language.
void answer_run(Job& job, const std::shared_ptr<const Done>& done, const std::string& language);
// Threads and frames as the job asks; its stop and its progress.
[[nodiscard]] SolveOptions options_of(Job& job);
// The files of a run, put in place together.
void write_done(const std::string& language, Replacement& results, const Done& done);

}  // namespace wythe::api
