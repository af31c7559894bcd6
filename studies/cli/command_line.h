#pragma once

namespace gurney::cli {

/// The command line of `gurney`: reads the arguments, runs the command, prints errors.
/// @returns the exit code (docs/conventions.md)
int run_command_line(int argc, char** argv);

}  // namespace gurney::cli
