#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/fragility_figures.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/report/fragility_report.h"

namespace gurney::cli {
namespace {

struct FragilityOptions {
  std::string file, measure, second, method;
  FigureFile figure;
  study::AssessmentRequest assessed_by;
  std::vector<std::string> states, configurations, records;
  study::UnitSystem units;
  bool json = false, overwrite = false;
};

/// All where none is named.
template <class Find>
std::vector<std::size_t> chosen(const std::vector<std::string>& names, std::size_t all, Find find) {
  std::vector<std::size_t> result;
  for (const std::string& name : names) result.push_back(find(name));
  for (std::size_t i = 0; names.empty() && i < all; ++i) result.push_back(i);
  return result;
}

std::size_t configuration_index(const study::StudyData& data, const std::string& name) {
  const std::vector<std::string>& names = data.configurations();
  const auto found = std::ranges::find(names, name);
  require(found != names.end(),
          fmt::format("{}: no configuration '{}'{}; it has {}", data.file().path(), name,
                      config::suggestion(name, names), fmt::join(names, "; ")));
  return static_cast<std::size_t>(found - names.begin());
}

/// Curves over one measure.
findings::Section curves(const FragilityOptions& options, const study::StudyData& data,
                         const std::vector<std::size_t>& states,
                         const std::vector<std::size_t>& configurations) {
  std::vector<study::FragilityResult> results;
  for (const std::size_t state : states)
    for (const std::size_t configuration : configurations)
      results.push_back(study::fragility_of(data, {.state = state,
                                                   .configuration = configuration,
                                                   .measure = options.measure,
                                                   .method = curve_method(options.method)}));
  if (!options.figure.empty())
    options.figure.write(figures::fragility_figure(data, results), options.overwrite, true);
  return report::fragility_findings(data, results);
}

/// Surfaces over two.
findings::Section surfaces(const FragilityOptions& options, const study::StudyData& data,
                           const std::vector<std::size_t>& states,
                           const std::vector<std::size_t>& configurations) {
  std::vector<study::VectorResult> results;
  for (const std::size_t state : states)
    for (const std::size_t configuration : configurations)
      results.push_back(
          study::vector_of(data, state, configuration, {options.measure, options.second}));
  if (!options.figure.empty())
    options.figure.write(figures::vector_figure(data, results), options.overwrite, true);
  return report::vector_findings(data, results);
}

int fragility(const FragilityOptions& options) {
  options.figure.check(options.overwrite);
  const study::StudyData data(options.file, options.assessed_by, options.records, options.units);
  const auto states =
      chosen(options.states, data.limit_states().size(),
             [&](const std::string& name) { return study::index_of(data.limit_states(), name); });
  const auto configurations =
      chosen(options.configurations, data.configurations().size(),
             [&](const std::string& name) { return configuration_index(data, name); });
  const auto make = options.second.empty() ? curves : surfaces;
  print_findings(make(options, data, states, configurations), options.json);
  return 0;
}

}  // namespace

void add_fragility(Commands& commands) {
  commands.add<FragilityOptions>(
      {"fragility", "Fit fragility functions and confidence bands",
       "gurney fragility ventilator.h5 --figure ventilator.svg\n"
       "gurney fragility ventilator.h5 --limit overturned --measure \"Sa(1) RotD50\"\n"
       "gurney fragility ventilator.h5 --limit-state \"peak_displacement > 0.2 m\""},
      fragility, [](Options& add, FragilityOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add_limit_state_options(add, options.assessed_by);
        add("--limit", options.states, "Only limit states of this name (default: all)");
        add("--configuration,--configurations", options.configurations,
            "Configurations (default: all)");
        add("--record", options.records, "Only runs of these records (default: all)");
        add("--measure MEASURE", options.measure, "Intensity measure (default: the study's own)");
        CLI::Option* const second =
            add("--and", options.second,
                "A second measure: P given both, and whether it adds to the first");
        add_method_option(add, options.method)->excludes(second);
        add_hazard_option(add, options.assessed_by)->excludes(second);
        add_figure_option(add, options.figure, "Draw the curves");
        add("--overwrite", options.overwrite, "Replace a figure that exists");
        add_units_option(add, options.units);
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
