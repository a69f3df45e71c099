// Reads a store: the campaign, its states, the titles of its columns, and whether it is undamaged.
#include <algorithm>
#include <utility>

#include "campaign/store/folder_lock.h"
#include "campaign/store/store.h"
#include "judge/modes/in_space.h"
#include "wythe/parts/error.h"
#include "wythe/parts/stored_states.h"

namespace wythe {
namespace {

study::Store opened(const std::string& folder) {
  const std::string base = folder + "/" + kBaseFolder;
  if (!study::holds_store(folder) && study::holds_store(base))
    throw InputError({{.file = folder,
                       .problem = "holds several campaigns, of a study with [[variant]]",
                       .cure = "name one of its folders, e.g. " + base}});
  if (!study::holds_store(folder))
    throw InputError({{.file = folder,
                       .problem = "holds no campaign (no campaign.db)",
                       .cure = "name the folder that wythe campaign --out wrote"}});
  return {folder, study::Store::Access::kRead};
}

Campaign without_records(study::Store& store) {
  Campaign campaign;
  campaign.study = store.study();
  campaign.samples = store.samples();
  const study::StoreHead head = store.head();
  campaign.load_height = head.load_height;
  campaign.provenance = head.provenance;
  return campaign;
}

}  // namespace

std::vector<int> stored_batches(const std::string& folder) { return opened(folder).study().batch; }

StudySpec read_study_of(const std::string& folder) { return opened(folder).study(); }

Campaign read_campaign(const std::string& folder) {
  study::Store store = opened(folder);
  Campaign campaign = without_records(store);
  campaign.records = store.records(study::last_counted(store));
  return campaign;
}

Campaign read_campaign(const std::string& folder,
                       const std::function<void(const Campaign&, const SampleRecord&)>& take) {
  constexpr int kAtOnce = 64;
  study::Store store = opened(folder);
  const Campaign campaign = without_records(store);
  const int last = std::min(campaign.samples.n_sample(), study::last_counted(store));
  static_cast<void>(store.done());  // refuses samples outside the parts below
  for (int first = 1; first <= last; first += kAtOnce) {
    study::Store part(folder, study::Store::Access::kRead);  // each counts its own memory
    for (const SampleRecord& record :
         part.records(campaign.samples, first, std::min(last, first + kAtOnce - 1)))
      take(campaign, record);
  }
  return campaign;
}

Campaign read_answers(const std::string& folder) {
  constexpr std::size_t kAtOnce = 256;
  study::Store store = opened(folder);
  Campaign campaign = without_records(store);
  store.check_no_other_sample();
  const int last = study::last_counted(store);
  std::vector<int> ran;
  for (const int sample : store.done())
    if (sample <= last) ran.push_back(sample);
  campaign.records.reserve(ran.size());
  for (std::size_t i = 0; i < ran.size(); i += kAtOnce)
    for (SampleRecord& record :
         store.records(campaign.samples, ran[i], ran[std::min(i + kAtOnce, ran.size()) - 1])) {
      record.features = {};
      record.events = {};
      record.energy = {};
      FailureMode& mode = record.failure_mode;
      // an assessment needs the failure of each pier, whether it is in plane, and whether the name is firm
      std::erase_if(mode.evidence, [](const Evidence& e) { return !study::tells_of_planes(e); });
      mode.evidence.shrink_to_fit();
      if (!record.pushed.is_read()) mode.elements = {}, mode.scores = {};
      record.provenance = {};
      campaign.records.push_back(record);  // a copy has no spare capacity
    }
  return campaign;
}

StoreProgress campaign_progress(const std::string& folder) {
  study::Store store = opened(folder);
  StoreProgress progress;
  const int last = study::last_counted(store);
  progress.samples = store.samples().n_sample();
  const auto [first, step] = *study::shard_of(store.head().shard);  // head() refuses others
  progress.shard = first, progress.shards = step;
  for (int s = first; s <= std::min(progress.samples, last); s += step) ++progress.total;
  study::Statement select(store.database(),
                          "SELECT count(*), total(status NOT IN ('completed', 'collapsed')), "
                          "total(wall_seconds) FROM sample WHERE sample <= ?");
  select.bind(last);
  select.step();
  progress.done = static_cast<int>(select.integer());
  progress.failed = static_cast<int>(select.number());
  progress.seconds = select.number();
  progress.writer = study::lock_holder(folder);
  progress.study = study::identity_of(store.study());
  return progress;
}

std::vector<Snapshot> read_states(const std::string& folder, int sample, const Model& model) {
  return opened(folder).states(sample, model);
}

struct StoredStates::Content {
  std::string folder;
  study::Store store;
};

StoredStates::StoredStates(const std::string& folder)
    : content_(new Content{folder, opened(folder)}) {
}  // make_unique asks for more than clang 14 knows

StoredStates::~StoredStates() = default;

std::vector<Snapshot> StoredStates::of(int sample, const Model& model) {
  if (content_->store.database().is_outdated()) {
    const std::string folder = content_->folder;
    content_.reset(new Content{folder, opened(folder)});
  }
  content_->store.database().give_back();  // releases the count after each sample
  return content_->store.states(sample, model);
}

void check_campaign(const std::string& folder) {
  if (!study::holds_store(folder)) throw IoError(folder + ": holds no campaign (no campaign.db)");
  study::Store store(folder, study::Store::Access::kRead);
  study::Statement check(store.database(), "PRAGMA integrity_check(1)");
  const std::string verdict = check.step() ? check.text() : "";
  if (verdict != "ok") store.database().damaged(verdict);
  static_cast<void>(store.study());
  static_cast<void>(store.head());
  store.check_whole();
  store.check_states();
}

}  // namespace wythe
