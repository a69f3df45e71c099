// One sample of a campaign: settings -> model -> solve -> failure mode, with one retry.
//
// What it answers depends on the study and the sample's inputs only; campaign and replay both come
// through here.
#pragma once

#include <functional>

#include "wythe/campaign.h"
#include "wythe/solve.h"

namespace wythe::study {

// Stands for solve() so that a test can play an unstable one.
using Solver = std::function<Result(const Model&, State&, const SolveOptions&)>;

struct SampleTask {
  const StudySpec& spec;
  const SampleTable& samples;
  const ModelBuilder& build;
  Solver solver;
};
[[nodiscard]] SampleRun run_task(const SampleTask& task, int sample, const SolveOptions& options);
[[nodiscard]] SampleRecord record_of(const SampleRun& run, const SampleTable& samples, int sample);
// The states a study asks for; where the push ended before the last of them, its end too.
[[nodiscard]] std::vector<Snapshot> asked_states(const StudySpec& spec, const Result& result);

}  // namespace wythe::study
