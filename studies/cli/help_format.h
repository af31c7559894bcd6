#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gurney::cli {

/// The layout of --help: what an option takes is a FILE, a NAME or a NUMBER, and descriptions are
/// broken at the width of the terminal.
class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_option(const CLI::Option* option, bool positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

}  // namespace gurney::cli
