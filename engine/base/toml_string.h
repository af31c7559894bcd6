#pragma once

#include <string>

namespace gurney {

/// A text as a basic string of TOML, in its quotes (TOML 1.0: quotation marks, backslashes and control characters are
/// escaped). Bytes that are not UTF-8 stay: no TOML can have them.
std::string toml_string(const std::string& text);

}  // namespace gurney
