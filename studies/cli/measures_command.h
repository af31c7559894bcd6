#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney measures`: which intensity measure predicts the demands of a study best.
void add_measures(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
