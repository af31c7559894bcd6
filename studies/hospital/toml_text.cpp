#include "studies/hospital/toml_text.h"

#include <fmt/format.h>

#include "engine/base/files.h"
#include "engine/base/toml_string.h"

namespace gurney::study {
namespace {

namespace fs = std::filesystem;

std::string joined(const config::Node& of, char open, char close, const auto& text_of) {
  std::string text(1, open);
  for (const config::Node& each : of.elements)
    text += (text.size() > 1 ? ", " : "") + text_of(each);
  return text + close;
}

/// A building, which has a floor, may be one of the catalogue (equipment::find_data()).
bool is_path(const config::Node& table, const config::Node& value) {
  if (value.key != "file") return value.key == "suite";
  const bool named = !value.text.ends_with(".toml") && value.text.find('/') == std::string::npos;
  return table.find("kind") == nullptr && !(named && table.find("floor") != nullptr);
}

std::string written(const config::Node& value, const fs::path& folder, bool path) {
  using Kind = config::Node::Kind;
  switch (value.kind) {
    case Kind::kBoolean:
      return value.boolean ? "true" : "false";
    case Kind::kInteger:
      return fmt::format("{}", value.integer);
    case Kind::kNumber:
      return fmt::format("{}", value.number);
    case Kind::kText:
      return toml_string(path ? fs::absolute(folder / value.text).lexically_normal().string()
                              : value.text);
    case Kind::kArray:
      return joined(value, '[', ']',
                    [&](const config::Node& each) { return written(each, folder, path); });
    case Kind::kTable:
      return joined(value, '{', '}', [&](const config::Node& each) {
        return toml_string(each.key) + " = " + written(each, folder, is_path(value, each));
      });
    case Kind::kOther:
      break;
  }
  return value.text;
}

}  // namespace

std::string inline_toml(const config::Node& value, const fs::path& folder) {
  return written(value, folder, false);
}

std::string inline_toml(const config::Node& parent, const std::string& key, const std::string& name,
                        const fs::path& folder) {
  if (parent.kind == config::Node::Kind::kTable) return inline_toml(*parent.find(key), folder);
  for (const config::Node& each : parent.elements)
    if (const config::Node* const of = each.find("name"); of != nullptr && of->text == name)
      return inline_toml(*each.find(key), folder);
  return {};
}

}  // namespace gurney::study
