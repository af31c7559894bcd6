#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney check`: reads a job with all it names and prints what would run. It writes nothing.
/// @param act  gets what the command does; it throws Error with every mistake
void add_check(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
