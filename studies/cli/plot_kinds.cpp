#include "studies/cli/plot_kinds.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/analysis/configuration_view.h"
#include "studies/analysis/overview.h"
#include "studies/cli/job_of_log.h"
#include "studies/cli/method_option.h"
#include "studies/figures/collision_figure.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/fragility_figures.h"
#include "studies/figures/history_figure.h"
#include "studies/figures/sensitivity_figures.h"
#include "studies/figures/spectra_figure.h"
#include "studies/figures/trajectory_figure.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/page/job_scene.h"
#include "studies/report/fragility_report.h"

namespace gurney::cli {
namespace {

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
  std::vector<std::size_t> states;
  for (const std::string& name : request.what)
    states.push_back(study::index_of(data.limit_states(), name));
  for (std::size_t i = 0; request.what.empty() && i < data.limit_states().size(); ++i)
    states.push_back(i);
  std::vector<study::FragilityResult> results;
  for (const std::size_t state : states)
    for (const std::size_t configuration :
         study::wanted_configurations(data, request.configurations))
      results.push_back(study::fragility_of(data, {.state = state,
                                                   .configuration = configuration,
                                                   .measure = request.measure,
                                                   .method = curve_method(request.method)}));
  return figures::fragility_figure(data, results, page);
}

/// A figure of demands.
template <auto Draw>
std::string of_demands(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file, {}, {}, page.units);
  std::vector<std::string> names = request.what;
  if (names.empty()) names = {"peak_displacement"};
  std::vector<study::DemandRuns> all;
  for (const std::string& name : names)
    for (study::DemandRuns& each :
         study::demand_runs(data, study::wanted_configurations(data, request.configurations), name,
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
    for (const std::size_t configuration :
         study::wanted_configurations(data, request.configurations)) {
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
  for (const std::size_t i : study::wanted_configurations(data, request.configurations))
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
                 .configurations = study::wanted_configurations(data, request.configurations)}),
      request.what);
}

struct PlotKind {
  const char *name, *what;
  enum class Of { kHistories, kStudies, kImpacts } of;  ///< which files have it
  std::string (*draw)(const PlotRequest&, const figures::PlotPage&);
};

using Of = PlotKind::Of;

constexpr PlotKind kKinds[] = {
    {"history", "histories of one run", Of::kHistories, history},
    {"trajectories", "paths of the items seen from above", Of::kHistories, trajectories},
    {"collisions", "impacts on the plan, by approach speed", Of::kImpacts, collisions},
    {"fragility", "fragility curves of limit states", Of::kStudies, fragility},
    {"ida", "IDA curves of a demand with 16, 50 and 84 % fractiles", Of::kStudies,
     of_demands<figures::ida_figure>},
    {"stripes", "demands at each intensity", Of::kStudies, of_demands<figures::stripes_figure>},
    {"cloud", "demand over intensity with log-log regression", Of::kStudies,
     of_demands<figures::cloud_figure>},
    {"cdf", "distribution of a demand at each level", Of::kStudies,
     of_demands<figures::distribution_figure>},
    {"tornado", "means of a demand where an uncertain input is low or high", Of::kStudies, tornado},
    {"spectra", "response spectra of the records and of the floor", Of::kStudies, spectra}};

const PlotKind& kind_of(const PlotRequest& request) {
  std::vector<std::string> names;
  for (const PlotKind& kind : kKinds) {
    if (request.kind == kind.name) return kind;
    names.push_back(kind.name);
  }
  throw Error(
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
  std::vector<std::string> states;
  for (const auto& state : data.limit_states()) states.push_back(state.name);
  return fmt::format(
      "limit states (of fragility, tornado): {}\ndemands (of ida, stripes, cloud, cdf, tornado): "
      "{}\n"
      "intensity measures (--measure): {}\nconfigurations (--configuration): {}\n",
      fmt::join(states, ", "), demand_names(data), fmt::join(data.measures(), ", "),
      fmt::join(data.configurations(), "; "));
}

}  // namespace

void check_kind(const PlotRequest& request) { kind_of(request); }

std::string plotted(const PlotRequest& request, const figures::PlotPage& page) {
  const PlotKind& kind = kind_of(request);
  require(
      kind.of != Of::kStudies || study::is_study_file(request.file),
      fmt::format("{}: is the file of one run; {} needs that of a study. It has: {}", request.file,
                  kind.name, fmt::join(study::StoredHistories(request.file).names(), ", ")));
  return kind.draw(request, page);
}

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

}  // namespace gurney::cli
