#include "studies/figures/sensitivity_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr std::size_t kMaxRows = 20;
constexpr std::size_t kFirst = 5, kTotal = 4;  // of the palette
constexpr double kNames = 400, kWidth = 330, kGap = 60, kRow = 24, kTop = 110, kBar = 13;

/// An axis of its own: ticks below, a line for each.
void draw_axis(Svg& svg, const Frame& frame, const Range& range, const std::string& title,
               const std::string& label) {
  const Scaling scaling(frame, range, {0, 1});
  const double bottom = frame.y + frame.height;
  for (const double value : ticks(range, 5)) {
    svg.line(scaling.x(value), frame.y, scaling.x(value), bottom, {.stroke = "#e6e6e6"});
    svg.text(scaling.x(value), bottom + 15,
             fmt::format("{:.4g}", std::abs(value) < 1e-12 * range.span() ? 0 : value),
             {.size = 10, .anchor = Anchor::kMiddle});
  }
  svg.rectangle(frame.x, frame.y, frame.width, frame.height, {.stroke = "#444444", .width = 0.8});
  svg.text(frame.x, frame.y - 9, title, {.size = 12, .bold = true});
  svg.text(frame.x + frame.width / 2, bottom + 31, label, {.anchor = Anchor::kMiddle});
}

Range range_of_bars(const study::StudySensitivity& found,
                    const std::vector<study::SensitiveInput>& inputs) {
  Range range{found.mean, found.mean};
  for (const study::SensitiveInput& input : inputs) {
    if (!input.drawn || std::isnan(input.bar.swing())) continue;
    range.low = std::min({range.low, input.bar.low, input.bar.high});
    range.high = std::max({range.high, input.bar.low, input.bar.high});
  }
  const double air = range.span() > 0 ? 0.06 * range.span() : 1;
  return {range.low - air, range.high + air};
}

void draw_index(Svg& svg, const Scaling& scaling, double y, double bar, std::size_t color,
                const statistics::VarianceIndex& index) {
  const double from = scaling.x(0), to = scaling.x(std::clamp(index.estimate, 0.0, 1.0));
  svg.rectangle(from, y - bar / 2, to - from, bar, {.stroke = "", .fill = palette(color)});
  svg.line(scaling.x(index.interval.low), y, scaling.x(index.interval.high), y, {.width = 1.4});
  for (const double end : {index.interval.low, index.interval.high})
    svg.line(scaling.x(end), y - bar / 3, scaling.x(end), y + bar / 3, {.width = 1.4});
}

void draw_indices(Svg& svg, const Scaling& scaling, double y, const study::SensitiveInput& input) {
  if (!input.index) return;
  if (!input.total) return draw_index(svg, scaling, y, kBar, kFirst, *input.index);
  const double bar = 0.7 * kBar;
  draw_index(svg, scaling, y - bar / 2, bar, kFirst, *input.index);
  draw_index(svg, scaling, y + bar / 2, bar, kTotal, *input.total);
}

/// Low above, high below, each from the mean: both are seen where they go the same way.
void draw_bar(Svg& svg, const Scaling& scaling, double y, const statistics::TornadoBar& bar,
              double mean) {
  if (std::isnan(bar.swing())) return;
  const auto half = [&](double end, double top, std::size_t color) {
    const double x = std::min(scaling.x(end), scaling.x(mean));
    svg.rectangle(x, top, std::abs(scaling.x(end) - scaling.x(mean)), kBar / 2,
                  {.stroke = "", .fill = palette(color)});
  };
  half(bar.low, y - kBar / 2, 0);
  half(bar.high, y, 1);
}

/// What the tornado draws, in a unit.
study::StudySensitivity in_unit(study::StudySensitivity found, double unit) {
  found.mean /= unit;
  for (study::SensitiveInput& input : found.inputs) {
    input.bar.low /= unit;
    input.bar.high /= unit;
  }
  return found;
}

}  // namespace

std::string sensitivity_figure(const report::SensitivityReport& report) {
  const study::ReportUnit unit = report.units.of(report.found.units);
  const study::StudySensitivity found = in_unit(report.found, unit.in_si);
  std::vector<study::SensitiveInput> inputs = found.inputs;
  if (inputs.size() > kMaxRows) inputs.resize(kMaxRows);
  const double height = kRow * static_cast<double>(std::max<std::size_t>(1, inputs.size()));
  Svg svg(kNames + 2 * kWidth + kGap + 40, kTop + height + 55);
  svg.text(24, 34, "Sensitivity of " + found.output, {.size = 16, .bold = true});
  std::string about = report.configuration;
  if (!found.level.empty()) about += (about.empty() ? "" : ", ") + found.level;
  svg.text(24, 55,
           fmt::format("{}{}{} runs{}", about, about.empty() ? "" : ", ", found.runs,
                       found.inputs.size() > kMaxRows ? ", first 20 inputs" : ""),
           {.size = 12, .color = "#555555"});
  const Frame left{kNames, kTop, kWidth, height};
  const Frame right{kNames + kWidth + kGap, kTop, kWidth, height};
  const Range range = range_of_bars(found, inputs);
  draw_axis(svg, left, {0, 1}, found.designed ? "" : "First-order index, 95 % interval",
            "Share of the variance");
  if (found.designed) {
    svg.text(left.x, left.y - 9, "First-order index", {.bold = true, .color = palette(kFirst)});
    svg.text(left.x + 130, left.y - 9, "total index", {.bold = true, .color = palette(kTotal)});
    svg.text(left.x + left.width, left.y - 9, "95 % intervals", {.anchor = Anchor::kEnd});
  }
  draw_axis(svg, right, range, "",
            fmt::format("Mean{}", unit.name == "1" ? "" : " (" + unit.name + ")"));
  svg.text(right.x, right.y - 9,
           fmt::format("Runs with the input in its lowest {:g} %", 100 * found.share),
           {.size = 12, .bold = true, .color = palette(0)});
  svg.text(right.x + right.width, right.y - 9, "highest",
           {.size = 12, .anchor = Anchor::kEnd, .bold = true, .color = palette(1)});
  const Scaling of_index(left, {0, 1}, {0, 1}), of_mean(right, range, {0, 1});
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double y = kTop + kRow * (static_cast<double>(i) + 0.5);
    svg.text(kNames - 8, y + 4, fitted(report::name_of(inputs[i]), 11, kNames - 24),
             {.anchor = Anchor::kEnd});
    draw_indices(svg, of_index, y, inputs[i]);
    if (inputs[i].drawn) draw_bar(svg, of_mean, y, inputs[i].bar, found.mean);
  }
  svg.line(of_mean.x(found.mean), kTop, of_mean.x(found.mean), kTop + height,
           {.stroke = "#444444", .dash = "4 3"});
  return svg.str();
}

}  // namespace gurney::figures
