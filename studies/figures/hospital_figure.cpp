#include "studies/figures/hospital_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "studies/figures/chart.h"

namespace gurney::figures {
namespace {

constexpr double kRowHeight = 26, kHospitalHead = 90;  // [px]
constexpr const char *kNothing = "#b0b0b0", *kInterval = "#d55e00";
constexpr std::size_t kGained = 2, kMostActions = 20;

/// A bar with its interval, in a row. A rectangle without height would not be drawn.
void add_answer(Panel& panel, const study::Answer& answer, double middle, double half,
                const std::string& color) {
  const Range interval{answer.interval.low, answer.interval.high};
  panel.bars.push_back({middle, half, {0, answer.value}, {.stroke = "", .fill = color}});
  panel.bars.push_back({middle, 0.025, interval, {.stroke = "", .fill = kInterval}});
}

Marks key(const std::string& label, const std::string& color) {
  return {label, {}, {}, {.stroke = color, .fill = color}, Marker::kSquare, 4};
}

PlotPanel services_panel(const study::HospitalAnswer& answer) {
  const std::size_t levels = answer.levels.size();
  Panel panel{.title = "",
              .x_label = "Chance that it works, 95 % intervals",
              .y_label = "",
              .legend_columns = 4,
              .x_range = {0, 1}};
  const auto& first = answer.levels.front();
  for (const auto* list : {&first.services, &first.rooms})
    for (const study::ServiceAnswer& each : *list) panel.rows.push_back(each.name);
  for (std::size_t level = 0; level < levels; ++level) {
    const study::LevelAnswer& of = answer.levels[level];
    const std::string color = ramp(level, levels);
    panel.marks.push_back(key(fmt::format("PGV {:g} m/s", of.pgv), color));
    std::size_t row = 0;
    for (const auto* list : {&of.services, &of.rooms})
      for (const study::ServiceAnswer& each : *list) {
        const double half = 0.4 / static_cast<double>(levels);
        add_answer(panel, each.works,
                   static_cast<double>(row++) + 0.1 + half * (2 * static_cast<double>(level) + 1),
                   0.85 * half, color);
      }
  }
  const double rows = static_cast<double>(panel.rows.size());
  return {.panel = std::move(panel),
          .height =
              kHospitalHead + rows * kRowHeight * std::max(1.0, 0.5 * static_cast<double>(levels))};
}

PlotPanel ranking_panel(const study::HospitalAnswer& answer) {
  Panel panel{.title = "",
              .x_label = fmt::format("Less {} at a PGV of {:g} m/s, 95 % intervals",
                                     answer.ranked_by, answer.ranked_at),
              .y_label = "",
              .legend_columns = 2};
  Range range{0, 0};
  for (std::size_t i = 0; i < std::min(kMostActions, answer.ranking.size()); ++i) {
    const study::RankedAction& action = answer.ranking[i];
    panel.rows.push_back(action.name + ": " + action.group);
    add_answer(panel, action.gain, static_cast<double>(i) + 0.5, 0.25,
               action.taken ? palette(kGained) : std::string(kNothing));
    range =
        widened(range, {action.gain.value, action.gain.interval.low, action.gain.interval.high});
  }
  const double air = range.span() > 0 ? 0.05 * range.span() : 1;
  panel.x_range = {range.low - air, range.high + air};
  panel.guides = {{0}};
  panel.marks = {key("gains, in this order", palette(kGained)),
                 key("no gain after those", kNothing)};
  const double rows = static_cast<double>(panel.rows.size());
  return {.panel = std::move(panel), .height = kHospitalHead + rows * kRowHeight};
}

}  // namespace

std::string hospital_figure(const study::Hospital& hospital, const study::HospitalAnswer& answer) {
  Chart chart{.title = hospital.title,
              .note = fmt::format(
                  "{} pieces, {} samples{}; costs in {}", answer.pieces, answer.samples,
                  answer.records > 0 ? fmt::format(" of the runs with {} records", answer.records)
                                     : std::string(" of fragility curves"),
                  answer.money)};
  chart.panels.push_back(services_panel(answer));
  if (!answer.ranking.empty()) chart.panels.push_back(ranking_panel(answer));
  return chart.svg();
}

}  // namespace gurney::figures
