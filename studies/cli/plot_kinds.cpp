#include "studies/cli/plot_kinds.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/config/nearest_name.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/fragility_figure.h"
#include "studies/figures/history_figure.h"
#include "studies/figures/trajectory_figure.h"
#include "studies/report/fragility_report.h"
#include "studies/study/analysis/configuration_view.h"
#include "studies/study/analysis/overview.h"
#include "studies/study/limit_states/limit_state_reader.h"

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
  const study::StudyData data(request.file);
  std::vector<std::size_t> states;
  for (const std::string& name : request.what)
    states.push_back(study::index_of(data.limit_states(), name));
  for (std::size_t i = 0; request.what.empty() && i < data.limit_states().size(); ++i)
    states.push_back(i);
  std::vector<study::FragilityResult> results;
  for (const std::size_t state : states)
    for (const std::size_t configuration :
         study::wanted_configurations(data, request.configurations))
      results.push_back(study::fragility_of(
          data, {.state = state, .configuration = configuration, .measure = request.measure}));
  return figures::fragility_figure(data, results, page);
}

/// A figure of demands.
template <auto Draw>
std::string of_demands(const PlotRequest& request, const figures::PlotPage& page) {
  const study::StudyData data(request.file);
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

struct PlotKind {
  const char *name, *what;
  bool of_studies;  ///< else of every file with histories
  std::string (*draw)(const PlotRequest&, const figures::PlotPage&);
};

constexpr PlotKind kKinds[] = {
    {"history", "histories of one run", false, history},
    {"trajectories", "paths of the items seen from above", false, trajectories},
    {"fragility", "fragility curves of limit states", true, fragility},
    {"ida", "IDA curves of a demand with 16, 50 and 84 % fractiles", true,
     of_demands<figures::ida_figure>},
    {"stripes", "demands at each intensity", true, of_demands<figures::stripes_figure>},
    {"cloud", "demand over intensity with log-log regression", true,
     of_demands<figures::cloud_figure>},
    {"cdf", "distribution of a demand at each level", true,
     of_demands<figures::distribution_figure>}};

const PlotKind& kind_of(const PlotRequest& request) {
  std::vector<std::string> names;
  for (const PlotKind& kind : kKinds) {
    if (request.kind == kind.name) return kind;
    names.push_back(kind.name);
  }
  throw Error(fmt::format("no figure '{}'{}; there are {}", request.kind,
                          config::suggestion(request.kind, names), fmt::join(names, ", ")));
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
      "limit states (of fragility): {}\ndemands (of ida, stripes, cloud, cdf): {}\n"
      "intensity measures (--measure): {}\nconfigurations (--configuration): {}\n",
      fmt::join(states, ", "), demand_names(data), fmt::join(data.measures(), ", "),
      fmt::join(data.configurations(), "; "));
}

}  // namespace

std::string plotted(const PlotRequest& request, const figures::PlotPage& page) {
  const PlotKind& kind = kind_of(request);
  require(
      !kind.of_studies || study::is_study_file(request.file),
      fmt::format("{}: is the file of one run; {} needs that of a study. It has: {}", request.file,
                  kind.name, fmt::join(study::StoredHistories(request.file).names(), ", ")));
  return kind.draw(request, page);
}

std::string plot_list(const std::string& file) {
  const study::StoredHistories stored(file);
  const bool study = study::is_study_file(file), histories = !stored.names().empty();
  std::string text;
  for (const PlotKind& kind : kKinds)
    if (kind.of_studies ? study : histories)
      text += fmt::format("{:13} {}\n", kind.name, kind.what);
  if (histories) {
    text += fmt::format("\nhistories: {}\n", fmt::join(stored.names(), ", "));
    if (study) text += fmt::format("runs with histories: {}\n", stored.runs().size());
  }
  if (study) text += "\n" + list_of_study(file);
  return text;
}

}  // namespace gurney::cli
