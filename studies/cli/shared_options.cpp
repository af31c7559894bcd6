#include "studies/cli/shared_options.h"

#include <fmt/format.h>

#include "engine/base/error.h"
#include "studies/cli/output.h"
#include "studies/results/output_files.h"

namespace gurney::cli {

void add_limit_state_options(Options& add, study::AssessmentRequest& request) {
  add.single("--limit-state CONDITION", request.limit_states,
             "A limit state instead of those of the job, such as 'peak_displacement > 0.2 m' "
             "or 'NAME = overturned'; repeatable");
  add("--limit-states FILE", request.limit_states_file,
      "File of limit states and performance levels instead of those of the job");
}

CLI::Option* add_hazard_option(Options& add, study::AssessmentRequest& request) {
  return add("--hazard FILE", request.hazard_file,
             "File of the site's hazard curve instead of that of the job");
}

CLI::Option* add_units_option(Options& add, study::UnitSystem& units, const char* usual) {
  const std::vector<std::string> names = study::UnitSystem::names();
  const auto problem = [](const std::string& name) -> std::string {
    try {
      study::UnitSystem{name};
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  return add
      .calling<std::string>(
          "--units UNITS", [&units](const std::string& name) { units = study::UnitSystem(name); },
          fmt::format("Units of what is printed and drawn: {} (default: {})",
                      fmt::join(names, ", "), usual))
      ->check(CLI::Validator(problem, fmt::format("{{{}}}", fmt::join(names, ","))));
}

picture::Style FigureStyle::style() const {
  picture::Style style{.width_mm = {}, .grey = grey};
  if (!width.empty()) style.width_mm = picture::length_in_mm(width);
  return style;
}

void FigureFile::check(bool overwrite) const {
  if (empty()) return;
  picture::format_of(path);
  style();
  study::OutputFiles(overwrite).check(path);
}

std::string FigureFile::bytes(const std::string& svg) const {
  return picture::written(svg, picture::format_of(path), style());
}

void FigureFile::write(const std::string& svg, bool overwrite, bool quiet) const {
  write_output(path, bytes(svg), overwrite, quiet);
}

void NamedFigures::check() const {
  require(format == "svg" || format == "pdf" || format == "png",
          "--figure-format " + format + ": must be svg, pdf or png");
  style();
}

std::string NamedFigures::bytes(const std::string& svg) const {
  return picture::written(svg, picture::format_of("figure" + suffix()), style());
}

void add_figure_style(Options& add, FigureStyle& style) {
  add("--width WIDTH", style.width,
      "Width of the figure: 85mm, 17cm, 3.5in, 240pt, 700px (default: its own)");
  add("--grey", style.grey, "Grey and dashed lines instead of colours");
}

void add_figure_option(Options& add, FigureFile& file, const std::string& description) {
  add("--figure FILE", file.path, description + " (.svg, .pdf or .png)");
  add_figure_style(add, file);
}

void add_figure_format(Options& add, NamedFigures& figures) {
  add("--figure-format FORMAT", figures.format,
      "Format of the figures: svg, pdf or png (default: svg)");
  add_figure_style(add, figures);
}

}  // namespace gurney::cli
