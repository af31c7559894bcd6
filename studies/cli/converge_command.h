#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney converge` to the program.
/// @param act  gets what to do when the command is given
void add_converge(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
