#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records plot`: one figure for each record.
/// @param act  is set to what the command does, once it is chosen
void add_records_plot(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
