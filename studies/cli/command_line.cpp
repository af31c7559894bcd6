#include "studies/cli/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <sstream>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/build_info/build_info.h"
#include "studies/cli/commands.h"
#include "studies/cli/help.h"
#include "studies/cli/json_errors.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/cli/shared_options.h"
#include "studies/render/wrapped.h"
#include "studies/results/hdf5_reader.h"

namespace gurney::cli {
namespace {

constexpr int kDone = 0, kBadInput = 1, kBadUsage = 2;

std::string version() {
  const build_info::BuildInfo build = build_info::build_info();
  return fmt::format(
      "gurney {}\ncommit           {}\ncompiler         {}\nBullet precision {}\n"
      "CPU class        {}\nlibraries        {}",
      build.program_version, build.git_commit, build.compiler, build.bullet_precision,
      build.cpu_class, build_info::libraries());
}

/// The command `help`, which parse_and_run() carries out.
void add_help(Commands& commands) {
  commands.add<bool>(
      {"help", "Print this help, or that of a command",
       "gurney help records scale\ngurney help --man"},
      [](const bool&) { return kDone; },
      [](Options& add, bool& manual) { add("--man", manual, "Print the manual page gurney(1)"); });
}

void add_colour(CLI::App& app) {
  using enum render::Colour;
  const std::map<std::string, render::Colour> known = {
      {"auto", kAuto}, {"always", kAlways}, {"never", kNever}};
  Options(app)
      .calling<std::string>(
          "--color WHEN", [known](const std::string& when) { render::set_colour(known.at(when)); },
          "Bold titles: auto (on a terminal, unless NO_COLOR is set), always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

CLI::App& command_at(CLI::App& app, const std::vector<std::string>& words) {
  CLI::App* at = &app;
  for (const std::string& word : words) {
    if (command_names(*at).empty() || word.starts_with('-')) break;
    at = at->get_subcommand(word);
  }
  return *at;
}

struct Group {
  const char* name;
  std::vector<AddCommand*> commands;
};

/// In the order of the help.
const Group kGroups[] = {
    {"Simulate", {add_run, add_check, add_replay, add_workbench, add_new}},
    {"Look at one run", {add_show, add_explain, add_play, add_plot}},
    {"Analyse studies",
     {add_report, add_fragility, add_compare, add_measures, add_sensitivity, add_loss, add_hospital,
      add_export}},
    {"Motions and equipment", {add_records, add_equipment}},
    {"Verify and calibrate", {add_verify, add_converge, add_pulling, add_calibrate}},
    {"Clusters", {add_submit, add_status, add_merge}},
    {"Program", {add_doctor, add_completion}}};

/// Error in the name of the command, before its options are looked at; empty if none.
std::string unknown_command(CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  for (const std::string& word : words) {
    const std::vector<std::string> names = command_names(*at);
    if (names.empty() || word.starts_with('-')) return {};
    if (std::ranges::find(names, word) == names.end()) {
      const char* const takes = word.ends_with(".toml") ? "run"
                                : word.ends_with(".h5") ? "show"
                                                        : nullptr;
      return fmt::format("unknown command '{}'{}", word,
                         takes == nullptr
                             ? config::suggestion(word, names)
                             : fmt::format("; did you mean 'gurney {} {}'?", takes, word));
    }
    at = at->get_subcommand(word);
  }
  return {};
}

/// @return the exit code, once all output is written
int flushed(int code) {
  std::cout.flush();
  require(std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0,
          "cannot write to the standard output");
  return code;
}

/// Whether the command has the option --json and was given it.
bool wants_json(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const CLI::Option* const json = command->get_option_no_throw("--json");
  return json != nullptr && json->count() > 0;
}

/// An option that a command does not take, or that stands before its name.
std::string unknown_option(const std::string& word, const std::string& command,
                           const std::vector<std::string>& known) {
  const std::string option = word.substr(0, word.find('='));
  if (std::ranges::find(known, option) != known.end())
    return fmt::format("{0}: options of a command stand after it: gurney {1} ... {0}\n", option,
                       command);
  return fmt::format("unknown option {}{}\n", word, config::near_name(option, known));
}

/// Arguments that the command does not take, with the option that each may stand for.
std::string unexpected(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::string path;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    path += (path.empty() ? "" : " ") + command->get_name();
  }
  std::vector<std::string> known;
  for (const CLI::Option* option : command->get_options({}))
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::vector<std::string> left = app.remaining(true);
  std::string text;
  bool option_before = false;  // a word after an unknown option is its value
  for (const std::string& word : words) {
    if (std::ranges::find(left, word) == left.end()) {
      option_before = false;
      continue;
    }
    const bool is_option = word.starts_with('-');
    if (is_option)
      text += unknown_option(word, path, known);
    else if (!option_before)
      text += fmt::format("unexpected argument '{}'\n", word);
    option_before = is_option;
  }
  return text + "Run with --help for more information.\n";
}

/// Prints the help that was asked for, or what is wrong. @return the exit code
int explained(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream output, errors;
  const int code = app.exit(error, output, errors);
  fmt::print("{}", output.str());
  print_error("{}", errors.str());
  return code == 0 ? kDone : kBadUsage;
}

/// An option such as `--seed=` with nothing behind it, for which CLI11 takes the next word; empty if none.
std::string option_without_value(const std::vector<std::string>& words) {
  const auto at = std::ranges::find_if(words, [](const std::string& word) {
    return word.starts_with("--") && word.find('=') + 1 == word.size();
  });
  return at == words.end() ? std::string() : at->substr(0, at->size() - 1);
}

int parse_and_run(CLI::App& app, const std::function<int()>& action, int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool wants_help = !words.empty() && words[0] == "help";
  if (wants_help) words.erase(words.begin());
  if (wants_help && words == std::vector<std::string>{"--man"}) {
    fmt::print("{}", manual_page(app, build_info::build_info().program_version));
    return kDone;
  }
  if (const std::string unknown = unknown_command(app, words); !unknown.empty()) {
    print_error("{}\n", unknown);
    return kBadUsage;
  }
  if (wants_help) {
    fmt::print("{}", command_at(app, words).help());
    return kDone;
  }
  if (const std::string option = option_without_value(words); !option.empty()) {
    print_error("{}: must not be empty\n", option);
    return kBadUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    print_error("{}", unexpected(app, words));
    return kBadUsage;
  } catch (const CLI::ParseError& error) {
    return explained(app, error);
  }
  if (app.get_subcommands().empty()) {
    print_error("a command is needed\n\n{}", app.help());
    return kBadUsage;
  }
  try {
    return action();
  } catch (const CLI::ParseError& error) {  // options that do not go together
    return explained(app, error);
  } catch (const Error& error) {
    if (!wants_json(app)) throw;
    findings::Section errors;
    add_errors(errors, error.what());
    print_findings(errors, true);
    return dynamic_cast<const BadUsage*>(&error) == nullptr ? kBadInput : kBadUsage;
  }
}

/// Runs the command and prints what it throws. @return the exit code
int exit_code_of(CLI::App& app, const std::function<int()>& action, int argc, char** argv) {
  try {
    return flushed(parse_and_run(app, action, argc, argv));
  } catch (const BadUsage& error) {
    print_error("{}\nRun with --help for more information.\n", error.what());
    return kBadUsage;
  } catch (const Error& error) {
    print_error("{}\n", error.what());
  } catch (const std::bad_alloc&) {
    write_error("gurney: not enough memory\n");
  } catch (const std::exception& error) {
    print_error("gurney: {}\n", error.what());
  }
  return kBadInput;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  open_standard_files();
  handle_signals();
  CLI::App app("What will hospital equipment on casters do when the floor shakes?", "gurney");
  app.set_version_flag("--version", version(), "Print versions of the program and its libraries");
  app.formatter(std::make_shared<HelpFormat>());
  app.fallthrough();  // options of the program are known behind a command too
  add_colour(app);
  app.require_subcommand(0, 1);  // what follows it is no command, as in: verify pulling
  app.footer(
      "Exit codes: 0 done, 1 bad input, 2 bad usage, 3 a run failed or a check failed, "
      "130/143 interrupted.");
  std::function<int()> action;
  Commands commands(app, action);
  for (const Group& group : kGroups) {
    commands.set_title(group.name);
    for (AddCommand* const add : group.commands) add(commands);
  }
  add_help(commands);
  const int code = exit_code_of(app, action, argc, argv);
  for (const std::string& path : study::files_without_checksum())
    print_error("{}: caution: no checksum at its end: cut off, or changed by another program\n",
                path);
  return code;
}

}  // namespace gurney::cli
