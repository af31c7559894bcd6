#include "studies/figures/plan_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/polygon.h"
#include "engine/base/units.h"
#include "studies/explanation/footprint.h"
#include "studies/figures/labels.h"
#include "studies/playback/recorded_run.h"
#include "studies/results/hdf5_reader.h"
#include "studies/results/names.h"

namespace gurney::figures {
namespace {

Sample at_start(const PlacedItem& item) {
  Sample sample;
  sample.orientation = Eigen::AngleAxisd(item.initial.yaw, Vector3::UnitZ());
  return sample;
}

Curve line(const std::vector<Vector2>& points, const std::string& label, const Pen& pen) {
  Curve curve{label, {}, {}, pen};
  for (const Vector2& point : points) curve.add(point.x(), point.y());
  return curve;
}

Curve outline(Polygon polygon, const std::string& label, const Pen& pen) {
  if (!polygon.empty()) polygon.push_back(polygon.front());
  return line(polygon, label, pen);
}

/// A line of the item's own plane, placed on the floor.
Curve placed(const PlacedItem& item, const Vector2& from, const Vector2& to, const Pen& pen) {
  const Eigen::Rotation2Dd turn(item.initial.yaw);
  const Vector2 origin = item.initial.position.head<2>();
  return line({origin + turn * from, origin + turn * to}, "", pen);
}

void add_item(Panel& panel, const PlacedItem& item, std::string name, std::size_t index) {
  const std::string color = palette(index), dash = dash_of(index);
  double front = 0;
  for (const BodyShape& box : item.model.shape)
    front = std::max(front, box.center.x() + box.size.x() / 2);
  for (const Polygon& part : explanation::footprint(item, at_start(item))) {
    panel.curves.push_back(outline(part, name, {.stroke = color, .width = 1.3, .dash = dash}));
    name.clear();
  }
  panel.curves.push_back(placed(item, Vector2::Zero(), {front, 0}, {.stroke = color, .width = 1}));
  const Curve& arrow = panel.curves.back();
  panel.marks.push_back(
      {"", {arrow.x[1]}, {arrow.y[1]}, {.stroke = color, .fill = color}, Marker::kCircle, 2.5});
  for (const Caster& caster : item.model.casters) {
    const Vector2 forward(std::cos(caster.heading), std::sin(caster.heading));
    const Vector2 mount = caster.mount.head<2>(), wheel = mount - caster.trail * forward;
    panel.curves.push_back(placed(item, mount, wheel, {.stroke = "#444444", .width = 1}));
    panel.curves.push_back(placed(item, wheel - caster.wheel_radius * forward,
                                  wheel + caster.wheel_radius * forward,
                                  {.stroke = "#444444", .width = 3.5}));
  }
}

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
        if (impact.item == names[item] && classes.of(impact.speed / speed_unit.in_si) == speed)
          marks.add(impact.x, impact.y);
      if (!marks.x.empty()) panel.marks.push_back(std::move(marks));
    }
  }
  set_unit(panel, units);
  return {.panel = panel, .aspect = aspect_of_plan(panel)};
}

const std::string kWall = "#888888", kStart = "#777777", kImpact = "#c00000";

/// Whether the origin is still a point of the item's base.
bool stands(const Quaternion& orientation) {
  constexpr double kStanding = 30 * kRadiansPerDegree;  // of tilt
  return (orientation * Vector3::UnitZ()).z() > std::cos(kStanding);
}

/// The outline of an item, with a line from its middle to its front while it stands.
void add_item(Panel& panel, const playback::RecordedItem& item, std::size_t sample, const Pen& pen,
              std::string label) {
  const auto placed = [&](const Vector3& point) -> Vector2 {
    return (item.position[sample] + item.orientation[sample] * point).head<2>();
  };
  double front = 0;
  for (const playback::RecordedShape& box : item.boxes) {
    std::vector<Vector2> points;
    for (const Vector3& point : box.points) {
      front = std::max(front, point.x());
      points.push_back(placed(point));
    }
    panel.curves.push_back(outline(convex_polygon(points), label, pen));
    label.clear();
  }
  if (!stands(item.orientation[sample])) return;
  const Vector2 tip = placed({front, 0, 0});
  panel.curves.push_back(line({placed(Vector3::Zero()), tip}, "", pen));
  panel.marks.push_back(
      {"", {tip.x()}, {tip.y()}, {.stroke = pen.stroke, .fill = pen.stroke}, Marker::kCircle, 2});
}

Panel empty_plan(const std::string& title, const std::string& x, const std::string& y) {
  return {.title = title,
          .x_label = x,
          .y_label = y,
          .zero_line = false,
          .equal_scales = true,
          .legend_columns = 4};
}

Panel plan_of_run(const study::Hdf5Reader& file) {
  const playback::RecordedRun run = playback::read_recorded_run(file.path());
  Panel panel = empty_plan("Seen from above", "x", "y");
  for (const playback::RecordedShape& shape : run.room) {
    std::vector<Vector2> points;
    for (const Vector3& point : shape.points) points.push_back(point.head<2>());
    panel.curves.push_back(outline(convex_polygon(points), "", {.stroke = kWall, .width = 0.8}));
  }
  for (std::size_t i = 0; i < run.items.size(); ++i) {
    const playback::RecordedItem& item = run.items[i];
    add_item(panel, item, 0, {.stroke = kStart, .width = 1}, i == 0 ? "at the start" : "");
    std::vector<Vector2> path;
    for (std::size_t k = 0; k < item.position.size(); ++k)
      path.push_back(stands(item.orientation[k]) ? Vector2(item.position[k].head<2>())
                                                 : Vector2::Constant(std::nan("")));
    panel.curves.push_back(line(path, "", pen(i, 1.8)));
    add_item(panel, item, run.time.size() - 1, pen(i, 1), item.name);
  }
  Marks impacts{"impact",
                file.numbers("/events/point_x"),
                file.numbers("/events/point_y"),
                {.stroke = kImpact, .width = 1.4},
                Marker::kCross,
                3.5};
  if (!impacts.x.empty()) panel.marks.push_back(std::move(impacts));
  return panel;
}

Panel paths_of_study(const study::StoredHistories& histories) {
  Panel panel = empty_plan("", "x from the start", "y from the start");
  std::vector<std::string> items;
  for (const std::size_t run : histories.runs()) {
    const study::StoredHistory history = histories.history("displacement", run);
    for (std::size_t i = 0; i + 1 < history.series.size(); ++i) {
      const auto &x = history.series[i], &y = history.series[i + 1];
      if (x.axis != "x" || y.axis != "y") continue;
      const auto known = std::ranges::find(items, x.part);
      const auto index = static_cast<std::size_t>(known - items.begin());
      if (known == items.end()) items.push_back(x.part);
      panel.curves.push_back({known == items.end() ? x.part : "",
                              x.values,
                              y.values,
                              {.stroke = palette(index), .width = 0.7, .opacity = 0.6}});
      panel.marks.push_back({"",
                             {x.values.back()},
                             {y.values.back()},
                             {.stroke = palette(index), .width = 0.8},
                             marker(index),
                             2});
    }
  }
  return panel;
}

}  // namespace
double aspect_of_plan(const Panel& panel, double most) {
  Vector2 low = Vector2::Constant(1e300), high = -low;
  const auto include = [&](const std::vector<double>& x, const std::vector<double>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!std::isfinite(x[i] + y[i])) continue;
      low = low.cwiseMin(Vector2(x[i], y[i]));
      high = high.cwiseMax(Vector2(x[i], y[i]));
    }
  };
  for (const Curve& curve : panel.curves) include(curve.x, curve.y);
  for (const Marks& marks : panel.marks) include(marks.x, marks.y);
  const Vector2 size = high - low;
  return size.x() > 0 ? std::clamp(size.y() / size.x(), 0.35, most) : most;
}

void set_unit(Panel& plan, const study::UnitSystem& units) {
  const study::ReportUnit unit = units.of("m");
  plan.x_label = with_unit(plan.x_label, unit);
  plan.y_label = with_unit(plan.y_label, unit);
  const auto scale = [&](std::vector<double>& values) {
    for (double& value : values) value /= unit.in_si;
  };
  for (Range* range : {&plan.x_range, &plan.y_range})
    *range = {range->low / unit.in_si, range->high / unit.in_si};
  for (Curve& curve : plan.curves) scale(curve.x), scale(curve.y);
  for (Marks& marks : plan.marks) scale(marks.x), scale(marks.y);
}

Panel scene_panel(const Scene& scene) {
  Panel panel = empty_plan("", "x", "y");
  for (const RoomShape& shape : scene.room)
    panel.curves.push_back(
        outline(explanation::footprint(shape), "", {.stroke = "#888888", .width = 1.2}));
  std::string label = "zone";
  for (const Zone& zone : scene.zones) {
    panel.curves.push_back(outline(explanation::footprint(zone), label,
                                   {.stroke = "#56B4E9", .width = 1.2, .dash = "6 3"}));
    label.clear();
  }
  label = "tether";
  for (const Tether& tether : scene.tethers) {
    const PlacedItem& item = scene.items.at(tether.item);
    const Vector2 point =
        (item.initial.position + at_start(item).orientation * tether.point).head<2>();
    panel.curves.push_back(line({placed_anchor(scene, tether).head<2>(), point}, label,
                                {.stroke = "#117733", .width = 1.2, .dash = "2 2"}));
    label.clear();
  }
  const std::vector<std::string> names = study::item_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i) add_item(panel, scene.items[i], names[i], i);
  return panel;
}

std::string scene_figure(const PlotPage& page, const std::string& title, const Scene& scene) {
  Panel panel = scene_panel(scene);
  set_unit(panel, page.units);
  return Chart{title,
               "seen from above, before the motion; grey: room; dots: fronts of the items; "
               "thick lines: wheels",
               {{.panel = panel, .aspect = aspect_of_plan(panel)}}}
      .svg(page);
}

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

std::string trajectory_figure(const PlotPage& page, const std::string& path) {
  const study::StoredHistories histories(path);
  const std::vector<std::size_t> runs = histories.runs();
  require(!runs.empty(), path + ": holds no histories, so it knows no paths");
  const study::Hdf5Reader file(path);
  const bool study = file.text_attribute("filetype") == "gurney-study";
  Panel panel = study ? paths_of_study(histories) : plan_of_run(file);
  set_unit(panel, page.units);
  const std::string note =
      study ? fmt::format(
                  "paths of the items' origins in {} runs, each from its start; marked: the "
                  "end",
                  runs.size())
            : "line: path of the item's origin while it stands; outlines at the start and at "
              "the end, the dot at the front";
  return Chart{histories.title(), note, {{.panel = panel, .aspect = aspect_of_plan(panel, 1)}}}.svg(
      page);
}

}  // namespace gurney::figures
