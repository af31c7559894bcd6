#include "studies/figures/run_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/polygon.h"
#include "engine/base/units.h"
#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/explanation/footprint.h"
#include "studies/figures/chart.h"
#include "studies/figures/labels.h"
#include "studies/figures/panel.h"
#include "studies/figures/plan_figures.h"
#include "studies/results/names.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {
namespace {

/// Axes of the scene from above, with all that moves on them, and the paths of the items.
Panel plan_panel(const Scene& scene, const Response& response, const study::UnitSystem& units = {});

/// Draws the scene on these axes: room shapes (low ones, such as thresholds, lighter), zones (those
/// that are occupied at the end darker), tethers, each item's boxes at the start (outline) and at
/// the end (filled, also where it lies), its front and casters while it stands, the points of
/// impact and a scale bar. Several items carry their numbers and are named at the right of the
/// frame. Every item must have a history.
/// @param in_unit  as draw() returns it
void draw_plan(Svg& svg, const Frame& frame, const Scaling& in_unit, const Scene& scene,
               const Response& response, const study::UnitSystem& units = {});

constexpr double kWidth = 1060, kHeight = 150, kPlanWidth = 740,
                 kLane = 32;                          // [px]
constexpr double kStanding = 30 * kRadiansPerDegree;  // of tilt; casters are drawn below
constexpr double kLow = 0.05;      // a room shape that reaches no higher may be rolled over [m]
constexpr double kOverhead = 1.8;  // a room shape above that stands in nobody's way [m]
const std::string kStartColor = "#777777", kImpactColor = "#c00000";

bool stands(const Sample& sample) { return sample.tilt < kStanding; }

Vector2 at(const PlacedItem& item, const Sample& sample, const Vector3& point) {
  const Vector3 start(item.initial.position.x(), item.initial.position.y(), 0);
  return (start + sample.origin_displacement() + sample.orientation * point).head<2>();
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
Vector2 top_of(const Polygon& polygon) {
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
  void area(const Polygon& polygon, const Pen& pen, double fill_opacity) {
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
    const bool broke = outcome.time_broken >= 0;
    const Pen pen{
        .stroke = broke ? kImpactColor : "#117733", .width = 1.2, .dash = broke ? "2 3" : ""};
    const auto end = [&](std::size_t item, const Vector3& point) {
      const std::vector<Sample>& history = response.items.at(item).history;
      return at(scene.items[item], broke ? history.front() : explanation::last_finite(history),
                point);
    };
    const Vector2 anchor =
        tether.anchor_item ? end(*tether.anchor_item, tether.anchor) : tether.anchor.head<2>();
    plan.line(anchor, end(tether.item, tether.point), pen);
    plan.dot(anchor, 3, {.stroke = pen.stroke, .width = 1.2, .fill = "#ffffff"});
  }
}

/// The front of an item is where its x axis points to.
void mark_front(Plan& plan, const PlacedItem& item, const Sample& sample,
                const std::string& color) {
  const Vector2 origin = at(item, sample, Vector3::Zero());
  const Vector2 ahead = (at(item, sample, Vector3::UnitX()) - origin).normalized();
  double reach = 0;
  for (const Polygon& part : explanation::footprint(item, sample))
    for (const Vector2& p : part) reach = std::max(reach, (p - origin).dot(ahead));
  plan.arrow(origin + reach * ahead, ahead, color);
}

void draw_item(Plan& plan, const PlacedItem& item, const Sample& sample, const Pen& outline,
               double fill_opacity) {
  for (const Polygon& part : explanation::footprint(item, sample))
    plan.area(part, outline, fill_opacity);
  if (!stands(sample)) return;
  const std::string& color = outline.stroke;
  mark_front(plan, item, sample, color);
  for (std::size_t i = 0; i < item.model.casters.size(); ++i) {
    const WheelPlan wheel = wheel_plan(item, i, sample);
    plan.line(wheel.mount, wheel.middle, {.stroke = color, .width = 1});
    plan.line(wheel.back, wheel.front, {.stroke = color, .width = 3.5});
    plan.dot(wheel.mount, 2.2, {.stroke = color, .width = 1, .fill = "#ffffff"});
  }
}

/// Path of the origin while the item stands: lying, it has no point there.
Curve path_of(const PlacedItem& item, const std::vector<Sample>& history, const Pen& pen) {
  Curve path{std::ranges::all_of(history, stands) ? "path" : "path while it stands", {}, {}, pen};
  for (const Sample& sample : history) {
    const Vector2 origin = at(item, sample, Vector3::Zero());
    if (stands(sample))
      path.add(origin.x(), origin.y());
    else
      path.add(std::nan(""), std::nan(""));
  }
  return path;
}

/// Middle of the boxes of an item.
Vector2 middle_of(const PlacedItem& item, const Sample& sample) {
  Vector2 low = Vector2::Constant(1e9), high = -low;
  for (const Polygon& part : explanation::footprint(item, sample))
    for (const Vector2& p : part) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return 0.5 * (low + high);
}

/// Numbers in the plan, names beside it with the lines of the histories.
void draw_legend(Svg& svg, Plan& plan, const Frame& frame, const Scene& scene,
                 const Response& response, const study::UnitSystem& units) {
  constexpr double kLineKey = 20, kSize = 11;
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
    svg.line(x + 12, y, x + 12 + kLineKey, y, pen(i, 1.6));
    const std::string what = d.time_of_overturning >= 0 ? ", overturned"
                             : d.time_of_toppling >= 0
                                 ? ", toppled"
                                 : ", " + lengths.fixed(d.residual_displacement, "m", 3);
    const double left = x + 18 + kLineKey;
    svg.text(left, y + 4,
             fitted(names[i], kSize, kWidth - left - 6 - text_width(what, kSize)) + what,
             {.size = kSize});
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
  const auto include_all = [&](const Polygon& polygon) {
    for (const Vector2& p : polygon) include(panel, p);
  };
  for (const RoomShape& shape : scene.room) include_all(explanation::footprint(shape));
  for (const Zone& zone : scene.zones) include_all(explanation::footprint(zone));
  for (const Tether& tether : scene.tethers) include(panel, placed_anchor(scene, tether).head<2>());
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    const PlacedItem& item = scene.items[i];
    const std::vector<Sample>& history = response.items.at(i).history;
    for (const Sample& sample : history)
      if (sample.displacement.allFinite()) include(panel, at(item, sample, Vector3::Zero()));
    for (const Sample* sample : {&history.front(), &explanation::last_finite(history)}) {
      for (const Polygon& part : explanation::footprint(item, *sample)) include_all(part);
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
std::size_t path_index(bool alone, std::size_t item) { return alone ? 1 : item; }

/// Height over width of the axes.
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
                                   pen(path_index(alone, i), alone ? 1.4 : 0.8)));
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
    const bool fell = response.items[i].demands.lies_from() >= 0;
    draw_item(plan, item, end,
              {.stroke = palette(i), .width = fell ? 2.4 : 1.2, .fill = palette(i)},
              alone  ? 0.08
              : fell ? 0.45
                     : 0.2);
    plan.dot(at(item, start, Vector3::Zero()), 3.5,
             {.stroke = kStartColor, .width = 1.5, .fill = "#ffffff"});
    if (stands(end))
      plan.dot(at(item, end, Vector3::Zero()), 3.5,
               {.stroke = "", .fill = palette(path_index(alone, i))});
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

/// Panels over time, in the units of the figure.
struct Panels {
  const study::RunFacts& facts;
  const study::UnitSystem& units;

  Panel panel(const std::string& title, const std::string& quantity, const char* unit,
              int legend_columns) const {
    return {.title = title,
            .x_label = "Time (s)",
            .y_label = with_unit(quantity, units.of(unit)),
            .legend_columns = legend_columns,
            .least_span = least_span(unit) / units.of(unit).in_si};
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
  for (PlotPanel& each : chart.panels)
    if (each.panel.lanes)
      each.height = std::max(kHeight, kLane * static_cast<double>(each.panel.curves.size()));
  chart.panels.insert(chart.panels.begin(), std::move(plan));
  return chart.svg({.width = kWidth});
}

}  // namespace gurney::figures
