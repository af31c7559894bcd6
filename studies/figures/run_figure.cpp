#include "studies/figures/run_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/chart.h"
#include "studies/figures/labels.h"
#include "studies/figures/plan_view.h"
#include "studies/results/names.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 1060, kHeight = 150, kPlanWidth = 740;

/// Panels over time, in the units of the figure.
struct Panels {
  const study::RunFacts& facts;
  const study::UnitSystem& units;

  Panel panel(const std::string& title, const std::string& quantity, const char* unit,
              int legend_columns) const {
    return {.title = title,
            .x_label = "Time (s)",
            .y_label = with_unit(quantity, units.of(unit)),
            .legend_columns = legend_columns};
  }

  template <class Get>
  void add(Panel& panel, const std::string& label, const std::vector<Sample>& history,
           const char* unit, Get get) const {
    const double in_si = units.of(unit).in_si;
    panel.curves.push_back(curve_over(
        label, history, pen(panel.curves.size()), [](const Sample& s) { return s.time; },
        [&](const Sample& s) { return get(s) / in_si; }));
  }

  /// A curve for each axis; the vertical only where something moves vertically.
  Panel vector(const std::string& quantity, const char* unit, const std::vector<Sample>& history,
               Vector3 Sample::*member) const {
    Panel made = panel(quantity + " relative to the floor", quantity, unit, 3);
    double largest = 0, vertical = 0;
    for (const Sample& sample : history) {
      largest = std::max(largest, (sample.*member).cwiseAbs().maxCoeff());
      vertical = std::max(vertical, std::abs((sample.*member).z()));
    }
    add(made, "x", history, unit, [&](const Sample& s) { return (s.*member).x(); });
    add(made, "y", history, unit, [&](const Sample& s) { return (s.*member).y(); });
    if (vertical > 0.05 * largest)
      add(made, "z", history, unit, [&](const Sample& s) { return (s.*member).z(); });
    return made;
  }

  Panel wheels(const std::string& title, const std::string& quantity, const char* unit,
               const std::vector<Sample>& history, double WheelSample::*member,
               bool rigid_too = true) const {
    Panel made = panel(title, quantity, unit, 2);
    const auto& casters = facts.scene.items[0].model.casters;
    for (std::size_t i = 0; i < casters.size(); ++i) {
      if (!rigid_too && !casters[i].swivels) continue;
      add(made, casters[i].name, history, unit,
          [&](const Sample& s) { return s.wheels[i].*member; });
      made.curves.back().pen = pen(i);
    }
    return made;
  }

  /// The input, at the samples of the history.
  Panel floor(const std::vector<Sample>& history) const {
    Panel made = panel("Floor acceleration", "Acceleration", "m/s2", 3);
    const char* const names[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<Eigen::Index>(axis);
      if (facts.floor.at_rest() || facts.floor.acceleration().row(row).isZero(0)) continue;
      add(made, names[axis], history, "m/s2",
          [&](const Sample& s) { return facts.floor.acceleration_at(s.time)[row]; });
      made.curves.back().pen = pen(axis);
    }
    return made;
  }

  Panel energy(const std::vector<Sample>& history, double at_start) const {
    Panel made = panel("Energy balance", "Energy", "J", 4);
    const auto of = [&](const char* label, auto get) {
      add(made, label, history, "J", [&](const Sample& s) { return get(s.energy); });
    };
    of("work", [](const EnergyAccount& e) { return e.work(); });
    of("kinetic", [](const EnergyAccount& e) { return e.kinetic; });
    of("stored", [&](const EnergyAccount& e) { return e.stored() - e.kinetic - at_start; });
    of("rolling", [](const EnergyAccount& e) { return e.rolling_loss; });
    of("sliding", [](const EnergyAccount& e) { return e.sliding_loss; });
    of("other loss",
       [](const EnergyAccount& e) { return e.loss() - e.rolling_loss - e.sliding_loss; });
    of("closure", [&](const EnergyAccount& e) { return e.closure(at_start); });
    made.curves.back().pen.dash = "4 3";
    return made;
  }

  std::vector<Panel> of_item(const ItemResponse& item) const {
    const std::vector<Sample>& history = item.history;
    Panel turn = panel("Yaw and tilt", "Angle", "rad", 2);
    add(turn, "yaw", history, "rad", [](const Sample& s) { return s.yaw; });
    add(turn, "tilt", history, "rad", [](const Sample& s) { return s.tilt; });
    Panel forces =
        wheels("Normal forces", "Normal force", "N", history, &WheelSample::normal_force);
    forces.lanes = true;
    std::vector<Panel> panels{
        floor(history),
        vector("Displacement", "m", history, &Sample::displacement),
        vector("Velocity", "m/s", history, &Sample::velocity),
        vector("Acceleration", "m/s2", history, &Sample::acceleration),
        turn,
        wheels("Swivel angles", "Swivel angle", "rad", history, &WheelSample::swivel_angle, false),
        forces,
        energy(history, item.stored_energy_at_start)};
    std::erase_if(panels, [](const Panel& panel) { return panel.curves.empty(); });
    const bool pulled = std::ranges::any_of(
        history, [](const Sample& s) { return s.cable_tension != 0 || s.pull_force != 0; });
    if (!pulled) return panels;
    Panel pull = panel("Pull", "Force", "N", 2);
    add(pull, "cable tension", history, "N", [](const Sample& s) { return s.cable_tension; });
    add(pull, "point forces", history, "N", [](const Sample& s) { return s.pull_force; });
    panels.push_back(std::move(pull));
    return panels;
  }

  /// A curve for each item, in the colours of the plan.
  std::vector<Panel> of_items(const Response& response) const {
    Panel distance = panel("Horizontal distance from the start", "Distance", "m", 0),
          tilt = panel("Tilt", "Angle", "rad", 0);
    const std::vector<std::string> names = study::item_names(facts.scene);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::vector<Sample>& history = response.items[i].history;
      add(distance, names[i], history, "m",
          [](const Sample& s) { return s.displacement.head<2>().norm(); });
      add(tilt, names[i], history, "rad", [](const Sample& s) { return s.tilt; });
      for (Panel* panel : {&distance, &tilt})
        if (i >= 7) panel->curves.back().pen.dash = "5 3";  // the palette repeats
    }
    return {distance, tilt};
  }
};

std::string about(const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  return fmt::format("{} \u00b7 {} \u00b7 {} at {:.2f} s{}",
                     names.size() == 1 ? names[0] : fmt::format("{} items", names.size()),
                     facts.record ? facts.record->name : "floor at rest", name_of(response.outcome),
                     response.end_time, response.cause.empty() ? "" : ": " + response.cause);
}

}  // namespace

std::string run_figure(const study::RunFacts& facts, const Response& response,
                       const study::UnitSystem& chosen) {
  const study::UnitSystem units = chosen.or_else("m");
  Chart chart{.title = facts.title.empty() ? facts.job_name : facts.title,
              .note = about(facts, response),
              .columns = 2};
  if (response.items[0].history.empty()) {
    chart.footnotes = {"No history was kept, so there is nothing to draw."};
    return chart.svg({.width = kWidth});
  }
  const Panels make{facts, units};
  const bool alone = response.items.size() == 1;
  PlotPanel plan{.panel = plan_panel(facts.scene, response, chosen),
                 .overlay = [&](Svg& svg, const Frame& frame, const Scaling& scaling) {
                   draw_plan(svg, frame, scaling, facts.scene, response, chosen);
                 }};
  if (alone && facts.scene.room.empty()) {
    plan.down = 2;
  } else {
    plan.across = 2;
    plan.beside = kWidth - kPlanWidth - 86;
    plan.height = std::clamp(kPlanWidth * plan_aspect(plan.panel), kPlanWidth / 3, kPlanWidth);
  }
  chart.panels =
      of_height(alone ? make.of_item(response.items[0]) : make.of_items(response), kHeight);
  chart.panels.insert(chart.panels.begin(), std::move(plan));
  return chart.svg({.width = kWidth});
}

}  // namespace gurney::figures
