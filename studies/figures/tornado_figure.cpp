#include "studies/figures/tornado_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

constexpr std::size_t kMaxRows = 20;
constexpr double kRow = 32, kBar = 12, kName = 12, kNameSize = 10;

using Inputs = std::vector<study::SensitiveInput>;

Inputs longest(const study::StudySensitivity& found) {
  Inputs inputs;
  std::ranges::copy_if(found.inputs, std::back_inserter(inputs),
                       [](const study::SensitiveInput& each) {
                         return each.drawn && !std::isnan(each.bar.swing());
                       });
  std::ranges::stable_sort(inputs, std::greater(), [](const study::SensitiveInput& each) {
    return std::abs(each.bar.swing());
  });
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  return inputs;
}

std::size_t fewest_of(const Inputs& inputs) {
  std::size_t fewest = inputs.front().bar.low_runs;
  for (const study::SensitiveInput& each : inputs)
    fewest = std::min({fewest, each.bar.low_runs, each.bar.high_runs});
  return fewest;
}

/// "ICU ventilator: peak_displacement" as "ICU ventilator: peak displacement".
std::string words_of(const std::string& output) {
  const std::size_t at = output.rfind(": ");
  if (at != std::string::npos) return output.substr(0, at + 2) + label_of(output.substr(at + 2));
  return label_of(output);
}

void draw_bar(Svg& svg, const Scaling& scaling, double top, double mean, double end, bool low) {
  const double from = scaling.x(mean), to = scaling.x(end);
  svg.rectangle(std::min(from, to), low ? top : top + kBar / 2, std::abs(to - from), kBar / 2,
                low ? Pen{.stroke = palette(0), .width = 0.8, .fill = palette(0)}
                    : Pen{.stroke = palette(1), .width = 0.8, .fill = "#ffffff"});
}

void draw_rows(Svg& svg, const Frame& frame, const Scaling& scaling, const Inputs& inputs,
               double mean, double unit) {
  svg.line(scaling.x(mean), frame.y, scaling.x(mean), frame.y + frame.height,
           {.stroke = "#444444", .width = 0.8, .dash = "4 3"});
  double top = frame.y + 3;
  for (const study::SensitiveInput& input : inputs) {
    if (&input != &inputs.front())  // a line between rows: a name belongs to the bar below it
      svg.line(frame.x, top - 2.5, frame.x + frame.width, top - 2.5,
               {.stroke = "#cccccc", .width = 0.6});
    const std::string name = fitted(report::name_of(input), kNameSize, frame.width - 12);
    svg.rectangle(frame.x + 3, top, text_width(name, kNameSize) + 4, kName + 1,
                  {.stroke = "", .fill = "#ffffff", .opacity = 0.85});
    svg.text(frame.x + 5, top + 10, name, {.size = kNameSize});
    draw_bar(svg, scaling, top + kName + 2, mean, input.bar.low / unit, true);
    draw_bar(svg, scaling, top + kName + 2, mean, input.bar.high / unit, false);
    top += kRow;
  }
}

Range range_of(const Inputs& inputs, double mean, double unit) {
  Range range{mean, mean};
  for (const study::SensitiveInput& input : inputs) {
    range.low = std::min({range.low, input.bar.low / unit, input.bar.high / unit});
    range.high = std::max({range.high, input.bar.low / unit, input.bar.high / unit});
  }
  const double air = range.span() > 0 ? 0.06 * range.span() : 1;
  return {range.low - air, range.high + air};
}

PlotPanel panel_of(const report::SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  const study::ReportUnit unit = report.units.of(found.units);
  const Inputs inputs = longest(found);
  const double mean = found.mean / unit.in_si;
  Panel panel{.title = words_of(found.output) +
                       (report.configuration.empty() ? "" : ", " + report.configuration),
              .x_label = with_unit(
                  inputs.empty() ? fmt::format("Means of fewer than {} runs are not drawn",
                                               study::kFewestOfMean)
                                 : fmt::format("Mean over {} runs or more", fewest_of(inputs)),
                  unit),
              .y_label = "",
              .zero_line = false,
              .legend_columns = 2,
              .x_range = range_of(inputs, mean, unit.in_si),
              .y_range = {0, 1},
              .y_axis = false};
  panel.marks = {{fmt::format("lowest {:g} % of the input", 100 * found.share),
                  {},
                  {},
                  {.stroke = palette(0), .fill = palette(0)},
                  Marker::kSquare,
                  4},
                 {"highest", {}, {}, {.stroke = palette(1)}, Marker::kSquare, 4}};
  return {.panel = panel,
          .height = 6 + kRow * static_cast<double>(inputs.size()),
          .overlay = [inputs, mean, unit = unit.in_si](Svg& svg, const Frame& frame,
                                                       const Scaling& scaling) {
            draw_rows(svg, frame, scaling, inputs, mean, unit);
          }};
}

}  // namespace

std::string tornado_figure(const PlotPage& page, const std::string& title,
                           const std::vector<report::SensitivityReport>& reports) {
  std::vector<PlotPanel> panels;
  bool cut = false;
  for (const report::SensitivityReport& each : reports) {
    panels.push_back(panel_of(each));
    cut = cut || std::ranges::count_if(each.found.inputs, &study::SensitiveInput::drawn) >
                     static_cast<std::ptrdiff_t>(kMaxRows);
  }
  return plot_figure(page, title,
                     std::string("means over the runs in which an input is low or high; dashed: "
                                 "mean of all runs") +
                         (cut ? "; the 20 longest bars" : ""),
                     panels);
}

}  // namespace gurney::figures
