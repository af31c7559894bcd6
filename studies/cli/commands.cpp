#include "studies/cli/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "engine/config/nearest_name.h"

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

std::function<std::string(const std::string&)> Options::whole_number(int low, int high) {
  return [low, high](const std::string& text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, value);
    const bool right = error == std::errc() && read == end && value >= low && value <= high;
    return right ? std::string()
                 : fmt::format("{}: must be a whole number, {} to {}", text, low, high);
  };
}

CLI::Validator Options::one_of(const std::vector<std::string>& names) {
  const std::string all = fmt::format("{{{}}}", fmt::join(names, ","));
  return {[names, all](const std::string& name) {
            return std::ranges::find(names, name) != names.end()
                       ? std::string()
                       : fmt::format("{} not in {}{}", name, all, config::near_name(name, names));
          },
          all};
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
