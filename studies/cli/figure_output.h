#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "studies/picture/picture.h"

namespace gurney::cli {

/// How the figures of a command are written: options --width and --grey.
struct FigureStyle {
  std::string width;  ///< as given: "85mm"; empty: the figure's own
  bool grey = false;

  /// @throws Error for a width that is none
  picture::Style style() const;
};

/// A figure that a command writes to a file the user names: option --figure.
struct FigureFile : FigureStyle {
  std::string path;

  bool empty() const { return path.empty(); }

  /// To be called before anything is computed.
  /// @throws Error for a suffix or a width that is none, and unless the file can be written
  void check(bool overwrite) const;

  std::string bytes(const std::string& svg) const;

  /// Prints the name of the file unless `quiet`.
  void write(const std::string& svg, bool overwrite, bool quiet) const;
};

/// Figures to which a command gives names itself: option --figure-format.
struct NamedFigures : FigureStyle {
  std::string format = "svg";

  /// To be called before anything is computed. @throws Error
  void check() const;
  std::string suffix() const { return "." + format; }
  std::string bytes(const std::string& svg) const;
};

void add_figure_style(CLI::App& command, FigureStyle& style);
void add_figure_option(CLI::App& command, FigureFile& file, const std::string& description);
void add_figure_format(CLI::App& command, NamedFigures& figures);

}  // namespace gurney::cli
