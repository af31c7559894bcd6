#include "studies/cli/help_format.h"

#include <fmt/format.h>

#include <set>

#include "studies/cli/command_tree.h"
#include "studies/render/wrapped.h"

namespace gurney::cli {
namespace {

constexpr std::size_t kIndent = 28;

/// A name with its description beside it, or below if the name is long.
std::string entry(const std::string& name, const std::string& description) {
  std::string text = "  " + name;
  if (text.size() + 2 > kIndent && !description.empty())
    text += "\n" + std::string(kIndent, ' ');
  else
    text.resize(kIndent, ' ');
  return text + render::wrapped(description, kIndent, kIndent) + "\n";
}

/// " (not with --demand)"
std::string relations(const CLI::Option& option) {
  std::set<std::string> all;
  for (const CLI::Option* other : option.get_needs())
    all.insert(fmt::format(" (needs {})", other->get_name()));
  for (const CLI::Option* other : option.get_excludes())
    all.insert(fmt::format(" (not with {})", other->get_name()));
  return fmt::format("{}", fmt::join(all, ""));
}

}  // namespace

HelpFormat::HelpFormat() { label("Positionals", "Arguments"); }

std::string HelpFormat::make_usage(const CLI::App* app, std::string) const {
  return "\nUsage: " + usage(command_tree(*app).front()) + "\n";
}

std::string HelpFormat::make_option(const CLI::Option* option, bool positional) const {
  const CommandOption shown = option_of(*option);
  std::string name =
      positional ? shown.names.front() : fmt::format("{}", fmt::join(shown.names, ", "));
  if (!positional && !shown.value.empty()) name += " " + shown.value;
  if (shown.repeated) name += "...";
  return entry(name, shown.description + relations(*option));
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

}  // namespace gurney::cli
