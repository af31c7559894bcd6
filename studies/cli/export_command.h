#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney export` to the program.
void add_export(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
