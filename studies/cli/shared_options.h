#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <functional>
#include <string>

#include "equipment/catalogue/catalogue.h"
#include "studies/analysis/assessment.h"
#include "studies/analysis/fragility_result.h"
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
      ->check(Options::one_of({"outcomes", "cloud"}));
}

inline study::CurveMethod curve_method(const std::string& method) {
  return method == "cloud" ? study::CurveMethod::kCloud : study::CurveMethod::kOwn;
}

/// Indices of those configurations, of the named ones or all, that have runs with results. What is left out is
/// said on the error stream.
/// @throws Error if none has
std::vector<std::size_t> configurations_with_runs(const study::StudyData& data,
                                                  const std::vector<std::string>& texts);

/// Indices of limit states by their names; of all where none is named.
std::vector<std::size_t> wanted_states(const study::StudyData& data,
                                       const std::vector<std::string>& names);

/// @param measure  empty: the study's own
/// @param method   of --method
std::vector<study::FragilityResult> fragility_curves(const study::StudyData& data,
                                                     const std::vector<std::size_t>& states,
                                                     const std::vector<std::size_t>& configurations,
                                                     const std::string& measure,
                                                     const std::string& method);

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
  bool overwrite = false;

  bool empty() const { return path.empty(); }

  /// To be called before anything is computed.
  /// @throws Error for a suffix or a width that is none, and unless the file can be written
  void check() const;

  std::string bytes(const std::string& svg) const;

  /// Writes what `draw` returns, if a file is named, and prints its name unless `quiet`.
  void write(const std::function<std::string()>& draw, bool quiet) const;
};

/// Figures to which a command gives names itself: option --figure-format.
struct NamedFigures : FigureStyle {
  std::string format = {};  ///< empty: svg

  /// To be called before anything is computed. @throws Error
  void check() const;
  std::string suffix() const { return "." + (format.empty() ? "svg" : format); }
  std::string bytes(const std::string& svg) const;
};

/// The options of the style.
std::array<CLI::Option*, 2> add_figure_style(Options& add, FigureStyle& style);

inline constexpr const char* kReplacesFigure = "a figure that exists";

/// Options of the style need one that names the file, and so does --overwrite unless it replaces other files too.
/// @param names     of the option that names the file
/// @param replaces  with --overwrite
void add_figure_option(Options& add, FigureFile& file, const std::string& description,
                       const std::string& names = "--figure FILE",
                       const std::string& replaces = kReplacesFigure);
void add_figure_format(Options& add, NamedFigures& figures);

/// The file of an item or of other data on the command line: a name of the catalogue, or a path.
/// @throws Error that begins with `option` and what was written
std::string data_file(equipment::DataKind kind, const std::string& name,
                      const std::string& option = "");

/// The results file that a command writes. @throws Error unless it ends in .h5
std::filesystem::path results_file(const std::filesystem::path& path);

/// Refuses files that are often named in the place of a job, with the command that takes them.
/// @param command  that wants a job
/// @throws Error for a results file and for a file of a record
void require_job(const std::string& path, const std::string& command);

}  // namespace gurney::cli
