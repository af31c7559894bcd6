#include <algorithm>
#include <cmath>
#include <map>

#include "studies/figures/panel.h"
#include "tests/benchmark/peers/curves.h"

namespace gurney::benchmark {
namespace {

using figures::Panel;

constexpr double kWidth = 420, kHeight = 300, kLeft = 75, kTop = 60, kGap = 90;  // [px]
constexpr double kLeast = 1e-5;  ///< smaller errors are drawn here

Panel panel_of(const std::string& job, const std::vector<Point>& points) {
  Panel panel{.title = job,
              .x_label = "CPU time of a simulated second (ms)",
              .y_label = "Error of the peak displacement (%)",
              .zero_line = false,
              .log_x = true,
              .y_range = {std::log10(100 * kLeast), 2.3},
              .log_y = true};
  std::map<std::string, std::size_t> colors;
  std::vector<std::string> order;
  for (const Point& p : points) {
    const std::string label = p.engine + ", " + p.setup;
    if (std::ranges::find(order, label) == order.end()) order.push_back(label);
    colors.try_emplace(p.engine, colors.size());
  }
  for (const std::string& label : order) {
    figures::Curve curve;
    curve.label = label;
    std::size_t color = 0, of_engine = 0;
    for (const Point& p : points) {
      if (p.engine + ", " + p.setup != label) continue;
      color = colors[p.engine];
      if (p.job != job) continue;
      curve.x.push_back(1e3 * p.cpu);
      curve.y.push_back(100 * std::clamp(p.error[0], kLeast, 2.0));
    }
    for (const std::string& before : order) {
      if (before == label) break;
      of_engine += before.substr(0, before.find(',')) == label.substr(0, label.find(','));
    }
    constexpr const char* kDashes[] = {"", "6 3", "2 3"};
    curve.pen = {.stroke = figures::palette(color), .width = 1.6, .dash = kDashes[of_engine % 3]};
    curve.key = figures::marker(color);
    panel.marks.push_back({.label = "",
                           .x = curve.x,
                           .y = curve.y,
                           .pen = {.stroke = figures::palette(color)},
                           .marker = figures::marker(color)});
    panel.curves.push_back(curve);
  }
  return panel;
}

}  // namespace

std::string curves_figure(const std::vector<Point>& points) {
  std::vector<std::string> jobs;
  for (const Point& p : points)
    if (std::ranges::find(jobs, p.job) == jobs.end()) jobs.push_back(p.job);
  const double columns = static_cast<double>(jobs.size());
  const double legend = 100;
  figures::Svg svg(kLeft + columns * (kWidth + kGap), kTop + legend + kHeight + 50);
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    Panel panel = panel_of(jobs[j], points);
    if (j == 0)
      panel.legend_columns = 2;
    else
      for (figures::Curve& curve : panel.curves) curve.label.clear();
    draw(svg, {kLeft + static_cast<double>(j) * (kWidth + kGap), kTop + legend, kWidth, kHeight},
         panel);
  }
  return svg.str();
}

}  // namespace gurney::benchmark
