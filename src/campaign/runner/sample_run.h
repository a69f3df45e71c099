// One sample of a campaign: settings -> model -> solve -> failure mode, with one retry.
//
// Its result depends on the study and the sample's inputs alone; campaign and replay both use it.
#pragma once

#include <functional>
#include <optional>

#include "model/compiler.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/solve.h"

namespace wythe::study {

struct SampleTask {
  const StudySpec& spec;
  const SampleTable& samples;
  const ModelBuilder& build;
  const Compiler* compiler = nullptr;  // of the base model, for many samples; nullptr: compile()
  double only = kUnset;                // the only intensity to run for a sample under a record [SI]
};

// A sample under way, so that several can be solved side by side:
//
//   SampleJob job(task, sample);
//   for (bool go_on = !job.refused(); go_on; go_on = job.wants_another())
//     job.take(solve(job.model(), job.state(), options));
//   SampleRun run = job.finish();
class SampleJob {
 public:
  SampleJob(const SampleTask& task, int sample);
  SampleJob(const SampleJob&) = delete;
  SampleJob& operator=(const SampleJob&) = delete;

  [[nodiscard]] int sample() const { return sample_; }
  [[nodiscard]] bool refused() const { return !run_.refused.empty(); }
  [[nodiscard]] const Model& model() const { return run_.model; }
  [[nodiscard]] State& state() { return state_; }
  void take(Result result) { run_.result = std::move(result); }
  // Adds to its time: core time where several samples share a core, else clock time.
  void took(double seconds) { run_.wall_seconds += seconds; }
  // True if there is another run: with half the time step after a
  // first unstable result, or with the next intensity of its record.
  [[nodiscard]] bool wants_another();
  // Evaluates the failure mode; call once.
  [[nodiscard]] SampleRun finish();

 private:
  void build_model();
  void set_intensity(double intensity);
  [[nodiscard]] std::optional<double> next() const;
  void note_shake();

  SampleTask task_;
  int sample_;
  double intensity_ = kUnset;  // of the shake under way
  bool retried_ = false;       // whether the present shake was retried
  SampleRun run_;
  State state_;
};

// Displacement at which a study evaluates failure modes, given or by default [m].
[[nodiscard]] double read_modes_at(const StudySpec& spec);

// A replacement for solve(), with which tests simulate an unstable run.
using Solver = std::function<Result(const Model&, State&, const SolveOptions&)>;
[[nodiscard]] SampleRun run_task(const SampleTask& task, int sample, const Solver& solver,
                                 const SolveOptions& options);
[[nodiscard]] SampleRecord record_of(const SampleRun& run, const SampleTable& samples, int sample);
// The states that a study asks for, and the end if the push ended before the last of them.
[[nodiscard]] std::vector<Snapshot> asked_states(const StudySpec& spec, const Result& result);

}  // namespace wythe::study
