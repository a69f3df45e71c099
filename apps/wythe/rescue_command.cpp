// wythe store rescue: what can be saved of a damaged store. Where its study is damaged too, the study comes from a file,
// and has to prove that it is of this wall before anything is written.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "campaign_commands.h"
#include "interrupt.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/io.h"
#include "wythe/rescue.h"
#include "wythe/stored_states.h"
#include "wythe/text.h"

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

void say_what_proves(const std::vector<int>& samples) {
  if (samples.empty())
    return fmt::print(stderr,
                      "note: no sample that ran is whole, so nothing shows that the study is of "
                      "this wall\n");
  fmt::print("to see whether the study is of this wall, {} run again: {}\n",
             samples.size() == 1 ? "a sample is" : "some samples are", fmt::join(samples, ", "));
  std::fflush(stdout);
}

// Of a study with options that of the folder's name.
StudySpec study_of_folder(const StoreArguments& a) {
  StudySpec study = asked_study(a.by);
  const std::string name =  // also of "out/base/" and "."
      (fs::absolute(a.folder) / "").lexically_normal().parent_path().filename().string();
  for (const VariantSpec& option : study.option)
    if (option.folder == name) return option.study;
  if (!study.option.empty() && name != kBaseFolder)
    refuse("--study", a.by.study, "has [[variant]], and none of its folders is called " + name,
           "name the folder as the campaign did, e.g. out/" + std::string(kBaseFolder));
  return study;
}

Rescue rescue_by_study(const StoreArguments& a) {
  const StopSignal stop;
  StudyOfRescue by{.study = study_of_folder(a),
                   .build = {},
                   .shard = a.by.shard,
                   .stop = &stop.asked(),
                   .proves = say_what_proves};
  by.build = model_builder(by.study);
  return rescue_campaign(a.folder, a.out, by);
}

void check_arguments(const StoreArguments& a) {
  check_language(a.language);
  check_folder(a.out, FolderFor::kCampaign);
  if (!a.by.study.empty()) return;
  const auto refuse_alone = [](const std::string& option, const std::string& value) {
    if (!value.empty())
      refuse(option, value, "is for a study that comes from its file", "give --study FILE too");
  };
  refuse_alone("--samples", a.by.samples);
  refuse_alone("--seed", a.by.seed);
  refuse_alone("--shard", a.by.shard);
  if (!a.by.overrides.empty()) refuse_alone("--set", a.by.overrides.front());
}

}  // namespace

int rescue_store(const StoreArguments& a) {
  check_arguments(a);
  const Rescue rescue = a.by.study.empty() ? rescue_campaign(a.folder, a.out) : rescue_by_study(a);
  for (const Rescue::Lost& lost : rescue.lost)
    fmt::print("sample {} is lost: {}\n", lost.sample, readable(lost.why));
  if (!rescue.knows_shard)
    fmt::print(stderr,
               "note: the store does not say any more which shard of its campaign it is, so it is "
               "saved as a whole one. To put it back into an array, rescue it into another folder "
               "with --shard, e.g. --shard 2/40 for shard 2 of 40\n");
  fmt::print("{} samples kept, {} lost; go on with wythe campaign STUDY.toml --out {} --resume\n",
             rescue.kept, rescue.lost.size(), shell_quoted(a.out));
  if (rescue.kept > 0)
    static_cast<void>(write_campaign_files(a.out, read_answers(a.out), a.language));
  return 0;
}

}  // namespace wythe::app
