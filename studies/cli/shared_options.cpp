#include "studies/cli/shared_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "engine/base/error.h"
#include "engine/base/files.h"
#include "engine/base/shell_word.h"
#include "engine/config/document.h"
#include "equipment/catalogue/catalogue.h"
#include "groundmotions/formats/format.h"
#include "studies/analysis/configuration_view.h"
#include "studies/cli/output.h"
#include "studies/cli/process.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/results/output_files.h"

namespace gurney::cli {
namespace {

/// The signature of HDF5 (File Format Specification, section II.A).
bool is_hdf5(const std::string& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1a\n";
  std::array<char, kSignature.size()> start{};
  std::ifstream file(path, std::ios::binary);
  return file.read(start.data(), start.size()) &&
         std::string_view(start.data(), start.size()) == kSignature;
}

bool is_toml_or_json(const std::string& path) {
  try {
    config::Document unused(path);
  } catch (const Error&) {
    return false;
  }
  return true;
}

bool is_record(const std::string& path) {
  try {
    const groundmotions::SourceFile file(path);
    return std::ranges::any_of(groundmotions::formats(), [&](const groundmotions::Format& each) {
      return each.is_binary != file.is_text() && each.recognises(file);
    });
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

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

std::vector<std::size_t> configurations_with_runs(const study::StudyData& data,
                                                  const std::vector<std::string>& texts) {
  std::vector<std::size_t> wanted = study::wanted_configurations(data, texts);
  std::string left_out;
  std::erase_if(wanted, [&](std::size_t i) {
    if (!data.runs_of(i).empty()) return false;
    const std::string& name = data.configurations()[i];
    left_out += fmt::format("{}: all runs{} failed\n", data.file().path(),
                            name.empty() ? "" : " of " + name);
    return true;
  });
  if (!left_out.empty()) left_out.pop_back();
  require(!wanted.empty(), left_out);
  if (!left_out.empty()) print_error("{}\n", left_out);
  return wanted;
}

std::vector<std::size_t> wanted_states(const study::StudyData& data,
                                       const std::vector<std::string>& names) {
  std::vector<std::size_t> wanted;
  for (const std::string& name : names)
    wanted.push_back(study::index_of(data.limit_states(), name));
  for (std::size_t i = 0; names.empty() && i < data.limit_states().size(); ++i) wanted.push_back(i);
  return wanted;
}

std::vector<study::FragilityResult> fragility_curves(const study::StudyData& data,
                                                     const std::vector<std::size_t>& states,
                                                     const std::vector<std::size_t>& configurations,
                                                     const std::string& measure,
                                                     const std::string& method) {
  std::vector<study::FragilityResult> results;
  for (const std::size_t state : states)
    for (const std::size_t configuration : configurations)
      results.push_back(study::fragility_of(data, {.state = state,
                                                   .configuration = configuration,
                                                   .measure = measure,
                                                   .method = curve_method(method)}));
  return results;
}

picture::Style FigureStyle::style() const {
  picture::Style style{.width_mm = {}, .grey = grey};
  if (!width.empty())
    style.width_mm = from_usage([&] { return picture::length_in_mm(width); }, "--");
  return style;
}

void FigureFile::check() const {
  if (empty()) return;
  from_usage([&] { return picture::format_of(path); });
  style();
  study::OutputFiles(overwrite).check(path);
}

std::string FigureFile::bytes(const std::string& svg) const {
  return picture::written(svg, picture::format_of(path), style());
}

void FigureFile::write(const std::function<std::string()>& draw, bool quiet) const {
  if (!empty()) write_output(path, bytes(draw()), overwrite, quiet);
}

void NamedFigures::check() const {
  require_usage(format.empty() || format == "svg" || format == "pdf" || format == "png",
                "--figure-format " + format + ": must be svg, pdf or png");
  style();
}

std::string NamedFigures::bytes(const std::string& svg) const {
  return picture::written(svg, picture::format_of("figure" + suffix()), style());
}

std::array<CLI::Option*, 2> add_figure_style(Options& add, FigureStyle& style) {
  return {add("--width WIDTH", style.width,
              "Width of the figure: 85mm, 17cm, 3.5in, 240pt, 700px (default: its own)"),
          add("--grey", style.grey, "Grey and dashed lines instead of colours")};
}

void add_figure_option(Options& add, FigureFile& file, const std::string& description,
                       const std::string& names, const std::string& replaces) {
  CLI::Option* const figure = add(names, file.path, description + " (.svg, .pdf or .png)");
  for (CLI::Option* const style : add_figure_style(add, file)) style->needs(figure);
  CLI::Option* const overwrite = add("--overwrite", file.overwrite, "Replace " + replaces);
  if (replaces == kReplacesFigure) overwrite->needs(figure);
}

void add_figure_format(Options& add, NamedFigures& figures) {
  add("--figure-format FORMAT", figures.format,
      "Format of the figures: svg, pdf or png (default: svg)");
  add_figure_style(add, figures);
}

std::string data_file(equipment::DataKind kind, const std::string& name,
                      const std::string& option) {
  try {
    return equipment::find_data(kind, name, "");
  } catch (const Error& error) {
    throw Error(option + name + ": " + error.what());
  }
}

std::filesystem::path results_file(const std::filesystem::path& path) {
  require_usage(path.extension() == ".h5",
                path.string() + ": the results file must end in .h5 (-o FILE.h5)");
  return path;
}

void require_job(const std::string& path, const std::string& command) {
  if (!is_file(path)) return;  // the reader of jobs states why
  const std::string name = shell_word(path);
  require(!is_hdf5(path),
          fmt::format("{}: is a results file; gurney {} takes a job. To see what it "
                      "holds: gurney show {}",
                      path, command, name));
  require(is_toml_or_json(path) || !is_record(path),
          fmt::format("{}: is the file of a record; gurney {} takes a job. To inspect it: gurney "
                      "records info {}; for a job that uses it: gurney new job NAME --record {}",
                      path, command, name, name));
}

}  // namespace gurney::cli
