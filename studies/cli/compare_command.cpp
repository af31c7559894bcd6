#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/fragility_figures.h"
#include "studies/figures/ranking_figure.h"
#include "studies/report/comparison_report.h"
#include "studies/report/ranking_report.h"

namespace gurney::cli {
namespace {

struct CompareOptions {
  std::string a, b;  ///< results files of studies; b empty: two configurations of a
  std::vector<std::string> configurations, demands;
  std::string measure, job;
  bool records = false;  ///< rank those of a
  std::optional<std::size_t> level;
  FigureFile figure;
  study::AssessmentRequest assessed_by;
  study::UnitSystem units;
  bool overwrite = false, json = false;
};

std::string listed(const study::StudyData& data) {
  return fmt::format("{}: {}", data.file().path(), fmt::join(data.configurations(), "; "));
}

/// Two configurations of one file.
void choose(const study::StudyData& data, const std::string& text,
            report::ComparisonReport& report) {
  require(data.configurations().size() > 1,
          data.file().path() + ": has one configuration; name a second file to compare it with");
  std::vector<std::size_t> chosen = study::named_configurations(data, text);
  if (text.empty() && data.configurations().size() == 2) chosen = {0, 1};
  require(chosen.size() == 2,
          fmt::format("two configurations must be named, --configurations A,B, or a second file "
                      "given\n{}",
                      listed(data)));
  report.a = {&data, chosen[0]};
  report.b = {&data, chosen[1]};
  report.name_a = report.label_a = report.a.configuration_name();
  report.name_b = report.label_b = report.b.configuration_name();
}

/// The configuration of a file that a text names by itself.
std::optional<std::size_t> only(const study::StudyData& data, const std::string& text) {
  if (text.empty() && data.configurations().size() == 1) return 0;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    if (!text.empty() && data.configurations()[i] == text) return i;
  return {};
}

/// The configurations where they tell the sides apart, else the files.
void set_labels(report::ComparisonReport& report) {
  report.label_a = report.a.configuration_name();
  report.label_b = report.b.configuration_name();
  if (report.label_a != report.label_b && !report.label_a.empty() && !report.label_b.empty())
    return;
  const std::filesystem::path a = report.a.data->file().path(), b = report.b.data->file().path();
  const bool differ = a.stem() != b.stem();
  report.label_a = (differ ? a.stem() : a).string();
  report.label_b = (differ ? b.stem() : b).string();
}

/// One configuration of each file: one name for both, or two apart by a comma.
void choose(const study::StudyData& a, const study::StudyData& b, const std::string& text,
            report::ComparisonReport& report) {
  auto first = only(a, text), second = only(b, text);
  for (auto comma = text.find(','); !(first && second) && comma != std::string::npos;
       comma = text.find(',', comma + 1)) {
    const auto start = text.find_first_not_of(' ', comma + 1);
    first = only(a, text.substr(0, comma));
    second = start == std::string::npos ? std::nullopt : only(b, text.substr(start));
  }
  require(first && second,
          fmt::format("{}a configuration of each file must be named, --configuration NAME, or "
                      "NAME,NAME where they differ\n{}\n{}",
                      text.empty() ? "" : fmt::format("--configuration '{}': ", text), listed(a),
                      listed(b)));
  report.a = {&a, *first};
  report.b = {&b, *second};
  const auto name = [](const study::ConfigurationView& side) {
    const std::string& of = side.configuration_name();
    return side.data->file().path() + (of.empty() ? "" : " (" + of + ")");
  };
  report.name_a = name(report.a);
  report.name_b = name(report.b);
  set_labels(report);
}

std::string figure_of(const CompareOptions& options, const study::StudyData& data,
                      const study::RecordRanking& ranking, std::size_t configuration) {
  const std::string job = options.job.empty() ? job_of_log(options.a) : options.job;
  const auto spectra = study::suite_spectra(
      data, {.job = job,
             .level = options.level ? std::optional(*options.level - 1) : std::nullopt,
             .configurations = {configuration}});
  return figures::ranking_figure({.width = 900, .units = options.units}, ranking, spectra.front(),
                                 study::StoredHistories(options.a));
}

/// The records of one study, by what they do.
int rank(const CompareOptions& options) {
  require(options.b.empty(),
          "--records: ranks the records of one study; " + options.b + ": is a second one");
  require(options.demands.size() <= 1, "--records: ranks by one demand");
  const study::StudyData data(options.a, {}, {}, options.units);
  study::RankingRequest request;
  if (!options.demands.empty()) request.demand = options.demands.front();
  if (options.level) request.level = *options.level - 1;
  std::vector<findings::Section> known;
  std::string figure;
  for (const std::size_t configuration : study::wanted_configurations(data, options.configurations))
    for (const study::RecordRanking& ranking :
         study::rank_records({&data, configuration}, request)) {
      known.push_back(report::ranking_findings(data, ranking));
      require(options.figure.empty() || figure.empty(),
              "--figure: shows one item in one configuration; name them: --configuration NAME "
              "--demand \"ITEM: peak_displacement\"");
      if (!options.figure.empty()) figure = figure_of(options, data, ranking, configuration);
    }
  print_findings(known, options.json);
  if (!figure.empty()) options.figure.write(figure, options.overwrite, options.json);
  return 0;
}

int compare(const CompareOptions& options) {
  options.figure.check(options.overwrite);
  if (options.records) return rank(options);
  const study::StudyData a(options.a, options.assessed_by, {}, options.units);
  std::optional<study::StudyData> b;
  report::ComparisonReport report;
  const std::string named = fmt::format("{}", fmt::join(options.configurations, ","));
  if (options.b.empty()) {
    choose(a, named, report);
  } else {
    b.emplace(options.b, options.assessed_by, std::vector<std::string>(), options.units);
    choose(a, *b, named, report);
  }
  report.inputs = study::input_differences(report.a, report.b);
  report.found = study::compare_studies(
      report.a, report.b,
      {.demands = options.demands, .measure = options.measure, .confidence = report.confidence});
  print_findings(report::comparison_findings(report), options.json);
  if (!options.figure.empty())
    options.figure.write(figures::comparison_figure(report), options.overwrite, options.json);
  return 0;
}

}  // namespace

void add_compare(Commands& commands) {
  commands.add<CompareOptions>(
      {"compare", "Compare configurations pairwise, or the records of a study",
       "gurney compare ventilator.h5 --configurations off,on\n"
       "gurney compare first.h5 second.h5\n"
       "gurney compare ventilator.h5 --records --configuration off --figure records.svg"},
      compare, [](Options& add, CompareOptions& options) {
        add.required("A", options.a, "The results file of a study");
        add("B", options.b, "A second results file (default: two configurations of A)");
        add.single("--configuration,--configurations", options.configurations,
                   "Configurations: one for both files, or two, separated by a comma");
        add.single("--demand", options.demands, "Demands (default: all non-negative demands)");
        add("--measure MEASURE", options.measure,
            "Intensity measure of the curves (default: the studies' own)");
        add_limit_state_options(add, options.assessed_by);
        CLI::Option* const records =
            add("--records", options.records,
                "Rank the records of A by a demand (default: peak_displacement), and state which "
                "intensity measure explains the order");
        add("--level", options.level,
            "Of --records: the N-th level, counted from 1 (default: the highest)")
            ->check(CLI::Range(1, 1000000))
            ->needs(records);
        add("--job", options.job,
            "Of --records with --figure: the job, if it is not where the log says")
            ->needs(records);
        add_figure_option(add, options.figure, "Draw the fragility curves, or spectra and paths");
        add("--overwrite", options.overwrite, "Replace a figure that exists");
        add_units_option(add, options.units);
        add("--json", options.json, "Print JSON, in SI units or those of --units");
      });
}

}  // namespace gurney::cli
