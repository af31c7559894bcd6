#include "studies/cli/figure_output.h"

#include "engine/base/error.h"
#include "studies/cli/records_output.h"
#include "studies/results/output_files.h"

namespace gurney::cli {

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

void add_figure_style(CLI::App& command, FigureStyle& style) {
  command.add_option("--width", style.width,
                     "Width of the figure: 85mm, 17cm, 3.5in, 240pt, 700px (default: its own)");
  command.add_flag("--grey", style.grey, "Grey and dashed lines instead of colours");
}

void add_figure_option(CLI::App& command, FigureFile& file, const std::string& description) {
  command.add_option("--figure", file.path, description + " (.svg, .pdf or .png)");
  add_figure_style(command, file);
}

void add_figure_format(CLI::App& command, NamedFigures& figures) {
  command.add_option("--figure-format", figures.format,
                     "Format of the figures: svg, pdf or png (default: svg)");
  add_figure_style(command, figures);
}

}  // namespace gurney::cli
