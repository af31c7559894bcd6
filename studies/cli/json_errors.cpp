#include "studies/cli/json_errors.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

#include "engine/base/error.h"

namespace gurney::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The key that a message begins with: `item.headings_deg[2] = 90: ...`.
Json key_of(const std::string& message) {
  static const std::regex kKey(R"(^([A-Za-z_][^\s:=]*)( = |: |\.$))");
  std::smatch found;
  return std::regex_search(message, found, kKey) ? Json(found[1].str()) : Json();
}

Json error_of(const std::string& line) {
  static const std::regex kPlace(R"(^(.+?):(\d+):(\d+): (.*)$)"), kLine(R"(^(.+?):(\d+): (.*)$)"),
      kPointer(R"(^(.+?\.json):(/\S*): (.*)$)"), kFile(R"(^(\S*[./]\S*): (.*)$)");
  Json error = {{"file", nullptr},
                {"line", nullptr},
                {"column", nullptr},
                {"key", nullptr},
                {"message", line}};
  std::smatch found;
  if (std::regex_match(line, found, kPlace)) {
    error["line"] = std::stoi(found[2]);
    error["column"] = std::stoi(found[3]);
  } else if (std::regex_match(line, found, kPointer)) {
    error["pointer"] = found[2].str();
  } else if (std::regex_match(line, found, kLine)) {
    error["line"] = std::stoi(found[2]);
  } else if (!std::regex_match(line, found, kFile)) {
    return error;
  }
  error["file"] = found[1].str();
  error["message"] = found[found.size() - 1].str();
  error["key"] = key_of(error["message"]);
  return error;
}

}  // namespace

Json json_errors(const std::string& text) {
  Json errors = Json::array();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) errors.push_back(error_of(line));
  return errors;
}

int with_json_errors(bool json, const std::function<int()>& action) {
  if (!json) return action();
  try {
    return action();
  } catch (const Error& error) {
    fmt::print("{}\n", Json{{"errors", json_errors(error.what())}}.dump(2));
    return 1;
  }
}

}  // namespace gurney::cli
