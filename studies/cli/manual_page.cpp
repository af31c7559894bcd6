#include "studies/cli/manual_page.h"

#include <fmt/format.h>

#include <sstream>

#include "studies/cli/command_tree.h"

namespace gurney::cli {
namespace {

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
