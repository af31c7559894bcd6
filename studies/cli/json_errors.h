#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace gurney::cli {

/// The lines of an Error as a list of {file, line, column, key, message}; what a line does not
/// state is null. JSON files have places of another kind: `pointer` instead of line and column.
nlohmann::ordered_json json_errors(const std::string& text);

/// Runs `action`; with `json` an Error is printed as {"errors": [...]} to the standard output.
/// @returns the exit code
int with_json_errors(bool json, const std::function<int()>& action);

}  // namespace gurney::cli
