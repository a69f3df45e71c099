#include "study/campaign/proof.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <utility>

#include "study/draws/records.h"
#include "study/store/doubles.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

namespace fs = std::filesystem;

// Gone with all that is in it at the end.
class HiddenFolder {
 public:
  explicit HiddenFolder(const std::string& out) : path_(out + "/.wythe_proof") { remove(); }
  ~HiddenFolder() { remove(); }
  HiddenFolder(const HiddenFolder&) = delete;
  HiddenFolder& operator=(const HiddenFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void remove() const {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  std::string path_;
};

// How much of its study a sample has gone through: 0 all, 1 some of the push or shake, 2 less.
int left_out(const SampleRecord& record) {
  if (record.status == "completed") return 0;
  return record.has_curve() || !record.shakes.empty() ? 1 : 2;
}

}  // namespace

std::vector<int> samples_to_prove(const StudySpec& study, const std::vector<SampleRecord>& whole) {
  using Cost = std::pair<int, std::int64_t>;
  std::map<int, std::pair<Cost, int>> best;  // by record
  for (const SampleRecord& record : whole) {
    if (record.steps <= 0) continue;
    const std::pair<Cost, int> one = {{left_out(record), record.steps}, record.sample};
    const auto [there, is_new] = best.emplace(case_of(study, record.sample).record, one);
    if (!is_new && one < there->second) there->second = one;
  }
  std::vector<int> samples;
  for (const auto& [record, one] : best) samples.push_back(one.second);
  return samples;
}

void prove_study(const std::string& folder, const std::string& out, const StudySpec& study,
                 const StudyOfRescue& by, const std::vector<int>& samples) {
  if (by.proves) by.proves(samples);
  StudySpec alone = study;
  alone.until.clear();
  for (const int sample : samples) {
    const HiddenFolder hidden(out);
    CampaignOptions options;
    options.jobs = 1;
    options.shard = sample, options.shards = count_samples(study);  // this sample and no other
    options.stop = by.stop;
    const CampaignOutcome outcome = run_campaign(alone, by.build, hidden.path(), options);
    if (outcome.interrupted)
      throw IoError(folder +
                    ": interrupted before the study was proved: nothing was saved; rescue once "
                    "more");
    SampleRows again(hidden.path()), stored(folder);
    const auto difference = SampleRows::difference(again, stored, sample);
    if (!difference) continue;
    throw InputError(
        {{.file = study.file,
          .path = "",
          .value = fmt::format("sample {}", sample),
          .problem = fmt::format("comes out otherwise than it is stored ({}): the study file is of "
                                 "another wall or another push, or another program ran it ({})",
                                 *difference, stored.run(sample).provenance),
          .cure = "give the study file, with its model and records, as they were, and use the "
                  "program that ran the campaign; nothing was saved"}});
  }
}

}  // namespace wythe::study
