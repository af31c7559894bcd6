#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney show` to the program.
void add_show(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
