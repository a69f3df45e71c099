// All shards of a campaign at once: first every existing store is compared
// with the study, then missing stores are created and small ones grow.
//
//   check_shards ─► the largest design there, grown to what is asked ─► make_shards: create | grow | leave
#include "wythe/parts/shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "campaign/runner/plan.h"
#include "campaign/store/folder_lock.h"
#include "campaign/store/store.h"
#include "wythe/parts/error.h"

namespace wythe {
namespace study {
namespace {

struct Found {
  std::string folder;
  std::vector<int> batch;
};

class ShardCheck {
 public:
  ShardCheck(const StudySpec& asked, const ShardStores& stores) : asked_(asked), stores_(stores) {
    const std::size_t n = stores.folders.size();
    for (std::size_t i = 0; i < n; ++i)
      look(stores.folders[i], fmt::format("{}/{}", i + 1, n), "when the array was handed in");
    if (!stores.joined.empty()) look(stores.joined, "", "when the campaign began");
    throw_if_any();
  }

  [[nodiscard]] std::vector<int> design() {
    const Found* largest = nullptr;
    for (const Found& found : found_)
      if (largest == nullptr || total(found.batch) > total(largest->batch)) largest = &found;
    if (largest == nullptr) return asked_.batch;
    for (const Found& found : found_)
      if (!std::equal(found.batch.begin(), found.batch.end(), largest->batch.begin(),
                      largest->batch.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                   found.batch.size(), largest->batch.size()))))
        faults_.push_back({.file = found.folder,
                           .path = "samples",
                           .value = sum_of(found.batch),
                           .problem = fmt::format("is a design that {} of {} does not go on from",
                                                  sum_of(largest->batch), largest->folder),
                           .cure = "name another folder for a new array"});
    throw_if_any();
    const int has = total(largest->batch), asks = total(asked_.batch);
    if (asks < has && stores_.may_shrink) return check_growth(largest->batch);
    if (asks < has)
      throw InputError(
          {{.file = largest->folder,
            .path = "samples",
            .value = std::to_string(asks),
            .problem = fmt::format(
                "is fewer than the {} that are drawn there already; a design can only grow", has),
            .cure = fmt::format("write --samples {} or more, or leave --samples out", has)}});
    return check_growth(grown(largest->batch, asked_.batch, largest->folder));
  }

 private:
  void look(const std::string& folder, const std::string& shard, const char* then) {
    if (!holds_store(folder)) return;
    Store store(folder, Store::Access::kRead);
    const std::string& name = store.database().name();
    const StudySpec was = store.study();
    found_.push_back({folder, was.batch});
    for (Fault& fault : changes(was, asked_, name, then)) add(std::move(fault));
    if (const std::string is = store.head().shard; !shard.empty() && is != shard)
      add({.file = name,
           .path = "shard",
           .problem = fmt::format("is {}, would be {}", is, shard),
           .cure = "name another folder, or write as many tasks as there are shards"});
  }
  // Faults that are the same in all shards are reported once, for the first shard.
  void add(Fault fault) {
    if (said_.emplace(fault.path, fault.value, fault.problem).second)
      faults_.push_back(std::move(fault));
  }
  void throw_if_any() const {
    if (!faults_.empty()) throw InputError(faults_);
  }
  static std::string sum_of(const std::vector<int>& batch) {
    return fmt::format("{}", fmt::join(batch, " + "));
  }

  // A store that grows must not be in use by another process.
  std::vector<int> check_growth(std::vector<int> batch) {
    for (const Found& found : found_) {
      if (found.folder == stores_.joined || total(found.batch) == total(batch)) continue;
      const std::string writer = lock_holder(found.folder);
      if (writer.empty()) continue;
      faults_.push_back(
          {.file = found.folder,
           .path = "samples",
           .value = std::to_string(total(batch)),
           .problem = fmt::format("{} runs its {} samples now, so more cannot be added", writer,
                                  total(found.batch)),
           .cure = "wait until it has ended (wythe status DIR), or cancel the array (scancel JOB), "
                   "then hand in again"});
    }
    throw_if_any();
    return batch;
  }

  const StudySpec& asked_;
  const ShardStores& stores_;
  std::vector<Found> found_;
  std::vector<Fault> faults_;
  std::set<std::tuple<std::string, std::string, std::string>> said_;
};

}  // namespace
}  // namespace study

std::vector<int> check_shards(const StudySpec& asked, const ShardStores& stores) {
  return study::ShardCheck(asked, stores).design();
}

void make_shards(const StudySpec& asked, const ModelBuilder& build, const ShardStores& stores,
                 const std::string& provenance) {
  const SampleTable samples = draw_samples(asked);
  study::StoreHead head = study::head_of(asked, build, {.provenance = provenance});
  for (std::size_t i = 0; i < stores.folders.size(); ++i) {
    const std::string& folder = stores.folders[i];
    head.shard = fmt::format("{}/{}", i + 1, stores.folders.size());
    if (study::holds_store(folder) && stored_batches(folder) == asked.batch) continue;
    const study::FolderLock lock(folder);
    if (!study::holds_store(folder)) {
      study::create_store(folder, asked, samples, head);
      continue;
    }
    study::Store store(folder, study::Store::Access::kWrite);
    static_cast<void>(study::continue_store(store, asked, head));
  }
}

int campaign_workers(const std::string& folder) { return study::lock_workers(folder); }

}  // namespace wythe
