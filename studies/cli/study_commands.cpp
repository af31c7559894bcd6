#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/base/error.h"
#include "studies/analysis/configuration_view.h"
#include "studies/cli/commands.h"
#include "studies/cli/output.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/ranking_figure.h"
#include "studies/figures/study_figures.h"
#include "studies/report/comparison_report.h"
#include "studies/report/fragility_report.h"
#include "studies/report/ranking_report.h"
#include "studies/report/study_report.h"

namespace gurney::cli {
namespace {

/// What is asked of a study, and how the answer is shown.
struct Question {
  std::string file, measure;
  study::AssessmentRequest assessed_by;
  std::vector<std::string> configurations;
  FigureFile figure;
  study::UnitSystem units;
  bool json = false;

  study::StudyData data(const std::vector<std::string>& records = {}) const {
    return study::StudyData(file, assessed_by, records, units);
  }
};

void add_answer_options(Options& add, Question& of) {
  add_units_option(add, of.units);
  add("--json", of.json, "Print JSON, in SI units or those of --units");
}

struct CompareOptions : Question {
  std::string second;  ///< file; empty: two configurations of the first
  std::vector<std::string> demands;
  std::string job;
  bool records = false;  ///< rank those of the first
  std::optional<std::size_t> level;
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
  require_usage(chosen.size() == 2,
                fmt::format("two configurations must be named, --configurations A,B, or a second "
                            "file given\n{}",
                            listed(data)));
  require_usage(chosen[0] != chosen[1],
                fmt::format("--configurations {}: names one twice; must be two that differ\n{}",
                            text, listed(data)));
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
  const std::string job = options.job.empty() ? job_of_log(options.file) : options.job;
  const auto spectra = study::suite_spectra(
      data, {.job = job,
             .level = options.level ? std::optional(*options.level - 1) : std::nullopt,
             .configurations = {configuration}});
  return figures::ranking_figure({.width = 900, .units = options.units}, ranking, spectra.front(),
                                 study::StoredHistories(options.file));
}

/// The records of one study, by what they do.
int rank(const CompareOptions& options) {
  require(options.second.empty(),
          "--records: ranks the records of one study; " + options.second + ": is a second one");
  require(options.demands.size() <= 1, "--records: ranks by one demand");
  const study::StudyData data(options.file, {}, {}, options.units);
  study::RankingRequest request;
  if (!options.demands.empty()) request.demand = options.demands.front();
  if (options.level) request.level = *options.level - 1;
  std::vector<findings::Section> known;
  std::string figure;
  for (const std::size_t configuration : configurations_with_runs(data, options.configurations))
    for (const study::RecordRanking& ranking :
         study::rank_records({&data, configuration}, request)) {
      known.push_back(report::ranking_findings(data, ranking));
      require(options.figure.empty() || figure.empty(),
              "--figure: shows one item in one configuration; name them: --configuration NAME "
              "--demand \"ITEM: peak_displacement\"");
      if (!options.figure.empty()) figure = figure_of(options, data, ranking, configuration);
    }
  print_findings(known, options.json);
  options.figure.write([&] { return figure; }, options.json);
  return 0;
}

int compare(const CompareOptions& options) {
  options.figure.check();
  if (options.records) return rank(options);
  const study::StudyData a = options.data();
  std::optional<study::StudyData> b;
  report::ComparisonReport report;
  const std::string named = fmt::format("{}", fmt::join(options.configurations, ","));
  if (options.second.empty()) {
    choose(a, named, report);
  } else {
    b.emplace(options.second, options.assessed_by, std::vector<std::string>(), options.units);
    choose(a, *b, named, report);
  }
  report.inputs = study::input_differences(report.a, report.b);
  report.found = study::compare_studies(
      report.a, report.b,
      {.demands = options.demands, .measure = options.measure, .confidence = report.confidence});
  print_findings(report::comparison_findings(report), options.json);
  options.figure.write([&] { return figures::comparison_figure(report); }, options.json);
  return 0;
}

struct FragilityOptions : Question {
  std::string second, method;  ///< second: measure
  std::vector<std::string> states, records;
};

/// Curves over one measure.
findings::Section curves(const FragilityOptions& options, const study::StudyData& data,
                         const std::vector<std::size_t>& states,
                         const std::vector<std::size_t>& configurations) {
  const auto results =
      fragility_curves(data, states, configurations, options.measure, options.method);
  options.figure.write([&] { return figures::fragility_figure(data, results); }, true);
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
  options.figure.write([&] { return figures::vector_figure(data, results); }, true);
  return report::vector_findings(data, results);
}

int fragility(const FragilityOptions& options) {
  options.figure.check();
  const study::StudyData data = options.data(options.records);
  const auto make = options.second.empty() ? curves : surfaces;
  print_findings(make(options, data, wanted_states(data, options.states),
                      study::wanted_configurations(data, options.configurations)),
                 options.json);
  return 0;
}

struct MeasuresOptions : Question {
  std::vector<std::string> states;
};

int measures(const MeasuresOptions& options) {
  const study::StudyData data = options.data();
  const std::vector<std::size_t> states =
      options.states.empty() ? study::sized_states(data) : wanted_states(data, options.states);
  require(!states.empty(),
          options.file +
              ": no limit state has a demand above a limit, so there is no size to "
              "predict");
  std::vector<findings::Section> known;
  for (const std::size_t configuration : configurations_with_runs(data, options.configurations))
    for (const std::size_t state : states) {
      const study::LimitState& limit = data.limit_states()[state];
      known.push_back(report::measure_findings(
          {data.configurations()[configuration], limit.name, limit.words,
           study::rank_measures({&data, configuration}, state), options.units}));
    }
  print_findings(known, options.json);
  return 0;
}

struct SensitivityOptions : Question {
  std::string demand, limit;
  int level = 0;  ///< counted from 1; 0: that nearest to a median
  bool all_levels = false;
};

/// The limit state that is given, else the peak displacement.
void choose_output(const SensitivityOptions& options, const study::StudyData& data,
                   study::SensitivityRequest& request) {
  if (options.assessed_by.empty()) {
    request.demand = "peak_displacement";
    return;
  }
  require(data.limit_states().size() == 1,
          "several limit states are given; --limit NAME states which to explain");
  request.limit = data.limit_states().front().name;
}

int sensitivity(const SensitivityOptions& options) {
  options.figure.check();
  const study::StudyData data = options.data();
  study::SensitivityRequest request{.demand = options.demand, .limit = options.limit, .level = {}};
  if (options.demand.empty() && options.limit.empty()) choose_output(options, data, request);
  request.all_levels = options.all_levels;
  if (options.level > 0) {
    require(data.study().intensity.kind != study::IntensityPlan::Kind::kIda,
            options.file + ": an IDA has no levels common to all records; omit --level");
    request.level = static_cast<std::size_t>(options.level - 1);
  }
  const auto wanted = configurations_with_runs(data, options.configurations);
  require(options.figure.empty() || wanted.size() == 1,
          fmt::format("--figure draws one configuration; name it with --configuration: {}",
                      fmt::join(data.configurations(), "; ")));
  std::vector<report::SensitivityReport> reports;
  std::size_t found = 0;
  for (const std::size_t configuration : wanted) {
    report::SensitivityReport report{data.configurations()[configuration], {}, "", options.units};
    try {
      report.found = study::study_sensitivity({&data, configuration}, request);
      ++found;
    } catch (const Error& error) {
      if (wanted.size() == 1) throw;
      report.why_not = error.what();
    }
    reports.push_back(std::move(report));
  }
  if (found == 0) throw Error(reports.front().why_not);
  std::vector<findings::Section> known;
  for (const report::SensitivityReport& each : reports)
    known.push_back(report::sensitivity_findings(each));
  print_findings(known, options.json);
  options.figure.write([&] { return figures::sensitivity_figure(reports.front()); }, options.json);
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
        add.required("A", options.file, "The results file of a study");
        add("B", options.second, "A second results file (default: two configurations of A)");
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
        add_answer_options(add, options);
      });
}

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
        add_answer_options(add, options);
      });
}

void add_measures(Commands& commands) {
  commands.add<MeasuresOptions>(
      {"measures", "Compare intensity measures: efficiency and sufficiency",
       "gurney measures ventilator.h5"},
      measures, [](Options& add, MeasuresOptions& options) {
        add.required("FILE", options.file, "The results file of the study");
        add_limit_state_options(add, options.assessed_by);
        add.single(
            "--limit", options.states,
            "Limit states whose demand is predicted (default: all with a demand above a limit)");
        add.single("--configuration", options.configurations, "Configurations (default: all)");
        add_answer_options(add, options);
      });
}

void add_sensitivity(Commands& commands) {
  commands.add<SensitivityOptions>(
      {"sensitivity", "Rank uncertain parameters by their influence on a demand",
       "gurney sensitivity ventilator.h5 --demand peak_displacement"},
      sensitivity, [](Options& add, SensitivityOptions& options) {
        add.required("FILE", options.file, "The results file of a study with draws");
        CLI::Option* const demand =
            add("--demand", options.demand, "The demand to explain (default: peak_displacement)");
        add("--limit", options.limit, "Explain whether this limit state is exceeded")
            ->excludes(demand);
        add_limit_state_options(add, options.assessed_by);
        add.single("--configuration", options.configurations, "Configurations (default: all)");
        CLI::Option* const level =
            add("--level", options.level,
                "Runs at the N-th level, counted from 1 (default: that nearest to the median "
                "of the limit state)")
                ->check(CLI::Range(1, 1000000));
        add("--all-levels", options.all_levels, "Runs at all levels together")->excludes(level);
        add_figure_option(add, options.figure, "Draw indices and tornado of one configuration");
        add_answer_options(add, options);
      });
}

}  // namespace gurney::cli
