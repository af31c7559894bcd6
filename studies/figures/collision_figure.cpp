#include "studies/figures/collision_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "studies/figures/scene_figure.h"
#include "studies/results/names.h"

namespace gurney::figures {
namespace {

constexpr double kLargest = 7;  // radius of the largest circle [px]

/// Four classes of approach speed between 1, 2 and 5 times powers of ten, the fastest first.
struct SpeedClasses {
  explicit SpeedClasses(double fastest) {
    const double power = std::pow(10, std::floor(std::log10(std::max(fastest, 1e-6))));
    constexpr std::array kSteps{0.2, 0.5, 1.0, 2.0, 5.0, 10.0};
    std::size_t top = 2;
    while (top + 1 < kSteps.size() && kSteps[top] * power < fastest) ++top;
    for (std::size_t i = 0; i < bounds.size(); ++i)
      bounds[i] = top >= i ? kSteps[top - i] * power : 0.1 * power;
  }

  std::size_t of(double speed) const {
    std::size_t found = 0;
    while (found + 1 < bounds.size() && speed <= bounds[found + 1]) ++found;
    return found;
  }
  std::string name(std::size_t index, const std::string& unit) const {
    return index + 1 < bounds.size()
               ? fmt::format("{:.4g} to {:.4g} {}", bounds[index + 1], bounds[index], unit)
               : fmt::format("to {:.4g} {}", bounds[index], unit);
  }
  /// The area is in proportion to the speed.
  double radius(std::size_t index) const {
    return kLargest * std::sqrt(bounds[index] / bounds.front());
  }

  std::array<double, 4> bounds;
};

PlotPanel panel_of(const CollisionMap& map, const SpeedClasses& classes,
                   const study::UnitSystem& units) {
  const study::ReportUnit speed_unit = units.of("m/s");
  Panel panel = scene_panel(map.scene);
  panel.title = fmt::format("{}{}{} impacts in {} run{}", map.name, map.name.empty() ? "" : ": ",
                            map.impacts.size(), map.runs, map.runs == 1 ? "" : "s");
  const std::vector<std::string> names = study::item_names(map.scene);
  for (std::size_t speed = 0; speed < classes.bounds.size(); ++speed) {
    panel.marks.push_back({classes.name(speed, speed_unit.name),
                           {},
                           {},
                           {.stroke = "#555555", .fill = "#bbbbbb", .opacity = 0.6},
                           Marker::kCircle,
                           classes.radius(speed)});
    for (std::size_t item = 0; item < names.size(); ++item) {
      const std::string color = palette(item);
      Marks marks{"",
                  {},
                  {},
                  {.stroke = color, .width = 0.7, .fill = color, .opacity = 0.45},
                  Marker::kCircle,
                  classes.radius(speed)};
      for (const study::StoredImpact& impact : map.impacts)
        if (impact.item == names[item] && classes.of(impact.speed / speed_unit.in_si) == speed) {
          marks.x.push_back(impact.x);
          marks.y.push_back(impact.y);
        }
      if (!marks.x.empty()) panel.marks.push_back(std::move(marks));
    }
  }
  set_unit(panel, units);
  return {.panel = panel, .aspect = aspect_of_plan(panel)};
}

}  // namespace

std::string collision_figure(const PlotPage& page, const std::string& title,
                             const std::string& note, const std::vector<CollisionMap>& maps) {
  double fastest = 0;
  for (const CollisionMap& map : maps)
    for (const study::StoredImpact& impact : map.impacts) fastest = std::max(fastest, impact.speed);
  const SpeedClasses classes(fastest / page.units.of("m/s").in_si);
  std::vector<PlotPanel> panels;
  for (const CollisionMap& map : maps) panels.push_back(panel_of(map, classes, page.units));
  return Chart{title, note, panels}.svg(page);
}

}  // namespace gurney::figures
