#include "studies/cli/commands.h"

#include <sstream>

namespace gurney::cli {

CLI::Option* Options::named(CLI::Option* option, const std::string& names, bool number) {
  const std::size_t blank = names.find(' ');
  return option->type_name(blank != std::string::npos ? names.substr(blank + 1)
                           : number                   ? "NUMBER"
                                                      : "NAME");
}

CLI::Option* Options::not_empty(CLI::Option* option) {
  if (option->get_positional()) return option;
  return option->check(std::function<std::string(const std::string&)>(
      [](const std::string& text) { return text.empty() ? "must not be empty" : ""; }));
}

CLI::App& Commands::begin(const CommandText& text) {
  std::string footer = "Examples:";
  std::istringstream examples(text.examples);
  for (std::string line; std::getline(examples, line);) footer += "\n  " + line;
  CLI::App& command = *app_.add_subcommand(text.name, text.description);
  command.group(title_);
  command.footer(footer);
  return command;
}

Commands Commands::below(const CommandText& text) {
  CLI::App& command = begin(text);
  command.require_subcommand(1);
  return Commands(command, action_);
}

}  // namespace gurney::cli
