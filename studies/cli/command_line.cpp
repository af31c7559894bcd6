#include "studies/cli/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <memory>

#include "engine/base/error.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/records_command.h"
#include "studies/cli/run_command.h"
#include "studies/cli/signals.h"

namespace gurney {
namespace {

constexpr int kDone = 0, kBadInput = 1, kBadUsage = 2;

std::string version() {
  const BuildInfo build = build_info();
  return fmt::format(
      "gurney {}\ncommit           {}\ncompiler         {}\nBullet precision {}\n"
      "CPU class        {}",
      build.program_version, build.git_commit, build.compiler, build.bullet_precision,
      build.cpu_class);
}

void add_run(CLI::App& app, std::function<int()>& act) {
  auto held = std::make_shared<RunOptions>();
  RunOptions& options = *held;
  CLI::App* const run = app.add_subcommand("run", "Run one job: an item under a record or a pull");
  run->add_option("JOB", options.job,
                  "The job file, such as studies/jobs/icu_ventilator_shake.toml")
      ->required();
  run->add_option("-o,--output", options.output,
                  "The results file; the figure and the log stand beside it "
                  "(default: out/<name of the job>.h5)");
  run->add_flag("--overwrite", options.overwrite, "Replace files that exist");
  run->add_flag("--json", options.json, "Print the summary as JSON");
  run->add_flag("--no-figure", options.no_figure, "Draw no figure");
  run->callback([held, &act] { act = [held] { return run_command(*held); }; });
}

}  // namespace

int run_command_line(int argc, char** argv) {
  handle_signals();
  CLI::App app("What will hospital equipment on casters do when the floor shakes?", "gurney");
  app.set_version_flag("--version", version());
  app.footer(
      "Exit codes: 0 done, 1 bad input, 2 bad usage, 3 a run diverged, 130/143 interrupted.");
  std::function<int()> act;
  add_run(app, act);
  add_records(app, act);
  CLI::App* const help = app.add_subcommand("help", "Print this help");
  try {
    app.parse(argc, argv);
    if (help->parsed()) {
      fmt::print("{}", app.help());
      return kDone;
    }
    if (app.get_subcommands().empty()) {
      fmt::print(stderr, "a command is needed\n\n{}", app.help());
      return kBadUsage;
    }
    return act();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadUsage;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "gurney: {}\n", error.what());
  }
  return kBadInput;
}

}  // namespace gurney
