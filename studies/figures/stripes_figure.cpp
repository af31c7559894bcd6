#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "studies/analysis/ida_curves.h"
#include "studies/figures/demand_axes.h"
#include "studies/figures/demand_figures.h"

namespace gurney::figures {
namespace {

/// One configuration; `offset` keeps configurations apart [in the unit of the intensity].
void add(Panel& panel, const study::DemandRuns& runs, const study::DemandRuns::Configuration& of,
         std::size_t index, double offset, double ceiling) {
  const std::string color = palette(index);
  Marks stood{"", {}, {}, {.stroke = color, .width = 0.8}, marker(index), 2.2};
  Marks fell{"", {}, {}, {.stroke = color, .width = 1}, Marker::kCross, 3};
  std::map<double, std::vector<double>> stripes;
  for (const study::DemandRun& run : of.runs) {
    const double im = run.im / runs.measure_unit.in_si;
    const double demand = run.demand / runs.unit.in_si;
    Marks& marks = run.overturned ? fell : stood;
    marks.x.push_back(im + offset);
    marks.y.push_back(run.overturned ? ceiling : demand);
    marks.runs.push_back(run.run);
    stripes[im].push_back(run.overturned ? std::numeric_limits<double>::infinity() : demand);
  }
  Curve median{
      of.name.empty() ? "median" : of.name + ", median", {}, {}, {.stroke = color, .width = 1.8}};
  median.key = marker(index);
  Area band{.x = {}, .low = {}, .high = {}, .color = color};
  for (auto& [im, values] : stripes) {
    std::ranges::sort(values);
    const auto at = [&sorted = values](double fraction) {
      const auto count = static_cast<double>(sorted.size());
      return sorted[static_cast<std::size_t>(std::min(count - 1, fraction * count))];
    };
    median.x.push_back(im + offset);
    median.y.push_back(at(0.5));
    if (std::isinf(at(0.16))) continue;
    band.x.push_back(im + offset);
    band.low.push_back(at(0.16));
    band.high.push_back(std::min(at(0.84), 2 * ceiling));  // beyond the axes where they overturned
  }
  panel.curves.push_back(std::move(median));
  panel.areas.push_back(std::move(band));
  stood.name = of.name;
  panel.marks.push_back(std::move(stood));
  if (fell.x.empty()) return;
  fell.label = of.name.empty() ? "overturned" : of.name + ", overturned";
  panel.marks.push_back(std::move(fell));
}

}  // namespace

std::string stripes_figure(const PlotPage& page, const std::string& title,
                           const std::vector<study::DemandRuns>& all) {
  std::vector<PlotPanel> panels;
  for (const study::DemandRuns& runs : all) {
    const double top = largest_demand(runs), right = largest_intensity(runs);
    Panel panel{.title = runs.item,
                .x_label = measure_label(runs),
                .y_label = demand_label(runs),
                .zero_line = false,
                .legend_columns = 2,
                .x_range = {0, 1.06 * right},
                .y_range = {0, 1.12 * top}};
    const std::size_t count = runs.configurations.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double place = static_cast<double>(i) - 0.5 * static_cast<double>(count - 1);
      add(panel, runs, runs.configurations[i], i, 0.012 * right * place, 1.07 * top);
    }
    panels.push_back({.panel = panel, .aspect = 0.6});
  }
  return Chart{title,
               "line: median of the runs of an intensity; area: 16 to 84 % fractiles; "
               "crosses at the top: runs in which the item overturned",
               panels}
      .svg(page);
}

}  // namespace gurney::figures
