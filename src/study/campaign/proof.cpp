#include "study/campaign/proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "core/files.h"
#include "study/draws/records.h"
#include "study/store/doubles.h"
#include "wythe/error.h"

namespace wythe::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "made_by_rescue";

// A folder of our own below `out`, gone with all that is in it at the end; one that a killed rescue left goes first.
class HiddenFolder {
 public:
  explicit HiddenFolder(const std::string& out) : path_(out + "/.wythe_proof") {
    std::error_code error;
    if (fs::exists(fs::symlink_status(path_, error))) {
      if (!fs::is_directory(fs::symlink_status(path_, error)) ||
          !fs::exists(fs::symlink_status(path_ + "/" + kMark, error)))
        throw InputError({{.file = path_,
                           .path = "",
                           .value = "",
                           .problem = "is in the place where the study is to be proved",
                           .cure = "rename or remove it, or name another folder"}});
      remove();
    }
    fs::create_directory(path_, error);
    if (error) throw IoError(path_ + ": cannot be made: " + error.message());
    write_file(path_ + "/" + kMark, "");
  }
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

// The ways through a study that samples have gone: under which record, how it ended, whether it was pushed or shaken at all, fell,
// or was tried again.
auto way_of(const StudySpec& study, const SampleRecord& record) {
  const bool fell = std::any_of(record.shakes.begin(), record.shakes.end(),
                                [](const ShakeAnswer& shake) { return shake.collapsed; });
  return std::tuple(case_of(study, record.sample).record, record.status, record.has_curve(), fell,
                    record.retried);
}

}  // namespace

std::vector<int> samples_to_prove(const StudySpec& study, const std::vector<SampleRecord>& whole) {
  std::map<decltype(way_of(study, whole.front())), std::pair<std::int64_t, int>> best;
  for (const SampleRecord& record : whole) {
    if (record.steps <= 0) continue;
    const std::pair one(record.steps, record.sample);
    const auto [there, is_new] = best.emplace(way_of(study, record), one);
    if (!is_new && one < there->second) there->second = one;
  }
  std::vector<int> samples;
  for (const auto& [way, one] : best) samples.push_back(one.second);
  std::sort(samples.begin(), samples.end());
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
