#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>

#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/figure_output.h"
#include "studies/cli/method_option.h"
#include "studies/cli/plot_kinds.h"
#include "studies/cli/units_option.h"

namespace gurney::cli {
namespace {

struct PlotOptions {
  PlotRequest request;
  FigureFile figure;
  std::string font_size;
  study::UnitSystem units;
  bool list = false, overwrite = false;
};

/// Texts are laid out at 11 px, which is 8.25 pt where 96 px are an inch.
constexpr double kPagePoints = 8.25, kPxPerMm = 96 / 25.4;

double points_of(const std::string& text) {
  constexpr double kSmallest = 4, kLargest = 40;
  if (text.empty()) return kPagePoints;
  double points = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), points);
  const std::string unit(end, text.data() + text.size());
  require(error == std::errc() && (unit.empty() || unit == "pt") && points >= kSmallest &&
              points <= kLargest,
          fmt::format("--font-size {}: must be {} to {} pt", text, kSmallest, kLargest));
  return points;
}

/// A smaller text leaves a wider page.
figures::PlotPage page_of(PlotOptions& options) {
  constexpr double kNarrowest = 220;
  figures::PlotPage page{.units = options.units};
  if (options.figure.width.empty()) options.figure.width = fmt::format("{}px", page.width);
  page.width = picture::length_in_mm(options.figure.width) * kPxPerMm * kPagePoints /
               points_of(options.font_size);
  require(page.width >= kNarrowest,
          fmt::format("--width {}: too narrow for this size of text; choose a smaller --font-size",
                      options.figure.width));
  return page;
}

int plot(PlotOptions options) {
  if (options.list) {
    fmt::print("{}", plot_list(options.request.file));
    return 0;
  }
  if (!options.request.kind.empty()) check_kind(options.request);
  require(!options.request.kind.empty() && !options.figure.empty(),
          "a figure needs its kind and -o FILE.svg, .pdf or .png; gurney plot FILE --list lists "
          "what can be plotted");
  options.figure.check(options.overwrite);
  const figures::PlotPage page = page_of(options);
  options.figure.write(plotted(options.request, page), options.overwrite, false);
  return 0;
}

}  // namespace

void add_plot(CLI::App& app, std::function<int()>& action) {
  auto shared = std::make_shared<PlotOptions>();
  PlotOptions& options = *shared;
  CLI::App* const command = app.add_subcommand("plot", "Plot what a results file holds");
  command->add_option("FILE", options.request.file, "The results file of a study or of one run")
      ->required();
  command->add_option("KIND", options.request.kind,
                      "history, trajectories, collisions, fragility, ida, stripes, cloud, cdf, "
                      "tornado or spectra");
  command->add_option("WHAT", options.request.what,
                      "Histories, demands, limit states, what was hit, or which spectra "
                      "(default: displacement, peak_displacement, all)");
  command->add_flag("--list", options.list, "List what can be plotted from the file");
  command->add_option("-o,--output", options.figure.path, "The figure (.svg, .pdf or .png)");
  command->add_option("--run", options.request.run, "The run of a history (default: the first)");
  command
      ->add_option("--configuration", options.request.configurations,
                   "Configurations (default: all)")
      ->allow_extra_args(false);
  command->add_option("--measure", options.request.measure,
                      "Intensity measure (default: the study's own)");
  add_method_option(*command, options.request.method);
  command
      ->add_option_function<std::size_t>(
          "--level", [shared](std::size_t level) { shared->request.level = level - 1; },
          "Of tornado and spectra: the N-th level, counted from 1 (default: that nearest to the "
          "median; the highest)")
      ->check(CLI::Range(1, 1000000));
  command->add_option("--job", options.request.job,
                      "The job file, of collisions and spectra (default: the path in the log)");
  add_units_option(*command, options.units);
  add_figure_style(*command, options.figure);
  command->add_option("--font-size", options.font_size, "Size of the labels [pt] (default: 8.25)");
  command->add_flag("--overwrite", options.overwrite, "Replace a figure that exists");
  command->callback([shared, &action] { action = [shared] { return plot(*shared); }; });
}

}  // namespace gurney::cli
