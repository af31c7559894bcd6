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

/// Gives the values of options their names, instead of CLI11's TEXT, INT and FLOAT.
void name_values(CLI::App& app);

}  // namespace gurney::cli
