#pragma once

#include <string>

#include "engine/config/node.h"

namespace gurney::config {

/// @param name  of the file, for messages
/// @throws Error `name:line:column: ...` where the text is not TOML 1.0 or nested deeper than
/// kDeepestNesting.
Node read_toml(const std::string& text, const std::string& name);

}  // namespace gurney::config
