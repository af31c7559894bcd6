#include "studies/figures/plan_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/explanation/footprint.h"
#include "studies/figures/scene_figure.h"
#include "studies/results/names.h"

namespace gurney::figures {
namespace {

constexpr double kStanding = 30 * kRadiansPerDegree;  // of tilt; casters are drawn below
constexpr double kLow = 0.05;      // a room shape that reaches no higher may be rolled over [m]
constexpr double kOverhead = 1.8;  // a room shape above that stands in nobody's way [m]
const std::string kStartColor = "#777777", kImpactColor = "#c00000";

Vector2 at(const PlacedItem& item, const Sample& sample, const Vector3& point) {
  const Vector3 start(item.initial.position.x(), item.initial.position.y(), 0);
  return (start + sample.displacement + sample.orientation * point).head<2>();
}

/// The wheel of a caster from above: its middle and its ends along the rolling direction.
struct WheelPlan {
  Vector2 mount, middle, back, front;
};

WheelPlan wheel_plan(const PlacedItem& item, std::size_t wheel, const Sample& sample) {
  const Caster& caster = item.model.casters[wheel];
  const double angle = sample.wheels[wheel].swivel_angle;
  const Vector3 forward(std::cos(angle), std::sin(angle), 0);
  const Vector3 middle = caster.mount - caster.trail * forward;
  return {at(item, sample, caster.mount), at(item, sample, middle),
          at(item, sample, middle - caster.wheel_radius * forward),
          at(item, sample, middle + caster.wheel_radius * forward)};
}

double top_of(const RoomShape& shape) {
  if (const auto* box = std::get_if<RoomBox>(&shape.shape))
    return shape.position.z() + 0.5 * box->size.z();
  return 2 * kLow;
}

/// A lintel, say.
bool is_overhead(const RoomShape& shape) {
  const auto* box = std::get_if<RoomBox>(&shape.shape);
  return box != nullptr && shape.position.z() - 0.5 * box->size.z() > kOverhead;
}

/// Above the middle of a polygon, at its edge.
Vector2 top_of(const explanation::Polygon& polygon) {
  Vector2 middle = Vector2::Zero();
  double top = -1e9;
  for (const Vector2& p : polygon) {
    middle += p / static_cast<double>(polygon.size());
    top = std::max(top, p.y());
  }
  return {middle.x(), top};
}

/// Draws in metres.
class Plan {
 public:
  Plan(Svg& svg, const Scaling& scaling) : svg_(svg), scaling_(scaling) {}

  std::pair<double, double> px(const Vector2& p) const {
    return {scaling_.x(p.x()), scaling_.y(p.y())};
  }
  void line(const Vector2& a, const Vector2& b, const Pen& pen) {
    svg_.line(px(a).first, px(a).second, px(b).first, px(b).second, pen);
  }
  void area(const explanation::Polygon& polygon, const Pen& pen, double fill_opacity) {
    Svg::Points points;
    for (const Vector2& p : polygon) points.push_back(px(p));
    if (!pen.fill.empty())
      svg_.polyline(points, {.stroke = "", .fill = pen.fill, .opacity = fill_opacity}, true);
    Pen outline = pen;
    outline.fill.clear();
    svg_.polyline(points, outline, true);
  }
  void dot(const Vector2& p, double radius, const Pen& pen) {
    svg_.circle(px(p).first, px(p).second, radius, pen);
  }
  void text(const Vector2& p, double down, const std::string& text, const TextStyle& style) {
    svg_.text(px(p).first, px(p).second + down, text, style);
  }
  /// A small triangle whose tip is at `tip`.
  void arrow(const Vector2& tip, const Vector2& ahead, const std::string& color) {
    constexpr double kLength = 12, kHalfWidth = 3.5;
    const auto [x, y] = px(tip);
    const double dx = ahead.x(), dy = -ahead.y();  // y of a picture points down
    const double back_x = x - kLength * dx, back_y = y - kLength * dy;
    svg_.polyline({{x, y},
                   {back_x - kHalfWidth * dy, back_y + kHalfWidth * dx},
                   {back_x + kHalfWidth * dy, back_y - kHalfWidth * dx}},
                  {.stroke = "", .fill = color}, true);
  }
  void cross(const Vector2& p) {
    constexpr double kArm = 4;
    const auto [x, y] = px(p);
    svg_.line(x - kArm, y - kArm, x + kArm, y + kArm, {.stroke = kImpactColor, .width = 1.6});
    svg_.line(x - kArm, y + kArm, x + kArm, y - kArm, {.stroke = kImpactColor, .width = 1.6});
  }

 private:
  Svg& svg_;
  const Scaling& scaling_;
};

void draw_room(Plan& plan, const Scene& scene, const Response& response) {
  for (std::size_t i = 0; i < scene.zones.size(); ++i) {
    const bool taken = i < response.zones.size() && response.zones[i].occupied_at_end;
    const std::string color = taken ? "#e69f00" : "#56b4e9";
    plan.area(explanation::footprint(scene.zones[i]),
              {.stroke = color, .dash = "6 3", .fill = color}, taken ? 0.3 : 0.15);
  }
  for (const RoomShape& shape : scene.room) {
    const bool low = top_of(shape) <= kLow, overhead = is_overhead(shape);
    plan.area(explanation::footprint(shape),
              {.stroke = "#888888",
               .width = 0.8,
               .dash = overhead ? "2 3" : "",
               .fill = low ? "#eadfc8" : "#c4c4c4"},
              overhead ? 0.0 : 1.0);
  }
}

void draw_tethers(Plan& plan, const Scene& scene, const Response& response) {
  for (std::size_t i = 0; i < scene.tethers.size(); ++i) {
    const Tether& tether = scene.tethers[i];
    const TetherOutcome outcome =
        i < response.tethers.size() ? response.tethers[i] : TetherOutcome();
    const std::vector<Sample>& history = response.items.at(tether.item).history;
    const bool broke = outcome.time_broken >= 0;
    const Pen pen{
        .stroke = broke ? kImpactColor : "#117733", .width = 1.2, .dash = broke ? "2 3" : ""};
    const Vector2 anchor = tether.anchor.head<2>();
    plan.line(anchor,
              at(scene.items[tether.item],
                 broke ? history.front() : explanation::last_finite(history), tether.point),
              pen);
    plan.dot(anchor, 3, {.stroke = pen.stroke, .width = 1.2, .fill = "#ffffff"});
  }
}

/// The front of an item is where its x axis points to.
void mark_front(Plan& plan, const PlacedItem& item, const Sample& sample,
                const std::string& color) {
  const Vector2 origin = at(item, sample, Vector3::Zero());
  const Vector2 ahead = (at(item, sample, Vector3::UnitX()) - origin).normalized();
  double reach = 0;
  for (const explanation::Polygon& part : explanation::footprint(item, sample))
    for (const Vector2& p : part) reach = std::max(reach, (p - origin).dot(ahead));
  plan.arrow(origin + reach * ahead, ahead, color);
}

void draw_item(Plan& plan, const PlacedItem& item, const Sample& sample, const Pen& outline,
               double fill_opacity) {
  for (const explanation::Polygon& part : explanation::footprint(item, sample))
    plan.area(part, outline, fill_opacity);
  if (!(sample.tilt < kStanding)) return;
  const std::string& color = outline.stroke;
  mark_front(plan, item, sample, color);
  for (std::size_t i = 0; i < item.model.casters.size(); ++i) {
    const WheelPlan wheel = wheel_plan(item, i, sample);
    plan.line(wheel.mount, wheel.middle, {.stroke = color, .width = 1});
    plan.line(wheel.back, wheel.front, {.stroke = color, .width = 3.5});
    plan.dot(wheel.mount, 2.2, {.stroke = color, .width = 1, .fill = "#ffffff"});
  }
}

Curve path_of(const PlacedItem& item, const std::vector<Sample>& history, const Pen& pen) {
  Curve path{"path", {}, {}, pen};
  for (const Sample& sample : history) {
    const Vector2 origin = at(item, sample, Vector3::Zero());
    path.x.push_back(origin.x());
    path.y.push_back(origin.y());
  }
  return path;
}

/// Middle of the boxes of an item.
Vector2 middle_of(const PlacedItem& item, const Sample& sample) {
  Vector2 low = Vector2::Constant(1e9), high = -low;
  for (const explanation::Polygon& part : explanation::footprint(item, sample))
    for (const Vector2& p : part) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return 0.5 * (low + high);
}

/// Numbers in the plan, names beside it.
void draw_legend(Svg& svg, Plan& plan, const Frame& frame, const Scene& scene,
                 const Response& response, const study::UnitSystem& units) {
  const std::vector<std::string> names = study::item_names(scene);
  const study::UnitSystem lengths = units.or_else("g-mm");
  const double x = frame.x + frame.width + 22;
  double y = frame.y + 6;
  for (std::size_t i = 0; i < names.size(); ++i, y += 19) {
    const Demands& d = response.items[i].demands;
    const std::string number = std::to_string(i + 1);
    const Vector2 middle =
        middle_of(scene.items[i], explanation::last_finite(response.items[i].history));
    const Pen badge{.stroke = palette(i), .width = 1.2, .fill = "#ffffff"};
    const TextStyle style{.size = 10, .anchor = Anchor::kMiddle, .bold = true};
    plan.dot(middle, 8, badge);
    plan.text(middle, 3.5, number, style);
    svg.circle(x, y, 8, badge);
    svg.text(x, y + 3.5, number, style);
    svg.text(x + 14, y + 4,
             names[i] + (d.time_of_overturning >= 0
                             ? ", overturned"
                             : ", " + lengths.fixed(d.residual_displacement, "m", 3)),
             {.size = 11});
  }
  const auto note = [&](const std::string& text, const char* color) {
    svg.text(x - 6, y + 10, text, {.size = 10, .color = color});
    y += 15;
  };
  note(lengths.of("m").name + ": from the start, at the end", "#555555");
  note("grey outline: at the start", "#555555");
  if (!response.impacts.empty()) note("\u00d7 point of impact", "#c00000");
  if (!scene.zones.empty()) note("dashed: zones; orange: not free", "#a06a00");
  if (!scene.tethers.empty()) note("green: tethers; red dots: broken", "#117733");
}

/// @param scaling  of values in the unit
void draw_scale_bar(Svg& svg, const Frame& frame, const Scaling& scaling,
                    const study::ReportUnit& unit) {
  const double ten = std::pow(10, std::floor(-std::log10(unit.in_si)));  // 10 in, 100 cm, 1 m
  double length = 0.1 * ten;
  for (const double longer : {0.2 * ten, 0.5 * ten, ten, 2 * ten, 5 * ten})
    if (scaling.x(longer) - scaling.x(0) < frame.width / 4) length = longer;
  const double px = scaling.x(length) - scaling.x(0);
  const double right = frame.x + frame.width - 12, y = frame.y + frame.height - 10;
  svg.rectangle(right - px - 6, y - 18, px + 12, 24,
                {.stroke = "", .fill = "#ffffff", .opacity = 0.8});
  svg.line(right - px, y, right, y, {.width = 3});
  svg.text(right - px / 2, y - 6, fmt::format("{:g} {}", length, unit.name),
           {.size = 10, .anchor = Anchor::kMiddle});
}

void include(Panel& panel, const Vector2& point) {
  panel.x_range = {std::min(panel.x_range.low, point.x()), std::max(panel.x_range.high, point.x())};
  panel.y_range = {std::min(panel.y_range.low, point.y()), std::max(panel.y_range.high, point.y())};
}

/// Everything that is drawn, with some air around it.
Panel fitted_panel(const Scene& scene, const Response& response) {
  const Vector2 first = scene.items.front().initial.position.head<2>();
  Panel panel{.title = "Seen from above",
              .x_label = "x",
              .y_label = "y",
              .curves = {},
              .zero_line = false,
              .equal_scales = true};
  panel.x_range = {first.x(), first.x()};
  panel.y_range = {first.y(), first.y()};
  const auto include_all = [&](const explanation::Polygon& polygon) {
    for (const Vector2& p : polygon) include(panel, p);
  };
  for (const RoomShape& shape : scene.room) include_all(explanation::footprint(shape));
  for (const Zone& zone : scene.zones) include_all(explanation::footprint(zone));
  for (const Tether& tether : scene.tethers) include(panel, tether.anchor.head<2>());
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const PlacedItem& item = scene.items[i];
    const std::vector<Sample>& history = response.items.at(i).history;
    for (const Sample& sample : history)
      if (sample.displacement.allFinite()) include(panel, at(item, sample, Vector3::Zero()));
    for (const Sample* sample : {&history.front(), &explanation::last_finite(history)}) {
      for (const explanation::Polygon& part : explanation::footprint(item, *sample))
        include_all(part);
      for (std::size_t w = 0; w < item.model.casters.size(); ++w) {
        const WheelPlan wheel = wheel_plan(item, w, *sample);
        include(panel, wheel.back);
        include(panel, wheel.front);
      }
    }
  }
  const double air = 0.05 * std::max({panel.x_range.span(), panel.y_range.span(), 0.1});
  include(panel, {panel.x_range.low - air, panel.y_range.low - air});
  include(panel, {panel.x_range.high + air, panel.y_range.high + air});
  return panel;
}

/// A single item ends in the first colour and has its path in the second.
std::string path_color(bool alone, std::size_t item) { return palette(alone ? 1 : item); }

}  // namespace

double plan_aspect(const Panel& plan) { return plan.y_range.span() / plan.x_range.span(); }

Panel plan_panel(const Scene& scene, const Response& response, const study::UnitSystem& units) {
  const std::size_t count = scene.items.size();
  const bool alone = count == 1;
  Panel panel = fitted_panel(scene, response);
  if (alone) {
    panel.legend_columns = 3;
    panel.curves = {{"start", {}, {}, {.stroke = kStartColor, .width = 3}},
                    {"end", {}, {}, {.stroke = palette(0), .width = 3}}};
  }
  for (std::size_t i = 0; i < count; ++i)
    panel.curves.push_back(path_of(scene.items[i], response.items[i].history,
                                   {.stroke = path_color(alone, i), .width = alone ? 1.4 : 0.8}));
  set_unit(panel, units);
  return panel;
}

void draw_plan(Svg& svg, const Frame& frame, const Scaling& in_unit, const Scene& scene,
               const Response& response, const study::UnitSystem& units) {
  const std::size_t count = scene.items.size();
  const bool alone = count == 1;
  const study::ReportUnit unit = units.of("m");
  const Scaling scaling = in_unit.of_si(unit.in_si);
  Plan plan(svg, scaling);
  svg.begin_clip(frame.x, frame.y, frame.width, frame.height);
  draw_room(plan, scene, response);
  for (std::size_t i = 0; i < count; ++i)
    draw_item(plan, scene.items[i], response.items[i].history.front(),
              {.stroke = alone ? kStartColor : "#aaaaaa", .width = 1.2}, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const PlacedItem& item = scene.items[i];
    const Sample &start = response.items[i].history.front(),
                 &end = explanation::last_finite(response.items[i].history);
    const bool fell = response.items[i].demands.time_of_overturning >= 0;
    draw_item(plan, item, end,
              {.stroke = palette(i), .width = fell ? 2.4 : 1.2, .fill = palette(i)},
              alone  ? 0.08
              : fell ? 0.45
                     : 0.2);
    plan.dot(at(item, start, Vector3::Zero()), 3.5,
             {.stroke = kStartColor, .width = 1.5, .fill = "#ffffff"});
    plan.dot(at(item, end, Vector3::Zero()), 3.5, {.stroke = "", .fill = path_color(alone, i)});
  }
  draw_tethers(plan, scene, response);
  for (const Impact& impact : response.impacts) plan.cross(impact.point.head<2>());
  for (const Zone& zone : scene.zones)
    plan.text(top_of(explanation::footprint(zone)), 11, zone.name,
              {.size = 9, .anchor = Anchor::kMiddle, .color = "#225577"});
  draw_scale_bar(svg, frame, in_unit, unit);
  svg.end_group();
  if (!alone) draw_legend(svg, plan, frame, scene, response, units);
}

}  // namespace gurney::figures
