#include "studies/cli/json_errors.h"

#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>

#include "engine/base/printable.h"

// Messages are taken apart by hand: they quote files, and std::regex needs stack for each character.
namespace gurney::cli {
namespace {

using Text = std::string_view;

constexpr Text kSpace = " \t\n\v\f\r";

/// A message with its place in a file: `file:line:column: message`, with less of it or none.
struct Parts {
  Text file;
  std::optional<int> line, column;
  Text pointer, message;
};

/// Takes a whole number and the colon behind it off the front of `text`.
std::optional<int> take_number(Text& text) {
  int number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  const bool digits = !text.empty() && text[0] >= '0' && text[0] <= '9';
  if (!digits || problem != std::errc() || !text.substr(length).starts_with(':')) return {};
  text.remove_prefix(length + 1);
  return number;
}

/// `file:line: message` or `file:line:column: message`, at the first place that has so much.
std::optional<Parts> with_line(Text text, bool with_column) {
  for (auto colon = text.find(':', 1); colon != Text::npos; colon = text.find(':', colon + 1)) {
    Text rest = text.substr(colon + 1);
    Parts parts{text.substr(0, colon), take_number(rest), {}, {}, {}};
    if (parts.line && with_column) parts.column = take_number(rest);
    if (!parts.line || parts.column.has_value() != with_column || !rest.starts_with(' ')) continue;
    parts.message = rest.substr(1);
    return parts;
  }
  return {};
}

/// `file.json:/pointer: message`
std::optional<Parts> with_pointer(Text text) {
  constexpr Text kEnding = ".json:/";
  const auto at = text.find(kEnding, 1);
  if (at == Text::npos) return {};
  const auto from = at + kEnding.size() - 1, space = text.find_first_of(kSpace, from);
  if (space == Text::npos || text[space] != ' ' || text[space - 1] != ':') return {};
  return Parts{text.substr(0, from - 1),
               {},
               {},
               text.substr(from, space - 1 - from),
               text.substr(space + 1)};
}

/// `file: message`, where the first word looks like a path.
std::optional<Parts> with_file(Text text) {
  const auto space = text.find_first_of(kSpace);
  if (space == Text::npos || space < 2 || text[space] != ' ' || text[space - 1] != ':') return {};
  const Text file = text.substr(0, space - 1);
  if (file.find_first_of("./") == Text::npos) return {};
  return Parts{file, {}, {}, {}, text.substr(space + 1)};
}

/// The key that a message begins with: `item.headings_deg[2] = 90: ...`. Empty: it has none.
std::string key_of(Text message) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  if (message.empty() || !is_letter(message[0])) return {};
  const Text key = message.substr(0, message.find_first_of(" \t\n\v\f\r:="));
  const Text rest = message.substr(key.size());
  if (rest.empty() && key.ends_with('.')) return std::string(key.substr(0, key.size() - 1));
  if (!rest.starts_with(" = ") && !rest.starts_with(": ")) return {};
  return std::string(key);
}

findings::Value text_or_none(Text text) {
  return text.empty() ? findings::Value() : findings::Value(std::string(text));
}

findings::Section error_of(Text line) {
  auto parts = with_line(line, true);
  if (!parts) parts = with_pointer(line);
  if (!parts) parts = with_line(line, false);
  if (!parts) parts = with_file(line);
  const Parts all = parts.value_or(Parts{{}, {}, {}, {}, line});
  findings::Section error("errors[]");
  error.json("file", text_or_none(all.file)).json("line", all.line).json("column", all.column);
  error.json("key", parts ? text_or_none(key_of(all.message)) : findings::Value());
  error.json("message", shortened(all.message));
  if (!all.pointer.empty()) error.json("pointer", std::string(all.pointer));
  return error;
}

}  // namespace

void add_errors(findings::Section& to, const std::string& text) {
  std::istringstream lines(printable(text));
  for (std::string line; std::getline(lines, line);) to.add(error_of(line));
}

}  // namespace gurney::cli
