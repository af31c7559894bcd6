#include "studies/figures/explanation_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/explanation/words.h"
#include "studies/figures/chart.h"
#include "studies/figures/labels.h"

namespace gurney::figures {
namespace {

using explanation::Event;
using explanation::Explanation;

/// From before the motion and its pulse to after the event.
Range window_of(const Explanation& of) {
  constexpr double kBefore = 0.5, kAfter = 1.5;
  if (of.item().finding == explanation::Finding::kStill || of.tracks.time.empty())
    return {0, of.end_time};
  double from = of.swing_start;
  if (of.pulse) from = std::min(from, of.pulse->start);
  return {std::max(0.0, from - kBefore), std::min(of.end_time, of.worst_time + kAfter)};
}

/// Panels over the window, in the units of the explanation.
struct Panels {
  explicit Panels(const Explanation& explanation) : of(explanation), window(window_of(of)) {
    for (std::size_t i = 0; i < of.tracks.time.size(); ++i)
      if (of.tracks.time[i] >= window.low && of.tracks.time[i] <= window.high) shown.push_back(i);
  }

  Panel panel(const std::string& title, const std::string& quantity, const char* unit) const {
    return {.title = title,
            .x_label = "",
            .y_label = with_unit(quantity, unit_of(unit)),
            .legend_columns = 6,
            .x_range = window,
            .least_span = least_span(unit) / unit_of(unit).in_si};
  }
  study::ReportUnit unit_of(const char* si) const { return of.units.or_else("m").of(si); }

  template <class Get>
  Curve curve(const std::string& label, std::size_t color, const char* unit, Get get) const {
    return curve_over(
        label, shown, pen(color, 1.3, color == 1 ? "4 2" : ""),
        [&](std::size_t i) { return of.tracks.time[i]; },
        [&](std::size_t i) { return get(i) / unit_of(unit).in_si; });
  }
  Curve curve(const std::string& label, std::size_t color, const char* unit,
              const std::vector<double>& values) const {
    return curve(label, color, unit, [&](std::size_t i) { return values[i]; });
  }

  Panel floor() const {
    Panel made = panel(
        "Floor acceleration " +
            (of.direction.isZero()
                 ? "towards +x"
                 : explanation::towards(std::atan2(of.direction.y(), of.direction.x()), of.units)),
        "Acceleration", "m/s2");
    made.curves = {curve("", 0, "m/s2", of.tracks.floor)};
    if (!of.pulse) return made;
    Area pulse{{}, {}, {}, palette(1), 0.35};
    const Curve& all = made.curves[0];
    for (std::size_t i = 0; i < all.x.size(); ++i) {
      if (all.x[i] < of.pulse->start || all.x[i] > of.pulse->end) continue;
      pulse.add(all.x[i], std::min(all.y[i], 0.0), std::max(all.y[i], 0.0));
    }
    made.areas = {pulse};
    return made;
  }

  Panel displacement() const {
    Panel made = panel("Distance of " + of.item().name + " from its start", "Distance", "m");
    made.curves = {curve("", 0, "m", of.tracks.displacement)};
    return made;
  }

  /// An item that lies on the floor has a tilt that hides all others.
  Panel tilt() const {
    Panel made = panel("Tilt against critical tilt", "Tilt", "rad");
    made.curves = {curve("tilt", 0, "rad", of.tracks.tilt),
                   curve("critical, where it leans to", 1, "rad", of.tracks.critical)};
    const double highest = widened({0, 0}, made.curves[0].y).high,
                 critical = widened({0, 0}, made.curves[1].y).high;
    if (critical > 0)
      made.y_range = {0, std::max(1.1 * critical, std::min(1.05 * highest, 3 * critical))};
    return made;
  }

  /// Impacts of wheels on the floor give grip for moments; the demand sets the scale.
  Panel grip() const {
    Panel made = panel("Force that holds it against grip", "Force", "N");
    made.curves = {curve("force needed", 0, "N", of.tracks.demand),
                   curve("grip", 1, "N", of.tracks.grip)};
    const double least = 1 / unit_of("N").in_si;
    const double needed = widened({0, least}, made.curves[0].y).high,
                 grip = widened({0, least}, made.curves[1].y).high;
    made.y_range = {0, 1.05 * std::min(std::max(needed, grip), 3 * needed)};
    return made;
  }

  Panel energy() const {
    Panel made = panel("Energy since the start", "Energy", "J");
    const auto add = [&](const char* label, auto get) {
      made.curves.push_back(curve(label, made.curves.size(), "J",
                                  [&](std::size_t i) { return get(of.tracks.energy[i]); }));
      made.curves.back().pen.dash.clear();
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
    return made;
  }

  const Explanation& of;
  Range window;
  std::vector<std::size_t> shown = {};  ///< samples
};

std::vector<Event> shown_events(const Explanation& of, const Range& window) {
  constexpr std::size_t kMaxEvents = 10;
  std::vector<Event> events;
  for (const Event& event : of.events) {
    const bool here = event.time >= window.low && event.time <= window.high;
    const bool ours = event.item == of.item().name || event.kind == explanation::EventKind::kZone;
    if (here && ours && events.size() < kMaxEvents) events.push_back(event);
  }
  return events;
}

}  // namespace

std::string explanation_figure(const Explanation& of) {
  constexpr double kHeight = 118;
  Chart chart{.title = explanation::headline(of)};
  if (!of.failed && !of.tracks.time.empty()) {
    chart.note = of.title + (of.record.empty() ? "" : " \u00b7 " + of.record);
    const Panels make(of);
    std::vector<Panel> panels;
    if (of.record.empty())
      panels = {make.displacement(), make.tilt(), make.energy()};
    else
      panels = {make.floor(), make.displacement(), make.tilt(), make.grip(), make.energy()};
    panels.back().x_label = "Time (s)";
    for (const Event& event : shown_events(of, make.window)) {
      const std::string words =
          explanation::sentence(event, of.units);  // the first clause is drawn
      chart.footnotes.push_back(fmt::format("{}: {:.2f} s, {}", chart.footnotes.size() + 1,
                                            event.time, words.substr(0, words.find(';'))));
      for (Panel& panel : panels) panel.guides.push_back({event.time});
      panels.front().guides.back().label = std::to_string(chart.footnotes.size());
    }
    chart.panels = of_height(std::move(panels), kHeight);
  }
  return chart.svg({.width = 760});
}

}  // namespace gurney::figures
