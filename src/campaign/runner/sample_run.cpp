// An unstable sample is run once more with half the time step; under a record each intensity has this one
// retry. Settings that give no valid model make a refused sample, and the campaign continues. record_of()
// collects the data of a run for the store. A sample with shakes only has shakes instead of responses.
#include "campaign/runner/sample_run.h"

#include <algorithm>
#include <cmath>

#include "campaign/runner/shakes.h"
#include "dynamics/stages/wall_run.h"
#include "wythe/parts/assessment.h"
#include "wythe/parts/error.h"
#include "wythe/parts/failure_mode.h"

namespace wythe {
namespace study {
namespace {

constexpr double kSame = 1e-9;      // displacements closer than this are equal [m]
constexpr double kRetryStep = 0.5;  // of the step that was unstable

// The displacements of requested states, including that of the failure mode, ascending and each once.
std::vector<double> state_displacements(const StudySpec& spec) {
  std::vector<double> all = spec.states;
  if (!std::isnan(spec.read_modes_at)) all.push_back(spec.read_modes_at);
  std::sort(all.begin(), all.end());
  const auto same = [](double a, double b) { return std::fabs(a - b) < kSame; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

bool shakes(const Model& model) {
  return std::any_of(model.stages.begin(), model.stages.end(),
                     [](const Stage& s) { return s.spec.kind() == StageKind::kShake; });
}

}  // namespace

double read_modes_at(const StudySpec& spec) {
  return std::isnan(spec.read_modes_at) ? kReadModesAt : spec.read_modes_at;
}

namespace {

void read_answer(const StudySpec& spec, SampleRun& run) {
  Result& r = run.result;
  if (!spec.fractions.empty()) {
    ResponseOptions read = reading_of(run.model, r);
    read.fractions = spec.fractions;
    r.responses = read_responses(r.curve, read);
  }
  r.failure_mode = name_failure_mode(run.model, r, read_modes_at(spec));
  r.features = read_features(run.model, r);
  if (is_asked(run.spec.assessment)) r.pushed = read_pushed_wall(run.spec, run.model, r);
}

}  // namespace

SampleJob::SampleJob(const SampleTask& task, int sample) : task_(task), sample_(sample) {
  run_.settings = settings_of(task.samples, sample - 1);
  if (task.spec.shaking.is_asked())
    set_intensity(std::isnan(task.only) ? next().value_or(kUnset) : task.only);
  try {
    run_.spec = task.build(run_.settings);
    const std::vector<double> states = state_displacements(task.spec);
    if (!states.empty()) run_.spec.output.states = states;
    build_model();
  } catch (const InputError& error) {
    const std::vector<Fault> why = refusal_of(task.samples, sample - 1, task.build);
    run_.refused = in_one_line(why.empty() ? error.faults() : why);
  }
}

void SampleJob::build_model() {
  const Compiler* compiler = task_.compiler;
  run_.model = compiler == nullptr ? compile(run_.spec) : compiler->compile(run_.spec);
  state_ = initial_state(run_.model);
}

// The intensity is the last one of the settings.
void SampleJob::set_intensity(double intensity) {
  intensity_ = intensity;
  run_.settings.back() = intensity_setting(task_.spec.shaking, intensity);
}

// The next intensity after the shakes that are done, for a study with shakes.
std::optional<double> SampleJob::next() const {
  const ShakingSpec& shaking = task_.spec.shaking;
  if (!shaking.is_asked() || !std::isnan(task_.only)) return std::nullopt;
  const std::size_t record = case_of(task_.spec, sample_ - 1).record;
  return next_intensity(shaking, shaking.record[record], run_.shakes);
}

void SampleJob::note_shake() {
  run_.shakes.push_back(shake_answer(task_.spec.shaking, intensity_, run_.model, run_.result));
  run_.shakes.back().retried = retried_;
}

bool SampleJob::wants_another() {
  if (run_.result.status == SolveStatus::kUnstable && !retried_) {
    run_.spec.solve.step_fraction *= kRetryStep;
    run_.retried = retried_ = true;
    build_model();
    return true;
  }
  if (!shakes(run_.model)) return false;
  note_shake();
  const std::optional<double> another = next();
  if (!another) return false;
  retried_ = false;
  set_intensity(*another);
  try {
    run_.spec = task_.build(run_.settings);
    build_model();
  } catch (const InputError& error) {
    ShakeResult& refused = run_.shakes.emplace_back();
    refused.intensity = *another;
    refused.status = "refused";
    refused.reason = as_text(in_one_line(error.faults()));
    return false;
  }
  return true;
}

SampleRun SampleJob::finish() {
  if (!refused()) read_answer(task_.spec, run_);
  return std::move(run_);
}

SampleRun run_task(const SampleTask& task, int sample, const Solver& solver,
                   const SolveOptions& options) {
  SampleJob job(task, sample);
  SolveOptions how = options;
  how.read_modes_at = read_modes_at(task.spec);
  for (bool go_on = !job.refused(); go_on; go_on = job.wants_another()) {
    Result result = solver(job.model(), job.state(), how);
    job.took(result.wall_seconds);
    job.take(std::move(result));
  }
  return job.finish();
}

SampleRecord record_of(const SampleRun& run, const SampleTable& samples, int sample) {
  const Result& r = run.result;
  SampleRecord record;
  record.sample = sample;
  record.inputs = samples.value[sample - 1];
  record.status = run.refused.empty() ? to_string(r.status) : "refused";
  record.reason = run.refused.empty() ? r.reason : as_text(run.refused);
  record.retried = run.retried;
  record.steps = r.steps;
  record.time_step = r.time_step;
  record.wall_seconds = run.wall_seconds;
  record.curve = r.curve;
  if (!run.refused.empty()) return record;
  record.shakes = run.shakes;
  if (!run.shakes.empty() && !record.has_curve()) {
    sum_up(run.shakes, record);
    record.steps = 0;
    for (const ShakeResult& shake : run.shakes) record.steps += shake.steps;
    return record;
  }
  if (r.status != SolveStatus::kUnstable) record.state_hash = r.state_hash;
  if (!record.answered()) return record;
  record.responses = r.responses;
  record.failure_mode = r.failure_mode;
  record.features = r.features;
  record.events = r.events;
  record.energy = r.energy;
  record.quasi_static = r.quasi_static;
  record.overlap_lost = r.validity.overlap_lost;
  record.pushed = r.pushed;
  if (r.pushed.is_read()) record.rise = r.rise;
  return record;
}

std::vector<Snapshot> asked_states(const StudySpec& spec, const Result& result) {
  const std::vector<double> wanted = state_displacements(spec);
  std::vector<Snapshot> states;
  bool missing = false;
  for (const double displacement : wanted) {
    const auto found = std::find_if(result.states.snapshots.begin(), result.states.snapshots.end(),
                                    [&](const Snapshot& s) { return s.asked == displacement; });
    if (found == result.states.snapshots.end())
      missing = true;
    else
      states.push_back(*found);
  }
  if (missing && !result.states.snapshots.empty() && result.states.snapshots.back().label == "end")
    states.push_back(result.states.snapshots.back());
  return states;
}

}  // namespace study

namespace study {
namespace {
Result solve_alone(const Model& model, State& state, const SolveOptions& how) {
  return dynamics::run_stages(model, state, how);
}
}  // namespace
}  // namespace study

SampleRun run_sample(const StudySpec& study, const SampleTable& samples, int sample,
                     const ModelBuilder& build, const SolveOptions& options) {
  return study::run_task({study, samples, build}, sample, study::solve_alone, options);
}

SampleRun run_shake(const StudySpec& study, const SampleTable& samples, int sample,
                    double intensity, const ModelBuilder& build, const SolveOptions& options) {
  return study::run_task({study, samples, build, nullptr, intensity}, sample, study::solve_alone,
                         options);
}

}  // namespace wythe
