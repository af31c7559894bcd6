#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gurney::cli {

/// The manual page gurney(1) of all commands, in the language of man(7).
std::string manual_page(const CLI::App& app, const std::string& version);

}  // namespace gurney::cli
