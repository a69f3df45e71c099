// The wythe program: reads the command line, calls one command, turns errors into exit codes.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <string_view>

#include "assess_command.h"
#include "campaign_commands.h"
#include "commands.h"
#include "report_files.h"
#include "streams.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/solve.h"

namespace {

using namespace wythe::app;

constexpr int kInputError = 2, kEnvironmentError = 4;

std::string version_text() {
  const wythe::Provenance p = wythe::provenance();
  return fmt::format("wythe {} ({}, {}, {}; {})", p.version, p.commit, p.compiler, p.build_type,
                     wythe::instruction_set());
}

void add_overrides(CLI::App* command, std::vector<std::string>& overrides) {
  command
      ->add_option("--set", overrides,
                   "override a key: path=value, e.g. stage.push.velocity=\"1 mm/s\"")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
}

void add_language(CLI::App* command, std::string& language) {
  command->add_option("--lang", language, "language of report.html: en, it, de, fr, es or pt");
}

void add_replace(CLI::App* command, bool& replaces) {
  command->add_flag("--replace", replaces,
                    "replace results of another model or campaign in the folder, too");
}

void add_run(CLI::App& app, RunArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("run", "push one wall and write its curve, states and report");
  command->footer(
      "example: wythe run examples/tuff_wall/model.toml --out out/tuff --set "
      "stage.push.velocity=\"1 mm/s\"");
  command->add_option("model", a.model, "the wall, MODEL.toml");
  command->add_option("--out", a.out, "folder for the results, made if absent");
  add_overrides(command, a.overrides);
  command->add_option("--threads", a.threads, "cores for this wall, 0 all; no change of results")
      ->check(CLI::Range(0, kMostCores));
  command->add_option("--walls", a.walls,
                      "push so many walls that differ by what scatters within them ([scatter], "
                      "[field.*]), and state "
                      "medians and intervals");
  command->add_option("--jobs", a.jobs, "of --walls: how many cores; 0, the default, is all");
  command->add_option("--checkpoint", a.checkpoint,
                      "write a checkpoint into the folder this often, e.g. \"60 s\"");
  command->add_option("--resume", a.resume,
                      "go on from the checkpoint in this folder, in the place of model and --out");
  add_replace(command, a.replaces);
  command->add_flag("--quiet", a.quiet, "no progress");
  add_language(command, a.language);
  command->callback([&] { code = run(a); });
}

void add_check(CLI::App& app, CheckArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "check", "check a model or a study; print its size and the time it will take");
  command->footer("example: wythe check examples/tuff_wall/model.toml");
  command->add_option("file", a.file, "MODEL.toml or STUDY.toml")->required();
  add_overrides(command, a.overrides);
  command->callback([&] { code = check(a); });
}

void add_materials(CLI::App& app, std::string& name, int& code) {
  CLI::App* command = app.add_subcommand(
      "materials", "list typical materials and rules; explain one with values, source and scatter");
  command->footer("example: wythe materials circolare_brick_lime");
  command->add_option("name", name, "name of a typical material or of a rule");
  command->callback([&] { code = materials(name); });
}

void add_contact(CLI::App& app, ContactArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("contact", "stresses of one joint along a path of opening and slip");
  command->footer(
      "example: wythe contact examples/joint_law/law.toml --path examples/joint_law/path.csv --out "
      "out.csv");
  command->add_option("law", a.law, "LAW.toml with one [material.joint]")->required();
  command->add_option("--path", a.path, "CSV: opening_mm,slip_mm")->required();
  command->add_option("--out", a.out, "CSV to write")->required();
  command->callback([&] { code = contact(a); });
}

void add_drawing(CLI::App& app, DrawingArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "drawing", "print the wall and its openings from a drawing of a facade (ASCII DXF)");
  command->footer("example: wythe drawing facade.dxf > model.toml");
  command->add_option("file", a.file, "the drawing, closed rectangles by layer")->required();
  command->add_option("--unit", a.unit,
                      "m, mm, cm, dm, in or ft, in place of what the file states");
  command->add_option("--outline", a.outline, "layer of the wall's outline")->capture_default_str();
  command
      ->add_option("--openings", a.openings,
                   "layer of doors and windows, up to the springing of arches")
      ->capture_default_str();
  command->add_option("--lintels", a.lintels, "layer of lintels")->capture_default_str();
  command->callback([&] { code = drawing(a); });
}

void add_campaign(CLI::App& app, CampaignArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "campaign", "draw the samples of a study, push one wall for each, write statistics");
  command->footer(
      "example: wythe campaign examples/tuff_wall/study.toml --out out/campaign --samples 24");
  command->add_option("study", a.studies, "the study, STUDY.toml; several with --slurm")
      ->required();
  command->add_option("--out", a.out, "folder for the store and results, made if absent")
      ->required();
  command->add_option("--samples", a.samples, "number of samples, in place of the study's");
  command->add_option("--seed", a.seed, "seed of the samples, in place of the study's");
  add_overrides(command, a.overrides);
  command->add_option(
      "--jobs", a.jobs,
      "cores for samples side by side; 0, the default, is all; no change of results");
  command->add_flag("--resume", a.resume, "continue the campaign that the folder holds");
  command->add_flag(
      "--stored", a.stored,
      "with --resume: run what the folder's stores hold, no other study (tasks of an array)");
  command->add_option("--shard", a.shard, "I/N: only samples I, I + N, ...; join with wythe merge");
  command->add_option("--until", a.until,
                      "stop when precise enough, e.g. \"relative_interval(peak_reaction) < 1 %\"");
  command->add_option("--slurm", a.slurm.tasks,
                      "write scripts for a job array of N tasks, in DIR/slurm, and run nothing");
  command->add_flag("--submit", a.slurm.submit, "with --slurm: hand them to sbatch");
  command->add_option("--partition", a.slurm.partition, "with --slurm: partition of the cluster");
  command->add_option("--time", a.slurm.time,
                      "with --slurm: limit of a task as Slurm reads it, e.g. 12:00:00");
  command->add_option("--cores", a.slurm.cores,
                      "with --slurm: cores of a task (default: its whole node)");
  command->add_flag("--quiet", a.quiet, "no progress");
  add_language(command, a.language);
  command->callback([&] { code = campaign(a); });
}

void add_assess(CLI::App& app, AssessArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "assess", "the verdict on a wall, from many walls of its model pushed both ways");
  command->footer("example: wythe assess examples/brick_facade/model.toml --out out/facade");
  command->add_option("model", a.model, "the wall, MODEL.toml, with [assessment] and [scatter]")
      ->required();
  command->add_option("--out", a.out, "folder for the stores and results, made if absent")
      ->required();
  command->add_option("--walls", a.walls,
                      "walls in each way of pushing (default: 8); more with --resume adds to them");
  command->add_option("--until", a.until,
                      "add walls until the 95 % interval of the share that does not meet the limit "
                      "state is narrower than this, e.g. 0.3 (default: none are added)");
  command->add_option("--seed", a.seed, "seed of the walls (default: 0)");
  command->add_option("--between", a.between,
                      "coefficient of variation of strengths from wall to wall, beside what "
                      "scatters within each (default: none)");
  add_overrides(command, a.overrides);
  command->add_option("--jobs", a.jobs,
                      "cores for walls side by side; 0, the default, is all; no change of results");
  command->add_flag("--resume", a.resume, "go on with the walls that the folder holds");
  command->add_flag("--quiet", a.quiet, "no forecast, no progress");
  add_language(command, a.language);
  command->callback([&] { code = assess(a); });
}

void add_status(CLI::App& app, StatusArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "status", "say how far a campaign, its shards and options are, from their stores");
  command->footer("example: wythe status out/campaign");
  command->add_option("folder", a.folder, "folder of the campaign, or of its array")->required();
  command->callback([&] { code = status(a); });
}

void add_store(CLI::App& app, StoreArguments& a, int& code) {
  CLI::App* command = app.add_subcommand("store", "check the store of a campaign");
  command->require_subcommand(1);
  command->footer("example: wythe store check out/campaign");
  CLI::App* check =
      command->add_subcommand("check", "read every byte: of a campaign, its shards and options");
  check->add_option("folder", a.folder, "folder of the campaign, or of its array")->required();
  check->footer("example: wythe store check out/campaign");
  check->callback([&] { code = check_store(a); });
}

void add_merge(CLI::App& app, MergeArguments& a, int& code) {
  CLI::App* command = app.add_subcommand("merge", "join the shards of a campaign");
  command->footer("example: wythe merge out/shard_1 out/shard_2 --out out/campaign");
  command->add_option("folders", a.folders, "folders of the shards, or of an array that holds them")
      ->required();
  command->add_option("--out", a.out, "folder for the joined campaign, made if absent")->required();
  add_language(command, a.language);
  command->callback([&] { code = merge(a); });
}

void add_compare(CLI::App& app, CompareArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "compare", "run models before and after an intervention, or compare campaigns, pair by pair");
  command->footer("example: wythe compare before.toml after.toml --out out/shop");
  command
      ->add_option("folders", a.folders,
                   "models (before.toml after.toml), or folders of campaigns; the base first")
      ->required();
  command->add_option("--out", a.out, "folder for comparison.json and comparison.html")->required();
  add_replace(command, a.replaces);
  command->add_option("--stiffness", a.stiffness,
                      "of models: share by which initial stiffness may change (default: 0.15)");
  command->add_option("--strength", a.strength,
                      "of models: share by which the peak force may fall (default: 0)");
  command->add_option("--displacement", a.displacement,
                      "of models: share by which the displacement capacity may fall (default: 0)");
  command->add_option("--walls", a.walls,
                      "of models with [scatter]: walls in each direction (default: 8)");
  command->add_option("--seed", a.seed, "of models: seed of the walls (default: 0)");
  add_overrides(command, a.overrides);
  command->add_option("--jobs", a.jobs, "cores for walls side by side; 0, the default, is all");
  command->add_flag("--resume", a.resume, "of models: go on with the walls that the folder holds");
  command->add_flag("--quiet", a.quiet, "no progress");
  add_language(command, a.language);
  command->callback([&] { code = compare(a); });
}

void add_replay(CLI::App& app, ReplayArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "replay", "run one sample of a campaign again and write all files of a run");
  command->footer("example: wythe replay out/campaign --sample 17 --out out/sample_17");
  command->add_option("folder", a.folder, "folder of the campaign")->required();
  command->add_option("--sample", a.sample, "number of the sample, from 1")->required();
  command->add_option("--intensity", a.intensity,
                      "of a sample under a record: this shake alone, e.g. \"2 m/s^2\"");
  command->add_option("--out", a.out, "folder for the results, made if absent")->required();
  command->add_option("--threads", a.threads, "cores for this wall, 0 all; no change of results")
      ->check(CLI::Range(0, kMostCores));
  add_replace(command, a.replaces);
  command->add_flag("--quiet", a.quiet, "no progress");
  add_language(command, a.language);
  command->callback([&] { code = replay(a); });
}

void add_limit(CLI::App& app, LimitArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "limit", "check a model by limit analysis of its blocks and by macro-blocks (FM-1, FM-4)");
  command->footer(
      "example: wythe limit examples/tuff_wall/model.toml --out out/limit --with out/campaign");
  command->add_option("model", a.model, "the wall, MODEL.toml")->required();
  command->add_option("--out", a.out, "folder for the results, made if absent")->required();
  command->add_option("--with", a.with, "folder of a run or a campaign to compare with");
  add_overrides(command, a.overrides);
  command->add_option("--only", a.only, "some of: lp infinite macro_block_1 macro_block_2 parts")
      ->check(CLI::IsMember({"lp", "infinite", "macro_block_1", "macro_block_2", "parts"}));
  command->add_flag(
      "--assessment", a.assessment,
      "local mechanisms after Circolare 7/2019, C8.7.1.2.1: parts out of plane, macro-blocks");
  add_replace(command, a.replaces);
  command->add_flag("--quiet", a.quiet, "no progress");
  add_language(command, a.language);
  command->callback([&] { code = limit(a); });
}

void add_report(CLI::App& app, ReportArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("report", "write report.html again from the stored results of a folder");
  command->footer("example: wythe report out/campaign --lang it");
  command->add_option("folder", a.folder, "folder of a run, a campaign or an assessment")
      ->required();
  add_language(command, a.language);
  command->callback([&] { code = report(a); });
}

void add_export(CLI::App& app, ExportArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "export", "write curves, samples and states of a run or a campaign as CSV tables or HDF5");
  command->footer("example: wythe export out/campaign --out out/tables");
  command->add_option("folder", a.folder, "folder of a run or a campaign")->required();
  command->add_option("--out", a.out, "folder for the tables, made if absent")->required();
  command->add_flag("--hdf5", a.hdf5, "one file results.h5 in the place of CSV tables");
  add_replace(command, a.replaces);
  command->callback([&] { code = export_tables(a); });
}

void add_new(CLI::App& app, NewArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("new", "write a commented file to start from, which runs as it is");
  command->footer("example: wythe new facade my_house");
  command->add_option("kind", a.kind, "pier, portal, facade, arch, opening or study")->required();
  command->add_option("folder", a.folder, "folder for the file, made if absent")->required();
  command->callback([&] { code = new_starter(a); });
}

void add_picture(CLI::App& app, PictureArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("picture", "draw the stored states of one sample of a campaign (SVG)");
  command->footer(
      "example: wythe picture out/campaign --sample 17 --at 10 20 40 --out sample_17.svg");
  command->add_option("folder", a.folder, "folder of the campaign")->required();
  command->add_option("--sample", a.sample, "number of the sample, from 1")->required();
  command->add_option("--out", a.out, "SVG file to write")->required();
  command->add_option("--at", a.at_mm, "displacements of the states, mm; default all stored");
  command->add_option("--scale", a.scale, "magnification of displacements; default one that fits");
  command->callback([&] { code = picture(a); });
}

void add_studio(CLI::App& app, StudioArguments& a, int& code) {
  CLI::App* command = app.add_subcommand(
      "studio", "draw a wall in the browser and push it: writes the page and opens it");
  command->footer("example: wythe studio model.toml");
  command->add_option("model", a.model, "model file to begin with");
  command->add_option("--out", a.out, "page to write; default studio.html");
  command->callback([&] { code = studio(a); });
}

// A script with an empty variable passes "", which must not mean 0
// or a missing option: --slurm "" would run the whole campaign here.
void refuse_empty(int argc, char** argv) {
  std::vector<wythe::Fault> faults;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool is_empty_option = argument.starts_with("--") && argument.ends_with("=") &&
                                 argument.find('=') + 1 == argument.size() &&
                                 std::string_view(argv[i - 1]) != "--set";
    const bool is_blank = argument.find_first_not_of(" \t\r\n") == std::string::npos;
    if (!is_blank && !is_empty_option) continue;
    const std::string before = argv[i - 1];
    std::string place = fmt::format("argument {}", i);
    if (is_empty_option) place = argument.substr(0, argument.size() - 1);
    if (is_blank && before.starts_with("--")) place = before;
    faults.push_back(
        {.file = place, .problem = "is empty", .cure = "give it a value, or leave it out"});
  }
  if (!faults.empty()) throw wythe::InputError(std::move(faults));
}

// Refuses a word that is no command. The library would only say that a command is missing.
void refuse_unknown_command(const CLI::App& app, const std::string& before, int argc, char** argv) {
  if (argc < 2) return;
  const std::string word = argv[1];
  std::vector<std::string> names = {"--help"};
  if (before.empty()) names.push_back("--version");
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == word) {
      const bool has_more = !command->get_subcommands({}).empty();
      return has_more ? refuse_unknown_command(*command, word, argc - 1, argv + 1) : void();
    }
    names.push_back(command->get_name());
  }
  if (word == "-h" || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw wythe::InputError({{.file = "wythe" + (before.empty() ? "" : " " + before),
                            .value = word,
                            .problem = word.starts_with("-") ? "there is no such option here"
                                                             : "there is no such command",
                            .cure = wythe::meant_name(word == "help" ? "--help" : word, names)}});
}

// Reports the system's reason, before anything checks whether the file exists.
void refuse_long_path(const std::string& path) {
  std::error_code error;
  static_cast<void>(std::filesystem::symlink_status(path, error));
  constexpr std::size_t kLongestName = 255;  // in bytes, on all common file systems
  bool is_long = error == std::errc::filename_too_long;
  for (const std::filesystem::path& part : std::filesystem::path(path))
    is_long = is_long || part.string().size() > kLongestName;
  if (!is_long) return;
  throw wythe::IoError(
      fmt::format("{}: is too long for the file system; a name has at most 255 bytes, a path 4095",
                  wythe::readable(path, 300)));
}

void check_paths(const CLI::App& command) {
  for (const char* name :
       {"model", "file", "folder", "folders", "study", "law", "--out", "--path", "--with"})
    if (const CLI::Option* option = command.get_option_no_throw(name))
      for (const std::string& path : option->results()) refuse_long_path(path);
}

int parse_and_run(int argc, char** argv) {
  refuse_empty(argc, argv);
  CLI::App app(
      "wythe pushes masonry walls until they fail: strength, drift, failure mode and their "
      "uncertainty");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::function<std::string()>(version_text));
  int code = 0;
  RunArguments run_arguments;
  CheckArguments check_arguments;
  ContactArguments contact_arguments;
  add_run(app, run_arguments, code);
  add_check(app, check_arguments, code);
  add_contact(app, contact_arguments, code);
  std::string material_name;
  add_materials(app, material_name, code);
  DrawingArguments drawing_arguments;
  add_drawing(app, drawing_arguments, code);
  AssessArguments assess_arguments;
  assess_arguments.command.assign(argv, argv + argc);
  add_assess(app, assess_arguments, code);
  CampaignArguments campaign_arguments;
  campaign_arguments.command.assign(argv, argv + argc);
  MergeArguments merge_arguments;
  ReplayArguments replay_arguments;
  ReportArguments report_arguments;
  add_campaign(app, campaign_arguments, code);
  add_merge(app, merge_arguments, code);
  StoreArguments store_arguments;
  add_store(app, store_arguments, code);
  StatusArguments status_arguments;
  add_status(app, status_arguments, code);
  CompareArguments compare_arguments;
  compare_arguments.command.assign(argv, argv + argc);
  add_compare(app, compare_arguments, code);
  add_replay(app, replay_arguments, code);
  add_report(app, report_arguments, code);
  LimitArguments limit_arguments;
  add_limit(app, limit_arguments, code);
  ExportArguments export_arguments;
  add_export(app, export_arguments, code);
  NewArguments new_arguments;
  add_new(app, new_arguments, code);
  PictureArguments picture_arguments;
  add_picture(app, picture_arguments, code);
  StudioArguments studio_arguments;
  add_studio(app, studio_arguments, code);
  refuse_unknown_command(app, "", argc, argv);
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    command->parse_complete_callback([command] { check_paths(*command); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kInputError;
  }
  return code;
}

// Ends the program at once, because a library's destructor may need memory
// too, where no exception can leave it. As after a kill, files are complete.
void say_memory_is_full() {
  constexpr std::string_view kWords =
      "wythe stopped: there is no more memory; what is stored is kept. Ask for less at once "
      "(--jobs), "
      "for a smaller model, or take a larger machine\n";
  static_cast<void>(!::write(STDERR_FILENO, kWords.data(), kWords.size()));
  ::_exit(kEnvironmentError);
}

}  // namespace

int main(int argc, char** argv) {
  make_streams_safe();
  std::set_new_handler(say_memory_is_full);
  try {
    return ended_with(parse_and_run(argc, argv));
  } catch (const wythe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kInputError;
  } catch (const wythe::IoError& error) {
    fmt::print(stderr, "{}\n", wythe::readable_lines(error.what()));
    return kEnvironmentError;
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "{}: {}\n", wythe::readable(error.path1().string()), error.code().message());
    return kEnvironmentError;
  } catch (const std::exception& error) {
    fmt::print(stderr,
               "wythe stopped by a mistake of its own: please report it, with the command and its "
               "files. For the report: {}\n",
               wythe::readable_lines(error.what()));
    return kEnvironmentError;
  }
}
