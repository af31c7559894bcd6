#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gurney::cli {

/// One option or positional argument, as help, manual page and completion present it.
struct CommandOption {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional its name
  std::string value;               ///< FILE, FOLDER, NAME or NUMBER; empty: takes none
  std::string description;
  std::vector<std::string> choices;  ///< the only values allowed; empty: any
  bool positional = false, repeated = false, required = false;
};

/// One command, "" being the program itself.
struct Command {
  std::string path;  ///< "records floor"
  std::string description, footer;
  std::vector<CommandOption> options;
  std::vector<std::string> commands;  ///< names of those below it
};

/// Every command, each before those below it, in the order of the help.
std::vector<Command> command_tree(const CLI::App& app);

/// An option that the help shows.
CommandOption option_of(const CLI::Option& option);

/// "gurney run [OPTIONS] JOB"
std::string usage(const Command& command);

/// The layout of --help: what an option takes is a FILE, a NAME or a NUMBER, and descriptions are
/// broken at the width of the terminal.
class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_option(const CLI::Option* option, bool positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// The manual page gurney(1) of all commands, in the language of man(7).
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace gurney::cli
