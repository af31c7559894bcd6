#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney fragility` to the program.
void add_fragility(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
