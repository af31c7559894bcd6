#include "studies/figures/history_figure.h"

#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

PlotPanel panel_of(const study::StoredHistory& history, const study::UnitSystem& units) {
  constexpr std::size_t kTogether = 3;
  const study::ReportUnit unit = units.of(history.units);
  PlotPanel result{.panel = {.title = label_of(history.name),
                             .x_label = "Time (s)",
                             .y_label = with_unit(label_of(history.name), unit),
                             .legend_columns = 4},
                   .aspect = 0.4};
  for (const study::StoredHistory::Series& series : history.series) {
    const std::string space = series.part.empty() || series.axis.empty() ? "" : ", ";
    Curve curve{series.part + space + series.axis,
                history.time,
                series.values,
                {.stroke = palette(result.panel.curves.size()), .width = 1.2}};
    for (double& value : curve.y) value /= unit.in_si;
    result.panel.curves.push_back(std::move(curve));
  }
  // A vertical component of several g would hide the horizontal ones.
  const bool of_floor = history.name.starts_with("floor_") && result.panel.curves.size() > 1;
  result.panel.own_ranges = of_floor;
  result.panel.lanes = of_floor || (history.of != "axis" && result.panel.curves.size() > kTogether);
  return result;
}

}  // namespace

std::string history_figure(const PlotPage& page, const std::string& title, const std::string& note,
                           const std::vector<study::StoredHistory>& histories) {
  std::vector<PlotPanel> panels;
  for (const study::StoredHistory& each : histories) panels.push_back(panel_of(each, page.units));
  return Chart{title, note, panels}.svg(page);
}

}  // namespace gurney::figures
