#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "engine/base/append_all.h"
#include "engine/base/printable.h"
#include "studies/cli/commands.h"
#include "studies/cli/help.h"
#include "studies/cli/output.h"
#include "studies/doctor/examination.h"
#include "studies/render/wrapped.h"
#include "studies/report/formats.h"

namespace gurney::cli {
namespace {

using doctor::Finding;

void print_text(const std::vector<Finding>& findings) {
  constexpr std::size_t kIndent = 22;
  for (const Finding& each : findings) {
    fmt::print("{:<8} {:<12} {}\n", name_of(each.state), each.name,
               render::wrapped(printable(each.text), kIndent, kIndent));
    if (!each.advice.empty())
      fmt::print("{:22}-> {}\n", "", render::wrapped(each.advice, kIndent + 3, kIndent + 3));
  }
}

void print_json(const std::vector<Finding>& findings) {
  findings::Table table{"findings", "", report::json_columns({"name", "state", "text", "advice"})};
  for (const Finding& each : findings)
    table.add({each.name, name_of(each.state), each.text, each.advice});
  findings::Section all;
  print_findings(all.add(std::move(table)), true);
}

int examine(const bool& json) {
  const std::vector<Finding> findings = doctor::examination();
  json ? print_json(findings) : print_text(findings);
  const auto problems = std::ranges::count(findings, Finding::State::kProblem, &Finding::state),
             warnings = std::ranges::count(findings, Finding::State::kWarning, &Finding::state);
  if (!json) fmt::print("\nproblems: {}, warnings: {}\n", problems, warnings);
  return problems > 0 ? 1 : 0;
}

/// The pattern of a `case`: 'records ls' | 'records floor'
std::string pattern(const std::vector<std::string>& words) {
  return fmt::format("'{}'", fmt::join(words, "' | '"));
}

/// The words that lead to a command, each as COMMAND AND_THE_NEXT_WORD.
std::string known_commands(const std::vector<Command>& commands) {
  std::vector<std::string> known;
  for (const Command& command : commands)
    for (const std::string& below : command.commands) known.push_back(command.path + " " + below);
  return pattern(known);
}

std::vector<std::string> flags_of(const Command& command) {
  std::vector<std::string> flags;
  for (const CommandOption& option : command.options)
    if (!option.positional) append_all(flags, option.names);
  return flags;
}

/// Words that may follow a command: those below it, or the values of its arguments.
std::vector<std::string> words_after(const Command& command) {
  std::vector<std::string> words = command.commands;
  for (const CommandOption& option : command.options)
    if (option.positional) append_all(words, option.choices);
  return words;
}

/// Cases of options with a value: `with(words)` where only these are allowed, else `otherwise`.
template <class With>
std::string value_cases(const std::vector<Command>& commands, With with,
                        const std::string& otherwise) {
  std::string text;
  std::vector<std::string> any;
  for (const Command& command : commands)
    for (const CommandOption& option : command.options) {
      if (option.positional || option.value.empty()) continue;
      std::vector<std::string> at;
      for (const std::string& name : option.names) at.push_back(command.path + " " + name);
      if (option.choices.empty())
        append_all(any, at);
      else
        text += fmt::format("    {}) {} ;;\n", pattern(at), with(option.choices));
    }
  return text + fmt::format("    {}) {} ;;\n", pattern(any), otherwise);
}

/// For zsh's _describe: name and description, with a colon between.
std::string described(const std::string& name, const std::string& description) {
  std::string safe;
  for (const char each : description)
    safe += each == '\'' ? std::string("'\\''") : each == ':' ? "\\:" : std::string(1, each);
  return fmt::format(" '{}:{}'", name, safe);
}

/// Scripts that complete commands, options, and values of which only some are allowed; where a file
/// may stand, files.
std::string bash_completion(const CLI::App& app) {
  const std::vector<Command> commands = command_tree(app);
  std::string cases;
  for (const Command& command : commands)
    cases += fmt::format("    '{}') commands='{}' options='{}' ;;\n", command.path,
                         fmt::join(words_after(command), " "), fmt::join(flags_of(command), " "));
  const auto with = [](const std::vector<std::string>& words) {
    return fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$word\"); return",
                       fmt::join(words, " "));
  };
  return fmt::format(R"(# bash completion of gurney, made by: gurney completion bash
_gurney() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command='' commands='' options='' each
  for each in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$command $each" in
      {}) command=${{command:+$command }}$each ;;
    esac
  done
  COMPREPLY=()
  case "$command $before" in
{}  esac
  case "$command" in
{}  esac
  [[ $word != -* ]] && options=''
  mapfile -t COMPREPLY < <(compgen -W "$commands $options" -- "$word")
}}
complete -o default -F _gurney gurney
)",
                     known_commands(commands), value_cases(commands, with, "return"), cases);
}

std::string zsh_completion(const CLI::App& app) {
  const std::vector<Command> commands = command_tree(app);
  std::string cases;
  for (const Command& command : commands) {
    std::string below, options;
    for (const Command& each : commands)
      for (const std::string& name : command.commands)
        if (each.path == command.path + (command.path.empty() ? "" : " ") + name)
          below += described(name, each.description);
    for (const CommandOption& option : command.options)
      for (const std::string& name : option.positional ? option.choices : option.names)
        (option.positional ? below : options) += described(name, option.description);
    cases += fmt::format("    '{}')\n      commands=({})\n      options=({}) ;;\n", command.path,
                         below, options);
  }
  const auto with = [](const std::vector<std::string>& words) {
    return fmt::format("compadd -- {}; return", fmt::join(words, " "));
  };
  return fmt::format(R"(#compdef gurney
# zsh completion of gurney, made by: gurney completion zsh
_gurney() {{
  local command='' each
  local -a commands options
  for each in "${{(@)words[2,CURRENT-1]}}"; do
    case "$command $each" in
      {}) command=${{command:+$command }}$each ;;
    esac
  done
  case "$command ${{words[CURRENT-1]}}" in
{}  esac
  case "$command" in
{}  esac
  if [[ $PREFIX == -* ]]; then
    _describe option options
  elif (( ${{#commands}} )); then
    _describe command commands
  else
    _files
  fi
}}
_gurney "$@"
)",
                     known_commands(commands), value_cases(commands, with, "_files; return"),
                     cases);
}

struct CompletionOptions {
  std::string shell;
  const CLI::App* program = nullptr;
};

int completion(const CompletionOptions& options) {
  const auto script = options.shell == "bash" ? bash_completion : zsh_completion;
  fmt::print("{}", script(*options.program));
  return 0;
}

}  // namespace

void add_doctor(Commands& commands) {
  commands.add<bool>({"doctor", "Report whether the program works on this machine",
                      "gurney doctor\n"
                      "gurney doctor --json"},
                     examine, [](Options& add, bool& json) { add("--json", json, "Print JSON"); });
}

void add_completion(Commands& commands) {
  commands.add<CompletionOptions>(
      {"completion", "Print the script that completes commands in bash or zsh",
       "source <(gurney completion bash)"},
      completion, [](Options& add, CompletionOptions& options) {
        options.program = &add.program();
        add.required("SHELL", options.shell, "bash or zsh")
            ->check(Options::one_of({"bash", "zsh"}));
      });
}

}  // namespace gurney::cli
