// Only an undamaged store of the same study and shard can be continued. Its design may then grow by
// batches of two samples or more. All samples are drawn again, and only those beyond the stored ones
// are added. If this version would draw other values for stored samples, they stay and a note says so.
#include "campaign/runner/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "campaign/runner/shakes.h"
#include "wythe/parts/error.h"

namespace wythe::study {

int total(const std::vector<int>& batch) { return std::accumulate(batch.begin(), batch.end(), 0); }

StoreHead head_of(const StudySpec& asked, const ModelBuilder& build,
                  const CampaignOptions& options) {
  const ModelSpec base = build({});
  const Model model = compile(base);
  check_control_point(asked.shaking, model);
  StoreHead head;
  head.shard = fmt::format("{}/{}", options.shard, options.shards);
  head.provenance = options.provenance;
  head.load_height = load_height_of(model);
  return head;
}

std::vector<int> grown(const std::vector<int>& was, const std::vector<int>& asked,
                       const std::string& store) {
  if (total(asked) == total(was)) return was;
  if (total(asked) < total(was))
    throw InputError(
        {{.file = store,
          .path = "samples",
          .value = std::to_string(total(asked)),
          .problem = fmt::format("the store holds a design of {} already, which can only grow",
                                 total(was)),
          .cure = fmt::format("write --samples {} or more", total(was))}});
  if (asked.size() > was.size() && std::equal(was.begin(), was.end(), asked.begin())) return asked;
  std::vector<int> batch = was;
  batch.push_back(total(asked) - total(was));
  if (batch.back() < 2)
    throw InputError(
        {{.file = store,
          .path = "samples",
          .value = std::to_string(total(asked)),
          .problem = fmt::format("adds one sample to the {} of the store, and a design "
                                 "has two at least",
                                 total(was)),
          .cure = fmt::format("write --samples {} or more", total(was) + 2)}});
  return batch;
}

namespace {

void refuse_changes(Store& store, const StudySpec& was, const StudySpec& asked,
                    const StoreHead& head) {
  const std::string& name = store.database().name();
  const StoreHead stored = store.head();
  std::vector<Fault> faults = changes(was, asked, name);
  if (stored.shard != head.shard)
    faults.push_back({.file = name,
                      .path = "shard",
                      .problem = fmt::format("was {} when the campaign began, is {} now",
                                             stored.shard, head.shard),
                      .cure = "give each shard a folder of its own"});
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

CampaignPlan continue_store(Store& store, const StudySpec& asked, const StoreHead& head) {
  store.check_whole();
  const StudySpec was = store.study();
  refuse_changes(store, was, asked, head);
  CampaignPlan plan{asked, store.samples(), {}};
  plan.spec.batch = grown(was.batch, asked.batch, store.database().name());
  const SampleTable drawn = draw_samples(plan.spec);
  const int stored = plan.samples.n_sample();
  const auto first = drawn.value.begin(), next = first + stored;
  if (!std::equal(first, next, plan.samples.value.begin(), same_inputs))
    plan.notes.push_back({"store.other_draws"});
  if (head.provenance != store.head().provenance)
    plan.notes.push_back(
        {"store.other_program", {{"began", store.head().provenance}, {"now", head.provenance}}});
  if (drawn.n_sample() > stored) {
    plan.samples.value.insert(plan.samples.value.end(), next, drawn.value.end());
    set_more(plan.spec, plan.samples);
    store.add_samples(plan.samples, stored + 1, plan.spec);
  }
  return plan;
}

}  // namespace wythe::study
