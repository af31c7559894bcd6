#include "studies/figures/run_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/figures/labels.h"
#include "studies/figures/panel.h"
#include "studies/figures/plan_view.h"
#include "studies/results/names.h"

namespace gurney::figures {
namespace {

constexpr double kWidth = 1060, kLeft = 70, kColumn = 560, kPanelWidth = 430, kPanelHeight = 150,
                 kTop = 112, kRow = 225, kPlanWidth = 740;

Frame frame_at(int column, int row, double top = kTop, int rows = 1) {
  return {kLeft + column * (kColumn - kLeft + 30.0), top + row * kRow, kPanelWidth,
          kPanelHeight + (rows - 1) * kRow};
}

template <class Get>
Curve curve(const std::string& label, const std::vector<Sample>& history, std::size_t color,
            Get get) {
  Curve result{label, {}, {}, {.stroke = palette(color), .width = 1.3}};
  for (const Sample& sample : history) {
    result.x.push_back(sample.time);
    result.y.push_back(get(sample));
  }
  return result;
}

Panel time_panel(const std::string& title, const std::string& y_label, int legend_columns) {
  return {.title = title,
          .x_label = "Time (s)",
          .y_label = y_label,
          .curves = {},
          .legend_columns = legend_columns};
}

/// A curve for each axis; the vertical only where something moves vertically.
Panel vector_panel(const std::string& title, const std::string& y_label,
                   const study::ReportUnit& unit, const std::vector<Sample>& history,
                   Vector3 Sample::*member) {
  Panel panel = time_panel(title, with_unit(y_label, unit), 3);
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = [&](const Sample& s) { return (s.*member)[axis] / unit.in_si; };
    double largest = 0;
    for (const Sample& sample : history)
      largest = std::max(largest, (sample.*member).cwiseAbs().maxCoeff() / unit.in_si);
    const bool moves = std::any_of(history.begin(), history.end(), [&](const Sample& s) {
      return std::abs(value(s)) > 0.05 * largest;
    });
    if (axis < 2 || moves)
      panel.curves.push_back(curve(names[axis], history, static_cast<std::size_t>(axis), value));
  }
  return panel;
}

Panel wheel_panel(const std::string& title, const std::string& y_label,
                  const study::RunFacts& facts, const std::vector<Sample>& history,
                  double WheelSample::*member, const study::ReportUnit& unit,
                  bool rigid_too = true) {
  Panel panel = time_panel(title, with_unit(y_label, unit), 2);
  const auto& casters = facts.scene.items[0].model.casters;
  for (std::size_t i = 0; i < casters.size(); ++i)
    if (rigid_too || casters[i].swivels)
      panel.curves.push_back(curve(casters[i].name, history, i, [&](const Sample& s) {
        return s.wheels[i].*member / unit.in_si;
      }));
  return panel;
}

/// The input, at the samples of the history.
Panel floor_panel(const FloorMotion& floor, const std::vector<Sample>& history,
                  const study::ReportUnit& unit) {
  Panel panel = time_panel("Floor acceleration", with_unit("Acceleration", unit), 3);
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis)
    if (!floor.at_rest() && floor.acceleration().row(axis).cwiseAbs().maxCoeff() > 0)
      panel.curves.push_back(
          curve(names[axis], history, static_cast<std::size_t>(axis),
                [&](const Sample& s) { return floor.acceleration_at(s.time)[axis] / unit.in_si; }));
  return panel;
}

Panel energy_panel(const std::vector<Sample>& history, double stored_at_start,
                   const study::ReportUnit& unit) {
  Panel panel = time_panel("Energy balance", with_unit("Energy", unit), 4);
  const auto add = [&](const char* label, auto get) {
    panel.curves.push_back(curve(label, history, panel.curves.size(),
                                 [&](const Sample& s) { return get(s.energy) / unit.in_si; }));
  };
  add("work", [](const EnergyAccount& e) { return e.work(); });
  add("kinetic", [](const EnergyAccount& e) { return e.kinetic; });
  add("stored", [&](const EnergyAccount& e) { return e.stored() - e.kinetic - stored_at_start; });
  add("rolling", [](const EnergyAccount& e) { return e.rolling_loss; });
  add("sliding", [](const EnergyAccount& e) { return e.sliding_loss; });
  add("other loss",
      [](const EnergyAccount& e) { return e.loss() - e.rolling_loss - e.sliding_loss; });
  add("closure", [&](const EnergyAccount& e) { return e.closure(stored_at_start); });
  panel.curves.back().pen.dash = "4 3";
  return panel;
}

Panel pull_panel(const std::vector<Sample>& history, const study::ReportUnit& unit) {
  Panel panel = time_panel("Pull", with_unit("Force", unit), 2);
  panel.curves = {curve("cable tension", history, 0,
                        [&](const Sample& s) { return s.cable_tension / unit.in_si; }),
                  curve("point forces", history, 1,
                        [&](const Sample& s) { return s.pull_force / unit.in_si; })};
  return panel;
}

Panel turn_panel(const std::vector<Sample>& history, const study::ReportUnit& unit) {
  Panel panel = time_panel("Yaw and tilt", with_unit("Angle", unit), 2);
  panel.curves = {curve("yaw", history, 0, [&](const Sample& s) { return s.yaw / unit.in_si; }),
                  curve("tilt", history, 1, [&](const Sample& s) { return s.tilt / unit.in_si; })};
  return panel;
}

/// A curve for each item.
template <class Get>
Panel item_panel(const std::string& title, const std::string& y_label, const study::RunFacts& facts,
                 const Response& response, Get get) {
  Panel panel = time_panel(title, y_label, 0);
  const std::vector<std::string> names = study::item_names(facts.scene);
  for (std::size_t i = 0; i < names.size(); ++i) {
    panel.curves.push_back(curve(names[i], response.items[i].history, i, get));
    if (i >= 7) panel.curves.back().pen.dash = "5 3";  // the palette repeats
  }
  return panel;
}

void draw_heading(Svg& svg, const study::RunFacts& facts, const Response& response) {
  const std::vector<std::string> names = study::item_names(facts.scene);
  const std::string items = names.size() == 1 ? names[0] : fmt::format("{} items", names.size());
  const std::string floor = facts.record ? facts.record->name : "floor at rest";
  svg.text(kLeft, 34, facts.title.empty() ? facts.job_name : facts.title,
           {.size = 17, .bold = true});
  svg.text(kLeft, 55,
           fmt::format("{}   \u00b7   {}   \u00b7   {} at {:.2f} s{}", items, floor,
                       name_of(response.outcome), response.end_time,
                       response.cause.empty() ? "" : ": " + response.cause),
           {.size = 12, .color = "#555555"});
}

bool pulled(const std::vector<Sample>& history) {
  return std::any_of(history.begin(), history.end(),
                     [](const Sample& s) { return s.cable_tension != 0 || s.pull_force != 0; });
}

std::vector<Panel> panels_of_item(const study::RunFacts& facts, const ItemResponse& item,
                                  const study::UnitSystem& units) {
  const std::vector<Sample>& history = item.history;
  Panel forces = wheel_panel("Normal forces", "Normal force", facts, history,
                             &WheelSample::normal_force, units.of("N"));
  forces.lanes = true;
  std::vector<Panel> panels{floor_panel(facts.floor, history, units.of("m/s2")),
                            vector_panel("Displacement relative to the floor", "Displacement",
                                         units.of("m"), history, &Sample::displacement),
                            vector_panel("Velocity relative to the floor", "Velocity",
                                         units.of("m/s"), history, &Sample::velocity),
                            vector_panel("Acceleration relative to the floor", "Acceleration",
                                         units.of("m/s2"), history, &Sample::acceleration),
                            turn_panel(history, units.of("rad")),
                            wheel_panel("Swivel angles", "Swivel angle", facts, history,
                                        &WheelSample::swivel_angle, units.of("rad"), false),
                            forces,
                            energy_panel(history, item.stored_energy_at_start, units.of("J"))};
  std::erase_if(panels, [](const Panel& panel) { return panel.curves.empty(); });
  if (pulled(history)) panels.push_back(pull_panel(history, units.of("N")));
  return panels;
}

void draw_panel(Svg& svg, const Frame& frame, const Panel& panel) {
  if (panel.lanes)
    draw_lanes(svg, frame, panel);
  else
    draw(svg, frame, panel);
}

std::vector<Panel> panels_of_items(const study::RunFacts& facts, const Response& response,
                                   const study::UnitSystem& units) {
  const study::ReportUnit length = units.of("m"), angle = units.of("rad");
  return {item_panel(
              "Horizontal distance from the start", with_unit("Distance", length), facts, response,
              [&](const Sample& s) { return s.displacement.head<2>().norm() / length.in_si; }),
          item_panel("Tilt", with_unit("Angle", angle), facts, response,
                     [&](const Sample& s) { return s.tilt / angle.in_si; })};
}

}  // namespace

std::string run_figure(const study::RunFacts& facts, const Response& response,
                       const study::UnitSystem& chosen) {
  const study::UnitSystem units = chosen.or_else("m");
  const std::vector<Sample>& history = response.items[0].history;
  if (history.empty()) {
    Svg svg(kWidth, 120);
    draw_heading(svg, facts, response);
    svg.text(kLeft, 90, "No history was kept, so there is nothing to draw.");
    return svg.str();
  }
  const std::vector<Panel> panels = response.items.size() == 1
                                        ? panels_of_item(facts, response.items[0], units)
                                        : panels_of_items(facts, response, units);
  const int count = static_cast<int>(panels.size());
  if (response.items.size() == 1 && facts.scene.room.empty()) {
    // The plan takes the left half of two rows.
    const int rows = 2 + (count - 1) / 2;
    Svg svg(kWidth, kTop + rows * kRow - 25);
    draw_heading(svg, facts, response);
    draw_plan(svg, frame_at(0, 0, kTop, 2), facts.scene, response, chosen);
    for (int i = 0; i < count; ++i)
      draw_panel(svg, i < 2 ? frame_at(1, i) : frame_at(i % 2, 1 + i / 2),
                 panels[static_cast<std::size_t>(i)]);
    return svg.str();
  }
  const double height =
      std::clamp(kPlanWidth * plan_aspect(facts.scene, response), kPlanWidth / 3, kPlanWidth);
  const double top = kTop + height + 75;
  const int rows = (count + 1) / 2;
  Svg svg(kWidth, top + rows * kRow - 25);
  draw_heading(svg, facts, response);
  draw_plan(svg, {kLeft, kTop, kPlanWidth, height}, facts.scene, response, chosen);
  for (int i = 0; i < count; ++i)
    draw_panel(svg, frame_at(i % 2, i / 2, top), panels[static_cast<std::size_t>(i)]);
  return svg.str();
}

}  // namespace gurney::figures
