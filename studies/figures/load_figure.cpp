#include "studies/figures/load_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gurney::figures {
namespace {

constexpr double kRow = 34, kNameSize = 10;

bool finite(const Range& range) { return std::isfinite(range.low) && std::isfinite(range.high); }

void add_line(const LoadLine& line, std::size_t index, double highest, Panel& panel) {
  const auto band = [&](const Range& slopes, double opacity) {
    if (finite(slopes))
      panel.areas.push_back({{0, highest},
                             {0, slopes.low * highest},
                             {0, slopes.high * highest},
                             palette(index),
                             opacity});
  };
  band(line.prediction, 0.12);
  band(line.interval, 0.28);
  panel.curves.push_back({line.label,
                          {0, highest},
                          {0, line.ratio * highest},
                          {.stroke = palette(index), .width = 1.8},
                          marker(index)});
  panel.marks.push_back({"",
                         line.load,
                         line.resistance,
                         {.stroke = palette(index), .width = 1.2},
                         marker(index),
                         3.5});
}

/// Percent that the axis goes to either side.
double reach_of(const std::vector<ResidualRow>& rows) {
  double reach = 1;
  for (const ResidualRow& row : rows)
    for (const ResidualRow::Trial& each : row.trials)
      reach = std::max(reach, 100 * (std::abs(each.ratio - 1) + 2 * each.error));
  return 1.15 * reach;
}

void draw_rows(Svg& svg, const Frame& frame, const Scaling& scaling,
               const std::vector<ResidualRow>& rows) {
  svg.begin_clip(frame.x, frame.y, frame.width, frame.height);
  double top = frame.y + 3;
  for (const ResidualRow& row : rows) {
    const double middle = top + 22;
    const auto bar = [&](const Range& range, double half, double opacity) {
      if (!finite(range)) return;
      const double from = scaling.x(100 * (range.low - 1)), to = scaling.x(100 * (range.high - 1));
      svg.rectangle(from, middle - half, to - from, 2 * half,
                    {.stroke = "", .fill = palette(0), .opacity = opacity});
    };
    bar(row.prediction, 6, 0.12);
    bar(row.interval, 6, 0.25);
    for (const ResidualRow::Trial& each : row.trials) {
      const double x = scaling.x(100 * (each.ratio - 1));
      const double half = scaling.x(200 * each.error) - scaling.x(0);
      const std::string color = palette(each.validation ? 1 : 0);
      svg.line(x - half, middle, x + half, middle, {.stroke = color});
      svg.circle(x, middle, 3.2,
                 {.stroke = color, .width = 1.2, .fill = each.validation ? "#ffffff" : color});
    }
    svg.text(frame.x + 5, top + 10, fitted(row.label, kNameSize, frame.width - 12),
             {.size = kNameSize});
    top += kRow;
  }
  svg.end_clip();
}

}  // namespace

std::string load_figure(const PlotPage& page, const std::vector<LoadLine>& lines) {
  double highest = 0, strongest = 0;
  for (const LoadLine& line : lines) {
    for (const double load : line.load) highest = std::max(highest, 1.1 * load);
    for (const double each : line.resistance) strongest = std::max(strongest, 1.25 * each);
  }
  Panel panel{.title = "",
              .x_label = "Normal force on all wheels N (N)",
              .y_label = "Rolling resistance f_r (N)",
              .legend_columns = 1,
              .x_range = {0, highest},
              .y_range = {0, strongest}};
  for (std::size_t i = 0; i < lines.size(); ++i) add_line(lines[i], i, highest, panel);
  return plot_figure(page, "Rolling resistance against load",
                     "each mark is a pull; dark band: 95 % confidence interval of Cr/R; light "
                     "band: 95 % prediction interval of one more pull",
                     {{.panel = panel}});
}

std::string residual_figure(const PlotPage& page, const std::vector<ResidualRow>& rows) {
  const double reach = reach_of(rows);
  Panel panel{.title = "",
              .x_label = "Value of the trial over the constant, less one (%)",
              .y_label = "",
              .zero_line = false,
              .legend_columns = 2,
              .x_range = {-reach, reach},
              .y_range = {0, 1},
              .y_axis = false};
  panel.curves = {{"", {0, 0}, {0, 1}, {.stroke = "#444444", .width = 0.8, .dash = "4 3"}}};
  panel.marks = {{"calibration", {}, {}, {.stroke = palette(0), .fill = palette(0)}},
                 {"validation", {}, {}, {.stroke = palette(1)}}};
  return plot_figure(
      page, "Residuals",
      "line through a mark: two standard errors of its measurement to either side; dark band: 95 % "
      "confidence interval of the constant; light band: 95 % prediction interval of one more trial",
      {{.panel = panel,
        .height = 6 + kRow * static_cast<double>(rows.size()),
        .overlay = [rows](Svg& svg, const Frame& frame, const Scaling& scaling) {
          draw_rows(svg, frame, scaling, rows);
        }}});
}

}  // namespace gurney::figures
