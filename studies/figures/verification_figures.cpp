#include "studies/figures/verification_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/convergence/convergence.h"
#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

/// `time [s]` as axes of other figures have it: `Time (s)`.
std::string axis_label(std::string axis) {
  for (char& c : axis) c = c == '[' ? '(' : c == ']' ? ')' : c;
  if (!axis.empty() && axis[0] >= 'a' && axis[0] <= 'z') axis[0] = static_cast<char>(axis[0] - 32);
  return axis;
}

constexpr double kLeastChange = 1e-5;  ///< smaller ones are drawn here

/// Change of a number against the smallest step, over the steps above it.
Curve change_of(const study::ConvergedNumber& number, const study::Convergence& found) {
  Curve curve;
  curve.label = fmt::format("{}{}{}", number.item, number.item.empty() ? "" : ", ", number.name);
  std::vector<std::pair<double, double>> steps;
  for (std::size_t i = 0; i < found.variants.size(); ++i)
    if (found.variants[i].varied == study::Varied::kTimeStep)
      steps.emplace_back(found.variants[i].factor * found.settings.time_step, number.values[i]);
  std::ranges::sort(steps);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double change = study::relative_change(steps[i].second, steps.front().second, 0);
    curve.add(1e3 * steps[i].first, 100 * std::max(kLeastChange, change));
  }
  return curve;
}

}  // namespace

std::string verification_figure(const verification::CaseRun& run) {
  if (run.findings.series.empty()) return {};
  std::string values;
  for (std::size_t i = 0; i < run.set.values.size(); ++i)
    values += fmt::format("{}{} {:.4g} {}", i == 0 ? "; " : ", ", run.family->parameters[i].name,
                          run.set.values[i], run.family->parameters[i].unit);
  Chart chart{.title = run.name() + ": " + run.family->statement.title,
              .note = run.family->statement.equation + values,
              .columns = 2};
  for (const verification::Series& series : run.findings.series) {
    Panel compared{.title = series.quantity,
                   .x_label = axis_label(series.axis),
                   .y_label = series.unit,
                   .curves = {{"reference", series.at, series.reference, pen(1, 3)},
                              {"computed", series.at, series.computed, pen(0, 1.2, "5 3")}},
                   .legend_columns = 2};
    Panel error{.title = "computed less reference",
                .x_label = compared.x_label,
                .y_label = with_unit("error", {series.unit, 1}),
                .curves = {{"", series.at, series.computed, pen(0, 1)}}};
    for (std::size_t i = 0; i < series.at.size(); ++i) error.curves[0].y[i] -= series.reference[i];
    for (const Panel& panel : {compared, error})
      chart.panels.push_back({.panel = panel, .height = 180});
  }
  return chart.svg({.width = 940});
}

std::string convergence_figure(const study::Convergence& found) {
  constexpr std::size_t kMaxCurves = 7;
  Panel panel{.title = "",
              .x_label = "Time step (ms)",
              .y_label = "Relative change (%)",
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .y_range = {std::log10(100 * kLeastChange), 2},
              .log_y = true};
  Chart chart{"Relative change from the smallest time step"};
  // Peaks and path first: residuals and times scatter by their nature.
  std::string unchanged;
  for (const study::ConvergedNumber& number : found.numbers) {
    if (!number.name.starts_with("peak_") && number.name != "path_length") continue;
    if (number.values.front() == 0) continue;
    Curve curve = change_of(number, found);
    const std::size_t i = panel.curves.size();
    if (std::ranges::all_of(curve.y, [](double y) { return y <= 100 * kLeastChange; })) {
      unchanged += (unchanged.empty() ? "no change above 0.001 %: " : "; ") + curve.label;
    } else if (i < kMaxCurves) {
      curve.pen = pen(i, 1.6);
      curve.key = marker(i);
      panel.marks.push_back(
          {"", curve.x, curve.y, {.stroke = palette(i), .fill = palette(i)}, marker(i)});
      panel.curves.push_back(std::move(curve));
    }
  }
  if (!panel.curves.empty()) {
    const std::vector<double> x = panel.curves.front().x;
    panel.x_ticks = x;  // the steps that were run
    panel.x_range = {std::log10(x.front()) - 0.03, std::log10(x.back()) + 0.03};
    const double level = 100 * found.tolerance;
    panel.curves.push_back({"tolerance",
                            {x.front(), x.back()},
                            {level, level},
                            {.stroke = "#777777", .width = 1, .dash = "5 4"}});
  }
  if (!unchanged.empty()) chart.footnotes = {unchanged};
  chart.panels = {{.panel = std::move(panel), .height = 310}};
  return chart.svg({.width = 760});
}

std::string tolerance_figure(const PlotPage& page, const std::vector<ToleranceRow>& rows) {
  constexpr std::size_t kLines = 5;  // of marks in a row, so that fewer lie upon each other
  constexpr double kLeast = 1e-6;    // what is drawn at the edge
  double highest = std::sqrt(10);
  for (const ToleranceRow& row : rows)
    for (const double used : row.used)
      if (std::isfinite(used)) highest = std::max(highest, 2 * used);
  Panel panel{.title = "",
              .x_label = "|error| / tolerance",
              .y_label = "",
              .log_x = true,
              .legend_columns = 2,
              .x_range = {std::log10(kLeast), std::log10(highest)},
              .marks = {{"passed", {}, {}, pen(0, 0.8), Marker::kCircle, 2.6},
                        {"failed",
                         {},
                         {},
                         {.stroke = palette(1), .width = 1.2, .fill = palette(1)},
                         Marker::kSquare,
                         4}},
              .guides = {{1}}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    panel.rows.push_back(rows[row].label);
    for (std::size_t i = 0; i < rows[row].used.size(); ++i) {
      const double used = rows[row].used[i];
      Marks& marks = panel.marks[used <= 1 ? 0 : 1];
      marks.add(
          std::isfinite(used) ? std::clamp(used, kLeast, highest) : highest,
          static_cast<double>(row) + 0.25 + 0.5 * static_cast<double>(i % kLines) / (kLines - 1));
    }
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, rows.size()));
  return Chart{"Use of the tolerances",
               "each mark is a check; dashed: the tolerance; at the left edge: a millionth of the "
               "tolerance or less, such as no error at all",
               {{.panel = std::move(panel), .height = std::clamp(240 / count, 34.0, 80.0) * count}}}
      // few rows are high
      .svg(page);
}

}  // namespace gurney::figures
