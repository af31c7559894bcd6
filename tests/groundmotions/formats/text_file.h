#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney::groundmotions {

/// What the readers make of a file "f" with this text.
inline std::vector<Component> read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f", text), options);
}

/// The only component of such a file.
inline Component read_one(const std::string& text, const ReadOptions& options = {}) {
  const auto components = read_text(text, options);
  EXPECT_EQ(components.size(), 1u);
  return components.at(0);
}

/// `text` with its first `from` replaced by `to`; it is there.
inline std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// `text` with every `from` replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The value of a fact in the header of a component, or "(none)".
inline std::string fact(const Component& component, const std::string& name) {
  for (const auto& [key, value] : component.header)
    if (key == name) return value;
  return "(none)";
}

}  // namespace gurney::groundmotions
