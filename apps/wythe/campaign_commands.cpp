// Each command reads its study from a file or from the store of a folder, and hands it to the library (wythe/study.h).
// Here are options and the words on the console.
#include "campaign_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <thread>

#include "campaign_table.h"
#include "interrupt.h"
#include "notes.h"
#include "progress.h"
#include "shaking_table.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/solve.h"
#include "wythe/spec.h"
#include "wythe/study.h"

namespace wythe::app {
namespace fs = std::filesystem;
namespace {

// "2/4" -> shard 2 of 4.
void read_shard(const std::string& text, CampaignOptions& options) {
  if (text.empty()) return;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, options.shard);
  if (first == std::errc() && slash != end && *slash == '/') {
    const auto [stop, second] = std::from_chars(slash + 1, end, options.shards);
    if (second == std::errc() && stop == end) return;
  }
  refuse("--shard", text, "is not I/N", "write e.g. --shard 1/4");
}

// The study with options that are short forms of --set; their faults have the option's name.
StudySpec study_with_options(const CampaignArguments& a) {
  std::vector<std::string> overrides = a.overrides;
  std::map<std::string, std::string> option;
  const auto add = [&](const char* name, const std::string& key, const std::string& value) {
    if (value.empty()) return;
    overrides.push_back(key + "=" + value);
    option[key] = name;
  };
  add("--samples", "study.samples", a.samples);
  add("--seed", "study.seed", a.seed);
  add("--until", "study.until", a.until);
  try {
    return read_study(a.study, overrides);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      if (fault.file == "--set" && option.contains(fault.path))
        fault.file = option[fault.path], fault.path.clear();
    throw InputError(std::move(faults));
  }
}

}  // namespace

void refuse(const std::string& option, const std::string& value, const std::string& problem,
            const std::string& cure) {
  throw InputError({{.file = option, .value = value, .problem = problem, .cure = cure}});
}

void check_inner_folder(const std::string& folder) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(folder, error))) return;
  refuse(folder, "",
         fmt::format("is a link to {}, and results stay within their folder",
                     fs::read_symlink(folder, error).string()),
         "remove it, or name another folder");
}

int whole_number(const std::string& option, const std::string& text, int least, int most,
                 const std::string& cure) {
  return option_number<int>(
      option, text, [&](int n) { return n >= least && n <= most; },
      fmt::format("must be a whole number from {} to {}", least, most), cure);
}

int jobs_of(const std::string& text) {
  return text.empty() ? 0
                      : whole_number("--jobs", text, 0, kMostCores, "leave it out for all cores");
}

int threads_of(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::string shell_quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyz"
                                          "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./=+,:@%") == std::string::npos;
  if (plain) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string shell_path(const std::string& path) {
  return shell_quoted(path.starts_with('-') ? "./" + path : path);
}

StudySpec asked_study(const CampaignArguments& a) {
  StudySpec study = study_with_options(a);
  const std::string store = study.option.empty() ? a.out : a.out + "/" + kBaseFolder;
  if (!a.resume || !a.samples.empty() || !holds_campaign(store)) return study;
  const std::vector<int> stored = stored_batches(store);
  const int has = std::accumulate(stored.begin(), stored.end(), 0);
  const int asks = std::accumulate(study.batch.begin(), study.batch.end(), 0);
  if (has != asks && !a.stored)
    fmt::print(stderr, "note: {} holds a design of {} samples, the study asks for {}{}\n", a.out,
               has, asks, asks > has ? fmt::format("; --samples {} adds the rest", asks) : "");
  study.batch = stored;
  for (VariantSpec& option : study.option) option.study.batch = stored;
  return study;
}

namespace {

// The study in the stores of an array, for a shard whose study file is gone.
StudySpec study_in(const std::string& folder) {
  if (holds_campaign(folder)) return read_study_of(folder);
  const std::string base = folder + "/" + kBaseFolder;
  StudySpec study = read_study_of(base);
  for (const std::string& inner : option_folders(folder)) {
    if (fs::equivalent(inner, base)) continue;
    VariantSpec& option = study.option.emplace_back();
    option.study = read_study_of(inner);
    option.name = option.study.variant;
    option.folder = fs::path(inner).filename().string();
  }
  return study;
}

std::vector<std::string> variants_of(const StudySpec& study) {
  std::vector<std::string> names;
  for (const VariantSpec& option : study.option) names.push_back(option.name);
  return names;
}

// The study of a shard whose stores were created beforehand. The file must not ask
// for another design. Other differences are refused where each store is opened.
StudySpec stored_study(const CampaignArguments& a) {
  if (!a.resume) refuse("--stored", "", "goes on with stores that are there", "add --resume");
  if (!holds_campaign(a.out) && !holds_options(a.out))
    refuse("--stored", a.out, "holds no store of a campaign",
           "hand the array in again (wythe campaign STUDY.toml --slurm N): it makes the stores");
  const StudySpec stored = study_in(a.out);
  std::error_code error;
  if (!fs::exists(a.study, error)) {
    fmt::print(stderr, "note: {} is not there; the study that {} holds is run\n", readable(a.study),
               readable(a.out));
    return stored;
  }
  StudySpec study = asked_study(a);
  const std::vector<std::string> was = variants_of(stored), is = variants_of(study);
  const auto listed = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", "));
  };
  if (was != is)
    throw InputError(
        {{.file = a.out,
          .path = "variant",
          .problem = fmt::format("was {} when the array was handed in, is {} now", listed(was),
                                 listed(is)),
          .cure = "put it back as it was, or begin another campaign in another folder (nothing "
                  "stored was touched)"}});
  return study;
}

int say_interrupted(const CampaignArguments& a, const CampaignOutcome& outcome) {
  (void)write_campaign_files(a.out, read_answers(a.out), a.language, hold_for_test);
  fmt::print(stderr, "stopped: {} of {} samples are stored. To continue:\n  {}\n", outcome.done,
             outcome.total, resume_command(a));
  return kFailed;
}

}  // namespace

std::string resume_command(const CampaignArguments& a) {
  std::string line;
  for (const std::string& word : a.command) line += (line.empty() ? "" : " ") + shell_quoted(word);
  return a.resume ? line : line + " --resume";
}

int write_results(const std::string& folder, const std::string& language) {
  const Campaign campaign = read_answers(folder);
  const Statistics statistics = write_campaign_files(folder, campaign, language, hold_for_test);
  print_table(campaign, statistics);
  fmt::print("report {}/report.html\n", readable(folder));
  return statistics.answered > 0 || campaign.records.empty() ? 0 : kFailed;
}

int campaign(const CampaignArguments& asked) {
  CampaignArguments a = asked;
  check_language(a.language);
  if (!a.slurm.tasks.empty()) return cluster_campaign(a);
  for (const auto& [option, value] :
       {std::pair("--partition", a.slurm.partition), std::pair("--time", a.slurm.time),
        std::pair("--cores", a.slurm.cores)})
    if (!value.empty())
      refuse(option, value, "is for --slurm alone", "add --slurm N, or leave it out");
  if (a.slurm.submit)
    refuse("--submit", "", "is for --slurm alone", "add --slurm N, or leave it out");
  if (a.studies.size() > 1)
    refuse("study", a.studies[1], "is a second study, which only --slurm takes",
           "run one campaign after the other");
  a.study = a.studies.front();
  CampaignOptions options;
  options.jobs = jobs_of(a.jobs);
  options.resume = a.resume;
  options.provenance = provenance_text();
  read_shard(a.shard, options);
  const StudySpec study = a.stored ? stored_study(a) : asked_study(a);
  hold_for_test("model read");
  if (!study.option.empty()) return campaign_of_options(a, study, options);
  if (holds_options(a.out))
    refuse("--out", a.out, "holds the campaigns of a study with [[variant]]",
           "name another folder");
  const ModelBuilder build = model_builder(study);
  check_folder(a.out, FolderFor::kCampaign);
  CampaignOutcome outcome;
  {
    const StopSignal stop;
    options.stop = &stop.asked();
    CampaignPrinter printer(a.quiet);
    outcome = run_campaign(study, build, a.out, options, [&](const CampaignProgress& p) {
      printer(p);
      if (p.last != nullptr) hold_for_test(fmt::format("sample {}", p.done));
    });
  }
  for (const Message& note : outcome.notes)
    fmt::print(stderr, "note: {}\n", readable(text_of(note)));
  if (outcome.interrupted) return say_interrupted(a, outcome);
  const int code = write_results(a.out, a.language);
  if (outcome.precise_at > 0)
    fmt::print("precise enough after {} samples: {}\n", outcome.precise_at,
               text_of(outcome.until_state));
  else if (!outcome.until_state.empty())
    fmt::print("not yet precise enough: {}; add samples with --resume --samples N\n",
               text_of(outcome.until_state));
  return code;
}

int merge(const MergeArguments& asked) {
  MergeArguments a = asked;
  a.folders.clear();
  for (const std::string& folder : asked.folders) {
    const std::vector<std::string> shards = shard_folders(folder);
    if (shards.empty()) {
      a.folders.push_back(folder);
      continue;
    }
    a.folders.insert(a.folders.end(), shards.begin(), shards.end());
    a.array = folder;
  }
  if (!a.folders.empty() && holds_options(a.folders.front())) return merge_options(a);
  check_folder(a.out, FolderFor::kCampaign);
  check_language(a.language);
  merge_campaigns(a.folders, a.out);
  const StoreProgress whole = campaign_progress(a.out);
  const int missing = whole.samples - whole.done;
  if (missing > 0 && !a.array.empty())
    fmt::print(
        stderr,
        "note: the array is not complete: {} of {} samples have not run. wythe status {} "
        "says which; wythe campaign STUDY.toml --out {} --slurm {}, as before, hands in what "
        "is missing and joins it\n",
        missing, whole.samples, shell_quoted(a.array), shell_quoted(a.array),
        campaign_progress(a.folders.front()).shards);
  else if (missing > 0)
    fmt::print(stderr,
               "note: {} samples are in none of these shards; they can be run in {} with "
               "--resume\n",
               missing, shell_quoted(a.out));
  return write_results(a.out, a.language);
}

namespace {

const SampleRecord* record_in(const Campaign& campaign, int sample) {
  for (const SampleRecord& record : campaign.records)
    if (record.sample == sample) return &record;
  return nullptr;
}

std::string lines(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += text + '\n';
  return out;
}

void write_replay(const ReplayArguments& a, Replacement& results, const Campaign& campaign,
                  const SampleRun& run) {
  write_run(results.path(), run.spec, run.model, run.result);
  write_run_report(results.path(), run.spec, run.model, run.result, a.language);
  write_text(results.path() + "/model.toml", campaign.study.model_text);
  write_text(results.path() + "/settings.txt",
             lines(campaign.study.settings) + lines(run.settings));
  results.commit(hold_for_test);
}

void print_sample(const Model& model, const Result& result) {
  print_doubt(model, result);
  const double peak = result.responses.peak_reaction;
  fmt::print("peak {}   mode {}   state {}\n",
             std::isnan(peak) ? "not known" : fmt::format("{:.2f} kN", 1e-3 * peak),
             result.failure_mode.name, result.state_hash);
}

// The last shake of the replay that the store has; null: none.
const ShakeResult* shake_in(const SampleRecord& stored, const SampleRun& run) {
  for (const ShakeResult& shake : stored.shakes)
    if (run.shakes.empty() || shake.intensity == run.shakes.back().intensity ||
        std::isnan(shake.intensity))
      return &shake;
  return nullptr;
}

// Compares the results in the store with those of the replay.
int compare_replay(const ReplayArguments& a, const SampleRecord* stored_sample,
                   const SampleRun& run) {
  const std::string status = run.refused.empty() ? to_string(run.result.status) : "refused";
  fmt::print("sample {}: {}{}\n", a.sample, status, run.refused.empty() ? "" : ": " + run.refused);
  if (run.refused.empty()) print_sample(run.model, run.result);
  const bool shaken = stored_sample != nullptr && !stored_sample->shakes.empty();
  const ShakeResult* shake = shaken ? shake_in(*stored_sample, run) : nullptr;
  if (stored_sample == nullptr || (shaken && shake == nullptr)) {
    fmt::print("the campaign has not run this sample: nothing to compare\n");
    return 0;
  }
  const std::string hash = run.refused.empty() ? run.result.state_hash : "";
  struct {
    std::string status, state_hash, provenance;
  } in_store{stored_sample->status, stored_sample->state_hash, stored_sample->provenance};
  if (shake != nullptr) in_store.status = shake->status, in_store.state_hash = shake->state_hash;
  const auto* stored = &in_store;
  if (stored->status == status && stored->state_hash == hash) {
    fmt::print("the result equals that of the campaign, bit for bit\n");
    return 0;
  }
  fmt::print(stderr,
             "the result differs from that of the campaign: {}, state {}; stored {}, state {}\n"
             "the campaign was run by {}; this is {}\n",
             status, hash, stored->status, stored->state_hash, stored->provenance,
             provenance_text());
  return kFailed;
}

// NaN: no intensity was requested.
double asked_intensity(const ReplayArguments& a, const StudySpec& study) {
  if (a.intensity.empty()) return std::nan("");
  if (!study.shaking.is_asked())
    refuse("--intensity", a.intensity, "is of studies with [shaking]", "leave it out");
  try {
    const double value = parse_quantity(a.intensity, unit_of(study.shaking.measure));
    if (value > 0 && std::isfinite(value)) return value;
  } catch (const std::exception&) {  // no quantity, or one with another unit
  }
  refuse("--intensity", a.intensity,
         fmt::format("is no {} in {}", word_of(kIntensityMeasureWords, study.shaking.measure),
                     unit_of(study.shaking.measure)),
         fmt::format("write e.g. --intensity \"2 {}\"", unit_of(study.shaking.measure)));
}

}  // namespace

int replay(const ReplayArguments& a) {
  check_language(a.language);
  const Campaign campaign = read_campaign(a.folder);
  if (a.sample < 1 || a.sample > campaign.samples.n_sample())
    refuse("--sample", std::to_string(a.sample), "is not in the campaign",
           fmt::format("write a number from 1 to {}", campaign.samples.n_sample()));
  const double intensity = asked_intensity(a, campaign.study);
  const std::unique_ptr<Replacement> results = replace_run(a.out, {a.folder, 0, a.replaces});
  SolveOptions options;
  const StopSignal stop;
  options.threads = threads_of(a.threads);
  options.stop = &stop.asked();
  options.frames = kFrames;
  SampleRun run;
  {
    ProgressPrinter progress(a.quiet);
    options.progress = [&](const Progress& p) {
      progress(p);
      hold_for_test(fmt::format("stage {}", p.stage));
    };
    const ModelBuilder build = model_builder(campaign.study);
    run = std::isnan(intensity)
              ? run_sample(campaign.study, campaign.samples, a.sample, build, options)
              : run_shake(campaign.study, campaign.samples, a.sample, intensity, build, options);
  }
  if (run.refused.empty()) write_replay(a, *results, campaign, run);
  return compare_replay(a, record_in(campaign, a.sample), run);
}

namespace {

// "1, 5, 9 and 12 more"
std::string some_of(const std::vector<int>& samples) {
  constexpr std::size_t kShown = 10;
  const std::size_t shown = std::min(kShown, samples.size());
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", samples[i]);
  return samples.size() == shown ? text
                                 : text + fmt::format(" and {} more", samples.size() - shown);
}

// How a constant residual value may follow its peak, which varies; "" for other keys.
std::string follow_cure(const SampleTable& samples, const std::string& path) {
  constexpr const char* kResidual = ".residual_";
  const std::size_t at = path.find(kResidual);
  if (at == std::string::npos) return "";
  // the model may have "friction_tan" instead of "friction_angle"
  const std::string stem = path.substr(0, at + 1) + path.substr(at + 10, 8);
  for (const InputColumn& column : samples.column)
    if (column.path.starts_with(stem))
      return fmt::format(
          "let the residual follow {0}: [dependent.{0}_residual] with path = \"{1}\" and formula "
          "= \"{0}\"",
          column.name, path.substr(0, at + 10) + column.path.substr(at + 1));
  return "";
}

// Samples refused at the same key share one line.
void print_refusals(const SampleTable& samples, const ModelBuilder& build) {
  struct Refused {
    std::string first;
    std::vector<int> samples;
  };
  std::map<std::string, Refused> refused;
  int sample = 0;
  for (const std::vector<Fault>& why : refusals_of(samples, build)) {
    ++sample;
    if (why.empty()) continue;
    Refused& same = refused[why.front().path];
    if (same.samples.empty()) same.first = in_one_line(why);
    same.samples.push_back(sample);
  }
  for (const auto& [path, r] : refused) {
    fmt::print("{} sample{} will be refused ({}), e.g. {}\n", r.samples.size(),
               r.samples.size() == 1 ? "" : "s", some_of(r.samples), r.first);
    if (const std::string cure = follow_cure(samples, path); !cure.empty())
      fmt::print("cure: {}\n", cure);
  }
}

// Notes that no earlier option had; they are added to `told`.
std::vector<Message> new_to(std::vector<Message>& told, const std::vector<Message>& notes) {
  std::vector<Message> out;
  for (const Message& note : notes)
    if (std::find(told.begin(), told.end(), note) == told.end()) out.push_back(note);
  told.insert(told.end(), out.begin(), out.end());
  return out;
}

// Notes of the base model, without values that samples may set and records that a study replaces.
std::vector<Message> notes_of_base(const Model& base, const StudySpec& study) {
  const auto is_of_values = [](const std::string& code) {
    return code == "value.odd" || code == "density.odd" || code == "scatter.odd" ||
           code == "rule.slope_left_out" || code == "office.undivided";
  };
  std::vector<Message> notes;
  for (const Message& note : base.anatomy.notes) {
    const bool is_replaced = study.shaking.is_asked() && note.code.starts_with("shake.");
    if (!is_of_values(note.code) && !is_replaced) notes.push_back(note);
  }
  return notes;
}

// Prints notes of an option; returns the time of one of its samples [s].
double check_option(const VariantSpec& option, std::vector<Message>& told) {
  const StudySpec& study = option.study;
  const ModelBuilder build = model_builder(study);
  const Model model = compile_option(study, build);
  fmt::print("variant \"{}\": blocks {}   joints {}   contact points {}\n", readable(option.name),
             model.n_block, model.n_joint, model.n_point());
  const SampleTable samples = draw_samples(study);
  print_notes(notes_of(study, build({})), true);
  print_notes(new_to(told, notes_of_values(study, samples, build)), true);
  print_refusals(samples, build);
  return estimate(model).seconds;
}

}  // namespace

int check_study_file(const CheckArguments& a) {
  const StudySpec study = read_study(a.file, a.overrides);
  const ModelBuilder build = model_builder(study);
  const Model base = compile(build({}));
  const SampleTable samples = draw_samples(study);
  fmt::print("{}: valid\n", a.file);
  fmt::print("base model: blocks {}   joints {}   contact points {}\n", base.n_block, base.n_joint,
             base.n_point());
  print_inputs(samples);
  print_notes(notes_of(study, build({})), true);
  std::vector<Message> told;
  print_notes(new_to(told, notes_of_values(study, samples, build)), true);
  print_refusals(samples, build);
  print_notes(notes_of_base(base, study), true);
  double seconds = study.shaking.is_asked()
                       ? print_shakes_asked(study, samples, build) / samples.n_sample()
                       : estimate(base).seconds;
  for (const VariantSpec& option : study.option) seconds += check_option(option, told);
  const double cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t each = 1 + study.option.size();
  fmt::print("{} samples{}, {}about {} on {:.0f} cores\n", samples.n_sample(),
             each > 1 ? fmt::format(" of each of {} walls", each) : "",
             study.shaking.climbs() ? "at most " : "",
             duration_text(seconds * samples.n_sample() / cores), cores);
  return 0;
}

}  // namespace wythe::app
