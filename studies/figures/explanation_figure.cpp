#include "studies/figures/explanation_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/explanation/words.h"
#include "studies/figures/labels.h"
#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

using explanation::Event;
using explanation::EventKind;
using explanation::Explanation;
using explanation::Finding;

constexpr double kWidth = 760, kLeft = 66, kRight = 18, kTop = 80, kPanel = 118, kRow = 172,
                 kLine = 16;
constexpr std::size_t kMaxEvents = 10;

/// From before the motion and its pulse to after the event.
Range window_of(const Explanation& of) {
  constexpr double kBefore = 0.5, kAfter = 1.5;
  if (of.item().finding == Finding::kStill || of.tracks.time.empty()) return {0, of.end_time};
  double from = of.swing_start;
  if (of.pulse) from = std::min(from, of.pulse->start);
  return {std::max(0.0, from - kBefore), std::min(of.end_time, of.worst_time + kAfter)};
}

template <class Get>
Curve curve(const Explanation& of, const Range& window, const std::string& label, std::size_t color,
            Get get) {
  Curve result{label, {}, {}, {.stroke = palette(color), .width = 1.3}};
  for (std::size_t i = 0; i < of.tracks.time.size(); ++i) {
    const double time = of.tracks.time[i];
    if (time < window.low || time > window.high) continue;
    result.x.push_back(time);
    result.y.push_back(get(i));
  }
  return result;
}

study::ReportUnit unit_of(const Explanation& of, const char* si) {
  return of.units.or_else("m").of(si);
}

Panel time_panel(const std::string& title, const std::string& y_label, const Range& window) {
  return {.title = title,
          .x_label = "",
          .y_label = y_label,
          .curves = {},
          .legend_columns = 6,
          .x_range = window};
}

std::string floor_title(const Explanation& of) {
  return "Floor acceleration " +
         (of.direction.isZero()
              ? "towards +x"
              : explanation::towards(std::atan2(of.direction.y(), of.direction.x()), of.units));
}

Panel floor_panel(const Explanation& of, const Range& window) {
  const study::ReportUnit unit = unit_of(of, "m/s2");
  Panel panel = time_panel("", with_unit("Acceleration", unit), window);
  panel.legend_columns = 0;
  panel.curves.push_back(
      curve(of, window, "", 0, [&](std::size_t i) { return of.tracks.floor[i] / unit.in_si; }));
  if (!of.pulse) return panel;
  Area pulse{{}, {}, {}, palette(1), 0.35};
  const Curve& all = panel.curves[0];
  for (std::size_t i = 0; i < all.x.size(); ++i) {
    if (all.x[i] < of.pulse->start || all.x[i] > of.pulse->end) continue;
    pulse.x.push_back(all.x[i]);
    pulse.low.push_back(std::min(all.y[i], 0.0));
    pulse.high.push_back(std::max(all.y[i], 0.0));
  }
  panel.areas.push_back(pulse);
  return panel;
}

Panel displacement_panel(const Explanation& of, const Range& window) {
  const study::ReportUnit unit = unit_of(of, "m");
  Panel panel = time_panel("Distance of " + of.item().name + " from its start",
                           with_unit("Distance", unit), window);
  panel.legend_columns = 0;
  panel.curves.push_back(curve(
      of, window, "", 0, [&](std::size_t i) { return of.tracks.displacement[i] / unit.in_si; }));
  return panel;
}

Panel tilt_panel(const Explanation& of, const Range& window) {
  const study::ReportUnit unit = unit_of(of, "rad");
  Panel panel = time_panel("Tilt against critical tilt", with_unit("Tilt", unit), window);
  panel.curves.push_back(
      curve(of, window, "tilt", 0, [&](std::size_t i) { return of.tracks.tilt[i] / unit.in_si; }));
  panel.curves.push_back(curve(of, window, "critical, where it leans to", 1,
                               [&](std::size_t i) { return of.tracks.critical[i] / unit.in_si; }));
  panel.curves.back().pen.dash = "4 2";
  // What lies on the floor has a tilt that hides all others.
  double tilt = 0, critical = 0;
  for (const double value : panel.curves[0].y) tilt = std::max(tilt, value);
  for (const double value : panel.curves[1].y)
    if (std::isfinite(value)) critical = std::max(critical, value);
  if (critical > 0)
    panel.y_range = {0, std::max(1.1 * critical, std::min(1.05 * tilt, 3 * critical))};
  return panel;
}

/// Impacts of wheels on the floor give grip for moments; the demand sets the scale.
Panel grip_panel(const Explanation& of, const Range& window) {
  const study::ReportUnit unit = unit_of(of, "N");
  Panel panel = time_panel("Force that holds it against grip", with_unit("Force", unit), window);
  panel.curves.push_back(curve(of, window, "force needed", 0,
                               [&](std::size_t i) { return of.tracks.demand[i] / unit.in_si; }));
  panel.curves.push_back(
      curve(of, window, "grip", 1, [&](std::size_t i) { return of.tracks.grip[i] / unit.in_si; }));
  panel.curves.back().pen.dash = "4 2";
  double needed = 1 / unit.in_si, grip = needed;
  for (const double value : panel.curves[0].y) needed = std::fmax(needed, value);
  for (const double value : panel.curves[1].y) grip = std::fmax(grip, value);
  panel.y_range = {0, 1.05 * std::min(std::max(needed, grip), 3 * needed)};
  return panel;
}

Panel energy_panel(const Explanation& of, const Range& window) {
  const study::ReportUnit unit = unit_of(of, "J");
  Panel panel = time_panel("Energy since the start", with_unit("Energy", unit), window);
  const auto add = [&](const char* label, auto get) {
    panel.curves.push_back(curve(of, window, label, panel.curves.size(), [&](std::size_t i) {
      return get(of.tracks.energy[i]) / unit.in_si;
    }));
  };
  add("kinetic", [](const EnergyAccount& e) { return e.kinetic; });
  add("height", [](const EnergyAccount& e) { return e.gravitational; });
  add("floor put in", [](const EnergyAccount& e) { return e.work_of_floor; });
  if (of.record.empty())
    add("loads put in", [](const EnergyAccount& e) { return e.work() - e.work_of_floor; });
  add("friction",
      [](const EnergyAccount& e) { return e.sliding_loss + e.relaxation_loss + e.tread_loss; });
  add("rolling",
      [](const EnergyAccount& e) { return e.rolling_loss + e.axle_loss + e.swivel_loss; });
  add("impacts", [](const EnergyAccount& e) { return e.contact_loss; });
  return panel;
}

std::vector<Event> shown_events(const Explanation& of, const Range& window) {
  std::vector<Event> events;
  for (const Event& event : of.events) {
    const bool here = event.time >= window.low && event.time <= window.high;
    const bool ours = event.item == of.item().name || event.kind == EventKind::kZone;
    if (here && ours && events.size() < kMaxEvents) events.push_back(event);
  }
  return events;
}

/// Lines through a panel, with numbers above the first; numbers that would touch move up.
void draw_events(Svg& svg, const Frame& frame, const Scaling& scaling,
                 const std::vector<Event>& events, bool numbers) {
  double last = -100;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double x = scaling.x(events[i].time);
    svg.line(x, frame.y, x, frame.y + frame.height,
             {.stroke = "#888888", .width = 0.7, .dash = "2 2"});
    if (!numbers) continue;
    last = std::max(x, last + 13);
    svg.text(last, frame.y - 4, fmt::format("{}", i + 1),
             {.size = 10, .anchor = Anchor::kMiddle, .bold = true});
  }
}

void draw_list(Svg& svg, double top, const std::vector<Event>& events,
               const study::UnitSystem& units) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double y = top + kLine * static_cast<double>(i);
    const std::string words = explanation::sentence(events[i], units);  // the first clause is drawn
    svg.text(kLeft, y, fmt::format("{}", i + 1), {.anchor = Anchor::kEnd, .bold = true});
    svg.text(kLeft + 54, y, fmt::format("{:.2f} s", events[i].time), {.anchor = Anchor::kEnd});
    svg.text(kLeft + 66, y,
             fitted(words.substr(0, words.find(';')), 11, kWidth - kLeft - 66 - kRight));
  }
}

}  // namespace

std::string explanation_figure(const Explanation& of) {
  if (of.failed || of.tracks.time.empty()) {
    Svg svg(kWidth, 80);
    svg.text(kRight, 40, fitted(explanation::headline(of), 11, kWidth - 2 * kRight));
    return svg.str();
  }
  const Range window = window_of(of);
  const std::vector<Event> events = shown_events(of, window);
  std::vector<Panel> panels{floor_panel(of, window), displacement_panel(of, window),
                            tilt_panel(of, window), grip_panel(of, window),
                            energy_panel(of, window)};
  if (of.record.empty()) {
    panels.erase(panels.begin() + 3);
    panels.erase(panels.begin());
  }
  panels.back().x_label = "Time (s)";
  // The title of the first panel stands above the numbers of the events.
  const std::string first_title = of.record.empty() ? panels.front().title : floor_title(of);
  panels.front().title.clear();
  const double list = kTop + 14 + kRow * static_cast<double>(panels.size()) + 4;
  Svg svg(kWidth, list + kLine * static_cast<double>(events.size()) + 4);
  svg.text(kRight, 26, fitted(explanation::headline(of), 15, kWidth - 2 * kRight),
           {.size = 14, .bold = true});
  svg.text(kRight, 44,
           fitted(of.title + (of.record.empty() ? "" : "   \u00b7   " + of.record), 11,
                  kWidth - 2 * kRight),
           {.size = 11, .color = "#555555"});
  svg.text(kLeft, kTop - 6, first_title, {.size = 12, .bold = true});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Frame frame{kLeft, kTop + 14 + kRow * static_cast<double>(i), kWidth - kLeft - kRight,
                      kPanel};
    draw_events(svg, frame, draw(svg, frame, panels[i]), events, i == 0);
  }
  draw_list(svg, list, events, of.units);
  return svg.str();
}

}  // namespace gurney::figures
