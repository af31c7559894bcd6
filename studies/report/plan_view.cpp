#include "studies/report/plan_view.h"

#include <algorithm>
#include <cmath>

namespace gurney {
namespace {

/// Where the item stands in plan.
struct Pose {
  Vector2 origin;
  double yaw;

  Vector2 of(const Vector2& point) const { return origin + Eigen::Rotation2Dd(yaw) * point; }
};

Pose pose_of(const Scene& scene, const Sample& sample) {
  return {(scene.items[0].initial.position + sample.displacement).head<2>(),
          scene.items[0].initial.yaw + sample.yaw};
}

std::vector<Vector2> corners(const Box& box, const Pose& pose) {
  const Vector2 middle = box.center.head<2>(), half = box.size.head<2>() / 2;
  std::vector<Vector2> result;
  for (const Vector2& sign : {Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)})
    result.push_back(pose.of(middle + sign.cwiseProduct(half)));
  return result;
}

/// The wheel of a caster from above: its middle and its ends along the rolling direction.
struct WheelPlan {
  Vector2 mount, middle, back, front;
};

WheelPlan wheel_plan(const Caster& caster, double swivel_angle, const Pose& pose) {
  const Vector2 forward = Eigen::Rotation2Dd(swivel_angle) * Vector2::UnitX();
  const Vector2 mount = caster.mount.head<2>(), middle = mount - caster.trail * forward;
  return {pose.of(mount), pose.of(middle), pose.of(middle - caster.wheel_radius * forward),
          pose.of(middle + caster.wheel_radius * forward)};
}

/// The last sample that can be drawn: a run that diverged may end in numbers that are none.
const Sample& last_finite(const std::vector<Sample>& history) {
  const auto finite = [](const Sample& sample) {
    return sample.displacement.allFinite() && std::isfinite(sample.yaw) &&
           std::all_of(sample.wheels.begin(), sample.wheels.end(),
                       [](const WheelSample& w) { return std::isfinite(w.swivel_angle); });
  };
  const auto found = std::find_if(history.rbegin(), history.rend(), finite);
  return found == history.rend() ? history.front() : *found;
}

void draw_item(Svg& svg, const Scaling& scaling, const Scene& scene, const Sample& sample,
               const std::string& color) {
  const Pose pose = pose_of(scene, sample);
  for (const Box& box : scene.items[0].model.shape) {
    Svg::Points outline;
    for (const Vector2& corner : corners(box, pose))
      outline.emplace_back(scaling.x(corner.x()), scaling.y(corner.y()));
    svg.polyline(outline, {.stroke = "", .fill = color, .opacity = 0.08}, true);
    svg.polyline(outline, {.stroke = color, .width = 1.2}, true);
  }
  for (std::size_t i = 0; i < scene.items[0].model.casters.size(); ++i) {
    const WheelPlan wheel =
        wheel_plan(scene.items[0].model.casters[i], sample.wheels[i].swivel_angle, pose);
    svg.line(scaling.x(wheel.mount.x()), scaling.y(wheel.mount.y()), scaling.x(wheel.middle.x()),
             scaling.y(wheel.middle.y()), {.stroke = color, .width = 1});
    svg.line(scaling.x(wheel.back.x()), scaling.y(wheel.back.y()), scaling.x(wheel.front.x()),
             scaling.y(wheel.front.y()), {.stroke = color, .width = 3.5});
    svg.circle(scaling.x(wheel.mount.x()), scaling.y(wheel.mount.y()), 2.2,
               {.stroke = color, .width = 1, .fill = "#ffffff"});
  }
}

void include(Panel& panel, const Vector2& point) {
  panel.x_range = {std::min(panel.x_range.low, point.x()), std::max(panel.x_range.high, point.x())};
  panel.y_range = {std::min(panel.y_range.low, point.y()), std::max(panel.y_range.high, point.y())};
}

/// Everything that is drawn, with some air around it.
void fit_ranges(Panel& panel, const Scene& scene, const std::vector<Sample>& history,
                const Sample& end) {
  const Pose start = pose_of(scene, history.front());
  panel.x_range = {start.origin.x(), start.origin.x()};
  panel.y_range = {start.origin.y(), start.origin.y()};
  for (const Sample& sample : history)
    if (sample.displacement.allFinite()) include(panel, pose_of(scene, sample).origin);
  for (const Sample* sample : {&history.front(), &end}) {
    const Pose pose = pose_of(scene, *sample);
    for (const Box& box : scene.items[0].model.shape)
      for (const Vector2& corner : corners(box, pose)) include(panel, corner);
    for (std::size_t i = 0; i < scene.items[0].model.casters.size(); ++i) {
      const WheelPlan wheel =
          wheel_plan(scene.items[0].model.casters[i], sample->wheels[i].swivel_angle, pose);
      include(panel, wheel.back);
      include(panel, wheel.front);
    }
  }
  const double air = 0.05 * std::max({panel.x_range.span(), panel.y_range.span(), 0.1});
  include(panel, {panel.x_range.low - air, panel.y_range.low - air});
  include(panel, {panel.x_range.high + air, panel.y_range.high + air});
}

}  // namespace

void draw_plan(Svg& svg, const Frame& frame, const Scene& scene,
               const std::vector<Sample>& history) {
  const std::string before = "#777777", after = palette(0), path_color = palette(1);
  Panel panel{.title = "Path seen from above",
              .x_label = "x (m)",
              .y_label = "y (m)",
              .curves = {},
              .zero_line = false,
              .equal_scales = true,
              .legend_columns = 3};
  const Sample& end = last_finite(history);
  fit_ranges(panel, scene, history, end);
  Curve path{"path", {}, {}, {.stroke = path_color, .width = 1.4}};
  for (const Sample& sample : history) {
    const Vector2 origin = pose_of(scene, sample).origin;
    path.x.push_back(origin.x());
    path.y.push_back(origin.y());
  }
  panel.curves = {{"start", {}, {}, {.stroke = before, .width = 3}},
                  {"end", {}, {}, {.stroke = after, .width = 3}},
                  path};
  const Scaling scaling = draw(svg, frame, panel);
  svg.begin_clip(frame.x, frame.y, frame.width, frame.height);
  draw_item(svg, scaling, scene, history.front(), before);
  draw_item(svg, scaling, scene, end, after);
  svg.circle(scaling.x(path.x.front()), scaling.y(path.y.front()), 3.5,
             {.stroke = before, .width = 1.5, .fill = "#ffffff"});
  const Vector2 finish = pose_of(scene, end).origin;
  svg.circle(scaling.x(finish.x()), scaling.y(finish.y()), 3.5, {.stroke = "", .fill = path_color});
  svg.end_clip();
}

}  // namespace gurney
