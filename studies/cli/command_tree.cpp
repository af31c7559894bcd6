#include "studies/cli/command_tree.h"

#include <map>
#include <sstream>

namespace gurney::cli {
namespace {

/// Names of values that are neither a number nor a name; those of one command go first.
const std::map<std::string, std::string> kValues = {{"--output", "FILE"},
                                                    {"calibrate --output", "FOLDER"},
                                                    {"export --output", "FOLDER"},
                                                    {"pulling --output", "FOLDER"},
                                                    {"verify --figures", "FOLDER"},
                                                    {"new --from", "FOLDER"},
                                                    {"new --output", "FILE"},
                                                    {"--base", "FILE"},
                                                    {"--building", "FILE"},
                                                    {"--figure", "FILE"},
                                                    {"--hazard", "FILE"},
                                                    {"--job", "FILE"},
                                                    {"--limit-states", "FILE"},
                                                    {"--measured", "FILE"},
                                                    {"--program", "FILE"},
                                                    {"--script", "FILE"},
                                                    {"--factors", "LOW:HIGH"},
                                                    {"--figure-format", "FORMAT"},
                                                    {"--format", "FORMAT"},
                                                    {"--to", "FORMAT"},
                                                    {"--periods", "LOW:HIGH"},
                                                    {"--shard", "I/N"},
                                                    {"--time", "TIME"},
                                                    {"--color", "WHEN"},
                                                    {"--width", "WIDTH"},
                                                    {"--step", "STEP"},
                                                    {"--unit", "UNIT"},
                                                    {"--units", "UNITS"},
                                                    {"--limit-state", "CONDITION"},
                                                    {"--measure", "MEASURE"}};

std::string value_name(const std::string& command, const CLI::Option& option) {
  for (const std::string& name : option.get_lnames())
    for (const std::string& key : {command + " --" + name, "--" + name})
      if (const auto found = kValues.find(key); found != kValues.end()) return found->second;
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));
  return type == "INT" || type == "UINT" || type == "FLOAT" ? "NUMBER" : "NAME";
}

std::string path_of(const CLI::App& app) {
  if (app.get_parent() == nullptr) return {};
  const std::string above = path_of(*app.get_parent());
  return above + (above.empty() ? "" : " ") + app.get_name();
}

/// Of CLI::IsMember: `NAME:{on,off}`.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t from = type.find('{'), to = type.rfind('}');
  std::vector<std::string> choices;
  if (from == std::string::npos || to == std::string::npos) return choices;
  std::istringstream list(type.substr(from + 1, to - from - 1));
  for (std::string each; std::getline(list, each, ',');) choices.push_back(each);
  return choices;
}

}  // namespace

CommandOption option_of(const CLI::Option& option) {
  CommandOption shown;
  shown.positional = option.get_positional();
  if (shown.positional) shown.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_snames()) shown.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) shown.names.push_back("--" + name);
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0 && !shown.positional)
    shown.value = type.substr(0, type.find(':'));
  shown.description = option.get_description();
  shown.choices = choices_of(type);
  shown.repeated = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  shown.required = option.get_required();
  return shown;
}

std::vector<Command> command_tree(const CLI::App& app) {
  Command command{path_of(app), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options({}))
    if (!option->get_group().empty()) command.options.push_back(option_of(*option));
  std::vector<Command> below;
  for (const CLI::App* each : app.get_subcommands({})) {
    command.commands.push_back(each->get_name());
    for (Command& found : command_tree(*each)) below.push_back(std::move(found));
  }
  below.insert(below.begin(), std::move(command));
  return below;
}

std::string usage(const Command& command) {
  std::string line = "gurney" + (command.path.empty() ? "" : " " + command.path) + " [OPTIONS]";
  for (const CommandOption& option : command.options) {
    if (!option.positional) continue;
    const std::string name = option.names.front() + (option.repeated ? "..." : "");
    line += option.required ? " " + name : " [" + name + "]";
  }
  return line + (command.commands.empty() ? "" : " COMMAND");
}

void name_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0) option->type_name(value_name(path_of(app), *option));
  for (CLI::App* command : app.get_subcommands({})) {
    if (app.get_parent() != nullptr) command->group("Commands");
    name_values(*command);
  }
}

}  // namespace gurney::cli
