#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney sensitivity`: which of the drawn numbers rule a demand.
void add_sensitivity(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
