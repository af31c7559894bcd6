#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney pulling`.
void add_pulling(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
