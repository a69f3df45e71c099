// A campaign: runs the samples of a study on all cores, stores the results, reads them again.
//
//   run_campaign(study) -> DIR/campaign.db (SQLite) -> read_campaign -> statistics, samples.csv
//
// Each sample is one transaction: if the program is killed, only the samples that were running are
// lost. The result of a sample depends only on its inputs, never on jobs, order, shard or resume.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wythe/parts/pushed_wall.h"
#include "wythe/parts/result.h"
#include "wythe/parts/study.h"

namespace wythe {

struct SolveOptions;

// What one shake of a sample answered. NaN: not known, since the run did not end as one that counts.
struct ShakeResult {
  double intensity = kUnset;  // asked for, in the study's measure [SI]; NaN: as the model says
  std::string status;         // a SolveStatus in words, or "refused"
  Message reason;
  bool retried = false;
  // Of the first component as applied [m/s^2], [m/s], [m/s^2]; sa where the study has a period.
  double pga = kUnset, pgv = kUnset, sa = kUnset;
  // Of the control point: the first of [[history]], or the highest block [-], [m].
  double peak_drift = kUnset, residual_drift = kUnset;
  double peak_displacement = kUnset, residual_displacement = kUnset;
  double uplift = kUnset, slip = kUnset;  // largest opening and slip of any joint [m]
  double peak_base_shear = kUnset;        // [N]
  bool collapsed = false;                 // while it was shaken
  double collapse_time = kUnset;          // since the shake began [s]
  double gap_ratio = kUnset;              // of the energy ledger
  std::int64_t steps = 0;
  double time_step = 0;  // [s]
  std::string state_hash;
  // Whether it says that the wall stood or fell: it ended so, while it was shaken, and its energy ledger
  // closes (kMostEnergyGap).
  [[nodiscard]] bool counts() const;
};
// A gap of the energy ledger, as a share of the energy, beyond which no answer is taken from a shake.
inline constexpr double kMostEnergyGap = 0.01;

// The result of one sample. `status` is a SolveStatus in words, or "refused" (its inputs are not
// admissible: the reason says which and why), or "" while it has not run.
struct SampleRecord {
  int sample = 0;              // 1-based, as users count
  std::vector<double> inputs;  // (n_column) [SI]
  std::string status;
  Message reason;
  bool retried = false;  // with half the step, after `unstable`
  Responses responses;
  FailureMode failure_mode;
  std::vector<Feature> features;
  std::vector<Event> events;
  EnergyLedger energy;
  RateVerdict quasi_static;
  std::vector<CurveRow> curve;
  // Of what an assessment asks beside these; read where the model asks for one.
  PushedWall pushed;
  std::vector<RisePoint> rise;
  double overlap_lost = kUnset;     // Validity::overlap_lost [m]
  std::vector<ShakeResult> shakes;  // in the order they ran; empty where nothing is shaken
  std::int64_t steps = 0;
  double time_step = 0;     // [s]
  double wall_seconds = 0;  // of one core, all tries and shakes; no result: not in samples.csv
  std::string state_hash;
  std::string provenance;  // of the program that ran this sample
  [[nodiscard]] bool has_curve() const { return curve.size() > 1; }  // the first row is its start
  // Whether responses and failure mode are results; otherwise `reason` says why there are none. A
  // wall that collapsed before the push has no curve and no results.
  [[nodiscard]] bool answered() const {
    return has_curve() && (status == "completed" || status == "collapsed");
  }
};

struct CampaignOptions {
  int jobs = 0;                             // samples at once; 0: one per core
  bool resume = false;                      // go on with what the folder's store holds
  int shard = 1, shards = 1;                // this process does samples shard, shard + shards, ...
  int last = 0;                             // no sample beyond this one; 0: all
  const std::atomic<bool>* stop = nullptr;  // true: stop now, drop unfinished samples
  std::string provenance = {};              // version, commit, compiler, flags
};

struct CampaignProgress {
  int done = 0, total = 0, running = 0;
  double seconds = 0;        // since the start
  double rate = 0;           // samples a second since the start
  double seconds_left = -1;  // estimate, < 0: not known yet
  const SampleRecord* last = nullptr;
};

struct CampaignOutcome {
  int done = 0, total = 0;  // of this shard
  bool interrupted = false;
  int precise_at = 0;          // number of samples at which the study's `until` was met; 0: not met
  Message until_state;         // the rule's measures
  std::vector<Message> notes;  // for the user, e.g. an unfinished design
};

// Runs the samples that the store in `folder` does not hold yet. With `resume`, a study of more
// samples than the store adds a batch. Throws InputError (changed study on resume: says what changed),
// IoError (locked, damaged or newer store, full disk).
CampaignOutcome run_campaign(const StudySpec& study, const ModelBuilder& build,
                             const std::string& folder, const CampaignOptions& options,
                             const std::function<void(const CampaignProgress&)>& progress = {});

// The content of a store except the stored states; samples in order.
struct Campaign {
  StudySpec study;
  SampleTable samples;
  std::vector<SampleRecord> records;  // those that ran, by sample number
  double load_height = 0;             // for drift [m]
  std::string provenance;
};
[[nodiscard]] bool holds_campaign(const std::string& folder);
// Sizes of the designs a store holds.
[[nodiscard]] std::vector<int> stored_batches(const std::string& folder);
[[nodiscard]] StudySpec read_study_of(const std::string& folder);  // of a store
[[nodiscard]] Campaign read_campaign(const std::string& folder);
// The same with a few records at a time, in order, for stores larger than memory: `take` is called with
// each, and with the campaign without any. Returns that campaign.
Campaign read_campaign(const std::string& folder,
                       const std::function<void(const Campaign&, const SampleRecord&)>& take);
// Stored states of one sample, `model` being its wall (single precision, without velocities, for
// pictures).
[[nodiscard]] std::vector<Snapshot> read_states(const std::string& folder, int sample,
                                                const Model& model);
// How far a store is: read without its results.
struct StoreProgress {
  int done = 0, total = 0;  // of its shard, or where `until` was met
  int failed = 0;           // of those done: without an answer
  int samples = 0;          // of the whole design
  int shard = 1, shards = 1;
  double seconds = 0;  // that they took, all together
  std::string writer;  // the process that writes there; "": none
  std::string study;   // checksum of what makes its samples: that of all shards of a campaign
};
[[nodiscard]] StoreProgress campaign_progress(const std::string& folder);
// Joins shards or campaigns of one study; the result equals that of the undivided campaign. `out` may hold one
// already: it takes the others in. A sample that several hold must be equal to the bit in all (InputError).
void merge_campaigns(const std::vector<std::string>& folders, const std::string& out);

// Reads every byte of a store, its states too; IoError says what is damaged first.
void check_campaign(const std::string& folder);

// One sample alone, as the campaign runs it: the same bits, with every state.
struct SampleRun {
  std::string refused;  // why it was not run; "": it was
  std::vector<std::string> settings;
  ModelSpec spec;
  Model model;
  Result result;  // of the last shake, where there are several
  bool retried = false;
  std::vector<ShakeResult> shakes;
  double wall_seconds = 0;  // of all tries and shakes
};
[[nodiscard]] SampleRun run_sample(const StudySpec& study, const SampleTable& samples, int sample,
                                   const ModelBuilder& build, const SolveOptions& options);
// One shake of a sample alone, at this intensity [SI].
[[nodiscard]] SampleRun run_shake(const StudySpec& study, const SampleTable& samples, int sample,
                                  double intensity, const ModelBuilder& build,
                                  const SolveOptions& options);

// How many shakes a study asks for: at least and at most; what ends them is a result.
struct ShakeCount {
  int least = 0, most = 0;
};
[[nodiscard]] ShakeCount count_shakes(const StudySpec& study);

// "tensile_strength_MPa": name and unit of an input, its column title in samples.csv and the store.
[[nodiscard]] std::string column_title(const InputColumn& column);

}  // namespace wythe
