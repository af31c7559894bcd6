#include "studies/figures/scene_figure.h"

#include <algorithm>
#include <cmath>

#include "studies/explanation/footprint.h"
#include "studies/figures/labels.h"
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
  for (const Vector2& point : points) {
    curve.x.push_back(point.x());
    curve.y.push_back(point.y());
  }
  return curve;
}

Curve outline(explanation::Polygon polygon, const std::string& label, const Pen& pen) {
  if (!polygon.empty()) polygon.push_back(polygon.front());
  return line(polygon, label, pen);
}

/// A line of the item's own plane, placed on the floor.
Curve placed(const PlacedItem& item, const Vector2& from, const Vector2& to, const Pen& pen) {
  const Eigen::Rotation2Dd turn(item.initial.yaw);
  const Vector2 origin = item.initial.position.head<2>();
  return line({origin + turn * from, origin + turn * to}, "", pen);
}

void add_item(Panel& panel, const PlacedItem& item, std::string name, const std::string& color) {
  double front = 0;
  for (const BodyShape& box : item.model.shape)
    front = std::max(front, box.center.x() + box.size.x() / 2);
  for (const explanation::Polygon& part : explanation::footprint(item, at_start(item))) {
    panel.curves.push_back(outline(part, name, {.stroke = color, .width = 1.3}));
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

}  // namespace

double aspect_of_plan(const Panel& panel) {
  Vector2 low = Vector2::Constant(1e300), high = -low;
  const auto include = [&](const std::vector<double>& x, const std::vector<double>& y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      low = low.cwiseMin(Vector2(x[i], y[i]));
      high = high.cwiseMax(Vector2(x[i], y[i]));
    }
  };
  for (const Curve& curve : panel.curves) include(curve.x, curve.y);
  for (const Marks& marks : panel.marks) include(marks.x, marks.y);
  const Vector2 size = high - low;
  return size.x() > 0 ? std::clamp(size.y() / size.x(), 0.35, 0.8) : 0.8;
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
  Panel panel{.title = "",
              .x_label = "x",
              .y_label = "y",
              .zero_line = false,
              .equal_scales = true,
              .legend_columns = 4};
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
    panel.curves.push_back(line({tether.anchor.head<2>(), point}, label,
                                {.stroke = "#117733", .width = 1.2, .dash = "2 2"}));
    label.clear();
  }
  const std::vector<std::string> names = study::item_names(scene);
  for (std::size_t i = 0; i < names.size(); ++i)
    add_item(panel, scene.items[i], names[i], palette(i));
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

}  // namespace gurney::figures
