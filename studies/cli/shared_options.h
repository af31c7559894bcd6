#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "studies/analysis/assessment.h"
#include "studies/analysis/fitted_curve.h"
#include "studies/cli/commands.h"
#include "studies/picture/picture.h"
#include "studies/units/unit_system.h"

namespace gurney::cli {

/// The options --limit-state and --limit-states: limit states instead of those of the job.
void add_limit_state_options(Options& add, study::AssessmentRequest& request);

/// The option --hazard: the hazard of the site instead of that of the job.
CLI::Option* add_hazard_option(Options& add, study::AssessmentRequest& request);

/// The option --units: those in which results are printed and drawn instead of those of the job.
/// @param usual  what rules without it
CLI::Option* add_units_option(Options& add, study::UnitSystem& units,
                              const char* usual = "those of the job");

/// --method of what fits or draws fragility curves.
inline CLI::Option* add_method_option(Options& add, std::string& method) {
  return add("--method", method,
             "outcomes: of the runs, or capacities after an IDA (default); cloud: regression "
             "of the demands, of limit states with a demand above a limit")
      ->check(CLI::IsMember({"outcomes", "cloud"}));
}

inline study::CurveMethod curve_method(const std::string& method) {
  return method == "cloud" ? study::CurveMethod::kCloud : study::CurveMethod::kOwn;
}

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

void add_figure_style(Options& add, FigureStyle& style);
void add_figure_option(Options& add, FigureFile& file, const std::string& description);
void add_figure_format(Options& add, NamedFigures& figures);

}  // namespace gurney::cli
