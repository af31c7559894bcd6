#pragma once

#include <CLI/CLI.hpp>

namespace gurney::cli {

/// First line and examples of every command's --help.
void describe_commands(CLI::App& app);

}  // namespace gurney::cli
