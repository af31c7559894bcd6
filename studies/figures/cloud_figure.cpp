#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/demand_axes.h"
#include "studies/figures/demand_figures.h"
#include "studies/statistics/cloud.h"

namespace gurney::figures {
namespace {

/// Zero has no logarithm, and so small a demand is that of an item at rest.
double floor_of(const study::DemandRuns& runs) { return 1e-4 * largest_demand(runs); }

std::vector<statistics::CloudPoint> points_of(const study::DemandRuns& runs,
                                              const study::DemandRuns::Configuration& of) {
  using Known = statistics::CloudPoint::Known;
  std::vector<statistics::CloudPoint> points;
  const double floor = floor_of(runs);
  for (const study::DemandRun& run : of.runs) {
    const double demand = run.demand / runs.unit.in_si;
    const Known known = run.overturned    ? Known::kAtLeast
                        : demand <= floor ? Known::kAtMost
                                          : Known::kExactly;
    points.push_back(
        {run.im / runs.measure_unit.in_si, std::max(demand, floor), known, run.record});
  }
  return points;
}

void add_fit(Panel& panel, const std::vector<statistics::CloudPoint>& points,
             const std::string& name, std::size_t index) {
  const statistics::CloudFit fit = statistics::fit_cloud(points);
  const std::string space = name.empty() ? "" : name + ": ";
  Curve curve{
      space + statistics::text(fit.status), {}, {}, {.stroke = palette(index), .width = 1.8}};
  if (fit.status == statistics::CloudStatus::kFitted) {
    curve.label =
        fmt::format("{}ln D = {}{:.3g} {} {:.3g} ln IM; \u03c3 {:.3g}; R\u00b2 {:.2f}", space,
                    fit.a < 0 ? "\u2212" : "", std::abs(fit.a), fit.b < 0 ? "\u2212" : "+",
                    std::abs(fit.b), fit.sigma, fit.r_squared);
    Area band{.x = {}, .low = {}, .high = {}, .color = palette(index), .opacity = 0.12};
    const auto [low, high] = std::ranges::minmax(points, {}, &statistics::CloudPoint::im);
    for (const double im : {low.im, high.im}) {
      const double demand = std::exp(fit.a + fit.b * std::log(im));
      curve.x.push_back(im);
      curve.y.push_back(demand);
      band.x.push_back(im);
      band.low.push_back(demand * std::exp(-fit.sigma));
      band.high.push_back(demand * std::exp(fit.sigma));
    }
    panel.areas.push_back(std::move(band));
  }
  panel.curves.push_back(std::move(curve));
}

}  // namespace

std::string cloud_figure(const PlotPage& page, const std::string& title,
                         const std::vector<study::DemandRuns>& all) {
  using Known = statistics::CloudPoint::Known;
  std::vector<PlotPanel> panels;
  for (const study::DemandRuns& runs : all) {
    Panel panel{.title = runs.item,
                .x_label = measure_label(runs),
                .y_label = demand_label(runs),
                .zero_line = false,
                .log_x = true,
                .legend_columns = 1,
                .log_y = true};
    for (std::size_t i = 0; i < runs.configurations.size(); ++i) {
      const auto points = points_of(runs, runs.configurations[i]);
      const Pen pen{.stroke = palette(i), .width = 0.9};
      Marks exact{"", {}, {}, pen, marker(i), 2.6}, bounds{"", {}, {}, pen, Marker::kCross, 3};
      for (std::size_t k = 0; k < points.size(); ++k) {
        Marks& marks = points[k].known == Known::kExactly ? exact : bounds;
        marks.x.push_back(points[k].im);
        marks.y.push_back(points[k].edp);
        marks.runs.push_back(runs.configurations[i].runs[k].run);
      }
      exact.name = bounds.name = runs.configurations[i].name;
      panel.marks.insert(panel.marks.end(), {exact, bounds});
      add_fit(panel, points, runs.configurations[i].name, i);
      panel.curves.back().key = marker(i);
    }
    panels.push_back({.panel = panel, .aspect = 0.65});
  }
  return Chart{title,
               "line: censored regression of ln demand on ln intensity, in the units of the "
               "axes; area: one standard deviation \u03c3; crosses: runs that overturned (at "
               "least this demand) or stayed below 1/10000 of the largest (at most)",
               panels}
      .svg(page);
}

}  // namespace gurney::figures
