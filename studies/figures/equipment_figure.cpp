#include "studies/figures/equipment_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/polygon.h"
#include "engine/base/units.h"
#include "equipment/catalogue/support.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kPanel = 330, kLeft = 70, kTop = 95, kGap = 75;

/// A view of the item along an axis: item axis `across` to the right, `up` upwards.
struct View {
  const char* title;
  int across, up;
};

constexpr View kPlan = {"Plan", 0, 1}, kSide = {"From the right", 0, 2},
               kFront = {"From the front", 1, 2};

const std::string kChassis = palette(0), kEdge = palette(1), kWorst = palette(2),
                  kPart = palette(3), kContent = palette(4);

/// Half of what the plan shows.
double plan_half_width(const report::EquipmentFacts& facts) {
  double reach = 0;
  for (const BodyShape& shape : facts.model.shape)
    reach = std::max(reach, (shape.center.cwiseAbs() + shape.size / 2).head<2>().maxCoeff());
  for (const Caster& caster : facts.model.casters)
    reach = std::max(
        reach, caster.mount.head<2>().cwiseAbs().maxCoeff() + caster.trail + caster.wheel_radius);
  return 1.1 * reach;
}

/// Scale of both side views, so that a millimetre is as long in each.
double side_half_width(const report::EquipmentFacts& facts) {
  double height = facts.sheet.size.z();
  for (const equipment::LoadedContent& content : facts.contents)
    for (const BodyShape& shape : content.model.shape)
      height = std::max(height, content.position.z() + shape.top());
  return std::max(plan_half_width(facts), 1.1 * 0.55 * height);
}

class ViewDrawing {
 public:
  ViewDrawing(Svg& svg, const Frame& frame, const View& view, double half)
      : svg_(svg), view_(view), scaling_(frame, {-half, half}, ranges(view, half)) {
    Panel panel{.title = view.title,
                .x_label = view.across == 0 ? "x, forward (m)" : "y, left (m)",
                .y_label = view.up == 1 ? "y, left (m)" : "z (m)",
                .zero_line = false,
                .x_range = {-half, half},
                .y_range = ranges(view, half)};
    scaling_ = draw(svg, frame, panel);
  }

  /// Shapes that are turned about z and moved.
  void shapes(const std::vector<BodyShape>& shapes, const std::string& color, double yaw = 0,
              const Vector3& position = Vector3::Zero()) {
    const Eigen::AngleAxisd turn(yaw, Vector3::UnitZ());
    for (const BodyShape& shape : shapes) {
      std::vector<Vector2> seen;
      for (const Vector3& point : outline_points(shape)) {
        const Vector3 there = position + turn * point;
        seen.emplace_back(there[view_.across], there[view_.up]);
      }
      polygon(convex_polygon(std::move(seen)),
              {.stroke = color, .width = 1.2, .fill = color, .opacity = 0.15});
    }
  }

  /// Chassis, parts and contents.
  void bodies(const report::EquipmentFacts& facts) {
    std::vector<BodyShape> chassis = facts.model.shape;
    for (const equipment::LoadedPart& part : facts.parts)
      chassis.resize(chassis.size() - part.model.shape.size());
    shapes(chassis, kChassis);
    for (const equipment::LoadedPart& part : facts.parts) shapes(part.model.shape, kPart);
    for (const equipment::LoadedContent& content : facts.contents)
      shapes(content.model.shape, kContent, content.yaw, content.position);
  }

  void polygon(const std::vector<Vector2>& corners, const Pen& pen) {
    Svg::Points points;
    for (const Vector2& c : corners) points.emplace_back(scaling_.x(c.x()), scaling_.y(c.y()));
    svg_.polyline(points, pen, true);
  }

  void line(const Vector2& from, const Vector2& to, const Pen& pen) {
    svg_.line(scaling_.x(from.x()), scaling_.y(from.y()), scaling_.x(to.x()), scaling_.y(to.y()),
              pen);
  }

  void circle(const Vector2& center, double radius, const Pen& pen) {
    svg_.circle(scaling_.x(center.x()), scaling_.y(center.y()), scaling_.x(radius) - scaling_.x(0),
                pen);
  }

  /// From the side; a wheel seen more from its edge is a rectangle.
  /// @param along  share of its rolling direction that lies in the view
  void wheel(double middle, const Caster& caster, double along) {
    const Pen pen{.stroke = "#444444", .width = 1.2, .fill = "#dddddd"};
    const double radius = caster.wheel_radius;
    if (along > 0.7) return circle({middle, radius}, radius, pen);
    const double half =
        radius * along + caster.wheel_width / 2 * std::sqrt(std::max(0.0, 1 - along * along));
    polygon({{middle - half, 0},
             {middle + half, 0},
             {middle + half, 2 * radius},
             {middle - half, 2 * radius}},
            pen);
  }

  void center_of_mass(const Vector3& center) {
    const double x = scaling_.x(center[view_.across]), y = scaling_.y(center[view_.up]);
    svg_.circle(x, y, 5, {.stroke = "#000000", .width = 1.2, .fill = "#ffffff"});
    svg_.line(x - 8, y, x + 8, y, {.stroke = "#000000"});
    svg_.line(x, y - 8, x, y + 8, {.stroke = "#000000"});
  }

 private:
  static Range ranges(const View& view, double half) {
    if (view.up == 1) return {-half, half};
    return {-0.12 * half, 1.88 * half};
  }

  Svg& svg_;
  View view_;
  Scaling scaling_;
};

void draw_plan_view(Svg& svg, const Frame& frame, const report::EquipmentFacts& facts,
                    double half) {
  ViewDrawing view(svg, frame, kPlan, half);
  view.bodies(facts);
  for (const Caster& caster : facts.model.casters) {
    const Vector2 mount = caster.mount.head<2>();
    const Vector2 forward(std::cos(caster.heading), std::sin(caster.heading));
    const Vector2 wheel = mount - caster.trail * forward;
    if (caster.swivels)
      view.circle(mount, caster.trail, {.stroke = "#888888", .width = 0.8, .dash = "2 2"});
    view.line(mount, wheel, {.stroke = "#444444"});
    view.line(wheel - caster.wheel_radius * forward, wheel + caster.wheel_radius * forward,
              {.stroke = "#444444", .width = 3.5});
  }
  view.polygon(facts.sheet.support_polygon, {.stroke = kEdge, .width = 1.6});
  const Vector3& center = facts.sheet.whole.center_of_mass;
  const double direction = facts.sheet.stability.direction;
  const Vector2 n(std::cos(direction), std::sin(direction));
  view.line(center.head<2>(), center.head<2>() + facts.sheet.stability.base * n,
            {.stroke = kWorst, .width = 2});
  view.center_of_mass(center);
}

/// With the line from the centre of mass to the edge, as placed, on both sides.
void draw_side_view(Svg& svg, const Frame& frame, const View& seen,
                    const report::EquipmentFacts& facts, double half) {
  ViewDrawing view(svg, frame, seen, half);
  view.line({-half, 0}, {half, 0}, {.stroke = "#444444", .width = 1.5});
  view.bodies(facts);
  for (const Caster& caster : facts.model.casters) {
    const Vector3 forward(std::cos(caster.heading), std::sin(caster.heading), 0);
    const Vector3 wheel = caster.mount - caster.trail * forward;
    view.line({caster.mount[seen.across], caster.mount.z()},
              {wheel[seen.across], caster.wheel_radius}, {.stroke = "#444444"});
    view.wheel(wheel[seen.across], caster, std::abs(forward[seen.across]));
  }
  const Vector3& center = facts.sheet.whole.center_of_mass;
  const auto supports = equipment::supports_of(facts.model, equipment::Swivels::kAsPlaced);
  const double forward = seen.across == 0 ? 0 : 90 * kRadiansPerDegree;
  for (const double side : {1.0, -1.0}) {
    const double reach = equipment::reach_towards(
        supports, center.head<2>(), forward + (side > 0 ? 0 : 180 * kRadiansPerDegree));
    view.line({center[seen.across], center.z()}, {center[seen.across] + side * reach, 0},
              {.stroke = kEdge, .width = 1.2, .dash = "4 3"});
  }
  view.center_of_mass(center);
}

}  // namespace

std::string equipment_figure(const report::EquipmentFacts& facts) {
  const equipment::ItemSheet& sheet = facts.sheet;
  const std::string of_others = std::string(facts.parts.empty() ? "" : " Pink: parts.") +
                                (facts.contents.empty() ? "" : " Yellow: contents.");
  const bool rolls = !facts.model.casters.empty();
  Svg svg(kLeft + 3 * kPanel + 2 * kGap + 25, kTop + kPanel + 85);
  svg.text(kLeft, 34, facts.model.name, {.size = 17, .bold = true});
  svg.text(kLeft, 55,
           fmt::format("{:.1f} kg; {:.0f} x {:.0f} x {:.0f} mm; centre of mass {:.0f} mm above the "
                       "floor; overturns at a tilt of {:.1f} deg",
                       sheet.whole.mass, sheet.size.x() * kMillimetersPerMeter,
                       sheet.size.y() * kMillimetersPerMeter, sheet.size.z() * kMillimetersPerMeter,
                       sheet.whole.center_of_mass.z() * kMillimetersPerMeter,
                       sheet.stability.tilt_as_placed / kRadiansPerDegree) +
               (rolls ? fmt::format(" as placed, {:.1f} deg at worst",
                                    sheet.stability.tilt / kRadiansPerDegree)
                      : std::string()),
           {.size = 12, .color = "#555555"});
  const double half = side_half_width(facts), step = kPanel + kGap;
  draw_plan_view(svg, {kLeft, kTop, kPanel, kPanel}, facts, plan_half_width(facts));
  draw_side_view(svg, {kLeft + step, kTop, kPanel, kPanel}, kSide, facts, half);
  draw_side_view(svg, {kLeft + 2 * step, kTop, kPanel, kPanel}, kFront, facts, half);
  svg.text(kLeft, kTop + kPanel + 62,
           rolls ? "Plan: wheels as placed, circles of free swivels, support as placed (orange), "
                   "the shortest distance to an edge with swivels at their worst (green)."
                 : "Plan: support (orange), the shortest distance to an edge (green).",
           {.size = 11, .color = "#555555"});
  svg.text(kLeft, kTop + kPanel + 77,
           "Sides: dashed lines from the centre of mass to the ends of the support; cross: centre "
           "of mass." +
               of_others,
           {.size = 11, .color = "#555555"});
  return svg.str();
}

}  // namespace gurney::figures
