#pragma once

#include <string>

#include "studies/findings/findings.h"

namespace gurney::cli {

/// Adds the lines of an Error as `errors`, each {file, line, column, key, message}; what a line does not
/// state is null. JSON files have places of another kind: `pointer` instead of line and column.
void add_errors(findings::Section& to, const std::string& text);

}  // namespace gurney::cli
