// A campaign: it runs the samples of a study on all cores, stores the results and reads them again.
//
//   run_campaign(study) -> DIR/campaign.db (SQLite) -> read_campaign -> statistics, samples.csv
//
// Each sample is one transaction: if the program is killed, only the samples under way are
// lost. The result of a sample depends on its inputs alone, never on jobs, order, shard or resume.
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

// Result of one shake of a sample. NaN: not known, since the run did not end in a way that counts.
struct ShakeResult {
  double intensity = kUnset;  // in the study's measure [SI]; NaN: as the model states
  std::string status;         // a SolveStatus in words, or "refused"
  Message reason;
  bool retried = false;
  // Intensities of the first component as applied [m/s^2], [m/s], [m/s^2]; sa where the study states a period.
  double pga = kUnset, pgv = kUnset, sa = kUnset;
  // Drifts of the control point, the first of [[history]] or the highest block [-]; displacements [m].
  double peak_drift = kUnset, residual_drift = kUnset;
  double peak_displacement = kUnset, residual_displacement = kUnset;
  double uplift = kUnset, slip = kUnset;  // largest opening and slip of any joint [m]
  double peak_base_shear = kUnset;        // [N]
  bool collapsed = false;                 // during the shake
  double collapse_time = kUnset;          // time since the shake began [s]
  double gap_ratio = kUnset;              // of the energy ledger
  std::int64_t steps = 0;
  double time_step = 0;  // [s]
  std::string state_hash;
  // Whether the run shows that the wall stood or fell: it completed, or it collapsed during the shake; and its energy
  // ledger closes (kMostEnergyGap).
  [[nodiscard]] bool counts() const;
};
// Largest gap of the energy ledger, as a share of the energy, with which a shake still counts.
inline constexpr double kMostEnergyGap = 0.01;

// The result of one sample. `status` is a word of SolveStatus, or "refused" where its inputs are not
// admissible (the reason names them), or "" where it has not run.
struct SampleRecord {
  int sample = 0;              // counted from 1, as users do
  std::vector<double> inputs;  // (n_column) [SI]
  std::string status;
  Message reason;
  bool retried = false;  // ran again with half the step, after `unstable`
  Responses responses;
  FailureMode failure_mode;
  std::vector<Feature> features;
  std::vector<Event> events;
  EnergyLedger energy;
  RateVerdict quasi_static;
  std::vector<CurveRow> curve;
  // States for an assessment; read where the model asks for one.
  PushedWall pushed;
  std::vector<RisePoint> rise;
  double overlap_lost = kUnset;     // Validity::overlap_lost [m]
  std::vector<ShakeResult> shakes;  // in the order in which they ran; empty without shakes
  std::int64_t steps = 0;
  double time_step = 0;     // [s]
  double wall_seconds = 0;  // of one core, all tries and shakes; not in samples.csv
  std::string state_hash;
  std::string provenance;  // the program that ran this sample
  [[nodiscard]] bool has_curve() const { return curve.size() > 1; }  // row 0 is the start
  // Whether responses and failure mode are results; otherwise `reason` says why there are none. A
  // wall that collapsed before the push has neither curve nor results.
  [[nodiscard]] bool answered() const {
    return has_curve() && (status == "completed" || status == "collapsed");
  }
};

struct CampaignOptions {
  int jobs = 0;                             // samples at once; 0: one per core
  bool resume = false;                      // continue with the samples that the store holds
  int shard = 1, shards = 1;                // this process runs samples shard, shard + shards, ...
  int last = 0;                             // the last sample to run; 0: all
  const std::atomic<bool>* stop = nullptr;  // true: stop now and drop unfinished samples
  std::string provenance = {};              // version, commit, compiler, flags
};

struct CampaignProgress {
  int done = 0, total = 0, running = 0;
  double seconds = 0;        // since the start
  double rate = 0;           // samples per second since the start
  double seconds_left = -1;  // estimate; < 0: not known yet
  const SampleRecord* last = nullptr;
};

struct CampaignOutcome {
  int done = 0, total = 0;  // of this shard
  bool interrupted = false;
  int precise_at = 0;          // number of samples that met the study's `until`; 0: not met
  Message until_state;         // measures of that rule
  std::vector<Message> notes;  // for the user, e.g. an unfinished design
};

// Runs the samples that the store in `folder` does not hold yet. With `resume` a study with more
// samples than the store adds a batch. Throws InputError (study changed since: names the difference),
// IoError (store locked, damaged or of a newer version, or disk full).
CampaignOutcome run_campaign(const StudySpec& study, const ModelBuilder& build,
                             const std::string& folder, const CampaignOptions& options,
                             const std::function<void(const CampaignProgress&)>& progress = {});

// The content of a store without the stored states; samples are in order.
struct Campaign {
  StudySpec study;
  SampleTable samples;
  std::vector<SampleRecord> records;  // of the samples that ran, in order
  double load_height = 0;             // for drift [m]
  std::string provenance;
};
[[nodiscard]] bool holds_campaign(const std::string& folder);  // whether it has a store
// Sizes of the designs in a store, one for each batch.
[[nodiscard]] std::vector<int> stored_batches(const std::string& folder);
[[nodiscard]] StudySpec read_study_of(const std::string& folder);  // of a store
[[nodiscard]] Campaign read_campaign(const std::string& folder);   // throws InputError, IoError
// Reads a store larger than memory: calls `take` with a few records at a time, in order, and with the
// campaign without records. Returns that campaign.
Campaign read_campaign(const std::string& folder,
                       const std::function<void(const Campaign&, const SampleRecord&)>& take);
// Stored states of one sample; `model` is its wall. They are for pictures: single precision, without
// velocities.
[[nodiscard]] std::vector<Snapshot> read_states(const std::string& folder, int sample,
                                                const Model& model);
// Progress of a store, read without its results.
struct StoreProgress {
  int done = 0, total = 0;  // of its shard, or up to where `until` was met
  int failed = 0;           // done but without an answer
  int samples = 0;          // of the whole design
  int shard = 1, shards = 1;
  double seconds = 0;  // sum over the samples done
  std::string writer;  // the process that writes the store; "": none
  std::string study;   // checksum of the study; equal in all shards of a campaign
};
[[nodiscard]] StoreProgress campaign_progress(const std::string& folder);
// Merges shards or campaigns of one study; the result equals that of the undivided campaign. If `out` holds a campaign
// already, the others are added to it. A sample in several stores must have equal bits in all (InputError).
void merge_campaigns(const std::vector<std::string>& folders, const std::string& out);

// Reads every byte of a store, including its states. Throws IoError that names the first damage.
void check_campaign(const std::string& folder);

// One sample alone, with the bits that the campaign gives it, and with all its states.
struct SampleRun {
  std::string refused;  // why it was not run; "" where it was
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
// Runs one shake of a sample alone, at this intensity [SI].
[[nodiscard]] SampleRun run_shake(const StudySpec& study, const SampleTable& samples, int sample,
                                  double intensity, const ModelBuilder& build,
                                  const SolveOptions& options);

// Fewest and most shakes that a study asks for; results decide where a sample stops.
struct ShakeCount {
  int least = 0, most = 0;
};
[[nodiscard]] ShakeCount count_shakes(const StudySpec& study);

// "tensile_strength_MPa": name and unit of an input, its column title in samples.csv and the store.
[[nodiscard]] std::string column_title(const InputColumn& column);

}  // namespace wythe
