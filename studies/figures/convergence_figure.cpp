#include "studies/figures/convergence_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/convergence/judge.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 760, kHeight = 400, kLeft = 80, kTitle = 16;
constexpr std::size_t kMaxCurves = 7;
constexpr double kLeast = 1e-5;  ///< smaller changes are drawn here

/// Change of a number against the smallest step, over the steps above it.
Curve curve_of(const study::ConvergedNumber& number, const study::Convergence& found) {
  Curve curve;
  curve.label = fmt::format("{}{}{}", number.item, number.item.empty() ? "" : ", ", number.name);
  std::vector<std::pair<double, double>> steps;
  for (std::size_t i = 0; i < found.variants.size(); ++i)
    if (found.variants[i].varied == study::Varied::kTimeStep)
      steps.emplace_back(found.variants[i].factor * found.settings.time_step, number.values[i]);
  std::ranges::sort(steps);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double change = study::relative_change(steps[i].second, steps.front().second, 0);
    curve.x.push_back(1e3 * steps[i].first);
    curve.y.push_back(100 * std::max(kLeast, change));
  }
  return curve;
}

}  // namespace

std::string convergence_figure(const study::Convergence& found) {
  // Peaks and path first: residuals and times scatter by their nature.
  std::vector<const study::ConvergedNumber*> shown;
  std::string unchanged;
  for (const study::ConvergedNumber& number : found.numbers) {
    if (!number.name.starts_with("peak_") && number.name != "path_length") continue;
    if (number.values.front() == 0) continue;
    if (std::ranges::all_of(curve_of(number, found).y, [](double y) { return y <= 100 * kLeast; }))
      unchanged += (unchanged.empty() ? "no change above 0.001 %: " : "; ") +
                   (number.item.empty() ? "" : number.item + ", ") + number.name;
    else if (shown.size() < kMaxCurves)
      shown.push_back(&number);
  }
  Panel panel{.title = "",
              .x_label = "Time step (ms)",
              .y_label = "Relative change (%)",
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .y_range = {std::log10(100 * kLeast), 2},
              .log_y = true};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    panel.curves.push_back(curve_of(*shown[i], found));
    panel.curves.back().pen = {.stroke = palette(i), .width = 1.6};
  }
  if (!shown.empty()) {
    const std::vector<double>& x = panel.curves.front().x;
    panel.x_ticks = x;  // the steps that were run
    const double level = 100 * found.tolerance;
    panel.curves.push_back({"tolerance",
                            {x.front(), x.back()},
                            {level, level},
                            {.stroke = "#777777", .width = 1, .dash = "5 4"}});
  }
  const double legend = 16 * std::ceil(0.5 * double(panel.curves.size()));
  Svg svg(kWidth, kHeight + kTitle + legend + (unchanged.empty() ? 0 : 18));
  svg.text(kLeft, kHeight + kTitle + legend + 4, fitted(unchanged, 11, kWidth - kLeft - 20),
           {.color = "#555555"});
  svg.text(kLeft, 24, "Relative change from the smallest time step", {.size = 13, .bold = true});
  const Scaling scaling =
      draw(svg, {kLeft, 30 + kTitle + legend, kWidth - kLeft - 40, kHeight - 90}, panel);
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (std::size_t k = 0; k < panel.curves[i].x.size(); ++k)
      svg.circle(scaling.x(std::log10(panel.curves[i].x[k])),
                 scaling.y(std::log10(panel.curves[i].y[k])), 3, {.fill = palette(i)});
  return svg.str();
}

}  // namespace gurney::figures
