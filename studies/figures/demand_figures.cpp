#include "studies/figures/demand_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "studies/analysis/demand_runs.h"
#include "studies/figures/labels.h"
#include "studies/statistics/cloud.h"
#include "studies/statistics/quantiles.h"

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
      curve.add(im, demand);
      band.add(im, demand * std::exp(-fit.sigma), demand * std::exp(fit.sigma));
    }
    panel.areas.push_back(std::move(band));
  }
  panel.curves.push_back(std::move(curve));
}

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
  curve.add(right, below / static_cast<double>(count));
  return curve;
}

/// One axis for all panels of a demand, so that configurations and items can be compared.
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

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Curve curve_of_ida(const study::IdaCurve& ida, const study::DemandRuns& runs) {
  Curve curve{"", {}, {}, {.stroke = "#b0b0b0", .width = 0.8}};
  for (std::size_t i = 0; i < ida.im.size(); ++i)
    curve.add(ida.demand[i] / runs.unit.in_si, ida.im[i] / runs.measure_unit.in_si);
  if (std::isfinite(ida.capacity)) {  // up to its mark
    curve.add(curve.x.back(), ida.capacity / runs.measure_unit.in_si);
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
    if (flat && !result.x.empty() && std::isfinite(result.x.back()))
      result.add(right, result.y.back());
    if (flat) break;
    result.add(std::isnan(demand) ? kNaN : demand, im);
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
    panel.curves.push_back(curve_of_ida(each, runs));
    if (!std::isfinite(each.capacity)) continue;
    overturned.add(each.demand.back() / runs.unit.in_si, each.capacity / runs.measure_unit.in_si);
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
    marks.add(im + offset, run.overturned ? ceiling : demand);
    marks.runs.push_back(run.run);
    stripes[im].push_back(run.overturned ? std::numeric_limits<double>::infinity() : demand);
  }
  Curve median{
      of.name.empty() ? "median" : of.name + ", median", {}, {}, {.stroke = color, .width = 1.8}};
  median.key = marker(index);
  median.shift = stood.shift = fell.shift = offset;
  fell.only_x = true;
  Area band{.x = {}, .low = {}, .high = {}, .color = color};
  for (const auto& [im, values] : stripes) {
    const auto at = [&](double fraction) { return statistics::quantile_of(values, fraction); };
    median.add(im + offset, at(0.5));
    if (std::isinf(at(0.16))) continue;
    band.add(im + offset, at(0.16),
             std::min(at(0.84), 2 * ceiling));  // beyond the axes where they overturned
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

std::string demand_label(const study::DemandRuns& runs) {
  return with_unit(label_of(runs.column), runs.unit);
}

std::string measure_label(const study::DemandRuns& runs) {
  return with_unit(label_of(runs.measure), runs.measure_unit);
}

std::string panel_title(const study::DemandRuns& runs, const std::string& configuration) {
  return configuration.empty() ? runs.item : runs.item + ", " + configuration;
}

double largest_demand(const study::DemandRuns& runs) {
  double largest = 0;
  for (const auto& configuration : runs.configurations)
    for (const study::DemandRun& run : configuration.runs)
      if (!run.overturned) largest = std::max(largest, run.demand / runs.unit.in_si);
  return largest > 0 ? largest : 1;
}

double largest_intensity(const study::DemandRuns& runs) {
  double largest = 0;
  for (const auto& configuration : runs.configurations)
    for (const study::DemandRun& run : configuration.runs)
      largest = std::max(largest, run.im / runs.measure_unit.in_si);
  return largest;
}

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
        marks.add(points[k].im, points[k].edp);
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

std::string ida_figure(const PlotPage& page, const std::string& title,
                       const std::vector<study::DemandRuns>& all) {
  std::vector<PlotPanel> panels;
  for (const study::DemandRuns& runs : all)
    for (const auto& configuration : runs.configurations)
      panels.push_back({.panel = panel_of(runs, configuration), .aspect = 0.6});
  return Chart{
      title,
      "grey: one analysis case each; 16, 50, 84 %: fractiles at one intensity; horizontal: "
      "that many overturned",
      panels}
      .svg(page);
}

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
