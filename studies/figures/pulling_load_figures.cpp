#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "studies/figures/panel.h"
#include "studies/figures/pulling_figures.h"

namespace gurney::figures {
namespace {

constexpr double kLeft = 75, kTop = 110, kPanelHeight = 330, kGap = 105;

void heading(Svg& svg, const std::string& title, const report::PullingReport& report) {
  std::string about =
      "f_r by the paper's method from simulated signals, aligned trials. Cr and the floor factors "
      "are "
      "inputs of the simulation";
  if (!report.measured.empty()) about += "; squares: trials that were given";
  svg.text(kLeft, 28, title, {.size = 15, .bold = true});
  svg.text(kLeft, 48, about, {.size = 11, .color = "#555555"});
  svg.text(kLeft, 66, report::noise_words(report), {.size = 11, .color = "#555555"});
}

/// Aligned trials with averages.
std::vector<const calibration::SimulatedTrial*> usable(const report::PullingReport& report) {
  std::vector<const calibration::SimulatedTrial*> chosen;
  for (const calibration::SimulatedTrial& trial : report.trials)
    if (trial.alignment == calibration::Alignment::kAligned && trial.averages)
      chosen.push_back(&trial);
  return chosen;
}

template <class Get>
std::vector<std::string> names(const std::vector<const calibration::SimulatedTrial*>& trials,
                               Get get) {
  std::vector<std::string> all;
  for (const calibration::SimulatedTrial* trial : trials)
    if (std::ranges::find(all, get(*trial)) == all.end()) all.push_back(get(*trial));
  return all;
}

std::size_t index_in(const std::vector<std::string>& all, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(all, name) - all.begin());
}

const std::string& caster_of(const calibration::SimulatedTrial& trial) {
  return trial.trial.setup.caster;
}
const std::string& floor_of(const calibration::SimulatedTrial& trial) {
  return trial.trial.setup.floor;
}

void dot(Svg& svg, double x, double y, std::size_t color, bool filled) {
  svg.circle(x, y, 4,
             {.stroke = palette(color), .width = 1.4, .fill = filled ? palette(color) : "#ffffff"});
}

void square(Svg& svg, double x, double y, std::size_t color) {
  svg.rectangle(x - 4, y - 4, 8, 8, {.stroke = palette(color), .width = 1.6});
}

/// Of two points of a line, or of a legend only (NaN).
Curve line(const std::string& label, const Range& x, const Range& y, std::size_t color) {
  return {label, {x.low, x.high}, {y.low, y.high}, {.stroke = palette(color), .width = 1.5}};
}

Range from_zero(double highest) { return {0, highest > 0 ? 1.15 * highest : 1}; }

double highest_resistance(const std::vector<const calibration::SimulatedTrial*>& trials) {
  double highest = 0;
  for (const calibration::SimulatedTrial* trial : trials) {
    const calibration::Resistance found = calibration::average_method(*trial->averages);
    highest = std::max({highest, found.pulled, found.coasting});
  }
  return highest;
}

/// Of the empty item.
std::vector<const calibration::SimulatedTrial*> lightest(
    const std::vector<const calibration::SimulatedTrial*>& trials) {
  std::vector<const calibration::SimulatedTrial*> chosen;
  for (const calibration::SimulatedTrial* trial : trials)
    if (trial->trial.setup.payload == 0) chosen.push_back(trial);
  return chosen;
}

void draw_diameters(Svg& svg, const Frame& frame,
                    const std::vector<const calibration::SimulatedTrial*>& trials) {
  const auto floors = names(trials, floor_of);
  Panel panel{.title = "No payload",
              .x_label = "Wheel diameter (mm)",
              .y_label = "f_r (N)",
              .curves = {},
              .legend_columns = 3,
              .x_range = {80, 145},
              .y_range = from_zero(highest_resistance(trials))};
  const double nan = std::nan("");
  for (std::size_t i = 0; i < floors.size(); ++i)
    panel.curves.push_back(line(floors[i], {nan, nan}, {nan, nan}, i));
  Curve inverse{"as 1/R", {}, {}, {.stroke = "#666666", .width = 1.3, .dash = "5 4"}};
  if (!trials.empty())
    for (double diameter = 80; diameter <= 145; diameter += 1) {
      inverse.x.push_back(diameter);
      inverse.y.push_back(calibration::mean_resistance(*trials[0]->averages) * 2 *
                          kMillimetersPerMeter * trials[0]->trial.setup.wheel_radius / diameter);
    }
  panel.curves.push_back(inverse);
  const Scaling scaling = draw(svg, frame, panel);
  // Trials of one diameter side by side: floors apart, and casters of other treads.
  for (const calibration::SimulatedTrial* trial : trials) {
    const std::size_t floor = index_in(floors, floor_of(*trial));
    const double diameter = 2 * kMillimetersPerMeter * trial->trial.setup.wheel_radius;
    dot(svg, scaling.x(diameter) + (floor == 0 ? -5 : 5),
        scaling.y(calibration::mean_resistance(*trial->averages)), floor, floor == 0);
  }
}

void draw_speeds(Svg& svg, const Frame& frame,
                 const std::vector<const calibration::SimulatedTrial*>& all) {
  const auto casters = names(all, caster_of);
  std::vector<const calibration::SimulatedTrial*> trials;
  for (const calibration::SimulatedTrial* trial : all)
    if (caster_of(*trial) == casters.front()) trials.push_back(trial);
  double fastest = 0, known = 0;
  for (const calibration::SimulatedTrial* trial : trials) {
    fastest = std::max({fastest, trial->averages->pull_speed, trial->averages->coast_speed});
    known = trial->theory.resistance;
  }
  const Range speeds = from_zero(fastest);
  Panel panel{.title = casters.front() + ", no payload",
              .x_label = "Mean speed (m/s)",
              .y_label = "f_r (N)",
              .curves = {line("input", speeds, {known, known}, 6)},
              .legend_columns = 3,
              .x_range = speeds,
              .y_range = from_zero(highest_resistance(trials))};
  const double nan = std::nan("");
  panel.curves.push_back(line("phase II", {nan, nan}, {nan, nan}, 0));
  panel.curves.push_back(line("phase III", {nan, nan}, {nan, nan}, 1));
  const Scaling scaling = draw(svg, frame, panel);
  for (const calibration::SimulatedTrial* trial : trials) {
    const calibration::Resistance found = calibration::average_method(*trial->averages);
    dot(svg, scaling.x(trial->averages->pull_speed), scaling.y(found.pulled), 0, true);
    dot(svg, scaling.x(trial->averages->coast_speed), scaling.y(found.coasting), 1, false);
  }
}

}  // namespace

std::string pulling_figure_6(const report::PullingReport& report) {
  const std::vector<const calibration::SimulatedTrial*> trials = usable(report);
  const auto casters = names(trials, caster_of);
  double heaviest = 0, highest = highest_resistance(trials);
  for (const calibration::SimulatedTrial* trial : trials)
    heaviest = std::max(heaviest, trial->theory.normal_force);
  for (const calibration::MeasuredTrial& each : report.measured) {
    if (!each.fault.empty()) continue;
    heaviest = std::max(heaviest, calibration::normal_force(each.trial.setup));
    highest = std::max(highest, calibration::mean_resistance(*each.averages));
  }
  const Range loads = from_zero(heaviest);
  Panel panel{.title = "",
              .x_label = "Normal force on all wheels (N)",
              .y_label = "f_r (N)",
              .curves = {},
              .legend_columns = 1,
              .x_range = loads,
              .y_range = from_zero(highest)};
  for (const calibration::CasterFit& fit : calibration::fits_by_caster(report.trials)) {
    panel.curves.push_back(
        line(fmt::format("{}: Cr/R = {:.4f} ({:.4f} input)", fit.caster, fit.found, fit.known),
             loads, {0, fit.found * loads.high}, index_in(casters, fit.caster)));
    if (panel.curves.size() > 1) panel.curves.back().pen.dash = "7 4";
  }
  const Frame frame{kLeft, kTop, 620, kPanelHeight};
  Svg svg(kLeft + 620 + 40, kTop + kPanelHeight + 55);
  heading(svg, "Rolling resistance against load (as Figure 6 of Xu, Ma & Kurata 2022)", report);
  const Scaling scaling = draw(svg, frame, panel);
  // Casters that roll alike would hide each other.
  for (const calibration::SimulatedTrial* trial : trials) {
    const std::size_t caster = index_in(casters, caster_of(*trial));
    dot(svg, scaling.x(trial->theory.normal_force) + 5 * static_cast<double>(caster) - 5,
        scaling.y(calibration::mean_resistance(*trial->averages)), caster, caster == 0);
  }
  for (const calibration::MeasuredTrial& each : report.measured)
    if (each.fault.empty() &&
        calibration::alignment_of(each.trial.setup.headings) == calibration::Alignment::kAligned)
      square(svg, scaling.x(calibration::normal_force(each.trial.setup)),
             scaling.y(calibration::mean_resistance(*each.averages)),
             index_in(casters, each.trial.setup.caster));
  return svg.str();
}

std::string pulling_figure_7(const report::PullingReport& report) {
  const std::vector<const calibration::SimulatedTrial*> trials = lightest(usable(report));
  Svg svg(kLeft + 2 * 420 + kGap + 30, kTop + kPanelHeight + 55);
  heading(svg, "Wheel diameter, floor and speed (as Figure 7 of Xu, Ma & Kurata 2022)", report);
  if (trials.empty()) return svg.str();
  draw_diameters(svg, {kLeft, kTop, 420, kPanelHeight}, trials);
  draw_speeds(svg, {kLeft + 420 + kGap, kTop, 420, kPanelHeight}, trials);
  return svg.str();
}

}  // namespace gurney::figures
