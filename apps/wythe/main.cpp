// The wythe program: reads the command line, calls one command, turns errors into exit codes.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "commands.h"
#include "wythe/error.h"
#include "wythe/provenance.h"

namespace {

using namespace wythe::app;

constexpr int kInputError = 2, kEnvironmentError = 4;

std::string version_text() {
  const wythe::Provenance p = wythe::provenance();
  return fmt::format("wythe {} ({}, {}, {})", p.version, p.commit, p.compiler, p.build_type);
}

void add_overrides(CLI::App* command, std::vector<std::string>& overrides) {
  command
      ->add_option("--set", overrides,
                   "override a key: path=value, e.g. stage.push.velocity=\"1 mm/s\"")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, RunArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("run", "push one wall and write its curve, states and report");
  command->footer(
      "example: wythe run examples/tuff_wall/model.toml --out out/tuff --set "
      "stage.push.velocity=\"1 mm/s\"");
  command->add_option("model", a.model, "the wall, MODEL.toml")->required();
  command->add_option("--out", a.out, "folder for the results, made if absent")->required();
  add_overrides(command, a.overrides);
  command->add_option("--threads", a.threads, "threads inside this wall; same bits for any number")
      ->check(CLI::Range(1, 256));
  command->add_flag("--quiet", a.quiet, "no progress");
  command->callback([&] { code = run(a); });
}

void add_check(CLI::App& app, CheckArguments& a, int& code) {
  CLI::App* command = app.add_subcommand("check", "validate a model and print what it compiles to");
  command->footer("example: wythe check examples/tuff_wall/model.toml");
  command->add_option("file", a.file, "MODEL.toml")->required();
  add_overrides(command, a.overrides);
  command->callback([&] { code = check(a); });
}

void add_contact(CLI::App& app, ContactArguments& a, int& code) {
  CLI::App* command =
      app.add_subcommand("contact", "drive one joint along a path of opening and slip");
  command->footer(
      "example: wythe contact examples/joint_law/law.toml --path examples/joint_law/path.csv --out "
      "out.csv");
  command->add_option("law", a.law, "LAW.toml with one [material.joint]")->required();
  command->add_option("--path", a.path, "CSV: opening_mm,slip_mm")->required();
  command->add_option("--out", a.out, "CSV to write")->required();
  command->callback([&] { code = contact(a); });
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(
      "wythe: how strong a masonry wall is, how far it drifts, how it fails, and how sure we are");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  int code = 0;
  RunArguments run_arguments;
  CheckArguments check_arguments;
  ContactArguments contact_arguments;
  add_run(app, run_arguments, code);
  add_check(app, check_arguments, code);
  add_contact(app, contact_arguments, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kInputError;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const wythe::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kInputError;
  } catch (const wythe::IoError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kEnvironmentError;
  } catch (const std::exception& error) {
    fmt::print(stderr, "wythe stopped: {}\n", error.what());
    return kEnvironmentError;
  }
}
