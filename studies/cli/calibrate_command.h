#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney calibrate`.
/// @param act  becomes what the command does
void add_calibrate(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
