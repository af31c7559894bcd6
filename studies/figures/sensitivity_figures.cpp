#include "studies/figures/sensitivity_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

constexpr std::size_t kMaxRows = 20, kLow = 0, kHigh = 1, kFirst = 5, kTotal = 4;  // of the palette
constexpr double kRow = 26, kBar = 12;                                             // [px]

using Inputs = std::vector<study::SensitiveInput>;

bool has_bar(const study::SensitiveInput& input) {
  return input.drawn && !std::isnan(input.bar.swing());
}

Inputs longest(const study::StudySensitivity& found) {
  Inputs inputs;
  std::ranges::copy_if(found.inputs, std::back_inserter(inputs), has_bar);
  std::ranges::stable_sort(inputs, std::greater(), [](const study::SensitiveInput& each) {
    return std::abs(each.bar.swing());
  });
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  return inputs;
}

/// "ICU ventilator: peak_displacement" as "ICU ventilator: Peak displacement".
std::string words_of(const std::string& output) {
  const std::size_t at = output.rfind(": ");
  if (at != std::string::npos) return output.substr(0, at + 2) + label_of(output.substr(at + 2));
  return label_of(output);
}

Marks key(const std::string& label, const Pen& pen) {
  return {label, {}, {}, pen, Marker::kSquare, 4};
}

/// Low above, high below, each from the mean: both are seen where they go the same way.
Panel tornado_panel(const study::StudySensitivity& found, const Inputs& inputs, double unit) {
  const double mean = found.mean / unit;
  const Pen low{.stroke = palette(kLow), .width = 0.8, .fill = palette(kLow)},
      high{.stroke = palette(kHigh), .width = 0.8, .fill = "#ffffff"};
  Panel panel{.title = "",
              .x_label = "",
              .y_label = "",
              .legend_columns = 2,
              .rows = std::vector<std::string>(std::max<std::size_t>(1, inputs.size())),
              .guides = {{mean}}};
  panel.marks = {key(fmt::format("lowest {:g} % of the input", 100 * found.share), low),
                 key("highest", high)};
  Range range{mean, mean};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!has_bar(inputs[i])) continue;
    const double middle = static_cast<double>(i) + 0.5, half = kBar / 4 / kRow;
    const statistics::TornadoBar& bar = inputs[i].bar;
    panel.bars.push_back({middle - half, half, {mean, bar.low / unit}, low});
    panel.bars.push_back({middle + half, half, {mean, bar.high / unit}, high});
    range = widened(range, {bar.low / unit, bar.high / unit});
  }
  const double air = range.span() > 0 ? 0.06 * range.span() : 1;
  panel.x_range = {range.low - air, range.high + air};
  return panel;
}

std::vector<std::string> names_of(const Inputs& inputs) {
  std::vector<std::string> names;
  for (const study::SensitiveInput& each : inputs) names.push_back(input_label(each.names));
  return names;
}

/// One index below the other, as bars with their intervals.
Panel index_panel(const study::StudySensitivity& found, const Inputs& inputs) {
  Panel panel{.title = "",
              .x_label = "Share of the variance, 95 % intervals",
              .y_label = "",
              .legend_columns = 2,
              .x_range = {0, 1},
              .rows = names_of(inputs)};
  const auto add = [&](const statistics::VarianceIndex& index, double middle, double half,
                       std::size_t color) {
    panel.bars.push_back({middle,
                          half,
                          {0, std::clamp(index.estimate, 0.0, 1.0)},
                          {.stroke = "", .fill = palette(color)}});
    const Range& interval = {index.interval.low, index.interval.high};
    panel.bars.push_back({middle, 0, interval, {.width = 1.4}});
    for (const double end : {interval.low, interval.high})
      panel.bars.push_back({middle, half / 2, {end, end}, {.width = 1.4}});
  };
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double middle = static_cast<double>(i) + 0.5, half = kBar / 2 / kRow;
    const auto &index = inputs[i].index, &total = inputs[i].total;
    if (index && !total) add(*index, middle, half, kFirst);
    if (!index || !total) continue;
    add(*index, middle - 0.7 * half, 0.7 * half, kFirst);
    add(*total, middle + 0.7 * half, 0.7 * half, kTotal);
  }
  const auto pen_of = [](std::size_t color) {
    return Pen{.stroke = palette(color), .fill = palette(color)};
  };
  panel.marks = {key("First-order index", pen_of(kFirst))};
  if (found.designed) panel.marks.push_back(key("total index", pen_of(kTotal)));
  return panel;
}

std::size_t fewest_of(const Inputs& inputs) {
  std::size_t fewest = inputs.front().bar.low_runs;
  for (const study::SensitiveInput& each : inputs)
    fewest = std::min({fewest, each.bar.low_runs, each.bar.high_runs});
  return fewest;
}

}  // namespace

std::string sensitivity_figure(const report::SensitivityReport& report) {
  const study::StudySensitivity& found = report.found;
  const study::ReportUnit unit = report.units.of(found.units);
  Inputs inputs = found.inputs;
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  std::string about = report.configuration;
  if (!found.level.empty()) about += (about.empty() ? "" : ", ") + found.level;
  Panel tornado = tornado_panel(found, inputs, unit.in_si);
  tornado.x_label = fmt::format("Mean{}", unit.name == "1" ? "" : " (" + unit.name + ")");
  return Chart{.title = "Sensitivity of " + words_of(found.output),
               .note = fmt::format("{}{}{} runs{}; dashed: mean of all runs", about,
                                   about.empty() ? "" : ", ", found.runs,
                                   found.inputs.size() > kMaxRows ? ", first 20 inputs" : ""),
               .panels = {{.panel = index_panel(found, inputs)}, {.panel = std::move(tornado)}},
               .columns = 2}
      .svg({.width = 1180});
}

std::string tornado_figure(const PlotPage& page, const std::string& title,
                           const std::vector<report::SensitivityReport>& reports) {
  Chart chart{title,
              "means over the runs in which an input is low or high; dashed: mean of all "
              "runs"};
  bool cut = false;
  for (const report::SensitivityReport& each : reports) {
    const study::StudySensitivity& found = each.found;
    const study::ReportUnit unit = each.units.of(found.units);
    const Inputs inputs = longest(found);
    Panel panel = tornado_panel(found, inputs, unit.in_si);
    panel.title =
        words_of(found.output) + (each.configuration.empty() ? "" : ", " + each.configuration);
    panel.x_label = with_unit(
        inputs.empty()
            ? fmt::format("Means of fewer than {} runs are not drawn", study::kFewestOfMean)
            : fmt::format("Mean over {} runs or more", fewest_of(inputs)),
        unit);
    if (!inputs.empty()) panel.rows = names_of(inputs);
    chart.panels.push_back({.panel = std::move(panel)});
    cut = cut || std::ranges::count_if(found.inputs, &study::SensitiveInput::drawn) >
                     static_cast<std::ptrdiff_t>(kMaxRows);
  }
  if (cut) chart.note += "; the 20 longest bars";
  return chart.svg(page);
}

}  // namespace gurney::figures
