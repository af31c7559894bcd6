#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gurney::cli {

/// Scripts that complete commands, options, and values of which only some are allowed; where a file
/// may stand, files.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace gurney::cli
