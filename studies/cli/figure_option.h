#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gurney::cli {

/// The option --figure of a command. Figures are SVG: another ending than .svg is a wrong usage.
void add_figure_option(CLI::App& command, std::string& path, const std::string& description);

}  // namespace gurney::cli
