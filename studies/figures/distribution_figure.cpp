#include <algorithm>
#include <cmath>

#include "studies/figures/demand_axes.h"
#include "studies/figures/demand_figures.h"

namespace gurney::figures {
namespace {

/// The empirical distribution as steps; what overturned counts as above every demand.
Curve steps_of(const std::string& label, std::vector<double> demands, std::size_t count,
               double right) {
  std::ranges::sort(demands);
  Curve curve{label, {0}, {0}, {}};
  double below = 0;
  for (const double demand : demands) {
    curve.x.insert(curve.x.end(), {demand, demand});
    curve.y.push_back(below / static_cast<double>(count));
    below += 1;
    curve.y.push_back(below / static_cast<double>(count));
  }
  curve.x.push_back(right);
  curve.y.push_back(below / static_cast<double>(count));
  return curve;
}

/// The same axis for all panels of a demand, so that configurations and items can be compared.
double right_of(const study::DemandRuns& runs, const std::vector<study::DemandRuns>& all) {
  double largest = 0;
  for (const study::DemandRuns& each : all)
    if (each.column == runs.column) largest = std::max(largest, largest_demand(each));
  return 1.05 * largest;
}

Panel panel_of(const study::DemandRuns& runs, const study::DemandRuns::Configuration& of,
               double right) {
  Panel panel{.title = panel_title(runs, of.name),
              .x_label = demand_label(runs),
              .y_label = "Fraction of runs",
              .legend_columns = 4,
              .x_range = {0, right},
              .y_range = {0, 1.02}};
  std::vector<std::string> levels;
  std::vector<study::DemandRun> by_intensity = of.runs;  // the legend and the colours follow it
  std::ranges::stable_sort(by_intensity, {}, &study::DemandRun::im);
  for (const study::DemandRun& run : by_intensity)
    if (std::ranges::find(levels, run.level) == levels.end()) levels.push_back(run.level);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    std::vector<double> demands;
    std::size_t count = 0;
    for (const study::DemandRun& run : of.runs) {
      if (run.level != levels[i]) continue;
      ++count;
      if (!run.overturned) demands.push_back(run.demand / runs.unit.in_si);
    }
    const std::string name = levels[i] == "all" ? "all intensities" : levels[i];
    Curve curve = steps_of(name, demands, count, right);
    curve.pen = {.stroke = ramp(i, levels.size()), .width = 1.5};
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

}  // namespace

std::string distribution_figure(const PlotPage& page, const std::string& title,
                                const std::vector<study::DemandRuns>& all) {
  std::vector<PlotPanel> panels;
  for (const study::DemandRuns& runs : all)
    for (const auto& configuration : runs.configurations)
      panels.push_back(
          {.panel = panel_of(runs, configuration, right_of(runs, all)), .aspect = 0.5});
  return Chart{title,
               "empirical distribution of the runs of each level; runs in which the item "
               "overturned count as above every demand",
               panels}
      .svg(page);
}

}  // namespace gurney::figures
