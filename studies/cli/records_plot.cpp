#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/figure_output.h"
#include "studies/cli/new_folder.h"
#include "studies/cli/record_source.h"
#include "studies/cli/records_output.h"
#include "studies/figures/record_figures.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  RecordSource source;
  std::string output;
  NamedFigures figures;
  bool overwrite = false;
};

int plot(const PlotOptions& options) {
  const fs::path output = options.output;
  const bool one_file = names_a_file(output);
  FigureFile file{options.figures, options.output};
  if (one_file) file.check(options.overwrite);
  options.figures.check();
  std::optional<NewFolder> folder;
  if (!one_file) folder.emplace(output);
  std::size_t count = 0;
  return for_each_record(
      options.source, nullptr,
      [&](const groundmotions::SuiteRecord&, const groundmotions::Record& record) {
        require(!one_file || count++ == 0,
                options.output + ": one figure for several records; name a folder with -o");
        if (!one_file)
          file.path = (output / (file_name(record.name) + options.figures.suffix())).string();
        file.write(figures::record_figure(record), options.overwrite, false);
      });
}

}  // namespace

void add_records_plot(CLI::App& records, std::function<int()>& action) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* const command = records.add_subcommand(
      "plot", "Draw acceleration, velocity, displacement and spectra of records");
  add_source_options(*command, options->source);
  command->add_option("-o,--output", options->output, "A file (.svg, .pdf or .png), or a folder")
      ->required();
  add_figure_format(*command, options->figures);
  command->add_flag("--overwrite", options->overwrite, "Replace files that exist");
  command->callback([options, &action] { action = [options] { return plot(*options); }; });
}

}  // namespace gurney::cli
