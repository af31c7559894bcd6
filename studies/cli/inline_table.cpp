#include "studies/cli/inline_table.h"

#include <fmt/format.h>

#include <cctype>
#include <sstream>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/base/toml_string.h"

namespace gurney::cli {
namespace {

std::string value_of(const std::string& text) {
  const bool bare = number(text) || text == "true" || text == "false" || text.starts_with('[') ||
                    text.starts_with('{') || text.starts_with('"');
  if (!bare) return toml_string(text);
  // TOML wants a digit before the point and no plus sign; .5 and +1 are what people type.
  const auto value = number(text);
  return value ? fmt::format("{}", *value) : text;
}

}  // namespace

std::string inline_table(const std::string& first_key, const std::vector<std::string>& words) {
  require(!words.empty(), fmt::format("a {} needs a name", first_key));
  std::string table = fmt::format("{{ {} = {}", first_key, toml_string(words[0]));
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto equals = words[i].find('=');
    require(equals != std::string::npos && equals > 0,
            fmt::format("'{}' in '{}': must be key=value", words[i], fmt::join(words, " ")));
    table +=
        fmt::format(", {} = {}", words[i].substr(0, equals), value_of(words[i].substr(equals + 1)));
  }
  return table + " }";
}

std::string option_error(const std::string& option, const std::string& text,
                         const std::string& path, const std::string& message) {
  std::istringstream lines(message);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (!result.empty()) result += '\n';
    if (!line.starts_with(option + ":")) {
      result += line;
      continue;
    }
    line.erase(0, line.find(": ") + 2);
    if (line.starts_with(path)) line.erase(0, path.size());
    if (line.starts_with('.')) line.erase(0, 1);
    result += fmt::format("{} \"{}\": {}", option, text, line);
  }
  return result;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (std::isspace(static_cast<unsigned char>(c)) && depth <= 0 && !quoted) {
      if (!words.back().empty()) words.emplace_back();
      continue;
    }
    if (c == '"') quoted = !quoted;
    if (!quoted && std::string_view("([{").find(c) != std::string_view::npos) ++depth;
    if (!quoted && std::string_view(")]}").find(c) != std::string_view::npos) --depth;
    words.back() += c;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string option_table(const std::string& option, const std::string& text,
                         const std::string& first_key) {
  try {
    return inline_table(first_key, words_of(text));
  } catch (const Error& error) {
    throw Error(fmt::format("{} \"{}\": {}", option, text, error.what()));
  }
}

}  // namespace gurney::cli
