#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records floor`: the motion of a floor of a building under a ground motion.
/// @param act  is set to what the command does, once it is chosen
void add_records_floor(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
