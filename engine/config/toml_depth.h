#pragma once

#include <optional>
#include <string>

#include "engine/config/node.h"

namespace gurney::config {

/// How deep tables and arrays may be in each other; the readers refuse more before they recurse.
inline constexpr int kDeepestNesting = 64;

/// Where tables and arrays of a TOML text, dotted keys and headers included, are first nested
/// deeper than kDeepestNesting. The parser and the tree that it makes are recursive.
std::optional<Place> find_too_deep(const std::string& text);

}  // namespace gurney::config
