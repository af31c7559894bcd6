#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney verify`: holds the engine against closed forms. The exit code is 3 if a check fails.
void add_verify(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
