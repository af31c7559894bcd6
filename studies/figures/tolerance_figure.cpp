#include "studies/figures/tolerance_figure.h"

#include <algorithm>
#include <cmath>

namespace gurney::figures {
namespace {

constexpr double kNameSize = 10;
constexpr std::size_t kLines = 5;  // of marks in a row
constexpr double kLeast = -6;      // log10 of what is drawn at the edge

double highest_of(const std::vector<ToleranceRow>& rows) {
  double highest = 0.5;
  for (const ToleranceRow& row : rows)
    for (const double used : row.used)
      if (std::isfinite(used) && used > 0) highest = std::max(highest, std::log10(used) + 0.3);
  return highest;
}

/// Few rows are high, so that their marks can be seen.
double row_height(std::size_t rows) {
  return std::clamp(240 / static_cast<double>(std::max<std::size_t>(1, rows)), 34.0, 80.0);
}

/// Rows from above; marks of a row in lines, so that fewer lie upon each other.
void add_marks(const std::vector<ToleranceRow>& rows, double highest, Panel& panel) {
  panel.marks = {{"passed", {}, {}, {.stroke = palette(0), .width = 0.8}, Marker::kCircle, 2.6},
                 {"failed",
                  {},
                  {},
                  {.stroke = palette(1), .width = 1.2, .fill = palette(1)},
                  Marker::kSquare,
                  4}};
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t i = 0; i < rows[row].used.size(); ++i) {
      const double used = rows[row].used[i];
      Marks& marks = panel.marks[used <= 1 ? 0 : 1];
      const double least = std::pow(10, kLeast), most = std::pow(10, highest);
      marks.x.push_back(std::isfinite(used) ? std::clamp(used, least, most) : most);
      marks.y.push_back(static_cast<double>(rows.size() - row) - 0.5 -
                        0.42 * static_cast<double>(i % kLines) / kLines);
    }
}

}  // namespace

std::string tolerance_figure(const PlotPage& page, const std::vector<ToleranceRow>& rows) {
  const double highest = highest_of(rows);
  Panel panel{.title = "",
              .x_label = "|error| / tolerance",
              .y_label = "",
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .x_range = {kLeast, highest},
              .y_range = {0, static_cast<double>(rows.size())},
              .y_axis = false};
  add_marks(rows, highest, panel);
  panel.curves = {{"",
                   {1, 1},
                   panel.y_range.span() > 0 ? std::vector<double>{0, panel.y_range.high}
                                            : std::vector<double>{0, 1},
                   {.stroke = "#444444", .width = 1.2, .dash = "5 3"}}};
  return plot_figure(
      page, "Use of the tolerances",
      "each mark is a check; dashed: the tolerance; at the left edge: a millionth of the tolerance "
      "or less, such as no error at all",
      {{.panel = panel,
        .height = row_height(rows.size()) * static_cast<double>(rows.size()),
        .overlay = [rows](Svg& svg, const Frame& frame, const Scaling&) {
          double top = frame.y;
          for (const ToleranceRow& row : rows) {
            svg.text(frame.x + 6, top + 11, fitted(row.label, kNameSize, frame.width - 12),
                     {.size = kNameSize});
            top += row_height(rows.size());
            svg.line(frame.x, top, frame.x + frame.width, top, {.stroke = "#cccccc", .width = 0.6});
          }
        }}});
}

}  // namespace gurney::figures
