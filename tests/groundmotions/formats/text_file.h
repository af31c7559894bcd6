#pragma once

#include <string>
#include <vector>

#include "groundmotions/formats/format.h"

namespace gurney {

/// What the readers make of a file "f" with this text.
inline std::vector<Component> read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_components(SourceFile("f", text), options);
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

}  // namespace gurney
