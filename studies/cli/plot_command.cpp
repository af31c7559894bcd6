#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/names.h"
#include "engine/base/number_text.h"
#include "engine/base/shell_word.h"
#include "engine/config/nearest_name.h"
#include "studies/analysis/configuration_view.h"
#include "studies/analysis/overview.h"
#include "studies/cli/commands.h"
#include "studies/cli/repeated_run.h"
#include "studies/cli/shared_options.h"
#include "studies/figures/chart.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/plan_figures.h"
#include "studies/figures/record_figures.h"
#include "studies/figures/study_figures.h"
#include "studies/page/page.h"

namespace gurney::cli {
namespace {

/// Request to `gurney plot`.
struct PlotRequest {
  std::string file, kind;
  std::vector<std::string> what;  ///< histories, demands, limit states; empty: the usual ones
  std::vector<std::string> configurations;
  std::string measure, method;
  std::optional<std::size_t> run;
  std::optional<std::size_t> level;  ///< its index
  std::string job;                   ///< path of the study's job; empty: that in its log
};

std::string history(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StoredHistories stored(request.file);
  const std::vector<std::size_t> runs = stored.runs();
  const std::size_t run = request.run.value_or(runs.empty() ? 0 : runs.front());
  std::vector<std::string> names = request.what;
  if (names.empty()) names = {"displacement"};
  std::vector<study::StoredHistory> histories;
  for (const std::string& name : names) histories.push_back(stored.history(name, run));
  const std::string note = study::is_study_file(request.file) ? fmt::format("run {}", run) : "";
  return history_figure(page, stored.title(), note, histories);
}

std::string trajectories(const PlotRequest& request, const figures::PlotPage& page) {
  return figures::trajectory_figure(page, request.file);
}

std::string fragility(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file, {}, {}, page.units);
  return figures::fragility_figure(
      data,
      fragility_curves(data, wanted_states(data, request.what),
                       configurations_with_runs(data, request.configurations), request.measure,
                       request.method),
      page);
}

/// A figure of demands.
template <auto Draw>
std::string of_demands(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file, {}, {}, page.units);
  if constexpr (Draw == figures::ida_figure)
    require(!data.has_suites_by_level(),
            request.file +
                ": each level has records of its own, which no curve follows from one "
                "level to the next; gurney plot FILE stripes has their demands");
  std::vector<std::string> names = request.what;
  if (names.empty()) names = {"peak_displacement"};
  std::vector<study::DemandRuns> all;
  for (const std::string& name : names)
    for (study::DemandRuns& each :
         study::demand_runs(data, configurations_with_runs(data, request.configurations), name,
                            data.measure(request.measure)))
      all.push_back(std::move(each));
  return Draw(page, data.file().text_attribute("title"), all);
}

/// A limit state, or a demand.
study::SensitivityRequest sensitivity_request(const study::StudyData& data,
                                              const std::string& name) {
  for (const study::LimitState& state : data.limit_states())
    if (state.name == name) return {.demand = "", .limit = name, .level = {}};
  return {.demand = name, .limit = "", .level = {}};
}

std::string tornado(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file, {}, {}, page.units);
  std::vector<std::string> names = request.what;
  if (names.empty()) names = {"peak_displacement"};
  std::vector<report::SensitivityReport> reports;
  for (const std::string& name : names)
    for (const std::size_t configuration : configurations_with_runs(data, request.configurations)) {
      study::SensitivityRequest output = sensitivity_request(data, name);
      output.level = request.level;
      reports.push_back({data.configurations()[configuration],
                         study::study_sensitivity({&data, configuration}, output), "", page.units});
    }
  return figures::tornado_figure(page, data.file().text_attribute("title"), reports);
}

std::string job_of(const PlotRequest& request) {
  return request.job.empty() ? job_of_log(request.file) : request.job;
}

/// Those with what is asked for; by default all but the floor.
std::vector<study::StoredImpact> wanted_impacts(const PlotRequest& request) {
  std::vector<study::StoredImpact> all = study::stored_impacts(request.file);
  const std::vector<std::string> known = study::hit_by_items(all);
  for (const std::string& name : request.what)
    require(std::ranges::find(known, name) != known.end(),
            fmt::format("no item hit '{}'{}", name, config::suggestion(name, known)));
  std::erase_if(all, [&](const study::StoredImpact& impact) {
    return request.what.empty()
               ? impact.other == "floor"
               : std::ranges::find(request.what, impact.other) == request.what.end();
  });
  require(!all.empty(),
          request.file + ": no item hit anything" + (known.empty() ? "" : " but the floor"));
  return all;
}

std::string collisions(const PlotRequest& request, const figures::PlotPage& page) {
  const std::vector<study::StoredImpact> impacts = wanted_impacts(request);
  const std::string what = request.what.empty() ? "the room and other items"
                                                : fmt::format("{}", fmt::join(request.what, ", "));
  const std::string note =
      "first points of contact with " + what + "; area of a circle: approach speed";
  if (!study::is_study_file(request.file)) {
    const study::Hdf5Reader file(request.file);
    return figures::collision_figure(
        page, file.text_attribute("title"), note,
        {{"", page::scene_of_run(file, job_of(request)).scene, impacts, 1}});
  }
  const study::StudyData data(request.file, {}, {}, page.units);
  std::vector<figures::CollisionMap> maps;
  for (const std::size_t i : configurations_with_runs(data, request.configurations))
    maps.push_back({data.configurations()[i],
                    page::scene_of_study(data.file(), job_of(request), i).scene,
                    study::impacts_of_runs(impacts, data.runs_of(i)), data.runs_of(i).size()});
  return figures::collision_figure(page, data.file().text_attribute("title"), note, maps);
}

std::string spectra(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file, {}, {}, page.units);
  return figures::spectra_figure(
      page, data.file().text_attribute("title"),
      study::suite_spectra(
          data, {.job = job_of(request),
                 .level = request.level,
                 .configurations = configurations_with_runs(data, request.configurations)}),
      request.what);
}

struct PlotKind {
  const char *name, *what;
  enum class Of { kHistories, kStudies, kImpacts } of;  ///< which files have it
  std::string (*draw)(const PlotRequest&, const figures::PlotPage&);
  std::vector<std::string> takes;  ///< what it does not ignore of what some kinds alone have
};

using Of = PlotKind::Of;

const PlotKind kKinds[] = {
    {"history", "histories of one run", Of::kHistories, history, {"WHAT", "--run"}},
    {"trajectories", "paths of the items seen from above", Of::kHistories, trajectories, {}},
    {"collisions",
     "impacts on the plan, by approach speed",
     Of::kImpacts,
     collisions,
     {"WHAT", "--configuration", "--job"}},
    {"fragility",
     "fragility curves of limit states",
     Of::kStudies,
     fragility,
     {"WHAT", "--configuration", "--measure", "--method"}},
    {"ida",
     "IDA curves of a demand with 16, 50 and 84 % fractiles",
     Of::kStudies,
     of_demands<figures::ida_figure>,
     {"WHAT", "--configuration", "--measure"}},
    {"stripes",
     "demands at each intensity",
     Of::kStudies,
     of_demands<figures::stripes_figure>,
     {"WHAT", "--configuration", "--measure"}},
    {"cloud",
     "demand over intensity with log-log regression",
     Of::kStudies,
     of_demands<figures::cloud_figure>,
     {"WHAT", "--configuration", "--measure"}},
    {"cdf",
     "distribution of a demand at each level",
     Of::kStudies,
     of_demands<figures::distribution_figure>,
     {"WHAT", "--configuration"}},
    {"tornado",
     "means of a demand where an uncertain input is low or high",
     Of::kStudies,
     tornado,
     {"WHAT", "--configuration", "--level"}},
    {"spectra",
     "response spectra of the records and of the floor",
     Of::kStudies,
     spectra,
     {"WHAT", "--configuration", "--level", "--job"}}};

const PlotKind& kind_of(const PlotRequest& request) {
  std::vector<std::string> names;
  for (const PlotKind& kind : kKinds) {
    if (request.kind == kind.name) return kind;
    names.push_back(kind.name);
  }
  const bool is_kind = std::ranges::find(names, request.file) != names.end();
  if (is_kind || request.kind.ends_with(".h5"))
    throw BadUsage(fmt::format("the file comes first: gurney plot {} {}{}",
                               shell_word(request.kind), is_kind ? "" : "KIND ", request.file));
  throw BadUsage(
      fmt::format("no figure '{}'{}", request.kind, config::suggestion(request.kind, names)));
}

std::string demand_names(const study::StudyData& data) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < data.configurations().size(); ++i)
    for (const study::NamedDemand& demand : study::demands_of(data, i)) {
      const std::string& column = demand.quantity.column;
      const std::string name = demand.quantity.of == study::Quantity::Of::kItem
                                   ? (demand.absolute ? "|" + column + "|" : column)
                                   : demand.name;
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string list_of_study(const std::string& file) {
  const study::StudyData data(file);
  const std::vector<std::string> states = names_of(data.limit_states());
  return fmt::format(
      "limit states (of fragility, tornado): {}\ndemands (of ida, stripes, cloud, cdf, tornado): "
      "{}\n"
      "intensity measures (--measure): {}\nconfigurations (--configuration): {}\n",
      fmt::join(states, ", "), demand_names(data), fmt::join(data.measures(), ", "),
      fmt::join(data.configurations(), "; "));
}

/// Given options that some kinds do not take.
std::vector<std::string> given(const PlotRequest& request) {
  std::vector<std::string> names;
  const auto add = [&](bool there, const char* name) {
    if (there) names.emplace_back(name);
  };
  add(!request.what.empty(), "WHAT");
  add(request.run.has_value(), "--run");
  add(!request.configurations.empty(), "--configuration");
  add(!request.measure.empty(), "--measure");
  add(!request.method.empty(), "--method");
  add(request.level.has_value(), "--level");
  add(!request.job.empty(), "--job");
  return names;
}

/// @throws BadUsage unless the kind is one of those there are, and takes what is given
void check_kind(const PlotRequest& request) {
  const PlotKind& kind = kind_of(request);
  for (const std::string& name : given(request))
    if (std::ranges::find(kind.takes, name) == kind.takes.end())
      throw BadUsage(fmt::format("{} is not for the figure {}, which takes {}", name, kind.name,
                                 kind.takes.empty()
                                     ? "none of its kind"
                                     : fmt::format("{}", fmt::join(kind.takes, ", "))));
}

/// The figure as SVG. @throws Error for what the file does not hold, with what it holds
std::string plotted(const PlotRequest& request, const figures::PlotPage& page) {
  const PlotKind& kind = kind_of(request);
  const bool study = study::is_study_file(request.file);
  if (!study && kind.of == Of::kImpacts && !request.configurations.empty())
    throw BadUsage(request.file + ": is the file of one run, which has no --configuration");
  require(
      kind.of != Of::kStudies || study,
      fmt::format("{}: is the file of one run; {} needs that of a study. It has: {}", request.file,
                  kind.name, fmt::join(study::StoredHistories(request.file).names(), ", ")));
  return kind.draw(request, page);
}

/// Plots that a file allows: a paragraph for each kind.
std::string plot_list(const std::string& file) {
  const study::StoredHistories stored(file);
  const bool study = study::is_study_file(file), histories = !stored.names().empty();
  std::string text;
  for (const PlotKind& kind : kKinds)
    if (kind.of == Of::kImpacts || (kind.of == Of::kStudies ? study : histories))
      text += fmt::format("{:13} {}\n", kind.name, kind.what);
  if (histories) {
    text += fmt::format("\nhistories: {}\n", fmt::join(stored.names(), ", "));
    if (study) text += fmt::format("runs with histories: {}\n", stored.runs().size());
  }
  if (study) text += "\n" + list_of_study(file);
  return text;
}

struct PlotOptions {
  PlotRequest request;
  FigureFile figure;
  std::string font_size;
  study::UnitSystem units;
  bool list = false;
};

/// Texts are laid out at 11 px, which is 8.25 pt where 96 px are an inch.
constexpr double kPagePoints = 8.25, kPxPerMm = 96 / 25.4;

double points_of(const std::string& text) {
  constexpr double kSmallest = 4, kLargest = 40;
  if (text.empty()) return kPagePoints;
  std::string_view unit = text;
  const auto points = take_number(unit);
  require_usage(points >= kSmallest && points <= kLargest && (unit.empty() || unit == "pt"),
                fmt::format("--font-size {}: must be {} to {} pt", text, kSmallest, kLargest));
  return *points;
}

/// A smaller text leaves a wider page.
figures::PlotPage page_of(PlotOptions& options) {
  constexpr double kNarrowest = 220;
  figures::PlotPage page{.units = options.units};
  if (options.figure.width.empty()) options.figure.width = fmt::format("{}px", page.width);
  page.width = picture::length_in_mm(options.figure.width) * kPxPerMm * kPagePoints /
               points_of(options.font_size);
  require_usage(
      page.width >= kNarrowest,
      fmt::format("--width {}: too narrow for this size of text; choose a smaller --font-size",
                  options.figure.width));
  return page;
}

int plot(const PlotOptions& asked) {
  PlotOptions options = asked;
  if (options.list) {
    std::vector<std::string> unused = given(options.request);
    if (!options.request.kind.empty()) unused.emplace_back("KIND");
    if (!options.figure.empty()) unused.emplace_back("-o");
    if (!unused.empty())
      throw BadUsage(
          fmt::format("--list draws nothing, and has no use for {}", fmt::join(unused, ", ")));
    fmt::print("{}", plot_list(options.request.file));
    return 0;
  }
  if (!options.request.kind.empty()) check_kind(options.request);
  const std::string lists = fmt::format("; gurney plot {} --list lists what can be plotted",
                                        shell_word(options.request.file));
  require_usage(!options.request.kind.empty(), "a figure needs its kind" + lists);
  require_usage(!options.figure.empty(), "a figure needs -o FILE.svg, .pdf or .png" + lists);
  options.figure.check();
  const figures::PlotPage page = page_of(options);
  options.figure.write([&] { return plotted(options.request, page); }, false);
  return 0;
}

}  // namespace

void add_plot(Commands& commands) {
  commands.add<PlotOptions>(
      {"plot", "Plot what a results file holds",
       "gurney plot ventilator.h5 --list\n"
       "gurney plot ventilator.h5 fragility overturned --width 85mm -o overturned.pdf\n"
       "gurney plot run.h5 history displacement tilt -o run.png"},
      plot, [](Options& add, PlotOptions& options) {
        add.required("FILE", options.request.file, "The results file of a study or of one run");
        add("KIND", options.request.kind,
            "history, trajectories, collisions, fragility, ida, stripes, cloud, cdf, "
            "tornado or spectra");
        add("WHAT", options.request.what,
            "Histories, demands, limit states, what was hit, or which spectra "
            "(default: displacement, peak_displacement, all)");
        add("--list", options.list, "List what can be plotted from the file");
        add("--run", options.request.run, "Of history: the run (default: the first)");
        add.single("--configuration", options.request.configurations,
                   "Configurations (default: all)");
        add("--measure MEASURE", options.request.measure,
            "Of fragility, ida, stripes and cloud: intensity measure (default: the study's own)");
        add_method_option(add, options.request.method);
        add.calling<std::size_t>(
               "--level", [&options](std::size_t level) { options.request.level = level - 1; },
               "Of tornado and spectra: the N-th level, counted from 1 (default: that nearest to "
               "the "
               "median; the highest)")
            ->check(CLI::Range(1, 1000000));
        add("--job FILE", options.request.job,
            "The job file, of collisions and spectra (default: the path in the log)");
        add_units_option(add, options.units);
        add_figure_option(add, options.figure, "The figure", "-o,--output FILE");
        add("--font-size", options.font_size, "Size of the labels [pt] (default: 8.25)");
      });
}

}  // namespace gurney::cli
