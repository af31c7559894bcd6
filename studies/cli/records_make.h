#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records make`: a synthetic motion as a record file.
/// @param act  is set to what the command does, once it is chosen
void add_records_make(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
