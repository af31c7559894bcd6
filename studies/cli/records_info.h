#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records info` (a page for each record) and `gurney records ls` (a line for each).
/// @param act  is set to what the chosen command does
void add_records_info(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
