#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records scale`: factors that bring a suite to a target spectrum.
/// @param act  is set to what the command does, once it is chosen
void add_records_scale(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
