#include "studies/cli/help.h"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "studies/render/wrapped.h"

namespace gurney::cli {
namespace {

std::string path_of(const CLI::App& app) {
  if (app.get_parent() == nullptr) return {};
  const std::string above = path_of(*app.get_parent());
  return above + (above.empty() ? "" : " ") + app.get_name();
}

/// Choices in the type name of CLI::IsMember: `NAME:{on,off}`.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t from = type.find('{'), to = type.rfind('}');
  std::vector<std::string> choices;
  if (from == std::string::npos || to == std::string::npos) return choices;
  std::istringstream list(type.substr(from + 1, to - from - 1));
  for (std::string each; std::getline(list, each, ',');) choices.push_back(each);
  return choices;
}

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

/// Text of man(7): a hyphen that is one, a backslash, and no line that begins as a request does.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char each : text) {
    if ((each == '.' || each == '\'') && (safe.empty() || safe.back() == '\n')) safe += "\\&";
    if (each == '-') safe += '\\';
    safe += each == '\\' ? "\\e" : std::string(1, each);
  }
  return safe;
}

std::string entry(const CommandOption& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", escaped(name));
  if (!option.value.empty()) names += fmt::format(" \\fI{}\\fR", escaped(option.value));
  std::string description = option.description;
  const std::string choices = fmt::format("{}", fmt::join(option.choices, ", "));
  if (description.find(choices) == std::string::npos) description += " (" + choices + ")";
  return fmt::format(".TP\n{}{}\n{}\n", names, option.repeated ? "..." : "", escaped(description));
}

/// The lines below "Examples:", as they are to be typed.
std::string examples(const std::string& footer) {
  std::istringstream lines(footer);
  std::string line, text;
  if (!std::getline(lines, line) || line != "Examples:") return {};
  while (std::getline(lines, line)) text += escaped(line) + "\n";
  return ".PP\n.nf\n" + text + ".fi\n";
}

std::string section(const Command& command) {
  std::string text = fmt::format(".SS gurney {}\n{}.\n.PP\n\\fB{}\\fR\n", escaped(command.path),
                                 escaped(command.description), escaped(usage(command)));
  for (const CommandOption& option : command.options)
    if (option.names.back() != "--help") text += entry(option);
  return text + examples(command.footer);
}

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
bad input, or \fBgurney doctor\fR found a problem
.TP
.B 2
bad usage
.TP
.B 3
a run failed, or a check failed
.TP
.BR 130 ", " 143
interrupted by SIGINT or SIGTERM
.SH ENVIRONMENT
.TP
.B GURNEY_DATA
the folder of the catalogue: it holds equipment/
.TP
.B COLUMNS
width of the text, from 40 to 100
.SH FILES
.TP
.I share/gurney
beside the folder of the program: catalogue, shipped jobs, records and buildings
)";

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

std::string manual_page(const CLI::App& app, const std::string& version) {
  const std::vector<Command> commands = command_tree(app);
  std::string text = fmt::format(
      ".TH GURNEY 1 \"\" \"gurney {}\" \"User Commands\"\n"
      ".SH NAME\ngurney \\- seismic response of hospital equipment on casters\n"
      ".SH SYNOPSIS\n.B gurney\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\n{}\n.SH COMMANDS\n",
      escaped(version), escaped(commands.front().description));
  for (std::size_t i = 1; i < commands.size(); ++i) text += section(commands[i]);
  return text + kEnd;
}

}  // namespace gurney::cli
