#include <cmath>
#include <limits>

#include "studies/analysis/ida_curves.h"
#include "studies/figures/demand_axes.h"
#include "studies/figures/demand_figures.h"

namespace gurney::figures {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Curve curve_of(const study::IdaCurve& ida, const study::DemandRuns& runs) {
  Curve curve{"", {}, {}, {.stroke = "#b0b0b0", .width = 0.8}};
  for (std::size_t i = 0; i < ida.im.size(); ++i) {
    curve.x.push_back(ida.demand[i] / runs.unit.in_si);
    curve.y.push_back(ida.im[i] / runs.measure_unit.in_si);
  }
  if (std::isfinite(ida.capacity)) {  // up to its mark
    curve.x.push_back(curve.x.back());
    curve.y.push_back(ida.capacity / runs.measure_unit.in_si);
  }
  return curve;
}

/// Where an item overturns the curve goes on to the right.
Curve fractile_curve(const std::vector<study::IdaCurve>& curves, double fraction,
                     const study::DemandRuns& runs, double right, double top) {
  constexpr int kPoints = 200;
  Curve result;
  for (int i = 0; i <= kPoints; ++i) {
    const double im = top * i / kPoints;
    const double demand =
        study::fractile_at(curves, im * runs.measure_unit.in_si, fraction) / runs.unit.in_si;
    const bool flat = std::isinf(demand);
    if (flat && !result.x.empty() && std::isfinite(result.x.back())) {
      result.x.push_back(right);
      result.y.push_back(result.y.back());
    }
    if (flat) break;
    result.x.push_back(std::isnan(demand) ? kNaN : demand);
    result.y.push_back(im);
  }
  return result;
}

Panel panel_of(const study::DemandRuns& runs, const study::DemandRuns::Configuration& of) {
  const double right = 1.1 * largest_demand(runs), top = 1.06 * largest_intensity(runs);
  Panel panel{.title = panel_title(runs, of.name),
              .x_label = demand_label(runs),
              .y_label = measure_label(runs),
              .legend_columns = 5,
              .x_range = {0, right},
              .y_range = {0, top}};
  const std::vector<study::IdaCurve> curves = study::ida_curves(of.runs);
  Marks overturned{"overturns", {}, {}, {.stroke = "#555555", .width = 1}, Marker::kCircle, 2.5};
  for (const study::IdaCurve& each : curves) {
    panel.curves.push_back(curve_of(each, runs));
    if (!std::isfinite(each.capacity)) continue;
    overturned.x.push_back(each.demand.back() / runs.unit.in_si);
    overturned.y.push_back(each.capacity / runs.measure_unit.in_si);
  }
  if (!curves.empty()) panel.curves.front().label = "one case";
  const std::pair<double, Pen> fractiles[] = {
      {0.16, {.stroke = palette(0), .width = 1.8, .dash = "2 3"}},
      {0.50, {.stroke = palette(1), .width = 2.2}},
      {0.84, {.stroke = palette(0), .width = 1.8, .dash = "7 3"}}};
  const char* const names[] = {"16 %", "50 %", "84 %"};
  for (std::size_t i = 0; i < 3; ++i) {
    Curve curve = fractile_curve(curves, fractiles[i].first, runs, right, top);
    curve.label = names[i];
    curve.pen = fractiles[i].second;
    panel.curves.push_back(std::move(curve));
  }
  if (!overturned.x.empty()) panel.marks.push_back(std::move(overturned));
  return panel;
}

}  // namespace

std::string ida_figure(const PlotPage& page, const std::string& title,
                       const std::vector<study::DemandRuns>& all) {
  std::vector<PlotPanel> panels;
  for (const study::DemandRuns& runs : all)
    for (const auto& configuration : runs.configurations)
      panels.push_back({.panel = panel_of(runs, configuration), .aspect = 0.6});
  return Chart{title,
               "grey: one analysis case each; 16, 50, 84 %: fractiles of the demand at given "
               "intensity, horizontal where that many have overturned",
               panels}
      .svg(page);
}

}  // namespace gurney::figures
