#include "groundmotions/synthetic/kinds.h"

#include <fmt/format.h>

#include <limits>
#include <sstream>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/config/document.h"
#include "engine/config/nearest_name.h"
#include "groundmotions/synthetic/component.h"

namespace gurney::groundmotions {

namespace {

std::vector<std::string> kind_names() { return names_of(synthetic_kinds()); }

SyntheticRequest read_values(const SyntheticKind& kind, config::Table& table) {
  SyntheticRequest request{&kind, {}};
  for (const SyntheticParameter& parameter : kind.parameters) {
    const std::string& key = parameter.key;
    request.values[key] = key == "seed" ? table.integer(key, 0, std::numeric_limits<int>::max(),
                                                        static_cast<int>(parameter.fallback))
                                        : table.number(key, parameter.range, parameter.fallback);
  }
  return request;
}

}  // namespace

namespace {

/// "where:1:9: text" is "where: text": lines and columns are of no file.
std::string without_positions(const std::string& message, const std::string& where) {
  std::istringstream lines(message);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += (result.empty() ? "" : "\n") + where + line.substr(line.find(": "));
  return result;
}

}  // namespace

std::optional<SyntheticRequest> read_synthetic_request(config::Table& table) {
  const std::size_t errors = table.document().errors();
  const std::size_t index = table.choice("kind", kind_names());
  if (table.document().errors() != errors) {
    for (const std::string& key : table.keys()) table.set_aside(key);  // of which kind is not known
    return {};
  }
  return read_values(synthetic_kinds()[index], table);
}

SyntheticRequest synthetic_request(const std::string& kind,
                                   const std::vector<std::string>& settings) {
  const SyntheticKind* found = nullptr;
  for (const SyntheticKind& each : synthetic_kinds())
    if (each.name == kind) found = &each;
  require(found != nullptr, fmt::format("records make: unknown kind '{}'{}", kind,
                                        config::suggestion(kind, kind_names())));
  const std::string where = "records make " + kind;
  std::string text;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    require(equals != std::string::npos && equals > 0 && equals + 1 < setting.size() &&
                setting.find_first_of("\r\n#") == std::string::npos,
            fmt::format("{}: '{}': must be key=value, a number", where, setting));
    const std::string value = setting.substr(equals + 1);
    require(number(value).has_value(), fmt::format("{}: {} = '{}': must be a number", where,
                                                   setting.substr(0, equals), value));
    text += fmt::format("{} = {}\n", setting.substr(0, equals), *number(value));
  }
  config::Document document(text, where);
  config::Table table = document.root();
  const SyntheticRequest request = read_values(*found, table);
  try {
    document.finish();
  } catch (const Error& error) {
    throw Error(without_positions(error.what(), where));
  }
  return request;
}

Record make_record(const SyntheticRequest& request) {
  const SyntheticKind& kind = *request.kind;
  try {
    Record record = kind.make(request.values);
    HeaderFacts facts;
    for (const auto& parameter : kind.parameters)
      facts.emplace_back(parameter.key, fmt::format("{}", request.values.at(parameter.key)));
    describe_synthetic(record, kind.name, kind.source, facts);
    return record;
  } catch (const Error& error) {
    throw Error(fmt::format("synthetic {}: {}", kind.name, error.what()));
  }
}

}  // namespace gurney::groundmotions
