#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// `gurney compare`: what differs between two studies, or two configurations of one.
void add_compare(CLI::App& app, std::function<int()>& act);

}  // namespace gurney::cli
