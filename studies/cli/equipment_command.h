#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney equipment ls|show|check`.
/// @param act  becomes what the command does
void add_equipment(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
