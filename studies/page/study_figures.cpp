#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/base/shell_word.h"
#include "studies/analysis/demand_runs.h"
#include "studies/analysis/demands.h"
#include "studies/figures/demand_figures.h"
#include "studies/figures/labels.h"
#include "studies/figures/trajectory_figure.h"
#include "studies/page/drawing.h"
#include "studies/page/study_page.h"

namespace gurney::page {
namespace {

constexpr std::size_t kMaxDemands = 3, kMaxHistories = 2000;

figures::PlotPage paper_of(const StudyPage& page) {
  return {.width = kNarrow, .most_marks = kMaxMarks, .units = page.overview.units, .apart = true};
}

/// The peak displacement, and the demands of items that limit states ask for.
std::vector<std::string> demands_of_interest(const study::StudyData& data) {
  std::vector<std::string> names{"peak_displacement"};
  for (const study::LimitState& state : data.limit_states()) {
    const std::string& column = state.quantity.column;
    const bool size = state.is_simple() && state.quantity.of == study::Quantity::Of::kItem &&
                      !column.starts_with("time_of_");
    if (size && std::ranges::find(names, column) == names.end() && names.size() < kMaxDemands)
      names.push_back(column);
  }
  return names;
}

std::vector<std::size_t> drawn_configurations(const study::StudyData& data) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < data.configurations().size() && drawn.size() < kMaxConfigurations;
       ++i)
    if (!data.runs_of(i).empty()) drawn.push_back(i);
  return drawn;
}

/// None where no run has it.
std::vector<study::DemandRuns> runs_of(const study::StudyData& data, const std::string& demand) {
  try {
    auto all = study::demand_runs(data, drawn_configurations(data), demand, data.measure(""));
    if (all.size() > kMaxItems) all.resize(kMaxItems);
    return all;
  } catch (const Error&) {
    return {};
  }
}

struct Kind {
  const char *name, *caption, *description;
  std::string (*draw)(const figures::PlotPage&, const std::string&,
                      const std::vector<study::DemandRuns>&);
};

constexpr Kind kDistributions{"cdf", "distribution at each level",
                              "Empirical distribution functions, one for each intensity level.",
                              figures::distribution_figure},
    kIda{"ida", "IDA curves",
         "Intensity over demand, a curve for each analysis case, with 16, 50 and 84 % fractiles.",
         figures::ida_figure},
    kStripes{"stripes", "stripes", "Demands at each intensity with median and fractiles.",
             figures::stripes_figure},
    kCloud{"cloud", "cloud with regression", "Demand over intensity on logarithmic axes.",
           figures::cloud_figure};

std::vector<Kind> kinds_for(const study::StudyData& data) {
  const study::IntensityPlan& plan = data.study().intensity;
  if (plan.kind == study::IntensityPlan::Kind::kIda) return {kIda, kCloud};
  if (plan.levels.size() + static_cast<std::size_t>(plan.more_stages) > 1)
    return {kStripes, kDistributions};
  return {kDistributions, kCloud};
}

/// What the figures leave out, and how to see it.
Html left_out(const StudyPage& page, std::size_t items) {
  const std::size_t configurations = page.data.configurations().size();
  std::vector<std::string> parts;
  if (configurations > kMaxConfigurations)
    parts.push_back(
        fmt::format("the first {} of {} configurations", kMaxConfigurations, configurations));
  if (items > kMaxItems) parts.push_back(fmt::format("the first {} of {} items", kMaxItems, items));
  if (parts.empty()) return {};
  return paragraph(
      fmt::format("These figures draw {}. Others: gurney plot {} cdf "
                  "--configuration NAME -o cdf.svg.",
                  fmt::join(parts, " and "), shell_word(page.path)));
}

}  // namespace

Section study_demands(const StudyPage& page) {
  const study::StudyData& data = page.data;
  Html figures;
  std::size_t items = 0;
  for (const std::string& demand : demands_of_interest(data)) {
    const std::vector<study::DemandRuns> all = runs_of(data, demand);
    if (all.empty()) continue;
    items = std::max(
        items, study::demands_named(data, drawn_configurations(data).front(), {demand}).size());
    Html of_demand;
    for (const Kind& kind : kinds_for(data)) {
      std::string name = fmt::format("{}-{}", kind.name, demand);
      std::ranges::replace(name, '_', '-');
      of_demand +=
          html(Drawing{name, kind.draw(paper_of(page), "", all),
                       figures::label_of(demand) + ": " + kind.caption + ".", kind.description});
    }
    const std::string title = figures::label_of(demand);
    figures += figures.empty() ? element("h3", title) + side_by_side(of_demand)
                               : folded(title, side_by_side(of_demand));
  }
  const study::StoredHistories histories(page.path);
  const std::size_t kept = histories.names().empty() ? 0 : histories.runs().size();
  if (kept > 0 && kept <= kMaxHistories)
    figures += element("h3", "Paths") +
               html(Drawing{"paths",
                            figures::trajectory_figure(
                                {.most_marks = kMaxMarks, .units = page.overview.units}, page.path),
                            "Paths of the items seen from above, each from its start.",
                            fmt::format("Paths of {}.", counted(kept, "run"))});
  return {"demands", "Demands", left_out(page, items) + figures};
}

}  // namespace gurney::page
