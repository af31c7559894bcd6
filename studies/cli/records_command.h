#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records` and its commands. @param act  is set to what the chosen command does
void add_records(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
