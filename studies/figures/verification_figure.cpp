#include "studies/figures/verification_figure.h"

#include <fmt/format.h>

#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kRow = 270, kTop = 100;  // [px]

std::string label(const std::string& quantity, const std::string& unit) {
  return unit.empty() ? quantity : fmt::format("{} ({})", quantity, unit);
}

/// `time [s]` as axes of other figures have it: `Time (s)`.
std::string axis_label(std::string axis) {
  for (char& c : axis) c = c == '[' ? '(' : c == ']' ? ')' : c;
  if (!axis.empty() && axis[0] >= 'a' && axis[0] <= 'z') axis[0] = static_cast<char>(axis[0] - 32);
  return axis;
}

void draw_series(Svg& svg, double y, const verification::Series& series) {
  const std::string axis = axis_label(series.axis);
  draw(svg, {80, y, 400, kRow - 90},
       {.title = series.quantity,
        .x_label = axis,
        .y_label = series.unit,
        .curves = {{"reference", series.at, series.reference, {.stroke = palette(1), .width = 3}},
                   {"computed",
                    series.at,
                    series.computed,
                    {.stroke = palette(0), .width = 1.2, .dash = "5 3"}}},
        .legend_columns = 2});
  std::vector<double> error = series.computed;
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= series.reference[i];
  draw(svg, {600, y, 300, kRow - 90},
       {.title = "computed less reference",
        .x_label = axis,
        .y_label = label("error", series.unit),
        .curves = {{"", series.at, error, {.stroke = palette(0), .width = 1}}}});
}

}  // namespace

std::string verification_figure(const verification::CaseRun& run) {
  const auto& all = run.findings.series;
  if (all.empty()) return {};
  Svg svg(940, kTop + kRow * static_cast<double>(all.size()));
  svg.text(30, 30, run.name() + ": " + run.family->statement.title, {.size = 15, .bold = true});
  svg.text(30, 50, run.family->statement.equation, {.size = 10});
  std::string values;
  for (std::size_t i = 0; i < run.set.values.size(); ++i)
    values += fmt::format("{}{} {:.4g} {}", i == 0 ? "" : ", ", run.family->parameters[i].name,
                          run.set.values[i], run.family->parameters[i].unit);
  svg.text(30, 66, values, {.size = 10, .color = "#555555"});
  for (std::size_t i = 0; i < all.size(); ++i)
    draw_series(svg, kTop + 20 + kRow * static_cast<double>(i), all[i]);
  return svg.str();
}

}  // namespace gurney::figures
