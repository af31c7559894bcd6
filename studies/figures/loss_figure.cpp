#include "studies/figures/loss_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/error.h"
#include "studies/figures/chart.h"
#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

using study::ExpectedLoss;
using study::StudyLoss;

constexpr double kRowHeight = 26, kLossHead = 90;  // [px]
constexpr const char* kInterval = "#333333";
using NamedCurve = std::pair<std::string, const ExpectedLoss*>;

/// Bars of all configurations in the row of each level, the interval of the records over each.
PlotPanel levels_panel(const std::vector<StudyLoss>& losses, const std::string& money) {
  Panel panel{.title = "",
              .x_label = fmt::format("Expected loss, {}, 95 % intervals", money),
              .y_label = "",
              .legend_columns = 2};
  const double half = 0.4 / static_cast<double>(losses.size());
  double most = 0;
  for (std::size_t i = 0; i < losses.size(); ++i) {
    const std::string color = palette(i);
    panel.marks.push_back(
        {losses[i].configuration, {}, {}, {.stroke = color, .fill = color}, Marker::kSquare, 4});
    for (const study::LossAtLevel& at : losses[i].levels) {
      const auto row = std::ranges::find(panel.rows, at.level);
      const double middle = static_cast<double>(row - panel.rows.begin()) + 0.1 +
                            half * (2 * static_cast<double>(i) + 1);
      if (row == panel.rows.end()) panel.rows.push_back(at.level);
      panel.bars.push_back(
          {middle, 0.85 * half, {0, at.cost.value}, {.stroke = "", .fill = color}});
      most = std::max(most, at.cost.value);
      if (!at.cost.interval) continue;
      panel.bars.push_back({middle,
                            0.025,
                            {at.cost.interval->low, at.cost.interval->high},
                            {.stroke = "", .fill = kInterval}});
      most = std::max(most, at.cost.interval->high);
    }
  }
  panel.x_range = {0, most > 0 ? 1.05 * most : 1};
  const double rows = static_cast<double>(panel.rows.size());
  const double bars = std::max(1.0, 0.5 * static_cast<double>(losses.size()));
  return {.panel = std::move(panel), .height = kLossHead + rows * kRowHeight * bars};
}

/// Chances over the cost, on axes of decades; an interval that reaches 0 ends at a
/// tenth of the smallest chance.
PlotPanel exceedance_panel(const std::vector<NamedCurve>& curves, const std::string& money,
                           const std::string& y_label) {
  Panel panel{.title = "",
              .x_label = fmt::format("Loss above, {}", money),
              .y_label = y_label,
              .zero_line = false,
              .log_x = true,
              .legend_columns = 2,
              .log_y = true};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [name, of] : curves)
    for (const study::LossExceedance& each : of->exceedance)
      if (each.chance.value > 0) least = std::min(least, each.chance.value);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Curve line{curves[i].first, {}, {}, pen(i)};
    Marks points{"", {}, {}, pen(i), marker(i)};
    Area area{.x = {}, .low = {}, .high = {}, .color = palette(i)};
    for (const study::LossExceedance& each : curves[i].second->exceedance) {
      if (!(each.chance.value > 0)) continue;
      line.add(each.cost, each.chance.value);
      points.add(each.cost, each.chance.value);
      if (each.chance.interval)
        area.add(each.cost, std::max(each.chance.interval->low, least / 10),
                 each.chance.interval->high);
    }
    if (line.x.empty()) continue;
    line.key = marker(i);
    panel.curves.push_back(std::move(line));
    panel.marks.push_back(std::move(points));
    if (!area.x.empty()) panel.areas.push_back(std::move(area));
  }
  return {.panel = std::move(panel), .aspect = 0.5};
}

std::vector<NamedCurve> curves_at(const std::vector<StudyLoss>& losses, std::size_t intensity) {
  std::vector<NamedCurve> curves;
  for (const StudyLoss& loss : losses)
    if (intensity < loss.at.size()) curves.emplace_back(loss.configuration, &loss.at[intensity]);
  return curves;
}

}  // namespace

std::string loss_figure(const study::Consequences& consequences,
                        const std::vector<StudyLoss>& losses, const study::ReportUnit& unit) {
  const std::string money = consequences.money();
  Chart chart{.title = "Losses",
              .note = "95 % intervals are of the records, not of prices and repairs"};
  if (std::ranges::any_of(losses, [](const StudyLoss& each) { return !each.levels.empty(); }))
    chart.panels.push_back(levels_panel(losses, money));
  const auto add = [&](const std::vector<NamedCurve>& curves, const std::string& label) {
    PlotPanel panel = exceedance_panel(curves, money, label);
    if (!panel.panel.curves.empty()) chart.panels.push_back(std::move(panel));
  };
  for (std::size_t i = 0; !losses.empty() && i < losses.front().at.size(); ++i)
    add(curves_at(losses, i), fmt::format("P at {} {:g} {}", losses.front().measure.name,
                                          losses.front().at[i].im / unit.in_si, unit_label(unit)));
  std::vector<NamedCurve> annual;
  for (const StudyLoss& loss : losses)
    if (loss.annual) annual.emplace_back(loss.configuration, &*loss.annual);
  add(annual, "Times a year");
  require(!chart.panels.empty(),
          "no figure: neither levels, nor a loss above 0 at an intensity or with a hazard");
  return chart.svg();
}

}  // namespace gurney::figures
