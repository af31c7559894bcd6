#pragma once

#include <functional>
#include <string>

#include "studies/findings/findings.h"

namespace gurney::cli {

/// Adds the lines of an Error as `errors`, each {file, line, column, key, message}; what a line does not
/// state is null. JSON files have places of another kind: `pointer` instead of line and column.
void add_errors(findings::Section& to, const std::string& text);

/// Runs `action`; with `json` an Error is printed as {"errors": [...]} to the standard output.
/// @returns the exit code
int with_json_errors(bool json, const std::function<int()>& action);

}  // namespace gurney::cli
