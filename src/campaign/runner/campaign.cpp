// run_campaign: checks, then opens or continues the store, then workers that take the next sample.
//
//   study ─ base compiles ─ samples drawn ─► store ─► jobs × { take ► lanes ► write } ─► outcome
//
// Nothing is written before every check has passed. Samples are started in order. The stop rule
// uses the samples 1 .. k that are all done, so it stops at the same k for any number of jobs.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>

#include "campaign/runner/plan.h"
#include "campaign/runner/sample_pool.h"
#include "campaign/store/folder_lock.h"
#include "campaign/store/store.h"
#include "core/files.h"
#include "wythe/parts/error.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/study_notes.h"

namespace wythe {
namespace study {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void refuse(Fault fault) { throw InputError({std::move(fault)}); }

void check_options(const StudySpec& asked, const CampaignOptions& options) {
  if (options.shards < 1 || options.shard < 1 || options.shard > options.shards)
    refuse({.file = "--shard",
            .value = fmt::format("{}/{}", options.shard, options.shards),
            .problem = "is not a shard",
            .cure = "write I/N with I from 1 to N, e.g. --shard 1/4"});
  if (options.jobs < 0)
    refuse({.file = "--jobs",
            .value = std::to_string(options.jobs),
            .problem = "must not be negative",
            .cure = "leave it out for one sample per core"});
  check_rule(asked.until);
  if (!asked.until.empty() && options.shards > 1)
    refuse({.file = "--until",
            .value = asked.until,
            .problem = "can't be judged by a shard, which sees only its own samples",
            .cure = "run without --shard, or drop --until"});
}

// Data that all workers share. Members after `mutex_` are used only while it is locked.
class Runner {
 public:
  Runner(CampaignPlan plan, Store& store, const ModelBuilder& build, const CampaignOptions& options,
         FolderLock& lock, const std::function<void(const CampaignProgress&)>& progress)
      : plan_(std::move(plan)),
        build_(build),
        compiler_(build({})),
        options_(options),
        progress_(progress),
        lock_(lock),
        store_(store) {
    campaign_.study = plan_.spec;
    campaign_.samples = plan_.samples;
    store_.database().execute("PRAGMA busy_timeout = 60000");  // ms: waits for queries of others
    queue_samples();
    take_up_rule();
  }

  CampaignOutcome run() {
    report(nullptr);
    const PoolTask task{.samples = {plan_.spec, plan_.samples, build_, &compiler_},
                        .left = static_cast<int>(pending_.size()),
                        .jobs = options_.jobs,
                        .halt = halt_,
                        .poll = [this] { poll_user(); },
                        .take = [this] { return take(); },
                        .keep = [this](SampleJob& job) { keep(job); }};
    lock_.tell_workers(workers_of(task));
    if (!halt_) solve_samples(task);
    CampaignOutcome outcome;
    outcome.done = done_;
    outcome.total = total_;
    outcome.precise_at = met_ ? static_cast<int>(campaign_.records.size()) : 0;
    outcome.interrupted = !met_ && done_ < total_;
    outcome.until_state = until_state_;
    outcome.notes = plan_.notes;
    return outcome;
  }

 private:
  void queue_samples() {
    const std::set<int> done = store_.done();
    const int drawn = plan_.samples.n_sample();
    const int last = options_.last > 0 ? std::min(options_.last, drawn) : drawn;
    for (int s = options_.shard; s <= last; s += options_.shards) {
      ++total_;
      if (done.contains(s))
        ++done_;
      else
        pending_.push_back(s);
    }
  }

  // Applies the stop rule from the samples that existed when it was first given, then after each new one.
  void take_up_rule() {
    const std::string& rule = plan_.spec.until;
    const bool same = store_.value("until") == rule && !store_.value("until_from").empty();
    if (rule.empty() || !same) store_.set_value("until_met_at", "");
    store_.set_value("until", rule);
    for (const char* key : {"fragility", "limit_states"})
      store_.set_value(key, value_of(rows_of(plan_.spec), key));
    if (rule.empty()) {
      store_.set_value("until_from", "");
      return;
    }
    for (SampleRecord& record : store_.records(plan_.samples.n_sample()))
      waiting_[record.sample] = std::move(record);
    if (!same) {
      int prefix = 0;
      while (waiting_.contains(prefix + 1)) ++prefix;
      store_.set_value("until_from", std::to_string(prefix));
    }
    until_from_ = store_.number_of_sample("until_from");
    judge();
  }

  // Adds the samples that complete the sequence 1 .. k, one by one, until the rule holds.
  void judge() {
    for (auto next = waiting_.begin(); !met_ && next != waiting_.end(); next = waiting_.begin()) {
      const int k = static_cast<int>(campaign_.records.size()) + 1;
      if (next->first != k) return;
      campaign_.records.push_back(std::move(next->second));
      waiting_.erase(next);
      if (k < until_from_) continue;
      met_ = precise_enough(plan_.spec.until, campaign_, &until_state_);
      if (!met_) continue;
      store_.set_value("until_met_at", std::to_string(k));
      halt_ = true;
    }
  }

  void keep(SampleJob& job) {
    const SampleRun done = job.finish();
    SampleRecord record = record_of(done, plan_.samples, job.sample());
    record.provenance = options_.provenance;
    write(packed(std::move(record), asked_states(plan_.spec, done.result)));
  }

  void poll_user() {
    if (options_.stop != nullptr && options_.stop->load()) halt_ = true;
  }

  int take() {
    poll_user();
    const std::lock_guard lock(mutex_);
    if (halt_ || next_ == pending_.size()) return 0;
    ++running_;
    return pending_[next_++];
  }

  void write(PackedSample sample) {
    const std::lock_guard lock(mutex_);
    --running_;
    if (met_) return;
    store_.write(sample);
    ++done_;
    ++done_now_;
    report(&sample.record);
    if (plan_.spec.until.empty()) return;
    waiting_[sample.record.sample] = std::move(sample.record);
    judge();
  }

  void report(const SampleRecord* last) const {
    if (!progress_) return;
    CampaignProgress p;
    p.done = done_;
    p.total = total_;
    p.running = running_;
    p.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    p.rate = p.seconds > 0 ? done_now_ / p.seconds : 0;
    if (p.rate > 0) p.seconds_left = (total_ - done_) / p.rate;
    p.last = last;
    progress_(p);
  }

  const CampaignPlan plan_;
  const ModelBuilder& build_;
  const Compiler compiler_;  // of the base model, whose assembly samples share
  const CampaignOptions& options_;
  const std::function<void(const CampaignProgress&)>& progress_;
  FolderLock& lock_;
  const Clock::time_point start_ = Clock::now();
  std::vector<int> pending_;
  int total_ = 0, until_from_ = 0;
  std::atomic<bool> halt_{false};

  std::mutex mutex_;
  Store& store_;
  std::size_t next_ = 0;
  int done_ = 0, done_now_ = 0, running_ = 0;
  bool met_ = false;
  Message until_state_;
  Campaign campaign_;                    // samples 1 .. k, for the rule
  std::map<int, SampleRecord> waiting_;  // done, but beyond k
};

}  // namespace
}  // namespace study

CampaignOutcome run_campaign(const StudySpec& asked, const ModelBuilder& build,
                             const std::string& folder, const CampaignOptions& options,
                             const std::function<void(const CampaignProgress&)>& progress) {
  study::check_options(asked, options);
  check_output(study::store_path(folder).string());  // a link is not a store of this folder
  const bool there = study::holds_store(folder);
  if (there && !options.resume)
    study::refuse({.file = folder,
                   .problem = "holds a campaign already",
                   .cure = "--resume goes on with it; or name another folder"});
  const study::StoreHead head = study::head_of(asked, build, options);
  study::CampaignPlan plan{asked, draw_samples(asked), {}};
  study::FolderLock lock(folder);
  if (!there) study::create_store(folder, asked, plan.samples, head);
  study::Store store(folder, study::Store::Access::kWrite);
  if (there) plan = study::continue_store(store, asked, head);
  for (Message& note : notes_of(asked, build({}))) plan.notes.push_back(std::move(note));
  for (Message& note : notes_of_values(asked, plan.samples, build))
    plan.notes.push_back(std::move(note));
  return study::Runner(std::move(plan), store, build, options, lock, progress).run();
}

bool holds_campaign(const std::string& folder) { return study::holds_store(folder); }

}  // namespace wythe
